#!/usr/bin/env python3
"""Checks the size of classes and folders. A class has at most 12 data members and 30 methods, and is
implemented by the .cpp file of its own header; a folder of sources has at most 25 files. Offenders
of today are listed in tests/style/classes.txt with their figures, which may only shrink.
Usage: classes.py REPOSITORY [--list]; `--list` prints what tests/style/classes.txt should hold."""
import collections
import pathlib
import re
import sys

MEMBERS_MAX, METHODS_MAX, FILES_MAX, FOLDER_MAX = 12, 30, 1, 25
PRODUCT = ("common", "proto", "web", "master", "worker", "client", "library", "python")
FOLDERS = (*PRODUCT, "bench")

RAW = re.compile(r'R"\(.*?\)"', re.DOTALL)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
TEXT = re.compile(r'"(?:\\.|[^"\\\n])*"' + r"|'(?:\\.|[^'\\\n])+'")
HEAD = re.compile(r"\b(?:class|struct)\s+(?:alignas\([^)]*\)\s*)?([A-Za-z_][\w:]*)\s*(?:final\s*)?(?::[^;{]*)?$")
DEFINITION = re.compile(r"^(?!\s)(?:[^\n({;=]*[ *&>])?((?:\w+::)+)~?\w+\s*\(", re.MULTILINE)
METHOD = re.compile(r"(~?\w+|operator\s*\S+?)\s*\(")


def bare(text):
    """The text without comments and the contents of literals."""
    return TEXT.sub('""', COMMENT.sub("", RAW.sub('""', text)))


def scope_of(path):
    """What tells a class of the library or the package from one of the same name in the engine."""
    return "cdcluster::" if path.startswith(("library/", "python/")) else ""


def statements(body):
    """The declarations at the top of a class body, with the bodies of functions and nested classes
    replaced by {}."""
    depth, parentheses = 0, 0
    out = []
    for c in body:
        if c == "{":
            depth += 1
            if depth == 1:
                out.append("{}")
        elif c == "}":
            depth -= 1
            if depth == 0 and parentheses == 0:
                out.append("\0")  # Perhaps the end: a semicolon or a declarator may follow.
        elif depth == 0:
            parentheses += (c == "(") - (c == ")")
            out.append(c)
    text = "".join(out)
    text = re.sub(r"\0(?=\s*[;,=(]|\s*\w+\s*[;={])", "", text).replace("\0", ";")
    text = re.sub(r"\b(public|private|protected)\s*:(?!:)", "", text)
    return [each.strip() for each in text.split(";") if each.strip()]


def without_templates(text):
    """The text without template arguments, so that a comma or parenthesis means what it says."""
    previous = None
    while previous != text:
        previous, text = text, re.sub(r"<[^<>;{}]*>", "", text)
    return text


def measured(body):
    members = methods = 0
    for each in statements(body):
        flat = without_templates(each)
        if re.match(r"\s*(?:template\s*)?(?:using|friend|typedef|enum|class|struct|static_assert)\b", flat):
            continue
        head = re.split(r"[={]", flat, maxsplit=1)[0]
        if METHOD.search(head) or "operator" in flat:
            methods += "= delete" not in flat and "= default" not in flat
        elif not re.match(r"\s*static\b", flat):
            members += 1
    return members, methods


def classes_of(text):
    """Yields (name, members, methods) of each class that a file defines, nested ones included."""
    text = bare(text)
    stack = []
    for at, c in enumerate(text):
        if c == "{":
            before = re.split(r"[;{}]", text[:at])[-1]
            head = HEAD.search(re.sub(r"\s+", " ", before).strip()) if "enum" not in before else None
            stack.append((head.group(1) if head else None, at + 1))
        elif c == "}" and stack:
            name, begin = stack.pop()
            if name:
                outer = [n for n, _ in stack if n]
                full = "::".join([*outer, name])
                yield full, *measured(text[begin:at])


def figures(root):
    found = {}
    headers = {}
    folders = collections.Counter()
    sources = [p for f in FOLDERS for p in sorted((root / f).rglob("*")) if p.suffix in (".hpp", ".cpp")]
    for path in sources:
        name = path.relative_to(root).as_posix()
        folders[name.rsplit("/", 1)[0]] += 1
        if not name.startswith(PRODUCT):
            continue
        for each, members, methods in classes_of(path.read_text(encoding="utf-8")):
            if members > MEMBERS_MAX:
                found[f"members {name} {each}"] = members
            if methods > METHODS_MAX:
                found[f"methods {name} {each}"] = methods
            headers[scope_of(name) + each] = name
    for each, count in folders.items():
        if count > FOLDER_MAX:
            found[f"folder {each}"] = count
    files = collections.defaultdict(set)
    for path in sources:
        name = path.relative_to(root).as_posix()
        if path.suffix != ".cpp" or not name.startswith(PRODUCT):
            continue
        for match in DEFINITION.finditer(bare(path.read_text(encoding="utf-8"))):
            each = scope_of(name) + match.group(1).rstrip(":")
            if each in headers and headers[each].endswith(".hpp"):
                files[each].add(name)
    for each, names in files.items():
        if len(names) > FILES_MAX:
            found[f"files {headers[each]} {each}"] = len(names)
    return found


def main():
    root = pathlib.Path(sys.argv[1])
    found = figures(root)
    lines = [f"{each} {count}" for each, count in sorted(found.items())]
    if "--list" in sys.argv[2:]:
        print("\n".join(lines))
        return 0
    allowed = {}
    listed = root / "tests/style/classes.txt"
    for line in listed.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            each, count = line.rsplit(" ", 1)
            allowed[each] = int(count)
    limits = {"members": MEMBERS_MAX, "methods": METHODS_MAX, "files": FILES_MAX, "folder": FOLDER_MAX}
    problems = [f"{each}: {count}, at most {allowed.get(each, limits[each.split()[0]])}"
                for each, count in sorted(found.items()) if count > allowed.get(each, 0)]
    problems += [f"{each}: {found.get(each, 'within the limit')} now: lower its line in {listed.name}"
                 for each, count in allowed.items() if found.get(each, 0) < count]
    print("\n".join(problems) or f"{len(allowed)} classes and folders over the limits, none of them grew")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
