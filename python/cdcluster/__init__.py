"""Exact contacts between triangle meshes in many rigid poses.

    >>> import numpy as np
    >>> import cdcluster as cd
    >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> a = cd.Mesh.from_arrays(corners, faces)
    >>> poses = np.tile(np.eye(4), (3, 1, 1))
    >>> poses[:, 0, 3] = [0.25, 1, 2]                     # B along x
    >>> found = cd.contacts(a, a, poses)
    >>> found.hit
    array([ True,  True, False])
    >>> found.pairs_of(1).shape[1]
    2

A pose maps B's coordinates into A's frame: x_A = R x_B + t. Answers are exact for the numbers given,
and have the digest that `cdctl run` prints. Arrays of results are views of memory that the results
own; they are read-only.
"""
import os
import shutil

import numpy as np

from . import _native
from ._cluster import Cluster, ClusterJob, Progress
from ._job import Job
from ._mesh import CopyWarning, Mesh
from ._native import IncompleteError, InputError, RefusedError, Unreachable
from ._question import LEVELS, Question, pose_rows
from ._results import Results

__all__ = [
    "Cluster", "ClusterJob", "CopyWarning", "IncompleteError", "InputError", "Job", "Mesh", "Progress",
    "RefusedError", "Results", "Unreachable", "contacts", "contacts_in_windows", "distance", "open", "run",
]
__version__ = _native.version()


def _ask(question, poses, quat_order, progress):
    rows, form = pose_rows(poses, quat_order)
    native, kept = _native.find_contacts(question.a, question.b, rows, form, question.query, progress)

    def save(folder, overwrite):
        _native.save_pair(question.a, question.b, rows, form, question.query, kept, folder, overwrite)

    return Results(native, save)


def contacts(a, b, poses, level="pairs", *, quat_order=None, clearance=None, limit_pairs=0, maps=False,
             ignore=(), threads=0, progress=None):
    """Finds where two meshes touch in each pose of B in A's frame.

    `poses` are (N, 4, 4), (N, 3, 4) or (N, 12), row by row, or (N, 7) with `quat_order`; float64 in C
    order is read in place. Matrices must be rigid within 1e-5. `level` is any, count, pairs or
    contacts. Pairs at most `clearance` apart count as near. `ignore` are pairs of patterns, of parts of
    A and of B. `threads` 0: one for each core. `progress(done, total)` is called some times a second;
    if it returns False, the call ends with InterruptedError, as Ctrl-C ends it with KeyboardInterrupt.

    Raises InputError naming the row of a bad pose, or the option that does not fit.
    """
    question = Question(a, b, level, clearance=clearance, limit_pairs=limit_pairs, maps=maps, ignore=ignore,
                        threads=threads)
    return _ask(question, poses, quat_order, progress)


def distance(a, b, poses, *, quat_order=None, up_to=None, ignore=(), threads=0, progress=None):
    """Finds how far apart two meshes are in each pose, and where: NaN in contact, and beyond `up_to`.

    Arguments and errors are those of `contacts`.
    """
    question = Question(a, b, "distance", up_to=up_to, ignore=ignore, threads=threads)
    return _ask(question, poses, quat_order, progress)


def contacts_in_windows(a, b, poses, level="pairs", *, rows=65536, quat_order=None, progress=None, **options):
    """Yields the results of `rows` poses at a time, so that memory stays bounded.

    `poses` may be a memory-mapped array. Options are those of `contacts`. Each of the results has the
    number of its first pose as `first`, and the maps of its window. The last has the digest over all
    poses, which is that of `contacts` and of `cdctl run`; the digest of those before it is empty.
    """
    if rows < 1:
        raise InputError(f"rows is {rows}; at least 1")
    shape = np.shape(poses)
    is_one = len(shape) == 1 or len(shape) == 2 and shape in ((4, 4), (3, 4))
    poses = np.asarray(poses)[None] if is_one else poses
    question = Question(a, b, level, **options)
    sweep = _native.PoseSweep(question.a, question.b, question.query, progress)
    for first in range(0, len(poses), rows):
        part, form = pose_rows(poses[first:first + rows], quat_order)
        yield Results(sweep.next(part, form, first + rows >= len(poses)))


def run(job, *, folder=".", out=None, tree_cache=None, threads=0, progress=None):
    """Runs a job as `cdctl run` does: scenes, motions and shot lines, too.

    `job` is the path of a job file, a `Job`, or a dict with the tables of a job file, whose relative
    paths are those in `folder`. With `out` the results are also kept in that folder, where a run that
    was stopped goes on; `cdctl view`, `report` and `diff` read it, and so does `open`.
    """
    job = Job.of(job, folder)._job
    native, kept = _native.run(job, os.fspath(out or ""), os.fspath(tree_cache or ""), threads, progress)
    if kept.folder:
        return Results(native, _copy_of(kept.folder))
    return Results(native, lambda folder, overwrite: _native.save_run(job, kept, folder, overwrite))


def open(folder, *, partial=False):
    """Reads the results of a finished run from its folder.

    Raises IncompleteError if scenarios have no result, unless `partial` is set: then `index` tells which
    the arrays have.
    """
    native = _native.open(os.fspath(folder))
    if not native.digest and not partial:
        raise IncompleteError(f"{os.fspath(folder)} has the results of {len(native)} scenarios, and not of all; "
                              "open(folder, partial=True) reads these")
    return Results(native, _copy_of(folder))


def _copy_of(source):
    """A function that copies a results folder."""
    source = os.path.abspath(source)

    def save(folder, overwrite):
        if os.path.abspath(folder) == source:
            return
        if os.path.exists(folder) and os.listdir(folder):
            if not overwrite:
                raise InputError(f"{folder} is not empty; overwrite=True replaces it")
            shutil.rmtree(folder)
        shutil.copytree(source, folder, dirs_exist_ok=True)

    return save
