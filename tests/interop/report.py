"""What the checks say: one line each, `ok NAME` or `FAILED NAME: why`."""

import sys
import time
import traceback

_passed = 0
_failed = 0


def check(name, action, *arguments):
    """Runs an action; it passes unless it raises. Says which, and goes on.

    The action may return a few words that are said after the name. Durations from 2 s on are said, too.
    """
    global _passed, _failed
    start = time.monotonic()
    try:
        words = action(*arguments)
    except Exception as error:  # whatever the host throws is a failure of the check
        _failed += 1
        where = traceback.extract_tb(error.__traceback__)[-1]
        print(f"FAILED {name}: {error} ({where.name}, line {where.lineno})", flush=True)
    else:
        _passed += 1
        seconds = time.monotonic() - start
        print(f"ok {name}" + (f" ({words})" if words else "") + (f" in {seconds:.0f} s" if seconds >= 2 else ""),
              flush=True)


def still_refused(name, reason, action, *arguments):
    """What a host cannot take: passes as long as the action raises, so that the reason is not told
    when it no longer holds."""
    def refused():
        try:
            action(*arguments)
        except Exception:
            return reason
        raise AssertionError(f"it takes this now; it did not: {reason}")
    check(name, refused)


def expect(condition, message):
    if not condition:
        raise AssertionError(message)


def raises(error, words, action, *arguments, **options):
    """The action raises this error, and these words are in its message."""
    try:
        action(*arguments, **options)
    except error as raised:
        expect(words in str(raised), str(raised))
    else:
        raise AssertionError(f"{arguments} {options} are taken")


def finish():
    print(f"{_passed} passed, {_failed} failed")
    sys.exit(1 if _failed else 0)
