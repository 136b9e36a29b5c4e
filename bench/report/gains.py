"""What the gains of a cluster consist of, as a page."""
from cluster import SCENES, Series, mean
from tables import fixed, in_order, known, number, select, show, table

TITLE = "What the gains consist of"
FILES = ("fit", "runs", "attribution")
PAGE = "GAINS.md"
PAPERS = ("best-match", "random", "lowest")
SWITCHES = ("", "+peers", ", longest first", "+peers, longest first")
OURS = ("earliest-finish+peers", "blind earliest-finish+peers", "earliest-finish",
        "earliest-finish+peers, equal predictions", "earliest-finish+peers, longest first",
        "earliest-finish+peers, no help at the end")
WHAT_OURS = ("all parts", "matching off: it does not see blocks", "peers off",
             "predictions off: all equal", "longest submitted first", "recalls and copies off")


class Attribution:
    """Mean speed-ups, as the paper defines them, by scene, way and cost of bytes."""

    def __init__(self, rows):
        self.rows = rows

    def value(self, scene, way, bytes_="cost", column="paper_speedup"):
        return mean(select(self.rows, scene=scene, way=way, bytes=bytes_), column)

    def both(self, way, bytes_="cost"):
        """The means of both scenes."""
        found = [self.value(scene, way, bytes_) for scene in SCENES]
        return " / ".join("" if value is None else fixed(value) for value in found).strip(" /")

    def seeds(self):
        return len({row["seed"] for row in self.rows})

    def ratio(self, way, other, bytes_="cost", other_bytes="cost"):
        cells = []
        for scene in SCENES:
            one, two = self.value(scene, way, bytes_), self.value(scene, other, other_bytes)
            cells.append("" if one is None or two is None else f"{one / two:.2f}x")
        return cells


def paper_table(data):
    rows = []
    for form in ("-pull", ""):
        for name in PAPERS:
            cells = [data.both(name + form + switch) for switch in SWITCHES]
            rows.append([name + form, *cells, data.both(name + form, "free")])
    return table(["strategy", "alone", "+peers", "longest first", "both", "bytes free"], rows)


def our_table(data):
    rows = [[what, data.both(way), data.both(way, "free")] for way, what in zip(OURS, WHAT_OURS)]
    return table(["`earliest-finish`", "bytes cost", "bytes free"], rows)


def share_table(data):
    ours = OURS[0]
    pairs = (("matching, client-first: best-match by random", "best-match-pull", "random-pull"),
             ("matching, client-first: best-match by lowest", "best-match-pull", "lowest-pull"),
             ("matching, a client for each scenario: best-match by random", "best-match", "random"),
             ("matching, ours: by ours that does not see blocks", ours, OURS[1]),
             ("peers: random by random without", "random+peers", "random"),
             ("peers: ours by ours without", ours, OURS[2]),
             ("order: random, longest first, by random", "random, longest first", "random"),
             ("order: ours by ours with equal predictions", ours, OURS[3]),
             ("all: ours by random", ours, "random"))
    rows = [[what, *data.ratio(one, two)] for what, one, two in pairs]
    for way in ("random", ours):
        name = "ours" if way == ours else way
        rows.append([f"bytes: {name} by {name} where bytes cost nothing", *data.ratio(way, way, "cost", "free")])
    return table(["what", *SCENES], rows)


def attribution_section(rows, fit):
    if not rows:
        return ""
    data = Attribution(rows)
    bounds = " / ".join(fixed(data.value(scene, OURS[0], column="paper_bound")) for scene in SCENES)
    rate = "".join(show(known(row, "value")) for row in fit)
    note = (f"Speed-ups as the paper defines them (it gives 20 and 12 for heavy; bound {bounds}), heavy / cars: all "
            "scenarios, the paper's depths, q = 20, its costs, 3 ms an analysis, and a pipe of "
            f"{rate} bytes a second, fitted so that lowest-pull takes 261 s. Means of {data.seeds()} seeds. *-pull*: "
            "client-first (5.1). *Longest first*: by the master's predictions. *Bytes free*: no pipe, endless links.")
    return (f"## Each part switched off\n{note}\n\n{paper_table(data)}\n{our_table(data)}\n"
            f"Ratios of these means:\n\n{share_table(data)}")


def optimum_section(runs):
    if not runs:
        return ""
    rows = []
    for name in in_order(select(runs, setting="client-first"), "strategy"):
        cells = [name]
        for experiment in ("depth", "q"):
            for scene in SCENES:
                series = Series(runs, "client-first", scene, experiment)
                best = series.best(name)
                cells.append(" ".join(("**{}**" if x == best else "{}").format(
                    fixed(series.mean(x, name, "paper_speedup"))) for x in series.xs))
        rows.append(cells)
    xs = [", ".join(show(x) for x in Series(runs, "client-first", SCENES[0], one).xs) for one in ("depth", "q")]
    columns = [f"{scene}, {what}" for what in ("depth", "q") for scene in SCENES]
    return (f"## Where the optimum lies\nSpeed-ups at the depths {xs[0]} (q = 20), and with q = {xs[1]} (the paper's "
            "depths); the best is bold. The paper's optimum: depth 12 and 10, q = 20.\n\n" +
            table(["strategy", *columns], rows))


def faults(_data):
    """The page has only figures of the simulation: none of ours can be wrong."""
    return []


def summary(data):
    return [attribution_section(data["attribution"], data["fit"]), optimum_section(data["runs"])]
