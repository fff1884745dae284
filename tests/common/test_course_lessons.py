"""Every lesson has the same parts in the same order, each exercise says how to see and check it, and the main thread is short."""

import json
import re
import unittest
from pathlib import Path

from pages.reading import minutes, sections
from test import lesson_commands
from tree import ROOT, chapters, lesson_pages, lessons, shots

PARTS = ["What you will be able to do", "The first ten minutes", "What you will see", "The smallest program", "The frame",
         "Exercises", "What goes wrong", "Speed against accuracy", "When to use which", "Recap", "Questions", "Further reading"]
EXERCISE = re.compile(r"^### (\d\d\.\w+) \((?:easy|medium|hard)\)\n(.*?)(?=^##|\Z)", re.M | re.S)
MOST_MINUTES = 45
UPDATE = "python3 docs/figures/reading_minutes.py measures again, and docs/figures/draw.py draws"


def read(page: Path) -> str:
    return (ROOT / page).read_text(encoding="utf-8")


class Lessons(unittest.TestCase):
    def each(self):
        """(chapter, its own page by heading, the text of all its pages)."""
        pages = {chapter: lesson_pages(chapter) for chapter in chapters()}
        return [(chapter, dict(sections(read(found[0]))), "\n".join(map(read, found))) for chapter, found in pages.items()]

    def test_the_parts_stand_in_one_order(self):
        for chapter, parts, _ in self.each():
            self.assertEqual([heading for heading in parts if heading in PARTS], PARTS, chapter)

    def test_further_pages_keep_that_order(self):
        for page in (page for chapter in chapters() for page in lesson_pages(chapter)[1:]):
            there = [part for heading, _ in sections(read(page)) for part in PARTS if heading.startswith(part)]
            self.assertEqual(there, sorted(there, key=PARTS.index), page)
            self.assertEqual(there.count("Exercises"), "\n### " in read(page) and EXERCISE.search(read(page)) is not None, page)

    def test_a_picture_comes_before_all_else(self):
        for _, parts, _ in self.each():
            self.assertRegex(parts[""], r"!\[[^\]]+\]\(\.\./tests/\w+/golden/\w+\.png\)")
            self.assertIn("./course run", parts[""])

    def test_goals_are_a_short_list_and_the_beginning_is_done_by_hand(self):
        for _, parts, _ in self.each():
            goals = re.findall(r"^- ", parts["What you will be able to do"], re.M)
            self.assertTrue(3 <= len(goals) <= 6, goals)
            steps = re.findall(r"^\d+\. .*", parts["The first ten minutes"], re.M)
            self.assertTrue(3 <= len(steps) <= 6, steps)
            self.assertIn("Run `./course run", steps[0])

    def test_an_exercise_can_be_seen_and_checked_and_names_typical_mistakes(self):
        for chapter, _, text in self.each():
            found = EXERCISE.findall(text)
            self.assertGreaterEqual(len(found), 5, chapter)
            for name, body in found:
                for part in ("See", "Check", "Typical mistakes"):
                    self.assertRegex(body, rf"(?m)^- \*\*{part}:\*\*\s+\S", name)
                self.assertIn(f"./course check {name}", body)

    def test_three_to_six_questions_one_of_them_a_prediction(self):
        for chapter, parts, _ in self.each():
            asked = re.split(r"^\d+\. ", parts["Questions"], flags=re.M)[1:]
            self.assertTrue(3 <= len(asked) <= 6, f"{chapter}: {len(asked)}")
            for question in asked:
                self.assertEqual(question.count("<details><summary>Answer</summary>"), 1, question)
            self.assertTrue(any(re.search(r"\bpredict\b", question, re.I) for question in asked), chapter)

    def test_the_chart_comes_before_any_table(self):
        for chapter, parts, _ in self.each():
            text = parts["Speed against accuracy"]
            chart, table = text.find("](studies/"), text.find("\n|")
            self.assertGreater(chart, 0, chapter)
            self.assertTrue(table < 0 or chart < table, chapter)

    def test_a_name_of_a_picture_and_of_a_study_is_one_scene_or_the_lesson_names_the_studys(self):
        unnamed = []
        for chapter, _, text in self.each():
            pictures = {shot["name"]: shot.get("scene", "") for shot in shots(chapter)}
            for study in sorted((ROOT / "chapters" / chapter).glob("study*.json")):
                for scene in json.loads(study.read_text())["scenes"]:
                    file, label = (scene, Path(scene).stem) if isinstance(scene, str) else (scene["scene"], scene.get("label", ""))
                    if pictures.get(label.split(",")[0], file) != file and f"{Path(file).name}`" not in text:
                        unnamed.append(f"{chapter}: '{label}' of {study.name} is {file}, the shot is another scene")
        self.assertEqual(unnamed, [])

    def test_the_main_thread_is_read_in_45_minutes(self):
        self.assertEqual([f"{page.stem}: {minutes(page):.0f}" for page in lessons() if minutes(page) > MOST_MINUTES], [])

    def test_the_chart_of_reading_minutes_is_up_to_date(self):
        charted = json.loads((ROOT / "docs/figures/reading_minutes.json").read_text())
        self.assertEqual(list(charted), [page.stem for page in lessons()], UPDATE)
        for page in lessons():
            self.assertLessEqual(abs(charted[page.stem] - minutes(page)), 4, f"{page.stem}: {UPDATE}")
        self.assertIn("images/reading_minutes.svg", read(Path("docs/teaching.md")))

    def test_lesson_00_defines_each_word_once(self):
        text = read(Path("docs/00_start.md"))
        for word in ("graphics pipeline", "vertex shader", "fragment shader", "uniform", "texture", "sampler", "mip levels",
                     "depth buffer", "compute shader", "dispatch", "workgroup", "invocation", "Shared memory", "barrier", "subgroup"):
            self.assertEqual(text.count(f"**{word}**"), 1, word)


class Commands(unittest.TestCase):
    PAGE = """Run `./course run 02 --shot statue --set
mist=0.3`, then

    for a in 1 2; do build/chapters/02_lambert_phong --shininess $a \\
        --size 96x64 --screenshot $a.png; done   # twice

or `./course run 02 --shot NAME` or (`build/chapters/03_attenuation --study FILE`).
"""

    def test_programs_commands_are_found_in_text_and_in_blocks(self):
        found = lesson_commands.printed_on(Path("a.md"), self.PAGE)
        self.assertEqual([(one.line, one.chapter[:2], " ".join(one.words)) for one in found], [
            (1, "02", "--shot statue --set mist=0.3"), (4, "02", "--shininess 1 --size 96x64 --screenshot 1.png"),
            (4, "02", "--shininess 2 --size 96x64 --screenshot 2.png"), (7, "03", "--study FILE")])
        self.assertEqual([lesson_commands.is_drawn(one.words) for one in found], [True, True, True, False])
        self.assertEqual(lesson_commands.small(found[1].words), ["--shininess", "1", "--size", "32x18"])

    def test_most_pages_print_some(self):
        found = lesson_commands.printed()
        self.assertEqual({one.chapter for one in found}, set(chapters()))
        self.assertGreater(len(found), 250)
        self.assertIn(("--shot", "forge", "--set", "method=window"), [one.words for one in found if lesson_commands.is_drawn(one.words)])
