"""The Python package loads what it makes in the MuJoCo that Python has, beside its own.

    check_python.py FOLDER
"""

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
        expect(all(f.code == "target/one-root" for f in error.findings), str(error))
        return "has no root of its own"


def finds_a_difference():
    variant = mjforge.Spec("hammer").variants()[0]
    variant.record["mass"] *= 1.001
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


for name in mjforge.catalogue():
    for target in ("mujoco", "robosuite"):
        check(f"{name} for {target} verified in Python", verifies, name, target)
    check(f"{name} with files verified in Python", verifies, name, "mujoco", "files")
check("a difference is found in Python", finds_a_difference)
check("an old MuJoCo is refused in Python", refuses_an_old_one)
check("1,000 models in Python", makes_a_thousand_models)
finish()
