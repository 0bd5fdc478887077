"""One variant of a spec: an MJCF file and its record."""
# mypy: disable-error-code="no-any-return, type-arg"

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import importlib
import math
import os
import pathlib
import tempfile
import types
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional, Sequence, Union

from . import _attach
from ._findings import Finding, MismatchError, VariantError
from ._json import copied, loads, members_of_record
from ._members import Joint, Members, Position, Site, elements, members_of
from ._options import path as path_of
from ._options import real
from ._parameters import with_settings

if TYPE_CHECKING:
    import numpy as np
    from mujoco import MjData, MjModel, MjsBody, MjSpec  # type: ignore[import-not-found, import-untyped, unused-ignore]

    from ._picture import Layer, Picture, Size
    from ._spec import Source, Spec

ON_FLOOR = (0.0,) * 6  # Variant.standing_box for the target scene
_PIP = "python -m pip install 'mujoco>=2.2.2'"


def _numpy() -> Any:
    try:
        import numpy
    except ImportError as error:
        raise ImportError("this needs NumPy: python -m pip install numpy") from error
    return numpy


def mujoco_of(given: Any) -> Any:
    """Returns the given module, or the installed `mujoco`. Raises ImportError if there is none, or
    if it is older than 2.2.
    """
    module = given
    if module is None:
        try:
            module = importlib.import_module("mujoco")
        except ImportError as error:
            raise ImportError(f"no MuJoCo to load it in: {_PIP}") from error
    if not isinstance(module, types.ModuleType) and not hasattr(module, "MjModel"):
        raise TypeError(f"mujoco={module!r} is not a module but of type {type(module).__name__}")
    version = str(getattr(module, "__version__", ""))
    numbers = tuple(int(part) for part in version.split(".")[:2] if part.isdigit())
    if not hasattr(module, "MjModel") or numbers < (2, 2):
        name = getattr(module, "__name__", repr(module))
        raise ImportError(f"{name} {version} is not MuJoCo's Python package from 2.2 on: {_PIP}")
    return module


class Variant:
    """A variant of a spec: an MJCF file, and its record with values and measurements. Quantities
    are in the object's own frame (m, kg, kg m^2). Variants with the same file and the same record are
    equal. Dicts and lists that properties return are copies, so that a variant does not change.
    """

    __slots__ = ("xml_bytes", "record_bytes", "_files_bytes", "_contents", "findings", "_record",
                 "_members", "_standing_box", "_view")

    xml_bytes: bytes  # the MJCF file, as the command writes it
    record_bytes: bytes  # the record, a line of a manifest, JSON
    findings: tuple[Finding, ...]  # warnings about the variant; after `from_record` and in a Batch, those of the record

    def __init__(self, xml: bytes, record: bytes, files: bytes, contents: bytes,
                 findings: tuple[Finding, ...], view: Optional[Mapping[str, Any]] = None,
                 standing_box: Optional[Sequence[float]] = None):
        self.xml_bytes = xml
        self.record_bytes = record
        self._files_bytes = files
        self._contents = contents
        self.findings = findings
        self._view = view or {"pose": {}}
        self._record: dict[str, Any] = {}
        self._members: Optional[Members] = None
        self._standing_box = standing_box

    @staticmethod
    def from_record(record: Mapping[str, Any], spec: "Union[Source, Spec, None]" = None) -> "Variant":
        """Makes a variant again from its record, a line of a manifest, and compares the hashes.

        `spec`: the spec, if its file is not in the working folder, or if it was a text or a mapping.
        Raises FileNotFoundError if the file is not there, MismatchError if the spec has changed or
        the file differs.

        >>> import mjforge
        >>> record = mjforge.Spec("mug").variants(seed=7)[41].record
        >>> mjforge.Variant.from_record(record)
        <mjforge.Variant mug 41 of seed 7 for mujoco>
        """
        from ._replay import replay

        return replay(record, spec)

    @property
    def xml(self) -> str:
        """The MJCF file, as text."""
        return self.xml_bytes.decode()

    @property
    def record(self) -> dict[str, Any]:
        """The record: the variant's line of a manifest, read anew at each access."""
        return dict(loads(self.record_bytes))

    def _facts(self) -> dict[str, Any]:
        """Returns the record, which is read at the first call and must not be changed."""
        if not self._record:
            self._record = self.record
        return self._record

    @property
    def view(self) -> dict[str, Any]:
        """`view:` of the spec: azimuth and elevation (degrees), pose (rad, m)."""
        return copied(self._view)

    @property
    def standing_box(self) -> Sequence[float]:
        """The bounding box, min and max, whose bottom `attach` puts at `pos`: that of `bounds`. Zeros for
        the target scene, whose files have the object on the floor.
        """
        if self._standing_box is None:
            box, target = members_of_record(self.record_bytes, ("aabb", "target"))
            self._standing_box = ON_FLOOR if target == "scene" else (*box["min"], *box["max"])
        return self._standing_box

    def _own_members(self) -> Members:
        """Returns the members, which are read at the first call and must not be changed."""
        if self._members is None:
            self._members = members_of(elements(self.xml_bytes))
        return self._members

    @property
    def members(self) -> Members:
        """Joints, sites, actuators and first body of the object."""
        own = self._own_members()
        return dataclasses.replace(own, joints=dict(own.joints), sites=dict(own.sites),
                                   actuators=list(own.actuators), key=copied(own.key))

    @property
    def name(self) -> str:
        """Name of the object, with which the names in the file begin."""
        return str(self._facts()["name"])

    @property
    def joints(self) -> dict[str, Joint]:
        """Joints by name, in the order of MuJoCo's `qpos`; each has name, type, body, range and
        start.
        """
        return dict(self._own_members().joints)

    @property
    def sites(self) -> dict[str, Site]:
        """Sites by name; each has name, body, pos and quat."""
        return dict(self._own_members().sites)

    @property
    def pose(self) -> dict[str, Position]:
        """Start positions of the joints by name: rad or m for a hinge or slide, a quaternion for a
        ball joint, pos and quat for a free joint. The free joint of the first body is left out,
        because the scene places that body.
        """
        members = self._own_members()
        return {name: joint.start for name, joint in members.joints.items() if name != members.root_joint}

    @property
    def index(self) -> int:
        """Index of the variant among those of its spec and seed."""
        return self._facts()["index"]

    @property
    def seed(self) -> int:
        """Seed of the draws; see Spec.variants."""
        return self._facts()["seed"]

    @property
    def params(self) -> dict[str, Any]:
        """Values of the parameters, drawn or computed."""
        return copied(self._facts()["params"])

    @property
    def mass(self) -> float:
        """Mass, kg."""
        return self._facts()["mass"]

    @property
    def com(self) -> "np.ndarray":
        """Center of mass, (3,), m."""
        return _numpy().array(self._facts()["com"])

    @property
    def inertia(self) -> "np.ndarray":
        """Inertia about the center of mass, (3, 3), kg m^2."""
        xx, yy, zz, xy, xz, yz = self._facts()["inertia"]
        return _numpy().array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])

    @property
    def bounds(self) -> "np.ndarray":
        """Corners of the axis-aligned bounding box at the start, (2, 3): min and max; m."""
        box = self._facts()["aabb"]
        return _numpy().array([box["min"], box["max"]])

    @property
    def swept_bounds(self) -> "np.ndarray":
        """Corners of a box around the object at all positions of its joints, (2, 3): min and max;
        m.
        """
        box = self._facts()["swept_aabb"]
        return _numpy().array([box["min"], box["max"]])

    @property
    def places(self) -> list[dict[str, Any]]:
        """Bodies that `place:` has put somewhere: name ("body"), region or site ("at"), and "pos"
        (m) and "quat" in the object's frame at the start.
        """
        return copied(self._facts().get("places", []))

    @property
    def left_out(self) -> list[str]:
        """Names of the bodies with `fewer: true` for which there was no room."""
        return list(self._facts().get("left_out", []))

    @property
    def files(self) -> dict[str, bytes]:
        """Meshes and textures by their names in the XML: files that the spec names, which are read
        now, and with `assets="files"` all others as OBJ and PNG. Written under these names beside
        the XML, the files are those that the command writes. Most objects have none with
        `assets="inline"`.
        """
        files: dict[str, bytes] = {}
        if not self._files_bytes:
            return files
        start = 0
        for name, path, size in loads(self._files_bytes):
            if path:
                with open(path, "rb") as file:
                    files[name] = file.read()
                if hashlib.sha256(files[name]).hexdigest() != self._facts()["assets"][name]:
                    raise OSError(f"'{path}' has changed since the Spec of this variant first used it")
            else:
                files[name] = self._contents[start:start + size]
                start += size
        return files

    def load(self, mujoco: Any = None) -> "MjModel":
        """Returns a mujoco.MjModel of the variant, loaded by the given module or the installed one.

        >>> model = mjforge.Spec("mug").variants()[0].load()  # doctest: +SKIP
        >>> data = mujoco.MjData(model)  # doctest: +SKIP
        """
        return mujoco_of(mujoco).MjModel.from_xml_string(self.xml, self.files)

    def attach(
        self,
        scene: "MjSpec",
        *,
        prefix: str = "",
        pos: _attach.Numbers = (0.0, 0.0, 0.0),
        quat: _attach.Numbers = (1.0, 0.0, 0.0, 0.0),
        stand: bool = True,
    ) -> "MjsBody":
        """Adds the object to a scene, a mujoco.MjSpec, and returns the object's first body in the
        scene.

        `prefix`: prefix of the object's names; ValueError if the scene then has the name of the first
        body already. `pos`, `quat` (w x y z): place of the object in the world, as lists or arrays.
        `stand`: if true, `pos` is the height of the object's bottom, otherwise of its origin; the
        bottom is that of the bounding box at the start. A reset of the scene sets the object to its
        start, unless that is in a keyframe, as for objects without a free body
        (Spec(set={"root.start": "zero"}) has no keyframe). Keyframes are not added to the scene:
        call `start`.

        >>> scene = mujoco.MjSpec.from_file("table.xml")  # doctest: +SKIP
        >>> laptop = mjforge.Spec("laptop").variants(seed=3)[1]  # doctest: +SKIP
        >>> body = laptop.attach(scene, prefix="laptop/", pos=(0.1, 0, 0.42))  # doctest: +SKIP
        >>> model = scene.compile()  # doctest: +SKIP
        """
        return _attach.attach(self, scene, prefix, pos, quat, stand)

    def start(self, model: "MjModel", data: "MjData", prefix: str = "") -> None:
        """Sets joints, velocities, activations and controls of the object in a simulation to its
        start state. The first body stays at its pose; other free bodies, and velocities of free
        bodies, are relative to it. `prefix`: the prefix with which the object was attached.

        >>> data = mujoco.MjData(model)  # doctest: +SKIP
        >>> laptop.start(model, data, "laptop/")  # doctest: +SKIP
        """
        _attach.start(self, model, data, prefix)

    def save(self, path: Union[str, "os.PathLike[str]"]) -> pathlib.Path:
        """Writes the MJCF file, and beside it the meshes and textures in `files`. `path`: the file,
        or a folder, in which the file gets the name that the command gives it. A folder exists, or is a
        text that ends with "/"; such a folder is made. Returns the path of the file. Raises
        FileExistsError if there is a mesh or texture of the name with another content, such as one of
        another spec.

        >>> import mjforge, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     mjforge.Spec("mug").variants()[3].save(f"{folder}/mugs/").name
        'mug_000003.xml'
        """
        name = path_of(path, "path")
        file = pathlib.Path(name)
        if name.endswith(os.sep):
            file.mkdir(parents=True, exist_ok=True)
        if file.is_dir():
            file /= os.path.basename(self._facts().get("file") or f"{self.name}_{self.index:06}.xml")
        files = {file.parent / name: content for name, content in self.files.items()}
        for beside, content in files.items():
            if beside.exists() and beside.read_bytes() != content:
                raise FileExistsError(f"'{beside}' has another content: save to another folder, or remove it")
        file.write_bytes(self.xml_bytes)
        for beside, content in files.items():
            beside.parent.mkdir(parents=True, exist_ok=True)
            beside.write_bytes(content)
        return file

    @contextlib.contextmanager
    def as_file(self) -> Iterator[pathlib.Path]:
        """Writes the files to a temporary folder and yields the path of the MJCF file, for hosts that
        read only files. Removes the folder at the end of the `with` block.

        >>> import mjforge
        >>> with mjforge.Spec("spoon").variants(assets="files")[0].as_file() as path:
        ...     path.name, path.with_name("assets").is_dir()
        ('spoon_000000.xml', True)
        """
        with tempfile.TemporaryDirectory() as folder:
            yield self.save(folder)

    def png(self, size: "Size" = 640, layer: "Layer" = "visual",
            pose: Optional[Mapping[str, float]] = None) -> "Picture":
        """Draws the object as `mjforge preview` does. Returns the bytes of a PNG file.

        `size`: pixels, a number or (width, height). `layer`: "visual", "collision", "bounds",
        "inertia", "joints" or "regions". `pose`: positions of hinges (rad) and slides (m) that are
        not at their start. Camera and other joints are those of the spec's `view:`; an object that
        was read from a batch has no `view:`. Raises VariantError if nothing can be drawn.

        >>> laptop = mjforge.Spec("laptop").variants(seed=3)[1]  # doctest: +SKIP
        >>> laptop.png(size=(300, 200), pose={"hinge": 2.0}).save("laptop.png")  # doctest: +SKIP
        """
        from ._picture import draw

        return draw([self], size, layer, pose)

    def _repr_png_(self) -> Optional[bytes]:
        """Returns a picture for a notebook; None if no renderer works."""
        try:
            return bytes(self.png(320))
        except (VariantError, OSError):
            return None

    def verify(self, mujoco: Any = None, tolerance: float = 1e-6) -> "MjModel":
        """Loads the variant and compares the model with the record: numbers of bodies, joints and
        geoms, names, mass, center of mass, inertia, bounds and start state. `tolerance` is relative
        to the mass, to the size and to their products. Returns the model; raises MismatchError if
        there is a difference.

        >>> for variant in mjforge.Spec("mug").variants()[:100]:  # doctest: +SKIP
        ...     model = variant.verify()
        """
        from ._comparison import Comparison

        if not 0 <= real(tolerance, "tolerance") < math.inf:
            raise ValueError(f"tolerance={tolerance!r} is not a number from 0 on")
        mujoco = mujoco_of(mujoco)
        model = self.load(mujoco)
        differences = Comparison(mujoco, model, self._facts(), self.xml_bytes, tolerance).run()
        if differences:
            name = f"{self._facts()['name']} {self.index} of seed {self.seed}"
            words = "; ".join(difference.message for difference in differences)
            raise MismatchError(f"{name}: in MuJoCo {mujoco.__version__} {words}")
        return model

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Variant):
            return NotImplemented
        return (self.xml_bytes, self.record_bytes) == (other.xml_bytes, other.record_bytes)

    def __hash__(self) -> int:
        return hash(self.record_bytes)

    def __repr__(self) -> str:
        facts = self._facts()
        return (f"<mjforge.Variant {self.name}{with_settings(facts.get('set', {}))} {self.index} of seed {self.seed} "
                f"for {facts['target']}>")
