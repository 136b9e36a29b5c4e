"""Small meshes and jobs, and results folders that cdctl makes of them."""
import base64
import csv
import json
import math
import re
import struct
import subprocess
import unittest

BOX_CORNERS = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
BOX_FACES = [
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
    (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
]  # fmt: skip

HOSTILE_MARKUP = "<img src=x onerror=\"document.title='broken in'\">"
HOSTILE_RTL = "\u202eabc\u202e<script>document.title='broken in'</script>"
HOSTILE_LONG = "long" * 2500


def box(half=(1, 1, 1)):
    """Vertices and triangles of a box about the origin."""
    return [tuple(s * h for s, h in zip(corner, half)) for corner in BOX_CORNERS], list(BOX_FACES)


def write_obj(path, parts):
    """Writes parts (name, vertices, triangles) as OBJ."""
    lines, base = [], 1
    for name, vertices, triangles in parts:
        lines.append(f"o {name}")
        lines += ["v {!r} {!r} {!r}".format(*vertex) for vertex in vertices]
        lines += ["f {} {} {}".format(*(base + corner for corner in triangle)) for triangle in triangles]
        base += len(vertices)
    path.write_text("\n".join(lines) + "\n")


def write_gltf(path, parts):
    """Writes parts (name, vertices, triangles) as glTF, whose names may be any text."""
    blob, views, accessors, meshes, nodes = b"", [], [], [], []

    def add(values, kind, component, target, extra):
        nonlocal blob
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(values), "target": target})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind, **extra})
        blob += values
        return len(accessors) - 1

    for name, vertices, triangles in parts:
        bounds = {"min": [min(v[i] for v in vertices) for i in range(3)], "max": [max(v[i] for v in vertices) for i in range(3)]}
        position = add(
            b"".join(struct.pack("<3f", *v) for v in vertices), "VEC3", 5126, 34962, {"count": len(vertices), **bounds}
        )
        index = add(b"".join(struct.pack("<3I", *t) for t in triangles), "SCALAR", 5125, 34963, {"count": 3 * len(triangles)})
        meshes.append({"primitives": [{"attributes": {"POSITION": position}, "indices": index}]})
        nodes.append({"name": name, "mesh": len(meshes) - 1})
    uri = "data:application/octet-stream;base64," + base64.b64encode(blob).decode()
    gltf = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": meshes,
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(blob), "uri": uri}],
    }
    path.write_text(json.dumps(gltf))


class Scenes:
    """Makes results folders below `root`, each once."""

    def __init__(self, cdctl, root):
        self.cdctl, self.root = cdctl, root

    def run(self, name, *options):
        """Runs a job with these options of `cdctl run`; returns its folder."""
        out = self.root / name
        if not out.exists():
            words = [self.cdctl, "run", *map(str, options), "--out", out, "--quiet"]
            ran = subprocess.run(list(map(str, words)), capture_output=True, text=True, cwd=self.root)
            if ran.returncode != 0:
                raise AssertionError(f"cdctl run failed: {ran.stderr}")
        return out

    def poses(self, name, header, rows):
        path = self.root / f"{name}.csv"
        path.write_text(header + "\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n")
        return path

    def job(self, name, text):
        path = self.root / f"{name}.toml"
        path.write_text(text)
        return path

    def box_and_tip(self, name, place):
        write_obj(self.root / "box.obj", [("box", *box())])
        write_obj(self.root / "tip.obj", [("tip", [(0.9, 0, 0), (1.6, 0.1, 0), (1.6, -0.1, 0.05)], [(0, 1, 2)])])
        poses = self.poses(name, "x,y,z", [place])
        return self.run(name, "--a", "box.obj", "--b", "tip.obj", "--unit", "m", "--poses", poses, "--level", "contacts")

    def one_pair(self):
        """A box, and a triangle whose tip goes through one triangle of the box's face x = 1."""
        return self.box_and_tip("one_pair", (0, -0.5, 0.5))

    def no_pair(self):
        """As `one_pair`, but the triangle is far from the box."""
        return self.box_and_tip("no_pair", (5, -0.5, 0.5))

    def bodies(self):
        """A box of two parts, and a small one."""
        upper = [(x, y, z + 2.5) for x, y, z in box()[0]]
        write_obj(self.root / "a.obj", [("lower", *box()), ("upper", upper, BOX_FACES)])
        write_obj(self.root / "b.obj", [("probe", *box((0.3, 0.2, 0.4)))])
        return ["--a", "a.obj", "--b", "b.obj", "--unit", "m"]

    def grid(self):
        self.bodies()
        job = self.job(
            "grid",
            'name = "grid"\nunit = "m"\n[a]\nmesh = "a.obj"\n[b]\nmesh = "b.obj"\n'
            "[poses]\ngrid = { x = [-2, 2, 21], y = [-2, 2, 17], z = [0, 2.5, 3], yaw_deg = [0, 60, 3] }\n"
            '[query]\nlevel = "contacts"\nmaps = true\n[output]\nformats = ["csv", "csv-pairs"]\n',
        )
        return self.run("grid", job)

    def long_job(self, name="long"):
        """Writes a job of 80,000,000 scenarios with this name; returns its file."""
        self.bodies()
        return self.job(
            "long",
            f"name = '''{name}'''\nunit = \"m\"\n"
            '[a]\nmesh = "a.obj"\n[b]\nmesh = "b.obj"\n'
            "[poses]\ngrid = { x = [-2, 2, 200], y = [-2, 2, 200], yaw_deg = [0, 90, 2000] }\n"
            '[query]\nlevel = "count"\n',
        )

    def drive(self):
        rows = [(i, f"{0.1 * i:.1f}", -2.5 + 0.05 * i, round(math.sin(0.2 * i), 4), 0.1, 3 * i) for i in range(100)]
        poses = self.poses("drive", "id,t,x,y,z,yaw_deg", rows)
        return self.run(
            "drive", *self.bodies(), "--poses", poses, "--level", "contacts", "--formats", "csv,csv-pairs"
        )

    def approach(self):
        """A small box beside a large one: free, 3 and 4 cm away, crossing, free, 2 cm away; 5 cm are near."""
        rows = [(x,) for x in (2, 1.33, 1.34, 1.2, 2, 1.32)]
        poses = self.poses("approach", "x", rows)
        near = ["--clearance", 0.05, "--level", "contacts", "--formats", "csv,csv-pairs"]
        return self.run("approach", *self.bodies(), "--poses", poses, *near)

    def distances(self):
        """The poses of `approach`, asked for the distance: 0.7, 0.03, 0.04, contact, 0.7 and 0.02 m."""
        rows = [(x,) for x in (2, 1.33, 1.34, 1.2, 2, 1.32)]
        poses = self.poses("distances", "x", rows)
        return self.run("distances", *self.bodies(), "--poses", poses, "--level", "distance")

    def motions(self):
        """A small box that stays away from a large one, then meets it at x = 1.3, halfway, and stays in it."""
        self.bodies()
        self.poses("keys", "x", [(4,), (2.3,), (0.3,), (0.3,)])
        job = self.job(
            "motions",
            'name = "motions"\nunit = "m"\n[a]\nmesh = "a.obj"\n[b]\nmesh = "b.obj"\n'
            '[poses]\nfile = "keys.csv"\n[motion]\nresolution = 0.01\nuntil = "end"\n'
            '[query]\nlevel = "pairs"\n[output]\nformats = ["csv"]\n',
        )
        return self.run("motions", job)

    def crossing_job(self):
        """Writes a job of six bodies of four meshes over six steps; returns its file. Two cars drive towards one
        another, a cart crosses their way; a pole, a wall and the floor are fixed."""
        wheel = [(x, y, z - 0.5) for x, y, z in box((0.3, 0.55, 0.2))[0]]
        write_obj(self.root / "car.obj", [("body", *box((1, 0.5, 0.4))), ("wheel", wheel, BOX_FACES)])
        write_obj(self.root / "post.obj", [("post", *box((0.2, 0.2, 2)))])
        write_obj(self.root / "wall.obj", [("wall", *box((0.2, 4, 1)))])
        write_obj(self.root / "floor.obj", [("floor", *box((8, 6, 0.1)))])
        rows = []
        for step in range(6):
            places = [("car.0", step - 5, 0.3), ("car.1", 4 - step, -0.2), ("cart", 1, round(3 - 0.6 * step, 1))]
            rows += [(step, 0.5 * step, name, x, y, 0.8) for name, x, y in places]
        self.poses("crossing", "step,t,body,x,y,z", rows)
        fixed = lambda mesh, *place: f'{{ mesh = "{mesh}.obj", pose = {[*place, 0, 0, 0, 1]}, quat_order = "xyzw" }}'
        return self.job(
            "crossing",
            'name = "crossing"\nunit = "m"\n[bodies]\ncar = { mesh = "car.obj", count = 2 }\n'
            f'cart = {{ mesh = "post.obj" }}\nwall = {fixed("wall", 3, 0, 1)}\n'
            f'pole = {fixed("post", -2, 0.5, 1)}\nfloor = {fixed("floor", 0, 0, -0.2)}\n'
            '[poses]\nfile = "crossing.csv"\n[query]\nlevel = "pairs"\n[output]\nformats = ["csv", "csv-pairs"]\n',
        )

    def crossing(self):
        return self.run("crossing", self.crossing_job())

    def moving_crossing(self):
        """The cars, the cart and the fixed bodies of `crossing`, moving from each step to the next."""
        text = self.crossing_job().read_text()
        parts = text.replace('"crossing"', '"moving"', 1).replace(', "csv-pairs"', "")
        job = self.job("moving", parts.replace("[query]", "[motion]\nresolution = 0.02\n[query]"))
        return self.run("moving", job)

    def crowd(self, count):
        """So many boxes on a floor, at one step."""
        write_obj(self.root / "brick.obj", [("brick", *box((0.3, 0.3, 0.3)))])
        write_obj(self.root / "floor.obj", [("floor", *box((8, 6, 0.1)))])
        rows = [(0, f"brick.{i}", i % 15 - 7, i // 15 % 11 - 5, 0.35) for i in range(count)]
        self.poses("crowd", "step,body,x,y,z", rows)
        job = self.job(
            "crowd",
            f'unit = "m"\n[bodies]\nbrick = {{ mesh = "brick.obj", count = {count} }}\n'
            'floor = { mesh = "floor.obj", pose = [0, 0, 0, 0, 0, 0, 1], quat_order = "xyzw" }\n'
            '[poses]\nfile = "crowd.csv"\n[rules]\norder = [ { ignore = ["brick.*", "brick.*"] } ]\n'
            '[query]\nlevel = "pairs"\n',
        )
        return self.run("crowd", job)

    def shots(self):
        """Lines from the front and from the left through the box of two parts."""
        self.bodies()
        job = self.job(
            "shots",
            'name = "shots"\nunit = "m"\n[a]\nmesh = "a.obj"\n'
            "[shots]\nspacing = 0.25\ntile = 8\nazimuth_deg = [0, 90, 2]\n"
            '[query]\nlevel = "pairs"\n[output]\nformats = ["csv", "csv-pairs", "npz"]\n',
        )
        return self.run("shots", job)

    def lines_through(self):
        """Lines from the front and from the left through a scene of two steps: a box of two parts that moves,
        and a small one that stands."""
        self.bodies()
        self.poses("lines", "step,t,body,x,y,z", [(0, 0, "block", 0, 0, 0), (1, 2.5, "block", 0, 3, 0.5)])
        job = self.job(
            "lines",
            'name = "lines"\nunit = "m"\n[bodies]\nblock = { mesh = "a.obj" }\n'
            'probe = { mesh = "b.obj", pose = [3, 0, 0, 0, 0, 0, 1], quat_order = "xyzw" }\n'
            '[poses]\nfile = "lines.csv"\n'
            "[shots]\nspacing = 0.25\ntile = 8\nazimuth_deg = [0, 90, 2]\n"
            '[query]\nlevel = "pairs"\n[output]\nformats = ["csv", "csv-pairs", "npz"]\n',
        )
        return self.run("lines", job)

    def random(self):
        return self.run("random", *self.bodies(), "--random", 300, "--seed", 1, "--level", "contacts")

    def many(self):
        """More random poses than are drawn as points."""
        return self.run("many", *self.bodies(), "--random", 60000, "--seed", 2, "--level", "count")

    def hostile(self):
        """Names that are markup, turn the writing direction, or never end."""
        shifted = lambda by: [(x, y + by, z) for x, y, z in box()[0]]
        names = [HOSTILE_MARKUP, HOSTILE_RTL, HOSTILE_LONG]
        write_gltf(self.root / "names.gltf", [(name, shifted(3 * i), BOX_FACES) for i, name in enumerate(names)])
        write_gltf(self.root / "bar.gltf", [(HOSTILE_MARKUP, *box((0.5, 8, 0.2)))])
        poses = self.poses("bar", "id,x", [(HOSTILE_MARKUP, 1), ("plain", 9)])
        job = self.job(
            "hostile",
            "name = '''" + HOSTILE_MARKUP + "'''\nunit = 'm'\n"
            '[a]\nmesh = "names.gltf"\n[b]\nmesh = "bar.gltf"\n'
            f'[poses]\nfile = "{poses.name}"\n[query]\nlevel = "contacts"\nmaps = true\n',
        )
        return self.run("hostile", job)

    def million(self):
        """Returns the folder of a generated car and the car's number of triangles, which is about a million."""
        program = self.cdctl.parents[1] / "bench" / "make_vehicle"
        if not program.exists():
            raise unittest.SkipTest(f"{program} is not built (CD_BENCH=ON builds it)")
        words = [program, "car", "1000000", self.root / "million.glb"]
        said = subprocess.run(words, check=True, capture_output=True, text=True).stdout
        triangles = int(re.search(r"(\d+) triangles", said).group(1))
        self.bodies()
        poses = self.poses("million", "x,z", [(2, 0.5)])
        words = ["--a", "million.glb", "--b", "b.obj", "--unit", "m", "--poses", poses, "--level", "contacts"]
        return self.run("million", *words), triangles


def pairs_by_scenario(folder):
    """Returns the triangles of A and of B in contact in each scenario, from pairs.csv."""
    found = {}
    with open(folder / "pairs.csv", newline="") as file:
        for row in csv.DictReader(file):
            a, b = found.setdefault(int(row["scenario"]), (set(), set()))
            a.add(int(row["triangle_a"]))
            b.add(int(row["triangle_b"]))
    return found
