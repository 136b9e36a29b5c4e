"""Shows the page on real vehicles (bench/page/run). Usage: pictures.py BIN_DIR MESHES OUT."""
import csv
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from browser import HEIGHT, WIDTH, Browser
from scenes import Scenes
from servers import Program, View

POSES = 10_000
TIMED_ROUNDS = 5
DEMO_SCENARIOS = 1_000


def command(*words, codes=(0,)):
    """Runs a program to its end; returns what it printed."""
    words = list(map(str, words))
    ran = subprocess.run(words, capture_output=True, text=True)
    if ran.returncode not in codes:
        raise SystemExit(f"{' '.join(words)} ended with {ran.returncode}: {ran.stderr}")
    return ran.stdout


# Random poses depend on the bodies, so that runs with other bodies have no pose in common.
RANDOM = f"random = {{ n = {POSES}, seed = 1, penetration = [0.005, 0.05] }}"
GRID = "grid = { x = [-7, 7, 29], y = [-4, 4, 17], yaw_deg = [0, 135, 4] }"


def run_pair(cdctl, a, b, poses, out):
    """Runs a job at level contacts with maps; returns the results folder."""
    job = out.parent / f"{out.name}.toml"
    job.write_text(
        f'name = "{out.name}"\n[a]\nmesh = "{a}"\n[b]\nmesh = "{b}"\n[poses]\n{poses}\n'
        '[query]\nlevel = "contacts"\nmaps = true\n'
    )
    command(cdctl, "run", job, "--out", out, "--quiet")
    return out


def draw_screens(browser, home, screens, prefix):
    """Keeps a picture of each screen in light and dark, and of the first two on a phone."""
    for scheme in ("light", "dark"):
        browser.colours(scheme)
        for name, (link, condition) in screens.items():
            browser.open(home + link)
            browser.wait(name, condition)
            time.sleep(0.5)
            browser.picture(f"{prefix}-{name}-{scheme}")
    browser.colours("light")
    browser.size(390, 844, is_phone=True)
    for name, (link, condition) in list(screens.items())[:2]:
        browser.open(home + link)
        browser.wait(name, condition)
        time.sleep(0.5)
        browser.picture(f"{prefix}-{name}-phone")
    browser.size(WIDTH, HEIGHT)


def job_screens(job, scenario):
    def shows(mode):
        return lambda facts: facts.get("scenario") == scenario and facts.get("mode") == mode

    return {
        "job": (f"#/jobs/{job}", lambda facts: facts["screen"] == "job" and facts.get("poseSpace")),
        "viewer": (f"#/jobs/{job}/{scenario}", shows("contacts")),
        "ghost-b": (f"#/jobs/{job}/{scenario}?ghost=b", shows("contacts")),
        "heat": (f"#/jobs/{job}/{scenario}?mode=heat&ghost=none", shows("heat")),
        "section": (f"#/jobs/{job}/{scenario}?clip=y:0.05", shows("contacts")),
    }


def worst_of(browser, home, job):
    """Returns the scenario that the job's page offers at a place of its pose space."""
    browser.open(f"{home}#/jobs/{job}")
    return browser.wait("the job", lambda f: f["screen"] == "job" and f.get("poseSpace"))["poseSpace"]["scenario"]


def come_closer(browser, camera, link):
    """Moves the camera to four fifths of its distance."""
    eye, target = camera[:3], camera[3:]
    nearer = [t + (e - t) * 0.8 for e, t in zip(eye, target)]
    browser.go(link + "&cam=" + ",".join(f"{value:.4f}" for value in nearer + target))
    browser.wait("the nearer view", lambda facts: abs(facts["camera"][0] - nearer[0]) < 1e-3)
    time.sleep(0.5)


def time_page(browser, server, rounds=TIMED_ROUNDS):
    """Returns triangles, and the medians of the seconds until the meshes are in hand and drawn."""
    data, frame = [], []
    for _ in range(rounds):
        browser.open(server.home + "#/jobs/folder/0")
        facts = browser.scenario(0)
        data.append(facts["meshMilliseconds"] / 1000)
        frame.append(facts["firstFrameMilliseconds"] / 1000)
    return sum(facts["trianglesDrawn"]), statistics.median(data), statistics.median(frame)


def print_report(cdctl, folder, out):
    command(cdctl, "report", folder, "-o", out / "report.html")
    sandbox = ["--no-sandbox"] if os.geteuid() == 0 else []
    with tempfile.TemporaryDirectory() as profile:
        command(
            "/usr/bin/chromium", "--headless=new", *sandbox, "--disable-gpu", f"--user-data-dir={profile}",
            "--no-pdf-header-footer", f"--print-to-pdf={out / 'report.pdf'}", f"file://{out / 'report.html'}",
        )
    print(f"report.html: {(out / 'report.html').stat().st_size} bytes, report.pdf: {(out / 'report.pdf').stat().st_size} bytes")


def without_part(source, target):
    """Copies an OBJ file without its part of the most triangles; returns the part's name."""
    sizes, part = {}, ""
    for line in source.read_text().splitlines():
        if line.startswith(("o ", "g ")):
            part = line[2:].strip()
        elif line.startswith("f "):
            sizes[part] = sizes.get(part, 0) + 1
    lost = max(sizes, key=sizes.get)
    part, lines = "", []
    for line in source.read_text().splitlines():
        if line.startswith(("o ", "g ")):
            part = line[2:].strip()
        if not (part == lost and line.startswith(("f ", "o ", "g "))):
            lines.append(line)
    target.write_text("\n".join(lines) + "\n")
    return lost


def show_folder(browser, cdctl, meshes, root, out, times):
    """Shows the carrier and the sedan: pictures, times, report, and the picture of README."""
    folder = run_pair(cdctl, meshes / "m113_apc.glb", meshes / "sedan.obj", RANDOM, root / "carrier-sedan")
    server = View(cdctl, folder)
    try:
        browser.open(server.url) # Leaves the key with the browser.
        scenario = worst_of(browser, server.home, "folder")
        draw_screens(browser, server.home, job_screens("folder", scenario), "carrier-sedan")
        times.append(("m113_apc.glb x sedan.obj", *time_page(browser, server)))
        browser.size(1100, 700)
        browser.open(f"{server.home}#/jobs/folder/4")
        come_closer(browser, browser.scenario(4)["camera"], "#/jobs/folder/4?lines=0")
        left, top, width, height = browser.box(".stage canvas")
        browser.picture_of("contact", left, top, width, height)
        browser.size(WIDTH, HEIGHT)
    finally:
        browser.leave()
        server.close()
    begin = time.monotonic()
    print_report(cdctl, folder, out)
    print(f"report and PDF: {time.monotonic() - begin:.1f} s")


def show_diff(cdctl, meshes, root, out):
    """Compares two runs, in the second of which the sedan has lost its largest part."""
    lost = without_part(meshes / "sedan.obj", root / "sedan.obj")
    carrier = meshes / "m113_apc.glb"
    old = run_pair(cdctl, carrier, meshes / "sedan.obj", GRID, root / "sedan-whole")
    new = run_pair(cdctl, carrier, root / "sedan.obj", GRID, root / "sedan-less")
    text = command(cdctl, "diff", old, new)
    (out / "diff.txt").write_text(f"B lost the part {lost}\n\n{text}")
    print(text)


def show_million(browser, cdctl, root, times):
    folder, _ = Scenes(cdctl, root).million()
    server = View(cdctl, folder)
    try:
        browser.open(server.url)
        times.append(("a generated car x a box", *time_page(browser, server)))
    finally:
        browser.leave()
        server.close()


def show_demo(browser, bin_dir, root):
    """Shows the demo's cluster: `cdctl demo` on a terminal keeps its page open."""
    os.environ["XDG_CACHE_HOME"] = str(root / "cache")
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        os.environ.pop(name, None)
    words = f"{bin_dir}/cdctl demo --vehicles debian --scenarios {DEMO_SCENARIOS}"
    demo = Program("script", "--quiet", "--return", "--command", words, "/dev/null")
    try:
        url = demo.wait_for(r"http://127\.0\.0\.1:\d+/#key=[0-9a-f]+").group(0)
        home = url.split("#")[0]
        browser.open(url)
        browser.wait("the page", lambda f: f.get("screen"))
        browser.go("#/cluster")
        job = browser.wait("the job", lambda f: f["screen"] == "cluster" and f["jobs"])["jobs"][0]["job"]
        scenario = worst_of(browser, home, job)
        cluster = {"cluster": ("#/cluster", lambda f: f["screen"] == "cluster" and len(f.get("workers") or []) == 2)}
        draw_screens(browser, home, cluster | job_screens(job, scenario), "demo")
    finally:
        browser.leave()
        demo.close()


def main():
    bin_dir, meshes, out = map(pathlib.Path, sys.argv[1:4])
    cdctl, times = bin_dir / "cdctl", []
    with tempfile.TemporaryDirectory(prefix="cd_page_") as folder:
        root = pathlib.Path(folder)
        browser = Browser(out)
        try:
            show_folder(browser, cdctl, meshes, root, out, times)
            show_diff(cdctl, meshes, root, out)
            show_million(browser, cdctl, root, times)
            show_demo(browser, bin_dir, root)
        finally:
            browser.close()
    with open(out / "times.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["bodies", "triangles", "meshes in hand (s)", "first frame, from then (s)"])
        for bodies, triangles, data, frame in times:
            writer.writerow([bodies, triangles, f"{data:.2f}", f"{frame:.2f}"])
            print(f"{bodies}: {triangles} triangles, in hand {data:.2f} s, first frame {frame:.2f} s later")


if __name__ == "__main__":
    main()
