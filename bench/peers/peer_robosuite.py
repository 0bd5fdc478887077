"""robosuite: its own classes, each object with new sizes (the hammer draws them
itself)."""

import logging
import xml.etree.ElementTree as ET

logging.disable(logging.WARNING)

import mujoco
from robosuite.models import MujocoWorldBase
from robosuite.models.objects import (HammerObject, HingedBoxObject, HollowCylinderObject,
                                      PotWithHandlesObject, RatchetingWrenchObject)

import objects
from worker import serve

MAKE = {
    "hammer": lambda: HammerObject("hammer"),
    "pot": lambda: PotWithHandlesObject("pot", **objects.draw_pot()),
    "hinged box": lambda: HingedBoxObject("hinged_box", **objects.draw_hinged_box()),
    "wrench": lambda: RatchetingWrenchObject("wrench", **objects.draw_wrench()),
    "ring of 50": lambda: HollowCylinderObject("ring", **objects.draw_ring()),
}


def text(name):
    """The object and its assets, the least that has to be written of it."""
    thing = MAKE[name]()
    return (ET.tostring(thing.asset, encoding="unicode"),
            ET.tostring(thing.get_obj(), encoding="unicode"))


def world(name):
    thing = MAKE[name]()
    world = MujocoWorldBase()
    world.merge_assets(thing)
    world.worldbody.append(thing.get_obj())
    return world


def load_light(name):
    """The cheapest complete model: no base.xml, no textures from PNG files."""
    thing = MAKE[name]()
    for texture in thing.asset.findall("texture"):
        thing.asset.remove(texture)
    for material in thing.asset.findall("material"):
        material.attrib.pop("texture", None)
    asset = ET.tostring(thing.asset, encoding="unicode")
    body = ET.tostring(thing.get_obj(), encoding="unicode")
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler angle="radian" autolimits="true"/>{asset}'
        f"<worldbody>{body}</worldbody></mujoco>")


serve({"text": text,
       "world": lambda name: world(name).get_xml(),
       "load": lambda name: world(name).get_model(mode="mujoco"),
       "load light": load_light},
      compiled=lambda name: world(name).get_model(mode="mujoco"))
