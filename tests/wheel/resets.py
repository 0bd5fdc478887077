#!/usr/bin/env python3
"""Resets of a simulation with new objects, in the MuJoCo that is installed: objects are attached,
load as recorded and start, and memory is flat.

    resets.py [COUNT]

COUNT: number of resets, after which memory must be as after the first thousand.
"""

import math
import os
import sys

import mjforge
import mujoco

SPECS = ("robosuite/hammer", "mug", "robosuite/hinged_box", "laptop", "cardboard_box")
SCENE = mujoco.MjSpec.from_string("""<mujoco><worldbody><geom type="plane" size="2 2 .1"/>
  <body name="table" pos="0 0 .4"><geom type="box" size=".4 .4 .02"/></body></worldbody></mujoco>""")
WARM = 1000  # resets after which allocators and caches have their size
MOST = 2e6  # bytes; a leak of 300 bytes a reset is more in 9,000 resets


def reset(variants):
    """A simulation of new objects beside each other on a table."""
    scene = SCENE.copy()
    for number, variant in enumerate(variants):
        variant.attach(scene, prefix=f"{number}/", pos=(0.2 * number, 0, 0.42))
    model = scene.compile()
    data = mujoco.MjData(model)
    for number, variant in enumerate(variants):
        variant.start(model, data, f"{number}/")
    return model, data


def resets_of(name):
    """Objects have their masses, start as recorded, and stay on the table."""
    for variant in mjforge.Spec(name).variants(seed=3, validate="load")[:3]:
        variant.verify(mujoco)
        model, data = reset([variant, variant])
        for number in range(2):
            body = model.body(f"{number}/{variant.members.root}")
            assert math.isclose(body.subtreemass[0], variant.mass, rel_tol=1e-6), (name, body.subtreemass)
            for joint, position in variant.pose.items():
                if isinstance(position, float):
                    assert data.joint(f"{number}/{joint}").qpos[0] == position, (name, joint)
        mujoco.mj_step(model, data, 50)
        assert all(map(math.isfinite, data.qpos)), name


def resident():
    """Bytes of memory."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def memory_of(count):
    """Growth of the memory, in bytes, after the first resets."""
    spec = mjforge.Spec("primitives/box")
    before = 0
    for index in range(count):
        if index % 100 == 0:
            variants = spec.variants(seed=index, set={"density": 300 + index / 100})
        reset([variants[index]])
        if index == WARM:
            before = resident()
    return resident() - before


for spec in SPECS:
    resets_of(spec)
if len(sys.argv) > 1:
    count = int(sys.argv[1])
    grown = memory_of(count)
    assert grown < MOST, f"{grown / 1e6:.1f} MB more after {count} resets"
    print(f"{grown / 1e6:.1f} MB more after {count} resets", end=", ")
print(f"MuJoCo {mujoco.__version__}")
