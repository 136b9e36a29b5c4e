"""Tests what the page shows of a job that asks how far the bodies are apart."""
import csv

from page_case import PageTest


class Distance(PageTest):
    def rows(self, folder):
        with open(folder / "scenarios.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_the_nearest_pair_is_drawn_with_a_line(self):
        folder = self.scenes.distances()
        self.open(folder, "#/jobs/folder/1?cam=-9,0,0,0,0,0&ghost=none")
        facts = self.browser.scenario(1)
        row = self.rows(folder)[1]
        self.assertEqual(facts["class"], "separate")
        self.assertEqual(facts["verified"], True)
        self.assertEqual(facts["gaps"], 1)
        self.assertEqual(facts["highlighted"], [[int(row["triangle_a"])], [int(row["triangle_b"])]])
        self.browser.wait_text("the bodies are 0.03 m apart")
        self.browser.wait_text("the nearest triangles: the line joins their nearest points")

    def test_bodies_in_contact_are_drawn_with_their_contacts(self):
        self.open(self.scenes.distances(), "#/jobs/folder/3")
        facts = self.browser.scenario(3)
        self.assertEqual(facts["class"], "contact")
        self.assertEqual(facts["verified"], True)
        self.assertEqual(facts["gaps"], 0)
        self.assertGreater(len(facts["highlighted"][0]), 0)

    def test_the_job_lists_the_least_distances(self):
        self.open(self.scenes.distances(), "#/jobs/folder")
        self.browser.wait("the job", lambda facts: facts.get("job") == "folder" and facts["ready"])
        text = self.browser.wait_text("least distances")
        self.assertIn("level distance", text)
        places = [text.index(number) for number in ("0.02", "0.03", "0.04", "0.7")]
        self.assertEqual(places, sorted(places))
