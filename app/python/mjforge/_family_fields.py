"""Numbers of a scene's model in each world: those of the world's variant, and those that MuJoCo
derives from them.
"""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Optional

from ._attach import _module_of, _require_type
from ._family_base import mesh_of_row, meshes_that_differ
from ._family_rows import placements
from ._family_scene import Placed
from ._family_worlds import Worlds, writer
from ._library import integer
from ._poses import compose, inverse, product, rotate, without

if TYPE_CHECKING:
    from mujoco import MjModel  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._family import Family

_POSES = ("body", "geom", "site", "cam")
_LIGHTS = ("light_pos", "light_dir")
_MATERIALS = ("geom_matid", "site_matid", "tendon_matid")
_FREE = ("qpos0", "qpos_spring")


def fields_of(family: Family, model: MjModel, prefix: Any, rows: Any,
              over: Optional[Mapping[str, Any]]) -> dict[str, Any]:
    """See Family.fields."""
    _require_type(model, "MjModel", "model")
    placed = placements(family, prefix, rows)
    worlds = Worlds(model, len(placed[0][1]), over)
    for each, variants in placed:
        write(Placed(family, model, each), worlds, variants)
    worlds.derive()
    return worlds.arrays


def write(placed: Placed, worlds: Worlds, rows: Any) -> None:
    """Writes the numbers of one object's variants into `worlds`, without the numbers that MuJoCo
    derives from them.
    """
    _Writer(placed, worlds, rows).run()


def model_of(family: Family, model: MjModel, prefix: Any, row: Any) -> MjModel:
    """See Family.to_model."""
    if not 0 <= integer(row, "row") < len(family):
        raise ValueError(f"row={row!r} is not within 0 .. {len(family) - 1}, the variants of '{family.path}'")
    values = fields_of(family, model, prefix, [row], None)
    changed = copy.copy(model)
    for name, array in values.items():
        writer(changed, name)(array[0])
    if "bvh_aabb" not in values:  # this release does not update the boxes of the midphase
        changed.opt.disableflags |= _module_of(model).mjtDisableBit.mjDSBL_MIDPHASE
    return changed


class _Writer:
    """Writes the numbers of one object into the arrays of the scene."""

    def __init__(self, placed: Placed, worlds: Worlds, rows: Any) -> None:
        import numpy as np

        self._np = np
        self._placed = placed
        self._base = placed.base
        self._members = placed.family._file.members
        self._worlds = worlds
        self._rows = rows  # variant of each world

    def run(self) -> None:
        self._write_meshes()
        for kind in _POSES:
            self._write_poses(kind)
        self._write_lights()
        for field in _FREE:
            self._write_coordinates(field)
        apart = {*_LIGHTS, *_MATERIALS, *_FREE, *(f"{kind}_{what}" for kind in _POSES for what in ("pos", "quat"))}
        for field in self._placed.family._file.fields():
            if field in apart:
                continue
            if f"{field}.components" in self._members:
                self._write(field, self._placed.coordinates(field)[1], self._values(field))
            else:
                self._write_elements(field)
        for field in set(_MATERIALS) & set(self._members):
            self._write_materials(field)
        for name in self._members:
            if name.startswith("opt_"):
                self._worlds.set_option(f"opt.{name[4:]}", self._values(name))
        self._worlds.add_bounds(self._sized())

    def _values(self, field: str) -> Any:
        """Returns the numbers of a field in each world."""
        return self._members[field][self._rows]

    def _write(self, field: str, there: Any, values: Any) -> None:
        """Writes the numbers of elements in each world; `there` has the ids of the elements in the
        scene.
        """
        out = self._worlds.array(field)
        columns = values.reshape(*values.shape[:2], -1)
        if field == "eq_data" or field.endswith("_user"):  # the scene may have more columns
            out[:, there, :columns.shape[-1]] = columns
        elif field == "tendon_lengthspring":  # one length before MuJoCo 2.3.1, later two
            out[:, there] = columns
        else:
            out[:, there] = values.reshape(out[:, there].shape)

    def _write_elements(self, field: str) -> None:
        kind = field.partition("_")[0]
        mine, values = self._placed.elements(field), self._values(field)
        if field == "geom_size":  # MuJoCo computes the size of a mesh geom from the vertices
            is_shape = self._base.geom_dataid[mine] < 0
            mine, values = mine[is_shape], values[:, is_shape]
        if field == "eq_data":
            values = self._welded_to_world(mine, values.copy())
        self._write(field, self._placed.found(kind, mine), values)

    def _welded_to_world(self, mine: Any, values: Any) -> Any:
        """Recomputes numbers that are relative to the world of the base. The anchor of a connect
        moves with the object. The anchor of a weld stays in place, as when MjSpec attaches a weld,
        so that its position in the other body changes.
        """
        types, (pos, quat) = self._placed.types, self._placed.frame_of_roots()
        for at, number in enumerate(mine):
            kind, ends = self._base.eq_type[number], (self._base.eq_obj1id[number], self._base.eq_obj2id[number])
            if kind not in (types.mjEQ_WELD, types.mjEQ_CONNECT) or 0 not in ends:
                continue
            if self._placed.ids("body")[0] != 0:
                raise ValueError(f"prefix={self._placed.prefix!r}: the object has an equality with the world, and is "
                                 "attached to a body: attach it to the world")
            first, second, turn = values[:, at, :3], values[:, at, 3:6], values[:, at, 6:10]  # turn: of welds
            if kind == types.mjEQ_CONNECT:
                anchor = first if ends[0] == 0 else second
                anchor[...] = pos + rotate(quat, anchor)
            elif ends[0] == 0:
                second[...], turn[...] = compose((pos, quat), (second, turn))
            else:
                second += rotate(turn, rotate(inverse(quat), first - pos) - first)
                turn[...] = product(turn, inverse(quat))
        return values

    def _write_materials(self, field: str) -> None:
        names = self._members["materials"].tolist()
        ids = self._np.array([self._placed.id_of(self._placed.model, "mat", self._placed.prefix + name)
                              for name in names] + [-1])
        self._write(field, self._placed.ids(field.partition("_")[0])[self._placed.elements(field)],
                    ids[self._values(field)])

    def _full(self, field: str, mine: Any) -> Any:
        """Returns an array of the base for the elements `mine`, with the numbers of each world."""
        np = self._np
        values = np.repeat(getattr(self._base, field)[mine][None].astype(float), len(self._rows), axis=0)
        if f"{field}.names" in self._members:
            at = {number: position for position, number in enumerate(mine.tolist())}
            values[:, [at[number] for number in self._placed.elements(field).tolist()]] = self._values(field)
        return values

    def _stored(self, fields: Iterable[str]) -> Any:
        """Returns the ids in the base of all elements that the family's arrays of these fields
        contain.
        """
        found = [self._placed.elements(field) for field in fields if f"{field}.names" in self._members]
        return self._np.unique(self._np.concatenate([self._np.zeros(0, int), *found]))

    def _write_poses(self, kind: str) -> None:
        np, placed = self._np, self._placed
        pos_field, quat_field = f"{kind}_pos", f"{kind}_quat"
        mine = self._stored((pos_field, quat_field))
        other_meshes = self._geoms_with_other_meshes() if kind == "geom" else np.zeros(0, int)
        mine = np.union1d(mine, other_meshes)
        if not len(mine):
            return
        pose = self._full(pos_field, mine), self._full(quat_field, mine)
        has_mesh = np.zeros(len(mine), bool)
        if kind == "geom":
            has_mesh = self._base.geom_type[mine] == placed.mesh_type
            pose = self._through_mesh(mine, has_mesh, pose)
        pos, quat = compose(placed.frames(kind, mine), pose)
        there = placed.ids(kind)[mine]
        if f"{pos_field}.names" in self._members or has_mesh.any():
            self._write(pos_field, there, pos)
        if f"{quat_field}.names" in self._members or len(other_meshes):
            self._write(quat_field, there, quat)

    def _through_mesh(self, mine: Any, has_mesh: Any, pose: "tuple[Any, Any]") -> "tuple[Any, Any]":
        """Converts poses of mesh geoms from the frame of MJCF to the mesh frame of this MuJoCo,
        which depends on the release. Poses that are equal in all variants are in MuJoCo's frame of
        the base's mesh.
        """
        model = self._placed.model
        for at in self._np.flatnonzero(has_mesh):
            geom, mesh = mine[at], self._base.geom_dataid[mine[at]]
            own = self._base.mesh_pos[mesh], self._base.mesh_quat[mesh]
            pos, quat = without((self._base.geom_pos[geom], self._base.geom_quat[geom]), own)
            if not self._has("geom_pos", geom):
                pose[0][:, at] = pos
            if not self._has("geom_quat", geom):
                pose[1][:, at] = quat
            ids = self._mesh_ids(int(mesh))
            pose[0][:, at] += rotate(pose[1][:, at], model.mesh_pos[ids])
            pose[1][:, at] = product(pose[1][:, at], model.mesh_quat[ids])
        return pose

    def _has(self, field: str, element: int) -> bool:
        return f"{field}.names" in self._members and element in self._placed.elements(field)

    def _mesh_ids(self, mesh: int) -> Any:
        """Returns, for a mesh of the base, the id of the mesh in the scene for each world."""
        ids = self._worlds_meshes.get(mesh)
        if ids is not None:
            return ids[self._rows]
        return self._np.full(len(self._rows), self._placed.ids("mesh")[mesh])

    def _geoms_with_other_meshes(self) -> Any:
        is_mesh = self._base.geom_type == self._placed.mesh_type
        return self._np.flatnonzero(is_mesh & self._np.isin(self._base.geom_dataid, list(self._worlds_meshes)))

    def _write_meshes(self) -> None:
        """Selects the meshes of each world, and computes the sizes and bounds of their geoms."""
        placed, np = self._placed, self._np
        self._worlds_meshes: dict[int, Any] = {}
        for name in meshes_that_differ(placed.family._file):
            ids = [placed.id_of(placed.model, "mesh", placed.prefix + mesh_of_row(name, row))
                   for row in range(len(placed.family))]
            if min(ids) < 0:
                raise ValueError(f"prefix={placed.prefix!r}: the model has no mesh '{placed.prefix}"
                                 f"{mesh_of_row(name, ids.index(-1))}': attach the `base` of the family, "
                                 "which has the meshes of all variants")
            self._worlds_meshes[placed.names("mesh").index(name)] = np.array(ids)
        for geom in self._geoms_with_other_meshes():
            ids = self._worlds_meshes[int(self._base.geom_dataid[geom])][self._rows]
            self._worlds.set_mesh(placed.ids("geom")[geom], ids)

    def _write_lights(self) -> None:
        placed = self._placed
        for field in _LIGHTS:
            if f"{field}.names" in self._members:
                mine = placed.elements(field)
                pos, quat = placed.frames("light", mine)
                turned = rotate(quat, self._values(field))
                self._write(field, placed.ids("light")[mine], turned + (pos if field == "light_pos" else 0))

    def _write_coordinates(self, field: str) -> None:
        """Writes positions of joints; positions of free bodies are poses in the world of the scene.
        """
        if f"{field}.names" not in self._members:
            return
        mine, there = self._placed.coordinates(field)
        values = self._values(field)
        self._write(field, there, values)
        full = self._np.repeat(getattr(self._base, field)[None], len(self._rows), axis=0)
        full[:, mine] = values
        out = self._worlds.array(field)
        for joint in self._np.unique(self._placed.elements(field)):
            if self._base.jnt_type[joint] == self._placed.free_type:
                self._placed.place_free(joint, full, out)

    def _sized(self) -> Any:
        """Returns the ids in the scene of primitive geoms whose sizes differ between variants."""
        if "geom_size.names" not in self._members:
            return self._np.zeros(0, int)
        mine = self._placed.elements("geom_size")
        return self._placed.ids("geom")[mine[self._base.geom_dataid[mine] < 0]]
