#!/usr/bin/env python3
"""mjforge against what else makes MJCF in a program, the same objects, one run.

    run.py BUILD FOLDER [--smoke | --write]

BUILD holds app/mjforge and bench/mjforge_in_process; FOLDER gets the peers.
--smoke: few objects, only to see that all of it runs. --write: the tables go to
docs/performance.md. Status 1 if a peer's object is not the same.
"""

import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

from install import install, version
import page
from processes import Peer, run_timed
from report import report

# Name: the bundled spec, and what is held so that all variants have the same parts.
OBJECTS = {
    "hammer": ("robosuite/hammer", ["handle_shape=box"]),
    "pot": ("robosuite/pot_with_handles", ["solid_handle=false"]),
    "hinged box": ("robosuite/hinged_box", []),
    "wrench": ("robosuite/ratcheting_wrench", ["ngeoms=8", "grip=true"]),
    "ring of 50": ("robosuite/hollow_cylinder", ["ngeoms=50"]),
}
PEERS = ["robosuite", "pymjcf", "mjspec"]

REPETITIONS = 5
SECONDS = 0.25  # that a measurement inside a process should take
COMMAND_SECONDS = 2.0  # and one of the whole command, so that its start weighs little


class Library:
    """mjforge in a process that times itself."""

    def __init__(self, program):
        self.program = program

    def measure(self, what, name, count):
        spec, settings = OBJECTS[name]
        said = subprocess.run([self.program, what, str(count), spec, *settings],
                              check=True, capture_output=True, text=True).stdout
        cpu, wall = map(float, said.split())
        return {"cpu": cpu, "wall": wall}


class Command:
    """mjforge as it is used: started, run, ended. Time of all its processes."""

    def __init__(self, program, scratch):
        self.program = program
        self.scratch = scratch

    def generate(self, name, count, out, *options):
        spec, settings = OBJECTS[name]
        sets = [word for setting in settings for word in ("--set", setting)]
        return [self.program, "generate", spec, "-n", str(count), "-s", "7", "-o", out, "-q",
                *sets, *options]

    def measure(self, validate, jobs, name, count):
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.scratch))
        command = self.generate(name, count, folder / "objects.tar", "--validate", validate,
                                "-j", str(jobs))
        seconds = run_timed(command)
        shutil.rmtree(folder)
        return {clock: s / count * 1e6 for clock, s in seconds.items()}

    def example(self, name):
        """A file of one variant."""
        file = self.scratch / f"{name.replace(' ', '_')}.xml"
        subprocess.run(self.generate(name, 1, file), check=True)
        return file


def check_same(peers, command):
    """Each peer's object has as many geoms of each kind as mjforge's."""
    different = 0
    for name in OBJECTS:
        ours = peers[0].ask(file=str(command.example(name)))["geoms"]
        for peer in peers:
            theirs = peer.ask(geoms=name)["geoms"]
            if theirs != ours:
                different += 1
                print(f"FAILED {name}: {peer.name} has {theirs}, mjforge {ours}")
        print(f"{name}: {', '.join(f'{n} {kind}' for kind, n in ours.items())}", flush=True)
    if different:
        sys.exit(1)


def measurements(peers, library, command):
    """By row, what measures it: a function of an object's name and a count."""
    rows = {}
    for peer in peers:
        for row in peer.rows:
            rows[f"{peer.name} {row}"] = lambda name, count, peer=peer, row=row: peer.ask(
                row=row, object=name, count=count)
    for what in ("none", "load", "bare"):
        rows[f"library {what}"] = lambda name, count, what=what: library.measure(what, name, count)
    for validate in ("none", "load"):
        for jobs in (1, 2):
            rows[f"command {validate} {jobs}"] = (
                lambda name, count, validate=validate, jobs=jobs: command.measure(
                    validate, jobs, name, count))
    return rows


def choose_counts(rows, smoke):
    """How many objects make a measurement long enough; warms up as well."""
    counts = {}
    for row, measure in rows.items():
        for name in OBJECTS:
            if smoke:
                counts[row, name] = 20
                continue
            seconds = COMMAND_SECONDS if row.startswith("command") else SECONDS
            once = measure(name, 2000 if row.startswith("command") else 20)["wall"] / 1e6
            counts[row, name] = max(10, int(seconds / once))
    return counts


def run(rows, smoke):
    """Medians by (row, object). One round after the other, each through all of
    them, so that a slow minute of the machine is everybody's."""
    counts = choose_counts(rows, smoke)
    results = {key: [] for key in counts}
    repetitions = 1 if smoke else REPETITIONS
    for repetition in range(repetitions):
        print(f"round {repetition + 1} of {repetitions}", file=sys.stderr, flush=True)
        for name in OBJECTS:
            for row, measure in rows.items():
                results[row, name].append(measure(name, counts[row, name]))
    return {key: {clock: statistics.median(sample[clock] for sample in samples)
                  for clock in ("cpu", "wall")} for key, samples in results.items()}


def versions(program):
    return (f"{page.version_of(program)}; robosuite {version('robosuite')},"
            f" dm_control {version('dm_control')}, Python's mujoco {version('mujoco')}")


def main():
    options = set(sys.argv[3:])
    if len(sys.argv) < 3 or options - {"--smoke", "--write"} or len(options) > 1:
        sys.exit("usage: run.py BUILD FOLDER [--smoke | --write]")
    build, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    python = install(folder)
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        command = Command(build / "app/mjforge", pathlib.Path(scratch))
        library = Library(build / "bench/mjforge_in_process")
        peers = [Peer(python, name) for name in PEERS]
        check_same(peers, command)
        medians = run(measurements(peers, library, command), "--smoke" in options)
        for peer in peers:
            peer.close()
    about = f"{versions(build / 'app/mjforge')}. {page.machine()}."
    if "--smoke" in options:
        print("Only to see that all of it runs; these figures say nothing.\n")
    print(report(medians, OBJECTS, about, page.as_text))
    if "--write" in options:
        page.write("peers", report(medians, OBJECTS, about, page.as_markdown))


main()
