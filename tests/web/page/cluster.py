"""A master with its workers on this machine."""
import subprocess

from servers import Program


class Cluster:
    """cdmaster on ports that the system chooses; ends with the `with` block."""

    def __init__(self, bin_dir, root):
        self.bin, self.root = bin_dir, root
        root.mkdir()
        self.programs = []

    def __enter__(self):
        self.master = self.start(
            "cdmaster", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0", "--state", self.root / "state"
        )
        self.address = self.master.wait_for(r"--master (127\.0\.0\.1:\d+)").group(1)
        self.http = int(self.master.wait_for(r"http listening: host=127\.0\.0\.1 port=(\d+)").group(1))
        self.page = f"http://127.0.0.1:{self.http}/"
        return self

    def __exit__(self, *_):
        for program in reversed(self.programs):
            program.close()

    def start(self, name, *options):
        program = Program(self.bin / name, *options, cwd=self.root)
        self.programs.append(program)
        return program

    def add_worker(self, name):
        return self.start("cdworker", "--master", self.address, "--name", name, "--threads", "1")

    def submit(self, scenes):
        """Submits a job that takes a while."""
        words = [self.bin / "cdctl", "submit", *scenes.bodies(), "--random", "60000", "--seed", "3"]
        words += ["--level", "contacts", "--master", self.address]
        subprocess.run(list(map(str, words)), check=True, capture_output=True, cwd=scenes.root)
