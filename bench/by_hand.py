"""The calls of MjSpec that make an object, with all numbers at hand."""

from typing import Any, Callable, Mapping, Optional

import mujoco
from mjforge._members import elements

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


# Arguments of MuJoCo that are names of elements.
_NAMES = {"name", "material", "meshname"}
_SOLIMP = _padded(0.9, 0.95, 0.001, 0.5, 2)


class _Tables:
    """The tables for the release of MuJoCo."""

    def __init__(self) -> None:
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
        self.material = _Table("name rgba emission specular shininess reflectance texrepeat",
                               {"texuniform": ("texuniform", _boolean)})
        self.texture = _Table("name rgb1 rgb2 random markrgb width height",
                              {"type": ("type", words("mjtTexture", "mjTEXTURE_")),
                               "builtin": ("builtin", words("mjtBuiltin", "mjBUILTIN_")),
                               "mark": ("mark", words("mjtMark", "mjMARK_"))})
        self.mesh = _Table("name scale", {
            "vertex": ("uservert", _list), "normal": ("usernormal", _list), "texcoord": ("usertexcoord", _list),
            "face": ("userface", _list), "smoothnormal": ("smoothnormal", _boolean)})
        self.rgb = mujoco.mjtTextureRole.mjTEXROLE_RGB


def _arguments(attributes: dict[str, Any], table: _Table, prefix: str) -> dict[str, Any]:
    """Changes the attributes to arguments for MuJoCo, and returns them. Names get the prefix."""
    if not table.known.issuperset(attributes):
        raise KeyError(str(attributes))
    for name, (known, convert) in table.others.items():
        if name in attributes:
            value = attributes.pop(name)
            attributes[known] = value if convert is None else convert(value)
    for name in _NAMES.intersection(attributes):
        attributes[name] = prefix + attributes[name]
    return attributes


class ByHand:
    """The calls of MjSpec that make the object of a variant, with all numbers at hand: a lower bound
    for a program that draws and computes them. It adds to the scene itself, without an attachment.
    The object stands at a place, and its names have a prefix, as those of Variant.attach.
    """

    def __init__(self, variant, prefix, place):
        self.assets, self.bodies, self.prefix = [], [], prefix
        tables = _Tables()
        root = elements(variant.xml_bytes)
        for tag, attributes, children in root[2]:
            if tag == "asset":
                for kind, its, _ in children:
                    texture = prefix + its.pop("texture") if "texture" in its else None
                    self.assets.append((kind, _arguments(its, getattr(tables, kind), prefix), texture))
            elif tag == "worldbody":
                self.bodies = [self._body(tables, *child) for child in children]
            elif tag not in ("compiler", "keyframe"):  # keyframes do not come into a scene
                raise KeyError(tag)
        self.rgb = tables.rgb
        for body in self.bodies:
            body[0]["pos"] = [a + b for a, b in zip(body[0]["pos"], place)]

    def _body(self, tables, _, attributes, children):
        inertial, elements, inner = {}, [], []
        for tag, its, below in children:
            if tag == "body":
                inner.append(self._body(tables, tag, its, below))
            elif tag == "inertial":
                inertial = _arguments(its, tables.inertial, self.prefix)
            else:
                elements.append((tag, _arguments(its, getattr(tables, tag), self.prefix)))
        return _arguments(attributes, tables.body, self.prefix), inertial, elements, inner

    def add_to(self, scene):
        for kind, arguments, texture in self.assets:
            made = getattr(scene, "add_" + kind)(**arguments)
            if texture is not None:
                made.textures[self.rgb] = texture
        for body in self.bodies:
            self._add(scene.worldbody, body)

    def _add(self, parent, body):
        arguments, inertial, elements, inner = body
        made = parent.add_body(**arguments)
        if inertial:
            made.explicitinertial = True
            for name, value in inertial.items():
                setattr(made, name, value)
        for tag, its in elements:
            getattr(made, "add_" + tag)(**its)
        for each in inner:
            self._add(made, each)
