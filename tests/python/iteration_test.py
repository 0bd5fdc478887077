"""Iterations over variants: the order, what is made ahead, errors, signals and threads."""

import concurrent.futures
import itertools
import os
import signal
import time
import types
import unittest

import mjforge

BALL = {"mjforge": 1, "name": "ball", "parts": [{"name": "ball", "type": "sphere", "size": 0.02}]}
SOMETIMES = {**BALL, "params": {"i": {"cycle": [1, 2, 3]}}, "expect": ["i < 3"]}


class Iteration(unittest.TestCase):
    """Iteration makes some variants ahead."""

    def test_gives_the_variants_that_indices_give(self):
        for name in ("hammer", "mug"):
            variants = mjforge.Spec(name).variants(seed=3)[5:80:2]
            ahead = [(v.xml_bytes, v.record_bytes, v.index) for v in variants]
            alone = [variants[i] for i in range(len(variants))]
            self.assertEqual(ahead, [(v.xml_bytes, v.record_bytes, v.index) for v in alone])

    def made_after(self, variants, asked):
        """The number of variants that are made until so many are asked for."""
        indices = []
        make = variants._makers[0].make
        spy = types.SimpleNamespace(make=lambda index: indices.append(index) or make(index))
        variants._makers[:] = [spy]
        for _ in zip(range(asked), variants):
            pass
        self.assertEqual(indices, list(range(len(indices))))
        return len(indices)

    def test_makes_at_most_as_many_ahead_as_were_asked_for(self):
        variants = mjforge.Spec(BALL).variants()
        self.assertEqual(self.made_after(variants, 1), 1)
        for asked in (2, 5, 20, 300):
            variants = mjforge.Spec(BALL).variants()
            self.assertLess(self.made_after(variants, asked), min(2 * asked, asked + 32) + 1)

    def test_makes_none_ahead_that_takes_long(self):
        variants = mjforge.Spec(BALL).variants()
        make = variants._makers[0].make

        def slow(index):
            end = time.thread_time() + 0.01
            while time.thread_time() < end:
                pass
            return make(index)

        variants._makers[:] = [types.SimpleNamespace(make=slow)]
        self.assertEqual(self.made_after(variants, 20), 20)

    def test_gives_all_before_one_that_fails(self):
        variants = mjforge.Spec(SOMETIMES).variants()
        failing = next(i for i in range(30) if self.fails(variants, i))
        given = []
        with self.assertRaises(mjforge.VariantError) as raised:
            for variant in variants:
                given.append(variant.index)
        self.assertEqual(given, list(range(failing)))
        with self.assertRaises(mjforge.VariantError) as alone:
            variants[failing]
        self.assertEqual(str(raised.exception), str(alone.exception))

    @staticmethod
    def fails(variants, index):
        try:
            variants[index]
        except mjforge.VariantError:
            return True
        return False

    def test_leaves_out_what_fails_where_it_is_skipped(self):
        variants = mjforge.Spec(SOMETIMES).variants(on_invalid="skip")[:30]
        given = [v.index for v in variants]
        self.assertEqual(given, [i for i in range(30) if not self.fails(variants, i)])
        self.assertEqual(len(given), 20)

    def test_ends_at_once_with_ctrl_c(self):
        variants = mjforge.Spec(BALL).variants()
        make = variants._makers[0].make

        def interrupted(index):
            if index == 11:
                raise KeyboardInterrupt
            return make(index)

        variants._makers[:] = [types.SimpleNamespace(make=interrupted)]
        with self.assertRaises(KeyboardInterrupt):
            for variant in variants:
                self.assertLess(variant.index, 11)
        self.assertEqual(len(variants._makers), 1)

    def test_loses_no_variant_by_an_exception_of_a_signal(self):
        for error in (RuntimeError, KeyboardInterrupt, TimeoutError):
            variants = mjforge.Spec(SOMETIMES).variants(on_invalid="skip")[:200]
            wanted, calls = [v.index for v in variants], []
            make = variants._makers[0].make

            def interrupted(index):
                calls.append(index)
                if len(calls) % 7 == 0:
                    raise error
                return make(index)

            variants._makers[:] = [types.SimpleNamespace(make=interrupted)]
            given, iterator = [], iter(variants)
            while len(given) < len(wanted):
                before = len(calls) // 7
                try:
                    given.append(next(iterator).index)
                except error:
                    self.assertEqual(len(calls) // 7, before + 1)  # in the call that it interrupts
            self.assertEqual(given, wanted)
            self.assertEqual(list(iterator), [])
            self.assertLess(len(calls), 2 * 200)  # variants that were made ahead are kept

    def test_loses_no_variant_by_an_exception_at_any_time(self):
        class Alarm(Exception):
            pass

        def ring(*_):
            raise Alarm

        given, iterator = [], iter(mjforge.Spec(BALL).variants())
        before = signal.signal(signal.SIGALRM, ring)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.001, 0.001)
            while len(given) < 5000:
                try:
                    given.extend(itertools.islice(iterator, 5000))  # keeps what came before an exception
                except Alarm:
                    pass
        except Alarm:  # between two calls of `extend`
            pass
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        self.assertEqual([v.index for v in given], list(range(len(given))))

    def test_shares_variants_with_indices_iterations_threads_and_forks(self):
        variants = mjforge.Spec("hammer").variants(seed=7)
        alone = [v.xml for v in variants[:40]]
        one, other = iter(variants[:40]), iter(variants[:40])
        for index, (first, second) in enumerate(zip(one, other)):
            self.assertEqual([first.xml, second.xml, variants[index].xml], 3 * [alone[index]])
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for made in pool.map(lambda _: [v.xml for v in variants[:40]], range(4)):
                self.assertEqual(made, alone)
        begun = iter(variants[:40])
        for _ in range(10):
            next(begun)
        child = os.fork()
        if child == 0:
            os._exit(0 if [v.xml for v in begun] == alone[10:] else 1)
        self.assertEqual([v.xml for v in begun], alone[10:])
        self.assertEqual(os.waitpid(child, 0)[1], 0)


if __name__ == "__main__":
    unittest.main()
