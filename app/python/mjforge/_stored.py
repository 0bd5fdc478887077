"""A batch that was written: its objects by number, its records, and checks of all its files."""

from __future__ import annotations

import array
import itertools
import json
import os
import pathlib
from typing import Any, Iterator, Optional, Sequence, Union, overload

from . import _command
from ._batch_files import (Reader, Stored, bad_manifest, expect_no_family, manifests_of, missing_shards,
                           record_of, seal_of)
from ._findings import Finding, VariantError, findings_of
from ._json import loads, members_of_record
from ._library import integer, lines
from ._options import path as path_of
from ._table import Table
from ._variant import Variant


def _variant(stored: Stored) -> Variant:
    files = [[name, "", len(content)] for name, content in stored.files.items()]
    return Variant(stored.xml, stored.line, json.dumps(files).encode() if files else b"",
                   b"".join(stored.files.values()), findings_of(stored.record))


def _raise(finding: Finding) -> None:
    raise VariantError([finding])


def _lines(manifest: pathlib.Path) -> Iterator[bytes]:
    """Yields the lines of a manifest. Raises VariantError if the manifest cannot be read."""
    try:
        yield from lines(str(manifest))
    except OSError as error:
        raise VariantError([bad_manifest(manifest, f"cannot read the manifest to its end: {error}")]) from error


def _records(manifest: pathlib.Path) -> Iterator[tuple[bytes, bool]]:
    """Yields each line of a manifest, and True if the object of the record has a file. Raises
    VariantError for a line that is not a record, and at the end if the seal tells another number of
    records or bytes.
    """
    reader = Reader(manifest, _raise)
    for number, line in enumerate(_lines(manifest), start=1):
        reader.records = number
        try:
            status = members_of_record(line, ["status"])[0]
        except (ValueError, TypeError, KeyError, RecursionError):
            problem = record_of(line)[1]
            raise VariantError([bad_manifest(manifest, f"this line is not a record: {problem}", line=number,
                                             column=1)]) from None
        yield line, status == "ok"
    reader.compare_with_seal()


def _stored_lines(manifest: pathlib.Path) -> Iterator[bytes]:
    """Yields the records of objects that have a file, as lines."""
    return (line for line, is_stored in _records(manifest) if is_stored)


def _changed(manifest: pathlib.Path, problem: str = "") -> VariantError:
    reason = f" (the record of this object is wrong: {problem})" if problem else ""
    return VariantError([bad_manifest(manifest, "the manifest is damaged, or was changed since this Batch was opened: "
                                                f"open it again{reason}")])


class Batch:
    """A batch that was written, as a sequence of variants: its objects that have a file, numbered
    from 0.

    `path`: a folder, an archive (.tar, .tar.zst), a series of archives ("x_%05d.tar") or a
    manifest. Iteration needs constant memory. Archives are read from their start, so that objects
    should be accessed by iteration or in ascending order. Raises FileNotFoundError if there is no
    manifest, and VariantError for an object that is missing or was changed, and for a manifest that
    is damaged or was changed since the batch was opened. A Batch can be pickled; only one thread at
    a time may use it.

    >>> import mjforge, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     report = mjforge.Spec("mug").variants(seed=7).write(f"{folder}/mugs.tar", 5)
    ...     batch = mjforge.Batch(f"{folder}/mugs.tar")
    ...     len(batch), batch[-1].index, [v.index for v in batch[1:3]], batch.verify()
    (5, 4, [1, 2], [])
    """

    def __init__(self, path: Union[str, os.PathLike[str]]) -> None:
        path = path_of(path, "path")
        self._manifests = [pathlib.Path(os.path.abspath(each)) for each in manifests_of(path)]
        self._seals = {manifest: seal_of(manifest) for manifest in self._manifests}
        self.path = pathlib.Path(os.path.abspath(path))
        self._starts: Optional[list[array.array[int]]] = None  # offsets of records in each manifest
        self._reader: Optional[tuple[int, Reader]] = None  # last object read, and its reader
        # Compressed manifest that was read last, and the process; number of the next record; further records.
        self._packed: Optional[tuple[tuple[pathlib.Path, int], int, Iterator[bytes]]] = None

    def _compare(self, manifest: pathlib.Path) -> None:
        """Raises VariantError if a manifest was changed since the batch was opened."""
        if seal_of(manifest) != self._seals[manifest]:
            raise _changed(manifest)

    def _unchanged(self) -> Iterator[pathlib.Path]:
        """Yields the manifests. Compares each before and after its use."""
        for manifest in self._manifests:
            self._compare(manifest)
            yield manifest
            self._compare(manifest)

    def __iter__(self) -> Iterator[Variant]:
        for manifest in self._unchanged():
            expect_no_family(manifest)
            reader = Reader(manifest, _raise)
            yield from map(_variant, reader)
            reader.compare_with_seal()

    def records(self) -> Iterator[dict[str, Any]]:
        """Yields the records of all variants, including those that failed and have no file."""
        for manifest in self._unchanged():
            for line, _ in _records(manifest):
                yield loads(line)

    def __len__(self) -> int:
        for manifest in self._manifests:
            self._compare(manifest)
        return sum(map(len, self._index()))

    def _index(self) -> list[array.array[int]]:
        if self._starts is None:
            self._starts = [self._starts_of(manifest) for manifest in self._unchanged()]
        return self._starts

    @staticmethod
    def _starts_of(manifest: pathlib.Path) -> array.array[int]:
        starts, start = array.array("Q"), 0
        for line, is_stored in _records(manifest):
            if is_stored:
                starts.append(start)
            start += len(line) + 1
        return starts

    def _record(self, number: int) -> tuple[pathlib.Path, bytes, dict[str, Any]]:
        """Returns the manifest, the line and the record of an object. Raises VariantError if the
        record is not there, or if the manifest was changed since the batch was opened.
        """
        manifest, line = self._line(number)
        record, problem = record_of(line)
        if problem or record["status"] != "ok":
            expect_no_family(manifest)
            raise _changed(manifest, problem)
        self._compare(manifest)
        return manifest, line, record

    def _line(self, number: int) -> tuple[pathlib.Path, bytes]:
        shards = zip(self._manifests, self._index())
        manifest, starts = next(shards)
        while number >= len(starts):
            number -= len(starts)
            manifest, starts = next(shards)
        if manifest.suffix == ".zst":
            return manifest, self._packed_line(manifest, number)
        with open(manifest, "rb") as file:
            file.seek(starts[number])
            return manifest, file.readline().rstrip(b"\n")

    def _packed_line(self, manifest: pathlib.Path, number: int) -> bytes:
        """Returns a record of a compressed manifest. Continues after the record that was read last, but
        not in a forked process, which shares the position in the open file with its parent.
        """
        place, at, found = self._packed or (None, 0, iter(()))
        if place != (manifest, os.getpid()) or number < at:
            at, found = 0, _stored_lines(manifest)
        line = next(itertools.islice(found, number - at, None), b"")
        self._packed = (manifest, os.getpid()), number + 1, found
        return line

    def _number(self, number: Any) -> int:
        at, count = integer(number, "number"), sum(map(len, self._index()))
        if not -count <= at < count:
            count = len(self)  # a VariantError if the batch was changed, which may have this object
            raise IndexError(f"number={number} is not within the {count} objects of '{self.path}'")
        return at % count

    @overload
    def __getitem__(self, number: int) -> Variant: ...
    @overload
    def __getitem__(self, number: slice) -> Sequence[Variant]: ...
    def __getitem__(self, number: Any) -> Any:
        if isinstance(number, slice):
            return _Slice(self, range(len(self))[number])
        number = self._number(number)
        manifest, line, record = self._record(number)
        reader = None
        if self._reader is not None and self._reader[0] < number and self._reader[1].manifest == manifest:
            reader = self._reader[1]  # continues in an archive
        reader = reader or Reader(manifest, _raise)
        self._reader = None
        if record.get("each"):
            raise ValueError(f"number={number} is a scene whose objects are files of their own (--each)")
        stored = reader.read(record, line)
        assert stored is not None  # otherwise, _raise has raised an exception
        self._reader = number, reader
        return _variant(stored)

    def table(self, members: Sequence[str] = ("params", "mass", "bounds"), frame: Optional[bool] = None) -> Any:
        """Returns a table of the records of the objects; see Variants.table."""
        table = Table(members, frame)
        for record in itertools.chain.from_iterable(map(_stored_lines, self._unchanged())):
            table.add(record)
        return table.finish()

    def verify(self) -> list[Finding]:
        """Compares all files with their hashes, as `mjforge verify` does. Returns the findings."""
        found = list(missing_shards(self.path, self._manifests))
        for manifest in self._manifests:
            found += _command.run(["verify", "--", str(manifest)], b"").findings
        return found

    def prove(self, *, jobs: Optional[int] = None, progress: bool = True) -> list[Finding]:
        """Loads all objects in the installed `mujoco` and compares them with their records; see
        mjforge.prove.
        """
        from . import prove

        return prove(self.path, jobs=jobs, progress=progress)

    def replay(self, number: int) -> Variant:
        """Makes an object again from its record, and returns it; see Variant.from_record."""
        from ._replay import replay

        manifest, _, record = self._record(self._number(number))
        return replay(record, None, manifest.parent)

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_reader": None, "_packed": None}

    def __repr__(self) -> str:
        return f"<mjforge.Batch {str(self.path)!r}>"


class _Slice(Sequence[Variant]):
    """Some objects of a batch, which are read when asked for."""

    def __init__(self, batch: Batch, numbers: range) -> None:
        self._batch = batch
        self._numbers = numbers

    def __len__(self) -> int:
        return len(self._numbers)

    @overload
    def __getitem__(self, key: int) -> Variant: ...
    @overload
    def __getitem__(self, key: slice) -> Sequence[Variant]: ...
    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, slice):
            return _Slice(self._batch, self._numbers[key])
        number = integer(key, "number")
        if not -len(self) <= number < len(self):
            raise IndexError(f"number={number} is not within the {len(self)} objects of {self!r}")
        return self._batch[self._numbers[number]]

    def __repr__(self) -> str:
        return f"<objects {self._numbers} of {self._batch!r}>"
