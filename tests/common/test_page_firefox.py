"""The site in Firefox, of Debian's package firefox-esr: pictures of the programs, verdicts on all answers, an exercise solved from a
file on a phone in the dark, keys, reading without a network. ./course test --all installs it; no other run tries it."""

import tempfile
import unittest
from pathlib import Path

import test_page_pictures as pictures
import test_page_verdicts as verdicts
from browser import FIREFOX, WHY_NONE, Firefox
from site_page import COLORS, DRAWN_BY, LAMBERT, Solving, remove, serve, site

from pages import in_browser, running
from tree import BUILD, write_atomically

tearDownModule = remove


def setUpModule():
    if not FIREFOX:  # a browser that nobody has tried is not a browser that works
        raise AssertionError("not installed: firefox-esr; ./course test page_firefox installs it")


@unittest.skipIf(WHY_NONE, WHY_NONE)
class InFirefox(Solving, pictures.Comparing):
    def test_programs_look_like_their_pictures(self):
        with Firefox() as browser:
            self.compare(browser, sorted(running.scenes()))
            self.assertEqual(browser.complaints, [])

    def test_every_answer_has_the_verdict_of_the_check(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = verdicts.compared(Path(folder), in_browser.write(Path(folder)), Firefox)
        write_atomically(BUILD / "report" / "verdicts_firefox.md", verdicts.table(rows))
        self.assertGreater(len(rows), 400)
        self.assertEqual([row for row in rows if not row["same_verdict"]], [])

    def test_an_exercise_and_a_picture_from_a_file_on_a_phone_and_in_the_dark(self):
        with Firefox(390, 844, dark=True) as browser:
            browser.open(site() / "02_lambert_phong.html")
            self.assertEqual(browser.evaluate("[innerWidth, document.documentElement.scrollWidth]"), [390, 390])
            self.assertEqual(browser.evaluate("getComputedStyle(document.body).backgroundColor"), "rgb(20, 24, 31)")
            self.solve(browser, "02.lambert", LAMBERT)
            self.press(browser, "02.lambert", "See it in the picture")
            browser.wait(f"{DRAWN_BY % 0} && Program.all[0].mine.size && Program.all[0].said.textContent === ''")
            browser.wait(f"{COLORS % 0} > 20")
            browser.evaluate("[...document.querySelectorAll('.states-link')].pop().click()")
            browser.wait("[...document.images].some(one => one.src.includes('/states/') && one.naturalWidth > 300)")
            self.assertEqual(browser.complaints, [])

    def test_keys_turn_a_picture_and_reach_its_buttons(self):
        with Firefox() as browser:
            self.turn_by_keys(browser)
            self.assertEqual(browser.complaints, [])

    def test_it_is_read_without_a_network_after_one_visit(self):
        address, end = serve()
        with Firefox() as browser:
            self.read_offline(browser, address, end)
