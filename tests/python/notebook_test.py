"""The notebook of the documentation has the outputs that its cells give.

MJFORGE_UPDATE=1 writes the outputs into the notebook.
"""

import ast
import base64
import contextlib
import io
import json
import os
import pathlib
import unittest

NOTEBOOK = pathlib.Path(__file__).resolve().parents[2] / "docs/examples/python/hammers.ipynb"


def lines_of(text):
    return text.splitlines(keepends=True)


def outputs_of(source, names, count):
    """The outputs of a cell as a notebook stores them, among them that of its last expression."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, "cell", "exec"), names)
        value = None if last is None else eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    outputs = []
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines_of(printed.getvalue())})
    if value is not None:
        data = {"text/plain": lines_of(repr(value))}
        if hasattr(value, "_repr_png_"):
            data["image/png"] = base64.b64encode(value._repr_png_()).decode()
        outputs.append({"data": data, "execution_count": count, "metadata": {}, "output_type": "execute_result"})
    return outputs


def size_of(picture):
    return base64.b64decode(picture)[16:24]


def without_pixels(outputs):
    """Renderers differ in the last digits of colors, so that only the size of a picture is compared."""
    return [{**output, "data": {**output["data"], "image/png": size_of(output["data"]["image/png"])}}
            if "image/png" in output.get("data", {}) else output for output in outputs]


class Notebook(unittest.TestCase):
    def test_has_the_outputs_of_its_cells(self):
        notebook = json.loads(NOTEBOOK.read_text())
        names = {}
        count = 0
        pictures = 0
        for cell in notebook["cells"]:
            if cell["cell_type"] != "code":
                continue
            count += 1
            made = outputs_of("".join(cell["source"]), names, count)
            pictures += any("image/png" in output.get("data", {}) for output in made)
            if os.environ.get("MJFORGE_UPDATE"):
                cell.update(outputs=made, execution_count=count)
            self.assertEqual(without_pixels(cell["outputs"]), without_pixels(made), "".join(cell["source"]))
            self.assertEqual(cell["execution_count"], count)
        self.assertGreater(pictures, 2)
        if os.environ.get("MJFORGE_UPDATE"):
            NOTEBOOK.write_text(json.dumps(notebook, indent=1) + "\n")


if __name__ == "__main__":
    unittest.main()
