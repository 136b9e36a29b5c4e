"""Tests that a group of contacts leads to its contacts: parts that the file names, connected pieces, and bodies
with names of their own."""
import subprocess

from page_case import PageTest
from scenes import BOX_FACES, box, pairs_by_scenario, write_obj

JOB = (
    'name = "pieces"\nunit = "m"\n[a]\nmesh = "pieces.obj"\nname = "van"\n[b]\nmesh = "probe.obj"\nname = "po/st"\n'
    "[poses]\ngrid = { z = [-1, 3.5, 40] }\n"
    '[query]\nlevel = "contacts"\nmaps = true\n[output]\nformats = ["csv", "csv-pairs"]\n'
)


# Bodies of two named parts and of one, along a line on which B meets both parts of A.
TWO_PARTS = (
    'name = "parts"\nunit = "m"\n[a]\nmesh = "a.obj"\n[b]\nmesh = "b.obj"\n'
    "[poses]\ngrid = {{ z = [-1, 3.5, 40] }}\n"
    '[query]\nlevel = "{level}"\nmaps = true\n[output]\nformats = ["csv", "csv-pairs"]\n'
)


class Parts(PageTest):
    def job(self):
        """A job whose A is one part of two boxes, apart from each other: triangles 0 to 11, and 12 to 23."""
        vertices, faces = box()
        upper = [(x, y, z + 2.5) for x, y, z in vertices]
        faces = faces + [tuple(8 + corner for corner in face) for face in BOX_FACES]
        write_obj(self.root / "pieces.obj", [("both", vertices + upper, faces)])
        write_obj(self.root / "probe.obj", [("probe", *box((0.3, 0.2, 0.4)))])
        return self.scenes.job("pieces", JOB)

    def follow_group(self, text):
        """Clicks the worst scenario of the first group whose row has this text; returns what is shown."""
        self.browser.wait_text("parts in contact")
        rows = self.browser.driver.find_elements("css selector", ".table tbody tr")
        row = next(row for row in rows if text in row.text)
        link = row.find_element("css selector", "a")
        self.browser.driver.execute_script("arguments[0].click()", link)
        return self.browser.wait("its contacts", lambda f: f.get("scenario") is not None and f["highlighted"][0])

    def test_a_group_of_pieces_shows_its_contacts_alone(self):
        folder = self.scenes.run("pieces", self.job())
        expected = pairs_by_scenario(folder)
        self.open(folder, "#/jobs/folder")
        for piece, triangles in (("piece 1", range(12)), ("piece 2", range(12, 24))):
            facts = self.follow_group(piece)
            self.assertEqual(facts["parts"], [piece, "probe"])
            listed = sorted(one for one in expected[facts["scenario"]][0] if one in triangles)
            self.assertEqual(facts["highlighted"][0], listed)
            self.assertIn(f"part=van/{piece.replace(' ', '+')}&with=po%5C/st/probe", self.browser.link())
            self.browser.driver.back()
            self.browser.wait("the job", lambda f: f["screen"] == "job")

    def test_next_and_previous_contact_are_of_the_piece(self):
        folder = self.scenes.run("pieces", self.job())
        with_upper = [n for n, (a, _) in sorted(pairs_by_scenario(folder).items()) if max(a) >= 12]
        self.open(folder, f"#/jobs/folder/{with_upper[0]}?part=van/piece 2")
        self.browser.scenario(with_upper[0])
        for following in with_upper[1:4]:
            self.browser.press("n")
            self.browser.scenario(following)
        self.browser.press("p")
        self.browser.scenario(with_upper[2])

    def test_a_picked_triangle_and_the_list_name_the_piece(self):
        folder = self.scenes.run("pieces", self.job())
        scenario = max(n for n, (a, _) in pairs_by_scenario(folder).items() if min(a) >= 12)
        self.open(folder, f"#/jobs/folder/{scenario}?pick=a:14")
        self.browser.scenario(scenario)
        body = self.browser.wait_text("piece 2 2;")
        self.assertIn("piece 2 × probe", body)

    def test_letters_and_names_of_bodies_open_the_same(self):
        folder = self.scenes.run("pieces", self.job())
        self.open(folder, "#/jobs/folder/10")
        self.browser.scenario(10)
        forms = ["part=van/piece 1&with=po\\/st/probe", "part=a/piece 1&with=b/probe", "part=piece 1&with=probe"]
        for number, form in enumerate(forms, 11):
            with self.subTest(form):
                self.browser.go(f"#/jobs/folder/{number}?{form}")
                self.browser.wait(form, lambda f, n=number: f.get("scenario") == n and f["parts"] == ["piece 1", "probe"])

    def test_a_report_knows_the_pieces(self):
        self.job()
        # The report holds all scenarios of so short a job, not only those of the worst class.
        folder = self.scenes.run("few", self.scenes.job("few", JOB.replace("40]", "16]")))
        path = self.root / "pieces.html"
        subprocess.run([self.bin / "cdctl", "report", folder, "--3d", "-o", path], check=True, capture_output=True)
        scenario, (touching, _) = next(iter(pairs_by_scenario(folder).items()))
        piece, triangles = ("piece 1", range(12)) if min(touching) < 12 else ("piece 2", range(12, 24))
        self.browser.open(path.as_uri())
        self.browser.wait("the worst scenario", lambda f: f.get("scenario") is not None)
        self.browser.go(f"#/jobs/folder/{scenario}?part=van/{piece}")
        facts = self.browser.wait("its contacts", lambda f: f["parts"] == [piece, ""] and f["highlighted"][0])
        self.assertTrue(all(one in triangles for one in facts["highlighted"][0]))
        self.assertEqual(facts["errors"], [])

    def open_on_a_master(self, name, job):
        """Runs a job to its end on a cluster, and opens its page."""
        cluster = self.start_cluster(name)
        cluster.add_worker("one")
        cluster.run("cdctl", "submit", job, "--master", cluster.address)
        cluster.run("cdctl", "watch", "last", "--master", cluster.address)
        self.browser.open(f"{cluster.page}#/jobs/{cluster.job()}")

    def test_a_group_on_a_master_leads_to_its_next_contact(self):
        self.open_on_a_master("groups", self.job())
        facts = self.follow_group("both")
        self.assertEqual(facts["parts"], ["both", "probe"])
        self.browser.press("n")
        self.browser.wait("the next contact", lambda f: f["scenario"] > facts["scenario"])

    def two_parts(self, level):
        self.scenes.bodies()
        return self.scenes.job(f"parts_{level}", TWO_PARTS.format(level=level))

    def with_upper(self):
        """The scenarios in which the upper part of A is in contact, which a job with lists of pairs tells."""
        folder = self.scenes.run("parts_contacts", self.two_parts("contacts"))
        found = [n for n, (a, _) in sorted(pairs_by_scenario(folder).items()) if max(a) >= 12]
        self.assertGreater(min(found), min(pairs_by_scenario(folder)))
        return found

    def assert_steps_are_of_the_group(self):
        """From a group of the open page, n and p go through the group's scenarios and no others."""
        expected = self.with_upper()
        worst = self.follow_group("upper")["scenario"]
        for key, following in (("n", expected[expected.index(worst) + 1 :]), ("p", expected[-2::-1])):
            for one in following:
                self.browser.press(key)
                facts = self.browser.scenario(one)
                self.assertEqual(facts["parts"], ["upper", "probe"])
                self.assertTrue(all(triangle >= 12 for triangle in facts["highlighted"][0]))
            self.browser.press(key)
            self.browser.wait_text("no contact after" if key == "n" else "no contact before")

    def test_at_level_count_the_steps_are_of_the_group(self):
        """Where records list no pairs, the scenarios in contact are run again to find those of the group."""
        folder = self.scenes.run("parts_count", self.two_parts("count"))
        self.open(folder, "#/jobs/folder")
        self.assert_steps_are_of_the_group()
        self.browser.go("#/jobs/folder/3?part=a/no such part")
        self.browser.scenario(3)
        self.browser.press("n")
        self.browser.wait_text("the body has no part 'no such part'")

    def test_on_a_master_at_level_count_the_steps_are_of_the_group(self):
        self.open_on_a_master("counted", self.two_parts("count"))
        self.assert_steps_are_of_the_group()
