"""Rows of CSV files, and tables of Markdown made of them."""
import csv
import os


def read(folder, name):
    """The rows of a CSV file; none where the run did not write it."""
    path = os.path.join(folder, name + ".csv")
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def number(row, column):
    return float(row[column] or 0)


def known(row, column):
    """A number, or None where there is no row or the cell is empty."""
    return float(row[column]) if row and row[column] else None


def total(rows, *columns):
    return sum(number(row, column) for row in rows for column in columns)


def weighted(rows, column, weight):
    """The mean of a column, each row counted as often as its weight says; None without weights."""
    weights = total(rows, weight)
    return sum(number(row, column) * number(row, weight) for row in rows) / weights \
        if weights else None


def select(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def in_order(rows, column):
    return list(dict.fromkeys(row[column] for row in rows))


def show(value, digits=3):
    """A number as people read it; nothing for None."""
    if value is None:
        return ""
    if value == 0:
        return "0"
    if abs(value) >= 1e15:
        return f"{value:.1e}"
    if abs(value) >= 1000 or float(value).is_integer():
        return f"{value:,.0f}"
    return f"{value:.{digits}g}"


def fixed(value, digits=1):
    return "" if value is None else f"{value:.{digits}f}"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def figure(what, target, value, unit, is_met):
    """A row of a page's figures: a value of None was not measured."""
    if value is None:
        return [what, target, "", "not measured"]
    return [what, target, f"{show(value)} {unit}".strip(), "yes" if is_met(value) else "**no**"]


def unpackaged(engines):
    """The row of engines that the specification of a page names, and that have no Debian package."""
    return [f"{engines}: no Debian package", "", "not measured here", ""]


def figures_table(rows):
    return table(["figure", "target", "measured", "met"], rows)
