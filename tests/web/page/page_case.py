"""What the tests of the page share: the programs, one browser, and the folders that cdctl makes."""
import unittest

from browser import Browser
from scenes import Scenes
from servers import View


def is_red(colour):
    red, green, blue = colour
    return red > 130 and red > 2 * green and red > 2 * blue


class PageTest(unittest.TestCase):
    """A test in the browser that all tests share."""

    @classmethod
    def begin(cls, bin_dir, out, root):
        """Starts the browser. The programs are in `bin_dir`; pictures go to `out`, folders below `root`."""
        cls.bin, cls.out, cls.root = bin_dir, out, root
        cls.scenes, cls.browser = Scenes(bin_dir / "cdctl", root), Browser(out)

    def view(self, folder):
        """Serves a folder until the test ends."""
        server = View(self.bin / "cdctl", folder)
        self.addCleanup(server.close)
        return server

    def open(self, folder, link=""):
        server = self.view(folder)
        self.browser.open(server.url + ("&" + link.lstrip("#") if link else ""))
        return server

    def tearDown(self):
        self.browser.leave()
