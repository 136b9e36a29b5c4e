#!/usr/bin/env python3
"""Checks all Markdown pages: how long they are, that their links lead to files, that their jobs are TOML, that
the tests that they name exist, and that the page of the job file has every key that the parser knows.
Usage: documents.py REPOSITORY"""
import pathlib
import re
import sys
import tomllib

LINES_MAX = {"README.md": 90, "ARCHITECTURE.md": 120, "proto/PROTOCOL.md": 380}
PAGE_LINES_MAX = 160
RESULTS_LINES_MAX = 60
COLUMNS_MAX = 100
CELL_WORDS_MAX = 25
JOB_PAGES = ("docs/job-file.md", "docs/job-keys.md")
# A table of the job file that the parser reads: the keys that it knows.
KNOWN_KEYS = re.compile(r'TomlFields\s+\w+\(\s*\*?table,[^{;]*\{((?:\s*"\w+",?)+)\s*\}\)')


def link_target(page, link):
    """The file that a relative link leads to; nothing for links to the web and within the page."""
    if re.match(r"[a-z]+:|#", link):
        return None
    return page.parent / link.split("#")[0]


def anchors_of(page):
    """What a link may name behind '#', as GitHub makes it of headings."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def problems_of_links(page, name, text):
    for link in re.findall(r"\[[^\]]*\]\(([^)\s]+)\)", text):
        target = link_target(page, link)
        if target is None:
            continue
        if not target.exists():
            yield f"{name}: the link {link} leads to no file"
        elif "#" in link and link.split("#")[1] not in anchors_of(target):
            yield f"{name}: the link {link} leads to no heading"


def problems_of_page(root, name):
    page = root / name
    text = page.read_text(encoding="utf-8")
    lines = text.splitlines()
    is_readme = name == "README.md"
    is_generated = name.startswith("bench/") and not name.endswith("README.md")
    lines_max = RESULTS_LINES_MAX if name.endswith("RESULTS.md") else LINES_MAX.get(name, PAGE_LINES_MAX)
    if len(lines) > lines_max:
        yield f"{name}: has {len(lines)} lines; {lines_max} at most"
    for number, line in enumerate(lines, 1):
        is_row = line.startswith("|")
        # A row of a table cannot be broken; README has narrow tables.
        if len(line) > COLUMNS_MAX and (is_readme or not is_row) and not is_generated:
            yield f"{name}:{number}: has {len(line)} columns; {COLUMNS_MAX} at most"
        for cell in line.strip("|").split("|") if is_row else []:
            if len(cell.split()) > CELL_WORDS_MAX:
                yield f"{name}:{number}: a cell has {len(cell.split())} words; {CELL_WORDS_MAX} at most"
    yield from problems_of_links(page, name, text)
    for job in re.findall(r"^```toml\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        try:
            tomllib.loads(job)
        except tomllib.TOMLDecodeError as error:
            yield f"{name}: a job in it is no TOML: {error}"


def problems_of_named_tests(root, pages):
    """Tests that a page names as `Suite.Name` exist."""
    sources = [p.read_text(encoding="utf-8") for p in sorted((root / "tests").rglob("*_test.cpp"))]
    known = {match for text in sources for match in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", text, re.MULTILINE)}
    for name in pages:
        for test in re.findall(r"`([A-Z]\w+)\.([A-Z]\w+)`", (root / name).read_text(encoding="utf-8")):
            if test not in known:
                yield f"{name}: names the test {'.'.join(test)}, which does not exist"


def known_keys(root):
    """The keys of each table of a job file, as client/ reads them."""
    return [
        re.findall(r'"(\w+)"', keys)
        for source in sorted((root / "client").rglob("*.cpp"))
        for keys in KNOWN_KEYS.findall(source.read_text(encoding="utf-8"))
    ]


def problems_of_job_page(root):
    tables = known_keys(root)
    if not tables:
        yield "client/: no table of a job file is read there; mend KNOWN_KEYS"
    text = "\n".join((root / page).read_text(encoding="utf-8") for page in JOB_PAGES)
    rows = re.findall(r"^\|([^|]*)\|", text, re.MULTILINE)
    explained = [key for first_cell in rows for key in re.findall(r"`(\w+)`", first_cell)]
    read = [key for keys in tables for key in keys]
    for key in sorted(set(read) | set(explained)):
        if explained.count(key) != read.count(key):
            yield (f"{' and '.join(JOB_PAGES)}: explain the key {key} in {explained.count(key)} tables, "
                   f"and the parser knows it in {read.count(key)}")


def main():
    root = pathlib.Path(sys.argv[1])
    names = sorted(p.relative_to(root).as_posix() for p in root.rglob("*.md") if "node_modules" not in p.parts)
    pages = [name for name in names if not name.startswith(("build", "."))]
    found = [problem for name in pages for problem in problems_of_page(root, name)]
    found += problems_of_named_tests(root, pages)
    found += problems_of_job_page(root)
    print("\n".join(found) or f"{len(pages)} pages obey the limits, and every key is explained")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
