#!/usr/bin/env python3
"""Draws docs/worlds.png for docs/families.md: 64 hammers in 64 worlds of MuJoCo Warp, side by side, while they fall.

    PYTHONPATH=build/release/python docs/pictures/worlds.py MJFORGE

needs Python with mujoco-warp. The worlds are simulated together; only the picture has all of them in one scene.
"""

import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

import mjforge
import mujoco
import mujoco_warp
import numpy as np

SIDE = 8  # worlds in a row
SPACING = 0.42  # m, from one world to the next
STEPS = 140
TILE = '<geom type="box" size="0.2 0.2 0.004" pos="{x} {y} -0.004" rgba="{shade} {shade} {shade} 1"/>'
CAMERA = ("--azimuth", "90", "--elevation", "-50", "--distance", "6.5", "--size", "960x640")


def simulate(hammers):
    """Poses of all hammers after they have fallen for a while, [worlds, 7]."""
    scene = mujoco.MjSpec.from_string("<mujoco><worldbody><geom type='plane' size='1 1 1'/></worldbody></mujoco>")
    scene.attach(hammers.base, prefix="hammer/", frame=scene.worldbody.add_frame(pos=[0, 0, 0.45]))
    model = scene.compile()
    m = mujoco_warp.put_model(model)
    d = mujoco_warp.make_data(model, nworld=len(hammers), nconmax=100, njmax=400)
    hammers.to_warp(m, model, "hammer/")
    start = hammers.start(model, "hammer/")
    random = np.random.default_rng(7)
    start["qpos"][:, 3:7] = random.normal(size=(len(hammers), 4))
    start["qpos"][:, 3:7] /= np.linalg.norm(start["qpos"][:, 3:7], axis=1, keepdims=True)
    start["qvel"][:, 3:6] = random.normal(size=(len(hammers), 3)) * 3
    for name, values in start.items():
        getattr(d, name).assign(values)
    for _ in range(STEPS):
        mujoco_warp.step(m, d)
    return d.qpos.numpy()


def scene_of(variants, poses):
    """MJCF with all hammers, each on a tile."""
    root = ET.fromstring("<mujoco model='worlds'><compiler angle='radian'/><size nconmax='2000' njmax='8000'/>"
                         "<asset/><worldbody/></mujoco>")
    for world, (variant, pose) in enumerate(zip(variants, poses)):
        own = ET.fromstring(variant.xml.replace(f'"{variant.name}', f'"world_{world}_{variant.name}'))
        x, y = SPACING * (world % SIDE - (SIDE - 1) / 2), SPACING * (world // SIDE - (SIDE - 1) / 2)
        body = own.find("worldbody/body")
        body.set("pos", f"{pose[0] + x} {pose[1] + y} {pose[2]}")
        body.set("quat", " ".join(map(str, pose[3:7])))
        root.find("asset").extend(own.find("asset"))
        root.find("worldbody").append(body)
        shade = 0.75 + 0.1 * ((world + world // SIDE) % 2)
        root.find("worldbody").append(ET.fromstring(TILE.format(x=x, y=y, shade=shade)))
    return ET.tostring(root, encoding="unicode")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    variants = mjforge.Spec("robosuite/hammer").variants(seed=7, set={"handle_shape": "box"})
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "hammers.npz")
        variants.write(file, SIDE * SIDE)
        poses = simulate(mjforge.load_family(file))
        scene = pathlib.Path(folder, "worlds.xml")
        scene.write_text(scene_of(variants, poses), encoding="utf-8")
        picture = pathlib.Path(__file__).resolve().parents[1] / "worlds.png"
        subprocess.run([sys.argv[1], "preview", str(scene), "-o", str(picture), "--force", "-q", *CAMERA], check=True)
    print(f"{picture.name}: {picture.stat().st_size // 1000} kB")


main()
