"""MJX takes each variant in a world with everything it could touch.

    check_mjx.py FOLDER
"""

import importlib.metadata
import logging
import os
import sys
import warnings
import xml.etree.ElementTree as ET

os.environ["JAX_PLATFORMS"] = "cpu"
logging.disable(logging.WARNING)
warnings.simplefilter("error", UserWarning)  # "this may lead to inaccuracies"

import mujoco
from mujoco import mjx
import numpy as np

from generated import specs
from report import check, expect, finish

VERSION = importlib.metadata.version("mujoco-mjx")
WORLD = ('<body><geom type="plane" size="2 2 0.1"/><geom type="box" size="0.1 0.1 0.1" pos="1 0 0"/>'
         '<geom type="mesh" mesh="wedge" pos="0 1 0"/><geom type="capsule" size="0.1 0.1"/></body>')
WEDGE = '<mesh name="wedge" vertex="0 0 0  1 0 0  0 1 0  0 0 1"/>'


def model_of(variant):
    root = ET.parse(variant.file).getroot()
    asset = root.find("asset")
    if asset is None:
        asset = ET.SubElement(root, "asset")
    asset.append(ET.fromstring(WEDGE))
    root.find("worldbody").extend(ET.fromstring(WORLD))
    # Files stand beside the variant's.
    folder = os.getcwd()
    os.chdir(variant.file.parent)
    try:
        return mujoco.MjModel.from_xml_string(ET.tostring(root, encoding="unicode"))
    finally:
        os.chdir(folder)


def check_variant(variant):
    model = model_of(variant)
    variant.expect_mass(model.body_subtreemass[0])
    on_device = mjx.put_model(model)
    expect(np.allclose(on_device.body_mass, model.body_mass, rtol=1e-5),
           f"{variant}: other masses on the device")
    mjx.make_data(on_device)


def check_spec(variants):
    for variant in variants:
        check_variant(variant)
    return f"{len(variants)} variants"


for name, variants in specs(sys.argv[1], "mjx"):
    check(f"mjx {VERSION} {name}", check_spec, variants)
finish()
