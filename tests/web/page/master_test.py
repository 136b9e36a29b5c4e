"""Tests the page of a master while its cluster works."""
import re
import time

from cluster import Cluster
from page_case import PageTest
from servers import ask, slow_reader

RETURN_SECONDS = 3  # Until a worker whose connection broke is lost.
SLACK_SECONDS = 45


def said_by(label):
    """Returns the numbers that a chart says it ends with, by line: 'wire: out 3.1 MB/s, in 40 B/s'."""
    values = re.findall(r"([a-z][a-z ]*) ([\d.]+)", label.split(": ", 1)[1])
    return {title.strip(): float(value) for title, value in values}


class RunningJob(PageTest):
    """A cluster of two workers with a job of minutes, which all tests of this class look at."""

    @classmethod
    def setUpClass(cls):
        cls.cluster = cls.enterClassContext(Cluster(cls.bin, cls.root / "running"))
        for name in ("steady", "calm"):
            cls.cluster.add_worker(name)
        cls.cluster.submit(cls.scenes)

    def open_cluster(self):
        """Opens the cluster's screen; returns the facts once both workers and the job are there."""
        self.browser.open(self.cluster.page + "#/cluster")
        return self.browser.wait("the workers", lambda f: len(f.get("workers") or []) == 2 and f["jobs"])

    def charts(self):
        labels = self.browser.driver.execute_script(
            "return [...document.querySelectorAll('.chart [role=img]')].map(one => one.ariaLabel)"
        )
        return {label.split(":")[0]: said_by(label) for label in labels}

    def test_counts_and_charts_follow_the_work(self):
        """Counts grow, and the charts' last values of throughput and of the wire become positive."""
        job = self.open_cluster()["jobs"][0]
        self.browser.wait("more results", lambda f: f["jobs"][0]["done"] > job["done"])
        moving = [("throughput", "scenarios"), ("wire", "out"), ("wire", "in")]
        self.browser.wait(
            "moving charts", lambda f: (now := self.charts()) and all(now[one][line] > 0 for one, line in moving)
        )
        self.assertEqual(set(self.charts()["wire"]), {"out", "in", "peer to peer"})
        self.assertEqual(self.browser.facts()["jobs"][0]["state"], "running")

    def test_the_map_of_the_pose_space_fills_while_the_job_runs(self):
        """More and more of the scenarios that a job's screen shows are tested, without a reload."""
        job = self.open_cluster()["jobs"][0]["job"]
        self.browser.go(f"#/jobs/{job}")
        facts = self.browser.wait("the job", lambda f: f["screen"] == "job" and f.get("poseSpace"))
        self.browser.driver.execute_script("window.isSamePage = true")
        for _ in range(2):
            last = facts["tested"]
            facts = self.browser.wait("a fuller map", lambda f: f["tested"] > last)
        self.assertTrue(self.browser.driver.execute_script("return window.isSamePage"))

    def test_a_running_job_is_described_once(self):
        """While the job runs its screen asks for its progress alone."""
        job = self.open_cluster()["jobs"][0]["job"]
        self.browser.collect()
        before = len(self.browser.addresses)
        self.browser.go(f"#/jobs/{job}")
        facts = self.browser.wait("the job", lambda f: f["screen"] == "job" and f["ready"])
        for _ in range(3):
            last = facts["done"]
            facts = self.browser.wait("more results", lambda f: f["done"] > last)
        self.browser.collect()
        asked = [url for _, url in self.browser.addresses[before:]]
        self.assertEqual(sum(url.endswith(f"/jobs/{job}") for url in asked), 1)
        self.assertGreater(sum(url.endswith(f"/jobs/{job}/progress") for url in asked), 2)

    def test_each_link_opens_its_screen(self):
        """The address alone and the links of all screens open what they name while the job runs."""
        job = self.open_cluster()["jobs"][0]["job"]
        screens = {"": "cluster", "#/cluster": "cluster", "#/jobs": "jobs", f"#/jobs/{job}": "job"}
        for link, screen in {**screens, f"#/jobs/{job}/0": "viewer"}.items():
            self.browser.open(self.cluster.page + link)
            self.browser.wait(screen, lambda f: f["screen"] == screen)
        self.assertEqual(self.browser.facts()["shaChecked"], [True, True])

    def test_the_list_of_jobs_opens_a_job(self):
        """The bar leads to the list of jobs, and a row of it to its job."""
        job = self.open_cluster()["jobs"][0]["job"]
        self.follow("nav a[href='#/jobs']")
        facts = self.browser.wait("the jobs", lambda f: f["screen"] == "jobs")
        self.assertEqual(facts["jobs"], [job])
        self.follow(f".table a[href='#/jobs/{job}']")
        self.browser.wait("the job", lambda f: f["screen"] == "job" and f["job"] == job)
        self.follow("nav a[href='#/cluster']")
        self.browser.wait("the cluster", lambda f: f["screen"] == "cluster")

    def follow(self, selector):
        self.browser.driver.execute_script("document.querySelector(arguments[0]).click()", selector)

    def test_pictures(self):
        """Keeps pictures of all screens of a master, in light and dark; none is wider than a phone."""
        job = self.open_cluster()["jobs"][0]["job"]
        screens = {"cluster": "#/cluster", "jobs": "#/jobs", "job-running": f"#/jobs/{job}"}
        for name, link in screens.items():
            self.browser.go(link)
            self.browser.wait(name, lambda f: f["link"] == link)
            self.keep_pictures(name)


class Master(PageTest):
    def test_a_killed_worker_turns_lost_within_its_time(self):
        """A worker that is killed is shown as lost, first of all workers, once it had the time to return."""
        cluster = self.start_cluster("cluster", "--return-within", RETURN_SECONDS)
        cluster.add_worker("a steady one")
        doomed = cluster.add_worker("doomed")
        cluster.submit(self.scenes)
        self.browser.open(cluster.page + "#/cluster")
        self.browser.wait("two workers", lambda f: len(f.get("workers") or []) == 2 and f["jobs"])
        begin = time.monotonic()
        doomed.process.kill()
        facts = self.browser.wait("a lost worker", lambda f: self.state(f, "doomed").startswith("lost"))
        waited = time.monotonic() - begin
        self.assertGreaterEqual(waited, RETURN_SECONDS)
        self.assertLess(waited, RETURN_SECONDS + SLACK_SECONDS)
        self.assertFalse(self.state(facts, "a steady one").startswith("lost"))
        rows = self.browser.driver.find_elements("css selector", ".table tbody tr")
        self.assertIn("doomed", rows[0].text)
        self.browser.picture("cluster-lost-light")
        done = facts["jobs"][0]["done"]
        self.browser.wait("results of the other", lambda f: f["jobs"][0]["done"] > done)

    def test_a_job_that_ends_is_described_again(self):
        """Digest and groups appear, without a reload, where the job was opened before it had a worker."""
        self.scenes.grid()
        cluster = self.start_cluster("ending")
        cluster.run("cdctl", "submit", self.scenes.root / "grid.toml", "--master", cluster.address)
        self.browser.open(f"{cluster.page}#/jobs/{cluster.job()}")
        facts = self.browser.wait("the job", lambda f: f["screen"] == "job" and f["ready"])
        total = 21 * 17 * 3 * 3
        self.assertLess(facts["done"], total, "of poses far apart the master needs no worker")
        cluster.add_worker("late")
        self.browser.wait("the end", lambda f: f["done"] == total)
        self.browser.wait_text("digest")
        self.browser.wait_text("parts in contact")

    @staticmethod
    def state(facts, worker):
        return next(one["state"] for one in facts["workers"] if one["name"] == worker)

    def test_role_metrics_sees_the_cluster_and_no_mesh(self):
        """Whoever has the role metrics may read the cluster's status, but no job and no mesh."""
        cluster = self.start_cluster("roles", has_identity=True)
        metrics, submitter = cluster.credential("metrics"), cluster.credential("submitter")
        mesh = "/api/v1/meshes/" + 64 * "0"
        self.assertEqual(cluster.status("/"), 200)
        self.assertIn(cluster.status("/api/v1/cluster"), (401, 403))
        self.assertEqual(cluster.status("/api/v1/cluster", metrics), 200)
        self.assertEqual(cluster.status(mesh, metrics), 403)
        self.assertEqual(cluster.status("/api/v1/jobs/j-1", metrics), 403)
        self.assertEqual(cluster.status(mesh, submitter), 404)

    def test_slow_readers_do_not_slow_the_probes(self):
        """A probe is answered while 64 clients read nothing of what they asked for."""
        cluster = self.start_cluster("slow")
        readers = [slow_reader(cluster.http, "/app.js", {}) for _ in range(64)]
        try:
            begin = time.monotonic()
            self.assertEqual(ask(cluster.http, "/healthz")[0], 200)
            self.assertLess(time.monotonic() - begin, 2)
        finally:
            for reader in readers:
                reader.close()
