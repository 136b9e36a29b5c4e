"""Tests what the page shows of a job of lines."""
import csv

from page_case import PageTest


class Shots(PageTest):
    def passages(self, folder, scenario, line):
        """Returns the rows of shotlines.csv for a line, in order."""
        with open(folder / "shotlines.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        return [row for row in rows if (int(row["scenario"]), int(row["line"])) == (scenario, line)]

    def hit_scenario(self, folder):
        """Returns the first bundle with a hit, and its number of hits."""
        with open(folder / "scenarios.csv", newline="") as file:
            return next((int(r["scenario"]), int(r["hits"])) for r in csv.DictReader(file) if int(r["hits"]) > 0)

    def test_lines_are_drawn_with_their_hits(self):
        folder = self.scenes.shots()
        scenario, hits = self.hit_scenario(folder)
        self.open(folder, f"#/jobs/folder/{scenario}")
        facts = self.browser.scenario(scenario)
        self.assertEqual(facts["class"], "contact")
        self.assertEqual(facts["verified"], True)
        self.assertEqual(facts["lines"][0], 64)
        self.assertGreater(facts["lines"][1], 0)
        self.assertLessEqual({"enters", "leaves"}, {one["kind"] for one in facts["hits"]})
        self.assertEqual(len(facts["hits"]), min(64, hits))
        self.browser.wait_text(f"contact, {hits} hits")
        self.browser.wait_text("parts hit here")
        self.browser.wait_text("where the lines come from")
        self.keep_pictures("lines")

    def test_a_click_on_a_hit_lists_its_line(self):
        folder = self.scenes.shots()
        scenario, _ = self.hit_scenario(folder)
        self.open(folder, f"#/jobs/folder/{scenario}")
        facts = self.browser.scenario(scenario)
        hit = facts["hits"][0]
        self.browser.click(*hit["pixel"])
        facts = self.browser.wait("the pick", lambda facts: facts["pick"] is not None)
        self.assertEqual(facts["pick"]["body"], 1)
        line = facts["pick"]["triangle"]
        rows = self.passages(folder, scenario, line)
        self.assertGreater(len(rows), 0)
        self.browser.wait_text(f"line {line}")
        cells = self.browser.driver.execute_script(
            "return [...document.querySelectorAll('.line-hits tbody tr')]"
            ".map((row) => [...row.cells].map((cell) => cell.textContent))"
        )
        self.assertEqual(len(cells), len(rows))
        for cell, row in zip(cells, rows):
            self.assertEqual(cell[0], row["part"])
            for text, name in zip(cell[1:], ("in", "out", "thickness")):
                if row[name]:
                    self.assertAlmostEqual(float(text), float(row[name]), delta=1e-4)
                else:
                    self.assertEqual(text, "")

    def test_first_hits_alone(self):
        folder = self.scenes.shots()
        scenario, hits = self.hit_scenario(folder)
        self.open(folder, f"#/jobs/folder/{scenario}?first=1")
        facts = self.browser.scenario(scenario)
        self.assertEqual({one["kind"] for one in facts["hits"]}, {"enters"})
        self.assertEqual(len(facts["hits"]), facts["lines"][1])
        self.assertLess(len(facts["hits"]), hits)

    def test_the_job_counts_hits(self):
        folder = self.scenes.shots()
        self.open(folder, "#/jobs/folder")
        self.browser.wait("the job", lambda facts: facts.get("job") == "folder" and facts["ready"])
        text = self.browser.wait_text("most hits")
        for words in ("bundles", "hits.", "parts hit", "hits a bundle", "directions azimuth 2", "directions"):
            self.assertIn(words, text)
        self.assertNotIn("pairs of triangles", text)
        self.keep_pictures("shots")

    def test_lines_of_a_scene_are_drawn_with_the_body_that_they_hit(self):
        folder = self.scenes.lines_through()
        with open(folder / "scenarios.csv", newline="") as file:
            rows = [row for row in csv.DictReader(file) if int(row["hits"]) > 0]
        row = [row for row in rows if (row["body_a"], row["step"]) == ("block", "1")][-1]
        scenario = int(row["scenario"])
        self.open(folder, f"#/jobs/folder/{scenario}")
        facts = self.browser.scenario(scenario)
        self.assertEqual((facts["class"], facts["verified"]), ("contact", True))
        self.assertEqual((facts["scene"]["step"], facts["scene"]["time"]), (1, 2.5))
        self.assertEqual(facts["scene"]["bodies"], [0, 2])
        self.assertEqual(facts["lines"][0], 64)
        self.assertGreater(facts["lines"][1], 0)
        self.assertLessEqual({"enters", "leaves"}, {one["kind"] for one in facts["hits"]})
        self.browser.wait_text(f"contact, {row['hits']} hits")
        self.browser.wait_text("block")
        hit = facts["hits"][0]
        self.browser.click(*hit["pixel"])
        facts = self.browser.wait("the pick", lambda facts: facts["pick"] is not None)
        self.assertEqual(facts["pick"]["body"], 1)
        passages = self.passages(folder, scenario, facts["pick"]["triangle"])
        self.assertGreater(len(passages), 0)
        self.assertEqual({passage["body"] for passage in passages}, {"block"})
        self.keep_pictures("lines_of_a_scene")
