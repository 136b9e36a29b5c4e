"""Bodies, poses and jobs for the tests of the package."""
import numpy as np


def torus(around=48, across=24, radius=2.0, tube=0.7):
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    angle, turn = 2 * np.pi * u / around, 2 * np.pi * v / across
    distance = radius + tube * np.cos(turn)
    vertices = np.stack([distance * np.cos(angle), distance * np.sin(angle), tube * np.sin(turn)], -1)
    number = lambda i, j: (i % around) * across + j % across
    faces = np.concatenate([
        np.stack([number(u, v), number(u + 1, v), number(u + 1, v + 1)], -1).reshape(-1, 3),
        np.stack([number(u, v), number(u + 1, v + 1), number(u, v + 1)], -1).reshape(-1, 3)])
    return vertices.reshape(-1, 3), faces


def rotations(count, seed=1):
    q = np.random.default_rng(seed).normal(size=(count, 4))
    return q / np.linalg.norm(q, axis=1)[:, None]


def poses(count, seed=1, reach=4.0):
    """Rows x y z qw qx qy qz."""
    t = np.random.default_rng(seed + 1).uniform(-reach, reach, (count, 3))
    return np.concatenate([t, rotations(count, seed)], axis=1)


def matrices(rows):
    w, x, y, z = rows[:, 3:].T
    m = np.tile(np.eye(4), (len(rows), 1, 1))
    m[:, :3, :3] = np.moveaxis(np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]), 2, 0)
    m[:, :3, 3] = rows[:, :3]
    return m


def write_obj(path, mesh):
    with open(path, "w") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in mesh.vertices.tolist())
        file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in mesh.faces.tolist())


def write_steps(path):
    """The steps of SCENE."""
    path.write_text("step,body,x\n" + "".join(
        f"{step},car.{car},{3.0 * car - step}\n" for step in range(4) for car in range(3)))


SCENE = {
    "bodies": {"car": {"mesh": "body.obj", "count": 3},
               "wall": {"mesh": "body.obj", "pose": [0, 0, 0, 0, 0, 0, 1], "quat_order": "xyzw"}},
    "poses": {"file": "steps.csv"},
    "query": {"level": "pairs"},
}
MOTION = {
    "a": {"mesh": "body.obj"}, "b": {"mesh": "body.obj"},
    "poses": {"line": {"from": [8, 0.1, 0.2], "to": [-8, 0, 0]}},
    "motion": {"resolution": 0.01}, "query": {"level": "pairs"},
}
SHOTS = {
    "a": {"mesh": "body.obj"}, "query": {"level": "pairs"},
    "shots": {"spacing": 0.25, "azimuth_deg": [0, 90, 2], "elevation_deg": [0, 45, 2]},
}
SCENE_SHOTS = {
    "bodies": SCENE["bodies"], "poses": SCENE["poses"], "query": {"level": "pairs"},
    "shots": {"spacing": 0.5, "tile": 8, "azimuth_deg": [0, 90, 2]},
}
