"""The report and the gallery: their contents, and their behaviour in a browser (if Chromium is installed)."""
# Builds: nothing

import json
import unittest

from PIL import Image

from browser import WHY_NONE, Browser
from folder_case import FolderCase
from pages.page import chart_uri, data_uri
from pages.report import write_report
from tree import ROOT

LIMITS = {"flip_mean": 0.002, "flip_p99": 0.05, "max_diff": 64}
JUNIT = """<?xml version="1.0"?>
<testsuite name="x" tests="4" failures="3">
  <testcase name="unit.good" time="1.25" status="run"><system-out>fine</system-out></testcase>
  <testcase name="unit.bad" time="0.5" status="fail"><failure message=""/><system-out>{output}</system-out></testcase>
  <testcase name="shot.02.bad" time="1" status="fail"><failure message=""/><system-out>no</system-out></testcase>
  <testcase name="unit.later" time="0" status="notrun"/>
</testsuite>
"""


def metrics(mean, p99, steps):
    return {"flip": {"mean": mean, "p99": p99}, "max_diff": {"steps": steps, "x": 3, "y": 4},
            "nan": {"reference": 0, "test": 0}, "inf": {"reference": 0, "test": 0}}


class ReportCase(FolderCase):
    def setUp(self):
        self.results = self.folder / "results"
        self.results.mkdir()
        self.page = self.folder / "report" / "index.html"

    def picture(self, name, colour):
        path = self.folder / name
        Image.new("RGB", (96, 54), colour).save(path)
        return str(path)

    def result(self, kind, name, **entries):
        data = {"kind": kind, "chapter": "02_lambert_phong", "name": name, "again": f"./course again {name}", **entries}
        (self.results / f"{kind}.{name}.json").write_text(json.dumps(data))

    def shot(self, name, ok, figures, expected="expected.png", actual="actual.png", kind="shot"):
        picture = {"name": name, "ok": ok, "metrics": figures, "expected": expected and str(self.folder / expected),
                   "actual": actual and str(self.folder / actual),
                   "heatmap": str(self.folder / "heat.png") if figures else None}
        self.result(kind, name, caption=f"What {name} shows.", ok=ok, limits=LIMITS, pictures=[picture],
                    why=[] if ok else [f"{name} is <wrong> & bad"])

    def some_results(self):
        for name, colour in (("expected.png", "#336699"), ("actual.png", "#3a6a99"), ("heat.png", "#221144")):
            self.picture(name, colour)
        self.shot("good", True, metrics(0.0001, 0.001, 3))
        self.shot("equal", True, metrics(0, 0, 0))
        self.shot("bad", False, metrics(0.1, 0.2, 90))
        self.shot("new", False, None, expected=None)
        self.shot("hard", True, metrics(0.3, 0.5, 200), kind="wrong_picture")
        self.result("probe", "reflection", rows=[
            {"case": "02.phong", "inputs": "9", "worst": 1.5, "bound": "2 ULP", "ok": True, "text": None},
            {"case": "02.blinn", "inputs": "9", "worst": "NaN", "bound": 0, "ok": False, "text": "f(x = 0) < nothing"}])
        self.result("stability", "edges", rows=[
            {"case": "L = -V", "inputs": "H = 0", "worst": 0, "bound": 0, "ok": True, "text": "no highlight"}])
        svg = self.folder / "chart.svg"
        svg.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200">'
                       '<rect width="300" height="200" fill="#dde"/></svg>')
        (self.folder / "chart.md").write_text("| method | ms |\n| --- | ---: |\n| a\\|b | 3 |\n\nnote\n")
        self.result("chart", "study", picture=str(svg), table=str(self.folder / "chart.md"))
        (self.results / "tests.xml").write_text(JUNIT.format(output="line\n" * 100 + "1 == 2 &lt;b&gt;"))

    def write(self):
        write_report(self.results, self.page)
        return self.page.read_text()


class ReportText(ReportCase):
    def test_what_failed_stands_first_and_says_how_to_look_closer(self):
        self.some_results()
        html = self.write()
        failed, chapters = html.replace("&#39;", "'").split('<section id="02_lambert_phong">')
        self.assertIn('badge bad">4 failed', failed)  # bad, new, reflection, unit.bad; shot.02.bad is bad again
        for text in ("bad is &lt;wrong&gt; &amp; bad", "./course again bad", "build/compare", "./course accept 02.bad",
                     "02.blinn", "f(x = 0) &lt; nothing", "unit.bad", "1 == 2 &lt;b&gt;", "./course test '^unit.bad$'",
                     "41 lines before", "there is none"):
            self.assertIn(text, failed)
        for text in ("What good shows.", "02.phong", "unit.good", "<span>02 Lambert and Phong shading</span>"):
            self.assertNotIn(text, failed)
            self.assertIn(text, chapters)
        self.assertEqual(html.count("class=over"), 3)  # bad is over each limit; rejected pictures are right
        self.assertIn("image/png", failed)  # exact where it matters
        self.assertNotIn("image/webp", failed)
        self.assertIn("image/webp", chapters)
        self.assertIn('href="#failed-shot.02_lambert_phong.bad"', chapters)
        self.assertIn('id="failed-shot.02_lambert_phong.bad"', failed)

    def test_tables_say_rejected_within_and_outside(self):
        self.some_results()
        html = self.write()
        self.assertEqual(html.count(">rejected<"), 1)
        self.assertIn(">outside<", html)
        self.assertIn("<td>a|b</td>", html)

    def test_it_is_self_contained(self):
        self.some_results()
        html = self.write().replace("http://www.w3.org", "")
        for outside in ("http:", "https:", "//cdn", 'src="/', "url(", "@import"):
            self.assertNotIn(outside, html)

    def test_all_pictures_and_charts_are_below_10_mb(self):
        """Of all goldens, as where every test has passed, by the mean of some."""
        mega = 0.0
        for files, embedded in ((ROOT.glob("tests/*/golden/*.png"), lambda file: data_uri(file, lossless=False)),
                                (ROOT.glob("docs/studies/*.png"), chart_uri)):
            files = sorted(files)
            chosen = files[::8]
            mega += sum(len(embedded(file)) for file in chosen) / len(chosen) * len(files) / 1e6
        self.assertLess(mega + 1.5, 10, "with 1.5 MB of figures and words")

    def test_what_cannot_be_read_is_a_failure(self):
        (self.results / "shot.torn.json").write_text('{"kind": "sh')
        (self.results / "tests.xml").write_text("<testsuite")
        html = self.write()
        self.assertIn("2 failed", html)
        self.assertIn("shot.torn.json cannot be used", html)
        self.assertIn("tests.xml cannot be read", html)

    def test_a_missing_picture_is_named(self):
        self.some_results()
        (self.folder / "actual.png").unlink()
        (self.folder / "heat.png").write_text("no picture")
        html = self.write()
        self.assertIn("bad, actual: ", html)
        self.assertNotIn('src=""', html)


@unittest.skipIf(WHY_NONE, WHY_NONE)
class InBrowser(ReportCase):
    def test_the_report_has_no_broken_picture_no_complaint_and_its_slider_moves(self):
        self.some_results()
        self.write()
        with Browser() as browser:
            browser.open(self.page)
            broken = "[...document.images].filter(i => !(i.complete && i.naturalWidth)).map(i => i.alt)"
            self.assertEqual(browser.evaluate(broken), [])
            studies = sum(len(list((ROOT / "docs" / "studies").glob(f"{chapter}*.png")))
                          for chapter in {json.loads(f.read_text())["chapter"] for f in self.results.glob("*.json")})
            self.assertEqual(browser.evaluate("document.images.length"), 10 + studies)
            self.assertEqual(browser.evaluate("document.querySelectorAll('.slide').length"), 3)
            self.assertFalse(browser.evaluate("document.documentElement.scrollWidth > innerWidth"))
            shown = "getComputedStyle(document.querySelector('.slide img + img')).clipPath"
            before = browser.evaluate(shown)
            self.assertIn("50%", before)

            browser.evaluate("document.querySelector('.slide input').focus()")
            for _ in range(5):
                browser.press("ArrowRight")
            self.assertIn("55%", browser.evaluate(shown))
            self.assertEqual(browser.complaints, [])
