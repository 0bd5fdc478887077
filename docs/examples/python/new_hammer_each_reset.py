"""robosuite's Lift, with a new hammer at each reset in place of the cube.

    python -m pip install mjforge robosuite
    python new_hammer_each_reset.py
"""

import tempfile

import mjforge
import numpy as np
import robosuite
from robosuite.environments.manipulation.lift import Lift
from robosuite.environments.manipulation.manipulation_env import ManipulationEnv
from robosuite.models.arenas import TableArena
from robosuite.models.objects import MujocoXMLObject
from robosuite.models.tasks import ManipulationTask
from robosuite.utils.placement_samplers import UniformRandomSampler


def as_object(variant):
    """robosuite reads objects from files."""
    with tempfile.NamedTemporaryFile(suffix=".xml") as file:
        file.write(variant.xml_bytes)
        file.flush()
        return MujocoXMLObject(file.name, name=variant.record["name"])


class LiftHammer(Lift):
    """Takes `hammers`, variants for the target robosuite."""

    def __init__(self, hammers, **options):
        self.hammers = iter(hammers)
        super().__init__(**options)

    def _load_model(self):  # at each reset
        ManipulationEnv._load_model(self)
        robot = self.robots[0].robot_model
        robot.set_base_xpos(robot.base_xpos_offset["table"](self.table_full_size[0]))
        arena = TableArena(table_full_size=self.table_full_size, table_offset=self.table_offset)
        arena.set_origin([0, 0, 0])
        self.hammer = next(self.hammers)
        self.cube = as_object(self.hammer)  # what Lift lifts
        self.placement_initializer = UniformRandomSampler(
            name="sampler", mujoco_objects=self.cube, x_range=[-0.05, 0.05], y_range=[-0.05, 0.05],
            ensure_object_boundary_in_range=False, reference_pos=self.table_offset, z_offset=0.01,
            rng=self.rng)
        self.model = ManipulationTask(
            mujoco_arena=arena, mujoco_robots=[robot], mujoco_objects=self.cube)


hammers = mjforge.Spec("hammer").variants(seed=7, target="robosuite")
environment = robosuite.make(
    "LiftHammer", robots="Panda", hammers=hammers, has_renderer=False,
    has_offscreen_renderer=False, use_camera_obs=False, seed=0)
for _ in range(3):
    environment.reset()
    for _ in range(20):
        environment.step(np.zeros(environment.action_dim))
    body = environment.sim.model.body_name2id(environment.cube.root_body)
    mass = environment.sim.model.body_subtreemass[body]
    height = environment.sim.data.body_xpos[body][2] - environment.table_offset[2]
    print(f"hammer {environment.hammer.index}: {mass:.3f} kg of {environment.hammer.mass:.3f}, "
          f"{1000 * height:.0f} mm above the table")
