"""Reads the file of a family, NumPy arrays in a zip archive, and checks that the file is complete.
"""

from __future__ import annotations

import copy
import importlib
import json
import os
import pathlib
import zipfile
from typing import Any, NoReturn, Union

from . import _command
from ._options import path as path_of

_FORMAT = 1  # version of the file's format
_END = 22  # size of the end record of a zip archive, bytes
_PER_VARIANT = ("index", "mass", "bounds", "top_offset", "bottom_offset", "horizontal_radius")


def numpy_module() -> Any:
    """Returns the module numpy. Raises ImportError with the command that installs NumPy."""
    try:
        return importlib.import_module("numpy")
    except ImportError as error:
        raise ImportError("this needs NumPy: python -m pip install numpy") from error


class FamilyFile:
    """Arrays of a family's file, read into memory and checked."""

    def __init__(self, path: "Union[str, os.PathLike[str]]") -> None:
        self.path = pathlib.Path(path_of(path, "path"))
        _expect_file(self.path)
        numpy = numpy_module()
        _expect_unchanged(self.path)
        self.members = self._read(numpy)
        self.facts: dict[str, Any] = self._facts()
        self.count = int(self.facts["variants"])
        self._check_members()

    def text(self, name: str) -> str:
        """Returns a member of the file that is a text."""
        return bytes(self.members[name].tobytes()).decode()

    def assets(self) -> dict[str, bytes]:
        """Returns the files to which the base refers, by their names in the base."""
        return {name: array.tobytes() for name, array in self.members.items() if name.startswith("assets/")}

    def fields(self) -> list[str]:
        """Returns the names of the arrays that have numbers of named elements."""
        return [name for name in self.members if f"{name}.names" in self.members]

    def arrays(self) -> dict[str, Any]:
        """Returns the arrays with one row for each variant, without the index and the parameters.
        """
        return {name: array for name, array in self.members.items()
                if name != "index" and not name.startswith("params/") and self._has_rows(name)}

    def columns(self, folder: str) -> dict[str, Any]:
        """Returns the members of a folder, by their names in the folder."""
        return {name[len(folder):]: array for name, array in self.members.items() if name.startswith(folder)}

    def only(self, row: int) -> FamilyFile:
        """Returns the file reduced to one variant."""
        one = copy.copy(self)
        one.members = {name: array[row:row + 1] if self._has_rows(name) else array
                       for name, array in self.members.items()}
        one.count = 1
        return one

    def _read(self, numpy: Any) -> dict[str, Any]:
        with open(self.path, "rb") as file:
            if file.read(2) != b"PK":
                raise ValueError(f"'{self.path}' is not a family that 'mjforge generate -o NAME.npz' wrote")
        try:
            _expect_whole(self.path)
            with numpy.load(self.path, allow_pickle=False) as members:
                return dict(members.items())
        except Exception as error:  # zipfile and NumPy raise many kinds for broken archives
            raise ValueError(f"'{self.path}' was cut short or changed: {error}") from error

    def _facts(self) -> dict[str, Any]:
        if not {"family", "base", "index"} <= set(self.members):
            raise ValueError(f"'{self.path}' is not a family that 'mjforge generate -o NAME.npz' wrote")
        try:
            facts = json.loads(self.text("family"))
            version, count = facts["mjforge_family"], facts["variants"]
        except (ValueError, KeyError, TypeError) as error:
            self._changed(f"its facts cannot be read: {error}")
        if version != _FORMAT:
            raise ValueError(f"'{self.path}' has version {version} of the format; this mjforge reads {_FORMAT}")
        if not isinstance(count, int) or count < 1:
            self._changed(f"it has {count!r} variants")
        return dict(facts)

    def _changed(self, message: str) -> NoReturn:
        raise ValueError(f"'{self.path}' was changed: {message}")

    def _check_members(self) -> None:
        """Raises ValueError if the shape of an array does not match the number of variants or of
        names.
        """
        for name, array in self.members.items():
            base, _, kind = name.rpartition(".")
            if kind in ("names", "components") and base in self.members:
                if array.shape != self.members[base].shape[1:2]:
                    self._changed(f"'{name}' has the shape {array.shape}")
            elif self._has_rows(name) and array.shape[:1] != (self.count,):
                self._changed(f"'{name}' has the shape {array.shape}, not {self.count} rows")
            elif self._has_rows(name) and array.dtype.kind not in "fiu" and not name.startswith("params/"):
                self._changed(f"'{name}' has no numbers")
        for name in ("index", "mass", "bounds"):
            if name not in self.members:
                self._changed(f"it has no '{name}'")

    def _has_rows(self, name: str) -> bool:
        return (name in _PER_VARIANT or f"{name}.names" in self.members
                or name.startswith(("start_", "opt_", "mesh_vert/", "mesh_scale/", "params/")))


def _expect_file(path: pathlib.Path) -> None:
    if path.is_dir():
        inside = sorted(each.name for each in path.glob("*.npz"))
        hint = f"name one of its files: {', '.join(inside[:5])}" if inside else "it has no .npz files"
        raise ValueError(f"path='{path}' is a folder, and a family is one file; {hint}")
    if path.exists():
        return
    if "%s" in path.name:
        found = sorted(each.name for each in path.parent.glob(path.name.replace("%s", "*")))
        raise ValueError(f"path='{path}' names a file for each structure; name one of them"
                         + (f": {', '.join(found[:5])}" if found else ""))
    raise FileNotFoundError(f"'{path}' does not exist: 'mjforge generate SPEC -n 64 -o NAME.npz' writes a family")


def _expect_whole(path: pathlib.Path) -> None:
    """Raises an error if a checksum or the number of members is wrong. NumPy does not compare
    checksums if a shape was changed, and does not read the number of members in the archive's end
    record.
    """
    with open(path, "rb") as file, zipfile.ZipFile(file) as archive:
        if broken := archive.testzip():
            raise ValueError(f"the checksum of '{broken}' is another")
        file.seek(-_END, os.SEEK_END)
        end = file.read()
        stated, count = int.from_bytes(end[10:12], "little"), len(archive.infolist())
        if not end.startswith(b"PK\5\6") or stated not in (count, 0xFFFF):
            raise ValueError(f"it has {count} of {stated} members")


def _expect_unchanged(path: pathlib.Path) -> None:
    """Raises ValueError if the hash of the file differs from the hash in the seal, if there is a
    seal beside the file.
    """
    if not any(path.parent.glob("*.manifest.seal.json")):
        return
    try:
        findings = _command.run(["verify", "--", str(path)], b"").findings
    except (OSError, ValueError):
        return  # the seal belongs to another file, or cannot be read
    for finding in findings:
        if finding.code == "batch/changed":
            raise ValueError(f"'{path}' is not the file that was written: {finding.message}")
