"""Submissions in later chapters that attack their grading: answers that know where they run, that bring their own checks, and that
have a table of the inputs everybody can see."""

import subprocess
import unittest

from graded_class import OF, PLACES, REAL, begins, right, why_not
from build.build import build
from check.variants import variants
from grading.judge import Judge, targets
from grading.judge_compile import parts
from tree import BUILD, chapters


def variant(chapter: str, name: str) -> str:
    """An answer with a known verdict, a file or an entry of a list."""
    return next(one.text for one in variants(chapter)[0] if one.name == name + ".glsl")


NAIVE_LIGHTS = variant("06_deferred", "accumulate_lights.each_alone")
TWO_BARRIERS = variant("08_bloom", "blur_line.two_barriers")
CELL = (REAL / "shaders/03_attenuation/cell.glsl").read_text()


def own_reach() -> str:
    """An answer that asks every light by itself, in a copy of the function that is counted."""
    body = CELL[CELL.index("bool light_reaches_cell"):CELL.index("// [/light_reaches_cell]")]
    return NAIVE_LIGHTS.replace("Lit accumulate_lights", body.replace("light_reaches_cell", "mine") + "Lit accumulate_lights")\
        .replace("(light_reaches_cell(", "(mine(")


def before(text: str, place: str, line: str) -> str:
    """GLSL with a line more before the first of these places."""
    at = text.index(place)
    return text[:at] + line + text[at:]


FORGED = """#include "02_lambert_phong/exercises.h"
#include <string>
#include <string_view>
namespace lightwalk {
using Answer = std::string (*)(std::string_view);
struct RegisterAnswer { RegisterAnswer(const char* id, Answer answer); };
static std::string forged(std::string_view) { return std::string(64, '\\0'); }
%s static const RegisterAnswer mine("02.record_mist try_record_mist", forged);
}
"""

# name: (exercise, answer, words of the verdict)
ATTACKS = {
    "sets the count back": ("06.accumulate_lights", begins(NAIVE_LIGHTS, "accumulate_lights", "{\n    asked = 0u;\n"),
                            "asked' : undeclared"),
    "counts in a copy": ("06.accumulate_lights", own_reach(), "lights where|lights reach|plain loop"),
    "waits for nobody": ("06.accumulate_lights", "void barrier() {}\n" + NAIVE_LIGHTS, "syntax error"),
    "says so by another name": (
        "08.blur_line", before(TWO_BARRIERS, "    int middle", "    barriers_passed = 1u;\n"), "barriers_passed' : undeclared"),
    "says so of its own": (
        "08.blur_line", before(before(TWO_BARRIERS, "    int middle", "    barriers_passed = 1u;\n"), "vec3 blur_line",
                               "uint barriers_passed;\n"), "different barriers"),
    "makes the check agree": (
        "08.blur_line", '#include "08_bloom/line_source.glsl"\n'
        "vec4 texelFetch(sampler2D s, ivec2 at, int level) { return vec4(0.0); }\n"
        "vec3 blur_line(int start, int radius) { return vec3(0.0); }\n", "gave 0.0000|overloaded functions"),
    "brings its own trial": ("02.record_mist", FORGED % "" + right("02.record_mist"), "is there twice"),
    "brings its own trial first": (
        "02.record_mist", FORGED % "[[gnu::init_priority(101)]]" + right("02.record_mist"), "is there twice"),
}


def table(exercise: str, known: str) -> str:
    """An answer that is right if `known` holds, an expression of its input, and wrong elsewhere."""
    wrong = {"13.area": "return 9.0f;", "07.odd_size_weights": "return vec3(9.0);", "11.record_cones": "return;",
             "13.propagate_distance": "return 99u;"}.get(exercise, "return {};")
    return begins(right(exercise), exercise[3:], f"{{\n    if (!({known})) {wrong}\n")


def one_of(value: str, *numbers) -> str:
    return " || ".join(f"{value} == {number}" for number in numbers)


# Answers that know every input of their check that does not move with the seed.
TABLES = {
    "01.triangulate": table("01.triangulate", one_of("polygon.size()", 2, 3, 4, 5, 6, 10, 42, 100, 1000)),
    "07.level_sizes": table("07.level_sizes", one_of("size.x", 4, 1, 1023, 3, 1366, 1080, 4096, 4097, 16384)),
    "07.odd_size_weights": table("07.odd_size_weights", one_of("size", 1, 2, 3, 5, 7, 8, 255, 683, 1023, 1366, 4097)),
    "08.gaussian_weights": table("08.gaussian_weights", one_of(
        "sigma_px", "0.0f", "1e-20f", "1e-30f", "0.1f", "0.3f", "1.0f", "2.5f", "10.0f", "33.3f", "200.0f")),
    "08.pair_taps": table("08.pair_taps", "weights[0] >= 0.15f || weights.size() > 30 || weights[0] == 0.0f || "
                          + one_of("weights.size()", 1, 4, 5, 7, 22)),
    "13.area": table("13.area", one_of("length", 1, 2, 3, 4, 5, 7, 8, 31, 64, 255, 256, 509)),
    "13.propagate_distance": table("13.propagate_distance", one_of("known(0u) * 256u + known(5u)", *(
        f"{a}u * 256u + {b}u" for a, b in ((1, 1), (4, 4), (3, 4), (2, 2), (0, 1), (200, 1), (254, 254), (100, 100))))
        + " || known(0u) == 0u"),
    "11.record_cones": table("11.record_cones", one_of("passes.found.desc.size.x", 40, 61)),
}
assert set(TABLES) <= set(PLACES)


@unittest.skipIf(why_not(), why_not())
class Later(unittest.TestCase):
    def test_attacks_get_no_mark_and_are_told_why(self):
        with Judge({exercise: OF[exercise] for exercise, _, _ in ATTACKS.values()}, 2, False) as judge:
            for name, (exercise, text, words) in ATTACKS.items():
                with self.subTest(name):
                    judge.control(exercise)  # what is right passes
                    found = judge.judge(exercise, text.encode())
                    self.assertFalse(found["ok"], found)
                    self.assertRegex(found["first_failure"], words)

    def test_a_table_of_what_everybody_can_see_is_wrong(self):
        with Judge({exercise: OF[exercise] for exercise in TABLES}, 2, False) as judge:
            for exercise, text in TABLES.items():
                with self.subTest(exercise):
                    found = judge.judge(exercise, text.encode(), 1)
                    self.assertFalse(found["ok"], found)
                    self.assertNotRegex(found["first_failure"], "compile|link|error")
                    right_one = judge.judge(exercise, right(exercise).encode(), 1)
                    self.assertTrue(right_one["ok"], right_one)


class Built(unittest.TestCase):
    def test_a_tree_that_was_only_cloned_is_built_as_far_as_judging_needs(self):
        build(["serve_main"])
        made = set(subprocess.run(["ninja", "-C", BUILD, "-t", "commands", *targets(chapters())], check=True,
                                  stdout=subprocess.PIPE, text=True).stdout.split())
        for chapter in chapters():
            named = [str(path.relative_to(BUILD)) for path in parts(chapter)]
            self.assertEqual([name for name in named if name not in made], [])
            trials = [name for name in named if "checks_trial_" in name]
            self.assertEqual(bool(trials), chapter[:2] in ("02", "11", "12", "14"))
