"""Any MuJoCo loads each variant whose meshes and textures are files, as recorded. From 2.3.3 to 3.1.1
it crashes on inline meshes with texture coordinates.

    check_files.py FOLDER
"""

import sys

import mujoco

from generated import prove, specs
from report import check, finish

for name, variants in specs(sys.argv[1], "files"):
    check(f"mujoco {mujoco.__version__} {name} with files", prove, variants)
finish()
