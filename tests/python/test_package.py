"""Proves what the Python package promises: the program's digests, views without copies, errors that
name rows, calls that end on Ctrl-C, and jobs of every kind."""
import concurrent.futures
import doctest
import gc
import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import types

import numpy as np
import pytest

import cdcluster as cd

CDCTL = os.environ["CDCTL"]


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


@pytest.fixture(scope="module")
def body():
    return cd.Mesh.from_arrays(*torus())


def write_obj(path, mesh):
    with open(path, "w") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in mesh.vertices.tolist())
        file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in mesh.faces.tolist())


def digest_of_program(folder, job):
    (folder / "job.toml").write_text(job)
    subprocess.run([CDCTL, "run", "job.toml", "--out", "by-program", "--overwrite", "--quiet", "--tree-cache", "off"],
                   cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return json.loads((folder / "by-program/summary.json").read_text())["digest"]


@pytest.mark.parametrize("level", cd.LEVELS)
def test_digests_are_those_of_the_program(level, body, tmp_path):
    write_obj(tmp_path / "body.obj", body)
    rows = poses(400)
    np.save(tmp_path / "poses.npy", rows)
    job = ('[a]\nmesh = "body.obj"\n[b]\nmesh = "body.obj"\n[poses]\nfile = "poses.npy"\nquat_order = "wxyz"\n'
           f'[query]\nlevel = "{level}"\n')
    wanted = digest_of_program(tmp_path, job)
    mesh = cd.Mesh(tmp_path / "body.obj")
    ask = cd.distance if level == "distance" else lambda *a, **k: cd.contacts(*a, level=level, **k)
    results = ask(mesh, mesh, rows, quat_order="wxyz")
    assert results.digest == wanted
    assert cd.run(tmp_path / "job.toml").digest == wanted
    assert cd.open(tmp_path / "by-program").digest == wanted
    assert len(results) == 400 and 0 < results.hit.sum() < 400
    assert len(results.pairs) == (results.offsets[-1] if len(results.offsets) else 0)


def test_all_forms_of_poses_give_the_same_contacts(body):
    rows = poses(100)
    wanted = cd.contacts(body, body, rows, quat_order="wxyz")
    square = matrices(rows)
    for each in (square, square[:, :3], square[:, :3].reshape(-1, 12)):
        found = cd.contacts(body, body, np.ascontiguousarray(each))
        assert (found.hit == wanted.hit).all()
    xyzw = np.concatenate([rows[:, :3], rows[:, 4:], rows[:, 3:4]], axis=1)
    assert cd.contacts(body, body, xyzw, quat_order="xyzw").digest == wanted.digest
    assert len(cd.contacts(body, body, np.eye(4))) == 1


def test_arrays_are_read_only_views_that_keep_their_memory(body):
    results = cd.contacts(body, body, poses(50), quat_order="wxyz", level="contacts")
    address = results.pairs.ctypes.data
    assert results.pairs.ctypes.data == address and results.pairs_of(3).base is not None
    assert not results.pairs.flags.owndata and not results.points.flags.writeable
    first = int(results.offsets[np.argmax(results.hit)])
    part = results.pairs_of(int(np.argmax(results.hit)))
    assert part.ctypes.data == address + 8 * first
    kept = results.pairs
    copy = kept.copy()
    del results
    gc.collect()
    assert (kept == copy).all()
    assert body.vertices.ctypes.data == body.vertices.ctypes.data
    vertices = cd.Mesh.from_arrays(*torus()).vertices  # The mesh itself is gone.
    gc.collect()
    assert (vertices == torus()[0]).all()


def test_poses_are_copied_only_where_they_must_be_and_it_is_said(body):
    rows = poses(20)
    import warnings
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cd.contacts(body, body, rows, quat_order="wxyz")
        cd.contacts(body, body, rows.tolist(), quat_order="wxyz")
    with pytest.warns(cd.CopyWarning, match="float64 in C order"):
        cd.contacts(body, body, np.asfortranarray(rows), quat_order="wxyz")
    with pytest.warns(cd.CopyWarning, match="float32"), pytest.raises(cd.InputError, match="row 0.*R'R"):
        skewed = matrices(rows).astype(np.float32)
        skewed[:, 0, 0] += 1e-4
        cd.contacts(body, body, skewed)


def test_errors_name_what_is_wrong(body, tmp_path):
    rows = poses(5)
    rows[3, 3:] = 0
    with pytest.raises(cd.InputError, match="row 3"):
        cd.contacts(body, body, rows, quat_order="wxyz")
    for wrong, words in ((np.zeros((2, 7)), "quat_order"), (np.zeros((2, 5)), r"\(2, 5\)")):
        with pytest.raises(cd.InputError, match=words):
            cd.contacts(body, body, wrong)
    with pytest.raises(cd.InputError, match="level"):
        cd.contacts(body, body, np.eye(4), level="all")
    with pytest.raises(cd.InputError, match="maps"):
        cd.contacts(body, body, np.eye(4), level="any", maps=True)
    with pytest.raises(cd.InputError, match="face 0 has the vertices"):
        cd.Mesh.from_arrays([[0, 0, 0]], [[0, 0, -1]])
    with pytest.raises(cd.InputError, match="shape"):
        cd.Mesh.from_arrays([[0, 0]], [[0, 0, 0]])
    with pytest.raises(cd.InputError, match="path"):
        cd.Mesh(5)
    with pytest.raises(cd.InputError, match="none.obj: no such file"):
        cd.Mesh(tmp_path / "none.obj")
    with pytest.raises(FileNotFoundError, match="nothing"):
        cd.open(tmp_path / "nothing")
    with pytest.raises(FileNotFoundError, match="no.toml"):
        cd.run(tmp_path / "no.toml")
    (tmp_path / "bad.obj").write_text("f 1 2 3\n")
    with pytest.raises(ValueError, match="bad.obj:1"):
        cd.Mesh(str(tmp_path / "bad.obj"))
    with pytest.raises(cd.InputError, match="job.toml:"):
        cd.run({"a": {"mesh": "x.obj"}, "bogus": 1}, folder=tmp_path)
    with pytest.raises(cd.InputError, match="a set"):
        cd.run({"a": {"mesh": {1}}})
    with pytest.raises(IndexError):
        cd.contacts(body, body, np.eye(4)).pairs_of(1)


def test_parts_are_ignored_by_pattern(body):
    half = len(body.faces) // 2
    parts = [("front", 0, half), ("back", half, len(body.faces))]
    mesh = cd.Mesh.from_arrays(body.vertices, body.faces, parts)
    assert mesh.parts == parts
    results = cd.contacts(mesh, mesh, poses(50), quat_order="wxyz", ignore=[("front", "*")], maps=True)
    assert results.pairs[:, 0].min() >= half
    assert results.map_a[:half].sum() == 0 and results.map_a.sum() > 0


def test_meshes_of_other_libraries_and_processes(body):
    class Trimesh:
        vertices, faces = torus()

    other = types.SimpleNamespace(vertices=torus()[0], triangles=torus()[1])  # As Open3D has it.
    rows = poses(30)
    wanted = cd.contacts(body, body, rows, quat_order="wxyz").digest
    assert cd.contacts(Trimesh(), other, rows, quat_order="wxyz").digest == wanted
    again = pickle.loads(pickle.dumps(body))
    assert again.sha256 == body.sha256 and again.is_closed
    with concurrent.futures.ProcessPoolExecutor(2) as pool:
        tasks = [pool.submit(digest_in_process, body, rows) for _ in range(4)]
        assert {task.result() for task in tasks} == {wanted}


def digest_in_process(mesh, rows):
    return cd.contacts(mesh, mesh, rows, quat_order="wxyz", threads=2).digest


def test_many_threads_ask_at_once(body):
    rows = poses(200)
    wanted = cd.contacts(body, body, rows, quat_order="wxyz").digest
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        tasks = [pool.submit(digest_in_process, body, rows) for _ in range(24)]
        assert {task.result() for task in tasks} == {wanted}


def test_windows_keep_memory_bounded(body, tmp_path):
    """A million poses from a mapped file, whose results would take a few times their share."""
    count = 1_000_000
    mapped = np.lib.format.open_memmap(tmp_path / "poses.npy", "w+", np.float64, (count, 7))
    for first in range(0, count, 100_000):
        mapped[first:first + 100_000] = poses(100_000, seed=first, reach=60)
    mapped.flush()
    seen = hits = 0
    peak_before = peak_bytes()
    for part in cd.contacts_in_windows(body, body, mapped, "any", rows=50_000, quat_order="wxyz"):
        assert part.first == seen
        seen += len(part)
        hits += int(part.hit.sum())
    assert seen == count and hits > 0
    assert peak_bytes() - peak_before < 200e6
    few = list(cd.contacts_in_windows(body, body, poses(10), rows=4, quat_order="wxyz"))
    assert [len(part) for part in few] == [4, 4, 2]
    whole = cd.contacts(body, body, poses(10), quat_order="wxyz")
    assert np.array_equal(np.concatenate([part.pairs for part in few]), whole.pairs)


def peak_bytes():
    with open("/proc/self/status") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith("RssAnon"))


LONG = """
import sys, numpy as np, cdcluster as cd
sys.path.insert(0, {tests!r})
import test_package as t
body = cd.Mesh.from_arrays(*t.torus(200, 100))
rows = t.poses(200_000, reach=1)
cd.contacts(body, body, rows[:10], quat_order="wxyz")
print("begins", flush=True)
try:
    cd.contacts(body, body, rows, level="contacts", quat_order="wxyz")
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def test_ctrl_c_ends_a_call_with_keyboard_interrupt():
    process = subprocess.Popen([sys.executable, "-B", "-c", LONG.format(tests=os.path.dirname(__file__))],
                               stdout=subprocess.PIPE, text=True)
    try:
        assert process.stdout.readline() == "begins\n"
        time.sleep(0.5)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        # The whole call takes minutes.
        assert process.stdout.readline() == "interrupted\n"
        print(f"Ctrl-C took {1000 * (time.monotonic() - begin):.0f} ms")
        assert process.wait(20) == 0
    finally:
        process.kill()


def test_progress_is_told_and_stops_a_call(body):
    told = []
    rows = poses(60_000)

    def progress(done, total):
        told.append((done, total))
        return len(told) < 2

    with pytest.raises(InterruptedError):
        cd.contacts(body, body, rows, level="contacts", quat_order="wxyz", progress=progress)
    assert len(told) == 2 and told[0][1] == 60_000
    with pytest.raises(ZeroDivisionError):
        cd.contacts(body, body, rows, level="contacts", quat_order="wxyz", progress=lambda done, total: 1 / 0)
    assert len(cd.contacts(body, body, rows[:5], quat_order="wxyz")) == 5


def test_other_threads_run_while_a_call_does(body):
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.is_set():
            ticks.append(1)
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    before = len(ticks)
    cd.contacts(body, body, poses(3000, reach=1), level="contacts", quat_order="wxyz", threads=1)
    during = len(ticks) - before
    stop.set()
    thread.join()
    assert during > 3


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


@pytest.mark.parametrize("job", [SCENE, MOTION, SHOTS], ids=["scene", "motion", "shots"])
def test_jobs_of_every_kind(job, body, tmp_path):
    write_obj(tmp_path / "body.obj", body)
    (tmp_path / "steps.csv").write_text("step,body,x\n" + "".join(
        f"{step},car.{car},{3.0 * car - step}\n" for step in range(4) for car in range(3)))
    results = cd.run(job, folder=tmp_path, out=tmp_path / "out")
    assert results.hit.any()
    again = cd.run(cd.Job.from_folder(tmp_path / "out"))
    assert again.digest == results.digest == cd.open(tmp_path / "out").digest
    subprocess.run([CDCTL, "verify", "out"], cwd=tmp_path, check=True, stdout=subprocess.DEVNULL)
    if job is SCENE:
        assert results.body_names == ["car.0", "car.1", "car.2", "wall"]
        assert set(results.step.tolist()) <= set(range(4)) and (results.body_a < results.body_b).all()
    if job is MOTION:
        assert results.motion_end[0] == 1 and 0 < results.t0[0] < results.t1[0] < 1 << results.motion_depth[0]
        assert results.runs.shape[1] == 5
    if job is SHOTS:
        assert len(results.hit_depth) == len(results.pairs) > 0 and (results.hit_depth > 0).all()


def test_tables_for_pandas(body):
    import pandas
    table = cd.contacts(body, body, poses(20), quat_order="wxyz").to_pandas()
    assert isinstance(table, pandas.DataFrame) and len(table) == 20
    assert set(table["class"]) <= {"separate", "touch", "cross", "inside"}


def test_the_script_of_the_page_runs(tmp_path):
    page = open(os.path.join(os.path.dirname(__file__), "../../docs/python.md"), encoding="utf-8").read()
    script = page.split("## A script to paste")[1].split("```python\n")[1].split("```")[0]
    if not os.path.exists("/usr/share/sumo/data/3D/tram.obj"):
        assert os.environ.get("CI") != "true"
        pytest.skip("the demo's vehicles are missing: packages_demo of deploy/packages")
    done = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, capture_output=True, text=True,
                          env={**os.environ, "MPLBACKEND": "Agg"})
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("9197 of 10000 poses are free") and (tmp_path / "free.png").stat().st_size > 0


def test_docstrings_are_true():
    outcome = doctest.testmod(cd)
    assert outcome.attempted > 5 and outcome.failed == 0


def test_stubs_are_those_of_the_module():
    folder = os.path.dirname(os.path.dirname(cd.__file__))
    environment = {**os.environ, "PYTHONPATH": folder, "MYPYPATH": folder}
    private = os.path.join(os.path.dirname(__file__), "private.txt")
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "--allowlist", private, "cdcluster"], env=environment,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
