#!/usr/bin/env python3
"""Runs the wheel for 64-bit ARM in an emulator, where nothing else of mjforge is, and compares what it
writes with the output of the wheel for x86_64. Says a line about each check and counts them.

    emulated.py DIST NATIVE_DIST ROOT FOLDER

Each DIST has a wheel. ROOT has Debian for 64-bit ARM, with Python. The folder is made anew.
"""

import filecmp
import itertools
import json
import pathlib
import re
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tests/interop"))

from report import check, expect, finish

# What a wheel for manylinux_2_35 may take from the system.
SYSTEM = re.compile(r"(ld-linux-aarch64|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|z))\.so\b.*")
# A hull with many points in two planes: Qhull lists its faces in an order that depends on rounding.
DRUM = """
mjforge: 1
name: drum
params: {a: 1cm .. 5cm, b: 1cm .. 5cm, c: 1cm .. 5cm}
parts:
  - name: drum
    type: hull
    density: 700
    points:
      - {for: {i: 24}, at: [a * cos(i * 15deg), b * sin(i * 15deg), c]}
      - {for: {i: 24}, at: [a * cos(i * 15deg), b * sin(i * 15deg), -c]}
"""
MODULE = """
import mjforge
variants = mjforge.Spec("mug").variants(seed=7, validate="load")
print(variants[1].xml, variants[1].record)
variants.write("mugs/", 3)
"""


class Wheel:
    """An unpacked wheel, and the command that runs programs of its architecture."""

    def __init__(self, dist, arch, folder, *emulator):
        self.file, = dist.glob("*.whl")
        self.folder = folder / arch
        self.packages = self.folder / "packages"
        self.emulator = emulator
        subprocess.run([sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check",
                        "--no-index", "--no-deps", "--only-binary=:all:",
                        "--platform", f"manylinux_2_35_{arch}", "--target", self.packages, self.file], check=True)

    def run(self, *command):
        """Its standard output. No variable leads to a checkout."""
        result = subprocess.run([*self.emulator, *map(str, command)], cwd=self.folder, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={"PATH": "/usr/bin:/bin", "PYTHONPATH": str(self.packages)})
        expect(result.returncode == 0,
               f"{command} ended with {result.returncode}: {(result.stdout + result.stderr)[-800:]}")
        return result.stdout

    def mjforge(self, *words):
        return self.run("/usr/bin/python3", "-m", "mjforge", *words)


def needs_nothing_else(arm):
    binaries = [arm.packages / "mjforge/bin/mjforge", arm.packages / "mjforge/lib/libmjforge.so",
                *(arm.packages / "mjforge.libs").iterdir()]
    expect(len(binaries) > 10, f"only {binaries}")
    for binary in binaries:
        for line in arm.run("/lib/ld-linux-aarch64.so.1", "--list", binary).splitlines():
            name, arrow, found = line.strip().partition(" => ")
            known = not arrow or SYSTEM.fullmatch(pathlib.Path(name).name)
            expect(known or str(arm.packages) in found, f"{binary.name} needs {line.strip()}")
        expect(str(SOURCE).encode() not in binary.read_bytes(), f"{binary.name} names {SOURCE}")


def has_the_licenses(arm, native):
    arms, natives = ({file.name for file in wheel.packages.glob("*.dist-info/licenses/*")}
                     for wheel in (arm, native))
    expect(arms == natives and len(arms) > 10, f"in one of the wheels only: {arms ^ natives}")
    return f"{len(arms)} licenses"


def has_the_command(arm):
    version = arm.mjforge("--version")
    expect(re.match(r"mjforge \d+\.\d+\.\d+\nMuJoCo 4\.0\.\d+\n", version), f"wrong version: {version}")
    arm.mjforge("check", "mug", "-n", "2", "--physics")


def differing(left, right):
    """The files that differ in two folders, or that only one of them has."""
    names = {path.relative_to(folder) for folder in (left, right) for path in folder.rglob("*") if path.is_file()}
    _, wrong, missing = filecmp.cmpfiles(left, right, names, shallow=False)
    return [str(name) for name in wrong + missing]


def writes_the_same(arm, native, folder, *words):
    for wheel in arm, native:
        (wheel.folder / folder).mkdir()
        wheel.mjforge("generate", *words, "--seed", "7", "--validate", "load", "-q")
    wrong = differing(arm.folder / folder, native.folder / folder)
    expect(not wrong, f"differ: {wrong}")
    return f"{len(list((arm.folder / folder).rglob('*.*')))} files"


def has_the_module(arm, native):
    expect(arm.run("/usr/bin/python3", "-c", MODULE) == native.run("/usr/bin/python3", "-c", MODULE),
           "variants differ")
    wrong = differing(arm.folder / "mugs", native.folder / "mugs")
    expect(not wrong, f"differ: {wrong}")


def main():
    dist, native_dist, root, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    shutil.rmtree(folder, ignore_errors=True)
    arm = Wheel(dist, "aarch64", folder, "proot", "-q", "qemu-aarch64", "-r", root, "-b", folder, "-b", "/dev",
                "-b", "/proc", "-w", folder / "aarch64")
    native = Wheel(native_dist, "x86_64", folder)
    drum = folder / "drum.yaml"
    drum.write_text(DRUM)
    names = [entry["name"] for entry in json.loads(native.mjforge("catalogue", "--json"))]
    names.remove("scenes/bin_pile")  # a pile depends on the last bits of MuJoCo
    check("the wheel needs no other library", needs_nothing_else, arm)
    check("the wheel has the licenses of the other", has_the_licenses, arm, native)
    check("the command of the wheel", has_the_command, arm)
    # A run for each folder, because specs of different folders can have the same name.
    for group, members in itertools.groupby(names, lambda name: name.partition("/")[0]):
        check(f"bundled specs of {group}, as on x86_64", writes_the_same, arm, native, group, *members,
              "-n", "3", "-o", f"{group}/")
    check("hulls, as on x86_64", writes_the_same, arm, native, "drums", drum, "-n", "100", "-o", "drums/")
    check("archives, as on x86_64", writes_the_same, arm, native, "archive", "mug", "-n", "3", "-o",
          "archive/mugs.tar.zst")
    check("the module of the wheel", has_the_module, arm, native)
    finish()


main()
