#!/usr/bin/env python3
"""Proves that the checks of includes, unseen names, documents, classes, callers and the page can fail: a tree that
breaks each rule is refused, a clean one passes. Usage: style_test.py"""
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
GOOD_NAMES = {
    "common/core/a.hpp": "#pragma once\n#define CD_A(x) x\nstruct Thing {\n    int count;\n};\nint twice(int x);\n",
    "common/core/b.hpp": '#pragma once\n#include "common/core/a.hpp"\nenum class Kind { Other };\nstruct Other;\n',
    "common/core/b.cpp": '#include "common/core/b.hpp"\nint f(Thing t) {\n    return CD_A(twice(t.count));\n}\n',
}
BAD_NAMES = {
    "a macro unseen": {"master/m.cpp": "int f() {\n    return CD_A(1);\n}\n"},
    "a type unseen": {"master/m.cpp": "int f() {\n    return sizeof(Thing);\n}\n"},
    "a function unseen": {"tests/t.cpp": "int f() {\n    return twice(1);\n}\n"},
}

GOOD_PAGES = {
    "README.md": "# A page\n\n[Job](docs/job-file.md#the-job)\n\n| a | cell |\n\n```toml\nname = 1\n```\n",
    "docs/job-file.md": "# Job file\n## The job\n| `name`, `unit` | text |\n### A body\n| `unit` | text |\n",
    "docs/job-keys.md": "# More keys\n",
    "ARCHITECTURE.md": "[All](docs/job-file.md)\n",
    "CONTRIBUTING.md": "`Boxes.Touch` and `results.npz`\n",
    "tests/common/tree/box_test.cpp": "TEST_P(Boxes, Touch) {}\n",
    "client/job.cpp": 'TomlFields job(table, "the job", problem, {"name", "unit"});\n'
                      'TomlFields fields(*table, "[a]", problem, {"unit"});\n',
}
BAD_PAGES = {
    "a long README": {"README.md": 91 * "line\n"},
    "a long ARCHITECTURE": {"ARCHITECTURE.md": 121 * "line\n"},
    "a long page": {"docs/page.md": 161 * "line\n"},
    "a wide line in a decision": {"docs/decisions/001-x.md": 101 * "x"},
    "a wide line": {"docs/page.md": 101 * "x"},
    "a wide table in README": {"README.md": "| " + 50 * "xx" + " |\n"},
    "a cell that is an essay": {"docs/page.md": "| " + 26 * "word " + "|\n"},
    "a link to no file": {"docs/page.md": "[there](../docs/none.md)\n"},
    "a link to no file in ARCHITECTURE": {"ARCHITECTURE.md": "[there](none.md)\n"},
    "a link to no heading": {"README.md": "[there](docs/job-file.md#nothing)\n"},
    "a test that does not exist": {"docs/page.md": "`Boxes.Part`\n"},
    "a job that is no TOML": {"docs/page.md": "```toml\nname = \n```\n"},
    "a long page of results": {"bench/peers/RESULTS.md": 61 * "A figure.\n"},
    "a wide line in a page outside docs": {"proto/NOTES.md": 101 * "x" + "\n"},
    "a key that is explained nowhere": {"client/more.cpp": 'TomlFields f(table, "q", problem, {"level"});\n'},
    "a key that is explained in one of two tables": {
        "docs/job-file.md": "# Job file\n## The job\n| `name`, `unit` | text |\n",
    },
    "a key that the parser does not know": {
        "docs/job-file.md": GOOD_PAGES["docs/job-file.md"] + "| `gone` | text |\n",
    },
    "no parser": {"client/job.cpp": ""},
}

GOOD_CLASSES = {
    "common/core/a.hpp": "class A {\n  public:\n    int f(int x) const { return x; }\n  private:\n" + 12 * "    int x_;\n" + "};\n",
    "common/core/a.cpp": "int A::f(int x) {}\n",
    "tests/style/classes.txt": "members common/core/b.hpp B 13\n",
    "common/core/b.hpp": "struct B {\n" + 13 * "    int x = 0;\n" + "    static int y;\n    using Z = int;\n};\n",
}
BAD_CLASSES = {
    "a class with 13 data members": {"master/net/m.hpp": "struct M {\n" + 13 * "    std::map<int, int> x{};\n" + "};\n"},
    "a nested class with 13 data members": {"master/net/m.hpp": "struct M {\n    struct N {\n" + 13 * "        int x;\n" + "    };\n};\n"},
    "a class with 31 methods": {"master/net/m.hpp": "class M {\n" + 31 * "    void f(std::function<void(int)> g);\n" + "};\n"},
    "an offender that grew": {"common/core/b.hpp": "struct B {\n" + 14 * "    int x = 0;\n" + "};\n"},
    "an offender that shrank, under its old figure": {"common/core/b.hpp": "struct B {\n    int x = 0;\n};\n"},
    "a class in two files": {"common/core/a_more.cpp": "void A::g() {}\n"},
    "a folder of 26 files": {f"bench/peers/p{i}.cpp": "" for i in range(26)},
}
GOOD_CALLERS = {
    "common/core/a.hpp": "int twice(int x);\nint alone(int x);\n",
    "common/core/a.cpp": "int twice(int x) {\n    return 2 * x;\n}\nint alone(int x) {\n    return twice(x);\n}\n",
    "tests/style/callers.txt": "alone what a test needs\n",
}
BAD_CALLERS = {
    "a function that nothing calls": {"master/net/m.hpp": "void lonely();\n"},
    "a method that only a test calls": {
        "master/net/m.hpp": "class M {\n    [[nodiscard]] std::map<int, int> lonely() const;\n};\n",
        "tests/t.cpp": "void f() {\n    m.lonely();\n}\n",
    },
    "an exception that is called": {"master/net/m.cpp": "void f() {\n    alone(1);\n}\n"},
    "an exception without a reason": {"tests/style/callers.txt": "alone\n"},
}


GOOD_PAGE = {
    "web/page/src/main.ts": "// A comment may stand here.\nelement.textContent = name;\n",
    "web/page/index.html": '<script type="module" src="app.js"></script>\n',
    "web/page/package.json": '{"dependencies": {"three": "0.187.0"}}',
    "web/page/package-lock.json": '{"packages": {"": {}, "node_modules/three": {"integrity": "sha512-x"}}}',
    "web/page/node_modules/three/three.js": 'fetch("https://away.example")\n',
}
BAD_PAGE = {
    "HTML of text": {"web/page/src/main.ts": "element.innerHTML = name;\n"},
    "HTML of text beside an element": {"web/page/src/main.ts": "e.insertAdjacentHTML('beforeend', name);\n"},
    "HTML in a component": {"web/page/src/a.tsx": "<p dangerouslySetInnerHTML={{ __html: name }} />\n"},
    "code of text": {"web/page/src/main.ts": "eval(name);\n"},
    "a function of text": {"web/page/src/main.ts": "new Function(name)();\n"},
    "an address": {"web/page/src/main.ts": "fetch('https://away.example');\n"},
    "an address without its scheme": {"web/page/src/main.ts": 'fetch("//away.example");\n'},
    "a style from elsewhere": {"web/page/src/a.css": "@import 'more.css';\n"},
    "a style in the HTML": {"web/page/index.html": '<p style="color: red">\n'},
    "a script in the HTML": {"web/page/index.html": "<script>start()</script>\n"},
    "a range of versions": {"web/page/package.json": '{"dependencies": {"three": "^0.187.0"}}'},
    "a lock file that names a registry": {
        "web/page/package-lock.json": '{"packages": {"node_modules/a": {"resolved": "there", "integrity": "x"}}}',
    },
    "a package without a hash": {"web/page/package-lock.json": '{"packages": {"node_modules/a": {}}}'},
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


CHECKS = [
    ("includes.py", GOOD_SOURCES, BAD_SOURCES),
    ("unseen.py", GOOD_NAMES, BAD_NAMES),
    ("documents.py", GOOD_PAGES, BAD_PAGES),
    ("classes.py", GOOD_CLASSES, BAD_CLASSES),
    ("callers.py", GOOD_CALLERS, BAD_CALLERS),
    ("page.py", GOOD_PAGE, BAD_PAGE),
]
failures = [failure for check in CHECKS for failure in failures_of(*check)]
print("\n".join(failures) or f"{sum(len(bad) for _, _, bad in CHECKS)} broken rules were noticed")
sys.exit(1 if failures else 0)
