#!/usr/bin/env python3
"""Installs the wheel where nothing else of mjforge is, and tries the command, the module and the
examples there. Says a line about each check and counts them.

    run.py DIST FOLDER PYTHON

DIST has the wheel and the source distribution. The folder is made anew. PYTHON is the Python of the
environment.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import venv

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tests/interop"))

from report import check, expect, finish

# What a wheel for manylinux_2_35 may take from the system.
SYSTEM = re.compile(r"(ld-linux-x86-64|linux-vdso|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|z))\.so\b.*")
MEGABYTES = 12
# Of what robosuite depends on, its devices and controllers are left out: they need a compiler and
# a display.
ROBOSUITE = ["mujoco==3.3.7", "numpy<2; python_version<'3.13'", "numba", "scipy", "Pillow", "opencv-python-headless", "termcolor"]


class Place:
    """An empty virtual environment, and an empty folder to work in. Compiled modules are in another folder,
    so that pip need not compile all modules of large packages, and scripts leave nothing beside them."""

    def __init__(self, dist, folder, python):
        shutil.rmtree(folder, ignore_errors=True)
        self.wheel, = dist.glob("*.whl")
        self.sources, = dist.glob("*.tar.gz")
        self.bin = folder / "venv/bin"
        self.empty = folder / "empty"
        self.empty.mkdir(parents=True)
        self.compiled = folder / "compiled"
        self.pip_python = folder / "pip/bin/python"
        venv.create(folder / "pip", with_pip=True)
        subprocess.run([python, "-m", "venv", "--without-pip", folder / "venv"], check=True)
        said = self.run(self.bin / "python", "-c", "import sys; print(*sys.version_info[:2])")
        self.version = tuple(map(int, said.split()))

    def run(self, *command, status=0, **variables):
        """Its standard output and error. No variable leads to a checkout."""
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("PYTHON", "MJFORGE", "LD_"))}
        environment |= {"PATH": f"{self.bin}:{environment['PATH']}", "PYTHONPYCACHEPREFIX": str(self.compiled),
                        **variables}
        result = subprocess.run([str(word) for word in command], cwd=self.empty, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment)
        expect(result.returncode == status,
               f"{command[0]} ended with {result.returncode}: {result.stdout[-800:]}")
        return result.stdout

    def pip(self, *words, status=0):
        return self.run(self.pip_python, "-m", "pip", "--python", self.bin / "python",
                        "--disable-pip-version-check", *words, status=status, PYTHONPYCACHEPREFIX="")

    def install(self, *words):
        """Installs packages from PyPI."""
        return self.pip("install", "--quiet", "--only-binary=:all:", "--no-compile", *words)


def is_small(place):
    size = place.wheel.stat().st_size / 1e6
    expect(size <= MEGABYTES, f"{size:.1f} MB are more than {MEGABYTES}")
    expect("-py3-none-manylinux_2_35_x86_64" in place.wheel.name, place.wheel.name)
    return f"{size:.1f} MB"


def installs_alone(place):
    place.pip("install", "--no-index", "--no-deps", place.wheel)
    listed = place.pip("list", "--format=freeze").split()
    expect(len(listed) == 1 and listed[0].startswith("mjforge=="), f"installed: {listed}")


def packaged(place):
    """The folder of the installed module."""
    said = place.run(place.bin / "python", "-c", "import mjforge; print(mjforge.__path__[0])")
    return pathlib.Path(said.strip())


def needs_nothing_else(place):
    folder = packaged(place)
    binaries = [folder / "bin/mjforge", folder / "lib/libmjforge.so",
                *folder.with_name("mjforge.libs").iterdir()]
    expect(len(binaries) > 10, f"only {binaries}")
    for binary in binaries:
        for line in place.run("ldd", binary).splitlines():
            name, _, found = line.strip().partition(" => ")
            known = SYSTEM.fullmatch(pathlib.Path(name.split()[0]).name)
            expect(known or str(folder.parent) in found, f"{binary.name} needs {line.strip()}")
        expect(str(SOURCE).encode() not in binary.read_bytes(), f"{binary.name} names {SOURCE}")


def has_the_licenses(place):
    folder, = packaged(place).parent.glob("mjforge-*.dist-info")
    licenses = {file.name for file in (folder / "licenses").iterdir()}
    wanted = {"LICENSE", "mujoco", "libarchive-dev", "libgcrypt20", "libqhull-r8.0"}
    expect(wanted <= licenses, f"there are no {wanted - licenses}")
    expect((folder / "licenses/mujoco/LICENSES_THIRD_PARTY.md").exists(), "not all of MuJoCo's")
    return f"{len(licenses)} licenses"


def has_the_command(place):
    version = place.run("mjforge", "--version")
    expect(re.match(r"mjforge \d+\.\d+\.\d+\nMuJoCo 4\.0\.\d+\n", version), f"wrong version: {version}")
    place.run("mjforge", "generate", "hammer", "-n", "3", "--seed", "7", "-o", "hammers")
    place.run("mjforge", "generate", "mug", "-n", "3", "-o", "mugs.tar.zst")
    made = sorted(path.name for path in (place.empty / "hammers").glob("*.xml"))
    expect(made == [f"hammer_{i:06}.xml" for i in range(3)], f"made {made}")
    place.run(place.bin / "python", "-m", "mjforge", "check", "mug", "-n", "2", "--physics")
    expect("tools/hammer" in place.run("mjforge", "catalogue"), "no catalogue")


def makes_every_spec(place):
    """Every bundled spec behaves in the MuJoCo of the wheel."""
    names = [entry["name"] for entry in json.loads(place.run("mjforge", "catalogue", "--json"))]
    expect(len(names) > 50, f"only {len(names)} specs")
    place.run("mjforge", "check", *names, "-n", "1", "--physics")
    return f"{len(names)} specs"


def proves(place):
    """Batches of the wheel's MuJoCo are as recorded in another one."""
    for batch, count in (("hammers", 3), ("mugs.tar.zst", 3)):
        said = place.run("mjforge", "prove", batch)
        expect(re.match(rf"{count} variants in {batch}: {count} as recorded in MuJoCo 3\.3\.7; checked in "
                        r"4\.0\.\d+ when made", said), said)


def draws(place):
    place.run("mjforge", "preview", "mug", "-o", "mug.png")
    expect((place.empty / "mug.png").read_bytes()[:4] == b"\x89PNG", "not a picture")
    place.run("mjforge", "catalogue", "knurled", "--html", "gallery")
    page = (place.empty / "gallery/specs/tools/adjustable_wrench.html").read_text(encoding="utf-8")
    expect('<img src="data:image/webp;base64,' in page, "no picture in the gallery")


def has_the_module(place):
    said = place.run(place.bin / "python", "-c", "import mjforge; "
                     "print(mjforge.Spec('hammer').variants(seed=7, validate='load')[1].xml)")
    # The command says that there is one variant, the module that there is no end.
    written = (place.empty / "hammers/hammer_000001.xml").read_text()
    expect(said.partition("-->")[2].strip() == written.partition("-->")[2].strip(), "bytes differ")


def example(place, name, words):
    # Python warns of escape sequences in robosuite when it compiles it.
    said = place.run(place.bin / "python", SOURCE / "docs/examples/python" / name,
                     PYTHONWARNINGS="ignore::SyntaxWarning")
    said = [line for line in said.splitlines() if not line.startswith("[robosuite ")]
    expect(re.fullmatch(words, "\n".join(said)), f"said {said}")
    return said[-1]


WRONG_WORDS = """import mjforge
mjforge.Spec("hammer").variants(target="robosuit")
mjforge.Spec("hammer").variants(validate="fysics")
mjforge.Spec("hammer").check("3")
mjforge.Spec("hammer").variants()[0].attach(None, pos="abc")
"""
GOOD_WORDS = """from typing import Any
import mjforge
import numpy as np
def add(scene: Any, variant: mjforge.Variant) -> None:
    variant.attach(scene, pos=np.zeros(3), quat=np.array([1.0, 0, 0, 0]))
    variant.attach(scene, pos=np.array([0, 0, 1]), quat=np.zeros(4, dtype=np.float32))
    variant.attach(scene, pos=[0, 0, 1], quat=(1, 0, 0, 0))
"""


def has_types(place):
    place.install("mypy", "pyright")
    place.run(place.bin / "mypy", "--strict", "-p", "mjforge")
    place.run(place.bin / "pyright", packaged(place))
    (place.empty / "wrong_words.py").write_text(WRONG_WORDS)
    (place.empty / "good_words.py").write_text(GOOD_WORDS)
    for checker in (("mypy", "--strict"), ("pyright",)):
        place.run(place.bin / checker[0], *checker[1:], "good_words.py")
        said = place.run(place.bin / checker[0], *checker[1:], "wrong_words.py", status=1)
        found = {int(line) for line in re.findall(r"wrong_words\.py:(\d+)(?::\d+)?.* error: ", said)}
        expect(found == {2, 3, 4, 5}, f"{checker[0]} says {said}")


def has_its_tests_passed(place):
    """Also of the chapter's examples that need other packages."""
    said = place.run(place.bin / "python", "-m", "unittest", "discover", "--start-directory",
                     SOURCE / "tests/python", "--pattern", "*_test.py", CHAPTER_EXAMPLES="all")
    return re.search(r"Ran \d+ tests", said)[0].lower()


def resets_in(place, requirement, *count):
    """Attaches and simulates objects in a release of MuJoCo."""
    # The package of 4.0 is divided, and an upgrade from an earlier one removes files of its parts.
    place.pip("uninstall", "--quiet", "--yes", "mujoco")
    place.install("--upgrade", requirement, "numpy")
    return place.run(place.bin / "python", SOURCE / "tests/wheel/resets.py", *count).strip()


def mujoco_of_mjlab(place):
    """The release of MuJoCo that the newest mjlab asks for."""
    report = json.loads(place.run(place.pip_python, "-m", "pip", "--disable-pip-version-check", "install", "--quiet",
                                  "--dry-run", "--no-deps", "--ignore-installed", "--report", "-", "mjlab"))
    asked = report["install"][0]["metadata"]["requires_dist"]
    return next(each for each in asked if re.match(r"mujoco\b(?!-)", each))


def goes(place):
    place.pip("uninstall", "--yes", "mjforge")
    left = [path.name for path in place.bin.parent.rglob("*mjforge*")]
    expect(not left, f"left: {left}")


def sources_say_what_is_missing(place):
    said = place.pip("install", "--no-deps", place.sources, status=1, *(
        f"--config-settings=cmake.define.CMAKE_DISABLE_FIND_PACKAGE_{name}=ON"
        for name in ("tinyobjloader", "xxhash")))
    expect(re.search(r"These libraries are missing[^\n]*\n\s+tinyobjloader\s+xxhash\s", said), said[-1500:])


def main():
    dist, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    place = Place(dist, folder, sys.argv[3])
    check("the wheel is small", is_small, place)
    check("the wheel needs no other package", installs_alone, place)
    check("the wheel needs no other library", needs_nothing_else, place)
    check("the wheel has the licenses of what is in it", has_the_licenses, place)
    check("the command of the wheel", has_the_command, place)
    check("bundled specs in the MuJoCo of the wheel", makes_every_spec, place)
    check("pictures of the wheel", draws, place)
    check("the module of the wheel", has_the_module, place)
    check("robosuite beside the wheel", place.install, *ROBOSUITE)
    check("batches in another MuJoCo", proves, place)
    check("robosuite itself", place.pip, "install", "--quiet", "--no-compile", "--no-deps", "robosuite==1.5.2")
    check("example: a thousand models", example, place, "thousand_models.py",
          r"1000 models of 0\.\d+ to 0\.\d+ kg")
    check("example: a new hammer at each reset", example, place, "new_hammer_each_reset.py",
          r"(hammer \d: (0\.\d+) kg of \2, \d+ mm above the table\n?){3}")
    check("resets in the MuJoCo of robosuite", resets_in, place, "mujoco==3.3.7")
    check("types", has_types, place)
    check("the packages of the chapter's examples", place.install, "gymnasium")
    check("the package's tests", has_its_tests_passed, place)
    # mjlab needs Python 3.10.
    if place.version >= (3, 10):
        check("resets in the MuJoCo of mjlab", lambda: resets_in(place, mujoco_of_mjlab(place)))
    check("resets in the newest MuJoCo", resets_in, place, "mujoco", "10000")
    check("the wheel goes", goes, place)
    check("the source distribution says what is missing", sources_say_what_is_missing, place)
    finish()


main()
