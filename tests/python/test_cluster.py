"""Proves what the package promises of clusters: a job of any kind has the digest of a local run, its
folder is that of `cdctl`, and errors, Ctrl-C, threads and forks do what the documentation says."""
import concurrent.futures
import multiprocessing
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import cdcluster as cd
from cdcluster._toml import toml_text
from cluster import address, program, running
from shapes import MOTION, SCENE, SCENE_SHOTS, SHOTS, poses, torus, write_obj, write_steps

ARRAYS = ("kind", "count", "near_count", "offsets", "pairs", "pair_class", "points", "distance", "witness",
          "witness_points", "step", "bundle", "body_a", "body_b", "motion_end", "t0", "t1", "runs", "hit_depth", "map_a", "map_b")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The folder of the cluster, and of all that clients keep."""
    made = tmp_path_factory.mktemp("cluster")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(made / "cache"))
        patch.setenv("XDG_STATE_HOME", str(made / "user"))
        patch.delenv("CDCTL_MASTER", raising=False)
        patch.delenv("CDCTL_CREDENTIAL", raising=False)
        yield made


@pytest.fixture(scope="module")
def processes(folder):
    with running(folder) as cluster:
        yield cluster


@pytest.fixture(scope="module")
def master(processes):
    return address(processes)


@pytest.fixture(scope="module")
def cluster(master):
    return cd.Cluster(master)


@pytest.fixture(scope="module")
def body():
    return cd.Mesh.from_arrays(*torus())


def assert_equal(found, wanted):
    assert found.digest == wanted.digest != ""
    for name in ARRAYS:
        assert np.array_equal(getattr(found, name), getattr(wanted, name), equal_nan="distance" in name or "points" in name), name


QUESTIONS = [
    {"level": "any"},
    {"level": "count", "maps": True},
    {"level": "pairs", "ignore": [("front", "*")], "limit_pairs": 5},
    {"level": "contacts", "clearance": 0.1},
    {"level": "distance", "up_to": 2.0},
]


def ask(a, b, rows, level, **question):
    call = cd.distance if level == "distance" else lambda *args, **all: cd.contacts(*args, level=level, **all)
    return call(a, b, rows, quat_order="wxyz", **question)


@pytest.mark.parametrize("question", QUESTIONS, ids=[q["level"] for q in QUESTIONS])
def test_a_question_has_the_digest_and_arrays_of_a_local_call(question, cluster, body, tmp_path):
    half = len(body.faces) // 2
    mesh = cd.Mesh.from_arrays(body.vertices, body.faces, [("front", 0, half), ("back", half, 2 * half)])
    other = cd.Mesh.from_arrays(body.vertices, body.faces, [("whole", 0, 2 * half)])
    rows = poses(300)
    local = ask(mesh, other, rows, **question)
    job = cluster.submit(mesh, other, rows, quat_order="wxyz", name="a sweep", **question)
    assert job.name == "a sweep" and job.id.startswith("j-")
    found = job.results()
    assert_equal(found, local)
    assert (found.map_a.sum() > 0) == (question.get("maps", False))
    # The folders of both are those of cdctl.
    local.save(tmp_path / "local")
    found.save(tmp_path / "fetched")
    program("cdctl", "results", job.id, "--master", cluster.address, "--out", "by-cdctl", "--quiet", cwd=tmp_path)
    records = (tmp_path / "by-cdctl/records").read_bytes()
    for saved in ("local", "fetched"):
        assert (tmp_path / saved / "records").read_bytes() == records
        assert_equal(cd.open(tmp_path / saved), cd.open(tmp_path / "by-cdctl"))
        assert cd.open(tmp_path / saved).digest == local.digest
        program("cdctl", "verify", saved, cwd=tmp_path)


def scene_files(folder, body):
    write_obj(folder / "body.obj", body)
    write_steps(folder / "steps.csv")
    np.save(folder / "poses.npy", poses(200))


PAIR = {"a": {"mesh": "body.obj"}, "b": {"mesh": "body.obj"},
        "poses": {"file": "poses.npy", "quat_order": "wxyz"}}
JOBS = {
    "contacts": {**PAIR, "query": {"level": "contacts"}},
    "distance": {**PAIR, "query": {"level": "distance"}},
    "random": {"a": {"mesh": "body.obj"}, "b": {"mesh": "body.obj"}, "poses": {"random": {"n": 50, "seed": 3}}},
    "scene": SCENE, "motion": MOTION, "shots": SHOTS, "scene-shots": SCENE_SHOTS,
}


@pytest.mark.parametrize("kind", JOBS)
def test_a_job_of_each_kind_has_the_digest_and_arrays_of_a_local_run(kind, cluster, body, tmp_path):
    scene_files(tmp_path, body)
    (tmp_path / "job.toml").write_text(toml_text(JOBS[kind]))
    local = cd.run(tmp_path / "job.toml")
    assert local.hit.any() or kind == "distance"
    job = cluster.submit(tmp_path / "job.toml")
    assert_equal(job.results(), local)
    assert_equal(cluster.submit(JOBS[kind], folder=tmp_path).results(), local)
    # What was not kept is written later, as if `out` had been given.
    local.save(tmp_path / "saved")
    kept = cd.run(tmp_path / "job.toml", out=tmp_path / "kept")
    assert (tmp_path / "saved/records").read_bytes() == (tmp_path / "kept/records").read_bytes()
    assert_equal(cd.open(tmp_path / "saved"), local)
    program("cdctl", "verify", "saved", cwd=tmp_path)
    kept.save(tmp_path / "copy")
    assert cd.open(tmp_path / "copy").digest == local.digest
    job.results().save(tmp_path / "fetched")
    assert (tmp_path / "fetched/records").read_bytes() == (tmp_path / "kept/records").read_bytes()
    program("cdctl", "verify", "fetched", cwd=tmp_path)


def test_saving_heeds_what_is_there_and_what_has_changed(body, tmp_path):
    rows = poses(20)
    found = cd.contacts(body, body, rows, quat_order="wxyz")
    found.save(tmp_path / "out")
    found.save(tmp_path / "out")  # It is there already.
    other = cd.contacts(body, body, poses(20, seed=9), quat_order="wxyz")
    with pytest.raises(cd.InputError, match="another run"):
        other.save(tmp_path / "out")
    other.save(tmp_path / "out", overwrite=True)
    assert cd.open(tmp_path / "out").digest == other.digest
    with pytest.raises(cd.InputError, match="not empty"):
        cd.open(tmp_path / "out").save(tmp_path)
    rows[3, 0] += 1
    with pytest.raises(cd.InputError, match="poses has changed"):
        found.save(tmp_path / "late")
    with pytest.raises(cd.InputError, match="window"):
        next(cd.contacts_in_windows(body, body, rows, quat_order="wxyz")).save(tmp_path / "window")
    scene_files(tmp_path, body)
    ran = cd.run(PAIR, folder=tmp_path)
    np.save(tmp_path / "poses.npy", poses(200, seed=5))
    with pytest.raises(cd.InputError, match="has changed since it ran"):
        ran.save(tmp_path / "later")


def test_a_watch_tells_how_far_the_job_is(cluster, body):
    job = cluster.submit(body, body, poses(20_000, reach=1), "contacts", quat_order="wxyz", name="watched")
    told = list(job.watch(period=0.1))
    done = [progress.done for progress in told]
    assert done == sorted(done) and {progress.total for progress in told} == {20_000}
    assert told[-1].state == "done" and done[-1] == 20_000 and told[-1].rate > 0 and told[-1].reason == ""
    assert all(progress.state == "running" for progress in told[:-1])
    assert job.progress() == told[-1]
    assert len(list(job.watch())) == 1


def test_jobs_are_found(cluster, body):
    job = cluster.submit(body, body, poses(5), quat_order="wxyz", name="found")
    assert job.results().digest
    for id in (job.id, job.id[2:], str(job.number), job.number, "last"):
        again = cluster.job(id)
        assert (again.number, again.name, again.owner) == (job.number, "found", job.owner)
    assert job.number in [each.number for each in cluster.jobs()]
    with pytest.raises(cd.InputError, match="j-zzzz"):
        cluster.job("j-zzzz")


def long_job(cluster, body):
    return cluster.submit(body, body, poses(300_000, reach=1), "contacts", quat_order="wxyz")


def test_a_cancelled_job_gives_what_it_has(cluster, body, tmp_path):
    job = long_job(cluster, body)
    for progress in job.watch(period=0.05):
        if progress.done > 100:
            break
    with pytest.raises(cd.IncompleteError, match="still running"):
        cluster._cluster.results(str(job.number), False)
    last = job.cancel()
    assert last.state == "cancelled" and 100 < last.done < last.total == 300_000
    assert job.cancel() == last
    with pytest.raises(cd.IncompleteError, match="was cancelled"):
        job.results()
    part = job.results(partial=True)
    assert part.digest == "" and len(part) == last.done
    # The scenarios that have a result have the right one.
    wanted = cd.contacts(body, body, poses(300_000, reach=1)[part.index[:200].astype(int)], "contacts", quat_order="wxyz")
    assert np.array_equal(part.kind[:200], wanted.kind) and np.array_equal(part.count[:200], wanted.count)
    part.save(tmp_path / "part")
    with pytest.raises(cd.IncompleteError, match="not of all"):
        cd.open(tmp_path / "part")
    again = cd.open(tmp_path / "part", partial=True)
    assert np.array_equal(again.index, part.index) and np.array_equal(again.pairs, part.pairs)
    assert again.to_pandas()["scenario"].tolist() == part.index.tolist()


def test_a_job_has_the_priority_that_is_given(cluster, body, tmp_path):
    assert cluster.submit(body, body, poses(5), quat_order="wxyz").priority == 0
    job = cluster.submit(body, body, poses(5), quat_order="wxyz", priority=-4)
    assert job.priority == cluster.job(job.id).priority == -4
    scene_files(tmp_path, body)
    assert cluster.submit(PAIR, folder=tmp_path, priority=7).priority == 7
    job = long_job(cluster, body)
    assert job.set_priority(-6).state == "running"
    assert job.priority == cluster.job(job.id).priority == -6
    job.cancel()
    with pytest.raises(cd.RefusedError, match="has ended"):
        job.set_priority(2)
    with pytest.raises(cd.InputError, match="the priority is 11 and may be -10 to 10"):
        cluster.submit(body, body, poses(5), quat_order="wxyz", priority=11)


def test_a_master_that_is_not_there_is_unreachable(master, body):
    with pytest.raises(cd.Unreachable, match="is cdmaster running there"):
        cd.Cluster("127.0.0.1:1")
    with pytest.raises(ConnectionError):
        cd.Cluster("127.0.0.1:1")
    with pytest.raises(cd.InputError, match="HOST:PORT"):
        cd.Cluster("nowhere")


def test_the_environment_names_the_master(master, monkeypatch):
    monkeypatch.setenv("CDCTL_MASTER", master)
    assert cd.Cluster().address == master


def test_bad_questions_are_refused_before_they_are_sent(cluster, body, tmp_path):
    count = len(cluster.jobs())
    with pytest.raises(cd.InputError, match="row 1"):
        cluster.submit(body, body, np.array([[0, 0, 0, 1, 0, 0, 0], [0.0] * 7]), quat_order="wxyz")
    with pytest.raises(cd.InputError, match="maps"):
        cluster.submit(body, body, np.eye(4), "any", maps=True)
    with pytest.raises(cd.InputError, match="in its tables"):
        cluster.submit(tmp_path / "job.toml", name="other")
    with pytest.raises(FileNotFoundError, match="no.toml"):
        cluster.submit(tmp_path / "no.toml")
    assert len(cluster.jobs()) == count


@pytest.fixture(scope="module")
def secured(tmp_path_factory):
    place = tmp_path_factory.mktemp("secured")
    for state in ("state", "foreign"):
        program("cdmaster", "init", "--state", place / state)
    with running(place, workers=0) as processes:
        yield processes


def test_credentials_are_those_of_cdctl_join(secured, folder, body):
    place = secured.folder
    master = address(secured)
    admin = place / "state/identity/admin.pem"
    for credential in ("none", place / "foreign/identity/admin.pem"):
        with pytest.raises(cd.RefusedError):
            cd.Cluster(master, credential=credential)
    with pytest.raises(PermissionError):
        cd.Cluster(master)  # Nobody has joined.
    token = program("cdctl", "token", "create", "--role", "submitter", "--uses", "1", "--master", master,
                    "--credential", admin).splitlines()[0]
    program("cdctl", "join", master, "--token", token)
    joined = cd.Cluster(master)
    job = joined.submit(body, body, poses(5), quat_order="wxyz")
    of_admin = cd.Cluster(master, credential=admin).submit(body, body, poses(5), quat_order="wxyz")
    assert of_admin.owner != job.owner
    with pytest.raises(cd.RefusedError, match="belongs to"):
        joined.job(of_admin.id).cancel()
    with pytest.raises(cd.RefusedError, match="priority 1 needs the role admin"):
        joined.submit(body, body, poses(5), quat_order="wxyz", priority=1)
    assert job.cancel().state == "cancelled"


def digest_of(master, number):
    return cd.Cluster(master).job(number).results().digest


def digest_by(job):
    return job.results().digest


def test_threads_and_forks_share_a_cluster(cluster, master, body):
    rows = poses(100)
    wanted = cd.contacts(body, body, rows, quat_order="wxyz").digest
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        submitted = [pool.submit(cluster.submit, body, body, rows, quat_order="wxyz") for _ in range(4)]
        jobs = [task.result() for task in submitted]
        assert {digest for digest in pool.map(digest_by, jobs)} == {wanted}
    fork = multiprocessing.get_context("fork")
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=fork) as pool:
        tasks = [pool.submit(digest_of, master, job.number) for job in jobs]
        assert {task.result() for task in tasks} == {wanted}
    assert jobs[0].results().digest == wanted
    with pytest.raises(TypeError):
        import pickle
        pickle.dumps(cluster)


WAIT = """
import sys, time, cdcluster as cd
sys.path.insert(0, {tests!r})
import shapes as t
body = cd.Mesh.from_arrays(*t.torus())
job = cd.Cluster({master!r}).submit(body, body, t.poses(300_000, reach=1), "contacts", quat_order="wxyz")
print(job.number, flush=True)
try:
    {wait}
except KeyboardInterrupt:
    print("interrupted", job.progress().state, flush=True)
"""


@pytest.mark.parametrize("wait", ["for _ in job.watch(): print('watches', flush=True)",
                                  "print('watches', flush=True); job.results()"], ids=["watch", "results"])
def test_ctrl_c_ends_a_wait_and_not_the_job(wait, cluster, master):
    script = WAIT.format(tests=os.path.dirname(__file__), master=master, wait=wait)
    process = subprocess.Popen([sys.executable, "-B", "-c", script], stdout=subprocess.PIPE, text=True)
    try:
        number = int(process.stdout.readline())
        assert process.stdout.readline() == "watches\n"
        time.sleep(0.7)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        # The job takes minutes.
        line = process.stdout.readline()
        while line == "watches\n":
            line = process.stdout.readline()
        print(f"Ctrl-C took {1000 * (time.monotonic() - begin):.0f} ms")
        assert line == "interrupted running\n"
        assert process.wait(20) == 0
    finally:
        process.kill()
        process.wait()
    assert cluster.job(number).cancel().state == "cancelled"


def test_a_watch_survives_its_master(body, tmp_path):
    with running(tmp_path, workers=1) as processes:
        job = cd.Cluster(address(processes)).submit(body, body, poses(3000, reach=1), "contacts", quat_order="wxyz")
        watch = job.watch(period=0.05)
        assert next(watch).total == 3000
        processes.kill_master()
        processes.start_master()
        assert [progress.state for progress in watch][-1] == "done"
        assert job.results().digest == cd.contacts(
            body, body, poses(3000, reach=1), "contacts", quat_order="wxyz").digest
