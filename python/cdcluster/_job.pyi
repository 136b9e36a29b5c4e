import os
from collections.abc import Mapping
from typing import Any

from ._toml import toml_text as toml_text

_Path = str | os.PathLike[str]

class Job:
    def __init__(self, native: Any) -> None: ...
    @staticmethod
    def from_toml(text: str, folder: _Path = ...) -> Job: ...
    @staticmethod
    def from_file(file: _Path) -> Job: ...
    @staticmethod
    def from_folder(folder: _Path) -> Job: ...
    @property
    def name(self) -> str: ...
    @staticmethod
    def of(job: _Path | Job | Mapping[str, Any], folder: _Path = ...) -> Job: ...
