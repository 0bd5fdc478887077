#!/usr/bin/python3
"""The pages of `mjforge report`, `mjforge catalogue --html` and `mjforge customize`, in a real Chromium without a window: what is
there, in light and dark, on a phone, with the keyboard and without a script. Says a line about each
check, and counts them.

    run.py PROGRAM FOLDER

The folder is made anew; pictures of the pages stay in it.
"""

import pathlib
import shutil
import sys

# The words of the checks are those of tests/slurm.
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parent.parent / "slurm"))

import customize_checks  # noqa: E402
import customize_fields  # noqa: E402
import customize_tasks  # noqa: E402
import gallery_checks  # noqa: E402
import page_checks  # noqa: E402
from browser import Browser  # noqa: E402
from pages import Pages  # noqa: E402
from report import check, finish, scenario  # noqa: E402


def run_all(program, folder):
    pages = Pages(program, folder)
    check("batches and their pages", pages.make)
    with Browser(folder / "profile") as browser:
        for name in pages.names():
            scenario(name, page_checks.run_all, browser, pages, name)
        scenario("sorting and filtering", page_checks.run_controls, browser, pages)
        scenario("hostile texts", page_checks.run_hostile, browser, pages)
        scenario("gallery", gallery_checks.run_all, browser, pages)
        scenario("customize", customize_checks.run_all, browser, program, folder)
        scenario("fields of customize", customize_fields.run_all, browser, program, folder)
        scenario("tasks with customize", customize_tasks.run_all, browser, program, folder)
    with Browser(folder / "profile-without-script", script=False) as browser:
        scenario("without a script", page_checks.run_without_script, browser, pages)
        scenario("gallery without a script", gallery_checks.run_without_script, browser, pages)


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    if folder.exists():
        shutil.rmtree(folder)
    folder.mkdir(parents=True)
    scenario("pages in a browser", run_all, program, folder)
    sys.exit(finish())


if __name__ == "__main__":
    main()
