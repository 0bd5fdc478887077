"""Equalities of joints hold to 1 % in a MuJoCo 3 while either joint is driven with little or much
force, with and without gravity.

    check_couplings.py FOLDER
"""

import sys

import mujoco
import numpy as np

from generated import specs
from report import check, expect, finish

TORQUES = [0.01, 0.1, 1]  # Nm
MOST = 0.01  # of the way of joint 1
SECONDS = 1.5


def hold(model):
    """Makes free bodies so heavy that they stay where they are, as in docs/physics.md."""
    for joint in np.flatnonzero(model.jnt_type == mujoco.mjtJoint.mjJNT_FREE):
        dof = model.jnt_dofadr[joint]
        model.dof_armature[dof:dof + 6] += 1e4 * model.body_subtreemass[model.jnt_bodyid[joint]]
    model.opt.tolerance = 1e-12


def way(model, joint):
    """Range of a hinge or a slide; a turn if it has none."""
    lower, upper = model.jnt_range[joint]
    return upper - lower if model.jnt_limited[joint] else 2 * np.pi


def inertia(model, data, dof):
    """Of a joint with all that the equalities move along with it."""
    accelerations = []
    for force in [0, 1e-3]:
        data.qfrc_applied[dof] = force
        mujoco.mj_forward(model, data)
        accelerations.append(data.qacc[dof])
    return 1e-3 / (accelerations[1] - accelerations[0])


def largest_error(model, equality, joint, torque):
    """Of the equality, as a share of joint 1's way, while a controller moves a joint from end to end
    in a second and holds it there. `torque` is the most that it applies; to a slide, the force that
    a thread makes of it."""
    first, second = model.eq_obj1id[equality], model.eq_obj2id[equality]
    coefficients = model.eq_data[equality][:5]
    most = torque if model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_HINGE else \
        torque * abs(coefficients[1])
    dof, own = model.jnt_dofadr[joint], model.jnt_qposadr[joint]
    data = mujoco.MjData(model)
    mass = inertia(model, data, dof)
    start, length = data.qpos[own], way(model, joint)
    error = 0
    while data.time < SECONDS:
        phase = np.pi * min(data.time, 1)
        ahead = start + length * (1 - np.cos(phase)) / 2 - data.qpos[own]
        faster = length * np.pi * np.sin(phase) / 2 - data.qvel[dof]
        data.qfrc_applied[dof] = np.clip(mass * (400 * ahead + 40 * faster), -most, most)
        mujoco.mj_step(model, data)
        x, y = (data.qpos[model.jnt_qposadr[i]] - model.qpos0[model.jnt_qposadr[i]]
                for i in [second, first])
        error = max(error, abs(y - np.polynomial.polynomial.polyval(x, coefficients)))
    return error / (way(model, first) if model.jnt_limited[first]
                    else abs(coefficients[1]) * way(model, second))


def check_spec(variants):
    worst = 0
    for variant in variants:
        for gravity in [True, False]:
            model = mujoco.MjModel.from_xml_path(str(variant.file))
            hold(model)
            if not gravity:
                model.opt.gravity[:] = 0
            for equality in np.flatnonzero(model.eq_type == mujoco.mjtEq.mjEQ_JOINT):
                for joint in [model.eq_obj1id[equality], model.eq_obj2id[equality]]:
                    for torque in TORQUES:
                        error = largest_error(model, equality, joint, torque)
                        worst = max(worst, error)
                        expect(error < MOST, f"{variant}: joint {joint} with {torque} Nm, gravity "
                                             f"{gravity}: {100 * error:.2f} %")
    return f"{100 * worst:.2f} % at most"


def has_coupling(variant):
    model = mujoco.MjModel.from_xml_path(str(variant.file))
    return (model.eq_type == mujoco.mjtEq.mjEQ_JOINT).any()


found = 0
for name, variants in specs(sys.argv[1], "mujoco"):
    # Objects of scenes are among the other specs.
    coupled = [] if name.startswith("scenes/") else [v for v in variants if has_coupling(v)]
    if coupled:
        found += 1
        check(f"couplings {mujoco.__version__} {name}", check_spec, coupled)
check("couplings: specs that have any", lambda: expect(found >= 4, f"{found}"))
finish()
