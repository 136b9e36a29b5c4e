#!/usr/bin/env python3
"""What certification adds to ordinary whole queries: exact decisions against those of floats alone,
in turn, by the medians of the rounds.

    certification.py FOLDER_OF_PROGRAMS OUT [--rounds 20] [--scenarios 50] [--couples 4]
                     [--callgrind]

Writes OUT/certification.csv. --callgrind also counts instructions of the AVX2 target (Valgrind
runs no AVX-512), which no load of the machine disturbs.
"""
import argparse
import csv
import os
import re
import statistics
import subprocess

DECISIONS = ([], ["--floats-only"])
LEVELS = ("any", "pairs")


def output(command, **more):
    return subprocess.run(command, check=True, capture_output=True, text=True, **more)


def seconds(command):
    return float(output(command).stdout.split()[0])


def instructions(command):
    valgrind = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                "--toggle-collect=cd::bench::run_queries*"]
    done = output(valgrind + command, env={**os.environ, "CD_SIMD": "avx2"})
    return int(re.search(r"Collected : (\d+)", done.stderr).group(1))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("programs")
    parser.add_argument("out")
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--scenarios", type=int, default=50)
    parser.add_argument("--couples", type=int, default=4)
    parser.add_argument("--models", help="folder of the vehicles; default: as built")
    parser.add_argument("--callgrind", action="store_true")
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    program = os.path.join(options.programs, "query_cost")
    models = ["--models", options.models] if options.models else []

    commands = {}  # By level: for each couple the commands of both decisions.
    for couple in range(options.couples):
        poses = os.path.join(options.out, f"poses_{couple}.bin")
        saved = subprocess.run([program, "--save", poses, "--couple", str(couple),
                                "--scenarios", str(options.scenarios), *models], check=False)
        if saved.returncode != 0:
            continue  # It has said which model is missing.
        for level in LEVELS:
            commands.setdefault(level, []).append(
                [[program, "--load", poses, "--couple", str(couple), "--level", level,
                  *models, *decision]
                 for decision in DECISIONS])

    with open(os.path.join(options.out, "certification.csv"), "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["level", "measure", "rounds", "certified", "float_only", "cost_percent"])
        for level, couples in commands.items():
            rounds = [[sum(seconds(couple[i]) for couple in couples) for i in (0, 1)]
                      for _ in range(options.rounds)]
            with_all, floats = (statistics.median(r[i] for r in rounds) for i in (0, 1))
            writer.writerow([level, "seconds", options.rounds, with_all, floats,
                             100 * (with_all / floats - 1)])
            if options.callgrind:
                # Counts do not vary: one run over the poses is enough.
                with_all, floats = (
                    sum(instructions(couple[i] + ["--repeat", "1"]) for couple in couples)
                    for i in (0, 1))
                writer.writerow([level, "instructions, AVX2", 1, with_all, floats,
                                 100 * (with_all / floats - 1)])


if __name__ == "__main__":
    main()
