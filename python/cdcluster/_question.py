"""Questions about two meshes in many poses."""
from . import _native
from ._mesh import Mesh, doubles
from ._native import InputError

#: The levels of a question, and what each adds.
LEVELS = ("any", "count", "pairs", "contacts", "distance")
_QUATERNIONS = {"xyzw": _native.PoseForm.Xyzw, "wxyz": _native.PoseForm.Wxyz}


def pose_rows(poses, quat_order):
    """The poses as rows of numbers, and their form."""
    rows = doubles(poses, "poses")
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


class Question:
    """Two meshes and a query, as the native module takes them."""

    def __init__(self, a, b, level, *, clearance=None, up_to=None, limit_pairs=0, maps=False, ignore=(),
                 threads=0):
        if level not in LEVELS:
            raise InputError(f"level is {level!r}, not one of {', '.join(LEVELS)}")
        self.a, self.b = (body._mesh if isinstance(body, Mesh) else Mesh(body)._mesh for body in (a, b))
        self.query = {"level": LEVELS.index(level), "clearance": clearance, "up_to": up_to,
                      "limit_pairs": limit_pairs, "maps": maps, "ignore": list(ignore), "threads": threads}
