"""Generates batches of all kinds, and pages about them, for the browser tests."""

import json
import os
import subprocess

SPEC = """mjforge: 1
name: mallet
description: A mallet whose head may get too close to its handle's end.
params:
  shape:   {choice: [box, cylinder, capsule], weights: [3, 2, 1], doc: Of the head.}
  length:  {uniform: [10cm, 25cm], unit: m, doc: Of the handle.}
  density: {log_uniform: [20, 5000], unit: kg/m3}
  half:    {normal: [3cm, 4mm], clip: [2cm, 4cm], unit: m}
  spikes:  {integer: [0, 4]}
  painted: {bernoulli: 0.3}
  color:   [0.2 .. 0.9, 0.3, 0.1 .. 0.5]
require: [length > 4 * half]
parts:
  - {name: handle, type: capsule, size: [1cm, length / 2], density: 500}
  - {name: head, type: box, size: [half, half, 2 * half], pos: [0, 0, length / 2],
     density: density, rgba: ["color.x", "color.y", "color.z", 1]}
"""

# Text that pages must show as text, and must never interpret as HTML.
HOSTILE = "</script><img src=x onerror=alert(1)>\"'&<svg onload=alert(2)>"


class Pages:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def run(self, *arguments, status=0, environment=None):
        done = subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True, text=True,
                              env={**os.environ, "NO_COLOR": "1", **(environment or {})}, check=False)
        if done.returncode != status:
            raise AssertionError(f"{' '.join(map(str, arguments))}: status {done.returncode}: "
                                 f"{done.stderr}")
        return done

    def names(self):
        return ("one", "many", "failing", "archive", "empty", "gone", "interrupted", "tried")

    def page(self, name):
        return self.folder / f"{name}.html"

    def _report(self, what, name, *options, status=0):
        self.run("report", what, "-o", f"{name}.html", *options, status=status)

    def make(self):
        (self.folder / "mallet.yaml").write_text(SPEC, encoding="utf-8")
        self.run("generate", "mallet.yaml", "-n", "1", "-o", "one/", "-q")
        self._report("one", "one")
        self.run("generate", "mallet.yaml", "-n", "300", "-o", "many/", "-q")
        self._report("many", "many", "--thumbnails", "40")
        self.run("generate", "mallet.yaml", "-n", "30", "-o", "x.tar.zst", "-q")
        self._report("x.tar.zst", "archive")
        (self.folder / "empty").mkdir()
        (self.folder / "empty/manifest.jsonl").write_text("")
        self._report("empty", "empty")
        self._make_failing()
        self._make_gone()
        # Some of these do not slide, and some are not held.
        self.run("generate", "mallet.yaml", "-n", "12", "-o", "tried/", "-q", "--profile", "simready",
                 "--set", "checks.grasps={force: 5N}", "--on-invalid", "skip")
        self._report("tried", "tried")
        lines = (self.folder / "many/manifest.jsonl").read_text().splitlines(keepends=True)
        (self.folder / ".manifest.jsonl.part").write_text("".join(lines[:20]) + lines[20][:80])
        self._report(".manifest.jsonl.part", "interrupted")
        self._make_hostile(lines)

    def _make_failing(self):
        spec = SPEC.replace("size: [half, half, 2 * half]",
                            "size: ['spikes > 2 ? 0 : half', half, 2 * half]")
        (self.folder / "failing.yaml").write_text(spec.replace("mallet", "failing"))
        self.run("generate", "failing.yaml", "-n", "100", "-o", "failing/", "-q", status=1)
        self._report("failing", "failing")

    def _make_gone(self):
        self.run("generate", "mallet.yaml", "-n", "5", "-o", "gone/", "-q", "--set", "length=0.2")
        for file in (self.folder / "gone").glob("*.xml"):
            file.unlink()
        self._report("gone", "gone", "--spec", "failing.yaml")

    def _make_hostile(self, lines):
        """A manifest as nobody writes it: markup in each text there is."""
        records = []
        for number, line in enumerate(lines[:6]):
            record = json.loads(line)
            record.update(spec=HOSTILE, name=HOSTILE, status="failed", file=HOSTILE,
                          target=HOSTILE, set={HOSTILE: HOSTILE})
            record["params"] = {HOSTILE: f"{HOSTILE}{number % 2}", "number": number, "b\u202ea": "\x1b[31m"}
            record["findings"] = [{"severity": HOSTILE, "code": HOSTILE, "message": HOSTILE,
                                   "file": HOSTILE, "line": 1, "column": 1, "hint": HOSTILE}]
            records.append(json.dumps(record))
        (self.folder / "hostile.jsonl").write_text("\n".join(records) + "\n")
        self._report("hostile.jsonl", "hostile")
