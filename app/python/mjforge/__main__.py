"""`python -m mjforge` and the console script `mjforge`: run the command."""

import os
import sys

from ._library import PROGRAM


def main() -> None:
    """Runs `mjforge prove` with the MuJoCo of this Python; for other commands, replaces this
    process by the program.
    """
    if sys.argv[1:2] == ["prove"]:
        from ._prove import main as prove

        sys.exit(prove(sys.argv[2:]))
    os.execv(PROGRAM, ["mjforge", *sys.argv[1:]])


if __name__ == "__main__":
    main()
