"""The variants of a family, each in its world of MJX, move like each alone in MuJoCo: 64 worlds, 100 steps, in
64-bit numbers.

They fall on a ball and not on a plane, because MJX takes only those corners for contacts with a plane that are
within 1 mm of the deepest one, and MuJoCo takes all. The cabinet has 705 pairs of geoms, for all of which MJX
reserves memory, and scissors touch a ball at thin edges and at 25 points, where MJX is less exact: their joints are
driven without contacts.

    check_mjx_worlds.py FOLDER [--slow]

With --slow, the families that take long to compile, and without it the others.
"""

import importlib.metadata
import logging
import os
import pathlib
import re
import subprocess
import sys

os.environ["JAX_PLATFORMS"] = "cpu"
os.environ["JAX_ENABLE_X64"] = "1"
logging.disable(logging.WARNING)

import jax
import jax.numpy as jnp
import mujoco
from mujoco import mjx
import numpy as np

import mjforge
from report import check, expect, finish, raises

VERSION = importlib.metadata.version("mujoco-mjx")
EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "docs/examples/python/hammers_in_mjx.py"
FAST = ("cabinet", "cylinder", "hammer")
STEPS = 100
GAP = 0.02  # above the ball, m
UPRIGHT = ("cylinder", "mug")  # do not turn, so that only the bottom touches the ball: MJX is less exact at edges
RADIUS = {"mug": 0.05}  # of the ball, m
SPEED = {"free": [0.1, 0, 0, 0.5, 1, 0.3], "upright": [0.01, 0, 0, 0, 0, 0], "joint": 0.3, "driven": 5}
DRIVEN = ("cabinet", "scissors")  # their joints move to an end; they touch nothing


def scene_of(family):
    spec = mujoco.MjSpec()
    radius = RADIUS.get(family.facts["name"], 0.5)
    spec.worldbody.add_geom(name="ball", type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[radius, 0, 0], pos=[0, 0, -radius])
    spec.attach(family.base, prefix="thing/", frame=spec.worldbody.add_frame())
    model = spec.compile()
    if family.facts["name"] in DRIVEN:
        model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    return model


def start_of(family, model):
    """Start states: free bodies above the ball, everything in motion."""
    state = family.start(model, "thing/")
    for joint in range(model.njnt):
        at, dof = model.jnt_qposadr[joint], model.jnt_dofadr[joint]
        if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE:
            state["qpos"][:, at + 2] = GAP - np.load(family.path)["bottom_offset"]
            state["qvel"][:, dof:dof + 6] = SPEED["upright" if family.facts["name"] in UPRIGHT else "free"]
        else:
            state["qvel"][:, dof] = SPEED["driven" if family.facts["name"] in DRIVEN else "joint"]
    return state


def alone(family, model, state, row):
    """Positions of a variant in MuJoCo, and the most contacts."""
    own = family.to_model(model, "thing/", row)
    data = mujoco.MjData(own)
    for name, values in state.items():
        getattr(data, name)[...] = values[row]
    positions, contacts = [], 0
    for _ in range(STEPS):
        mujoco.mj_step(own, data)
        positions.append(data.qpos.copy())
        contacts = max(contacts, data.ncon)
    return np.array(positions), contacts


def simulator(model, axes, state):
    """A compiled function of a batched model: positions, [steps, worlds, numbers]."""
    data = mjx.make_data(model)
    start = jax.vmap(lambda own: data.replace(**own))({name: jnp.asarray(each) for name, each in state.items()})
    step = jax.vmap(mjx.step, in_axes=(axes, 0))

    def advance(worlds, data):
        data = step(worlds, data)
        return data, data.qpos

    return jax.jit(lambda worlds: jax.lax.scan(lambda data, _: advance(worlds, data), start, None, STEPS)[1])


def with_shared_hulls(numbers):
    """All worlds have the hulls of the first."""
    def first(each):
        return jnp.broadcast_to(each[:1], each.shape)

    hulls = jax.tree_util.tree_map(first, numbers["_impl.mesh_convex"])
    return {**numbers, "_impl.mesh_convex": hulls}


def check_family(file):
    family = mjforge.load_family(file)
    model = scene_of(family)
    state = start_of(family, model)
    numbers, axes = family.to_mjx(model, "thing/")
    base = mjx.put_model(model)
    run = simulator(model, axes, state)
    positions = np.asarray(run(base.tree_replace(numbers)))
    runs = [alone(family, model, state, row) for row in range(len(family))]
    contacts = sum(each[1] > 0 for each in runs)
    alike = np.stack([each[0] for each in runs], axis=1)
    worst = np.abs(positions - alike).max()
    expect(np.ptp(alike, axis=0).max(axis=1).min() > 1e-3, "not all worlds move")
    expect(family.facts["name"] in DRIVEN or contacts == len(family), f"only {contacts} worlds have contacts")
    expect(worst < 1e-4, f"off by {worst:.1e} m")
    words = f"{len(family)} worlds, {contacts} with contacts, off by {worst:.1e}"
    if file.stem == "cylinder":  # which collides as a prism
        off = np.abs(np.asarray(run(base.tree_replace(with_shared_hulls(numbers)))) - alike).max()
        expect(off > 1e-3, f"with one hull for all they are off by {off:.1e} m only")
        words += f"; with one hull for all by {off:.1e}"
    return words


def check_runs():
    """The example of the cookbook runs as it is written."""
    said = subprocess.run([sys.executable, "-B", str(EXAMPLE)], capture_output=True, text=True)
    expect(said.returncode == 0, said.stderr[-500:])
    line = r"64 worlds with \d+ different hammers of 0\.\d+ to 0\.\d+ kg: pushed by 0\.\d+ to \d\.\d+ m\n"
    lines = [each for each in said.stdout.splitlines(keepends=True) if not each.startswith("Failed to import ")]
    expect(re.fullmatch(f"({line}){{2}}", "".join(lines)), f"it says {said.stdout}")


def check_other_faces(folder):
    """Meshes whose hulls have other faces are refused."""
    family = mjforge.load_family(folder / "uneven.npz")
    raises(ValueError, "have other faces, and MJX has the faces of a geom's hull once for all worlds",
           family.to_mjx, scene_of(family), "thing/")


def refusal(family, words, edit):
    """to_mjx refuses the object in an edited scene."""
    spec = mujoco.MjSpec()
    spec.attach(family.base, prefix="thing/", frame=spec.worldbody.add_frame())
    edit(spec)
    raises(ValueError, words, family.to_mjx, spec.compile(), "thing/")


def check_refusals(folder):
    sensors, objects = mujoco.mjtSensor, mujoco.mjtObj
    boxes, cylinders = (mjforge.load_family(folder / f"{name}.npz") for name in ("hinged_box", "cylinder"))
    refusal(boxes, "site_size differs between the variants, and the model has a sensor of the type touch",
            lambda spec: spec.add_sensor(type=sensors.mjSENS_TOUCH, objtype=objects.mjOBJ_SITE,
                                         objname=spec.sites[0].name))

    def look(spec):
        spec.worldbody.add_site(name="eye")
        eye = spec.add_sensor(type=sensors.mjSENS_RANGEFINDER, objtype=objects.mjOBJ_SITE, objname="eye")
        eye.intprm[0] = 1  # distances

    refusal(cylinders, "geom_dataid differs between the variants, and the model has a sensor of the type rangefinder",
            look)

    def add_ground(spec):
        spec.add_hfield(name="hills", nrow=3, ncol=3, size=[1, 1, 0.1, 0.1], userdata=np.linspace(0, 1, 9))
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_HFIELD, hfieldname="hills", pos=[0, 0, -1])

    refusal(boxes, "is larger in some variants than in the base, for which MJX counts the cells of a height field",
            add_ground)
    refusal(mjforge.load_family(folder / "string.npz"), "a tendon passes inside the geom that it wraps around in some "
            "variants only", lambda spec: None)


FOLDER = pathlib.Path(sys.argv[1], "family_mjx")
IS_SLOW = "--slow" in sys.argv
for npz in sorted(FOLDER.glob("*.npz")):
    if npz.stem not in ("string", "uneven") and (npz.stem in FAST) != IS_SLOW:
        check(f"mjx {VERSION} worlds of {npz.stem}", check_family, npz)
if not IS_SLOW:
    check(f"mjx {VERSION} worlds with hulls of other faces", check_other_faces, FOLDER)
    check(f"mjx {VERSION} refusals of families", check_refusals, FOLDER)
    check(f"mjx {VERSION} example", check_runs)
finish()
