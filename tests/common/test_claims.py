"""Claims in lessons are evaluated, sentences that compare without one are found, and advice is filled from verdicts."""
# Builds: nothing

import ast
import json
import re
import unittest
from pathlib import Path
from unittest import mock

from chart_fixture import point, study
from charts.verdict import verdict_of
from pages import advice, claims, quotes, tables
from tree import ROOT, Failure, lessons


def small():
    return study(points=[point("s", "none", 0.4, 3.0), point("s", "a", 0.2, 6.0, {"taps": 4}), point("s", "a", 0.02, 12.0, {"taps": 16}),
                         point("s", "slow", 0.3, 24.0)])


class Claims(unittest.TestCase):
    def holds(self, text):
        s = small()
        return claims.Scene(s.data, "s", lambda: verdict_of(s, "s")).evaluate(ast.parse(text, mode="eval"))

    def test_expressions(self):
        for text in ("ms(none) < ms('a; taps=4') < ms('a; taps=16')", "near(ms(slow) / ms('taps=4'), 4)", "flip_mean(none) == 2 * flip_mean('a; taps=4')",
                     "least(flip_mean, a) < 0.03 and most(flip_mean, a) > 0.1", "enough(a) and not enough(none)", "dominated(slow)",
                     "taken('taps=16')", "same(none, none) and not same(none, slow)", "at('/points/3/method') == 'slow'",
                     "of(s, ms, none) == 3", "round(ms(slow) / ms(none)) == 8"):
            with self.subTest(text):
                self.assertIs(self.holds(text), True)
        for text in ("ms(none) > ms(slow)", "dominated(a)", "taken(none)", "not enough(a)", "near(1, 1.2)"):
            with self.subTest(text):
                self.assertIs(self.holds(text), False)

    def test_what_is_no_claim_is_refused(self):
        for text in ("__import__('os')", "[1][0]", "ms(a)", "ms(x) > 1", "enough(x)", "ms.none"):
            with self.subTest(text), self.assertRaises((Failure, KeyError)):
                self.holds(text)

    def test_a_false_claim_is_named_with_its_line(self):
        page = "A page.\n\nIt is so.<!-- claim: small#ms(none) > ms(slow) -->\n"
        with mock.patch.object(Path, "read_text", return_value=page), mock.patch.object(tables, "load", return_value=small().data), \
                mock.patch.object(advice, "questions", return_value={}):
            wrong = claims.check_claims(Path("docs/x.md"))
        self.assertEqual(len(wrong), 1)
        self.assertIn("docs/x.md:3: a claim does not hold: s, NVIDIA H200: it is not so that ms(none) > ms(slow)", wrong[0])
        self.assertEqual(claims.fault_of("elsewhere; another program"), "")
        self.assertTrue(claims.fault_of("elsewhere;"))

    def test_sentences_that_compare(self):
        page = """# A page

## Speed against accuracy

`a` is faster than `b`. It has half of the error.<!-- claim: x#1 --> A triangle has half of a square's area.
Tiles win (`[03.x]`). With 3<!-- figure: f --> lights it is cheaper. Both run at the same time. The sun is twice as bright.
Its error is twice as large.

    faster code

| slower | table |

## Exercises

Which is faster?
"""
        with mock.patch.object(Path, "read_text", return_value=page):
            found = claims.unbound(Path("docs/x.md"))
        self.assertEqual(found, [(5, "Speed against accuracy", "`a` is faster than `b`."), (5, "Speed against accuracy", "Its error is twice as large.")])

    def test_comparisons_of_lessons_are_bound(self):
        loose = [f"{lesson}:{line}: {words}" for lesson in lessons() for line, section, words in claims.unbound(lesson)]
        self.assertEqual(loose, [], "a comparison needs <!-- claim: ... --> (common/course/pages/claims.py)")

    def test_no_chart_states_a_verdict_by_hand(self):
        verdict = re.compile(rf"{claims.COMPARES.pattern}|{claims.PERHAPS.pattern}|\w+est\b|\b(?:better|enough|never|only)\b", re.I)
        stated = [f"{request.relative_to(ROOT)}: {words}" for request in sorted(ROOT.glob("chapters/*/study*.json"))
                  for chart in json.loads(request.read_text(encoding="utf-8")).get("charts", []) if verdict.search(words := chart.get("says", ""))]
        self.assertEqual(stated, [], "without \"says\" the sentence is computed, for each device (common/course/charts/said.py)")

    def test_the_tail_of_an_error_does_not_contradict_its_mean(self):
        def errors(name: str, side: ast.expr, scene) -> list[float]:
            return [scene.value(name, scene.evaluate(one.args[0])) for one in ast.walk(side)
                    if isinstance(one, ast.Call) and one.func.id == "flip_mean" and "flip_p99" in scene.data["points"][0]["error"]]
        wrong = []
        for lesson in lessons():
            for match in claims.CLAIM.finditer((ROOT / lesson).read_text(encoding="utf-8")):
                source, scenes, text = claims.parts_of(match["claim"])
                comparisons = [one for one in ast.walk(ast.parse(text, mode="eval")) if isinstance(one, ast.Compare)] if text else []
                for scene, one in ((scene, one) for one in comparisons for scene in claims.scenes_of(source, scenes)):
                    mean, tail = ([errors(name, side, scene) for side in (one.left, *one.comparators)] for name in ("flip_mean", "flip_p99"))
                    if list(map(len, mean)) == [1, 1] and (mean[0] < mean[1]) != (tail[0] < tail[1]) and not claims.near(*tail[0], *tail[1]):
                        wrong.append(f"{lesson}: {scene.scene}: {ast.unparse(one)}, but the 99th percentiles are {tail}")
        self.assertEqual(wrong, [])


class Advice(unittest.TestCase):
    def question(self, **entry):
        return advice.Question("02_lambert_phong", {"id": "02.x", "question": "Which?", **entry}, (small(),))

    def test_blocks_are_filled_and_checked(self):
        with mock.patch.object(advice, "questions", return_value={"02.x": self.question()}):
            lines = ["before", "<!-- verdict: 02.x -->", "<!-- /verdict -->", "after"]
            _, filled = advice.check_blocks(Path("x.md"), lines)
            self.assertEqual((filled[0], filled[-1]), ("before", "after"))
            self.assertEqual(advice.check_blocks(Path("x.md"), filled), ([], filled))
            filled = [line.replace("12 ms", "13 ms") for line in filled]
            self.assertIn("x.md:2: the verdict 02.x is not that of its studies", advice.check_blocks(Path("x.md"), filled)[0][0])
            self.assertIn("there is no verdict 03.y", advice.check_blocks(Path("x.md"), ["<!-- verdict: 03.y -->", "<!-- /verdict -->"])[0][0])
            self.assertIn("does not end", advice.check_blocks(Path("x.md"), ["<!-- verdict: 02.x -->", "text"])[0][0])

    def test_a_page_as_it_should_be_is_not_written(self):
        """Where nothing can be written, either."""
        with mock.patch.object(quotes, "lessons", return_value=[]), mock.patch.object(quotes, "write_atomically", side_effect=AssertionError):
            self.assertEqual(quotes.run(None, []), 0)
