"""Poses of many elements in many worlds, as NumPy arrays. Quaternions are w x y z."""

from __future__ import annotations

from typing import Any, Tuple

Poses = Tuple[Any, Any]  # positions [..., 3] and quaternions [..., 4]


def rotate(quat: Any, vector: Any) -> Any:
    """Rotates vectors by quaternions."""
    import numpy as np

    axis, w = quat[..., 1:], quat[..., :1]
    across = 2 * np.cross(axis, vector)
    return vector + w * across + np.cross(axis, across)


def product(a: Any, b: Any) -> Any:
    """Returns the rotation by b, followed by the rotation by a."""
    import numpy as np

    va, vb, wa, wb = a[..., 1:], b[..., 1:], a[..., :1], b[..., :1]
    w = wa * wb - np.sum(va * vb, axis=-1, keepdims=True)
    return np.concatenate([w, wa * vb + wb * va + np.cross(va, vb)], axis=-1)


def inverse(quat: Any) -> Any:
    """Returns the inverse rotations."""
    return quat * [1, -1, -1, -1]


def compose(outer: Poses, inner: Poses) -> Poses:
    """Returns the poses `inner`, given in the frames `outer`, in the frame in which `outer` is
    given.
    """
    return outer[0] + rotate(outer[1], inner[0]), product(outer[1], inner[1])


def without(whole: Poses, inner: Poses) -> Poses:
    """Returns the poses `outer` for which compose(outer, inner) is `whole`."""
    quat = product(whole[1], inverse(inner[1]))
    return whole[0] - rotate(quat, inner[0]), quat
