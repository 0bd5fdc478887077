"""JSON of the library and the command, and members of records."""

from __future__ import annotations

import json
from typing import Any, Sequence

_decode = json.JSONDecoder().raw_decode

# Members that the record of every made variant has. If such a key occurs once in a record, it is the
# record's own, and not that of an inner object such as `params`.
_ALWAYS = frozenset(("name", "index", "seed", "params", "mass", "com", "inertia", "aabb", "swept_aabb",
                     "top_offset", "bottom_offset", "horizontal_radius", "nbody", "njnt", "ngeom",
                     "target", "status", "sha256"))


def loads(said: bytes) -> Any:
    """Reads JSON. Bytes of paths that are not UTF-8 become the characters that os.fsdecode makes of
    them, so that os.fsencode gives these bytes back.
    """
    return json.loads(said.decode(errors="surrogateescape"))


def members_of_record(record: bytes, members: Sequence[str]) -> list[Any]:
    """The values of members of a record, as the library writes it: without blanks. Raises KeyError
    for a member that it does not have.
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
