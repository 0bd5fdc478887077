"""What the tests of faults share: the program, the shim, one small batch for each kind of output."""

import argparse
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile

SPEC = """\
mjforge: 1
name: crate
params: {height: -0.02 .. 0.2}
materials: {wood: {texture: {file: wood.png}}}
parts: [{name: body, type: box, size: [0.1, 0.1, height], density: 500, material: wood}]
"""

# The smallest PNG: one white pixel.
PNG = bytes.fromhex(
    "89504e470d0a1a0a0000000d49484452000000010000000108020000009077 53de"
    "0000000c49444154789c63f8cfc00000030101 00c9fe92ef0000000049454e44ae426082")

# Words of `generate`, by kind of output: "{out}" is the folder that the test looks at.
OUTPUTS = {
    "folder": ["-n", "7", "-o", "{out}"],
    "archive": ["-n", "140", "-o", "{out}/x.tar"],
    "series": ["-n", "200", "--per-archive", "70", "-o", "{out}/x_%d.tar.zst"],
    "shard": ["-n", "20", "--shard", "1/3", "-o", "{out}"],
}


class Batch:
    """A folder with the spec, in which one kind of output is made."""

    def __init__(self, program, shim, output):
        self.program = str(pathlib.Path(program).resolve())
        self.shim = str(pathlib.Path(shim).resolve())
        self.words = OUTPUTS[output]
        self._folder = tempfile.TemporaryDirectory(prefix="mjforge-faults-")
        self.folder = pathlib.Path(self._folder.name).resolve()
        (self.folder / "crate.yaml").write_text(SPEC)
        (self.folder / "wood.png").write_bytes(PNG)
        self.out = self.folder / "out"
        self.counter = self.folder / "counter"
        self.record = self.folder / "record"

    def close(self):
        self._folder.cleanup()

    def clear(self):
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir()

    def run(self, *more, fail="", record=False, jobs=1):
        """One run of `generate` without validation."""
        words = [word.replace("{out}", str(self.out)) for word in self.words]
        environment = dict(os.environ)
        if fail or record:
            environment["LD_PRELOAD"] = self.shim
            # What is read is beside the output, too.
            environment["FAULTS_BELOW"] = str(self.folder if fail.startswith("read") else self.out)
        if fail:
            self.counter.write_bytes(bytes(8))
            environment["FAULTS_COUNTER"] = str(self.counter)
            environment["FAULTS_FAIL"] = fail
        if record:
            environment["FAULTS_RECORD"] = str(self.record)
        return subprocess.run(
            [self.program, "generate", "crate.yaml", "--on-invalid", "skip", "-j", str(jobs),
             "--validate", "none", "-q", *words, *more],
            cwd=self.folder, env=environment, capture_output=True, text=True, timeout=60,
            start_new_session=True)

    def calls(self):
        """How many calls of the kind the last run made."""
        return struct.unpack("=Q", self.counter.read_bytes())[0]

    def files(self, hidden=False):
        """All files, by name; hidden ones are what is under construction."""
        return {str(path.relative_to(self.out)): path.read_bytes()
                for path in sorted(self.out.rglob("*"))
                if path.is_file() and (hidden or not path.name.startswith("."))}


def parser(every):
    """Of the words that all of these tests take."""
    words = argparse.ArgumentParser()
    words.add_argument("program")
    words.add_argument("shim")
    words.add_argument("output", choices=OUTPUTS)
    words.add_argument("--every", type=int, default=1, help=every)
    return words


def is_honest(result):
    """Whether a run that did not succeed says so, and is not a bug."""
    return result.returncode in (1, 3) and "error:" in result.stderr \
        and "internal error" not in result.stderr
