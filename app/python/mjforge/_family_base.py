"""The base of a family as an MjSpec, with the meshes of all variants."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Iterator

if TYPE_CHECKING:
    from mujoco import MjModel, MjsMesh, MjSpec  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._family_file import FamilyFile

# Attributes that the copies of a mesh for the variants share with the mesh. Some releases of MuJoCo
# lack some of these attributes.
_SHARED = ("inertia", "maxhullvert", "smoothnormal", "needsdf", "refpos", "refquat", "content_type",
           "material")
_LISTS = ("userface", "usernormal", "usertexcoord", "userfacenormal", "userfacetexcoord")

_CONVEX_INERTIA = (3, 12)  # first release that can compute it for a mesh without geoms


def mesh_of_row(mesh: str, row: int) -> str:
    """Returns the name of the mesh that a variant has in place of a mesh of the base."""
    return f"{mesh}@{row}"


def meshes_that_differ(file: FamilyFile) -> list[str]:
    """Returns the names of the meshes of the base that differ between variants."""
    return [*file.columns("mesh_vert/"), *file.columns("mesh_scale/")]


def _mujoco() -> Any:
    try:
        mujoco = importlib.import_module("mujoco")
    except ImportError as error:
        raise ImportError("this needs MuJoCo: python -m pip install 'mujoco>=3.3'") from error
    if not hasattr(mujoco, "MjSpec") or not hasattr(mujoco.MjSpec, "attach"):
        raise ImportError(f"mujoco {mujoco.__version__} has no MjSpec.attach: "
                          "python -m pip install 'mujoco>=3.3'")
    return mujoco


def compiled(file: FamilyFile) -> MjModel:
    """Returns the compiled base, without the meshes of single variants."""
    return _mujoco().MjModel.from_xml_string(file.text("base"), file.assets())


def spec_of(file: FamilyFile) -> MjSpec:
    """Returns a new MjSpec of the base, without its keyframe and with the meshes of all variants.
    """
    mujoco = _mujoco()
    spec = mujoco.MjSpec.from_string(file.text("base"), assets=file.assets())
    spec.njmax = spec.nconmax = -1  # drops buffer sizes, which are for the object alone
    for key in list(spec.keys):
        spec.delete(key) if hasattr(spec, "delete") else key.delete()
    own = {mesh.name: mesh for mesh in spec.meshes}
    for name, vertices in file.columns("mesh_vert/").items():
        for row, mesh in enumerate(_copies_of(own[name], spec, file.count)):
            # Uses the scale of the base, so that vertices are rounded as in the variant's own file.
            mesh.scale, mesh.uservert = own[name].scale, (vertices[row] / own[name].scale).ravel()
    for name, scale in file.columns("mesh_scale/").items():
        for row, mesh in enumerate(_copies_of(own[name], spec, file.count)):
            mesh.scale, mesh.file = scale[row], own[name].file
    return spec


def _copies_of(mesh: MjsMesh, spec: MjSpec, count: int) -> Iterator[MjsMesh]:
    """Adds a copy of a mesh for each variant, without vertices."""
    shared = {name: getattr(mesh, name) for name in _SHARED if hasattr(mesh, name)}
    shared.update({name: value for name in _LISTS if len(value := getattr(mesh, name, ()))})
    collides = any(geom.meshname == mesh.name and (geom.contype or geom.conaffinity) for geom in spec.geoms)
    if collides and (len(mesh.userface) or mesh.file):
        # Requests the convex inertia, because otherwise a mesh that no geom of the base has would
        # get no convex hull.
        mujoco = _mujoco()
        if tuple(map(int, mujoco.__version__.split(".")[:2])) < _CONVEX_INERTIA:
            raise ImportError(f"mesh '{mesh.name}' differs between variants, collides and has faces: mujoco "
                              f"{mujoco.__version__} crashes on that; python -m pip install 'mujoco>=3.12'")
        shared["inertia"] = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
    for row in range(count):
        copy = spec.add_mesh(name=mesh_of_row(mesh.name, row))
        for name, value in shared.items():
            setattr(copy, name, value)
        yield copy
