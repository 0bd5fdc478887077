"""JSON of the library and the command, and members of records."""

from __future__ import annotations

import json
from typing import Any, Sequence

_decode = json.JSONDecoder().raw_decode

# Members of the record of every variant that was made. If such a key occurs only once in a record,
# it belongs to the record itself and not to an inner object such as `params`.
_ALWAYS = frozenset(("name", "index", "seed", "params", "mass", "com", "inertia", "aabb", "swept_aabb",
                     "top_offset", "bottom_offset", "horizontal_radius", "nbody", "njnt", "ngeom",
                     "target", "status", "sha256"))


def loads(said: bytes) -> Any:
    """Parses JSON. Bytes of paths that are not UTF-8 are decoded as by os.fsdecode, so that
    os.fsencode returns the same bytes.
    """
    return json.loads(said.decode(errors="surrogateescape"))


def copied(value: Any) -> Any:
    """Returns a copy of a value of JSON, faster than copy.deepcopy."""
    if isinstance(value, dict):
        return {key: copied(item) for key, item in value.items()}
    return [copied(item) for item in value] if isinstance(value, list) else value


def members_of_record(record: bytes, members: Sequence[str]) -> list[Any]:
    """Returns the values of members of a record, which must be as the library writes it: without
    blanks. Raises KeyError for a member that the record does not have.
    """
    values = []
    for member in members:
        key = b'"%s":' % member.encode()
        start = record.find(key)
        if member not in _ALWAYS or start < 0 or record.find(key, start + 1) >= 0:
            whole = loads(record)
            return [whole[member] for member in members]
        values.append(_decode(record[start + len(key):].decode(errors="surrogateescape"))[0])
    return values
