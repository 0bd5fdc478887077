"""Programs that serve `mjforge customize`, and what a page of theirs shows."""

import os
import signal
import subprocess
import time

from report import expect

PATIENCE = 30  # s, until the page shows what it should

SPEC = """mjforge: 1
name: lamp
description: Desk lamp with an arm that tilts.
params:
  stem_height: {value: 20cm .. 40cm, unit: m, doc: Height of the stem.}
  stem_radius: {value: 6mm, unit: m}
  base_shape: {choice: [box, cylinder]}
  base_half: {value: [8cm, 8cm, 1cm .. 2cm], unit: m}
  shade_color: [0.9, 0.3, 0.2, 1]
  feet: {integer: [0, 4]}
  plug: true
  label: lamp
bodies:
  - name: base
    parts:
      - {name: plate, if: base_shape == 'box', type: box, size: base_half, material: iron}
      - {name: plate, if: base_shape == 'cylinder', type: cylinder, size: ["base_half.x", "base_half.z"], material: iron}
      - {name: stem, type: cylinder, size: [stem_radius, stem_height / 2], pos: [0, 0, stem_height / 2], material: iron}
      - {name: "foot_${i}", for: {i: feet}, type: sphere, size: 8mm, pos: [6cm * cos(90deg * i), 6cm * sin(90deg * i), -2cm]}
      - {name: plug, if: plug and label != '', type: box, size: [1cm, 1cm, 1cm], pos: [0, 12cm, 0]}
  - name: head
    parent: base
    pos: [0, 0, stem_height]
    parts: [{name: shade, type: cylinder, size: [6cm, 4cm], rgba: shade_color, density: 200}]
    joints: [{name: tilt, axis: [0, 1, 0], range: [-30deg, 30deg]}]
pose: [{joint: tilt, value: 10deg}]
materials: {iron: {rgba: [0.25, 0.27, 0.3, 1], density: 4000}}
"""


class Served:
    """A program that serves a spec, by default lamp.yaml, in a folder. It ends with the block."""

    def __init__(self, program, folder, spec="lamp.yaml"):
        self.folder = folder
        self.spec = folder / "lamp.yaml"
        folder.mkdir(exist_ok=True)
        self.spec.write_text(SPEC, encoding="utf-8")
        self.process = subprocess.Popen(  # pylint: disable=consider-using-with
            [program, "customize", spec, "--no-open"], cwd=folder, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env={**os.environ, "NO_COLOR": "1"})
        self.address = self.process.stdout.readline().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()

    def stop(self):
        """Returns the exit status."""
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(timeout=PATIENCE)


def until(condition, what):
    """Waits until the condition holds; `what` is a message or makes one."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.05)
    expect(False, what() if callable(what) else what)


class Shown:
    """A page in a browser."""

    def __init__(self, browser):
        self.browser = browser

    def run(self, script, *arguments):
        return self.browser.run(script, *arguments)

    def open(self, served, **options):
        self.browser.visit(served.address, **options)
        self.wait()

    def is_current(self):
        return self.run("""const picture = document.getElementById("picture");
          return picture.complete && picture.naturalWidth > 0 && !document.getElementById("state").textContent &&
            !document.getElementById("view").classList.contains("outdated");""")

    def wait(self):
        """Waits for the full picture of the state that the page has, and for its checks."""
        for pause in (0, 0.3):  # the full picture follows the quick one
            time.sleep(pause)
            until(self.is_current, lambda: f"the picture stays outdated: {self.text('#findings')}")

    def picture(self):
        """A text that differs if the picture does."""
        return self.run("""const picture = document.getElementById("picture");
          const canvas = document.createElement("canvas");
          canvas.width = picture.naturalWidth;
          canvas.height = picture.naturalHeight;
          canvas.getContext("2d").drawImage(picture, 0, 0);
          return canvas.toDataURL();""")

    def enter(self, element, value, event="change"):
        """Gives an element a value, as a user does."""
        self.run("""const element = document.querySelector(arguments[0]);
          if (element.type === "checkbox") element.checked = arguments[1];
          else element.value = arguments[1];
          for (const name of ["input", arguments[2]])
            element.dispatchEvent(new Event(name, {bubbles: true}));""", element, value, event)

    def click(self, element):
        self.run("document.querySelector(arguments[0]).click()", element)

    def value(self, element):
        return self.run("const e = document.querySelector(arguments[0]);"
                        "return e.type === 'checkbox' ? e.checked : e.value", element)

    def text(self, element):
        return self.run("return document.querySelector(arguments[0]).innerText", element)


def control(name, element):
    """The selector of an element of a parameter's control."""
    return f"[data-name='{name}'] {element}"
