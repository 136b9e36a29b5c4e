"""Writes a job of two tori on a grid of poses. Usage: torus_job.py FOLDER NAME STEPS ANGLES: writes NAME.toml
and its meshes into FOLDER. There are STEPS² places, each with ANGLES angles."""
import math
import pathlib
import sys


def write_torus(path, count):
    with open(path, "w", encoding="utf-8") as file:
        for i in range(count):
            for k in range(count):
                u, v = 2 * math.pi * i / count, 2 * math.pi * k / count
                r = 1 + 0.4 * math.cos(v)
                file.write(f"v {r * math.cos(u)} {r * math.sin(u)} {0.4 * math.sin(v)}\n")
        for i in range(count):
            for k in range(count):
                corners = [(i + di) % count * count + (k + dk) % count + 1 for di, dk in ((0, 0), (1, 0), (1, 1), (0, 1))]
                file.write("f {0} {1} {2}\nf {0} {2} {3}\n".format(*corners))


def write_job(folder, name, steps, angles):
    write_torus(folder / "a.obj", 60)
    write_torus(folder / "b.obj", 40)
    (folder / f"{name}.toml").write_text(
        'a = { mesh = "a.obj" }\nb = { mesh = "b.obj" }\n'
        "[poses.grid]\n"
        f"x = [-2.5, 2.5, {steps}]\ny = [-2.5, 2.5, {steps}]\nroll_deg = [0, 90, {angles}]\n", encoding="utf-8")


if __name__ == "__main__":
    write_job(pathlib.Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
