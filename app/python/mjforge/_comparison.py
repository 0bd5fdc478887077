"""Comparison of a model that the user's MuJoCo compiled with the record of its variant."""

from __future__ import annotations

import dataclasses
import xml.parsers.expat
from typing import Any, Iterator, Mapping, Optional

# Kinds of elements with names, by tag, in sections with several kinds of elements.
_KINDS = {
    "worldbody": {tag: tag for tag in ("body", "joint", "geom", "site", "camera", "light")}
    | {"freejoint": "joint"},
    "asset": {tag: tag for tag in ("mesh", "texture", "material", "hfield", "skin")},
    "contact": {tag: tag for tag in ("pair", "exclude")},
    "custom": {tag: tag for tag in ("numeric", "text", "tuple")},
}
# Kind of the elements in each section with a single kind.
_SECTIONS = {"equality": "equality", "tendon": "tendon", "actuator": "actuator", "sensor": "sensor",
             "keyframe": "key"}

START = "_start"  # suffix of the name of the keyframe with the start state


@dataclasses.dataclass
class Element:
    """A named element of an MJCF file."""

    kind: str  # as in MuJoCo's mjtObj: "joint"
    name: str
    attributes: Mapping[str, str]
    line: int
    column: int


def elements_of(xml_bytes: bytes) -> list[Element]:
    """Returns the named elements, in the order of the file. Raises ValueError if the file is not
    XML.
    """
    elements: list[Element] = []
    path: list[str] = []
    parser = xml.parsers.expat.ParserCreate()

    def start(tag: str, attributes: dict[str, str]) -> None:
        path.append(tag)
        if len(path) < 3 or "name" not in attributes:
            return
        section = path[1]
        kind = _KINDS[section].get(tag) if section in _KINDS else None
        if section in _SECTIONS and len(path) == 3:
            kind = _SECTIONS[section]
        if kind is not None:
            elements.append(Element(kind, attributes["name"], attributes, parser.CurrentLineNumber,
                                    parser.CurrentColumnNumber + 1))

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: path.pop()
    try:
        parser.Parse(xml_bytes, True)
    except xml.parsers.expat.ExpatError as error:
        raise ValueError(f"it is not XML: {error}") from None
    return elements


@dataclasses.dataclass
class Difference:
    """A difference between a compiled model and its record."""

    message: str
    element: Optional[Element] = None
    code: str = "mujoco/mismatch"


# Tolerances of the bounding box, as shares of the size: distances from the true solid of the faces
# of render meshes (facets), and of the pieces that collide.
FACETS = 0.02
PIECES = 0.05


class Comparison:
    """Compares a compiled model with its record and with the names in its MJCF file.

    `tolerance` is relative to the mass, to the size and to their products. Masses, bounds and
    inertia are those of the whole object at the start state, in the frame that the root has before
    the root's own joints move it.
    """

    def __init__(self, mujoco: Any, model: Any, record: Mapping[str, Any], file: bytes,
                 tolerance: float) -> None:
        import numpy

        self.np = numpy
        self.mujoco = mujoco
        self.model = model
        self.record = record
        self.elements = elements_of(file)
        self.tolerance = tolerance
        box = numpy.array([record["aabb"]["min"], record["aabb"]["max"]])
        self.size = float(numpy.linalg.norm(box[1] - box[0]))
        self.differences: list[Difference] = []

    def run(self) -> list[Difference]:
        """Returns all differences. If numbers or names of elements differ, compares nothing else.
        """
        self._counts_and_names()
        if self.differences:
            return self.differences
        data = self.mujoco.MjData(self.model)
        key = self._start_key()
        if key is not None:
            number = self.mujoco.mj_name2id(self.model, self.mujoco.mjtObj.mjOBJ_KEY, key.name)
            self.mujoco.mj_resetDataKeyframe(self.model, data, number)
        self.mujoco.mj_kinematics(self.model, data)
        # Rounding errors of positions are proportional to the largest position.
        reach = self.np.abs(self._in_object(data.geom_xpos[self.model.geom_bodyid > 0]))
        self.size = max(self.size, float(reach.max(initial=0)))
        self._masses(data)
        if not self.record.get("declared_bounds"):
            self._bounds(data)
        self._start(data)
        return self.differences

    def _start_key(self) -> Optional[Element]:
        """Returns the keyframe with the start state; None if the file has no such keyframe."""
        return next((e for e in self.elements if e.kind == "key" and e.name.endswith(START)), None)

    def _root(self) -> Optional[Element]:
        return next((e for e in self.elements if e.kind == "body"), None)

    def _compare(self, what: str, compiled: Any, meant: Any, scale: float, allowed: float = 0,
                 element: Optional[Element] = None) -> None:
        error = self.tolerance * scale + allowed
        if not self.np.allclose(compiled, meant, rtol=0, atol=error):
            self._differ(what, compiled, meant, element or self._root())

    def _differ(self, what: str, compiled: Any, meant: Any, element: Optional[Element]) -> None:
        self.differences.append(
            Difference(f"the {what} is {_text(compiled)}, not {_text(meant)}", element))

    def _counts_and_names(self) -> None:
        for what, name in (("bodies", "nbody"), ("joints", "njnt"), ("geoms", "ngeom")):
            self._compare(f"number of {what}", getattr(self.model, name), self.record[name], 0)
        for element in self.elements:
            kind = getattr(self.mujoco.mjtObj, f"mjOBJ_{element.kind.upper()}")
            if self.mujoco.mj_name2id(self.model, kind, element.name) < 0:
                self.differences.append(
                    Difference(f"there is no {element.kind} {element.name!r}", element))

    def _in_object(self, points: Any) -> Any:
        """Converts points from the world to the object's frame; in a scene, the object rests on the
        floor.
        """
        is_scene = self.record.get("target") == "scene"
        return points + [0, 0, self.record["aabb"]["min"][2] if is_scene else 0]

    def _masses(self, data: Any) -> None:
        np, record, masses = self.np, self.record, self.model.body_mass[1:]
        mass = float(masses.sum())
        # A body without mass has mjMINVAL in the file.
        self._compare("mass", mass, record["mass"], record["mass"], 1e-15 * self.model.nbody)
        if not record["mass"] > 0:
            return
        positions = self._in_object(data.xipos[1:])
        com = masses @ positions / mass
        self._compare("center of mass", com, record["com"], self.size)
        axes = data.ximat[1:].reshape(-1, 3, 3)
        arms = positions - com
        tensors = np.einsum("bik,bk,bjk->bij", axes, self.model.body_inertia[1:], axes)
        tensors += masses[:, None, None] * (
            np.einsum("bk,bk->b", arms, arms)[:, None, None] * np.eye(3)
            - np.einsum("bi,bj->bij", arms, arms))
        xx, yy, zz, xy, xz, yz = record["inertia"]
        # MuJoCo 2.2 stops diagonalizing at off-diagonal terms of 1e-12 kg m^2.
        self._compare("inertia", tensors.sum(axis=0), [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]],
                      mass * self.size**2, 2e-12)

    def _boxes(self, data: Any) -> Iterator[tuple[int, Any, Any]]:
        """Yields the id, center and half sizes of the bounding box of each geom of the object, in
        the object's frame.
        """
        np, model, types = self.np, self.model, self.mujoco.mjtGeom
        centers = self._in_object(data.geom_xpos)
        axes = data.geom_xmat.reshape(-1, 3, 3)
        for geom in np.flatnonzero(model.geom_bodyid):
            kind, size, turn = model.geom_type[geom], model.geom_size[geom], axes[geom]
            z = turn[:, 2]
            if kind == types.mjGEOM_SPHERE:
                half = np.full(3, size[0])
            elif kind == types.mjGEOM_CAPSULE:
                half = size[0] + np.abs(z) * size[1]
            elif kind == types.mjGEOM_CYLINDER:
                half = size[0] * np.sqrt(np.maximum(0, 1 - z * z)) + np.abs(z) * size[1]
            elif kind == types.mjGEOM_ELLIPSOID:
                half = np.linalg.norm(turn * size, axis=1)
            elif kind == types.mjGEOM_BOX:
                half = np.abs(turn) @ size
            elif kind == types.mjGEOM_MESH:
                mesh = model.geom_dataid[geom]
                first = model.mesh_vertadr[mesh]
                corners = model.mesh_vert[first:first + model.mesh_vertnum[mesh]] @ turn.T
                low, high = corners.min(axis=0), corners.max(axis=0)
                yield int(geom), centers[geom] + (low + high) / 2, (high - low) / 2
                continue
            else:
                continue  # planes and height fields have no bounds
            yield int(geom), centers[geom], half

    def _bounds(self, data: Any) -> None:
        """Compares the recorded bounding box, which is that of the true solid. Each face of the box
        must be near a face of the bounding box of some geom (FACETS), and must not be farther
        inside the bounds of the colliding geoms than PIECES. Geoms without contact bits count, too,
        because a part may collide only in a `<pair>`.
        """
        np, model = self.np, self.model
        boxes = list(self._boxes(data))
        if not boxes:
            return
        ids = [geom for geom, _, _ in boxes]
        # Positions of the faces of each box: the lower faces with changed signs, then the upper
        # faces.
        faces = np.array([np.concatenate((half - center, half + center)) for _, center, half in boxes])
        collide = (model.geom_contype[ids] | model.geom_conaffinity[ids]) != 0
        colliding = faces[collide if collide.any() else slice(None)].max(axis=0)
        box = self.record["aabb"]
        meant = np.concatenate((-np.array(box["min"]), box["max"]))
        is_face = np.abs(faces - meant).min(axis=0) <= FACETS * self.size
        if not (is_face & (meant >= colliding - PIECES * self.size)).all():
            self._differ("bounding box", np.stack((-colliding[:3], colliding[3:])),
                         [box["min"], box["max"]], self._root())

    def _start(self, data: Any) -> None:
        """Checks the start state, which is that of the keyframe that mjforge writes; without a
        keyframe, all joints are at zero.
        """
        mujoco, model, np = self.mujoco, self.model, self.np
        start = self._start_key()
        element = start or self._root()
        if start is not None:
            key = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_KEY, start.name)
            meant = [float(number) for number in start.attributes.get("qpos", "").split()]
            if meant:
                self._compare("qpos of the start state", model.key_qpos[key], meant, 1, 0, element)
            mujoco.mj_resetDataKeyframe(model, data, key)
        mujoco.mj_forward(model, data)
        raised = [mujoco.mjtWarning(i).name for i in range(len(data.warning)) if data.warning[i].number]
        if raised or not (np.isfinite(data.qpos).all() and np.isfinite(data.qacc).all()):
            words = f"the warning {', '.join(raised)}" if raised else "numbers that are not finite"
            self.differences.append(Difference(f"the start state has {words}", element, "mujoco/warning"))


def _text(value: Any) -> str:
    """Returns a number or a nested list of numbers as text: "[0.1, 2]"."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, list):
        return "[" + ", ".join(map(_text, value)) + "]"
    return f"{value:.9g}" if isinstance(value, float) else str(value)
