"""Runs a test in Python, all of its cases or those that are named:

    python3 tests/run.py tests/common/test_live.py [Pictures.test_ten_tabs_are_all_answered ...]

Tests import their neighbours, tests/common, common/course and the parts of the conformance set by name.
"""

import importlib
import sys
import unittest
from pathlib import Path

if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    script, root = Path(sys.argv.pop(1)).resolve(), Path(__file__).resolve().parents[1]
    sys.path[:1] = [str(folder) for folder in (script.parent, root / "tests/common", root / "common/course", root / "assets/conformance")]
    unittest.main(importlib.import_module(script.stem))
