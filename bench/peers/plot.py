#!/usr/bin/env python3
"""Draws the two pictures of the report from the CSV files of peers_report.

    plot.py FOLDER            writes peers.{svg,png} and scaling.{svg,png} there
"""
import os
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import page  # noqa: E402
from page import in_order, number, read, select  # noqa: E402


def save(figure, folder, name):
    for kind in ("svg", "png"):
        figure.savefig(os.path.join(folder, f"{name}.{kind}"), dpi=150, bbox_inches="tight")
    plt.close(figure)


def draw_bars(axes, engines, column, title):
    """A group of bars a scene, a bar an engine."""
    rows = [row for row in select(engines, suite="scenes") if row[column]]
    scenes = in_order(rows, "scene")
    names = in_order(rows, "engine")
    width = 0.8 / max(1, len(names))
    for i, name in enumerate(names):
        mine = select(rows, engine=name)
        axes.bar([scenes.index(row["scene"]) + (i + 0.5) * width - 0.4 for row in mine],
                 [number(row, column) for row in mine], width, label=name)
    axes.set_yscale("log")
    axes.set_xticks(range(len(scenes)), scenes, rotation=15, fontsize=7)
    axes.set_ylabel("us a pose")
    axes.set_title(title, fontsize=9)
    axes.grid(True, axis="y", which="major", linewidth=0.3)
    axes.set_ylim(top=10 * axes.get_ylim()[1])  # Room for the names.
    axes.legend(fontsize=6, ncol=5, loc="upper center")


def draw_peers(folder, engines):
    figure, axes = plt.subplots(2, 1, figsize=(12, 9))
    draw_bars(axes[0], engines, "median_us", "all pairs, median over the poses")
    draw_bars(axes[1], engines, "any_best_us", "any contact, mean over the poses of the best pass")
    figure.tight_layout()
    save(figure, folder, "peers")


def draw_lines(axes, rows, x, column, labels):
    rows = [row for row in rows if row[column]]
    for name in in_order(rows, "engine"):
        mine = select(rows, engine=name)
        axes.plot([x(row) for row in mine], [number(row, column) for row in mine], marker=".",
                  linewidth=0.8, label=name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    axes.grid(True, which="major", linewidth=0.3)
    axes.legend(fontsize=6)


def draw_contacts(axes, poses):
    """A dot a pose: of all scenes, those with contacts."""
    for name in (page.OURS, page.FCL_FLOAT, page.FCL_DOUBLE):
        mine = [r for r in select(poses, engine=name) if r["all_us"] and number(r, "pairs") > 0]
        axes.scatter([number(r, "pairs") for r in mine], [number(r, "all_us") for r in mine], s=2,
                     label=name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("contacts of the pose")
    axes.set_ylabel("all pairs, us")
    axes.grid(True, which="major", linewidth=0.3)
    axes.legend(fontsize=6)


def draw_threads(axes, threads, scenes):
    """How many times as fast two threads are: of each size the pairs of runs, and their median."""
    counts = {row["scene"]: number(row, "triangles_a") + number(row, "triangles_b")
              for row in select(scenes, suite="size")}
    rows = select(threads, suite="size")
    axes.scatter([counts[row["scene"]] for row in rows], [number(row, "ratio") for row in rows], s=6)
    names = in_order(rows, "scene")
    axes.plot([counts[name] for name in names],
              [statistics.median(number(row, "ratio") for row in select(rows, scene=name))
               for name in names], linewidth=0.8)
    axes.set_xscale("log")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("triangles of both bodies")
    axes.set_ylabel("all pairs, 2 threads against 1")
    axes.grid(True, which="major", linewidth=0.3)


def draw_scaling(folder, scenes, engines, poses, threads):
    size = select(engines, suite="size")
    depth = select(engines, suite="depth")
    counts = {row["scene"]: number(row, "triangles_a") + number(row, "triangles_b")
              for row in select(scenes, suite="size")}

    def triangles(row):
        return counts[row["scene"]]

    figure, axes = plt.subplots(2, 4, figsize=(20, 8.5))
    count = "triangles of both bodies"
    draw_lines(axes[0][0], size, triangles, "mean_us", (count, "all pairs, mean us"))
    draw_lines(axes[0][1], size, triangles, "any_best_us", (count, "any contact, mean us"))
    draw_lines(axes[0][2], size, triangles, "build_ms", (count, "build, ms"))
    draw_lines(axes[1][0], size, triangles, "bytes_triangle", (count, "memory, bytes a triangle"))
    draw_contacts(axes[1][1], poses)
    draw_lines(axes[1][2], depth, lambda row: 100 * number(row, "x"), "mean_us",
               ("depth, % of B's diagonal", "all pairs, mean us"))
    draw_threads(axes[0][3], threads, scenes)
    draw_lines(axes[1][3], depth, lambda row: 100 * number(row, "x"), "any_best_us",
               ("depth, % of B's diagonal", "any contact, mean us"))
    figure.tight_layout()
    save(figure, folder, "scaling")


def main():
    folder = sys.argv[1]
    engines = read(folder, "engines")
    draw_peers(folder, engines)
    draw_scaling(folder, read(folder, "scenes"), engines, read(folder, "poses"),
                 read(folder, "threads"))


if __name__ == "__main__":
    main()
