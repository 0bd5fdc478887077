"""Tasks that a user does on the page of `mjforge customize` without reading a manual."""

import shlex
import subprocess

from report import check, expect
from served import Served, Shown, control, until

TALL = """mjforge: 1
name: tall
params:
  height: {value: 10cm .. 60cm, unit: m}
parts:
  - {name: foot, type: cylinder, size: [4cm, 5mm], pos: [0, 0, 5mm], density: 2000}
  - {name: stem, type: cylinder, size: [5mm, height / 2], pos: [0, 0, height / 2], density: 2000}
  - {name: shade, type: cylinder, size: [6cm, 3cm], pos: [0, 0, height], density: 300}
checks: {stable: true}
"""


def _tallest(page):
    """A user finds the tallest lamp that does not tip over."""
    slider = control("height", "input[type=range]")
    page.enter("#simulate", True)
    low, high = 0.1, 0.6
    for _ in range(6):
        middle = (low + high) / 2
        page.enter(slider, str(middle))
        page.wait()
        low, high = (low, middle) if "topples" in page.text("#findings") else (middle, high)
    expect(0.3 <= low and high <= 0.5, f"{low} to {high}")
    return f"{low:.2f} m"


def _ten_mugs(page, program, served):
    """A user makes ten mugs in a colour that the spec does not have."""
    page.enter(control("glaze", "input[type=color]"), "#00aaff")
    page.wait()
    page.enter("#count", "10")
    page.click("[data-export=command]")
    until(lambda: page.value("#copied").startswith("mjforge generate mug"), lambda: page.value("#copied"))
    words = shlex.split(page.value("#copied"))
    subprocess.run([program, *words[1:], "-q"], cwd=served.folder, check=True)
    mugs = sorted((served.folder / "mug").glob("*.xml"))
    expect(len(mugs) == 10, f"{len(mugs)} mugs")
    for mug in mugs:
        expect("0 0.66667 1 1" in mug.read_text(encoding="utf-8"), f"{mug.name} has another colour")


def _culprit(page):
    """A user finds the parameter that makes drawers collide."""
    page.enter("#simulate", True)
    guilty = []
    for name, value in (("width", "0.4"), ("plinth", "0.05"), ("gap", "-0.002"), ("drawer_board", "0.01")):
        page.enter(control(name, "input[inputmode=decimal]"), value)
        page.wait()
        if "'cabinet' and 'cabinet_drawer_0' touch" in page.text("#findings"):
            guilty.append(name)
        page.click("#undo")
        page.wait()
    expect(guilty == ["gap"], guilty)


def run_all(browser, program, folder):
    page = Shown(browser)
    (folder / "tasks").mkdir()
    (folder / "tasks/tall.yaml").write_text(TALL, encoding="utf-8")
    for spec, name, action in (("tall.yaml", "the tallest lamp that does not tip over", lambda served: _tallest(page)),
                               ("mug", "ten mugs in a colour", lambda served: _ten_mugs(page, program, served)),
                               ("drawer_cabinet", "what makes drawers collide", lambda served: _culprit(page))):
        with Served(program, folder / "tasks", spec) as served:
            page.open(served)
            check(name, action, served)
