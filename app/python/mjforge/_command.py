"""Runs the command, which uses as many processes as asked without forking this one."""

from __future__ import annotations

import json
import os
import signal
import subprocess
from typing import TYPE_CHECKING, Any, Mapping, Optional

from ._findings import Finding
from ._library import PROGRAM, c_text

if TYPE_CHECKING:
    from ._spec import Source, Spec


def _findings_of(said: bytes) -> tuple[list[Finding], str]:
    """Those of `--findings json`, and all other lines."""
    findings, words = [], []
    for line in said.decode(errors="replace").splitlines():
        if line.startswith("{"):
            findings.append(Finding(json.loads(line)))
        else:
            words.append(line)
    return findings, "\n".join(words)


def run(arguments: list[str], text: Optional[str]) -> tuple[int, list[Finding]]:
    """Exit status 0 or 1, and what was found. `text` goes to standard input.

    Raises ValueError for wrong usage, OSError for failed input or output, KeyboardInterrupt when
    either process was interrupted: the command has then ended and every file is complete.
    """
    command = [PROGRAM, arguments[0], "--findings=json", "--quiet", *arguments[1:]]
    for argument in command:
        c_text(argument, "argument")
    # In a session of its own a Ctrl-C at the terminal reaches it once, through this process.
    process = subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL if text is None else subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    given = None if text is None else text.encode()
    try:
        said = process.communicate(given)[1]
    except BaseException:
        process.send_signal(signal.SIGINT)
        process.communicate()
        raise
    findings, words = _findings_of(said)
    status = process.returncode
    if status in (0, 1):
        return status, findings
    told = "\n".join([*(finding.text for finding in findings), words]).strip()
    if status == 2:
        raise ValueError(told)
    if status == 3:
        raise OSError(told)
    if status == 130:
        raise KeyboardInterrupt
    raise RuntimeError(f"mjforge ended with status {status}: {told}")


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


def check(
    spec: "Source | Spec",
    count: int = 20,
    *,
    set: Optional[Mapping[str, Any]] = None,
    seed: int = 0,
    physics: bool = False,
    **options: Any,
) -> list[Finding]:
    """What `mjforge check` finds in a spec and in its first `count` variants; writes nothing.

    `physics`: each is simulated, too. Other options are the command's: `jobs`, `time_limit` (s),
    `profile`.
    """
    from ._spec import Spec

    if not isinstance(spec, Spec):
        reference, text, words = Spec.command_line(spec, set or {}, ())
    elif set:
        raise ValueError("a Spec has its settings already")
    else:
        reference, text, words = Spec.command_line(spec.source, spec.settings, spec.parameter_files)
    words += options_of({"count": count, "seed": seed, "physics": physics, **options})
    return run(["check", *words, "--", reference], text)[1]
