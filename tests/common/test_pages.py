"""Tests of the lessons' pages as they are: their links, what a browser shows of them, and the search."""

import json
import re
import unittest
from pathlib import Path
from urllib.parse import unquote

from browser import WHY_NONE, Browser
from html_seen import Seen
from live_page import has_pages

from tree import BUILD, chapters, exercises, lessons

# Text that ought to be a formula, outside of code: its TeX, or Markdown's sign for it.
LEFT_OVER = r"""(() => {
  const walker = document.createTreeWalker(document.querySelector("article"), NodeFilter.SHOW_TEXT), found = [];
  while (walker.nextNode()) {
    const node = walker.currentNode;
    if (!node.parentElement.closest("code, .katex-mathml, script, style") && /\$|\\[a-zA-Z(\[]|```|\?\?\? "/.test(node.data))
      found.push(node.data.trim());
  }
  return found;
})()"""
BROKEN = "Promise.all([...document.images].map(i => i.decode().then(() => '', () => i.src))).then(all => all.filter(Boolean))"
UNSET = "[...document.querySelectorAll('.arithmatex')].filter(f => !f.querySelector('.katex') || " \
        "f.querySelector('.katex-error')).map(f => f.textContent)"
# Code that is cut at the side of its block.
CUT = "[...document.querySelectorAll('pre > code')].filter(c => c.scrollWidth > c.clientWidth + 1).map(c => c.textContent.slice(0, 60))"
PHONE = 390, 844
WINDOW = 1280, 900
WIDTHS = "[innerWidth, document.documentElement.scrollWidth]"
ASK = """new Promise(done => {
  document.querySelector("[data-md-toggle=search]").click();
  const field = document.querySelector("[data-md-component=search-query]"), end = Date.now() + 90000;
  setTimeout(() => {
    field.focus(); field.value = %s; field.dispatchEvent(new Event("keyup", {bubbles: true}));
    const look = () => {
      const hits = [...document.querySelectorAll(".md-search-result__link")].map(a => a.href);
      hits.length || Date.now() > end ? done(hits) : setTimeout(look, 100);
    };
    look();
  }, 300);
})"""


class TheCourse(unittest.TestCase):
    """The pages of the tree as it is. They stay in the build folder: the report links them."""

    folder = BUILD / "docs"

    @classmethod
    def setUpClass(cls):
        has_pages()
        cls.pages = sorted(cls.folder.rglob("*.html"))
        cls.lessons = [cls.folder / page.with_suffix(".html").name for page in lessons()]


class Pages(TheCourse):
    def test_every_link_leads_to_a_file_and_a_heading(self):
        found = {page: Seen(page.read_text(encoding="utf-8")) for page in self.pages}
        self.assertGreater(sum(len(links.links) for links in found.values()), 500)
        for page, links in found.items():
            for tag, link in links.links:
                if re.match(r"(https?|data|mailto):", link):
                    self.assertEqual(tag, "a", f"{page} loads {link}")
                    continue
                path, _, anchor = unquote(link).partition("#")
                target = (page.parent / path).resolve() if path else page
                self.assertTrue(target.is_file() and target.is_relative_to(self.folder), f"{page}: {link}")
                if anchor and target.suffix == ".html" and not anchor.startswith("__"):
                    self.assertIn(anchor, found[target].names, f"{page}: {link}")

    def test_each_exercise_has_an_address_that_opens_at_it(self):
        names = {page.stem: Seen(page.read_text(encoding="utf-8")).names for page in self.lessons}
        for exercise in [exercise for chapter in chapters() for exercise in exercises(chapter)]:
            [page] = [stem for stem in names if exercise in names[stem]]
            self.assertIn(f"../{page}.html#{exercise}", (self.folder / "open" / f"{exercise}.html").read_text())

    def test_the_index_of_the_search_is_in_no_page(self):
        """It has 3 MB, and the search reads all of it: with each page, before."""
        if (self.folder / "search/search_index.json").exists():
            self.skipTest("this version of the theme reads its index itself")
        self.assertEqual([page for page in self.pages if "search_index" in page.read_text(encoding="utf-8")], [])

    def test_a_lesson_leads_to_the_next(self):
        for before, after in zip(self.lessons, self.lessons[1:]):
            self.assertIn(f'href="{after.name}" class="md-footer__link md-footer__link--next"', before.read_text())
            self.assertIn(f'href="{before.name}" class="md-footer__link md-footer__link--prev"', after.read_text())


@unittest.skipIf(WHY_NONE, WHY_NONE)
class InBrowser(TheCourse):
    def test_every_page_is_whole_keeps_to_itself_and_fits_a_phone(self):
        """Each is opened once, which takes longest; a lesson is then looked at as a phone shows it."""
        looked_at, formulas = self.looked_at(), 0
        for webgl in (True, False):  # listings and studies draw nothing, and load in two thirds of the time without it
            with Browser(webgl=webgl) as browser:
                for page in looked_at:
                    if webgl != ("run/gl.js" in page.read_text(encoding="utf-8")):
                        continue
                    browser.open(page)
                    self.look(browser, page)
                    if page in self.lessons:
                        browser.resize(*PHONE)
                        self.look(browser, page)
                        self.assertEqual(browser.evaluate(WIDTHS), [390, 390], page)
                        formulas += browser.evaluate("document.querySelectorAll('.katex').length")
                        browser.resize(*WINDOW)
        self.assertGreater(formulas, 100)

    def look(self, browser: Browser, page: Path):
        with self.subTest(page=page.name):
            self.assertEqual(browser.evaluate(BROKEN), [])
            self.assertEqual(browser.evaluate(UNSET), [])
            self.assertEqual(browser.evaluate(LEFT_OVER), [])
            self.assertEqual(browser.evaluate(CUT), [])
            self.assertFalse(browser.evaluate("document.documentElement.scrollWidth > innerWidth"))
            self.assertEqual(browser.complaints, [])

    def looked_at(self) -> list[Path]:
        """A third of the lessons, and of NAME.KIND.html (listings, studies) one of each kind; not the pages that lead on to an
        exercise."""
        pages = [page for page in self.pages if page.parent.name != "open"]
        kinds = {page.name.split(".")[-2] if page.name.count(".") > 1 else page: page for page in reversed(pages)}
        shown = self.lessons[::3]
        return [page for page in kinds.values() if page not in self.lessons or page in shown]

    def test_search_finds_and_leads_there(self):
        with Browser(webgl=True) as browser:
            for words, page in (("half vector", "02_lambert_phong.html"), ("clusters", "03_attenuation.html")):
                browser.open(self.folder / "index.html")
                hits = browser.evaluate(ASK % json.dumps(words))
                self.assertTrue(any(page in hit for hit in hits), hits)
                self.assertFalse([hit for hit in hits if not hit.startswith("file:")])
                self.assertEqual(browser.complaints, [])
            browser.open(self.folder / "index.html")
            self.assertEqual(browser.evaluate((ASK % '"xyzzyplugh"').replace("90000", "2000")), [])

    def test_an_exercises_address_opens_at_it(self):
        with Browser(webgl=True) as browser:
            browser.open(self.folder / "open" / "02.phong.html")
            until = "new Promise(f => { const t = setInterval(() => { if (scrollY > 500) { clearInterval(t); f(true); } }, 50);" \
                    " setTimeout(() => f(false), 15000); })"
            browser.wait("location.pathname.endsWith('02_lambert_phong.html') && document.readyState === 'complete'")
            self.assertTrue(browser.evaluate(until))
            self.assertIn("02_lambert_phong.html#02.phong", browser.evaluate("location.href"))
