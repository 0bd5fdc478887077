"""Import of packages that only some functions need."""

from __future__ import annotations

import importlib
from typing import Any


def needed(module: str, package: str) -> Any:
    """Returns the module of a package. Raises ImportError with the command that installs the
    package.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ImportError(f"this needs {module}: python -m pip install {package}") from error
