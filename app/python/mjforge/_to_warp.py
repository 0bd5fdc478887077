"""Writes the numbers of a family's variants into the worlds of MuJoCo Warp."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Mapping, Optional

from ._attach import _module_of
from ._family_rows import worlds_of

if TYPE_CHECKING:
    from mujoco import MjModel  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._family import Family


def to_warp(family: Family, m: Any, model: MjModel, prefix: Any, rows: Any,
            over: Optional[Mapping[str, Any]], worlds: Any) -> None:
    """See Family.to_warp."""
    if type(m).__name__ != "Model" or not type(m).__module__.startswith("mujoco_warp"):
        raise TypeError(f"m={type(m).__name__} is not a mujoco_warp.Model: mujoco_warp.put_model(model) returns one")
    write(m, family.fields(model, prefix, rows, over=over), model, worlds)


def write(m: Any, fields: Mapping[str, Any], model: MjModel, worlds: Any = None) -> None:
    """Writes the numbers in the fields of a scene (Family.fields) into the worlds of a model of
    MuJoCo Warp.
    """
    changes = changes_of(m, fields, model)
    at = None if worlds is None else worlds_of(worlds, next(len(values) for values in fields.values()))
    for holder, name, values in changes:
        _assign(holder, name, values, at)


def changes_of(m: Any, fields: Mapping[str, Any], model: MjModel) -> "list[tuple[Any, str, Any]]":
    """Returns the arrays of a model of Warp that differ between worlds: the object that has the
    array, the array's name in that object, and its numbers in each world. Raises ValueError for
    differences that Warp does not support.
    """
    if m.ngeom != model.ngeom or m.nbody != model.nbody or m.nv != model.nv:
        raise ValueError(f"m has {m.nbody} bodies, {m.ngeom} geoms and {m.nv} degrees of freedom, and the model "
                         f"{model.nbody}, {model.ngeom} and {model.nv}: it was not made from this model")
    _expect_no_static_geoms(fields, model)
    changes = []
    for field, values in fields.items():
        holder, name, values = _member(m, field, values)
        target = getattr(holder, name, None)
        if target is None or not hasattr(target, "dtype"):
            continue  # Warp does not use the field
        if _is_batched(holder, name):
            changes.append((holder, name, _shaped(target, values)))
        elif _is_used(field, model) and _differs(values, model, field):
            raise ValueError(f"{field} differs between worlds, and MuJoCo Warp shares it between them")
    return changes


def _member(m: Any, field: str, values: Any) -> "tuple[Any, str, Any]":
    """Returns the object that has a field, the field's name in that object, and the numbers in
    Warp's form.
    """
    import numpy as np

    part, _, name = field.rpartition(".")
    holder = getattr(m, part, None) if part else m
    if field == "opt.impratio":
        return holder, "impratio_invsqrt", 1 / np.sqrt(np.maximum(values, 1e-15))
    return holder, name, values


def _is_batched(holder: Any, name: str) -> bool:
    shape: Any = getattr(type(holder).__dataclass_fields__[name].type, "shape", ())
    return bool(shape) and shape[0] in ("*", "nworld")


def _differs(values: Any, model: MjModel, field: str) -> bool:
    import numpy as np

    part, _, name = field.rpartition(".")
    shared = np.asarray(getattr(getattr(model, part) if part else model, name))
    return not np.allclose(values, shared[None], rtol=1e-9, atol=1e-12)


def _is_used(field: str, model: MjModel) -> bool:
    """Returns false for fields that do not affect the motion of the scene."""
    mujoco = _module_of(model)
    if field == "dof_length":
        return bool(model.opt.enableflags & int(getattr(mujoco.mjtEnableBit, "mjENBL_SLEEP", 0)))
    if field == "site_size":
        sensing = ("mjSENS_TOUCH", "mjSENS_INSIDESITE")
        return any((model.sensor_type == int(getattr(mujoco.mjtSensor, name, -1))).any() for name in sensing)
    return True


def _shaped(target: Any, values: Any) -> Any:
    """Returns the numbers in the shape and the type that the array of Warp has for each world."""
    import numpy as np

    shape = (*target.shape[1:], *getattr(target.dtype, "_shape_", ()))
    flat = values.reshape(len(values), *target.shape[1:], -1) if values.size else values
    width = int(np.prod(shape)) // max(1, int(np.prod(target.shape[1:])))
    if values.size and flat.shape[-1] < width:  # the width of eq_data depends on the release
        flat = np.concatenate([flat, np.zeros((*flat.shape[:-1], width - flat.shape[-1]))], axis=-1)
    scalar = importlib.import_module("warp").dtype_to_numpy(getattr(target.dtype, "_wp_scalar_type_", target.dtype))
    return np.ascontiguousarray(flat.reshape(len(values), *shape), dtype=scalar)


def _assign(holder: Any, name: str, values: Any, at: Any) -> None:
    """Writes an array, in place if it already has these worlds, so that captured graphs remain
    valid.
    """
    warp = importlib.import_module("warp")
    target = getattr(holder, name)
    if at is not None:
        if target.shape[0] <= at.max():
            raise ValueError(f"worlds: {name} has numbers of {target.shape[0]} worlds, and not of world {at.max()}: "
                             "call to_warp for all worlds first")
        part = warp.array(values, dtype=target.dtype, device=target.device)
        warp.copy(warp.indexedarray(target, [warp.array(at, dtype=int, device=target.device)]), part)
    elif target.shape[0] == len(values):
        target.assign(values)
    else:
        array = warp.array(values, dtype=target.dtype, device=target.device)
        array._is_batched = True  # mark of mujoco_warp for such arrays
        setattr(holder, name, array)


def _expect_no_static_geoms(fields: Mapping[str, Any], model: MjModel) -> None:
    """Raises ValueError if poses of geoms on bodies that are fixed to the world differ, because
    Warp computes these poses once for all worlds.
    """
    import numpy as np

    is_static = (model.body_weldid == 0) & (model.body_mocapid[model.body_rootid] < 0)
    geoms = np.flatnonzero(is_static[model.geom_bodyid])
    bodies = set(model.geom_bodyid[geoms].tolist())
    for body in sorted(bodies):
        while body:
            bodies.add(body)
            body = int(model.body_parentid[body])
    for kind, ids in (("geom", geoms), ("body", np.array(sorted(bodies), dtype=int))):
        for field in (f"{kind}_pos", f"{kind}_quat"):
            values = fields.get(field)
            if values is None or not len(ids):
                continue
            off = np.abs(values[:, ids] - getattr(model, field)[ids]).max(axis=(0, 2))
            if off.max() > 1e-9:
                element = getattr(model, kind)(int(ids[off.argmax()])).name
                raise ValueError(f"{field} of {kind} '{element}' differs between worlds, and MuJoCo Warp computes the "
                                 "poses of geoms that are fixed to the world only once: make the family with --mocap")
