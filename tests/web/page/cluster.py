"""A master with its workers on this machine."""
import http.client
import json
import ssl
import subprocess

from servers import Program, ask


class Cluster:
    """cdmaster on ports that the system chooses; ends with the `with` block."""

    def __init__(self, bin_dir, root, *options, has_identity=False):
        """`options` are those of cdmaster."""
        self.bin, self.root, self.options, self.has_identity = bin_dir, root, options, has_identity
        root.mkdir()
        self.programs = []

    def __enter__(self):
        if self.has_identity:
            self.run("cdmaster", "init", "--state", self.root / "state")
        ports = ["--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"]
        self.master = self.start("cdmaster", *ports, "--state", self.root / "state", *self.options)
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

    def run(self, name, *options):
        """Runs a program to its end; returns what it printed."""
        words = list(map(str, [self.bin / name, *options]))
        ran = subprocess.run(words, capture_output=True, text=True, cwd=self.root)
        if ran.returncode != 0:
            raise AssertionError(f"{' '.join(words)}: {ran.stderr}")
        return ran.stdout

    def credential(self, role):
        """Joins as somebody with this role; returns the file with certificate and key."""
        admin = self.root / "state" / "identity" / "admin.pem"
        token = self.run("cdctl", "token", "create", "--role", role, "--master", self.address, "--credential", admin)
        path = self.root / f"{role}.pem"
        self.run("cdctl", "join", self.address, "--token", token.split()[-1], "--credential", path)
        return path

    def status(self, path, credential=None):
        """Returns the status of a request over TLS with a client's certificate, or without one."""
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        context.check_hostname = False
        context.verify_mode = ssl.CERT_NONE  # The test is about the client's certificate.
        if credential:
            context.load_cert_chain(credential)
        connection = http.client.HTTPSConnection("127.0.0.1", self.http, timeout=30, context=context)
        connection.request("GET", path)
        status = connection.getresponse().status
        connection.close()
        return status

    def add_worker(self, name):
        return self.start("cdworker", "--master", self.address, "--name", name, "--threads", "1")

    def job(self):
        """Returns the id of a job; of the only one, if there is one."""
        return json.loads(ask(self.http, "/api/v1/jobs")[2])["jobs"][0]["job"]

    def submit(self, scenes, name="long"):
        """Submits a job with this name that takes minutes."""
        self.run("cdctl", "submit", scenes.long_job(name), "--master", self.address)
