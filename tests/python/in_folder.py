"""Test cases that work in an empty folder."""

import os
import pathlib
import tempfile
import unittest


class InFolder(unittest.TestCase):
    """The working folder of a test is empty, and is `self.folder`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        self.folder = pathlib.Path(folder.name)
