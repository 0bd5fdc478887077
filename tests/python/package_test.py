"""The Python package makes what the command makes, and raises what it finds."""

import concurrent.futures
import json
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import time
import types
import unittest

import mjforge

BALL = {"mjforge": 1, "name": "ball", "parts": [{"name": "ball", "type": "sphere", "size": 0.02}]}
TYPO = "mjforge: 1\nname: ball\nparts: [{name: ball, type: sphere, sise: 2cm}]\n"


SHELF = """
mjforge: 1
name: shelf
joints: none
parts: [{name: board, type: box, size: [0.2, 0.1, 0.01]}]
regions: [{name: top, size: [0.2, 0.1], pos: [0, 0, 0.01]}]
bodies:
  - {name: "mug_${i}", for: {i: 12}, spec: containers/mug, joints: free, fewer: true, place: {at: top}}
"""


def is_open(path):
    """Whether a process has the file open."""
    for link in pathlib.Path("/proc").glob("[0-9]*/fd/*"):
        try:
            if os.readlink(link) == path:
                return True
        except OSError:  # the process has ended, or is another user's
            continue
    return False


class Variants(unittest.TestCase):
    def test_are_byte_for_byte_what_the_command_writes(self):
        for name in ("tools/hammer", "containers/mug"):
            variants = mjforge.Spec(name).variants(seed=7, target="robosuite", validate="load")
            with tempfile.TemporaryDirectory() as folder:
                variants.write(folder, 3, jobs=2)
                lines = pathlib.Path(folder, "manifest.jsonl").read_text().splitlines()
                self.assertEqual(len(lines), 3)
                for variant, line in zip(variants[:3], lines):
                    record = json.loads(line)
                    file = pathlib.Path(folder, record.pop("file"))
                    self.assertEqual(file.read_bytes(), variant.xml_bytes)
                    mine = {k: v for k, v in variant.record.items() if k != "file"}
                    self.assertEqual(record, mine)

    def test_their_files_are_what_the_command_writes(self):
        for name in ("kitchen/spoon", "furniture/round_table"):
            variants = mjforge.Spec(name).variants(seed=3, assets="files")
            self.assertIn('"assets_as":"files"', json.dumps(variants[0].record, separators=(",", ":")))
            with tempfile.TemporaryDirectory() as folder:
                variants.write(folder, 2)
                written = {}
                for variant in variants[:2]:
                    file = pathlib.Path(folder, f"{variant.record['name']}_{variant.index:06}.xml")
                    self.assertEqual(file.read_bytes(), variant.xml_bytes)
                    self.assertNotIn("vertex=", variant.xml)
                    again = pickle.loads(pickle.dumps(variant))
                    self.assertEqual(again.files, variant.files)
                    for asset in variant.files:
                        self.assertIn(f'file="{asset}"', variant.xml)
                    written.update(variant.files)
                found = {str(file.relative_to(folder)): file.read_bytes()
                         for file in pathlib.Path(folder).rglob("assets/*")}
                self.assertEqual(written, found)
                self.assertTrue(any(file.endswith(".obj") for file in found))
        self.assertEqual(mjforge.Spec("kitchen/spoon").variants()[0].files, {})

    def test_their_places_can_be_drawn_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "shelf.yaml")
            file.write_text(SHELF)
            scenes = mjforge.Spec(file).variants(seed=7)
            moved = mjforge.Spec(file).variants(seed=7, place_seed=0)
            here, there = scenes[3], moved[3]
            self.assertCountEqual([place["body"] for place in here.places] + here.left_out,
                                  [f"shelf_mug_{i}" for i in range(12)])
            self.assertTrue(here.places and here.left_out)
            self.assertEqual({place["at"] for place in here.places}, {"top"})
            self.assertNotEqual(here.places[0]["pos"], there.places[0]["pos"])
            self.assertEqual(here.places[0]["pos"][2], there.places[0]["pos"][2])  # the same mug
            moved.write(pathlib.Path(folder, "out"), 1)
            written = pathlib.Path(folder, "out/shelf_000000.xml").read_bytes()
            self.assertEqual(written, moved[0].xml_bytes)
            self.assertEqual(pickle.loads(pickle.dumps(moved))[3].xml_bytes, there.xml_bytes)
        self.assertEqual(mjforge.Spec(BALL).variants()[0].places, [])

    def test_bundled_scenes_have_places(self):
        desk = mjforge.Spec("scenes/desk").variants()[3]
        self.assertIn("table.surface", [place["at"] for place in desk.places])
        self.assertIn('name="desk_laptop"', desk.xml)

    def test_files_of_the_spec_are_among_them(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh = pathlib.Path(folder, "roof.obj")
            mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
            spec = mjforge.Spec({
                "mjforge": 1, "name": "house", "parts": [
                    {"name": "roof", "type": "mesh", "file": str(mesh), "density": 100},
                    {"name": "wall", "type": "box", "size": [0.1, 0.2, 0.3], "round": 0.01}]})
            files = spec.variants(assets="files")[0].files
            self.assertIn(mesh.read_bytes(), files.values())
            self.assertGreater(len(files), 1)
            self.assertEqual(list(spec.variants()[0].files.values()), [mesh.read_bytes()])

    def test_slices_are_sequences(self):
        variants = mjforge.Spec("hammer").variants()
        some = variants[10:20:2]
        self.assertEqual(len(some), 5)
        self.assertEqual([v.index for v in some], [10, 12, 14, 16, 18])
        self.assertEqual(some[-1].index, 18)
        self.assertEqual([v.index for v in some[1:3]], [12, 14])
        for wrong in (lambda: variants[5:], lambda: variants[-1], lambda: some[5]):
            self.assertRaises(IndexError, wrong)
        self.assertRaises(TypeError, len, variants)
        self.assertEqual((bool(variants), bool(some), bool(some[:0])), (True, True, False))

    def test_are_found_by_their_index(self):
        variants = mjforge.Spec("hammer").variants(seed=3)
        variant, other = variants[4], mjforge.Spec("hammer").variants(seed=4)[4]
        for some, at in ((variants, 4), (variants[:2**64], 4), (variants[1:9:3], 1), (variants[9:1:-1], 5)):
            self.assertIn(variant, some)
            self.assertEqual((some.index(variant), some.count(variant), some.count(other)), (at, 1, 0))
            self.assertEqual(some.index(variant, at, at + 1), at)
            self.assertRaisesRegex(ValueError, "hammer 4 of seed 3 .* is not one of", some.index, variant, at + 1)
            self.assertRaises(ValueError, some.index, variant, 0, at)
            for wrong in (other, variant.record, None, 4):
                self.assertNotIn(wrong, some)
                self.assertRaises(ValueError, some.index, wrong)
        self.assertNotIn(variant, variants[5:9])

    def test_that_cannot_be_made_are_not_found(self):
        given = mjforge.Spec({**BALL, "params": {"i": "1 .. 2"}}).variants()
        self.assertNotIn(given[0], mjforge.Spec({**BALL, "expect": ["1 > 2"]}).variants())

    def test_are_equal_if_file_and_record_are_the_same(self):
        variants = mjforge.Spec("hammer").variants(seed=3)
        variant = variants[4]
        self.assertEqual({variant, variants[4], pickle.loads(pickle.dumps(variant))}, {variant})
        with tempfile.TemporaryDirectory() as folder:
            variants.write(folder, 6)
            batch = mjforge.Batch(folder)
            self.assertEqual(batch[4], mjforge.Batch(folder)[4])
            self.assertIn(batch[4], batch)
            self.assertEqual(batch[2:].index(batch[4]), 2)
        for other in (variants[5], mjforge.Spec("hammer").variants(seed=3, name="other")[4], variant.xml, None):
            self.assertNotEqual(variant, other)

    def test_do_not_depend_on_threads(self):
        variants = mjforge.Spec("hammer").variants(seed=3)
        alone = [v.xml for v in variants[:200]]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertEqual(list(pool.map(lambda i: variants[i].xml, range(200))), alone)

    def test_can_be_pickled(self):
        variants = mjforge.Spec("hammer", set={"handle_length": "20cm .. 30cm"}).variants(seed=3)
        again = pickle.loads(pickle.dumps(variants[5:9]))
        self.assertEqual([v.xml for v in again], [v.xml for v in variants[5:9]])
        self.assertEqual(pickle.loads(pickle.dumps(variants[5])).xml, variants[5].xml)

    def test_their_representations_have_the_options_that_distinguish_them(self):
        spec = mjforge.Spec("hammer", set={"handle_length": "20cm .. 30cm"})
        variants = spec.variants(seed=3, name="tool", set={"handle_shape": "wooden"})
        settings = "(handle_length=20cm .. 30cm, handle_shape=wooden)"
        self.assertEqual(repr(variants[4]), f"<mjforge.Variant tool {settings} 4 of seed 3 for mujoco>")
        self.assertEqual(repr(variants), f"<mjforge.Variants of hammer {settings}, seed 3, target mujoco, name tool>")
        self.assertEqual(repr(mjforge.Spec("hammer").variants()[2]), "<mjforge.Variant hammer 2 of seed 0 for mujoco>")

    def test_outlive_their_maker(self):
        first = mjforge.Spec("hammer").variants()[0]
        self.assertIn("<mujoco", first.xml)
        self.assertGreater(first.mass, 0)
        self.assertTrue(0.05 < first.params["handle_length"] < 0.5)

    def test_settings_take_numbers_and_texts(self):
        for value in (0.25, "25cm", "250mm"):
            spec = mjforge.Spec("hammer", set={"handle_length": value})
            self.assertEqual(spec.variants()[0].params["handle_length"], 0.25)
        drawn = mjforge.Spec("hammer", set={"handle_length": "20cm .. 30cm"}).variants()
        for variant in drawn[:20]:
            self.assertTrue(0.2 <= variant.params["handle_length"] <= 0.3)

    def test_a_mapping_a_text_and_a_file_are_the_same_spec(self):
        text = json.dumps(BALL, indent=1)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "ball.yaml")
            file.write_text(text)
            # The comment at the top tells the hash of the spec's text.
            made = {mjforge.Spec(source).variants()[4].xml.partition("-->")[2]
                    for source in (BALL, text, file)}
        self.assertEqual(len(made), 1)


# Every third variant cannot be made.


class Errors(unittest.TestCase):
    def test_a_broken_spec_raises_all_of_them(self):
        with self.assertRaises(mjforge.SpecError) as raised:
            mjforge.Spec(TYPO)
        codes = [f.code for f in raised.exception.findings]
        self.assertEqual(codes, ["spec/unknown-key"])
        first = raised.exception.findings[0]
        self.assertEqual((first.line, first.column, first.severity), (3, 36, "error"))
        self.assertEqual(first.hint, "did you mean 'size'?")
        self.assertIn("<spec>:3:36: error: unknown key 'sise'", str(raised.exception))
        self.assertIn("        ^", str(raised.exception))
        self.assertEqual(len(pickle.loads(pickle.dumps(raised.exception.args))), 1)

    def test_check_reports_them(self):
        self.assertEqual(mjforge.check("hammer", 3).findings, ())
        self.assertEqual(mjforge.check(mjforge.Spec("mug"), 3, physics=True).findings, ())
        report = mjforge.check("robosuite/hammer", 3, physics=True)
        self.assertEqual(({f.code for f in report.findings}, report.ok), ({"physics/friction"}, True))

    def test_wrong_words_say_what_is_known(self):
        spec = mjforge.Spec("hammer")
        with self.assertRaisesRegex(ValueError, "target='robosuit'.*robosuite"):
            spec.variants(target="robosuit")
        with self.assertRaisesRegex(ValueError, "assets='file'.*files"):
            spec.variants(assets="file")
        for wrong in (dict(seed=-1), dict(seed=2**64), dict(name="a\0b"), dict(validate="no")):
            self.assertRaises(ValueError, spec.variants, **wrong)
        self.assertRaises(ValueError, mjforge.Spec, "hammer", set={"handle_length": float("nan")})
        self.assertRaises(mjforge.SpecError, mjforge.Spec, "hammer", set={"handle_lenght": 1})
        self.assertRaises(mjforge.SpecError, mjforge.Spec, "no/such/spec")

    def test_writing_where_nothing_can_be_written_is_an_os_error(self):
        self.assertRaises(OSError, mjforge.Spec("hammer").variants().write, "/proc/no/", 1)

    def test_no_or_a_wrong_mujoco_says_what_to_install(self):
        variant = mjforge.Spec("hammer").variants()[0]
        old = types.SimpleNamespace(__name__="mujoco", __version__="2.1.5", MjModel=None)
        for wrong in (types.ModuleType("mujoco_py"), old):
            with self.assertRaisesRegex(ImportError, "pip install 'mujoco"):
                variant.load(wrong)

    def test_ctrl_c_ends_a_write_with_whole_files(self):
        # A job in the background of a shell ignores the signal.
        program = ("import mjforge, signal, sys\n"
                   "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
                   "mjforge.Spec('hammer').variants().write(sys.argv[1], 10_000_000)")
        with tempfile.TemporaryDirectory() as folder:
            process = subprocess.Popen([sys.executable, "-c", program, folder],
                                       stderr=subprocess.PIPE)
            while not any(pathlib.Path(folder).glob("hammer_*.xml")) and process.poll() is None:
                time.sleep(0.01)
            os.kill(process.pid, signal.SIGINT)
            said = process.communicate(timeout=60)[1]
            self.assertIn(b"KeyboardInterrupt", said)
            for file in pathlib.Path(folder).glob("*.xml"):
                self.assertTrue(file.read_bytes().endswith(b"</mujoco>\n"), file)

    def test_a_write_ends_with_the_process_that_waits_for_it(self):
        program = "import mjforge, sys\nmjforge.Spec('hammer').variants().write(sys.argv[1], 10_000_000)"
        with tempfile.TemporaryDirectory() as folder:
            process = subprocess.Popen([sys.executable, "-c", program, folder], stderr=subprocess.PIPE)
            while not any(pathlib.Path(folder).glob("hammer_*.xml")) and process.poll() is None:
                time.sleep(0.01)
            process.kill()
            process.communicate(timeout=60)
            # The command removes its temporary file, or is gone, once no process has it open.
            lock = os.path.join(folder, ".manifest.jsonl.part")
            deadline = time.monotonic() + 60
            while is_open(lock) and time.monotonic() < deadline:
                time.sleep(0.05)
            self.assertFalse(is_open(lock))


if __name__ == "__main__":
    unittest.main()
