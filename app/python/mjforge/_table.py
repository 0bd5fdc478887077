"""Tables of records: a column for each number or text of the members that are asked for."""

from __future__ import annotations

import importlib
import itertools
import json
from typing import Any, Iterable, Optional, Sequence

# Members of a record under the names that a Variant has.
_RECORDED = {"bounds": "aabb", "swept_bounds": "swept_aabb"}
_AXES: dict[str, list[str]] = {"com": ["x", "y", "z"], "inertia": ["xx", "yy", "zz", "xy", "xz", "yz"]}
_KNOWN = ("index", "params", "mass", "com", "inertia", "bounds", "swept_bounds", "physics")
CHUNK = 1000  # records that are read together


def _slices(records: Sequence[bytes], member: str, following: str) -> Optional[list[Any]]:
    """The values of a member, whose text ends where the member `following` begins; None if that is
    not so in a record. Parses only these texts, because parsing records takes longer than making
    small objects.
    """
    key, end_key = b'"%s":' % member.encode(), b',"%s":' % following.encode()
    texts = []
    for record in records:
        start = record.find(key) + len(key)
        end = record.find(end_key, start)
        # An inner object may have the same key.
        if start < len(key) or end < 0 or record.find(key, end) >= 0:
            return None
        texts.append(record[start:end])
    try:
        values: list[Any] = json.loads(b"[" + b",".join(texts) + b"]")
    except ValueError:
        return None
    return values if len(values) == len(records) else None


def _read(records: Sequence[bytes], names: Sequence[str]) -> dict[str, Sequence[Any]]:
    """The columns of members."""
    first = json.loads(records[0])
    following = dict(zip(first, itertools.islice(first, 1, None)))
    whole: Optional[list[Any]] = None
    columns: dict[str, Sequence[Any]] = {}
    for name in names:
        member = _RECORDED.get(name, name)
        values = _slices(records, member, following[member]) if member in following else None
        if values is None:
            whole = [json.loads(record) for record in records] if whole is None else whole
            values = [record.get(member) for record in whole]
        if name not in _KNOWN and not any(value is not None for value in values):
            raise ValueError(f"members: {name!r} is in no record; there are {', '.join(_KNOWN)} "
                             "and the others of a manifest")
        _flatten(name, values, columns)
    return columns


def _flatten(name: str, values: Sequence[Any], columns: dict[str, Sequence[Any]]) -> None:
    """Adds the columns of a member: "bounds.min.x". Rows are turned into columns by zip(), because a
    loop over all numbers would take several times longer.
    """
    kinds = set(map(type, values)) - {type(None)}
    if kinds not in ({dict}, {list}):
        columns[name] = values
        return
    present = [value for value in values if value is not None]
    if kinds == {list}:
        counts = set(map(len, present))
        if len(counts) > 1:
            columns[name] = values
            return
        keys: Any = _letters(name, counts.pop())
        rows = values if len(present) == len(values) else [value or [None] * len(keys) for value in values]
    else:
        keys, rows = _rows_of(values, present)
    for key, column in zip(keys, zip(*rows)):
        _flatten(f"{name}.{key}", column, columns)


def _rows_of(values: Sequence[Any], present: Sequence[dict[str, Any]]) -> tuple[list[str], list[Any]]:
    """The keys of all objects, and the values of each object in the order of the keys."""
    keys = list(dict.fromkeys(itertools.chain.from_iterable(set(map(tuple, present)))))
    if len(present) == len(values) and set(map(tuple, present)) == {tuple(keys)}:
        return keys, [value.values() for value in values]
    return keys, [[(value or {}).get(key) for key in keys] for value in values]


def _letters(name: str, count: int) -> list[str]:
    if name in _AXES and count == len(_AXES[name]):
        return _AXES[name]
    if count == 3 and name.partition(".")[0] in ("bounds", "swept_bounds"):
        return ["x", "y", "z"]
    return list(map(str, range(count)))


def _array(numpy: Any, values: Sequence[Any]) -> Any:
    """An array of numbers, in which None is NaN, of texts, or of objects if a column has both."""
    column = numpy.array(values) if type(values[0]) in (int, float, bool) else None
    if column is not None and column.dtype.kind in "biuf":
        return column
    kinds = set(map(type, values))
    if kinds <= {int, float, type(None)} and kinds != {type(None)}:
        return numpy.array(values, dtype=float)
    if kinds == {str}:
        return numpy.array(values)
    column = numpy.empty(len(values), dtype=object)
    column[:] = values
    return column


def _joined(numpy: Any, chunks: Sequence[dict[str, Sequence[Any]]], sizes: Sequence[int]) -> dict[str, Any]:
    """The columns of all chunks, with None where a chunk does not have a column."""
    arrays = {}
    for name in dict.fromkeys(itertools.chain.from_iterable(chunks)):
        parts = [chunk.get(name) for chunk in chunks]
        made = [None if part is None else _array(numpy, part) for part in parts]
        kinds = {None if part is None else part.dtype.kind for part in made}
        if len(kinds) == 1 or kinds <= {"i", "f"}:
            arrays[name] = numpy.concatenate(made)
        else:
            values = [(None,) * size if part is None else part for part, size in zip(parts, sizes)]
            arrays[name] = _array(numpy, list(itertools.chain.from_iterable(values)))
    return arrays


def _members_of(members: Any) -> list[str]:
    if isinstance(members, (str, bytes)) or not isinstance(members, Iterable):
        raise TypeError(f"members={members!r} is not a list of names")
    names = list(members)
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"members={members!r}: {name!r} is not a text but of type {type(name).__name__}")
    return names


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


def table_of(chunks_of_records: Iterable[Sequence[bytes]], members: Any, frame: Any) -> Any:
    """See Variants.table. The records are JSON as the library writes it."""
    names, pandas = _members_of(members), _pandas(frame)
    try:
        import numpy
    except ImportError as error:
        raise ImportError("this needs NumPy: python -m pip install numpy") from error
    wanted = ["index", *(name for name in names if name != "index")]
    chunks: list[dict[str, Sequence[Any]]] = []
    sizes: list[int] = []
    for chunk in chunks_of_records:
        chunks.append(_read(chunk, wanted))
        sizes.append(len(chunk))
    arrays = _joined(numpy, chunks, sizes)
    return arrays if pandas is None else pandas.DataFrame(arrays)

