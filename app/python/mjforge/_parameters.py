"""Parameters of a spec and the catalogue of specs."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Mapping, Optional, Union

from ._json import loads
from ._library import CATALOGUE, bytes_of, library

Number = Union[float, "tuple[float, ...]"]


@dataclasses.dataclass(frozen=True)
class Parameter:
    """A parameter of a spec, with the values that it can have in a variant's `params`."""

    name: str
    unit: str  # "m", or "" if the spec declares no unit
    section: str  # heading of the parameter in `mjforge customize`, or ""
    doc: str
    default: str  # the value as written in the spec: "20cm .. 30cm"
    type: str  # "number", "text" or "boolean"
    components: int  # 1, the size of a vector, or 0 for a list of any length
    distribution: Optional[str]  # "uniform", "choice", ...; None if the value is no single draw
    distributions: tuple[Optional[str], ...]  # `distribution` of each component of a vector; else empty
    low: Optional[Number]  # bounds, each a tuple for a vector; None if `range` is None
    high: Optional[Number]
    choices: Optional[tuple[Any, ...]]  # options of "choice" and "cycle"

    @property
    def range(self) -> Optional[tuple[Number, Number]]:
        """The bounds, which are infinite for some distributions; None if the value depends on other
        parameters, is a list of any length, a choice of vectors, a text or a boolean.
        """
        return None if self.low is None or self.high is None else (self.low, self.high)


def _frozen(value: Any) -> Any:
    return tuple(_frozen(item) for item in value) if isinstance(value, list) else value


def parameter_of(members: dict[str, Any]) -> Parameter:
    """Makes a parameter from its object in the JSON of MjforgeDescription."""
    members["default"] = members.pop("spec")
    return Parameter(**{name: _frozen(value) for name, value in members.items()})


def with_settings(settings: Mapping[str, Any]) -> str:
    """Returns settings as the end of a name: " (handle_length=25cm)"; empty if there are none."""
    words = ", ".join(f"{name}={value}" for name, value in settings.items())
    return f" ({words})" if words else ""


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
        """Name of the spec, as text."""
        return str(self)

    @property
    def description(self) -> str:
        """Description in the spec. Reads the spec at the first access. Raises SpecError if the spec
        has errors.
        """
        if self._description is None:
            from ._spec import Spec

            self._description = Spec(self.path).description
        return self._description

    def __reduce__(self) -> Any:
        return CatalogueEntry, (str(self), self.path)


def catalogue() -> list[CatalogueEntry]:
    """Returns the names of the specs in the folders of MJFORGE_PATH, and of the bundled specs.

    >>> import mjforge
    >>> "tools/hammer" in mjforge.catalogue()
    True
    >>> {entry.name: entry.description for entry in mjforge.catalogue()}["primitives/ball"]
    'A ball of random radius.'
    """
    entries = loads(bytes_of(library.MjforgeCatalogue(os.fsencode(CATALOGUE))))
    return [CatalogueEntry(*entry) for entry in entries]
