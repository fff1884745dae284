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

    def write(self, name: str, content: str | bytes) -> Path:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path
