"""Makes one call of the program fail or late, or kills it there, and goes on with --resume.

For each kind of call and each number: the exit status must say that something failed (or everything
must be there), nothing under a final name may be wrong, and --resume must give the same bytes.

  python3 faults.py PROGRAM SHIM OUTPUT [--every N]
"""

import errno
import sys

import harness

KINDS = {
    "open": [errno.EMFILE, errno.EACCES],
    "read": [errno.EIO, errno.EINTR, "short"],
    "write": [errno.EIO, errno.ENOSPC, errno.EDQUOT, errno.EINTR, "short"],
    "rename": [errno.EIO],
    "sync": [errno.EIO],
    "mkdir": [errno.ENOSPC],
    "close": [errno.EIO, errno.EDQUOT],
    "truncate": [errno.EIO],
    "unlink": [errno.EIO],
    "fork": [errno.EAGAIN],
    "mmap": [errno.ENOMEM],
}
# What is not a fault: the call is made again, or its failure does not matter.
HARMLESS = {("read", errno.EINTR), ("read", "short"), ("write", errno.EINTR), ("write", "short"),
            ("unlink", errno.EIO), *((kind, "late") for kind in KINDS)}


def what_is_wrong(batch, whole, result, kind, how):
    """Of the faulty run itself; empty: nothing."""
    killed = how in ("kill", "killed")
    done = result.returncode == 0
    if done and batch.files() != whole:
        return "status 0, but files differ"
    if not done and kind == "read" and how == errno.EIO and result.returncode != 3:
        return f"status {result.returncode} rather than 3"
    if not done and not killed and not harness.is_honest(result):
        return f"status {result.returncode}"
    if not done and (kind, how) in HARMLESS:
        return f"status {result.returncode}, though it is harmless"
    for name, content in batch.files().items():
        # A manifest or seal of an interrupted batch has no final name yet, so all are as at the end.
        if name in whole and content != whole[name]:
            return f"'{name}' is wrong"
    return ""


def main():
    options = harness.parser("only every N-th call of a kind").parse_args()
    batch = harness.Batch(options.program, options.shim, options.output)
    batch.clear()
    result = batch.run()
    assert result.returncode == 0, result.stderr
    whole = batch.files()
    passed = failed = 0
    for kind, hows in KINDS.items():
        batch.clear()
        batch.run(fail=f"{kind} 0 0")
        calls = batch.calls()
        for how in [*hows, "late", "kill", "killed"]:
            for number in range(1, calls + 1, options.every):
                batch.clear()
                # Late calls matter to whoever waits for them: two workers and their leader.
                result = batch.run(fail=f"{kind} {number} {how}", jobs=2 if how == "late" else 1)
                wrong = what_is_wrong(batch, whole, result, kind, how)
                if not wrong:
                    again = batch.run("--resume")
                    if again.returncode != 0:
                        wrong = f"--resume: status {again.returncode}: {again.stderr}"
                    elif batch.files(hidden=True) != whole:
                        mine = batch.files(hidden=True)
                        wrong = "--resume: differ: " + ", ".join(
                            name for name in {*mine, *whole} if mine.get(name) != whole.get(name))
                if wrong:
                    failed += 1
                    print(f"{options.output}: {kind} {number} of {calls}, {how}: {wrong}\n"
                          f"{result.stderr}")
                else:
                    passed += 1
    print(f"{passed} passed, {failed} failed")
    batch.close()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
