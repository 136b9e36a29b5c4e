#!/usr/bin/env python3
"""Proves that the check of includes can fail: a tree that breaks each rule is refused, a clean one passes.
Usage: style_test.py"""
import pathlib
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).with_name("includes.py")
GOOD = {"common/core/a.hpp": "#pragma once\n", "proto/b.cpp": '#include "common/core/a.hpp"\n'}
BAD = {
    "a layer upwards": {"common/core/c.cpp": '#include "proto/b.hpp"\n', "proto/b.hpp": "#pragma once\n"},
    "a program in another": {"master/m.cpp": '#include "worker/w.hpp"\n', "worker/w.hpp": "#pragma once\n"},
    "a library past its door": {"master/m.cpp": "#include <assimp/scene.h>\n"},
    "Asio past its door": {"worker/w.cpp": "#include <boost/asio/read.hpp>\n"},
    "a file that is not there": {"master/m.cpp": '#include "common/core/none.hpp"\n'},
    "a slow header in a program": {
        "client/c.cpp": '#include "common/tree/t.hpp"\n',
        "common/tree/t.hpp": '#pragma once\n#include "common/geometry/dyadic.hpp"\n',
        "common/geometry/dyadic.hpp": "#pragma once\n",
    },
    "no pragma once": {"common/core/d.hpp": "int x();\n"},
}


def verdict(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return subprocess.run([sys.executable, CHECK, folder], capture_output=True).returncode


failures = [] if verdict(GOOD) == 0 else ["a clean tree is refused"]
failures += [f"passes: {name}" for name, files in BAD.items() if verdict({**GOOD, **files}) == 0]
print("\n".join(failures) or f"{len(BAD)} broken rules were noticed")
sys.exit(1 if failures else 0)
