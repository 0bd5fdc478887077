"""A Spec is what its files were when it was made, in every thread, process and folder."""

import concurrent.futures
import copy
import json
import os
import pathlib
import pickle
import subprocess
import unittest
import unittest.mock

import mjforge
from in_folder import InFolder
from mjforge._library import PROGRAM

PEG = "mjforge: 1\nname: peg\nparams: {{r: {}}}\nparts: [{{name: a, type: sphere, size: [r]}}]\n"
PARTS = ("mjforge: 1\nname: pair\nimport: wood.yaml\nbodies:\n  - {name: a, spec: peg.yaml}\n"
         "  - {name: b, parts: [{name: b, type: box, size: [r, r, r], material: wood}], pos: [1, 0, 0]}\n"
         "params: {r: 1cm .. 2cm}\n")
WOOD = "mjforge: 1\nmaterials: {wood: {rgba: [0.5, 0.3, 0.1, 1], density: 600}}\n"
ROOF = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 {}\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
HOUSE = {"mjforge": 1, "name": "house", "parts": [
    {"name": "roof", "type": "mesh", "file": "roof.obj", "density": 100}]}


class Named(mjforge.Spec):
    """A Spec with an attribute of its own."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self.title = "a peg"


class Some(mjforge.Variants):
    """Variants with an attribute of their own."""


class Snapshot(InFolder):
    def put(self, range="1cm .. 2cm"):
        pathlib.Path("peg.yaml").write_text(PEG.format(range))

    def test_a_changed_file_changes_nothing(self):
        self.put()
        spec = mjforge.Spec("peg.yaml")
        variants = spec.variants(seed=1)
        before = variants[0].xml
        self.put("5cm .. 6cm")
        with concurrent.futures.ThreadPoolExecutor(8) as pool:
            made = set(pool.map(lambda _: variants[0].xml, range(500)))
        self.assertEqual(made, {before})
        self.assertEqual(spec.variants(seed=1)[0].xml, before)
        self.assertEqual(spec.text, PEG.format("1cm .. 2cm"))
        self.assertEqual(spec.path, os.path.realpath("peg.yaml"))
        variants.write("out", 1)
        self.assertEqual(pathlib.Path("out/peg_000000.xml").read_text(), before)
        self.assertTrue(spec.check(2).ok)
        self.assertGreater(mjforge.Spec("peg.yaml").variants(seed=1)[0].params["r"], 0.05)

    def test_a_path_may_have_a_line_break(self):
        file = pathlib.Path("a\nb.yaml")
        file.write_text(PEG.format("1cm"))
        spec = mjforge.Spec(file)
        self.assertEqual((spec.name, spec.path), ("peg", os.path.realpath(file)))
        self.assertTrue(spec.variants().write("out", 1).ok)
        self.assertRaises(mjforge.SpecError, mjforge.Spec, str(file))  # YAML

    def test_imports_nested_specs_and_parameter_files_are_held(self):
        self.put()
        pathlib.Path("wood.yaml").write_text(WOOD)
        pathlib.Path("pair.yaml").write_text(PARTS)
        pathlib.Path("more.yaml").write_text("r: 1.5cm\n")
        for source in ("pair.yaml", PARTS):
            spec = mjforge.Spec(source, parameters=["more.yaml"])
            before = spec.variants(seed=1)[3].xml
            saved = pickle.dumps(spec)
            names = sorted(os.path.basename(path) for path in spec.texts)
            first = "pair.yaml" if source == "pair.yaml" else "-"
            self.assertEqual(names, sorted([first, "more.yaml", "peg.yaml", "wood.yaml"]))
            for file in self.folder.glob("*.yaml"):
                file.rename(file.with_suffix(".gone"))
            os.chdir("/")
            for each in (spec, pickle.loads(saved)):
                self.assertEqual(each.variants(seed=1)[3].xml, before)
                self.assertEqual(each.sha256, spec.sha256)
                each.variants(seed=1).write(self.folder / "out", 4, force=True)
                self.assertEqual((self.folder / "out/pair_000003.xml").read_text(), before)
            os.chdir(self.folder)
            for file in self.folder.glob("*.gone"):
                file.rename(file.with_suffix(".yaml"))

    def test_a_changed_mapping_changes_nothing(self):
        source = {"mjforge": 1, "name": "peg", "params": {"r": "1cm .. 2cm"},
                  "parts": [{"name": "a", "type": "sphere", "size": ["r"]}]}
        settings = {"r": "1cm"}
        spec = mjforge.Spec(source)
        pinned = mjforge.Spec(source, set=settings)
        source["params"]["r"] = "oops"
        settings["r"] = "oops"
        self.assertLess(spec.variants(seed=1)[0].params["r"], 0.02)
        self.assertEqual(pinned.variants()[0].params["r"], 0.01)

    def test_pickled_variants_are_the_same_in_another_folder(self):
        self.put()
        variants = mjforge.Spec("peg.yaml").variants(seed=1)
        before, saved = variants[0].xml, pickle.dumps(variants[:3])
        self.put("5cm .. 6cm")
        os.chdir("/")
        self.assertEqual(pickle.loads(saved)[0].xml, before)

    def test_copies_have_the_type_and_the_attributes(self):
        spec = Named(PEG.format("1cm .. 2cm"))
        for each in (copy.copy(spec), copy.deepcopy(spec), pickle.loads(pickle.dumps(spec)),
                     pickle.loads(pickle.dumps(spec, 0)), spec.variants(set={"r": 0.01}).spec, pickle.loads(pickle.dumps(spec.variants()[:3])).spec):
            self.assertEqual((type(each), each.title, each.name, each.text), (Named, "a peg", "peg", spec.text))
            self.assertEqual(list(each.parameters), ["r"])
        self.assertEqual(spec.variants(set={"r": 0.01}).spec.variants()[0].params["r"], 0.01)
        variants = Some(spec, spec.variants(seed=3)._options)
        variants.title = "pegs"
        for each in (variants[:5], variants[:9][:5], copy.copy(variants)[:5], pickle.loads(pickle.dumps(variants[:5]))):
            self.assertEqual((type(each), each.title, len(each)), (Some, "pegs", 5))
            self.assertEqual(each[4], variants[4])

    def test_a_search_path_that_changes_later_changes_nothing(self):
        self.put()
        before = os.environ.get("MJFORGE_PATH")
        os.environ["MJFORGE_PATH"] = str(self.folder)
        try:
            spec = mjforge.Spec("peg")
            entry, = [entry for entry in mjforge.catalogue() if entry == "peg"]
            self.assertEqual(os.path.realpath(entry.path), os.path.realpath("peg.yaml"))
        finally:
            os.environ.pop("MJFORGE_PATH")
            if before is not None:
                os.environ["MJFORGE_PATH"] = before
        self.assertEqual(spec.variants()[0].record["spec"], "peg")
        spec.variants().write("out", 1)
        self.assertEqual(json.loads(pathlib.Path("out/manifest.jsonl").read_text())["spec"], "peg")

    def test_a_changed_mesh_is_an_error(self):
        mesh = pathlib.Path("roof.obj")
        mesh.write_text(ROOF.format(1))
        spec = mjforge.Spec(HOUSE)
        used = spec.variants()
        first = used[0]
        self.assertEqual(list(first.files.values()), [mesh.read_bytes()])
        saved = pickle.dumps(spec)
        mesh.write_text(ROOF.format(2))
        for each in (spec, pickle.loads(saved)):
            variants = each.variants()
            for _ in range(2):
                with self.assertRaisesRegex(OSError, "roof.obj' has changed since"):
                    variants[0]
            with self.assertRaisesRegex(OSError, "roof.obj' has changed since"):
                variants.write("out", 1)
        for variant in (first, used[1]):
            self.assertEqual(variant.mass, first.mass)  # made from the mesh that was read
            for call in (lambda: variant.files, lambda: variant.save(self.folder)):
                self.assertRaisesRegex(OSError, "roof.obj' has changed since the Spec of this variant first used", call)
        self.assertAlmostEqual(mjforge.Spec(HOUSE).variants()[0].mass, 2 * first.mass)

    def test_a_missing_mesh_is_named_as_text(self):
        pathlib.Path("roof.obj").write_text(ROOF.format(1))
        variant = mjforge.Spec(HOUSE).variants()[0]
        os.unlink("roof.obj")
        with self.assertRaises(FileNotFoundError) as raised:
            variant.files
        self.assertEqual(raised.exception.filename, os.path.realpath("roof.obj"))

    def test_a_changed_mjcf_file_is_an_error(self):
        file = pathlib.Path("arm.xml")
        text = '<mujoco><worldbody><body name="arm"><geom size="{}"/></body></worldbody></mujoco>'
        file.write_text(text.format(0.1))
        spec = mjforge.Spec({"mjforge": 1, "name": "a", "bodies": [{"name": "b", "mjcf": "arm.xml", "body": "arm"}]})
        variants = spec.variants()
        before = variants[0].xml
        file.write_text(text.format(0.2))
        self.assertEqual(variants[1].xml.partition("-->")[2], before.partition("-->")[2])  # it is in memory
        os.chdir("/")
        for call in (lambda: spec.variants()[0], lambda: variants.write(self.folder / "out", 1)):
            self.assertRaisesRegex(OSError, "arm.xml' has changed since", call)

    def test_batches_of_texts_and_mappings_can_be_replayed(self):
        self.put()
        pathlib.Path("wood.yaml").write_text(WOOD)
        text = PARTS
        mapping = {"mjforge": 1, "name": "m", "params": {"l": "22cm .. 30cm"},
                   "parts": [{"name": "h", "type": "capsule", "size": ["1cm", "l/2"]}]}
        for number, source in enumerate((text, mapping)):
            variants = mjforge.Spec(source).variants(seed=1)
            for output in (f"folder{number}", f"one{number}.tar.zst", f"many{number}_%05d.tar"):
                report = variants.write(output, 3, per_archive=2 if "%" in output else None)
                self.assertTrue(report.manifest.with_name(
                    report.manifest.name.partition(".jsonl")[0] + ".spec.json").exists())
                for file in self.folder.glob("*.yaml"):
                    file.rename(file.with_suffix(".gone"))
                said = subprocess.run([PROGRAM, "replay", f"{report.manifest}:1"], capture_output=True,
                                      text=True)
                self.assertEqual(said.returncode, 0, said.stderr)
                self.assertIn("same bytes", said.stderr + said.stdout)
                for file in self.folder.glob("*.gone"):
                    file.rename(file.with_suffix(".yaml"))

    def test_batches_of_files_that_were_changed_or_removed_can_be_replayed(self):
        ball = PEG.format("1cm .. 2cm") + "import: wood\n"
        pathlib.Path("wood.yaml").write_text(WOOD)
        file = pathlib.Path("ball.yaml")
        file.write_text(ball)
        variants = mjforge.Spec("ball.yaml").variants(seed=1)
        variants.write("same", 2)
        self.assertFalse(os.path.exists("same/manifest.spec.json"))
        for number, change in enumerate((lambda: file.write_text(ball.replace("2cm", "3cm")), file.unlink,
                                         lambda: (file.write_text(ball), os.unlink("wood.yaml")))):
            change()
            for output in (f"folder{number}", f"one{number}.tar"):
                report = variants.write(output, 2)
                batch = mjforge.Batch(output)
                self.assertEqual(batch.replay(1).xml_bytes, batch[1].xml_bytes)
                self.assertEqual(batch[1].xml_bytes, variants[1].xml_bytes)
                said = subprocess.run([PROGRAM, "replay", f"{report.manifest}:1"], capture_output=True, text=True)
                self.assertEqual(said.returncode, 0, said.stderr)
        variants.write("same", 3, resume=True)
        self.assertEqual(mjforge.Batch("same").replay(2).xml_bytes, variants[2].xml_bytes)

    def test_specs_that_are_found_by_name_elsewhere_are_not_kept(self):
        os.mkdir("here")
        pathlib.Path("here/ball.yaml").write_text(PEG.format("1cm .. 2cm"))
        with unittest.mock.patch.dict(os.environ, MJFORGE_PATH="here"):
            variants = mjforge.Spec("ball").variants()
        os.rename("here", "there")
        with unittest.mock.patch.dict(os.environ, MJFORGE_PATH="there"):
            variants.write("out", 2)
            self.assertFalse(os.path.exists("out/manifest.spec.json"))
            self.assertEqual(mjforge.Batch("out").replay(1).xml_bytes, variants[1].xml_bytes)

    def test_a_snapshot_is_a_spec_for_the_command(self):
        self.put()
        mjforge.Spec(PEG.format("1cm")).variants().write("out", 1)
        self.put("oops")
        said = subprocess.run([PROGRAM, "inspect", "out/manifest.spec.json"], capture_output=True, text=True)
        self.assertIn("peg", said.stdout)
        file = pathlib.Path("out/manifest.spec.json")
        file.write_text(file.read_text()[:-20])
        said = subprocess.run([PROGRAM, "check", str(file)], capture_output=True, text=True)
        self.assertEqual(said.returncode, 3)
        self.assertIn("'out/manifest.spec.json' is a damaged snapshot of a spec", said.stderr)

    def test_a_snapshot_takes_parameter_files_from_the_disk(self):
        more = pathlib.Path("more.yaml")
        more.write_text("r: 11mm\n")
        mjforge.Spec(PEG.format("1cm .. 2cm"), parameters=[more]).variants().write("out", 1)
        more.write_text("r: 12mm\n")
        os.mkdir("elsewhere")
        os.chdir("elsewhere")
        pathlib.Path("more.yaml").write_text("r: 13mm\n")
        snapshot = self.folder / "out/manifest.spec.json"
        for file, radius in ((self.folder / more, 0.012), (more, 0.013)):
            made = subprocess.run([PROGRAM, "generate", snapshot, "--params", file, "-n", "1", "-o", "-"],
                                  capture_output=True, text=True)
            self.assertIn(f'size="{radius}"', made.stdout, made.stderr)
            spec = mjforge.Spec(snapshot, parameters=[file])
            self.assertEqual(spec.variants()[0].params["r"], radius)
        more.write_text("r: 14mm\n")
        self.assertEqual(spec.variants()[0].params["r"], 0.013)  # a Spec holds them

    def test_a_foreign_file_in_place_of_the_snapshot_stops_a_batch_at_its_start(self):
        for output, name in (("out", "manifest.spec.json"), ("x.tar", "x.manifest.spec.json")):
            foreign = self.folder / (f"out/{name}" if output == "out" else name)
            foreign.parent.mkdir(exist_ok=True)
            foreign.write_text('{"mine": 1}')
            variants, done = mjforge.Spec(PEG.format("1cm")).variants(), []
            with self.assertRaisesRegex(OSError, f"{name}' exists and was not made by mjforge"):
                variants.write(output, 3, progress=lambda made, _: done.append(made))
            self.assertEqual((done, foreign.read_text()), ([], '{"mine": 1}'))
            made = [path for path in self.folder.glob(f"{output}*/*") if path != foreign]
            self.assertEqual(made + list(self.folder.glob(f"{output}.part")), [])
            variants.write(output, 3, force=True)
            variants.write(output, 3)
            self.assertEqual(len(mjforge.Batch(output)), 3)

    def test_a_damaged_pickle_is_a_value_error(self):
        saved = pickle.dumps(mjforge.Spec(PEG.format("1cm")))
        for wrong in (saved.replace(b"mjforge_snapshot", b"mjforge_snapshop"), saved.replace(b'"texts"', b'"textz"')):
            self.assertRaisesRegex(ValueError, "a pickled Spec is damaged", pickle.loads, wrong)

    def test_folders_need_not_be_utf8(self):
        folder = pathlib.Path(os.fsdecode(b"caf\xe9"))
        folder.mkdir()
        os.chdir(folder)
        pathlib.Path("wood.yaml").write_text(WOOD)
        pathlib.Path("roof.obj").write_text(ROOF.format(1))
        pathlib.Path("house.yaml").write_text(json.dumps({**HOUSE, "import": "wood.yaml"}))
        for reference in ("house.yaml", self.folder / folder / "house.yaml"):
            spec = mjforge.Spec(reference)
            self.assertEqual(os.fsencode(spec.path), os.fsencode(os.path.realpath("house.yaml")))
            self.assertEqual([os.path.basename(path) for path in sorted(spec.texts)], ["house.yaml", "wood.yaml"])
            variant = pickle.loads(pickle.dumps(spec)).variants()[0]
            self.assertEqual(list(variant.files.values()), [pathlib.Path("roof.obj").read_bytes()])
            report = spec.variants().write(self.folder / folder / "out", 2)
            self.assertTrue(report.ok, report.findings)
            self.assertEqual(mjforge.Batch(report.manifest)[1].xml_bytes, spec.variants()[1].xml_bytes)
        pathlib.Path("house.yaml").write_text("mjforge: 2\n")
        with self.assertRaises(mjforge.SpecError) as raised:
            mjforge.Spec(self.folder / folder / "house.yaml")
        str(raised.exception).encode()  # can be printed


if __name__ == "__main__":
    unittest.main()
