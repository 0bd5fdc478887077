"""The page's indexed Job: its YAML is read and its container's command run here, once for
each index, as the cluster would. There is no cluster."""

import os
import signal
import subprocess

import yaml

import halfway
import page
from batch import ARCHIVES, FOLDER, merge, same
from report import check, expect, scenario


def read_job(form):
    """The container's command, for a smaller batch."""
    job = yaml.safe_load(page.smaller(page.block("yaml", "kind: Job"), form.output))
    spec, pod = job["spec"], job["spec"]["template"]["spec"]
    expect((job["apiVersion"], spec["completionMode"]) == ("batch/v1", "Indexed"), "not indexed")
    expect(spec["completions"] == page.SHARDS, f"completions: {spec['completions']}")
    # What backoffLimitPerIndex and podFailurePolicy ask for.
    expect(pod["restartPolicy"] == "Never", f"restartPolicy: {pod['restartPolicy']}")
    container, = pod["containers"]
    volumes = {volume["name"] for volume in pod["volumes"]}
    mounts = {mount["name"]: mount["mountPath"] for mount in container["volumeMounts"]}
    expect(set(mounts) == volumes, f"volumes {volumes}, mounts {mounts}")
    expect(container["workingDir"] in mounts.values(), "the working folder is not on a volume")
    return container["command"]


def start(command, folder, index):
    environment = dict(os.environ, JOB_COMPLETION_INDEX=str(index))
    with open(folder / "pod.log", "ab") as log:
        return subprocess.Popen(command, cwd=folder, env=environment, stdout=log, stderr=log)


def run_pod(command, folder, index, expected=0):
    status = start(command, folder, index).wait(timeout=120)
    expect(status == expected,
           f"index {index}: status {status}: {(folder / 'pod.log').read_text()[-500:]}")


def kill_a_pod(form, command, folder, index, number, expected):
    process = start(command, folder, index)
    pids = halfway.stop(form, folder, index, page.SHARDS)
    expect(process.pid in pids, "the container's first process is not mjforge")
    halfway.signal_all([process.pid] if number == signal.SIGTERM else pids, number)
    halfway.signal_all(pids, signal.SIGCONT)
    status = process.wait(timeout=60)
    expect(status == expected, f"status {status}")
    return f"status {status}"


def run_job(form, folder, reference):
    name = f"kubernetes, {form.name}"
    folder.mkdir(parents=True)
    command = []
    check(f"{name}: the Job is read", lambda: command.extend(read_job(form)))
    check(f"{name}: a pod is killed in the middle",
          kill_a_pod, form, command, folder, 2, signal.SIGKILL, -signal.SIGKILL)
    check(f"{name}: a pod is evicted", kill_a_pod, form, command, folder, 5, signal.SIGTERM, 130)
    for index in range(page.SHARDS):
        check(f"{name}: index {index}", run_pod, command, folder, index)
    check(f"{name}: the shards are merged", merge, form, folder)
    check(f"{name}: the same bytes as one local run", same, form, folder, reference)


def run_all(folder, references):
    for form in (FOLDER, ARCHIVES):
        scenario(f"kubernetes, {form.name}", run_job, form, folder / f"kubernetes-{form.name}",
                 references[form])
