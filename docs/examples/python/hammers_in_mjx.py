"""64 worlds of MJX with hammers of different geometry, which a random policy pushes. At each reset, each world gets
another hammer.
"""

import pathlib
import tempfile

import jax
import jax.numpy as jnp
import mjforge
import mujoco
from mujoco import mjx

WORLDS = 64
STEPS = 150

with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder, "hammers.npz")
    mjforge.Spec("robosuite/hammer").variants(seed=7, set={"handle_shape": "box"}, target="mjx").write(file, 256)
    hammers = mjforge.load_family(file)

scene = mujoco.MjSpec.from_string("<mujoco><worldbody><geom type='plane' size='1 1 1'/></worldbody></mujoco>")
scene.attach(hammers.base, prefix="hammer/", frame=scene.worldbody.add_frame(pos=[0, 0, 0.1]))
model = scene.compile()

numbers, axes = hammers.to_mjx(model, "hammer/")  # of all 256 hammers
start = {name: jnp.asarray(each) for name, each in hammers.start(model, "hammer/").items() if each.size}
base = mjx.put_model(model)
data = mjx.make_data(model)


def randomize(mjx_model, rows):
    """The model whose worlds have these hammers. Trainers of Brax take it and `axes` from a `randomization_fn`."""
    return mjx_model.tree_replace(jax.tree_util.tree_map(lambda each: each[rows], numbers))


@jax.jit
def episode(key):
    """Hammers of the worlds, and how far each was pushed."""
    key, draw = jax.random.split(key)
    rows = jax.random.randint(draw, (WORLDS,), 0, len(hammers))
    worlds = randomize(base, rows)
    first = jax.vmap(lambda own: data.replace(**own))({name: each[rows] for name, each in start.items()})

    def step(state, key):
        push = jax.random.uniform(key, (WORLDS, 2), minval=-1, maxval=5)  # N, the action
        force = jnp.zeros((WORLDS, model.nv)).at[:, :2].set(push)
        state = jax.vmap(mjx.step, in_axes=(axes, 0))(worlds, state.replace(qfrc_applied=force))
        return state, None

    last, _ = jax.lax.scan(step, first, jax.random.split(key, STEPS))
    return rows, jnp.linalg.norm(last.qpos[:, :2] - first.qpos[:, :2], axis=1)


for seed in range(2):
    rows, distance = episode(jax.random.PRNGKey(seed))
    masses = hammers.table(frame=False)["mass"][rows]
    print(f"{WORLDS} worlds with {len(set(rows.tolist()))} different hammers of {masses.min():.3f} to "
          f"{masses.max():.3f} kg: pushed by {distance.min():.2f} to {distance.max():.2f} m")
