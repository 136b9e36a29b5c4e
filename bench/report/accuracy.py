"""Speed against error: what accuracy_report measured, as a page."""
from tables import (figure, figures_table, in_order, known, number, read, select, show, table, total,
                    weighted)

TITLE = "Speed against error"
FILES = ("pairs", "queries", "coarse", "stages", "points", "certification")
PAGE = "RESULTS.md"
CERTIFIED = "cdcluster, certified"
KINDS = ("touch", "coplanar", "proper")
# Scenes where touching is the normal case.
TIES = ("stacked boxes", "gears")
# Hard pairs whose size or shape, not their contact, makes every rounding error large.
EXTREME = ("slivers 1e6 to 1e12", "needles 1e6 to 1e12", "tiny", "tiny 1e-20", "denormal",
           "denormal, many steps", "huge", "huge 2^400, nearly touching",
           "offset 1e7 with features of 1e-3", "scales 1e-6 with 1e6")


def mean_ns(rows):
    """Over pairs, not over categories."""
    timed = [row for row in rows if row["ns_pair"]]
    pairs = total(timed, "separate", *KINDS)
    times = (number(row, "ns_pair") * total([row], "separate", *KINDS) for row in timed)
    return sum(times) / pairs if pairs else None


def wrong_per_million(rows):
    answered = total(rows, "separate", *KINDS)
    wrong = total(rows, "invented", *("missed_" + kind for kind in KINDS))
    return 1e6 * wrong / answered if answered else None


def speed_errors(pairs):
    """A row for each engine: its wrong answers and its time, over all categories of the given pairs."""
    rows = []
    for engine in in_order(pairs, "engine"):
        mine = select(pairs, engine=engine)
        wrong, ns = wrong_per_million(mine), mean_ns(mine)
        rows.append({"engine": engine, "wrong per million": "" if wrong is None else wrong,
                     "ns a pair": "" if wrong is None or ns is None else ns})
    return rows


COARSE_NOTE = ("Any contact, on motion and vehicles. The error is the stated bound less the true "
               "distance, as a share of A's diagonal; it is 0 for a proof. The time is also told "
               "as a multiple of exact, least and most of a scene.")


def coarse_table(coarse):
    header = ["setting", "value", "queries", "apart", "contact", "undecided", "missed", "invented",
              "bound broken", "error mean", "error p99", "error max", "us a query", "times exact"]
    exact = {row["scene"]: number(row, "us_query") for row in select(coarse, setting="exact")}
    body = []
    for setting in in_order(coarse, "setting"):
        for value in in_order(select(coarse, setting=setting), "value"):
            rows = select(coarse, setting=setting, value=value)
            body.append([setting, value if setting != "exact" else "", show(total(rows, "queries")),
                         *(show(total(rows, c)) for c in ("apart", "contact", "undecided", "missed",
                                                          "invented", "bound_broken")),
                         show(weighted(rows, "error_mean", "queries")),
                         worst(rows, "error_p99"), worst(rows, "error_max"),
                         show(weighted(rows, "us_query", "queries")), times_text(rows, exact)])
    return table(header, body)


def times_text(rows, exact):
    """The least and the most that a scene's time is of its exact time."""
    ratios = sorted(number(row, "us_query") / exact[row["scene"]] for row in rows if row["scene"] in exact)
    return f"{show(ratios[0])} to {show(ratios[-1])}" if ratios and ratios[0] != 1 else ""


def extremes_apart(rows):
    """The rows of the usual categories, and of the extreme ones."""
    return ([row for row in rows if row["category"] not in EXTREME],
            [row for row in rows if row["category"] in EXTREME])


def rounded_percent(points):
    count = total(points, "points")
    return 100 * total(points, "rounded") / count if count else None


EXTREME_NOTE = ("The largest errors of end points, in units, are those of the extreme categories, whose "
                "coordinates lie at the ends of the range of doubles or whose triangles are thinner than a "
                "rounding step; they have columns of their own.")


def worst(rows, column):
    return show(max((number(row, column) for row in rows), default=None))


def at_most(what, value, limit, unit):
    return figure(what, f"<= {limit} {unit}", value, unit, lambda v: v <= limit)


def stage_ns(stages, **wanted):
    return weighted(select(stages, stage="all", **wanted), "ns_pair", "pairs")


def our_pairs(data):
    return [row for row in data["pairs"] if row["engine"].startswith(CERTIFIED)]


def our_ends(data):
    """Our crashes and hangs."""
    rows = our_pairs(data) + select(data.get("queries", []), ours="yes")
    return sum(row["ending"] != "done" for row in rows)


def our_wrong(data):
    missed = ["missed_" + kind for kind in KINDS]
    return (total(our_pairs(data), "invented", *missed, "wrong_class", "swap_differs", "order_differs")
            + total(select(data.get("queries", []), ours="yes"), "wrong_any", "wrong_count",
                    "invented", *missed)
            + total(data.get("coarse", []), "missed", "invented", "bound_broken"))


def faults(data):
    """What of ours is wrong, in words."""
    found = {"wrong answers": our_wrong(data), "crashes and hangs": our_ends(data),
             "unanswered pairs": total(our_pairs(data), "unanswered")}
    share = rounded_percent(select(data.get("points", []), engine=CERTIFIED))
    if share is not None and share < 100:
        found["per cent of points that are not correctly rounded"] = 100 - share
    if not our_pairs(data):
        found["suites without an answer"] = 1
    return [f"{show(count)} {what}" for what, count in found.items() if count]


def figures_section(data):
    rows = [figure("wrong answers: pairs, whole meshes, coarse", "0", our_wrong(data), "",
                   lambda v: v == 0)]
    vehicles = select(data["stages"], suite="vehicles")
    tested = total(select(vehicles, stage="all"), "pairs")
    past = tested - total(select(vehicles, stage="float"), "pairs")
    rows.append(at_most("pairs past the float stage, vehicles",
                        100 * past / tested if tested else None, 0.1, "%"))

    in_use = next((r["value"] for r in data["machine"] if r["what"] == "SIMD target in use"), "")
    for target, limit in (("avx512", 8), ("avx2", 15)):
        name = CERTIFIED if target == in_use else f"{CERTIFIED} ({target})"
        ns = mean_ns(select(data["pairs"], suite="vehicles", engine=name))
        rows.append(at_most(f"a candidate, vehicles, {target}", ns, limit, "ns"))
    ties = [r for r in select(data["stages"], suite="scenes") if r["category"].startswith(TIES)]
    rows.append(at_most("a candidate where ties are normal (stacked boxes, gears)",
                        stage_ns(ties), 100, "ns"))
    rows.append(at_most("the hard corpus, mean of a pair",
                        mean_ns(select(data["pairs"], suite="corpus", engine=CERTIFIED)), 300,
                        "ns"))
    for row in data["certification"]:
        rows.append(at_most(f"certification of whole queries, {row['level']}, {row['measure']}",
                            known(row, "cost_percent"), 3, "%"))
    rows.append(figure("points correctly rounded", "100 %",
                       rounded_percent(select(data["points"], engine=CERTIFIED)), "%",
                       lambda v: v == 100))
    rows.append(figure("crashes and hangs of ours", "0", our_ends(data), "", lambda v: v == 0))
    return "## Figures\n" + figures_table(rows)


def engine_summary(data):
    """A row an engine: hard pairs, whole meshes, points."""
    body = []
    for engine in in_order(data["pairs"], "engine"):
        pairs = select(data["pairs"], suite="corpus", engine=engine)
        points = select(data["points"], engine=engine)
        meshes = select(data["queries"], engine=engine)
        lists = select(meshes, level="pairs") or select(meshes, level="contacts")
        usual, extreme = extremes_apart(points if total(points, "points") else [])
        body.append([
            engine, show(wrong_per_million(pairs)), show(mean_ns(pairs)),
            *([show(total(select(meshes, level="any"), "wrong_any")), show(total(lists, "invented")),
               show(total(lists, *("missed_" + kind for kind in KINDS)))] if meshes else [""] * 3),
            show(rounded_percent(points)),
            *(worst(usual, c) for c in ("end_max", "end_max_units")),
            *(worst(extreme, c) for c in ("end_max", "end_max_units"))])
    queries = total(select(data["queries"], engine=CERTIFIED, level="any"), "asked")
    note = (f"Hard pairs: wrong answers per million and ns a pair. Whole meshes, {show(queries)} queries: wrong "
            "answers to any contact, pairs invented and missed. Points of contact: correctly rounded, and the "
            "largest distance of an end point, as a share of the longest edge and in units. " + EXTREME_NOTE)
    return f"## Engines\n{note}\n\n" + table(
        ["engine", "wrong per million", "ns a pair", "meshes: wrong any", "invented", "missed",
         "points rounded %", "end max", "units", "extreme: end max", "units"], body)


def summary(data):
    return [figures_section(data), engine_summary(data),
            f"## Coarse answers\n{COARSE_NOTE}\n\n" + coarse_table(data["coarse"])]
