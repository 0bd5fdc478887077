"""Tests what makes the page of the bundled specs: measures of families, products and shares."""

import contextlib
import io
import os
import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/pictures"))

import catalogue
import families
import products
import shares


def record(mass, sides):
    return {"mass": mass, "aabb": {"min": [-1, 0, 0], "max": [sides[0] - 1, sides[1], sides[2]]}}


def model(joints="", sites=""):
    return ElementTree.fromstring(
        f'<mujoco model="box"><worldbody><body name="box"><joint name="box_joint0" type="free"/>{joints}{sites}</body>'
        '</worldbody><equality><joint name="box_pair" joint1="box_a"/></equality></mujoco>')


def box_family():
    return families.Family(
        [record(0.4, [0.1, 0.3, 0.2]), record(0.5, [0.2, 0.1, 0.15]), {"status": "failed"}],
        [model('<joint name="box_slide_2" type="slide" range="0 0.05"/>'
               '<joint name="box_turn" range="-1 1" limited="false"/>',
               '<site name="box_grasp_1"/><site name="box_inside"/>'),
         model('<joint name="box_slide_10" type="slide" range="-0.01 0.07"/>', '<site name="box_grasp_2"/>')])


class Families(unittest.TestCase):
    def test_masses_and_sorted_sides_are_those_of_all_variants_that_were_made(self):
        family = box_family()
        self.assertEqual(family.count, 2)
        self.assertEqual((family.mass.low, family.mass.high), (0.4, 0.5))
        sides = [(round(side.low, 9), round(side.high, 9)) for side in family.sides]
        self.assertEqual(sides, [(0.2, 0.3), (0.15, 0.2), (0.1, 0.1)])

    def test_joints_whose_names_differ_in_numbers_are_one(self):
        family = box_family()
        self.assertEqual(list(family.joints), [("slide_#", "slide"), ("turn", "hinge")])
        slide = family.joints["slide_#", "slide"]
        self.assertEqual(slide.names, {"slide_2", "slide_10"})
        self.assertEqual((slide.low.low, slide.low.high, slide.high.low, slide.high.high), (-0.01, 0, 0.05, 0.07))
        self.assertEqual(family.joints["turn", "hinge"].variants, {0})
        self.assertFalse(family.joints["turn", "hinge"].is_limited)
        self.assertEqual(family.grasps, {"grasp_#": {"grasp_1", "grasp_2"}})


class Page(unittest.TestCase):
    def test_measures_stand_beside_those_of_the_product(self):
        product = products.Product("A | B", 0.45, "", [250, 180.5, 100], "maker's data")
        row = {"variants": 400, "physics": 400, "profiled": 300, "simready": 299, "date": "2026-11-27"}
        self.assertEqual(catalogue.measures(box_family(), product, row), [
            "|  | 2 variants | A \\| B (maker's data) |",
            "| --- | --- | --- |",
            "| mass | 400 to 500 g | 450 g |",
            "| sides | 200 to 300 x 150 to 200 x 100 mm | 250 x 180.5 x 100 mm |",
            "| pass the physical checks | 100 % of 400 (2026-11-27) |  |",
            "| pass `--profile simready`, too | 99.6 % of 300 (2026-11-27) |  |",
            ""])

    def test_what_is_not_known_is_left_out(self):
        self.assertEqual(catalogue.measures(box_family(), None, None), [
            "|  | 2 variants |", "| --- | --- |", "| mass | 400 to 500 g |",
            "| sides | 200 to 300 x 150 to 200 x 100 mm |", ""])
        part = products.Product("A", None, "tube", [150, 18], "ISO")
        self.assertEqual(catalogue.measures(box_family(), part, None)[2:4], [
            "| mass | 400 to 500 g |  |", "| sides | 200 to 300 x 150 to 200 x 100 mm | tube: 150 x 18 mm |"])

    def test_joints_are_folded(self):
        lines = catalogue.joints_and_grasps(box_family())
        self.assertIn("<summary>3 joints; grasp sites grasp_1, grasp_2</summary>", lines)
        self.assertIn("| `slide_2`, `slide_10` | slide | -10 .. 0 | 50 .. 70 | mm | all |", lines)
        self.assertIn("| `turn` | hinge | no limit | no limit | deg | 1 of 2 |", lines)
        self.assertEqual(catalogue.joints_and_grasps(families.Family([record(1, [1, 1, 1])], [model()])),
                         ["No joints; no grasp site.", ""])

    def test_of_three_names_the_first_and_the_last_are_told(self):
        hinges = "".join(f'<joint name="box_key_{i}"/>' for i in (10, 9, 1))
        lines = catalogue.joints_and_grasps(families.Family([record(1, [1, 1, 1])], [model(hinges)]))
        self.assertIn("| `key_1` to `key_10` | hinge | no limit | no limit | deg | all |", lines)

    def test_numbers_have_three_digits(self):
        self.assertEqual([catalogue.number(value) for value in (0, 0.0012345, 1.5, 23.456, 1234.5, -0.5)],
                         ["0", "0.00123", "1.5", "23.5", "1234", "-0.5"])

    def test_the_page_says_what_the_tables_say(self):
        chapters = (ROOT / "docs/catalogue.md").read_text(encoding="utf-8").split("\n## ")
        chapters = {chapter.split("\n", 1)[0]: chapter for chapter in chapters}
        for spec, product in products.read().items():
            with self.subTest(spec):
                self.assertTrue(product.name in chapters[spec], "`./dev pictures` makes the page again")
        for spec, row in shares.read().items():
            with self.subTest(spec):
                self.assertTrue(f"% of {row['variants']} ({row['date']})" in chapters[spec])
                self.assertTrue(f"% of {row['profiled']} ({row['date']})" in chapters[spec])


class Products(unittest.TestCase):
    def test_each_product_has_a_bundled_spec_a_measure_and_a_source(self):
        for spec, product in products.read().items():
            with self.subTest(spec):
                self.assertTrue((ROOT / "specs" / f"{spec}.yaml").exists())
                self.assertTrue(product.name and product.source)
                self.assertTrue(product.mass or product.sides)

    def test_a_product_is_outside_where_no_variant_comes_near(self):
        inside = products.Product("A", 0.395, "", [301, 180], "")
        self.assertEqual(products.outside(inside, box_family()), [])
        part = products.Product("A", None, "lid", [900], "")
        self.assertEqual(products.outside(part, box_family()), [])
        self.assertEqual(products.outside(products.Product("A", 0.6, "", [290, 250], ""), box_family()), [
            "A weighs 0.6 kg, variants 0.4 to 0.5 kg", "side 2 of A is 250 mm long, of variants 150 to 200 mm"])

    def test_sides_must_begin_with_the_longest(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "products.csv"
            file.write_text("spec,product,mass,size,source\na/b,A,,10 x 20,maker\n", encoding="utf-8")
            with self.assertRaisesRegex(ValueError, "a/b, '10 x 20', has not its longest side first"):
                products.read(file)


# A block with a lid that is lifted by turning.
CHEST = """mjforge: 1
name: chest
params: {length: 20cm .. 30cm}
parts: [{name: block, type: box, size: [length / 2, 5cm, 4cm], pos: [0, 0, 4cm], density: 500}]
sites: [{name: grasp, pos: [0, 0, 4cm]}]
bodies:
  - name: lid
    pos: [0, 5cm, 8.2cm]
    joints: [{name: lid, axis: [-1, 0, 0], range: [0, 1], damping: 0.01, armature: 1e-3}]
    parts: [{name: lid, type: box, size: [length / 2, 5cm, 5mm], pos: [0, -5cm, 5mm], density: 500}]
"""

# Stands in for mjforge: of three variants one is good, one fails the benchmark, and one a physical check.
PROGRAM = """#!/usr/bin/env python3
import json, pathlib, sys
command, *rest = sys.argv[1:]
if command == "catalogue":
    print(json.dumps([{"name": "a/one"}, {"name": "a/two"}, {"name": "scenes/x"}]))
elif command == "inspect":
    print(json.dumps({"spec_sha256": "0123456789abcdef"}))
elif rest[0] == "a/two" and "--profile" in rest:
    sys.exit(1)
else:
    folder = pathlib.Path(rest[rest.index("-o") + 1])
    folder.mkdir()
    error = lambda code: [{"severity": "error", "code": code}]
    records = [{"status": "ok", "findings": [{"severity": "warning", "code": "physics/friction"}]},
               {"status": "failed", "findings": error("physics/simready")},
               {"status": "failed", "findings": error("physics/topples")}]
    (folder / "manifest.jsonl").write_text("".join(json.dumps(record) + "\\n" for record in records))
"""


class Shares(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "mjforge"
        self.program.write_text(PROGRAM, encoding="utf-8")
        self.program.chmod(0o755)
        self.file = self.folder / "shares.csv"

    def count(self, *arguments):
        """What the command prints."""
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            shares.main([str(self.program), *arguments], self.file)
        return printed.getvalue()

    def rows(self):
        return {spec: (row["variants"], row["physics"], row["profiled"], row["simready"])
                for spec, row in shares.read(self.file).items()}

    def test_what_does_not_run_is_not_counted_as_failed(self):
        self.program.write_text(PROGRAM.replace("sys.exit(1)", "sys.exit(3)"), encoding="utf-8")
        with self.assertRaisesRegex(RuntimeError, "a/two"):
            self.count("3", "a/two")

    def test_errors_of_the_benchmark_are_none_of_the_physical_checks(self):
        printed = self.count("3")
        # Of a/two no variant passes the benchmark, so that nothing is written.
        self.assertEqual(self.rows(), {"a/one": (3, 2, 3, 1), "a/two": (3, 2, 3, 0)})
        self.assertIn("a/one: of 3 variants 2 pass the physical checks, 1 --profile simready", printed)

    def test_physical_checks_alone_leave_the_counts_of_the_profile(self):
        self.count("3", "a/one")
        printed = self.count("--physics", "5")
        self.assertEqual(self.rows(), {"a/one": (5, 2, 3, 1), "a/two": (5, 2, 0, 0)})
        self.assertIn("a/one: of 5 variants 2 pass the physical checks\n", printed)
        self.assertNotIn("a/one:", self.count("3"))
        self.assertEqual(self.rows()["a/two"], (3, 2, 3, 0))

    def test_only_what_is_missing_is_counted(self):
        self.count("3", "a/one")
        self.assertEqual(list(self.rows()), ["a/one"])
        self.assertNotIn("a/one", self.count("3"))
        self.assertIn("a/one", self.count("4"))
        text = self.file.read_text(encoding="utf-8").replace("0123456789ab", "ba9876543210")
        self.file.write_text(text, encoding="utf-8")
        self.assertIn("a/one has changed since it was counted: `./dev shares 3 a/one` counts it again", self.count("3"))


class Program(unittest.TestCase):
    """With mjforge itself."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.spec = pathlib.Path(folder.name) / "chest.yaml"
        self.spec.write_text(CHEST, encoding="utf-8")
        self.program = os.environ["MJFORGE_PROGRAM"]

    def test_a_family_is_what_its_variants_have(self):
        family = families.draw(self.program, str(self.spec), 5)
        self.assertEqual(family.count, 5)
        self.assertTrue(0.2 < family.sides[0].low < family.sides[0].high < 0.3)
        self.assertAlmostEqual(family.mass.high / family.mass.low, family.sides[0].high / family.sides[0].low, places=3)
        lid = family.joints["lid", "hinge"]
        self.assertEqual((len(family.joints), lid.names, len(lid.variants), lid.low.low), (1, {"lid"}, 5, 0))
        self.assertAlmostEqual(lid.high.high, 1)
        self.assertEqual(family.grasps, {"grasp": {"grasp"}})

    def test_variants_are_simulated(self):
        self.assertEqual(shares.count_passed(self.program, str(self.spec), 2), (2, 2))


if __name__ == "__main__":
    unittest.main()
