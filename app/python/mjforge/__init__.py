"""Randomized MuJoCo objects from declarative specs.

>>> import mjforge
>>> hammers = mjforge.Spec("hammer", set={"handle_length": "20cm .. 30cm"}).variants(seed=7)
>>> hammers[41].mass  # kg
0.1...
>>> model = hammers[41].load()  # doctest: +SKIP

Quantities are in SI units (m, kg, rad). Variants are made in this process; `Variants.write` and
`check` run the command `mjforge`, which the package contains.
"""

from ._command import check
from ._findings import Finding, MismatchError, SpecError, VariantError
from ._library import catalogue, version
from ._spec import Spec, Variants
from ._variant import Variant

__version__ = version()

__all__ = [
    "Finding",
    "MismatchError",
    "Spec",
    "SpecError",
    "Variant",
    "VariantError",
    "Variants",
    "catalogue",
    "check",
]
