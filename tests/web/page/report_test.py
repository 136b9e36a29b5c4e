"""Tests a report with the viewer, opened as a file."""
import re
import subprocess

from page_case import PageTest, is_red
from scenes import HOSTILE_MARKUP, pairs_by_scenario


class Report(PageTest):
    def setUp(self):
        self.asked_before = len(self.browser.addresses)

    def report(self, folder):
        """Writes the report of a folder; returns its address."""
        path = self.root / f"{folder.name}.html"
        words = [self.bin / "cdctl", "report", folder, "--3d", "-o", path]
        ran = subprocess.run(list(map(str, words)), capture_output=True, text=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return path.as_uri()

    def addresses(self):
        """The addresses of all requests of this test, but for pictures in the file."""
        self.browser.collect()
        urls = [url for _, url in self.browser.addresses[self.asked_before :]]
        return {url.split("#")[0] for url in urls if not url.startswith(("data:", "about:"))}

    def middle(self):
        left, top, width, height = self.browser.box(".stage canvas")
        return left + width / 2, top + height / 2

    def ask(self, script):
        return self.browser.driver.execute_script(f"return {script}")

    def test_shows_and_checks_a_known_scene_without_any_request(self):
        url = self.report(self.scenes.one_pair())
        link = "#/jobs/folder/0?cam=-9,-0.3,0.3,0,-0.3,0.3&ghost=none&lines=0"
        self.browser.open(url + link)
        facts = self.browser.scenario(0)
        self.assertEqual(facts["class"], "cross")
        self.assertEqual(facts["verified"], True)
        self.assertEqual(facts["shaChecked"], [True, True])
        self.assertEqual(facts["trianglesDrawn"], [12, 1])
        self.assertEqual([len(one) for one in facts["highlighted"]], [1, 1])
        middle = self.middle()
        x, y = self.browser.facts()["pointPixels"][0]
        self.assertTrue(is_red(self.browser.colour(x, y)))
        self.browser.go(link + "&walls=0")
        self.browser.wait("walls", lambda facts: not facts["throughWalls"])
        self.browser.click(*middle)
        facts = self.browser.wait("a pick", lambda facts: facts["pick"])
        self.assertEqual(facts["pick"], {"body": 0, "triangle": 0})
        self.browser.picture("report-viewer")
        # Keys are the viewer's after a click into it.
        self.browser.press_and_draw("x")
        self.assertEqual(self.browser.facts()["throughWalls"], True)
        self.assertEqual(self.browser.facts()["errors"], [])
        self.assertEqual(self.addresses(), {url})

    def test_goes_through_its_scenarios_alone(self):
        folder = self.scenes.grid()
        self.browser.open(self.report(folder))
        facts = self.browser.wait("the worst scenario", lambda f: f.get("scenario") is not None)
        pairs = pairs_by_scenario(folder)

        def touching(scenario):  # A body inside another one touches nothing.
            return [sorted(one) for one in pairs.get(scenario, ([], []))]

        self.assertEqual(facts["highlighted"], touching(facts["scenario"]))
        self.browser.click(*self.middle())
        self.assertEqual(self.ask("document.title"), "cdcluster: grid")
        self.assertLessEqual(self.browser.overflow(), 0)
        paths = self.ask("[...document.querySelectorAll('template[data-path]')].map(one => one.dataset.path)")
        held = sorted(int(path.split("/")[-1]) for path in paths if re.search(r"/scenarios/\d+$", path))
        self.assertEqual(len(held), 20)
        while facts["scenario"] != held[0]:
            self.browser.press("p")
            facts = self.browser.wait("the scenario before", lambda f, last=facts["scenario"]: f["scenario"] < last)
        seen = [held[0]]
        for _ in held[1:]:
            self.browser.press("n")
            facts = self.browser.wait("the next scenario", lambda f: f["scenario"] > seen[-1])
            self.assertEqual(facts["highlighted"], touching(facts["scenario"]))
            self.assertEqual(facts["verified"], True)
            seen.append(facts["scenario"])
        self.assertEqual(seen, held)
        self.browser.press("h")
        self.browser.wait("the heat map", lambda f: f["mode"] == "heat")
        self.browser.press("s")
        self.browser.wait("the section", lambda f: f["clip"])
        self.browser.picture("report-heat")
        self.assertEqual(self.browser.facts()["errors"], [])
        self.assertTrue(self.browser.link().startswith(f"#/jobs/folder/{seen[-1]}"))

    def test_shows_all_bodies_of_a_step_of_a_scene(self):
        self.browser.open(self.report(self.scenes.crossing()))
        facts = self.browser.wait("the step", lambda f: (f.get("scene") or {}).get("form") == "meshes")
        self.assertEqual((facts["scene"]["others"], facts["verified"]), (3, True))
        said = "document.getElementById('page').shadowRoot.textContent"
        self.browser.wait("the note", lambda f: "3 other bodies near another at this step, faint." in self.ask(said))
        self.middle()
        self.browser.picture("report-scene")
        step, seen = facts["scene"]["step"], facts["scenario"]
        pairs = "[...document.getElementById('page').shadowRoot.querySelectorAll('.pairs button')]"
        self.assertEqual(self.ask(f"{pairs}.filter((one) => !one.disabled).length > 1"), True)
        self.browser.driver.execute_script(f"{pairs}.find((one) => one.ariaPressed === 'false' && !one.disabled).click()")
        facts = self.browser.wait("another pair", lambda f: f["scenario"] != seen and f["scene"]["form"] == "meshes")
        self.assertEqual(facts["scene"]["step"], step)
        self.assertEqual(facts["errors"], [])

    def test_leaves_wheel_and_keys_to_the_report_until_it_is_clicked(self):
        self.browser.open(self.report(self.scenes.drive()))
        facts = self.browser.wait("the worst scenario", lambda f: f.get("scenario") is not None)
        middle = self.middle()
        before = self.ask("scrollY")
        self.browser.press("n")
        self.browser.turn_wheel(*middle, 120)
        self.browser.wait("a moved report", lambda f: self.ask("scrollY") > before)
        after = self.browser.facts()
        self.assertEqual((after["camera"], after["scenario"]), (facts["camera"], facts["scenario"]))
        self.browser.click(*self.middle())
        before = self.ask("scrollY")
        self.browser.turn_wheel(*self.middle(), 120)
        self.browser.wait("a zoomed view", lambda f: f["camera"] != facts["camera"])
        self.assertEqual(self.ask("scrollY"), before)

    def test_hostile_names_are_text(self):
        self.browser.open(self.report(self.scenes.hostile()))
        facts = self.browser.scenario(0)
        self.assertEqual(facts["errors"], [])
        self.assertNotEqual(self.ask("document.title"), "broken in")
        self.assertEqual(self.ask("document.querySelectorAll('script').length"), 1)
        shown = "document.getElementById('page').shadowRoot.textContent.includes(arguments[0])"
        self.assertTrue(self.browser.driver.execute_script(f"return {shown}", HOSTILE_MARKUP))

    def test_on_paper_and_without_scripts_it_is_the_report(self):
        driver = self.browser.driver
        url = self.report(self.scenes.drive())
        self.browser.open(url)
        self.browser.wait("the worst scenario", lambda f: True)
        display = "getComputedStyle(document.querySelector('section.viewer')).display"
        self.assertEqual(self.ask(display), "block")
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
        self.assertEqual(self.ask(display), "none")
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
        driver.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
        try:
            self.browser.open(url)
            text = driver.find_element("css selector", "body").text
        finally:
            driver.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": False})
        self.assertIn("runs this file's script", text)
        self.assertIn("Worst scenarios", text)
