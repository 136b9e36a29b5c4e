#!/usr/bin/env python3
"""Checks every #include against the table of layers (CONTRIBUTING.md): who may include whom, and which
folder is the door to which library; and that headers which are slow to compile reach few files of
the programs. Usage: includes.py REPOSITORY"""
import pathlib
import re
import sys

# A folder may include its own files and those of the folders named here.
LAYERS = {
    "common/core": [],
    "common/geometry": ["common/core"],
    "common/tree": ["common/core", "common/geometry"],
    "common/job": ["common/core", "common/geometry", "common/tree"],
    "proto": ["common"],
    "master": ["common", "proto"],
    "worker": ["common", "proto"],
    "client": ["common", "proto"],
}

# A library may be included only from these files (prefixes of paths).
DOORS = {
    r"Eigen/": ["common/geometry", "common/tree", "common/job", "client"],
    r"openssl/": ["common/core/hash.cpp", "proto/openssl.hpp", "proto/certificate.cpp", "proto/tls.cpp", "proto/stream.cpp"],
    r"sqlite3\.h": ["master/journal_database.cpp"],
    r"xxhash\.h": ["common/core/hash.cpp"],
    r"zstd\.h": ["common/core/compress.cpp"],
    r"spdlog/": ["common/core/log.cpp"],
    r"fmt/": ["common/core/log.hpp", "client"],
    r"boost/asio": ["proto/asio.hpp", "proto/asio_tls.hpp"],
    r"boost/multiprecision": ["common/geometry", "common/tree"],
    r"boost/": ["proto", "common/geometry", "common/tree"],
    r"cereal/": ["proto"],
    r"assimp/": ["client/import/assimp"],
    r"zip\.h": ["client/npz.cpp", "client/zip_file"],
    r"pugixml": ["client/import/xml"],
    r"zlib\.h": ["client"],
    r"CLI/": ["common/core/daemon_options.cpp", "master/config.cpp", "worker/config.cpp", "client"],
    r"toml\+\+/": ["common/core/daemon_options.cpp", "client"],
    r"nlohmann/": ["client"],
    r"hwy/": ["common/geometry", "common/tree"],
    r"fcl/": [],
}
# So many .cpp files of the programs and of proto/ may see these, through any number of headers. Each
# costs its compiler time in every file; values that programs need have headers of their own.
SLOW_HEADERS = {"common/tree/wide_kernel.hpp": 21, "common/geometry/dyadic.hpp": 0}
PROGRAMS = ("proto/", "master/", "worker/", "client/")
ANYWHERE = ("tests/", "bench/")  # May include everything of ours and any library.
SOURCES = {".cpp", ".hpp", ".h"}


def may_include_ours(path, included):
    own = path.rsplit("/", 1)[0] + "/"
    for layer, allowed in LAYERS.items():
        if path.startswith(layer + "/"):
            return included.startswith((layer + "/", *(a + "/" for a in allowed)))
    return included.startswith(own)


def problems_of(root, path):
    text = (root / path).read_text(encoding="utf-8")
    # Headers that are compiled once for each SIMD target have Highway's guard instead.
    guards = ("#pragma once", "defined(HWY_TARGET_TOGGLE)")
    if path.endswith(".hpp") and not any(guard in text for guard in guards):
        yield f"{path}:1: a header without #pragma once"
    for number, line in enumerate(text.splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if not match:
            continue
        quoted, included = match.group(1) == '"', match.group(2)
        place = f"{path}:{number}"
        if quoted and not (root / included).is_file():
            yield f'{place}: "{included}" is no file, named from the root of the repository'
        elif quoted and not path.startswith(ANYWHERE) and not may_include_ours(path, included):
            yield f'{place}: "{included}" is not of this layer or one below'
        elif not quoted and not path.startswith(ANYWHERE):
            for library, doors in DOORS.items():
                if re.match(library, included):
                    if not path.startswith(tuple(doors)):
                        yield f"{place}: <{included}> enters only through {', '.join(doors)}"
                    break


def seen_from(root, path, known):
    """All files of ours that a file includes, directly or not, itself among them."""
    waiting, seen = [path], set()
    while waiting:
        each = waiting.pop()
        if each not in seen and (root / each).is_file():
            seen.add(each)
            if each not in known:
                text = (root / each).read_text(encoding="utf-8")
                known[each] = re.findall(r'^\s*#\s*include\s*"([^"]+)"', text, re.MULTILINE)
            waiting += known[each]
    return seen


def leaks_of(root, files):
    known = {}
    seen = [seen_from(root, f, known) for f in files if f.startswith(PROGRAMS) and f.endswith(".cpp")]
    for header, files_max in SLOW_HEADERS.items():
        count = sum(header in each for each in seen)
        if count > files_max:
            yield f"{header}:1: is seen by {count} .cpp files of the programs, {files_max} at most may"


def main():
    root = pathlib.Path(sys.argv[1])
    files = sorted(
        p.relative_to(root).as_posix()
        for folder in ("common", "proto", "master", "worker", "client", "tests", "bench")
        for p in (root / folder).rglob("*")
        if p.suffix in SOURCES
    )
    found = [problem for path in files for problem in problems_of(root, path)]
    found += leaks_of(root, files)
    print("\n".join(found) or f"{len(files)} files keep to the layers")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
