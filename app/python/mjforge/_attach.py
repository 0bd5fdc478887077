"""Adds a variant to a scene (MjSpec), and sets its joints to the start pose in a simulation."""

from __future__ import annotations

import contextlib
import importlib
import math
import re
from typing import TYPE_CHECKING, Any, Iterator, Protocol

from ._library import c_text
from ._members import Joint, Members

if TYPE_CHECKING:
    from mujoco import MjData, MjModel, MjsBody, MjSpec  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._variant import Variant



class Numbers(Protocol):
    """Numbers in a list, a tuple or an array of NumPy."""

    def __len__(self) -> int: ...

    def __iter__(self) -> Iterator[float]: ...


Pose = tuple[Any, Any]  # position and quaternion, arrays

# A body with a name: names of bodies are letters, digits and _. A search of the text takes a tenth of
# the time of walks through the bodies of a parsed MjSpec.
_NAMED_BODY = re.compile(rb'\n *<body name="(\w+)"')


def vector_of(value: Any, size: int, what: str) -> list[float]:
    """Returns an argument as a list of `size` finite numbers. `what` is the argument's name in the
    TypeError or ValueError.
    """
    try:
        numbers = list(map(float, value))
    except (TypeError, ValueError):
        raise TypeError(f"{what}={value!r} is not a list of {size} numbers") from None
    if isinstance(value, (str, bytes)) or len(numbers) != size or not all(map(math.isfinite, numbers)):
        raise ValueError(f"{what}={value!r} is not a list of {size} finite numbers")
    return numbers


def _unit(quat: Any) -> list[float]:
    numbers = vector_of(quat, 4, "quat")
    norm = math.hypot(*numbers)
    if norm < 1e-9:
        raise ValueError(f"quat={quat!r} is zero")
    return [number / norm for number in numbers]


def _require_type(thing: Any, name: str, what: str) -> None:
    if type(thing).__name__ != name or not type(thing).__module__.startswith("mujoco"):
        raise TypeError(f"{what}={thing!r} is not a mujoco.{name} but of type {type(thing).__name__}")


def _module_of(thing: Any) -> Any:
    """Returns the MuJoCo package to which a model or spec belongs."""
    return importlib.import_module(type(thing).__module__.partition(".")[0])


def _bottom(variant: Variant, quat: Numbers) -> float:
    """Returns the z, m, of the lowest point of the variant's bounding box at the start, turned by
    `quat`.
    """
    x_min, y_min, z_min, x_max, y_max, z_max = variant.standing_box
    w, x, y, z = quat
    # z of the turned axes
    along_x, along_y, along_z = 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)
    return (along_x * (x_max if along_x < 0 else x_min) + along_y * (y_max if along_y < 0 else y_min) +
            along_z * (z_max if along_z < 0 else z_min))


def _name_of_root(xml: bytes) -> str:
    """Returns the name of the first body with a name in an MJCF text that mjforge wrote; empty if no
    body has a name.
    """
    found = _NAMED_BODY.search(xml, xml.rfind(b"\n  <worldbody>"))
    return found[1].decode() if found else ""


def _without_keyframe(xml: bytes) -> str:
    """Returns an MJCF text without its keyframe, which mjforge writes as the last section."""
    if xml.endswith(b"\n  </keyframe>\n</mujoco>\n"):
        xml = xml[:xml.rindex(b"\n  <keyframe>")] + b"\n</mujoco>\n"
    return xml.decode()


@contextlib.contextmanager
def _without_files(scene: MjSpec) -> Iterator[None]:
    """Takes the files out of a scene (`MjSpec.assets`, a dict that MuJoCo itself uses) for the duration of
    a `with` block.
    """
    files = dict(scene.assets)
    scene.assets.clear()
    try:
        yield
    finally:
        scene.assets.update(files)


def attach(variant: Variant, scene: MjSpec, prefix: str, pos: Numbers, quat: Numbers,
           stand: bool) -> MjsBody:
    """Returns the object's first body in the scene; see Variant.attach."""
    _require_type(scene, "MjSpec", "scene")
    c_text(prefix, "prefix")
    place, turn = vector_of(pos, 3, "pos"), _unit(quat)
    if not isinstance(stand, bool):
        raise TypeError(f"stand={stand!r} is not True or False")
    if not hasattr(scene, "attach"):
        raise ImportError(f"mujoco {_module_of(scene).__version__} has no MjSpec.attach: "
                          "python -m pip install 'mujoco>=3.3'")
    root = prefix + _name_of_root(variant.xml_bytes)
    if scene.body(root) is not None:  # MuJoCo notices this after it has attached a part
        raise ValueError(f"prefix={prefix!r}: the scene has a body {root!r} already")
    if stand:
        place[2] -= _bottom(variant, turn)
    # Removes the keyframe from the text, because removing it from the parsed spec takes a hundred
    # times as long. Elements are parsed, because calls of MjSpec for each element convert each
    # number and are slower.
    files = variant.files
    child = type(scene).from_string(_without_keyframe(variant.xml_bytes), assets=files)
    child.njmax = child.nconmax = -1  # drops buffer sizes, which are for the object alone
    # MuJoCo warns of an object without files in a scene with files, after it has attached the object,
    # because the object may read files from the disk. An object of mjforge then has only inline meshes.
    with contextlib.nullcontext() if files else _without_files(scene):
        scene.attach(child, prefix=prefix, frame=scene.worldbody.add_frame(pos=place, quat=turn))
    return scene.body(root)


class _Start:
    """Moves the joints of an object in a simulation to their start positions."""

    def __init__(self, members: Members, model: MjModel, data: MjData, prefix: str) -> None:
        self._mujoco = _module_of(model)
        self._members = members
        self._model = model
        self._data = data
        self._prefix = prefix

    def id_of(self, kind: str, name: str) -> int:
        number: int = self._mujoco.mj_name2id(
            self._model, getattr(self._mujoco.mjtObj, f"mjOBJ_{kind.upper()}"), self._prefix + name)
        if number < 0:
            raise ValueError(f"prefix={self._prefix!r}: the model has no {kind} {self._prefix + name!r}")
        return number

    def run(self) -> None:
        model, data, members = self._model, self._data, self._members
        speeds = iter(members.key.get("qvel", ()))
        placed = [j for j in members.joints.values() if j.type == "free" and j.name != members.root_joint]
        origin = self._origin() if placed or any(members.key.get("qvel", ())) else None
        for joint in members.joints.values():
            number = self.id_of("joint", joint.name)
            first, dof = model.jnt_qposadr[number], model.jnt_dofadr[number]
            width = {"free": 6, "ball": 3}.get(joint.type, 1)
            velocity = [next(speeds, 0.0) for _ in range(width)]
            if joint.type == "free" and any(velocity[:3]):
                velocity[:3] = self._turned(velocity[:3], origin)
            data.qvel[dof:dof + width] = velocity
            if joint.name == members.root_joint:
                continue
            if joint.type == "free":
                data.qpos[first:first + 7] = self._placed(joint, origin)
            else:
                data.qpos[first:first + (4 if joint.type == "ball" else 1)] = joint.start
        self._start_actuators()

    def _start_actuators(self) -> None:
        model, data, key = self._model, self._data, self._members.key
        controls, activations = iter(key.get("ctrl", ())), iter(key.get("act", ()))
        for name in self._members.actuators:
            number = self.id_of("actuator", name)
            data.ctrl[number] = next(controls, 0.0)
            if model.na and model.actuator_actadr[number] >= 0:
                first, count = model.actuator_actadr[number], model.actuator_actnum[number]
                data.act[first:first + count] = [next(activations, 0.0) for _ in range(count)]

    def _origin(self) -> Pose:
        """Returns the pose of the object's own frame in the world, computed from the present pose
        of the object's first body.
        """
        import numpy as np

        mujoco, model, data, members = self._mujoco, self._model, self._data, self._members
        body = self.id_of("body", members.root)
        if members.root_joint is not None:
            first = model.jnt_qposadr[self.id_of("joint", members.root_joint)]
            now = data.qpos[first:first + 3].copy(), data.qpos[first + 3:first + 7].copy()
        else:
            mujoco.mj_kinematics(model, data)
            parent = model.body_parentid[body]
            now = self._product((data.xpos[parent], data.xquat[parent]),
                                (model.body_pos[body], model.body_quat[body]))
        pos, quat = np.array(members.root_pose[:3]), np.array(members.root_pose[3:])
        back, moved = np.zeros(4), np.zeros(3)
        mujoco.mju_negQuat(back, quat)
        mujoco.mju_rotVecQuat(moved, -pos, back)
        return self._product(now, (moved, back))

    def _placed(self, joint: Joint, origin: Any) -> Any:
        """Returns the numbers in qpos of a free body that starts at its pose relative to the
        object's frame.
        """
        import numpy as np

        start = np.array(joint.start)
        return np.concatenate(self._product(origin, (start[:3], start[3:])))

    def _turned(self, vector: list[float], frame: Any) -> Any:
        """Returns a vector in the world whose components in a frame are given."""
        import numpy as np

        turned = np.zeros(3)
        self._mujoco.mju_rotVecQuat(turned, np.array(vector), frame[1])
        return turned

    def _product(self, outer: Pose, inner: Pose) -> Pose:
        import numpy as np

        pos, quat = np.zeros(3), np.zeros(4)
        self._mujoco.mju_rotVecQuat(pos, inner[0], outer[1])
        self._mujoco.mju_mulQuat(quat, outer[1], inner[1])
        return pos + outer[0], quat


def start(variant: Variant, model: MjModel, data: MjData, prefix: str) -> None:
    """See Variant.start."""
    _require_type(model, "MjModel", "model")
    _require_type(data, "MjData", "data")
    for array, size in (("qpos", model.nq), ("qvel", model.nv), ("act", model.na), ("ctrl", model.nu),
                        ("xpos", model.nbody)):
        if len(getattr(data, array)) != size:
            raise ValueError(f"data={data!r} is of another model: {array} has {len(getattr(data, array))} rows, "
                             f"not {size}")
    c_text(prefix, "prefix")
    _Start(variant._own_members(), model, data, prefix).run()
