"""A cluster of real processes on loopback, for the tests of the package."""
import contextlib
import os
import pathlib
import subprocess
import sys

PROGRAMS = pathlib.Path(os.environ["CDCTL"]).parent
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cluster"))

from cluster_of_processes import Cluster  # noqa: E402  (its folder is known only now)


@contextlib.contextmanager
def running(folder, workers=2, **options):
    """A master and workers of one thread each; yields the cluster, whose master listens at `port`."""
    cluster = Cluster(PROGRAMS, folder, workers, **options)
    try:
        yield cluster
    finally:
        cluster.end()


def address(cluster):
    return f"127.0.0.1:{cluster.port}"


def program(*words, **options):
    """Runs a program of ours, which must succeed. Returns what it prints."""
    done = subprocess.run([PROGRAMS / words[0], *words[1:]], capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
