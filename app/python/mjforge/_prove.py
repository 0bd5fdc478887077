"""`python -m mjforge prove`: a batch loaded in the user's MuJoCo and compared with its records."""

from __future__ import annotations

import argparse
import json
import os
import pathlib
import shutil
import sys
import time
from typing import Any, Optional, Union

from ._batch_files import Reader, Stored, manifests_of, missing_shards
from ._comparison import Difference
from ._findings import Finding, printable
from ._options import MAX_JOBS
from ._workers import Crew

_MAX_SHOWN = 50  # findings that the command prints
_MAX_COLUMNS = 120  # longest part of a quoted line


class Proof:
    """Result of a proof: findings, and the number of variants that match their records."""

    def __init__(self) -> None:
        self.findings: list[Finding] = []
        self.variants = 0  # variants with a file, according to the manifests
        self.proven = 0
        self.version = ""  # version of the MuJoCo that loaded the files
        self.recorded: set[str] = set()  # releases of MuJoCo that checked the variants


class _Progress:
    """A progress bar on a terminal."""

    def __init__(self, enabled: bool, count: Optional[int]) -> None:
        self._enabled = enabled and sys.stderr.isatty() and os.environ.get("TERM", "dumb") != "dumb"
        self._count = count
        self._start = time.monotonic()
        self._shown = False

    def show(self, done: int, failed: int) -> None:
        seconds = time.monotonic() - self._start
        if not self._enabled or seconds < 0.5:
            return
        line = f"{done}  {done / seconds:.0f}/s"
        if self._count:
            share = min(1.0, done / self._count)
            left = int(seconds * (self._count - done) / max(done, 1)) + 1
            line = (f"[{'#' * int(20 * share):.<20}] {int(100 * share):3} %  {done} of {self._count}"
                    f"  {done / seconds:.0f}/s  {left // 60}:{left % 60:02} left")
        if failed:
            line += f"  {failed} failed"
        sys.stderr.write(f"\r\x1b[K{line[:shutil.get_terminal_size().columns - 1]}")
        sys.stderr.flush()
        self._shown = True

    def clear(self) -> None:
        if self._shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()


def run(batch: Union[str, "os.PathLike[str]"], jobs: Optional[int], progress: bool) -> Proof:
    """Loads the files of a batch and compares them with their records. Raises FileNotFoundError if
    there is no manifest, ImportError if MuJoCo is not installed.
    """
    proof = Proof()
    manifests = manifests_of(batch)
    crew = Crew(jobs or len(os.sched_getaffinity(0)))
    try:
        proof.version = crew.version
        for manifest in manifests:
            _prove(manifest, crew, proof, progress)
    finally:
        crew.close()
    proof.findings += missing_shards(batch, manifests)
    return proof


def _prove(manifest: pathlib.Path, crew: Crew, proof: Proof, progress: bool) -> None:
    stored_objects = Reader(manifest, proof.findings.append)
    bar = _Progress(progress, stored_objects.count())
    failed = 0
    first = len(proof.findings)

    def report(stored: Stored, differences: list[Difference]) -> None:
        nonlocal failed
        proof.recorded.add(str(stored.record.get("mujoco", "")))
        proof.findings += [_finding(stored, difference, proof.version) for difference in differences]
        proof.proven += not differences
        failed += bool(differences)

    try:
        crew.examine(stored_objects, report, lambda: bar.show(stored_objects.records, failed))
    finally:
        bar.clear()
    stored_objects.compare_with_seal()
    proof.variants += stored_objects.objects
    proof.findings[first:] = sorted(proof.findings[first:], key=lambda f: f.index or 0)


def _finding(stored: Stored, difference: Difference, version: str) -> Finding:
    message = f"in MuJoCo {version} {difference.message}"
    members = {"severity": "error", "code": difference.code, "message": message, "notes": [],
               "file": stored.place, "seed": stored.record["seed"], "index": stored.record["index"]}
    quoted = ""
    if difference.element is not None:
        members |= {"line": difference.element.line, "column": difference.element.column}
        lines = stored.xml.splitlines()[difference.element.line - 1:difference.element.line]
        quoted = b"".join(lines).decode(errors="replace")
    return Finding(members, _text(members, quoted))


def _text(members: dict[str, Any], quoted: str) -> str:
    """Returns the finding in the form of the command: place, message, and the line with a caret."""
    place = ":".join(str(members[key]) for key in ("file", "line", "column") if key in members)
    text = (f"{place}: error: {members['message']} (seed {members['seed']}, index {members['index']}) "
            f"[{members['code']}]")
    if quoted:
        cut = quoted if len(quoted) <= _MAX_COLUMNS else quoted[:_MAX_COLUMNS - 3] + "..."
        text = f"{text}\n{cut}\n{' ' * (members['column'] - 1)}^"
    return text


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}{'' if count == 1 else 's'}"


def _jobs(text: str) -> int:
    try:
        number = int(text)
    except ValueError:
        number = 0
    if not 1 <= number <= MAX_JOBS:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number of processes from 1 to {MAX_JOBS}")
    return number


def _show(proof: Proof, as_json: bool) -> None:
    for finding in proof.findings if as_json else proof.findings[:_MAX_SHOWN]:
        print(json.dumps(finding.members()) if as_json else finding.text, file=sys.stderr)
    more = len(proof.findings) - _MAX_SHOWN
    if more > 0 and not as_json:
        print(f"mjforge: {_counted(more, 'more finding')}", file=sys.stderr)


def main(arguments: list[str]) -> int:
    """Runs `mjforge prove`; returns its exit status, which has the values of mjforge's other
    commands.
    """
    parser = argparse.ArgumentParser("mjforge prove", description="Loads every file of a batch in the "
                                     "installed MuJoCo and compares it with its record.")
    parser.add_argument("batch", metavar="WHAT", help="a folder, an archive or a manifest")
    parser.add_argument("-j", "--jobs", type=_jobs, metavar="N", help="processes; one per core")
    parser.add_argument("-q", "--quiet", action="store_true", help="print only findings")
    parser.add_argument("--findings", choices=["text", "json"], default="text", help="their format")
    options = parser.parse_args(arguments)
    start = time.monotonic()
    try:
        proof = run(options.batch, options.jobs, not options.quiet)
    except (ImportError, OSError) as error:
        print(printable(f"mjforge: error: {error}"), file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        print("mjforge: interrupted", file=sys.stderr)
        return 130
    _show(proof, options.findings == "json")
    if not options.quiet:
        releases = ", ".join(sorted(proof.recorded - {""}))
        checked = f"checked in {releases} when made" if releases else "not checked when made"
        print(printable(f"{_counted(proof.variants, 'variant')} in {options.batch}: {proof.proven} as recorded in "
                        f"MuJoCo {proof.version}; {checked} ({time.monotonic() - start:.1f} s)"),
              file=sys.stderr)
    return 1 if proof.findings or proof.proven < proof.variants else 0
