"""Batches that were written are read by number, in order, and made again."""

import contextlib
import importlib.util
import multiprocessing
import os
import pathlib
import pickle
import subprocess
import tempfile
import unittest
import unittest.mock

import mjforge
from mjforge import _batch_files, _stored
from mjforge._library import PROGRAM

FORMS = ("out/", "x.tar", "x.tar.zst")
UNLUCKY = """
mjforge: 1
name: ball
params: {r: "1cm .. 2cm"}
expect: ["r < 15mm"]
parts: [{name: ball, type: sphere, size: [r]}]
"""


@contextlib.contextmanager
def written(output, variants, count, **options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, output)
        variants.write(path, count, **options)
        yield path


def indices_of(batch, numbers, queue):
    try:
        queue.put([batch[number].index for number in numbers])
    except mjforge.VariantError as error:
        queue.put(str(error))


def has_numpy():
    return importlib.util.find_spec("numpy") is not None


class Batches(unittest.TestCase):
    def test_are_read_in_forked_processes_after_a_look_in_the_parent(self):
        fork = multiprocessing.get_context("fork")
        for output in ("x.tar", "x.tar.zst"):
            with written(output, mjforge.Spec("hammer").variants(), 300) as path:
                batch = mjforge.Batch(path)
                self.assertEqual(batch[0].index, 0)
                parts = [range(1 + part, 300, 3) for part in range(3)]
                queues = [fork.SimpleQueue() for _ in parts]
                workers = [fork.Process(target=indices_of, args=(batch, *each)) for each in zip(parts, queues)]
                for worker in workers:
                    worker.start()
                self.assertEqual([queue.get() for queue in queues], [list(part) for part in parts])
                self.assertEqual(batch[299].index, 299)
                for worker in workers:
                    worker.join()

    def test_that_are_compressed_are_read_once_by_ascending_numbers(self):
        with written("x.tar.zst", mjforge.Spec("hammer").variants(), 5) as path:
            batch = mjforge.Batch(path)
            self.assertEqual(len(batch), 5)
            with unittest.mock.patch("mjforge._stored.lines", wraps=_stored.lines) as lines:
                self.assertEqual([batch[number].index for number in (0, 1, 3, 4)], [0, 1, 3, 4])
            self.assertEqual(lines.call_count, 1)

    def test_have_the_variants_that_were_written(self):
        variants = mjforge.Spec("spoon").variants(seed=7, assets="files")
        for output in FORMS:
            with written(output, variants, 6) as path:
                batch = mjforge.Batch(path)
                self.assertEqual(len(batch), 6)
                for number in (4, 5, 1, 1, -1):
                    variant = batch[number]
                    self.assertEqual(variant.xml_bytes, variants[number % 6].xml_bytes)
                    self.assertEqual(variant.files, variants[number % 6].files)
                    self.assertEqual(variant.record["index"], number % 6)
                self.assertEqual([variant.index for variant in batch], list(range(6)))
                self.assertEqual([record["index"] for record in batch.records()], list(range(6)))
                self.assertEqual(pickle.loads(pickle.dumps(batch))[3].xml, batch[3].xml)
                self.assertEqual(batch.replay(3).xml_bytes, batch[3].xml_bytes)
                self.assertEqual(batch.verify(), [])

    def test_have_slices(self):
        variants = mjforge.Spec("spoon").variants(seed=7)
        for output in FORMS:
            with written(output, variants, 8) as path:
                batch = mjforge.Batch(path)
                some = batch[2:7]
                self.assertEqual(([v.index for v in some], len(some)), ([2, 3, 4, 5, 6], 5))
                self.assertEqual((some[1].xml, some[-1].index), (variants[3].xml, 6))
                self.assertEqual([v.index for v in some[::-2]], [6, 4, 2])
                self.assertEqual([v.index for v in batch[-2:]], [6, 7])
                self.assertEqual((list(batch[5:5]), len(batch[6:100])), ([], 2))
                self.assertEqual([v.index for v in pickle.loads(pickle.dumps(some))], [2, 3, 4, 5, 6])
                self.assertRaisesRegex(IndexError, "number=5 is not within the 5 objects", some.__getitem__, 5)
                self.assertRaisesRegex(TypeError, "number=", some.__getitem__, "1")
                self.assertIn("range(2, 7)", repr(some))

    def test_of_texts_are_made_again(self):
        spec = mjforge.Spec(UNLUCKY.replace('expect: ["r < 15mm"]\n', ""))
        for output in FORMS:
            with written(output, spec.variants(seed=5), 3) as path:
                batch = mjforge.Batch(path)
                self.assertEqual(batch.replay(2).xml_bytes, batch[2].xml_bytes)

    def test_are_series_and_shards(self):
        variants = mjforge.Spec("hammer").variants(seed=7)
        with written("x_%02d.tar", variants, 10, per_archive=4) as path:
            self.assertEqual([variant.index for variant in mjforge.Batch(path)], list(range(10)))
            self.assertEqual(mjforge.Batch(path)[9].xml, variants[9].xml)
            folder = mjforge.Batch(os.path.dirname(path))
            self.assertEqual((len(folder), folder[5].index), (10, 5))

    def test_say_which_shards_are_missing(self):
        with written("out/", mjforge.Spec("hammer").variants(), 6, shard="0/3") as path:
            found = mjforge.Batch(path).verify()
            self.assertEqual([f.code for f in found], ["batch/missing", "batch/missing"])
            self.assertIn("shard 1/3 is missing", found[0].message)
            manifest = pathlib.Path(path, "manifest-00000-of-00003.jsonl")
            self.assertEqual(mjforge.Batch(manifest).verify(), [])

    def test_count_only_objects_with_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            spec = pathlib.Path(folder, "ball.yaml")
            spec.write_text(UNLUCKY)
            variants = mjforge.Spec(spec).variants(on_invalid="skip")
            path = pathlib.Path(folder, "out")
            variants.write(f"{path}/", 20)
            batch = mjforge.Batch(path)
            made = [variant.index for variant in variants[:20]]
            self.assertTrue(1 < len(made) < 20)
            self.assertEqual(len(batch), len(made))
            self.assertEqual([batch[number].index for number in range(len(made))], made)
            self.assertEqual(len(list(batch.records())), 20)
            self.assertEqual(batch.replay(1).index, made[1])

    def test_say_what_is_missing_or_changed(self):
        with written("out/", mjforge.Spec("hammer").variants(), 3) as path:
            batch = mjforge.Batch(path)
            file = pathlib.Path(path, batch[1].record["file"])
            file.write_bytes(file.read_bytes() + b" ")
            pathlib.Path(path, batch[2].record["file"]).unlink()
            for number, code in ((1, "batch/changed"), (2, "batch/missing")):
                with self.assertRaises(mjforge.VariantError) as raised:
                    batch[number]
                self.assertEqual([f.code for f in raised.exception.findings], [code])
            self.assertEqual(batch[0].index, 0)
            self.assertRaises(mjforge.VariantError, list, batch)
            self.assertEqual([f.code for f in batch.verify()], ["batch/changed", "batch/missing"])

    def test_may_be_read_from_any_working_folder(self):
        self.addCleanup(os.chdir, os.getcwd())
        with written("out/", mjforge.Spec("hammer").variants(), 2) as path:
            os.chdir(os.path.dirname(os.path.dirname(path)))
            batch = mjforge.Batch("out")
            os.chdir("/")
            self.assertEqual((batch[1].index, len(batch.table(frame=False)["mass"]) if has_numpy() else 2), (1, 2))
            self.assertEqual(pickle.loads(pickle.dumps(batch)).verify(), [])

    def test_that_are_rewritten_or_damaged_are_findings(self):
        variants = mjforge.Spec("hammer").variants()
        for output, suffix in (("out/", ""), ("x.tar.zst", ".zst")):
            with written(output, variants, 6) as path:
                batch = mjforge.Batch(path)
                self.assertEqual(len(batch), 6)
                mjforge.Spec("hammer").variants(name="other").write(path, 2, force=True)
                with self.assertRaisesRegex(mjforge.VariantError, f"manifest.jsonl{suffix}: error: the manifest is "
                                                                  "damaged, or was changed since") as raised:
                    batch[4]
                self.assertEqual(raised.exception.findings[0].code, "output/bad-manifest")
        with written("out/", variants, 3) as path:
            manifest = pathlib.Path(path, "manifest.jsonl")
            lines = manifest.read_bytes().splitlines(keepends=True)
            for wrong, reason in ((b"{oops\n", "it is not JSON"), (b"[]\n", "it is not a JSON object"), (b"{}\n", "no 'stat")):
                manifest.write_bytes(lines[0] + wrong + lines[2])
                for call in (len, list, lambda batch: batch[0], lambda batch: list(batch.records())):
                    with self.assertRaisesRegex(mjforge.VariantError, f"jsonl:2:1: error: .*{reason}"):
                        call(mjforge.Batch(path))
            manifest.write_bytes(b"".join(lines[:2]))
            for call in (len, list, lambda batch: batch[0], lambda batch: list(batch.records())):
                with self.assertRaisesRegex(mjforge.VariantError, "jsonl' was changed: it has 2 records, not 3"):
                    call(mjforge.Batch(path))
            manifest.write_bytes(b"".join(lines)[:-9])
            self.assertRaisesRegex(mjforge.VariantError, "to its end: it was cut off", len, mjforge.Batch(path))

    def test_that_were_changed_since_are_one_finding_in_all_calls(self):
        variants = mjforge.Spec("hammer").variants()
        for output in FORMS:
            with written(output, variants, 6) as path:
                batch, unread = mjforge.Batch(path), mjforge.Batch(path)
                self.assertEqual((len(batch), batch[0].seed), (6, 0))
                variants.write(path, 6)
                self.assertEqual([variant.index for variant in batch], [*range(6)])  # the same again
                for change in (lambda: variants.write(path, 9, resume=True),
                               lambda: mjforge.Spec("hammer").variants(seed=5).write(path, 6)):
                    change()
                    for call in (len, list, lambda batch: batch[0], lambda batch: batch[3], lambda batch: batch[1:3][0],
                                 lambda batch: list(batch.records()), lambda batch: batch.replay(0),
                                  mjforge.Batch.table):
                        for each in (batch, unread, pickle.loads(pickle.dumps(batch))):
                            if call != mjforge.Batch.table or has_numpy():
                                with self.assertRaisesRegex(mjforge.VariantError, "was changed since this Batch"):
                                    call(each)
                self.assertEqual(mjforge.Batch(path)[5].seed, 5)

    def test_have_the_findings_of_their_records(self):
        variants = mjforge.Spec("robosuite/hammer").variants(seed=1, validate="physics")
        wanted = [(f.code, f.message, f.hint, f.line, f.severity, f.index) for f in variants[0].findings]
        self.assertEqual([code for code, *_ in wanted], ["physics/friction"])
        for output in FORMS:
            with written(output, variants, 2) as path:
                batch = mjforge.Batch(path)
                record = batch[0].record
                for variant in (batch[0], next(iter(batch)), batch.replay(0), mjforge.Variant.from_record(record)):
                    self.assertEqual([(f.code, f.message, f.hint, f.line, f.severity, f.index)
                                      for f in variant.findings], wanted)
        self.assertEqual(_batch_files.problem_of({**record, "findings": [3]}), "'findings' is not of its kind")

    def test_that_are_families_name_what_reads_them(self):
        for call in (mjforge.Batch, mjforge.prove):
            self.assertRaisesRegex(FileNotFoundError, "'f.npz' is a family, .* mjforge.load_family", call, "f.npz")
        with written("f.npz", mjforge.Spec("primitives/ball").variants(), 2) as path:
            batch = mjforge.Batch(path.replace("npz", "manifest.jsonl"))
            for call in (lambda: batch[1], lambda: list(batch)):
                self.assertRaisesRegex(FileNotFoundError, "jsonl' has the records of the family 'f.npz'", call)
            self.assertEqual([record["index"] for record in batch.records()], [0, 1])

    def test_wrong_arguments_are_named(self):
        for wrong in (5, None, True, b"out"):
            self.assertRaisesRegex(TypeError, "path=", mjforge.Batch, wrong)
        for wrong in ("no/such/batch", "no/such.tar", "no/manifest.jsonl"):
            self.assertRaisesRegex(FileNotFoundError, f"'{wrong}' does not exist", mjforge.Batch, wrong)
        self.assertRaisesRegex(FileNotFoundError, "'x_%d.tar' has no manifest 'x.manifest.jsonl'",
                               mjforge.Batch, "x_%d.tar")
        with written("out/", mjforge.Spec("hammer").variants(), 2) as path:
            batch = mjforge.Batch(path)
            for wrong in ("1", 1.0, None, True):
                self.assertRaisesRegex(TypeError, "number=", batch.__getitem__, wrong)
            self.assertRaisesRegex(IndexError, "number=2 is not within the 2 objects", batch.__getitem__, 2)
            self.assertRaises(IndexError, batch.replay, 2)


class Replays(unittest.TestCase):
    def test_of_records_compare_hashes(self):
        spec = mjforge.Spec("mug", set={"root.joints": "none"})
        options = {"target": "mjx", "sampler": "latin", "batch": 9, "name": "m${index}", "assets": "files"}
        record = spec.variants(seed=3, **options)[4].record
        self.assertEqual(mjforge.Variant.from_record(record).record, record)
        with self.assertRaisesRegex(mjforge.MismatchError, "m4 4 of seed 3: it is another file"):
            mjforge.Variant.from_record({**record, "sha256": "0" * 64})
        with self.assertRaisesRegex(mjforge.MismatchError, "the spec '.*/mug.yaml' has changed"):
            mjforge.Variant.from_record({**record, "spec_sha256": "0" * 64})

    def test_take_settings_as_the_command_does(self):
        text = ("mjforge: 1\nname: a\nparts: [{name: a, type: sphere, size: [1], if: t != 'z' and u != 'z'}]\n"
                "params: {t: {choice: ['u', v]}, u: {choice: [x, y]}}\n")
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.yaml")
            file.write_text(text)
            subprocess.run([PROGRAM, "generate", file, "--set", "t=u", "-o", f"{folder}/out", "-n", "1"], check=True,
                           capture_output=True)
            batch = mjforge.Batch(f"{folder}/out")
            self.assertEqual(batch.replay(0).params["t"], batch[0].params["u"])  # the parameter
            variant = mjforge.Spec(file).variants(set={"t": "u"})[3]
            self.assertEqual(variant.params["t"], "u")  # the choice
            self.assertEqual(mjforge.Variant.from_record(variant.record, file).record, variant.record)
            with self.assertRaisesRegex(FileNotFoundError, f"'{os.getcwd()}/a.yaml': give its path as spec="):
                mjforge.Variant.from_record(variant.record)

    def test_need_the_spec_of_a_text(self):
        text = UNLUCKY.replace('expect: ["r < 15mm"]\n', "")
        record = mjforge.Spec(text).variants(seed=2)[1].record
        self.assertRaisesRegex(ValueError, "give it as spec=", mjforge.Variant.from_record, record)
        self.assertEqual(mjforge.Variant.from_record(record, text).record, record)
        self.assertEqual(mjforge.Variant.from_record(record, mjforge.Spec(text)).record, record)

    def test_refuse_what_is_not_a_record(self):
        for wrong in (5, None, "x", [1]):
            self.assertRaisesRegex(TypeError, "record=", mjforge.Variant.from_record, wrong)
        self.assertRaisesRegex(ValueError, "record has no 'spec'", mjforge.Variant.from_record, {})
        record = mjforge.Spec("hammer").variants()[0].record
        for name, values in (("set", (3, None, ["a"])), ("spec", (3, None)), ("spec_file", (3,)),
                             ("findings", (3, [3])), ("assets", (3,))):
            for value in values:
                with self.assertRaisesRegex(ValueError, f"^the member '{name}' of record has a wrong type: record is not a line of a"):
                    mjforge.Variant.from_record({**record, name: value})


if __name__ == "__main__":
    unittest.main()
