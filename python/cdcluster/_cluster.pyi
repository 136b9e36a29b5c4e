import os
from collections.abc import Iterator, Mapping
from typing import Any, Literal, NamedTuple

from numpy.typing import ArrayLike

from ._job import Job as Job
from ._mesh import _Body
from ._native import InputError as InputError
from ._question import _Ignore, _Order, Question as Question, pose_rows as pose_rows
from ._results import Results as Results

_Path = str | os.PathLike[str]

class Progress(NamedTuple):
    done: int
    total: int
    rate: float
    state: str
    seconds: float
    reason: str

class ClusterJob:
    id: str
    number: int
    name: str
    owner: str
    priority: int
    def __init__(self, cluster: Any, facts: Any) -> None: ...
    def progress(self) -> Progress: ...
    def watch(self, period: float = ...) -> Iterator[Progress]: ...
    def results(self, *, partial: bool = ...) -> Results: ...
    def set_priority(self, priority: int) -> Progress: ...
    def cancel(self) -> Progress: ...

class Cluster:
    address: str
    def __init__(self, address: str | None = ..., *, credential: _Path | None = ..., insecure: bool = ...,
                 tree_cache: _Path | None = ...) -> None: ...
    def submit(self, a: _Body | Job | Mapping[str, Any], b: _Body | None = ..., poses: ArrayLike | None = ...,
               level: Literal["any", "count", "pairs", "contacts", "distance"] = ..., *,
               quat_order: _Order | None = ..., clearance: float | None = ..., up_to: float | None = ...,
               limit_pairs: int = ..., maps: bool = ..., ignore: _Ignore = ..., name: str = ...,
               folder: _Path = ..., priority: int = ...) -> ClusterJob: ...
    def jobs(self) -> list[ClusterJob]: ...
    def job(self, id: str | int) -> ClusterJob: ...
