"""Writes the tables of a job as TOML."""
import os

import numpy as np

from ._native import InputError


def _value(value, key):
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (str, os.PathLike)):
        escaped = "".join(f"\\u{ord(c):04x}" if ord(c) < 32 or ord(c) == 127 else c
                          for c in os.fspath(value).replace("\\", "\\\\").replace('"', '\\"'))
        return f'"{escaped}"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_value(str(k), k)} = {_value(v, k)}" for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(_value(each, key) for each in value) + "]"
    raise InputError(f"the job's {key} is a {type(value).__name__}, which no job file can have")


def toml_text(job):
    """The text of a job file with these tables, a dict of dicts and of values."""
    lines = [f"{_value(key, key)} = {_value(value, key)}" for key, value in job.items()
             if not isinstance(value, dict)]
    for name, table in job.items():
        if isinstance(table, dict):
            lines.append(f"[{_value(name, name)}]")
            lines += [f"{_value(key, key)} = {_value(value, key)}" for key, value in table.items()]
    return "\n".join(lines) + "\n"
