import os
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from numpy.typing import ArrayLike

from ._cluster import Cluster as Cluster, ClusterJob as ClusterJob, Progress as Progress
from ._job import Job as Job
from ._mesh import _Body as _Body, CopyWarning as CopyWarning, Mesh as Mesh
from ._native import IncompleteError as IncompleteError, InputError as InputError, RefusedError as RefusedError, Unreachable as Unreachable
from ._question import _Ignore as _Ignore, LEVELS as LEVELS, _Level as _Level, _Order as _Order, Question as Question, pose_rows as pose_rows
from ._results import Results as Results

__all__ = [
    "Cluster", "ClusterJob", "CopyWarning", "IncompleteError", "InputError", "Job", "Mesh", "Progress",
    "RefusedError", "Results", "Unreachable", "contacts", "contacts_in_windows", "distance", "open", "run",
]
__version__: str

_Path = str | os.PathLike[str]
_Progress = Callable[[int, int], bool | None]

def contacts(a: _Body, b: _Body, poses: ArrayLike, level: _Level = ..., *, quat_order: _Order | None = ...,
             clearance: float | None = ..., limit_pairs: int = ..., maps: bool = ..., ignore: _Ignore = ...,
             threads: int = ..., progress: _Progress | None = ...) -> Results: ...
def distance(a: _Body, b: _Body, poses: ArrayLike, *, quat_order: _Order | None = ..., up_to: float | None = ...,
             ignore: _Ignore = ..., threads: int = ..., progress: _Progress | None = ...) -> Results: ...
def contacts_in_windows(a: _Body, b: _Body, poses: Any, level: _Level = ..., *, rows: int = ...,
                        quat_order: _Order | None = ..., progress: _Progress | None = ...,
                        **options: Any) -> Iterator[Results]: ...
def run(job: _Path | Job | Mapping[str, Any], *, folder: _Path = ..., out: _Path | None = ...,
        tree_cache: _Path | None = ..., threads: int = ..., progress: _Progress | None = ...) -> Results: ...
def open(folder: _Path, *, partial: bool = ...) -> Results: ...
