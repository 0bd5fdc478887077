"""One variant of an object."""
# mypy: disable-error-code="no-any-return, type-arg"

from __future__ import annotations

import hashlib
import importlib
import json
import os
from typing import TYPE_CHECKING, Any

from ._findings import Finding, MismatchError

if TYPE_CHECKING:
    import numpy as np
    from mujoco import MjModel  # type: ignore[import-not-found, import-untyped, unused-ignore]

_PIP = "python -m pip install 'mujoco>=2.2.2'"


def _numpy() -> Any:
    try:
        import numpy
    except ImportError as error:
        raise ImportError("this needs NumPy: python -m pip install numpy") from error
    return numpy


def mujoco_of(given: Any) -> Any:
    """The given module, or the `mujoco` that is installed. Raises ImportError."""
    module = given
    if module is None:
        try:
            module = importlib.import_module("mujoco")
        except ImportError as error:
            raise ImportError(f"no MuJoCo to load it in: {_PIP}") from error
    version = str(getattr(module, "__version__", ""))
    numbers = tuple(int(part) for part in version.split(".")[:2] if part.isdigit())
    if not hasattr(module, "MjModel") or numbers < (2, 2):
        name = getattr(module, "__name__", repr(module))
        raise ImportError(f"{name} {version} is not MuJoCo's Python package from 2.2 on: {_PIP}")
    return module


class Variant:
    """An MJCF file and what is known about it. Frames: the object's own (m, kg, kg m^2)."""

    __slots__ = ("xml_bytes", "_record_bytes", "_files_bytes", "_contents", "findings", "_record")

    xml_bytes: bytes  # the file, as the command writes it
    findings: tuple[Finding, ...]  # warnings

    def __init__(self, xml: bytes, record: bytes, files: bytes, contents: bytes,
                 findings: tuple[Finding, ...]):
        self.xml_bytes = xml
        self._record_bytes = record
        self._files_bytes = files
        self._contents = contents
        self.findings = findings
        self._record: dict[str, Any] = {}

    @property
    def xml(self) -> str:
        """The MJCF file."""
        return self.xml_bytes.decode()

    @property
    def record(self) -> dict[str, Any]:
        """Its line of a manifest."""
        if not self._record:
            self._record = json.loads(self._record_bytes)
        return self._record

    @property
    def index(self) -> int:
        return self.record["index"]

    @property
    def seed(self) -> int:
        return self.record["seed"]

    @property
    def params(self) -> dict[str, Any]:
        """What was drawn or computed for each parameter."""
        return self.record["params"]

    @property
    def mass(self) -> float:
        """kg"""
        return self.record["mass"]

    @property
    def com(self) -> "np.ndarray":
        """Center of mass, (3,), m."""
        return _numpy().array(self.record["com"])

    @property
    def inertia(self) -> "np.ndarray":
        """About the center of mass, (3, 3), kg m^2."""
        xx, yy, zz, xy, xz, yz = self.record["inertia"]
        return _numpy().array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])

    @property
    def bounds(self) -> "np.ndarray":
        """Corners of the axis-aligned box around it at the start, (2, 3): min and max; m."""
        box = self.record["aabb"]
        return _numpy().array([box["min"], box["max"]])

    @property
    def swept_bounds(self) -> "np.ndarray":
        """Corners of a box around it at all positions of its joints, (2, 3): min and max; m."""
        box = self.record["swept_aabb"]
        return _numpy().array([box["min"], box["max"]])

    @property
    def places(self) -> list[dict[str, Any]]:
        """Where `place:` has put each body: its name ("body"), its region or site ("at"), and its
        "pos" (m) and "quat" in the object's frame at the start.
        """
        return self.record.get("places", [])

    @property
    def left_out(self) -> list[str]:
        """Names of the bodies with `fewer: true` for which there was no room."""
        return self.record.get("left_out", [])

    @property
    def files(self) -> dict[str, bytes]:
        """Meshes and textures by their names in the XML: those that the spec names, read now, and
        with `assets="files"` all others as OBJ and PNG. Written under these names beside the XML,
        they are what the command writes. Most objects have none with `assets="inline"`.
        """
        files = {}
        start = 0
        for name, path, size in json.loads(self._files_bytes or b"[]"):
            if path:
                with open(os.fsencode(path), "rb") as file:
                    files[name] = file.read()
                if hashlib.sha256(files[name]).hexdigest() != self.record["assets"][name]:
                    raise OSError(f"'{path}' has changed since this variant was made")
            else:
                files[name] = self._contents[start:start + size]
                start += size
        return files

    def load(self, mujoco: Any = None) -> "MjModel":
        """A mujoco.MjModel of it, in the given module or the one that is installed."""
        return mujoco_of(mujoco).MjModel.from_xml_string(self.xml, self.files)

    def verify(self, mujoco: Any = None, tolerance: float = 1e-6) -> "MjModel":
        """Loads it and compares what was compiled with what was meant: the numbers of bodies,
        joints and geoms, names, mass, center of mass, inertia, bounds and start state. `tolerance`
        is relative to the mass, the size and their products. Returns the model; raises
        MismatchError.
        """
        from ._comparison import Comparison

        mujoco = mujoco_of(mujoco)
        model = self.load(mujoco)
        differences = Comparison(mujoco, model, self.record, self.xml_bytes, tolerance).run()
        if differences:
            name = f"{self.record['name']} {self.index} of seed {self.seed}"
            words = "; ".join(difference.message for difference in differences)
            raise MismatchError(f"{name}: in MuJoCo {mujoco.__version__} {words}")
        return model

    def __repr__(self) -> str:
        return f"<mjforge.Variant {self.record['name']} {self.index} of seed {self.seed}>"
