"""Makes an MjSpec of an object with MuJoCo's own functions, from the elements of its MJCF file.

Parsing the text costs MuJoCo several times more. Elements and attributes that are not in the tables
below have no such MjSpec, and are parsed as text by the caller.
"""

from __future__ import annotations

import functools
from typing import Any, Callable, Mapping, Optional

from ._members import Element

# Attributes of an element that MuJoCo takes by the same name and as they are, and for all others the
# name in MuJoCo and the conversion of the value.
_Rule = tuple[str, Optional[Callable[[Any], Any]]]


class _Table:
    def __init__(self, same: str, others: Mapping[str, _Rule]) -> None:
        self.others = others
        self.known = frozenset([*same.split(), *others])


def _list(value: Any) -> Any:
    return value if isinstance(value, list) else [value]


def _padded(*defaults: float) -> Callable[[Any], Any]:
    """A vector whose last numbers may be left out of the file."""
    def pad(value: Any) -> Any:
        numbers = _list(value)
        return [*numbers, *defaults[len(numbers):]] if len(numbers) < len(defaults) else numbers
    return pad


def _boolean(value: str) -> bool:
    return {"true": True, "false": False}[value]


_SOLIMP = _padded(0.9, 0.95, 0.001, 0.5, 2)


class _Tables:
    """The tables for a release of MuJoCo."""

    def __init__(self, mujoco: Any) -> None:
        def words(enum: str, prefix: str) -> Callable[[Any], Any]:
            values = getattr(mujoco, enum).__members__
            known = {name[len(prefix):].lower(): value for name, value in values.items()}
            return known.__getitem__

        shape: dict[str, _Rule] = {"type": ("type", words("mjtGeom", "mjGEOM_"))}
        self.geom = _Table(
            "name pos quat rgba group material contype conaffinity condim priority mass density solmix solref "
            "margin gap", {**shape, "size": ("size", _padded(0, 0, 0)), "mesh": ("meshname", None),
                           "friction": ("friction", _padded(1, 0.005, 0.0001)), "solimp": ("solimp", _SOLIMP)})
        self.site = _Table("name pos quat rgba group material",
                           {**shape, "size": ("size", _padded(0.005, 0.005, 0.005))})
        self.body = _Table("name pos quat", {})
        self.inertial = _Table("mass", {"pos": ("ipos", None), "quat": ("iquat", None),
                                        "diaginertia": ("inertia", None)})
        # Damping and stiffness are polynomials in later releases.
        joint = mujoco.MjSpec().worldbody.add_body().add_joint()
        power = None if isinstance(joint.damping, float) else _padded(0, 0, 0)
        self.joint = _Table(
            "name pos axis range ref armature frictionloss springref margin group",
            {"type": ("type", words("mjtJoint", "mjJNT_")), "limited": ("limited", _boolean),
             "damping": ("damping", power), "stiffness": ("stiffness", power),
             "solimpfriction": ("solimp_friction", _SOLIMP), "solimplimit": ("solimp_limit", _SOLIMP),
             "solreffriction": ("solref_friction", None), "solreflimit": ("solref_limit", None)})
        self.material = _Table("name rgba specular shininess reflectance texrepeat",
                               {"texuniform": ("texuniform", _boolean)})
        self.texture = _Table("name rgb1 rgb2 random markrgb width height",
                              {"type": ("type", words("mjtTexture", "mjTEXTURE_")),
                               "builtin": ("builtin", words("mjtBuiltin", "mjBUILTIN_")),
                               "mark": ("mark", words("mjtMark", "mjMARK_"))})
        self.mesh = _Table("name scale", {
            "vertex": ("uservert", _list), "normal": ("usernormal", _list), "texcoord": ("usertexcoord", _list),
            "face": ("userface", _list), "smoothnormal": ("smoothnormal", _boolean)})
        self.equality = _Table("name solref", {"joint1": ("name1", None), "joint2": ("name2", None),
                                               "polycoef": ("data", None), "solimp": ("solimp", _SOLIMP)})
        self.exclude = _Table("name", {"body1": ("bodyname1", None), "body2": ("bodyname2", None)})
        self.rgb = mujoco.mjtTextureRole.mjTEXROLE_RGB
        self.equality_data = list(mujoco.MjSpec().add_equality().data)
        self.joints = mujoco.mjtEq.mjEQ_JOINT


_tables = functools.lru_cache(maxsize=8)(_Tables)


def _arguments(attributes: dict[str, Any], table: _Table) -> dict[str, Any]:
    """Changes the attributes to arguments for MuJoCo, and returns them."""
    if not table.known.issuperset(attributes):
        raise KeyError(str(attributes))
    for name, (known, convert) in table.others.items():
        if name in attributes:
            value = attributes.pop(name)
            attributes[known] = value if convert is None else convert(value)
    return attributes


def child_of(mujoco: Any, root: Element) -> Any:
    """An MjSpec of the object, without its keyframe; None if the tables do not have all of it."""
    child = mujoco.MjSpec()
    child.compiler.degree = False
    try:
        builder = _Builder(_tables(mujoco), child)
        for tag, attributes, children in root[2]:
            getattr(builder, "add_" + tag)(attributes, children)
    except (AttributeError, KeyError, TypeError, ValueError):
        return None
    return child


class _Builder:
    """Adds sections of a file to an MjSpec. Each `add_` has the tag of its section as its name."""

    def __init__(self, tables: _Tables, child: Any) -> None:
        self._tables = tables
        self._child = child

    def add_compiler(self, attributes: dict[str, Any], _: list[Element]) -> None:
        if attributes != {"angle": "radian", "usethread": "false"}:
            raise KeyError(str(attributes))

    # MuJoCo does not attach these three either: they belong to the scene.
    def add_option(self, *_: Any) -> None: ...
    def add_size(self, *_: Any) -> None: ...
    def add_keyframe(self, *_: Any) -> None: ...

    def add_asset(self, _: Any, children: list[Element]) -> None:
        child, tables = self._child, self._tables
        for tag, attributes, _inner in children:
            if tag == "material":
                texture = attributes.pop("texture", None)
                material = child.add_material(**_arguments(attributes, tables.material))
                if texture is not None:
                    material.textures[tables.rgb] = texture
            elif tag == "texture":
                values = _arguments(attributes, tables.texture)
                child.add_texture(**values)
            elif tag == "mesh":
                values = _arguments(attributes, tables.mesh)
                child.add_mesh(**values)
            else:
                raise KeyError(tag)

    def add_worldbody(self, _: Any, children: list[Element]) -> None:
        self._add_to(self._child.worldbody, children)

    def _add_to(self, body: Any, children: list[Element]) -> None:
        tables = self._tables
        for tag, attributes, inner in children:
            if tag == "geom":
                body.add_geom(**_arguments(attributes, tables.geom))
            elif tag == "site":
                body.add_site(**_arguments(attributes, tables.site))
            elif tag == "joint":
                body.add_joint(**_arguments(attributes, tables.joint))
            elif tag == "body":
                self._add_to(body.add_body(**_arguments(attributes, tables.body)), inner)
            elif tag == "inertial":
                body.explicitinertial = True
                for name, value in _arguments(attributes, tables.inertial).items():
                    setattr(body, name, value)
            else:
                raise KeyError(tag)

    def add_contact(self, _: Any, children: list[Element]) -> None:
        for tag, attributes, _inner in children:
            {"exclude": self._child.add_exclude}[tag](**_arguments(attributes, self._tables.exclude))

    def add_equality(self, _: Any, children: list[Element]) -> None:
        tables = self._tables
        for tag, attributes, _inner in children:
            values = {"joint": _arguments(attributes, tables.equality)}[tag]
            data = values["data"]
            values["data"] = data + tables.equality_data[len(data):]
            self._child.add_equality(type=tables.joints, **values)
