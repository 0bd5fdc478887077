"""The batch in its two forms, and what must be true of it at the end and before."""

import fnmatch
import os
import pathlib
import subprocess

import page
from report import expect

# What a run leaves beside the batch: manifests and seals of shards, scripts and logs.
_BESIDE = ["*manifest-*-of-*.json*", "*.log", "*.sbatch", "*.joblog"]


class Form:
    """`output`: the options that write it; `stem` and `packing`: how its manifest's name begins
    and ends."""

    def __init__(self, name, output, out, stem, packing, files):
        self.name, self.output, self.out, self.stem = name, output, out, stem
        self.packing = packing
        self.files = files  # that the whole batch has

    def shard_manifest(self, shard):
        return f"{self.stem}manifest-{shard:05}-of-{page.SHARDS:05}.jsonl{self.packing}"

    def part_of(self, shard):
        """The shard's manifest as long as it is being made: hidden beside it."""
        path = pathlib.Path(self.shard_manifest(shard))
        return path.with_name(f".{path.name}.part")

    def has_begun(self, folder, shard):
        """Whether some of the shard is there: a hundred files, or a piece of its archive."""
        if not (folder / self.part_of(shard)).exists():
            return False
        if self is FOLDER:
            index = shard * page.PER_SHARD + 100
            return (folder / f"hammers/hammer_{index:06}.xml").exists()
        archive = folder / f".hammers_{shard:05}.tar.zst.part"  # one a shard
        return archive.exists() and archive.stat().st_size > 0


FOLDER = Form("folder", "-o hammers/", "hammers/", "hammers/", "", page.COUNT + 2)
ARCHIVES = Form("archives", f"-o hammers_%05d.tar.zst --per-archive {page.PER_SHARD}",
                "hammers_%05d.tar.zst", "hammers.", ".zst", page.SHARDS + 2)


def run(command, folder, expected=0):
    """What it said."""
    result = subprocess.run(command, cwd=folder, shell=isinstance(command, str), text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
    expect(result.returncode == expected,
           f"{command}: status {result.returncode}: {result.stdout.strip()[-500:]}")
    return result.stdout.strip()


def make_reference(form, folder):
    """One local run, in one piece."""
    folder.mkdir(parents=True)
    run(f"mjforge generate hammer -n {page.COUNT} --seed 7 {form.output} --quiet", folder)
    return f"{len(files_of(folder))} files"


def files_of(folder):
    """What belongs to the batch, hidden files included."""
    return sorted(str((pathlib.Path(place) / name).relative_to(folder))
                  for place, _, names in os.walk(folder) for name in names
                  if not any(fnmatch.fnmatch(name, one) for one in _BESIDE))


def same(form, folder, reference):
    """Every file of the merged batch, byte by byte."""
    run(["diff", "-r", *(f"--exclude={one}" for one in _BESIDE), reference, folder], folder)
    count = len(files_of(folder))
    expect(count == form.files, f"{count} files instead of {form.files}")
    return f"{count} files, same bytes"


def whole_files_only(form, folder, reference, shard):
    """While a shard is missing: no final name has other bytes, none stands for the shard."""
    expect(not (folder / form.shard_manifest(shard)).exists(), "the shard has a manifest")
    count = 0
    for name in files_of(folder):
        if not pathlib.Path(name).name.startswith("."):
            expect((folder / name).read_bytes() == (reference / name).read_bytes(), name)
            count += 1
    expect(0 < count < form.files, f"{count} files")
    return f"{count} files, each whole"


def merge(form, folder):
    return run(["mjforge", "merge", form.out], folder)


def merge_refuses(form, folder, shard):
    """It says which shard is missing, and writes no manifest."""
    said = run(["mjforge", "merge", form.out], folder, expected=1)
    expect(f"{shard}/{page.SHARDS}" in said or pathlib.Path(form.shard_manifest(shard)).name in said,
           f"it does not name shard {shard}: {said}")
    expect(not (folder / f"{form.stem}manifest.jsonl{form.packing}").exists(), "there is a manifest")
