"""What the checks say: one line each, `ok NAME` or `FAILED NAME: why`, and their count."""

import traceback

_passed = 0
_failed = 0


class Broken(Exception):
    """A check has failed, and has said so; those that build on it need not be tried."""


def _fail(name, error):
    global _failed
    _failed += 1
    where = traceback.extract_tb(error.__traceback__)[-1]
    print(f"FAILED {name}: {error} ({where.name}, line {where.lineno})", flush=True)


def check(name, action, *arguments):
    """Runs an action; it passes unless it raises: then Broken. Says which.

    The action may return a few words that are said after the name.
    """
    global _passed
    try:
        words = action(*arguments)
    except Exception as error:  # whatever it is, it is a failure of the check
        _fail(name, error)
        raise Broken from error
    _passed += 1
    print(f"ok {name}" + (f" ({words})" if words else ""), flush=True)


def scenario(name, action, *arguments):
    """Checks that build on each other: the first that fails ends them."""
    try:
        action(*arguments)
    except Broken:
        pass  # it is counted
    except Exception as error:
        _fail(name, error)


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def failures():
    return _failed


def finish():
    """Says the count, last of all; the exit status."""
    print(f"{_passed} passed, {_failed} failed")
    return 1 if _failed else 0
