#!/usr/bin/env python3
"""Finds names that a file uses without including, directly or not, the header that declares them. Unity builds hide
such a mistake, since the includes of one file serve the files after it; other builds fail. Checks macros, types and
free functions that only one header declares. Usage: unseen.py REPOSITORY"""
import collections
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from callers import NO_FUNCTION
from classes import PRODUCT, bare
from includes import SOURCES, seen_from

MACRO = re.compile(r"^\s*#\s*define\s+(CD_\w+)", re.MULTILINE)
TYPE = re.compile(r"\b(?:class|struct|enum class|typename|using|concept)\s+([A-Z]\w*)")
ENUM = re.compile(r"\benum (?:class )?\w*[^{;]*\{([^}]*)\}")
# A name that follows a type declares a function, a method, a variable or a parameter.
NAMED = re.compile(r"(?:[\w>&*\]]\s+|::)(?<!return )(?<!co_await )(?<!throw )(?<!else )[&*]*([a-z]\w+)\s*[=({;,)\[]")
FREE = re.compile(r"^(?:\[\[nodiscard\]\] )?(?!using|namespace|return|friend)[a-zA-Z][^\n=;#{}]*[\w>&*]\s+[&*]?([a-z]\w+)\(", re.MULTILINE)
USE = re.compile(r"(?<![\w.:>#])(?:cd::)?(?:([A-Z]\w+)\b|([a-z]\w+)\()")
SUITE = re.compile(r"^(?:TEST\w*|INSTANTIATE\w+|CD_CONVERSATION)\(\w+")  # A test suite may be named after a type.


def declarations(files, text):
    """Maps each name that only one header declares to that header."""
    declared = collections.defaultdict(set)  # The headers of each name.
    wanted = set()
    for path in files:
        for name in re.findall(r"\w+", " ".join(ENUM.findall(text[path]))):
            declared[name].add("an enumerator")
        for pattern in (MACRO, TYPE, NAMED, FREE):
            for name in pattern.findall(text[path]):
                # Counts a declaration in a header and its definition in the .cpp file beside it as one.
                declared[name].add(path.rsplit(".", 1)[0] + ".hpp")
        if path.endswith(".hpp"):
            for pattern in (MACRO, TYPE, FREE):
                wanted.update(pattern.findall(text[path]))
    return {name: min(declared[name]) for name in wanted - NO_FUNCTION if len(declared[name]) == 1}


def problems_of(root, files):
    text = {path: bare((root / path).read_text(encoding="utf-8")) for path in files}
    home = declarations(files, text)
    known = {}
    for path in files:
        seen = seen_from(root, path, known)
        told = set()
        for line, code in enumerate(text[path].splitlines(), 1):
            for names in USE.findall(SUITE.sub("", code)):
                name = names[0] or names[1]
                if home.get(name, path) not in seen and name not in told:
                    told.add(name)
                    yield f"{path}:{line}: {name} is declared by {home[name]}, which the file does not include"


def main():
    root = pathlib.Path(sys.argv[1])
    files = sorted(
        path.relative_to(root).as_posix()
        for folder in (*PRODUCT, "bench", "tests")
        for path in (root / folder).rglob("*")
        if path.suffix in SOURCES
    )
    found = list(problems_of(root, files))
    print("\n".join(found) or f"{len(files)} files see what they use")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
