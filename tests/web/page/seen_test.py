"""Tests that an address holds all that is seen: of a job's screen, and of the viewer with its camera."""
import time
from urllib.parse import parse_qs

from selenium.webdriver.common.keys import Keys

from page_case import PageTest


class Seen(PageTest):
    def query(self):
        """What the address holds, once it says what is seen."""
        time.sleep(0.5)
        return {name: values[0] for name, values in parse_qs(self.browser.link().partition("?")[2]).items()}

    def same_camera(self, one, other):
        size = max(abs(value) for value in other)
        return all(abs(a - b) < 1e-4 * size for a, b in zip(one, other))

    def space(self, axes):
        return self.browser.wait("the pose space", lambda f: f.get("poseSpace") and f["poseSpace"]["axes"] == axes)

    def test_back_from_a_scenario_restores_the_job_as_it_was_seen(self):
        self.open(self.scenes.grid(), "#/jobs/folder?x=z&y=x&at=yaw:30,y:0.25&from=100&to=899")
        shown = self.space(["z", "x"])
        self.assertEqual([shown["strip"]["first"], shown["strip"]["end"]], [100, 900])
        body = self.browser.wait_text("yaw 30°")
        self.assertIn("y 0.25 m", body)
        left, top, width, height = self.browser.box("canvas.strip")
        self.browser.click(left + width / 2, top + height / 2)
        self.browser.wait("a scenario", lambda f: 450 < (f.get("scenario") or 0) < 550)
        self.browser.driver.back()
        again = self.space(["z", "x"])
        self.assertEqual(again["strip"]["first"], 100)
        self.assertIn("yaw 30°", self.browser.wait_text("y 0.25 m"))
        self.assertEqual(again["poseSpace"]["scenario"], shown["poseSpace"]["scenario"])

    def test_the_address_follows_axes_sliders_and_zoom(self):
        self.open(self.scenes.grid(), "#/jobs/folder")
        self.space(["x", "y"])
        self.assertEqual(self.query(), {})
        slider = self.browser.driver.find_element("css selector", ".slider input")
        slider.send_keys(Keys.ARROW_RIGHT)
        self.browser.driver.execute_script(
            "const choice = document.querySelectorAll('.controls select')[1];"
            "choice.value = 'yaw'; choice.dispatchEvent(new Event('change', {bubbles: true}))"
        )
        self.space(["x", "yaw"])
        self.browser.driver.execute_script("document.querySelector('canvas.strip').focus()")
        self.browser.press("+")
        self.browser.wait("a window", lambda f: f["strip"]["end"] - f["strip"]["first"] < 21 * 17 * 9)
        query = self.query()
        self.assertEqual((query["x"], query["y"], query["at"]), ("x", "yaw", "z:1.25"))
        seen = self.browser.facts()["strip"]
        self.assertEqual((int(query["from"]), int(query["to"]) + 1), (seen["first"], seen["end"]))
        self.browser.open(self.browser.origin + "/" + self.browser.link())
        again = self.space(["x", "yaw"])
        self.assertEqual(again["strip"]["first"], seen["first"])
        self.assertIn("z 1.25 m", self.browser.wait_text("z 1.25 m"))

    def test_a_scatter_keeps_its_axes(self):
        self.open(self.scenes.random(), "#/jobs/folder?x=roll&y=distance")
        spot = self.space(["roll", "distance"])["poseSpace"]
        self.browser.go(f"#/jobs/folder/{spot['scenario']}")
        self.browser.scenario(spot["scenario"])
        self.browser.driver.back()
        self.space(["roll", "distance"])

    def copied(self):
        """Returns the address that `copy link` copies."""
        self.browser.driver.execute_script(
            "Object.defineProperty(navigator, 'clipboard', {configurable: true, value:"
            "{writeText: async text => { window.copied = text; }}});"
            "[...document.querySelectorAll('button')].find(b => b.textContent === 'copy link').click()"
        )
        return self.browser.driver.execute_script("return window.copied")

    def test_a_copied_link_shows_what_is_seen_before_the_view_was_turned(self):
        self.open(self.scenes.drive(), "#/jobs/folder/45")
        camera = self.browser.scenario(45)["camera"]
        # The body moves on while the view stays.
        self.browser.press(Keys.ARROW_RIGHT)
        self.browser.scenario(46)
        link = self.copied()
        self.assertIn("cam=", link)
        self.assertNotIn("key=", link)
        self.browser.open(link)
        self.assertTrue(self.same_camera(self.browser.scenario(46)["camera"], camera))

    def test_the_address_has_the_camera_after_a_step(self):
        self.open(self.scenes.drive(), "#/jobs/folder/45")
        camera = self.browser.scenario(45)["camera"]
        self.assertNotIn("cam", self.query())
        for number in range(46, 50):
            self.browser.press(Keys.ARROW_RIGHT)
            now = self.browser.scenario(number)["camera"]
        self.assertTrue(self.same_camera(now, camera))
        self.assertTrue(self.same_camera([float(one) for one in self.query()["cam"].split(",")], now))
        self.browser.open(self.browser.origin + "/" + self.browser.link())
        self.assertTrue(self.same_camera(self.browser.scenario(49)["camera"], now))

    def test_the_address_waits_until_the_parts_are_known(self):
        self.open(self.scenes.grid(), "#/jobs/folder/500?part=probe")
        facts = self.browser.wait("the part", lambda f: f.get("parts") == ["", "probe"])
        self.assertEqual(facts["scenario"], 500)
        self.assertEqual(self.query()["part"], "b/probe")
