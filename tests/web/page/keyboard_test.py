"""Tests that the page works from the keyboard: zoom in the scenarios in order, picks, and moves of the view."""
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from page_case import PageTest


class Keyboard(PageTest):
    def focus(self, selector):
        self.browser.driver.execute_script(f"document.querySelector('{selector}').focus()")

    def strip(self, what, condition):
        return self.browser.wait(what, lambda f: f.get("strip") and condition(f["strip"]))["strip"]

    def step_right(self, times):
        """Moves the mark of the strip by one bin at a time, each step once the last is seen; returns its scenario."""
        mark = -1
        for _ in range(times):
            self.browser.press(Keys.ARROW_RIGHT)
            mark = self.strip("a further mark", lambda s, last=mark: s["mark"] > last)["mark"]
        return mark

    def chord(self, key):
        chord = ActionChains(self.browser.driver).key_down(Keys.SHIFT).send_keys(key).key_up(Keys.SHIFT)
        chord.perform()

    def test_plus_and_minus_zoom_about_the_mark(self):
        self.open(self.scenes.grid(), "#/jobs/folder")
        total = 21 * 17 * 9
        self.strip("all scenarios", lambda s: (s["first"], s["end"]) == (0, total))
        self.focus("canvas.strip")
        mark = self.step_right(10)
        for times in range(1, 6):
            self.browser.press("+")
            now = self.strip("half of them", lambda s, t=times: s["end"] - s["first"] <= total / 2**t + 1)
            self.assertEqual(now["mark"], mark)
            self.assertTrue(now["first"] <= mark < now["end"])
        size = now["end"] - now["first"]
        self.browser.press("-")
        self.strip("twice as many", lambda s: s["end"] - s["first"] == 2 * size)
        self.browser.press(Keys.ESCAPE)
        self.strip("all scenarios", lambda s: (s["first"], s["end"]) == (0, total))

    def test_the_mark_goes_on_beyond_the_edge(self):
        self.open(self.scenes.drive(), "#/jobs/folder?from=40&to=43")
        self.strip("a window", lambda s: (s["first"], s["end"]) == (40, 44))
        self.focus("canvas.strip")
        self.assertEqual(self.step_right(5), 44)
        now = self.strip("a window about the mark", lambda s: s["first"] <= 44 < s["end"])
        self.assertEqual(now["end"] - now["first"], 4)
        self.browser.press(Keys.ENTER)
        self.browser.scenario(44)

    def test_enter_picks_the_middle_of_the_picture(self):
        folder = self.scenes.one_pair()
        # Face 0 of the box holds the point y = -0.3, z = 0.3 of its side x = -1.
        self.open(folder, "#/jobs/folder/0?cam=-9,-0.3,0.3,0,-0.3,0.3&ghost=none&walls=0")
        self.browser.scenario(0)
        self.browser.press(Keys.ENTER)
        self.assertIsNone(self.browser.facts()["pick"])
        self.focus(".stage canvas")
        self.browser.press(Keys.ENTER)
        facts = self.browser.wait("a pick", lambda f: f["pick"])
        self.assertEqual(facts["pick"], {"body": 0, "triangle": 0})
        # The other triangle of that side, after moves to the right (which is towards -y) and down.
        for _ in range(2):
            self.chord("S")
        for _ in range(2):
            self.chord("A")
        self.browser.press(Keys.ENTER)
        facts = self.browser.wait("another pick", lambda f: f["pick"] != {"body": 0, "triangle": 0})
        self.assertEqual(facts["pick"], {"body": 0, "triangle": 1})

    def test_a_move_keeps_direction_and_distance(self):
        self.open(self.scenes.drive(), "#/jobs/folder/50")
        before = self.browser.scenario(50)["camera"]
        self.chord("W")
        self.chord("D")
        after = self.browser.wait("another view", lambda f: f["camera"][:3] != before[:3])["camera"]
        for axis in range(3):
            self.assertAlmostEqual(after[axis] - before[axis], after[axis + 3] - before[axis + 3], 6)

    def test_the_keys_of_each_screen_are_listed(self):
        self.open(self.scenes.drive(), "#/jobs/folder")
        self.browser.wait("the job", lambda f: f["screen"] == "job")
        self.browser.press("?")
        self.assertIn("half as many scenarios", self.browser.wait_text("Keys of a job's page"))
        self.browser.press(Keys.ESCAPE)
        self.browser.go("#/jobs/folder/50")
        self.browser.scenario(50)
        self.browser.press("?")
        self.assertIn("pick the triangle in its middle", self.browser.wait_text("Keys of the viewer"))
