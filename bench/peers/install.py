"""The peers from PyPI, in a throw-away virtual environment."""

import json
import pathlib
import shutil
import subprocess
import venv

# robosuite comes without what it depends on: its devices and controllers need a
# compiler and a display, so that what its objects need is listed.
PACKAGES = ["mujoco==3.3.7", "dm_control==1.0.34", "numpy==1.26.4", "numba==0.68.1",
            "scipy==1.17.1", "pillow==13.0.0", "opencv-python-headless==4.11.0.86",
            "termcolor==3.3.0", "scene-synthesizer==1.15.0", "trimesh==5.2.0"]
ALONE = ["robosuite==1.5.2"]


def version(package):
    """Of one of the above."""
    return dict(pinned.split("==") for pinned in PACKAGES + ALONE)[package]


def install(folder):
    """The environment's Python; made anew unless it is the same already."""
    python, stamp = folder / "venv/bin/python", folder / "installed.json"
    wanted = json.dumps([PACKAGES, ALONE])
    if stamp.exists() and stamp.read_text() == wanted and python.exists():
        return python
    shutil.rmtree(folder, ignore_errors=True)
    venv.create(folder / "pip", with_pip=True)
    venv.create(folder / "venv", with_pip=False)
    command = [folder / "pip/bin/python", "-m", "pip", "--python", python,
               "--disable-pip-version-check", "install", "--quiet", "--only-binary=:all:"]
    subprocess.run(command + PACKAGES, check=True)
    subprocess.run(command + ["--no-deps"] + ALONE, check=True)
    stamp.write_text(wanted)
    return python
