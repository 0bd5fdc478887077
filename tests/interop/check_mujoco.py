"""A MuJoCo 3 compiles each variant as recorded, and steps it for a second without a warning.

    check_mujoco.py FOLDER
"""

import sys

import mujoco
import numpy as np

from generated import prove, specs
from report import check, expect, finish


def simulate(variant):
    model = mujoco.MjModel.from_xml_path(str(variant.file))
    data = mujoco.MjData(model)
    while data.time < 1:
        mujoco.mj_step(model, data)
    raised = [mujoco.mjtWarning(i).name for i in range(len(data.warning)) if data.warning[i].number]
    expect(not raised, f"{variant}: {', '.join(raised)}")
    expect(np.isfinite(data.qpos).all() and np.isfinite(data.qvel).all(),
           f"{variant}: a position or velocity is not finite")


def check_spec(variants):
    prove(variants)
    for variant in variants:
        simulate(variant)
    return f"{len(variants)} variants"


for name, variants in specs(sys.argv[1], "mujoco"):
    check(f"mujoco {mujoco.__version__} {name}", check_spec, variants)
finish()
