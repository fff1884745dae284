"""Tests of live lessons as a reader sees them, in a browser: the knob that each link turns is the one that --set takes, and every
text and button can be read in light and in dark (WCAG 2: a contrast of 4.5)."""

import functools
import re
import subprocess
import sys
import unittest

from browser import Browser
from contrast import CONTRAST
from live_page import BUILD, LivePage
from part_in_ci import part
from small_course import REAL

sys.path.insert(0, str(REAL / "common/course"))
from tree import chapters, lesson_pages  # noqa: E402

# Each link in the order of the page: its words, and the knob and value that a click turns. Nothing is drawn.
LINKS = """(async () => {
  const found = [];
  Live.draw = () => {};
  Panel.prototype.turn = (knob, value) => { found.push([knob.name, value]); };
  for (const code of document.querySelectorAll("code[data-knob]")) {
    const before = found.length;
    code.onclick();
    for (let i = 0; i < 50 && found.length === before; ++i) await new Promise(done => setTimeout(done, 2));
    if (found.length === before) found.push([null, null]);
  }
  return found.map(([knob, value], i) => [document.querySelectorAll("code[data-knob]")[i].textContent.trim(), knob, value]);
})()"""


class Lessons(LivePage):
    def said_of(self, chapter: str, given: str) -> str:
        """What a program says of --set GIVEN; nothing where it takes it."""
        return subprocess.run([BUILD / "chapters" / chapter, "--set", given, "--list", "knobs"], text=True, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE).stderr

    def knob_of_set(self, chapter: str, name: str) -> str | None:
        """The knob that --set takes a name for: a wrong value is refused in its full name."""
        found = re.match(r"error: (?:--set )?([\w.]+)(?:=@)?[: ]", self.said_of(chapter, f"{name}=@"))
        return found[1] if found else None

    def test_a_link_turns_the_knob_that_set_takes(self):
        count = 0
        with Browser(1400, 1000, server=self.server.base) as browser:
            browser.open(self.server.address)
            for chapter in part(chapters(), 4):
                takes = functools.cache(functools.partial(self.knob_of_set, chapter))
                refuses = functools.cache(functools.partial(self.said_of, chapter))
                for page in lesson_pages(chapter):
                    self.opened(browser, page.stem)
                    for text, knob, value in browser.evaluate(LINKS):
                        count += 1
                        with self.subTest(f"{page.stem}: {text}"):
                            name = re.sub(r"^--(set )?", "", text).split("=")[0].strip()
                            if name.rpartition(".")[2] == (knob or "").rpartition(".")[2]:
                                self.assertEqual(knob, takes(name))
                            else:  # a value alone
                                self.assertEqual(text, value)
                            if value is not None:
                                self.assertEqual(refuses(f"{knob}={value}"), "")
        self.assertGreater(count, 10)

    def test_every_text_can_be_read_in_light_and_in_dark(self):
        for dark in (False, True):
            with Browser(1400, 1000, dark=dark, server=self.server.base) as browser:
                browser.open(self.server.address)
                for lesson in [page.stem for chapter in part(chapters(), 4) for page in lesson_pages(chapter)]:
                    self.opened(browser, lesson)
                    browser.evaluate("document.querySelectorAll('.live-open')[0]?.click()")
                    browser.evaluate("document.querySelectorAll('article details').forEach(one => { one.open = true; })")
                    found = browser.evaluate(CONTRAST)
                    self.assertEqual(found, {}, f"{lesson}, {'dark' if dark else 'light'}")


if __name__ == "__main__":
    unittest.main()
