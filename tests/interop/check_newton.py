"""Newton's builder takes each variant, with its bodies, its joints and its mass.

    check_newton.py FOLDER
"""

import importlib.metadata
import sys

import warp

warp.config.quiet = True
import newton

from generated import specs
from report import check, expect, finish

VERSION = importlib.metadata.version("newton")


def check_variant(variant):
    builder = newton.ModelBuilder()
    builder.add_mjcf(str(variant.file))
    expect(builder.body_count == variant.record["nbody"] - 1,
           f"{variant}: {builder.body_count} bodies, not {variant.record['nbody'] - 1}")
    expect(builder.shape_count >= variant.record["ngeom"],  # sites are shapes, too
           f"{variant}: {builder.shape_count} shapes of {variant.record['ngeom']} geoms")
    builder.finalize(device="cpu")
    variant.expect_mass(float(sum(builder.body_mass)), relative=1e-5)


def check_spec(variants):
    check_variant(variants[0])


for target in ("files", "mujoco"):
    for name, variants in specs(sys.argv[1], target):
        check(f"newton {VERSION} {name} ({target})", check_spec, variants)
finish()
