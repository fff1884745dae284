"""Tests of the CI's sampling of cases in ./course test: with each commit another part, in the end all of them, and never none."""
# Builds: nothing

import hashlib
import itertools
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

from part_in_ci import part

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from test.run_tests import SHARE, TURNS, chosen  # noqa: E402

CASES = list("abcdefghij")


def at(commit: str, of: int, cases=CASES) -> list:
    with mock.patch("part_in_ci.in_part", return_value=True), \
            mock.patch.object(subprocess, "run", return_value=mock.Mock(stdout=commit + "\n")):
        return part(cases, of)


class Part(unittest.TestCase):
    def test_commits_in_a_row_try_all_cases(self):
        parts = [at(f"{0xc0ffee + i:040x}", 3) for i in range(3)]
        self.assertEqual(sorted(sum(parts, [])), CASES)
        self.assertEqual(sorted(map(len, parts)), [3, 3, 4])
        self.assertEqual(parts[0], at(f"{0xc0ffee:040x}", 3), "the same commit tries the same")

    def test_never_none(self):
        for i in range(8):
            self.assertEqual(len(at(f"{i:040x}", 8, "ab")), 1)
        self.assertEqual(at("", 3), list("adgj"), "outside of a repository")
        self.assertEqual(at("1", 3, []), [])

    def test_with_all_all(self):
        with mock.patch("part_in_ci.in_part", return_value=False):
            self.assertEqual(part(CASES, 3), CASES)

    def test_each_test_that_takes_turns_is_there_and_has_one_turn(self):
        names = [name for turn in TURNS for name in turn.split("|")]
        self.assertEqual(len(names), len(set(names)))
        for name in names:
            self.assertTrue(list(ROOT.glob(f"tests/*/test_{name}.py")), name)

    def test_whoever_takes_a_turn_tries_all_cases_in_time(self):
        """A test that runs with one commit of six chose the same cases each time: those of that commit's remainder."""
        commits = [int(hashlib.sha1(str(i).encode()).hexdigest(), 16) for i in range(2000)]
        for of in (2, 3, 4, 6, 8):
            self.assertEqual({(chosen(commit)[0], commit % of) for commit in commits}, set(itertools.product(range(len(TURNS)), range(of))))
            self.assertEqual({(chosen(commit)[1], commit % of) for commit in commits}, set(itertools.product(range(SHARE), range(of))))


if __name__ == "__main__":
    unittest.main()
