"""Each of 64 worlds has its own variant of a family, in MuJoCo Warp (here on the CPU) and in mujoco.batch: all
move as each variant's own MJCF moves alone in plain MuJoCo.

    check_worlds.py FOLDER
"""

import functools
import importlib.metadata
import pathlib
import re
import subprocess
import sys
import tempfile

import warp

warp.config.quiet = True
import mjforge
import mujoco
import mujoco_warp
import numpy as np
from mjforge import _to_warp
from mujoco import batch

from report import check, expect, finish, raises
from scenes import PREFIX, STEPS, families, in_motion, on_floor, simulate_alone

WARP = f"mujoco-warp {importlib.metadata.version('mujoco-warp')}"
EXAMPLE = pathlib.Path(__file__).parents[2] / "docs/examples/python/hammers_in_warp.py"
BATCH = f"mujoco.batch {mujoco.__version__}"


@functools.lru_cache(maxsize=1)
def case(file):
    """A family, the compiled scene, the start of all variants, and where each is after each step alone."""
    family = mjforge.load_family(file)
    model = on_floor(family.base)
    state = in_motion(family, model)
    return family, model, state, simulate_alone(file, family, state)


def put(model, state):
    """Worlds of Warp at the start."""
    worlds = len(state["qpos"])
    data = mujoco_warp.put_data(model, mujoco.MjData(model), nworld=worlds, nconmax=200, njmax=1200)
    for name, values in state.items():
        getattr(data, name).assign(values)
    return data


def drift(m, model, state, alone):
    """The largest distance of a world from its variant alone, over all steps."""
    data = put(model, state)
    worst = 0
    for step in range(STEPS):
        mujoco_warp.step(m, data)
        worst = max(worst, np.abs(data.qpos.numpy() - alone[step]).max())
    return worst


def check_warp(file):
    family, model, state, alone = case(file)
    m = mujoco_warp.put_model(model)
    family.to_warp(m, model, PREFIX)
    off = drift(m, model, state, alone)
    expect(off < 1e-4, f"off by {off:.1e}")
    return f"{len(family)} worlds, off by {off:.1e}"


def check_batch(file):
    family, model, state, alone = case(file)
    worlds = batch.Batch(model, nsim=len(family))
    family.to_batch(worlds, PREFIX)
    for name, values in state.items():
        setattr(worlds, name, values)
    worst = 0
    for step in range(STEPS):
        worlds.step()
        worst = max(worst, np.abs(worlds.qpos - alone[step]).max())
    expect(worst < 1e-12, f"off by {worst:.1e}")
    return f"{len(family)} simulations, off by {worst:.1e}"


def check_shared_derived_fields(file):
    """Worlds in which only the stored numbers are written, and derived fields are those of the base, drift."""
    family, model, state, alone = case(file)
    m = mujoco_warp.put_model(model)
    fields = family.fields(model, PREFIX)
    _to_warp.write(m, {name: fields[name] for name in family.names if name in fields}, model)
    off = drift(m, model, state, alone)
    expect(off > 1e-3, f"off by only {off:.1e}")
    return f"off by {off:.1e}"


def check_reset(file):
    """Some worlds get other variants, in the same memory, and all others keep theirs."""
    family, model, state, alone = case(file)
    m = mujoco_warp.put_model(model)
    raises(ValueError, "has numbers of 1 worlds, and not of world 9", family.to_warp, m, model, PREFIX, [40, 8],
           worlds=[3, 9])
    family.to_warp(m, model, PREFIX)
    before = m.geom_size.ptr, m.body_mass.ptr
    family.to_warp(m, model, PREFIX, [40, 8], worlds=[3, 9])
    expect(before == (m.geom_size.ptr, m.body_mass.ptr), "other arrays")
    rows = np.arange(len(family))
    rows[[3, 9]] = 40, 8
    off = drift(m, model, {name: values[rows] for name, values in state.items()}, alone[:, rows])
    expect(off < 1e-4, f"off by {off:.1e}")
    simulations = batch.Batch(model, nsim=len(family))
    family.to_batch(simulations, PREFIX)
    family.to_batch(simulations, PREFIX, [40, 8], worlds=[3, 9])
    for name, values in family.fields(model, PREFIX, rows).items():
        if name in batch.MODEL_FIELDS:
            expect(np.array_equal(simulations.expand(name), values), f"{name} is another one")
    return f"off by {off:.1e}"


HOLDER = """
mjforge: 1
name: rack
params: {h: 3cm .. 9cm}
joints: none
parts: [{name: foot, type: box, size: [10cm, 3cm, 2cm]}]
bodies:
  - {name: holder, pos: [0, 0, 0.2 + h]}
  - {name: plate, parent: holder, pos: [0, 0, 5cm], parts: [{name: plate, type: box, size: [5cm, 5cm, 1cm]}]}
"""


def check_static_geoms():
    """Fixed objects without --mocap are refused, because Warp computes poses of static geoms once."""
    settings = {"drawers": 3, "handle": "bar"}
    for spec, given in (("drawer_cabinet", settings), (HOLDER, {})):
        with tempfile.TemporaryDirectory() as place:
            file = pathlib.Path(place, "fixed.npz")
            expect(mjforge.Spec(spec).variants(seed=7, set=given).write(file, 4).ok, "not written")
            family = mjforge.load_family(file)
            model = on_floor(family.base)
            raises(ValueError, "make the family with --mocap", family.to_warp, mujoco_warp.put_model(model), model, PREFIX)


def check_shared_fields(file):
    """Sizes of sites differ, and a sensor measures with them, but Warp's worlds share them."""
    family = mjforge.load_family(file)
    scene = mujoco.MjSpec.from_string("<mujoco/>")
    scene.attach(family.base, prefix=PREFIX, frame=scene.worldbody.add_frame())
    name = family.names["site_size"][0]
    scene.add_sensor(name="touch", type=mujoco.mjtSensor.mjSENS_TOUCH, objtype=mujoco.mjtObj.mjOBJ_SITE,
                     objname=PREFIX + name)
    model = scene.compile()
    raises(ValueError, "site_size differs between worlds", family.to_warp, mujoco_warp.put_model(model), model, PREFIX)


def check_example():
    """The example of docs/families.md."""
    said = subprocess.run([sys.executable, EXAMPLE], capture_output=True, text=True, check=True).stdout.splitlines()
    words = r"64 hammers of 0\.0\d+ to 0\.\d+ kg are \d+ to \d+ mm above the floor after a second"
    expect(re.fullmatch(words, said[-2]), f"{said}")
    expect(re.fullmatch(r"after a reset, worlds 3 and 9 have 0\.\d+ and 0\.\d+ kg", said[-1]), f"{said}")
    return said[-2]


def check_arguments(file):
    family, model, *_ = case(file)
    m = mujoco_warp.put_model(model)
    other = mujoco_warp.put_model(mujoco.MjModel.from_xml_string("<mujoco/>"))
    raises(TypeError, "m=MjModel is not a mujoco_warp.Model", family.to_warp, model, model, PREFIX)
    raises(ValueError, "it was not made from this model", family.to_warp, other, model, PREFIX)
    raises(ValueError, "did you mean 'its/'?", family.to_warp, m, model, "it/")
    raises(ValueError, "it has 2 variants for 1 worlds", family.to_warp, m, model, PREFIX, [1, 2], worlds=[1])
    raises(ValueError, "has a world twice", family.to_warp, m, model, PREFIX, [1, 2], worlds=[1, 1])
    simulations = batch.Batch(model, nsim=4)
    raises(TypeError, "is not a mujoco.batch.Batch", family.to_batch, model, PREFIX)
    raises(ValueError, "it has 64 variants for 4 worlds", family.to_batch, simulations, PREFIX)
    raises(ValueError, "9 is not within the 4 simulations", family.to_batch, simulations, PREFIX, [1], worlds=[9])


folder = sys.argv[1]
hammer = pathlib.Path(folder, "family/hammer.npz")
with warp.ScopedDevice("cpu"):
    for npz, _ in families(folder):
        check(f"{BATCH} family {npz.stem}", check_batch, npz)
        check(f"{WARP} family {npz.stem}", check_warp, npz)
    check(f"{WARP} family, derived fields left shared", check_shared_derived_fields, hammer)
    check(f"{WARP} family, a reset", check_reset, hammer)
    check(f"{WARP} family, static geoms", check_static_geoms)
    check(f"{WARP} family, shared fields", check_shared_fields, pathlib.Path(folder, "family/pot.npz"))
    check(f"{WARP} family, the example", check_example)
    check(f"{WARP} family, arguments", check_arguments, hammer)
finish()
