"""A table of a family's variants, with the columns of a table of their records."""

from __future__ import annotations

from typing import Any, Mapping, Optional

from ._family_file import FamilyFile
from ._table import _pandas


def table_of(file: FamilyFile, parameters: Mapping[str, Any], frame: Optional[bool]) -> Any:
    """See Family.table."""
    pandas = _pandas(frame)
    index = file.members["index"]
    columns = {"index": index if index.max() >= 2**63 else index.astype("int64")}
    for name, values in parameters.items():
        if values.ndim == 1:
            columns[f"params.{name}"] = values
        else:
            columns.update({f"params.{name}.{at}": values[:, at] for at in range(values.shape[1])})
    columns["mass"] = file.members["mass"]
    for side, name in enumerate(("min", "max")):
        columns.update({f"bounds.{name}.{axis}": file.members["bounds"][:, side, at] for at, axis in enumerate("xyz")})
    return columns if pandas is None else pandas.DataFrame(columns)
