"""Shot lines of ours and Embree: what shots_report measured, as a page."""
from tables import (figure, figures_table, in_order, known, number, select, show, table, total,
                    unpackaged)

TITLE = "Shot lines: ours and Embree"
FILES = ("shots",)
PAGE = "RESULTS.md"
OURS = "cdcluster"
ROBUST = "Embree robust"


def least_ratio(data, engine, kind):
    ratios = [known(row, "ratio") for row in select(data["shots"], engine=engine, kind=kind)]
    return min((ratio for ratio in ratios if ratio is not None), default=None)


def odd_of_ours(data):
    return total(select(data["shots"], engine=OURS, closed="yes"), "odd_lines")


def figures_section(data):
    rows = [figure(f"all hits of grids, {engine}: the least ratio of a body", ">= 2x",
                   least_ratio(data, engine, "grid"), "x", lambda v: v >= 2)
            for engine in in_order(data["shots"], "engine") if engine.startswith(ROBUST)]
    rows.append(figure("lines in which ours is wrong, of those that the oracle judged", "0",
                       total(data["shots"], "ours_wrong"), "", lambda v: v == 0))
    rows.append(figure("lines of ours with an odd number of hits, closed bodies", "0",
                       odd_of_ours(data), "", lambda v: v == 0))
    rows.append(unpackaged("BRL-CAD rtshot"))
    return "## Figures\n" + figures_table(rows)


def odd_lines(row):
    return show(number(row, "odd_lines")) if row["closed"] == "yes" else "-"


def theirs(row):
    """The ratio of a peer's time to ours, and what of its hits is wrong."""
    if not row:
        return "-"
    if row["ending"] != "done":
        return row["ending"]
    wrong = " / ".join([*(show(number(row, c)) for c in ("missing", "doubled")), odd_lines(row)])
    return f"{show(known(row, 'ratio'))} ({wrong})"


def scenes_section(data):
    """A row a body and kind of lines, a column an engine."""
    peers = [name for name in in_order(data["shots"], "engine") if name != OURS]
    rows = []
    for ours in select(data["shots"], engine=OURS):
        where = {"body": ours["body"], "kind": ours["kind"]}
        rows.append([ours["body"], ours["closed"], ours["kind"], show(number(ours, "lines")),
                     show(number(ours, "hits")),
                     f"{show(number(ours, 'lines_per_s') / 1e6)} ({odd_lines(ours)})",
                     *(theirs(next(iter(select(data["shots"], engine=peer, **where)), None))
                       for peer in peers)])
    note = ("Ours: million lines a second with all hits, their flags and depths; in brackets, odd lines: "
            "those with an odd number of hits, on closed bodies. Others: the ratio of their time to "
            "ours; in brackets, hits missing, hits too many, odd lines.")
    return f"## Bodies\n{note}\n\n" + table(
        ["body", "closed", "lines", "count", "hits", f"{OURS}, M lines/s", *peers], rows)


def judged_section(data):
    return (f"The oracle judged {show(total(data['shots'], 'judged'))} of the "
            f"{show(total(data['shots'], 'wrong_lines'))} answers, a line each, that differ from ours.\n")


def faults(data):
    """What of ours is wrong, in words."""
    found = []
    if total(data["shots"], "ours_wrong"):
        found.append(f"{show(total(data['shots'], 'ours_wrong'))} lines of ours are wrong")
    if odd_of_ours(data):
        found.append(f"{show(odd_of_ours(data))} lines of ours have an odd number of hits")
    if not select(data["shots"], engine=OURS):
        found.append("ours has no lines")
    return found


def summary(data):
    return [figures_section(data), scenes_section(data), judged_section(data)]
