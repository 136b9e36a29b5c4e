#!/usr/bin/env python3
"""Proves that the checks of includes and of documents can fail: a tree that breaks each rule is
refused, a clean one passes. Usage: style_test.py"""
import pathlib
import subprocess
import sys
import tempfile

GOOD_SOURCES = {"common/core/a.hpp": "#pragma once\n", "proto/channel/b.cpp": '#include "common/core/a.hpp"\n'}
BAD_SOURCES = {
    "a layer upwards": {"common/core/c.cpp": '#include "proto/codec/b.hpp"\n', "proto/codec/b.hpp": "#pragma once\n"},
    "a program in another": {
        "master/net/m.cpp": '#include "worker/cache/w.hpp"\n',
        "worker/cache/w.hpp": "#pragma once\n",
    },
    "a room upwards": {
        "master/journal/j.cpp": '#include "master/results/r.hpp"\n',
        "master/results/r.hpp": "#pragma once\n",
    },
    "geometry in dispatch": {
        "master/dispatch/d.cpp": '#include "master/geometry/g.hpp"\n',
        "master/geometry/g.hpp": "#pragma once\n",
    },
    "a channel in the client's formats": {
        "client/formats/f.cpp": '#include "proto/channel/c.hpp"\n',
        "proto/channel/c.hpp": "#pragma once\n",
    },
    "a library past its door": {"master/m.cpp": "#include <assimp/scene.h>\n"},
    "Asio past its door": {"worker/w.cpp": "#include <boost/asio/read.hpp>\n"},
    "a file that is not there": {"master/m.cpp": '#include "common/core/none.hpp"\n'},
    "a slow header in a program": {
        "client/c.cpp": '#include "common/tree/t.hpp"\n',
        "common/tree/t.hpp": '#pragma once\n#include "common/pair/numbers/dyadic.hpp"\n',
        "common/pair/numbers/dyadic.hpp": "#pragma once\n",
    },
    "no pragma once": {"common/core/d.hpp": "int x();\n"},
}


GOOD_PAGES = {
    "README.md": "# A page\n\n[Job](docs/job-file.md#the-job)\n\n| a | cell |\n\n```toml\nname = 1\n```\n",
    "docs/job-file.md": "# Job file\n## The job\n| `name`, `unit` | text |\n### A body\n| `unit` | text |\n",
    "ARCHITECTURE.md": "[All](docs/job-file.md)\n",
    "CONTRIBUTING.md": "",
    "client/job.cpp": 'TomlFields job(table, "the job", problem, {"name", "unit"});\n'
                      'TomlFields fields(*table, "[a]", problem, {"unit"});\n',
}
BAD_PAGES = {
    "a long README": {"README.md": 91 * "line\n"},
    "a long page": {"docs/page.md": 161 * "line\n"},
    "a wide line": {"docs/page.md": 101 * "x"},
    "a wide table in README": {"README.md": "| " + 50 * "xx" + " |\n"},
    "a cell that is an essay": {"docs/page.md": "| " + 26 * "word " + "|\n"},
    "a link to no file": {"docs/page.md": "[there](../docs/none.md)\n"},
    "a link to no file in ARCHITECTURE": {"ARCHITECTURE.md": "[there](none.md)\n"},
    "a link to no heading": {"README.md": "[there](docs/job-file.md#nothing)\n"},
    "a job that is no TOML": {"docs/page.md": "```toml\nname = \n```\n"},
    "a key that is explained nowhere": {"client/more.cpp": 'TomlFields f(table, "q", problem, {"level"});\n'},
    "a key that is explained in one of two tables": {
        "docs/job-file.md": "# Job file\n## The job\n| `name`, `unit` | text |\n",
    },
    "a key that the parser does not know": {
        "docs/job-file.md": GOOD_PAGES["docs/job-file.md"] + "| `gone` | text |\n",
    },
    "no parser": {"client/job.cpp": ""},
}


def passes(check, files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        command = [sys.executable, pathlib.Path(__file__).with_name(check), folder]
        return subprocess.run(command, capture_output=True).returncode == 0


def failures_of(check, good, bad):
    if not passes(check, good):
        yield f"{check} refuses a clean tree"
    for name, files in bad.items():
        if passes(check, {**good, **files}):
            yield f"{check} passes: {name}"


failures = [*failures_of("includes.py", GOOD_SOURCES, BAD_SOURCES), *failures_of("documents.py", GOOD_PAGES, BAD_PAGES)]
print("\n".join(failures) or f"{len(BAD_SOURCES) + len(BAD_PAGES)} broken rules were noticed")
sys.exit(1 if failures else 0)
