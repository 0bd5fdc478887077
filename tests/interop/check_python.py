"""The Python package loads what it makes in the MuJoCo that Python has, beside its own.

    check_python.py FOLDER
"""

import contextlib
import json
import os
import pathlib
import tempfile
import types

import mjforge
import mujoco

from report import check, expect, finish


def verifies(name, target, assets="inline"):
    variants = mjforge.Spec(name).variants(seed=1, target=target, assets=assets, validate="load")
    try:
        for variant in variants[:2]:
            variant.verify(mujoco)
    except mjforge.VariantError as error:
        expect(any(f.code == "target/one-root" for f in error.findings), str(error))
        return "has no root of its own"


def finds_a_difference():
    variant = mjforge.Spec("hammer").variants()[0]
    variant._facts()["mass"] *= 1.001
    try:
        variant.verify(mujoco)
    except mjforge.MismatchError as error:
        expect("mass is" in str(error), str(error))
    else:
        raise AssertionError("a mass that is 0.1 % off was not seen")


def refuses_an_old_one():
    old = types.SimpleNamespace(__name__="mujoco", __version__="2.1.5", MjModel=mujoco.MjModel)
    try:
        mjforge.Spec("hammer").variants()[0].load(old)
    except ImportError as error:
        expect("pip install" in str(error), str(error))
    else:
        raise AssertionError("MuJoCo 2.1.5 was taken")


def makes_a_thousand_models():
    models = [v.load(mujoco) for v in mjforge.Spec("hammer").variants(seed=7)[:1000]]
    expect(len({float(model.body_mass.sum()) for model in models}) > 900, "they are alike")


@contextlib.contextmanager
def written(output, name="laptop", count=3, **options):
    """The path of a batch in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, output)
        report = mjforge.Spec(name).variants(seed=3, **options).write(path, count)
        expect(report.ok, str(report))
        yield path


def proves_folders_and_archives():
    for output, options in (("out/", {"assets": "files"}), ("x.tar", {}), ("x.tar.zst", {"assets": "files"})):
        with written(output, **options) as path:
            findings = mjforge.prove(path)
            expect(not findings, "\n".join(f.text for f in findings))


def finds_another_record():
    """A finding for each number of a record that is not that of the model."""
    wrong = {"mass": lambda r: r.update(mass=r["mass"] * 1.001), "center of mass": lambda r: r["com"].reverse(),
             "inertia": lambda r: r["inertia"].reverse(), "number of joints": lambda r: r.update(njnt=7),
             "bounding box": lambda r: r["aabb"]["min"].reverse()}
    for what, change in wrong.items():
        with written("out/") as path:
            manifest = pathlib.Path(path, "manifest.jsonl")
            lines = manifest.read_text().splitlines()
            record = json.loads(lines[1])
            change(record)
            lines[1] = json.dumps(record)
            manifest.write_text("\n".join(lines) + "\n")
            pathlib.Path(path, "manifest.seal.json").unlink()  # it has the size of the manifest
            findings = mjforge.prove(path)
        expect(len(findings) == 1 and f"the {what} is" in findings[0].message, f"{what}: {findings}")
        expect((findings[0].code, findings[0].index) == ("mujoco/mismatch", 1), findings[0].text)


# A spec of each folder; check_mujoco.py and check_robosuite.py prove the files of all others.
folders = {name.partition("/")[0]: name for name in mjforge.catalogue()}
for name in folders.values():
    for target in ("mujoco", "robosuite"):
        check(f"{name} for {target} verified in Python", verifies, name, target)
    check(f"{name} with files verified in Python", verifies, name, "mujoco", "files")
check("a difference is found in Python", finds_a_difference)
check("folders and archives are proven in Python", proves_folders_and_archives)
check("records of other models are found in Python", finds_another_record)
check("an old MuJoCo is refused in Python", refuses_an_old_one)
check("1,000 models in Python", makes_a_thousand_models)
finish()
