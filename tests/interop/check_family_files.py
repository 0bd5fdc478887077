"""Families that cannot be read, or not in that scene: a message says why, and no number is wrong.

    check_family_files.py FOLDER
"""

import io
import pathlib
import shutil
import struct
import sys
import tempfile
import zipfile

import mjforge
import mujoco
import numpy as np

from report import check, expect, finish, raises
from scenes import PREFIX, on_floor


def check_refusals(folder):
    """Wrong arguments, and objects that are not there."""
    hammer, pot = (mjforge.load_family(pathlib.Path(folder, "family", f"{name}.npz")) for name in ("hammer", "pot"))
    model = on_floor(hammer.base)
    raises(ValueError, "did you mean 'its/'?", hammer.fields, model, "it/")
    raises(ValueError, "attach the base of the family", pot.fields, model, PREFIX)
    raises(ValueError, "rows: 64 is not within 0 .. 63", hammer.fields, model, PREFIX, [64])
    raises(ValueError, "rows: -1 is not within 0 .. 63", hammer.fields, model, PREFIX, [-1])
    raises(TypeError, "not a list of whole numbers", hammer.fields, model, PREFIX, [0.5])
    raises(ValueError, "rows=[] has no world", hammer.fields, model, PREFIX, [])
    raises(TypeError, "row=None is not an integer", hammer.to_model, model, PREFIX, None)
    raises(ValueError, "row=64 is not within 0 .. 63", hammer.to_model, model, PREFIX, 64)
    raises(TypeError, "over=5 is not a text", hammer.fields, model, PREFIX, over={5: 5})
    raises(ValueError, "over: mujoco", hammer.fields, model, PREFIX, over={"a": 5})
    raises(TypeError, "rows=5 cannot be called", hammer.to_mjlab, "hammer", rows=5)
    raises(TypeError, "prefix=3 is not a text", hammer.fields, model, 3)
    raises(TypeError, "is not a mujoco.MjModel", hammer.fields, hammer.base, PREFIX)
    raises(ValueError, "has the shape (2, 11, 3), not (1, 11, 3)", hammer.fields, model, PREFIX, [0],
           over=hammer.fields(model, PREFIX, [0, 1]))
    thing = hammer.base
    thing.geoms[0].type, thing.geoms[0].size = mujoco.mjtGeom.mjGEOM_SPHERE, [0.1, 0, 0]
    raises(ValueError, "it is not the base of this family", hammer.fields, on_floor(thing), PREFIX)


def middles(whole):
    """A position in the data of each member of an archive."""
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        for member in archive.infolist():
            lengths = struct.unpack_from("<HH", whole, member.header_offset + 26)  # of its name, and of extra fields
            yield member.header_offset + 30 + sum(lengths) + member.compress_size // 2


def check_files(folder):
    """Files that were cut short or changed, and files of other kinds."""
    whole = pathlib.Path(folder, "family/hammer.npz").read_bytes()
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place, "hammer.npz")
        for size in (0, 1, 100, len(whole) // 2, len(whole) - 1):
            file.write_bytes(whole[:size])
            raises(ValueError, "hammer.npz'", mjforge.load_family, file)
        for at in middles(whole):
            file.write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:])
            expect_refused(file)
        np.savez(file, index=np.arange(3))
        raises(ValueError, "is not a family", mjforge.load_family, file)
        members = dict(np.load(pathlib.Path(folder, "family/hammer.npz")).items())
        np.savez(file, **{**members, "geom_size": members["geom_size"][:3]})
        raises(ValueError, "'geom_size' has the shape (3, ", mjforge.load_family, file)
        np.savez(file, **{**members, "mass": members["mass"].astype(str)})
        raises(ValueError, "'mass' has no numbers", mjforge.load_family, file)
        np.savez(file, **{**members, "body_mass.names": np.array(["nail"])})
        changed = mjforge.load_family(file)
        raises(ValueError, "body_mass has 'nail', which is not in its base", changed.fields, on_floor(changed.base),
               PREFIX)
        np.savez(file, **{**members, "geom_size.names": members["geom_size.names"][:1]})
        raises(ValueError, "'geom_size.names' has the shape (1,)", mjforge.load_family, file)
        raises(ValueError, "is a folder, and a family is one file; name one of its files: hammer.npz",
               mjforge.load_family, place)
        raises(ValueError, "a file for each structure; name one of them: hammer.npz", mjforge.load_family,
               pathlib.Path(place, "ham%s.npz"))
        raises(FileNotFoundError, "pot.npz' does not exist", mjforge.load_family, pathlib.Path(place, "pot.npz"))


def check_archives(folder):
    """Archives that are whole but for their directory: an encrypted member, and a comment that hides others."""
    whole = pathlib.Path(folder, "family/hammer.npz").read_bytes()
    first, last = whole.index(b"PK\1\2"), whole.rindex(b"PK\1\2")
    before, end = whole.rindex(b"PK\1\2", 0, last), whole.rindex(b"PK\5\6")
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place, "hammer.npz")
        for at, number, words in ((first + 8, 1, "encrypted"), (before + 32, end - last, "members")):
            changed = bytearray(whole)
            changed[at:at + 2] = number.to_bytes(2, "little")
            file.write_bytes(changed)
            raises(ValueError, words, mjforge.load_family, file)


def expect_refused(file):
    """That a file in which one byte is another is refused."""
    try:
        mjforge.load_family(file)
    except ValueError:
        return
    raise AssertionError("a changed byte was not noticed")


def check_seal(folder):
    """A whole file that is not the one of its seal."""
    with tempfile.TemporaryDirectory() as place:
        for each in pathlib.Path(folder, "family").glob("hammer.*"):
            shutil.copy(each, place)
        file = pathlib.Path(place, "hammer.npz")
        mjforge.load_family(file)
        shutil.copy(pathlib.Path(folder, "family/pot.npz"), file)
        raises(ValueError, "is not the file that was written", mjforge.load_family, file)
        variants = mjforge.Spec("robosuite/hammer").variants(seed=7)
        expect(variants.write(pathlib.Path(place, "all_%s.npz"), 8, layout="split").ok, "not written")
        box, *others = sorted(pathlib.Path(place).glob("all_*.npz"))
        mjforge.load_family(box)
        shutil.copy(others[0], box)
        raises(ValueError, "is not the file that was written", mjforge.load_family, box)


for name, action in {"refusals": check_refusals, "files": check_files, "archives": check_archives,
                     "seal": check_seal}.items():
    check(f"mujoco {mujoco.__version__} family, {name}", action, sys.argv[1])
finish()
