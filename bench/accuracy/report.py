#!/usr/bin/env python3
"""Turns the CSV files of accuracy_report into one page of Markdown tables.

    report.py FOLDER            prints the page
    report.py --answers FOLDER  prints that of a run of hard pairs alone, without times
"""
import csv
import os
import sys

CERTIFIED = "cdcluster, certified"
KINDS = ("touch", "coplanar", "proper")
# Scenes where touching is the normal case.
TIES = ("stacked boxes", "gears")
# Hard pairs whose size or shape, not their contact, makes every rounding error large.
EXTREME = ("slivers 1e6 to 1e12", "needles 1e6 to 1e12", "tiny 1e-20", "denormal, many steps",
           "huge 2^400, nearly touching", "offset 1e7 with features of 1e-3",
           "scales 1e-6 with 1e6")


def read(folder, name):
    path = os.path.join(folder, name + ".csv")
    if not os.path.exists(path):
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def number(row, column):
    return float(row[column] or 0)


def total(rows, *columns):
    return sum(number(row, column) for row in rows for column in columns)


def select(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def in_order(rows, column):
    return list(dict.fromkeys(row[column] for row in rows))


def show(value, digits=3):
    """Numbers as people read them; nothing where there is nothing."""
    if value is None:
        return ""
    if value == 0:
        return "0"
    if value >= 1000 or float(value).is_integer():
        return f"{value:,.0f}"
    return f"{value:.{digits}g}"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def mean_ns(rows):
    """Over pairs, not over categories."""
    timed = [row for row in rows if row["ns_pair"]]
    weights = [total([row], "separate", *KINDS) for row in timed]
    if sum(weights) == 0:
        return None
    return sum(number(row, "ns_pair") * w for row, w in zip(timed, weights)) / sum(weights)


def wrong_per_million(rows):
    answered = total(rows, "separate", *KINDS)
    wrong = total(rows, "invented", *("missed_" + kind for kind in KINDS))
    return 1e6 * wrong / answered if answered else None


def pair_row(engine, rows, timed=True):
    pairs = total(rows, *KINDS, "separate")

    def per_million(column, among):
        count = total(rows, among)
        return show(1e6 * total(rows, column) / count) if count else ""

    bad = [row for row in rows if row["ending"] != "done"]
    return [
        engine,
        show(pairs),
        show(wrong_per_million(rows)),
        per_million("invented", "separate"),
        *(per_million("missed_" + kind, kind) for kind in KINDS),
        show(total(rows, "swap_differs")),
        show(total(rows, "order_differs")),
        show(len(select(bad, ending="crashed"))),
        show(len(select(bad, ending="timed out"))),
        *([show(mean_ns(rows))] if timed else []),
    ]


def pairs_section(pairs, suite, title, note, timed=True):
    rows = select(pairs, suite=suite)
    header = ["engine", "pairs", "wrong per million", "invented", "missed touch",
              "missed coplanar", "missed proper", "swap differs", "order differs", "crashes",
              "hangs"] + (["ns a pair"] if timed else [])
    body = [pair_row(engine, select(rows, engine=engine), timed)
            for engine in in_order(rows, "engine")]
    return f"## {title}\n\n{note}\n\n" + table(header, body)


def queries_section(queries):
    parts = ["## Whole meshes\n"]
    for suite in in_order(queries, "suite"):
        rows = select(queries, suite=suite)
        body = []
        for engine in in_order(rows, "engine"):
            for level in in_order(select(rows, engine=engine), "level"):
                mine = select(rows, engine=engine, level=level)
                answered = total(mine, "answered")
                # The time of an engine that came through every scene; else it is of other scenes.
                whole = all(row["us_query"] for row in mine)
                us = sum(number(r, "us_query") * number(r, "asked") for r in mine)
                us = us / total(mine, "asked") if whole else None
                has_pairs = level in ("pairs", "contacts")
                record = [number(r, "record_bytes") * number(r, "answered") for r in mine]
                touched = [number(r, "read_bytes") * number(r, "answered") for r in mine]
                body.append([
                    engine, level, show(answered), show(total(mine, "wrong_any")),
                    show(total(mine, "invented")) if has_pairs else "",
                    *(show(total(mine, "missed_" + k)) if has_pairs else "" for k in KINDS),
                    show(sum(row["ending"] != "done" for row in mine)),
                    show(us), show(1e6 / us if us else None),
                    show(sum(record) / answered) if sum(record) else "",
                    show(sum(touched) / answered) if sum(touched) else "",
                ])
        header = ["engine", "level", "queries", "wrong any-contact", "pairs invented",
                  "missed touch", "missed coplanar", "missed proper", "crashes, hangs", "us a query",
                  "queries/s", "bytes sent", "bytes read"]
        count = len(in_order(rows, "scene"))
        true_pairs = sum(number(select(rows, scene=s)[0], "true_pairs")
                         for s in in_order(rows, "scene"))
        parts.append(f"### {suite}: {count} scenes, {true_pairs:,.0f} pairs in contact\n")
        parts.append(table(header, body))
    return "\n".join(parts)


def coarse_section(coarse):
    header = ["setting", "value", "queries", "apart", "contact", "undecided", "missed", "invented",
              "bound broken", "error mean", "error p99", "error max", "us a query"]
    body = []
    for setting in in_order(coarse, "setting"):
        for value in in_order(select(coarse, setting=setting), "value"):
            rows = select(coarse, setting=setting, value=value)
            queries = total(rows, "queries")

            def mean(column):
                return sum(number(r, column) * number(r, "queries") for r in rows) / queries

            body.append([setting, value if setting != "exact" else "", show(queries),
                         *(show(total(rows, c)) for c in ("apart", "contact", "undecided", "missed",
                                                          "invented", "bound_broken")),
                         show(mean("error_mean")), show(max(number(r, "error_p99") for r in rows)),
                         show(max(number(r, "error_max") for r in rows)), show(mean("us_query"))])
    note = ("Any contact, on motion and vehicles. The error is the stated bound less the true "
            "distance, as a share of A's diagonal; it is 0 for a proof.")
    return f"## Coarse answers\n\n{note}\n\n" + table(header, body)


def stages_section(stages):
    header = ["suite", "stage", "pairs", "share %", "ns a pair"]
    body = []
    for suite in in_order(stages, "suite"):
        rows = select(stages, suite=suite)
        everything = total(select(rows, stage="all"), "pairs")
        for stage in in_order(rows, "stage"):
            mine = select(rows, stage=stage)
            pairs = total(mine, "pairs")
            ns = sum(number(r, "ns_pair") * number(r, "pairs") for r in mine) / pairs
            body.append([suite, stage, show(pairs), f"{100 * pairs / everything:.4g}", show(ns)])
    note = ("A pair counts for the highest stage that it needs; its time holds what the stages "
            "before cost, and is that of pairs in a row that end at the same stage.")
    return f"## Stages of our decision\n\n{note}\n\n" + table(header, body)


def points_section(points):
    header = ["engine", "pairs", "points", "correctly rounded %", "stray p99", "stray max",
              "end p99", "end max", "end max, units", "extreme: end max", "units"]
    body = []
    for engine in in_order(points, "engine"):
        rows = select(points, engine=engine)
        count = total(rows, "points")
        if count == 0:
            continue
        extreme = [row for row in rows if row["category"] in EXTREME]
        usual = [row for row in rows if row["category"] not in EXTREME]
        body.append([engine, show(total(rows, "pairs")), show(count),
                     show(100 * total(rows, "rounded") / count, 6),
                     *(worst(usual, c) for c in
                       ("stray_p99", "stray_max", "end_p99", "end_max", "end_max_units")),
                     *(worst(extreme, c) for c in ("end_max", "end_max_units"))])
    note = ("Of the hard pairs that are in contact. *Stray*: how far a returned point is from the "
            "exact shared set; *end*: how far the exact set's corners are from the nearest returned "
            "point. As shares of the longer triangle's longest edge; p99 and maximum of the worst "
            "category. The last two columns are those of the extreme categories alone ("
            + ", ".join(EXTREME) + "), whose coordinates lie at the ends of the range of doubles or "
            "whose triangles are thinner than a rounding step; the columns before leave them out.")
    return f"## Points of contact\n\n{note}\n\n" + table(header, body)


def worst(rows, column):
    return show(max((number(row, column) for row in rows), default=None))


def figure(name, target, measured, met):
    return [name, target, measured, {True: "yes", False: "**no**", None: "not measured"}[met]]


def at_most(name, value, limit, unit=""):
    shown = show(value) + unit if value is not None else ""
    return figure(name, f"<= {limit}{unit}", shown, None if value is None else value <= limit)


def stage_ns(stages, **wanted):
    rows = [r for r in select(stages, stage="all", **wanted)]
    pairs = total(rows, "pairs")
    return sum(number(r, "ns_pair") * number(r, "pairs") for r in rows) / pairs if pairs else None


def figures_section(data):
    ours = [row for row in data["pairs"] if row["engine"].startswith(CERTIFIED)]
    queries = select(data["queries"], ours="yes")
    wrong = total(ours, "invented", *("missed_" + k for k in KINDS), "wrong_class",
                  "swap_differs", "order_differs")
    wrong += total(queries, "wrong_any", "wrong_count", "invented",
                   *("missed_" + k for k in KINDS))
    wrong += total(data["coarse"], "missed", "invented", "bound_broken")
    rows = [figure("wrong answers: pairs, whole meshes, coarse", "0", show(wrong), wrong == 0)]

    vehicles = select(data["stages"], suite="vehicles")
    tested = total(select(vehicles, stage="all"), "pairs")
    past = tested - total(select(vehicles, stage="float"), "pairs")
    rows.append(at_most("pairs past the float stage, vehicles",
                        100 * past / tested if tested else None, 0.1, " %"))

    in_use = next((r["value"] for r in data["machine"] if r["what"] == "SIMD target in use"), "")
    for target, limit in (("avx512", 8), ("avx2", 15)):
        name = CERTIFIED if target == in_use else f"{CERTIFIED} ({target})"
        ns = mean_ns(select(data["pairs"], suite="vehicles", engine=name))
        rows.append(at_most(f"a candidate, vehicles, {target}", ns, limit, " ns"))
    ties = [r for r in select(data["stages"], suite="scenes") if r["category"].startswith(TIES)]
    rows.append(at_most("a candidate where ties are normal (stacked boxes, gears)",
                        stage_ns(ties), 100, " ns"))
    rows.append(at_most("the hard corpus, mean of a pair",
                        mean_ns(select(data["pairs"], suite="corpus", engine=CERTIFIED)), 300,
                        " ns"))
    for row in data["certification"]:
        rows.append(at_most(f"certification of whole queries, {row['level']}, {row['measure']}",
                            number(row, "cost_percent"), 3, " %"))
    points = select(data["points"], engine=CERTIFIED)
    count = total(points, "points")
    share = 100 * total(points, "rounded") / count if count else None
    rows.append(figure("points correctly rounded", "100 %",
                       f"{share:.6g} %" if count else "", share == 100 if count else None))
    ended = sum(row["ending"] != "done" for row in ours + queries)
    rows.append(figure("crashes and hangs of ours", "0", show(ended), ended == 0))
    return "## Figures\n\n" + table(["figure", "target", "measured", "met"], rows)


def answers_page(folder):
    """Of a run that took no times: what was answered, and by which sources."""
    pairs = read(folder, "pairs")
    machine = read(folder, "machine")
    print("# Hard pairs against the oracle\n")
    print("Made by `bench/accuracy/run --answers`; README.md beside it says what the columns mean.\n")
    print(table(["machine", ""], [[row["what"], row["value"]] for row in machine]))
    categories = len(in_order(pairs, "category"))
    body = []
    for engine in in_order(pairs, "engine"):
        rows = select(pairs, engine=engine)
        if engine.startswith(CERTIFIED):
            body.append([engine, show(total(rows, "separate", *KINDS)),
                         *(show(total(rows, kind)) for kind in ("separate", *KINDS)),
                         show(total(rows, "invented", *("missed_" + kind for kind in KINDS))),
                         *(show(total(rows, c)) for c in ("wrong_class", "swap_differs",
                                                          "order_differs", "unanswered"))])
    print("## Our answers\n")
    print(f"{categories} categories, equally many pairs of each, every pair asked three times: as it "
          "is, with the bodies swapped, and with the corners in another order. The truth is the "
          "exact oracle's.\n")
    print(table(["setting", "pairs", "apart", *KINDS, "wrong", "wrong class", "swap differs",
                 "order differs", "unanswered"], body))
    print(pairs_section(pairs, "corpus", "All engines",
                        "Missed and invented are per million of the pairs of that class; crashes "
                        "and hangs count categories, and end the engine's part in them.",
                        timed=False))


def main():
    if sys.argv[1] == "--answers":
        answers_page(sys.argv[2])
        return
    folder = sys.argv[1]
    names = ("machine", "pairs", "queries", "coarse", "stages", "points", "certification")
    data = {name: read(folder, name) for name in names}
    print("# Speed against error\n")
    print("Made by `bench/accuracy/run`; README.md beside it says what the columns mean.\n")
    print(table(["machine", ""], [[row["what"], row["value"]] for row in data["machine"]]))
    print(figures_section(data))
    print(pairs_section(data["pairs"], "corpus", "Hard pairs",
                        "The corpus: every category alike. Missed and invented are per million of "
                        "the pairs of that class; crashes and hangs count categories."))
    print(pairs_section(data["pairs"], "vehicles", "Candidates of vehicles",
                        "The pairs that our boxes leave for the triangle test."))
    print(pairs_section(data["pairs"], "scenes", "Candidates of hard scenes", "As above."))
    print(queries_section(data["queries"]))
    print(coarse_section(data["coarse"]))
    print(stages_section(data["stages"]))
    print(points_section(data["points"]))


if __name__ == "__main__":
    main()
