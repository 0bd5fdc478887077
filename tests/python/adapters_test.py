"""Families in other engines: what is refused before the engine is needed, and without it."""

import sys
import unittest
import unittest.mock

from mjforge import Family, _to_mjx, _to_newton


class Adapters(unittest.TestCase):
    def refused(self, error, message, action, *arguments, **options):
        with self.assertRaises(error) as caught:
            action(*arguments, **options)
        self.assertEqual(str(caught.exception), message)

    def setUp(self):
        without = dict.fromkeys(["mujoco.mjx", "mjlab.entity", "newton"])
        patch = unittest.mock.patch.dict(sys.modules, without)  # None: cannot be imported
        patch.start()
        self.addCleanup(patch.stop)
        self.family = Family.__new__(Family)

    def test_give_variants_at_the_start_or_at_resets(self):
        self.refused(ValueError, "mode='interval' is not 'startup' or 'reset'",
                     self.family.to_mjlab, "hammer", mode="interval")

    def test_need_the_name_of_an_entity(self):
        self.refused(TypeError, "name=3 is not a text but of type int", self.family.to_mjlab, 3)

    def test_say_which_package_they_need(self):
        self.refused(ImportError, "this needs mjlab.entity: python -m pip install mjlab",
                     self.family.to_mjlab, "hammer")
        self.refused(ImportError, "this needs newton: python -m pip install 'newton[sim]'",
                     _to_newton.add_worlds, self.family, None, None, {})
        self.refused(ImportError, "this needs mujoco.mjx: python -m pip install mujoco-mjx",
                     _to_mjx.replacements, None, {})


if __name__ == "__main__":
    unittest.main()
