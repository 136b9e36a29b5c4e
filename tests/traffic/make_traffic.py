"""Traffic of SUMO as scenes of cdctl: real vehicles at a crossing of Debian's sumo-tools.

make(folder, meshes) runs SUMO with a fixed seed and writes jobs into the folder: plain.toml;
collided.toml with two collisions put in; and jumped.toml with a car that jumps past another between
two steps. motion-plain.toml and motion-jumped.toml ask the same about motions between the steps.
Another version of SUMO drives otherwise, so nothing here depends on where a vehicle is: it looks for
places where vehicles are alone.
"""
import math
import pathlib
import subprocess
import xml.etree.ElementTree as ElementTree

NET = pathlib.Path("/usr/share/sumo/tools/game/cross/cross.net.xml")
ROUTES = NET.with_name("cross.rou.xml")
VEHICLES = 100
STEPS = 3600
SECONDS_A_STEP = 0.1
COLLISION_STEPS = 3
WANTED_STEPS = (1200, 2400)  # Each collision is at the first possible step from one of these on.
ALONE_METRES = 40.0  # No vehicle is longer than 10 m.
JUMP_WANTED_STEP = 600
JUMP_METRES = 15.0  # Before and behind the other car at the two steps.
CAR_METRES = 4.8895  # From the front of sedan.obj to its back.
JUMPER = "jumper"

BODIES = """[bodies]
car = {{ mesh = "{meshes}/sedan.obj", origin = [2.4121, 0, -0.208582], group = "traffic" }}
lorry = {{ mesh = "{meshes}/man_kat1_8x8.glb", origin = [1.312396, 0, -0.63], group = "traffic" }}
[poses]
fcd = {{ file = "{name}.xml", types = {{ passenger = "car", truck = "lorry" }} }}
[query]
level = "any"
"""
MOTION = """[motion]
resolution = 0.05
"""


def write_routes(path):
    """Writes 100 vehicles, each tenth of them a lorry, over the first nine tenths of the time."""
    routes = [(r.get("id"), r.get("edges")) for r in ElementTree.parse(ROUTES).getroot().iter("route")]
    lines = ["<routes>",
             '<vType id="passenger" length="4.9" width="1.9"/>',
             '<vType id="truck" length="9.8" width="2.5" maxSpeed="20"/>']
    lines += [f'<route id="{name}" edges="{edges}"/>' for name, edges in routes]
    seconds = 0.9 * STEPS * SECONDS_A_STEP / VEHICLES
    for i in range(VEHICLES):
        kind = "truck" if i % 10 == 0 else "passenger"
        lines.append(f'<vehicle id="{kind}.{i}" type="{kind}" route="{routes[i % len(routes)][0]}" '
                     f'depart="{i * seconds:.1f}" departSpeed="max"/>')
    path.write_text("\n".join(lines + ["</routes>\n"]))


def drive(folder):
    """Runs SUMO and returns its output."""
    write_routes(folder / "routes.xml")
    subprocess.run(
        ["sumo", "--net-file", NET, "--route-files", folder / "routes.xml", "--seed", "42",
         "--step-length", str(SECONDS_A_STEP), "--end", f"{STEPS * SECONDS_A_STEP:.1f}",
         "--fcd-output", folder / "plain.xml", "--xml-validation", "never",
         "--xml-validation.net", "never", "--no-step-log", "true", "--no-warnings", "true"],
        check=True, stdout=subprocess.DEVNULL)
    return ElementTree.parse(folder / "plain.xml")


def place(vehicle):
    return float(vehicle.get("x")), float(vehicle.get("y"))


def alone(steps, first):
    """The ids of vehicles that no other comes near while a collision lasts."""
    ids = None
    for step in steps[first:first + COLLISION_STEPS]:
        vehicles = step.findall("vehicle")
        found = {v.get("id") for v in vehicles
                 if all(v is other or math.dist(place(v), place(other)) > ALONE_METRES for other in vehicles)}
        ids = found if ids is None else ids & found
    return sorted(ids)


def collide(steps, first):
    """Puts one vehicle on the road where another is, 1 m behind it and turned by 20 degrees, and
    returns the collision: first and last step, and the two ids. None if no two vehicles are alone."""
    ids = alone(steps, first)
    if len(ids) < 2:
        return None
    for step in steps[first:first + COLLISION_STEPS]:
        by_id = {v.get("id"): v for v in step.findall("vehicle")}
        struck, moved = by_id[ids[0]], by_id[ids[1]]
        angle = float(struck.get("angle"))
        x, y = place(struck)
        moved.set("x", f"{x - math.sin(math.radians(angle)):.2f}")
        moved.set("y", f"{y - math.cos(math.radians(angle)):.2f}")
        moved.set("angle", f"{angle + 20:.2f}")
    return first, first + COLLISION_STEPS - 1, frozenset(ids[:2])


def ahead(vehicle, metres):
    """The place so far ahead of a vehicle's front, as attributes."""
    x, y = place(vehicle)
    angle = math.radians(float(vehicle.get("angle")))
    return {"x": f"{x + metres * math.sin(angle):.4f}", "y": f"{y + metres * math.cos(angle):.4f}"}


def jump(steps, first):
    """Puts a car behind another at a step, and in front of it at the next one; nobody else is near.
    Returns that step and the other's id. None if no car is alone and drives straight on."""
    two = steps[first:first + 2]
    here, there = ({v.get("id"): v for v in step.findall("vehicle")} for step in two)
    for struck in sorted(set(alone(two[:1], 0)) & set(alone(two[1:], 0))):
        car = here[struck]
        if car.get("type") == "passenger" and car.get("angle") == there[struck].get("angle"):
            for step, vehicle, metres in ((two[0], car, -JUMP_METRES), (two[1], there[struck], JUMP_METRES)):
                ElementTree.SubElement(step, "vehicle", {**vehicle.attrib, **ahead(vehicle, metres), "id": JUMPER})
            return first, struck
    return None


def take_out(steps, name):
    for step in steps:
        for vehicle in step.findall(f"vehicle[@id='{name}']"):
            step.remove(vehicle)


def first_found(put_in, steps, wanted):
    """What `put_in` does at the first possible step from a wanted one on."""
    return next(filter(None, (put_in(steps, first) for first in range(wanted, wanted + 1000))))


def write_job(folder, meshes, name, traffic, more=""):
    (folder / f"{name}.toml").write_text(BODIES.format(meshes=meshes, name=traffic) + more)


def make(folder, meshes):
    """Returns the two collisions that collided.toml has and plain.toml does not, and the jump: its step
    and the id of the car that is jumped past."""
    traffic = drive(folder)
    steps = traffic.getroot().findall("timestep")
    vehicles = {v.get("id") for v in traffic.getroot().iter("vehicle")}
    assert len(steps) == STEPS, f"SUMO made {len(steps)} steps"
    assert len(vehicles) == VEHICLES, f"SUMO let {len(vehicles)} vehicles drive"
    jump_found = first_found(jump, steps, JUMP_WANTED_STEP)
    traffic.write(folder / "jumped.xml")
    take_out(steps, JUMPER)
    collisions = {first_found(collide, steps, wanted) for wanted in WANTED_STEPS}
    assert len(collisions) == len(WANTED_STEPS)
    traffic.write(folder / "collided.xml")
    for name in ("plain", "collided", "jumped"):
        write_job(folder, meshes, name, name)
    for name in ("plain", "jumped"):
        write_job(folder, meshes, f"motion-{name}", name, MOTION)
    return collisions, jump_found
