"""A scene for families, their own variants in the same scene, and the start of a drop or a drive."""

import pathlib

import mjforge
import mujoco
import numpy as np

SCENE = ('<mujoco><compiler usethread="false"/><worldbody><geom name="floor" type="plane" size="2 2 1"/>'
         '<frame name="place" pos="0.3 -0.2 0" euler="0 0 50"/></worldbody></mujoco>')
PREFIX = "its/"
STEPS = 100


def families(folder):
    """Path and family of each .npz file."""
    for file in sorted(pathlib.Path(folder, "family").glob("*.npz")):
        yield file, mjforge.load_family(file)


def on_floor(thing):
    """The compiled model of a spec on a floor, away from the world's origin."""
    scene = mujoco.MjSpec.from_string(SCENE)
    scene.attach(thing, prefix=PREFIX, frame=scene.frame("place"))
    return scene.compile()


def xml_of(file, family, row):
    """The path of a variant's own MJCF, beside the family's file."""
    return file.with_suffix("") / f"{family.facts['name']}_{family.index[row]:06d}.xml"


def in_motion(family, model):
    """The start state of all variants, with free bodies above the floor and all joints in motion."""
    state = family.start(model, PREFIX)
    heights = 0.15 + family.arrays["horizontal_radius"] - family.arrays["bottom_offset"]
    for joint in range(model.njnt):
        adr, dof = model.jnt_qposadr[joint], model.jnt_dofadr[joint]
        if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE:
            state["qpos"][:, adr + 2] += heights
            state["qvel"][:, dof:dof + 6] = [0.1, 0, -1, 1, 2, 0.5]
        else:
            state["qvel"][:, dof] += 0.3
    return state


def simulate(model, state, row):
    """The positions of joints after each step from the start of a row, [steps, nq], and the contacts at the end."""
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = state["qpos"][row], state["qvel"][row]
    trace = np.empty((STEPS, model.nq))
    for step in range(STEPS):
        mujoco.mj_step(model, data)
        trace[step] = data.qpos
    return trace, data.ncon


def simulate_alone(file, family, state):
    """The positions of joints of each variant's own MJCF in the scene, [steps, variants, nq]."""
    traces = [simulate(on_floor(mujoco.MjSpec.from_file(str(xml_of(file, family, row)))), state, row)[0]
              for row in range(len(family))]
    return np.stack(traces, axis=1)
