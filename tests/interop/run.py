#!/usr/bin/env python3
"""Generates every bundled spec for every host and has the hosts themselves read
it. Says a line about each check and counts them; what cannot be installed has
failed.

    run.py PROGRAM FOLDER [HOST...]

Without HOSTs all of them. The folder is made anew; it gets a virtual environment for each host.
"""

import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import venv

HERE = pathlib.Path(__file__).resolve().parent

# Variants of each spec, by target.
COUNTS = {"mujoco": 20, "robosuite": 3, "robocasa": 3, "mjx": 3}

# The hosts: packages, packages that come without what they depend on, checks.
# Of what robosuite depends on, its devices and controllers are left out: they
# need a compiler and a display.
HOSTS = {
    # From 2.3.3 to 3.1.1 MuJoCo crashes on any mesh with texture coordinates in its XML.
    "mujoco-3.1": (["mujoco==3.1.2", "numpy<2"], [], ["check_mujoco.py"]),
    "mujoco-3.3": (["mujoco==3.3.7"], [], ["check_mujoco.py", "check_python.py"]),
    "mujoco-newest": (["mujoco"], [], ["check_mujoco.py", "check_python.py"]),
    "robosuite": (["mujoco", "numpy<2", "numba", "scipy", "Pillow", "opencv-python-headless",
                   "termcolor"], ["robosuite"],
                  ["check_robosuite.py", "check_robocasa.py", "check_attached.py"]),
    "mjx": (["mujoco-mjx"], [], ["check_mjx.py"]),
}


def run(command):
    """Its standard output; its last words as an error if it fails."""
    result = subprocess.run(command, capture_output=True)
    if result.returncode != 0:
        words = " ".join((result.stdout + result.stderr).decode(errors="replace").split())
        raise RuntimeError(f"{pathlib.Path(command[0]).name} failed: {words[-500:]}")
    return result.stdout


def generate(program, folder):
    """All files, and beside each one for MuJoCo what 2.2.2 made of it."""
    names = [entry["name"] for entry in json.loads(run([program, "catalogue", "--json"]))]
    if not names:
        raise RuntimeError("the catalogue is empty")
    for target, count in COUNTS.items():
        for name in names:
            try:
                run([program, "generate", name, "-n", str(count), "--target", target,
                     "-o", f"{folder / target / name}/", "--quiet"])
            except RuntimeError as error:
                if "[target/one-root]" not in str(error):
                    raise
                shutil.rmtree(folder / target / name, ignore_errors=True)
                print(f"{target} cannot take {name}: it has free bodies", flush=True)
    for file in sorted((folder / "mujoco").rglob("*.xml")):
        seen = run([program, "inspect", file, "--json"])
        file.with_name(file.name + ".json").write_bytes(seen)
    return len(names)


def install(base, place, packages, alone):
    venv.create(place, with_pip=False)
    command = [base / "bin/python", "-m", "pip", "--python", place / "bin/python",
               "--disable-pip-version-check", "install", "--quiet", "--only-binary=:all:"]
    for more in (packages, ["--no-deps"] + alone if alone else []):
        if more:
            run(command + more)


def run_host(base, folder, host, package):
    """(lines, seconds) of one host's checks."""
    start = time.monotonic()
    packages, alone, scripts = HOSTS[host]
    try:
        install(base, folder / host, packages, alone)
    except RuntimeError as error:
        return [f"FAILED {host}: cannot be installed: {error}"], time.monotonic() - start
    lines = []
    environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1", PYTHONWARNINGS="ignore",
                       PYTHONPATH=str(package))
    for script in scripts:
        result = subprocess.run([folder / host / "bin/python", HERE / script, folder / "files"],
                                capture_output=True, text=True, env=environment, cwd=folder)
        said = [line for line in result.stdout.splitlines() if line.startswith(("ok ", "FAILED "))]
        if not said or (result.returncode != 0 and all(line.startswith("ok ") for line in said)):
            end = " ".join((result.stdout + result.stderr).split())[-500:]
            said.append(f"FAILED {host}: {script} broke off (status {result.returncode}): {end}")
        lines += said
    return lines, time.monotonic() - start


def main():
    chosen = sys.argv[3:] or list(HOSTS)
    if unknown := set(chosen) - set(HOSTS):
        sys.exit(f"interop: {', '.join(unknown)}: the hosts are {', '.join(HOSTS)}")
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    if folder.exists():
        shutil.rmtree(folder)
    package = program.parent.parent / "python"  # where a build tree has it
    base = folder / "pip"
    venv.create(base, with_pip=True)
    start = time.monotonic()
    count = generate(program, folder / "files")
    print(f"{count} specs generated in {time.monotonic() - start:.0f} s", flush=True)
    passed = failed = 0
    with concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        hosts = {pool.submit(run_host, base, folder, host, package): host for host in chosen}
        for done in concurrent.futures.as_completed(hosts):
            lines, seconds = done.result()
            print(*lines, sep="\n")
            print(f"{hosts[done]}: {seconds:.0f} s", flush=True)
            failed += sum(line.startswith("FAILED ") for line in lines)
            passed += sum(line.startswith("ok ") for line in lines)
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed else 0)


main()
