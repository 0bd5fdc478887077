"""dm_control's PyMJCF reads each variant and writes it again; what it then simulates has the same
bodies, joints, geoms and masses.

    check_dm_control.py FOLDER
"""

import importlib.metadata
import os
import sys

os.environ["MUJOCO_GL"] = "disabled"

from dm_control import mjcf

from generated import specs
from report import check, expect, finish

VERSION = importlib.metadata.version("dm_control")


def check_variant(variant):
    model = mjcf.Physics.from_mjcf_model(mjcf.from_path(str(variant.file))).model
    counts = {"nbody": model.nbody, "njnt": model.njnt, "ngeom": model.ngeom}
    meant = {key: variant.record[key] for key in counts}
    expect(counts == meant, f"{variant}: has {counts}, not {meant}")
    variant.expect_mass(model.body_mass.sum())


def check_spec(variants):
    check_variant(variants[0])


for target in ("mujoco", "files"):
    for name, variants in specs(sys.argv[1], target):
        check(f"dm_control {VERSION} {name} ({target})", check_spec, variants)
finish()
