"""Randomized MuJoCo objects from declarative specs.

>>> import mjforge
>>> hammers = mjforge.Spec("hammer", set={"handle_length": "20cm .. 30cm"}).variants(seed=7)
>>> hammers[41].mass  # kg
0.1...
>>> model = hammers[41].load()  # doctest: +SKIP

Quantities are in SI units (m, kg, rad). Variants are made in this process; `Variants.write` and
`check` run the command `mjforge`, which the package contains.
"""

import os
from typing import Optional, Union

from ._command import check
from ._findings import Finding, MismatchError, SpecError, VariantError
from ._library import catalogue, version
from ._spec import Spec, Variants
from ._variant import Variant

__version__ = version()


def prove(
    batch: "Union[str, os.PathLike[str]]", *, jobs: Optional[int] = None, progress: bool = True
) -> "list[Finding]":
    """Loads every file of a batch in the `mujoco` that is installed and compares it with its
    record: numbers of elements, names, mass, center of mass, inertia, bounds and start state.
    Returns what is not as recorded.

    `batch`: a folder, an archive, a series of archives ("x_%05d.tar") or a manifest. `jobs`:
    processes (default: one per core). `progress`: a bar, if standard error is a terminal. Raises
    FileNotFoundError without a manifest, ImportError without a MuJoCo.
    """
    from ._prove import run  # keeps the import of the package short

    return run(batch, jobs, progress).findings


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
    "prove",
]
