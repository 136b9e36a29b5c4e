#!/usr/bin/env python3
"""Reads /metrics of a master with an identity, a worker and a job, and checks it by promtool; then checks
that it has each metric of the rules and of the dashboard, that Prometheus reads it by our configuration, and that
promtool parses each expression of the dashboard. Usage: check.py PROGRAMS PROMTOOL FOLDER"""
import contextlib
import json
import math
import pathlib
import re
import socket
import ssl
import subprocess
import sys
import time
import urllib.parse
import urllib.request

PATIENCE_SECONDS = 120
ROOT = pathlib.Path(__file__).resolve().parents[3]
NAME = re.compile(r"\bcdcluster_\w+")
# What Grafana puts in place of its variables.
VARIABLES = {"$instance": ".*", "$__rate_interval": "1m"}


def sphere(rings):
    """The text of an OBJ file of a closed sphere."""
    at = lambda ring, step: f"v {math.sin(math.pi * ring / rings) * math.cos(math.pi * step / rings):.6f} " \
        f"{math.sin(math.pi * ring / rings) * math.sin(math.pi * step / rings):.6f} {math.cos(math.pi * ring / rings):.6f}"
    lines = ["v 0 0 1", "v 0 0 -1"] + [at(ring, step) for ring in range(1, rings) for step in range(2 * rings)]
    index = lambda ring, step: 3 + (ring - 1) * 2 * rings + step % (2 * rings)
    for step in range(2 * rings):
        lines.append(f"f 1 {index(1, step)} {index(1, step + 1)}")
        lines.append(f"f 2 {index(rings - 1, step + 1)} {index(rings - 1, step)}")
        for ring in range(1, rings - 1):
            a, b = index(ring, step), index(ring, step + 1)
            c, d = index(ring + 1, step), index(ring + 1, step + 1)
            lines += [f"f {a} {c} {d}", f"f {a} {d} {b}"]
    return "\n".join(lines) + "\n"


def wait_for(what, look):
    """Returns the first value of `look` that is not empty."""
    end = time.monotonic() + PATIENCE_SECONDS
    while time.monotonic() < end:
        if found := look():
            return found
        time.sleep(0.05)
    raise SystemExit(f"monitoring: waited in vain for {what}")


class Cluster:
    """A master with an identity and one worker, on ports that the system chooses."""

    def __init__(self, programs, folder, stack):
        self.programs, self.folder, self.stack = programs, folder, stack
        state = folder / "state"
        self.admin = state / "identity" / "admin.pem"
        self.run("cdmaster", "init", "--state", state)
        self.log = folder / "master.log"
        self.start(self.log, "cdmaster", "--state", state, "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0",
                   "--port-file", folder / "port")
        self.master = "127.0.0.1:" + wait_for("the master", lambda: self.text_of(folder / "port").strip())
        self.http = int(re.search(r"http listening: .*port=(\d+)", self.log.read_text()).group(1))
        token = self.cdctl("token", "create").strip()
        self.run("cdworker", "join", self.master, "--token", token, "--state", folder / "worker")
        self.start(folder / "worker.log", "cdworker", "--master", self.master, "--state", folder / "worker",
                   "--threads", "1")

    @staticmethod
    def text_of(path):
        return path.read_text() if path.exists() else ""

    def run(self, program, *arguments):
        command = [self.programs / program, *arguments]
        return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, timeout=PATIENCE_SECONDS).stdout

    def cdctl(self, *arguments):
        return self.run("cdctl", *arguments, "--master", self.master, "--credential", self.admin)

    def start(self, log, program, *arguments):
        process = subprocess.Popen([self.programs / program, *arguments], stdout=subprocess.DEVNULL,
                                   stderr=self.stack.enter_context(log.open("w")))
        self.stack.callback(process.wait)
        self.stack.callback(process.terminate)

    def metrics(self):
        context = ssl.create_default_context(cafile=self.admin)
        context.load_cert_chain(self.admin)
        with socket.create_connection(("127.0.0.1", self.http)) as plain, \
                context.wrap_socket(plain, server_hostname="master") as secured:
            secured.sendall(b"GET /metrics HTTP/1.1\r\nHost: master\r\n\r\n")
            answer = b""
            with contextlib.suppress(ssl.SSLEOFError):
                while part := secured.recv(65536):
                    answer += part
        head, _, body = answer.decode().partition("\r\n\r\n")
        assert head.startswith("HTTP/1.1 200 "), head
        return body


def value_of(text, sample):
    found = re.search("^" + re.escape(sample) + r" (\S+)$", text, re.MULTILINE)
    return float(found.group(1)) if found else 0.0


def submit_long_job(cluster, folder):
    """Submits a job that runs until it is cancelled, and returns its id."""
    (folder / "sphere.obj").write_text(sphere(40))
    (folder / "job.toml").write_text(
        'name = "night"\n[a]\nmesh = "sphere.obj"\n[b]\nmesh = "sphere.obj"\n[poses]\n'
        "grid = { x = [-2, 2, 400], y = [-2, 2, 400], yaw_deg = [0, 350, 36] }\n[query]\nlevel = \"count\"\n")
    return cluster.cdctl("submit", folder / "job.toml", "-o", "name", "--quiet", "--tree-cache", "off").strip()


def scrape(cluster, prometheus, folder, stack):
    """Runs Prometheus itself on our configuration, with the lines for TLS, until it has read the master."""
    token = cluster.cdctl("token", "create", "--role", "metrics").strip()
    credential = folder / "metrics.pem"
    cluster.run("cdctl", "join", cluster.master, "--token", token, "--credential", credential)
    text = (ROOT / "deploy/prometheus/prometheus.yml").read_text()
    text = re.sub(r"^    # (scheme|tls_config|  \w+_?\w+)(:.*)$", r"    \1\2", text, flags=re.MULTILINE)
    text = text.replace("127.0.0.1:7680", f"127.0.0.1:{cluster.http}").replace("15s", "1s")
    assert text.count("metrics.pem") == 3 and "server_name" in text, text
    (folder / "prometheus.yml").write_text(text)
    (folder / "cdcluster.rules.yml").write_text((ROOT / "deploy/prometheus/cdcluster.rules.yml").read_text())
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    process = subprocess.Popen([prometheus, f"--config.file={folder}/prometheus.yml", f"--storage.tsdb.path={folder}/tsdb",
                                f"--web.listen-address=127.0.0.1:{port}"], stdout=subprocess.DEVNULL,
                               stderr=stack.enter_context((folder / "prometheus.log").open("w")))
    stack.callback(process.wait)
    stack.callback(process.terminate)

    def results(query):
        address = f"http://127.0.0.1:{port}/api/v1/query?" + urllib.parse.urlencode({"query": query})
        try:
            with urllib.request.urlopen(address, timeout=PATIENCE_SECONDS) as answer:
                return json.load(answer)["data"]["result"]
        except OSError:
            return []  # It does not listen yet.

    wait_for("Prometheus to read the master", lambda: results('up{job="cdcluster"} == 1'))
    wait_for("Prometheus to know the workers", lambda: results('cdcluster_workers{state="alive"} == 1'))
    firing = results('ALERTS{alertname=~"Cdcluster.*",alertstate="firing"}')
    assert not firing, firing


def live_metrics(programs, prometheus, folder):
    """Returns /metrics while a job runs of which some scenarios have a result."""
    with contextlib.ExitStack() as stack:
        cluster = Cluster(programs, folder, stack)
        job = submit_long_job(cluster, folder)

        def at_work():
            text = cluster.metrics()
            is_at_work = (value_of(text, "cdcluster_scenarios_total") > 0
                          and value_of(text, "cdcluster_state_free_bytes") > 0
                          and value_of(text, "cdcluster_journal_commit_seconds_count") > 0
                          and value_of(text, 'cdcluster_http_requests_total{code="200"}') > 0)
            return text if is_at_work else ""

        text = wait_for("the first results", at_work)
        assert value_of(text, 'cdcluster_jobs{state="running"}') == 1, text
        assert value_of(text, "cdcluster_results_bytes_total") > value_of(text, "cdcluster_scenarios_total"), text
        day = 86400
        left = value_of(text, "cdcluster_certificate_expires_timestamp_seconds") - time.time()
        assert left > day, f"the certificate is good for {left} s"
        started = value_of(text, "cdcluster_process_start_time_seconds")
        assert abs(time.time() - started) < PATIENCE_SECONDS, started
        scrape(cluster, prometheus, folder, stack)
        cluster.cdctl("cancel", job)
        return text


def expressions_of(dashboard):
    for panel in json.loads(dashboard)["panels"]:
        for target in panel["targets"]:
            expression = target["expr"]
            for variable, text in VARIABLES.items():
                expression = expression.replace(variable, text)
            yield panel["title"], expression


def main():
    programs, promtool, folder = (pathlib.Path(each) for each in sys.argv[1:])
    text = live_metrics(programs, promtool.with_name("prometheus"), folder)
    checked = subprocess.run([promtool, "check", "metrics"], input=text, text=True, capture_output=True)
    if checked.returncode != 0 or checked.stderr:
        raise SystemExit(f"monitoring: promtool check metrics: {checked.stdout}{checked.stderr}")
    broken = subprocess.run([promtool, "check", "metrics"], input=text + "cdcluster_x{ 1\n", text=True,
                            capture_output=True)
    assert broken.returncode != 0, "promtool takes anything"

    there = set(re.findall(r"^(cdcluster_\w+)[ {]", text, re.MULTILINE))
    rules = (ROOT / "deploy/prometheus/cdcluster.rules.yml").read_text()
    expressions = list(expressions_of((ROOT / "deploy/grafana/cdcluster.json").read_text()))
    wanted = set(NAME.findall(rules)) | {name for _, expression in expressions for name in NAME.findall(expression)}
    if missing := wanted - there:
        raise SystemExit(f"monitoring: not in /metrics: {', '.join(sorted(missing))}")

    group = [{"record": f"panel:{number}", "expr": expression} for number, (_, expression) in enumerate(expressions)]
    as_rules = folder / "dashboard.rules.json"  # JSON is YAML.
    as_rules.write_text(json.dumps({"groups": [{"name": "dashboard", "rules": group}]}))
    subprocess.run([promtool, "check", "rules", as_rules], check=True)
    documented = (ROOT / "docs/monitoring.md").read_text()
    families = set(re.findall(r"^# TYPE cdcluster_(\w+) ", text, re.MULTILINE))
    if missing := {name for name in families if f"`{name}" not in documented}:
        raise SystemExit(f"monitoring: docs/monitoring.md lacks {', '.join(sorted(missing))}")
    print(f"monitoring: {len(there)} names in /metrics, {len(wanted)} of them in rules and dashboard, "
          f"{len(expressions)} expressions")


if __name__ == "__main__":
    main()
