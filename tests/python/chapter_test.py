"""The examples of docs/python.md run one after the other, and print what the page shows."""

import contextlib
import importlib.util
import io
import os
import pathlib
import re
import tempfile
import unittest

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/python.md"
# `all`: also the examples whose modules are not installed, which then fail.
ALL = os.environ.get("CHAPTER_EXAMPLES") == "all"
# Modules that a test without a virtual environment may do without.
OPTIONAL = ("gymnasium", "mujoco", "numpy")


def examples():
    """Code, output or None, and number of its line, of each example of the page."""
    page = PAGE.read_text()
    for match in re.finditer(r"^```python\n(.*?)^```\n(?:```output\n(.*?)^```\n)?", page, re.M | re.S):
        yield match[1], match[2], page.count("\n", 0, match.start()) + 1


def missing(code):
    """The optional modules that the code needs and that are not installed."""
    needed = {name for name in OPTIONAL if re.search(rf"^import {name}\b", code, re.M)}
    if re.search(r"\.(load|prove)\(", code):
        needed.add("mujoco")
    return [name for name in needed if importlib.util.find_spec(name) is None]


class Chapter(unittest.TestCase):
    def test_its_examples(self):
        names = {}
        count = 0
        with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as stack:
            stack.callback(os.chdir, os.getcwd())
            os.chdir(folder)
            for code, output, line in examples():
                if missing(code) and not ALL:
                    continue
                said = io.StringIO()
                with self.subTest(line=line), contextlib.redirect_stdout(said):
                    exec(compile("\n" * line + code, str(PAGE), "exec"), names)
                    count += 1
                    if output is not None:
                        self.assertEqual(said.getvalue(), output)
        self.assertGreaterEqual(count, 7)


if __name__ == "__main__":
    unittest.main()
