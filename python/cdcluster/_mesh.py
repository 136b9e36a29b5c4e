"""Meshes, and arrays of numbers that the engine reads in place."""
import os
import warnings

import numpy as np

from . import _native
from ._native import InputError


class CopyWarning(UserWarning):
    """Poses or coordinates were copied, since they are no float64 in C order."""


def doubles(values, what):
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
        xyz = doubles(vertices, "vertices")
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
