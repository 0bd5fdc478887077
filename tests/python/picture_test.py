"""Pictures are those of the command, and a wrong argument is named."""

import pathlib
import pickle
import subprocess
import tempfile
import unittest

import mjforge
from mjforge._library import PROGRAM


CUPBOARD = """
mjforge: 1
name: cupboard
params: {doors: {integer: [1, 2]}}
parts: [{name: back, type: box, size: [20cm, 1cm, 20cm]}]
bodies:
  - name: "door_${i}"
    for: {i: doors}
    pos: [20cm * i - 10cm, -2cm, 0]
    joints: [{name: "swing_${i}", axis: [0, 0, 1], range: [0, 1.5]}]
    parts: [{name: "leaf_${i}", type: box, size: [9cm, 5mm, 20cm]}]
"""
VIEW = "view: {azimuth: 30deg, elevation: -60deg, pose: {swing_0: 1, swing_1: 0.5, back: 1}}\n"


def size_of(picture):
    return tuple(int.from_bytes(picture[at:at + 4], "big") for at in (16, 20))


class Pictures(unittest.TestCase):
    def test_are_those_of_the_command(self):
        variant = mjforge.Spec("laptop").variants(seed=3)[1]
        picture = variant.png((120, 80), layer="joints", pose={"hinge": 0.25})
        self.assertEqual(size_of(picture), (120, 80))
        with variant.as_file() as path, tempfile.TemporaryDirectory() as folder:
            picture.save(pathlib.Path(folder, "a.png"))
            command = [PROGRAM, "preview", path, "--size", "120x80", "--layer", "joints",
                       "--joint", "hinge=0.25", "-o", "-"]
            drawn = subprocess.run(command, capture_output=True, check=True).stdout
            self.assertEqual(drawn, pathlib.Path(folder, "a.png").read_bytes())
        self.assertIs(type(picture), mjforge.Picture)
        self.assertEqual((repr(picture), str(picture)), ("<mjforge.Picture 120 x 80>",) * 2)
        self.assertNotEqual(variant.png((120, 80), "joints"), picture)
        self.assertEqual(picture._repr_png_(), bytes(picture))
        self.assertEqual(size_of(variant._repr_png_()), (320, 320))

    def test_begin_with_the_view_of_the_spec(self):
        variants = mjforge.Spec(CUPBOARD + VIEW).variants()
        one, two = (next(variant for variant in variants[:20] if variant.params["doors"] == doors) for doors in (1, 2))
        self.assertEqual({angle: round(degrees) for angle, degrees in two.view.items() if angle != "pose"},
                         {"azimuth": 30, "elevation": -60})
        self.assertEqual(two.view["pose"], {"swing_0": 1, "swing_1": 0.5, "back": 1})

        def drawn(variant, *options):
            with variant.as_file() as path:
                command = [PROGRAM, "preview", path, "--size", "64", "--azimuth", "30", "--elevation", "-60", *options,
                           "-o", "-"]
                return subprocess.run(command, capture_output=True, check=True).stdout
        self.assertEqual(one.png(64), drawn(one, "--joint", "swing_0=1"))
        self.assertEqual(two.png(64), drawn(two, "--joint", "swing_0=1", "--joint", "swing_1=0.5"))
        self.assertEqual(two.png(64, pose={"cupboard_swing_0": 0}),
                         drawn(two, "--joint", "swing_0=0", "--joint", "swing_1=0.5"))
        self.assertEqual(pickle.loads(pickle.dumps(two)).png(64), two.png(64))
        plain = mjforge.Spec(CUPBOARD).variants()
        self.assertEqual(plain[0].view, {"pose": {}})
        self.assertNotEqual(variants[:8].sheet(64), plain[:8].sheet(64))
        self.assertNotEqual(bytes(variants[0]._repr_png_()), plain[0]._repr_png_())

    def test_sheets_show_a_slice_with_its_options(self):
        variants = mjforge.Spec("hammer").variants(seed=7, target="mjx", sampler="latin", batch=9)
        sheet = variants[1:9:2].sheet(64)
        self.assertGreater(size_of(sheet), (128, 128))
        self.assertNotEqual(sheet, variants[:4].sheet(64))
        self.assertRaisesRegex(TypeError, "take a slice", variants.sheet)
        self.assertRaisesRegex(ValueError, "1 to 400 variants, not 0", variants[:0].sheet)

    def test_wrong_arguments_are_named(self):
        variant = mjforge.Spec("laptop").variants()[0]
        for error, name, wrong in (
                (ValueError, "size", 5), (TypeError, "size", "64"), (TypeError, "size", True),
                (ValueError, "size", (64, 64, 64)), (ValueError, "size", (64, 5000)),
                (ValueError, "layer", "colision"), (TypeError, "layer", None),
                (TypeError, "pose", 5), (TypeError, "pose", {5: 1}), (TypeError, "pose", {"hinge": "1"}),
                (TypeError, "pose", {"hinge": True}), (ValueError, "pose", {"hinge": float("nan")})):
            with self.assertRaisesRegex(error, f"{name}=", msg=f"{name}={wrong!r}"):
                variant.png(**{name: wrong})
        with self.assertRaises(mjforge.VariantError) as raised:
            variant.png(pose={"hnge": 0.1})
        self.assertEqual(raised.exception.findings[0].code, "picture/unknown-joint")

    def test_repr_says_which(self):
        spec = mjforge.Spec("hammer", set={"handle_length": "25cm"})
        variants = spec.variants(seed=7, target="mjx")
        self.assertEqual(repr(spec), "<mjforge.Spec hammer (handle_length=25cm)>")
        self.assertEqual(repr(variants[:16]), "<mjforge.Variants range(0, 16) of hammer "
                         "(handle_length=25cm), seed 7, target mjx>")
        self.assertEqual(repr(variants[3]), "<mjforge.Variant hammer (handle_length=25cm) 3 of seed 7 for mjx>")


if __name__ == "__main__":
    unittest.main()
