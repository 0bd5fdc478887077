"""A spec, and the variants of it."""

from __future__ import annotations

import ctypes
import itertools
import json
import operator
import os
from typing import Any, Iterator, Mapping, Optional, Sequence, Union, overload

from . import _command
from ._findings import Finding, SpecError, VariantError
from ._library import (CATALOGUE, Request, VariantTexts, bytes_of, c_number, c_text, c_texts,
                       library)
from ._variant import Variant

Source = Union[str, "os.PathLike[str]", Mapping[str, Any]]


def _plain(value: Any) -> Any:
    """Of NumPy's scalars and arrays, for json.dumps."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a {type(value).__name__} is not a value of a spec: {value!r}")


def _yaml(value: Any) -> str:
    """JSON is YAML. Raises ValueError for infinities and NaN."""
    return json.dumps(value, default=_plain, ensure_ascii=False, allow_nan=False)


def _found(said: bytes) -> tuple[Finding, ...]:
    return tuple(Finding(members, text) for members, text in json.loads(said or b"[]"))


def _reference_and_text(source: Source) -> tuple[Optional[str], Optional[str]]:
    if isinstance(source, Mapping):
        return None, _yaml(source)
    path = os.fspath(source)
    if not isinstance(path, str):
        raise TypeError("a spec is a str, a path or a mapping")
    return (None, path) if "\n" in path else (path, None)


class _Maker:
    """An open spec in the library; for one thread at a time."""

    __slots__ = ("handle", "texts", "pointer")

    def __init__(self, spec: "Spec", options: Mapping[str, Any]) -> None:
        self.handle = None
        reference, text = _reference_and_text(spec.source)
        place_seed = options["place_seed"]
        pairs = [word for pair in spec.settings.items() for word in pair]
        request = Request(
            spec=None if reference is None else c_text(reference, "spec"),
            text=None if text is None else c_text(text, "spec"),
            text_name=b"<spec>",
            catalogue=os.fsencode(CATALOGUE),
            settings=c_texts(pairs, "set"),
            setting_count=len(spec.settings),
            parameter_files=c_texts(spec.parameter_files, "parameters"),
            parameter_file_count=len(spec.parameter_files),
            place_seed=(None if place_seed is None else
                        ctypes.pointer(ctypes.c_uint64(c_number(place_seed, "place_seed")))),
            **{name: (c_text if isinstance(default, str) else c_number)(options[name], name)
               for name, default in _DEFAULTS.items() if default is not None},
        )
        self.handle = library.MjforgeOpen(ctypes.byref(request))
        if not self.handle:
            raise MemoryError
        self.texts = VariantTexts()
        self.pointer = ctypes.byref(self.texts)

    def __del__(self) -> None:
        if self.handle:
            library.MjforgeClose(self.handle)

    def check(self) -> tuple[Finding, ...]:
        """Warnings of the loading; raises what hinders."""
        failure = bytes_of(library.MjforgeFailure(self.handle))
        if failure:
            raise ValueError(failure.decode())
        findings = _found(bytes_of(library.MjforgeFindings(self.handle)))
        if any(finding.severity == "error" for finding in findings):
            raise SpecError(findings)
        return findings

    def make(self, index: int) -> Variant:
        status = library.MjforgeMake(self.handle, index, self.pointer)
        texts = self.texts
        if status == 2:
            failure = bytes_of(library.MjforgeFailure(self.handle)).decode()
            raise MemoryError if failure == "not enough memory" else RuntimeError(failure)
        read = ctypes.string_at
        size = texts.findings_size
        findings = _found(read(texts.findings, size)) if size else ()
        if status == 1:
            raise VariantError(findings)
        size = texts.files_size
        files = read(texts.files, size) if size else b""
        size = texts.contents_size
        contents = read(texts.contents, size) if size else b""
        return Variant(read(texts.xml, texts.xml_size), read(texts.record, texts.record_size),
                       files, contents, findings)


_DEFAULTS = {"name": "", "target": "mujoco", "assets": "inline", "sampler": "random", "on_invalid": "fail",
             "validate": "none", "seed": 0, "batch": 0, "place_seed": None}


class Spec:
    """A family of objects.

    `spec`: a name in the catalogue, a path, YAML (a text with a line break) or the same as a
    mapping. `set`: parameters, each as a number, a list or any text a spec allows
    ("20cm .. 30cm"); "root.joints", "root.start" and "checks.profile" are names, too. `parameters`:
    YAML files of parameters. Raises SpecError with everything that is wrong.
    """

    name: str
    description: str
    parameters: list[dict[str, str]]  # name, unit and doc of each
    findings: tuple[Finding, ...]  # warnings

    def __init__(
        self,
        spec: Source,
        *,
        set: Optional[Mapping[str, Any]] = None,
        parameters: Sequence[Union[str, "os.PathLike[str]"]] = (),
    ) -> None:
        self.source = spec
        self.settings = self._texts_of(set or {})
        if isinstance(parameters, (str, bytes, os.PathLike)):
            raise TypeError(f"parameters={parameters!r} is not a list of files: write [{parameters!r}]")
        self.parameter_files = tuple(os.fspath(path) for path in parameters)
        maker = _Maker(self, _DEFAULTS)
        self.findings = maker.check()
        for member, value in json.loads(bytes_of(library.MjforgeDescription(maker.handle))).items():
            setattr(self, member, value)

    @staticmethod
    def _texts_of(settings: Mapping[str, Any]) -> dict[str, str]:
        if not isinstance(settings, Mapping):
            raise TypeError(f"set={settings!r} is not a mapping of names to values")
        return {name: v if isinstance(v, str) else _yaml(v) for name, v in settings.items()}

    @staticmethod
    def command_line(
        source: Source, settings: Mapping[str, Any], parameter_files: Sequence[str]
    ) -> tuple[str, Optional[str], list[str]]:
        """For the command: the spec's argument, standard input, options."""
        reference, text = _reference_and_text(source)
        words = [f"--set={name}={v}" for name, v in Spec._texts_of(settings).items()]
        words += [f"--params={path}" for path in parameter_files]
        return "-" if reference is None else reference, text, words

    def variants(
        self,
        seed: int = 0,
        *,
        target: str = "mujoco",
        assets: str = "inline",
        name: str = "",
        sampler: str = "random",
        batch: int = 0,
        on_invalid: str = "fail",
        validate: str = "none",
        place_seed: Optional[int] = None,
    ) -> "Variants":
        """Its variants: the same that `mjforge generate` makes with these options.

        `assets="files"`: meshes are OBJ and textures PNG, in `Variant.files`, not in the XML.
        `name`: of the object; "${index}" allowed. `batch`: variants that the draws are spread
        over, for samplers that need to know. `on_invalid="skip"`: iteration leaves out what cannot
        be made. `validate`: "none", "load" or "physics", in the MuJoCo that the package contains.
        `place_seed`: seed of the places alone: the same objects elsewhere.
        """
        return Variants(self, {"name": name, "target": target, "assets": assets, "sampler": sampler,
                               "on_invalid": on_invalid, "validate": validate, "seed": seed,
                               "batch": batch, "place_seed": place_seed})

    def __repr__(self) -> str:
        return f"<mjforge.Spec {self.name}>"


class Variants:
    """Variants of a spec, by index: without end, or those of a slice. Made when asked for, each
    time anew; threads may share it, and run in parallel while variants are made.
    """

    def __init__(self, spec: Spec, options: dict[str, Any],
                 indices: Optional[range] = None, makers: Optional[list[_Maker]] = None) -> None:
        self.spec = spec
        self._options = options
        self._indices = indices
        if makers is None:
            makers = [_Maker(spec, options)]
            makers[0].check()
        self._makers = makers  # idle ones; a list's pop and append are atomic

    def _make(self, index: int) -> Variant:
        if not 0 <= index < 2**64:
            raise IndexError(f"{index} is not within 0 .. 2^64 - 1")
        try:
            maker = self._makers.pop()
        except IndexError:
            maker = _Maker(self.spec, self._options)
            maker.check()
        try:
            return maker.make(index)
        finally:
            self._makers.append(maker)

    @overload
    def __getitem__(self, key: int) -> Variant: ...
    @overload
    def __getitem__(self, key: slice) -> "Variants": ...
    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, slice):
            return Variants(self.spec, self._options, self._range(key), self._makers)
        if self._indices is not None:
            return self._make(self._indices[key])
        return self._make(operator.index(key))

    def _range(self, key: slice) -> range:
        if self._indices is not None:
            return self._indices[key]
        start = 0 if key.start is None else operator.index(key.start)
        if key.stop is None or start < 0 or operator.index(key.stop) < 0:
            raise IndexError("a slice of variants has a start and an end, counted from 0")
        return range(start, key.stop, 1 if key.step is None else key.step)

    def __len__(self) -> int:
        if self._indices is None:
            raise TypeError("variants are without end: take a slice, such as variants[0:1000]")
        return len(self._indices)

    def __iter__(self) -> Iterator[Variant]:
        skip = self._options["on_invalid"] == "skip"
        for index in itertools.count() if self._indices is None else self._indices:
            try:
                yield self._make(index)
            except VariantError:
                if not skip:
                    raise

    def write(
        self,
        output: Union[str, "os.PathLike[str]"],
        count: int,
        *,
        jobs: Optional[int] = None,
        validate: str = "load",
        **options: Any,
    ) -> None:
        """Writes the first `count` as `mjforge generate` does, which it runs: files or archives and
        a manifest.

        `jobs`: processes (default: one per core). Other options are the command's, such as
        `resume=True`, `shard="0/4"`, `time_limit=5` (s). Raises VariantError for those that could
        not be made, after making the others, and OSError where writing fails. After Ctrl-C every
        file is complete, and `resume=True` continues.
        """
        if self._indices is not None:
            raise ValueError("all variants can be written, not a slice: use first=")
        spec = self.spec
        reference, text, words = Spec.command_line(spec.source, spec.settings, spec.parameter_files)
        words += _command.options_of({
            **{name: value for name, value in self._options.items() if value != _DEFAULTS[name]},
            "validate": validate, "count": count, "jobs": jobs, "output": output, **options})
        status, findings = _command.run(["generate", *words, "--", reference], text)
        if status != 0:
            raise VariantError(findings)

    def __reduce__(self) -> Any:
        return _again, (self.spec, self._options, self._indices)

    def __repr__(self) -> str:
        which = "" if self._indices is None else f" {self._indices}"
        return f"<mjforge.Variants of {self.spec.name}{which}>"


def _again(spec: Spec, options: dict[str, Any], indices: Optional[range]) -> Variants:
    return Variants(spec, options, indices)
