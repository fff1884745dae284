"""The libraries of common call their own functions directly."""
# Builds: lightwalk

import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common" / "course"))

from tree import BUILD  # noqa: E402


def said_by_readelf(option: str, library: Path) -> list[str]:
    return subprocess.run(["readelf", "-W", option, str(library)], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()


class Libraries(unittest.TestCase):
    def test_no_call_of_their_own_goes_through_the_linkage_table(self):
        # Each would be looked up by its name at the program's start, and read from one line of memory more in each frame.
        for library in (BUILD / "liblightwalk.so", BUILD / "liblightwalk_check.so"):
            defined = {line.split()[7] for line in said_by_readelf("--dyn-syms", library)
                       if re.search(r" FUNC +(GLOBAL|WEAK) +DEFAULT +\d+ ", line)}
            called = {found[1] for line in said_by_readelf("-r", library)
                      if (found := re.search(r"JUMP_SLO\S* +\S+ +(\S+)", line))}
            self.assertGreater(len(defined), 500, library.name)
            self.assertGreater(len(called), 50, library.name)
            self.assertEqual(sorted(called & defined), [], library.name)


if __name__ == "__main__":
    unittest.main()
