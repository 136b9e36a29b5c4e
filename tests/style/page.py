#!/usr/bin/env python3
"""Checks the page's sources: no HTML or code is made of text, no address leads out, no style or script stands
in the HTML (the page's policy forbids them), and the lock file names no registry. Usage: page.py REPOSITORY"""
import json
import pathlib
import re
import sys

SUFFIXES = {".ts", ".tsx", ".css", ".html", ".js"}
FORBIDDEN = [
    (r"\b(inner|outer)HTML\b|insertAdjacentHTML|dangerouslySetInnerHTML|srcdoc", "makes HTML of text"),
    (r"document\.write|createContextualFragment|DOMParser", "makes HTML of text"),
    (r"\beval\s*\(|new\s+Function\b|\bset(Timeout|Interval)\s*\(\s*[\"'`]", "makes code of text"),
    (r"[\"'`]//", "has a string that begins with //"),
    (r"https?:", "has an address"),
    (r"\burl\(\s*(?![\"']?data:)", "loads a file from a style sheet"),
    (r"@import", "loads a style sheet"),
]
IN_HTML = [
    (r"<style|\sstyle=", "has a style in the HTML"),
    (r"<script(?![^>]*\ssrc=)|\son[a-z]+=", "has a script in the HTML"),
]


def sources(root):
    page = root / "web" / "page"
    for path in sorted(page.rglob("*")):
        if "node_modules" not in path.parts and path.suffix in SUFFIXES and path.is_file():
            yield path


def problems_of_source(root, path):
    text = path.read_text(encoding="utf-8")
    for pattern, what in FORBIDDEN + (IN_HTML if path.suffix == ".html" else []):
        for found in re.finditer(pattern, text):
            line = text.count("\n", 0, found.start()) + 1
            yield f"{path.relative_to(root)}:{line}: {what}: {found.group(0)}"


def problems_of_packages(root):
    folder = root / "web" / "page"
    wanted = json.loads((folder / "package.json").read_text(encoding="utf-8"))
    for kind in ("dependencies", "devDependencies"):
        for name, version in wanted.get(kind, {}).items():
            if not re.fullmatch(r"\d+\.\d+\.\d+", version):
                yield f"web/page/package.json: {name} has no exact version: {version}"
    locked = json.loads((folder / "package-lock.json").read_text(encoding="utf-8"))
    for name, package in locked["packages"].items():
        if "resolved" in package:
            yield f"web/page/package-lock.json: {name} names where it was got"
        if name and "integrity" not in package:
            yield f"web/page/package-lock.json: {name} has no hash"


def main():
    root = pathlib.Path(sys.argv[1])
    problems = [problem for path in sources(root) for problem in problems_of_source(root, path)]
    problems += problems_of_packages(root)
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
