"""No line and no statement of a solution is handed out elsewhere: in a lesson, a comment, a shader, the smallest programs."""

import re
import unittest

from grading.handout import COMPILED, LEFT_OUT
from tree import ROOT, chapters, exercises, files, has_solutions

# Half a texel, which the specification says in words, is one of the fifteen statements of its solution.
ALLOWED = {("shaders/10_atmosphere/read_tables.glsl", "10.table_uv")}


def code(line: str) -> str:
    """Without comment, spaces, and a list's sign before it."""
    return re.sub(r"\s+", "", re.sub(r"^\s*[-+]\s", "", re.sub(r"//.*", "", line)))


def is_telling(text: str) -> bool:
    return len(text) >= 28 and bool(re.search(r"[-+*/<>?&|]|\(.*\(", text)) and not text.startswith(("#", "for(", "usingnamespace"))


def parts(line: str) -> set[str]:
    """The line's code, and each of its statements that is more than a call of the standard library."""
    whole = code(line)
    return {whole} | {one for one in re.split("[;{}]", whole) if not one.startswith("std::")}


def of_solutions() -> dict[str, str]:
    """The exercise by each telling line and statement of its solution that its starter does not have."""
    found = {}
    for chapter in chapters():
        for exercise, path in exercises(chapter).items():
            starter = set().union(*map(parts, path.read_text().splitlines()))
            for line in (path.parents[1] / "solution" / path.name).read_text().splitlines():
                found |= {part: exercise for part in parts(line) - starter if is_telling(part)}
    return found


@unittest.skipUnless(has_solutions(), "needs the reference solutions")
class Leaks(unittest.TestCase):
    def test_no_line_of_a_solution_is_handed_out(self):
        answers, found = of_solutions(), []
        self.assertGreater(len(answers), 300)
        for name in files():
            if "solution" in name.parts[:-1] or name.parts[0] == "assets" or name.suffix in (".png", ".jpg", ".bin") or \
                    any(name.match(pattern) for pattern in (*COMPILED, *LEFT_OUT)):
                continue
            for number, line in enumerate((ROOT / name).read_text(errors="replace").splitlines(), 1):
                exercise = next((answers[part] for part in parts(line) if part in answers), None)
                if exercise and (str(name), exercise) not in ALLOWED:
                    found.append(f"{name}:{number}: of {exercise}: {line.strip()}")
        self.assertEqual(found, [])
