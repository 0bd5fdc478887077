"""Runs the command `mjforge` as a child process, so that its worker processes are not forks of this
process.
"""

from __future__ import annotations

import os
import re
import subprocess
from typing import IO, Any, Callable, Mapping, Optional

from ._findings import Finding
from ._json import loads
from ._library import PROGRAM, c_text

# Lines that `generate` prints: with --verbose one for each variant, and first the number of variants
# that an earlier run made; as the last line, the numbers of all variants.
_VARIANT = re.compile(r".*: (ok|failed|skipped), attempt \d+")
_KEPT = re.compile(r"(\d+) variants? kept")
_SUMMARY = re.compile(r"\d+ variants? of .*: (\d+) ok\b.*")

_HELP = re.compile(r"\n  hint: see 'mjforge \w+ --help'")


class Messages:
    """Findings and other messages that the command writes to standard error."""

    def __init__(self, progress: Optional[Callable[[int], object]]) -> None:
        self.findings: list[Finding] = []
        self.words: list[str] = []
        self.made = 0  # number of valid variants of `generate`, those of an earlier run included
        self._progress = progress
        self._done = 0

    def read(self, stream: IO[bytes]) -> None:
        for encoded in stream:
            line = encoded.decode(errors="replace").rstrip("\n")
            if line.startswith("{"):
                members = loads(encoded)
                if "more" not in members:  # the number of findings that were not printed
                    self.findings.append(Finding(members))
            elif self._progress is not None and (kept := _KEPT.fullmatch(line)):
                self._done = int(kept[1])
                self._progress(self._done)
            elif self._progress is not None and _VARIANT.fullmatch(line):
                self._done += 1
                self._progress(self._done)
            elif summary := _SUMMARY.fullmatch(line):
                self.made += int(summary[1])
            else:
                self.words.append(line)

    def __str__(self) -> str:
        return "\n".join([*(finding.text for finding in self.findings), *self.words]).strip()


def run(arguments: list[str], text: bytes,
        progress: Optional[Callable[[int], object]] = None) -> Messages:
    """Runs the command and returns its messages. `text` goes to standard input. `progress` is
    called with the number of variants that are done, including those of an earlier run.

    Raises ValueError for wrong usage, OSError if reading or writing failed, and KeyboardInterrupt
    if this process or the command was interrupted; the command has then ended, and every file is
    complete.
    """
    # Without --quiet, `generate` ends with a summary.
    detail = ["--verbose"] if progress is not None else ["--quiet"] * (arguments[0] != "generate")
    command = [PROGRAM, arguments[0], "--findings=json", *detail, *arguments[1:]]
    for argument in command:
        c_text(argument, "argument")
    # Starts a session of its own, so that Ctrl-C at the terminal reaches the command only once,
    # through this process; the command ends when this process is killed.
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, start_new_session=True,
                               env={**os.environ, "MJFORGE_PARENT": str(os.getpid())})
    assert process.stdin is not None and process.stderr is not None
    messages = Messages(progress)
    try:
        try:
            process.stdin.write(text)
            process.stdin.close()
        except BrokenPipeError:
            pass  # the command has ended; standard error has the reason
        messages.read(process.stderr)
        status = process.wait()
    except BaseException:
        process.terminate()  # the command ignores SIGINT if this process does
        process.stderr.read()
        process.wait()
        raise
    finally:
        process.stderr.close()
    if status in (0, 1):
        return messages
    if status == 130:
        raise KeyboardInterrupt
    kinds: dict[int, type[Exception]] = {2: ValueError, 3: OSError}
    said = _HELP.sub("", str(messages)).removeprefix("mjforge: error: ")
    raise kinds.get(status, RuntimeError)(said or f"mjforge ended with status {status}")


def options_of(options: Mapping[str, Any]) -> list[str]:
    """Returns options as words of a command line: `time_limit=5` becomes `--time-limit 5`, and True
    becomes a flag without a value. Leaves out False and None.
    """
    words = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(os.fspath(value) if isinstance(value, os.PathLike) else str(value))
    return words
