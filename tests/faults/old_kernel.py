"""Files are judged where the kernel has no pidfd_open (before 5.3) or forbids it.

  python3 old_kernel.py PROGRAM
"""

import ctypes
import errno
import pathlib
import struct
import subprocess
import sys
import tempfile

PIDFD_OPEN = 434  # on every architecture
SET_NO_NEW_PRIVS = 38
SET_SECCOMP = 22
MODE_FILTER = 2

MODEL = '<mujoco><worldbody><geom size="1"/></worldbody></mujoco>\n'


def forbid_pidfd_open():
    """In this process and those that it starts."""
    libc = ctypes.CDLL(None, use_errno=True)
    load_number = struct.pack("=HBBI", 0x20, 0, 0, 0)
    skip_if_other = struct.pack("=HBBI", 0x15, 0, 1, PIDFD_OPEN)
    fail = struct.pack("=HBBI", 0x06, 0, 0, 0x00050000 | errno.ENOSYS)
    allow = struct.pack("=HBBI", 0x06, 0, 0, 0x7FFF0000)
    steps = ctypes.create_string_buffer(load_number + skip_if_other + fail + allow)
    program = struct.pack("@HP", 4, ctypes.addressof(steps))
    assert libc.prctl(SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0
    assert libc.prctl(SET_SECCOMP, MODE_FILTER, program, 0, 0) == 0
    assert libc.syscall(PIDFD_OPEN, 1, 0) == -1 and ctypes.get_errno() == errno.ENOSYS


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    forbid_pidfd_open()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "good.xml"
        file.write_text(MODEL)
        result = subprocess.run([program, "validate", file], capture_output=True, text=True)
    print(result.stdout, result.stderr)
    return 0 if result.returncode == 0 and ": ok, " in result.stdout else 1


if __name__ == "__main__":
    sys.exit(main())
