"""Peers in processes that are kept running, and commands whose time is taken."""

import json
import os
import pathlib
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ENVIRONMENT = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", PYTHONWARNINGS="ignore",
                   MUJOCO_GL="disable", OMP_NUM_THREADS="1")


class Peer:
    """One of peer_*.py, kept running."""

    def __init__(self, python, name):
        self.name = name
        self.process = subprocess.Popen([python, HERE / f"peer_{name}.py"], text=True,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        env=ENVIRONMENT)
        self.rows = self.answer()["rows"]

    def answer(self):
        line = self.process.stdout.readline()
        if not line:
            sys.exit(f"peers: {self.name} broke off")
        return json.loads(line)

    def ask(self, **request):
        print(json.dumps(request), file=self.process.stdin, flush=True)
        return self.answer()

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def run_timed(command):
    """Runs a command; seconds of all its processes."""
    start = time.perf_counter()
    process = subprocess.Popen(command)
    # Counts the children that the process itself has waited for.
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"peers: {' '.join(map(str, command))}: status {process.returncode}")
    return {"cpu": usage.ru_utime + usage.ru_stime, "wall": wall}
