"""Options of Variants.write that do not fit together, in the words of Python."""

from __future__ import annotations

import os
import re
from typing import Any, Mapping

_SHARD = re.compile(r"([0-9]{1,5})/([0-9]{1,5})")  # the command takes at most 99999 shards
_SERIES = re.compile(r".*%[0-9]*d.*\.tar(\.zst)?")


def check(options: Mapping[str, Any], span: range) -> None:
    """Raises ValueError for an option that does not fit the output or another option. `options`: the
    checked options of Variants.write. `span`: the indices of the variants.
    """
    output = options["output"]
    if output in ("", "-"):
        raise ValueError(f"output={output!r} is not a file, an archive or a folder")
    if span.stop >= 2**64:
        raise ValueError(f"first={span.start} and count={len(span)} go beyond the largest index, 2^64 - 2")
    if options["shard"] is not None:
        _check_shard(options["shard"])
    if options["verify"] and not options["resume"]:
        raise ValueError("verify=True is for resume=True; Batch(...).verify() compares the files of a batch")
    if not output.endswith(".npz"):
        for name in ("mocap", "pad"):
            if options[name]:
                raise ValueError(f"{name}=True is for families, such as output='NAME.npz', not for output={output!r}")
    if options["per_archive"] is not None and not _SERIES.fullmatch(os.path.basename(output)):
        raise ValueError(f"per_archive={options['per_archive']} is for a series of archives, such as "
                         f"output='NAME_%05d.tar', not for output={output!r}")


def _check_shard(shard: str) -> None:
    numbers = _SHARD.fullmatch(shard)
    index, count = map(int, numbers.groups()) if numbers else (0, 0)
    if count == 0:
        raise ValueError(f"shard={shard!r} is not of the form 'I/N', such as '0/4', N up to 99999")
    if index >= count:
        raise ValueError(f"shard={shard!r}: shards count from 0, so that the last one is '{count - 1}/{count}'")
