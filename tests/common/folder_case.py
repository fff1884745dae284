"""Tests that write files."""
import functools
import tempfile
import unittest
from pathlib import Path


class FolderCase(unittest.TestCase):
    @functools.cached_property
    def folder(self) -> Path:
        """The test's own; it goes with the test."""
        return Path(self.enterContext(tempfile.TemporaryDirectory(prefix="lightwalk_")))
