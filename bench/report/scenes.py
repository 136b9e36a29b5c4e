"""The broad phase of scenes, ours and the peers: what scenes_report measured, as a page."""
from tables import figure, figures_table, in_order, known, number, select, show, table, total

TITLE = "Scenes: the broad phase of ours and the peers"
FILES = ("scenes",)
PAGE = "RESULTS.md"
OURS = "cdcluster"
GOALS_MS = {"1000": 0.1, "10000": 3}


def figures_section(data):
    rows = []
    for row in select(data["scenes"], engine=OURS):
        goal = GOALS_MS.get(row["bodies"])
        if goal:
            rows.append(figure(f"{row['scene']} of {show(number(row, 'bodies'))} bodies, median of a step",
                               f"<= {goal} ms", known(row, "median_ms"), "ms", lambda v, goal=goal: v <= goal))
    rows.append(figure("pairs that ours lacks", "0", missing_of_ours(data), "", lambda v: v == 0))
    return "## Figures\n" + figures_table(rows)


def missing_of_ours(data):
    return total(select(data["scenes"], engine=OURS), "missing")


def times(row):
    """The times of an engine's steps, its ratio to ours, and its pairs."""
    if not row:
        return "-"
    if row["ending"] != "done":
        return row["ending"]
    ratio = "" if row["engine"] == OURS else f"; {show(known(row, 'ratio'))} x"
    return (f"{show(known(row, 'mean_ms'))} / {show(known(row, 'median_ms'))}{ratio}; "
            f"{show(round(number(row, 'pairs')))} ({show(number(row, 'missing'))})")


def scenes_section(data):
    """A row a scene and number of bodies, a column an engine."""
    engines = in_order(data["scenes"], "engine")
    rows = []
    for ours in select(data["scenes"], engine=OURS):
        where = {"scene": ours["scene"], "bodies": ours["bodies"]}
        rows.append([ours["scene"], show(number(ours, "bodies")),
                     *(times(next(iter(select(data["scenes"], engine=engine, **where)), None))
                       for engine in engines), "not measured here", "not measured here"])
    note = ("Mean and median of a step in ms, in which all bodies move; of others, the median by ours; pairs "
            "left, mean of a step; in brackets, pairs of overlapping boxes that are missing at the first "
            "and the last step. Coal and Jolt have no Debian package.")
    return f"## Steps\n{note}\n\n" + table(["scene", "bodies", *engines, "Coal", "Jolt"], rows)


def faults(data):
    """What of ours is wrong, in words."""
    found = []
    if missing_of_ours(data):
        found.append(f"ours lacks {show(missing_of_ours(data))} pairs")
    if not select(data["scenes"], engine=OURS):
        found.append("ours has no scene")
    return found


def summary(data):
    return [figures_section(data), scenes_section(data)]
