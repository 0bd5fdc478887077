"""64 worlds of MuJoCo Warp, each with a hammer of its own. They fall, and two worlds then get other hammers."""

import pathlib
import tempfile

import mjforge
import mujoco
import mujoco_warp

WORLDS = 64

with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder, "hammers.npz")
    mjforge.Spec("robosuite/hammer").variants(seed=7, set={"handle_shape": "box"}).write(file, WORLDS)
    hammers = mjforge.load_family(file)

scene = mujoco.MjSpec.from_string("<mujoco><worldbody><geom type='plane' size='1 1 1'/></worldbody></mujoco>")
scene.attach(hammers.base, prefix="hammer/", frame=scene.worldbody.add_frame(pos=[0, 0, 0.3]))
model = scene.compile()


def place(data, rows, worlds):
    """Sets some worlds to the start of their hammers."""
    for name, values in hammers.start(model, "hammer/", rows).items():
        array = getattr(data, name)
        numbers = array.numpy()
        numbers[worlds] = values
        array.assign(numbers)


m = mujoco_warp.put_model(model)
d = mujoco_warp.make_data(model, nworld=WORLDS, nconmax=100, njmax=400)
everywhere = list(range(WORLDS))
hammers.to_warp(m, model, "hammer/", everywhere)
place(d, everywhere, everywhere)
for _ in range(500):
    mujoco_warp.step(m, d)
masses, heights = hammers.arrays["mass"], 1000 * d.qpos.numpy()[:, 2]
print(f"{WORLDS} hammers of {masses.min():.3f} to {masses.max():.3f} kg are {heights.min():.0f} to "
      f"{heights.max():.0f} mm above the floor after a second")

# Two worlds get other hammers, at their start. Arrays remain where they are in memory.
hammers.to_warp(m, model, "hammer/", [40, 8], worlds=[3, 9])
place(d, [40, 8], [3, 9])
weights = m.body_subtreemass.numpy()[[3, 9], 1]
print(f"after a reset, worlds 3 and 9 have {weights[0]:.3f} and {weights[1]:.3f} kg")
