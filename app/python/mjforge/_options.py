"""Options of functions: their words, and checks of arguments before they are passed to C."""

from __future__ import annotations

import difflib
import json
import math
import os
import sys
from typing import Any, Callable, Literal, Mapping, get_args

from ._library import bytes_of, c_number, c_text, library

Target = Literal["mujoco", "scene", "robosuite", "robocasa", "mjx"]
Assets = Literal["inline", "files"]
Sampler = Literal["random", "sobol", "latin", "grid"]
OnInvalid = Literal["fail", "skip", "resample"]
Validate = Literal["none", "load", "physics"]
Durability = Literal["none", "batch"]
Layout = Literal["any", "one", "split"]
Profile = Literal["none", "simready"]

MAX_JOBS = 1024  # must be kMaxJobs of app/options.cc

# Words that each option accepts, from the library. A test compares the types above with these
# words.
WORDS: dict[str, list[str]] = json.loads(bytes_of(library.MjforgeWords()))


def text(value: Any, option: str) -> str:
    """Returns the value, which must be a text without zero characters. The text of a member of an enumeration is
    its value: str() would return its name.
    """
    c_text(value, option)
    return str.__str__(value)


def word(value: Any, option: str) -> str:
    """Returns the value, which must be one of the words of the option."""
    words = WORDS[option] if option in WORDS else get_args(Profile)
    if not isinstance(value, str):
        raise TypeError(f"{option}={value!r} is not one of {', '.join(words)}, "
                        f"but of type {type(value).__name__}")
    given = text(value, option)
    if given in words:
        return given
    meant = difflib.get_close_matches(given, words, 1)
    hint = f"; did you mean '{meant[0]}'?" if meant else ""
    raise ValueError(f"{option}={value!r} is not one of {', '.join(words)}{hint}")


def number(value: Any, option: str) -> int:
    """Returns the value, which must be an integer from 0 to 2^64 - 1."""
    return c_number(value, option)


def count(value: Any, option: str) -> int:
    """Returns the value, which must be an integer from 1 to 2^64 - 1."""
    return c_number(value, option, 1)


def length(value: Any, option: str) -> int:
    """Returns a number of variants, which must be an integer from 1 on that len() can return."""
    return c_number(value, option, 1, sys.maxsize)


def jobs(value: Any, option: str) -> int:
    """Returns a number of processes, which must be from 1 to MAX_JOBS."""
    return c_number(value, option, 1, MAX_JOBS)


def real(value: Any, option: str) -> float:
    """Returns the value, which must be a number of any type, as float."""
    try:
        if not isinstance(value, (bool, str, bytes, complex)):
            return float(value)
    except TypeError:
        pass
    except OverflowError:
        raise ValueError(f"{option} is beyond the largest number") from None
    raise TypeError(f"{option}={value!r} is not a number but of type {type(value).__name__}")


def seconds(value: Any, option: str) -> float:
    """Returns the value, which must be a positive number, as float."""
    if not 0 < real(value, option) < math.inf:
        raise ValueError(f"{option}={value!r} is not a positive number of seconds")
    return float(value)


def flag(value: Any, option: str) -> bool:
    """Returns the value, which must be True or False."""
    if not isinstance(value, bool):
        raise TypeError(f"{option}={value!r} is not True or False but of type {type(value).__name__}")
    return value


def path(value: Any, option: str) -> str:
    """Returns the path of a file or a folder, which must be a text or an os.PathLike, as text."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{option}={value!r} is not a path but of type {type(value).__name__}")
    return text(os.fspath(value), option)


def function(value: Any, option: str) -> Any:
    """Returns the value, which must be callable."""
    if not callable(value):
        raise TypeError(f"{option}={value!r} cannot be called: it is of type {type(value).__name__}")
    return value


# Check of each option, which is the same in all functions that have the option.
_CHECKS: dict[str, Callable[[Any, str], Any]] = {
    "seed": number, "place_seed": number, "batch": count, "count": length, "first": number,
    "jobs": jobs, "per_archive": count, "time_limit": seconds,
    "name": text, "shard": text, "output": path,
    "target": word, "assets": word, "sampler": word, "on_invalid": word, "validate": word,
    "durability": word, "profile": word, "layout": word,
    "resume": flag, "verify": flag, "force": flag, "if_changed": flag, "each": flag,
    "mocap": flag, "pad": flag, "physics": flag, "progress": function,
}
# Options that may be None, which means their default.
_OPTIONAL = {"place_seed", "batch", "jobs", "per_archive", "time_limit", "shard", "profile",
             "progress", "durability"}


def checked(options: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the options after their checks. Raises TypeError or ValueError with the name of the
    option.
    """
    return {option: None if value is None and option in _OPTIONAL else _CHECKS[option](value, option)
            for option, value in options.items()}
