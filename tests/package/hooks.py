"""The hook of .pre-commit-hooks.yaml, by the real pre-commit in a repository of its user."""

import re
import shutil

from report import check, expect
from words import TOP, run

GOOD = """\
mjforge: 1
name: crate
params: {height: 10cm .. 20cm}
parts: [{name: body, type: box, size: [10cm, 10cm, height]}]
"""


class Repository:
    """A user's, whose hooks come from a clone of the project as docs/install.md says."""

    def __init__(self, folder, page):
        self.folder = folder / "user"
        self.variables = {"HOME": str(folder), "PRE_COMMIT_HOME": str(folder / "cache")}
        project = folder / "project"
        project.mkdir(parents=True)
        shutil.copy(TOP / ".pre-commit-hooks.yaml", project)
        self.git("init", "--quiet", folder=project)
        self.commit(folder=project)
        self.git("tag", "v0.1.0", folder=project)
        [config] = re.findall(r"```yaml\n(repos:\n.*?)```", page, re.DOTALL)
        config, count = re.subn(r"https://\S+", str(project), config)
        expect(count == 1, "docs/install.md names not one repository")
        self.write(".pre-commit-config.yaml", config)
        self.git("init", "--quiet")
        self.pre_commit("install")

    def write(self, name, text):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def git(self, *words, folder=None, status=0):
        return run("git", "-c", "user.name=Tester", "-c", "user.email=tester@example.org", *words,
                   folder=folder or self.folder, variables=self.variables, status=status)

    def commit(self, folder=None, status=0):
        self.git("add", "--all", folder=folder)
        return self.git("commit", "--message", "All", folder=folder, status=status)

    def pre_commit(self, *words, status=0):
        return run("pre-commit", *words, folder=self.folder, variables=self.variables,
                   status=status)


def lets_good_specs_pass(repository):
    repository.write("objects/crate.yaml", GOOD)
    repository.write("objects/notes.txt", "Not a spec.\n")
    repository.write("settings.yaml", "not: a spec\n")
    said = repository.commit()
    expect("mjforge check" in said and "Passed" in said, said)


def stops_bad_specs(repository):
    repository.write("objects/crate.yaml", GOOD.replace("height]", "heigth]"))
    said = repository.commit(status=1)
    expect("objects/crate.yaml:4:" in said and "did you mean 'height'?" in said, said)
    expect("crate.yaml" in repository.git("status", "--short"), "it was committed")


def looks_at_specs_alone(repository):
    """Where the user says nothing else: YAML files below specs/."""
    config = (repository.folder / ".pre-commit-config.yaml").read_text()
    expect("        files: " in config, "the page shows no files:")
    repository.write(".pre-commit-config.yaml", re.sub(" +files: .*\n", "", config))
    repository.write("objects/crate.yaml", "not: a spec\n")
    repository.write("robots/specs/crate.yaml", GOOD)
    repository.git("add", "--all")
    said = repository.pre_commit("run", "--all-files", "--verbose", "mjforge-check")
    expect("Passed" in said, said)
    repository.write("robots/specs/crate.yaml", GOOD.replace("box", "bux"))
    repository.git("add", "--all")
    said = repository.pre_commit("run", "--all-files", status=1)
    expect("robots/specs/crate.yaml:4:" in said and "objects/" not in said, said)


def run_all(folder, page):
    repositories = []
    check("pre-commit installs the hook", lambda: repositories.append(Repository(folder, page)))
    check("a good spec is committed", lets_good_specs_pass, *repositories)
    check("a bad one is not", stops_bad_specs, *repositories)
    check("other files are left alone", looks_at_specs_alone, *repositories)
