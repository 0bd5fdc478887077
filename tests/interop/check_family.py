"""Each row of a family, written into the model of a scene in plain MuJoCo, is the variant's own model in
that scene: the same numbers, and the same motion.

    check_family.py FOLDER
"""

import json
import pathlib
import pickle
import sys
import tempfile

import mjforge
import mujoco
import numpy as np

from report import check, expect, finish, raises
from scenes import PREFIX, STEPS, families, in_motion, on_floor, simulate, xml_of

WORLDS = 16


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
          "actuator_gainprm actuator_biasprm actuator_gear actuator_user tendon_range tendon_lengthspring wrap_prm "
          "sensor_cutoff sensor_noise pair_margin numeric_data").split()


def twins(mine, own, kind):
    """Ids, in the model of a family, of the elements of a variant, which lacks those that are null. A geom of another
    type than the first one of its name has its type in its name."""
    name_of = lambda i: getattr(own, kind)(i).name
    if getattr(mine, f"n{kind}") == getattr(own, f"n{kind}"):
        return np.arange(getattr(own, f"n{kind}"))
    ids = []
    for i in range(getattr(own, f"n{kind}")):
        twin = getattr(mine, kind)(name_of(i))
        if kind == "geom" and mine.geom_type[twin.id] != own.geom_type[i]:
            stem, _, suffix = name_of(i).partition("_vis")
            type_name = mujoco.mjtGeom(own.geom_type[i]).name.removeprefix("mjGEOM_").lower()
            twin = mine.geom(f"{stem}.{type_name}" + ("_vis" if name_of(i).endswith("_vis") else suffix))
        ids.append(twin.id)
    return np.array(ids, dtype=int)


def compare(mine, own):
    """That all fields of two models are equal."""
    ids = {kind: twins(mine, own, kind) for kind in ("geom", "site")}
    for field in FIELDS:
        a, b = getattr(mine, field), getattr(own, field)
        a = a[ids[field.split("_")[0]]] if field.split("_")[0] in ids else a
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
    look = lambda m, geoms: [m.mat(m.geom_matid[g]).name if m.geom_matid[g] >= 0 else "" for g in geoms]
    expect(look(mine, ids["geom"]) == look(own, range(own.ngeom)), "other materials")
    null = np.setdiff1d(np.arange(mine.ngeom), ids["geom"])
    expect((mine.geom_rgba[null] == 0).all() and (mine.geom_matid[null] < 0).all(), "a null geom is visible")
    colour = lambda m: {m.mat(k).name: m.mat_rgba[k] for k in range(m.nmat)}
    for name, rgba in colour(own).items():
        expect(np.allclose(colour(mine)[name], rgba, atol=1e-6), f"{name} has another colour")


def expect_flags(base, own):
    """That each flag of the base, from which an engine skips work, is right for a variant."""
    geoms, sites = twins(base, own, "geom"), twins(base, own, "site")
    everything = np.arange(own.nbody)
    weighs = own.body_mass > 0
    is_mesh = own.geom_type == mujoco.mjtGeom.mjGEOM_MESH  # whose frame depends on the release
    frames = mujoco.mjtSameFrame
    for field, ids, counts in (("body_sameframe", everything, weighs), ("geom_sameframe", geoms, ~is_mesh),
                               ("site_sameframe", sites, np.full(own.nsite, True))):
        a, b = getattr(base, field)[ids][counts], getattr(own, field)[counts]
        right = ((a == frames.mjSAMEFRAME_NONE) | (a == b)
                 | ((a == frames.mjSAMEFRAME_BODYROT) & (b == frames.mjSAMEFRAME_BODY))
                 | ((a == frames.mjSAMEFRAME_INERTIAROT) & (b == frames.mjSAMEFRAME_INERTIA)))
        expect(right.all(), f"{field} is {a}, and of the variant {b}")


def own_start(model, alone):
    """The start of a variant in the scene: its free bodies where they stand there, all other joints as in the
    keyframe of its file."""
    qpos = model.qpos0.copy()
    for j in range(alone.njnt if alone.nkey else 0):
        if alone.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE:
            qpos[model.joint(f"{PREFIX}{alone.joint(j).name}").qposadr[0]] = alone.key_qpos[0, alone.jnt_qposadr[j]]
    return qpos


def check_family(file, family):
    scene = on_floor(family.base)
    starts, moving = family.start(scene, PREFIX), in_motion(family, scene)
    worst = contacts = 0
    for row in range(0, len(family), max(1, len(family) // WORLDS)):
        xml = str(xml_of(file, family, row))
        own = on_floor(mujoco.MjSpec.from_file(xml))
        expect_flags(scene, own)
        mine = family.to_model(scene, PREFIX, row)
        compare(mine, own)
        qpos = own_start(own, mujoco.MjModel.from_xml_path(xml))
        expect(np.allclose(starts["qpos"][row], qpos, atol=1e-9), "another start")
        (a, count), (b, _) = simulate(mine, moving, row), simulate(own, moving, row)
        contacts += count
        expect(np.max(np.ptp(b, axis=0)) > 1e-3, f"variant {row} does not move")
        worst = max(worst, np.max(np.abs(a - b)))
        expect(worst < 1e-9, f"variant {row} is off by {worst:.1e} after {STEPS} steps")
    return f"{len(family)} variants, {len(family.arrays)} arrays, {contacts} contacts, off by {worst:.1e}"


ARM = """<mujoco><worldbody><geom name="floor" type="plane" size="2 2 1"/>
  <body name="arm" pos="0.5 0 0"><joint name="turn" axis="0 0 1"/><geom type="capsule" size="0.02 0.2" pos="0 0 0.3"/>
    <body name="hand" pos="0 0 0.5"><joint name="bend" axis="0 1 0"/><geom type="box" size="0.05 0.05 0.05"/></body>
  </body></worldbody><actuator><motor name="turn" joint="turn"/></actuator></mujoco>"""
PLACES = {"left/": [-0.4, 0.3, 0.4], "right/": [0.2, -0.5, 0.4]}


def beside_an_arm(*things):
    scene = mujoco.MjSpec.from_string(ARM)
    for (prefix, pos), thing in zip(PLACES.items(), things):
        scene.attach(thing, prefix=prefix, frame=scene.worldbody.add_frame(pos=pos))
    return scene.compile()


def check_two_beside_a_robot(folder):
    """Worlds with an arm, two objects of a family, and other variants in each."""
    file = pathlib.Path(folder, "family/hammer.npz")
    family = mjforge.load_family(file)
    model = beside_an_arm(family.base, family.base)
    rows = np.array([[5, 40], [63, 0], [7, 7]])
    fields = family.fields(model, list(PLACES), rows)
    first = family.fields(model, "left/", rows[:, 0])
    again = family.fields(model, "right/", rows[:, 1], over=first)
    expect(set(fields) == set(again), f"{set(fields) ^ set(again)}")
    for name, array in fields.items():
        expect(np.allclose(array, again[name], rtol=1e-12, atol=1e-15), f"{name} depends on the order")
    for world, pair in enumerate(rows):
        own = beside_an_arm(*(mujoco.MjSpec.from_file(str(xml_of(file, family, row))) for row in pair))
        mine = beside_an_arm(family.base, family.base)
        for name, array in fields.items():
            part, _, member = name.rpartition(".")
            holder = getattr(mine, part) if part else mine
            if part:
                setattr(holder, member, array[world])
            else:
                getattr(holder, member)[:len(array[world])] = array[world]
        compare(mine, own)
        expect(np.isclose(mine.stat.meaninertia, own.stat.meaninertia), "another mean inertia")


def check_pose_in_another_frame(folder):
    """An object that the user moved before it was compiled starts there."""
    family = mjforge.load_family(pathlib.Path(folder, "family/hammer.npz"))
    thing = family.base
    thing.bodies[1].pos = [1, 2, 3]
    qpos = family.start(on_floor(thing), PREFIX, [4])["qpos"][0]
    away = np.array([0.3 + np.cos(np.radians(50)) - 2 * np.sin(np.radians(50)),
                     -0.2 + np.sin(np.radians(50)) + 2 * np.cos(np.radians(50)), 3])
    expect(np.allclose(qpos[:3], away), f"it is at {qpos[:3]}, not at {away}")


def check_table(folder):
    """Numbers and parameters are those of the variants."""
    family = mjforge.load_family(pathlib.Path(folder, "family/hammer.npz"))
    variants = mjforge.Spec("robosuite/hammer").variants(seed=7, set={"handle_shape": "box"})[:64]
    mine, own = family.table(frame=False), variants.table(frame=False)
    expect(set(mine) == set(own), f"{set(mine) ^ set(own)}")
    for name, column in own.items():
        expect(np.array_equal(mine[name], column), f"{name} differs")
    expect(np.array_equal(family.parameters["handle_length"], own["params.handle_length"]), "another handle_length")
    with tempfile.TemporaryDirectory() as place:  # indices that only integers without a sign have
        variants.spec.variants(seed=7).write(f"{place}/last.npz", 2, first=2**63 - 1)
        mine = mjforge.load_family(f"{place}/last.npz").table(frame=False)["index"]
        own = variants.spec.variants(seed=7)[2**63 - 1:2**63 + 1].table(frame=False)["index"]
        expect(mine.dtype == own.dtype and np.array_equal(mine, own), f"indices {mine}, not {own}")
    expect(family.facts["seed"] == 7 and len(family) == 64, f"{family.facts}")
    again = pickle.loads(pickle.dumps(family))
    expect(np.array_equal(again.arrays["geom_size"], family.arrays["geom_size"]), "a pickle has other numbers")


def check_one(folder):
    """A family of one variant: the others were invalid."""
    members = dict(np.load(pathlib.Path(folder, "family/hammer.npz")).items())
    facts = members["family"].tobytes().replace(b'"variants":64', b'"variants":1')
    one = {name: array[:1] if len(array.shape) and len(array) == 64 and not name.endswith(".names") else array
           for name, array in members.items()}
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place, "one.npz")
        np.savez(file, **{**one, "family": np.frombuffer(facts, "u1")})
        family = mjforge.load_family(file)
        fields = family.fields(on_floor(family.base), PREFIX, [0, 0, 0])
        expect(all(len(array) == 3 for array in fields.values()) and len(family) == 1, f"{list(fields)}")


ROCK = {"mjforge": 1, "name": "rock", "params": {"s": {"uniform": [0.05, 0.15]}}, "parts": [
    {"name": "k", "type": "mesh", "file": "t.obj", "scale": ["s", "s", 0.1], "density": 500}]}
CORNERS = "v 0 0 0\nv 1 0 0\nv 0 1.3 0\nv 0.2 0.1 0.8\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


def check_mesh_from_a_file(folder):
    """A mesh that variants scale differently. Its copies need a hull, which early releases cannot make."""
    with tempfile.TemporaryDirectory() as place:
        pathlib.Path(place, "t.obj").write_text(CORNERS)
        spec = pathlib.Path(place, "rock.json")
        spec.write_text(json.dumps(ROCK))
        for output in ("rock.npz", "rock/"):
            report = mjforge.Spec(spec).variants(seed=7).write(f"{place}/{output}", 8)
            expect(report.ok, str(report))
        file = pathlib.Path(place, "rock.npz")
        family = mjforge.load_family(file)
        if tuple(map(int, mujoco.__version__.split(".")[:2])) >= (3, 12):
            return check_family(file, family)
        raises(ImportError, "mesh 'rock_k' differs", lambda: family.base)


RIG = """
mjforge: 1
name: rig
joints: none
params: {width: 4cm .. 8cm, turn: 5deg .. 40deg, speed: 0.1 .. 1, kp: 20 .. 50}
parts: [{name: palm, type: box, size: [1cm, width / 2, 1cm]}]
sites: [{name: eye, pos: [0, 0, 3cm]}]
bodies:
  - name: finger_${i}
    for: {i: 2}
    pos: [0, (2 * i - 1) * (width / 2 - 1cm), 4.1cm]
    parts:
      - {name: 'pad_${i}', type: box, size: [1cm, 5mm, 3cm]}
      - {name: 'tip_${i}', type: box, size: [1cm, 5mm, 5mm], pos: [2cm, 0, 25mm]}  # turns the axes of inertia
    joints: [{name: 'slide_${i}', type: slide, axis: [0, 1 - 2 * i, 0], range: [0, width / 2 - 1.5cm]}]
  - name: flap
    pos: [-4cm, 0, 0]
    parts: [{name: flap, type: box, size: [2cm, 1cm, 2mm]}]
    joints: [{name: swing, axis: [0, 1, 0], range: [-90deg, 90deg], armature: 0.01}]
  - name: lever
    pos: [6cm, 0, 0]
    parts: [{name: lever, type: box, size: [2cm, 1cm, 2mm]}]
    sites: [{name: hook, pos: [0, 0, width / 2]}]
    joints: [{name: tilt, axis: [0, 1, 0], range: [-90deg, 90deg], armature: 0.01}]
contact: {exclude: [[finger_0, finger_1]]}
pose:
  - {joint: swing, value: turn, velocity: speed}
  - {joint: tilt, value: turn / 2}
mjcf:
  tendon:
    - fixed: {name: grip, children: [{joint: {joint: slide_0, coef: 0.5}}, {joint: {joint: slide_1, coef: width + 0.4}}]}
    - spatial: {name: spring, stiffness: kp, children: [{site: {site: eye}}, {site: {site: hook}}]}
  custom: [{numeric: {name: gain, data: [1, kp]}}]
  sensor: [{tendonpos: {name: opening, tendon: grip, cutoff: kp, noise: width / 100}}]
  contact:
    - pair: {geom1: flap, geom2: lever}
    - pair: {geom1: palm, geom2: lever, margin: width / 100}
  equality: [{joint: {name: together, joint1: slide_0, joint2: slide_1}}]
  actuator:
    - position: {name: close, tendon: grip, kp: kp, ctrlrange: [0, width / 2]}
    - position: {name: servo, joint: swing, kp: 2, user: [1, kp]}
    - intvelocity: {name: drive, joint: tilt, kp: 2, actrange: [-3, 3]}
"""


def check_actuators(folder):
    """Objects with tendons, equalities and actuators: their starts have velocities, controls and activations."""
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place, "rig.npz")
        for output in (file, f"{place}/rig/"):
            report = mjforge.Spec(RIG).variants(seed=7).write(output, 8)
            expect(report.ok, str(report))
        family = mjforge.load_family(file)
        scene = on_floor(family.base)
        starts = family.start(scene, PREFIX)
        for name in ("qpos", "qvel", "act", "ctrl"):
            expect(len(np.unique(starts[name].round(9), axis=0)) == 8, f"{name} of all starts: {starts[name]}")
        for row in range(len(family)):
            xml = str(xml_of(file, family, row))
            own, alone = on_floor(mujoco.MjSpec.from_file(xml)), mujoco.MjModel.from_xml_path(xml)
            mine = family.to_model(scene, PREFIX, row)
            compare(mine, own)
            for name, values in starts.items():
                expect(np.allclose(values[row], getattr(alone, f"key_{name}")[0], atol=1e-9), f"another {name}")
            expect(np.allclose(driven(mine, starts, row), driven(own, starts, row), rtol=0, atol=1e-9), "another motion")


HUNG = """
mjforge: 1
name: hung
params: {h: 3cm .. 9cm}
joints: none
parts: [{name: hull, type: box, size: [10cm, 3cm, h], mass: 0.1}]
bodies:
  - {name: arm, pos: [0.1, 0, h + 0.05], joints: free, parts: [{name: arm, type: box, size: [2cm, 2cm, 3cm], mass: 0.1}]}
  - {name: bob, pos: [0.3, 0, h + 0.05], joints: free, parts: [{name: bob, type: box, size: [2cm, 3cm, 2cm], mass: 0.1}]}
mjcf:
  equality:
    - weld: {name: fixed, body1: arm, anchor: [0, 0.1, h]}
    - connect: {name: held, body1: bob, anchor: [0, h, 0]}
"""


def check_welds(folder):
    """Equalities with the world are where the object stands in the scene."""
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place, "hung.npz")
        for output in (file, f"{place}/hung/"):
            expect(mjforge.Spec(HUNG).variants(seed=7).write(output, 8).ok, "not written")
        family = mjforge.load_family(file)
        scene = on_floor(family.base)
        starts = family.start(scene, PREFIX)
        for row in range(len(family)):
            own = on_floor(mujoco.MjSpec.from_file(str(xml_of(file, family, row))))
            mine = family.to_model(scene, PREFIX, row)
            compare(mine, own)
            expect(np.allclose(driven(mine, starts, row), driven(own, starts, row), rtol=0, atol=1e-9), "another motion")


MOON = {"mjforge": 1, "name": "moon", "params": {"g": "1 .. 9"}, "parts": [{"name": "rock", "type": "sphere", "size": 0.01}],
        "mjcf": {"option": {"gravity": [0, 0, "-g"]}}}


def check_options(folder):
    """Objects of one world must not draw the same option."""
    with tempfile.TemporaryDirectory() as place:
        mjforge.Spec(MOON).variants(seed=7).write(f"{place}/moon.npz", 4)
        family = mjforge.load_family(f"{place}/moon.npz")
        scene = mujoco.MjSpec()
        for prefix in ("a/", "b/"):
            scene.attach(family.base, prefix=prefix, frame=scene.worldbody.add_frame())
        model = scene.compile()
        gravity = family.fields(model, ["a/", "b/"], [[0, 0], [1, 1]])["opt.gravity"]
        expect(np.allclose(gravity[:, 2], [-family.parameters["g"][row] for row in (0, 1)]), f"gravity {gravity}")
        raises(ValueError, "opt.gravity differs", family.fields, model, ["a/", "b/"], [[0, 1]])


def driven(model, starts, row):
    """Where a start of a family is after some steps with its controls."""
    data = mujoco.MjData(model)
    for name, values in starts.items():
        getattr(data, name)[:] = values[row]
    mujoco.mj_step(model, data, STEPS)
    return data.qpos


RELEASE = f"mujoco {mujoco.__version__} family"
for npz, one in families(sys.argv[1]):
    check(f"{RELEASE} {npz.stem}", check_family, npz, one)
for name, action in {"twice, beside a robot": check_two_beside_a_robot,
                     "where the user moved it": check_pose_in_another_frame,
                     "as a table": check_table, "of one": check_one, "of a mesh file": check_mesh_from_a_file,
                     "with options": check_options, "with actuators": check_actuators, "welded to the world": check_welds}.items():
    check(f"{RELEASE}, {name}", action, sys.argv[1])
finish()
