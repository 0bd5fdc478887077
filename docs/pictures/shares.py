#!/usr/bin/env python3
"""Counts how many variants of each bundled spec pass the physical checks and `--profile simready`.

    docs/pictures/shares.py MJFORGE [--physics] [N] [SPEC...]

writes the counts of N (200) variants of each SPEC to shares.csv beside itself, a row as soon as it is known.
Without SPEC these are all bundled specs but scenes that have no row yet, or one of fewer variants: what was
interrupted goes on. `--physics` counts the physical checks alone, which take a tenth of the time, and leaves what
was counted of the profile from the same spec. `./dev shares` builds the program and runs this.
"""

import csv
import datetime
import json
import pathlib
import subprocess
import sys
import tempfile

FILE = pathlib.Path(__file__).resolve().parent / "shares.csv"
# `physics` of `variants` pass the physical checks, and `simready` of `profiled` the profile as well.
FIELDS = ("spec", "variants", "physics", "profiled", "simready", "date", "sha256")
VARIANTS = 200
SOME_FAILED = 1  # exit status of `generate` if variants failed
# A finding of the benchmark; all other errors are those of the physical checks.
BENCHMARK = "physics/simready"


def read(file=FILE):
    """The rows of the table, by spec, with numbers as numbers."""
    if not file.exists():
        return {}
    with file.open(encoding="utf-8", newline="") as lines:
        rows = {row["spec"]: row for row in csv.DictReader(lines)}
    for row in rows.values():
        row |= {field: int(row[field]) for field in ("variants", "physics", "profiled", "simready")}
    return rows


def write(rows, file=FILE):
    """Replaces the table as a whole, so that it can be interrupted."""
    made = file.with_suffix(".part")
    with made.open("w", encoding="utf-8", newline="") as lines:
        table = csv.DictWriter(lines, FIELDS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows[spec] for spec in sorted(rows))
    made.replace(file)


def ask(program, *arguments):
    output = subprocess.run([program, *arguments, "--json"], check=True, stdout=subprocess.PIPE, text=True).stdout
    return json.loads(output)


def hash_of(program, spec):
    return ask(program, "inspect", spec)["spec_sha256"][:12]


def records(program, spec, count, *options):
    """The manifest of a batch; none where no variant passes, because then nothing is written."""
    with tempfile.TemporaryDirectory() as folder:
        batch = pathlib.Path(folder) / "batch"
        made = subprocess.run([program, "generate", spec, "-n", str(count), "-q", "--durability", "none", "-o",
                               f"{batch}/", *options], check=False, capture_output=True, text=True)
        manifest = batch / "manifest.jsonl"
        if not manifest.exists():
            if made.returncode != SOME_FAILED:
                raise RuntimeError(f"{spec}: {made.stderr}")
            return []
        with manifest.open(encoding="utf-8") as lines:
            return [json.loads(line) for line in lines]


def behaves(record):
    """Whether a variant passes the physical checks, those of the benchmark aside."""
    return all(finding["severity"] != "error" or finding["code"] == BENCHMARK for finding in record["findings"])


def count_behaving(program, spec, count):
    """How many of `count` variants pass the physical checks."""
    return sum(map(behaves, records(program, spec, count, "--validate", "physics")))


def count_passed(program, spec, count):
    """How many of `count` variants pass the physical checks, and how many the profile as well."""
    made = records(program, spec, count, "--profile", "simready")
    ready = sum(record["status"] == "ok" for record in made)
    return sum(map(behaves, made)) if made else count_behaving(program, spec, count), ready


def main(arguments, file=FILE):
    if not arguments:
        sys.exit(__doc__)
    program, *rest = arguments
    only_physics = "--physics" in rest
    rest = [word for word in rest if word != "--physics"]
    count = int(rest.pop(0)) if rest and rest[0].isdigit() else VARIANTS
    rows = read(file)
    counted = "variants" if only_physics else "profiled"
    if not rest:
        names = [item["name"] for item in ask(program, "catalogue")]
        rows = {spec: row for spec, row in rows.items() if spec in names}
        rest = [spec for spec in names if not spec.startswith("scenes/")
                and (spec not in rows or rows[spec][counted] < count)]
        for spec in sorted(rows.keys() - rest):
            if rows[spec]["sha256"] != hash_of(program, spec):
                print(f"{spec} has changed since it was counted: `./dev shares {count} {spec}` counts it again")
    for spec in rest:
        sha256, row = hash_of(program, spec), rows.get(spec)
        if row is None or row["sha256"] != sha256:
            row = {"profiled": 0, "simready": 0}
        row |= {"spec": spec, "variants": count, "date": datetime.date.today().isoformat(), "sha256": sha256}
        if only_physics:
            row["physics"] = count_behaving(program, spec, count)
        else:
            row["physics"], row["simready"] = count_passed(program, spec, count)
            row["profiled"] = count
        rows[spec] = row
        write(rows, file)
        print(f"{spec}: of {count} variants {row['physics']} pass the physical checks" +
              ("" if only_physics else f", {row['simready']} --profile simready"), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
