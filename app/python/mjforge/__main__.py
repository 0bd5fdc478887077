"""`python -m mjforge` and the console script: the command itself."""

import os
import sys

from ._library import PROGRAM


def main() -> None:
    """Becomes the command."""
    os.execv(PROGRAM, ["mjforge", *sys.argv[1:]])


if __name__ == "__main__":
    main()
