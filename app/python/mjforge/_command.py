"""Runs the command, which uses as many processes as asked without forking this one."""

from __future__ import annotations

import os
import re
import signal
import subprocess
from typing import IO, Any, Callable, Mapping, Optional

from ._findings import Finding
from ._json import loads
from ._library import PROGRAM, c_text

# Lines of `generate --verbose`: of each variant, and at first of those that an earlier run made.
_VARIANT = re.compile(r".*: (ok|failed|skipped), attempt \d+")
_KEPT = re.compile(r"(\d+) variants? kept")


class _Messages:
    """What the command writes to standard error."""

    def __init__(self, progress: Optional[Callable[[int], object]]) -> None:
        self.findings: list[Finding] = []
        self.words: list[str] = []
        self._progress = progress
        self._done = 0

    def read(self, stream: IO[bytes]) -> None:
        for encoded in stream:
            line = encoded.decode(errors="replace").rstrip("\n")
            if line.startswith("{"):
                self.findings.append(Finding(loads(encoded)))
            elif self._progress is not None and (kept := _KEPT.fullmatch(line)):
                self._done = int(kept[1])
                self._progress(self._done)
            elif self._progress is not None and _VARIANT.fullmatch(line):
                self._done += 1
                self._progress(self._done)
            else:
                self.words.append(line)

    def __str__(self) -> str:
        return "\n".join([*(finding.text for finding in self.findings), *self.words]).strip()


def run(arguments: list[str], text: bytes,
        progress: Optional[Callable[[int], object]] = None) -> list[Finding]:
    """What was found. `text` goes to standard input; `progress` gets the number of variants that
    are done, those of an earlier run included.

    Raises ValueError for wrong usage, OSError for failed input or output, KeyboardInterrupt when
    either process was interrupted: the command has then ended and every file is complete.
    """
    command = [PROGRAM, arguments[0], "--findings=json",
               "--quiet" if progress is None else "--verbose", *arguments[1:]]
    for argument in command:
        c_text(argument, "argument")
    # In a session of its own a Ctrl-C at the terminal reaches it once, through this process.
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, start_new_session=True)
    assert process.stdin is not None and process.stderr is not None
    messages = _Messages(progress)
    try:
        try:
            process.stdin.write(text)
            process.stdin.close()
        except BrokenPipeError:
            pass  # the command has ended; standard error has the reason
        messages.read(process.stderr)
        status = process.wait()
    except BaseException:
        process.send_signal(signal.SIGINT)
        process.stderr.read()
        process.wait()
        raise
    finally:
        process.stderr.close()
    if status in (0, 1):
        return messages.findings
    if status == 130:
        raise KeyboardInterrupt
    kinds: dict[int, type[Exception]] = {2: ValueError, 3: OSError}
    raise kinds.get(status, RuntimeError)(str(messages) or f"mjforge ended with status {status}")


def options_of(options: Mapping[str, Any]) -> list[str]:
    """`time_limit=5` is `--time-limit 5`; True is a flag; False and None are left out."""
    words = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(os.fspath(value) if isinstance(value, os.PathLike) else str(value))
    return words
