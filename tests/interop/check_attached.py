"""robosuite's own grippers and objects, attached with mjforge: those that this MuJoCo takes can be
attached, and weigh and move as they do in their own files.

    check_attached.py FOLDER
"""

import pathlib

import mjforge
import mujoco
import numpy as np
import robosuite

from report import check, expect, finish

ASSETS = pathlib.Path(robosuite.__file__).parent / "models/assets"
FILES = sorted([*(ASSETS / "grippers").rglob("*.xml"), *(ASSETS / "objects").glob("*.xml")])


def load(file):
    """None for what MuJoCo itself refuses."""
    try:
        return mujoco.MjModel.from_xml_path(str(file))
    except ValueError:
        return None


def below_first(model):
    """The first body and those below it, which follow it."""
    inside = [1]
    for body in range(2, model.nbody):
        if model.body_parentid[body] in inside:
            inside.append(body)
    return inside


def check_attached(file, own):
    spec = mjforge.Spec({
        "mjforge": 1, "name": "held", "joints": "none",
        "parts": [{"name": "palm", "type": "sphere", "size": 0.01, "mass": 1}],
        "bodies": [{"name": "thing", "mjcf": str(file)}]})
    model = spec.variants(seed=0)[0].load()
    bodies = below_first(own)
    expect(model.nbody == len(bodies) + 2, f"{model.nbody - 2} bodies, not {len(bodies)}")
    kept = [body for body in own.jnt_bodyid if body in bodies[1:]]
    expect(model.njnt == len(kept), f"{model.njnt} joints, not {len(kept)}")
    difference = np.max(np.abs(model.body_mass[2:] - own.body_mass[bodies]))
    expect(difference < 1e-6 * max(1, own.body_mass.max()), f"masses differ by {difference} kg")
    return f"{model.nbody - 2} bodies, {model.njnt} joints, {model.body_mass[2:].sum():.4g} kg"


def check_count(taken):
    expect((taken, len(FILES)) == (28, 30), f"{taken} of {len(FILES)}")


models = {file: load(file) for file in FILES}
for file, own in models.items():
    if own is not None:
        check(f"attached {file.stem}", check_attached, file, own)
check("28 of robosuite's 30 files can be attached", check_count,
      sum(own is not None for own in models.values()))
finish()
