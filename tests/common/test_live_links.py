"""Tests of all live lessons as a reader sees them, in a browser: pictures and exercises are live, the knob that each link turns is
the one that --set takes, and every text and button can be read in light and in dark (WCAG 2: a contrast of 4.5)."""

import functools
import json
import re
import subprocess
import sys
import unittest
from pathlib import Path

from browser import Browser
from contrast import hard_to_read
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

DRAWN = ['[src*="/golden/"]', *(f'[src*="images/{name}."]' for name in json.loads((REAL / "docs/images/pictures.json").read_text()))]
IMAGES = f"document.querySelectorAll('article img:is({', '.join(DRAWN)})')"


class Lessons(LivePage):
    def said_of(self, chapter: str, *given: str) -> str:
        """What a program says of --set GIVEN; nothing where it takes all."""
        sets = [word for one in given for word in ("--set", one)]
        return subprocess.run([BUILD / "chapters" / chapter, *sets, "--list", "knobs"], text=True, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE).stderr

    def knob_of_set(self, chapter: str, name: str) -> str | None:
        """The knob that --set takes a name for: a wrong value is refused in its full name."""
        found = re.match(r"error: (?:--set )?([\w.]+)(?:=@)?[: ]", self.said_of(chapter, f"{name}=@"))
        return found[1] if found else None

    def test_all_is_live_links_turn_the_knob_that_set_takes_and_every_text_can_be_read(self):
        """Each lesson is opened once: that takes longest."""
        count = 0
        with Browser(1400, 1000, server=self.server.base) as browser:
            browser.open(self.server.address)
            for chapter in part(chapters(), 4):
                takes = functools.cache(functools.partial(self.knob_of_set, chapter))
                for page in lesson_pages(chapter):
                    self.opened(browser, page.stem)
                    self.check_live(browser, page)
                    browser.evaluate("document.querySelectorAll('.run-open')[0]?.click()")
                    browser.evaluate("document.querySelectorAll('article details').forEach(one => { one.open = true; })")
                    self.assertEqual(hard_to_read(browser), {}, page.stem)
                    count += self.check_links(browser, chapter, page.stem, takes)
        self.assertGreater(count, 10)

    def check_live(self, browser: Browser, page: Path):
        # Images other than charts and diagrams are drawn by a chapter.
        browser.wait(f"Boolean(![...{IMAGES}].some(i => !i.closest('.live-frame')))")
        opened = browser.evaluate("[...document.querySelectorAll('.run-open')].map(button => button.dataset.exercise)")
        self.assertEqual(opened, re.findall(r"^### (\d\d\.\w+)", (REAL / page).read_text(encoding="utf-8"), re.M), page)
        # A specification is read without scrolling sideways.
        cut = "[...document.querySelectorAll('.spec pre > code')].map(c => c.scrollWidth > c.clientWidth + 1)"
        self.assertFalse(browser.evaluate(f"{cut}.some(Boolean)"), page)
        self.assertEqual(browser.evaluate("[innerWidth >= document.documentElement.scrollWidth]"), [True], page)
        self.assertEqual(browser.complaints, [], page)

    def check_links(self, browser: Browser, chapter: str, lesson: str, takes) -> int:
        """The number of links that turn a knob."""
        links = browser.evaluate(LINKS)
        for text, knob, value in links:
            with self.subTest(f"{lesson}: {text}"):
                name = re.sub(r"^--(set )?", "", text).split("=")[0].strip()
                if name.rpartition(".")[2] == (knob or "").rpartition(".")[2]:
                    self.assertEqual(knob, takes(name))
                else:  # a value alone
                    self.assertEqual(text, value)
        given = dict.fromkeys(f"{knob}={value}" for _, knob, value in links if value is not None)
        self.assertEqual(self.said_of(chapter, *given), "", lesson)
        return len(links)


if __name__ == "__main__":
    unittest.main()
