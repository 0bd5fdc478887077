"""Drake's parser of MJCF makes a plant of each variant, with its bodies, its joints, its collision
geometries and its mass.

    check_drake.py FOLDER
"""

import importlib.metadata
import logging
import sys
import xml.etree.ElementTree as ET

from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
from pydrake.systems.framework import DiagramBuilder

from generated import specs
from report import check, expect, finish, still_refused

logging.getLogger("drake").setLevel(logging.ERROR)  # elements that it says it leaves out
VERSION = importlib.metadata.version("drake")


def check_variant(variant):
    root = ET.parse(variant.file).getroot()
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, 0.001)
    Parser(plant).AddModels(str(variant.file))
    plant.Finalize()
    context = plant.GetMyContextFromRoot(builder.Build().CreateDefaultContext())
    for body in root.iter("body"):
        plant.GetBodyByName(body.get("name"))  # raises
    for joint in root.iter("joint"):
        if joint.get("type") not in (None, "free") and joint.get("name"):
            plant.GetJointByName(joint.get("name"))
    count = sum(len(plant.GetCollisionGeometriesForBody(plant.GetBodyByName(body.get("name"))))
                for body in root.iter("body"))
    meant = sum(geom.get("contype") != "0" for geom in root.iter("geom"))
    expect(count == meant, f"{variant}: {count} collision geometries, not {meant}")
    variant.expect_mass(plant.CalcTotalMass(context))


def check_spec(variants):
    check_variant(variants[0])


for name, variants in specs(sys.argv[1], "files"):
    check(f"drake {VERSION} {name} with files", check_spec, variants)
for name, variants in specs(sys.argv[1], "mujoco"):
    if name == "containers/mug":
        still_refused(f"drake {VERSION} {name} with inline meshes",
                      "it leaves inline meshes out", check_spec, variants)
finish()
