"""Tests the buttons that give the view to others: its picture and its link."""
import struct
import time
import zlib

from browser import WAIT_SECONDS
from page_case import PageTest


def png_content(data):
    """Returns width, height and the packed rows of a PNG."""
    at, packed, size = 8, b"", (0, 0)
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    return *size, zlib.decompress(packed)


class Buttons(PageTest):
    def click(self, text):
        script = "[...document.querySelectorAll('.scrub button')].find(one => one.textContent === arguments[0]).click()"
        self.browser.driver.execute_script(script, text)

    def saved(self, folder):
        """Waits for the only file of a folder, and returns it once it is whole."""
        end = time.monotonic() + WAIT_SECONDS
        while True:
            files = list(folder.iterdir())
            if len(files) == 1 and files[0].suffix == ".png":
                return files[0]
            self.assertLess(time.monotonic(), end, f"no picture came; the folder has {files}")
            time.sleep(0.05)

    def test_png_saves_the_view(self):
        """PNG saves a picture as large as the canvas, named after job and scenario, and not of one colour."""
        folder = self.root / "downloads"
        folder.mkdir()
        allow = {"behavior": "allow", "downloadPath": str(folder)}
        self.browser.driver.execute_cdp_cmd("Browser.setDownloadBehavior", allow)
        self.open(self.scenes.grid(), "#/jobs/folder/510")
        self.browser.scenario(510)
        self.click("PNG")
        file = self.saved(folder)
        self.assertEqual(file.name, "grid-510.png")
        size = "const canvas = document.querySelector('.stage canvas'); return [canvas.width, canvas.height]"
        width, height, rows = png_content(file.read_bytes())
        self.assertEqual([width, height], self.browser.driver.execute_script(size))
        self.assertGreater(len(set(rows)), 50)

    def test_copy_link_copies_all_that_is_seen_and_no_key(self):
        """The copied link has the view but not the key, and opens the same view in another tab."""
        server = self.open(self.scenes.grid(), "#/jobs/folder/510?ghost=a&clip=z:0.25&cam=9,8,7,1,0.5,0&lines=0")
        before = self.browser.scenario(510)
        allowed = {"permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"], "origin": self.browser.origin}
        self.browser.driver.execute_cdp_cmd("Browser.grantPermissions", allowed)
        self.click("copy link")
        self.browser.wait_text("copied")
        read = "navigator.clipboard.readText().then(arguments[0], (error) => arguments[0](String(error)))"
        link = self.browser.driver.execute_async_script(read)
        self.assertTrue(link.startswith(server.home + "#/jobs/folder/510?"), link)
        self.assertNotIn(server.key, link)
        self.browser.open(link)
        after = self.browser.scenario(510)
        for fact in ("ghost", "clip", "camera", "highlighted"):
            self.assertEqual(after[fact], before[fact], fact)
        self.assertIn("lines=0", link)
