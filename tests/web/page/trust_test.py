"""Tests that the page shows what was tested, as text, to those who have the key."""
import shutil

from page_case import PageTest
from scenes import HOSTILE_LONG, HOSTILE_MARKUP, HOSTILE_RTL
from servers import ask


class Trust(PageTest):
    def test_hostile_names_are_text(self):
        self.open(self.scenes.hostile(), "#/jobs/folder")
        self.browser.wait("the job", lambda f: f["screen"] == "job")
        self.browser.picture("job-hostile-light")
        self.browser.go("#/jobs/folder/0")
        facts = self.browser.scenario(0)
        self.assertEqual(facts["errors"], [])
        self.browser.picture("viewer-hostile-light")
        script = (
            "return [document.querySelectorAll('img').length, document.querySelectorAll('script').length,"
            "document.title, document.body.textContent.includes(arguments[0]),"
            "document.body.textContent.includes(arguments[1]), document.body.textContent.includes(arguments[2])]"
        )
        names = HOSTILE_MARKUP, HOSTILE_RTL, HOSTILE_LONG[:300]
        images, scripts, title, *shown = self.browser.driver.execute_script(script, *names)
        self.assertEqual((images, scripts), (1, 1))  # The page's own icon and script.
        self.assertNotEqual(title, "broken in")
        self.assertEqual(shown, [True, True, True])
        wide = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
        self.assertLessEqual(self.browser.driver.execute_script(wide), 0)
        self.browser.go("#/jobs/folder/1")
        self.browser.scenario(1)

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
