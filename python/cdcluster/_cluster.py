"""Clusters, and jobs on them."""
import os
from typing import NamedTuple

from . import _native
from ._job import Job
from ._native import InputError
from ._question import Question, pose_rows
from ._results import Results


class Progress(NamedTuple):
    """How far a job is: scenarios `done` of `total`, `rate` a second, `seconds` since it was accepted.

    `state` is running, done, cancelled or failed. `reason` says why a job failed or is paused; else it is
    empty.
    """

    done: int
    total: int
    rate: float
    state: str
    seconds: float
    reason: str


def _progress(facts):
    return Progress(facts.done, facts.total, facts.rate, facts.state, facts.seconds, facts.failure or facts.paused)


class ClusterJob:
    """A job on a master. `Cluster.submit`, `job` and `jobs` make it.

    id: "j-4f2a", as `cdctl` prints it. number, name, owner, priority: what the master tells.
    """

    def __init__(self, cluster, facts):
        self._cluster = cluster
        self.id, self.number, self.name, self.owner = facts.id, facts.number, facts.name, facts.owner
        self.priority = facts.priority

    def progress(self):
        """How far the job is now."""
        return _progress(self._cluster.job(str(self.number)))

    def watch(self, period=0.5):
        """Yields the progress at once, then every `period` seconds and more often at first, up to the end.

        A master that is lost may come back within a minute; then Unreachable is raised.
        """
        watch = self._cluster.watch(str(self.number))
        wait = 0.0
        while True:
            facts = watch.next(int(1000 * wait))
            yield _progress(facts)
            if facts.state != "running":
                return
            wait = min(float(period), max(0.05, 2 * wait))

    def results(self, *, partial=False):
        """Waits until the job has ended, and fetches its results, with the digest of a local run.

        Raises IncompleteError if the job was cancelled or has failed. With `partial` it does not wait, and
        gives the results that there are; their `index` tells of which scenarios.
        """
        if not partial:
            for _ in self.watch():
                pass
        number = str(self.number)
        return Results(self._cluster.results(number, partial),
                       lambda folder, overwrite: self._cluster.save(number, folder, overwrite))

    def set_priority(self, priority):
        """Changes the priority of the job, -10 to 10, which must not have ended. Returns its progress."""
        facts = self._cluster.set_priority(str(self.number), priority)
        self.priority = facts.priority
        return _progress(facts)

    def cancel(self):
        """Cancels the job unless it has ended. Returns its last progress."""
        return _progress(self._cluster.cancel(str(self.number)))

    def __repr__(self):
        return f"<cdcluster.ClusterJob {self.id} {self.name}>"


class Cluster:
    """The master at `address`, "host:port"; without one, the one that CDCTL_MASTER names.

    The credential is that of `cdctl join`; `credential` names another file, or is "none" for a connection
    without encryption, which beyond this machine also needs `insecure`. CDCTL_CREDENTIAL counts as for
    `cdctl`. `tree_cache` is the folder that keeps meshes which were fetched; "off" for none.

    Each call connects anew: threads may share a cluster, and a process may fork. Raises Unreachable, or
    RefusedError if the master refuses the credential or what was asked.
    """

    def __init__(self, address=None, *, credential=None, insecure=False, tree_cache=None):
        self.address = address or os.environ.get("CDCTL_MASTER") or "127.0.0.1:7600"
        credential = os.environ.get("CDCTL_CREDENTIAL", "") if credential is None else os.fspath(credential)
        cache = None if tree_cache is None else os.fspath(tree_cache)
        self._cluster = _native.Cluster(self.address, credential, insecure, cache)
        self._cluster.jobs()  # A wrong address or credential is told now.

    def submit(self, a, b=None, poses=None, level="pairs", *, quat_order=None, clearance=None, up_to=None,
               limit_pairs=0, maps=False, ignore=(), name="", folder=".", priority=0):
        """Submits a question about two meshes, or a job: its file's path, a dict of tables, or a `Job`.

        `cluster.submit(a, b, poses, level="count", maps=True)` takes the arguments of `contacts`, and at level
        distance those of `distance`. `cluster.submit("job.toml")` takes what `cdctl submit` takes; relative
        paths of a dict are those in `folder`. Jobs of higher `priority`, -10 to 10, go first; one above 0
        needs the role admin.
        """
        if b is None and poses is None:
            asked = (level, quat_order, clearance, up_to, limit_pairs, maps, tuple(ignore), name)
            if asked != ("pairs", None, None, None, 0, False, (), ""):
                raise InputError("a job's name and query are in its tables")
            return ClusterJob(self._cluster, self._cluster.submit_job(Job.of(a, folder)._job, priority))
        question = Question(a, b, level, clearance=clearance, up_to=up_to, limit_pairs=limit_pairs, maps=maps,
                            ignore=ignore)
        rows, form = pose_rows(poses, quat_order)
        facts = self._cluster.submit_pair(question.a, question.b, rows, form, question.query, name,
                                          priority)
        return ClusterJob(self._cluster, facts)

    def jobs(self):
        """The jobs that the master knows."""
        return [ClusterJob(self._cluster, facts) for facts in self._cluster.jobs()]

    def job(self, id):
        """The job with this id, a prefix of it or its number; "last" is the newest of this user."""
        return ClusterJob(self._cluster, self._cluster.job(str(id)))

    def __repr__(self):
        return f"<cdcluster.Cluster {self.address}>"
