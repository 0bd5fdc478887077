"""robosuite reads each variant, places it on a table with its own sampler, and
it rests there.

    check_robosuite.py FOLDER
"""

import logging
import pathlib
import sys
import xml.etree.ElementTree as ET

logging.disable(logging.WARNING)

import mujoco
import numpy as np
import robosuite
from robosuite.models.arenas import TableArena
from robosuite.models.objects import MujocoXMLObject
from robosuite.models.tasks import ManipulationTask
from robosuite.utils.placement_samplers import UniformRandomSampler

from generated import specs
from report import check, expect, finish

TABLE_TOP = np.array([0, 0, 0.8])
SECONDS = 2
SPEED = 0.05  # m/s and, over the radius, rad/s

# Round underneath: robosuite's table has nothing that stops a roll, and at
# solver precision something always starts one. They must stay on the table.
ROLLING = {"primitives/ball", "primitives/ellipsoid", "primitives/capsule", "articulated/bicycle_wheel",
           "household/umbrella"}
# Wider than the table, over whose edge they tilt, with an origin outside of them. The floor is at -0.8.
WIDE = {"household/umbrella"}


def is_fixed(folder, name, variant):
    """Whether the root has no free joint, which only the file for MuJoCo says."""
    file = pathlib.Path(folder, "mujoco", name, variant.file.name)
    root = ET.parse(file).getroot().find("./worldbody/body")
    return root.find("./joint[@type='free']") is None


def read(variant, fixed, **options):
    if fixed:
        options["joints"] = None
    return MujocoXMLObject(str(variant.file), name=variant.record["name"], **options)


def check_offsets(variant, thing):
    record = variant.record
    expect(np.allclose(thing.bottom_offset, [0, 0, record["bottom_offset"]], atol=1e-9),
           f"{variant}: bottom_offset is {thing.bottom_offset}")
    expect(np.allclose(thing.top_offset, [0, 0, record["top_offset"]], atol=1e-9),
           f"{variant}: top_offset is {thing.top_offset}")
    expect(abs(thing.horizontal_radius - record["horizontal_radius"]) < 1e-9,
           f"{variant}: horizontal_radius is {thing.horizontal_radius}")


def check_names(variant, thing, model):
    for kind, names in [(mujoco.mjtObj.mjOBJ_BODY, thing.bodies),
                        (mujoco.mjtObj.mjOBJ_JOINT, thing.joints),
                        (mujoco.mjtObj.mjOBJ_SITE, thing.sites),
                        (mujoco.mjtObj.mjOBJ_GEOM, thing.contact_geoms + thing.visual_geoms)]:
        for name in names:
            expect(mujoco.mj_name2id(model, kind, name) >= 0,
                   f"{variant}: robosuite's {name!r} is not in the model")


def task_with(thing):
    arena = TableArena(table_full_size=(12, 12, 0.05), table_offset=TABLE_TOP)
    arena.set_origin([0, 0, 0])
    return ManipulationTask(mujoco_arena=arena, mujoco_robots=[], mujoco_objects=[thing])


def place(thing, seed):
    """A pose on the table: pos, quat."""
    sampler = UniformRandomSampler(
        name="sampler", mujoco_objects=thing, x_range=[-5, 5], y_range=[-5, 5],
        reference_pos=TABLE_TOP, z_offset=0.001, rng=np.random.default_rng(seed))
    (pos, quat, _), = sampler.sample().values()
    return np.array(pos), quat


def step(model, data):
    while data.time < SECONDS:
        mujoco.mj_step(model, data)


def free_joint(model, thing):
    """The one that robosuite has added."""
    joints = [model.joint(name) for name in thing.joints]
    free = [joint for joint in joints if joint.type[0] == mujoco.mjtJoint.mjJNT_FREE]
    expect(len(free) == 1, f"{thing.name}: {len(free)} free joints")
    return free[0]


def check_rest(variant, name, thing, fixed, model, data):
    raised = [mujoco.mjtWarning(i).name for i in range(len(data.warning)) if data.warning[i].number]
    expect(not raised, f"{variant}: {', '.join(raised)}")
    expect(np.isfinite(data.qpos).all(), f"{variant}: a position is not finite")
    reach = max(variant.record["horizontal_radius"], variant.record["top_offset"],
                -variant.record["bottom_offset"])
    if fixed:
        speed = max(abs(data.qvel), default=0) * reach
        expect(speed < SPEED, f"{variant}: its joints move at {speed:.3f} m/s after {SECONDS} s")
        return
    body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, thing.root_body)
    height = data.xpos[body][2] - TABLE_TOP[2]
    lowest = -0.05 if name in WIDE else -0.01
    expect(lowest < height < 2 * reach + 0.01, f"{variant}: is {height} m above the table")
    if name in ROLLING:
        return
    joint = free_joint(model, thing)
    velocity = data.qvel[joint.dofadr[0]:joint.dofadr[0] + 6]
    speed = max(np.linalg.norm(velocity[:3]), np.linalg.norm(velocity[3:]) * reach)
    expect(speed < SPEED, f"{variant}: moves at {speed:.3f} m/s after {SECONDS} s")


def check_variant(name, variant, seed):
    fixed = is_fixed(sys.argv[1], name, variant)
    # Every other one with the visual geoms that robosuite makes by itself.
    thing = read(variant, fixed, duplicate_collision_geoms=seed % 2 == 0)
    check_offsets(variant, thing)
    pos, quat = place(thing, seed)
    if fixed:
        thing.set_pos(pos)
    model = task_with(thing).get_model()
    check_names(variant, thing, model)
    data = mujoco.MjData(model)
    if not fixed:
        start = free_joint(model, thing).qposadr[0]
        data.qpos[start:start + 7] = np.concatenate([pos, quat])
    step(model, data)
    check_rest(variant, name, thing, fixed, model, data)


def check_spec(name, variants):
    for seed, variant in enumerate(variants):
        check_variant(name, variant, seed)
    return f"{len(variants)} variants"


for name, variants in specs(sys.argv[1], "robosuite"):
    check(f"robosuite {robosuite.__version__} {name}", check_spec, name, variants)
finish()
