"""Environments of mjlab with the variants of a family move like each variant alone in MuJoCo, also after a reset that
gives them other variants. They use the Euler integrator, because implicitfast of MuJoCo Warp 3.11 is less exact.
mjlab's own variants of an entity are not made for this: see check_primitives.

    check_mjlab_worlds.py FOLDER
"""

import importlib.metadata
import pathlib
import re
import subprocess
import sys
import tempfile

import warp

warp.config.quiet = True
import mujoco
import numpy as np
import torch
from mjlab.entity import EntityCfg
from mjlab.entity.variants import VariantEntityCfg
from mjlab.envs import ManagerBasedRlEnv, ManagerBasedRlEnvCfg
from mjlab.managers import ObservationGroupCfg, ObservationTermCfg
from mjlab.scene import Scene, SceneCfg
from mjlab.sim import MujocoCfg, Simulation, SimulationCfg
from mjlab.terrains import TerrainEntityCfg

import mjforge
from report import check, expect, finish, raises

VERSION = importlib.metadata.version("mjlab")
HERE = pathlib.Path(__file__).resolve().parent
EXAMPLE = HERE.parents[1] / "docs/examples/python/hammers_in_mjlab.py"
WORLDS = 64
STEPS = 100


def environment_of(events, entities):
    observations = {"actor": ObservationGroupCfg(terms={"time": ObservationTermCfg(
        func=lambda env: env.sim.data.time[:, None])})}
    return ManagerBasedRlEnv(ManagerBasedRlEnvCfg(
        scene=SceneCfg(num_envs=WORLDS, terrain=TerrainEntityCfg(terrain_type="plane"), entities=entities),
        sim=SimulationCfg(nconmax=200, njmax=1200, mujoco=MujocoCfg(integrator="euler")),
        decimation=1,
        episode_length_s=100, events=events, observations=observations, actions={}), device="cpu")


def start(environment, family):
    """Lets the objects fall to the floor, turning. Returns rows, positions and velocities of all worlds."""
    qpos, qvel = environment.sim.data.qpos, environment.sim.data.qvel
    rows = environment.event_manager.get_term_cfg("variants").func.rows
    offsets = np.load(family.path)
    height = 0.15 + offsets["horizontal_radius"][rows] - offsets["bottom_offset"][rows]
    qpos[:, 2] = torch.as_tensor(height, dtype=torch.float32)
    qvel[:] = 0.3
    qvel[:, :6] = torch.tensor([0.1, 0, -1, 1, 2, 0.5])
    return rows.tolist(), qpos.numpy().copy(), qvel.numpy().copy()


def compare(environment, family, prefix):
    """Steps all worlds, and each variant alone. Returns the largest distance and the number of worlds in contact."""
    rows, qpos, qvel = start(environment, family)
    trace = []
    for _ in range(STEPS):
        environment.sim.step()
        trace.append(environment.sim.data.qpos.numpy().copy())
    worst, touched = 0, set()
    for world, row in enumerate(rows):
        own = family.to_model(environment.sim.mj_model, prefix, row)
        data = mujoco.MjData(own)
        data.qpos[:], data.qvel[:] = qpos[world], qvel[world]
        for step in range(STEPS):
            mujoco.mj_step(own, data)
            worst = max(worst, np.abs(data.qpos - trace[step][world]).max())
            if data.ncon:
                touched.add(world)
    expect(worst < 1e-4, f"off by {worst:.1e} m")
    expect(len(touched) > WORLDS / 2, f"only {len(touched)} worlds touch the floor")
    return worst


def check_worlds(file):
    family = mjforge.load_family(file)
    entity, event = family.to_mjlab("thing", mode="reset",
                                    rows=lambda env, worlds: (worlds + env.shift) % len(family))
    entity.init_state = EntityCfg.InitialStateCfg(pos=(0, 0, 0.5))
    ManagerBasedRlEnv.shift = 0
    environment = environment_of({"variants": event}, {"thing": entity})
    environment.reset()
    term = environment.event_manager.get_term_cfg("variants").func
    expect(term.rows.tolist() == list(range(WORLDS)), f"rows {term.rows.tolist()}")
    expect("geom_rbound" in term.model_fields and "body_invweight0" in term.model_fields, f"{term.model_fields}")
    first = compare(environment, family, "thing/")
    before = environment.sim.model.body_mass.numpy().copy()
    environment.shift = 5
    environment.reset(env_ids=torch.tensor([3, 9]))
    expect(term.rows[[2, 3, 9]].tolist() == [2, 8, 14], f"rows {term.rows.tolist()}")
    changed = np.flatnonzero((environment.sim.model.body_mass.numpy() != before).any(axis=1)).tolist()
    expect(changed == [3, 9], f"worlds {changed} have other masses")
    again = compare(environment, family, "thing/")
    return f"{WORLDS} worlds off by {first:.1e}, {again:.1e} after a reset of two"


def check_two_families(folder):
    """Two objects keep their own numbers."""
    hammers, boxes = (mjforge.load_family(folder / f"{name}.npz") for name in ("hammer", "hinged_box"))
    hammer, hammer_event = hammers.to_mjlab("hammer")
    box, box_event = boxes.to_mjlab("box", rows=lambda env, worlds: 63 - worlds)
    environment = environment_of({"variants": hammer_event, "boxes": box_event}, {"hammer": hammer, "box": box})
    model = environment.sim.mj_model
    masses = environment.sim.model.body_mass.numpy()
    for family, prefix, rows in ((hammers, "hammer/", range(64)), (boxes, "box/", range(63, -1, -1))):
        expected = family.fields(model, prefix, list(rows))["body_mass"]
        own = [body for body in range(model.nbody) if model.body(body).name.startswith(prefix)]
        expect(np.allclose(masses[:, own], expected[:, own], rtol=1e-5), f"{prefix} has other masses")
        expect(len(set(masses[:, own].sum(axis=1).tolist())) > 60, f"{prefix} has equal masses")


def check_refusals(folder):
    family = mjforge.load_family(folder / "hammer.npz")
    raises(ValueError, "mode='interval' is not 'startup' or 'reset'", family.to_mjlab, "thing", mode="interval")
    entity, event = family.to_mjlab("thing", rows=lambda env, worlds: worlds + 1)
    raises(ValueError, "are not 64 rows of the 64 in", environment_of, {"variants": event}, {"thing": entity})
    scissors, event = mjforge.load_family(folder / "scissors.npz").to_mjlab("thing")
    scissors.init_state = EntityCfg.InitialStateCfg(pos=(0, 0, 0.5))
    raises(ValueError, "differs between the variants, and mujoco-warp", environment_of, {"variants": event},
           {"thing": scissors})
    entity, event = family.to_mjlab("other")
    raises(ValueError, "did you mean 'thing/'?", environment_of, {"variants": event}, {"thing": entity})


def sizes_with_own_variants(spec, files=False):
    """Sizes of geoms in two worlds, and masses, with mjlab's VariantEntityCfg of two variants."""
    with tempfile.TemporaryDirectory() as folder:
        variants = mjforge.Spec(spec).variants(seed=7, **({"assets": "files"} if files else {}))
        variants.write(folder, 2)
        files = sorted(pathlib.Path(folder).glob("*.xml"))
        own = VariantEntityCfg(variants={file.stem: lambda file=file: mujoco.MjSpec.from_file(str(file))
                                         for file in files}, assignment=lambda count: [0, 1])
        scene = Scene(SceneCfg(num_envs=2, entities={"thing": own}), device="cpu")
        simulation = Simulation(num_envs=2, cfg=SimulationCfg(nconmax=64, njmax=256), spec=scene.spec,
                                variant_info=scene.collect_variant_info(), device="cpu")
        alone = [mujoco.MjModel.from_xml_path(str(file)) for file in files]
    return simulation.model.geom_size.numpy(), simulation.model.body_mass.numpy()[:, 1:].sum(axis=1), alone


def check_primitives():
    """mjlab's VariantEntityCfg takes primitives, and gives all worlds the sizes of the first variant."""
    sizes, masses, alone = sizes_with_own_variants("primitives/box")
    expect(not np.allclose(alone[0].geom_size, alone[1].geom_size), "the variants have equal sizes")
    expect(np.allclose(masses, [model.body_mass.sum() for model in alone], rtol=1e-4), f"masses {masses}")
    expect((sizes[0] == sizes[1]).all(), "the worlds have sizes of their own now: the docs say that they do not")
    return "all worlds have the sizes of the first variant, with masses of their own"


def check_meshes():
    """It works for bodies whose geoms are all meshes."""
    sizes, masses, alone = sizes_with_own_variants(HERE / "uneven.yaml", files=True)
    for world, model in enumerate(alone):
        expect(abs(masses[world] - model.body_mass.sum()) < 1e-4 * masses[world], f"world {world} has another mass")
        for size in model.geom_size:
            expect(any(np.allclose(size, own, rtol=1e-4) for own in sizes[world]), f"world {world} has no {size}")


def check_runs():
    said = subprocess.run([sys.executable, "-B", str(EXAMPLE)], capture_output=True, text=True)
    lines = [line for line in said.stdout.splitlines() if line.startswith("16 environments")]
    expect(said.returncode == 0 and len(lines) == 2, said.stderr[-500:])
    for line in lines:
        expect(re.fullmatch(r"16 environments with 1\d different hammers of 0\.\d+ to 0\.\d+ kg: rewards .*", line),
               line)


FAMILIES = pathlib.Path(sys.argv[1], "family")
check(f"mjlab {VERSION} worlds of hammer", check_worlds, FAMILIES / "hammer.npz")
check(f"mjlab {VERSION} worlds of two families", check_two_families, FAMILIES)
check(f"mjlab {VERSION} refusals", check_refusals, FAMILIES)
check(f"mjlab {VERSION} own variants of primitives", check_primitives)
check(f"mjlab {VERSION} own variants of meshes", check_meshes)
check(f"mjlab {VERSION} example", check_runs)
finish()
