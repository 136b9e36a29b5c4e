"""Makes exports with cdctl, reads them with VTK, h5py and cdctl's importer, and compares them with
CSV and NPZ files of the same run. Usage: check.py CDCTL FOLDER"""
import collections
import csv
import json
import pathlib
import struct
import subprocess
import sys
import xml.etree.ElementTree

import h5py
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

CDCTL, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
CLASSES = {"touch": 1, "coplanar": 2, "proper": 3}
PROPER, TOUCH, SHARED = [224, 32, 32], [240, 200, 0], [0, 0, 0]
ODD_NAMES = ['<script>&amp;"', "Größe\u202etfel", "x" * 10_000, "comma, 'quote'"]


def check(condition, what):
    if not condition:
        sys.exit(f"export: FAILED: {what}")


def cdctl(*words, code=0):
    done = subprocess.run([CDCTL, *map(str, words)], capture_output=True, text=True)
    check(done.returncode == code, f"cdctl {words} ended with {done.returncode}: {done.stderr}")
    return done


# ---- Inputs -------------------------------------------------------------------------------------
def write_box(path, size, cells, names):
    """A closed box whose faces are grids; each face is a part."""
    corners, lines = {}, []
    for number, (axis, side) in enumerate((axis, side) for axis in range(3) for side in (0, cells)):
        lines.append("o " + names[number % len(names)] + str(number))
        for i in range(cells):
            for j in range(cells):
                quad = []
                for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                    place = [u, v]
                    place.insert(axis, side)
                    quad.append(corners.setdefault(tuple(place), len(corners) + 1))
                quad = quad if (side == 0) == (axis == 1) else quad[::-1]
                lines += [f"f {quad[0]} {quad[1]} {quad[2]}", f"f {quad[0]} {quad[2]} {quad[3]}"]
    vertices = ["v " + " ".join(str((k / cells - 0.5) * size) for k in place) for place in corners]
    path.write_text("\n".join(vertices + lines) + "\n", encoding="utf-8")


def write_inputs():
    write_box(FOLDER / "a.obj", 2, 7, ODD_NAMES)
    write_box(FOLDER / "b.obj", 1.1, 5, ["part"])
    rows = [f"{x},{y},0.1,{yaw}" for x in (0.4, 0.9, 1.55, 9) for y in (-0.3, 0.2) for yaw in (0, 30)]
    (FOLDER / "poses.csv").write_text("x,y,z,yaw_deg\n" + "\n".join(rows) + "\n")
    job = '[a]\nmesh = "a.obj"\n[b]\nmesh = "b.obj"\nname = "<odd>/b"\n[poses]\nfile = "poses.csv"\n'
    (FOLDER / "job.toml").write_text(job)


# ---- Readers ------------------------------------------------------------------------------------
def read_vtp(path):
    reader = vtk.vtkXMLPolyDataReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path.name))
    check(reader.CanReadFile(str(path)), f"VTK does not take {path.name} for its own")
    reader.SetFileName(str(path))
    reader.Update()
    check(not errors, f"VTK cannot read {path.name}")
    return reader.GetOutput()


def arrays_of(attributes):
    names = [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]
    return {name: vtk_to_numpy(attributes.GetArray(name)) for name in names}


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def cells_of(cells):
    return vtk_to_numpy(cells.GetConnectivityArray()) if cells.GetNumberOfCells() else np.empty(0, int)


def triangles_of(data):
    return points_of(data)[cells_of(data.GetPolys()).reshape(-1, 3)]


def texts_of(data, name):
    texts = data.GetFieldData().GetAbstractArray(name)
    return [texts.GetValue(i) for i in range(texts.GetNumberOfValues())]


def rows_of(path):
    csv.field_size_limit(1 << 20)
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


MESH_HEAD = struct.Struct("<QBQQI")  # Of Mesh::canonical_bytes: magic, precision, counts.


def mesh_of(folder, body):
    """Returns the corners (n, 3, 3) and the names of the parts of a body of a results folder."""
    told = json.loads((folder / "run.json").read_text())["bodies"][body]
    data = (folder / "inputs" / "meshes" / (told["sha256"] + ".mesh")).read_bytes()
    _, precision, vertices, triangles, _ = MESH_HEAD.unpack_from(data)
    kind = np.dtype("<f8" if precision else "<f4")
    points = np.frombuffer(data, kind, 3 * vertices, MESH_HEAD.size).reshape(-1, 3).astype(float)
    begin = MESH_HEAD.size + points.size * kind.itemsize
    return points[np.frombuffer(data, "<u4", 3 * triangles, begin).reshape(-1, 3)], told["parts"]


def read_glb(*paths):
    """Imports one or two GLB files with cdctl, and returns their corners."""
    out = FOLDER / "imported"
    cdctl("run", "--a", paths[0], "--b", paths[-1], "--random", 1, "--out", out, "--overwrite", "-q")
    return [mesh_of(out, body)[0] for body in range(2)]


def bag(corners):
    """The triangles as a multiset, each from its least corner on."""
    found = collections.Counter()
    for triangle in corners:
        first = min(range(3), key=lambda k: tuple(triangle[k]))
        found[tuple(np.roll(triangle, -first, axis=0).ravel().tolist())] += 1
    return found


# ---- Checks -------------------------------------------------------------------------------------
def check_bodies(out, files):
    """The meshes, parts and map of the VTP files of both bodies against map.csv."""
    tested = sum(row["class"] != "failed" for row in rows_of(out / "scenarios.csv"))
    names = [body["name"] for body in json.loads((out / "run.json").read_text())["bodies"]]
    for body, file in enumerate(files):
        data, (corners, parts) = read_vtp(out / file), mesh_of(out, body)
        cells = arrays_of(data.GetCellData())
        check(np.array_equal(triangles_of(data), corners), f"{file} has another mesh")
        check(texts_of(data, "part_names") == parts, f"{file} has other names of parts")
        check(np.array_equal(cells["triangle"], range(len(corners))), f"{file}: triangle is wrong")
        check(np.array_equal(cells["share"], cells["scenarios"] / tested), f"{file}: share is wrong")
        expected = np.zeros(len(corners), int)
        for row in rows_of(out / "map.csv"):
            if row["body"] == names[body]:
                expected[int(row["triangle"])] = int(row["scenarios"])
                check(parts[cells["part"][int(row["triangle"])]] == row["part"], f"{file}: part is wrong")
        check(expected.any() and np.array_equal(cells["scenarios"], expected), f"{file}: scenarios is wrong")


def check_points(out):
    """contacts.vtp against points.csv and pairs.csv."""
    data, rows = read_vtp(out / "contacts.vtp"), rows_of(out / "points.csv")
    arrays = arrays_of(data.GetPointData())
    pair = {(r["scenario"], r["triangle_a"], r["triangle_b"]): r["class"] for r in rows_of(out / "pairs.csv")}
    keys = [(r["scenario"], r["triangle_a"], r["triangle_b"]) for r in rows]
    check(len(rows) > 100 and data.GetNumberOfVerts() == len(rows), "contacts.vtp has other points")
    check(np.array_equal(points_of(data), [[float(r[k]) for k in "xyz"] for r in rows]), "points differ")
    for column, name in enumerate(("scenario", "triangle_a", "triangle_b")):
        check(np.array_equal(arrays[name], [int(key[column]) for key in keys]), f"{name} of points is wrong")
    check(np.array_equal(arrays["class"], [CLASSES[pair[key]] for key in keys]), "class of points is wrong")


def check_heat_glb(out, files):
    for body, corners in enumerate(read_glb(*(out / file for file in files))):
        rounded = mesh_of(out, body)[0].astype(np.float32).astype(float)
        check(bag(corners) == bag(rounded), f"{files[body]} has other triangles")


def shared_of(out, scenario):
    """The segments (sorted ends) and single points that pairs of a scenario share, of points.csv."""
    pairs = collections.defaultdict(list)
    for row in rows_of(out / "points.csv"):
        if row["scenario"] == str(scenario):
            pairs[row["triangle_a"], row["triangle_b"]].append(tuple(float(row[k]) for k in "xyz"))
    segments, dots = collections.Counter(), collections.Counter()
    for points in pairs.values():
        if len(points) == 1:
            dots[points[0]] += 1
        for i in range(len(points) if len(points) > 2 else len(points) // 2):
            segments[tuple(sorted((points[i], points[(i + 1) % len(points)])))] += 1
    return segments, dots


def contact_classes(out, scenario, column):
    """The last class of each triangle in contact."""
    classes = {}
    for row in rows_of(out / "pairs.csv"):
        if row["scenario"] == str(scenario):
            triangle = int(row[column])
            classes[triangle] = max(classes.get(triangle, 0), CLASSES[row["class"]])
    return classes


def world(corners, scenario):
    with open(FOLDER / "poses.csv", newline="") as file:
        x, y, z, yaw = (float(number) for number in list(csv.reader(file))[1 + scenario])
    c, s = np.cos(np.radians(yaw)), np.sin(np.radians(yaw))
    return corners @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T + [x, y, z]


def check_contact_cells(out, data, scenario, corners):
    cells = arrays_of(data.GetCellData())
    points = points_of(data)
    lines, dots = cells_of(data.GetLines()).reshape(-1, 2), cells_of(data.GetVerts())
    segments = collections.Counter(tuple(sorted(tuple(points[i].tolist()) for i in line)) for line in lines)
    expected = shared_of(out, scenario)
    check(segments == expected[0], f"scenario {scenario}: other segments")
    check(collections.Counter(tuple(points[i].tolist()) for i in dots) == expected[1], "other points")
    marks = len(lines) + len(dots)
    check((cells["colour"][:marks] == SHARED).all(), "segments are not black")
    triangles = triangles_of(data)
    for body, column in enumerate(("triangle_a", "triangle_b")):
        rows = [i for i in range(marks, data.GetNumberOfCells()) if cells[column][i] >= 0]
        found = {int(cells[column][i]): int(cells["class"][i]) for i in rows}
        check(found == contact_classes(out, scenario, column), f"scenario {scenario}: other triangles")
        for i in rows:
            colour = PROPER if cells["class"][i] == CLASSES["proper"] else TOUCH
            check(cells["colour"][i].tolist() == colour, "a triangle in contact has another colour")
            check(np.allclose(triangles[i - marks], corners[body][cells[column][i]], atol=1e-12), "moved")


def check_series(out, scenes, first, last):
    """A series of VTP files: A stands once, B moves, and contacts are those of the run."""
    cdctl("extract", out, f"{first}-{last}", "--as", "vtp", "--out", scenes)
    scenarios = range(first, last + 1)
    expected = {"a.vtp", "scenarios.pvd"} | {f"{n}-{i}.vtp" for n in ("_odd__b", "contacts") for i in scenarios}
    check({path.name for path in scenes.iterdir()} == expected, "a series has other files")
    steps = collections.defaultdict(list)
    for each in xml.etree.ElementTree.parse(scenes / "scenarios.pvd").iter("DataSet"):
        steps[int(each.get("timestep"))].append(each.get("file"))
    check(steps == {i: ["a.vtp", f"_odd__b-{i}.vtp", f"contacts-{i}.vtp"] for i in scenarios}, "scenarios.pvd")
    for i in scenarios:
        corners = [mesh_of(out, 0)[0], world(mesh_of(out, 1)[0], i)]
        for body, file in enumerate(steps[i][:2]):
            data = read_vtp(scenes / file)
            check(np.allclose(triangles_of(data), corners[body], atol=1e-12), f"{file}: B is elsewhere")
            check("colour" in arrays_of(data.GetCellData()), f"{file} has no colour")
        check_contact_cells(out, read_vtp(scenes / steps[i][2]), i, corners)


def check_scene_glb(out, scenes, scenario):
    cdctl("extract", out, scenario, "--as", "glb", "--out", scenes)
    corners = np.concatenate([mesh_of(out, 0)[0], world(mesh_of(out, 1)[0], scenario)])
    found = read_glb(scenes / f"{scenario}.glb")[0]
    key = lambda triangles: sorted(bag(np.round(triangles, 5) + 0.0).items())
    check(key(found) == key(corners), "a scene has other triangles")


def check_groups(out):
    """groups.csv against pairs.csv: b is one piece, so each group is a part of A."""
    found = rows_of(out / "groups.csv")
    check(found and not any(row["part_a"] in ("", "*") for row in found), "groups.csv has no groups")
    scenarios, pairs = collections.defaultdict(set), collections.Counter()
    for row in rows_of(out / "pairs.csv"):
        key = row["part_a"], row["part_b"]
        scenarios[key].add(row["scenario"])
        pairs[key] += 1
    tested = len(rows_of(out / "scenarios.csv"))
    for row in found:
        key = row["part_a"], row["part_b"]
        check(int(row["pairs"]) == pairs.pop(key, 0), f"groups.csv: pairs of {key}")
        check(int(row["scenarios"]) == len(scenarios[key]), f"groups.csv: scenarios of {key}")
        check(float(row["share"]) == len(scenarios[key]) / tested, f"groups.csv: share of {key}")
    check(not pairs, f"groups.csv lacks {list(pairs)}")


# ---- HDF5 ---------------------------------------------------------------------------------------
BOXES = '[a]\nmesh = "a.obj"\n[b]\nmesh = "b.obj"\nname = "odd/b"\n[poses]\nfile = "poses.csv"\n'
BODIES = '[bodies]\na = { mesh = "a.obj", pose = [0,0,0,1,0,0,0], quat_order = "wxyz" }\n'
MOVING = 'b = { mesh = "b.obj" }\n[poses]\nfile = "steps.csv"\n'
LINES = "[shots]\nspacing = 0.25\nazimuth_deg = [0, 40, 2]\n"
KINDS = {  # Job, level, and the files besides results.
    "contacts": (BOXES + "[query]\nclearance = 0.3\n", "contacts", ["map"]),
    "few": (BOXES + "[query]\nlimit_pairs = 3\n", "pairs", ["map"]),
    "nothing": (BOXES, "any", []),
    "distance": (BOXES, "distance", []),
    "motion": (BOXES + "[motion]\nresolution = 0.01\n", "pairs", ["map"]),
    "shots": ('[a]\nmesh = "a.obj"\n' + LINES, "pairs", ["map", "shots"]),
    "scene": (BODIES + MOVING, "contacts", []),
    "shots in a scene": (BODIES + MOVING + LINES, "pairs", ["shots"]),
}


def check_array_file(path):
    """An HDF5 file against the NPZ of its name."""
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, each: found.update({name: each[()]}) if hasattr(each, "dtype") else None)
        chunked = [name for name in found if file[name].chunks and file[name].compression == "gzip"]
    with np.load(path.with_suffix(".npz")) as expected:
        check(set(expected.files) == set(found) == set(chunked), f"{path}: other arrays")
        for name, array in expected.items():
            same = array.dtype == found[name].dtype and np.array_equal(array, found[name], equal_nan=array.dtype.kind == "f")
            check(same, f"{path}: {name} differs")


def check_h5():
    (FOLDER / "steps.csv").write_text("step,body,x\n0,b,0.4\n1,b,0.9\n2,b,9\n")
    job = FOLDER / "kind.toml"
    for kind, (text, level, others) in KINDS.items():
        job.write_text(text)
        out = FOLDER / ("h5 " + kind)
        options = ["--exact-points"] if level in ("contacts", "distance") else []
        cdctl("run", job, "--level", level, *options, "--formats", "npz,h5", "--out", out)
        names = {path.stem for path in out.iterdir() if path.suffix in (".h5", ".npz")}
        check(names == {"results", *others}, f"{kind}: files of {names}")
        for name in names:
            check_array_file(out / (name + ".h5"))
    with h5py.File(FOLDER / "h5 contacts" / "map.h5") as file:
        check(file["odd/b"].shape[0] > 10, "a body whose name has a slash has no map")
    many = FOLDER / "h5 many"  # More than a chunk of each array.
    cdctl("run", "--a", FOLDER / "a.obj", "--b", FOLDER / "b.obj", "--random", 40000,
          "--level", "count", "--maps", "--formats", "npz", "--out", many)
    cdctl("results", many, "--formats", "h5")
    check_array_file(many / "results.h5")


def main():
    write_inputs()
    check_h5()
    job, out = FOLDER / "job.toml", FOLDER / "out"
    cdctl("run", job, "--level", "contacts", "--formats", "csv,csv-pairs,vtp,glb", "--out", out)
    files = {"map", "pairs", "points", "scenarios", "groups", "records", "run", "summary"}
    files |= {"a", "_odd__b", "contacts"}
    check({path.stem for path in out.iterdir() if path.is_file()} == files, "a folder has other files")
    check_bodies(out, ["a.vtp", "_odd__b.vtp"])
    check_points(out)
    check_groups(out)
    check_heat_glb(out, ["a.glb", "_odd__b.glb"])
    check_series(out, FOLDER / "steps", 2, 6)
    check_scene_glb(out, FOLDER / "scene", 4)
    for level in ("any", "count", "pairs"):  # Scenes do not depend on the run's level.
        lower = FOLDER / level
        cdctl("run", job, "--level", level, "--formats", "csv", "--out", lower)
        for kind, name in (("vtp", "contacts-4.vtp"), ("glb", "4.glb")):
            scene = FOLDER / (level + kind)
            cdctl("extract", lower, 4, "--as", kind, "--out", scene)
            same = FOLDER / ("steps" if kind == "vtp" else "scene") / name
            check((scene / name).read_bytes() == same.read_bytes(), f"{name} differs at level {level}")
    later = FOLDER / "pairs"
    cdctl("results", later, "--formats", "vtp,glb")
    for name in ("a.vtp", "_odd__b.vtp", "a.glb", "_odd__b.glb"):
        check((later / name).read_bytes() == (out / name).read_bytes(), f"{name} made later differs")
    refused = cdctl("results", FOLDER / "any", "--formats", "vtp", code=2)
    check("format vtp shows in how many scenarios" in refused.stderr, "no reason for the refusal")


main()
