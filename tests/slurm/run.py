#!/usr/bin/python3
"""What docs/scale-out.md says, done: its job arrays in a Slurm started here, its lines for GNU
parallel, its Kubernetes Job's command; with tasks killed in the middle. The files must be
those of one local run. Says a line about each check, and counts them.

    run.py PROGRAM FOLDER

The folder is made anew.
"""

import os
import pathlib
import shutil
import signal
import sys
import time

import kubernetes_checks
import parallel_checks
import slurm_checks
from batch import ARCHIVES, FOLDER, make_reference
from report import check, failures, finish, scenario


def run_all(folder):
    references = {}
    for form in (FOLDER, ARCHIVES):
        references[form] = folder / f"local-{form.name}"
        check(f"local: one run, {form.name}", make_reference, form, references[form])
    for part in (slurm_checks, parallel_checks, kubernetes_checks):
        start = time.monotonic()
        scenario(part.__name__, part.run_all, folder, references)
        print(f"{part.__name__}: {time.monotonic() - start:.0f} s", flush=True)


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    if folder.exists():
        shutil.rmtree(folder)
    os.environ["PATH"] = f"{program.parent}:{os.environ['PATH']}"
    # What is to be ended ends by leaving its blocks, in which the daemons are ended.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    scenario("beyond one machine", run_all, folder)
    if not failures():
        shutil.rmtree(folder)
    sys.exit(finish())


if __name__ == "__main__":
    main()
