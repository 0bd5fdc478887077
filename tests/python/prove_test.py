"""`prove` reads batches, survives any MuJoCo, and says what is wrong. The comparison itself is tested in
real releases of MuJoCo by tests/interop/check_python.py.
"""

import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import mjforge
from mjforge import _prove
from mjforge._batch_files import Reader, manifests_of

PACKAGE = pathlib.Path(mjforge.__file__).parents[1]
# Modules in place of MuJoCo, whose loader does this.
REFUSES = "raise ValueError('XML Error: no good\\nElement geom, line 3')"
CRASHES = "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)"


class Agreeing:
    """In place of the processes with MuJoCo: every object is as recorded."""

    version = "9.8.7"

    def __init__(self, jobs):
        self.jobs = jobs

    def examine(self, objects, report, tick):
        for stored in objects:
            report(stored, [])

    def close(self):
        pass


class Proofs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def write(self, output, count=3, name="hammer", assets="inline", **options):
        variants = mjforge.Spec(name).variants(seed=7, assets=assets)
        variants.write(self.path / output, count, **options)

    def read(self, batch):
        """Objects and findings."""
        findings = []
        objects = [stored for manifest in manifests_of(self.path / batch)
                   for stored in Reader(manifest, findings.append)]
        return objects, findings

    def prove(self, load, *words):
        """Status, standard output and error of the command beside a module with that loader."""
        module = self.path / "modules/mujoco.py"
        module.parent.mkdir(exist_ok=True)
        module.write_text("__version__ = '9.8.7'\nclass MjModel:\n    @staticmethod\n"
                          f"    def from_xml_string(xml, files):\n        {load}\n")
        environment = {**os.environ, "PYTHONPATH": f"{module.parent}:{PACKAGE}"}
        result = subprocess.run([sys.executable, "-m", "mjforge", "prove", *words], cwd=self.path,
                                env=environment, capture_output=True, text=True)
        return result.returncode, result.stdout, result.stderr

    def test_reads_back_what_was_written(self):
        for output in ("a/", "b.tar", "c.tar.zst", "d_%d.tar.zst"):
            self.write(output, assets="files", name="mug")
            (manifest,) = manifests_of(self.path / output)
            self.assertEqual(Reader(manifest, print).count(), 3)
            self.assertEqual(manifest.suffix == ".zst", output.endswith(".zst"))
            objects, findings = self.read(output)
            self.assertEqual(findings, [])
            variants = mjforge.Spec("mug").variants(seed=7, assets="files")[:3]
            self.assertEqual(len(objects), 3)
            for stored, variant in zip(objects, variants):
                self.assertEqual(stored.xml, variant.xml_bytes)
                self.assertEqual(stored.files, variant.files)
                self.assertEqual(stored.record["params"], variant.params)

    def test_reads_series_shards_and_folders_of_folders(self):
        self.write("s_%02d.tar", 5, per_archive=2)
        self.assertEqual(len(self.read("s_%02d.tar")[0]), 5)
        for shard in range(2):
            self.write("shards/", 5, shard=f"{shard}/2")
        self.assertEqual(len(self.read("shards/")[0]), 5)
        self.write("many/one/", 2)
        self.write("many/two/", 2)
        self.assertEqual(len(self.read("many")[0]), 4)
        self.assertEqual(len(self.read("many/one/manifest.jsonl")[0]), 2)
        with self.assertRaisesRegex(FileNotFoundError, "none.tar' does not exist"):
            manifests_of(self.path / "none.tar")

    def test_a_shard_that_was_not_made_is_missing(self):
        for shard in (0, 2):
            self.write("shards/", 6, shard=f"{shard}/3")
        with unittest.mock.patch.object(_prove, "Crew", Agreeing):
            (finding,) = mjforge.prove(self.path / "shards")
            self.assertEqual(finding.code, "batch/missing")
            self.assertIn("shard 1/3 is missing: there is no '", finding.message)
            self.assertIn("manifest-00001-of-00003.jsonl'", finding.message)
            self.assertEqual(mjforge.prove(self.path / "shards/manifest-00002-of-00003.jsonl"), [])
            self.write("shards/", 6, shard="1/3")
            self.assertEqual(mjforge.prove(self.path / "shards"), [])

    def test_the_record_names_the_release_that_checked_it(self):
        version = subprocess.run([PACKAGE / "mjforge/bin/mjforge", "--version"], capture_output=True,
                                 text=True).stdout.splitlines()[1]
        self.write("a/", 1)
        (stored,), _ = self.read("a/")
        self.assertEqual("MuJoCo " + stored.record["mujoco"], version)
        self.assertNotIn("mujoco", mjforge.Spec("hammer").variants()[0].record)

    def test_what_cannot_be_read_is_found(self):
        self.write("a/", 5)
        (self.path / "a/hammer_000000.xml").unlink()
        (self.path / "a/hammer_000001.xml").write_text("<mujoco/>")
        (self.path / "a/hammer_000002.xml").unlink()
        os.mkfifo(self.path / "a/hammer_000002.xml")
        manifest = self.path / "a/manifest.jsonl"
        lines = manifest.read_text().splitlines()
        lines[3] = lines[3].replace("hammer_000003.xml", "../../etc/passwd")
        manifest.write_text("\n".join([*lines, "[]", "no JSON", "[" * 100000, '{"status": "ok"}', ""]))
        objects, findings = self.read("a/")
        self.assertEqual([stored.record["index"] for stored in objects], [4])
        self.assertEqual([(f.code, f.index, f.line) for f in findings],
                         [("batch/missing", 0, None), ("batch/changed", 1, None),
                          ("batch/missing", 2, None), ("output/bad-manifest", None, 4),
                          *(("output/bad-manifest", None, line) for line in (6, 7, 8, 9))])
        self.assertIn("is not a regular file", findings[2].message)

    def test_a_manifest_that_was_cut_is_an_error(self):
        self.write("x.tar.zst", 200)
        manifest = self.path / "x.manifest.jsonl.zst"
        manifest.write_bytes(manifest.read_bytes()[:1000])
        objects, findings = self.read("x.tar.zst")
        self.assertEqual(len(objects) % 64, 0)
        self.assertEqual([(f.code, f.message) for f in findings],
                         [("output/bad-manifest", "cannot read the manifest to its end: it was cut off")])
        manifest.rename(self.path / "y.manifest.jsonl.zst.part")
        self.assertEqual(self.read("y.manifest.jsonl.zst.part")[1], [])

    def prove_manifest(self, change):
        """Status and output of the command after a change of the lines of a manifest of 4 variants."""
        self.write("m/", 4, force=True)
        manifest = self.path / "m/manifest.jsonl"
        lines = manifest.read_text().splitlines(keepends=True)
        change(lines)
        manifest.write_text("".join(lines))
        said = io.StringIO()
        with unittest.mock.patch("mjforge._prove.Crew", Agreeing), contextlib.redirect_stderr(said):
            status = _prove.main([f"{self.path}/m"])
        return status, said.getvalue().replace(f"{self.path}/", "").splitlines()

    def test_a_batch_that_was_opened(self):
        self.write("a/", 2)
        with unittest.mock.patch("mjforge._prove.Crew", Agreeing):
            for batch in (mjforge.Batch(self.path / "a"), self.path / "a", f"{self.path}/a"):
                self.assertEqual(mjforge.prove(batch), [])
            self.assertEqual(mjforge.Batch(self.path / "a").prove(jobs=1), [])
        self.assertRaises(FileNotFoundError, mjforge.prove, "")
        self.assertRaises(FileNotFoundError, mjforge.Batch, "")

    def test_a_manifest_that_was_changed_is_found(self):
        changed = "mjforge: error: 'm/manifest.jsonl' was changed: it has"
        hint = "  hint: run the command that made it again with --resume"
        status, said = self.prove_manifest(lambda lines: None)
        self.assertEqual((status, len(said)), (0, 1))
        for count, change, words in (
                (3, lambda lines: lines.insert(2, lines.pop(2).replace('"status":"ok"', '"status":"weird"')),
                 ["m/manifest.jsonl:3:1: error: this line is not a record: 'status' is not one of ok, failed, "
                  "skipped [output/bad-manifest]"]),
                (3, lambda lines: lines.pop(2), [f"{changed} 3 records, not 4 [batch/changed]", hint]),
                (3, lambda lines: lines.pop(), [f"{changed} 3 records, not 4 [batch/changed]", hint]),
                (4, lambda lines: lines.insert(2, lines[1]),
                 ["m/manifest.jsonl:3:1: error: index 1 follows index 1, but indices ascend from line to line "
                  "[output/bad-manifest]"])):
            status, said = self.prove_manifest(change)
            self.assertEqual((status, said[:-1]), (1, words))
            self.assertTrue(said[-1].startswith(f"{count} variants in m: {count} as recorded"), said)

    def test_a_variant_that_its_manifest_calls_failed_is_found(self):
        _, said = self.prove_manifest(
            lambda lines: lines.insert(2, lines.pop(2).replace('"status":"ok"', '"status":"failed"')))
        self.assertRegex(said[0], r"'m/manifest.jsonl' was changed: it has \d+ bytes, not \d+ \[batch/changed\]")

    def test_manifests_that_were_joined_or_filtered_are_read(self):
        self.write("a/", 4)
        lines = (self.path / "a/manifest.jsonl").read_text().splitlines(keepends=True)
        other = [line.replace('"seed":7', '"seed":8') for line in lines]
        (self.path / "a/x.manifest.jsonl").write_text("".join([*lines[::2], *other]))
        objects, findings = self.read("a/x.manifest.jsonl")
        self.assertEqual((len(objects), findings), (6, []))

    def test_an_archive_that_was_cut_costs_its_last_objects(self):
        self.write("x.tar", 5)
        content = (self.path / "x.tar").read_bytes()
        (self.path / "x.tar").write_bytes(content[:len(content) // 2])
        objects, findings = self.read("x.tar")
        self.assertEqual(len(objects), 2)
        self.assertEqual([(f.code, f.index) for f in findings], [("batch/missing", 2)])

    def test_a_file_that_is_refused_is_a_finding_at_its_line(self):
        self.write("a/", 2)
        status, out, said = self.prove(REFUSES, "a", "-j1")
        self.assertEqual((status, out), (1, ""))
        self.assertIn("a/hammer_000001.xml:3:1: error: in MuJoCo 9.8.7 loading it fails: XML Error: no good "
                      "Element geom, line 3 (seed 7, index 1) [mujoco/error]\n  <compiler", said)
        self.assertRegex(said, r"2 variants in a: 0 as recorded in MuJoCo 9\.8\.7; checked in \S+ when made")
        status, _, said = self.prove(REFUSES, "a", "--findings", "json", "--quiet")
        self.assertEqual([json.loads(line)["index"] for line in said.splitlines()], [0, 1])

    def test_a_crash_costs_one_object(self):
        self.write("a/", 3)
        status, _, said = self.prove(CRASHES, "a", "-j1", "-q")
        self.assertEqual(status, 1)
        self.assertEqual(said.count("loading it makes MuJoCo crash (SIGSEGV)"), 3)

    def test_exit_statuses(self):
        self.assertEqual(self.prove(REFUSES, "none")[0], 3)
        self.assertEqual(self.prove(REFUSES)[0], 2)
        for jobs in ("0", "-1", "1025", "x"):
            status, _, said = self.prove(REFUSES, "a", f"--jobs={jobs}")
            self.assertEqual(status, 2)
            self.assertIn(f"'{jobs}' is not a number of processes from 1 to 1024", said)
        self.write("a/", 1)
        status, _, said = self.prove(REFUSES, "")
        self.assertEqual((status, said), (3, "mjforge: error: '' has no manifest: name the folder, the archive or the "
                                             "manifest that 'mjforge generate' wrote\n"))
        self.assertIn("\n1 variant in a: 0 as", self.prove(REFUSES, "a")[2])
        self.write("a/", 1)
        (self.path / "modules/mujoco.py").write_text("raise ImportError('none here')")
        result = subprocess.run([sys.executable, "-m", "mjforge", "prove", "a"], cwd=self.path,
                                env={**os.environ, "PYTHONPATH": f"{self.path}/modules:{PACKAGE}"},
                                capture_output=True, text=True)
        self.assertEqual(result.returncode, 3)
        self.assertIn("pip install", result.stderr)


if __name__ == "__main__":
    unittest.main()
