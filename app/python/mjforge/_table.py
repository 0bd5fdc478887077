"""Tables of records, with one column for each number or text in the requested members."""

from __future__ import annotations

import ctypes
import dataclasses
import importlib
import itertools
from typing import Any, Iterable, Iterator, Sequence

from ._json import loads
from ._library import bytes_of, c_texts, library

# Members of a record that have another name in Variant.
_RECORDED = {"bounds": "aabb", "swept_bounds": "swept_aabb"}
_AXES: dict[str, list[str]] = {"com": ["x", "y", "z"], "inertia": ["xx", "yy", "zz", "xy", "xz", "yz"]}
_KNOWN = ("index", "params", "mass", "com", "inertia", "bounds", "swept_bounds", "physics")
# All members of records. A member that no record has becomes a column of None. A test compares
# these names with the schema.
_MEMBERS = frozenset("""
    file archive name index seed place_seed attempt spec spec_file spec_sha256 set assets_as sampler batch params
    mass com inertia aabb swept_aabb top_offset bottom_offset horizontal_radius declared_bounds nbody njnt ngeom
    places pile_mujoco left_out target each validate mujoco structure layout layout_first pad mocap physics
    on_invalid status findings sha256 assets
""".split())
# Kinds of values, as in app/python/interface.h.
_ABSENT, _WHOLE, _NATURAL, _NUMBER, _FLAG, _TEXT, _LIST, _OBJECT = " ", "i", "u", "f", "b", "t", "l", "o"
CHUNK = 1000  # number of variants that are made together


@dataclasses.dataclass
class _Column:
    key: str
    kinds: frozenset[str]  # kinds of the values that are present
    inner: list["_Column"]
    bits: Any = None  # value of each row, as an integer of 64 bits
    kind: Any = None  # kind of each row, as the number of its character


class Table:
    """Columns that the library fills from records, and their conversion to arrays."""

    def __init__(self, members: Any, frame: Any) -> None:
        self._handle = None
        self._names = list(dict.fromkeys(["index", *_members_of(members)]))
        self._pandas = _pandas(frame)
        try:
            self._numpy = importlib.import_module("numpy")
        except ImportError as error:
            raise ImportError("this needs NumPy: python -m pip install numpy") from error
        recorded = c_texts((_RECORDED.get(name, name) for name in self._names), "members")
        self._handle = library.MjforgeOpenTable(recorded, len(self._names))
        if not self._handle:
            raise MemoryError

    def __del__(self) -> None:
        if self._handle:
            library.MjforgeCloseTable(self._handle)

    @property
    def handle(self) -> Any:
        """Handle of the table for library.MjforgeMakeRows."""
        return self._handle

    def add(self, record: bytes) -> None:
        """Adds a row for a record."""
        status = library.MjforgeAddRecord(self._handle, record, len(record))
        if status == 1:
            raise ValueError(f"it is not the record of a variant: {record[:80]!r}")
        if status == 2:
            raise MemoryError

    def finish(self, has_rows: bool = True) -> Any:
        """Returns a pandas.DataFrame, or a dict of NumPy arrays; see Variants.table. With
        `has_rows=False`, the columns have no rows.
        """
        said = bytes_of(library.MjforgeLayout(self._handle))
        if not said:
            raise MemoryError
        self._rows, self._texts, layout = loads(said)
        arrays: dict[str, Any] = {}
        if self._rows:
            numbers = itertools.count()
            for name, column in zip(self._names, [self._read(each, numbers) for each in layout]):
                if name not in _KNOWN and name not in _MEMBERS and not column.kinds:
                    raise ValueError(f"members: {name!r} is in no record; there are {', '.join(_KNOWN)} "
                                     "and the others of a manifest")
                self._flatten(name, column, arrays)
        if not has_rows or not self._rows:
            none = {"index": self._numpy.empty(0, dtype="int64")}
            arrays = {name: array[:0] for name, array in (arrays or none).items()}
        return arrays if self._pandas is None else self._pandas.DataFrame(arrays)

    def _read(self, layout: Sequence[Any], numbers: Iterator[int]) -> _Column:
        number, (key, kinds, inner) = next(numbers), layout
        column = _Column(key, frozenset(kinds) - {_ABSENT}, [self._read(each, numbers) for each in inner])
        numpy, at = self._numpy, ctypes.string_at
        column.kind = numpy.frombuffer(at(library.MjforgeKinds(self._handle, number), self._rows), "uint8")
        column.bits = numpy.frombuffer(at(library.MjforgeValues(self._handle, number), 8 * self._rows), "int64")
        return column

    def _flatten(self, name: str, column: _Column, arrays: dict[str, Any]) -> None:
        """Adds the arrays of a member and of its inner members, such as "bounds.min.x"."""
        lengths = set(column.bits[column.kind == ord(_LIST)].tolist())
        if column.kinds == {_LIST} and len(lengths) == 1:
            for letter, item in zip(_letters(name, lengths.pop()), column.inner):
                self._flatten(f"{name}.{letter}", item, arrays)
        elif column.kinds == {_OBJECT}:
            for member in column.inner:
                self._flatten(f"{name}.{member.key}", member, arrays)
        else:
            arrays[name] = self._array(column)

    def _array(self, column: _Column) -> Any:
        """Returns an array of numbers, in which None becomes NaN, of texts, or of objects if a
        column has both.
        """
        numpy, bits = self._numpy, column.bits
        is_whole = bool((column.kind != ord(_ABSENT)).all())
        if is_whole and column.kinds == {_WHOLE}:
            return bits.copy()
        if is_whole and column.kinds == {_FLAG}:
            return bits.astype(bool)
        if is_whole and column.kinds == {_TEXT}:
            used, numbers = numpy.unique(bits, return_inverse=True)
            return numpy.array([self._texts[text] for text in used])[numbers]
        if column.kinds and column.kinds <= {_WHOLE, _NUMBER}:
            numbers = bits.view(float).copy()
            numbers[column.kind == ord(_WHOLE)] = bits[column.kind == ord(_WHOLE)]
            numbers[column.kind == ord(_ABSENT)] = numpy.nan
            return numbers
        values = [self._value(column, row) for row in range(self._rows)]
        if column.kinds and column.kinds <= {_WHOLE, _NATURAL, _NUMBER}:
            is_natural = is_whole and column.kinds <= {_WHOLE, _NATURAL} and min(values) >= 0
            return numpy.array(values, dtype="uint64" if is_natural else float)
        objects = numpy.empty(len(values), dtype=object)
        objects[:] = values
        return objects

    def _value(self, column: _Column, row: int) -> Any:
        """Returns the value of one row, as in the JSON of the record."""
        kind, bits = chr(column.kind[row]), column.bits[row]
        if kind == _LIST:
            return [self._value(item, row) for item in column.inner[:bits]]
        if kind == _OBJECT:
            return {item.key: self._value(item, row) for item in column.inner if item.kind[row] != ord(_ABSENT)}
        if kind == _TEXT:
            return self._texts[bits]
        if kind == _NATURAL:
            return int(bits.view("uint64"))
        if kind == _NUMBER:
            return float(bits.view(float))
        return None if kind == _ABSENT else bool(bits) if kind == _FLAG else int(bits)


def _letters(name: str, count: int) -> list[str]:
    if name in _AXES and count == len(_AXES[name]):
        return _AXES[name]
    if count == 3 and name.partition(".")[0] in ("bounds", "swept_bounds"):
        return ["x", "y", "z"]
    return list(map(str, range(count)))


def _members_of(members: Any) -> list[str]:
    if isinstance(members, (str, bytes)) or not isinstance(members, Iterable):
        raise TypeError(f"members={members!r} is not a list of names")
    names = list(members)
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"members={members!r}: {name!r} is not a text but of type {type(name).__name__}")
    return list(map(str.__str__, names))


def _pandas(frame: Any) -> Any:
    if frame is not None and not isinstance(frame, bool):
        raise TypeError(f"frame={frame!r} is not True, False or None")
    if frame is False:
        return None
    try:
        return importlib.import_module("pandas")
    except ImportError as error:
        if frame:
            raise ImportError("frame=True needs pandas: python -m pip install pandas") from error
        return None
