"""Processes that load objects in the user's MuJoCo, so that a crash or a hang of MuJoCo costs only
one object.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
from multiprocessing.connection import Connection, Pipe
from typing import Any, Callable, Iterable, Optional

from ._batch_files import Stored
from ._comparison import Comparison, Difference, Element
from ._variant import mujoco_of

_TIME_LIMIT = 60.0  # time limit for one object, s
_TOLERANCE = 1e-6


def _examine(mujoco: Any, stored: Stored) -> list[Difference]:
    refused = "loading it"
    try:
        model = mujoco.MjModel.from_xml_string(stored.xml.decode(), stored.files)
        refused = "simulating it"
        return Comparison(mujoco, model, stored.record, stored.xml, _TOLERANCE).run()
    except Exception as error:  # the compiler raises ValueError, the simulation FatalError
        words = " ".join(str(error).split()) or type(error).__name__
        line = re.search(r"\bline(?: =)? (\d+)", words)
        place = Element("", "", {}, int(line[1]), 1) if line else None
        return [Difference(f"{refused} fails: {words}", place, "mujoco/error")]


def main() -> None:
    """Examines objects in a worker process, until the other end of the pipe is closed."""
    pipe = Connection(int(sys.argv[1]))
    try:
        mujoco = mujoco_of(None)
    except ImportError as error:
        pipe.send((str(error), ""))
        return
    pipe.send(("", mujoco.__version__))
    while True:
        try:
            stored = pipe.recv()
        except EOFError:
            return
        pipe.send(_examine(mujoco, stored))


class Worker:
    """A worker process, which is started for the first object, and again for the next object after
    it died.
    """

    def __init__(self, folder: str) -> None:
        self._folder = folder
        self._process: Optional[subprocess.Popen[bytes]] = None
        self._pipe: Connection

    def start(self) -> str:
        """Starts the process and returns the version of its MuJoCo. Raises ImportError if the
        process cannot import MuJoCo.
        """
        self._pipe, other = Pipe()
        paths = [os.path.abspath(path) for path in sys.path]
        # Uses a working folder of its own, to which MuJoCo logs its warnings, and a session of its
        # own, so that Ctrl-C at the terminal does not reach the worker.
        self._process = subprocess.Popen(
            [sys.executable, "-c", "from mjforge._workers import main; main()", str(other.fileno())],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)}, cwd=self._folder,
            pass_fds=[other.fileno()], start_new_session=True, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        other.close()
        try:
            failure, version = self._pipe.recv()
        except EOFError:
            failure, version = f"importing mujoco ends the process {self._end()}", ""
        if failure:
            raise ImportError(failure)
        return str(version)

    def _end(self) -> str:
        """Returns the cause of the end of the process: "(SIGSEGV)"."""
        assert self._process is not None
        status = self._process.wait()
        return f"({signal.Signals(-status).name})" if status < 0 else f"(status {status})"

    def examine(self, stored: Stored) -> list[Difference]:
        """Returns the differences between an object and its record."""
        if self._process is None or self._process.poll() is not None:
            self.start()
        try:
            self._pipe.send(stored)
            if self._pipe.poll(_TIME_LIMIT):
                found: list[Difference] = self._pipe.recv()
                return found
        except (EOFError, OSError):
            return [Difference(f"loading it makes MuJoCo crash {self._end()}", None, "mujoco/error")]
        self.close()
        return [Difference(f"loading it takes more than {_TIME_LIMIT:g} s", None, "batch/too-slow")]

    def close(self) -> None:
        """Ends the process."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()


class Crew:
    """Several workers, each served by a thread of this process."""

    def __init__(self, jobs: int) -> None:
        self._folder = tempfile.TemporaryDirectory()
        self._workers = [Worker(self._folder.name) for _ in range(jobs)]
        try:
            self.version = self._workers[0].start()
        except BaseException:
            self.close()
            raise

    def examine(self, objects: Iterable[Stored], report: Callable[[Stored, list[Difference]], None],
                tick: Callable[[], None]) -> None:
        """Examines all objects. `report` is called with each object and its differences, in any
        order, one call at a time; `tick` is called ten times a second.
        """
        iterator = iter(objects)
        lock = threading.Lock()
        failures: list[BaseException] = []

        def serve(worker: Worker) -> None:
            try:
                while not failures:
                    with lock:
                        stored = next(iterator, None)
                    if stored is None:
                        return
                    found = worker.examine(stored)
                    with lock:
                        report(stored, found)
            except BaseException as error:
                failures.append(error)

        threads = [threading.Thread(target=serve, args=[worker], daemon=True)
                   for worker in self._workers]
        for thread in threads:
            thread.start()
        try:
            for thread in threads:
                while thread.is_alive():
                    thread.join(0.1)
                    tick()
        except BaseException as error:
            failures.append(error)
            self._end_workers()
            for thread in threads:
                thread.join()
            raise
        if failures:
            raise failures[0]

    def close(self) -> None:
        """Ends all processes and removes their working folder."""
        self._end_workers()
        self._folder.cleanup()

    def _end_workers(self) -> None:
        for worker in self._workers:
            worker.close()
