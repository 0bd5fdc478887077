"""The files under test, made by generate.py: FOLDER/TARGET/SPEC/manifest.jsonl."""

import json
import pathlib

from report import expect


class Variant:
    def __init__(self, folder, record):
        self.record = record
        self.file = folder / record["file"]

    def __str__(self):
        return self.record["file"]

    def expect_mass(self, mass, relative=1e-6):
        """That the whole object has the mass of its record, in kg."""
        expect(abs(mass - self.record["mass"]) < relative * mass,
               f"{self}: weighs {mass} kg, not {self.record['mass']}")


def prove(variants):
    """That all are as recorded in the installed MuJoCo."""
    import mjforge  # which not every host has beside it

    findings = mjforge.prove(variants[0].file.parent, jobs=1)
    expect(not findings, "\n".join(finding.text for finding in findings))


def specs(folder, target):
    """(name, variants) of every spec that was generated for the target."""
    for manifest in sorted(pathlib.Path(folder, target).rglob("manifest.jsonl")):
        with open(manifest, encoding="utf-8") as lines:
            variants = [Variant(manifest.parent, json.loads(line)) for line in lines]
        yield str(manifest.parent.relative_to(pathlib.Path(folder, target))), variants
