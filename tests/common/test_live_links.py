"""Tests of live lessons as a reader sees them, in a browser: the knob that each link turns is the one that --set takes, and every
text and button can be read in light and in dark (WCAG 2: a contrast of 4.5)."""

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import CHROMIUM, Browser
from live_server import Server
from part_in_ci import part
from small_course import REAL
from test_live_browser import BUILD, copy_of_course, has_pages

sys.path.insert(0, str(REAL / "common/course"))
from tree import chapters  # noqa: E402

CONTRAST = """(() => {
  const rgb = text => (text.match(/[\\d.]+/g) ?? [0, 0, 0, 0]).map(Number);
  const light = c => { const [r, g, b] = c.slice(0, 3).map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const over = (top, below) => { const a = top[3] ?? 1; return [0, 1, 2].map(i => top[i] * a + below[i] * (1 - a)); };
  const ground = e => { const layers = []; for (let at = e; at; at = at.parentElement) layers.push(rgb(getComputedStyle(at).backgroundColor));
    return layers.reverse().reduce((below, top) => over(top, below), [255, 255, 255]); };
  const found = {};
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const e = walker.currentNode.parentElement, style = getComputedStyle(e);
    if (!walker.currentNode.textContent.trim() || !e.checkVisibility?.({checkOpacity: true, checkVisibilityCSS: true})) continue;
    if (e.closest("script, style, svg, .katex-mathml, .live-frame, .slide, .md-search, dialog, .md-skip, .headerlink, [aria-hidden=true], .md-top, .CodeMirror-measure")) continue;
    const box = e.getBoundingClientRect();
    if (!box.width || !box.height) continue;
    const below = ground(e), color = over(rgb(style.color), below);
    const [a, b] = [light(color), light(below)].sort((x, y) => y - x), ratio = (a + 0.05) / (b + 0.05);
    if (ratio < 4.5) found[`${e.tagName}.${e.className} in ${e.parentElement.tagName}.${e.parentElement.className}`] =
      [ratio.toFixed(2), style.color, below.map(Math.round).join(","), walker.currentNode.textContent.trim().slice(0, 30)];
  }
  return found;
})()"""
LINKS = """[...document.querySelectorAll('code.live-link')].map(code => [code.textContent.trim(),
  code.title.match(/^set (\\S+) to |^([\\w.]+): /)?.slice(1).find(Boolean) ?? null])"""


@unittest.skipUnless(CHROMIUM, "Chromium is not installed")
class Lessons(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        has_pages()
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.root = Path(made.name).resolve() / "course"
        copy_of_course(cls.root)
        cls.server = Server(cls.root, LIGHTWALK_ROOT=str(cls.root))
        cls.addClassCleanup(cls.server.__exit__)

    def opened(self, browser, lesson: str):
        browser.open(f"{self.server.base}{lesson}.html")
        browser.wait("document.body.classList.contains('live-ready')")

    def knob_of_set(self, chapter: str, name: str) -> str | None:
        """The knob that --set takes a name for: a wrong value is refused in its full name."""
        program = BUILD / "chapters" / chapter
        said = subprocess.run([program, "--set", f"{name}=@", "--list", "knobs"], text=True, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE).stderr
        found = re.match(r"error: (?:--set )?([\w.]+)(?:=@)?[: ]", said)
        return found[1] if found else None

    def test_a_link_turns_the_knob_that_set_takes(self):
        with Browser(1400, 1000, server=self.server.base) as browser:
            browser.open(self.server.address)
            for lesson in part(chapters(), 4):
                if not (BUILD / "chapters" / lesson).exists():
                    continue
                self.opened(browser, lesson)
                links = browser.evaluate(LINKS)
                known = json.loads(subprocess.run([BUILD / "chapters" / lesson, "--list", "knobs", "--json"], check=True, text=True,
                                                  stdout=subprocess.PIPE).stdout)
                full = {knob["name"] for knob in known}
                for text, knob in links:
                    name = re.sub(r"^--(set )?", "", text).split("=")[0].strip()
                    if knob is None or name.rpartition(".")[2] != knob.rpartition(".")[2]:
                        continue  # a value, or a command
                    with self.subTest(f"{lesson}: {text}"):
                        self.assertIn(knob, full)
                        self.assertEqual(knob, self.knob_of_set(lesson, name))

    def test_every_text_can_be_read_in_light_and_in_dark(self):
        for dark in (False, True):
            with Browser(1400, 1000, dark=dark, server=self.server.base) as browser:
                browser.open(self.server.address)
                for lesson in part(chapters(), 4):
                    self.opened(browser, lesson)
                    browser.evaluate("document.querySelectorAll('.live-open')[0]?.click()")
                    browser.evaluate("document.querySelectorAll('article details').forEach(one => { one.open = true; })")
                    found = browser.evaluate(CONTRAST)
                    self.assertEqual(found, {}, f"{lesson}, {'dark' if dark else 'light'}")


if __name__ == "__main__":
    unittest.main()
