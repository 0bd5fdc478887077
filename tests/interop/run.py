#!/usr/bin/env python3
"""Generates every bundled spec for every host and has the hosts themselves read
it. Says a line about each check and counts them; what cannot be installed has
failed.

    run.py PROGRAM FOLDER [--all] [--write] [HOST...]

Without HOSTs those that are not heavy; --all: all of them. The folder is made anew; it gets a
virtual environment for each host. --write puts the table of the hosts that ran into
docs/hosts.md, if nothing failed.
"""

import argparse
import concurrent.futures
import dataclasses
import datetime
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import venv

HERE = pathlib.Path(__file__).resolve().parent

# The sets of files: how many variants of each spec, and options of `generate`. MuJoCo gets 20
# times as many with --all.
SETS = {
    "mujoco": (1, ["--target", "mujoco"]),
    "robosuite": (1, ["--target", "robosuite"]),
    "robocasa": (1, ["--target", "robocasa"]),
    "mjx": (1, ["--target", "mjx"]),
    "files": (1, ["--assets", "files"]),
}
# Families (`-o NAME.npz`), and what makes all their variants one structure.
FAMILIES = {
    "hammer": ["robosuite/hammer", "--set", "handle_shape=box"],
    "any_hammer": ["robosuite/hammer"],
    "mug": ["mug"],
    "pot": ["robosuite/pot_with_handles", "--set", "solid_handle=false"],
    "hinged_box": ["robosuite/hinged_box"],
    "cabinet": ["articulated/drawer_cabinet", "--set", "drawers=3", "--set", "handle=bar"],
    "scissors": ["articulated/scissors"],
}
FAMILY_SIZE = 64
# Options of the family, and not of its variants alone: null geoms, and a mocap body.
OF_FAMILY = {"any_hammer": ["--pad"], "mug": ["--pad"], "cabinet": ["--mocap"]}
FOR_MJX = {"mug": ["--set", "handle_shape=round"], "cabinet": ["--mocap"]}
# Falling on a ball, the prisms that stand for round handles touch it in other places than in MuJoCo.
UNLIKE_MJX = {"any_hammer"}


@dataclasses.dataclass
class Host:
    packages: list
    scripts: list
    checked: str  # for the page
    alone: list = dataclasses.field(default_factory=list)  # without what they depend on
    heavy: bool = False  # it is large, or it takes long
    long: list = dataclasses.field(default_factory=list)  # scripts that run only with --all, because they take long


# Of what robosuite depends on, its devices and controllers are left out: they need a compiler and
# a display.
ROBOSUITE = ["numpy<2", "numba", "scipy", "Pillow", "opencv-python-headless", "termcolor"]
PROVED = "`prove` (names, masses, inertias, bounds, start state)"
MUJOCO = PROVED + " of {count} variants, each simulated for a second"
HOSTS = {
    # From 2.3.3 to 3.1.1 MuJoCo crashes on any mesh with texture coordinates in its XML.
    "mujoco-2.3": Host(["mujoco==2.3.7"], ["check_files.py"],
                       PROVED + ", with `--assets files`"),
    "mujoco-3.1": Host(["mujoco==3.1.2", "numpy<2"], ["check_mujoco.py"], MUJOCO,
                       heavy=True),
    "mujoco-3.3": Host(["mujoco==3.3.7"], ["check_mujoco.py", "check_couplings.py", "check_python.py",
                                            "check_reset.py", "check_later.py", "check_family.py",
                                            "check_family_files.py"],
                       MUJOCO + "; families, row by row; couplings, driven; attached to a scene in Python; "
                       "files with `<frame>` and `<replicate>`, expanded and attached"),
    "mujoco-newest": Host(["mujoco"], ["check_mujoco.py", "check_couplings.py", "check_python.py", "check_reset.py",
                                       "check_family.py", "check_family_files.py"],
                          MUJOCO + "; families, row by row; couplings, driven; attached to a scene in Python; "
                          "the same with `--assets files`", long=["check_files.py"]),
    "robosuite": Host(["mujoco"] + ROBOSUITE,
                      ["check_robosuite.py", "check_robocasa.py", "check_attached.py"],
                      "`MujocoXMLObject`, its sampler, rest on a table; robocasa's rules for an object; "
                      "robosuite's own files, attached", alone=["robosuite"]),
    # Its environments run with MuJoCo before 3.10.
    "robosuite-3.3": Host(["mujoco==3.3.7"] + ROBOSUITE, ["check_lift.py", "check_scene.py", "check_example.py"],
                          "the example of an environment, as written, also with joints; "
                          "the environment `Lift` with a Panda, in which four of the objects are the "
                          "cube; a scene of 11 objects beside a Panda, each a file (`--each`)", alone=["robosuite==1.5.2"]),
    "mjx": Host(["mujoco-mjx"], ["check_mjx.py", "check_mjx_worlds.py"],
                "a world with everything that it could touch, on the device; families, each of 64 worlds with its own "
                "variant, as each variant alone in MuJoCo", long=["check_mjx_worlds.py --slow"]),
    # It needs what MuJoCo 4.0 no longer has.
    "dm_control": Host(["dm_control", "mujoco==3.17.0"], ["check_dm_control.py"],
                       "`mjcf.from_path` and `Physics`: bodies, joints, geoms, masses, with inline "
                       "meshes and with `--assets files`"),
    "loaders": Host(["pandas", "zstandard", "webdataset"], ["check_batches.py", "check_tables.py"],
                    "a compressed series of archives and its manifest; tables of variants"),
    "drake": Host(["drake"], ["check_drake.py"],
                  "bodies, joints, collision geometries, mass, with `--assets files`; it leaves "
                  "inline meshes out", heavy=True),
    "newton": Host(["newton", "mujoco-warp", "trimesh", "Pillow", "scipy"],
                   ["check_newton.py", "check_newton_worlds.py"],
                   "bodies, shapes, mass, with inline meshes and with `--assets files`; the worlds of a family",
                   heavy=True),
    "mujoco-warp": Host(["mujoco-warp"], ["check_worlds.py"],
                        "six families, each of 64 worlds with its own variant, as each variant alone in MuJoCo, on "
                        "the CPU, also in `mujoco.batch`; masses on the device; three objects step as in MuJoCo",
                        long=["check_warp.py"]),
    # With PyTorch and its CUDA: 7 GB on the disk, although the CPU is enough here.
    "mjlab": Host(["mjlab"], ["check_mjlab.py", "check_mjlab_worlds.py"],
                  "`EntityCfg` and `Entity`: bodies, joints, geoms, masses; three objects step in two "
                  "worlds as in MuJoCo, on the CPU; a family in 64 worlds, also after a reset", heavy=True),
    "usd": Host(["mujoco-usd-converter"], ["check_usd.py"],
                "bodies, joints, colliders, stated masses, with `--assets files`; it refuses inline "
                "meshes and leaves ellipsoids out", heavy=True),
}
# Hosts that take longest. Their checks start first, so that both cores are busy until the end.
FIRST = ["mujoco-3.3", "mujoco-newest", "mjx", "mujoco-warp"]
# The packages whose versions the page tells.
TOLD = ["mujoco", "mujoco-mjx", "mujoco-warp", "robosuite", "dm_control", "drake", "newton", "mjlab",
        "mujoco-usd-converter", "pandas", "webdataset"]
BEGIN, END = "<!-- written by ./dev interop --all --write -->\n", "<!-- up to here -->\n"


def run(command):
    """Its standard output; its last words as an error if it fails."""
    result = subprocess.run(command, capture_output=True)
    if result.returncode != 0:
        words = " ".join((result.stdout + result.stderr).decode(errors="replace").split())
        raise RuntimeError(f"{pathlib.Path(command[0]).name} failed: {words[-500:]}")
    return result.stdout


def count_of(target, is_all):
    return SETS[target][0] * (20 if is_all and target == "mujoco" else 1)


def generate(program, folder, is_all):
    """All files. Returns the number of specs."""
    names = [entry["name"] for entry in json.loads(run([program, "catalogue", "--json"]))]
    if not names:
        raise RuntimeError("the catalogue is empty")
    for target, (_, options) in SETS.items():
        for name in names:
            scene = name.startswith("scenes/")
            # Several roots; MJX would reserve memory for all pairs of geoms. With --assets files a
            # scene has the files of its objects.
            if scene and target != "mujoco" and not (is_all and target == "files"):
                continue
            try:
                count = min(count_of(target, is_all), 2) if scene else count_of(target, is_all)
                run([program, "generate", name, "-n", str(count), *options,
                     "-o", f"{folder / target / name}/", "--quiet"])
            except RuntimeError as error:
                if "[target/one-root]" not in str(error):
                    raise
                shutil.rmtree(folder / target / name, ignore_errors=True)
                print(f"{target} cannot take {name}: it has free bodies", flush=True)
    for name, options in FAMILIES.items():
        for output, more in ((f"{name}.npz", OF_FAMILY.get(name, [])), (f"{name}/", [])):
            run([program, "generate", *options, *more, "-n", str(FAMILY_SIZE), "--seed", "7",
                 "-o", str(folder / "family" / output), "--quiet"])
        if name not in UNLIKE_MJX:
            run([program, "generate", *options, *FOR_MJX.get(name, []), "-n", str(FAMILY_SIZE), "--seed", "7",
                 "--target", "mjx", "-o", str(folder / "family_mjx" / f"{name}.npz"), "--quiet"])
    for spec in ("primitives/cylinder", HERE / "uneven.yaml", HERE / "string.yaml"):
        run([program, "generate", str(spec), "-n", str(FAMILY_SIZE), "--seed", "7", "--target", "mjx",
             "-o", str(folder / "family_mjx" / f"{pathlib.Path(spec).stem}.npz"), "--quiet"])
    for target in ("robosuite", "robocasa"):
        run([program, "generate", str(HERE / "scene.yaml"), "--each", "--target", target,
             "-o", f"{folder / 'each' / target}/", "--quiet"])
    run([program, "generate", "robosuite/hammer", "-n", "200", "-o", f"{folder / 'series'}/h_%02d.tar.zst",
         "--per-archive", "80", "--quiet"])
    return len(names)


def install(base, place, packages, alone):
    """Installs packages in a virtual environment. Python compiles the modules that the scripts import."""
    venv.create(place, with_pip=False)
    command = [base / "bin/python", "-m", "pip", "--python", place / "bin/python",
               "--disable-pip-version-check", "install", "--quiet", "--only-binary=:all:", "--no-compile"]
    for more in (packages, ["--no-deps"] + alone if alone else []):
        if more:
            run(command + more)


def versions_in(place):
    """"robosuite 1.5.2, mujoco 3.3.7": of the packages that are told."""
    code = ("import importlib.metadata as m, sys\n"
            "there = {d.metadata['Name'].lower(): d.version for d in m.distributions()}\n"
            "print(*[f'{p} {there[p.lower()]}' for p in sys.argv[1:] if p.lower() in there], sep=', ')")
    return run([place / "bin/python", "-c", code, *reversed(TOLD)]).decode().strip()


def run_host(base, folder, host, package, is_all):
    """(lines, versions, seconds) of one host's checks."""
    start = time.monotonic()
    chosen = HOSTS[host]
    try:
        install(base, folder / host, chosen.packages, chosen.alone)
    except RuntimeError as error:
        return ([f"FAILED {host}: cannot be installed: {error}"], "", time.monotonic() - start)
    installed = time.monotonic() - start
    lines = []
    environment = dict(os.environ, PYTHONPYCACHEPREFIX=str(folder / "compiled"), PYTHONWARNINGS="ignore",
                       PYTHONPATH=str(package))
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    for script in chosen.scripts + (chosen.long if is_all else []):
        name, *words = script.split()
        result = subprocess.run([folder / host / "bin/python", HERE / name, folder / "files", *words],
                                capture_output=True, text=True, env=environment, cwd=folder)
        said = [line for line in result.stdout.splitlines() if line.startswith(("ok ", "FAILED "))]
        if not said or (result.returncode != 0 and all(line.startswith("ok ") for line in said)):
            end = " ".join((result.stdout + result.stderr).split())[-500:]
            said.append(f"FAILED {host}: {script} broke off (status {result.returncode}): {end}")
        lines += said
    lines.append(f"{host}: {installed:.0f} s to install, "
                 f"{time.monotonic() - start - installed:.0f} s to check")
    return lines, versions_in(folder / host), time.monotonic() - start


def write_table(page, versions, specs, is_all):
    rows = [f"Of each of the {specs} bundled specs, on {datetime.date.today()}:\n\n",
            "| host | versions | what is checked |\n", "| --- | --- | --- |\n"]
    rows += [f"| {host} | {versions[host]} | "
             f"{one.checked.format(count=count_of('mujoco', is_all))} |\n"
             for host, one in HOSTS.items() if host in versions]
    text = page.read_text(encoding="utf-8")
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    page.write_text(text[:begin] + "\n" + "".join(rows) + "\n" + text[end:], encoding="utf-8")


def parse(arguments):
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("folder", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("hosts", nargs="*", metavar="HOST")
    options = parser.parse_args(arguments)
    if unknown := set(options.hosts) - set(HOSTS):
        parser.error(f"{', '.join(unknown)}: the hosts are {', '.join(HOSTS)}")
    if not options.hosts:
        options.hosts = [host for host, one in HOSTS.items() if options.all or not one.heavy]
    return options


def main():
    options = parse(sys.argv[1:])
    program, folder = options.program, options.folder
    if folder.exists():
        shutil.rmtree(folder)
    package = program.parent.parent / "python"  # where a build tree has it
    base = folder / "pip"
    venv.create(base, with_pip=True)
    start = time.monotonic()
    count = generate(program, folder / "files", options.all)
    print(f"{count} specs generated in {time.monotonic() - start:.0f} s", flush=True)
    passed = failed = 0
    versions = {}
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        hosts = {pool.submit(run_host, base, folder, host, package, options.all): host
                 for host in sorted(options.hosts, key=lambda host: host not in FIRST)}
        for done in concurrent.futures.as_completed(hosts):
            lines, versions[hosts[done]], seconds = done.result()
            print(*lines, sep="\n")
            print(f"{hosts[done]}: {seconds:.0f} s", flush=True)
            failed += sum(line.startswith("FAILED ") for line in lines)
            passed += sum(line.startswith("ok ") for line in lines)
    if options.write and not failed:
        write_table(HERE.parent.parent / "docs/hosts.md", versions, count,
                    options.all)
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


main()
