"""Newton's worlds of a family have the numbers that they have when each variant is read from its own MJCF.

    check_newton_worlds.py FOLDER
"""

import importlib.metadata
import json
import pathlib
import sys

import warp

warp.config.quiet = True
import newton
import numpy as np
from newton.solvers import SolverMuJoCo

import mjforge
from report import check, expect, finish, raises

VERSION = importlib.metadata.version("newton")
FOLDER = pathlib.Path(sys.argv[1], "family")
WORLDS = 8
# What differs between worlds, of bodies, joints and shapes. The rotation of the inertia frame is in the inertia.
NUMBERS = ("body_mass", "body_com", "body_inertia", "joint_X_p", "joint_X_c", "joint_axis", "joint_limit_lower",
           "joint_limit_upper", "joint_friction", "joint_armature", "shape_type", "shape_scale", "shape_transform",
           "shape_material_mu", "shape_world")


def builder_of():
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    return builder


def own_worlds(name):
    """Worlds of the variants' own files."""
    records = [json.loads(line) for line in (FOLDER / name / "manifest.jsonl").read_text().splitlines()]
    builder = builder_of()
    for record in records[:WORLDS]:
        world = builder_of()
        world.add_mjcf(str(FOLDER / name / record["file"]))
        builder.add_world(world)
    return builder.finalize(device="cpu")


def check_family(name):
    family = mjforge.load_family(FOLDER / f"{name}.npz")
    builder = builder_of()
    family.to_newton(builder, range(WORLDS))
    model, own = builder.finalize(device="cpu"), own_worlds(name)
    for field in NUMBERS:
        a, b = getattr(model, field).numpy(), getattr(own, field).numpy()
        expect(a.shape == b.shape, f"{field} has the shape {a.shape}, not {b.shape}")
        # Files have six digits; quaternions that differ in sign are equal.
        near = np.isclose(a, b, rtol=2e-5, atol=2e-6)
        if a.ndim > 1 and a.shape[-1] == 7:
            near[..., 3:] |= np.isclose(a[..., 3:], -b[..., 3:], atol=2e-6)
        expect(near.all(), f"{field} differs by {np.abs(a - b).max():.1e}")
    masses = model.body_mass.numpy().reshape(WORLDS, -1).sum(axis=1)
    expect(len(set(masses.tolist())) == WORLDS, f"masses {masses}")
    return f"{WORLDS} worlds, {len(NUMBERS)} arrays"


def check_steps(name):
    """The worlds of the hammers fall in Newton's own solver for MuJoCo."""
    family = mjforge.load_family(FOLDER / f"{name}.npz")
    builder = builder_of()
    family.to_newton(builder, range(WORLDS))
    model = builder.finalize(device="cpu")
    solver = SolverMuJoCo(model, nconmax=100, njmax=300)
    sizes = solver.mjw_model.geom_size.numpy()
    expect(sizes.shape[0] == WORLDS and (sizes != sizes[:1]).any(), f"sizes {sizes.shape} of one variant")
    state, after = model.state(), model.state()
    for _ in range(10):
        solver.step(state, after, model.control(), None, 0.002)
        state, after = after, state
    fallen = state.joint_q.numpy().reshape(WORLDS, -1)[:, 2]
    expect(np.allclose(fallen, -9.81 * 0.002**2 * 55, atol=1e-5), f"fallen by {fallen}")


def check_refusals():
    family = mjforge.load_family(FOLDER / "hammer.npz")
    raises(TypeError, "builder='a' is not a newton.ModelBuilder but of type str", family.to_newton, "a")
    raises(ValueError, "rows: 64 is not within 0 .. 63", family.to_newton, builder_of(), [64])


for each in ("hammer", "hinged_box", "scissors"):
    check(f"newton {VERSION} worlds of {each}", check_family, each)
check(f"newton {VERSION} steps of hammer", check_steps, "hammer")
check(f"newton {VERSION} refusals of families", check_refusals)
finish()
