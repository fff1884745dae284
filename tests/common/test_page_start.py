"""The site's start page: its film, written by the course, and the first exercises of two chapters, solved from a file and seen."""

import json
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from browser import WHY_NONE, Browser
from site_page import DRAWN_BY, LAMBERT, SQUARE, Solving, remove, site

from pages import publish
from tree import ROOT

tearDownModule = remove

SMALL = """(canvas => {
  const small = Object.assign(document.createElement("canvas"), {width: 32, height: 18}), to = small.getContext("2d");
  to.drawImage(canvas, 0, 0, 32, 18);
  return [...to.getImageData(0, 0, 32, 18).data];
})(Program.all[%d].canvas)"""
SEEN, SAME = 2, 0.5  # mean difference of two pictures in codes of 255: another picture; the same
# Each chapter's first exercise with a wrong and a right answer, and its program in the lesson.
FIRST = {"02.lambert": (LAMBERT.replace("max(dot(normal, to_light), 0)", "0.1"), LAMBERT, 0),
         "11.quaternion_square": (SQUARE.replace(" - dot(q.yzw, q.yzw)", ""), SQUARE, 1)}


def difference(a: list, b: list) -> float:
    return sum(abs(x - y) for x, y in zip(a, b)) / len(a)


@unittest.skipIf(WHY_NONE, WHY_NONE)
class FromTheStartPage(Solving):
    def test_a_shader_is_changed_and_two_first_exercises_are_solved_and_seen(self):
        with Browser(webgl=True) as browser:
            browser.open(site() / "index.html")
            browser.evaluate("document.querySelector('.hero a[href=\"#try\"]').click()")
            browser.wait(DRAWN_BY % 0)
            before = self.picture(browser, 0)
            self.named(browser, "document", "Edit")
            browser.wait("!!Program.all[0].editor")
            changed = browser.evaluate("Program.all[0].text.replace('0.75, 0.35, 0.15', '0.1, 0.9, 0.1')")  # the stone's colour
            self.assertNotEqual(changed, browser.evaluate("Program.all[0].text"))
            self.write(browser, "Program.all[0].editor", changed)
            self.until(browser, 0, lambda picture: difference(picture, before) > SEEN)
            self.follow(browser, ".try a[href*='#02.lambert']")
            self.solve_and_see(browser, "02.lambert")
            self.follow(browser, "a.md-logo")
            self.follow(browser, "a.card[href^='11_']")
            self.solve_and_see(browser, "11.quaternion_square")
            self.assertRegex(browser.evaluate("document.querySelector('.run-progress').textContent"), r"^2 of \d+ solved$")
            self.assertEqual(browser.complaints, [])

    def follow(self, browser, link: str):
        browser.evaluate(f"window.left = true, document.querySelector({json.dumps(link)}).click()")
        browser.wait("!window.left && document.readyState === 'complete' && !!document.querySelector('.run-progress')")
        self.assertTrue(browser.evaluate("location.protocol === 'file:'"))

    def named(self, browser, within: str, button: str):
        browser.evaluate(f"[...{within}.querySelectorAll('button')].find(one => one.textContent === '{button}').click()")

    def write(self, browser, editor: str, text: str):
        """As one pastes it."""
        browser.evaluate(f"{editor}.focus(), {editor}.execCommand('selectAll')")
        browser.call("keyboard.insertText", text)
        self.assertEqual(browser.evaluate(f"{editor}.getValue()").split(), text.split())

    def picture(self, browser, program: int) -> list:
        browser.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")
        return browser.evaluate(SMALL % program)

    def until(self, browser, program: int, true):
        while not true(self.picture(browser, program)):  # the test's own limit ends it
            self.assertEqual(browser.evaluate(f"Program.all[{program}].said.textContent"), "")

    def solve_and_see(self, browser, exercise: str):
        wrong, right, program = FIRST[exercise]
        self.assertEqual(browser.evaluate("document.querySelector('a.exercise').id"), exercise, "the lesson's first")
        browser.evaluate(f"Program.all[{program}].canvas.scrollIntoView({{behavior: 'instant'}})")
        browser.wait(DRAWN_BY % program)
        reference = self.picture(browser, program)
        browser.evaluate(f"document.querySelector('button[data-exercise=\"{exercise}\"]').click()")
        browser.wait(f"!!Exercise.all.get('{exercise}').editor")
        editor = f"Exercise.all.get('{exercise}').editor"
        self.write(browser, editor, wrong)
        self.press(browser, exercise, "Check")
        browser.wait("document.querySelector('.run-verdict.open')?.textContent ?? ''")
        self.assertRegex(browser.evaluate("document.querySelector('.run-verdict').textContent"), "expected")
        self.press(browser, exercise, "See it in the picture")
        browser.wait(f"Program.all[{program}].mine.size === 1")
        self.until(browser, program, lambda picture: difference(picture, reference) > SEEN)
        self.write(browser, editor, right)
        self.press(browser, exercise, "Check")
        browser.wait("!!document.querySelector('.run-verdict.ok')")
        self.until(browser, program, lambda picture: difference(picture, reference) < SAME)


class Film(unittest.TestCase):
    def test_its_seconds_are_of_one_scene_each_and_few(self):
        film = json.loads((ROOT / publish.FILM).read_text())
        self.assertLessEqual(sum(to_s - from_s for from_s, to_s in publish.BEST_S), 20)
        for from_s, to_s in publish.BEST_S:
            there = [one["name"] for one in film["scenes"] if one["from_s"] < to_s and one["to_s"] > from_s]
            self.assertEqual(len(there), 1, there)

    def test_without_ffmpeg_the_page_shows_its_picture(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(publish, "build"), mock.patch.object(publish, "warn") as said, \
                mock.patch.object(publish.drawn_pictures, "KEPT", Path(folder)), mock.patch.object(publish.shutil, "which", lambda _: None):
            self.assertIsNone(publish.start_film())
        self.assertIn("needs ffmpeg", said.call_args[0][0])
        with tempfile.TemporaryDirectory() as folder:
            from PIL import Image

            hero = '<div class="hero" markdown="0"> <img alt="" src="a.png"> <div>words</div></div>'
            Image.new("RGB", (64, 36)).save(Path(folder, "a.png"))
            self.assertIn('<img alt="" src="a.hero.webp">', publish.start_page(Path(folder), hero, None))
            Path(folder, "assets").mkdir()
            page = publish.start_page(Path(folder), hero, Path(folder, "a.png"))
            self.assertRegex(page, r'<video autoplay muted loop playsinline [^>]*poster="a.hero.webp"')

    @unittest.skipUnless(shutil.which("ffprobe"), "there is no ffmpeg")
    def test_the_course_writes_it_once(self):
        small = [*publish.DRAWN_AS[:2], "--size", "64x36", "--fps", "1", *publish.DRAWN_AS[6:]]
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(publish, "build"), mock.patch.object(publish, "warn"), \
                mock.patch.object(publish.drawn_pictures, "KEPT", Path(folder)), mock.patch.object(publish, "DRAWN_AS", small):
            made = publish.start_film()
            said = subprocess.run(["ffprobe", "-v", "error", "-show_streams", "-of", "json", made], stdout=subprocess.PIPE, check=True).stdout
            with mock.patch.object(publish.subprocess, "run", side_effect=AssertionError("drawn twice")):
                self.assertEqual(publish.start_film(), made)
        [stream] = json.loads(said)["streams"]  # a picture without sound
        self.assertEqual((stream["codec_name"], stream["width"], stream["height"]), ("h264", 64, 36))
        self.assertGreaterEqual(int(stream["nb_frames"]), len(publish.BEST_S))


if __name__ == "__main__":
    unittest.main()
