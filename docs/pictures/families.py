"""Draws variants of a spec and says what they have: masses, sides, joints and grasp sites."""

import json
import math
import pathlib
import re
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

SIDES = 3


class Range:
    """The smallest and the largest value that was seen."""

    def __init__(self):
        self.low, self.high = math.inf, -math.inf

    def add(self, value):
        self.low, self.high = min(self.low, value), max(self.high, value)


class Joint:
    """Joints whose names differ only in numbers: of how many variants, and where they end."""

    def __init__(self, kind):
        self.kind = kind
        self.names = set()
        self.variants = set()
        self.low, self.high = Range(), Range()
        self.is_limited = True


class Family:
    """What the variants of a spec have."""

    def __init__(self, records, models):
        made = [record for record in records if "mass" in record]
        self.count = len(made)
        self.mass = Range()
        self.sides = [Range() for _ in range(SIDES)]
        self.joints = {}
        self.grasps = {}
        for record in made:
            self.mass.add(record["mass"])
            box = record["aabb"]
            sides = sorted((high - low for low, high in zip(box["min"], box["max"])), reverse=True)
            for side, length in zip(self.sides, sides):
                side.add(length)
        for index, model in enumerate(models):
            self._add_model(index, model)

    def _add_model(self, index, model):
        prefix = model.get("model") + "_"
        world = model.find("worldbody")
        for element in world.iter("joint"):
            name = element.get("name").removeprefix(prefix)
            # That of the root says only that the object is free.
            if name != "joint0":
                self._add_joint(index, name, element)
        for element in world.iter("site"):
            name = element.get("name").removeprefix(prefix)
            if "grasp" in name:
                self.grasps.setdefault(_pattern(name), set()).add(name)

    def _add_joint(self, index, name, element):
        kind = element.get("type", "hinge")
        joint = self.joints.setdefault((_pattern(name), kind), Joint(kind))
        joint.names.add(name)
        joint.variants.add(index)
        if element.get("range") is None or element.get("limited") == "false":
            joint.is_limited = False
            return
        low, high = map(float, element.get("range").split())
        joint.low.add(low)
        joint.high.add(high)


def _pattern(name):
    return re.sub(r"\d+", "#", name)


def draw(program, spec, count):
    """The family of `count` variants."""
    with tempfile.TemporaryDirectory() as folder:
        batch = pathlib.Path(folder) / "batch"
        # Some variants may have no place for everything; they are left out.
        subprocess.run([program, "generate", spec, "-n", str(count), "-j1", "-q", "--durability", "none",
                        "--on-invalid", "skip", "-o", f"{batch}/"], check=True)
        with (batch / "manifest.jsonl").open(encoding="utf-8") as lines:
            records = [json.loads(line) for line in lines]
        models = (ElementTree.parse(file).getroot() for file in sorted(batch.glob("*.xml")))
        return Family(records, models)
