"""The shared library: app/python/interface.h has the same structs and says what they mean."""

from __future__ import annotations

import ctypes
import json
import os
from ctypes import POINTER, Structure, c_char_p, c_int, c_size_t, c_uint64, c_void_p
from typing import Any

_FOLDER = os.path.dirname(os.path.abspath(__file__))
PROGRAM = os.path.join(_FOLDER, "bin", "mjforge")
CATALOGUE = os.path.join(_FOLDER, "share", "mjforge", "specs")


class Text(Structure):
    _fields_ = [("data", c_void_p), ("size", c_size_t)]


class Request(Structure):
    _fields_ = [
        ("spec", c_char_p),
        ("text", c_char_p),
        ("text_name", c_char_p),
        ("catalogue", c_char_p),
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
    ]


def _load() -> ctypes.CDLL:
    library = ctypes.CDLL(os.path.join(_FOLDER, "lib", "libmjforge.so"))
    for name, result, *arguments in (
        ("MjforgeOpen", c_void_p, POINTER(Request)),
        ("MjforgeClose", None, c_void_p),
        ("MjforgeFailure", Text, c_void_p),
        ("MjforgeFindings", Text, c_void_p),
        ("MjforgeDescription", Text, c_void_p),
        ("MjforgeMake", c_int, c_void_p, c_uint64, POINTER(VariantTexts)),
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


def c_text(text: str) -> bytes:
    """Raises ValueError where C would see the end of the text too early."""
    if "\0" in text:
        raise ValueError(f"a text with a zero character: {text!r}")
    return os.fsencode(text)


def c_texts(texts: list[str]) -> Any:
    """An array."""
    return (c_char_p * len(texts))(*map(c_text, texts))


def catalogue() -> list[str]:
    """Names of the bundled specs."""
    return json.loads(bytes_of(library.MjforgeCatalogue(os.fsencode(CATALOGUE))))


def version() -> str:
    return library.MjforgeVersion().decode()
