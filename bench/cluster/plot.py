#!/usr/bin/env python3
"""Draws the experiments from the CSV files of simulate.

    plot.py FOLDER            writes paper.{svg,png}, measured.{svg,png} and memory.{svg,png} there
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from page import SCENES, SETTINGS, Series, at, values  # noqa: E402
from report import read  # noqa: E402


def save(figure, folder, name):
    figure.tight_layout()
    for kind in ("svg", "png"):
        figure.savefig(os.path.join(folder, f"{name}.{kind}"), dpi=120, bbox_inches="tight")
    plt.close(figure)


def draw(axes, series, column, labels):
    """A line a strategy; bars are the range over the seeds."""
    for strategy in series.strategies():
        means = [series.mean(x, strategy, column) for x in series.xs]
        seeds = [values(at(series.rows, x, strategy), column) for x in series.xs]
        errors = [[max(0, mean - min(each)) for mean, each in zip(means, seeds)],
                  [max(0, max(each) - mean) for mean, each in zip(means, seeds)]]
        axes.errorbar(series.xs, means, yerr=errors, marker=".", linewidth=0.8, elinewidth=0.5,
                      label=strategy)
    axes.set_xlabel(labels[0], fontsize=8)
    axes.set_ylabel(labels[1], fontsize=8)
    axes.grid(True, linewidth=0.3)
    axes.set_ylim(bottom=0)


def draw_grid(folder, name, runs, settings, experiments, columns):
    """Rows: setting, scene and column; columns: experiments."""
    kinds = [(setting, scene, column) for setting in settings for scene in SCENES
             for column in columns]
    figure, axes = plt.subplots(len(kinds), len(experiments), squeeze=False,
                                figsize=(4.2 * len(experiments), 2.9 * len(kinds)))
    for row, (setting, scene, (column, label)) in enumerate(kinds):
        for place, (experiment, x_label) in enumerate(experiments):
            series = Series(runs, setting, scene, experiment)
            if series.rows:
                draw(axes[row][place], series, column, (x_label, label))
                axes[row][place].set_title(f"{scene}, {setting}", fontsize=8)
            if experiment == "q" or (experiment == "scenarios" and setting == "measured"):
                axes[row][place].set_xscale("log")
    handles, names = axes[0][0].get_legend_handles_labels()
    axes[0][0].legend(handles, names, fontsize=6)
    save(figure, folder, name)


def main():
    folder = sys.argv[1]
    runs = read(folder, "runs")
    experiments = (("scenarios", "scenarios (Figure 10)"), ("depth", "depth (Figure 11)"),
                   ("q", "q (Figure 12)"), ("cores", "weighted cores (Figure 13)"))
    columns = (("paper_speedup", "speed-up, as in the paper"), ("transfer", "relative transfer"))
    draw_grid(folder, "paper", runs, SETTINGS, experiments, columns)
    draw_grid(folder, "measured", runs, ("measured",),
              experiments,
              (("speedup", "speed-up"), ("transfer", "relative transfer")))
    draw_grid(folder, "memory", runs, ("unfitted", "measured"), (("depth", "depth"),),
              (("memory_max_mb", "MB at one worker"), ("memory_sum_mb", "MB at all workers")))


if __name__ == "__main__":
    main()
