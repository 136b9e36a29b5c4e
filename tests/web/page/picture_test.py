"""Keeps pictures of the screens for people."""
import time

from browser import HEIGHT, WIDTH
from page_case import PageTest


class Pictures(PageTest):
    def test_screens_in_light_and_dark_and_on_a_phone(self):
        server = self.open(self.scenes.grid())
        self.browser.wait("the job", lambda f: f["screen"] == "job" and f.get("poseSpace"))
        worst = self.browser.facts()["poseSpace"]["scenario"]
        screens = {
            "job": "#/jobs/folder",
            "viewer": f"#/jobs/folder/{worst}",
            "viewer-heat": f"#/jobs/folder/{worst}?mode=heat&ghost=none",
            "viewer-section": f"#/jobs/folder/{worst}?clip=y:0.05&pick=a:3",
        }
        for scheme in ("light", "dark"):
            self.browser.colours(scheme)
            for name, link in screens.items():
                self.browser.open(server.home + link)
                self.browser.wait(name, lambda f: f["link"].startswith(link.split("?")[0]))
                time.sleep(0.3)
                self.browser.picture(f"{name}-{scheme}")
        self.browser.colours("light")
        self.browser.size(390, 844, is_phone=True)
        try:
            for name in ("job", "viewer"):
                self.browser.open(server.home + screens[name])
                self.browser.wait(name, lambda f: True)
                time.sleep(0.3)
                self.browser.picture(f"{name}-phone")
                wide = "return document.documentElement.scrollWidth - document.documentElement.clientWidth"
                self.assertLessEqual(self.browser.driver.execute_script(wide), 0, f"{name} is wider than a phone")
        finally:
            self.browser.size(WIDTH, HEIGHT)
