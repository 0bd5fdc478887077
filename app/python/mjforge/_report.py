"""Results of writing and checking many variants."""

from __future__ import annotations

import dataclasses
import os
import pathlib
from typing import Optional, Sequence

from ._findings import Finding
from ._json import loads
from ._library import bytes_of, library, lines

_OK = b'"status":"ok"'
_CLEAN = b'"findings":[]'


@dataclasses.dataclass(frozen=True)
class Report:
    """What became of the variants that were written or checked."""

    count: int  # variants that were asked for; of a shard, those of the shard
    made: int
    # By index. If no variant at all could be made, equal findings are only at the first index.
    failed: dict[int, tuple[Finding, ...]]
    skipped: dict[int, tuple[Finding, ...]]  # by index, with on_invalid="skip"
    findings: tuple[Finding, ...]  # errors and warnings of all variants, in index order
    manifest: Optional[pathlib.Path]  # None if there is none: after a check, or for a single file

    @property
    def ok(self) -> bool:
        """Whether no variant failed."""
        return not self.failed

    def __str__(self) -> str:
        counts = f"{self.made} of {self.count} variants ok"
        if self.skipped:
            counts += f", {len(self.skipped)} skipped"
        return "\n".join([counts, *(finding.text for finding in self.findings)])


def manifest_of(output: str, shard: Optional[str]) -> Optional[pathlib.Path]:
    """The manifest that the command writes for this output; None for a single file."""
    index, _, shards = (shard or "0/1").partition("/")
    path = bytes_of(library.MjforgeManifest(os.fsencode(output), int(index), int(shards)))
    return pathlib.Path(os.fsdecode(path)) if path else None


def report_of(manifest: Optional[pathlib.Path], first: int, count: int,
              found: list[Finding], key_paths: Sequence[str]) -> Report:
    """The report of a command that has ended. `found`: its findings, a part of all. `key_paths`: of
    the lines of a spec that was a mapping.
    """
    for finding in found:
        finding.set_keys(key_paths)
    if manifest is None or not os.path.exists(manifest):
        # The command writes no manifest for a single file, nor if it could make no variant.
        has_failed = any(finding.severity == "error" for finding in found)
        failed = {index: tuple(finding for finding in found if finding.index == index)
                  for index in range(first, first + count)} if has_failed else {}
        return Report(count, count - len(failed), failed, {}, tuple(found), None)
    made = total = 0
    by_status: dict[str, dict[int, tuple[Finding, ...]]] = {"failed": {}, "skipped": {}}
    findings: list[Finding] = []
    for line in lines(os.fspath(manifest)):
        total += 1
        if _OK in line and _CLEAN in line:
            made += 1
            continue
        record = loads(line)
        own = tuple(Finding(members).set_keys(key_paths) for members in record["findings"])
        findings += own
        if record["status"] == "ok":
            made += 1
        else:
            by_status[record["status"]][record["index"]] = own
    about_all = [finding for finding in found if finding.index is None]
    return Report(total, made, by_status["failed"], by_status["skipped"],
                  tuple(about_all + findings), manifest)
