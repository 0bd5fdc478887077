"""The variants of a spec, by index."""

from __future__ import annotations

import operator
import os
import threading
import time
from typing import TYPE_CHECKING, Any, Callable, Iterator, Optional, Sequence, Union, overload

from . import _command, _options, _write_options
from ._findings import Finding, VariantError
from ._library import integer
from ._maker import Maker
from ._options import Durability, Layout, Profile, Validate
from ._parameters import with_settings
from ._report import Report, report_of
from ._variant import Variant

if TYPE_CHECKING:
    from ._picture import Layer, Picture, Size
    from ._spec import Spec
    from ._table import Table

DEFAULTS: dict[str, Any] = {
    "name": "", "target": "mujoco", "assets": "inline", "sampler": "random", "on_invalid": "fail",
    "validate": "none", "seed": 0, "batch": None, "place_seed": None}

# Iteration makes at most this many variants at a time, and no further one after this time. A variant
# that is made alone between simulations takes 50 to 300 us longer, because its code and data have left
# the caches of the processor.
_AHEAD = 32
_TIME_AHEAD = 0.005  # s of this thread
# Iteration without end stops at this many invalid variants before the first valid one. If one in a
# hundred is valid, the probability of so many is 0.00004.
_MOST_INVALID = 1000


def described(spec: "Spec") -> str:
    """Returns the name of a spec and its settings, as text: "hammer (handle_length=25cm)"."""
    return spec.name + with_settings(spec.settings)


class Variants(Sequence[Variant]):
    """Variants of a spec, by index: without end, or those of a slice, which is a sequence. Each
    access makes the variant anew; iteration makes some ahead. Threads may share the object, and run
    in parallel while variants are made.

    >>> import mjforge
    >>> mugs = mjforge.Spec("mug").variants(seed=7)
    >>> [v.index for v in mugs[10:20:5]], len(mugs[:100]), mugs[:100][-1].index
    ([10, 15], 100, 99)
    """

    def __init__(self, spec: "Spec", options: dict[str, Any], makers: Optional[list[Maker]] = None) -> None:
        self.spec = spec
        self._options = options
        self._indices: Optional[range] = None
        if makers is None:
            makers = [Maker(spec, options)]
            makers[0].check()
        self._makers = makers  # makers that are not in use; a list's pop and append are atomic

    def _idle_maker(self) -> Maker:
        try:
            return self._makers.pop()
        except IndexError:
            maker = Maker(self.spec, self._options)
            maker.check()
            return maker

    def _make(self, index: int) -> Variant:
        if not 0 <= index < 2**64:
            raise IndexError(f"index={index} is not within 0 .. 2^64 - 1")
        maker = self._idle_maker()
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
            some = type(self).__new__(type(self))
            some.__dict__.update(self.__dict__, _indices=self._range(key))
            return some
        index = integer(key, "index")
        return self._make(index if self._indices is None else self._indices[index])

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

    @property
    def _all(self) -> range:
        return range(2**64) if self._indices is None else self._indices

    def __bool__(self) -> bool:
        return bool(self._all)

    def _has(self, value: Any, indices: range) -> bool:
        """Returns True if the value is the variant of its index, and the index is one of `indices`."""
        if not isinstance(value, Variant) or value.index not in indices:
            return False
        try:
            return self._make(value.index) == value
        except VariantError:
            return False

    def __contains__(self, value: Any) -> bool:
        return self._has(value, self._all)

    def index(self, value: Any, start: int = 0, stop: Optional[int] = None) -> int:
        if not self._has(value, self._all[start:stop]):
            raise ValueError(f"{value!r} is not one of {self!r}")
        return self._all.index(value.index)

    def count(self, value: Any) -> int:
        return int(value in self)

    def __iter__(self) -> Iterator[Variant]:
        return _Iteration(self)

    def write(
        self,
        output: Union[str, "os.PathLike[str]"],
        count: Optional[int] = None,
        *,
        first: Optional[int] = None,
        progress: Optional[Callable[[int, Optional[int]], object]] = None,
        jobs: Optional[int] = None,
        time_limit: Optional[float] = None,
        resume: bool = False,
        shard: Optional[str] = None,
        per_archive: Optional[int] = None,
        validate: Optional[Validate] = None,
        profile: Optional[Profile] = None,
        each: bool = False,
        force: bool = False,
        verify: bool = False,
        if_changed: bool = False,
        durability: Optional[Durability] = None,
        mocap: bool = False,
        pad: bool = False,
        layout: "Layout" = "any",
    ) -> Report:
        """Writes the first `count` variants, or those of a slice, to files or archives, with a
        manifest. Runs `mjforge generate`, which makes the same variants as this object.

        `progress(done, total)` is called after each variant of this run, and first with the number
        of variants that `resume` finds; `total` is None for a shard. `jobs`: number of processes
        (default: one per core). `time_limit`: time for each variant, s. `validate`: as for
        `variants()` by default, but at least "load". All other options are those of the command:
        `first` is the first index, `shard="0/4"` a part of the batch. For a family (output
        "NAME.npz"), `mocap=True` makes fixed bodies mocap bodies, and `pad=True` adds null geoms
        for geoms that a variant lacks; `layout="split"` makes one family ("NAME_%s.npz"), or one
        folder in a folder or an archive, for each structure. `per_archive` is for a series
        ("NAME_%05d.tar"). Options that do not fit together are a ValueError.

        Returns a report, also if variants failed. Raises OSError if writing fails. After Ctrl-C or
        an exception of `progress`, every file is complete, and `resume=True` continues.

        >>> import mjforge, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     report = mjforge.Spec("mug").variants(seed=7).write(folder, 3)
        >>> report.made, report.ok, report.manifest.name
        (3, True, 'manifest.jsonl')
        """
        span = self._span(count, first)
        options = _options.checked({
            "output": output, "jobs": jobs, "time_limit": time_limit, "resume": resume,
            "shard": shard, "per_archive": per_archive, "profile": profile, "each": each,
            "force": force, "verify": verify, "if_changed": if_changed, "durability": durability,
            "mocap": mocap, "pad": pad, "layout": layout, "progress": progress,
            "validate": self._validation() if validate is None else validate})
        _write_options.check(options, span)
        del options["progress"]
        own = {name: value for name, value in self._options.items() if name != "validate"}
        own["batch"] = own["batch"] or len(span)
        words = [f"--set={name}={value}" for name, value in self.spec.settings.items()]
        words += [f"--params={path}" for path in self.spec.parameter_files]
        words += _command.options_of({
            **{name: value for name, value in own.items() if value != DEFAULTS[name]},
            "first": span.start, "count": len(span), **options})
        self.spec._compare_inputs()
        total = len(span) if shard is None else None
        messages = _command.run(
            ["generate", *words, "--", "-"], self.spec._snapshot.saved(),
            None if progress is None else lambda done: progress(done, total))
        return report_of(options["output"], shard, span, messages.made, own["on_invalid"] == "skip",
                         messages.findings, self.spec)

    def _span(self, count: Optional[int], first: Optional[int]) -> range:
        """Returns the indices of the variants to write."""
        if self._indices is None:
            start = 0 if first is None else _options.number(first, "first")
            return range(start, start + _options.length(count, "count"))
        for option, value in (("count", count), ("first", first)):
            if value is not None:
                raise ValueError(f"{option}={value!r}: a slice has its variants already")
        if not self._indices:
            raise ValueError(f"the slice {self._indices} is empty, so it cannot be written")
        start, last = self._indices[0], self._indices[-1]
        if self._indices.step != 1 and start != last:
            raise ValueError(f"variants {self._indices} are not consecutive, so they cannot be written")
        return range(start, start + _options.length(last - start + 1, "count"))

    def _validation(self) -> str:
        return "load" if self._options["validate"] == "none" else str(self._options["validate"])

    def sheet(self, size: "Size" = 320, layer: "Layer" = "visual") -> "Picture":
        """Draws a contact sheet of a slice with at most 400 variants. Returns the bytes of a PNG
        file. `size` is the size of each picture; see Variant.png.

        >>> mjforge.Spec("hammer").variants()[:8].sheet(size=100).save("hammers.png")  # doctest: +SKIP
        """
        from ._picture import draw

        len(self)  # raises TypeError without a slice
        return draw(self, size, layer)

    def table(self, members: Sequence[str] = ("params", "mass", "bounds"),
              frame: Optional[bool] = None) -> Any:
        """Returns a table of a slice: the index, and one column for each number or text in these
        members of the records, such as "params.width" and "bounds.min.x".

        The table is a pandas.DataFrame if pandas is installed (`frame=True`: otherwise raises
        ImportError), and a dict of NumPy arrays without pandas or with `frame=False`.

        >>> mugs = mjforge.Spec("mug").variants()[:1000]  # doctest: +SKIP
        >>> list(mugs.table(["mass", "bounds"], frame=False))[:3]  # doctest: +SKIP
        ['index', 'mass', 'bounds.min.x']
        """
        from ._table import CHUNK, Table

        len(self)  # raises TypeError without a slice
        table = Table(members, frame)
        indices = self._indices or range(0)
        if indices and not (min(indices[0], indices[-1]) >= 0 and max(indices[0], indices[-1]) < 2**64):
            raise IndexError(f"{indices} is not within 0 .. 2^64 - 1")
        self.spec._compare_inputs()
        if not indices:
            return self._empty(table)
        while indices:
            maker = self._idle_maker()
            try:
                count = maker.add_rows(indices[:CHUNK], table)
            finally:
                self._makers.append(maker)
            indices = indices[count:]
            if not count:
                self._leave_out(indices[0])
                indices = indices[1:]
        return table.finish()

    def _empty(self, table: "Table") -> Any:
        """Returns a table without rows, with the columns that variant 0 has, or only the index if
        variant 0 cannot be made.
        """
        try:
            table.add(self._make(0).record_bytes)
        except VariantError:
            pass
        return table.finish(has_rows=False)

    def _leave_out(self, index: int) -> None:
        """Raises the error of a variant that fails, unless iteration leaves such variants out."""
        try:
            self._make(index)
        except VariantError:
            if self._options["on_invalid"] != "skip":
                raise
        else:
            raise MemoryError  # no memory for the row of the variant

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_makers": []}

    def __repr__(self) -> str:
        which = "" if self._indices is None else f" {self._indices}"
        name = f", name {self._options['name']}" if self._options["name"] else ""
        return (f"<mjforge.Variants{which} of {described(self.spec)}, seed {self._options['seed']}, "
                f"target {self._options['target']}{name}>")


class _Iteration(Iterator[Variant]):
    """Iteration over variants. Not a generator, because an exception would end a generator, and
    iteration continues after a variant that cannot be made, and after Ctrl-C.
    """

    def __init__(self, variants: Variants) -> None:
        self._variants = variants
        self._indices = variants._all  # indices that are not in `_ready`
        self._ready: Iterator[Variant] = iter(())  # variants that can be given
        self._made: dict[int, Optional[Variant]] = {}  # the next of `_ready`, by index; None: left out
        self._ahead = 1
        self._first = 0  # index from which on no variant was valid so far
        # Invalid variants until the error; 0: no error.
        self._patience = _MOST_INVALID if variants._indices is None else 0
        self._lock = threading.Lock()  # threads may share an iteration

    def __next__(self) -> Variant:
        while True:
            ready = self._ready
            # The handler of a signal may raise an exception at any call, and Python makes none from the step of
            # the iterator to the end of this method, so that no variant is lost.
            for variant in ready:
                return variant
            with self._lock:
                if self._ready is ready:
                    self._make_ahead()

    def _make_ahead(self) -> None:
        """Makes variants of the next indices, as many as are made in a short time, up to one that fails
        and is not left out. Raises the error of the first variant, or StopIteration after the last.
        """
        skips = self._variants._options["on_invalid"] == "skip"
        end = time.thread_time() + _TIME_AHEAD
        for index in self._indices[:min(self._ahead, self._patience or self._ahead)]:
            if index in self._made:
                continue  # before an exception
            try:
                self._made[index] = self._variants._make(index)
            except VariantError:
                if skips:
                    self._made[index] = None
                elif self._made:
                    break  # the variant is tried again when its turn comes
                else:
                    self._indices = self._indices[1:]
                    raise
            if time.thread_time() > end:
                break
        if not self._made:
            raise StopIteration
        self._ahead = min(2 * self._ahead, _AHEAD)
        self._pass_on([variant for variant in self._made.values() if variant is not None])

    def _pass_on(self, valid: list[Variant]) -> None:
        patience = 0 if valid else max(self._patience - len(self._made), 0)
        gives_up = patience == 0 and self._patience > 0 and not valid
        ready, indices = iter(valid), self._indices[len(self._made):]
        made: dict[int, Optional[Variant]] = {}
        # No call comes between these assignments, so that an exception finds all of them or none.
        self._ready, self._indices, self._made, self._patience = ready, indices, made, patience
        if gives_up:
            self._give_up()

    def _give_up(self) -> None:
        """Raises VariantError with the reason of the first invalid variant."""
        first, self._first, self._patience = self._first, self._first + _MOST_INVALID, _MOST_INVALID
        try:
            self._variants[first]
        except VariantError as error:
            raise VariantError([Finding({
                "severity": "error", "code": error.findings[0].code, "notes": [],
                "message": f"none of the {_MOST_INVALID} variants from {first} on is valid",
                "hint": "take a slice, such as variants[0:100000], to look further"}), *error.findings]) from None
