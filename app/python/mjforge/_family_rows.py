"""Arguments of a family's methods: prefixes of objects, and the variant of each world."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._options import text

if TYPE_CHECKING:
    from ._family import Family


def placements(family: Family, prefix: Any, rows: Any) -> "list[tuple[str, Any]]":
    """Returns the prefix of each object and the object's variant in each world. Raises TypeError or
    ValueError.
    """
    prefixes = [text(each, "prefix") for each in ([prefix] if isinstance(prefix, str) else _list(prefix))]
    if len(set(prefixes)) != len(prefixes):
        raise ValueError(f"prefix={prefix!r} has a prefix twice")
    variants = rows_of(family, rows, len(prefixes))
    return [(each, variants[:, at]) for at, each in enumerate(prefixes)]


def _list(prefix: Any) -> "list[Any]":
    try:
        prefixes = list(prefix)
    except TypeError:
        raise TypeError(f"prefix={prefix!r} is not a text or a list of texts") from None
    if isinstance(prefix, bytes):
        raise TypeError(f"prefix={prefix!r} is not a text but of type bytes")
    if not prefixes:
        raise ValueError("prefix=[] has no prefix")
    return prefixes


def rows_of(family: Family, rows: Any, objects: int = 1) -> Any:
    """Returns the variant of each object in each world, an array [worlds, objects]."""
    import numpy as np

    if rows is None:
        rows = np.arange(len(family))
    try:
        array = np.asarray(rows)
    except ValueError:
        raise TypeError(f"rows={rows!r} is not an array of whole numbers") from None
    if not array.size:
        raise ValueError("rows=[] has no world")
    if array.dtype.kind not in "iu" or array.ndim not in (1, 2):
        raise TypeError(f"rows={rows!r} is not a list of whole numbers, one for each world")
    if array.ndim == 2 and array.shape[1] != objects:
        raise ValueError(f"rows: its {array.shape[1]} columns are not one for each of {objects} prefixes")
    wrong = array[(array < 0) | (array >= len(family))]
    if len(wrong):
        raise ValueError(f"rows: {wrong.flat[0]} is not within 0 .. {len(family) - 1}, the variants of "
                         f"'{family.path}'")
    array = array.astype(np.int64)
    return np.repeat(array[:, None], objects, axis=1) if array.ndim == 1 else array


def worlds_of(worlds: Any, count: int) -> Any:
    """Returns the worlds to which `rows` apply, an array of whole numbers. `count` is the number of
    rows.
    """
    import numpy as np

    array = np.asarray(worlds)
    if array.dtype.kind not in "iu" or array.ndim != 1:
        raise TypeError(f"worlds={worlds!r} is not a list of whole numbers")
    if len(array) != count:
        raise ValueError(f"rows: it has {count} variants for {len(array)} worlds")
    if len(array) != len(np.unique(array)) or array.min() < 0:
        raise ValueError(f"worlds={worlds!r} has a world twice, or a negative one")
    return array.astype(np.int64)
