"""A family in Newton, where each world is imported from MJCF of its own."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

from ._family_base import mesh_of_row, meshes_that_differ
from ._family_rows import rows_of
from ._packages import needed

if TYPE_CHECKING:
    from ._family import Family


def add_worlds(family: Family, builder: Any, rows: Any, options: "dict[str, Any]") -> None:
    """See Family.to_newton."""
    newton = needed("newton", "'newton[sim]'")
    if not isinstance(builder, newton.ModelBuilder):
        raise TypeError(f"builder={builder!r} is not a newton.ModelBuilder but of type {type(builder).__name__}")
    for row in rows_of(family, rows)[:, 0]:
        world = newton.ModelBuilder(up_axis=builder.up_axis, gravity=builder.gravity)
        newton.solvers.SolverMuJoCo.register_custom_attributes(world)
        world.add_mjcf(mjcf_of(family, int(row)), **options)
        builder.add_world(world)


def mjcf_of(family: Family, row: int) -> str:
    """Returns MJCF of the base with the numbers of one variant, to six digits as MuJoCo writes
    them.
    """
    alone = copy.copy(family)
    alone._file = family._file.only(row)
    spec = alone.base
    if not hasattr(spec, "copy_back"):
        version = needed("mujoco", "mujoco").__version__
        raise ImportError(f"mujoco {version} has no MjSpec.copy_back: python -m pip install 'mujoco>=3.17'")
    own = set(meshes_that_differ(alone._file))
    for geom in spec.geoms:
        if geom.meshname in own:
            geom.meshname = mesh_of_row(geom.meshname, 0)
    model = spec.compile()
    numbers = alone.to_model(model)
    is_mesh = model.geom_dataid >= 0
    numbers.geom_size[is_mesh] = model.geom_size[is_mesh]  # sizes computed from the mesh
    numbers.stat.meaninertia = model.stat.meaninertia  # not read by anything
    spec.copy_back(numbers)
    return str(spec.to_xml())
