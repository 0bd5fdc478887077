"""NVIDIA's converter makes USD of each variant, with its bodies, its joints, what collides, and the
masses that the file says.

    check_usd.py FOLDER
"""

import importlib.metadata
import sys
import tempfile
import xml.etree.ElementTree as ET

import mujoco_usd_converter
from pxr import Usd, UsdPhysics

from generated import specs
from report import check, expect, finish, still_refused

VERSION = importlib.metadata.version("mujoco-usd-converter")


def stage_of(variant):
    converter = mujoco_usd_converter.Converter(layer_structure=False, scene=False)
    return Usd.Stage.Open(converter.convert(str(variant.file), tempfile.mkdtemp()).path)


def joint_prims(body):
    """Names of the body's joints in USD, where a joint cannot have the name of a geom or site of the body."""
    others = {each.get("name") for kind in ("geom", "site") for each in body.findall(kind)}
    names = [joint.get("name") for joint in body.findall("joint") if joint.get("type") != "free"]
    return {f"{name}_1" if name in others else name for name in names}


def check_variant(variant):
    root = ET.parse(variant.file).getroot()
    stage = stage_of(variant)  # what it holds lives as long as it
    prims = list(stage.TraverseAll())
    bodies = {prim.GetName(): prim for prim in prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
    meant = [body for body in root.iter("body")]
    expect(set(bodies) == {body.get("name") for body in meant}, f"{variant}: bodies {set(bodies)}")
    joints = {prim.GetName() for prim in prims if prim.IsA(UsdPhysics.Joint)}
    moving = set().union(*map(joint_prims, meant))
    expect(moving <= joints, f"{variant}: joints {joints}, not {moving}")
    colliding = sum(prim.HasAPI(UsdPhysics.CollisionAPI) for prim in prims)
    geoms = sum(geom.get("contype") != "0" for geom in root.iter("geom"))
    expect(colliding == geoms, f"{variant}: {colliding} colliders, not {geoms}")
    for body in meant:
        inertial = body.find("inertial")
        if inertial is None:
            continue
        mass = UsdPhysics.MassAPI(bodies[body.get("name")]).GetMassAttr().Get()
        expect(abs(mass - float(inertial.get("mass"))) <= 1e-6 * mass,
               f"{variant}: {body.get('name')} weighs {mass} kg, not {inertial.get('mass')}")


def check_spec(variants):
    check_variant(variants[0])


def has_ellipsoids(variant):
    geoms = ET.parse(variant.file).getroot().iter("geom")
    return any(geom.get("type") == "ellipsoid" and geom.get("contype") != "0" for geom in geoms)


for name, variants in specs(sys.argv[1], "files"):
    words = f"mujoco-usd-converter {VERSION} {name} with files"
    if has_ellipsoids(variants[0]):
        still_refused(words, "it leaves ellipsoids out", check_spec, variants)
    else:
        check(words, check_spec, variants)
for name, variants in specs(sys.argv[1], "mujoco"):
    if name == "containers/mug":
        still_refused(f"mujoco-usd-converter {VERSION} {name} with inline meshes",
                      "an inline mesh has no file", check_spec, variants)
finish()
