#!/usr/bin/env python3
"""Proves that the generator of pages refuses a run with a wrong answer of ours, and a summary that is too
long. Usage: page_test.py"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest

REPORT = pathlib.Path(__file__).resolve().parents[3] / "bench/report"
sys.path.insert(0, str(REPORT))
sys.dont_write_bytecode = True

import page  # noqa: E402
import peers  # noqa: E402
from tables import show  # noqa: E402

COUNTS = ("separate", "touch", "coplanar", "proper", "invented", "missed_touch", "missed_coplanar",
          "missed_proper", "wrong_class", "swap_differs", "order_differs", "unanswered")


def answers(**changed):
    """The exit status of a page of one engine of ours and one of others, 40 pairs each."""
    row = {"engine": "cdcluster, certified", "suite": "corpus", "category": "random", "ending": "done",
           **{count: 0 for count in COUNTS}, "separate": 10, "touch": 10, "coplanar": 10, "proper": 10}
    theirs = {**row, "engine": "another", "invented": 3}
    return written_page("answers", {"pairs": [{**row, **changed}, theirs]}, "ANSWERS.md", "abc")


def shots(**changed):
    """The exit status of a page of shot lines, one row of ours and one of another engine."""
    row = {"body": "sphere", "kind": "grid", "closed": "yes", "engine": "cdcluster", "ending": "done",
           "lines": 10, "hits": 20, "lines_per_s": 1e6, "ratio": 1, "missing": 0, "doubled": 0,
           "wrong_lines": 0, "odd_lines": 0, "judged": 0, "ours_wrong": 0}
    theirs = {**row, "engine": "Embree robust", "ratio": 2.5, "missing": 7, "odd_lines": 7}
    return written_page("shots", {"shots": [{**row, **changed}, theirs]}, "RESULTS.md", "2.5 (7 / 0 / 7)")


def motions(**changed):
    """The exit status of a page of motions, one row of ours and one of another engine."""
    row = {"scene": "two boxes", "kind": "onto, straight", "engine": "cdcluster", "paths": 10,
           "impacts": 10, "undecided": 0, "unanswered": 0, "missed": 0, "invented": 0, "mean_ms": 1,
           "median_ms": 1, "off_median": 0, "off_early": 0, "off_late": 0}
    theirs = {**row, "engine": "FCL", "impacts": 4, "missed": 6}
    return written_page("motions", {"motions": [{**row, **changed}, theirs]}, "RESULTS.md",
                        "1 / 1; 6 / 0 / 0 of 10; 0 / 0 / 0")


def scenes(**changed):
    """The exit status of a page of scenes, one row of ours and one of another engine."""
    row = {"scene": "town", "bodies": 1000, "engine": "cdcluster", "ending": "done", "steps": 5,
           "mean_ms": 0.1, "median_ms": 0.1, "ratio": 1, "pairs": 82, "missing": 0}
    theirs = {**row, "engine": "FCL", "ratio": 4, "pairs": 120}
    return written_page("scenes", {"scenes": [{**row, **changed}, theirs]}, "RESULTS.md", "4 x; 120 (0)")


def written_page(kind, tables, name, expected):
    """The exit status of a page of these tables, which must have the expected text."""
    with tempfile.TemporaryDirectory() as folder:
        for table, rows in {**tables, "machine": [{"what": "commit", "value": "abc"}]}.items():
            with open(pathlib.Path(folder, table + ".csv"), "w", newline="", encoding="utf-8") as file:
                writer = csv.DictWriter(file, rows[0].keys())
                writer.writeheader()
                writer.writerows(rows)
        done = subprocess.run([sys.executable, "-B", REPORT / "page.py", kind, folder],
                              capture_output=True, check=False)
        assert expected in pathlib.Path(folder, name).read_text(encoding="utf-8")
        return done.returncode


class Page(unittest.TestCase):
    def test_a_run_without_a_wrong_answer_of_ours_passes(self):
        self.assertEqual(answers(), 0)

    def test_a_wrong_answer_of_ours_is_refused(self):
        for column in ("invented", "missed_touch", "wrong_class", "swap_differs", "order_differs",
                       "unanswered"):
            self.assertEqual(answers(**{column: 1}), 1, column)
        self.assertEqual(answers(ending="crashed"), 1)

    def test_a_run_without_ours_is_refused(self):
        self.assertEqual(answers(engine="a third"), 1)

    def test_a_wrong_line_of_ours_is_refused(self):
        self.assertEqual(shots(), 0)
        self.assertEqual(shots(ours_wrong=1), 1)
        self.assertEqual(shots(odd_lines=1), 1)
        self.assertEqual(shots(odd_lines=1, closed="no"), 0)

    def test_a_missed_impact_of_ours_is_refused(self):
        self.assertEqual(motions(), 0)
        self.assertEqual(motions(impacts=9), 1)
        self.assertEqual(motions(unanswered=1), 1)

    def test_a_missing_pair_of_ours_is_refused(self):
        self.assertEqual(scenes(), 0)
        self.assertEqual(scenes(missing=1), 1)

    def test_a_summary_has_60_lines_and_cells_of_25_words(self):
        self.assertEqual(page.broken_rules("a\n" * 60 + f"| {'b ' * 25} |"), ["61 lines, more than 60"])
        self.assertEqual(page.broken_rules("a\n" * 59 + f"| {'b ' * 25} |"), [])
        self.assertEqual(len(page.broken_rules(f"| a | {'b ' * 26} |")), 1)

    def test_a_ratio_of_two_threads_above_2_is_void(self):
        self.assertIsNone(peers.thread_ratio([{"ratio": "1.9"}, {"ratio": "2.1"}, {"ratio": "2.2"}]))
        self.assertEqual(peers.thread_ratio([{"ratio": "1.9"}, {"ratio": "1.8"}, {"ratio": "2.2"}]), 1.9)

    def test_numbers_are_short(self):
        self.assertEqual([show(value) for value in (None, 0, 12.345, 1234.5, 2.0**400, -1234)],
                         ["", "0", "12.3", "1,234", "2.6e+120", "-1,234"])


if __name__ == "__main__":
    unittest.main()
