"""Parameters of a spec and the catalogue of specs."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Optional, Union

from ._json import loads
from ._library import CATALOGUE, bytes_of, library

Number = Union[float, "tuple[float, ...]"]


@dataclasses.dataclass(frozen=True)
class Parameter:
    """A parameter of a spec: what a variant's `params` may have under this name."""

    name: str
    unit: str  # "m", or "" if the spec does not say it
    section: str  # heading of its control in `mjforge customize`, or ""
    doc: str
    default: str  # the value as the spec has it: "20cm .. 30cm"
    type: str  # "number", "text" or "boolean"
    components: int  # 1, the size of a vector, or 0 for a list of any length
    distribution: Optional[str]  # "uniform", "choice", ...; None if it is no draw by itself
    distributions: tuple[Optional[str], ...]  # the same of the components of a vector; empty for others
    low: Optional[Number]  # bounds, each a tuple for a vector; None if they differ between variants
    high: Optional[Number]
    choices: Optional[tuple[Any, ...]]  # of "choice" and "cycle"

    @property
    def range(self) -> Optional[tuple[Number, Number]]:
        """The bounds, which are infinite for some distributions; None if the value depends on other
        parameters or is not a number.
        """
        return None if self.low is None or self.high is None else (self.low, self.high)


def _frozen(value: Any) -> Any:
    return tuple(_frozen(item) for item in value) if isinstance(value, list) else value


def parameter_of(members: dict[str, Any]) -> Parameter:
    """The parameter of an object of MjforgeDescription."""
    members["default"] = members.pop("spec")
    return Parameter(**{name: _frozen(value) for name, value in members.items()})


class CatalogueEntry(str):
    """The name of a spec, with the path of its file and its description."""

    path: str
    _description: Optional[str]

    def __new__(cls, name: str, path: str = "") -> "CatalogueEntry":
        entry = super().__new__(cls, name)
        entry.path = path
        entry._description = None
        return entry

    @property
    def name(self) -> str:
        return str(self)

    @property
    def description(self) -> str:
        """What the spec says about itself; it is read for that. Raises SpecError."""
        if self._description is None:
            from ._spec import Spec

            self._description = Spec(self.path).description
        return self._description

    def __reduce__(self) -> Any:
        return CatalogueEntry, (str(self), self.path)


def catalogue() -> list[CatalogueEntry]:
    """The specs in the folders of MJFORGE_PATH, and the bundled ones.

    >>> import mjforge
    >>> "tools/hammer" in mjforge.catalogue()
    True
    >>> {entry.name: entry.description for entry in mjforge.catalogue()}["primitives/ball"]
    'A ball of random radius.'
    """
    entries = loads(bytes_of(library.MjforgeCatalogue(os.fsencode(CATALOGUE))))
    return [CatalogueEntry(*entry) for entry in entries]
