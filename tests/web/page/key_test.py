"""Tests that each key and each movement of the mouse in the viewer's list does what the list says."""
import math

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys as Key

from page_case import PageTest
from scenes import pairs_by_scenario


def distance(camera):
    return math.dist(camera[:3], camera[3:])


class Keys(PageTest):
    """Each test is of some rows of the list; `rows` names all of them. Picks, moves and the end of a search are in
    keyboard_test.py and long_job_test.py."""

    rows = [
        "n, p", "← →", "esc", "space", "h", "g", "x", "l", "s", "[ ]", "f", "c", "e",
        "shift ← → ↑ ↓", "shift W A S D", "+ −", "enter", "drag, wheel", "click", "?",
    ]  # fmt: skip

    def setUp(self):
        folder = self.scenes.grid()
        contacts = sorted(pairs_by_scenario(folder))
        middle = len(contacts) // 2
        self.first = contacts[0]
        self.before, self.here, self.after = contacts[middle - 1 : middle + 2]
        self.open(folder, f"#/jobs/folder/{self.here}")
        self.start = self.browser.scenario(self.here)

    def press(self, key, fact, expected):
        """Presses a key and waits until a fact has a value."""
        self.browser.press(key)
        return self.browser.wait(f"{fact} {expected}", lambda f: f[fact] == expected)

    def turned(self, act):
        """Does something and returns the camera once it is another one."""
        last = self.browser.facts()["camera"]
        act()
        return self.browser.wait("another view", lambda f: f["camera"] != last)["camera"]

    def chord(self, key):
        ActionChains(self.browser.driver).key_down(Key.SHIFT).send_keys(key).key_up(Key.SHIFT).perform()

    def ask(self, script):
        return self.browser.driver.execute_script(f"return {script}")

    def test_the_list_has_the_rows_that_are_tested(self):
        """The question mark opens the list, Escape closes it, and while it is open keys are not the viewer's."""
        self.browser.press("?")
        self.browser.wait("the list", lambda f: self.ask("document.querySelector('dialog.keys')?.open"))
        shown = self.ask("[...document.querySelectorAll('dialog.keys kbd')].map(one => one.textContent)")
        self.assertEqual(shown, self.rows)
        self.browser.press("g")
        self.browser.press(Key.ESCAPE)
        self.browser.wait("no list", lambda f: not self.ask("document.querySelector('dialog')"))
        self.assertEqual(self.browser.facts()["ghost"], "b")

    def test_keys_that_go_to_another_scenario(self):
        """n and p go to the next and the previous contact, the arrows to the neighbours."""
        self.press("n", "scenario", self.after)
        self.press("p", "scenario", self.here)
        self.press("p", "scenario", self.before)
        self.press(Key.ARROW_RIGHT, "scenario", self.before + 1)
        self.press(Key.ARROW_LEFT, "scenario", self.before)

    def test_space_plays_and_stops(self):
        """Space shows one scenario after another until it is pressed again."""
        is_playing = "document.querySelector('.scrub button[title=space]').getAttribute('aria-pressed') === 'true'"
        self.browser.press(Key.SPACE)
        self.browser.wait("a replay", lambda f: self.ask(is_playing) and f["scenario"] > self.here + 2)
        self.browser.press(Key.SPACE)
        self.browser.wait("its end", lambda f: not self.ask(is_playing))

    def test_keys_that_change_what_is_shown(self):
        """h, g, x and l change the mode, the ghost, and how contacts are drawn; the link says the same."""
        self.press("h", "mode", "heat")
        self.press("h", "mode", "contacts")
        for ghost in ("none", "a", "b"):
            self.press("g", "ghost", ghost)
        self.press("x", "throughWalls", False)
        self.press("x", "throughWalls", True)
        self.browser.press_and_draw("l")
        self.browser.wait("a link without lines", lambda f: "lines=0" in self.browser.link())
        self.browser.press_and_draw("l")
        self.browser.wait("a link with lines", lambda f: "lines" not in self.browser.link())

    def test_keys_of_the_section_plane(self):
        """s makes and drops the section plane, brackets move it."""
        self.browser.press("s")
        at = self.browser.wait("a section", lambda f: f["clip"])["clip"]["at"]
        self.browser.press("]")
        self.browser.wait("a plane further on", lambda f: f["clip"]["at"] > at)
        self.browser.press("[")
        self.browser.press("[")
        self.browser.wait("a plane further back", lambda f: f["clip"]["at"] < at)
        self.press("s", "clip", None)

    def test_keys_that_go_to_the_contact_and_to_all(self):
        """c looks at the contact, f at all; the direction stays, and only c makes a camera in the link."""
        self.browser.go(f"#/jobs/folder/{self.first}")
        everything = self.browser.scenario(self.first)["camera"]
        near = self.turned(lambda: self.browser.press("c"))
        self.assertNotEqual(near[3:], everything[3:])
        self.assertLess(distance(near), distance(everything))
        self.browser.wait("a camera in the link", lambda f: "cam=" in self.browser.link())
        far = self.turned(lambda: self.browser.press("f"))
        for one, other in zip(far, everything):
            self.assertAlmostEqual(one, other, 4)
        self.browser.wait("no camera in the link", lambda f: "cam=" not in self.browser.link())

    def test_keys_that_turn_and_approach(self):
        """Arrows with shift turn about the target, plus and minus change the distance from it."""
        first = self.start["camera"]
        for key, back in ((Key.ARROW_RIGHT, Key.ARROW_LEFT), (Key.ARROW_UP, Key.ARROW_DOWN)):
            turned = self.turned(lambda: self.chord(key))
            self.assertEqual(turned[3:], first[3:])
            self.assertAlmostEqual(distance(turned), distance(first), 5)
            for one, other in zip(self.turned(lambda: self.chord(back)), first):
                self.assertAlmostEqual(one, other, 5)
        self.assertLess(distance(self.turned(lambda: self.browser.press("+"))), distance(first))
        self.turned(lambda: self.browser.press("-"))
        self.assertGreater(distance(self.turned(lambda: self.browser.press("-"))), distance(first))
        self.assertEqual(self.browser.facts()["scenario"], self.here)

    def test_the_mouse(self):
        """A drag turns, one with the right button moves, the wheel zooms, and none of them picks."""
        left, top, width, height = self.browser.box(".stage canvas")
        middle = left + width / 2, top + height / 2
        aside = middle[0] + 60, middle[1] + 30
        first = self.browser.facts()["camera"]
        turned = self.turned(lambda: self.browser.drag(middle, aside))
        self.assertAlmostEqual(distance(turned), distance(first), 5)
        self.assertEqual(turned[3:], first[3:])
        moved = self.turned(lambda: self.browser.drag(middle, aside, "right"))
        self.assertNotEqual(moved[3:], first[3:])
        nearer = self.turned(lambda: self.browser.turn_wheel(*middle, -240))
        self.assertLess(distance(nearer), distance(moved))
        self.assertIsNone(self.browser.facts()["pick"])

    def test_a_click_with_shift_picks_the_ghost(self):
        """Where the ghost is in front of a body, a click picks the body and one with shift the ghost."""
        self.browser.go(f"#/jobs/folder/{self.here}?ghost=a&walls=0&lines=0")
        self.browser.wait("a ghost", lambda f: f["ghost"] == "a" and f["scenario"] == self.here)
        point = self.browser.facts()["pointPixels"][0]
        self.browser.click(*point, shift=True)
        self.browser.wait("a pick of the ghost", lambda f: f["pick"] and f["pick"]["body"] == 0)
        self.browser.click(*point)
        self.browser.wait("a pick of the body", lambda f: f["pick"] and f["pick"]["body"] == 1)
