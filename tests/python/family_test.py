"""Families in Python: what is refused before NumPy is needed. What they load is compared with MuJoCo in
tests/interop/check_family.py and tests/interop/check_worlds.py.
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import zipfile

import mjforge


class Families(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refused(self, error, path, message):
        with self.assertRaises(error) as caught:
            mjforge.load_family(path)
        self.assertEqual(str(caught.exception), message)

    def write(self, name="balls.npz"):
        ball = {"mjforge": 1, "name": "ball", "params": {"r": {"uniform": [0.01, 0.02]}},
                "parts": [{"name": "ball", "type": "sphere", "size": "r"}]}
        file = self.folder / name
        self.assertTrue(mjforge.Spec(ball).variants(seed=7).write(file, 2).ok)
        return file

    def test_need_a_path(self):
        self.refused(TypeError, 3, "path=3 is not a path but of type int")

    def test_are_files_that_exist(self):
        file = self.folder / "cups.npz"
        self.refused(FileNotFoundError, file,
                     f"'{file}' does not exist: 'mjforge generate SPEC -n 64 -o NAME.npz' writes a family")

    def test_are_no_folders(self):
        self.refused(ValueError, self.folder,
                     f"path='{self.folder}' is a folder, and a family is one file; it has no .npz files")
        self.write()
        self.refused(ValueError, self.folder, f"path='{self.folder}' is a folder, and a family is one file; "
                     "name one of its files: balls.npz")

    def test_are_one_of_the_files_of_structures(self):
        self.write("balls_1.npz")
        series = self.folder / "balls_%s.npz"
        self.refused(ValueError, series,
                     f"path='{series}' names a file for each structure; name one of them: balls_1.npz")

    def test_have_mocap_bodies_if_asked(self):
        post = {"mjforge": 1, "name": "post", "joints": "none", "params": {"r": {"uniform": [0.01, 0.02]}},
                "parts": [{"name": "post", "type": "cylinder", "size": ["r", 0.2]}]}
        for mocap in (False, True):
            file = self.folder / f"posts_{mocap}.npz"
            self.assertTrue(mjforge.Spec(post).variants(seed=7).write(file, 2, mocap=mocap).ok)
            with zipfile.ZipFile(file) as members:
                self.assertEqual(b'mocap="true"' in members.read("base.npy"), mocap)
        with self.assertRaisesRegex(TypeError, "^mocap=1 is not True or False"):
            mjforge.Spec(post).variants().write(self.folder / "posts.npz", 2, mocap=1)

    def test_are_padded_or_split_if_asked(self):
        pin = {"mjforge": 1, "name": "pin", "params": {"shape": {"cycle": ["box", "ball"]}},
               "parts": [{"name": "core", "type": "box", "size": [0.02, 0.02, 0.02]},
                         {"name": "knob", "if": "shape == 'ball'", "type": "sphere", "size": 0.03}]}
        variants = mjforge.Spec(pin).variants(seed=7)
        report = variants.write(self.folder / "padded.npz", 4, pad=True)
        self.assertEqual((report.ok, len(list(self.folder.glob("padded*.npz")))), (True, 1))
        with self.assertRaisesRegex(ValueError, "^record is that of a variant with null geoms"):
            mjforge.Variant.from_record(next(mjforge.Batch(report.manifest).records()), pin)
        self.assertTrue(variants.write(self.folder / "split_%s.npz", 4, layout="split").ok)
        self.assertEqual(len(list(self.folder.glob("split_*.npz"))), 2)
        self.assertFalse(variants.write(self.folder / "one.npz", 4).ok)

    def test_say_that_numpy_is_missing(self):
        file = self.write()
        with unittest.mock.patch("importlib.import_module", side_effect=ImportError):
            self.refused(ImportError, str(file), "this needs NumPy: python -m pip install numpy")

    def test_are_not_loaded_with_the_package(self):
        code = "import mjforge, sys; print({'numpy', 'mujoco', 'mjforge._family_fields'} & set(sys.modules))"
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(said.stdout, "set()\n")


if __name__ == "__main__":
    unittest.main()
