#!/usr/bin/env python3
"""Proves that cdctl finds in traffic of SUMO the two collisions that were put in, at their steps, and
else what it finds without them. Usage: check.py CDCTL MESHES FOLDER"""
import csv
import pathlib
import subprocess
import sys

from make_traffic import STEPS, VEHICLES, make


def episodes(cdctl, folder, name):
    """Runs a job and returns its episodes: first and last step, and the two ids."""
    out = folder / f"{name}.out"
    # A run with a contact is no error: only --fail-on would make it one.
    subprocess.run([cdctl, "run", folder / f"{name}.toml", "--out", out, "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)
    with open(next(out.rglob("episodes.csv")), newline="") as file:
        return {(int(row["first_step"]), int(row["last_step"]), frozenset((row["body_a"], row["body_b"])))
                for row in csv.DictReader(file)}


def covered_steps(folder, name):
    with open(next((folder / f"{name}.out").rglob("coverage.csv")), newline="") as file:
        rows = list(csv.DictReader(file))
    failed = sum(int(row["failed"]) for row in rows)
    return len(rows), failed


def main():
    cdctl, meshes, folder = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])
    collisions = make(folder, meshes)
    plain = episodes(cdctl, folder, "plain")
    collided = episodes(cdctl, folder, "collided")
    assert covered_steps(folder, "collided") == (STEPS, 0), covered_steps(folder, "collided")
    assert collided - plain == collisions, f"found {collided - plain}, put in {collisions}"
    assert plain <= collided, f"lost {plain - collided}"
    print(f"traffic: {VEHICLES} vehicles, {STEPS} steps: both collisions found, "
          f"beside {len(plain)} episodes of SUMO's own")


if __name__ == "__main__":
    main()
