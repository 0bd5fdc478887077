"""A wrong argument is a TypeError or a ValueError that names it, never a crash of the interpreter."""

import pathlib
import unittest

import mjforge

TEXTS = ("validate", "target", "assets", "name", "sampler", "on_invalid")
NUMBERS = ("seed", "batch")


class Arguments(unittest.TestCase):
    def test_options_that_are_not_texts(self):
        spec = mjforge.Spec("hammer")
        for option in TEXTS:
            for wrong in (True, False, None, 0, 5, 2.5, b"mjx", pathlib.Path("mjx"), ["mjx"], object()):
                with self.assertRaisesRegex(TypeError, f"{option}=.* is not a text", msg=f"{option}={wrong}"):
                    spec.variants(**{option: wrong})
            with self.assertRaisesRegex(ValueError, f"{option}=.*zero character"):
                spec.variants(**{option: "mjx\0"})
            with self.assertRaises(ValueError):
                spec.variants(**{option: "\ud800"})

    def test_options_that_are_not_integers(self):
        spec = mjforge.Spec("hammer")
        for option in NUMBERS:
            for wrong in (True, None, 2.0, "7", b"7", [7]):
                with self.assertRaisesRegex(TypeError, f"{option}=.* is not an integer"):
                    spec.variants(**{option: wrong})
            for wrong in (-1, 2**64):
                with self.assertRaisesRegex(ValueError, f"{option}={wrong} is not within"):
                    spec.variants(**{option: wrong})
        self.assertRaises(TypeError, spec.variants, place_seed="7")
        self.assertRaises(ValueError, spec.variants, place_seed=-1)
        self.assertEqual(spec.variants(seed=2**64 - 1)[0].seed, 2**64 - 1)

    def test_specs_and_settings(self):
        for wrong in (None, True, 5, b"hammer", ["hammer"], object()):
            self.assertRaises(TypeError, mjforge.Spec, wrong)
        for wrong in (5, True, "a=1", [("handle_length", 1)]):
            self.assertRaises(TypeError, mjforge.Spec, "hammer", set=wrong)
        for wrong in ({5: 1}, {None: 1}, {b"handle_length": 1}, {"handle_length": object()}):
            self.assertRaises(TypeError, mjforge.Spec, "hammer", set=wrong)
        for wrong in ("x.yaml", pathlib.Path("x.yaml"), [5], [None], [b"x.yaml"], 5):
            self.assertRaises(TypeError, mjforge.Spec, "hammer", parameters=wrong)
        spec = mjforge.Spec("hammer")
        spec.settings = {"handle_length": 5}
        self.assertRaises(TypeError, spec.variants)

    def test_indices(self):
        variants = mjforge.Spec("hammer").variants()
        for wrong in ("a", None, 1.0, b"a", slice(0, "a"), slice("a", 3), slice(0, 3, "a"), slice(0, 2.0)):
            self.assertRaises(TypeError, variants.__getitem__, wrong)
        for wrong in (-1, 2**64):
            self.assertRaises(IndexError, variants.__getitem__, wrong)
        # C would take it for index 0.
        self.assertRaises(IndexError, variants[2**64:2**64 + 1].__getitem__, 0)


if __name__ == "__main__":
    unittest.main()
