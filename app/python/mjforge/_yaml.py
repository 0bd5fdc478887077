"""Specs and settings given as Python objects: their YAML text, and the key path of each line."""

from __future__ import annotations

import itertools
import json
import os
import re
from typing import TYPE_CHECKING, Any, Callable, Container, Mapping, Optional

from ._options import text as text_option

if TYPE_CHECKING:
    from ._parameters import Parameter

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
# Texts that YAML takes for a number, a boolean or null, and some others.
_NOT_TEXT = re.compile(r"[-+.0-9][-+.0-9a-fox]*|true|false|null", re.IGNORECASE)


def _plain(value: Any) -> Any:
    """Converts NumPy scalars and arrays, paths and mappings to types of JSON."""
    if hasattr(value, "tolist"):
        plain = value.tolist()
        if type(plain) is not type(value):
            return plain
        if value.dtype.kind == "f":  # tolist() returns a longdouble as it is
            return float(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return dict(value)
    raise TypeError(f"a {type(value).__name__} is not a value of a spec: {value!r}")


def flow_text(value: Any) -> str:
    """Returns a value as JSON on one line, which is also YAML. Raises TypeError, and ValueError for
    infinities and NaN.
    """
    return json.dumps(value, default=_plain, ensure_ascii=False, allow_nan=False)


def _converted(convert: Callable[[Any], Any], value: Any, place: str) -> Any:
    """Returns convert(value). Raises the errors of `convert` with the place of the value."""
    try:
        return convert(value)
    except ValueError as error:
        raise ValueError(f"{place}={value!r} is not a value of a spec: {error}") from None
    except TypeError as error:
        raise TypeError(f"{place}: {error}") from None


def _key(path: str, key: Any) -> str:
    if not isinstance(key, str):
        raise TypeError(f"spec: {path}[{key!r}] has a key of type {type(key).__name__}, not a text")
    if not _NAME.fullmatch(key):
        return f"{path}[{key!r}]"
    name = str.__str__(key)
    return f"{path}.{name}" if path else name


class _Lines:
    """A text under construction, with one value or bracket on each line, and the key path of each
    line.
    """

    def __init__(self) -> None:
        self.texts: list[str] = []
        self.paths: list[str] = []

    def add(self, value: Any, path: str, before: str = "", after: str = "") -> None:
        if not isinstance(value, (str, bytes, Mapping, list, tuple, int, float, type(None))):
            value = _converted(_plain, value, f"spec: {path}")
        if isinstance(value, Mapping) and value:
            self._line(f"{before}{{", path)
            self._items([(_key(path, key), f"{flow_text(key)}: ", item)
                         for key, item in value.items()])
            self._line(f"}}{after}", path)
        elif isinstance(value, (list, tuple)) and value:
            self._line(f"{before}[", path)
            self._items([(f"{path}[{i}]", "", item) for i, item in enumerate(value)])
            self._line(f"]{after}", path)
        else:
            text = _converted(flow_text, value, f"spec: {path}")
            self._line(f"{before}{text}{after}", path)

    def _items(self, items: list[tuple[str, str, Any]]) -> None:
        for i, (path, before, item) in enumerate(items, 1):
            self.add(item, path, before, "," if i < len(items) else "")

    def _line(self, text: str, path: str) -> None:
        self.texts.append(text)
        self.paths.append(path)


def block_text(spec: Mapping[str, Any]) -> tuple[str, tuple[str, ...]]:
    """Returns the text of a mapping, and the key path of each line: `parts[0].type`."""
    lines = _Lines()
    try:
        lines.add(spec, "")
    except RecursionError:
        raise ValueError("spec: the mapping is nested too deep, or contains itself") from None
    return "\n".join(lines.texts) + "\n", tuple(lines.paths)


def checked_settings(settings: Any) -> dict[str, Any]:
    """Returns a copy of the settings. Raises an error for names that are not texts and for values
    that a spec cannot have.
    """
    if settings is None:
        return {}
    if not isinstance(settings, Mapping):
        raise TypeError(f"set={settings!r} is not a mapping of names to values")
    checked: dict[str, Any] = {}
    for name, value in settings.items():
        checked[text_option(name, "set")] = value
        if isinstance(value, str):
            text_option(value, f"set[{name!r}]")
        else:
            _converted(flow_text, value, f"set[{name!r}]")
    return checked


class RecordedText(str):
    """The text of a setting in a record, which is used unchanged."""


def needs_parameter(value: Any) -> bool:
    """Returns True if the text of a setting depends on the parameter that it sets."""
    if isinstance(value, RecordedText):
        return False
    if isinstance(value, str):
        return (_NAME.fullmatch(value) or _NOT_TEXT.fullmatch(value)) is not None
    return isinstance(value, (list, tuple)) or hasattr(value, "tolist")


def setting_text(value: Any, known: "Optional[Parameter]", names: Container[str]) -> str:
    """Returns the value of a setting as YAML. A pair of numbers becomes a range if the parameter is
    one number (a range of whole numbers if the parameter draws whole numbers), or if the pair is a
    component of a vector. A text that is an option of the parameter stays a text, even if it is one
    of `names`, the names of all parameters, or looks like a number. `known`: the parameter as the spec
    declares it, if there is one.
    """
    if isinstance(value, RecordedText):
        return str(value)
    if isinstance(value, str):
        value = str.__str__(value)
        is_choice = known is not None and known.type == "text" and value in (known.choices or ())
        return f"'{value}'" if is_choice and (value in names or _NOT_TEXT.fullmatch(value)) else value
    if hasattr(value, "tolist"):
        value = value.tolist()
    if known is None or known.type != "number" or not isinstance(value, (list, tuple)):
        return flow_text(value)
    if known.components == 1:
        return _range_text(value, known.distribution) or flow_text(value)
    drawn = itertools.chain(known.distributions, itertools.repeat(None))
    items = [_range_text(item, each) or flow_text(item) for item, each in zip(value, drawn)]
    return f"[{', '.join(items)}]"


def _range_text(value: Any, distribution: Optional[str]) -> str:
    """Returns the range of a pair of numbers, "0.2 .. 0.3", or "{integer: [2, 3]}" if `distribution`
    draws whole numbers; empty for other values.
    """
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, (list, tuple)) or len(value) != 2:
        return ""
    ends = [_plain(end) if hasattr(end, "tolist") else end for end in value]
    if not all(isinstance(end, (int, float)) and not isinstance(end, bool) for end in ends):
        return ""
    low, high = map(flow_text, ends)
    is_whole = distribution in ("integer", "poisson")
    return f"{{integer: [{low}, {high}]}}" if is_whole else f"{low} .. {high}"
