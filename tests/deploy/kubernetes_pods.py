"""Runs the containers of deploy/kubernetes as the kubelet would, but for the image and the cluster: their
commands, variables, users and volumes are those of the objects. Each is process 1 of its own namespace, on a
read-only root of this machine's programs, without capabilities. A job runs through them while a worker and
the master are stopped. Usage: kubernetes_pods.py FILE BIN_DIR: FILE is the output of `kubectl kustomize`.
Needs root and namespaces; the caller has made one of networks, in which all addresses are this one's."""
import json
import os
import pathlib
import shutil
import signal
import ssl
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

import yaml

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from kubernetes_objects import check_typed, pods_of
from torus_job import write_job

ROOT = pathlib.Path(__file__).resolve().parents[2]
PATIENCE = 60

# Makes the root, and becomes the container's process 1. Arguments: the root, the pod's name, the user, then
# HOST PATH ro|rw of each mount, then --, then the command with its environment.
BEGIN = """
root=$1 name=$2 user=$3; shift 3
mount --make-rprivate /
mount -t tmpfs tmpfs "$root"
mkdir "$root/proc" "$root/dev" "$root/usr" "$root/etc"
for link in bin sbin lib lib64; do
    if [ -L "/$link" ]; then cp -P "/$link" "$root/$link"; else mkdir "$root/$link"; mount --rbind -o ro "/$link" "$root/$link"; fi
done
for folder in usr etc; do mount --bind "/$folder" "$root/$folder"; mount -o remount,bind,ro "$root/$folder"; done
for device in null urandom; do : >"$root/dev/$device"; mount --bind "/dev/$device" "$root/dev/$device"; done
mount -t proc proc "$root/proc"
while [ "$1" != -- ]; do
    if [ -d "$1" ]; then mkdir -p "$root$2"; else [ -e "$root$2" ] || : >"$root$2"; fi
    mount --bind "$1" "$root$2"
    if [ "$3" = ro ]; then mount -o remount,bind,ro "$root$2"; fi
    shift 3
done
shift
mount -o remount,ro "$root"
hostname "$name"
exec chroot "$root" /usr/bin/setpriv --reuid "$user" --regid "$user" --clear-groups --no-new-privs \\
    --inh-caps=-all --bounding-set=-all /usr/bin/env -i "$@"
"""


def fail(text):
    sys.exit(f"kubernetes: FAILED: {text}")


def wait_for(what, condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            fail(f"it does not come true: {what}")
        time.sleep(0.1)


class Cluster:
    """The objects, a folder for what the kubelet would mount, and the containers that run."""

    def __init__(self, items, programs, work):
        self.items = items
        self.pods = {name: pod for name, (_, pod) in pods_of(items).items()}
        self.options = next(item["data"] for item in items if item["kind"] == "ConfigMap")
        self.work = work
        self.image = work / "image"  # What the image has in /usr/local/bin.
        self.image.mkdir()
        for program in ("cdmaster", "cdworker", "cdctl"):
            shutil.copy(programs / program, self.image)
        shutil.copy(ROOT / "deploy/compose/entrypoint", self.image / "cd-entrypoint")
        self.hosts = work / "hosts"
        self.hosts.write_text("127.0.0.1 localhost cdcluster-master\n", encoding="utf-8")
        self.running = []

    def volume(self, pod_name, volume):
        """The folder of a volume, with the owner and the mode that the kubelet would give it."""
        claim = volume.get("persistentVolumeClaim", {}).get("claimName") or f"{volume['name']}-{pod_name}"
        shared = volume.get("secret", {}).get("secretName") or claim
        folder = self.work / "volumes" / shared
        if not folder.exists():
            folder.mkdir(parents=True)
            if "emptyDir" in volume:
                folder.chmod(0o777)
            elif "secret" not in volume:  # Claimed, with the group `fsGroup`.
                os.chown(folder, 0, self.pods["cdcluster-master"]["securityContext"]["fsGroup"])
                folder.chmod(0o2775)
        return folder

    def start(self, owner, pod_name, container_name, options=None, command=None):
        pod = self.pods[owner]
        container = next(each for each in pod.get("initContainers", []) + pod["containers"]
                         if each["name"] == container_name)
        volumes = {volume["name"]: volume for volume in pod["volumes"]}
        mounts = [str(self.image), "/usr/local/bin", "ro", str(self.hosts), "/etc/hosts", "ro"]
        for mount in container["volumeMounts"]:
            way = "ro" if mount.get("readOnly") else "rw"
            mounts += [str(self.volume(pod_name, volumes[mount["name"]])), mount["mountPath"], way]
        environment = {"PATH": "/usr/local/bin:/usr/bin:/bin", "HOME": "/var/lib/cdcluster"}
        for source in container.get("envFrom", []):
            environment.update(self.options if source["configMapRef"] else {})
        environment.update({each["name"]: each["value"] for each in container.get("env", [])})
        environment.update(options or {})
        words = command or container.get("command", ["cd-entrypoint"]) + container.get("args", [])
        root = pathlib.Path(tempfile.mkdtemp(dir=self.work))
        log = self.work / f"{pod_name}.log"
        with open(log, "a", encoding="utf-8") as output:
            process = subprocess.Popen(
                ["unshare", "--mount", "--pid", "--uts", "--fork", "--kill-child", "sh", "-euc", BEGIN, "begin",
                 str(root), pod_name, str(pod["securityContext"]["runAsUser"]), *mounts, "--",
                 *(f"{key}={value}" for key, value in environment.items()), *words],
                stdout=output, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        started = Container(process, log, pod["terminationGracePeriodSeconds"] if "terminationGracePeriodSeconds" in pod else 30)
        self.running.append(started)
        return started

    def end(self):
        for container in self.running:
            container.process.kill()
            container.process.wait()


class Container:
    def __init__(self, process, log, grace):
        self.process = process
        self.log = log
        self.grace = grace

    def text(self):
        return self.log.read_text(encoding="utf-8")

    def stop(self):
        """SIGTERM to process 1, as the kubelet sends it; the exit code within the grace period."""
        parent = self.process.pid
        children = pathlib.Path(f"/proc/{parent}/task/{parent}/children").read_text(encoding="utf-8").split()
        os.kill(int(children[0]), signal.SIGTERM)
        return self.wait(self.grace)

    def wait(self, seconds):
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            fail(f"a container does not end within {seconds} s:\n{self.text()}")


def answers(container, probe):
    """Whether a probe of the container succeeds."""
    get = container[probe]["httpGet"]
    port = next(each["containerPort"] for each in container["ports"] if each["name"] == get["port"])
    anyone = ssl.create_default_context()
    anyone.check_hostname = False
    anyone.verify_mode = ssl.CERT_NONE
    try:
        with urllib.request.urlopen(f"{get['scheme'].lower()}://127.0.0.1:{port}{get['path']}", context=anyone,
                                    timeout=container[probe].get("timeoutSeconds", 1)) as answer:
            return answer.status < 400
    except (urllib.error.URLError, OSError):
        return False


def publish(cluster, folder):
    """What the container `publish` does with the Secrets that the invitation has made."""
    for role in ("worker", "submitter"):
        secret = json.loads((folder / "secrets" / f"{role}.json").read_text(encoding="utf-8"))
        check_typed(secret)
        volume = cluster.volume("", {"name": "", "secret": {"secretName": secret["metadata"]["name"]}})
        for key, value in secret["stringData"].items():
            (volume / key).write_text(value, encoding="utf-8")


def digest(folder):
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))["digest"]


def run(cluster, programs):
    work = cluster.work
    job_folder = work / "job"
    job_folder.mkdir()
    write_job(job_folder, "job", 50, 8)
    cdctl = programs / "cdctl"
    local = [cdctl, "run", "job.toml", "--quiet", "--tree-cache", "off", "--out"]
    subprocess.run([*local, "here"], cwd=job_folder, check=True, stdout=subprocess.DEVNULL)

    master_pod = cluster.pods["cdcluster-master"]["containers"][0]
    master = cluster.start("cdcluster-master", "cdcluster-master-0", "master")
    wait_for("the master's probes", lambda: all(
        answers(master_pod, probe) for probe in ("startupProbe", "livenessProbe", "readinessProbe")))

    # The root cannot be written, and nothing can be mounted, by who asks from inside.
    inside = cluster.start("cdcluster-worker", "inside", "worker", command=[
        "sh", "-c", "id -u; grep CapEff /proc/self/status; touch /x || touch /usr/x || echo read-only; touch /tmp/x"])
    if inside.wait(PATIENCE) != 0 or not all(word in inside.text() for word in ("10001", "0000000000000000", "read-only")):
        fail(f"a container is not confined: {inside.text()}")

    # In a cluster each pod has an address of its own, here another port.
    ports = [{}, {"CDWORKER_PEER_PORT": "7602"}]
    workers = [cluster.start("cdcluster-worker", f"worker-{i}", "worker", ports[i]) for i in range(2)]
    invite = cluster.start("cdcluster-invite", "invite", "invite")
    if invite.wait(PATIENCE) != 0:
        fail(f"no invitation: {invite.text()}")
    publish(cluster, cluster.volume("invite", {"name": "join", "emptyDir": {}}))
    wait_for("workers connect", lambda: all("connected: " in worker.text() for worker in workers))

    credential = work / "me.pem"
    token = work / "volumes/cdcluster-join-submitter/token"
    subprocess.run([cdctl, "join", "127.0.0.1:7600", "--token-file", token, "--credential", credential],
                   check=True, stdout=subprocess.DEVNULL)
    there = ["--master", "127.0.0.1:7600", "--credential", credential]
    job = subprocess.run([cdctl, "submit", "job.toml", "--quiet", "--tree-cache", "off", "-o", "name", *there],
                         cwd=job_folder, check=True, capture_output=True, text=True).stdout.strip()

    def done():
        listed = subprocess.run([cdctl, "get", "jobs", "-o", "json", *there], capture_output=True, text=True)
        return sum(int(each["done"]) for each in json.loads(listed.stdout)) if listed.returncode == 0 else 0

    wait_for("results", lambda: done() > 0)
    code = workers[0].stop()
    if code != 0 or "ended: exit_code=0" not in workers[0].text():
        fail(f"a worker does not drain: {code}\n{workers[0].text()}")
    code = master.stop()
    if code != 0:
        fail(f"the master does not end: {code}\n{master.text()}")
    master = cluster.start("cdcluster-master", "cdcluster-master-0", "master")
    wait_for("the master again", lambda: answers(master_pod, "readinessProbe"))
    subprocess.run([cdctl, "wait", job, "--quiet", *there], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([cdctl, "results", job, "--quiet", "--tree-cache", "off", "--out", "there", *there], cwd=job_folder, check=True,
                   stdout=subprocess.DEVNULL)
    if digest(job_folder / "there") != digest(job_folder / "here"):
        fail("the digest is another than that of one process")
    if workers[1].stop() != 0 or master.stop() != 0:
        fail(f"not ended in order:\n{workers[1].text()}\n{master.text()}")
    print("kubernetes: a job has run through the containers")


def main():
    programs = pathlib.Path(sys.argv[2]).resolve()
    with open(sys.argv[1], encoding="utf-8") as file:
        items = [item for item in yaml.safe_load_all(file) if item]
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        cluster = Cluster(items, programs, pathlib.Path(folder))
        try:
            run(cluster, programs)
        finally:
            cluster.end()


if __name__ == "__main__":
    main()
