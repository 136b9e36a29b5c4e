"""Tests what the page shows of a job of motions."""
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from page_case import PageTest


class Motion(PageTest):
    def test_a_motion_starts_at_its_event_with_its_contacts(self):
        self.open(self.scenes.motions(), "#/jobs/folder/1")
        facts = self.browser.scenario(1)
        motion = facts["motion"]
        self.assertEqual(facts["verified"], True)
        self.assertEqual(motion["tau"], motion["event"])
        self.assertAlmostEqual(motion["tau"], 0.5, delta=0.01)
        self.assertAlmostEqual(motion["centre"][0], 1.3, delta=0.02)
        self.assertEqual(motion["pieces"], len(motion["intervals"]))
        self.assertEqual(motion["intervals"][0]["kind"], "free")
        self.assertIn("event", [one["kind"] for one in motion["intervals"]])
        self.assertGreater(len(facts["highlighted"][0]), 0)
        self.browser.wait_text("the event, contacts are drawn")
        self.keep_pictures("motion")

    def test_the_keyboard_moves_the_time_and_contacts_are_hidden(self):
        self.open(self.scenes.motions(), "#/jobs/folder/1")
        before = self.browser.scenario(1)["motion"]
        slider = self.browser.driver.find_element(By.CSS_SELECTOR, ".time-line input")
        slider.send_keys(Keys.HOME)
        facts = self.browser.wait("the begin", lambda facts: facts["motion"]["tau"] == 0 and facts["ready"])
        self.assertEqual(facts["highlighted"], [[], []])
        self.assertAlmostEqual(facts["motion"]["centre"][0], 2.3, delta=1e-6)
        self.browser.wait_text("at 0 of the way: free; contacts are drawn at the event only")
        self.assertIn("free", slider.get_attribute("aria-valuetext"))
        self.browser.press("e")
        facts = self.browser.wait("the event", lambda facts: facts["motion"]["tau"] == before["event"])
        self.assertGreater(len(facts["highlighted"][0]), 0)

    def test_a_link_holds_the_time(self):
        self.open(self.scenes.motions(), "#/jobs/folder/1?tau=0.25")
        motion = self.browser.scenario(1)["motion"]
        self.assertEqual(motion["tau"], 0.25)
        self.assertAlmostEqual(motion["centre"][0], 1.8, delta=1e-6)

    def test_a_free_motion_starts_at_its_begin(self):
        self.open(self.scenes.motions(), "#/jobs/folder/0")
        facts = self.browser.scenario(0)
        self.assertEqual(facts["class"], "separate")
        self.assertEqual((facts["motion"]["event"], facts["motion"]["tau"]), (None, 0))
        self.assertEqual([one["kind"] for one in facts["motion"]["intervals"]], ["free"])
        self.browser.wait_text("free throughout")
