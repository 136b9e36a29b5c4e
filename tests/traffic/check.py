#!/usr/bin/env python3
"""Proves that cdctl finds in traffic of SUMO the two collisions that were put in, at their steps, and
else what it finds without them; that motions between the steps, and only these, find a car that jumps
past another, at its step and time; and that three workers find the same. The folder has to exist.
Usage: check.py PROGRAMS MESHES FOLDER"""
import contextlib
import csv
import json
import pathlib
import subprocess
import sys

from make_traffic import CAR_METRES, JUMP_METRES, JUMPER, SECONDS_A_STEP, STEPS, VEHICLES, make

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cluster"))
from cluster_of_processes import Cluster

WORKERS = 3


@contextlib.contextmanager
def cluster_of(programs, folder):
    """Ends, with all its processes, with the `with` block."""
    home = folder / "cluster"
    home.mkdir()
    cluster = Cluster(programs, home, WORKERS)
    try:
        yield cluster
    finally:
        cluster.end()


def rows_of(folder, name, file):
    with open(next((folder / f"{name}.out").rglob(file)), newline="") as rows:
        return list(csv.DictReader(rows))


def episodes(cdctl, folder, name):
    """Runs a job and returns its episodes: first and last step, and the two ids."""
    out = folder / f"{name}.out"
    # A run with a contact is no error: only --fail-on would make it one.
    subprocess.run([cdctl, "run", folder / f"{name}.toml", "--out", out, "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)
    return {(int(row["first_step"]), int(row["last_step"]), frozenset((row["body_a"], row["body_b"])))
            for row in rows_of(folder, name, "episodes.csv")}


def covered_steps(folder, name):
    rows = rows_of(folder, name, "coverage.csv")
    failed = sum(int(row["failed"]) for row in rows)
    return len(rows), failed


def check_jump(cdctl, folder, step, struck, at_steps):
    """The car that jumps past another is apart from it at both steps, so only motions tell of it: of
    that step, with the time at which its front reaches the other's back. `at_steps` are the episodes
    without it."""
    pair = frozenset((JUMPER, struck))
    assert episodes(cdctl, folder, "jumped") == at_steps
    named = [row for row in rows_of(folder, "jumped", "scenarios.csv") if JUMPER in (row["body_a"], row["body_b"])]
    assert not named, f"the boxes meet at a step: {named}"
    plain, jumped = (episodes(cdctl, folder, f"motion-{name}") for name in ("plain", "jumped"))
    assert jumped - plain == {(step, step, pair)}, f"found {jumped - plain}, put in {step}, {pair}"
    assert plain <= jumped, f"lost {plain - jumped}"
    assert covered_steps(folder, "motion-jumped") == (STEPS - 1, 0), covered_steps(folder, "motion-jumped")
    row, = (row for row in rows_of(folder, "motion-jumped", "scenarios.csv")
            if frozenset((row["body_a"], row["body_b"])) == pair)
    begin, t0, t1 = (float(row[key]) for key in ("time", "t0", "t1"))
    meets = begin + SECONDS_A_STEP * (JUMP_METRES - CAR_METRES) / (2 * JUMP_METRES)
    metres = 2 * JUMP_METRES / SECONDS_A_STEP
    assert (row["class"], row["end"]) == ("contact", "contact"), row
    assert t0 < t1 and (t1 - t0) * metres < 0.5, row
    assert abs(t1 - meets) * metres < 0.5, f"{row}, where the front reaches the back at {meets}"
    return t0, t1, len(plain)


def check_cluster(programs, folder, name):
    """Three workers find what one process finds."""
    with cluster_of(programs, folder) as cluster:
        done = cluster.cdctl("run", folder / f"{name}.toml", "--out", folder / f"{name}.cluster.out", "--quiet")
    assert done is not None, "the cluster did not answer"
    here, there = (json.loads((folder / f"{name}{out}" / "run.json").read_text())["digest"]
                   for out in (".out", ".cluster.out"))
    assert here == there, f"digest {here} in one process, {there} on a cluster"


def main():
    programs, meshes, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    cdctl = programs / "cdctl"
    collisions, (step, struck) = make(folder, meshes)
    plain = episodes(cdctl, folder, "plain")
    collided = episodes(cdctl, folder, "collided")
    assert covered_steps(folder, "collided") == (STEPS, 0), covered_steps(folder, "collided")
    assert collided - plain == collisions, f"found {collided - plain}, put in {collisions}"
    assert plain <= collided, f"lost {plain - collided}"
    print(f"traffic: {VEHICLES} vehicles, {STEPS} steps: both collisions found, "
          f"beside {len(plain)} episodes of SUMO's own")
    t0, t1, episodes_of_motions = check_jump(cdctl, folder, step, struck, plain)
    print(f"traffic: {JUMPER} jumps past {struck} between the steps {step} and {step + 1}: found between "
          f"{t0:.5f} and {t1:.5f} s, beside {episodes_of_motions} episodes of motions of SUMO's own")
    check_cluster(programs, folder, "motion-jumped")
    print("traffic: three workers have the digest of one process")


if __name__ == "__main__":
    main()
