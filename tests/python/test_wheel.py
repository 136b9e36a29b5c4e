"""Proves that the target `wheel` packs a package that works by itself."""
import os
import pathlib
import subprocess
import sys

BUILD = pathlib.Path(os.environ["CDCTL"]).parents[1]


def test_a_wheel_is_a_whole_package(tmp_path):
    subprocess.run(["cmake", "--build", BUILD, "--target", "wheel"], check=True, stdout=subprocess.DEVNULL)
    wheel, = (BUILD / "wheel").glob("cdcluster-*.whl")
    # Unpacking compares each file with its hash in the wheel.
    subprocess.run([sys.executable, "-m", "wheel", "unpack", wheel, "--dest", tmp_path], check=True)
    root, = tmp_path.iterdir()
    told = subprocess.run([sys.executable, "-c", "import cdcluster; print(cdcluster.__file__, cdcluster.LEVELS)"],
                          env={**os.environ, "PYTHONPATH": str(root)}, check=True, capture_output=True, text=True)
    assert told.stdout.startswith(str(root / "cdcluster")) and "contacts" in told.stdout
    assert (root / "cdcluster" / "py.typed").exists()
