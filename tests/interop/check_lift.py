"""robosuite's environment Lift, with a Panda, gets a variant in place of its cube.

    check_lift.py FOLDER
"""

import logging
import sys

logging.disable(logging.WARNING)

import mujoco
import numpy as np
import robosuite
from robosuite.environments.manipulation import lift
from robosuite.models.objects import MujocoXMLObject

from generated import specs
from report import check, expect, finish

# One body each, as the cube: the environment sets its first joint, which is free.
OBJECTS = {"robosuite/hammer", "containers/mug", "kitchen/spoon", "primitives/box"}
TABLE_TOP = 0.8  # m


def check_variant(variant):
    lift.BoxObject = lambda name, **_: MujocoXMLObject(str(variant.file), name=name,
                                                       duplicate_collision_geoms=False)
    environment = robosuite.make("Lift", robots="Panda", has_renderer=False,
                                 has_offscreen_renderer=False, use_camera_obs=False, seed=1)
    environment.reset()
    body = environment.cube_body_id
    variant.expect_mass(environment.sim.model.body_subtreemass[body])
    for _ in range(20):
        observed, *_ = environment.step(np.zeros(environment.action_dim))
    height = observed["cube_pos"][2]
    reach = max(variant.record["horizontal_radius"], variant.record["top_offset"],
                -variant.record["bottom_offset"])
    expect(TABLE_TOP - 0.01 < height < TABLE_TOP + 2 * reach,
           f"{variant}: the robot sees it at a height of {height} m")
    environment.close()


def check_spec(variants):
    for variant in variants[:2]:
        check_variant(variant)


for name, variants in specs(sys.argv[1], "robosuite"):
    if name in OBJECTS:
        check(f"robosuite {robosuite.__version__}, MuJoCo {mujoco.__version__}, Lift with {name}",
              check_spec, variants)
finish()
