"""The page's job arrays in a real Slurm, with tasks that are killed, stopped and requeued."""

import concurrent.futures
import signal

import halfway
import page
from batch import ARCHIVES, FOLDER, merge, merge_refuses, same, whole_files_only
from cluster import Cluster
from report import check, expect, failures, scenario

ALL = list(range(page.SHARDS))
ENDED = ["COMPLETED", "FAILED", "CANCELLED", "NODE_FAIL", "TIMEOUT"]


class Array:
    """One of the page's scripts, submitted in a folder of its own."""

    def __init__(self, cluster, form, folder, script_with):
        folder.mkdir(parents=True)
        self.cluster, self.form, self.folder = cluster, form, folder
        self.script = folder / "hammers.sbatch"
        self.script.write_text(page.smaller(page.block("bash", script_with), form.output))
        self.job = cluster.submit(self.script)

    def task(self, shard):
        return self.cluster.tasks(self.job)[shard]

    def stop(self, shard):
        return halfway.stop(self.form, self.folder, shard, page.SHARDS)

    def signal(self, shard, name):
        """By scancel, to the script alone: as Slurm does before the time limit. Its status is
        that of a second try, when the task may be gone."""
        self.cluster.run("scancel", "--batch", f"--signal={name}", f"{self.job}_{shard}",
                         must_succeed=False)

    def wait_until_failed(self, shard, exit_code):
        self.wait_for([shard], ["FAILED"])
        code = self.task(shard)["ExitCode"]
        expect(code == exit_code, f"its exit code is {code} instead of {exit_code}")
        return f"FAILED, exit code {code}"

    def wait_for(self, shards, states):
        self.cluster.wait_for(self.job, shards, states)

    def requeue(self, shard):
        self.cluster.run("scontrol", "requeue", f"{self.job}_{shard}")

    def wait_until_done(self):
        self.wait_for(ALL, ["COMPLETED"])

    def requeue_until_done(self, *shards):
        for shard in shards:
            self.requeue(shard)
        self.wait_until_done()

    def was_requeued(self, *shards):
        """These and no others, so what the page says of requeueing is what Slurm does."""
        again = [shard for shard, said in sorted(self.cluster.tasks(self.job).items())
                 if said["Restarts"] != "0"]
        expect(again == list(shards), f"requeued were {again}")


def kill_in_the_middle(array, reference):
    """SIGKILL to one task and its workers while the others run."""
    check("slurm, folder: a task is killed in the middle",
          lambda: halfway.signal_all(array.stop(3), signal.SIGKILL))
    check("slurm, folder: Slurm says that it failed", array.wait_until_failed, 3, "0:9")
    array.wait_for(ALL, ENDED)
    check("slurm, folder: what it left are whole files",
          whole_files_only, array.form, array.folder, reference, 3)
    check("slurm, folder: merge names the missing shard", merge_refuses, array.form, array.folder, 3)
    check("slurm, folder: it is requeued and done", array.requeue_until_done, 3)
    check("slurm, folder: no other one was requeued", array.was_requeued, 3)
    check("slurm, folder: the shards are merged", merge, array.form, array.folder)
    check("slurm, folder: the same bytes as one local run",
          same, array.form, array.folder, reference)


def submit_again(array, reference):
    """What to do when Slurm has forgotten the job: every shard sees that it is done."""
    def again():
        array.job = array.cluster.submit(array.script)
        return array.wait_until_done()
    check("slurm, folder: the array is submitted again", again)
    check("slurm, folder: nothing has changed", same, array.form, array.folder, reference)


def stop_in_other_ways(array, reference):
    """Three tasks: SIGKILL by scancel, SIGTERM as before a time limit, requeued while it runs."""
    # Watched from now on: a task may begin and end while another one is waited for.
    watchers = concurrent.futures.ThreadPoolExecutor()
    stopped = {index: watchers.submit(array.stop, index) for index in (2, 4, 6)}

    def by_kill():
        stopped[2].result()
        array.signal(2, "KILL")
        return array.wait_until_failed(2, "0:9")

    def by_term():
        pids = stopped[4].result()
        array.signal(4, "TERM")
        halfway.signal_all(pids, signal.SIGCONT)
        return array.wait_until_failed(4, "130:0")

    def by_requeue():
        pids = stopped[6].result()
        array.requeue(6)
        halfway.signal_all(pids, signal.SIGCONT)
        array.wait_for([6], ["COMPLETED"])
        array.was_requeued(6)

    check("slurm, archives: a task is killed by scancel", by_kill)
    check("slurm, archives: a task is told to end, as before its time limit", by_term)
    check("slurm, archives: a task is requeued while it runs", by_requeue)
    array.wait_for(ALL, ENDED)
    check("slurm, archives: what they left are whole files",
          whole_files_only, array.form, array.folder, reference, 2)
    check("slurm, archives: merge names the missing shards",
          merge_refuses, array.form, array.folder, 2)
    check("slurm, archives: they are requeued and done", array.requeue_until_done, 2, 4)
    check("slurm, archives: no other one was requeued", array.was_requeued, 2, 4, 6)
    check("slurm, archives: the shards are merged", merge, array.form, array.folder)
    check("slurm, archives: the same bytes as one local run",
          same, array.form, array.folder, reference)


def requeue_itself(array, reference):
    """Slurm's signal before the time limit, at once instead of after hours."""
    def by_itself():
        pids = array.stop(1)
        array.signal(1, "USR1")
        halfway.signal_all(pids, signal.SIGCONT)
        array.wait_until_done()
        array.was_requeued(1)
    check("slurm, time limit: a task requeues itself", by_itself)
    check("slurm, time limit: the shards are merged", merge, array.form, array.folder)
    check("slurm, time limit: the same bytes as one local run",
          same, array.form, array.folder, reference)


def in_folder(cluster, folder, reference):
    array = Array(cluster, FOLDER, folder, "--signal=B:TERM@60")
    kill_in_the_middle(array, reference)
    submit_again(array, reference)


def in_archives(cluster, folder, reference):
    stop_in_other_ways(Array(cluster, ARCHIVES, folder, "--signal=B:TERM@60"), reference)


def at_the_time_limit(cluster, folder, reference):
    requeue_itself(Array(cluster, ARCHIVES, folder, "--signal=B:USR1@60"), reference)


def run_all(folder, references):
    with Cluster() as cluster:
        try:
            scenario("slurm, folder", in_folder, cluster, folder / "slurm-folder",
                     references[FOLDER])
            scenario("slurm, archives", in_archives, cluster, folder / "slurm-archives",
                     references[ARCHIVES])
            scenario("slurm, time limit", at_the_time_limit, cluster, folder / "slurm-limit",
                     references[ARCHIVES])
        finally:
            if failures():
                cluster.say_logs()
