"""Arrays with one row for each world, for the fields of a model that differ between worlds."""

from __future__ import annotations

import copy
import functools
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Sequence

from ._attach import _module_of
from ._library import c_text

if TYPE_CHECKING:
    from mujoco import MjModel  # type: ignore[import-not-found, import-untyped, unused-ignore]

# Fields that mj_setConst computes; `_others` finds further fields that a release computes.
_DERIVED = ("body_subtreemass", "body_invweight0", "dof_invweight0", "dof_M0", "tendon_length0", "tendon_invweight0",
            "actuator_acc0", "actuator_length0", "cam_pos0", "cam_poscom0", "cam_mat0", "light_pos0",
            "light_poscom0", "light_dir0", "eq_data")


class Worlds:
    """Arrays of the fields in which at least one world differs from the model, by field."""

    def __init__(self, model: MjModel, count: int, over: Optional[Mapping[str, Any]]) -> None:
        import numpy as np

        self._np = np
        self._mujoco = _module_of(model)
        self._model = model
        self._count = count
        self.arrays: dict[str, Any] = {}
        self._options: dict[str, Any] = {}  # options that an object has set
        self._over = {} if over is None else checked(over)
        for name, array in self._over.items():
            try:
                self.array(name)
            except ValueError as error:
                raise ValueError(f"over: {error}") from None
            if np.shape(array) != self.arrays[name].shape:
                raise ValueError(f"over: '{name}' has the shape {np.shape(array)}, not {self.arrays[name].shape}, "
                                 "which it has for these worlds")
            self.arrays[name][...] = array

    def array(self, field: str) -> Any:
        """Returns the array of a field; a new array has the model's numbers in all worlds."""
        if field not in self.arrays:
            part, _, member = field.rpartition(".")
            shared = getattr(getattr(self._model, part) if part else self._model, member, None)
            if shared is None:
                raise ValueError(f"mujoco {self._mujoco.__version__} has no {field}")
            if field == "bvh_aabb":  # boxes of bodies, which precede those of meshes
                shared = shared[:_boxes_of_bodies(self._model)]
            self.arrays[field] = self._np.repeat(self._np.asarray(shared)[None], self._count, axis=0)
        return self.arrays[field]

    def set_option(self, field: str, values: Any) -> None:
        """Sets an option in each world. Raises ValueError if an object of a world set another value."""
        if (self._options.setdefault(field, values) != values).any():
            raise ValueError(f"{field} differs between the objects of a world: draw it in one of them only")
        self.array(field)[...] = values

    def set_mesh(self, geom: int, meshes: Any) -> None:
        """Gives a geom the mesh of each world, with the bounds of the mesh."""
        np, model = self._np, self._model
        self.array("geom_dataid")[:, geom] = meshes
        low, high = np.empty((self._count, 3)), np.empty((self._count, 3))
        used, worlds = np.unique(meshes, return_inverse=True)
        for number, mesh in enumerate(used):
            first = model.mesh_vertadr[mesh]
            vertices = model.mesh_vert[first:first + model.mesh_vertnum[mesh]]
            low[worlds == number], high[worlds == number] = vertices.min(axis=0), vertices.max(axis=0)
        size = np.maximum(np.abs(low), np.abs(high))
        self.array("geom_size")[:, geom] = size
        self.array("geom_aabb")[:, geom] = np.concatenate([(low + high) / 2, (high - low) / 2], axis=1)
        self.array("geom_rbound")[:, geom] = np.linalg.norm(size, axis=1)

    def add_bounds(self, geoms: Any) -> None:
        """Computes the bounding spheres and boxes of primitive geoms from their sizes."""
        np, types = self._np, self._mujoco.mjtGeom
        for geom in geoms:
            size = self.arrays["geom_size"][:, geom]
            r, h, zero = size[:, 0], size[:, 1], np.zeros(self._count)
            kind = int(self._model.geom_type[geom])
            if kind == types.mjGEOM_SPHERE:
                radius, half = r, (r, r, r)
            elif kind == types.mjGEOM_CAPSULE:
                radius, half = r + h, (r, r, r + h)
            elif kind == types.mjGEOM_CYLINDER:
                radius, half = np.hypot(r, h), (r, r, h)
            elif kind == types.mjGEOM_ELLIPSOID:
                radius, half = size.max(axis=1), tuple(size.T)
            elif kind == types.mjGEOM_BOX:
                radius, half = np.linalg.norm(size, axis=1), tuple(size.T)
            else:
                continue  # a plane has no bounds
            self.array("geom_rbound")[:, geom] = radius
            self.array("geom_aabb")[:, geom] = np.stack([zero, zero, zero, *half], axis=1)

    def derive(self) -> None:
        """Computes, in each world, the numbers that MuJoCo derives from others."""
        work = copy.copy(self._model)
        data = self._mujoco.MjData(work)
        # Copies the numbers of equalities, because mj_setConst reads some of them and computes
        # others.
        given = [(name, array.copy() if name == "eq_data" else array) for name, array in self.arrays.items()
                 if name not in _DERIVED[:-1] and not name.startswith("stat.")]
        writers = [(writer(work, name), array) for name, array in given]

        def compute(world: int) -> None:
            for write, array in writers:
                write(array[world])
            self._mujoco.mj_setConst(work, data)

        names = [name for name in _DERIVED if getattr(self._model, name).size]
        names += self._others(work, compute, names)
        taken = [(getattr(work, name), self.array(name)) for name in names]
        for world in range(self._count):
            compute(world)
            for source, array in taken:
                array[world] = source[:array.shape[1]]
        self._derive_mean_inertia()

    def _derive_mean_inertia(self) -> None:
        """Computes the mean inertia, by which solvers scale their tolerance, unless the scene sets
        another value.
        """
        mean = self._model.dof_M0.mean() if self._model.nv else None
        if mean is not None and self._np.isclose(mean, self._model.stat.meaninertia, rtol=1e-9, atol=0):
            self.array("stat.meaninertia")[...] = self.arrays["dof_M0"].mean(axis=1)

    def _others(self, work: MjModel, compute: Callable[[int], None], known: Sequence[str]) -> list[str]:
        """Returns the names of further arrays that mj_setConst changes in the first, the middle or
        the last world.
        """
        found: set[str] = set()
        given = self.arrays.keys() - self._over.keys()
        candidates = [name for name in dir(work) if not name.startswith("_") and name not in known
                      and name not in given and _is_real(getattr(work, name, None))]
        for world in {0, self._count // 2, self._count - 1}:
            compute(world)
            found |= {name for name in candidates
                      if not self._np.array_equal(getattr(work, name), getattr(self._model, name), equal_nan=True)}
        return sorted(found)


def _boxes_of_bodies(model: MjModel) -> int:
    return int((model.body_bvhadr + model.body_bvhnum).max(initial=0))


def _is_real(value: Any) -> bool:
    return getattr(getattr(value, "dtype", None), "kind", "") == "f" and value.size > 0


def writer(model: MjModel, field: str) -> Callable[[Any], None]:
    """Returns a function that sets a field of the model."""
    part, _, member = field.rpartition(".")
    if part:
        return functools.partial(setattr, getattr(model, part), member)
    if field == "bvh_aabb":
        return functools.partial(model.bvh_aabb.__setitem__, slice(_boxes_of_bodies(model)))
    return functools.partial(getattr(model, field).__setitem__, ...)


def checked(over: Any) -> Mapping[str, Any]:
    if not isinstance(over, Mapping):
        raise TypeError(f"over={over!r} is not a dict of arrays but of type {type(over).__name__}")
    for name in over:
        c_text(name, "over")
    return over
