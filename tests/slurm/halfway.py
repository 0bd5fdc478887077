"""Stops mjforge in the middle of a shard, so that it can be killed just there."""

import contextlib
import os
import pathlib
import signal
import time


def processes(shard):
    """mjforge and its workers that make the shard, `I/N`."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                words = (entry / "cmdline").read_text(errors="replace").split("\0")
            except OSError:
                continue  # it has ended
            if os.path.basename(words[0]) == "mjforge" and f"--shard\0{shard}\0" in "\0".join(words):
                found.append(int(entry.name))
    return found


def processes_in(folder):
    """All whose working folder it is."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            if entry.name.isdigit() and (entry / "cwd").readlink() == folder:
                found.append(int(entry.name))
    return found


def signal_all(pids, number):
    for pid in pids:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, number)


@contextlib.contextmanager
def _at_once():
    """Runs as soon as it wakes, where that is allowed: a whole shard takes tenths of a second."""
    before = os.sched_getscheduler(0), os.sched_getparam(0)
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
    except PermissionError:
        yield
        return
    try:
        yield
    finally:
        os.sched_setscheduler(0, *before)


def stop(form, folder, shard, of, seconds=60):
    """The processes that make a shard, stopped (SIGSTOP) when some of it is made."""
    end = time.monotonic() + seconds
    with _at_once():
        while not form.has_begun(folder, shard):
            if (folder / form.shard_manifest(shard)).exists() or time.monotonic() > end:
                raise AssertionError(f"shard {shard} of the {form.name} was not seen begun")
            time.sleep(0.001)
        pids = []
        # Once more: the first may have made a worker meanwhile.
        while more := set(processes(f"{shard}/{of}")) - set(pids):
            signal_all(more, signal.SIGSTOP)
            pids += more
    if not pids or not (folder / form.part_of(shard)).exists():
        raise AssertionError(f"shard {shard} of the {form.name} was done before it could be stopped")
    return pids
