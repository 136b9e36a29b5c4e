"""Tests what links open, and that the address follows what is seen."""
import time

from page_case import PageTest


class Links(PageTest):
    def test_every_form_opens_what_it_names(self):
        self.open(self.scenes.grid(), "#/jobs/folder")
        self.browser.wait("the job", lambda facts: facts["screen"] == "job")
        forms = [
            ("mode=heat", lambda f: f["mode"] == "heat"),
            ("ghost=a", lambda f: f["ghost"] == "a"),
            ("ghost=none&walls=0", lambda f: f["ghost"] == "none" and not f["throughWalls"]),
            ("clip=x:0.4", lambda f: f["clip"] == {"axis": "x", "at": 0.4}),
            ("part=lower", lambda f: f["parts"] == ["lower", ""]),
            ("part=a/lower&with=b/probe", lambda f: f["parts"] == ["lower", "probe"]),
            ("pick=b:7", lambda f: f["pick"] == {"body": 1, "triangle": 7}),
            (
                "cam=9,8,7,1,0.5,0.25",
                lambda f: all(abs(a - b) < 1e-3 for a, b in zip(f["camera"], [9, 8, 7, 1, 0.5, 0.25])),
            ),
        ]
        for number, (form, holds) in enumerate(forms):
            with self.subTest(form):
                self.browser.go(f"#/jobs/folder/{500 + number}?{form}")
                self.browser.wait(form, lambda f: f.get("scenario") == 500 + number and holds(f))
        # The address follows what is seen, and opens it again in another tab.
        self.browser.go("#/jobs/folder/520?mode=heat&ghost=a&walls=0&lines=0&clip=z:0.25&part=a/lower&pick=a:3&cam=9,8,7,1,0.5,0")
        before = self.browser.scenario(520)
        time.sleep(0.5)
        link = self.browser.link()
        self.browser.open(self.browser.origin + "/" + link)
        after = self.browser.scenario(520)
        for fact in ("mode", "ghost", "throughWalls", "clip", "parts", "pick", "camera", "highlighted"):
            self.assertEqual(after[fact], before[fact], fact)

    def test_part_of_a_link_shows_its_contacts_alone(self):
        self.open(self.scenes.grid(), "#/jobs/folder/510")
        everything = self.browser.scenario(510)["highlighted"][0]
        found = self.browser.facts()
        for _ in range(40):
            if any(one < 12 for one in everything) and any(one >= 12 for one in everything):
                break
            self.browser.press("n")
            found = self.browser.wait("a step", lambda f, last=found["scenario"]: f["scenario"] != last)
            everything = found["highlighted"][0]
        self.browser.go(f"#/jobs/folder/{found['scenario']}?part=a/lower")
        facts = self.browser.wait("the part", lambda f: f["parts"] == ["lower", ""])
        self.assertEqual(facts["highlighted"][0], [one for one in everything if one < 12])

    def test_addresses_without_a_view_lead_to_the_job(self):
        """The address alone and the list of jobs open the only job of a folder; a wrong address says so."""
        server = self.open(self.scenes.drive())
        self.browser.wait("the job", lambda f: f["screen"] == "job")
        self.browser.open(server.home + "#/jobs")
        self.browser.wait("the job", lambda f: f["link"] == "#/jobs/folder" and f["screen"] == "job")
        self.browser.go("#/jobs/folder/1/2")
        self.browser.wait_text("this address names nothing here")

    def test_back_and_forward(self):
        self.open(self.scenes.drive(), "#/jobs/folder")
        self.browser.wait("the job", lambda facts: facts["screen"] == "job")
        self.browser.go("#/jobs/folder/3")
        self.browser.scenario(3)
        self.browser.press("n")
        after = self.browser.wait("the next contact", lambda f: f["scenario"] != 3)["scenario"]
        self.browser.driver.back()
        self.browser.scenario(3)
        self.browser.driver.back()
        self.browser.wait("the job", lambda facts: facts["screen"] == "job")
        self.browser.driver.forward()
        self.browser.scenario(3)
        self.browser.driver.forward()
        self.browser.scenario(after)

    def test_a_link_is_followed_while_the_last_view_is_noted(self):
        """What a view notes in the address does not replace a link that was followed in the meantime."""
        with self.browser.slow_address(600):
            self.open(self.scenes.drive(), "#/jobs/folder/3")
            self.browser.scenario(3)
            self.browser.press("+")  # The new camera is noted in the address after 200 ms.
            self.browser.go("#/jobs/folder/3?ghost=a")
            self.browser.wait("the ghost", lambda f: f["ghost"] == "a")
            self.assertEqual(self.browser.link(), "#/jobs/folder/3?ghost=a")

    def test_key_leaves_the_address_and_serves_other_tabs(self):
        server = self.open(self.scenes.drive())
        self.browser.wait("the job", lambda facts: facts["screen"] == "job")
        self.assertNotIn(server.key, self.browser.driver.current_url)
        self.browser.open(server.home + "#/jobs/folder/5")
        self.browser.scenario(5)
