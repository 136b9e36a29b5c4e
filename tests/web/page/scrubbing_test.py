"""Tests the way from scenario to scenario."""
import time

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from page_case import PageTest
from scenes import pairs_by_scenario


class Scrubbing(PageTest):
    def test_a_hundred_scenarios_show_exactly_the_listed_triangles(self):
        folder = self.scenes.drive()
        expected = pairs_by_scenario(folder)
        self.assertGreater(len(expected), 20)
        self.open(folder, "#/jobs/folder/0")
        self.browser.scenario(0)
        for number in range(100):
            facts = self.browser.scenario(number)
            a, b = expected.get(number, (set(), set()))
            self.assertEqual(facts["highlighted"], [sorted(a), sorted(b)], f"scenario {number}")
            self.assertEqual(facts["verified"], True)
            self.browser.press(Keys.ARROW_RIGHT)

    def test_next_and_previous_contact(self):
        folder = self.scenes.drive()
        contacts = sorted(pairs_by_scenario(folder))
        self.open(folder, "#/jobs/folder/0")
        self.browser.scenario(0)
        self.browser.press("n")
        self.browser.scenario(contacts[0])
        self.browser.press("n")
        self.browser.scenario(contacts[1])
        self.browser.press("p")
        self.browser.scenario(contacts[0])
        self.browser.press("p")
        self.browser.wait_text("no contact before this scenario")

    def test_the_keyboard_turns_the_view_and_the_link_says_how(self):
        self.open(self.scenes.drive(), "#/jobs/folder/50")
        before = self.browser.scenario(50)["camera"]
        chord = ActionChains(self.browser.driver).key_down(Keys.SHIFT).send_keys(Keys.ARROW_RIGHT).key_up(Keys.SHIFT)
        chord.send_keys("+").perform()
        camera = self.browser.wait("another view", lambda f: f["camera"][0] != before[0])["camera"]
        self.assertEqual(camera[3:], before[3:])
        time.sleep(0.5)
        self.assertIn("cam=", self.browser.link())

    def test_frames_are_drawn_only_when_something_changed(self):
        self.open(self.scenes.drive(), "#/jobs/folder/50")
        self.browser.scenario(50)
        time.sleep(0.5)
        frames = self.browser.facts()["frames"]
        time.sleep(1)
        self.assertEqual(self.browser.facts()["frames"], frames)
