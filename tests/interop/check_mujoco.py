"""A MuJoCo 3 compiles each variant to the masses and inertias of 2.2.2, and
steps it for a second without a warning.

    check_mujoco.py FOLDER
"""

import json
import pathlib
import sys

import mujoco
import numpy as np

from generated import specs
from report import check, expect, finish

RELATIVE = 1e-6


def compare_body(model, body, meant):
    name = f"body {meant['name']!r}"
    mass = model.body_mass[body]
    expect(abs(mass - meant["mass"]) <= RELATIVE * meant["mass"],
           f"{name} has mass {mass}, not {meant['mass']}")
    if meant["mass"] == 0:
        return
    xx, yy, zz, xy, xz, yz = meant["inertia"]
    moments = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    compiled = np.sort(model.body_inertia[body])
    # 2.2.2 stops diagonalizing at off-diagonal terms of 1e-12 kg m^2.
    expect(np.allclose(compiled, moments, rtol=RELATIVE, atol=2e-12),
           f"{name} has moments {compiled}, not {moments}")
    center = model.body_ipos[body]
    expect(np.allclose(center, meant["com"], rtol=RELATIVE, atol=1e-7),
           f"{name} has its centre of mass at {center}, not {meant['com']}")


def check_variant(variant, meant):
    model = mujoco.MjModel.from_xml_path(str(variant.file))
    expect(model.nbody == len(meant["bodies"]) + 1,
           f"{variant}: {model.nbody} bodies, not {len(meant['bodies']) + 1}")
    for body, one in enumerate(meant["bodies"], start=1):
        compare_body(model, body, one)
    data = mujoco.MjData(model)
    while data.time < 1:
        mujoco.mj_step(model, data)
    raised = [mujoco.mjtWarning(i).name for i in range(len(data.warning)) if data.warning[i].number]
    expect(not raised, f"{variant}: {', '.join(raised)}")
    expect(np.isfinite(data.qpos).all() and np.isfinite(data.qvel).all(),
           f"{variant}: a position or velocity is not finite")


def check_spec(variants):
    for variant in variants:
        meant = json.loads(pathlib.Path(f"{variant.file}.json").read_text(encoding="utf-8"))
        check_variant(variant, meant)
    return f"{len(variants)} variants"


for name, variants in specs(sys.argv[1], "mujoco"):
    check(f"mujoco {mujoco.__version__} {name}", check_spec, variants)
finish()
