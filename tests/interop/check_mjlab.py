"""mjlab makes an entity of each variant, with its bodies, its joints and its mass. Some it also
simulates in two worlds, here on the CPU, to where MuJoCo has them.

    check_mjlab.py FOLDER
"""

import importlib.metadata
import sys

import warp

warp.config.quiet = True
import mujoco
import numpy as np
from mjlab.entity import EntityCfg
from mjlab.scene import Scene, SceneCfg
from mjlab.sim import Simulation, SimulationCfg

from generated import specs
from report import check, expect, finish, still_refused

VERSION = importlib.metadata.version("mjlab")
STEPPED = {"robosuite/hammer", "articulated/drawer_cabinet", "primitives/ball"}
STEPS = 10
WORLDS = 2


def free_joints(model):
    return int(np.sum(model.jnt_type == int(mujoco.mjtJoint.mjJNT_FREE)))


def simulate(variant, entity):
    scene = Scene(SceneCfg(num_envs=WORLDS, entities={"thing": entity}), device="cpu")
    simulation = Simulation(num_envs=WORLDS, cfg=SimulationCfg(nconmax=200, njmax=500),
                            model=scene.compile(), device="cpu")
    scene.initialize(mj_model=simulation.mj_model, model=simulation.model, data=simulation.data)
    data = mujoco.MjData(simulation.mj_model)
    for _ in range(STEPS):
        scene.write_data_to_sim()
        simulation.step()
        mujoco.mj_step(simulation.mj_model, data)
    positions = simulation.data.qpos.numpy()
    for world in positions:
        expect(np.allclose(world, data.qpos, atol=1e-5), f"{variant}: is at {world}, not {data.qpos}")
    expect(len(positions) == WORLDS, f"{variant}: {len(positions)} worlds")


def check_spec(name, variants):
    variant = variants[0]
    entity = EntityCfg(spec_fn=lambda: mujoco.MjSpec.from_file(str(variant.file)))
    built = entity.build()
    model = built.compile()
    own = mujoco.MjModel.from_xml_path(str(variant.file))
    is_fixed = free_joints(own) == 0
    expect(built.is_fixed_base == is_fixed, f"{variant}: fixed base {built.is_fixed_base}")
    counts = {"nbody": model.nbody - is_fixed,  # it puts what is fixed into a body that it can place
              "njnt": model.njnt, "ngeom": model.ngeom}
    meant = {key: variant.record[key] for key in counts}
    expect(counts == meant, f"{variant}: has {counts}, not {meant}")
    expect(set(built.joint_names) <= {own.joint(i).name for i in range(own.njnt)},
           f"{variant}: joints {built.joint_names}")
    variant.expect_mass(model.body_mass.sum())
    if name in STEPPED:
        simulate(variant, entity)


for name, variants in specs(sys.argv[1], "mujoco"):
    if free_joints(mujoco.MjModel.from_xml_path(str(variants[0].file))) > 1:
        still_refused(f"mjlab {VERSION} {name}", "an entity has one free body at most", check_spec,
                      name, variants)
    else:
        check(f"mjlab {VERSION} {name}", check_spec, name, variants)
finish()
