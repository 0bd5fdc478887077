"""Pictures of variants, drawn by the command `mjforge preview`.

The command draws in a process of its own, because a renderer in this process would share OpenGL,
and the current context of OpenGL, with the renderer of the user's MuJoCo.
"""

from __future__ import annotations

import math
import os
import pathlib
import tempfile
from typing import TYPE_CHECKING, Any, Iterable, Literal, Mapping, Optional, Union, get_args

from . import _command
from ._findings import VariantError
from ._library import c_number
from ._options import path as path_of
from ._options import text

if TYPE_CHECKING:
    from ._variant import Variant

Layer = Literal["visual", "collision", "bounds", "inertia", "joints", "regions"]
Size = Union[int, tuple[int, int]]  # width and height in pixels; one number for both


class Picture(bytes):
    """The bytes of a PNG file, which a notebook shows as a picture."""

    def _repr_png_(self) -> bytes:
        return bytes(self)

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the file."""
        pathlib.Path(path_of(path, "path")).write_bytes(self)

    def __repr__(self) -> str:
        width, height = (int.from_bytes(self[at:at + 4], "big") for at in (16, 20))
        return f"<mjforge.Picture {width} x {height}>"

    __str__ = __repr__


def _size_of(size: Any) -> str:
    numbers = size if isinstance(size, (tuple, list)) else (size,)
    if len(numbers) not in (1, 2):
        raise ValueError(f"size={size!r} is not a number of pixels or (width, height)")
    for number in numbers:
        if not 16 <= c_number(number, "size") <= 4096:
            raise ValueError(f"size={size!r} is not within 16 .. 4096 pixels")
    return "x".join(str(int(number)) for number in numbers)


def _layer_of(layer: Any) -> str:
    name = text(layer, "layer")
    if name not in get_args(Layer):
        raise ValueError(f"layer={layer!r} is not one of {', '.join(get_args(Layer))}")
    return name


def _joints_of(pose: Any) -> list[str]:
    if not isinstance(pose, Mapping):
        raise TypeError(f"pose={pose!r} is not a mapping of joints to positions")
    words = []
    for joint, value in pose.items():
        joint = text(joint, "pose")
        if isinstance(value, (str, bytes, bool, complex)) or not hasattr(value, "__float__"):
            raise TypeError(f"pose={pose!r}: the position of {joint!r} is not a number")
        if not math.isfinite(value):
            raise ValueError(f"pose={pose!r}: the position of {joint!r} is not finite")
        words += ["--joint", f"{joint}={float(value)!r}"]
    return words


def _takes(variant: Variant, name: str, value: float) -> bool:
    """Returns True if exactly one joint of the variant has this name, whose first words may be left
    out, and is a hinge or slide whose range contains the position.
    """
    joints = variant.joints
    fitting = [name] if name in joints else [joint for joint in joints if joint.endswith("_" + name)]
    if len(fitting) != 1 or joints[fitting[0]].type not in ("hinge", "slide"):
        return False
    low, high = joints[fitting[0]].range or (-math.inf, math.inf)
    slack = 1e-6 * (high - low) if math.isfinite(high - low) else 0.0
    return low - slack <= value <= high + slack


def _view_of(variants: list[Variant]) -> list[str]:
    """Returns the options of the command for the camera and the joint positions of the spec's
    `view:`.
    """
    view = variants[0].view
    pose = {name: value for name, value in view["pose"].items()
            if any(_takes(variant, name, value) for variant in variants)}
    angles = [word for angle in ("azimuth", "elevation") if angle in view
              for word in (f"--{angle}", repr(view[angle]))]
    return angles + _joints_of(pose)


def draw(variants: Iterable[Variant], size: Optional[Size], layer: Layer,
         pose: Optional[Mapping[str, float]] = None) -> Picture:
    """Draws a variant, or a contact sheet of several variants."""
    words = ["--layer", _layer_of(layer)]
    explicit = _joints_of({} if pose is None else pose)
    if size is not None:
        words += ["--size", _size_of(size)]
    with tempfile.TemporaryDirectory() as folder:
        files: list[str] = []
        drawn: list[Variant] = []
        for variant in variants:
            inner = pathlib.Path(folder, str(len(files)))
            inner.mkdir()
            files.append(str(variant.save(inner)))
            drawn.append(variant)
        if not 0 < len(files) <= 400:
            raise ValueError(f"a sheet has 1 to 400 variants, not {len(files)}")
        words += [*_view_of(drawn), *explicit]  # if a joint has two positions, the last one counts
        picture = pathlib.Path(folder, "picture.png")
        findings = _command.run(["preview", *words, "-o", str(picture), "--", *files], b"").findings
        if not picture.exists():
            raise VariantError(findings)
        return Picture(picture.read_bytes())
