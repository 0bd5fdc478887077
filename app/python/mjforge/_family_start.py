"""The start state of each world, for an object of a family in a scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional

from ._attach import _require_type
from ._family_fields import write
from ._family_rows import placements
from ._family_scene import Placed
from ._family_worlds import Worlds, checked

if TYPE_CHECKING:
    from mujoco import MjModel  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._family import Family

_NAMES = ("qpos", "qvel", "act", "ctrl", "mocap_pos", "mocap_quat")


def start_of(family: Family, model: MjModel, prefix: Any, rows: Any,
             over: Optional[Mapping[str, Any]]) -> dict[str, Any]:
    """See Family.start."""
    import numpy as np

    _require_type(model, "MjModel", "model")
    placed = placements(family, prefix, rows)
    worlds = len(placed[0][1])
    state = _defaults(model, worlds)
    for name, array in ({} if over is None else checked(over)).items():
        if name not in state or np.shape(array) != state[name].shape:
            raise ValueError(f"over: '{name}' has the shape {np.shape(array)}; a start state of {worlds} worlds has "
                             f"{', '.join(f'{key} {each.shape}' for key, each in state.items())}")
        state[name][...] = array
    for each, variants in placed:
        _place(Placed(family, model, each), variants, state)
    return {name: array for name, array in state.items() if array.size}


def _defaults(model: MjModel, worlds: int) -> dict[str, Any]:
    import numpy as np

    mocap = [int(np.flatnonzero(model.body_mocapid == i)[0]) for i in range(model.nmocap)]
    start = {"qpos": model.qpos0, "qvel": np.zeros(model.nv), "act": np.zeros(model.na), "ctrl": np.zeros(model.nu),
             "mocap_pos": model.body_pos[mocap], "mocap_quat": model.body_quat[mocap]}
    return {name: np.repeat(np.asarray(start[name])[None], worlds, axis=0) for name in _NAMES}


def _place(placed: Placed, rows: Any, state: dict[str, Any]) -> None:
    """Writes the start positions of one object's joints, actuators and mocap bodies to `state`."""
    import numpy as np

    base, model = placed.base, placed.model
    own = _own_start(placed, rows)
    worlds = Worlds(model, len(rows), None)
    write(placed, worlds, rows)
    for joint, there in enumerate(placed.ids("jnt")):
        for name, address, total in (("qpos", "jnt_qposadr", "nq"), ("qvel", "jnt_dofadr", "nv")):
            first, to = getattr(base, address)[joint], getattr(model, address)[there]
            ends = [*getattr(base, address)[joint + 1:joint + 2], getattr(base, total)]
            width = ends[0] - first
            state[name][:, to:to + width] = own[name][:, first:first + width]
        if base.jnt_type[joint] == placed.free_type:
            placed.place_free(joint, own["qpos"], state["qpos"])
    for number, there in enumerate(placed.ids("actuator")):
        state["ctrl"][:, there] = own["ctrl"][:, number]
        first, count = base.actuator_actadr[number], base.actuator_actnum[number]
        if first >= 0:
            to = model.actuator_actadr[there]
            state["act"][:, to:to + count] = own["act"][:, first:first + count]
    for body in placed.ids("body")[1:]:
        mocap = model.body_mocapid[body]
        if mocap >= 0:
            for name in ("pos", "quat"):
                state[f"mocap_{name}"][:, mocap] = worlds.array(f"body_{name}")[:, body]


def _own_start(placed: Placed, rows: Any) -> dict[str, Any]:
    """Returns the start state of the base, from its keyframe or MuJoCo's default, with the numbers
    of each variant.
    """
    import numpy as np

    base, members = placed.base, placed.family._file.members
    qpos = np.repeat(base.qpos0[None], len(rows), axis=0)
    if "qpos0.names" in members:
        qpos[:, placed.coordinates("qpos0")[0]] = members["qpos0"][rows]
    start = {"qpos": qpos}
    for name, count in (("qvel", base.nv), ("act", base.na), ("ctrl", base.nu)):
        start[name] = np.zeros((len(rows), count))
    for name, array in start.items():
        if base.nkey:
            array[...] = getattr(base, f"key_{name}")[0]
        if f"start_{name}" in members:
            array[...] = members[f"start_{name}"][rows]
    return start
