#!/usr/bin/env python3
"""Turns the CSV files of a run into a page of Markdown: RESULTS.md, ANSWERS.md for the kind `answers`, or GAINS.md.

    page.py KIND FOLDER      KIND: peers, distances, shots, motions, scenes, accuracy, answers, cluster, gains or ranges

Fails, after it has written the page, when an answer of ours is wrong, and when the page breaks a rule.
"""
import argparse
import importlib
import os
import re
import sys

from tables import read

KINDS = ("peers", "distances", "shots", "motions", "scenes", "accuracy", "answers", "cluster",
         "gains", "ranges")
LINES_MAX = 60
CELL_WORDS_MAX = 25
# Rows of machine.csv that the first line of a page has.
ORIGIN = ("command", "commit", "date")


def page(title, machine, sections):
    """The page's text: where its figures come from, then its sections."""
    facts = {row["what"]: row["value"] for row in machine}
    command, commit, date = (facts.get(what, "unknown") for what in ORIGIN)
    where = "; ".join(f"{row['what']} {row['value']}" for row in machine if row["what"] not in ORIGIN)
    return "\n".join([f"# {title}\n",
                      f"Made by `{command}` at commit {commit} on {date}; README.md says what columns mean. "
                      f"Machine: {where}.\n", *(section for section in sections if section)])


def broken_rules(summary):
    lines = summary.splitlines()
    found = [] if len(lines) <= LINES_MAX else [f"{len(lines)} lines, more than {LINES_MAX}"]
    cells = (cell for line in lines if line.startswith("|") for cell in re.split(r"\s*\|\s*", line))
    return found + [f"a cell of more than {CELL_WORDS_MAX} words: {cell}" for cell in cells
                    if len(cell.split()) > CELL_WORDS_MAX]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("folder")
    options = parser.parse_args()
    kind = importlib.import_module(options.kind)
    data = {name: read(options.folder, name) for name in ("machine", *kind.FILES)}
    text = page(kind.TITLE, data["machine"], kind.summary(data))
    with open(os.path.join(options.folder, kind.PAGE), "w", encoding="utf-8") as file:
        file.write(text)
    problems = kind.faults(data) + broken_rules(text)
    for problem in problems:
        print(f"{options.folder}: {problem}", file=sys.stderr)
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
