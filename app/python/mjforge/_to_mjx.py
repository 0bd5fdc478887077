"""A family in MJX: fields of the model with one row for each world, and axes for `jax.vmap`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping

from ._attach import _module_of
from ._mjx_hulls import moved_hull
from ._packages import needed

if TYPE_CHECKING:
    from mujoco import MjModel  # type: ignore[import-not-found, import-untyped, unused-ignore]

# Prefixes of fields that MJX shares between worlds, but does not read in a step.
_UNREAD = ("body_margin", "cam_", "geom_dataid", "geom_fluid", "light_", "mat_", "mesh_", "numeric_", "sensor_noise",
           "site_size", "tendon_rgba", "tendon_width", "tuple_")
# Fields that MJX shares between worlds, and the only type of sensor that reads each of them.
_SENSED = {"site_size": "TOUCH", "geom_dataid": "RANGEFINDER"}


def replacements(model: MjModel, fields: Mapping[str, Any]) -> tuple[dict[str, Any], Any]:
    """Returns the arrays for `mjx_model.tree_replace`, and a model of axes for `jax.vmap`.

    `fields` are the result of Family.fields for this model.
    """
    mjx, jax = needed("mujoco.mjx", "mujoco-mjx"), needed("jax", "mujoco-mjx")
    base = mjx.put_model(model, impl="jax")
    _check_sensors(model, fields)
    _check_height_fields(model, fields)
    _check_wraps(model, fields, base)
    arrays: dict[str, Any] = {}
    axes: dict[str, Any] = {}
    for name, values in fields.items():
        leaf = _leaf(base, name)
        if isinstance(leaf, jax.Array):
            arrays[name] = jax.numpy.asarray(values, leaf.dtype).reshape(len(values), *leaf.shape)
            axes[name] = 0
        elif leaf is not None and not name.startswith(_UNREAD) and not name.endswith("_user"):
            raise ValueError(f"{name} differs between the variants, and MJX has it once for all worlds")
    if "geom_dataid" in fields:
        arrays["_impl.mesh_convex"], axes["_impl.mesh_convex"] = _hulls(model, base, fields["geom_dataid"])
    return arrays, jax.tree_util.tree_map(lambda _: None, base).tree_replace(axes)


def _leaf(base: Any, name: str) -> Any:
    """Returns the value of a field in MJX's model; None if MJX has no such field."""
    outer, _, inner = name.rpartition(".")
    place = getattr(base, outer) if outer else base
    return getattr(place, inner) if inner in {field.name for field in type(place).fields()} else None


def _check_sensors(model: MjModel, fields: Mapping[str, Any]) -> None:
    types = _module_of(model).mjtSensor
    for name, kind in _SENSED.items():
        if name in fields and (model.sensor_type == getattr(types, f"mjSENS_{kind}")).any():
            raise ValueError(f"{name} differs between the variants, and the model has a sensor of the type "
                             f"{kind.lower()}, for which MJX has it once for all worlds")


def _check_height_fields(model: MjModel, fields: Mapping[str, Any]) -> None:
    """Raises ValueError if a geom is larger in a variant than in the base, and might cover more
    cells of a height field.
    """
    import numpy as np

    if not model.nhfield or "geom_rbound" not in fields:
        return
    larger = np.flatnonzero((fields["geom_rbound"] > model.geom_rbound).any(axis=0))
    if len(larger):
        raise ValueError(f"geom '{model.geom(larger[0]).name}' is larger in some variants than in the base, for which "
                         "MJX counts the cells of a height field")


def _check_wraps(model: MjModel, fields: Mapping[str, Any], base: Any) -> None:
    """Raises ValueError if a tendon passes inside a sphere or a cylinder in some variants only."""
    import numpy as np

    types = _module_of(model).mjtWrap
    wraps = np.isin(model.wrap_type, [int(types.mjWRAP_SPHERE), int(types.mjWRAP_CYLINDER)])
    if not model.nsite or not wraps.any():
        return
    geoms, sites = model.wrap_objid[wraps], np.round(model.wrap_prm[wraps]).astype(int)

    def of(name: str, ids: Any) -> Any:
        return fields.get(name, getattr(model, name)[None])[:, ids]

    distance = np.linalg.norm(of("site_pos", sites) - of("geom_pos", geoms), axis=2)
    is_inside = (distance < of("geom_size", geoms)[:, :, 0]) & (sites >= 0)
    if (is_inside != base._impl.is_wrap_inside).any():
        raise ValueError("a tendon passes inside the geom that it wraps around in some variants only, and MJX "
                         "decides this once for all worlds")


def _hulls(model: MjModel, base: Any, meshes: Any) -> tuple[Any, Any]:
    """Returns the convex hulls of colliding meshes, and their axes. `meshes` has the mesh of each
    geom in each world.
    """
    import numpy as np

    jax = needed("jax", "mujoco-mjx")
    hulls = list(base._impl.mesh_convex)
    is_moved = [False] * len(hulls)
    for geom in np.flatnonzero((meshes != model.geom_dataid).any(axis=0)):
        mesh = model.geom_dataid[geom]
        if hulls[mesh] is None or is_moved[mesh]:  # the mesh does not collide, or its hull is done
            continue
        same = meshes[:, model.geom_dataid == mesh]
        if (same != same[:, :1]).any():
            raise ValueError(f"geoms with the mesh '{model.mesh(mesh).name}' have different meshes in some "
                             "variants, and MJX has one convex hull for all of them")
        hulls[mesh], is_moved[mesh] = moved_hull(model, hulls[mesh], mesh, same[:, 0]), True

    def repeated(each: Any) -> Any:
        return jax.numpy.broadcast_to(each, (len(meshes), *each.shape))

    shared = [hull if is_own else jax.tree_util.tree_map(repeated, hull) for hull, is_own in zip(hulls, is_moved)]
    return tuple(shared), tuple(None if hull is None else 0 for hull in hulls)
