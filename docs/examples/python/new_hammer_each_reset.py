"""robosuite's Lift, with a new hammer at each reset in place of the cube, or another object.

    python -m pip install mjforge robosuite==1.5.2 mujoco==3.3.7
    python new_hammer_each_reset.py [SPEC]

robosuite 1.5.2 refuses MuJoCo from 3.10 on, which pip would take.
"""

import sys

import mjforge
import numpy as np
import robosuite
from robosuite.environments.manipulation.lift import Lift
from robosuite.environments.manipulation.manipulation_env import ManipulationEnv
from robosuite.models.arenas import TableArena
from robosuite.models.objects import MujocoXMLObject
from robosuite.models.tasks import ManipulationTask
from robosuite.utils.placement_samplers import UniformRandomSampler


class FreeObject(MujocoXMLObject):
    """An object whose free joint is its first joint, which environments of robosuite set.

    robosuite itself adds the free joint to the file's joints, as the last of them.
    """

    def _get_object_subtree(self):
        tree = super()._get_object_subtree()
        free = tree.find("./joint[@type='free']")
        tree.remove(free)
        tree.insert(0, free)
        return tree


def as_object(variant):
    """robosuite reads objects from files."""
    with variant.as_file() as path:
        return FreeObject(str(path), name=variant.name)


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


spec = mjforge.Spec(sys.argv[1] if len(sys.argv) > 1 else "hammer")
hammers = spec.variants(seed=7, target="robosuite")
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
    print(f"{spec.name} {environment.hammer.index}: {mass:.3f} kg of {environment.hammer.mass:.3f}, "
          f"{1000 * height:.0f} mm above the table")
