"""A wrong argument is a TypeError or a ValueError that names it, never a crash of the interpreter."""

import collections.abc
import enum
import functools
import inspect
import pathlib
import random
import typing
import unittest

import mjforge
from in_folder import InFolder
from mjforge import _command, _options, _picture, _table

TEXTS = ("validate", "target", "assets", "name", "sampler", "on_invalid")
NUMBERS = ("seed", "batch")
SPEC = mjforge.Spec("hammer")


class Arguments(InFolder):
    def test_options_that_are_not_texts(self):
        spec = mjforge.Spec("hammer")
        for option in TEXTS:
            for wrong in (True, False, None, 0, 5, 2.5, b"mjx", pathlib.Path("mjx"), ["mjx"], object()):
                known = ", ".join(_options.WORDS.get(option, ())) or "a text"
                with self.assertRaisesRegex(TypeError, f"{option}=.* is not .*{known},? but of type",
                                            msg=f"{option}={wrong}"):
                    spec.variants(**{option: wrong})
            with self.assertRaisesRegex(ValueError, f"{option}=.*zero character"):
                spec.variants(**{option: "mjx\0"})
            with self.assertRaises(ValueError):
                spec.variants(**{option: "\ud800"})

    def test_options_that_are_not_integers(self):
        spec = mjforge.Spec("hammer")
        for option in NUMBERS:
            for wrong in (True, 2.0, "7", b"7", [7]):
                with self.assertRaisesRegex(TypeError, f"{option}=.* is not an integer"):
                    spec.variants(**{option: wrong})
            for wrong in (-1, 2**64):
                with self.assertRaisesRegex(ValueError, f"{option}={wrong} is not within"):
                    spec.variants(**{option: wrong})
        self.assertRaises(TypeError, spec.variants, seed=None)
        with self.assertRaisesRegex(ValueError, "batch=0 is not within 1"):
            spec.variants(batch=0)
        self.assertRaises(TypeError, spec.variants, place_seed="7")
        self.assertRaises(ValueError, spec.variants, place_seed=-1)
        self.assertEqual(spec.variants(seed=2**64 - 1)[0].seed, 2**64 - 1)

    def test_specs_and_settings(self):
        for wrong in (None, True, 5, b"hammer", ["hammer"], object()):
            self.assertRaises(TypeError, mjforge.Spec, wrong)
        loop = {"mjforge": 1}
        loop["parts"] = [loop]
        self.assertRaisesRegex(ValueError, "spec: .*contains itself", mjforge.Spec, loop)
        for wrong, kind in ((float("nan"), ValueError), (object(), TypeError), (b"x", TypeError), ({5: 1}, TypeError)):
            with self.assertRaisesRegex(kind, r"^spec: parts\[0\]\.size\[1\]"):
                mjforge.Spec({"mjforge": 1, "parts": [{"size": [0.1, wrong]}]})
        for wrong in (5, True, "a=1", [("handle_length", 1)]):
            self.assertRaises(TypeError, mjforge.Spec, "hammer", set=wrong)
        for wrong in ({5: 1}, {None: 1}, {b"handle_length": 1}, {"handle_length": object()}):
            self.assertRaises(TypeError, mjforge.Spec, "hammer", set=wrong)
        for wrong in ("x.yaml", pathlib.Path("x.yaml"), [5], [None], [b"x.yaml"], 5):
            self.assertRaises(TypeError, mjforge.Spec, "hammer", parameters=wrong)
        with self.assertRaises(AttributeError):
            SPEC.settings = {"handle_length": 5}
        with self.assertRaises(TypeError):
            SPEC.settings["handle_length"] = 5

    def test_indices(self):
        variants = mjforge.Spec("hammer").variants()
        for wrong in ("a", None, 1.0, b"a", slice(0, "a"), slice("a", 3), slice(0, 3, "a"), slice(0, 2.0)):
            self.assertRaises(TypeError, variants.__getitem__, wrong)
        for wrong in (-1, 2**64):
            self.assertRaisesRegex(IndexError, f"index={wrong} is not within", variants.__getitem__, wrong)
        # C would take it for index 0.
        self.assertRaises(IndexError, variants[2**64:2**64 + 1].__getitem__, 0)

    def test_slices_are_sequences(self):
        some = SPEC.variants()[:10]
        self.assertIsInstance(some, collections.abc.Sequence)
        self.assertEqual(len({variant.index for variant in random.sample(some, 3)}), 3)
        self.assertEqual([variant.index for variant in reversed(some[:3])], [2, 1, 0])

    def test_numbers_that_refuse_to_be_converted(self):
        class Several:
            def __index__(self):
                raise TypeError("only one number can be an index")

            __float__ = __index__

        variants = SPEC.variants()
        self.assertRaisesRegex(TypeError, "seed=.* is not an integer", SPEC.variants, seed=Several())
        self.assertRaisesRegex(TypeError, "index=.* is not an integer", variants.__getitem__, Several())
        self.assertRaisesRegex(TypeError, "time_limit=.* is not a number", variants.write, "x", 1, time_limit=Several())
        self.assertRaisesRegex(ValueError, "time_limit", variants.write, "x", 1, time_limit=10**400)
        self.assertRaisesRegex(TypeError, "mujoco=5 is not a module", variants[0].load, 5)

    def test_every_option_names_its_words(self):
        with self.assertRaisesRegex(ValueError, "target='robosuit' is not one of mujoco, scene, .*; "
                                    "did you mean 'robosuite'"):
            SPEC.variants(target="robosuit")
        for option, words in _options.WORDS.items():
            is_written = option in ("durability", "layout")
            call = SPEC.variants().write if is_written else SPEC.variants
            arguments = ("unused", 1) if is_written else ()
            with self.assertRaisesRegex(ValueError, f"{option}='{words[0]}x' is not one of .*{words[-1]}.*; "
                                        f"did you mean '{words[0]}'"):
                call(*arguments, **{option: words[0] + "x"})

    def test_texts_are_the_values_of_enumerations(self):
        class Word(str, enum.Enum):
            SPEC, TARGET, NAME, OUTPUT = "hammer", "mjx", "tool", "out"
            PARAMETER, VALUE, SHAPE, OPTION, LAYER = "handle_length", "25cm", "handle_shape", "fibreglass", "joints"
            KEY, MEMBER = "mjforge", "mass"

        class Number(enum.IntEnum):
            SEED, COUNT = 7, 2

        settings = {Word.PARAMETER: Word.VALUE, Word.SHAPE: Word.OPTION}
        spec = mjforge.Spec(Word.SPEC, set=settings)
        self.assertEqual(repr(spec), "<mjforge.Spec hammer (handle_length=25cm, handle_shape=fibreglass)>")
        variants = mjforge.Spec(Word.SPEC).variants(target=Word.TARGET, name=Word.NAME, set=settings,
                                                    seed=Number.SEED)
        self.assertEqual(repr(variants), "<mjforge.Variants of hammer (handle_length=25cm, handle_shape=fibreglass), "
                         "seed 7, target mjx, name tool>")
        self.assertTrue(variants.write(Word.OUTPUT, Number.COUNT).ok)
        self.assertEqual(mjforge.Batch(Word.OUTPUT)[1].xml, variants[1].xml)
        self.assertEqual(_picture._layer_of(Word.LAYER) + _picture._joints_of({Word.NAME: 1})[1], "jointstool=1.0")
        self.assertEqual([*map(str, _table._members_of([Word.MEMBER]))], ["mass"])
        with self.assertRaises(mjforge.SpecError) as raised:
            mjforge.Spec({Word.KEY: 1, "name": "a", Word.NAME: 1, "parts": [{Word.MEMBER: "x"}]})
        self.assertLessEqual({"tool", "parts[0]"}, {finding.key for finding in raised.exception.findings})

    def test_types_have_the_words_of_the_library(self):
        types = {"target": _options.Target, "assets": _options.Assets, "sampler": _options.Sampler,
                 "on_invalid": _options.OnInvalid, "validate": _options.Validate,
                 "durability": _options.Durability, "layout": _options.Layout}
        self.assertEqual({name: list(typing.get_args(each)) for name, each in types.items()}, _options.WORDS)

    def test_options_of_write(self):
        write = SPEC.variants().write
        for count in (0, -1, 2**63, 2**64):
            for call in (lambda count: write("unused", count), SPEC.check):
                with self.assertRaisesRegex(ValueError, rf"count={count} is not within 1 \.\. 2\^63 - 1"):
                    call(count)
        with self.assertRaisesRegex(ValueError, "count=9223372036854775808 is not within"):
            SPEC.variants()[1:2**63 + 1].write("unused")
        for count in (None, True, 1.5, "3", [3]):
            with self.assertRaisesRegex(TypeError, f"count={count!r} is not an integer".replace("[", r"\[")):
                write("unused", count)
        with self.assertRaisesRegex(ValueError, "output='-'"):
            write("-", 1)
        with self.assertRaisesRegex(TypeError, "jbs"):
            write("unused", 1, jbs=2)
        with self.assertRaisesRegex(ValueError, "x.xml takes one variant"):
            write("x.xml", 2)
        with self.assertRaisesRegex(ValueError, "shard"):
            write("unused", 2, shard="2/2")

    def test_options_of_write_that_do_not_fit_together(self):
        variants = SPEC.variants()
        shard = "is not of the form 'I/N', such as '0/4', N up to 99999"
        for options, message in (
                ({"shard": "x"}, f"shard='x' {shard}"), ({"shard": "0/0"}, f"shard='0/0' {shard}"),
                ({"shard": "0/100000"}, f"shard='0/100000' {shard}"), ({"shard": "-1/2"}, f"shard='-1/2' {shard}"),
                ({"shard": "2/2"}, "shard='2/2': shards count from 0, so that the last one is '1/2'"),
                ({"first": 2**64 - 1}, f"first={2**64 - 1} and count=2 go beyond the largest index, 2^64 - 2"),
                ({"verify": True}, "verify=True is for resume=True; Batch(...).verify() compares the files of a batch"),
                ({"mocap": True}, "mocap=True is for families, such as output='NAME.npz', not for output='unused'"),
                ({"pad": True}, "pad=True is for families, such as output='NAME.npz', not for output='unused'"),
                ({"per_archive": 3}, "per_archive=3 is for a series of archives, such as output='NAME_%05d.tar', not "
                                     "for output='unused'")):
            with self.assertRaises(ValueError) as raised:
                variants.write("unused", 2, **options)
            self.assertEqual(str(raised.exception), message)
        for output in ("x.tar", "%d.tar/x", "x%s.tar", "x.npz", "x.xml"):
            self.assertRaisesRegex(ValueError, "^per_archive=3 is for", variants.write, output, 1, per_archive=3)
        for output in ("%d.tar", "a/x_%05d.tar.zst"):
            self.assertTrue(variants.write(output, 2, per_archive=1, first=2**64 - 3, shard="0/1").ok)
        with self.assertRaises(ValueError) as raised:
            variants.write("x.xml", 2)
        self.assertEqual(str(raised.exception), "-o x.xml takes one variant, -n asks for 2")

    def test_slices_that_are_written(self):
        variants = SPEC.variants()
        for some in (variants[0:0], variants[5:5:2], variants[5:9][9:]):
            with self.assertRaisesRegex(ValueError, r"^the slice range\(.*\) is empty, so it cannot be written"):
                some.write("unused")
        for some in (variants[5:9:2], variants[5:9][::-1]):
            with self.assertRaisesRegex(ValueError, r"^variants range\(.*\) are not consecutive"):
                some.write("unused")
        for some in (variants[5:6:7], variants[5:9:7], variants[5:9][0::-1], variants[3:9][2:3]):
            some.write("one")
            self.assertEqual([record["index"] for record in mjforge.Batch("one").records()], [5])

    def test_numbers_of_processes(self):
        for jobs in (-1, 0, 1025, 2**64):
            for call in (functools.partial(SPEC.variants().write, "unused", 1), functools.partial(SPEC.check, 1),
                         functools.partial(mjforge.prove, "unused")):
                with self.assertRaisesRegex(ValueError, rf"jobs={jobs} is not within 1 \.\. 1024$"):
                    call(jobs=jobs)
        with self.assertRaisesRegex(ValueError, f"is not a number of processes from 1 to {_options.MAX_JOBS}"):
            _command.run(["check", "--jobs=1025", "--", "hammer"], b"")

    def test_no_argument_of_any_type_crashes(self):
        variants = SPEC.variants()
        functions = {mjforge.Spec: {}, SPEC.variants: {}, SPEC.check: {}, mjforge.prove: {}, mjforge.check: {},
                     variants.write: {"count": 1}, variants.__getitem__: {}, variants[:2].write: {},
                     variants[0].load: {}, variants[0].verify: {}, variants[0].save: {}, mjforge.Batch: {},
                     mjforge.load_family: {}, mjforge.Picture(b"").save: {}}
        wrong = [None, True, False, 0, -1, 7, 2**80, 1.5, float("nan"), "", "nothing", "a\0b", "\ud800", b"mjx",
                 b"\xff", [], [5], (), (None,), {}, {"a": object()}, {5: 5}, set(), object(), type, len,
                 pathlib.Path("no/such"), slice(0, 1), 1j, range(3), Exception("x")]
        tried = 0
        for function, given in functions.items():
            names = inspect.signature(function).parameters
            for name, parameter in names.items():
                for value in wrong:
                    arguments = {"output": "out", **given} if "output" in names else dict(given)
                    if parameter.kind is inspect.Parameter.POSITIONAL_ONLY:
                        call = functools.partial(function, value)
                    elif function in (mjforge.Spec, mjforge.check) and name != "spec":
                        call = functools.partial(function, "mug", **{**arguments, name: value})
                    elif function == mjforge.prove and name != "batch":
                        call = functools.partial(function, "no/such", **{name: value})
                    else:
                        call = functools.partial(function, **{**arguments, name: value})
                    tried += 1
                    try:
                        call()
                    except (TypeError, ValueError, IndexError, OSError, ImportError) as error:
                        self.assertTrue(str(error), (function, name, value))
                        # A function in `progress` raises what it likes.
                        if isinstance(error, TypeError) and name != "key" and not (
                                name == "progress" and callable(value)):
                            self.assertIn(name, str(error))
        self.assertGreater(tried, 1000)


if __name__ == "__main__":
    unittest.main()
