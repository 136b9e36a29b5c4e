#!/usr/bin/env python3
"""Checks every #include against the table of layers (CONTRIBUTING.md): who may include whom, and which
folder is the door to which library; and that headers which are slow to compile reach few files of
the programs. Usage: includes.py REPOSITORY"""
import pathlib
import re
import sys

# A room is one of these folders with all below it that is no room of its own. It may include its own
# files and those of the rooms named here; everything outside common/ may also include all of common/.
LAYERS = {
    "common/core": [],
    "common/geometry": ["common/core"],
    "common/pair": ["common/core", "common/geometry"],
    "common/distance": ["common/core", "common/geometry", "common/pair"],
    "common/shots": ["common/core", "common/distance", "common/geometry", "common/pair", "common/tree"],
    "common/tree": ["common/core", "common/geometry", "common/pair"],
    "common/search": ["common/core", "common/distance", "common/geometry", "common/pair", "common/tree"],
    "common/motion": ["common/core", "common/geometry", "common/pair", "common/search", "common/tree"],
    "common/solid": ["common/core", "common/distance", "common/geometry", "common/pair", "common/search", "common/tree"],
    "common/job": ["common/core", "common/distance", "common/geometry", "common/motion", "common/pair", "common/search", "common/shots", "common/solid", "common/tree"],
    "common/scene": ["common/core", "common/geometry", "common/job", "common/motion", "common/tree"],
    "proto/identity": [],
    "proto/messages": ["proto/identity"],
    "proto/codec": ["proto/identity", "proto/messages"],
    "proto/channel": ["proto/codec", "proto/identity", "proto/messages"],
    "proto/access": ["proto/channel", "proto/codec", "proto/identity", "proto/messages"],
    "web/status": ["proto/identity", "proto/messages"],
    "web/server": ["proto/channel", "proto/messages", "web/status"],
}
# The rooms of a program, lowest first: each may include those before it, and of proto/ or web/ what
# is named.
ORDERED = {
    "master": {
        "base": ["channel"],
        "identity": ["access", "channel", "codec", "identity", "messages"],
        "geometry": ["messages"],
        "blocks": ["access", "channel", "messages"],
        "journal": ["messages"],
        "workers": ["channel", "codec", "messages"],
        "dispatch": ["messages"],
        "submission": ["messages"],
        "compute": ["channel", "messages"],
        "jobs": ["channel", "messages"],
        "verify": ["messages"],
        "results": ["messages"],
        "coordinator": ["channel", "messages"],
        "page": ["channel", "codec", "messages", "web/server"],
        "net": ["access", "channel", "codec", "messages", "web/server", "web/status"],
        "": ["channel"],
    },
    "worker": {
        "cache": ["messages"],
        "peers": ["access", "channel"],
        "execution": ["channel", "messages"],
        "session": ["channel", "codec", "messages"],
        "membership": ["access", "channel"],
        "": ["access", "channel"],
    },
    "client": {
        "base": ["messages"],
        "formats": [],
        "groups": [],
        "picture": [],
        "import": [],
        "bundle": [],
        "curves": [],
        "demo": [],
        "spec": ["messages"],
        "trees": [],
        "poses": [],
        "scene": [],
        "report": ["messages", "web/status"],
        "export": ["web/status"],
        "job": ["messages"],
        "cli": [],
        "local": [],
        "remote": ["access", "channel", "messages", "web/server", "web/status"],
        "folder": ["messages", "web/status"],
        "cluster": ["messages", "web/status"],
        "compare": ["messages", "web/status"],
        "view": ["channel", "messages", "web/server", "web/status"],
        "document": ["messages", "web/server", "web/status"],
        "commands": ["messages", "web/server", "web/status"],
        "": [],
    },
}
# NARROW restricts these rooms to fewer includes than their place in the order allows.
NARROW = {"master/dispatch": ["master/base", "proto/messages"]}
for _program, _rooms in ORDERED.items():
    _before = []
    for _room, _proto in _rooms.items():
        _name = f"{_program}/{_room}".rstrip("/")
        _outside = [each if "/" in each else f"proto/{each}" for each in _proto]
        LAYERS[_name] = NARROW.get(_name, [*_before, *_outside])
        _before.append(_name)


LAYERS["library"] = [room for room in LAYERS if room.startswith("client/") and room != "client/commands"]
LAYERS["python"] = ["library", *LAYERS["library"], "proto/messages", "web/status"]


def room_of(path):
    """The longest room that the path is in; None outside all rooms."""
    folder = path
    while "/" in folder:
        folder = folder.rsplit("/", 1)[0]
        if folder in LAYERS:
            return folder
    return None


# A library may be included only from these files (prefixes of paths).
DOORS = {
    r"Eigen/": ["common/geometry", "common/pair", "common/distance", "common/shots", "common/tree", "common/search", "common/solid", "common/job", "client"],
    r"openssl/": ["common/core/files/hash.cpp", "proto/identity/openssl.hpp", "proto/identity/certificate.cpp", "proto/channel/tls.cpp", "proto/channel/stream.cpp"],
    r"sqlite3\.h": ["master/journal/journal_database.cpp"],
    r"xxhash\.h": ["common/core/files/hash.cpp"],
    r"zstd\.h": ["common/core/files/compress.cpp"],
    r"spdlog/": ["common/core/host/log.cpp"],
    r"fmt/": ["common/core/host/log.hpp", "common/core/host/log_style.cpp", "common/core/words.cpp", "client", "web"],
    r"boost/asio": ["proto/channel/asio.hpp", "proto/channel/asio_tls.hpp"],
    r"boost/multiprecision": ["common/pair/numbers", "common/tree/build/triangle_cells"],
    r"boost/container": ["common/core/growing_list.hpp", "master/blocks/block_index.hpp"],
    r"boost/": ["proto", "common/pair/numbers"],
    r"cereal/": ["proto"],
    r"assimp/": ["client/import/foreign/assimp"],
    r"png\.h": ["client/picture/image.cpp"],
    r"zip\.h": ["client/formats/npz.cpp", "client/formats/zip_file"],
    r"pugixml": ["client/import/foreign/xml"],
    r"expat\.h": ["client/poses/fcd_xml.cpp"],
    r"zlib\.h": ["client"],
    r"hdf5\.h": ["client/formats/h5.cpp"],
    r"CLI/": ["common/core/host/daemon_options.cpp", "common/core/host/man_page.cpp", "master/config.cpp", "worker/config.cpp", "client"],
    r"toml\+\+/": ["common/core/host/config_file.cpp", "client"],
    r"nlohmann/": ["client", "web"],
    r"pybind11/": ["python"],
    r"hwy/": ["common/geometry", "common/pair", "common/distance", "common/scene", "common/shots", "common/tree", "common/search/contact_pair"],
    r"fcl/": [],
}
# So many .cpp files of the programs and of proto/ may see these, through any number of headers. Each
# costs its compiler time in every file; values that programs need have headers of their own.
SLOW_HEADERS = {"common/tree/wide/wide_kernel.hpp": 21, "common/pair/numbers/dyadic.hpp": 0}
PROGRAMS = ("proto/", "web/", "master/", "worker/", "client/", "library/", "python/")
ANYWHERE = ("tests/", "bench/")  # May include everything of ours and any library.
SOURCES = {".cpp", ".hpp", ".h"}


def may_include_ours(path, included):
    room, target = room_of(path), room_of(included)
    if room is None or target is None:
        return path.rsplit("/", 1)[0] == included.rsplit("/", 1)[0]
    return target == room or target in LAYERS[room] or target.startswith("common/") and not room.startswith("common/")


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
        for folder in ("common", "proto", "web", "master", "worker", "client", "library", "python", "tests", "bench")
        for p in (root / folder).rglob("*")
        if p.suffix in SOURCES
    )
    found = [problem for path in files for problem in problems_of(root, path)]
    found += leaks_of(root, files)
    print("\n".join(found) or f"{len(files)} files keep to the layers")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
