"""Tests that names and messages of others are shown as text only."""
import json

from page_case import PageTest
from scenes import HOSTILE_LONG, HOSTILE_MARKUP, HOSTILE_RTL


class ForeignWords(PageTest):
    def assert_text(self, *words):
        """Asserts that the page shows these words, has made no element of them, and is not too wide."""
        ask = self.browser.driver.execute_script
        script = "return arguments[0].map(one => document.body.textContent.includes(one))"
        self.assertEqual(ask(script, words), [True] * len(words))
        count = "return ['img', 'script'].map(one => document.querySelectorAll(one).length)"
        self.assertEqual(ask(count), [1, 1])  # The page's own icon and script.
        self.assertNotEqual(ask("return document.title"), "broken in")
        self.assertEqual(self.browser.facts()["errors"], [])
        self.assertLessEqual(self.browser.overflow(), 0)

    def assert_isolated(self, word):
        """Asserts that a word stands in an element of its own that ends its writing direction."""
        script = (
            "return [...document.querySelectorAll('bdi')].filter(one => one.textContent === arguments[0])"
            ".map(one => getComputedStyle(one).unicodeBidi)"
        )
        found = self.browser.driver.execute_script(script, word)
        self.assertTrue(found)
        self.assertEqual(set(found), {"isolate"})

    def test_names_of_jobs_parts_and_poses(self):
        """Names in a results folder are text on the job's screen and in the viewer."""
        self.open(self.scenes.hostile(), "#/jobs/folder")
        self.browser.wait("the job", lambda f: f["screen"] == "job")
        self.assert_text(HOSTILE_MARKUP, HOSTILE_RTL, HOSTILE_LONG[:300])
        self.browser.picture("job-hostile-light")
        self.browser.go("#/jobs/folder/0")
        self.browser.scenario(0)
        self.assert_text(HOSTILE_MARKUP, HOSTILE_RTL, HOSTILE_LONG[:300])
        self.browser.picture("viewer-hostile-light")
        self.browser.go("#/jobs/folder/1")
        self.browser.scenario(1)

    def test_names_of_workers_and_of_a_masters_jobs(self):
        """A worker's and a job's name are text on the screens of the cluster and of the jobs."""
        cluster = self.start_cluster("foreign")
        for name in (HOSTILE_MARKUP, HOSTILE_RTL):
            cluster.add_worker(name)
        cluster.submit(self.scenes, HOSTILE_MARKUP)
        self.browser.open(cluster.page + "#/cluster")
        self.browser.wait("workers and a job", lambda f: len(f.get("workers") or []) == 2 and f["jobs"])
        self.assert_text(HOSTILE_MARKUP, HOSTILE_RTL)
        self.assert_isolated(HOSTILE_RTL)
        self.browser.picture("cluster-hostile-light")
        self.browser.go("#/jobs")
        self.browser.wait("the jobs", lambda f: f["screen"] == "jobs")
        self.assert_text(HOSTILE_MARKUP)

    def test_failures(self):
        """The failure of a scenario and that of a job are text; the words are put into the server's JSON."""
        words = HOSTILE_MARKUP + HOSTILE_RTL
        failed = f"json.failure = {json.dumps(words)}; json.state = json.class = 'failed'; json.verified = null"
        server = self.view(self.scenes.one_pair())
        with self.browser.lie("/jobs/folder", failed):
            self.browser.open(server.url + "&/jobs/folder")
            self.browser.wait("the job", lambda f: f["screen"] == "job")
            self.assert_text(words)
            self.assert_isolated(words)
        with self.browser.lie("/scenarios/0", failed):
            self.browser.open(server.url + "&/jobs/folder/0")
            self.assertEqual(self.browser.scenario(0)["class"], "failed")
            self.assert_text(words)
            self.assert_isolated(words)
            self.browser.picture("viewer-failed-light")
