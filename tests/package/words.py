"""Commands of others, as a user gives them."""

import os
import pathlib
import subprocess

TOP = pathlib.Path(__file__).resolve().parent.parent.parent

# Of the tester, only what programs need; nothing that leads to a build or changes the words.
KEPT = ["HOME", "TERM", "USER", "SOURCE_DATE_EPOCH", "http_proxy", "https_proxy", "no_proxy"]


def environment(variables=None):
    kept = {name: os.environ[name] for name in KEPT if name in os.environ}
    return {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "C.UTF-8", "MANWIDTH": "100",
            "DEBIAN_FRONTEND": "noninteractive", **kept, **(variables or {})}


def run(*words, folder=TOP, variables=None, status=0):
    """What it says, on both channels; it ends with this status."""
    result = subprocess.run([str(word) for word in words], cwd=folder, text=True,
                            env=environment(variables), stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if result.returncode != status:
        line = " ".join(str(word) for word in words)
        raise AssertionError(f"{line}: status {result.returncode}\n{result.stdout}")
    return result.stdout


def as_root(*words):
    return run(*([] if os.geteuid() == 0 else ["sudo"]), *words)
