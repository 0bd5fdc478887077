"""An object of a family in a scene: ids of its elements in the scene's model, and its pose."""

from __future__ import annotations

import difflib
from typing import TYPE_CHECKING, Any

from ._attach import _module_of
from ._library import c_text
from ._poses import Poses, compose, without

if TYPE_CHECKING:
    from mujoco import MjModel  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._family import Family

# Kind of element by the first word of a field's name: the name in mjtObj, and the count in mjModel.
_KINDS = {"body": ("BODY", "nbody"), "geom": ("GEOM", "ngeom"), "jnt": ("JOINT", "njnt"),
          "dof": ("JOINT", "njnt"), "qpos0": ("JOINT", "njnt"), "qpos": ("JOINT", "njnt"),
          "site": ("SITE", "nsite"), "cam": ("CAMERA", "ncam"), "light": ("LIGHT", "nlight"),
          "mat": ("MATERIAL", "nmat"), "mesh": ("MESH", "nmesh"), "pair": ("PAIR", "npair"),
          "eq": ("EQUALITY", "neq"), "tendon": ("TENDON", "ntendon"), "actuator": ("ACTUATOR", "nu"),
          "wrap": ("TENDON", "ntendon"), "sensor": ("SENSOR", "nsensor"), "numeric": ("NUMERIC", "nnumeric"),
          "tuple": ("TUPLE", "ntuple")}
# Positions of the first numbers of joints, tendons and other elements that have several, by the first word of a
# field's name.
_ADDRESSES = {"dof": "jnt_dofadr", "qpos0": "jnt_qposadr", "qpos": "jnt_qposadr", "wrap": "tendon_adr",
              "numeric": "numeric_adr", "tuple": "tuple_adr"}
# Kinds of elements that the object must have in the scene, and the field that must be equal there.
_CHECKED = (("body", None), ("jnt", "jnt_type"), ("geom", "geom_type"), ("site", "site_type"), ("mat", None),
            ("tendon", None), ("actuator", "actuator_trntype"))


class Placed:
    """An object of a family in a scene. Elements are given by their ids in the base; `ids` has
    their ids in the scene.
    """

    def __init__(self, family: Family, model: MjModel, prefix: str) -> None:
        import numpy as np

        self._np = np
        self._mujoco = _module_of(model)
        self.family = family
        self.base = family._compiled()
        self.model = model
        self.prefix = prefix
        self.mesh_type = int(self._mujoco.mjtGeom.mjGEOM_MESH)
        self.types = self._mujoco.mjtEq
        self.free_type = int(self._mujoco.mjtJoint.mjJNT_FREE)
        self._known: dict[str, Any] = {}
        self._expect_object()

    def id_of(self, model: MjModel, kind: str, name: str) -> int:
        """Returns the id of an element by its name; -1 if the model has no such element."""
        return int(self._mujoco.mj_name2id(model, getattr(self._mujoco.mjtObj, f"mjOBJ_{_KINDS[kind][0]}"), name))

    def _name_of(self, model: MjModel, kind: str, number: int) -> str:
        return self._mujoco.mj_id2name(model, getattr(self._mujoco.mjtObj, f"mjOBJ_{_KINDS[kind][0]}"), number) or ""

    def names(self, kind: str) -> list[str]:
        """Returns the names of all elements of the base, empty for elements without a name."""
        return [self._name_of(self.base, kind, i) for i in range(getattr(self.base, _KINDS[kind][1]))]

    def ids(self, kind: str) -> Any:
        """Returns the id in the scene of each element of the base; -1 if the element is not in the
        scene.
        """
        if kind not in self._known:
            found = [self.id_of(self.model, kind, self.prefix + name) if name else -1 for name in self.names(kind)]
            if kind == "body":
                found[0] = self._parent_of_roots(found)
            self._known[kind] = self._np.array(found, dtype=int)
            if kind in ("pair", "eq"):
                self._find_unnamed(kind)
        return self._known[kind]

    def _parent_of_roots(self, bodies: list[int]) -> int:
        """Returns the body of the scene to which the roots of the base are attached."""
        roots = [i for i in range(1, self.base.nbody) if self.base.body_parentid[i] == 0 and bodies[i] > 0]
        return int(self.model.body_parentid[bodies[roots[0]]]) if roots else 0

    def _find_unnamed(self, kind: str) -> None:
        """Finds pairs and equalities without names by the elements that they connect, in their
        order.
        """
        ours, theirs = self._ends(kind, self.base), self._ends(kind, self.model)
        taken = set(self._known[kind].tolist())
        for number, ends in enumerate(ours):
            if self._known[kind][number] >= 0:
                continue
            mapped = self._mapped(kind, ends)
            match = next((i for i, other in enumerate(theirs) if other == mapped and i not in taken), -1)
            self._known[kind][number] = match
            taken.add(match)

    @staticmethod
    def _ends(kind: str, model: MjModel) -> "list[tuple[int, ...]]":
        if kind == "pair":
            return [(0, int(a), int(b)) for a, b in zip(model.pair_geom1, model.pair_geom2)]
        return [(int(t), int(a), int(b)) for t, a, b in zip(model.eq_type, model.eq_obj1id, model.eq_obj2id)]

    def _mapped(self, kind: str, ends: "tuple[int, ...]") -> "tuple[int, ...]":
        types = self._mujoco.mjtEq
        of = {int(types.mjEQ_JOINT): "jnt", int(types.mjEQ_TENDON): "tendon"}
        what = "geom" if kind == "pair" else of.get(ends[0], "body")
        return (ends[0], *(int(self.ids(what)[i]) if i >= 0 else i for i in ends[1:]))

    def _expect_object(self) -> None:
        """Raises ValueError if elements of the base are missing in the scene, or have another type
        there.
        """
        for kind, field in _CHECKED:
            there = self.ids(kind)
            for number, name in enumerate(self.names(kind)):
                if not name or (kind == "body" and number == 0):
                    continue
                if there[number] < 0:
                    raise ValueError(self._missing(kind, name))
                if field is None:
                    continue
                mine, other = getattr(self.base, field)[number], getattr(self.model, field)[there[number]]
                if mine != other:
                    raise ValueError(f"prefix={self.prefix!r}: '{self.prefix}{name}' has the {field} {other} in the "
                                     f"model and {mine} in '{self.family.path}': it is not the base of this family")

    def _missing(self, kind: str, name: str) -> str:
        bodies = [self._name_of(self.model, "body", i) for i in range(1, self.model.nbody)]
        root = next(filter(None, self.names("body")[1:]), "")
        has_root = self.prefix + root in bodies
        meant = sorted(body[:len(body) - len(root)] for body in bodies if root and body.endswith(root))
        words = {"jnt": "joint", "mat": "material"}.get(kind, kind)
        message = f"prefix={self.prefix!r}: the model has no {words} '{self.prefix}{name}'"
        if has_root:
            return f"{message}, which '{self.family.path}' has"
        close = difflib.get_close_matches(self.prefix, meant, 1, 0) or meant[:1]
        if close:
            return f"{message}; did you mean {close[0]!r}?"
        return f"{message}: attach the base of the family to the scene"

    def elements(self, field: str) -> Any:
        """Returns the ids in the base of the elements in an array of the family's file."""
        members = self.family._file.members
        kind = field.partition("_")[0]
        all_names = self.names(kind)
        names = members[f"{field}.names"].tolist()
        if "" in names and names.count("") != all_names.count(""):
            raise ValueError(f"'{self.family.path}': {field} has {names.count('')} of {all_names.count('')} elements "
                             "without names: give them names in the spec")
        unnamed = (i for i, name in enumerate(all_names) if not name)
        numbers = {name: i for i, name in enumerate(all_names)}
        if strange := sorted(set(names) - numbers.keys()):
            raise ValueError(f"'{self.family.path}' was changed: {field} has '{strange[0]}', which is not in its base")
        return self._np.array([numbers[name] if name else next(unnamed) for name in names], dtype=int)

    def coordinates(self, field: str) -> "tuple[Any, Any]":
        """Returns the positions, in the arrays of the base and of the scene, of the numbers in a
        field of which elements have several: degrees of freedom, wraps of tendons and so on.
        """
        kind = field.partition("_")[0]
        address, mine = _ADDRESSES[kind], self.elements(field)
        component = self.family._file.members[f"{field}.components"]
        return (getattr(self.base, address)[mine] + component,
                getattr(self.model, address)[self.found(kind, mine)] + component)

    def found(self, kind: str, mine: Any) -> Any:
        """Returns the ids in the scene of elements of the base. Raises ValueError if one is missing."""
        there = self.ids(kind)[mine]
        if (there < 0).any():
            name = self.names(kind)[mine[there < 0][0]]
            raise ValueError(f"prefix={self.prefix!r}: the model has no {kind} '{self.prefix}{name}'")
        return there

    def frames(self, kind: str, elements: Any) -> Poses:
        """Returns, for each of these elements of the base, the pose of the base's world in the
        frame of the element's parent in the scene. The pose is the identity if the parent is a body
        of the object.
        """
        np = self._np
        parents = getattr(self.base, "body_parentid" if kind == "body" else f"{kind}_bodyid")[elements]
        pos, quat = np.zeros((len(elements), 3)), np.tile([1.0, 0, 0, 0], (len(elements), 1))
        for at in np.flatnonzero(parents == 0):
            if kind == "light":
                pos[at], quat[at] = self.frame_of_roots()
                continue
            mine, there = elements[at], self.ids(kind)[elements[at]]
            pos[at], quat[at] = without(
                (getattr(self.model, f"{kind}_pos")[there], getattr(self.model, f"{kind}_quat")[there]),
                (getattr(self.base, f"{kind}_pos")[mine], getattr(self.base, f"{kind}_quat")[mine]))
        return pos, quat

    def frame_of_roots(self) -> Poses:
        """Returns the pose of the base's world in the frame of the object's parent in the scene."""
        roots = self._np.flatnonzero(self.base.body_parentid == 0)[1:2]
        if not len(roots):
            return self._np.zeros(3), self._np.array([1.0, 0, 0, 0])
        pos, quat = self.frames("body", roots)
        return pos[0], quat[0]

    def place_free(self, joint: int, qpos: Any, out: Any) -> None:
        """Converts the pose of a free body from the world of the base (`qpos`) to the world of the
        scene (`out`), with one row for each world.
        """
        np = self._np
        body = self.base.jnt_bodyid[joint]
        first, there = self.base.jnt_qposadr[joint], self.model.jnt_qposadr[self.ids("jnt")[joint]]
        pos, quat = compose(self.frames("body", np.array([body])),
                            (qpos[:, first:first + 3], qpos[:, first + 3:first + 7]))
        out[:, there:there + 3], out[:, there + 3:there + 7] = pos, quat
