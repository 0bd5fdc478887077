"""Each row of a family, written into its base in plain MuJoCo, is the variant's own model: the same
numbers, and the same motion.

    check_family.py FOLDER
"""

import json
import pathlib
import sys

import mujoco
import numpy as np

from report import check, expect, finish

KINDS = {"body": mujoco.mjtObj.mjOBJ_BODY, "geom": mujoco.mjtObj.mjOBJ_GEOM,
         "jnt": mujoco.mjtObj.mjOBJ_JOINT, "dof": mujoco.mjtObj.mjOBJ_JOINT,
         "qpos0": mujoco.mjtObj.mjOBJ_JOINT, "qpos": mujoco.mjtObj.mjOBJ_JOINT,
         "site": mujoco.mjtObj.mjOBJ_SITE, "mat": mujoco.mjtObj.mjOBJ_MATERIAL,
         "eq": mujoco.mjtObj.mjOBJ_EQUALITY, "tendon": mujoco.mjtObj.mjOBJ_TENDON,
         "actuator": mujoco.mjtObj.mjOBJ_ACTUATOR}
FLOOR = '<worldbody><geom name="floor" type="plane" size="2 2 1"/>'
STEPS = 100
WORLDS = 16


def rotate(quat, vector):
    out = np.empty(3)
    mujoco.mju_rotVecQuat(out, vector, quat)
    return out


def product(a, b):
    out = np.empty(4)
    mujoco.mju_mulQuat(out, a, b)
    return out


def rows_of(model, array, names, components):
    """Rows of an array of the model that belong to these elements."""
    ids = [mujoco.mj_name2id(model, KINDS[array.split("_")[0]], name) for name in names]
    expect(min(ids) >= 0, f"{array}: {names} are not all in the base")
    if components is None:
        return ids
    first = model.jnt_qposadr if array.startswith("qpos") else model.jnt_dofadr
    return [first[i] + int(c) for i, c in zip(ids, components)]


def with_vertices(base, family, i):
    """The compiled base, with the vertices of variant i in the meshes that differ."""
    spec = mujoco.MjSpec.from_string(base)
    for key in family:
        if key.startswith("mesh_vert/"):
            mesh = next(m for m in spec.meshes if m.name == key[len("mesh_vert/"):])
            mesh.scale = [1, 1, 1]
            mesh.uservert = family[key][i].ravel()
    return spec.compile()


def place_mesh(model, geom):
    """From the pose of a mesh as in MJCF to that of MuJoCo's frame for it."""
    mesh = model.geom_dataid[geom]
    model.geom_pos[geom] += rotate(model.geom_quat[geom], model.mesh_pos[mesh])
    model.geom_quat[geom] = product(model.geom_quat[geom], model.mesh_quat[mesh])


def bound(model, geom):
    """Bounding sphere and box of a primitive geom."""
    kind, size = model.geom_type[geom], model.geom_size[geom]
    types = mujoco.mjtGeom
    r, h = size[0], size[1]
    radius, half = {
        types.mjGEOM_SPHERE: (r, [r, r, r]),
        types.mjGEOM_CAPSULE: (r + h, [r, r, r + h]),
        types.mjGEOM_CYLINDER: (np.hypot(r, h), [r, r, h]),
        types.mjGEOM_ELLIPSOID: (max(size), size),
        types.mjGEOM_BOX: (np.linalg.norm(size), size),
    }[types(kind)]
    model.geom_rbound[geom] = radius
    model.geom_aabb[geom] = [0, 0, 0, *half]


def compiled_base(family, i):
    """The base with the vertices of row i, on a floor."""
    return with_vertices(family["base"].tobytes().decode().replace("<worldbody>", FLOOR), family, i)


def world(family, i):
    """The model of variant i: the base with the numbers of row i."""
    model = compiled_base(family, i)
    meshes = [g for g in range(model.ngeom) if model.geom_type[g] == mujoco.mjtGeom.mjGEOM_MESH]
    for array in family:
        if f"{array}.names" not in family:
            continue
        names = family[f"{array}.names"]
        components = family.get(f"{array}.components")
        values = family[array][i]
        rows = rows_of(model, array, names, components)
        if array == "geom_matid":
            values = [mujoco.mj_name2id(model, KINDS["mat"], family["materials"][m]) if m >= 0 else -1
                      for m in values]
        getattr(model, array)[rows] = np.reshape(values, getattr(model, array)[rows].shape)
    stored = {array: set(family.get(f"{array}.names", [])) for array in ("geom_pos", "geom_quat")}
    pose = mesh_poses(model, family, i, meshes, stored)
    for g in meshes:
        model.geom_pos[g], model.geom_quat[g] = pose[g]
        place_mesh(model, g)
    for g in range(model.ngeom):
        if g not in meshes and model.geom_type[g] != mujoco.mjtGeom.mjGEOM_PLANE:
            bound(model, g)
    for option in ("timestep", "impratio", "density", "viscosity", "gravity", "wind"):
        if f"opt_{option}" in family:
            setattr(model.opt, option, family[f"opt_{option}"][i])
    mujoco.mj_setConst(model, mujoco.MjData(model))
    return model


def mesh_poses(model, family, i, meshes, stored):
    """Poses of mesh geoms as in MJCF; of those that are constant, from the base."""
    spec = mujoco.MjSpec.from_string(family["base"].tobytes().decode())
    in_base = {geom.name: geom for geom in spec.geoms}
    poses = {}
    for g in meshes:
        name = model.geom(g).name
        pos = model.geom_pos[g] if name in stored["geom_pos"] else in_base[name].pos
        quat = model.geom_quat[g] if name in stored["geom_quat"] else in_base[name].quat
        poses[g] = np.array(pos), np.array(quat) / np.linalg.norm(quat)
    return poses


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


def start(model, family, i, from_file):
    """The start state, with free bodies above the floor and all joints in motion."""
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    if from_file:
        for name in ("qpos", "qvel", "act", "ctrl"):
            if f"start_{name}" in family:
                getattr(data, name)[:] = family[f"start_{name}"][i]
    # A key of the base has the positions of its own variant, unless start_qpos replaces them.
    for j in range(model.njnt):
        adr, dof = model.jnt_qposadr[j], model.jnt_dofadr[j]
        if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE:
            data.qpos[adr + 2] += 0.15 + family["horizontal_radius"][i] - family["bottom_offset"][i]
            data.qvel[dof:dof + 6] = [0.1, 0, -1, 1, 2, 0.5]
        else:
            data.qvel[dof] += 0.3
    return data


def simulate(model, data):
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_MIDPHASE  # boxes of trees are not updated
    trace = []
    for _ in range(STEPS):
        mujoco.mj_step(model, data)
        trace.append(data.qpos.copy())
    return np.array(trace)


def check_family(folder):
    family = dict(np.load(folder.with_suffix(".npz"), allow_pickle=False).items())
    facts = json.loads(family["family"].tobytes())
    count = facts["variants"]
    worst = 0
    contacts = 0
    for i in range(0, count, max(1, count // WORLDS)):
        file = folder / f"{facts['name']}_{family['index'][i]:06d}.xml"
        own = mujoco.MjModel.from_xml_string(
            file.read_text(encoding="utf-8").replace("<worldbody>", FLOOR))
        expect_flags(compiled_base(family, i), own)
        mine = world(family, i)
        compare(mine, own)
        first, second = start(mine, family, i, True), start(own, family, i, False)
        expect(np.allclose(first.qpos, second.qpos, atol=1e-9), "another start")
        a, b = simulate(mine, first), simulate(own, second)
        contacts += first.ncon
        expect(np.max(np.ptp(b, axis=0)) > 1e-3, f"variant {i} does not move")
        worst = max(worst, np.max(np.abs(a - b)))
        expect(worst < 1e-9, f"variant {i} is off by {worst:.1e} after {STEPS} steps")
    return f"{count} variants, {len(family)} arrays, {contacts} contacts, off by {worst:.1e}"


for npz in sorted(pathlib.Path(sys.argv[1], "family").glob("*.npz")):
    check(f"mujoco {mujoco.__version__} family {npz.stem}", check_family, npz.with_suffix(""))
finish()
