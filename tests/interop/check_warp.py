"""MuJoCo Warp takes each variant to its device, here the CPU. A few it also steps, as MuJoCo does:
its kernels are compiled for each kind of model, which takes a minute.

    check_warp.py FOLDER
"""

import importlib.metadata
import sys

import warp

warp.config.quiet = True
import mujoco
import mujoco_warp
import numpy as np

from generated import specs
from report import check, expect, finish

VERSION = importlib.metadata.version("mujoco-warp")
STEPPED = {"robosuite/hammer", "containers/mug", "primitives/ball"}


def check_variant(variant, steps):
    model = mujoco.MjModel.from_xml_path(str(variant.file))
    data = mujoco.MjData(model)
    with warp.ScopedDevice("cpu"):
        on_device = mujoco_warp.put_model(model)
        state = mujoco_warp.put_data(model, data)
        for _ in range(steps):
            mujoco_warp.step(on_device, state)
            mujoco.mj_step(model, data)
    masses = on_device.body_mass.numpy().reshape(-1, model.nbody)[0]
    expect(np.allclose(masses, model.body_mass, rtol=1e-6), f"{variant}: other masses on the device")
    positions = state.qpos.numpy()[0]
    expect(np.allclose(positions, data.qpos, atol=1e-5), f"{variant}: is at {positions}")


def check_spec(name, variants):
    check_variant(variants[0], 10 if name in STEPPED else 0)


for name, variants in specs(sys.argv[1], "mujoco"):
    check(f"mujoco-warp {VERSION} {name}", check_spec, name, variants)
finish()
