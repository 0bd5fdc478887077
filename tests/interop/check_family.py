"""Each row of a family, written into the model of a scene in plain MuJoCo, is the variant's own model in
that scene: the same numbers, and the same motion.

    check_family.py FOLDER
"""

import pathlib
import sys

import mjforge
import mujoco
import numpy as np

from report import check, expect, finish

SCENE = ('<mujoco><compiler usethread="false"/><worldbody><geom name="floor" type="plane" size="2 2 1"/>'
         '<frame name="place" pos="0.3 -0.2 0" euler="0 0 50"/></worldbody></mujoco>')
STEPS = 100
WORLDS = 16


def on_floor(thing):
    """The compiled model of a spec on a floor, away from the world's origin."""
    scene = mujoco.MjSpec.from_string(SCENE)
    scene.attach(thing, prefix="its/", frame=scene.frame("place"))
    return scene.compile()


def tensors(model):
    out = np.empty((model.nbody, 3, 3))
    for b in range(model.nbody):
        matrix = np.empty(9)
        mujoco.mju_quat2Mat(matrix, model.body_iquat[b])
        axes = matrix.reshape(3, 3)
        out[b] = axes @ np.diag(model.body_inertia[b]) @ axes.T
    return out


FIELDS = ("body_pos body_quat body_mass body_ipos body_subtreemass body_invweight0 geom_type geom_size "
          "geom_pos geom_quat geom_friction geom_rbound geom_solref geom_solimp geom_margin jnt_type "
          "jnt_pos jnt_axis jnt_range jnt_stiffness dof_damping dof_frictionloss dof_armature dof_M0 "
          "dof_invweight0 qpos0 qpos_spring site_pos site_quat site_size site_rgba eq_data "
          "actuator_gainprm actuator_biasprm actuator_gear tendon_range").split()


def compare(mine, own):
    """That all fields of two models are equal."""
    for field in FIELDS:
        a, b = getattr(mine, field), getattr(own, field)
        if field in ("body_ipos", "body_invweight0"):  # a body without mass has no centre
            a, b = a[own.body_mass > 0], b[own.body_mass > 0]
        expect(a.shape == b.shape, f"{field} has the shape {a.shape}, not {b.shape}")
        if field.endswith("quat") and a.size:
            signs = np.sign(np.sum(a * b, axis=-1, keepdims=True))
            a = a * np.where(signs == 0, 1, signs)
        scale = max(float(np.max(np.abs(b), initial=0)), 1e-6)
        error = np.max(np.abs(a - b), initial=0) / scale
        expect(error < 1e-6, f"{field} differs by {error:.1e} of {scale:.2g}")
    a, b = tensors(mine), tensors(own)
    error = np.max(np.abs(a - b)) / np.max(np.abs(b))
    expect(error < 1e-6, f"inertia differs by {error:.1e}")
    look = lambda m: [m.mat(m.geom_matid[g]).name if m.geom_matid[g] >= 0 else "" for g in range(m.ngeom)]
    expect(look(mine) == look(own), "other materials")
    colour = lambda m: {m.mat(k).name: m.mat_rgba[k] for k in range(m.nmat)}
    for name, rgba in colour(own).items():
        expect(np.allclose(colour(mine)[name], rgba, atol=1e-6), f"{name} has another colour")


def expect_flags(base, own):
    """That each flag of the base, from which an engine skips work, is right for a variant."""
    weighs = own.body_mass > 0
    is_mesh = own.geom_type == mujoco.mjtGeom.mjGEOM_MESH  # whose frame depends on the release
    frames = mujoco.mjtSameFrame
    for field, counts in (("body_sameframe", weighs), ("geom_sameframe", ~is_mesh),
                          ("site_sameframe", np.full(own.nsite, True))):
        a, b = getattr(base, field)[counts], getattr(own, field)[counts]
        right = ((a == frames.mjSAMEFRAME_NONE) | (a == b)
                 | ((a == frames.mjSAMEFRAME_BODYROT) & (b == frames.mjSAMEFRAME_BODY))
                 | ((a == frames.mjSAMEFRAME_INERTIAROT) & (b == frames.mjSAMEFRAME_INERTIA)))
        expect(right.all(), f"{field} is {a}, and of the variant {b}")


def start(model, qpos, height):
    """The start state, with free bodies above the floor and all joints in motion."""
    data = mujoco.MjData(model)
    data.qpos[:] = qpos
    for j in range(model.njnt):
        adr, dof = model.jnt_qposadr[j], model.jnt_dofadr[j]
        if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE:
            data.qpos[adr + 2] += height
            data.qvel[dof:dof + 6] = [0.1, 0, -1, 1, 2, 0.5]
        else:
            data.qvel[dof] += 0.3
    return data


def own_start(model, alone):
    """The start of a variant in the scene: its free bodies where they stand there, all other joints as in the
    keyframe of its file."""
    qpos = model.qpos0.copy()
    for j in range(alone.njnt if alone.nkey else 0):
        if alone.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE:
            qpos[model.joint(f"its/{alone.joint(j).name}").qposadr[0]] = alone.key_qpos[0, alone.jnt_qposadr[j]]
    return qpos


def simulate(model, data):
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_MIDPHASE  # boxes of trees are not updated
    trace = []
    for _ in range(STEPS):
        mujoco.mj_step(model, data)
        trace.append(data.qpos.copy())
    return np.array(trace)


def check_family(file):
    family = mjforge.load_family(file)
    scene = on_floor(family.base)
    starts = family.start(scene, "its/")
    heights = 0.15 + family.arrays["horizontal_radius"] - family.arrays["bottom_offset"]
    worst = 0
    contacts = 0
    for i in range(0, len(family), max(1, len(family) // WORLDS)):
        xml = file.with_suffix("") / f"{family.facts['name']}_{family.index[i]:06d}.xml"
        own = on_floor(mujoco.MjSpec.from_file(str(xml)))
        expect_flags(scene, own)
        mine = family.to_model(scene, "its/", i)
        compare(mine, own)
        qpos = own_start(own, mujoco.MjModel.from_xml_path(str(xml)))
        expect(np.allclose(starts["qpos"][i], qpos, atol=1e-9), "another start")
        first, second = start(mine, starts["qpos"][i], heights[i]), start(own, qpos, heights[i])
        a, b = simulate(mine, first), simulate(own, second)
        contacts += first.ncon
        expect(np.max(np.ptp(b, axis=0)) > 1e-3, f"variant {i} does not move")
        worst = max(worst, np.max(np.abs(a - b)))
        expect(worst < 1e-9, f"variant {i} is off by {worst:.1e} after {STEPS} steps")
    return f"{len(family)} variants, {len(family.arrays)} arrays, {contacts} contacts, off by {worst:.1e}"


for npz in sorted(pathlib.Path(sys.argv[1], "family").glob("*.npz")):
    check(f"mujoco {mujoco.__version__} family {npz.stem}", check_family, npz)
finish()
