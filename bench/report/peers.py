"""Ours and the peers: what peers_report measured, as a page."""
import statistics

from tables import (figure, figures_table, in_order, known, number, select, show, table, total,
                    weighted)

TITLE = "Ours and the peers"
FILES = ("floor", "scenes", "engines", "threads", "builds")
PAGE = "RESULTS.md"
OURS = "cdcluster"
FCL_FLOAT = "FCL OBB float"
FCL_DOUBLE = "FCL OBB double"


def cell(row, column):
    return show(known(row, column))


def find(rows, scene, engine):
    """The row of an engine on a scene, if it took part."""
    return next(iter(select(rows, scene=scene, engine=engine)), None)


# The floor of a query of drivaer x sedan, as estimated on another machine: which kernel, so many
# times, so many nanoseconds each.
FLOOR = (("boxes", 68902, 0.24), ("sides", 4569, 3.9), ("decision", 1500, 5.9))
FLOOR_TARGET = 72 / 43


def floors(data):
    """Microseconds there and here."""
    here = {row["kernel"]: number(row, "ns") for row in data["floor"]}
    return (sum(count * ns for _, count, ns in FLOOR) / 1e3,
            sum(count * here[kernel] for kernel, count, _ in FLOOR) / 1e3)


def figures_section(data):
    engines = select(data["engines"], suite="scenes")
    rows = []

    def ratio(what, scene, peer, column, least):
        value = known(find(engines, scene, peer), column)
        rows.append(figure(f"{what}, {scene}, against {peer}", f">= {least}x", value, "x",
                           lambda v: v >= least))

    for scene, double, single in (("drivaer x sedan", 23, 14), ("sedan x sedan", 25, 15),
                                  ("truck x car", 30, 18)):
        ratio("all pairs", scene, FCL_DOUBLE, "ratio", double)
        ratio("all pairs", scene, FCL_FLOAT, "ratio", single)
    for scene in ("drivaer x sedan", "sedan x sedan", "truck x car"):
        ratio("any contact", scene, FCL_DOUBLE, "any_best_ratio", 20)
    ratio("all pairs, near miss", "drivaer near sedan", FCL_FLOAT, "ratio", 10)
    ours = find(engines, "drivaer x sedan", OURS)
    rows.append(figure("all pairs, drivaer x sedan, mean", "<= 72 us", known(ours, "mean_us"),
                       "us", lambda v: v <= 72))
    mean = known(ours, "mean_us")
    rows.append(figure("the same, times the floor of this machine", f"<= {show(FLOOR_TARGET)}x",
                       mean / floors(data)[1] if mean else None, "x",
                       lambda v: v <= FLOOR_TARGET))
    rows.append(figure("drivaer x sedan, resident bytes a triangle", "<= 64",
                       known(ours, "resident_bytes_triangle"), "", lambda v: v <= 64))
    builds = [float(row["seconds_2"]) for row in data["builds"]]
    rows.append(figure("build of the motorbike, 2 threads, median", "<= 0.25 s",
                       statistics.median(builds) if builds else None, "s", lambda v: v <= 0.25))
    rows.append(figure("AVX2 against the widest, drivaer x sedan", "<= 1.8x",
                       known(find(engines, "drivaer x sedan", "cdcluster (avx2)"), "ratio"),
                       "x", lambda v: v <= 1.8))
    threads = select(data["threads"], suite="scenes")
    for scene in ("drivaer x sedan", "truck x car"):
        ratio = thread_ratio(select(threads, scene=scene))
        rows.append(figure(f"2 threads against 1, {scene}, median of the pairs", ">= 1.9x", ratio,
                           "x", lambda v: v >= 1.9))
    rows.append(figure("disagreements in which ours is wrong", "0",
                       total(data["engines"], "ours_wrong"), "", lambda v: v == 0))
    return "## Figures\n" + figures_table(rows)


def thread_ratio(rows):
    """The median speed-up of two threads; None where it is above 2, which two threads cannot reach:
    something else slowed the runs on one thread, so that the measurement is void."""
    if not rows:
        return None
    ratio = statistics.median(float(row["ratio"]) for row in rows)
    return ratio if ratio <= 2 else None


def faults(data):
    """What of ours is wrong, in words."""
    ours = [row for row in data["engines"] if row["engine"].startswith(OURS)]
    found = {"disagreements in which ours is wrong": total(data["engines"], "ours_wrong"),
             "pairs that our SIMD targets disagree on": total(ours, "missing", "extra"),
             "poses with a wrong answer of ours to any contact": total(ours, "any_wrong"),
             "scenes that ours did not come through": sum(
                 row[c] not in ("", "done") for row in ours for c in ("ending", "any_ending"))}
    if not ours:
        found["suites without a scene"] = 1
    return [f"{show(count)} {what}" for what, count in found.items() if count]


def times_ours(row, ours, column):
    value, base = known(row, column), known(ours, column)
    return "-" if value is None or not base else show(value / base)


def scenes_summary(data):
    """A row a scene, a column an engine: means of all pairs and of any contact."""
    engines = select(data["engines"], suite="scenes")
    names = [name for name in in_order(engines, "engine") if name != OURS]
    rows = []
    for scene in in_order(engines, "scene"):
        ours = find(engines, scene, OURS)
        rows.append([scene, f"{cell(ours, 'mean_us')} / {cell(ours, 'any_best_us')}"] + [
            " / ".join(times_ours(find(engines, scene, name), ours, c)
                       for c in ("mean_us", "any_best_us"))
            for name in names])
    note = ("All pairs / any contact: means over the poses, of ours in us, of the others as multiples "
            "of ours; any contact by the best pass of each pose.")
    return f"## Scenes\n{note}\n\n" + table(["scene", f"{OURS}, us", *names], rows)


def engines_summary(data):
    """A row an engine, over all scenes in which it took part: answers, build, memory."""
    triangles = {(row["suite"], row["scene"]): total([row], "triangles_a", "triangles_b")
                 for row in data["scenes"]}
    rows = []
    for engine in in_order(data["engines"], "engine"):
        mine = select(data["engines"], engine=engine)
        answered = [row for row in mine if row["pairs_found"]]
        measured = [{**row, "triangles": triangles[row["suite"], row["scene"]]}
                    for row in mine if row["build_ms"] and row["bytes_triangle"]]
        count = total(measured, "triangles")
        rows.append([engine, *(show(total(answered, c)) if answered else "" for c in (
            "pairs_found", "missing", "extra", "judged", "ours_wrong")),
            show(1e3 * total(measured, "build_ms") / count if count else None),
            show(weighted(measured, "bytes_triangle", "triangles"))])
    note = ("Over all scenes in which the engine took part: pairs found, pairs that only ours has, pairs "
            "that only it has, how many of both the exact oracle looked at, and in how many ours is wrong.")
    return f"## Who is wrong, build and memory\n{note}\n\n" + table(
        ["engine", "pairs", "missing", "extra", "judged", "ours wrong", "build, us a triangle",
         "memory, bytes a triangle"], rows)


def threads_summary(data):
    found = []
    for rows, column in ((select(data["threads"], suite="scenes"), "scene"), (data["builds"], "mesh")):
        for what in in_order(rows, column):
            ratio = thread_ratio(select(rows, **{column: what}))
            found.append(f"{what}{'' if column == 'scene' else ', build'}: {show(ratio) or 'void'}")
    return ("Two threads against one, medians; above 2 is void, since the runs on one thread were "
            "disturbed. " + "; ".join(found) + ".\n")


def summary(data):
    return [figures_section(data), scenes_summary(data), engines_summary(data), threads_summary(data)]
