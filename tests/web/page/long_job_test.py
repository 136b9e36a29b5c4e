"""Tests jobs that are longer than what the page asks for at once: searches, slices and windows on a master, and
exact pictures of a folder."""
import time

from selenium.webdriver.common.keys import Keys

from page_case import PageTest

BODIES = 'unit = "m"\n[a]\nmesh = "a.obj"\n[b]\nmesh = "b.obj"\n'


class LongJobs(PageTest):
    def run_job(self, cluster, name, poses, level="count"):
        """Runs a job on the cluster to its end; returns its id."""
        self.scenes.bodies()
        text = f'name = "{name}"\n{BODIES}[poses]\ngrid = {poses}\n[query]\nlevel = "{level}"\n'
        cluster.run("cdctl", "submit", self.scenes.job(name, text), "--master", cluster.address)
        cluster.run("cdctl", "watch", "last", "--master", cluster.address)
        return cluster.job()

    def test_a_search_goes_on_until_the_next_contact_of_a_sparse_job(self):
        cluster = self.start_cluster("sparse")
        cluster.add_worker("one")
        # B moves towards A in 400,000 steps. Only the last scenarios are in contact.
        job = self.run_job(cluster, "sparse", "{ x = [-40000, 0, 400001] }")
        self.browser.open(f"{cluster.page}#/jobs/{job}/0")
        self.browser.scenario(0)
        script = (
            "const note = document.querySelector('.scrub .note'); window.said = [];"
            "new MutationObserver(() => said.push(note.textContent))"
            ".observe(note, {childList: true, characterData: true, subtree: true})"
        )
        self.browser.driver.execute_script(script)
        self.browser.press("n")
        found = self.browser.wait("the contact", lambda f: f["scenario"] > 0)
        self.assertGreater(found["scenario"], 399_900)
        self.assertNotEqual(found["class"], "separate")
        said = self.browser.driver.execute_script("return said")
        self.assertTrue(any(text.startswith("searching, at #") for text in said), said)
        self.browser.press("p")
        self.browser.wait_text("no contact before this scenario")

    def test_a_search_ends_when_the_user_does_something_else(self):
        cluster = self.start_cluster("ended")
        cluster.add_worker("one")
        job = self.run_job(cluster, "ended", "{ x = [-40000, -10, 400001] }")
        self.browser.open(f"{cluster.page}#/jobs/{job}/0")
        self.browser.scenario(0)
        # Answers come when the test lets them.
        self.browser.driver.execute_script(
            "const ask = window.fetch; window.asked = 0;"
            "window.fetch = (path, options) => { if (!path.includes('/next')) return ask(path, options);"
            "asked += 1; return new Promise((done, fail) => {"
            "options.signal.addEventListener('abort', () => { window.ended = true; fail(options.signal.reason); });"
            "if (asked < 3) ask(path, options).then(done, fail); }); }"
        )
        self.browser.press("n")
        self.browser.wait_text("searching, at #")
        self.browser.press(Keys.ARROW_RIGHT)
        self.browser.scenario(1)
        self.assertTrue(self.browser.driver.execute_script("return window.ended"))
        self.browser.press("n")
        self.browser.press(Keys.ESCAPE)
        asked = self.browser.driver.execute_script("return asked")
        time.sleep(0.3)
        self.assertEqual(self.browser.driver.execute_script("return asked"), asked)
        self.assertNotIn("no contact after", self.browser.wait_text("next contact"))

    def test_a_slice_of_a_long_grid_is_read_by_itself(self):
        cluster = self.start_cluster("slices")
        cluster.add_worker("one")
        job = self.run_job(cluster, "slices", "{ x = [-4, 4, 50], y = [-2, 2, 50], yaw_deg = [0, 90, 40] }")
        self.browser.open(f"{cluster.page}#/jobs/{job}?at=yaw:90")
        self.browser.wait_text("yaw 90°")
        facts = self.browser.wait(
            "the slice", lambda f: f.get("poseSpace") and f["poseSpace"]["height"] == 1 / 50 and f["poseSpace"]["width"] == 1 / 50
        )
        spot = facts["poseSpace"]
        self.assertEqual(spot["scenario"] % 40, 39)
        self.assertNotIn("other axes folded", self.browser.wait_text("pose space"))
        left, top, width, height = self.browser.box(".plot canvas")
        self.browser.click(left + width * (spot["x"] + 0.01), top + height * (1 - spot["y"] - 0.01))
        self.browser.scenario(spot["scenario"])

    def test_a_window_of_a_running_job_follows_its_results(self):
        cluster = self.start_cluster("follows")
        cluster.add_worker("one")
        cluster.submit(self.scenes)
        job = cluster.job()
        self.browser.open(f"{cluster.page}#/jobs/{job}")
        done = self.browser.wait("results", lambda f: f["screen"] == "job" and f["done"] > 0)["done"]
        first = done + 400_000
        self.browser.go(f"#/jobs/{job}?from={first}&to={first + 1023}")
        self.browser.wait("an exact window", lambda f: f["strip"]["isExact"] and f["strip"]["first"] == first)
        shown = self.browser.facts()["strip"]["shown"]
        self.browser.wait("more results", lambda f: f["strip"]["shown"] > shown or f["strip"]["shown"] == 1024)

    def test_a_folder_of_many_poses_is_exact(self):
        count = 1_100_000  # So many that the page keeps the two coordinates that it draws.
        rows = ((f"{i * 8e-6 - 4:.6f}", f"{i * 7919 % count * 8e-6 - 4:.6f}") for i in range(count))
        poses = self.scenes.poses("exact", "x,z", rows)
        folder = self.scenes.run("exact", *self.scenes.bodies(), "--poses", poses, "--level", "count")
        self.open(folder, "#/jobs/folder")
        facts = self.browser.wait("the pose space", lambda f: f["screen"] == "job" and f.get("poseSpace"))
        self.assertEqual((facts["isExact"], facts["tested"]), (True, count))
        self.assertEqual(facts["poseSpace"]["axes"], ["x", "z"])
        self.assertNotIn("a sample of", self.browser.wait_text("share of contacts in each cell"))
        # The number of scenarios in a cell is that of all poses, not of a sample.
        self.assertAlmostEqual(facts["poseSpace"]["width"], 1 / 128)
        said = facts["poseSpace"]["text"].split(" scenarios")[0].replace("\u202f", "")
        self.assertGreater(int(said), count / 128**2 / 2)
        self.browser.driver.execute_script(
            "const choice = document.querySelector('.controls select');"
            "choice.value = 'distance'; choice.dispatchEvent(new Event('change', {bubbles: true}))"
        )
        self.browser.wait("another axis", lambda f: f.get("poseSpace") and f["poseSpace"]["axes"][0] == "distance")

    def test_a_large_seed_is_shown_whole(self):
        seed = 2**63 - 1
        folder = self.scenes.run("seed", *self.scenes.bodies(), "--random", 5, "--seed", seed, "--level", "count")
        self.open(folder, "#/jobs/folder")
        self.browser.wait_text(f"seed {seed}")


class Drawing(PageTest):
    def test_why_nothing_is_drawn_is_said(self):
        server = self.view(self.scenes.drive())
        with self.browser.lie("/scenarios/45", "json.draw_note = 'it takes too long'; json.exact_pairs = 0"):
            self.browser.open(server.url + "&/jobs/folder/45")
            facts = self.browser.scenario(45)
            self.assertEqual(facts["highlighted"], [[], []])
            self.browser.wait_text("nothing is drawn: it takes too long")
