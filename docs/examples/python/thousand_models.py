"""A thousand hammers, each a model of its own in your MuJoCo.

    python -m pip install mjforge mujoco numpy
    python thousand_models.py
"""

import mjforge
import mujoco

hammers = mjforge.Spec("hammer", set={"handle_length": "20cm .. 30cm"}).variants(seed=7)
models = [hammer.load(mujoco) for hammer in hammers[:1000]]
masses = [mujoco.mj_getTotalmass(model) for model in models]
print(f"{len(models)} models of {min(masses):.3f} to {max(masses):.3f} kg")
