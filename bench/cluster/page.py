#!/usr/bin/env python3
"""Turns the CSV files of simulate into one page of Markdown tables.

    page.py FOLDER          prints the page
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "accuracy"))
from report import in_order, number, read, select, show, table  # noqa: E402

SETTINGS = ("unfitted", "fitted")
SCENES = ("heavy", "cars")
BEST, LOAD, RANDOM, LOWEST = "best-match", "best-match-load", "random", "lowest"
# The cut of the fixed body in the paper's experiments.
PAPER_DEPTH = {"heavy": 12, "cars": 10}


def values(rows, column):
    return [number(row, column) for row in rows]


def mean(rows, column):
    """Over the seeds; nothing of nothing."""
    found = values(rows, column)
    return sum(found) / len(found) if found else None


def half_range(rows, column):
    found = values(rows, column)
    return (max(found) - min(found)) / 2 if found else None


def fixed(value, digits=1):
    return "" if value is None else f"{value:.{digits}f}"


def with_range(rows, column, digits=1):
    if not rows or any(row[column] == "" for row in rows):
        return ""
    text = fixed(mean(rows, column), digits)
    return f"{text} ± {fixed(half_range(rows, column), digits)}" if len(rows) > 1 else text


def points(rows):
    return sorted({number(row, "x") for row in rows})


def at(rows, x, strategy=None):
    found = [row for row in rows if number(row, "x") == x]
    return select(found, strategy=strategy) if strategy else found


class Series:
    """One experiment in one setting and scene."""

    def __init__(self, runs, setting, scene, experiment):
        self.rows = select(runs, setting=setting, scene=scene, experiment=experiment)
        self.xs = points(self.rows)

    def strategies(self):
        return in_order(self.rows, "strategy")

    def mean(self, x, strategy, column):
        return mean(at(self.rows, x, strategy), column)

    def last(self, strategy, column):
        return self.mean(self.xs[-1], strategy, column) if self.xs else None

    def best(self, strategy, column="paper_speedup"):
        """The x with the largest mean."""
        known = [(self.mean(x, strategy, column), x) for x in self.xs if at(self.rows, x, strategy)]
        return max(known)[1] if known else None


def series_table(series, name, columns):
    """A row an x, and for each strategy the columns' means, joined."""
    header = [name] + series.strategies()
    rows = []
    for x in series.xs:
        cells = [show(round(x, 1))]
        for strategy in series.strategies():
            mine = at(series.rows, x, strategy)
            cells.append(" / ".join(with_range(mine, c, digits) for c, digits in columns))
        rows.append(cells)
    return table(header, rows)


SPEEDUPS = (("paper_speedup", 1), ("speedup", 1))
EXPERIMENTS = (
    ("scenarios", "Number of scenarios (Figure 10)", "scenarios"),
    ("paper depth", "All scenarios at the paper's depth", "depth"),
    ("depth", "Distribution depth (Figure 11)", "depth"),
    ("q", "Buffer size q (Figure 12)", "q"),
    ("cores", "Cluster size (Figure 13, Table 4)", "weighted cores"),
)


def paper_sections(runs):
    parts = ["## The paper's experiments\n",
             "Each cell: speed-up as the paper defines it (weighted serial time, bound 29.3) / against "
             "one fast core (bound 25.0). Means over the seeds ± half of their range. Below each "
             "table of speed-ups the relative transfer: bytes from the master by those of both "
             "bodies.\n"]
    for experiment, title, name in EXPERIMENTS:
        parts.append(f"### {title}\n")
        for scene in SCENES:
            for setting in SETTINGS:
                series = Series(runs, setting, scene, experiment)
                if series.rows:
                    depth = "" if experiment in ("depth", "paper depth") else \
                        f", depth {series.rows[0]['depth']}"
                    parts.append(f"{scene}, {setting}{depth}:\n")
                    parts.append(series_table(series, name, SPEEDUPS))
                    parts.append(series_table(series, name, (("transfer", 1),)))
    return "\n".join(parts)


def statement_rows(runs, setting):
    """What the paper states, and what came out: value and verdict of each statement."""
    heavy, cars = (Series(runs, setting, scene, "scenarios") for scene in SCENES)
    depth = {scene: Series(runs, setting, scene, "depth") for scene in SCENES}
    q = {scene: Series(runs, setting, scene, "q") for scene in SCENES}
    cores = {scene: Series(runs, setting, scene, "cores") for scene in SCENES}
    if not heavy.rows:
        return None
    best, load, low = (heavy.last(s, "paper_speedup") for s in (BEST, LOAD, LOWEST))
    rows = [
        (fixed(best), abs(best - 20) <= 1.5),
        (fixed(low), abs(low - 12) <= 1.5),
        (fixed(heavy.last(LOWEST, "seconds") - heavy.last(BEST, "seconds"), 0) + " s",
         heavy.last(LOWEST, "seconds") - heavy.last(BEST, "seconds") >= 52),
        (f"{load / best:.2f}x", load / best <= 1.05),
    ]
    gains = [heavy.mean(x, BEST, "speedup") / heavy.mean(x, LOWEST, "speedup") for x in heavy.xs]
    rows.append((" ".join(f"{gain:.2f}" for gain in gains), gains[-1] > gains[0]))
    transfers = {s: heavy.last(s, "transfer") for s in (BEST, RANDOM, LOWEST)}
    rows.append((" ".join(fixed(value) for value in transfers.values()),
                 transfers[BEST] < min(transfers[RANDOM], transfers[LOWEST])))
    gain = {scene: one.last(BEST, "speedup") / one.last(LOWEST, "speedup")
            for scene, one in zip(SCENES, (heavy, cars))}
    rows.append((f"{gain['heavy']:.2f}x, {gain['cars']:.2f}x", gain["heavy"] > gain["cars"]))
    found = {scene: depth[scene].best(BEST) for scene in SCENES}
    inner = all(depth[s].xs[0] < found[s] < depth[s].xs[-1] for s in SCENES)
    rows.append((", ".join(show(found[s]) for s in SCENES), inner))
    found = {scene: q[scene].best(BEST) for scene in SCENES}
    rows.append((", ".join(show(found[s]) for s in SCENES),
                 all(10 <= found[s] <= 40 for s in SCENES)))

    def spread(series, x):
        speeds = [series.mean(x, s, "speedup") for s in (BEST, LOAD, RANDOM, LOWEST)]
        return max(speeds) / min(speeds)

    small = [spread(cores[s], x) for s in SCENES for x in cores[s].xs if x <= 16]
    rows.append((" ".join(f"{one:.2f}x" for one in small), max(small) <= 1.1))
    large = [cores["heavy"].mean(x, LOWEST, "speedup") for x in cores["heavy"].xs[-2:]]
    rows.append((f"{large[0]:.1f} to {large[-1]:.1f}", large[-1] <= 1.05 * large[0]))
    memory = {strategy: [mean(at(depth["heavy"].rows, x, strategy), "memory_sum_mb")
                         for x in depth["heavy"].xs] for strategy in (BEST, LOWEST)}
    rows.append((", ".join(f"{name} {show(each[0])} to {show(each[-1])} MB"
                           for name, each in memory.items()),
                 memory[BEST][0] <= 0.9 * memory[LOWEST][0]))
    return rows


STATEMENTS = (
    ("best-match reaches about 20 with all scenarios of the heavy case (7.2)", "20"),
    ("lowest reaches about 12", "12"),
    ("so lowest takes longer by", "104 s"),
    ("best-match-load gains nothing of note over best-match", "about 1"),
    ("the more scenarios, the larger the gain: best-match by lowest at each fifth", "growing"),
    ("best-match transfers least: best-match, random, lowest", "least"),
    ("the larger the geometry, the larger the gain: heavy, cars (7.3)", "heavy > cars"),
    ("there is an optimal depth: heavy, cars", "12, 10"),
    ("q = 20 is best or near it: heavy, cars (7.4)", "20, 20"),
    ("up to 16 weighted cores all are equal (7.5): largest by smallest at 12 and 16, heavy, cars",
     "1"),
    ("more than 20 weighted cores do not help lowest: 19.8 to 25", "flat"),
    ("at small depths the sending machine (2 or 3 GB) runs out of memory under lowest and random, "
     "not under best-match: all workers' memory, smallest to largest depth",
     "best-match less"),
)


def statements_section(runs):
    found = {setting: statement_rows(runs, setting) for setting in SETTINGS}
    rows = []
    for i, (what, paper) in enumerate(STATEMENTS):
        row = [what, paper]
        for setting in SETTINGS:
            if found[setting]:
                value, holds = found[setting][i]
                row += [value, "yes" if holds else "**no**"]
            else:
                row += ["", ""]
        rows.append(row)
    note = ("Speed-ups as the paper defines them, at the depth that is best here (its own is in the "
            "tables below). *Holds*: within 1.5 of a speed-up, half of the 104 s, 5 % for "
            "\"nothing\" and \"flat\", 10 % for \"equal\", q within a factor of two, an optimum "
            "inside the range, a tenth less memory at the smallest depth.")
    return f"## What the paper states\n\n{note}\n\n" + table(
        ["the paper", "its figure", "unfitted", "holds", "fitted", "holds"], rows)


def ours_section(runs):
    rows = []
    for scene in SCENES:
        series = Series(runs, "unfitted", scene, "scenarios")
        for strategy in series.strategies():
            mine = at(series.rows, series.xs[-1], strategy)
            rows.append([scene, strategy, with_range(mine, "speedup", 2),
                         "yes" if mean(mine, "speedup") >= 24 else "no",
                         *(fixed(mean(mine, c), 3) for c in (
                             "start_share", "between_share", "tail_share", "master_share")),
                         fixed(mean(mine, "transfer"), 1), fixed(mean(mine, "peer_mb"), 0)])
    return ("## Ours, in the unfitted setting\n\nAll scenarios, against one fast core (bound 25.0). "
            "`+peers`: workers give each other blocks, as in the product; the paper has that as future "
            "work. Shares of what all cores could have worked in which they did no scenario: before "
            "their first, between two, after their last. Then the share of the time in which the "
            "master's thread is busy, bytes from the master by those of both bodies, MB from workers "
            "to workers.\n\n" + table(
                ["scene", "strategy", "speed-up", "24 of 25", "start", "between", "tail", "master",
                 "transfer", "from peers"], rows))


def additions_section(folder):
    if not os.path.exists(os.path.join(folder, "additions.csv")):
        return ""
    rows = read(folder, "additions")
    keys = ("setting", "slow_ratio", "bits_per_second", "peers", "hints", "helps")
    lines = []
    for case in dict.fromkeys(tuple(row[key] for key in keys) for row in rows):
        found = select(rows, **dict(zip(keys, case)))
        setting, slow_ratio, rate, peers, hints, helps = case
        lines.append([setting, fixed(1 / float(slow_ratio), 2), fixed(float(rate) / 1e9, 1), peers, hints, helps,
                      with_range(found, "speedup", 2), fixed(number(found[0], "bound"), 1),
                      fixed(mean(found, "tail_share"), 4), fixed(mean(found, "recalled"), 0),
                      fixed(mean(found, "copies"), 0)])
    return (f"## What earliest-finish adds\n\nThe heavy case, depth {rows[0]['depth']}: hints of what buffers will "
            "need, and at the end recalls and copies; by the speed of the slow cores, the rate of links, and "
            "with geometry from workers or from the master alone.\n\n" + table(
                ["setting", "slow cores", "Gb/s", "peers", "hints", "recalls, copies", "speed-up", "bound", "tail",
                 "recalled", "copies"], lines))


def memory_section(runs):
    parts = ["## Memory\n",
             "MB at the worker that holds most / at all workers together, at the end, which is the "
             "peak: nothing leaves.\n"]
    for setting in ("unfitted", "measured"):
        for scene in SCENES:
            series = Series(runs, setting, scene, "depth")
            if series.rows:
                parts.append(f"{scene}, {setting}:\n")
                parts.append(series_table(series, "depth",
                                          (("memory_max_mb", 0), ("memory_sum_mb", 0))))
    return "\n".join(parts)


def measured_section(runs):
    parts = ["## The same cluster with the costs of today\n",
             "Speed-up against one core in one process (bound 25.0) / relative transfer / MB that came "
             "to the master (its link takes 125 a second) / share of the time in which its thread "
             "decides. Where the number of scenarios does not "
             "vary, it is ten times the paper's.\n"]
    columns = (("speedup", 2), ("transfer", 1), ("received_mb", 0), ("master_share", 3))
    for experiment, title, name in EXPERIMENTS:
        for scene in SCENES:
            series = Series(runs, "measured", scene, experiment)
            if series.rows:
                depth = "" if experiment == "depth" else f", depth {series.rows[0]['depth']}"
                parts.append(f"{title}; {scene}{depth}:\n")
                parts.append(series_table(series, name, columns))
    return "\n".join(parts)


def beyond_section(rows):
    if not rows:
        return ""
    parts = ["## Beyond the paper's cluster\n",
             "Hosts of one core, every second one with a tenth of the speed; a fleet of 100 million "
             "triangles (copies of the heavy vehicle) against the car, in groups of 1,000 neighbouring "
             "scenarios, counted and not listed; 2 GB of cache at each host. README.md says how it is "
             "scaled. The last three ways are counted and not simulated, each in its own favour; *fits*: "
             "no host needs more than its cache; *master*: processor time of the dispatcher and the director.\n"]
    for hosts, gigabits in sorted({(number(r, "hosts"), number(r, "gigabits")) for r in rows}):
        mine = [r for r in rows if (number(r, "hosts"), number(r, "gigabits")) == (hosts, gigabits)]
        first = mine[0]
        parts.append(f"{show(hosts)} hosts, {show(gigabits)} Gb/s; {show(number(first, 'scenarios'))} "
                     f"scenarios, geometry {show(number(first, 'geometry_mb'))} MB, bound "
                     f"{show(number(first, 'bound'))}:\n")
        parts.append(table(
            ["way", "seconds", "speed-up", "sent MB", "by geometry", "between workers MB",
             "to the master MB", "evicted blocks", "start", "between", "tail",
             "master us / scenario", "fits"],
            [[r["way"], *(show(number(r, c)) for c in ("seconds", "speedup", "sent_mb",
                                                       "sent_by_geometry")),
              *(("" if number(r, "dispatcher_us") == 0 else show(number(r, c))) for c in (
                  "peer_mb", "received_mb", "evictions", "start_share", "between_share",
                  "tail_share", "dispatcher_us")), r["fits"]] for r in mine]))
    return "\n".join(parts)


def related_section(folder):
    rows = [row for scene in SCENES
            if os.path.exists(os.path.join(folder, f"related_{scene}.csv"))
            for row in read(folder, f"related_{scene}")]
    if not rows:
        return ""
    return ("## Box and triangle tests of other ways\n\nOf one scenario, means; counted for the same "
            "poses by `related_counts`, which says what each way is taken to be. Building, and placing "
            "boxes anew for a pose, is not counted.\n\n" + table(
                ["scene", "scenarios", "way", "box tests", "triangle tests"],
                [[r["scene"], r["scenarios"], r["way"], show(number(r, "box_tests")),
                  show(number(r, "triangle_tests"))] for r in rows]))


def costs_section(data):
    whole = [[row["scene"], show(number(row, "scenarios")), *(show(number(row, c)) for c in (
        "us", "binary_us", "box_tests", "triangle_tests", "wide_box_tests", "wide_triangle_tests",
        "box_test_ns", "triangle_test_ns"))] for row in data["whole"]]
    costs = [[row["scene"], *(show(number(row, c)) for c in (
        "depth", "roots", "analysis_us", "analysis_tests", "work_us", "binary_us", "roots_a",
        "roots_b", "batch_bytes", "result_bytes", "bytes_triangle", "wire_bytes_triangle",
        "open_ms", "top_kb"))] for row in data["costs"]]
    return "\n".join([
        "## What was measured\n",
        "Means over the scenarios. In one process, in wide trees (as jobs run) and in binary ones "
        "(the paper's form), with the paper's N_b and N_p of both, and C_b and C_p of the wide "
        "ones:\n",
        table(["scene", "scenarios", "us", "binary us", "N_b", "N_p", "wide N_b", "wide N_p",
               "C_b ns", "C_p ns"], whole),
        "By depth of the fixed body's cut (the other's is 6): the master's analysis, the worker's "
        "step in wide and in binary trees, roots touched, bytes of a scenario in a batch and of its "
        "result, bytes of a triangle encoded and on the wire, opening all blocks, the top:\n",
        table(["scene", "depth", "roots", "analysis us", "box tests", "work us", "binary us",
               "roots of A", "of B", "batch bytes", "result bytes", "bytes a triangle", "on the wire",
               "open ms", "top kB"], costs)])


def prediction_section(folder):
    if not os.path.exists(os.path.join(folder, "prediction.csv")):
        return ""
    return ("## The simulation against real clusters\n\nThe same job in both, analysed by the master, on one "
            "computer whose cores a master and workers of one thread share (`bench/cluster/prediction`); "
            "real: the median of five.\n\n" + table(
                ["job", "strategy", "cores", "workers", "scenarios", "real, s", "predicted, s", "error"],
                [[r["scene"], r["strategy"], r["cores"], r["workers"], show(number(r, "scenarios")),
                  fixed(number(r, "real"), 3), fixed(number(r, "predicted"), 3),
                  f"{100 * number(r, 'error'):+.0f} %"] for r in read(folder, "prediction")]))


def dispatcher_section(runs):
    rows = []
    for scene in SCENES:
        series = Series(runs, "measured", scene, "depth")
        for x in series.xs:
            rows.append([scene, show(x)] + [
                fixed(series.mean(x, s, "dispatcher_us"), 2) for s in series.strategies()])
    names = in_order(select(runs, setting="measured", experiment="depth"), "strategy")
    return ("## The dispatcher's own time\n\nMicroseconds of processor time for each scenario, "
            "really spent in the dispatcher while it was simulated, by depth; charged to the "
            "master's thread in the setting above.\n\n" + table(["scene", "depth"] + names, rows))


def main():
    folder = sys.argv[1]
    data = {name: read(folder, name) for name in ("machine", "whole", "costs", "fit", "runs")}
    has_beyond = os.path.exists(os.path.join(folder, "beyond.csv"))
    data["beyond"] = read(folder, "beyond") if has_beyond else []
    runs = data["runs"]
    print("# The paper's experiments, simulated\n")
    print("Made by `bench/cluster/run`; README.md beside it says how, and what the settings are.\n")
    print(table(["machine", ""], [[row["what"], row["value"]] for row in data["machine"]]))
    for row in data["fit"]:
        print(f"The one fitted constant: {row['what']}: {show(float(row['value']))}, so that lowest "
              "takes 261 s (a speed-up of 12) for all scenarios of the heavy case.\n")
    print(statements_section(runs))
    print(ours_section(runs))
    print(additions_section(folder))
    print(paper_sections(runs))
    print(memory_section(runs))
    print(measured_section(runs))
    print(dispatcher_section(runs))
    print(prediction_section(folder))
    print(beyond_section(data["beyond"]))
    print(related_section(folder))
    print(costs_section(data))
    fitted = os.path.join(folder, "fit_costs.txt")
    if os.path.exists(fitted):
        print("The master's model of costs (`master/cost_model.cpp`) against these traces: by depth, the "
              "sum predicted by the sum measured, and the standard deviation of the logarithm of a "
              "scenario's ratio:\n")
        with open(fitted, encoding="utf-8") as lines:
            print("```\n" + lines.read() + "```")


if __name__ == "__main__":
    main()
