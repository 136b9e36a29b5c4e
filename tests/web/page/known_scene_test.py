"""Tests what the viewer draws of a scene whose contacts are known."""

from page_case import PageTest, is_red

# From the front of the box, straight onto its face x = -1.
FRONT = "cam=-9,0,0,0,0,0&lines=0"


class KnownScene(PageTest):
    def test_contact_shows_through_walls_and_not_otherwise(self):
        self.open(self.scenes.one_pair(), f"#/jobs/folder/0?{FRONT}&ghost=none")
        facts = self.browser.scenario(0)
        self.assertEqual(facts["class"], "cross")
        self.assertEqual(facts["verified"], True)
        self.assertEqual(facts["shaChecked"], [True, True])
        self.assertEqual(facts["trianglesDrawn"], [12, 1])
        self.assertEqual([len(one) for one in facts["highlighted"]], [1, 1])
        x, y = facts["pointPixels"][0]
        mirrored = self.mirrored(x, y)
        self.assertTrue(is_red(self.browser.colour(x, y)))
        self.assertFalse(is_red(self.browser.colour(*mirrored)))
        self.browser.picture("viewer-known-light")
        self.browser.press_and_draw("x")
        self.assertFalse(is_red(self.browser.colour(x, y)))

    def mirrored(self, x, y):
        """The point on the other triangle of the box's side."""
        left, top, width, height = self.browser.box(".stage canvas")
        return 2 * left + width - x, 2 * top + height - y

    def test_pick_gives_the_triangle_under_the_pointer(self):
        folder = self.scenes.one_pair()
        # Faces 0 and 1 of the box are those at x = -1; face 0 holds the point y = -0.3, z = 0.3.
        self.open(folder, "#/jobs/folder/0?cam=-9,-0.3,0.3,0,-0.3,0.3&ghost=none&walls=0")
        self.browser.scenario(0)
        left, top, width, height = self.browser.box(".stage canvas")
        self.browser.click(left + width / 2, top + height / 2)
        facts = self.browser.wait("a pick", lambda facts: facts["pick"])
        self.assertEqual(facts["pick"], {"body": 0, "triangle": 0})
        self.assertIn("in 0 pairs here", self.browser.wait_text("in 0 pairs here"))
        # Through walls, what is seen is the contact behind that face.
        self.browser.press_and_draw("x")
        x, y = self.browser.facts()["pointPixels"][0]
        self.browser.click(x, y)
        highlighted = self.browser.facts()["highlighted"]
        facts = self.browser.wait("another pick", lambda facts: facts["pick"] != {"body": 0, "triangle": 0})
        self.assertIn(facts["pick"]["triangle"], highlighted[facts["pick"]["body"]])
        self.browser.wait_text("in 1 pair here")
