"""robosuite puts the objects of a scene, each a file of its own, where placement.json says, beside a
Panda that holds still; after a second and a half they are still there.

    check_scene.py FOLDER
"""

import json
import logging
import pathlib
import sys

logging.disable(logging.WARNING)

import mujoco
import numpy as np
import robosuite
from robosuite.environments.manipulation.manipulation_env import ManipulationEnv
from robosuite.models.arenas import EmptyArena
from robosuite.models.tasks import ManipulationTask

from report import check, expect, finish

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/hosts.md"
STEPS = 30  # of 50 ms
MOVED = 0.002  # m
TURNED = np.radians(2)
JOINT = np.radians(5)  # the hinge leans on its limit, which is soft


# The example of the page, which defines read_scene().
exec(PAGE.read_text(encoding="utf-8").split("```python\n")[1].split("```")[0])


class Scene(ManipulationEnv):
    def __init__(self, things, **options):
        self.things = things
        super().__init__(**options)

    def _load_model(self):
        super()._load_model()
        self.robots[0].robot_model.set_base_xpos([-1.1, 0, 0])
        arena = EmptyArena()
        arena.set_origin([0, 0, 0])
        self.model = ManipulationTask(mujoco_arena=arena,
                                      mujoco_robots=[robot.robot_model for robot in self.robots],
                                      mujoco_objects=list(self.things.values()))

    def reward(self, action=None):
        return 0


def angle(one, other):
    return 2 * np.arccos(min(1, abs(np.dot(one, other))))


def expect_poses(when, environment, placed, things):
    data, model = environment.sim.data._data, environment.sim.model._model
    for name, wanted in placed.items():
        body = model.body(things[name].root_body).id
        moved = np.linalg.norm(data.xpos[body] - wanted["pos"])
        turned = angle(data.xquat[body], np.array(wanted["quat"]))
        expect(moved < MOVED and turned < TURNED,
               f"{when} '{name}' is {moved:.4f} m and {turned:.3f} rad from its place")
        for joint, position in wanted.get("joints", {}).items():
            now = data.qpos[model.joint(f"{things[name].naming_prefix}{joint}").qposadr[0]]
            expect(abs(now - position) < JOINT,
                   f"{when} joint '{joint}' of '{name}' is at {now}, not {position}")


def check_scene(folder):
    placed = json.loads((folder / "placement.json").read_text(encoding="utf-8"))["objects"]
    things = read_scene(folder)
    environment = Scene(things, robots="Panda", has_renderer=False, has_offscreen_renderer=False,
                        use_camera_obs=False, control_freq=20, seed=1)
    environment.reset()
    expect_poses("at first", environment, placed, things)
    for _ in range(STEPS):
        environment.step(np.zeros(environment.action_dim))
    expect_poses("later", environment, placed, things)
    environment.close()
    return f"{len(things)} objects"


for target in ("robosuite", "robocasa"):
    for placement in sorted(pathlib.Path(sys.argv[1], "each", target).glob("*/placement.json")):
        check(f"robosuite {robosuite.__version__}, MuJoCo {mujoco.__version__}, {placement.parent.name} "
              f"for {target} with a Panda", check_scene, placement.parent)
finish()
