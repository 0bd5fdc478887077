"""Files with `<frame>` and `<replicate>`: the command that mjforge's finding gives expands them, and
what mjforge attaches of the result lies where this MuJoCo puts it.

    check_later.py FOLDER
"""

import os
import pathlib
import random
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

import mjforge
import mujoco
import numpy as np

from report import check, expect, finish

SEEDS = range(40)
TOLERANCE = 1e-5  # MuJoCo writes six digits
SIZES = {int(mujoco.mjtGeom.mjGEOM_SPHERE): 1, int(mujoco.mjtGeom.mjGEOM_CAPSULE): 2,
         int(mujoco.mjtGeom.mjGEOM_CYLINDER): 2}  # how many of the three count
DEFAULTS = """
<default>
  <geom type="box" size="0.02 0.03 0.04" quat="0.8 0.1 0 0.2" density="700"/>
  <default class="slanted">
    <geom type="capsule" size="0.01 0.05" euler="30 0 20"/>
    <site size="0.004" zaxis="1 2 3"/>
    <joint axis="0 1 0" pos="0.01 0 0"/>
    <default class="rods"><geom fromto="0 0 0 0.03 0.02 0.01"/></default>
  </default>
</default>"""

# What refers to replicas, alone, with what is beside them, and with what no replica has.
REFERRING = """
<mujoco>
  <worldbody>
    <body name="thing">
      <geom name="base" size="0.1"/>
      <body name="still"><joint name="turn"/><geom name="stop" size="0.05"/></body>
      <replicate count="3" offset="0 0.3 0" euler="10 0 5" sep="_">
        <body name="arm">
          <joint name="swing" axis="0 1 0"/><geom name="rod" size="0.04"/><site name="tip"/>
          <replicate count="2" offset="0.1 0 0"><body name="tooth"><joint name="bite"/>
            <geom name="edge" size="0.01"/></body></replicate>
        </body>
      </replicate>
    </body>
  </worldbody>
  <contact><exclude name="apart" body1="arm" body2="still"/><pair name="near" geom1="edge" geom2="rod"/>
  </contact>
  <equality><joint name="same" joint1="swing"/><joint name="both" joint1="swing" joint2="turn"/>
    <weld name="held" body1="tooth" body2="arm"/></equality>
  <tendon><fixed name="pull"><joint joint="bite" coef="1"/><joint joint="turn" coef="2"/></fixed></tendon>
  <actuator><motor name="first" joint="turn"/><motor name="push" joint="bite"/>
    <motor name="drag" tendon="pull"/></actuator>
  <sensor><jointpos name="angle" joint="turn"/><framepos name="from" objtype="site" objname="tip"
    reftype="body" refname="still"/><actuatorfrc name="force" actuator="drag"/></sensor>
</mujoco>"""


class Drawn:
    """A file with a body `thing`, drawn with this seed."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.count = 0
        root = xml.fromstring(f"<mujoco>{DEFAULTS}<worldbody/></mujoco>")
        xml.SubElement(root, "compiler", angle=self.random.choice(["degree", "radian"]),
                       eulerseq=self.random.choice(["xyz", "XYZ", "zYx"]))
        world = root.find("worldbody")
        around = xml.SubElement(world, "frame", **self.pose())
        body = xml.SubElement(around, "body", name="thing", **self.pose())
        xml.SubElement(body, "geom", name="middle")
        self.fill(body, 3, body)
        self.text = xml.tostring(root, encoding="unicode")

    def numbers(self, count, size=1.0):
        return " ".join(f"{self.random.uniform(-size, size):.4f}" for _ in range(count))

    def pose(self, orientations=("quat", "axisangle", "xyaxes", "zaxis", "euler", None)):
        words = {}
        if self.random.random() < 0.8:
            words["pos"] = self.numbers(3, 0.2)
        said = self.random.choice(orientations)
        if said:
            words[said] = self.numbers({"quat": 4, "axisangle": 4, "xyaxes": 6}.get(said, 3))
        return words

    def maybe_class(self, word, names=("slanted", "main")):
        return {word: self.random.choice(names)} if self.random.random() < 0.3 else {}

    def name(self):
        self.count += 1
        return f"e{self.count}x"  # a number after it is a replica's

    def fill(self, parent, depth, body):
        for _ in range(self.random.randint(1, 3)):
            self.add(parent, self.random.choice(
                ["geom", "ends", "site", "camera", "light", "joint", "body", "frame", "frame",
                 "replicate"]), depth, body)

    def add(self, parent, kind, depth, body):
        if kind in ("body", "frame", "replicate"):
            if depth == 0:
                return
            if kind == "body":
                child = xml.SubElement(parent, kind, name=self.name(), **self.pose(),
                                       **self.maybe_class("childclass"))
                xml.SubElement(child, "geom", name=self.name())
                return self.fill(child, depth - 1, child)
            if kind == "frame":
                child = xml.SubElement(parent, kind, **self.pose(), **self.maybe_class("childclass"))
                return self.fill(child, depth - 1, body)
            child = xml.SubElement(
                parent, kind, count=str(self.random.choice([1, 2, 3, 11])), offset=self.numbers(3, 0.1),
                euler=self.numbers(3), sep=self.random.choice(["", "_", "__"]))
            return self.fill(child, depth - 1, None)
        words = {"name": self.name(), **self.maybe_class("class", ("slanted", "rods", "main"))}
        if kind == "ends":
            words |= {"fromto": self.numbers(6, 0.1), "size": "0.01",
                      "type": self.random.choice(["capsule", "cylinder", "box", "ellipsoid"])}
            kind = self.random.choice(["geom", "site"])
        elif kind == "light":
            words |= {"pos": self.numbers(3), "dir": self.numbers(3)}
        elif kind == "joint":
            # A replicate holds none of its own, and `thing` is told by the spec how it moves.
            if body is None or body.get("name") == "thing":
                return
            words |= {"axis": self.numbers(3), "type": self.random.choice(["hinge", "slide"])}
            if self.random.random() < 0.5:
                words["pos"] = self.numbers(3, 0.1)
        elif kind == "camera":
            words |= self.pose()
        elif words.get("class") != "rods":
            # Whether `quat` wins over what a class says in another word differs: since 4.0 it does.
            words |= self.pose(("axisangle", "xyaxes", "zaxis", "euler", None))
        xml.SubElement(parent, kind, **words)


def rotation(quat):
    matrix = np.zeros(9)
    mujoco.mju_quat2Mat(matrix, quat)
    return matrix.reshape(3, 3)


def places(model, prefix, body):
    """By the names of elements: where they are in that body, as their file has it."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    turn, at = data.xmat[body].reshape(3, 3).T, data.xpos[body]
    inside = {body}
    for one in range(body + 1, model.nbody):
        if model.body_parentid[one] in inside:
            inside.add(one)
    found = {}
    kinds = {"body": (data.xpos, data.xmat, range(model.nbody)),
             "geom": (data.geom_xpos, data.geom_xmat, model.geom_bodyid),
             "site": (data.site_xpos, data.site_xmat, model.site_bodyid),
             "cam": (data.cam_xpos, data.cam_xmat, model.cam_bodyid),
             "light": (data.light_xpos, data.light_xdir, model.light_bodyid),
             "jnt": (data.xanchor, data.xaxis, model.jnt_bodyid)}
    for kind, (positions, turns, bodies) in kinds.items():
        names = getattr(model, f"name_{kind}adr")
        for i, inside_of in enumerate(bodies):
            if inside_of not in inside or (kind == "body" and i == body):
                continue
            name = model.names[names[i]:].split(b"\0", 1)[0].decode().removeprefix(prefix)
            direction = turn @ turns[i].reshape(3, -1)
            numbers = [turn @ (positions[i] - at), direction.ravel()]
            if kind in ("geom", "site"):
                count = SIZES.get(int(getattr(model, f"{kind}_type")[i]), 3)
                numbers.append(getattr(model, f"{kind}_size")[i][:count])
            found[kind, name] = np.concatenate(numbers)
    return found


def attach(file):
    """The model of an object which `thing` of the file is attached to."""
    spec = mjforge.Spec({
        "mjforge": 1, "name": "held", "joints": "none",
        "parts": [{"name": "palm", "type": "sphere", "size": 0.01, "mass": 1}],
        "bodies": [{"name": "it", "mjcf": str(file), "body": "thing"}]})
    return spec.variants(seed=0)[0].load()


def command(file):
    """The command in the hint that mjforge gives for the file."""
    try:
        attach(file)
    except (mjforge.SpecError, mjforge.VariantError) as error:
        hint = error.findings[0].hint
        return hint.partition(": ")[2].rpartition("; mjforge built")[0]
    raise AssertionError("mjforge attaches the file as it is")


def attached(folder, text):
    """(the file's own model, that of an object which `thing` is attached to)"""
    file = folder / "file.xml"
    file.write_text(text, encoding="utf-8")
    path = f"{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}"
    subprocess.run(command(file), shell=True, check=True, env={**os.environ, "PATH": path})
    return mujoco.MjModel.from_xml_string(text), attach(folder / "file-flat.xml")


def compare(folder, seed):
    own, model = attached(folder, Drawn(seed).text)
    meant = places(own, "", own.body("thing").id)
    seen = places(model, "held_it_", model.body("held_it").id)
    expect(seen.keys() == meant.keys(), f"not in both: {sorted(seen.keys() ^ meant.keys())[:5]}")
    for key, numbers in meant.items():
        difference = np.max(np.abs(seen[key] - numbers))
        expect(difference < TOLERANCE, f"{key} of seed {seed} differs by {difference}")
    return f"{len(meant)} elements"


def names(model, kind, prefix):
    starts = getattr(model, f"name_{kind}adr")
    found = [model.names[start:].split(b"\0", 1)[0].decode() for start in starts]
    return [name.removeprefix(prefix) for name in found if name.startswith(prefix)]


def compare_referring(folder):
    own, model = attached(folder, REFERRING)
    counts = {"jnt": 10, "exclude": 3, "pair": 6, "eq": 3, "tendon": 6, "actuator": 13, "sensor": 10}
    for kind, count in counts.items():
        meant, seen = names(own, kind, ""), names(model, kind, "held_it_")
        expect(seen == meant, f"{kind}: {seen}, not {meant}")
        expect(len(meant) == count, f"{kind}: {meant}")
    expect((model.actuator_trnid[:, 0] == own.actuator_trnid[:, 0]).all(), "actuators move others")
    expect((model.sensor_objid == own.sensor_objid).all(), "sensors read others")
    return f"{sum(counts.values())} names"


with tempfile.TemporaryDirectory() as made:
    for seed in SEEDS:
        check(f"mujoco {mujoco.__version__} frames {seed}", compare, pathlib.Path(made), seed)
    check(f"mujoco {mujoco.__version__} replicate", compare_referring, pathlib.Path(made))
finish()
