"""Tests that the page shows what was tested, and only to those who have the key."""
import shutil

from page_case import PageTest
from servers import ask


class Trust(PageTest):
    def test_damaged_mesh_is_not_the_tested_geometry(self):
        folder = self.root / "damaged"
        shutil.copytree(self.scenes.one_pair(), folder)
        server = self.view(folder)
        mesh = max((folder / "inputs" / "meshes").iterdir(), key=lambda path: path.stat().st_size)
        data = bytearray(mesh.read_bytes())
        data[40] ^= 1  # A bit of a coordinate.
        mesh.write_bytes(data)
        self.browser.open(server.url + "&/jobs/folder/0")
        self.browser.wait_text("not the tested geometry")
        facts = self.browser.scenario(0)
        self.assertEqual(sorted(facts["shaChecked"]), [False, True])
        self.browser.picture("viewer-damaged-light")

    def test_a_record_that_a_second_run_does_not_give_is_told_with_both(self):
        """A stored record that differs from the one of the run here makes a red bar that names both."""
        folder = self.root / "wrong_record"
        shutil.copytree(self.scenes.one_pair(), folder)
        shutil.copy(self.scenes.no_pair() / "records", folder / "records")
        self.open(folder, "#/jobs/folder/0")
        facts = self.browser.scenario(0)
        self.assertEqual((facts["verified"], facts["class"]), (False, "separate"))
        bars = self.browser.driver.find_elements("css selector", ".notice.bad")
        self.assertEqual(len(bars), 1)
        self.assertIn("the record says separate with 0 pairs, a second run here cross with 1 pair", bars[0].text)
        self.assertNotIn("✓ verified", self.browser.driver.find_element("css selector", "main").text)
        self.browser.picture("viewer-wrong-record-light")

    def test_requests_without_a_right_are_refused(self):
        server = self.view(self.scenes.one_pair())
        key = {"Authorization": f"Bearer {server.key}"}
        self.assertEqual(ask(server.port, "/api/v1/jobs", headers=key)[0], 200)
        self.assertEqual(ask(server.port, "/api/v1/jobs")[0], 401)
        self.assertEqual(ask(server.port, "/api/v1/jobs", headers={"Authorization": "Bearer " + 32 * "0"})[0], 401)
        self.assertEqual(ask(server.port, "/api/v1/jobs", "POST", headers=key)[0], 405)
        self.assertEqual(ask(server.port, "/", "POST")[0], 405)
        for path in ("/", "/api/v1/jobs"):
            self.assertEqual(ask(server.port, path, headers=key, host="evil.example")[0], 421)
        status, headers, body = ask(server.port, "/", "HEAD")
        self.assertEqual((status, body), (200, b""))
        policy = headers["Content-Security-Policy"]
        self.assertIn("default-src 'none'", policy)
        self.assertNotIn("unsafe", policy)
        self.assertNotIn("Set-Cookie", headers)

    def test_page_without_its_key_says_so(self):
        server = self.view(self.scenes.one_pair())
        self.browser.open(server.home)
        self.browser.driver.execute_script("localStorage.clear()")
        self.browser.open(server.home)
        self.browser.wait_text("key")
