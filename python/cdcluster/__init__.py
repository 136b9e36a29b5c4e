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
import warnings

import numpy as np

from . import _native
from ._native import InputError
from ._toml import toml_text

__all__ = [
    "CopyWarning", "InputError", "Job", "Mesh", "Results", "contacts", "contacts_in_windows",
    "distance", "open", "run",
]
__version__ = _native.version()

#: The levels of a question, and what each adds.
LEVELS = ("any", "count", "pairs", "contacts", "distance")
_QUATERNIONS = {"xyzw": _native.PoseForm.Xyzw, "wxyz": _native.PoseForm.Wxyz}
_KINDS = ("separate", "touch", "cross", "inside", "contact", "undecided", "failed", "near")


class CopyWarning(UserWarning):
    """Poses or coordinates were copied, since they are no float64 in C order."""


def _doubles(values, what):
    """The values as float64 in C order, copied only where they are not."""
    array = np.asarray(values)
    made = np.ascontiguousarray(array, dtype=np.float64)
    if isinstance(values, np.ndarray) and not np.shares_memory(made, array) and array.size:
        warnings.warn(f"{what} of {array.dtype} are copied; float64 in C order is read in place",
                      CopyWarning, stacklevel=3)
    return made


class Mesh:
    """An immutable triangle mesh.

    `Mesh("van.glb")` reads a file; coordinates are multiplied by `factor`. `Mesh(other)` takes any
    object with `vertices` (V, 3) and `faces` (T, 3), as trimesh's and Open3D's have. A mesh keeps its
    tree, which the first question builds, and pickles as its canonical bytes.

    Raises InputError naming the file, and the line, byte or face.
    """

    def __init__(self, source, factor=1.0):
        if isinstance(source, _native.Mesh):
            self._mesh = source
        elif isinstance(source, (str, os.PathLike)):
            self._mesh = _native.Mesh.load(os.fspath(source), float(factor))
        elif hasattr(source, "vertices") and (hasattr(source, "faces") or hasattr(source, "triangles")):
            faces = source.faces if hasattr(source, "faces") else source.triangles
            vertices = np.asarray(source.vertices, dtype=np.float64) * factor
            self._mesh = Mesh.from_arrays(vertices, faces)._mesh
        else:
            raise InputError("a mesh is made of a file's path, or of an object with vertices and faces")

    @staticmethod
    def from_arrays(vertices, faces, parts=()):
        """Makes a mesh of vertices (V, 3) and faces (T, 3), which are vertex numbers.

        `parts` are (name, first triangle, triangle after the last), ascending. Degenerate and repeated
        triangles are kept. Raises InputError naming the first bad vertex, triangle or part.
        """
        xyz = _doubles(vertices, "vertices")
        triangles = np.asarray(faces)
        if xyz.ndim != 2 or xyz.shape[1] != 3:
            raise InputError(f"vertices have the shape {xyz.shape}, not (V, 3)")
        if triangles.ndim != 2 or triangles.shape[1] != 3 or triangles.dtype.kind not in "iu":
            raise InputError(f"faces are {triangles.dtype} of the shape {triangles.shape}, not whole "
                             "numbers of the shape (T, 3)")
        if triangles.size and (triangles.min() < 0 or triangles.max() >= len(xyz)):
            row = int(np.argmax((triangles < 0).any(axis=1) | (triangles >= len(xyz)).any(axis=1)))
            raise InputError(f"face {row} has the vertices {triangles[row].tolist()}; there are {len(xyz)}")
        numbers = np.ascontiguousarray(triangles, dtype=np.uint32)
        return Mesh(_native.Mesh.from_arrays(xyz, numbers, [tuple(part) for part in parts]))

    @property
    def vertices(self):
        """The vertices, (V, 3) float64: a view."""
        return self._mesh.vertices

    @property
    def faces(self):
        """The vertex numbers of the triangles, (T, 3) uint32: a view."""
        return self._mesh.triangles

    @property
    def parts(self):
        """The parts: (name, first triangle, triangle after the last)."""
        return self._mesh.parts

    @property
    def sha256(self):
        """The mesh's identity, in hexadecimal."""
        return self._mesh.sha256

    @property
    def is_closed(self):
        """Whether the surface is closed, so that a body can be inside of it."""
        return self._mesh.is_closed

    def __repr__(self):
        return f"<cdcluster.Mesh of {len(self.faces)} triangles, {self.sha256[:16]}>"

    def __reduce__(self):
        return Mesh, (self._mesh,)


class Job:
    """A job as `cdctl run` takes it: two bodies, scenes, motions or shot lines."""

    def __init__(self, native):
        self._job = native

    @staticmethod
    def from_toml(text, folder="."):
        """Reads the text of a job file; paths in it are relative to `folder`."""
        return Job(_native.Job.from_toml(text, os.fspath(folder)))

    @staticmethod
    def from_file(file):
        """Reads a job file."""
        return Job(_native.Job.from_file(os.fspath(file)))

    @staticmethod
    def from_folder(folder):
        """Takes the job of a results folder, with the inputs that the folder keeps."""
        return Job(_native.Job.from_folder(os.fspath(folder)))

    @property
    def name(self):
        """The job's name; empty without one."""
        return self._job.name


class Results:
    """The answers for scenarios, in arrays of which element i is that of scenario `first` + i.

    A scenario is a pose; in a scene a pair of bodies at a step. Arrays that the question does not
    fill are empty.

    kind (N,) u1: 0 separate, 1 touch, 2 cross, 3 inside, 4 contact, 5 undecided, 6 failed, 7 near.
    count, near_count (N,) u8: pairs in contact, and near ones, also those that a limit cut off.
    offsets (N + 1,) u8, pairs (M, 2) u4, pair_class (M,) u1: the pairs of scenario i are those from
    offsets[i] up to offsets[i + 1]; classes are 1 touch, 2 coplanar, 3 proper, 4 near.
    point_offsets (M + 1,) u8, points (K, 3) f8: the points that each pair shares, in the world.
    pair_distance (M,) f8: of near pairs, at level contacts.
    distance (N,) f8, witness (N, 2) u4, witness_points (N, 2, 3) f8: NaN where there is none.
    step, body_a, body_b (N,): of a scene; bodies are indices of `body_names`.
    motion_end, motion_depth, t0, t1, run_offsets, runs (R, 5): of motions, as in results.npz.
    hit_depth, hit_flags, hit_rank (M,): of shot lines.
    map_a, map_b (T,) u8: with maps, the scenarios in which each triangle is in contact or near.
    failures: reasons, by scenario. digest: SHA-256 over all results.
    """

    def __init__(self, native):
        self._native = native

    def __len__(self):
        return len(self._native)

    @property
    def hit(self):
        """Whether each scenario is in contact, (N,) bool."""
        kind = self._native.kind
        return (kind >= 1) & (kind <= 4)

    def pairs_of(self, scenario):
        """The pairs of a scenario, (m, 2) u4: a view of `pairs`."""
        offsets = self._native.offsets
        if not 0 <= scenario < len(self) or not len(offsets):
            raise IndexError(f"there are no pairs of scenario {scenario} of {len(self)}")
        return self._native.pairs[offsets[scenario]:offsets[scenario + 1]]

    def to_pandas(self):
        """A table with a row for each scenario. Needs pandas."""
        import pandas  # Not needed otherwise.

        native = self._native
        columns = {"scenario": native.first + np.arange(len(self), dtype=np.uint64)}
        if len(native.step):
            names = np.array(native.body_names, dtype=object)
            columns |= {"step": native.step, "body_a": names[native.body_a], "body_b": names[native.body_b]}
        columns |= {"class": np.array(_KINDS, dtype=object)[native.kind], "count": native.count}
        for name in ("near_count", "distance"):
            if len(getattr(native, name)):
                columns[name] = getattr(native, name)
        return pandas.DataFrame(columns)

    def __repr__(self):
        return f"<cdcluster.Results of {len(self)} scenarios, {int(self.hit.sum())} in contact>"


for _name in ("first", "kind", "count", "near_count", "surfaces_only", "offsets", "pairs", "pair_class",
              "point_offsets", "points", "pair_distance", "hit_depth", "hit_flags", "hit_rank", "distance",
              "witness", "witness_points", "step", "body_a", "body_b", "body_names", "motion_end",
              "motion_depth", "t0", "t1", "run_offsets", "runs", "map_a", "map_b", "failures", "digest"):
    setattr(Results, _name, property(lambda self, name=_name: getattr(self._native, name)))


def _pose_rows(poses, quat_order):
    """The poses as rows of numbers, and their form."""
    rows = _doubles(poses, "poses")
    form = {(4, 4): _native.PoseForm.Matrix44, (3, 4): _native.PoseForm.Matrix34}.get(rows.shape[-2:])
    if form is not None and rows.ndim in (2, 3):
        return rows, form
    if rows.ndim in (1, 2) and rows.shape[-1] == 12:
        return rows, _native.PoseForm.Matrix34
    if rows.ndim in (1, 2) and rows.shape[-1] == 7:
        if quat_order not in _QUATERNIONS:
            raise InputError('rows of 7 numbers are x y z and a quaternion: say quat_order="xyzw" or "wxyz"')
        return rows, _QUATERNIONS[quat_order]
    raise InputError(f"poses have the shape {rows.shape}; it is (N, 4, 4), (N, 3, 4), (N, 12) or (N, 7)")


def _ask(a, b, poses, quat_order, progress, **query):
    if query["level"] not in LEVELS:
        raise InputError(f"level is {query['level']!r}, not one of {', '.join(LEVELS)}")
    query["level"] = LEVELS.index(query["level"])
    rows, form = _pose_rows(poses, quat_order)
    native_a, native_b = (body._mesh if isinstance(body, Mesh) else Mesh(body)._mesh for body in (a, b))
    return Results(_native.find_contacts(native_a, native_b, rows, form, query, progress))


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
    return _ask(a, b, poses, quat_order, progress, level=level, clearance=clearance, up_to=None,
                limit_pairs=limit_pairs, maps=maps, ignore=list(ignore), threads=threads)


def distance(a, b, poses, *, quat_order=None, up_to=None, ignore=(), threads=0, progress=None):
    """Finds how far apart two meshes are in each pose, and where: NaN in contact, and beyond `up_to`.

    Arguments and errors are those of `contacts`.
    """
    return _ask(a, b, poses, quat_order, progress, level="distance", clearance=None, up_to=up_to,
                limit_pairs=0, maps=False, ignore=list(ignore), threads=threads)


def contacts_in_windows(a, b, poses, level="pairs", *, rows=65536, quat_order=None, **options):
    """Yields the results of `rows` poses at a time, so that memory stays bounded.

    `poses` may be a memory-mapped array. Options are those of `contacts`. Each of the results has the
    number of its first pose as `first`; its digest and maps are those of the window.
    """
    if rows < 1:
        raise InputError(f"rows is {rows}; at least 1")
    shape = np.shape(poses)
    is_one = len(shape) == 1 or len(shape) == 2 and shape in ((4, 4), (3, 4))
    poses = np.asarray(poses)[None] if is_one else poses
    for first in range(0, len(poses), rows):
        part = contacts(a, b, poses[first:first + rows], level, quat_order=quat_order, **options)
        part._native.first = first
        yield part


def run(job, *, folder=".", out=None, tree_cache=None, threads=0, progress=None):
    """Runs a job as `cdctl run` does: scenes, motions and shot lines, too.

    `job` is the path of a job file, a `Job`, or a dict with the tables of a job file, whose relative
    paths are those in `folder`. With `out` the results are also kept in that folder, where a run that
    was stopped goes on; `cdctl view`, `report` and `diff` read it, and so does `open`.
    """
    if isinstance(job, dict):
        job = Job.from_toml(toml_text(job), folder)
    elif not isinstance(job, Job):
        job = Job.from_file(job)
    return Results(_native.run(job._job, os.fspath(out or ""), os.fspath(tree_cache or ""), threads, progress))


def open(folder):
    """Reads the results of a finished run from its folder."""
    return Results(_native.open(os.fspath(folder)))
