"""Runs the fuzz targets and says what they found: ./dev fuzz. The last line: "N passed, N failed".

  python3 run.py BUILD PROGRAM [--minutes N | --smoke | --replay] [--jobs N] [TARGET...]

Inputs that reach something new are kept in BUILD/corpus, and the next run goes on from there. What
fails is in BUILD/found; `BUILD/tests/fuzz/mjforge_fuzz_TARGET FILE` runs it again. --replay: runs only
what was kept and what fuzzing begins with.
"""

import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import seeds

# MuJoCo reads these files itself and is not ours to mend: the target goes on after a crash, and
# what happened in MuJoCo is counted apart.
WITH_MUJOCO = {"mjcf"}

SMOKE_SECONDS = 6
# A run that takes longer is a bug: no input is longer than this, and sanitizers cost tenfold.
TIMEOUT_SECONDS = 40
SLOW_MS = 300  # to begin with
MEMORY_MB = 2560
MOST_BYTES = {"seal": 2000, "expression": 400, "spec": 4000, "mjcf": 8000}
MOST_FAILURES = 5
ENVIRONMENT = {
    "ASAN_OPTIONS": "detect_leaks=1:strict_string_checks=1:detect_stack_use_after_return=1:"
                    "allocator_may_return_null=0:quarantine_size_mb=64",
    "UBSAN_OPTIONS": "print_stacktrace=1",
}


class Target:
    """One target with its folders, and what its runs did."""

    def __init__(self, name, options, scratch):
        self.name = name
        self.build = options.build
        self.program = options.build / f"tests/fuzz/mjforge_fuzz_{name}"
        self.kept = pathlib.Path(__file__).parent / "corpus" / name
        # .ci/run begins anew each time.
        self.corpus = (scratch if options.smoke else options.build) / "corpus" / name
        self.seeds = scratch / "seeds" / name
        self.words = scratch / f"{name}.dict"
        self.found = options.build / "found"
        self.scratch = scratch / name
        for folder in (self.corpus, self.found, self.scratch):
            folder.mkdir(parents=True, exist_ok=True)
        self.most_bytes = MOST_BYTES.get(name, 16000)
        self.executions = self.memory = self.in_mujoco = 0
        self.failures = []  # files

    def prepare(self, project, mjforge):
        seeds.write(self.name, project, mjforge, self.seeds)

    def write_words(self):
        words = self.build / "tests/fuzz/mjforge_fuzz_words"
        self.words.write_bytes(subprocess.run([words, self.name], check=True,
                                              stdout=subprocess.PIPE).stdout)

    def start(self, *words):
        """One run; returns what it printed."""
        environment = {**os.environ, **ENVIRONMENT, "TMPDIR": str(self.scratch)}
        with tempfile.TemporaryFile() as output:
            subprocess.run([self.program, *words], cwd=self.scratch, env=environment, check=False,
                           stdin=subprocess.DEVNULL, stdout=output, stderr=output)
            output.seek(0)
            return output.read().decode(errors="replace")

    def read(self, files):
        """Runs each of these once; returns how long each took, in ms."""
        times = {}
        while files:
            text = self.start(f"-timeout={TIMEOUT_SECONDS}", f"-rss_limit_mb={MEMORY_MB}", *files)
            done = re.findall(r"^Executed (\S+) in (\d+) ms$", text, re.MULTILINE)
            times.update((pathlib.Path(file), int(time)) for file, time in done)
            self.executions += len(done)
            if len(done) < len(files):
                self.judge(files[len(done)], text)
            files = files[len(done) + 1:]
        return times

    def read_kept(self):
        """Runs what was kept, and what fuzzing begins with, of which it removes what is slow."""
        self.read(sorted(self.kept.iterdir()) if self.kept.exists() else [])
        for file in self.seeds.iterdir():
            if file.stat().st_size > self.most_bytes:  # libFuzzer would cut it off
                file.unlink()
        for file, time_taken in self.read(sorted(self.seeds.iterdir())).items():
            if time_taken > SLOW_MS:
                file.unlink()

    def fuzz(self, seconds, seed):
        self.write_words()
        end = time.monotonic() + seconds
        while len(self.failures) < MOST_FAILURES and (left := int(end - time.monotonic())) > 0:
            before = set(self.found.iterdir())
            # A run is ended and begun again, so that what libraries keep does not add up.
            words = [f"-max_total_time={min(left, 600)}", f"-timeout={TIMEOUT_SECONDS}",
                     f"-rss_limit_mb={MEMORY_MB}", f"-max_len={self.most_bytes}",
                     f"-dict={self.words}", f"-artifact_prefix={self.found}/{self.name}-",
                     "-print_final_stats=1", "-print_funcs=0", f"-seed={seed}"]
            if self.name in WITH_MUJOCO:
                words += ["-fork=1", "-ignore_crashes=1", "-ignore_timeouts=1", "-ignore_ooms=1"]
            kept = [self.kept] if self.kept.exists() else []
            text = self.start(*words, self.corpus, self.seeds, *kept)
            self.count(text)
            mine = [file for file in sorted(set(self.found.iterdir()) - before)
                    if file.name.startswith(f"{self.name}-") and "slow-unit" not in file.name]
            for file in mine:
                self.judge(file, self.start(f"-timeout={TIMEOUT_SECONDS}",
                                            f"-rss_limit_mb={MEMORY_MB}", file)
                           if self.name in WITH_MUJOCO else text)
            if not mine and "stat::number_of_executed_units" not in text and "#" not in text:
                print(text[-3000:], flush=True)
                self.failures.append("the run itself")

    def count(self, text):
        units = re.findall(r"stat::number_of_executed_units:\s*(\d+)", text) or \
            re.findall(r"^#(\d+): cov", text, re.MULTILINE)[-1:]
        self.executions += sum(map(int, units))
        memory = re.findall(r"stat::peak_rss_mb:\s*(\d+)|rss: (\d+)Mb", text)
        self.memory = max([self.memory, *(int(a or b) for a, b in memory)])

    def judge(self, file, text):
        """What failed: shows it, unless it happened in MuJoCo."""
        if self.name in WITH_MUJOCO and is_in_mujoco(text):
            self.in_mujoco += 1
            return
        self.failures.append(file)
        if len(self.failures) <= MOST_FAILURES:
            print(f"{self.name}: {file}\n{excerpt(text)}", flush=True)

    def summary(self):
        kinds = {kind: sum(1 for file in self.failures if f"-{kind}-" in str(file))
                 for kind in ("crash", "leak", "timeout", "oom")}
        words = ", ".join(f"{count} {kind}" for kind, count in kinds.items())
        mujoco = f", {self.in_mujoco} in MuJoCo" if self.name in WITH_MUJOCO else ""
        # libFuzzer does not say it of the processes that it starts.
        memory = f", {self.memory} MB" if self.memory else ""
        return f"{self.name:10} {self.executions:>11,} executions, {words}{mujoco}{memory}"


def is_in_mujoco(text):
    """Whether the innermost frame that is neither the sanitizers' nor the C library's is MuJoCo's,
    or the report has no frame of its own: time and memory that ran out while MuJoCo loaded."""
    for line in re.findall(r"^\s+#\d+ 0x\w+ (.*)$", text, re.MULTILINE):
        if "libmujoco" in line:
            return True
        if "mjforge::" in line and "Engine" not in line and "engine::" not in line:
            return False
    return "MUST:" not in text


def excerpt(text):
    """The first line of a report, and the frames that are ours."""
    begin = re.search(r"^(MUST:|==\d+==.*ERROR|.*runtime error:|terminate)", text, re.MULTILINE)
    lines = text[begin.start() if begin else 0:].splitlines()
    frames = [line for line in lines[1:] if re.match(r"\s+#\d+ .* mjforge::", line)
              or line.startswith(("SUMMARY", "  what()"))]
    return "\n".join(line[:200] for line in [*lines[:1], *frames[:8]])


def main():
    words = argparse.ArgumentParser()
    words.add_argument("build", type=lambda text: pathlib.Path(text).resolve())
    words.add_argument("program", type=lambda text: pathlib.Path(text).resolve())
    words.add_argument("--minutes", type=float, default=1)
    words.add_argument("--smoke", action="store_true")
    words.add_argument("--replay", action="store_true")
    words.add_argument("--jobs", type=int, default=os.cpu_count())
    words.add_argument("targets", nargs="*")
    options = words.parse_intermixed_args()
    unknown = set(options.targets) - set(seeds.SEEDS)
    if unknown:
        sys.exit(f"there is no target '{unknown.pop()}'; targets: {', '.join(seeds.SEEDS)}")
    project = pathlib.Path(__file__).resolve().parents[2]
    # In memory, where files cost little.
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="mjforge-fuzz-", dir=memory_folder()))
    targets = [Target(name, options, scratch) for name in options.targets or seeds.SEEDS]

    def run(target):
        target.prepare(project, options.program)
        target.read_kept()
        # The same start each time in .ci/run; with 0 another one in every long run.
        if not options.replay:
            target.fuzz(SMOKE_SECONDS if options.smoke else options.minutes * 60,
                        1 if options.smoke else 0)
        print(target.summary(), flush=True)

    try:
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            list(pool.map(run, targets))
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    failed = sum(1 for target in targets if target.failures)
    print(f"{sum(target.executions for target in targets):,} executions")
    print(f"{len(targets) - failed} passed, {failed} failed")
    return 1 if failed else 0


def memory_folder():
    folder = pathlib.Path("/dev/shm")
    return folder if os.access(folder, os.W_OK) else None


if __name__ == "__main__":
    sys.exit(main())
