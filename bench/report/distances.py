"""Distances of ours and the peers: what distances_report measured, as a page."""
from tables import (figure, figures_table, in_order, known, number, select, show, table, total,
                    unpackaged)

TITLE = "Distances: ours and the peers"
FILES = ("distances", "pairs", "near_queries", "near_floats")
PAGE = "RESULTS.md"
OURS = "cdcluster"
# Of SCENES 1.4: microseconds of a query, nanoseconds of a candidate in floats.
QUERY_LIMITS = {"drivaer near sedan": 15, "drivaer x sedan": 8}
FLOAT_LIMITS = {"avx512": 40, "avx2": 80}


def ours_in(data, scene, poses_are):
    return next(iter(select(data["distances"], scene=scene, poses_are=poses_are, engine=OURS)), None)


def figures_section(data):
    rows = []
    near = ours_in(data, "drivaer near sedan", "apart")
    rows.append(figure("distance, drivaer near sedan, median", "<= 150 us", known(near, "median_us"),
                       "us", lambda v: v <= 150))
    for engine in in_order(data["distances"], "engine"):
        row = next(iter(select(data["distances"], scene="drivaer near sedan", poses_are="apart",
                               engine=engine)), None)
        if engine != OURS:
            rows.append(figure(f"the same, {engine}, median of the ratios", ">= 10x",
                               known(row, "ratio"), "x", lambda v: v >= 10))
    rows += near_figures(data)
    rows.append(figure("distances of ours that are wrong", "0", wrong_of_ours(data), "",
                       lambda v: v == 0))
    rows.append(unpackaged("PQP 1.3, Coal"))
    return "## Figures\n" + figures_table(rows)


def near_figures(data):
    """Times of queries with a clearance of 1 cm, and of a candidate on each SIMD target with a goal."""
    rows = []
    for scene, limit in QUERY_LIMITS.items():
        row = next(iter(select(data["near_queries"], scene=scene)), None)
        what = f"nearer than 1 cm?, {scene}, mean of a pose"
        rows.append(figure(f"{what}, median round", f"<= {limit} us",
                           known(row, "median_round_us"), "us", lambda v, most=limit: v <= most))
        rows.append([f"{what}, quickest round", "", f"{show(known(row, 'quickest_round_us'))} us", ""])
    for target, limit in FLOAT_LIMITS.items():
        for scene in QUERY_LIMITS:
            row = next(iter(select(data["near_floats"], scene=scene, target=target)), None)
            what = f"a candidate in floats at 1 cm, {scene}, {target}"
            if data["near_floats"] and not row:
                rows.append([what, f"<= {limit} ns", "none on this machine", ""])
                continue
            rows.append(figure(what, f"<= {limit} ns", known(row, "candidate_ns"), "ns",
                               lambda v, most=limit: v <= most))
    return rows


def wrong_of_ours(data):
    return total(data["distances"], "ours_wrong") + total(select(data["pairs"], engine=OURS), "unequal")


def theirs(row):
    """The ratio of a peer's times to ours, and how many of its answers are not ours."""
    if not row:
        return "-"
    if row["ending"] != "done":
        return row["ending"]
    wrong = " / ".join(show(number(row, c)) for c in ("unequal", "off", "wrong"))
    return f"{show(known(row, 'ratio'))} ({wrong})"


def scenes_section(data):
    """A row a scene and kind of poses, a column an engine."""
    peers = [name for name in in_order(data["distances"], "engine") if name != OURS]
    rows = []
    for ours in select(data["distances"], engine=OURS):
        where = {"scene": ours["scene"], "poses_are": ours["poses_are"]}
        rows.append([ours["scene"], ours["poses_are"], show(number(ours, "poses")),
                     f"{show(known(ours, 'mean_us'))} / {show(known(ours, 'median_us'))}",
                     *(theirs(next(iter(select(data["distances"], engine=peer, **where)), None))
                       for peer in peers)])
    note = ("Ours: mean and median of a pose. Others: median over the poses of the ratio to ours; in "
            "brackets, the poses whose answer is unequal to ours by a bit; off by more than 1e-12 of the "
            "largest coordinate; wrong by more than 1 % of the distance, or about contact.")
    return f"## Scenes\n{note}\n\n" + table(["scene", "poses", "count", f"{OURS}, us", *peers], rows)


def pairs_section(data):
    rows = []
    for engine in in_order(data["pairs"], "engine"):
        mine = select(data["pairs"], engine=engine)
        count = total(mine, "pairs")
        worst = max(mine, key=lambda row: number(row, "wrong") / number(row, "pairs"))
        rows.append([engine, show(count),
                     *(show(round(1e6 * total(mine, c) / count)) for c in ("unequal", "off", "wrong")),
                     f"{worst['kind']}: {show(round(100 * number(worst, 'wrong') / number(worst, 'pairs')))} %"
                     if total(mine, "wrong") else ""])
    kinds = len(in_order(data["pairs"], "kind"))
    note = (f"Single pairs of triangles that share no point, {kinds} kinds, against the exact oracle; "
            "answers of a million that are unequal, off or wrong, as above.")
    return f"## Hard pairs\n{note}\n\n" + table(
        ["engine", "pairs", "unequal", "off", "wrong", "wrong most often"], rows)


def faults(data):
    """What of ours is wrong, in words."""
    found = []
    if wrong_of_ours(data):
        found.append(f"{show(wrong_of_ours(data))} distances of ours are wrong")
    if not select(data["distances"], engine=OURS):
        found.append("ours has no distance of a scene")
    if not select(data["pairs"], engine=OURS):
        found.append("ours has no distance of a pair")
    return found


def summary(data):
    return [figures_section(data), scenes_section(data), pairs_section(data)]
