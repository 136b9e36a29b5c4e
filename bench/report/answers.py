"""Hard pairs alone, without times: what accuracy_report --answers measured, as a page."""
from accuracy import CERTIFIED, KINDS, faults, wrong_per_million  # noqa: F401
from tables import in_order, select, show, table, total

TITLE = "Hard pairs against the oracle"
FILES = ("pairs",)
PAGE = "ANSWERS.md"


def engine_row(engine, rows):
    def per_million(column, among):
        count = total(rows, among)
        return show(1e6 * total(rows, column) / count) if count else ""

    endings = [row["ending"] for row in rows]
    return [engine, show(total(rows, *KINDS, "separate")), show(wrong_per_million(rows)),
            per_million("invented", "separate"),
            *(per_million("missed_" + kind, kind) for kind in KINDS),
            *(show(total(rows, column)) for column in ("swap_differs", "order_differs")),
            show(endings.count("crashed")), show(endings.count("timed out"))]


def engines_section(pairs):
    note = ("Missed and invented are per million of the pairs of that class; crashes and hangs count categories, "
            "and end the engine's part in them.")
    return f"## All engines\n\n{note}\n\n" + table(
        ["engine", "pairs", "wrong per million", "invented", "missed touch", "missed coplanar", "missed proper",
         "swap differs", "order differs", "crashes", "hangs"],
        [engine_row(engine, select(pairs, engine=engine)) for engine in in_order(pairs, "engine")])


def summary(data):
    pairs = data["pairs"]
    body = []
    for engine in in_order(pairs, "engine"):
        rows = select(pairs, engine=engine)
        if engine.startswith(CERTIFIED):
            body.append([engine, show(total(rows, "separate", *KINDS)),
                         *(show(total(rows, kind)) for kind in ("separate", *KINDS)),
                         show(total(rows, "invented", *("missed_" + kind for kind in KINDS))),
                         *(show(total(rows, c)) for c in ("wrong_class", "swap_differs",
                                                          "order_differs", "unanswered"))])
    note = (f"{len(in_order(pairs, 'category'))} categories, equally many pairs of each, every pair asked three "
            "times: as it is, with the bodies swapped, and with the corners in another order. The truth is the "
            "exact oracle's.")
    return [f"## Our answers\n\n{note}\n\n" + table(
                ["setting", "pairs", "apart", *KINDS, "wrong", "wrong class", "swap differs",
                 "order differs", "unanswered"], body),
            engines_section(pairs)]
