"""A Slurm of its own: one controller, one node, one user, on loopback ports and in
one folder. Nothing of a Slurm that the machine may have is read or touched."""

import ctypes
import getpass
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time

# Tasks at once: more than two, so that one is killed while others run, on any machine.
CPUS = 4

CONFIGURATION = """\
ClusterName=mjforge_test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
# What is requeued begins again when its old credential has expired: not in two minutes.
AuthInfo=socket={folder}/munge.socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
# Neither control groups nor systemd nor a database.
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
JobRequeue=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1
# What is stopped is killed two seconds later if it is still there.
KillWait=2
CompleteWait=0
ReturnToService=2
# The node has as many cores as is said below, whatever the machine has.
SlurmdParameters=config_overrides
NodeName=node NodeHostname={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=main Nodes=node Default=YES MaxTime=INFINITE State=UP
"""

# linux/prctl.h
_PR_SET_PDEATHSIG = 1
_PR_SET_CHILD_SUBREAPER = 36
_prctl = ctypes.CDLL(None).prctl


def wait_until(what, condition, seconds=60, pause=0.1):
    """What the condition returned at last; an error if that stays false."""
    end = time.monotonic() + seconds
    while not (result := condition()):
        if time.monotonic() > end:
            raise AssertionError(f"{what}: not within {seconds} s")
        time.sleep(pause)
    return result


def free_ports(count):
    """Loopback ports that nobody listens on, all different."""
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def descendants():
    """The processes that come from this one, whoever is their parent now."""
    parents = {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                # The name may hold anything; after its parenthesis come state and parent.
                fields = (entry / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue  # it has ended
            if fields[0] != "Z":
                parents[int(entry.name)] = int(fields[1])
    found = {os.getpid()}
    while more := {pid for pid, parent in parents.items() if parent in found} - found:
        found |= more
    return found - {os.getpid()}


class Cluster:
    """`with Cluster() as cluster:` starts it; all of it has ended and gone afterwards."""

    def __init__(self):
        # Not in a folder of the caller's: a socket's path is short, and munged wants it
        # where everybody could reach it.
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="mjforge-slurm-"))
        self.folder.chmod(0o711)
        self.environment = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"))
        self._daemons = []

    def __enter__(self):
        try:
            self._start()
        except BaseException:
            self.say_logs()
            self._stop()
            raise
        return self

    def __exit__(self, *_):
        self._stop()

    def run(self, *command, folder=None, must_succeed=True):
        """Standard output of one of Slurm's commands."""
        result = subprocess.run(command, env=self.environment, cwd=folder, text=True,
                                capture_output=True, timeout=60)
        if must_succeed and result.returncode != 0:
            raise AssertionError(f"{' '.join(map(str, command))}: {result.stderr.strip()}")
        return result.stdout.strip()

    def submit(self, script, *options):
        """The number of the job; it runs in the script's folder."""
        return self.run("sbatch", "--parsable", *options, script.name, folder=script.parent)

    def tasks(self, job):
        """What Slurm says of each task of an array: {task: {key: value}}."""
        lines = self.run("scontrol", "show", "job", job, "--oneliner").splitlines()
        said = [dict(word.split("=", 1) for word in line.split() if "=" in word) for line in lines]
        # Tasks that have not begun may share a line, `ArrayTaskId=4-7`.
        return {int(one["ArrayTaskId"]): one for one in said if one["ArrayTaskId"].isdigit()}

    def wait_for(self, job, tasks, states, seconds=120):
        """Waits until each of these tasks is in one of the states."""
        def those():
            said = self.tasks(job)
            return all(task in said and said[task]["JobState"] in states for task in tasks)
        try:
            wait_until(f"tasks {tasks} of job {job} {'/'.join(states)}", those, seconds)
        except AssertionError as error:
            now = self.run("squeue", "--noheader", "--states=all", "--format=%K %T %r").splitlines()
            raise AssertionError(f"{error}: {', '.join(sorted(now))}") from None

    def say_logs(self):
        for log in sorted(self.folder.glob("*.log")):
            print(f"--- {log.name}", *log.read_text(errors="replace").splitlines()[-40:], sep="\n")

    def _start(self):
        # What the daemons leave behind becomes ours, and so can be ended.
        _prctl(_PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        controller_port, node_port = free_ports(2)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], user=getpass.getuser(), folder=self.folder,
            controller_port=controller_port, node_port=node_port, cpus=CPUS))
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self._daemon("munged", "--foreground", "--num-threads=2", f"--key-file={key}",
                     *(f"--{what}={self.folder / name}" for what, name in [
                         ("socket", "munge.socket"), ("pid-file", "munged.pid"),
                         ("seed-file", "munged.seed")]))
        wait_until("munged", self._has_munge)
        self._daemon("slurmctld", "-D")
        self._daemon("slurmd", "-D")
        wait_until("an idle node", self._is_idle)

    def _daemon(self, *command):
        # Debian's are in folders that are not on everybody's path.
        environment = dict(self.environment)
        environment["PATH"] += ":/usr/local/sbin:/usr/sbin:/sbin"
        with open(self.folder / f"{command[0]}.log", "wb") as log:
            self._daemons.append(subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, cwd=self.folder,
                env=environment, start_new_session=True,
                # It does not outlive this process, however that ends.
                preexec_fn=lambda: _prctl(_PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)))

    def _check_daemons(self):
        for daemon in self._daemons:
            if daemon.poll() is not None:
                raise AssertionError(f"{daemon.args[0]} ended with status {daemon.returncode}")

    def _has_munge(self):
        self._check_daemons()
        return (self.folder / "munge.socket").exists()

    def _is_idle(self):
        self._check_daemons()
        try:
            return self.run("sinfo", "--noheader", "--format=%T") == "idle"
        except AssertionError:
            return False  # the controller does not listen yet

    def _stop(self):
        for daemon in reversed(self._daemons):
            daemon.terminate()
            try:
                daemon.wait(timeout=10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self._daemons.clear()
        while left := descendants():
            for pid in left:
                try:
                    os.kill(pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass  # it has ended by itself
            time.sleep(0.05)
        try:
            while True:
                os.waitpid(-1, 0)
        except ChildProcessError:
            pass  # none is left
        shutil.rmtree(self.folder)
