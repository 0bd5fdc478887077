#!/usr/bin/python3
"""The package for Debian as its users meet it: what is in it, installed with apt on this machine,
run from an empty folder, and removed. Then what is installed without it, and pre-commit. Says a
line about each check, and counts them.

    run.py BUILD FOLDER

The folder is made anew. Needs root, by itself or with sudo.
"""

import pathlib
import re
import shutil
import sys

# The words of the checks are those of tests/slurm.
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parent.parent / "slurm"))

import hooks  # noqa: E402
from report import check, expect, finish, scenario  # noqa: E402
from words import TOP, as_root, run  # noqa: E402

PAGE = (TOP / "docs/install.md").read_text()
COMMANDS = ["generate", "check", "inspect", "validate", "preview", "view", "report", "merge",
            "verify", "replay", "catalogue", "schema"]
# It is wanted only in Debian itself.
NOT_HERE = "initial-upload-closes-no-bugs"


def make(build):
    """The package; the second time it has the same bytes."""
    folder = build / "package"
    packages = []
    for _ in range(2):
        shutil.rmtree(folder, ignore_errors=True)
        run("cpack", "--config", build / "CPackConfig.cmake", folder=build)
        [file] = folder.glob("*.deb")
        packages.append(file.read_bytes())
    expect(packages[0] == packages[1], "the second package differs from the first")
    shutil.rmtree(folder / "_CPack_Packages")
    return f"{len(packages[0]) / 1e6:.1f} MB"


def has_what_debian_wants(package):
    run("lintian", "--fail-on=error,warning", "--suppress-tags", NOT_HERE, "--allow-root", package)


def says_what_it_needs(package):
    control = run("dpkg-deb", "--field", package)
    for words in ["\nDepends: .*libmujoco2", "\nDepends: .*libyaml-cpp0", "\nSection: science\n",
                  "\nRecommends: libegl1 | libosmesa6\n", "\nVersion: [0-9.]+-1\n"]:
        expect(re.search(words.replace(" | ", r" \| "), control), f"no {words!r} in\n{control}")
    files = run("dpkg-deb", "--contents", package)
    for path in ["usr/include", "usr/lib", ".a\n", str(TOP)]:
        expect(path not in files, f"the package has {path}")


def is_not_here_yet():
    """Else what the tester uses would be removed in the end."""
    run("dpkg-query", "--show", "mjforge", status=1)


def traces():
    """What others have installed may be among them."""
    return set(run("find", "/usr", "/etc", "/var/lib/dpkg/info", "-name", "*mjforge*").split("\n"))


def install(package):
    expect(f"sudo apt install ./{package.relative_to(TOP)}\n" in PAGE,
           f"docs/install.md does not say how to install {package.relative_to(TOP)}")
    # Images for containers leave man pages out.
    as_root("apt-get", "install", "--yes", "--no-install-recommends",
            "--option=DPkg::Options::=--path-include=/usr/share/*", package)


def works(empty):
    expect(run("mjforge", "--version", folder=empty).startswith("mjforge "), "no version")
    expect("tools/hammer " in run("mjforge", "catalogue", folder=empty), "no hammer")
    said = run("mjforge", "generate", "hammer", "-n", "100", "--seed", "7", "-o", "out/",
               folder=empty)
    expect("100 variants of hammer in out/: 100 ok" in said, said)
    expect(len(list((empty / "out").glob("hammer_*.xml"))) == 100, "not 100 files")
    expect("20 of 20 variants ok" in run("mjforge", "check", "mug", folder=empty), "no mug")
    said = run("mjforge", "replay", "out/manifest.jsonl:42", folder=empty)
    expect("same bytes" in said, said)
    expect(": ok, 1 body" in run("mjforge", "validate", "out/hammer_000000.xml", folder=empty),
           "not valid")
    said = run("mjforge", "catalogue", "knurled", "--html", "gallery", folder=empty)
    expect("1 spec in gallery/index.html" in said, said)
    expect((empty / "gallery/specs/tools/adjustable_wrench.html").exists(), "no page in the gallery")


def has_man_pages(empty):
    for page in ["mjforge", *[f"mjforge-{command}" for command in COMMANDS]]:
        file = run("man", "--where", page, folder=empty).strip()
        expect(file == f"/usr/share/man/man1/{page}.1.gz", f"{page} is {file}")
        text = run("man", "--warnings", page, folder=empty)
        expect(f"{page} - " in text, f"no name in\n{text}")
        expect("warning" not in text, text)
    text, words = run("man", "mjforge-generate"), run("mjforge", "generate", "--help")
    options = re.findall(r"^  (-.*?)  +(\S.*)", words, re.MULTILINE)
    expect(len(options) >= 30, words)
    for names, meaning in [*options, (re.search("  mjforge generate .*", words)[0], "")]:
        expect(re.sub("(^-.),", r"\1, ", names) in text and meaning in text, f"no {names} in\n{text}")
    for page in ["man mjforge\n", "man mjforge-generate\n"]:
        expect(page in PAGE, f"no {page!r} in docs/install.md")


def shells_complete(empty, home=None):
    """As they start: nothing says where the scripts are, except to zsh where the page says so."""
    variables = {"HOME": str(home or empty), "XDG_DATA_HOME": ""}
    if home:
        variables = {"HOME": str(home), "PATH": f"{home}/.local/bin:/usr/bin:/bin"}
    said = run("bash", "-c", "source /usr/share/bash-completion/bash_completion;"
               " _completion_loader mjforge; COMP_LINE='mjforge gen' COMP_POINT=11 COMP_CWORD=1"
               " COMP_WORDS=(mjforge gen) COMP_TYPE=9; _mjforge mjforge; echo $COMPREPLY",
               folder=empty, variables=variables)
    expect(said == "generate\n", f"bash: {said}")
    start = ""
    if home:
        [start] = re.findall(r"^fpath=.*\n", PAGE, re.MULTILINE)
    said = run("zsh", "-f", "-c", f"{start} autoload -Uz compinit; compinit -D -u;"
               " print $_comps[mjforge]; autoload +X _mjforge && print found",
               folder=empty, variables=variables)
    expect(said == "_mjforge\nfound\n", f"zsh: {said}")
    said = run("fish", "-c", "complete --do-complete 'mjforge gen'", folder=empty,
               variables=variables)
    expect(said == "generate\tMake variants of objects\n", f"fish: {said}")


def remove(before):
    files = run("dpkg", "--listfiles", "mjforge").split()
    ours = [pathlib.Path(file) for file in files if "mjforge" in file]
    expect(len(ours) > 100, f"only {len(ours)} files")
    as_root("apt-get", "purge", "--yes", "mjforge")
    left = [str(file) for file in ours if file.exists()]
    expect(not left, f"left: {left}")
    expect(traces() == before, f"left: {traces() - before}")


def the_component(build, home):
    """What docs/install.md says of `cmake --install`."""
    expect("--component program" in PAGE, "docs/install.md does not name the component")
    run("cmake", "--install", build, "--prefix", home / ".local", "--component", "program")
    expect((home / ".local/bin/mjforge").exists(), "no program")
    expect(not (home / ".local/include").exists(), "there are headers")
    shells_complete(home, home)


def debian(build, folder):
    check("the same commit makes the same package", make, build)
    [package] = (build / "package").glob("*.deb")
    check("lintian finds nothing", has_what_debian_wants, package)
    check("it says what it needs", says_what_it_needs, package)
    check("it is not installed yet", is_not_here_yet)
    before = traces()
    check("apt installs it", install, package)
    try:
        empty = folder / "empty"
        empty.mkdir()
        scenario("from an empty folder", check, "generate, check and others", works, empty)
        scenario("man", check, "man pages", has_man_pages, empty)
        scenario("shells", check, "bash, zsh and fish complete", shells_complete, empty)
        scenario("pre-commit", hooks.run_all, folder / "hooks", PAGE)
    finally:
        check("apt removes all of it", remove, before)


def main():
    build, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    scenario("package", debian, build, folder)
    home = folder / "home"
    home.mkdir()
    scenario("without a package", check, "the component `program` in a home", the_component, build,
             home)
    sys.exit(finish())


if __name__ == "__main__":
    main()
