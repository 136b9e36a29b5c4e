"""A cluster of real processes on loopback, for the programs of measurement in this folder."""
import json
import os
import pathlib
import re
import signal
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = ROOT / "build/test/bin"
PATIENCE = 120  # Seconds in which cdctl has to answer.


class Failed(Exception):
    """What was to be shown is not so."""


def meshes():
    """The folder of the models, or None; the setting of the build is given as CD_MESHES."""
    folder = pathlib.Path(os.environ.get("CD_MESHES", ROOT.parent / "shared/meshes"))
    return folder if folder.is_dir() else None


def resident_kb(process):
    try:
        text = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
        return int(re.search(r"VmRSS:\s+(\d+)", text)[1])
    except (OSError, TypeError):
        return 0


def digest_of(programs, *job):
    """Of a job that `cdctl run` does in one process: the first digits."""
    done = subprocess.run([programs / "cdctl", "run", *job, "--tree-cache", "off", "--quiet"],
                          capture_output=True, text=True, check=True)
    return re.search(r"^ *digest +([0-9a-f]+)", done.stdout, re.MULTILINE)[1]


class Cluster:
    """A master and workers of one thread each, with logs and the master's state in `folder`."""

    def __init__(self, programs, folder, workers, master_options=(), worker_options=()):
        self.programs, self.folder = programs, folder
        self.master_options, self.worker_options = master_options, worker_options
        self.port = 0
        self.master = None
        self.workers = [None] * workers
        try:
            self.start_master()
            for place in range(workers):
                self.start_worker(place)
        except BaseException:
            self.end()
            raise

    def start(self, name, *command):
        with open(self.folder / f"{name}.log", "ab") as log:
            return subprocess.Popen([self.programs / command[0], *command[1:]], stdout=log, stderr=log)

    def start_master(self):
        """Returns when it listens: always on the port that the system chose first."""
        port_file = self.folder / "port"
        port_file.unlink(missing_ok=True)
        self.master = self.start("master", "cdmaster", "--listen", f"127.0.0.1:{self.port}", "--port-file", port_file,
                                 "--state", self.folder / "state", *self.master_options)
        give_up_at = time.monotonic() + PATIENCE
        while not (port_file.exists() and port_file.read_text(encoding="ascii").strip()):
            if self.master.poll() is not None:
                raise Failed(f"the master does not start: {self.folder / 'master.log'}")
            if time.monotonic() > give_up_at:
                raise Failed("the master does not listen")
            time.sleep(0.01)
        self.port = int(port_file.read_text(encoding="ascii"))

    def kill_master(self):
        self.master.kill()
        self.master.wait()

    def start_worker(self, place):
        self.workers[place] = self.start(
            f"worker{place}", "cdworker", "--master", f"127.0.0.1:{self.port}", "--threads", "1", "--name",
            f"worker{place}", "--connect-for", "600", *self.worker_options)

    def cdctl(self, *arguments):
        """What it prints, or nothing where the master cannot be asked now."""
        done = subprocess.run([self.programs / "cdctl", *arguments, "--master", f"127.0.0.1:{self.port}"],
                              capture_output=True, text=True, check=False, timeout=PATIENCE)
        return done.stdout if done.returncode == 0 else None

    def status(self):
        """Of `cdctl status`, or nothing where the master cannot be asked now."""
        printed = self.cdctl("status", "-o", "json")
        return None if printed is None else json.loads(printed)

    def submit(self, *job):
        """The job's number in text, or nothing where the master cannot be asked now."""
        accepted = self.cdctl("submit", *job, "--quiet", "-o", "name")
        return None if accepted is None else accepted.strip()

    def processes(self):
        return [process for process in (self.master, *self.workers) if process is not None]

    def end(self):
        for process in self.processes():
            if process.poll() is None:
                process.send_signal(signal.SIGCONT)
                process.terminate()
        for process in self.processes():
            try:
                process.wait(timeout=60)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                raise Failed(f"a process did not end when it was told to: {process.args[0]}") from None
