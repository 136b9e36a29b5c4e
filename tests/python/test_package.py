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
from cluster import address, program, running
from shapes import MOTION, SCENE, SCENE_SHOTS, SHOTS, matrices, poses, torus, write_obj, write_steps

CDCTL = os.environ["CDCTL"]


@pytest.fixture(scope="module")
def body():
    return cd.Mesh.from_arrays(*torus())


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


def test_pairs_are_those_of_fcl(body, tmp_path):
    """Random poses have no pair that only touches, so that FCL's doubles decide as exact numbers do."""
    program_of_fcl = os.path.join(os.path.dirname(CDCTL), "../bench/fcl_pairs")
    if not os.path.exists(program_of_fcl):
        assert os.environ.get("CI") != "true", "build fcl_pairs: cmake -DCD_BENCH=ON -DCD_PEERS=ON, with libfcl-dev"
        pytest.skip("bench/fcl_pairs is built with CD_PEERS only")
    write_obj(tmp_path / "body.obj", body)
    mesh = cd.Mesh(tmp_path / "body.obj")
    at = matrices(poses(200, reach=3))
    np.save(tmp_path / "poses.npy", at)
    told = subprocess.run([program_of_fcl, "body.obj", "body.obj", "poses.npy"], cwd=tmp_path, capture_output=True,
                          text=True, check=True).stdout.splitlines()
    wanted = [np.array(line.split(), dtype=np.uint32).reshape(-1, 2) for line in told]
    found = cd.contacts(mesh, mesh, at)
    assert len(wanted) == len(found) == 200 and 0 < found.hit.sum() < 200
    for scenario, pairs in enumerate(wanted):
        assert np.array_equal(found.pairs_of(scenario), pairs), scenario


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
    assert few[2].index.tolist() == [8, 9]
    whole = cd.contacts(body, body, poses(10), quat_order="wxyz")
    assert [part.digest for part in few] == ["", "", whole.digest]
    assert np.array_equal(np.concatenate([part.pairs for part in few]), whole.pairs)


@pytest.mark.parametrize("question", [{"level": "any"}, {"level": "contacts", "clearance": 0.1},
                                      {"level": "count", "maps": True}], ids=["any", "contacts", "count"])
@pytest.mark.parametrize("rows", [7, 1000, 4000])
def test_the_last_window_has_the_digest_over_all(question, rows, body):
    wanted = cd.contacts(body, body, poses(4000), quat_order="wxyz", **question)
    parts = list(cd.contacts_in_windows(body, body, poses(4000), rows=rows, quat_order="wxyz", **question))
    assert parts[-1].digest == wanted.digest and not any(part.digest for part in parts[:-1])
    assert (np.concatenate([part.kind for part in parts]) == wanted.kind).all()
    if "maps" in question:
        assert (sum(part.map_a for part in parts) == wanted.map_a).all()
    bad = poses(4000)
    bad[3333, 3:] = 0
    with pytest.raises(cd.InputError, match="row 3333"):
        list(cd.contacts_in_windows(body, body, bad, rows=rows, quat_order="wxyz", **question))


def peak_bytes():
    with open("/proc/self/status") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith("RssAnon"))


LONG = """
import sys, numpy as np, cdcluster as cd
sys.path.insert(0, {tests!r})
import shapes as t
body = cd.Mesh.from_arrays(*t.torus({around}, {across}))
rows = t.poses(200_000, reach=1)
{first}
print("begins", flush=True)
try:
    cd.contacts(body, body, rows, level="contacts", quat_order="wxyz")
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


# The first answers the whole call's poses, which takes minutes; the second builds the tree of a million triangles.
@pytest.mark.parametrize("around, across, first, wait", [
    (200, 100, 'cd.contacts(body, body, rows[:10], quat_order="wxyz")', 0.5), (1000, 500, "", 0.15)], ids=["search", "tree"])
def test_ctrl_c_ends_a_call_with_keyboard_interrupt(around, across, first, wait):
    script = LONG.format(tests=os.path.dirname(__file__), around=around, across=across, first=first)
    process = subprocess.Popen([sys.executable, "-B", "-c", script], stdout=subprocess.PIPE, text=True)
    try:
        assert process.stdout.readline() == "begins\n"
        time.sleep(wait)
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "interrupted\n"
        assert process.wait(20) == 0
    finally:
        process.kill()
        process.wait()


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


@pytest.mark.parametrize("job", [SCENE, MOTION, SHOTS, SCENE_SHOTS], ids=["scene", "motion", "shots", "scene-shots"])
def test_jobs_of_every_kind(job, body, tmp_path):
    write_obj(tmp_path / "body.obj", body)
    write_steps(tmp_path / "steps.csv")
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
    if "shots" in job:
        assert len(results.hit_depth) == len(results.hits) > 0 and (results.hit_depth > 0).all()
        subprocess.run([CDCTL, "run", "out", "--out", "npz", "--formats", "npz"], cwd=tmp_path, check=True,
                       stdout=subprocess.DEVNULL)
        shots = np.load(tmp_path / "npz/shots.npz")
        named = {"offsets": "offsets", "hits": "hits", "depth": "hit_depth", "flags": "hit_flags", "rank": "hit_rank"}
        named |= {"step": "step", "bundle": "bundle", "body": "body_a"} if "bodies" in job else {}
        for array, name in named.items():
            assert (shots[array] == getattr(results, name)).all(), name
        assert (shots["index"] == results.index).all() and len(results.bundle) == ("bodies" in job) * len(results)
    else:
        assert len(results.hits) == 0


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
    place = tmp_path / "cluster"
    place.mkdir()
    with running(place) as processes:
        environment = {**os.environ, "MPLBACKEND": "Agg", "CDCTL_MASTER": address(processes),
                       "XDG_CACHE_HOME": str(tmp_path / "cache"), "XDG_STATE_HOME": str(tmp_path / "user")}
        done = subprocess.run([sys.executable, "-c", script], cwd=tmp_path, capture_output=True, text=True,
                              env=environment)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0].startswith("9197 of 10000 poses are free") and (tmp_path / "free.png").stat().st_size > 0
    assert "10000 of 10000" in lines[-2] and lines[-2].endswith("done") and lines[-1] == "the same digest"
    program("cdctl", "verify", "free-space", cwd=tmp_path)


def test_docstrings_are_true():
    modules = [cd] + [sys.modules[f"cdcluster.{name}"] for name in ("_cluster", "_job", "_mesh", "_question", "_results")]
    outcomes = [doctest.testmod(module) for module in modules]
    assert sum(outcome.attempted for outcome in outcomes) > 5 and not any(outcome.failed for outcome in outcomes)


def test_the_module_exports_nothing_but_itself():
    native = sys.modules["cdcluster._native"].__file__
    names = subprocess.run(["nm", "--dynamic", "--defined-only", native], capture_output=True, text=True, check=True)
    assert [line.split()[-1] for line in names.stdout.splitlines()] == ["PyInit__native"]


def test_stubs_are_those_of_the_module():
    folder = os.path.dirname(os.path.dirname(cd.__file__))
    environment = {**os.environ, "PYTHONPATH": folder, "MYPYPATH": folder}
    private = os.path.join(os.path.dirname(__file__), "private.txt")
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "--allowlist", private, "cdcluster"], env=environment,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
