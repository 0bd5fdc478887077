"""Any MuJoCo loads each variant whose meshes and textures are files, with the masses that are
meant. From 2.3.3 to 3.1.1 it crashes on inline meshes with texture coordinates.

    check_files.py FOLDER
"""

import sys

import mujoco

from generated import specs
from report import check, expect, finish


def check_spec(variants):
    for variant in variants:
        model = mujoco.MjModel.from_xml_path(str(variant.file))
        expect(model.nbody == variant.record["nbody"] and model.ngeom == variant.record["ngeom"],
               f"{variant}: {model.nbody} bodies, {model.ngeom} geoms")
        variant.expect_mass(model.body_mass.sum())


for name, variants in specs(sys.argv[1], "files"):
    check(f"mujoco {mujoco.__version__} {name} with files", check_spec, variants)
finish()
