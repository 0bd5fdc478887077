"""`python -m mjforge` and the console script: the command itself."""

import os
import sys

from ._library import PROGRAM


def main() -> None:
    """Proves a batch in the MuJoCo of this Python, or becomes the command."""
    if sys.argv[1:2] == ["prove"]:
        from ._prove import main as prove

        sys.exit(prove(sys.argv[2:]))
    os.execv(PROGRAM, ["mjforge", *sys.argv[1:]])


if __name__ == "__main__":
    main()
