"""Objects of the library: snapshots of specs, and the makers of variants."""

from __future__ import annotations

import ctypes
import os
from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence

from ._findings import Finding, SpecError, VariantError
from ._json import loads
from ._library import (CATALOGUE, Request, Text, VariantTexts, bytes_of, c_number, c_text,
                       c_texts, library)
from ._variant import ON_FLOOR, Variant

if TYPE_CHECKING:
    from ._spec import Spec
    from ._table import Table


class Snapshot:
    """A spec with the texts of all files that were read to load it. Threads may share a snapshot.
    """

    __slots__ = ("handle",)

    def __init__(self, handle: Optional[int]) -> None:
        self.handle = handle
        if not handle:
            raise MemoryError

    @classmethod
    def of(cls, reference: Optional[str], text: Optional[str]) -> "Snapshot":
        """Makes a snapshot of a file, of a name in the search path, or of a text."""
        return cls(library.MjforgeNewSnapshot(
            None if reference is None else c_text(reference, "spec"),
            None if text is None else c_text(text, "spec"), os.fsencode(CATALOGUE)))

    @classmethod
    def read(cls, saved: bytes) -> "Snapshot":
        """Makes a snapshot from the result of `saved`. Raises ValueError if that is damaged."""
        handle = library.MjforgeReadSnapshot(saved, len(saved))
        if not handle:
            raise ValueError(f"a pickled Spec is damaged: {saved[:40]!r} does not begin a snapshot")
        return cls(handle)

    def saved(self) -> bytes:
        """Returns the snapshot as JSON, for `read`, and as a spec for the command."""
        return bytes_of(library.MjforgeSnapshotText(self.handle))

    def __del__(self) -> None:
        if getattr(self, "handle", None):
            library.MjforgeCloseSnapshot(self.handle)


def found(said: bytes, key_paths: Sequence[str] = ()) -> tuple[Finding, ...]:
    """Returns the findings in the JSON of MjforgeFindings. `key_paths` has the key of each line of
    a spec that was given as a mapping.
    """
    return tuple(Finding(members, text).set_keys(key_paths) for members, text in loads(said or b"[]"))


def compare(path: str, sha256: str, first: str) -> None:
    """Raises OSError if the hash of a file differs from `first`, the hash at its first use."""
    if sha256 != first:
        raise OSError(f"'{path}' has changed since this Spec first used it: its SHA-256 is {sha256}, "
                      f"and was {first}; make a new Spec")


class Maker:
    """A spec opened in the library to make its variants, for one thread at a time."""

    __slots__ = ("handle", "texts", "pointer", "_key_paths", "_inputs", "_changed", "_view", "_is_scene")

    def __init__(self, spec: "Spec", options: Mapping[str, Any]) -> None:
        self.handle = None
        self._key_paths = spec._key_paths
        self._inputs = spec._inputs
        self._changed = ""
        self._view = spec._view
        self._is_scene = options["target"] == "scene"
        place_seed = options["place_seed"]
        settings = [word for pair in spec.settings.items() for word in pair]
        request = Request(
            snapshot=spec._snapshot.handle,
            settings=c_texts(settings, "set"),
            setting_count=len(settings) // 2,
            parameter_files=c_texts(spec.parameter_files, "parameters"),
            parameter_file_count=len(spec.parameter_files),
            place_seed=(None if place_seed is None else
                        ctypes.pointer(ctypes.c_uint64(c_number(place_seed, "place_seed")))),
            seed=c_number(options["seed"], "seed"),
            batch=c_number(options["batch"] or 0, "batch"),
            **{name: c_text(options[name], name)
               for name in ("name", "target", "assets", "sampler", "on_invalid", "validate")},
        )
        self.handle = library.MjforgeOpen(ctypes.byref(request))
        if not self.handle:
            raise MemoryError
        self.texts = VariantTexts()
        self.pointer = ctypes.byref(self.texts)

    def __del__(self) -> None:
        if getattr(self, "handle", None):
            library.MjforgeClose(self.handle)

    def check(self) -> tuple[Finding, ...]:
        """Returns the warnings of loading the spec. Raises SpecError if the spec has errors,
        ValueError if the request is wrong.
        """
        findings = found(bytes_of(library.MjforgeFindings(self.handle)), self._key_paths)
        if any(finding.severity == "error" for finding in findings):
            raise SpecError(findings)
        failure = bytes_of(library.MjforgeFailure(self.handle))
        if failure:
            raise ValueError(failure.decode())
        return findings

    def description(self) -> dict[str, Any]:
        return dict(loads(bytes_of(library.MjforgeDescription(self.handle))))

    def make(self, index: int) -> Variant:
        if self._changed:
            raise OSError(self._changed)
        status = library.MjforgeMake(self.handle, index, self.pointer)
        texts = self.texts
        if status == 2:
            failure = bytes_of(library.MjforgeFailure(self.handle)).decode()
            raise MemoryError if failure == "not enough memory" else RuntimeError(failure)
        read = ctypes.string_at
        size = texts.findings_size
        findings = found(read(texts.findings, size), self._key_paths) if size else ()
        if status == 1:
            raise VariantError(findings)
        size = texts.inputs_size
        if size:
            self._compare(loads(read(texts.inputs, size)))
        size = texts.files_size
        files = read(texts.files, size) if size else b""
        size = texts.contents_size
        contents = read(texts.contents, size) if size else b""
        return Variant(read(texts.xml, texts.xml_size), read(texts.record, texts.record_size),
                       files, contents, findings, self._view, ON_FLOOR if self._is_scene else (*texts.box,))

    def add_rows(self, indices: range, table: "Table") -> int:
        """Adds the records of these variants to a table, up to the first variant that fails.
        Returns the number of records added.
        """
        if self._changed:
            raise OSError(self._changed)
        inputs = Text()
        count: int = library.MjforgeMakeRows(self.handle, indices.start % 2**64, indices.step % 2**64,
                                             len(indices), table.handle, inputs)
        self._compare(loads(bytes_of(inputs) or b"[]"))
        return count

    def _compare(self, inputs: list[list[str]]) -> None:
        """Raises OSError if a file to which variants refer has changed since its first use."""
        for path, sha256 in inputs:
            try:
                compare(path, sha256, self._inputs.setdefault(path, sha256))
            except OSError as error:
                self._changed = str(error)
                raise
