"""The page's lines for GNU parallel, with a job that is killed and a machine that goes down."""

import os
import signal
import subprocess

import halfway
import page
from batch import ARCHIVES, FOLDER, merge, same
from report import check, expect, scenario


class Lines:
    """The page's block with that option, in a folder."""

    def __init__(self, form, folder, option):
        folder.mkdir(parents=True, exist_ok=True)
        self.form, self.folder = form, folder
        self.command = page.smaller(page.block("sh", option), form.output)

    def start(self):
        with open(self.folder / "parallel.log", "ab") as log:
            return subprocess.Popen(["bash", "-c", self.command], cwd=self.folder, stdout=log,
                                    stderr=log, stdin=subprocess.DEVNULL)

    def stop(self, shard):
        return halfway.stop(self.form, self.folder, shard, page.SHARDS)

    def wait_until_done(self, process):
        status = process.wait(timeout=120)
        expect(status == 0, f"status {status}: {(self.folder / 'parallel.log').read_text()[-500:]}")

    def logged(self):
        """The jobs that have ended: [(exit status, signal)]."""
        lines = (self.folder / "hammers.joblog").read_text().splitlines()[1:]
        return [tuple(line.split("\t")[6:8]) for line in lines]


def compare(name, lines, reference):
    check(f"{name}: the shards are merged", merge, lines.form, lines.folder)
    check(f"{name}: the same bytes as one local run", same, lines.form, lines.folder, reference)


def kill_a_job(folder, reference):
    name = "parallel, folder"
    lines = Lines(FOLDER, folder, "--retries 3 \\")

    def killed():
        process = lines.start()
        halfway.signal_all(lines.stop(3), signal.SIGKILL)
        lines.wait_until_done(process)
        expect(lines.logged().count(("0", "0")) == page.SHARDS, str(lines.logged()))
    check(f"{name}: a job is killed in the middle and tried again", killed)
    compare(name, lines, reference)


def kill_everything(folder, reference):
    name = "parallel, archives"
    lines = Lines(ARCHIVES, folder, "--retries 3 \\")

    def killed():
        process = lines.start()
        lines.stop(5)
        halfway.signal_all(halfway.processes_in(folder), signal.SIGKILL)
        process.wait(timeout=60)
        expect(len(lines.logged()) < page.SHARDS, "all jobs were done")
        return f"{len(lines.logged())} of {page.SHARDS} jobs were done"

    def goes_on():
        again = Lines(ARCHIVES, folder, "--resume-failed")
        again.wait_until_done(again.start())
    check(f"{name}: all of it is killed, as when the machine goes down", killed)
    check(f"{name}: it goes on from its log", goes_on)
    compare(name, lines, reference)


def run_all(folder, references):
    # Its settings, and its notice about citing, are no matter of this user's.
    os.environ["PARALLEL_HOME"] = str(folder / "parallel-home")
    scenario("parallel, folder", kill_a_job, folder / "parallel-folder", references[FOLDER])
    scenario("parallel, archives", kill_everything, folder / "parallel-archives",
             references[ARCHIVES])
