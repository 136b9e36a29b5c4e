#!/usr/bin/env python3
"""Draws the two pictures of the report from the CSV files of accuracy_report.

    plot.py FOLDER            writes speed_error.{svg,png} and coarse.{svg,png} there
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import report  # noqa: E402


def not_dominated(points):
    """Those that no other point beats in both coordinates, by ascending x."""
    best = []
    for x, y in sorted(set(points)):
        if not best or y < best[-1][1]:
            best.append((x, y))
    return best


def save(figure, folder, name):
    for kind in ("svg", "png"):
        figure.savefig(os.path.join(folder, f"{name}.{kind}"), dpi=150, bbox_inches="tight")
    plt.close(figure)


def draw_pairs(axes, rows, title):
    ours, theirs, names = [], [], {}
    for engine in report.in_order(rows, "engine"):
        mine = report.select(rows, engine=engine)
        ns = report.mean_ns(mine)
        wrong = report.wrong_per_million(mine)
        if not ns or wrong is None:
            continue
        is_ours = mine[0]["ours"] == "yes"
        (ours if is_ours else theirs).append((wrong, ns))
        names[(wrong, ns)] = engine.removeprefix("cdcluster, ")
    for points, marker, label in ((ours, "o", "ours"), (theirs, "s", "others")):
        axes.scatter([p[0] for p in points], [p[1] for p in points], marker=marker, label=label)
    front = not_dominated(ours + theirs)
    axes.plot([p[0] for p in front], [p[1] for p in front], linewidth=0.8, linestyle="--",
              label="not dominated")
    # Linear up to one wrong answer in a million, so that zero is on the paper.
    axes.set_xscale("symlog", linthresh=1)
    axes.set_xlim(-0.5, 2e6)
    axes.set_yscale("log")
    axes.set_xlabel("wrong answers per million")
    axes.set_ylabel("ns a pair")
    axes.set_title(title, fontsize=9)
    axes.grid(True, which="major", linewidth=0.3)
    axes.legend(fontsize=6, loc="upper center")
    write_names(axes, names)


def write_names(axes, names):
    """Names beside their points, on the side with room, pushed upwards where they would overlap."""
    last = {}
    for (wrong, ns), name in sorted(names.items(), key=lambda item: item[0][1]):
        is_right = wrong > 1e3
        _, y = axes.transData.transform((wrong, ns)) * 72 / axes.figure.dpi
        y_text = max(y - 2, last.get(is_right, -1e9) + 7)
        last[is_right] = y_text
        axes.annotate(name, (wrong, ns), textcoords="offset points", fontsize=6,
                      xytext=(-7 if is_right else 7, y_text - y),
                      ha="right" if is_right else "left")


def draw_speed_error(folder, pairs):
    suites = [(s, t) for s, t in (("corpus", "hard pairs"), ("scenes", "candidates of hard scenes"),
                                  ("vehicles", "candidates of vehicles"))
              if report.select(pairs, suite=s)]
    figure, axes = plt.subplots(1, len(suites), figsize=(6 * len(suites), 5), squeeze=False)
    for place, (suite, title) in zip(axes[0], suites):
        draw_pairs(place, report.select(pairs, suite=suite), title)
    save(figure, folder, "speed_error")


def draw_coarse(folder, coarse):
    figure, axes = plt.subplots(figsize=(7, 5))
    for setting, marker in (("exact", "*"), ("tolerance", "o"), ("cut", "^")):
        points = []
        for value in report.in_order(report.select(coarse, setting=setting), "value"):
            rows = report.select(coarse, setting=setting, value=value)
            queries = report.total(rows, "queries")
            error = sum(report.number(r, "error_mean") * report.number(r, "queries") for r in rows)
            time = sum(report.number(r, "us_query") * report.number(r, "queries") for r in rows)
            points.append((error / queries, time / queries))
            if setting != "exact":
                axes.annotate(value, points[-1], textcoords="offset points", xytext=(5, 4),
                              fontsize=7)
        axes.plot([p[0] for p in points], [p[1] for p in points], marker=marker, linewidth=0.8,
                  label=setting if setting != "cut" else "depth of the cut")
    axes.set_xscale("symlog", linthresh=1e-4)
    axes.set_xlim(left=-2e-5)
    axes.set_yscale("log")
    axes.set_xlabel("bound less true distance, mean share of the diagonal")
    axes.set_ylabel("us a query for any contact")
    axes.grid(True, which="major", linewidth=0.3)
    axes.legend(fontsize=8)
    save(figure, folder, "coarse")


def main():
    folder = sys.argv[1]
    draw_speed_error(folder, report.read(folder, "pairs"))
    draw_coarse(folder, report.read(folder, "coarse"))


if __name__ == "__main__":
    main()
