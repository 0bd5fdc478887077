"""Results of writing and checking many variants."""

from __future__ import annotations

import dataclasses
import os
import pathlib
from typing import TYPE_CHECKING, Optional

from ._findings import Finding, findings_of
from ._json import loads
from ._library import bytes_of, library, lines

if TYPE_CHECKING:
    from ._spec import Spec

_OK = b'"status":"ok"'
_CLEAN = b'"findings":[]'


@dataclasses.dataclass(frozen=True)
class Report:
    """Results of writing or checking variants."""

    count: int  # number of variants that were requested; for a shard, the variants of the shard
    made: int
    # Findings of failed variants, by index. If no variant at all could be made, equal findings are
    # only at the first index.
    failed: dict[int, tuple[Finding, ...]]
    skipped: dict[int, tuple[Finding, ...]]  # by index, if on_invalid="skip"
    findings: tuple[Finding, ...]  # errors and warnings of all variants, in index order
    manifest: Optional[pathlib.Path]  # None without a manifest: after a check, for a single file

    @property
    def ok(self) -> bool:
        """True if no variant failed."""
        return not self.failed

    def __str__(self) -> str:
        counts = f"{self.made} of {self.count} variants ok"
        if self.skipped:
            counts += f", {len(self.skipped)} skipped"
        return "\n".join([counts, *(finding.text for finding in self.findings)])


def manifest_of(output: str, shard: Optional[str]) -> Optional[pathlib.Path]:
    """Returns the manifest that the command writes for this output; None for a single file."""
    index, _, shards = (shard or "0/1").partition("/")
    path = bytes_of(library.MjforgeManifest(os.fsencode(output), int(index), int(shards)))
    return pathlib.Path(os.fsdecode(path)) if path else None


def report_of(output: str, shard: Optional[str], span: range, made: int, skips: bool,
              found: list[Finding], spec: Spec) -> Report:
    """Returns the report of a command that has ended. `made`: the number of valid variants. `skips`:
    whether invalid variants are skipped. `found`: the findings that the command printed, a part of
    all.
    """
    manifest = manifest_of(output, shard)
    texts: dict[str, str] = {}

    def placed(finding: Finding) -> Finding:
        texts.update(texts or spec.texts)
        return finding.set_keys(spec._key_paths).set_texts(texts)

    for finding in found:
        placed(finding)
    if manifest is None or made == 0 and not shard:
        # The command writes no manifest for a single file, or if it could make no variant; a manifest
        # of an earlier batch remains.
        invalid = {index: tuple(finding for finding in found if finding.index == index)
                   for index in span} if made == 0 else {}
        failed, skipped = ({}, invalid) if skips else (invalid, {})
        return Report(len(span), made, failed, skipped, tuple(found), None)
    made = total = 0
    by_status: dict[str, dict[int, tuple[Finding, ...]]] = {"failed": {}, "skipped": {}}
    findings: list[Finding] = []
    for line in lines(os.fspath(manifest)):
        total += 1
        if _OK in line and _CLEAN in line:
            made += 1
            continue
        record = loads(line)
        own = tuple(map(placed, findings_of(record)))
        findings += own
        if record["status"] == "ok":
            made += 1
        else:
            by_status[record["status"]][record["index"]] = own
    about_all = [finding for finding in found if finding.index is None]
    return Report(total, made, by_status["failed"], by_status["skipped"],
                  tuple(about_all + findings), manifest)
