"""Writes the numbers of a family's variants into the simulations of mujoco.batch."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Mapping, Optional

from ._family_rows import worlds_of
from ._to_warp import _differs

if TYPE_CHECKING:
    from ._family import Family


def to_batch(family: Family, batch: Any, prefix: Any, rows: Any, over: Optional[Mapping[str, Any]],
             worlds: Any) -> None:
    """See Family.to_batch."""
    if type(batch).__name__ != "Batch" or not type(batch).__module__.startswith("mujoco"):
        raise TypeError(f"batch={batch!r} is not a mujoco.batch.Batch but of type {type(batch).__name__}")
    known = importlib.import_module(type(batch).__module__).MODEL_FIELDS
    fields = family.fields(batch.model, prefix, rows, over=over)
    count = next(len(values) for values in fields.values())
    at = worlds_of(range(batch.nsim) if worlds is None else worlds, count)
    if at.max() >= batch.nsim:
        raise ValueError(f"worlds: {at.max()} is not within the {batch.nsim} simulations of the batch")
    for field, values in fields.items():
        if field in known:
            batch.expand(field)[at] = values
        elif not field.startswith("stat.") and _differs(values, batch.model, field):
            raise ValueError(f"{field} differs between worlds, and mujoco.batch shares it between them")
