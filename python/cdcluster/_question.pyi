from collections.abc import Iterable
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._mesh import _Body, Mesh as Mesh, doubles as doubles
from ._native import InputError as InputError

LEVELS: tuple[str, ...]
_Level = Literal["any", "count", "pairs", "contacts"]
_Order = Literal["xyzw", "wxyz"]
_Ignore = Iterable[tuple[str, str]]

def pose_rows(poses: ArrayLike, quat_order: _Order | None) -> tuple[NDArray[np.float64], Any]: ...

class Question:
    a: Any
    b: Any
    query: dict[str, Any]
    def __init__(self, a: _Body, b: _Body, level: str, *, clearance: float | None = ..., up_to: float | None = ...,
                 limit_pairs: int = ..., maps: bool = ..., ignore: _Ignore = ..., threads: int = ...) -> None: ...
