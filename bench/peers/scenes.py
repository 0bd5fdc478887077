#!/usr/bin/env python3
"""mjforge against scene_synthesizer: the same objects on the same table and shelf, one run.

    scenes.py BUILD FOLDER [--smoke | --write]

BUILD holds app/mjforge; FOLDER gets the peers. --smoke: few objects, only to see that all of it
runs. --write: the table goes to docs/performance.md.
"""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

from install import install, version
import page
from processes import Peer, run_timed

SPEC = pathlib.Path(__file__).resolve().parent / "scene.yaml"
SUPPORTS = {
    "table": [],
    "shelf": ["levels=4", "half_x=60cm", "half_y=15cm"],
}
THINGS = ["boxes", "mugs", "mixed"]
COUNTS = [5, 20, 100]
ROUNDS = 5
OBJECTS = 2000  # in the scenes of one command, so that its start weighs little
LEAST_SCENES = 20
GOAL = 20  # times as fast


class Case:
    """A number of things on a support."""

    def __init__(self, program, scratch, support, things, count):
        self.name = f"{count} {things}, {support}"
        self.count = count
        self.scenes = max(LEAST_SCENES, OBJECTS // count)
        self._command = [program, "generate", SPEC, "-q", "--force", "-j", "1",
                         "--validate", "none",
                         "--set", f"things={things}", "--set", f"count={count}"]
        self._settings = [word for each in SUPPORTS[support] for word in ("--set", each)]
        self._folder = scratch / self.name.replace(", ", "_").replace(" ", "_")
        # All things, also those without room: nothing is left out on a large table.
        self._objects = self._folder / "objects"
        subprocess.run([*self._command, "-n", str(ROUNDS), "-o", self._objects,
                        "--set", "half_x=100m", "--set", "half_y=100m"], check=True)

    def objects(self, index):
        return self._objects / f"scene_{index:06}.xml"

    def scene(self, index):
        return self._folder / "scenes" / f"scene_{index:06}.xml"

    def generate(self):
        """Milliseconds of CPU time for each scene."""
        seconds = run_timed([*self._command, *self._settings, "-n", str(self.scenes),
                             "-o", self._folder / "scenes"])
        return 1e3 * seconds["cpu"] / self.scenes

    def placed(self, index):
        manifest = (self._folder / "scenes/manifest.jsonl").read_text().splitlines()
        return len(json.loads(manifest[index])["places"])

    def with_poses(self, index, poses):
        """A file like the scene, with the objects where the peer has placed them."""
        tree = ET.parse(self.objects(index))
        world = tree.find("worldbody")
        support = ET.parse(self.scene(index)).find("worldbody/body[@name='scene']")
        world.remove(world.find("body[@name='scene']"))
        for keyframe in tree.findall("keyframe"):
            tree.getroot().remove(keyframe)
        for body in world.findall("body"):
            pose = poses[body.get("name")]
            if pose is None:
                world.remove(body)
                continue
            for key, numbers in zip(("pos", "quat"), pose):
                body.set(key, " ".join(map(repr, numbers)))
        world.insert(0, support)
        file = self._folder / "peer.xml"
        tree.write(file)
        return file


def run_case(case, peer, rounds):
    """What each round gives, by name."""
    rows = []
    for index in range(rounds):
        ours = case.generate()
        theirs = peer.ask(scene=str(case.scene(index)), objects=str(case.objects(index)),
                          seed=index)
        poses = theirs["poses"]
        rows.append({
            "ours": ours, "theirs": theirs["cpu"], "ratio": theirs["cpu"] / ours,
            "ours placed": case.placed(index),
            "theirs placed": sum(pose is not None for pose in poses.values()),
            "ours rest": peer.ask(settle=str(case.scene(index)))["rest"],
            "theirs rest": peer.ask(settle=str(case.with_poses(index, poses)))["rest"]})
    return rows


def cells_of(case, rows):
    def number(key):
        value = statistics.median(row[key] for row in rows)
        return f"{value:.0f}" if value >= 100 else f"{value:.3g}"

    def share(key, of):
        return f"{100 * sum(row[key] for row in rows) / of:.1f} %"

    cells = [case.name, number("theirs"), number("ours"), number("ratio")]
    for whose in ("theirs", "ours"):
        cells.append(share(f"{whose} placed", len(rows) * case.count))
        cells.append(share(f"{whose} rest", sum(row[f"{whose} placed"] for row in rows)))
    return cells


HEAD = ["", "scene_synthesizer, ms", "mjforge, ms", "ratio", "scene_synthesizer places",
        "of these rest", "mjforge places", "of these rest"]


def main():
    options = set(sys.argv[3:])
    if len(sys.argv) < 3 or options - {"--smoke", "--write"} or len(options) > 1:
        sys.exit("usage: scenes.py BUILD FOLDER [--smoke | --write]")
    smoke = "--smoke" in options
    program = pathlib.Path(sys.argv[1]).resolve() / "app/mjforge"
    folder = pathlib.Path(sys.argv[2]).resolve()
    peer = Peer(install(folder), "scene_synthesizer")
    rows = []
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        for support in SUPPORTS:
            for things in THINGS:
                for count in COUNTS[:1] if smoke else COUNTS:
                    case = Case(program, pathlib.Path(scratch), support, things, count)
                    rows.append(cells_of(case, run_case(case, peer, 1 if smoke else ROUNDS)))
                    print("  ".join(rows[-1]), file=sys.stderr, flush=True)
    peer.close()
    missed = [row[0] for row in rows if float(row[3]) < GOAL]
    reached = f"not reached by {', '.join(missed)}" if missed else "reached by all rows"
    about = (f"{page.version_of(program)}; scene_synthesizer {version('scene-synthesizer')},"
             f" trimesh {version('trimesh')}, Python's mujoco {version('mujoco')}."
             f" {page.machine()}.")
    if smoke:
        print("Only to see that all of it runs; these figures say nothing.\n")
    report = "\n\n".join([about, f"The goal is a ratio of {GOAL}: {reached}.", "{}"])
    print(report.format(page.as_text(HEAD, rows)))
    if "--write" in options:
        page.write("scenes", report.format(page.as_markdown(HEAD, rows)))


main()
