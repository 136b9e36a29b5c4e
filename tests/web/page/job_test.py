"""Tests the screen of a job."""
import re

from selenium.webdriver.common.keys import Keys

from page_case import PageTest


class Jobs(PageTest):
    def click_space(self, folder, name):
        """Opens a job page, clicks on a place of the pose space, and expects its scenario."""
        self.open(folder, "#/jobs/folder")
        facts = self.browser.wait("the pose space", lambda f: f["screen"] == "job" and f.get("poseSpace"))
        self.browser.picture(f"job-{name}-light")
        spot = facts["poseSpace"]
        left, top, width, height = self.browser.box(".plot canvas")
        x = left + width * (spot["x"] + spot["width"] / 2)
        y = top + height * (1 - spot["y"] - spot["height"] / 2)
        self.browser.click(x, y)
        self.browser.scenario(spot["scenario"])
        self.browser.driver.back()
        self.browser.wait("the job", lambda f: f["screen"] == "job")
        return facts

    def test_grid(self):
        facts = self.click_space(self.scenes.grid(), "grid")
        self.assertEqual(facts["tested"], 21 * 17 * 3 * 3)
        self.assertTrue(facts["isExact"])

    def test_file(self):
        self.click_space(self.scenes.drive(), "file")
        self.browser.wait_text("1 run of consecutive scenarios in contact")

    def test_random(self):
        self.click_space(self.scenes.random(), "random")

    def test_many_random_poses_are_drawn_as_shares_in_cells(self):
        facts = self.click_space(self.scenes.many(), "many")
        self.assertAlmostEqual(facts["poseSpace"]["width"], 1 / 128)

    def test_a_panel_without_a_neighbour_takes_the_row(self):
        """A job without contact has no histogram: nothing is left empty beside the pose space."""
        poses = self.scenes.poses("far", "x,y", [(9 + i % 7, i) for i in range(70)])
        folder = self.scenes.run("far", *self.scenes.bodies(), "--poses", poses, "--level", "count")
        self.open(folder, "#/jobs/folder")
        self.browser.wait("the pose space", lambda f: f["screen"] == "job" and f.get("poseSpace"))
        self.browser.picture("job-no-contact-light")
        rows = self.browser.driver.execute_script(
            "return [...document.querySelectorAll('.two')].map(row => [...row.children].map(one =>"
            " [one.getBoundingClientRect().width, row.getBoundingClientRect().width]))"
        )
        self.assertEqual([len(row) for row in rows], [1, 1])
        for ((panel, row),) in rows:
            self.assertAlmostEqual(panel, row, 0)

    def test_strip_opens_the_scenario_that_is_clicked(self):
        self.open(self.scenes.drive(), "#/jobs/folder")
        self.browser.wait("the job", lambda f: f["screen"] == "job")
        left, top, width, height = self.browser.box("canvas.strip")
        self.browser.click(left + width * 0.425, top + height / 2)
        self.browser.scenario(42)

    def test_a_heading_sorts_its_table(self):
        self.open(self.scenes.drive(), "#/jobs/folder")
        self.browser.wait("the job", lambda f: f["screen"] == "job")
        heading = self.browser.driver.find_element("css selector", "th button")
        sorted_by = "return document.querySelectorAll('th[aria-sort$=\"ending\"]').length"
        self.assertEqual(self.browser.driver.execute_script(sorted_by), 0)
        self.browser.driver.execute_script("arguments[0].click()", heading)
        self.browser.wait("a sorted table", lambda f: self.browser.driver.execute_script(sorted_by) == 1)

    def test_the_keyboard_reaches_the_pose_space(self):
        self.open(self.scenes.drive(), "#/jobs/folder")
        self.browser.wait("the pose space", lambda f: f["screen"] == "job" and f.get("poseSpace"))
        self.browser.driver.execute_script("document.querySelector('.plot canvas').focus()")
        self.browser.press(Keys.ARROW_RIGHT)
        scenario = int(re.search(r"^#(\d+) .* at x ", self.browser.wait_text(" at x "), re.MULTILINE).group(1))
        self.browser.press(Keys.ENTER)
        self.browser.scenario(scenario)
