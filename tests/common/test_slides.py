"""Tests of slides and of the book: one file each that needs nothing else, with all that a lesson shows, answers behind questions."""
# Builds: nothing

import re
import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from html_seen import Seen
from pages import book, slides
from pages.lesson_html import blocks, words
import cli
from tree import ROOT, Failure, UsageError, chapters

CHAPTER = chapters()[1]


class Slides(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.slides = slides.make(CHAPTER)
        cls.page = slides.page(CHAPTER, cls.slides)

    def test_all_that_a_lesson_shows_is_on_a_slide(self):
        lesson = (ROOT / "docs" / f"{CHAPTER}.md").read_text()
        kinds = [slide["kind"] for slide in self.slides]
        self.assertEqual((kinds[0], kinds[-1]), ("title", "question"))
        self.assertTrue(self.slides[0]["image"], "slides begin with the picture")
        quotes = len(re.findall(r"^ *<!-- quote: ", lesson, re.M))
        self.assertGreaterEqual(kinds.count("code") + sum("code" in slide for slide in self.slides), quotes - lesson.count("<summary>Derivation"))
        shown = sum(bool(slide.get("picture")) for slide in self.slides) + 2 * kinds.count("pair") + \
            sum(slide.get("html", "").count("<img") for slide in self.slides if slide["kind"] == "table")
        self.assertEqual(shown + bool(self.slides[0]["image"]), len(re.findall(r"!\[", lesson)))
        self.assertIn("Speed against accuracy", [slide["title"] for slide in self.slides])

    def test_an_answer_comes_behind_its_question(self):
        asked = [slide for slide in self.slides if slide["kind"] == "question"]
        self.assertGreaterEqual(len(asked), 6)
        for question, answer in zip(asked[::2], asked[1::2]):
            self.assertEqual((question["title"], question["answer"], answer["title"]), ("Question", "", "Answer"))
            self.assertEqual(question["question"], answer["question"])
            self.assertTrue(words(answer["answer"]))
            self.assertNotIn("<details", question["question"] + answer["answer"])

    def test_it_needs_no_network(self):
        self.assertEqual([link for _, link in Seen(self.page).links if not link.startswith(("data:", "https://"))], [])
        self.assertEqual(re.findall(r"url\((?!\"?data:)(?!\"?%23)[^)]*\.(?:woff2|png|css)", self.page), [])
        self.assertIn("katex.render", self.page)
        self.assertLess(len(self.page), 12e6)

    def test_sentences(self):
        for text, meant in (("One. Two.", "One."), ("By 1.5 m. Two.", "By 1.5 m."), ("<b>One. Two</b> three. Four.", "<b>One. Two</b> three."),
                            ("A (see b. c). Two.", "A (see b. c)."), ("Only one", "Only one")):
            self.assertEqual(slides.sentence(text), meant)
        self.assertEqual([block[0] for block in blocks("<p>a<br>b</p>\n<img src='x'><ul><li><p>c</p></li></ul>")], ["p", "img", "ul"])

    def test_a_bad_word_is_one_line(self):
        for words_of, said in ((["docs", "--slides", "99"], "no chapter '99'"), (["docs", "--slides", "02", "--out", "/proc/x"], "cannot be written"),
                               (["docs", "--book", "99"], "no chapter '99'"), (["docs", "--book", "--out", "x.txt"], "not called like a PDF")):
            with self.assertRaisesRegex(UsageError, said), mock.patch.object(book, "ALONE", False):  # no test waits for a book
                cli.main(words_of)


class Book(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with mock.patch("pages.book.embedded", lambda path, *_, **__: f"data:{path}"):
            cls.parts = [book.chapter_part(chapter) for chapter in chapters()[:3]]

    def test_answers_stand_at_its_end(self):
        page = book.page(self.parts, {})
        end = page.index('<article id="answers">')
        for chapter, part in zip(chapters(), self.parts):
            lesson = (ROOT / "docs" / f"{chapter}.md").read_text()
            self.assertEqual(len(part["answers"]), len(re.findall(r"<summary>Answer</summary>", lesson)))
            for i in range(len(part["answers"])):
                self.assertGreater(page.index(f'id="answer-{chapter[:2]}-{i + 1}"'), end)
        self.assertNotIn("<details", page)

    def test_figures_are_numbered_and_links_lead_somewhere(self):
        page = book.page(self.parts, {self.parts[1]["id"]: 17})
        numbers = re.findall(r"<b>Figure 2\.(\d+)\.</b>", page)
        self.assertEqual(numbers, [str(i + 1) for i in range(len(numbers))])
        self.assertGreater(len(numbers), 5)
        seen = Seen(page)
        inside = [link[1:] for _, link in seen.links if link.startswith("#")]
        chapters_there = {part["id"] for part in self.parts}
        self.assertEqual([name for name in inside if name not in seen.names and not re.match(r"chapter-\d\d[a-z]?$", name)], [])
        self.assertTrue(chapters_there <= seen.names)
        self.assertRegex(page, r'<a href="#chapter-02">17</a>')

    @unittest.skipUnless(book.find_browser() and shutil.which("pdfinfo"), "there is no chromium or no pdfinfo (poppler-utils)")
    def test_pages_are_known_after_the_first_printing(self):
        with tempfile.TemporaryDirectory() as made:
            file, out = Path(made, "a.html"), Path(made, "a.pdf")
            file.write_text('<a href="#b">x</a><h1 id="b" style="break-before: page">B</h1>')
            book.print_pdf(book.find_browser(), file, out)
            self.assertEqual(book.pages_of(out), {"b": 2})
            self.assertEqual(book.page_count(out), 2)
            self.assertTrue(out.read_bytes().startswith(b"%PDF"))


class Printings(unittest.TestCase):
    def printed(self, *pages: dict) -> list[dict]:
        """The page numbers given to each printing, if the printings' own are `pages`."""
        given = []
        with tempfile.TemporaryDirectory() as folder, mock.patch("pages.book.print_pdf"), mock.patch("pages.book.warn"), \
                mock.patch("pages.book.page", lambda _, places: given.append(places) or ""), \
                mock.patch("pages.book.pages_of", side_effect=pages):
            book.print_until_settled("browser", [], Path(folder, "book.html"), Path(folder, "book.pdf"))
        return given

    def test_numbers_that_move_a_page_are_printed_once_more(self):
        self.assertEqual(self.printed({"a": 9}, {"a": 10}, {"a": 10}), [{}, {"a": 9}, {"a": 10}])

    def test_what_never_settles_is_a_failure(self):
        with self.assertRaisesRegex(Failure, "pages still moved in printing 4"):
            self.printed(*({"a": number} for number in range(4)))
