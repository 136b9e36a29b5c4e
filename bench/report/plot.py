#!/usr/bin/env python3
"""Draws the pictures of a run from its CSV files, each as SVG and PNG.

    plot.py KIND FOLDER      KIND: peers, accuracy or cluster
"""
import dataclasses
import os
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import accuracy  # noqa: E402
import cluster  # noqa: E402
from tables import in_order, number, read, select  # noqa: E402


@dataclasses.dataclass
class Panel:
    """One pair of axes. Each value of the column `line` has its own line; rows with the same x are averaged."""
    rows: list
    x: str
    y: str
    line: str = "engine"
    title: str = ""
    x_scale: str = "linear"  # Or log, symlog, names: the x are names, without lines between points.
    y_scale: str = "log"

    def draw(self, axes):
        rows = [row for row in self.rows if row[self.y] != ""]
        for name in in_order(rows, self.line):
            mine = select(rows, **{self.line: name})
            xs = in_order(mine, self.x)
            if self.x_scale != "names":
                xs.sort(key=float)
            ys = [statistics.mean(number(row, self.y) for row in select(mine, **{self.x: x})) for x in xs]
            axes.plot(xs if self.x_scale == "names" else [float(x) for x in xs], ys, marker=".",
                      linewidth=0 if self.x_scale == "names" else 0.8, label=name)
        if self.x_scale == "names":
            axes.tick_params(axis="x", labelrotation=15, labelsize=6)
        else:
            axes.set_xscale(self.x_scale)
        axes.set_yscale(self.y_scale)
        axes.set_xlabel(self.x, fontsize=8)
        axes.set_ylabel(self.y, fontsize=8)
        axes.set_title(self.title, fontsize=8)
        axes.grid(True, which="major", linewidth=0.3)
        axes.legend(fontsize=6)


def peers_pictures(folder):
    engines = read(folder, "engines")
    scenes, sizes = (select(engines, suite=suite) for suite in ("scenes", "size"))
    yield "peers", [[Panel(scenes, "scene", y, title="a pose", x_scale="names")
                     for y in ("mean_us", "any_best_us")]]
    # The x of a size is the number of triangles of both bodies.
    yield "scaling", [[Panel(sizes, "x", y, title="by triangles of both bodies", x_scale="log")
                       for y in ("mean_us", "any_best_us", "build_ms", "bytes_triangle")]]


def accuracy_pictures(folder):
    pairs = read(folder, "pairs")
    yield "speed_error", [[Panel(accuracy.speed_errors(select(pairs, suite=suite)), "wrong per million", "ns a pair",
                                 title=suite, x_scale="symlog") for suite in ("corpus", "scenes", "vehicles")]]
    yield "coarse", [[Panel(read(folder, "coarse"), "value", y, "setting", x_scale="log", y_scale=scale)
                      for y, scale in (("us_query", "log"), ("error_mean", "linear"))]]


def cluster_pictures(folder):
    runs = read(folder, "runs")
    for setting in (*cluster.SETTINGS, "measured"):
        yield setting, [[Panel(select(runs, setting=setting, scene=scene, experiment=experiment), "x", y, "strategy",
                               f"{scene}, {experiment}", y_scale="linear")
                         for experiment in ("scenarios", "depth", "q", "cores")]
                        for scene in cluster.SCENES for y in ("speedup", "transfer", "memory_sum_mb")]


def main():
    kind, folder = sys.argv[1:]
    pictures = {"peers": peers_pictures, "accuracy": accuracy_pictures, "cluster": cluster_pictures}[kind]
    for name, panels in pictures(folder):
        size = (5.5 * len(panels[0]), 4 * len(panels))
        figure, axes = plt.subplots(len(panels), len(panels[0]), squeeze=False, figsize=size)
        for row, places in zip(panels, axes):
            for panel, place in zip(row, places):
                panel.draw(place)
        figure.tight_layout()
        for kind in ("svg", "png"):
            figure.savefig(os.path.join(folder, f"{name}.{kind}"), dpi=150, bbox_inches="tight")
        plt.close(figure)


if __name__ == "__main__":
    main()
