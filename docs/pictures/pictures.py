"""Makes the pictures of the documents of real vehicles (docs/pictures/make). Usage: pictures.py BIN_DIR MESHES OUT
[NAME...]: the pictures NAME.png, all by default."""
import csv
import pathlib
import struct
import subprocess
import sys
import tempfile
import time

from browser import Browser
from scenes import Scenes
from servers import View

# Heights of the vehicles' origins above the ground, in metres.
GROUND = {"truck": 0.63, "carrier": 0.585, "sedan": 0.209, "rover": 0.001}
# Places and turns (x, y, yaw in degrees) at step 0, and by how much they change in a step.
TRAFFIC = {
    "truck": ((-0.6, -0.9, 24), (2.2, 0.55, 12)),
    "sedan.0": ((11.8, 2.2, 180), (-3.1, 0, 0)),
    "sedan.1": ((18, 2.2, 180), (-3.3, 0, 0)),
    "sedan.2": ((24, 2.4, 182), (-3.3, 0, 0)),
    "sedan.3": ((-14, -2, 0), (2, 0, 0)),
    "sedan.4": ((-20.5, -2.2, 2), (2, 0, 0)),
    "sedan.5": ((4.5, -12, 90), (0, 0.5, 0)),
    "rover": ((-6, 5, -56), (0.1, -0.1, 2)),
}
STEPS = 3
ROOT = 0.5**0.5


def place_at(step, body):
    """Returns x, y, z, yaw of a body of the traffic."""
    begin, change = TRAFFIC[body]
    x, y, yaw = (round(b + step * c, 3) for b, c in zip(begin, change))
    return x, y, GROUND[body.split(".")[0]], yaw


def write_npy(path, rows):
    """Writes rows of numbers as an array of doubles."""
    header = str({"descr": "<f8", "fortran_order": False, "shape": (len(rows), len(rows[0]))}).ljust(117) + "\n"
    values = [value for row in rows for value in row]
    begin = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode()
    path.write_bytes(begin + struct.pack(f"<{len(values)}d", *values))


class Pictures:
    """Each method makes the picture of its name."""

    def __init__(self, cdctl, meshes, root, browser):
        self.cdctl, self.meshes, self.root, self.browser = cdctl, meshes, root, browser
        self.scenes = Scenes(cdctl, root)

    def mesh(self, name):
        return f'mesh = "{self.meshes / name}"'

    def run(self, name, text):
        """Runs a job; returns the results folder."""
        return self.scenes.run(name, self.scenes.job(name, 'unit = "m"\n' + text))

    def draw(self, name, folder, link, selector, scenario=0, size=(1440, 820)):
        """Keeps a picture of an element of the viewer of a scenario."""
        server = View(self.cdctl, folder)
        try:
            self.browser.size(*size)
            self.browser.open(server.url)
            self.browser.wait("the page", lambda facts: facts.get("screen"))
            self.browser.go(f"#/jobs/folder/{scenario}?{link}")
            self.browser.scenario(scenario)
            time.sleep(0.5)
            self.browser.wait_frames()
            left, top, width, height = self.browser.box(selector)
            scrolled = self.browser.driver.execute_script("return scrollY")
            self.browser.picture_of(name, left, top + scrolled, width, height)
        finally:
            self.browser.leave()
            server.close()

    def distance(self):
        """A sedan before a carrier, with the line between the nearest points."""
        self.scenes.poses("distance", "x,y,z,yaw_deg", [(3.1, 0.75, -0.376, 28)])
        folder = self.run(
            "distance",
            f'[a]\n{self.mesh("m113_apc.glb")}\n[b]\n{self.mesh("sedan.obj")}\n'
            '[poses]\nfile = "distance.csv"\n[query]\nlevel = "distance"\n',
        )
        self.draw("distance", folder, "ghost=none&cam=6,-7,4.6,0.7,0.5,0.5", ".stage-column")

    def motion(self):
        """A truck turns across the way of a sedan."""
        truck = [(-3, -1, 0, 0), (2.5, 2.5, 0, 65)]
        sedan = [(12, 2.2, -0.42, 180), (-10, 2.2, -0.42, 180)]
        rows = [(i, body, *keys[i]) for i in (0, 1) for body, keys in (("a", truck), ("b", sedan))]
        self.scenes.poses("motion", "scenario,body,x,y,z,yaw_deg", rows)
        folder = self.run(
            "motion",
            f'[a]\n{self.mesh("man_kat1_8x8.glb")}\n[b]\n{self.mesh("sedan.obj")}\n'
            '[poses]\nfile = "motion.csv"\nof = "both"\n'
            '[motion]\nresolution = 0.01\nuntil = "end"\n[query]\nlevel = "pairs"\n',
        )
        self.draw("motion", folder, "cam=20,-14,13,4.2,-0.6,0", ".stage-column")

    def scene(self):
        """Traffic at a crossing: the truck meets a sedan at the last step."""
        rows = [(step, body, *place_at(step, body)) for step in range(STEPS) for body in TRAFFIC]
        self.scenes.poses("scene", "step,body,x,y,z,yaw_deg", rows)
        sedans = sum(body.startswith("sedan") for body in TRAFFIC)
        folder = self.run(
            "scene",
            f'[bodies]\ntruck = {{ {self.mesh("man_kat1_8x8.glb")} }}\n'
            f'sedan = {{ {self.mesh("sedan.obj")}, count = {sedans} }}\n'
            f'rover = {{ {self.mesh("curiosity_rover.stl")} }}\n'
            f'carrier = {{ {self.mesh("m113_apc.glb")}, pose = [-3.4, 13, {GROUND["carrier"]}, 0, 0, {-ROOT}, {ROOT}], '
            'quat_order = "xyzw" }\n[poses]\nfile = "scene.csv"\n[query]\nlevel = "distance"\nup_to = 12\n',
        )
        self.draw("scene", folder, "ghost=none&cam=18.5,-16,12,0,2.6,0", ".stage-column", self.contact_of(folder))

    def contact_of(self, folder):
        """Returns the first scenario in contact."""
        with open(folder / "scenarios.csv", newline="") as file:
            return next(int(row["scenario"]) for row in csv.DictReader(file) if row["class"] == "contact")

    def shots(self):
        """Lines through a sedan from the left."""
        lines = [(x / 4, 1.8, z, x / 4, -1.8, z) for z in (0.12, 0.8) for x in range(-10, 11)]
        write_npy(self.root / "lines.npy", lines)
        folder = self.run(
            "shots",
            f'[a]\n{self.mesh("sedan.obj")}\n[shots]\nfile = "lines.npy"\n[query]\nlevel = "pairs"\n',
        )
        self.draw("shots", folder, "ghost=none&cam=-3.6,4.6,2.7,0,-0.1,0.4", ".stage-column")

    def thickness(self):
        """A wheel with lugs from two directions, as a report shows it."""
        folder = self.run(
            "thickness",
            f'[a]\n{self.mesh("lugged_wheel.obj")}\n'
            "[shots]\nspacing = 0.002\ntile = 512\nazimuth_deg = [30, 60, 2]\n"
            '[query]\nlevel = "pairs"\n[output]\nformats = []\n',
        )
        report = self.root / "thickness.html"
        words = [self.cdctl, "report", folder, "-o", report]
        subprocess.run(list(map(str, words)), check=True, capture_output=True)
        self.browser.size(1440, 1200)
        self.browser.open(report.as_uri())
        place = "const b = [...document.querySelectorAll('h2')].find((e) => e.textContent === 'Thickness')"
        place += ".parentElement.querySelector('.cards').getBoundingClientRect();"
        place += "return [b.left + scrollX, b.top + scrollY, b.width + 2, b.height]"
        self.browser.picture_of("thickness", *self.browser.driver.execute_script(place))


def main():
    bin_dir, meshes, out = map(pathlib.Path, sys.argv[1:4])
    names = sys.argv[4:] or ["distance", "motion", "scene", "shots", "thickness"]
    with tempfile.TemporaryDirectory(prefix="cd_pictures_") as folder:
        browser = Browser(out)
        try:
            pictures = Pictures(bin_dir / "cdctl", meshes, pathlib.Path(folder), browser)
            for name in names:
                getattr(pictures, name)()
                print(f"{name}.png: {(out / f'{name}.png').stat().st_size} bytes")
        finally:
            browser.close()


if __name__ == "__main__":
    main()
