"""Tests what the page shows of a job with a clearance."""
import csv

from page_case import PageTest


def is_orange(colour):
    red, green, blue = colour
    return red > 140 and red > 1.3 * green > 1.3 * 1.3 * blue


class Near(PageTest):
    def near_pairs(self, folder, scenario):
        """The near pairs of a scenario, from pairs.csv."""
        with open(folder / "pairs.csv", newline="") as file:
            rows = [row for row in csv.DictReader(file) if int(row["scenario"]) == scenario]
        return [(int(row["triangle_a"]), int(row["triangle_b"])) for row in rows if row["class"] == "near"]

    def test_near_triangles_are_orange_with_lines_between_them(self):
        folder = self.scenes.approach()
        self.open(folder, "#/jobs/folder/1?cam=-9,0,0,0,0,0&ghost=none")
        facts = self.browser.scenario(1)
        pairs = self.near_pairs(folder, 1)
        self.assertGreater(len(pairs), 0)
        self.assertEqual(facts["class"], "near")
        self.assertEqual(facts["verified"], True)
        self.assertEqual(facts["gaps"], len(pairs))
        self.assertEqual(facts["highlighted"], [sorted({pair[body] for pair in pairs}) for body in (0, 1)])
        self.browser.wait_text("near: the line joins the nearest points")
        self.browser.wait_text("nearest triangles 0.03 m apart")
        x, y = facts["pointPixels"][0]
        # Beside the line and its ends: the triangles are seen through the walls of A.
        step = self.browser.box(".stage canvas")[3] / 60
        around = [self.browser.colour(x + i * step, y + j * step) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        self.assertTrue(any(is_orange(colour) for colour in around), around)
        self.browser.picture("viewer-near-light")

    def test_next_finds_contacts_near_scenarios_or_both(self):
        folder = self.scenes.approach()
        self.open(folder, "#/jobs/folder/0")
        self.browser.scenario(0)
        self.browser.press("n")
        self.browser.scenario(3)
        self.browser.go("#/jobs/folder/0?seek=near")
        self.browser.scenario(0)
        for expected in (1, 2, 5):
            self.browser.press("n")
            self.browser.scenario(expected)
        self.browser.go("#/jobs/folder/1?seek=either")
        self.browser.scenario(1)
        for expected in (2, 3, 5):
            self.browser.press("n")
            self.browser.scenario(expected)

    def test_the_job_counts_near_scenarios(self):
        self.open(self.scenes.approach(), "#/jobs/folder")
        self.browser.wait("the job", lambda facts: facts.get("job") == "folder" and facts["ready"])
        text = self.browser.wait_text("In 3 scenarios without contact the bodies are at most 0.05 m apart")
        self.assertIn("1 of 6 scenarios", text)
        self.browser.wait_text("clearance 0.05 m")
        self.browser.wait_text("parts in contact or near")
        self.browser.wait_text("2 runs of consecutive scenarios in contact or near")
