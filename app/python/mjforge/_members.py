"""Joints, sites and the start pose of an object, read from its MJCF file."""

from __future__ import annotations

import dataclasses
from typing import Any, Optional, Union

from ._json import loads
from ._library import bytes_of, library

# Position of a joint: rad or m for a hinge or slide, a quaternion for a ball joint, pos and quat
# for a free joint.
Position = Union[float, tuple[float, ...]]
# An element of an MJCF file: tag, attributes, children.
Element = list[Any]

_START = "_start"  # suffix of the name of the keyframe with the start state


def elements(xml: bytes) -> Element:
    """Returns the root element of an MJCF file. Attributes that consist of numbers become a number
    or a list. Raises ValueError if the text is not XML.
    """
    said = bytes_of(library.MjforgeElements(xml, len(xml)))
    if not said:
        raise ValueError("it is not XML")
    root: Element = loads(said)
    return root


def section(root: Element, tag: str) -> list[Element]:
    """Returns the elements in a section of a file ("worldbody"); empty if the file has no such
    section.
    """
    return next((children for name, _, children in root[2] if name == tag), [])


@dataclasses.dataclass(frozen=True)
class Joint:
    """A joint of an object. Frames and units are those of MJCF (m, rad)."""

    name: str
    type: str  # "free", "ball", "slide" or "hinge"
    body: str
    range: Optional[tuple[float, float]]  # None if unlimited
    start: Position


@dataclasses.dataclass(frozen=True)
class Site:
    """A site of an object, in the frame of its body (m)."""

    name: str
    body: str
    pos: tuple[float, ...]
    quat: tuple[float, ...]


@dataclasses.dataclass
class Members:
    """Joints, sites and actuators of an object. Joints are in the order of MuJoCo's qpos, sites in
    the order of the file.
    """

    root: str = ""  # name of the first body
    root_pose: tuple[float, ...] = ()  # start pos and quat of the first body in the object's frame
    root_joint: Optional[str] = None  # name of the free joint of the first body
    joints: dict[str, Joint] = dataclasses.field(default_factory=dict)
    sites: dict[str, Site] = dataclasses.field(default_factory=dict)
    actuators: list[str] = dataclasses.field(default_factory=list)
    key: dict[str, list[float]] = dataclasses.field(default_factory=dict)  # start qvel, act, ctrl


_WIDTHS = {"free": 7, "ball": 4}  # numbers of a joint in qpos; a hinge or slide has one


def _list(value: Any) -> list[float]:
    return value if isinstance(value, list) else [value]


def _pose(attributes: dict[str, Any]) -> tuple[float, ...]:
    return (*attributes.get("pos", (0.0, 0.0, 0.0)), *attributes.get("quat", (1.0, 0.0, 0.0, 0.0)))


def members_of(root: Element) -> Members:
    """Returns the members of an object, given the elements of a file that mjforge wrote."""
    found = Members()
    for tag, attributes, children in section(root, "worldbody"):
        if tag == "body":
            _read_body(attributes, children, found)
    found.actuators = [str(attributes.get("name")) for _, attributes, _ in section(root, "actuator")]
    for tag, attributes, _ in section(root, "keyframe"):
        if tag == "key" and str(attributes.get("name", "")).endswith(_START):
            _read_start({name: _list(value) for name, value in attributes.items()}, found)
    return found


def _read_body(attributes: dict[str, Any], children: list[Element], found: Members) -> None:
    name = str(attributes.get("name", ""))
    is_root = not found.root and name != ""  # robosuite's files have a body without a name around it
    if is_root:
        found.root, found.root_pose = name, _pose(attributes)
    for tag, its, _ in children:
        if tag in ("joint", "freejoint"):
            joint = _joint("free" if tag == "freejoint" else its.get("type", "hinge"), its, attributes, name)
            found.joints[joint.name] = joint
            if is_root and joint.type == "free":
                found.root_joint = joint.name
        elif tag == "site":
            pose = tuple(map(float, _pose(its)))
            found.sites[str(its.get("name"))] = Site(str(its.get("name")), name, pose[:3], pose[3:])
    for tag, its, inner in children:
        if tag == "body":
            _read_body(its, inner, found)


def _joint(kind: str, attributes: dict[str, Any], body: dict[str, Any], body_name: str) -> Joint:
    start: Position = float(attributes.get("ref", 0.0))
    if kind == "free":
        start = tuple(map(float, _pose(body)))
    elif kind == "ball":
        start = (1.0, 0.0, 0.0, 0.0)
    limits = attributes.get("range") if attributes.get("limited") != "false" else None
    return Joint(str(attributes.get("name")), kind, body_name,
                 (float(limits[0]), float(limits[1])) if limits else None, start)


def _read_start(key: dict[str, list[float]], found: Members) -> None:
    """Sets the start positions of joints to those of the keyframe."""
    found.key = {name: key[name] for name in ("qvel", "act", "ctrl") if name in key}
    qpos = key.get("qpos")
    if qpos is None:
        return
    first = 0
    for name, joint in found.joints.items():
        numbers = tuple(map(float, qpos[first:first + _WIDTHS.get(joint.type, 1)]))
        first += len(numbers)
        start = numbers if joint.type in _WIDTHS else numbers[0]
        found.joints[name] = dataclasses.replace(joint, start=start)
        if name == found.root_joint:
            found.root_pose = numbers
