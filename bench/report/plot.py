#!/usr/bin/env python3
"""Draws the pictures of a run from its CSV files, each as SVG and PNG.

    plot.py KIND FOLDER      KIND: peers, accuracy or cluster
"""
import os
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import accuracy  # noqa: E402
import cluster  # noqa: E402
import peers  # noqa: E402
from tables import in_order, number, read, select, weighted  # noqa: E402


def save(figure, folder, name):
    for kind in ("svg", "png"):
        figure.savefig(os.path.join(folder, f"{name}.{kind}"), dpi=150, bbox_inches="tight")
    plt.close(figure)


def label(axes, x, y):
    axes.set_xlabel(x, fontsize=8)
    axes.set_ylabel(y, fontsize=8)
    axes.grid(True, which="major", linewidth=0.3)


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
    label(axes, "", "us a pose")
    axes.set_title(title, fontsize=9)
    axes.set_ylim(top=10 * axes.get_ylim()[1])  # Room for the names.
    axes.legend(fontsize=6, ncol=5, loc="upper center")


def draw_scenes(folder, engines):
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
    label(axes, *labels)
    axes.legend(fontsize=6)


def draw_contacts(axes, poses):
    """A dot a pose: of all scenes, those with contacts."""
    for name in (peers.OURS, peers.FCL_FLOAT, peers.FCL_DOUBLE):
        mine = [r for r in select(poses, engine=name) if r["all_us"] and number(r, "pairs") > 0]
        axes.scatter([number(r, "pairs") for r in mine], [number(r, "all_us") for r in mine], s=2,
                     label=name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    label(axes, "contacts of the pose", "all pairs, us")
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
    label(axes, "triangles of both bodies", "all pairs, 2 threads against 1")


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


def not_dominated(points):
    """Those that no other point beats in both coordinates, by ascending x."""
    best = []
    for x, y in sorted(set(points)):
        if not best or y < best[-1][1]:
            best.append((x, y))
    return best


def draw_pairs(axes, rows, title):
    ours, theirs, names = [], [], {}
    for engine in in_order(rows, "engine"):
        mine = select(rows, engine=engine)
        ns = accuracy.mean_ns(mine)
        wrong = accuracy.wrong_per_million(mine)
        if not ns or wrong is None:
            continue
        is_ours = mine[0]["ours"] == "yes"
        (ours if is_ours else theirs).append((wrong, ns))
        names[(wrong, ns)] = engine.removeprefix("cdcluster, ")
    for points, marker, whose in ((ours, "o", "ours"), (theirs, "s", "others")):
        axes.scatter([p[0] for p in points], [p[1] for p in points], marker=marker, label=whose)
    front = not_dominated(ours + theirs)
    axes.plot([p[0] for p in front], [p[1] for p in front], linewidth=0.8, linestyle="--",
              label="not dominated")
    # Linear up to one wrong answer in a million, so that zero is on the paper.
    axes.set_xscale("symlog", linthresh=1)
    axes.set_xlim(-0.5, 2e6)
    axes.set_yscale("log")
    label(axes, "wrong answers per million", "ns a pair")
    axes.set_title(title, fontsize=9)
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
              if select(pairs, suite=s)]
    figure, axes = plt.subplots(1, len(suites), figsize=(6 * len(suites), 5), squeeze=False)
    for place, (suite, title) in zip(axes[0], suites):
        draw_pairs(place, select(pairs, suite=suite), title)
    save(figure, folder, "speed_error")


def draw_coarse(folder, coarse):
    figure, axes = plt.subplots(figsize=(7, 5))
    for setting, marker in (("exact", "*"), ("tolerance", "o"), ("cut", "^")):
        points = []
        for value in in_order(select(coarse, setting=setting), "value"):
            rows = select(coarse, setting=setting, value=value)
            points.append(tuple(weighted(rows, c, "queries") for c in ("error_mean", "us_query")))
            if setting != "exact":
                axes.annotate(value, points[-1], textcoords="offset points", xytext=(5, 4),
                              fontsize=7)
        axes.plot([p[0] for p in points], [p[1] for p in points], marker=marker, linewidth=0.8,
                  label=setting if setting != "cut" else "depth of the cut")
    axes.set_xscale("symlog", linthresh=1e-4)
    axes.set_xlim(left=-2e-5)
    axes.set_yscale("log")
    label(axes, "bound less true distance, mean share of the diagonal", "us a query for any contact")
    axes.legend(fontsize=8)
    save(figure, folder, "coarse")


def draw_series(axes, series, column, labels):
    """A line a strategy; bars are the range over the seeds."""
    for strategy in series.strategies():
        means = [series.mean(x, strategy, column) for x in series.xs]
        seeds = [cluster.values(cluster.at(series.rows, x, strategy), column) for x in series.xs]
        errors = [[max(0, mean - min(each)) for mean, each in zip(means, seeds)],
                  [max(0, max(each) - mean) for mean, each in zip(means, seeds)]]
        axes.errorbar(series.xs, means, yerr=errors, marker=".", linewidth=0.8, elinewidth=0.5,
                      label=strategy)
    label(axes, *labels)
    axes.set_ylim(bottom=0)


def draw_grid(folder, name, runs, settings, experiments, columns):
    """Rows: setting, scene and column; columns: experiments."""
    kinds = [(setting, scene, column) for setting in settings for scene in cluster.SCENES
             for column in columns]
    figure, axes = plt.subplots(len(kinds), len(experiments), squeeze=False,
                                figsize=(4.2 * len(experiments), 2.9 * len(kinds)))
    for row, (setting, scene, (column, y_label)) in enumerate(kinds):
        for place, (experiment, x_label) in enumerate(experiments):
            series = cluster.Series(runs, setting, scene, experiment)
            if series.rows:
                draw_series(axes[row][place], series, column, (x_label, y_label))
                axes[row][place].set_title(f"{scene}, {setting}", fontsize=8)
            if experiment == "q" or (experiment == "scenarios" and setting == "measured"):
                axes[row][place].set_xscale("log")
    handles, names = axes[0][0].get_legend_handles_labels()
    axes[0][0].legend(handles, names, fontsize=6)
    figure.tight_layout()
    save(figure, folder, name)


def draw_peers(folder):
    engines = read(folder, "engines")
    draw_scenes(folder, engines)
    draw_scaling(folder, read(folder, "scenes"), engines, read(folder, "poses"), read(folder, "threads"))


def draw_accuracy(folder):
    draw_speed_error(folder, read(folder, "pairs"))
    draw_coarse(folder, read(folder, "coarse"))


def draw_cluster(folder):
    runs = read(folder, "runs")
    experiments = (("scenarios", "scenarios (Figure 10)"), ("depth", "depth (Figure 11)"),
                   ("q", "q (Figure 12)"), ("cores", "weighted cores (Figure 13)"))
    draw_grid(folder, "paper", runs, cluster.SETTINGS, experiments,
              (("paper_speedup", "speed-up, as in the paper"), ("transfer", "relative transfer")))
    draw_grid(folder, "measured", runs, ("measured",), experiments,
              (("speedup", "speed-up"), ("transfer", "relative transfer")))
    draw_grid(folder, "memory", runs, ("unfitted", "measured"), (("depth", "depth"),),
              (("memory_max_mb", "MB at one worker"), ("memory_sum_mb", "MB at all workers")))


def main():
    kind, folder = sys.argv[1:]
    {"peers": draw_peers, "accuracy": draw_accuracy, "cluster": draw_cluster}[kind](folder)


if __name__ == "__main__":
    main()
