"""An environment of mjlab with hammers of different geometry: each environment gets another one at each reset."""

import pathlib
import tempfile

import mjforge
import torch
from mjlab.entity import EntityCfg
from mjlab.envs import ManagerBasedRlEnv, ManagerBasedRlEnvCfg, mdp
from mjlab.managers import EventTermCfg, ObservationGroupCfg, ObservationTermCfg, RewardTermCfg, TerminationTermCfg
from mjlab.scene import SceneCfg
from mjlab.sim import MujocoCfg, SimulationCfg
from mjlab.terrains import TerrainEntityCfg

ENVIRONMENTS = 16

with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder, "hammers.npz")
    mjforge.Spec("robosuite/hammer").variants(seed=7, set={"handle_shape": "box"}).write(file, 256)
    hammers = mjforge.load_family(file)

hammer, variants = hammers.to_mjlab("hammer", mode="reset")
hammer.init_state = EntityCfg.InitialStateCfg(pos=(0, 0, 0.2))
masses = torch.as_tensor(hammers.table(frame=False)["mass"], dtype=torch.float32)


def mass(env):
    """What a critic may know: the mass of the hammer that each environment has now."""
    return masses[env.event_manager.get_term_cfg("variants").func.rows][:, None]


def position(env):
    return env.scene["hammer"].data.root_link_pos_w - env.scene.env_origins


task = ManagerBasedRlEnvCfg(
    scene=SceneCfg(num_envs=ENVIRONMENTS, terrain=TerrainEntityCfg(terrain_type="plane"), entities={"hammer": hammer}),
    sim=SimulationCfg(nconmax=64, njmax=256, mujoco=MujocoCfg(timestep=0.002)),
    decimation=5,
    episode_length_s=0.4,
    seed=1,
    events={
        "variants": variants,  # before events that depend on the object
        "state": EventTermCfg(func=mdp.reset_scene_to_default, mode="reset"),
        "push": EventTermCfg(func=mdp.push_by_setting_velocity, mode="interval", interval_range_s=(0.1, 0.2),
                             params={"velocity_range": {"x": (-1, 1), "y": (-1, 1)},
                                     "asset_cfg": mdp.SceneEntityCfg("hammer")}),
    },
    observations={"actor": ObservationGroupCfg(terms={"position": ObservationTermCfg(func=position)}),
                  "critic": ObservationGroupCfg(terms={"mass": ObservationTermCfg(func=mass)})},
    rewards={"distance": RewardTermCfg(func=lambda env: position(env)[:, :2].norm(dim=1), weight=1)},
    terminations={"time": TerminationTermCfg(func=mdp.time_out, time_out=True)},
    actions={},
)
environment = ManagerBasedRlEnv(task, device="cpu")
observed, _ = environment.reset()
for episode in range(2):
    rewards = 0
    for _ in range(environment.max_episode_length):
        weights = observed["critic"]
        observed, reward, *_ = environment.step(torch.zeros(ENVIRONMENTS, 0))
        rewards += reward
    print(f"{ENVIRONMENTS} environments with {len(weights.unique())} different hammers of {weights.min():.3f} to "
          f"{weights.max():.3f} kg: rewards of {rewards.min():.2f} to {rewards.max():.2f}")
