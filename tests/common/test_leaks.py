"""No line of a solution is handed out elsewhere: in a lesson, a comment, a shader, the smallest programs.

And no line of a specification is too long for a page.
"""

import re
import sys
import unittest
from pathlib import Path

REAL = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REAL / "common/course"))
from grading.handout import COMPILED, LEFT_OUT  # noqa: E402
from tree import ROOT, chapters, exercises, files, has_solutions  # noqa: E402

SPEC_COLUMNS = 100
# A chapter's own pass that builds on the same few lines: (file, exercise, how many of them at most).
SHARED = {("shaders/03_attenuation/cell.glsl", "03.light_reaches_box"): 1, ("shaders/05_shadow_maps/filter_pcf.glsl", "05.pcf"): 3,
          ("shaders/05_shadow_maps/filter_pcss.glsl", "05.pcf"): 1, ("shaders/10_atmosphere/closed_depth.glsl", "10.optical_depth"): 1,
          ("shaders/10_atmosphere/make_multiple.comp", "10.in_scatter"): 3, ("shaders/11_fractals/noise_jet.glsl", "11.noise_derivative"): 3,
          ("shaders/13_mlaa/links.comp", "13.line_ends"): 1}


def code(line: str) -> str:
    """Without comment, spaces, and a list's sign before it."""
    return re.sub(r"\s+", "", re.sub(r"^\s*[-+]\s", "", re.sub(r"//.*", "", line)))


def is_telling(text: str) -> bool:
    return len(text) >= 28 and bool(re.search(r"[-+*/<>?&|]|\(.*\(", text)) and not text.startswith(("#", "for(", "usingnamespace"))


def of_solutions() -> dict[str, str]:
    """The exercise by each telling line of its solution that its starter does not have."""
    found = {}
    for chapter in chapters():
        for exercise, path in exercises(chapter).items():
            starter = {code(line) for line in path.read_text().splitlines()}
            for line in (path.parents[1] / "solution" / path.name).read_text().splitlines():
                if is_telling(code(line)) and code(line) not in starter:
                    found[code(line)] = exercise
    return found


@unittest.skipUnless(has_solutions(), "needs the reference solutions")
class Leaks(unittest.TestCase):
    def test_no_line_of_a_solution_is_handed_out(self):
        answers, counts, found = of_solutions(), {}, []
        self.assertGreater(len(answers), 300)
        for name in files():
            if "solution" in name.parts[:-1] or name.parts[0] == "assets" or name.suffix in (".png", ".jpg", ".bin") or \
                    any(name.match(pattern) for pattern in (*COMPILED, *LEFT_OUT)):
                continue
            for number, line in enumerate((ROOT / name).read_text(errors="replace").splitlines(), 1):
                if exercise := answers.get(code(line)):
                    place = (name.as_posix(), exercise)
                    counts[place] = counts.get(place, 0) + 1
                    if counts[place] > SHARED.get(place, 0):
                        found.append(f"{name}:{number}: of {exercise}: {line.strip()}")
        self.assertEqual(found, [])

    def test_the_list_of_shared_lines_is_no_longer_than_needed(self):
        for name, exercise in SHARED:
            self.assertTrue((ROOT / name).exists(), name)


class Specifications(unittest.TestCase):
    def test_no_line_is_too_long(self):
        found = []
        for chapter in chapters():
            for exercise, path in exercises(chapter).items():
                text = path.read_text().splitlines()
                marks = [i for i, line in enumerate(text) if re.match(r"// \[/?\w+\]", line)]
                for i in range(marks[0], marks[1]) if len(marks) > 1 else ():
                    if len(text[i]) > SPEC_COLUMNS and text[i].startswith("//"):
                        found.append(f"{exercise}:{i + 1}: {len(text[i])} characters")
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
