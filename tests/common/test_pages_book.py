"""Tests of ./course docs --book: it is printed until the page numbers of its contents match the printing itself."""

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from pages import book  # noqa: E402
from tree import Failure  # noqa: E402


class Printings(unittest.TestCase):
    def printed(self, *pages: dict) -> list[dict]:
        """The page numbers given to each printing, if the printings' own are `pages`."""
        given = []
        with tempfile.TemporaryDirectory() as folder, mock.patch("pages.book.print_pdf"), mock.patch("pages.book.warn"), \
                mock.patch("pages.book.page", lambda _, places: given.append(places) or ""), \
                mock.patch("pages.book.pages_of", side_effect=pages):
            book.print_until_settled("browser", [], Path(folder, "book.html"), Path(folder, "book.pdf"))
        return given

    def test_the_second_printing_has_the_pages_of_the_first(self):
        self.assertEqual(self.printed({"a": 2}, {"a": 2}), [{}, {"a": 2}])

    def test_numbers_that_move_a_page_are_printed_once_more(self):
        self.assertEqual(self.printed({"a": 9}, {"a": 10}, {"a": 10}), [{}, {"a": 9}, {"a": 10}])

    def test_what_never_settles_is_a_failure(self):
        with self.assertRaisesRegex(Failure, "pages still moved in printing 4"):
            self.printed(*({"a": number} for number in range(4)))


if __name__ == "__main__":
    unittest.main()
