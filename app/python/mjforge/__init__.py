"""Randomized MuJoCo objects from declarative specs.

>>> import mjforge
>>> hammers = mjforge.Spec("hammer", set={"handle_length": "20cm .. 30cm"}).variants(seed=7)
>>> hammers[41].mass  # kg
0.526938...
>>> model = hammers[41].load()  # doctest: +SKIP

Quantities are in SI units (m, kg, rad). Variants are made in this process; `Variants.write` and
`check` run the command `mjforge`, which the package contains.
"""

import os
from typing import Any, Mapping, Optional, Union

from . import _options
from ._family import Family, load_family
from ._findings import Finding, MismatchError, SpecError, VariantError
from ._library import version
from ._members import Joint, Site
from ._options import Profile
from ._parameters import CatalogueEntry, Parameter, catalogue
from ._picture import Picture
from ._report import Report
from ._spec import Source, Spec
from ._stored import Batch
from ._variants import Variants
from ._variant import Variant

__version__ = version()


def check(
    spec: "Union[Source, Spec]",
    count: int = 20,
    *,
    set: Optional[Mapping[str, Any]] = None,
    seed: int = 0,
    physics: bool = False,
    profile: "Optional[Profile]" = None,
    jobs: Optional[int] = None,
    time_limit: Optional[float] = None,
) -> Report:
    """Equals `Spec(spec, set=set).check(...)`: makes the first `count` variants and reports those
    that fail. Raises SpecError if the spec has errors.

    >>> import mjforge
    >>> print(mjforge.check("hammer", 3))
    3 of 3 variants ok
    """
    if not isinstance(spec, Spec):
        spec = Spec(spec, set=set)
    elif set is not None:
        raise ValueError(f"set={set!r}: a Spec has its settings already")
    return spec.check(count, seed=seed, physics=physics, profile=profile, jobs=jobs,
                      time_limit=time_limit)


def prove(
    batch: "Union[str, os.PathLike[str], Batch]", *, jobs: Optional[int] = None, progress: bool = True
) -> "list[Finding]":
    """Loads every file of a batch in the installed `mujoco` and compares the model with the
    variant's record, a line of the manifest: numbers of elements, names, mass, center of mass,
    inertia, bounds and start state. Returns the findings: differences, and files that are missing,
    changed or rejected by MuJoCo.

    `batch`: a folder, an archive, a series of archives ("x_%05d.tar"), a manifest or a Batch.
    `jobs`: number of processes (default: one per core). `progress`: shows a progress bar if
    standard error is a terminal. Raises FileNotFoundError if there is no manifest, ImportError if
    MuJoCo is not installed.

    >>> report = mjforge.Spec("mug").variants().write("mugs/", 100)  # doctest: +SKIP
    >>> mjforge.prove("mugs/")  # doctest: +SKIP
    []
    """
    from ._prove import run  # keeps the import of the package short

    path = _options.path(batch.path if isinstance(batch, Batch) else batch, "batch")
    workers = None if jobs is None else _options.jobs(jobs, "jobs")
    return run(path, workers, _options.flag(progress, "progress")).findings


__all__ = [
    "Batch",
    "CatalogueEntry",
    "Family",
    "Finding",
    "Joint",
    "MismatchError",
    "Parameter",
    "Picture",
    "Report",
    "Site",
    "Spec",
    "SpecError",
    "Variant",
    "VariantError",
    "Variants",
    "catalogue",
    "check",
    "load_family",
    "prove",
]
