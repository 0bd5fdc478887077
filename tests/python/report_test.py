"""Writing and checking return reports; parameters, settings and findings say what they are about."""

import doctest
import importlib.util
import inspect
import json
import math
import os
import pathlib
import pickle
import sys
import unittest

import mjforge
import mjforge._maker
from in_folder import InFolder

HALF_FAIL = {"mjforge": 1, "name": "m", "params": {"l": {"value": "22cm .. 30cm"}},
             "parts": [{"name": "h", "type": "capsule", "size": ["1cm", "l/2"]}], "expect": ["l < 25cm"]}
ALL_FAIL = {**HALF_FAIL, "expect": ["l < 1cm"]}
EXACT = {"mjforge": 1, "name": "m", "params": {"c": {"choice": ["a", "b", "c", "d"], "exact": True}},
         "parts": [{"name": "h", "type": "sphere", "size": ["1cm"]}]}
KINDS = {"mjforge": 1, "name": "kinds", "params": {
    "width": {"value": "20cm .. 30cm", "unit": "m", "section": "Size", "doc": "Of it."},
    "gauss": {"normal": [0.5, 0.1], "clip": [0.4, 0.6]}, "free": {"normal": [0, 1]}, "count": {"integer": [1, 4]},
    "shape": {"choice": ["box", "disc"]}, "level": {"choice": [1, 3, 2]}, "flag": {"bernoulli": 0.5},
    "size": ["1cm .. 2cm", "3cm", "4cm .. 5cm"], "fixed": 0.25, "twice": "2 * width", "rate": {"exponential": 2}},
    "parts": [{"name": "a", "type": "box", "size": ["size.x", "size.y", "size.z"],
               "if": "flag or shape == 'box' or gauss + free + count + level + fixed + rate > -100 or twice > 0 or true"}]}


class Reports(InFolder):
    def test_failed_variants_are_reported_by_index(self):
        variants = mjforge.Spec(HALF_FAIL).variants(seed=1)
        expected = [i for i in range(20) if not self.makes(variants, i)]
        self.assertTrue(0 < len(expected) < 20)
        report = variants.write("out", 20)
        self.assertEqual((report.count, report.made, report.ok), (20, 20 - len(expected), False))
        self.assertEqual(list(report.failed), expected)
        for index, findings in report.failed.items():
            self.assertEqual({finding.index for finding in findings}, {index})
        self.assertEqual(report.manifest, pathlib.Path("out/manifest.jsonl"))
        checked = mjforge.Spec(HALF_FAIL).check(20, seed=1)
        self.assertEqual((list(checked.failed), checked.made, checked.manifest),
                         (expected, report.made, None))
        self.assertEqual(list(variants[5:15].write("slice", jobs=1).failed), [i for i in expected if 5 <= i < 15])
        skipping = mjforge.Spec(HALF_FAIL).variants(seed=1, on_invalid="skip").write("skip", 20)
        self.assertEqual((skipping.ok, list(skipping.skipped)), (True, expected))

    @staticmethod
    def makes(variants, index):
        try:
            return bool(variants[index])
        except mjforge.VariantError:
            return False

    def test_nothing_made_is_a_report_too(self):
        for output in ("out", "one.xml", "a.tar"):
            report = mjforge.Spec(ALL_FAIL).variants().write(output, 1)
            self.assertEqual((report.ok, report.made, list(report.failed), report.manifest), (False, 0, [0], None))
            self.assertTrue(report.failed[0])
        self.assertEqual(list(mjforge.Spec(ALL_FAIL).check(3).failed), [0, 1, 2])
        self.assertEqual(mjforge.Spec("mug").variants().write("one.xml", 1).made, 1)

    def test_an_earlier_batch_is_not_the_result_of_a_run_that_made_nothing(self):
        for output in ("out", "a.tar", "b.npz"):
            self.assertEqual(mjforge.Spec("primitives/ball").variants().write(output, 3).made, 3)
            report = mjforge.Spec(ALL_FAIL).variants().write(output, 2)
            self.assertEqual((report.ok, report.made, list(report.failed), report.manifest), (False, 0, [0, 1], None))

    def test_variants_that_are_all_skipped_are_not_made(self):
        for output, count in (("out", 2), ("one.xml", 1), ("a.tar", 2), ("b.npz", 2)):
            report = mjforge.Spec(ALL_FAIL).variants(on_invalid="skip").write(output, count)
            self.assertEqual((report.ok, report.made, list(report.skipped), report.manifest),
                             (True, 0, list(range(count)), None))

    def test_findings_beyond_those_that_are_printed_are_no_finding(self):
        many = {**HALF_FAIL, "expect": [f"l < {i}mm" for i in range(1, 60)]}
        report = mjforge.Spec(many).variants().write("out", 3)
        self.assertEqual({finding.code for finding in report.findings}, {"model/expectation"})

    def test_iteration_goes_on_after_a_variant_that_cannot_be_made(self):
        variants = mjforge.Spec(HALF_FAIL).variants(seed=1)
        made, iterator = [], iter(variants)
        for index in range(20):
            try:
                made.append(next(iterator).index)
            except mjforge.VariantError as error:
                self.assertEqual({finding.index for finding in error.findings}, {index})
        self.assertEqual(made, [i for i in range(20) if self.makes(variants, i)])

    def test_iteration_without_end_gives_up_where_none_is_valid(self):
        endless = iter(mjforge.Spec(ALL_FAIL).variants(on_invalid="skip"))
        for first in (0, 1000):
            said = f"none of the 1000 variants from {first} on is valid"
            with self.assertRaisesRegex(mjforge.VariantError, said) as raised:
                next(endless)
            self.assertEqual([finding.index for finding in raised.exception.findings], [None, first])
        self.assertEqual(list(mjforge.Spec(ALL_FAIL).variants(on_invalid="skip")[:1200]), [])

    def test_options_of_variants_are_used(self):
        variants = mjforge.Spec("mug").variants(seed=7, validate="physics")
        report = variants.write("out", 1)
        self.assertEqual(json.loads(report.manifest.read_text())["validate"], "physics")
        report = variants.write("again", 1, validate="none")
        self.assertEqual(json.loads(report.manifest.read_text())["validate"], "none")

    def test_progress_counts_variants(self):
        told = []
        mjforge.Spec("mug").variants().write("out", 12, progress=lambda done, total: told.append((done, total)))
        self.assertEqual(told, [(i, 12) for i in range(1, 13)])
        report = mjforge.Spec("mug").variants().write("shards", 12, shard="1/3", progress=lambda *_: None)
        self.assertEqual((report.made, report.manifest.name), (4, "manifest-00001-of-00003.jsonl"))

    def test_progress_of_a_resume_counts_those_that_are_there(self):
        mugs, told = mjforge.Spec("mug").variants(), []
        mugs.write("out", 4)
        for _ in range(2):
            mugs.write("out", 6, resume=True, progress=lambda done, total: told.append((done, total)))
        self.assertEqual(told, [(4, 6), (5, 6), (6, 6), (6, 6)])

    def test_an_exception_of_progress_stops_and_resume_finishes(self):
        variants = mjforge.Spec("mug").variants(seed=3)

        def stop(done, total):
            if done == 5:
                raise KeyboardInterrupt

        self.assertRaises(KeyboardInterrupt, variants.write, "out", 3000, jobs=1, progress=stop)
        self.assertFalse(os.path.exists("out/manifest.jsonl"))
        self.assertGreater(len(list(pathlib.Path("out").glob("*.xml"))), 4)
        report = variants.write("out", 3000, resume=True, validate="load")
        self.assertEqual((report.made, len(list(pathlib.Path("out").glob("*.xml")))), (3000, 3000))
        self.assertEqual(pathlib.Path("out/mug_000007.xml").read_bytes(), variants[7].xml_bytes)

    def test_batches_that_need_their_size(self):
        hammer = mjforge.Spec("hammer")
        for call in (lambda: hammer.variants(sampler="latin"), lambda: hammer.variants(sampler="grid"),
                     lambda: mjforge.Spec(EXACT).variants()):
            self.assertRaisesRegex(ValueError, "batch is missing: .*batch=N", call)
        variants = mjforge.Spec(EXACT).variants(seed=1, batch=20)
        drawn = [variant.params["c"] for variant in variants[:20]]
        self.assertEqual([drawn.count(c) for c in "abcd"], [5, 5, 5, 5])
        self.assertEqual(self.written(variants, 20, "c"), drawn)
        for sampler in ("latin", "sobol", "random"):
            variants = hammer.variants(seed=1, sampler=sampler, batch=10)
            drawn = [variant.params["handle_length"] for variant in variants[:10]]
            self.assertEqual(self.written(variants, 10, "handle_length"), drawn)
            self.assertEqual(self.written(variants, 5, "handle_length"), drawn[:5])

    def written(self, variants, count, name):
        report = variants.write("batch", count, force=True)
        return [json.loads(line)["params"][name] for line in report.manifest.read_text().splitlines()]

    def test_the_same_mistake_is_the_same_exception(self):
        for wrong, settings in (("hamer", {}), ("mjforge: 1\nname: a\nparts: []\nprats: []\n", {}),
                                ("hammer", {"handle_lenght": 1})):
            raised = []
            for call in (lambda: mjforge.Spec(wrong, set=settings), lambda: mjforge.check(wrong, set=settings)):
                with self.assertRaises(mjforge.SpecError) as error:
                    call()
                raised.append(str(error.exception))
            self.assertEqual(raised[0], raised[1])
        with self.assertRaises(mjforge.SpecError):
            mjforge.Spec("hammer").variants(set={"handle_lenght": 1})

    def test_findings_in_reports_of_mappings_have_keys(self):
        for report in (mjforge.Spec(HALF_FAIL).variants().write("half", 9), mjforge.Spec(ALL_FAIL).check(2),
                       mjforge.Spec(HALF_FAIL).check(9)):
            self.assertEqual({finding.key for finding in report.findings}, {"expect[0]"})
            self.assertTrue(str(report.findings[0]).startswith("expect[0]: error: "))

    def test_texts_of_reports_name_each_variant_and_quote_the_spec(self):
        pathlib.Path("half.yaml").write_text(
            "mjforge: 1\nname: m\nparams: {l: 22cm .. 30cm}\nimport: parts/wood.yaml\n"
            "parts: [{name: h, type: capsule, size: [1cm, l/2], material: wood}]\nexpect: [1 == 1, l < 25cm]\n")
        os.mkdir("parts")
        pathlib.Path("parts/wood.yaml").write_text("mjforge: 1\nmaterials: {wood: {density: 600}}\n")
        spec = mjforge.Spec("half.yaml")
        for report in (mjforge.Spec(spec.text).check(6, seed=1), spec.check(6, seed=1),
                       spec.variants(seed=1).write("half", 6)):
            text = f"{report.made} of 6 variants ok"
            for index, (finding,) in report.failed.items():
                text += (f"\n{finding.file}:6:18: error: {finding.message} (seed 1, index {index}) [model/expectation]"
                         "\nexpect: [1 == 1, l < 25cm]\n                 ^")
            self.assertEqual(str(report), text)
            self.assertTrue(report.failed)
        with self.assertRaises(mjforge.VariantError) as error:
            spec.variants(seed=1)[index]
        self.assertIn(str(error.exception), text)

    def test_texts_of_findings_of_mappings_name_the_variant(self):
        for call in (lambda: mjforge.Spec(ALL_FAIL).variants(seed=3)[5], lambda: next(iter(
                mjforge.Spec(ALL_FAIL).variants(seed=3)[5:6]))):
            with self.assertRaisesRegex(mjforge.VariantError, r"^expect\[0\]: error: .* \(seed 3, index 5\) \[model/exp"):
                call()
        finding = mjforge.Spec(ALL_FAIL).check(1).findings[0]
        self.assertRegex(repr(finding), r"^<mjforge.Finding \"expect\[0\]: error: .* \(seed 0, index 0\) \[model/exp")

    def test_excerpts_are_those_of_the_command(self):
        for line, excerpt in (("expect: ['l < 1']", "expect: ['l < 1']\n         ^"),
                              ("\t漢é: ['l < 1']", " 漢é: ['l < 1']\n       ^"),
                              ("x" * 100 + "'" + "y" * 200, f"...{47 * 'x'}"), (9 * " ", None)):
            column = 1 + len(line.partition("'")[0].encode())
            members = {"file": "a.yaml", "line": 2, "column": column, "severity": "error", "message": "m", "code": "c",
                       "notes": [{"message": "n", "file": "a.yaml", "line": 1, "column": 1}]}
            texts = {"/x/a.yaml": f"name: a\n{line}\n", "/x/aa.yaml": ""}
            text = mjforge.Finding(members).set_texts(texts).text
            first, *quoted = text.split("\n")
            self.assertEqual(first, f"a.yaml:2:{column}: error: m [c]")
            self.assertEqual(quoted[-3:], ["a.yaml:1:1: note: n", "name: a", "^"])
            if excerpt is None or excerpt.startswith("..."):
                self.assertEqual(len(quoted), 3 if excerpt is None else 5)
                self.assertTrue(excerpt is None or len(quoted[0]) == 120 and quoted[0][quoted[1].index("^")] == "'")
            else:
                self.assertEqual("\n".join(quoted[:2]), excerpt)
            texts["/y/a.yaml"] = texts["/x/a.yaml"]  # the name of two files
            self.assertEqual(mjforge.Finding(members).set_texts(texts).text, f"{first}\na.yaml:1:1: note: n")

    def test_findings_of_mappings_have_keys(self):
        wrong = {"mjforge": 1, "name": "m", "parts": [{"name": "a", "type": "box", "size": [1, 1, 1]},
                                                     {"name": "b", "type": "capsul", "size": [1, "x +"]}]}
        with self.assertRaises(mjforge.SpecError) as error:
            mjforge.Spec(wrong)
        keys = [finding.key for finding in error.exception.findings]
        self.assertEqual(keys, ["parts[1].type", "parts[1].size[1]"])
        self.assertTrue(str(error.exception).startswith("parts[1].type: error: 'capsul' is not one of box"))
        self.assertEqual([f.key for f in pickle.loads(pickle.dumps(error.exception.findings))], keys)
        with self.assertRaises(mjforge.VariantError) as error:
            mjforge.Spec(ALL_FAIL).variants()[0]
        self.assertEqual(error.exception.findings[0].key, "expect[0]")
        with self.assertRaises(mjforge.SpecError) as error:
            mjforge.Spec("mjforge: 1\nname: m\nparts: 5\n")
        self.assertIsNone(error.exception.findings[0].key)


class Parameters(InFolder):
    def test_of_whole_numbers_take_pairs_as_ranges_of_whole_numbers(self):
        spec = mjforge.Spec(KINDS)
        self.assertEqual(spec.parameters["count"].range, (1, 4))
        fixed = mjforge.Spec(KINDS, set={"count": 3})
        pathlib.Path("fixed.yaml").write_text("count: 3\n")
        filed = mjforge.Spec(KINDS, parameters=["fixed.yaml"])
        for variants in (spec.variants(set={"count": (2, 3)}), mjforge.Spec(KINDS, set={"count": (2, 3)}).variants(),
                         fixed.variants(set={"count": (2, 3)}), filed.variants(set={"count": (2, 3)}),
                         spec.variants(set={"count": [2.0, 3]})):
            self.assertEqual({variant.params["count"] for variant in variants[:8]}, {2, 3})
        blender = mjforge.Spec("appliances/blender")
        self.assertTrue(blender.variants(set={"keys": blender.parameters["keys"].range})[1])

    def test_of_vectors_take_pairs_for_their_components(self):
        pair = {"integer": [1, 9]}
        spec = mjforge.Spec({**KINDS, "params": {**KINDS["params"], "grid": [pair, "1 .. 9", {"poisson": 3}, 4]}})
        self.assertEqual(spec.parameters["grid"].distributions, ("integer", "uniform", "poisson", None))
        self.assertEqual(spec.parameters["count"].distributions, ())
        settings = [[(2, 3), (2, 3), (2, 3), (2, 3)]]
        if importlib.util.find_spec("numpy"):
            import numpy

            ends = numpy.array([2, 3])
            settings += [4 * [tuple(ends)], 4 * [ends], numpy.array(4 * [ends]),
                         (ends, list(ends.astype(numpy.longdouble)), ends.astype(float), ends.astype(numpy.longdouble))]
        for setting in settings:
            drawn = [v.params["grid"] for v in spec.variants(set={"grid": setting})[:20]]
            whole, real, counts, fixed = (set(numbers) for numbers in zip(*drawn))
            self.assertEqual((whole, counts), ({2, 3}, {2, 3}))
            self.assertTrue(len(real) == len(fixed) == 20 and all(2 <= n <= 3 for n in real | fixed))

    def test_of_text_take_choices_that_are_names_of_parameters(self):
        spec = mjforge.Spec({**KINDS, "params": {**KINDS["params"], "t": {"choice": ["rate", "shape"]}},
                             "parts": [{**KINDS["parts"][0], "name": "b"}, {
                                 "name": "a", "type": "sphere", "size": [1], "if": "t == 'rate'"}]})
        for name in ("rate", "shape", "'rate'"):
            for variants in (spec.variants(set={"t": name}), mjforge.Spec(spec.text, set={"t": name}).variants()):
                self.assertEqual(variants[0].params["t"], name.strip("'"))
        self.assertEqual(spec.variants(set={"shape": "disc"}).spec.settings, {"shape": "disc"})

    def test_of_text_take_choices_that_look_like_other_values(self):
        choices = ("8", "-1.5", "1e3", "0x1f", "true", "null", "False", "no", "M10", "a-b")
        spec = mjforge.Spec({**KINDS, "params": {**KINDS["params"], "grade": {"choice": [*choices]},
                                                 "sizes": {"choice": [["8", "x"], ["9", "y"]]}}})
        self.assertEqual(spec.parameters["grade"].choices, choices)
        for choice in choices:
            variants = spec.variants(set={"grade": choice})
            variant = mjforge.Spec(spec.text, set={"grade": choice}).variants()[0]
            self.assertEqual((variants[0].params["grade"], variant.params["grade"]), (choice, choice))
            self.assertEqual(mjforge.Variant.from_record(variant.record, spec.text), variant)
            self.assertTrue(variants.write(self.folder / "out", 1).ok)
            self.assertEqual(mjforge.Batch(self.folder / "out")[0].xml, variants[0].xml)
        for choice in spec.parameters["sizes"].choices:
            self.assertEqual(spec.variants(set={"sizes": choice})[0].params["sizes"], [*choice])
        for value, drawn in (("2 * 0.3", 0.6), ("25cm", 0.25), ("0.5", 0.5)):
            self.assertEqual(spec.variants(set={"rate": value})[0].params["rate"], drawn)

    def test_say_what_may_be_drawn(self):
        known = mjforge.Spec(KINDS).parameters
        self.assertEqual(list(known), list(KINDS["params"]))
        width = known["width"]
        self.assertEqual((width.unit, width.section, width.doc, width.default, width.distribution, width.range),
                         ("m", "Size", "Of it.", "20cm .. 30cm", "uniform", (0.2, 0.3)))
        self.assertEqual({name: known[name].range for name in known if name != "width"}, {
            "gauss": (0.4, 0.6), "free": (-math.inf, math.inf), "count": (1, 4), "shape": None, "level": (1, 3),
            "flag": None, "size": ((0.01, 0.03, 0.04), (0.02, 0.03, 0.05)), "fixed": (0.25, 0.25), "twice": None,
            "rate": (0, math.inf)})
        self.assertEqual((known["shape"].choices, known["shape"].type), (("box", "disc"), "text"))
        self.assertEqual((known["level"].choices, known["fixed"].choices), ((1, 3, 2), None))
        self.assertEqual((known["flag"].type, known["flag"].distribution), ("boolean", "bernoulli"))
        self.assertEqual(known["size"].components, 3)
        for variant in mjforge.Spec("hammer").variants()[:50]:
            for name, value in variant.params.items():
                parameter = mjforge.Spec("hammer").parameters[name] if variant.index == 0 else None
                if parameter and parameter.range and parameter.components == 1:
                    self.assertTrue(parameter.low <= value <= parameter.high, name)

    def test_that_are_lists_or_choices_of_vectors_have_no_range(self):
        spec = mjforge.Spec({**KINDS, "params": {**KINDS["params"], "list": {"each": "1 .. 2", "count": 3},
                                                 "pair": {"choice": [[1, 2], [3, 4]]}}})
        known = spec.parameters
        self.assertEqual([(known[name].range, known[name].components) for name in ("list", "pair")],
                         [(None, 0), (None, 2)])
        self.assertEqual(spec.variants(set={"list": (3, 4)})[0].params["list"], [3, 4])
        drawn = spec.variants(set={"list": {"each": "3 .. 4", "count": 5}})[0].params["list"]
        self.assertTrue(len(drawn) == 5 and all(3 < number < 4 for number in drawn))

    def test_can_be_set_without_reading_the_spec_again(self):
        spec = mjforge.Spec("hammer")
        for value in ((0.2, 0.21), [0.2, 0.21], "20cm .. 21cm"):
            for variants in (spec.variants(set={"handle_length": value}),
                             mjforge.Spec("hammer", set={"handle_length": value}).variants()):
                for variant in variants[:10]:
                    self.assertTrue(0.2 <= variant.params["handle_length"] <= 0.21)
                self.assertEqual(variants.spec.parameters["handle_length"].range, (0.2, 0.21))
        self.assertEqual((spec.settings, spec.parameters["handle_length"].range), ({}, (0.26, 0.31)))
        kinds = mjforge.Spec(KINDS).variants(set={"size": (0.01, (0.02, 0.03), 0.04), "fixed": 7})[0].params
        self.assertEqual((kinds["size"][0], kinds["size"][2], kinds["fixed"]), (0.01, 0.04, 7))
        self.assertTrue(0.02 <= kinds["size"][1] <= 0.03)
        twice = spec.variants(set={"handle_length": 0.2}).spec.variants(set={"handle_shape": "tubular"})[0]
        self.assertEqual((twice.params["handle_length"], twice.params["handle_shape"]), (0.2, "tubular"))

    def test_catalogue_describes_its_specs(self):
        entries = mjforge.catalogue()
        self.assertIn("tools/hammer", entries)
        hammer = entries[entries.index("tools/hammer")]
        self.assertIn("hammer", hammer.description)
        self.assertTrue(pathlib.Path(hammer.path).is_file())
        self.assertEqual(mjforge.Spec(hammer).name, "hammer")
        self.assertEqual(pickle.loads(pickle.dumps(hammer)).path, hammer.path)


class Docstrings(unittest.TestCase):
    def test_their_examples_are_true(self):
        modules = [mjforge] + [module for name, module in sys.modules.items() if name.startswith("mjforge.")]
        tried = 0
        for module in modules:
            result = doctest.testmod(module, optionflags=doctest.ELLIPSIS)
            self.assertEqual(result.failed, 0, module.__name__)
            tried += result.attempted
        self.assertGreater(tried, 30)

    def test_all_that_is_public_has_one(self):
        missing = [f"{name}.{member}" for name in mjforge.__all__ for member, value in vars(getattr(mjforge, name)).items()
                   if inspect.isclass(getattr(mjforge, name)) and not member.startswith("_")
                   and (inspect.isfunction(value) or isinstance(value, property)) and not inspect.getdoc(value)]
        self.assertEqual(missing, [])
        self.assertEqual([name for name in mjforge.__all__ if not inspect.getdoc(getattr(mjforge, name))], [])


if __name__ == "__main__":
    unittest.main()
