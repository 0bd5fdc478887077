"""The example of an environment of robosuite runs as it is written, also with objects that have joints.

    check_example.py FOLDER
"""

import pathlib
import re
import subprocess
import sys

from report import check, expect, finish

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "docs/examples/python/new_hammer_each_reset.py"


def runs(name):
    said = subprocess.run([sys.executable, "-B", str(EXAMPLE), name], capture_output=True, text=True)
    expect(said.returncode == 0, said.stderr[-500:])
    lines = [line for line in said.stdout.splitlines() if not line.startswith("[robosuite ")]
    expect(re.fullmatch(rf"({name} \d: (\d+\.\d+) kg of \2, -?\d+ mm above the table\n?){{3}}", "\n".join(lines)),
           f"it says {lines}")
    return lines[-1]


for name in ("hammer", "hinged_box", "laptop"):
    check(f"a new {name} at each reset", runs, name)
finish()
