"""Hard pairs alone, without times: what accuracy_report --answers was answered."""
from accuracy import CERTIFIED, KINDS, faults, pairs_section  # noqa: F401
from tables import in_order, select, show, table, total

TITLE = "Hard pairs against the oracle"
FILES = ("pairs",)


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
            pairs_section(pairs, "corpus", "All engines",
                          "Missed and invented are per million of the pairs of that class; crashes and hangs "
                          "count categories, and end the engine's part in them.", timed=False)]


PAGES = {"ANSWERS.md": summary}
