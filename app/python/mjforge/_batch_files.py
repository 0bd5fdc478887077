"""Reading of the files of a batch: the manifest, and the objects in a folder or in archives."""

from __future__ import annotations

import dataclasses
import hashlib
import os
import pathlib
import re
import stat
from typing import Any, Callable, Iterator, Mapping, Optional, Sequence, Union

from ._findings import Finding
from ._json import loads
from ._library import lines, members

# Size limit of a file, bytes; must be bytes::kMaxAsset of the library.
_MAX_FILE = 256 << 20
_MAX_ASSETS = 1 << 30  # largest size of the assets of an archive that are kept in memory
_RESUME = "run the command that made it again with --resume"
_SHARD = re.compile(r"-(?P<index>\d{5})-of-(?P<count>\d{5})(?=\.jsonl)")
_MANIFEST = re.compile(r"(.+\.)?manifest(-\d{5}-of-\d{5})?\.jsonl(\.zst)?")


def manifests_of(batch: Union[str, "os.PathLike[str]"]) -> list[pathlib.Path]:
    """Returns the manifests of a batch. `batch` is a folder of objects, of archives or of several
    batches, an archive, a series of archives ("x_%05d.tar"), or a manifest. Raises
    FileNotFoundError if there is no manifest.
    """
    path = pathlib.Path(batch)
    found: list[pathlib.Path] = []
    if not os.fspath(batch):
        pass  # pathlib would use the working folder for an empty path
    elif path.is_dir():
        names = {name for name in os.listdir(path) if _MANIFEST.fullmatch(name)}
        # A merged manifest has all records of its shards.
        found = [path / name for name in sorted(names)
                 if name == (whole := _SHARD.sub("", name)) or whole not in names]
        found = found or sorted(each for each in path.glob("*/*") if _MANIFEST.fullmatch(each.name))
    elif path.name.removesuffix(".part").endswith((".jsonl", ".jsonl.zst")):
        found = [path]
    else:
        name = path.name.removesuffix(".zst").removesuffix(".tar")
        stem = re.sub(r"%\d*d", "", name, count=1)
        stem = name if stem == name else stem.rstrip("_-.")
        ending = ".jsonl.zst" if path.suffix == ".zst" else ".jsonl"
        found = [path.with_name(f"{stem}.manifest{ending}")]
    if path.suffix == ".npz":
        raise FileNotFoundError(f"'{path}' is a family, not a batch: mjforge.load_family reads it")
    if not found or not found[0].exists():
        lacks = "does not exist"
        if path.exists() or "%" in path.name or not os.fspath(batch):
            lacks = f"has no manifest '{found[0]}'" if found else "has no manifest"
        raise FileNotFoundError(f"'{os.fspath(batch)}' {lacks}: name the folder, the archive or the manifest that "
                                "'mjforge generate' wrote")
    return found


def expect_no_family(manifest: pathlib.Path) -> None:
    """Raises FileNotFoundError if the first record of a manifest is that of a family's variant, which
    has no file.
    """
    try:
        archive = loads(next(lines(str(manifest)), b"{}"))["archive"]
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return
    if str(archive).endswith(".npz"):
        raise FileNotFoundError(f"'{manifest}' has the records of the family '{archive}', whose variants have no "
                                "files: mjforge.load_family reads the family")


def missing_shards(batch: Union[str, "os.PathLike[str]"],
                   manifests: Sequence[pathlib.Path]) -> Iterator[Finding]:
    """Yields a finding for each shard of a folder's batches that has no manifest, unless the shards are
    merged. `manifests` is the result of manifests_of(batch).
    """
    present: dict[tuple[pathlib.Path, int], set[int]] = {}
    for manifest in manifests if os.path.isdir(batch) else ():
        if shard := _SHARD.search(manifest.name):
            whole = manifest.with_name(_SHARD.sub("", manifest.name))
            present.setdefault((whole, int(shard["count"])), set()).add(int(shard["index"]))
    for (whole, count), indices in present.items():
        for index in sorted(set(range(count)) - indices):
            name = whole.name.replace(".jsonl", f"-{index:05}-of-{count:05}.jsonl")
            yield Finding({
                "severity": "error", "code": "batch/missing", "notes": [],
                "message": f"shard {index}/{count} is missing: there is no '{whole.with_name(name)}'",
                "hint": f"make it with --shard {index}/{count} --resume"})


@dataclasses.dataclass
class Stored:
    """An object of a batch: its MJCF file, the other files of the object, and its record."""

    place: str  # path of the MJCF file; in an archive, with the path of the archive
    record: Mapping[str, Any]
    xml: bytes
    files: Mapping[str, bytes]  # contents of meshes and textures, by their names in the XML
    line: bytes = b""  # line of the manifest with the record


class Reader:
    """Reads the objects of a manifest in their order. Calls `report` with a finding for everything
    that cannot be read.
    """

    def __init__(self, manifest: pathlib.Path, report: Callable[[Finding], None]) -> None:
        self.manifest = manifest
        self._report = report
        self._archive: Optional[str] = None
        self._process = 0  # id of the process that opened the archive
        self._members: Iterator[tuple[str, bytes]] = iter(())
        self._broken: Optional[str] = None  # archive in which an object is missing
        self._assets: dict[str, bytes] = {}  # assets of the archive; the last used are at the end
        self._asset_bytes = 0
        self.records = 0  # number of records read so far
        self.objects = 0  # number of these records that have a file
        self._last: Optional[tuple[int, int]] = None  # seed and index of the previous record
        self._is_sound = True  # true if no line was wrong so far

    def count(self) -> Optional[int]:
        """Returns the number of records according to the seal (a file beside a complete manifest);
        None if there is no seal.
        """
        sealed = self._sealed()
        return None if sealed is None else sealed[0]

    def _sealed(self) -> Optional[tuple[int, int]]:
        """Returns the number of records and the size of the manifest, bytes, according to the seal;
        None if the manifest has no seal.
        """
        try:
            seal = loads(seal_of(self.manifest))
            if seal["manifest"]["file"] != self.manifest.name:
                return None
            return int(seal["records"]), int(seal["manifest"]["bytes"])
        except (ValueError, KeyError, TypeError, RecursionError):
            return None

    def compare_with_seal(self) -> None:
        """Reports a manifest whose number of records or size differs from its seal, unless a line
        was wrong. All records must have been read.
        """
        sealed = self._sealed()
        if sealed is None or not self._is_sound:
            return
        size = self.manifest.stat().st_size
        for what, value, meant in (("records", self.records, sealed[0]), ("bytes", size, sealed[1])):
            if value != meant:
                self._report(Finding({
                    "severity": "error", "code": "batch/changed", "notes": [], "hint": _RESUME,
                    "message": f"'{self.manifest}' was changed: it has {value} {what}, not {meant}"}))
                return

    def __iter__(self) -> Iterator[Stored]:
        for number, line in enumerate(self._lines(), start=1):
            self.records += 1
            record = self._record_of(number, line)
            if record is None or self._is_repeated(record, number) or record["status"] != "ok":
                continue
            if record.get("each"):
                self._bad_manifest("the objects of its scenes are files of their own (--each), which "
                                   "have no records to compare with", line=number, column=1)
                return
            self.objects += 1
            if self._broken and record.get("archive") == self._broken:
                continue
            stored = self.read(record, line)
            if stored is not None:
                yield stored

    def read(self, record: Mapping[str, Any], line: bytes) -> Optional[Stored]:
        """Returns the object of a record that has a file; None after a finding. Objects of an
        archive must be read in the order of their records, but records may be left out.
        """
        try:
            stored = self._read(record)
        except OSError as error:
            self._missing(record, error)
            return None
        stored.line = line
        return stored if self._is_unchanged(stored) else None

    def _lines(self) -> Iterator[bytes]:
        try:
            yield from lines(str(self.manifest))
        except OSError as error:
            self._bad_manifest(f"cannot read the manifest to its end: {error}")

    def _record_of(self, number: int, line: bytes) -> Optional[dict[str, Any]]:
        record, problem = record_of(line)
        if not problem:
            return record
        self._bad_manifest(f"this line is not a record: {problem}", line=number, column=1)
        return None

    def _is_repeated(self, record: Mapping[str, Any], number: int) -> bool:
        """Returns True, after a finding, if the index of a record is not above the index of the
        previous record. Does not compare records with different seeds, because manifests of several
        batches may have been joined.
        """
        before, self._last = self._last, (record["seed"], record["index"])
        if before is None or before[0] != record["seed"] or before[1] < record["index"]:
            return False
        self._bad_manifest(f"index {record['index']} follows index {before[1]}, but indices ascend from line to "
                           "line", line=number, column=1)
        return True

    def _bad_manifest(self, message: str, **place: int) -> None:
        self._is_sound = False
        self._report(bad_manifest(self.manifest, message, **place))

    def _read(self, record: Mapping[str, Any]) -> Stored:
        name = record["file"]
        below, folder = self.manifest.parent, os.path.dirname(name)
        assets = {asset: os.path.join(folder, asset) for asset in record.get("assets", {})}
        if "archive" in record:
            archive = str(below / record["archive"])
            xml = self._member(archive, name)
            files = {asset: self._asset(path) for asset, path in assets.items()}
            return Stored(os.path.join(archive, name), record, xml, files)
        files = {asset: _content(below / file) for asset, file in assets.items()}
        return Stored(str(below / name), record, _content(below / name), files)

    def _member(self, archive: str, name: str) -> bytes:
        """Returns a member of an archive. An archive has the objects in the order of the manifest,
        and assets before the first object that needs them. Opens the archive anew in a forked
        process, because a fork shares the position in an open file with its parent.
        """
        if (archive, os.getpid()) != (self._archive, self._process):
            self._archive, self._process, self._members = archive, os.getpid(), members(archive)
            self._assets, self._asset_bytes = {}, 0
        for member, content in self._members:
            if member == name:
                return content
            if not member.endswith((".xml", ".json")):
                self._keep(member, content)
        raise FileNotFoundError(f"it is not in '{archive}'")

    def _keep(self, asset: str, content: bytes) -> None:
        self._asset_bytes += len(content) - len(self._assets.pop(asset, b""))
        self._assets[asset] = content
        while self._asset_bytes > _MAX_ASSETS and len(self._assets) > 1:
            self._asset_bytes -= len(self._assets.pop(next(iter(self._assets))))

    def _asset(self, path: str) -> bytes:
        if path not in self._assets:
            raise FileNotFoundError(f"its '{path}' is not in '{self._archive}'")
        content = self._assets[path] = self._assets.pop(path)
        return content

    def _missing(self, record: Mapping[str, Any], error: OSError) -> None:
        words = error.strerror or str(error)
        if "archive" in record:
            self._broken = record["archive"]
            words += "; later objects of this archive are not read"
        self._add(record, "batch/missing", f"cannot read '{record['file']}': {words}", _RESUME)

    def _is_unchanged(self, stored: Stored) -> bool:
        wrong = [name for name, sha256 in stored.record.get("assets", {}).items()
                 if hashlib.sha256(stored.files.get(name, b"")).hexdigest() != sha256]
        if hashlib.sha256(stored.xml).hexdigest() != stored.record["sha256"]:
            wrong = [stored.place]
        for name in wrong:
            self._add(stored.record, "batch/changed",
                      f"'{name}' was changed: it has another SHA-256 than its record", _RESUME)
        return not wrong

    def _add(self, record: Mapping[str, Any], code: str, message: str, hint: str) -> None:
        self._report(Finding({"severity": "error", "code": code, "message": message, "hint": hint,
                              "seed": record["seed"], "index": record["index"], "notes": []}))


def _regular(path: Union[str, "os.PathLike[str]"]) -> Union[str, "os.PathLike[str]"]:
    """Returns the path. Raises OSError for pipes and devices, because reading them may never end.
    """
    if not stat.S_ISREG(os.stat(path).st_mode):
        raise OSError(f"'{os.fspath(path)}' is not a regular file")
    return path


def _content(path: pathlib.Path) -> bytes:
    with open(_regular(path), "rb") as file:
        # `read` allocates as many bytes as it is asked for, which takes time.
        content = file.read(min(os.fstat(file.fileno()).st_size, _MAX_FILE) + 1)
    if len(content) > _MAX_FILE:
        raise OSError(f"it has more than {_MAX_FILE} bytes")
    return content


def seal_of(manifest: pathlib.Path) -> bytes:
    """Returns the text of a manifest's seal, which contains the hash of the manifest; empty if there is
    no seal.
    """
    name = manifest.name.removesuffix(".zst").removesuffix(".jsonl") + ".seal.json"
    try:
        return _content(manifest.with_name(name))
    except OSError:
        return b""


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _are_numbers(count: int) -> Callable[[Any], bool]:
    return lambda value: isinstance(value, list) and len(value) == count and all(map(_is_number, value))


def _is_count(value: Any) -> bool:
    return isinstance(value, int) and value >= 0


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


def _is_mapping(value: Any) -> bool:
    return isinstance(value, Mapping)


def _is_inside(value: Any) -> bool:
    """Returns True for a relative path that stays below its folder."""
    if not isinstance(value, str) or "\0" in value or os.path.isabs(value):
        return False
    return ".." not in value.split("/")


def _is_box(value: Any) -> bool:
    return isinstance(value, dict) and all(_are_numbers(3)(value.get(key)) for key in ("min", "max"))


def _are_assets(value: Any) -> bool:
    return isinstance(value, dict) and all(map(_is_inside, value))


def _are_findings(value: Any) -> bool:
    return isinstance(value, list) and all(
        isinstance(finding, dict) and all(_is_text(finding.get(key)) for key in ("severity", "code", "message")) and
        all(map(_is_mapping, finding.get("notes", ()))) for finding in value)


# Values of `status`, and tests of the members of a record that are used here.
_STATUSES = ("ok", "failed", "skipped")
_ALWAYS = {"status": _is_text, "index": _is_count, "seed": _is_count}
_OF_OBJECTS = {"file": _is_inside, "sha256": _is_text, "mass": _is_number,
               "com": _are_numbers(3), "inertia": _are_numbers(6), "aabb": _is_box,
               "nbody": _is_count, "njnt": _is_count, "ngeom": _is_count}
OPTIONAL = {"archive": _is_inside, "assets": _are_assets, "findings": _are_findings, "spec": _is_text,
            "spec_file": _is_text, "set": _is_mapping}


def bad_manifest(manifest: pathlib.Path, message: str, **place: int) -> Finding:
    """Returns the finding that a manifest cannot be read."""
    return Finding({"severity": "error", "code": "output/bad-manifest", "message": message, "notes": [],
                    "file": str(manifest), **place})


def record_of(line: bytes) -> tuple[dict[str, Any], str]:
    """Returns the record in a line of a manifest, and the reason why the line is not a record; the
    reason is empty if the line is a record.
    """
    try:
        record = loads(line)
    except (ValueError, RecursionError):
        return {}, "it is not JSON"
    return record, problem_of(record)


def problem_of(record: Any) -> str:
    """Returns the reason why a JSON value is not a record; empty if the value is a record."""
    if not isinstance(record, dict):
        return "it is not a JSON object"
    needed = {**_ALWAYS, **(_OF_OBJECTS if record.get("status") == "ok" else {})}
    for key, is_good in {**needed, **OPTIONAL}.items():
        if key not in record:
            if key in needed:
                return f"it has no '{key}'"
        elif not is_good(record[key]):
            return f"'{key}' is not of its kind"
    if record["status"] not in _STATUSES:
        return f"'status' is not one of {', '.join(_STATUSES)}"
    return ""
