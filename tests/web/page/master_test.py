"""Tests the page of a master."""
import time

from cluster import Cluster
from page_case import PageTest
from servers import ask, slow_reader


class Master(PageTest):
    def test_counts_grow_and_a_killed_worker_turns_lost(self):
        with Cluster(self.bin, self.root / "cluster") as cluster:
            doomed = cluster.add_worker("doomed")
            cluster.add_worker("steady")
            cluster.submit(self.scenes)
            self.browser.open(cluster.page + "#/cluster")
            facts = self.browser.wait("two workers", lambda f: len(f.get("workers") or []) == 2 and f["jobs"])
            done = facts["jobs"][0]["done"]
            self.browser.wait("more results", lambda f: f["jobs"][0]["done"] > done)
            self.browser.picture("cluster-light")
            doomed.process.kill()
            self.browser.wait("a lost worker", lambda f: any(w["state"].startswith("lost") for w in f["workers"]))
            rows = self.browser.driver.find_elements("css selector", ".table tbody tr")
            self.assertIn("doomed", rows[0].text)
            self.browser.colours("dark")
            self.browser.picture("cluster-dark")
            self.browser.colours("light")
            job = facts["jobs"][0]["job"]
            self.browser.go(f"#/jobs/{job}")
            before = self.browser.wait("the job", lambda f: f["screen"] == "job")["done"]
            self.browser.wait("more results", lambda f: f["done"] > before)
            self.browser.picture("job-running-light")

    def test_role_metrics_sees_the_cluster_and_no_mesh(self):
        with Cluster(self.bin, self.root / "roles", has_identity=True) as cluster:
            metrics, submitter = cluster.credential("metrics"), cluster.credential("submitter")
            mesh = "/api/v1/meshes/" + 64 * "0"
            self.assertEqual(cluster.status("/"), 200)
            self.assertIn(cluster.status("/api/v1/cluster"), (401, 403))
            self.assertEqual(cluster.status("/api/v1/cluster", metrics), 200)
            self.assertEqual(cluster.status(mesh, metrics), 403)
            self.assertEqual(cluster.status("/api/v1/jobs/j-1", metrics), 403)
            self.assertEqual(cluster.status(mesh, submitter), 404)

    def test_slow_readers_do_not_slow_the_probes(self):
        with Cluster(self.bin, self.root / "slow") as cluster:
            readers = [slow_reader(cluster.http, "/app.js", {}) for _ in range(64)]
            try:
                begin = time.monotonic()
                self.assertEqual(ask(cluster.http, "/healthz")[0], 200)
                self.assertLess(time.monotonic() - begin, 2)
            finally:
                for reader in readers:
                    reader.close()
