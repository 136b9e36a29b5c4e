"""What the tests of the page share: the programs, one browser, and the folders that cdctl makes."""
import unittest

from browser import HEIGHT, WIDTH, Browser
from cluster import Cluster
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

    def start_cluster(self, name, *options, **more):
        """Starts a master, with these options of `Cluster`, that ends after the page was left."""
        return self.enterContext(Cluster(self.bin, self.root / name, *options, **more))

    def open(self, folder, link=""):
        server = self.view(folder)
        self.browser.open(server.url + ("&" + link.lstrip("#") if link else ""))
        return server

    def tearDown(self):
        self.browser.leave()

    def keep_pictures(self, name):
        """Keeps pictures of what is shown in light, in dark and on a phone, whose width it must fit."""
        for scheme in ("dark", "light"):
            self.browser.colours(scheme)
            self.browser.wait_frames()
            self.browser.picture(f"{name}-{scheme}")
        self.browser.size(390, 844, is_phone=True)
        try:
            self.browser.wait_frames()
            self.browser.picture(f"{name}-phone")
            self.assertLessEqual(self.browser.overflow(), 0, f"{name} is wider than a phone")
        finally:
            self.browser.size(WIDTH, HEIGHT)
