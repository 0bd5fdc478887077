"""The shared library, loaded by ctypes. Structs must match app/python/interface.h, which documents
them.
"""

from __future__ import annotations

import ctypes
import operator
import os
from ctypes import POINTER, Structure, c_char_p, c_double, c_int, c_size_t, c_uint64, c_void_p
from typing import Any, Iterable, Iterator

_FOLDER = os.path.dirname(os.path.abspath(__file__))
PROGRAM = os.path.join(_FOLDER, "bin", "mjforge")
CATALOGUE = os.path.join(_FOLDER, "share", "mjforge", "specs")


class Text(Structure):
    _fields_ = [("data", c_void_p), ("size", c_size_t)]


class Request(Structure):
    _fields_ = [
        ("snapshot", c_void_p),
        ("settings", POINTER(c_char_p)),
        ("setting_count", c_size_t),
        ("parameter_files", POINTER(c_char_p)),
        ("parameter_file_count", c_size_t),
        ("name", c_char_p),
        ("target", c_char_p),
        ("assets", c_char_p),
        ("sampler", c_char_p),
        ("on_invalid", c_char_p),
        ("validate", c_char_p),
        ("seed", c_uint64),
        ("batch", c_uint64),
        ("place_seed", POINTER(c_uint64)),
    ]


class VariantTexts(Structure):
    _fields_ = [
        ("xml", c_void_p),
        ("xml_size", c_size_t),
        ("record", c_void_p),
        ("record_size", c_size_t),
        ("findings", c_void_p),
        ("findings_size", c_size_t),
        ("files", c_void_p),
        ("files_size", c_size_t),
        ("contents", c_void_p),
        ("contents_size", c_size_t),
        ("inputs", c_void_p),
        ("inputs_size", c_size_t),
        ("box", c_double * 6),
    ]


def _load() -> ctypes.CDLL:
    library = ctypes.CDLL(os.path.join(_FOLDER, "lib", "libmjforge.so"))
    for name, result, *arguments in (
        ("MjforgeNewSnapshot", c_void_p, c_char_p, c_char_p, c_char_p),
        ("MjforgeReadSnapshot", c_void_p, c_char_p, c_size_t),
        ("MjforgeCloseSnapshot", None, c_void_p),
        ("MjforgeSnapshotText", Text, c_void_p),
        ("MjforgeWords", Text),
        ("MjforgeManifest", Text, c_char_p, c_uint64, c_uint64),
        ("MjforgeOpen", c_void_p, POINTER(Request)),
        ("MjforgeClose", None, c_void_p),
        ("MjforgeFailure", Text, c_void_p),
        ("MjforgeFindings", Text, c_void_p),
        ("MjforgeDescription", Text, c_void_p),
        ("MjforgeMake", c_int, c_void_p, c_uint64, POINTER(VariantTexts)),
        ("MjforgeOpenTable", c_void_p, POINTER(c_char_p), c_size_t),
        ("MjforgeCloseTable", None, c_void_p),
        ("MjforgeMakeRows", c_size_t, c_void_p, c_uint64, c_uint64, c_size_t, c_void_p, POINTER(Text)),
        ("MjforgeAddRecord", c_int, c_void_p, c_char_p, c_size_t),
        ("MjforgeLayout", Text, c_void_p),
        ("MjforgeKinds", c_void_p, c_void_p, c_size_t),
        ("MjforgeValues", c_void_p, c_void_p, c_size_t),
        ("MjforgeOpenArchive", c_void_p, c_char_p),
        ("MjforgeCloseArchive", None, c_void_p),
        ("MjforgeNextMember", c_int, c_void_p, POINTER(Text), POINTER(Text)),
        ("MjforgeOpenLines", c_void_p, c_char_p),
        ("MjforgeCloseLines", None, c_void_p),
        ("MjforgeNextLine", c_int, c_void_p, POINTER(Text)),
        ("MjforgeElements", Text, c_char_p, c_size_t),
        ("MjforgeCatalogue", Text, c_char_p),
        ("MjforgeVersion", c_char_p),
    ):
        function = getattr(library, name)
        function.restype = result
        function.argtypes = arguments
    return library


library = _load()


def bytes_of(text: Text) -> bytes:
    return ctypes.string_at(text.data, text.size) if text.size else b""


def c_text(text: Any, what: str) -> bytes:
    """Returns a text as an argument for C. Rejects other types, because C would take a number for
    an address, and zero characters, because they would end the text. `what` is the name of the
    argument in the TypeError or ValueError.
    """
    if not isinstance(text, str):
        raise TypeError(f"{what}={text!r} is not a text but of type {type(text).__name__}")
    if "\0" in text:
        raise ValueError(f"{what}={text!r} has a zero character")
    try:
        return os.fsencode(text)
    except UnicodeEncodeError:
        raise ValueError(f"{what}={text!r} is not valid Unicode") from None


def c_texts(texts: Iterable[Any], what: str) -> Any:
    """Returns texts as an array for C."""
    encoded = [c_text(text, what) for text in texts]
    return (c_char_p * len(encoded))(*encoded)


MAX_NUMBER = 2**64 - 1


def c_number(number: Any, what: str, least: int = 0, most: int = MAX_NUMBER) -> int:
    """Returns an integer of any type as an argument for C. Raises TypeError, or ValueError if the
    integer is outside of the range.
    """
    index = integer(number, what)
    if not least <= index <= most:
        end = f"2^{most.bit_length()} - 1" if most & (most + 1) == 0 else most
        raise ValueError(f"{what}={index} is not within {least} .. {end}")
    return index


def integer(number: Any, what: str) -> int:
    """Returns an integer of any type as int. Raises a TypeError with the name `what`."""
    try:
        if not isinstance(number, bool):
            return int(operator.index(number))  # in Python 3.9, index() returns a member of an IntEnum as it is
    except TypeError:
        pass
    raise TypeError(f"{what}={number!r} is not an integer but of type {type(number).__name__}")


def members(archive: str) -> Iterator[tuple[str, bytes]]:
    """Yields names and contents of the members of an archive, `.tar` or `.tar.zst`. Raises OSError.
    """
    handle = library.MjforgeOpenArchive(c_text(archive, "archive"))
    if not handle:
        raise MemoryError
    name, content = Text(), Text()
    try:
        while (status := library.MjforgeNextMember(handle, name, content)) == 0:
            yield os.fsdecode(bytes_of(name)), bytes_of(content)
        if status == 2:
            raise OSError(bytes_of(content).decode(errors="replace"))
    finally:
        library.MjforgeCloseArchive(handle)


def lines(manifest: str) -> Iterator[bytes]:
    """Yields the lines of a manifest, `.jsonl` or `.jsonl.zst`, without line ends. Raises OSError
    if reading fails, or if the manifest was cut off and is no longer being written (`.part`).
    """
    handle = library.MjforgeOpenLines(c_text(manifest, "manifest"))
    if not handle:
        raise MemoryError
    line = Text()
    try:
        while (status := library.MjforgeNextLine(handle, line)) == 0:
            yield bytes_of(line)
        if status == 2:
            raise OSError(bytes_of(line).decode(errors="replace"))
        if status == 3 and not manifest.endswith(".part"):
            raise OSError("it was cut off")
    finally:
        library.MjforgeCloseLines(handle)


def version() -> str:
    return str(library.MjforgeVersion().decode())
