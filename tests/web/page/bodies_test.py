"""Tests what the page shows of a scene of many bodies."""
import csv

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from page_case import PageTest
from scenes import pairs_by_scenario

CAR_0, CAR_1, CART, WALL, POLE, FLOOR = range(6)
NAMES = ["car.0", "car.1", "cart", "wall", "pole", "floor"]


def rows_of(folder):
    """Returns step and names of the bodies of each scenario, from scenarios.csv."""
    with open(folder / "scenarios.csv", newline="") as file:
        return [(int(row["step"]), row["body_a"], row["body_b"]) for row in csv.DictReader(file)]


def scenario_of(rows, step, a, b):
    return rows.index((step, NAMES[a], NAMES[b]))


class Bodies(PageTest):
    """A crossing of two cars, which share a mesh, and a cart, which shares its mesh with a pole."""

    def setUp(self):
        self.folder = self.scenes.crossing()
        self.rows = rows_of(self.folder)

    def find(self, selector):
        return self.browser.driver.find_element(By.CSS_SELECTOR, selector)

    def drawn(self, number):
        """Waits until a scenario is drawn with the other bodies of its step."""

        def is_there(facts):
            scene = facts.get("scene") or {}
            return facts.get("scenario") == number and scene.get("stepRead") == scene["step"] and scene["form"] != "none"

        return self.browser.wait(f"scenario {number} with its step", is_there)

    def check_crossing(self, job):
        """Checks the scenario in which the cars cross, in a folder or on a master."""
        cars = scenario_of(self.rows, 4, CAR_0, CAR_1)
        self.browser.wait("the job", lambda f: f["screen"] == "job")
        self.browser.go(f"#/jobs/{job}/{cars}")
        facts = self.drawn(cars)
        scene = facts["scene"]
        self.assertEqual((scene["step"], scene["time"], scene["bodies"]), (4, 2, [CAR_0, CAR_1]))
        self.assertEqual(facts["verified"], True)
        self.assertEqual(facts["shaChecked"], [True, True])
        self.assertEqual(facts["trianglesDrawn"], [24, 24])
        pairs = pairs_by_scenario(self.folder)[cars]
        self.assertEqual(facts["highlighted"], [sorted(triangles) for triangles in pairs])
        self.assertEqual((scene["form"], scene["others"]), ("meshes", 3))
        # In the frame of the first car, which stands at (-1, 0.3, 0.8).
        centres = {one["body"]: [round(value, 6) for value in one["centre"]] for one in scene["centres"]}
        self.assertEqual(centres, {CART: [2, 0.3, 0], POLE: [-1, 0.2, 0.2], FLOOR: [1, -0.3, -1]})
        return facts

    def check_filter(self, job):
        """Checks that a job's screen and the search for contacts keep to a body and to steps."""
        wanted = [i for i, row in enumerate(self.rows) if "car.1" in row[1:]]
        self.browser.wait("a screen", lambda f: f["screen"] in ("job", "viewer"))
        self.browser.go(f"#/jobs/{job}?body=car.1")
        self.browser.wait("the scenarios of the car", lambda f: f.get("rows") and f["shown"] == wanted)
        some = [i for i in wanted if 1 <= self.rows[i][0] <= 4]
        self.browser.go(f"#/jobs/{job}?body=car.1&steps=1-4")
        facts = self.browser.wait("some steps", lambda f: f["shown"] == some and f["strip"]["first"] > 0)
        self.assertEqual(self.rows[facts["strip"]["first"]][0], 1)
        self.assertEqual(self.rows[facts["strip"]["end"]][0], 5)
        self.browser.go(f"#/jobs/{job}/{some[0]}?body=car.1&steps=1-4")
        self.browser.scenario(some[0])
        for number in some[1:]:
            self.browser.press("n")
            self.browser.scenario(number)
        self.browser.press("n")
        self.browser.wait_text("no contact after this scenario")
        self.assertIn("body=car.1&steps=1-4", self.browser.link())

    def test_a_pair_is_drawn_among_the_faint_bodies_of_its_step(self):
        self.open(self.folder, "#/jobs/folder")
        self.check_crossing("folder")
        self.browser.wait_text("3 other bodies near another at this step")
        self.assertEqual(self.find(".pair-names").text, "car.0 × car.1")
        self.keep_pictures("scene")

    def test_all_bodies_move_with_a_step_of_motions(self):
        folder = self.scenes.moving_crossing()
        number = scenario_of(rows_of(folder), 2, CAR_0, POLE)
        at = lambda facts, body: next(one["centre"] for one in facts["scene"]["centres"] if one["body"] == body)
        self.open(folder, f"#/jobs/folder/{number}?tau=0")
        facts = self.drawn(number)
        # In the frame of the first car, which goes from x = -3 to x = -2. The cart's y is 1.8, then 1.2.
        wanted = {0: ([4, 1.5, 0], [3, -0.3, -1]), 0.25: ([3.75, 1.35, 0], [2.75, -0.3, -1]), 1: ([3, 0.9, 0], [2, -0.3, -1])}
        for tau, (cart, floor) in wanted.items():
            self.browser.go(f"#/jobs/folder/{number}?tau={tau}")
            facts = self.browser.wait("the time", lambda f, tau=tau: f["motion"]["tau"] == tau and f["scene"]["others"] > 0)
            for body, place in ((CART, cart), (FLOOR, floor)):
                for value, expected in zip(at(facts, body), place):
                    self.assertAlmostEqual(value, expected, delta=1e-6)
        self.keep_pictures("scene-motion")

    def check_parts(self, job):
        """Follows the contacts of the first car's wheel with the other car's body, over all scenarios of a scene."""
        with open(self.folder / "pairs.csv", newline="") as file:
            listed = [(int(row["scenario"]), row["part_a"], row["part_b"]) for row in csv.DictReader(file)]
        found = {n for n, a, b in listed if (a, b) == ("wheel", "body") and self.rows[n][1:] == ("car.0", "car.1")}
        wheels = sorted(found)
        self.assertGreater(wheels[-1] - wheels[0], 1, "others are between")
        self.browser.wait("a screen", lambda f: f["screen"] in ("job", "viewer"))
        self.browser.go(f"#/jobs/{job}/{wheels[0]}?part=car.0/wheel&with=car.1/body")
        facts = self.browser.wait("the wheel", lambda f: f.get("scenario") == wheels[0] and f["parts"] == ["wheel", "body"])
        self.assertTrue(all(one >= 12 for one in facts["highlighted"][0]))
        self.browser.wait_text("only car.0/wheel × car.1/body")
        for number in wheels[1:]:
            self.browser.press("n")
            facts = self.browser.scenario(number)
            self.assertEqual(facts["parts"], ["wheel", "body"])
        self.browser.press("n")
        self.browser.wait_text("no contact after this scenario")

    def test_the_next_contact_is_of_the_parts_of_two_bodies(self):
        self.open(self.folder, "#/jobs/folder")
        self.check_parts("folder")
        self.keep_pictures("scene-parts")

    def test_the_part_of_one_body_is_found_with_all_other_bodies(self):
        pairs = pairs_by_scenario(self.folder)
        side = lambda n: self.rows[n][1:].index("car.1") if "car.1" in self.rows[n][1:] else -1
        wheels = [n for n in sorted(pairs) if side(n) >= 0 and max(pairs[n][side(n)]) >= 12]
        self.assertGreater(len({self.rows[n][1:] for n in wheels}), 1, "with several bodies, as A and as B")
        part = ["part", "with"][side(wheels[0])]
        self.open(self.folder, f"#/jobs/folder/{wheels[0]}?{part}=car.1/wheel")
        self.browser.scenario(wheels[0])
        for number in wheels[1:]:
            self.browser.press("n")
            facts = self.browser.scenario(number)
            self.browser.wait("its part", lambda f, n=number: f["parts"][side(n)] == "wheel")
        self.assertEqual(facts["errors"], [])

    def test_a_group_leads_to_the_contacts_of_its_parts(self):
        self.open(self.folder, "#/jobs/folder")
        self.browser.wait_text("parts in contact")
        self.find("[aria-label='parts whose name holds']").send_keys("car.1/wheel")
        self.browser.wait_frames()
        rows = self.browser.driver.find_elements(By.CSS_SELECTOR, "[aria-label='parts in contact'] tbody tr")
        self.assertGreater(len(rows), 0)
        self.assertTrue(all("car.1/wheel" in row.text for row in rows))
        link = rows[0].find_element(By.CSS_SELECTOR, "a")
        self.browser.driver.execute_script("arguments[0].click()", link)
        facts = self.browser.wait("its contacts", lambda f: f.get("scenario") is not None and f["highlighted"][0])
        self.assertIn("wheel", facts["parts"])

    def test_bodies_with_one_mesh_read_it_once(self):
        self.browser.collect()
        before = len(self.browser.addresses)
        self.open(self.folder, "#/jobs/folder/0")
        for number in range(len(self.rows)):
            self.browser.go(f"#/jobs/folder/{number}")
            self.drawn(number)
        self.browser.collect()
        meshes = [url for _, url in self.browser.addresses[before:] if "/api/v1/meshes/" in url]
        self.assertEqual(len(meshes), 4)
        self.assertEqual(len(set(meshes)), 4)

    def test_the_other_bodies_can_be_left_out(self):
        number = scenario_of(self.rows, 4, CAR_0, CAR_1)
        self.open(self.folder, f"#/jobs/folder/{number}")
        pixels = [one["pixel"] for one in self.drawn(number)["scene"]["centres"]]
        with_others = [self.browser.colour(*pixel) for pixel in pixels]
        self.browser.go(f"#/jobs/folder/{number}?others=0")
        self.browser.wait("the pair alone", lambda f: f.get("scene") and f["scene"]["others"] == 0)
        self.browser.wait_frames()
        self.assertNotEqual([self.browser.colour(*pixel) for pixel in pixels], with_others)
        self.assertIn("others=0", self.browser.link())

    def test_steps_keep_to_the_pair_where_it_is_tested(self):
        begin = scenario_of(self.rows, 3, CAR_0, POLE)
        self.open(self.folder, f"#/jobs/folder/{begin}")
        self.drawn(begin)
        self.find(".steps button:nth-of-type(2)").click()
        self.drawn(scenario_of(self.rows, 4, CAR_0, POLE))
        self.browser.press(".")
        self.drawn(next(i for i, row in enumerate(self.rows) if row[0] == 5))
        self.browser.press(",")
        self.browser.wait("step 4", lambda f: f["scene"]["step"] == 4)
        slider = self.find(".steps input[type=range]")
        slider.send_keys(Keys.HOME)
        self.browser.wait("the first step", lambda f: f["scene"]["step"] == 0)

    def test_the_list_and_a_click_on_a_faint_body_lead_to_its_scenarios(self):
        number = scenario_of(self.rows, 4, CAR_0, CAR_1)
        self.open(self.folder, f"#/jobs/folder/{number}")
        self.drawn(number)
        listed = lambda: self.find("[aria-label='pairs of this body']").get_attribute("value")
        for one in self.drawn(number)["scene"]["centres"]:
            self.browser.click(*one["pixel"])
            self.browser.wait_frames()
            if listed() == NAMES[one["body"]]:
                break
        self.assertIn(listed(), ["cart", "pole", "floor"])
        buttons = self.browser.driver.find_elements(By.CSS_SELECTOR, "[aria-label='pairs of bodies at this step'] li button")
        here = [i for i, row in enumerate(self.rows) if row[0] == 4 and listed() in row[1:]]
        self.assertEqual(len(buttons), len(here))
        buttons[0].click()
        self.browser.wait("a scenario of the body", lambda f: f.get("scenario") in here)

    def test_a_filter_is_kept_by_the_screens(self):
        self.open(self.folder, "#/jobs/folder")
        self.check_filter("folder")

    def test_the_table_of_bodies_counts_and_chooses(self):
        self.open(self.folder, "#/jobs/folder")
        self.browser.wait("the bodies", lambda f: f.get("rows") == len(self.rows))
        self.browser.wait_text("6 bodies of 4 meshes")
        table = self.find("[aria-label='bodies'] table").text
        for name in NAMES:
            contacts = sum(name in row[1:] for row in self.rows)
            self.assertRegex(table, rf"{name.replace('.', '[.]')} {contacts} {contacts} ")
        self.find("[aria-label='bodies whose name holds']").send_keys("car.")
        self.browser.wait_frames()
        names = [one.text for one in self.browser.driver.find_elements(By.CSS_SELECTOR, "[aria-label='bodies'] td .link")]
        self.assertEqual(sorted(names), ["car.0", "car.1"])
        self.find("[aria-label='bodies'] td .link").click()
        self.browser.wait("one body", lambda f: len(f["shown"]) < len(self.rows))
        self.browser.wait("the link", lambda f: self.browser.link().endswith(f"?body={names[0]}"))
        self.keep_pictures("scene-job")

    def test_episodes_are_those_of_the_run(self):
        self.open(self.folder, "#/jobs/folder")
        self.browser.wait("the bodies", lambda f: f.get("rows") == len(self.rows))
        with open(self.folder / "episodes.csv", newline="") as file:
            wanted = [(row["body_a"], row["body_b"], row["first_step"], row["last_step"]) for row in csv.DictReader(file)]
        rows = self.browser.driver.find_elements(By.CSS_SELECTOR, "[aria-label='episodes'] tbody tr")
        found = [tuple(row.text.split()[:4]) for row in rows]
        self.assertEqual(sorted(found), sorted(wanted))

    def test_a_job_of_a_master_is_shown_alike(self):
        cluster = self.start_cluster("crossing_master")
        cluster.add_worker("one")
        cluster.run("cdctl", "run", self.scenes.crossing_job(), "--master", cluster.address, "--quiet")
        job = cluster.job()
        self.browser.open(f"{cluster.page}#/jobs/{job}")
        self.check_crossing(job)
        self.check_filter(job)
        self.check_parts(job)

    def test_above_two_hundred_bodies_boxes_are_drawn(self):
        self.open(self.scenes.crowd(202), "#/jobs/folder/0")
        scene = self.drawn(0)["scene"]
        self.assertEqual((scene["form"], scene["others"]), ("boxes", 201))
        self.browser.wait_text("201 other bodies: boxes only")
        self.keep_pictures("scene-boxes")
