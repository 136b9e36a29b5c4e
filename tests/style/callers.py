#!/usr/bin/env python3
"""Finds functions of the product that nothing in the product calls: a promise without a caller. Such a
function is deleted, called, or listed in tests/style/callers.txt with its reason. Usage: callers.py REPOSITORY"""
import collections
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from classes import PRODUCT, bare

DECLARED = re.compile(r"(~?\b[a-z]\w*)\s*\(")
WORD = re.compile(r"\b[a-z]\w*\b")
NO_FUNCTION = {"if", "for", "while", "switch", "return", "sizeof", "alignof", "decltype", "noexcept", "requires", "assert",
               "static_assert", "operator", "defined", "alignas", "explicit", "catch", "constexpr"}


def declared_in(text):
    """Names that a header declares as functions: followed by a parenthesis, outside other functions' bodies."""
    names = set()
    for line in bare(text).splitlines():
        if line.lstrip().startswith("#"):
            continue
        head = re.split(r"[={]", re.sub(r"<[^<>;{}]*>", "", line), maxsplit=1)[0]
        match = DECLARED.search(head)
        if match and match.group(1) not in NO_FUNCTION and not re.match(r"\s*(return|if|for|while|else|co_await|co_return)\b", head):
            if re.search(r"[\w>&*\]]\s+[&*]?" + re.escape(match.group(1)) + r"\s*\($", head[: match.end()]):
                names.add(match.group(1))
    return names


def main():
    root = pathlib.Path(sys.argv[1])
    listed = root / "tests/style/callers.txt"
    uses = collections.Counter()
    declared = collections.defaultdict(set)
    for folder in PRODUCT:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".hpp", ".cpp"):
                continue
            text = bare(path.read_text(encoding="utf-8"))
            if path.suffix == ".hpp" and "include" not in path.parts:  # Others call the library.
                for name in declared_in(text):
                    declared[name].add(path.relative_to(root).as_posix())
            # Each line that begins a definition or declaration counts for nothing, all others are uses.
            for line in text.splitlines():
                words = WORD.findall(line)
                if path.suffix == ".cpp" and line and not line[0].isspace():
                    head = re.search(r"(?:\w+::)*(~?\b[a-z]\w*)\s*\(", re.sub(r"<[^<>;{}]*>", "", line))
                    if head and head.group(1) in words:
                        words.remove(head.group(1))
                uses.update(words)
    for name, headers in declared.items():
        uses[name] -= len(headers)
    exempt = {}
    for line in listed.read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            name, _, reason = line.partition(" ")
            exempt[name] = reason
    unused = {name for name in declared if uses[name] <= 0}
    problems = [f"{', '.join(sorted(declared[name]))}: nothing in the product calls {name}" for name in sorted(unused - set(exempt))]
    problems += [f"{listed.name}: {name} is called, or is gone: remove its line" for name in exempt if name not in unused]
    problems += [f"{listed.name}: {name} has no reason" for name, reason in exempt.items() if not reason.strip()]
    print("\n".join(problems) or f"{sum(map(len, declared.values()))} functions, all called")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
