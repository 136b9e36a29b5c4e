"""Keeps pictures of the screens of a results folder for people."""
from page_case import PageTest


class Pictures(PageTest):
    def test_screens_in_light_and_dark_and_on_a_phone(self):
        """Keeps pictures of each screen of a folder, in light and dark; none is wider than a phone."""
        server = self.open(self.scenes.grid())
        self.browser.wait("the job", lambda f: f["screen"] == "job" and f.get("poseSpace"))
        worst = self.browser.facts()["poseSpace"]["scenario"]
        screens = {
            "job": "#/jobs/folder",
            "viewer": f"#/jobs/folder/{worst}",
            "viewer-heat": f"#/jobs/folder/{worst}?mode=heat&ghost=none",
            "viewer-section": f"#/jobs/folder/{worst}?clip=y:0.05&pick=a:3",
        }
        for name, link in screens.items():
            self.browser.open(server.home + link)
            self.browser.wait(name, lambda f: f["link"].startswith(link.split("?")[0]))
            self.keep_pictures(name)
        self.browser.press("?")
        is_open = "return document.querySelector('dialog.keys')?.open === true"
        self.browser.wait("the keys", lambda f: self.browser.driver.execute_script(is_open))
        self.keep_pictures("viewer-keys")
