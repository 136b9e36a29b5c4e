"""Motions of ours and the peers: what motions_report measured, as a page."""
from tables import (figure, figures_table, in_order, known, number, select, show, table, total,
                    unpackaged)

TITLE = "Motions: ours and the peers"
FILES = ("motions",)
PAGE = "RESULTS.md"
OURS = "cdcluster"
TURNING = "onto, turning"


def figures_section(data):
    ours = next(iter(select(data["motions"], scene="drivaer x sedan", kind=TURNING, engine=OURS)), None)
    rows = [figure("first contact, sedan onto drivaer, turning, mean of a path", "<= 1.5 ms",
                   known(ours, "mean_ms"), "ms", lambda v: v <= 1.5),
            figure("paths that ours leaves undecided", "0",
                   total(select(data["motions"], engine=OURS), "undecided"), "", lambda v: v == 0)]
    rows.append(unpackaged("Coal"))
    return "## Figures\n" + figures_table(rows)


def times(row):
    return f"{show(known(row, 'mean_ms'))} / {show(known(row, 'median_ms'))}"


def theirs(row):
    """The times of a peer, what of its answers is wrong, and the error of its times."""
    if not row or not number(row, "paths"):
        return "-"
    wrong = " / ".join(show(number(row, column)) for column in ("missed", "invented", "unanswered"))
    found = [times(row), f"{wrong} of {show(number(row, 'paths'))}"]
    if row["off_median"]:
        found.append(" / ".join(show(1e3 * number(row, column))
                                for column in ("off_median", "off_early", "off_late")))
    return "; ".join(found)


def scenes_section(data):
    """A row a scene and kind of path, a column an engine."""
    peers = [name for name in in_order(data["motions"], "engine") if name != OURS]
    rows = []
    for ours in select(data["motions"], engine=OURS):
        where = {"scene": ours["scene"], "kind": ours["kind"]}
        rows.append([ours["scene"], ours["kind"],
                     f"{show(number(ours, 'paths'))} / {show(number(ours, 'impacts'))}", times(ours),
                     *(theirs(next(iter(select(data["motions"], engine=peer, **where)), None))
                       for peer in peers)])
    note = ("Ours: mean and median of a path in ms. Others: these; impacts missed (ours has proven contact), "
            "invented (ours has proven the path free), and crashes or times beyond the "
            "limit (by the clock, with the building of trees: a busy machine has more), of the paths tried; how far "
            "outside of the proven bracket of ours their times are, times the path's length: median, most "
            "early (below 0), most late, in thousandths of the unit (mm of vehicles).")
    return f"## Paths\n{note}\n\n" + table(
        ["scene", "path", "paths / impacts", f"{OURS}, ms", *peers], rows)


def engines_section(_):
    return ("FCL's conservative advancement takes no error and no number of iterations for meshes; naive is "
            "its default, which tests samples of the path. The body that moves is FCL's first: of two boxes "
            "of which the second moves, conservative advancement misses the impact. Bullet sweeps "
            "convex hulls, so its impacts of vehicles are those of other bodies. "
            "With a turn, the peers' paths differ from ours by 0.6 mrad.\n")


def faults(data):
    """What of ours is wrong, in words."""
    found = []
    if not select(data["motions"], engine=OURS):
        found.append("ours has no motion")
    for row in select(data["motions"], engine=OURS):
        if total([row], "missed", "invented", "unanswered"):
            found.append(f"ours contradicts itself in {row['scene']}")
    for row in data["motions"]:
        if row["scene"] in ("two boxes", "thin wall") and row["engine"] == OURS \
                and row["impacts"] != row["paths"]:
            found.append(f"ours misses impacts of {row['scene']}")
    return found


def summary(data):
    return [figures_section(data), scenes_section(data), engines_section(data)]
