"""Each variant is what robocasa's MJCFObject needs, which cannot be installed
from a package index. What it asks of a file and changes in it is done here over
robosuite's own class, of which it is one.

    check_robocasa.py FOLDER
"""

import logging
import os
import sys
import xml.etree.ElementTree as ET

logging.disable(logging.WARNING)

import mujoco
import numpy as np
from robosuite.models.arenas import TableArena
from robosuite.models.objects import MujocoXMLObject
from robosuite.models.tasks import ManipulationTask

from generated import specs
from report import check, expect, finish

# What it sets on every geom.
OVERWRITTEN = {"solref": "0.001 1", "solimp": "0.998 0.998 0.001", "density": "100",
               "friction": "0.95 0.3 0.1"}
# How many numbers its scaling understands, by the geom's type.
SIZES = {"box": (3,), "sphere": (3,), "ellipsoid": (3,), "cylinder": (2,), "capsule": (2,)}


def numbers(element, attribute):
    text = element.get(attribute)
    expect(text is not None, f"geom {element.get('name')!r} has no {attribute}")
    return np.array([float(word) for word in text.split(" ")])


def check_file(variant):
    root = ET.parse(variant.file).getroot()
    expect(root.find("asset") is not None, f"{variant}: no asset element")
    for asset in root.find("asset").findall("./*[@file]"):
        expect(os.path.exists(variant.file.parent / asset.get("file")),
               f"{variant}: {asset.get('file')} is not there")
    expect(root.find("./worldbody/body/body[@name='object']") is not None,
           f"{variant}: no body 'object' in a body")
    for geom in root.iter("geom"):
        size = geom.get("size")
        if geom.get("type") == "mesh":
            expect(size is None, f"{variant}: mesh geom {geom.get('name')!r} has a size")
            continue
        expect(len(size.split(" ")) in SIZES[geom.get("type")],
               f"{variant}: geom {geom.get('name')!r} has size {size!r}")


def regions_of(thing):
    """Geoms named reg_*, which it makes invisible, by the rest of the name."""
    regions = {}
    for geom in thing.worldbody.iter("geom"):
        name = geom.get("name").split(thing.naming_prefix)[1]
        if not name.startswith("reg_"):
            continue
        rgba = numbers(geom, "rgba")
        expect(len(rgba) == 4, f"region {name!r} has no alpha")
        regions[name[len("reg_"):]] = (numbers(geom, "pos"), numbers(geom, "size"))
    return regions


def check_region(variant, thing):
    regions = regions_of(thing)
    # Each region of the spec has a site of group 5 in its area, and robocasa's is the space above.
    sites = [site.get("name").split(thing.naming_prefix)[1]
             for site in thing.worldbody.iter("site") if site.get("group") == "5"]
    wanted = {"bbox"} | {"int" if site == "inside" else site for site in sites}
    expect(set(regions) == wanted, f"{variant}: regions are {list(regions)}, not {wanted}")
    pos, half_size = regions["bbox"]
    box = variant.record["aabb"]
    expect(len(half_size) == 3, f"{variant}: reg_bbox has {len(half_size)} sizes")
    expect(np.allclose(pos - half_size, box["min"], atol=1e-9) and
           np.allclose(pos + half_size, box["max"], atol=1e-9),
           f"{variant}: reg_bbox is {pos} +- {half_size}, not {box}")


def check_mass(variant, thing):
    arena = TableArena()
    model = ManipulationTask(mujoco_arena=arena, mujoco_robots=[],
                             mujoco_objects=[thing]).get_model()
    body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, thing.root_body)
    variant.expect_mass(model.body_subtreemass[body])
    data = mujoco.MjData(model)
    data.qpos[model.joint(thing.joints[-1]).qposadr[0] + 2] = 2
    while data.time < 0.2:
        mujoco.mj_step(model, data)
    expect(np.isfinite(data.qpos).all(), f"{variant}: a position is not finite")


def check_spec(variants):
    for variant in variants:
        check_file(variant)
        thing = MujocoXMLObject(str(variant.file), name=variant.record["name"], obj_type="all",
                                joints=[{"type": "free", "damping": "0.0005"}],
                                duplicate_collision_geoms=False)
        for geom in thing.get_obj().iter("geom"):
            for attribute, value in OVERWRITTEN.items():
                geom.set(attribute, value)
        check_region(variant, thing)
        check_mass(variant, thing)
    return f"{len(variants)} variants"


for name, variants in specs(sys.argv[1], "robocasa"):
    check(f"robocasa {name}", check_spec, variants)
finish()
