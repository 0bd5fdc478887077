"""Convex hulls of meshes in MJX: faces and edges of one mesh, with the vertices of others."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._packages import needed

if TYPE_CHECKING:
    from mujoco import MjModel  # type: ignore[import-not-found, import-untyped, unused-ignore]

# Largest distance of a vertex from the outer side of a face, relative to the size of the mesh.
_FLATNESS = 1e-5


def moved_hull(model: MjModel, hull: Any, mesh: int, meshes: Any) -> Any:
    """Returns the convex hull (ConvexMesh) of a mesh, with the vertices of each world's mesh.

    Raises ValueError if the convex hull of one of these meshes has other faces.
    """
    import numpy as np

    jax = needed("jax", "mujoco-mjx")
    base = _vertices(model, mesh)

    def nearest(points: Any) -> Any:
        return np.linalg.norm(np.asarray(points)[..., None, :] - base, axis=-1).argmin(axis=-1)

    face, corner = nearest(hull.face), nearest(hull.vert)
    used, worlds = np.unique(meshes, return_inverse=True)
    vertices = _moved_vertices(model, mesh, used)
    on_face = vertices[:, face]
    normal = np.cross(on_face[:, :, 1] - on_face[:, :, 0], on_face[:, :, -1] - on_face[:, :, 0])
    with np.errstate(invalid="ignore"):
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    height = np.einsum("wfx,wvx->wfv", normal, vertices)
    height -= np.einsum("wfx,wfx->wf", normal, on_face[:, :, 0])[..., None]
    has_faces = height.max(axis=(1, 2)) <= _FLATNESS * np.ptp(vertices, axis=(1, 2))  # false for NaN
    if not has_faces.all():
        other = model.mesh(used[has_faces.argmin()]).name
        raise ValueError(f"the convex hulls of the meshes '{model.mesh(mesh).name}' and '{other}' have other "
                         "faces, and MJX has the faces of a geom's hull once for all worlds")
    # Finds the normals of the two faces that meet at each edge.
    ends = corner[np.asarray(hull.edge)]
    meets = (face[None, :, :, None] == ends[:, None, None]).any(axis=2).all(axis=-1)
    likeness = np.asarray(hull.edge_face_normal) @ np.asarray(hull.face_normal).T
    owner = np.where(meets[:, None], likeness, -2).argmax(axis=-1)
    moved = (vertices[:, corner], on_face, normal, normal[:, owner])
    vert, face, normal, edge_normal = (jax.numpy.asarray(array[worlds], hull.vert.dtype) for array in moved)
    edge = jax.numpy.broadcast_to(hull.edge, (len(meshes), *hull.edge.shape))
    return type(hull)(vert, face, normal, edge, edge_normal)


def _vertices(model: MjModel, mesh: int) -> Any:
    first = model.mesh_vertadr[mesh]
    return model.mesh_vert[first:first + model.mesh_vertnum[mesh]].astype(float)


def _moved_vertices(model: MjModel, mesh: int, meshes: Any) -> Any:
    """Returns the vertices of each of these meshes. Raises ValueError if their number differs from
    that of `mesh`.
    """
    import numpy as np

    number = model.mesh_vertnum[mesh]
    differs = model.mesh_vertnum[meshes] != number
    if differs.any():
        other = meshes[differs.argmax()]
        raise ValueError(f"the mesh '{model.mesh(mesh).name}' has {number} vertices and '{model.mesh(other).name}' "
                         f"{model.mesh_vertnum[other]}, and MJX has as many in all worlds")
    return np.stack([_vertices(model, other) for other in meshes])
