"""Specs of random objects, as their files were when they were read."""

from __future__ import annotations

import contextlib
import hashlib
import os
import tempfile
import types
from typing import Any, Mapping, Optional, Sequence, Union

from . import _options, _yaml
from ._findings import Finding, SpecError
from ._json import loads
from ._maker import Maker, Snapshot, compare
from ._options import Assets, OnInvalid, Profile, Sampler, Target, Validate
from ._parameters import Parameter, parameter_of
from ._report import Report
from ._variants import DEFAULTS, Variants, described

Source = Union[str, "os.PathLike[str]", Mapping[str, Any]]


class Spec:
    """A spec of random objects, as its files were when the Spec was made.

    `spec`: a name in the catalogue, a path (an os.PathLike always), YAML (a text with a line break), or the
    content of the YAML as a mapping. `set`: values of parameters, each a number, a list, a pair (a range if the
    parameter is one number; of whole numbers if it draws them) or any text that a spec allows, such as
    "20cm .. 30cm"; "root.joints", "root.start" and "checks.profile" are names, too. `parameters`:
    YAML files with values of parameters. Raises SpecError with all errors of the spec.

    >>> import mjforge
    >>> hammer = mjforge.Spec("hammer", set={"handle_length": (0.2, 0.3)})
    >>> hammer.parameters["handle_length"].range
    (0.2, 0.3)
    >>> hammer.variants(seed=7)[41].params["handle_length"]
    0.2...

    The text of the spec and the texts of all files that it imports are read once and kept; pickles
    contain these texts. Files that variants refer to (meshes, textures, MJCF) are read when they
    are used. Their hashes are kept from the first use on; if such a file has changed when it is read
    again, OSError is raised.
    """

    name: str
    description: str
    path: Optional[str]  # path of the spec's file; None for a text or a mapping
    sha256: str  # hash of the texts of the spec and of its imports
    parameters: Mapping[str, Parameter]
    findings: tuple[Finding, ...]  # warnings about the spec

    _snapshot: Snapshot
    _view: Mapping[str, Any] = {"pose": {}}  # camera and joint positions in `view:` of the spec
    _settings: dict[str, str]
    _key_paths: tuple[str, ...]  # key of each line of the text, if the spec was a mapping
    _inputs: dict[str, str]  # hashes of the files that variants refer to, by path
    parameter_files: tuple[str, ...]

    def __init__(
        self,
        spec: Source,
        *,
        set: Optional[Mapping[str, Any]] = None,
        parameters: Sequence[Union[str, "os.PathLike[str]"]] = (),
    ) -> None:
        reference: Optional[str] = None
        text: Optional[str] = None
        self._key_paths = ()
        if isinstance(spec, Mapping):
            text, self._key_paths = _yaml.block_text(spec)
        else:
            if not isinstance(spec, (str, os.PathLike)):
                raise TypeError(f"spec={spec!r} is not a name, a path, a text or a mapping, but of type "
                                f"{type(spec).__name__}")
            reference = _options.path(spec, "spec")
            if reference == "-":
                raise ValueError("spec='-' is not a name, a path or a text")
            if "\n" in reference and isinstance(spec, str):
                reference, text = None, reference
        if isinstance(parameters, (str, bytes, os.PathLike)) or not isinstance(parameters, Sequence):
            raise TypeError(f"parameters={parameters!r} is not a list of files: write [{parameters!r}]")
        self._snapshot = Snapshot.of(reference, text)
        self._inputs = {}
        self._settings = {}
        self.parameter_files = tuple(
            os.path.abspath(_options.path(path, "parameters")) for path in parameters)
        settings = _yaml.checked_settings(set)
        self.parameters = {}
        self._settings = self._texts_of(settings)
        self._open()

    def _open(self) -> None:
        """Loads the spec and sets the attributes that describe it."""
        self._describe(Maker(self, {**DEFAULTS, "batch": 1}))

    def _describe(self, maker: Maker) -> None:
        self.findings = maker.check()
        members = maker.description()
        self._view = members.pop("view")
        parameters = [parameter_of(each) for each in members.pop("parameters")]
        self.parameters = types.MappingProxyType({each.name: each for each in parameters})
        for member, value in members.items():
            setattr(self, member, value)

    def _texts_of(self, settings: Mapping[str, Any]) -> dict[str, str]:
        """Returns the values of settings as YAML, which may depend on the parameters that the spec
        declares.
        """
        known = self.parameters
        if any(_yaml.needs_parameter(value) and (not known or name in self._settings or self.parameter_files)
               for name, value in settings.items()):
            known = self._declared()
        return {name: _yaml.setting_text(value, known.get(name), known) for name, value in settings.items()}

    def _declared(self) -> Mapping[str, Parameter]:
        """Returns the parameters as the spec declares them, without settings and parameter files; the
        known parameters if the spec then has errors.
        """
        bare = Spec.__new__(Spec)
        bare.__dict__.update(self.__dict__, _settings={}, parameter_files=())
        with contextlib.suppress(SpecError):
            bare._open()
        return bare.parameters

    def _with(self, settings: Optional[Mapping[str, Any]]) -> "Spec":
        """Returns a Spec with further settings, made from the same texts."""
        settings = _yaml.checked_settings(settings)
        if not settings:
            return self
        other = type(self).__new__(type(self))
        other.__dict__.update(self.__dict__)
        other._settings = {**self._settings, **self._texts_of(settings)}
        return other

    def _compare_inputs(self) -> None:
        """Raises OSError if a file that variants have used has changed on the disk."""
        for path, first in list(self._inputs.items()):
            with open(path, "rb") as file:
                compare(path, hashlib.sha256(file.read()).hexdigest(), first)

    @property
    def settings(self) -> Mapping[str, str]:
        """Settings as texts of YAML, by name."""
        return types.MappingProxyType(self._settings)

    @property
    def text(self) -> str:
        """YAML text of the spec."""
        return self.texts["-" if self.path is None else self.path]

    @property
    def texts(self) -> dict[str, str]:
        """Texts that were read, by path: the spec, its imports, tables and parameter files. The
        path of a spec without a file is "-".
        """
        saved = loads(self._snapshot.saved())
        return dict([*saved["texts"], *saved["parameter_texts"]])

    def variants(
        self,
        seed: int = 0,
        *,
        set: Optional[Mapping[str, Any]] = None,
        target: Target = "mujoco",
        assets: Assets = "inline",
        name: str = "",
        sampler: Sampler = "random",
        batch: Optional[int] = None,
        on_invalid: OnInvalid = "fail",
        validate: Validate = "none",
        place_seed: Optional[int] = None,
    ) -> "Variants":
        """Returns variants of the spec, the same that `mjforge generate` makes with these options.

        `set`: further settings, as for Spec, without reading the spec again. `assets="files"`:
        meshes are OBJ files and textures PNG files in `Variant.files`, not in the XML. `name`: name
        of the object; "${index}" is allowed. `batch`: the number of variants over which draws are
        spread by the samplers "latin" and "grid" and by choices with `exact: true`, which require
        it. `on_invalid="skip"`: iteration leaves out variants that cannot be made, and without a slice
        raises VariantError if the first 1000 are such. `validate`: "none", "load" or "physics", in the
        MuJoCo that the package contains. `place_seed`: seed for the places of bodies alone.

        >>> import mjforge
        >>> hammer = mjforge.Spec("hammer")
        >>> for longest in (0.28, 0.3, 0.34):  # a curriculum
        ...     variants = hammer.variants(seed=3, set={"handle_length": (0.26, longest)})
        ...     assert all(v.params["handle_length"] <= longest for v in variants[:5])
        """
        options = _options.checked({
            "name": name, "target": target, "assets": assets, "sampler": sampler,
            "on_invalid": on_invalid, "validate": validate, "seed": seed, "batch": batch,
            "place_seed": place_seed})
        spec = self._with(set)
        if spec is self:
            return Variants(self, options)
        maker = Maker(spec, options)
        spec._describe(maker)
        return Variants(spec, options, [maker])

    def check(
        self,
        count: int = 20,
        *,
        seed: int = 0,
        physics: bool = False,
        profile: Optional[Profile] = None,
        jobs: Optional[int] = None,
        time_limit: Optional[float] = None,
    ) -> Report:
        """Makes the first `count` variants, loads each in the MuJoCo that the package contains, and
        reports those that fail. Writes no files.

        `physics`: also simulates each variant. `profile="simready"`: also runs the tests of the
        SimReady benchmark. `jobs`: number of processes (default: one per core). `time_limit`: time
        for each variant, s.

        >>> import mjforge
        >>> report = mjforge.Spec("mug").check(3)
        >>> report.ok, report.made, list(report.failed)
        (True, 3, [])
        """
        options = _options.checked({"seed": seed, "physics": physics, "profile": profile})
        validate = "physics" if physics or profile not in (None, "none") else "load"
        variants = Variants(self, {**DEFAULTS, "seed": options["seed"], "validate": validate}, [])
        with tempfile.TemporaryDirectory() as folder:
            report = variants.write(os.path.join(folder, "checked.tar"), count, profile=profile,
                                    jobs=jobs, time_limit=time_limit, durability="none")
        return Report(report.count, report.made, report.failed, report.skipped, report.findings, None)

    def __getstate__(self) -> dict[str, Any]:
        state = {**self.__dict__, "_snapshot": self._snapshot.saved()}
        del state["parameters"]  # a read-only mapping cannot be pickled
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state, _snapshot=Snapshot.read(state["_snapshot"]))
        self._open()

    def __repr__(self) -> str:
        return f"<mjforge.Spec {described(self)}>"
