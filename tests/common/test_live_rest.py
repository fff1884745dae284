"""A live page at rest and its charts, in a browser: a picture gathers sixteen samples and says so; a point of a chart has its
figures, picture, truth and error; a verdict is in view, and leads to the next exercise; an error of the compiler is said once."""

import unittest

from browser import Browser
from live_page import LivePage

PICTURE = "Picture.all[0]"
IMAGE = f"{PICTURE}.sides[0].image.src"


class Refining(LivePage):
    refine = "on"

    def test_a_picture_at_rest_gathers_sixteen_samples(self):
        with Browser(1400, 1000, server=self.server.base) as browser:
            browser.open(self.server.address)
            self.opened(browser, "02_lambert_phong")
            browser.evaluate(f"{PICTURE}.draw(true)")
            browser.wait(f"Boolean({PICTURE}.answers[0]?.format === 'png' && {IMAGE}.startsWith('blob:'))")
            first = browser.evaluate(IMAGE)
            browser.wait(f"{PICTURE}.note.textContent === '16 samples'")
            whole = browser.evaluate(IMAGE)
            self.assertNotEqual(whole, first)
            browser.evaluate(f"{PICTURE}.change({{turn_rad: 0.3}}, false)")
            self.assertEqual(browser.evaluate(f"{PICTURE}.samples"), 1)
            browser.wait(f"{PICTURE}.note.textContent !== '16 samples'")
            browser.wait(f"{PICTURE}.note.textContent === '16 samples'")
            self.assertNotEqual(browser.evaluate(IMAGE), whole)
            self.assertEqual(browser.complaints, [])


class Answering(LivePage):
    def test_a_point_of_a_chart_has_figures_picture_truth_and_error(self):
        with Browser(1400, 1000, server=self.server.base) as browser:
            browser.open(self.server.address)
            self.opened(browser, "02_lambert_phong")
            chart = "document.querySelector('.live-chart')"
            browser.evaluate(f"{chart}.dispatchEvent(new PointerEvent('pointerenter')), 0")
            browser.wait(f"Number({chart}.dataset.points) > 1", 120)
            for point in ("first", "last"):
                place = browser.evaluate(f"(async () => {{ const e = {chart}; e.scrollIntoView({{block: 'center', behavior: 'instant'}});"
                                         f"const all = (await Live.get('chart/' + e.querySelector('img').src.match(/studies\\/([\\w.]+)\\.svg/)[1])).points;"
                                         f"const p = {'all[0]' if point == 'first' else 'all.at(-1)'}, b = e.querySelector('img').getBoundingClientRect();"
                                         f"return [b.left + p.x * b.width, b.top + p.y * b.height, p.words]; }})()")
                browser.call("mouse.move", *place[:2])
                browser.wait(f"!{chart}.querySelector('.live-words').hidden")
                self.assertIn("quartiles", browser.evaluate(f"{chart}.querySelector('.live-words').textContent"))
            browser.drag(tuple(place[:2]), tuple(place[:2]))
            browser.wait("Boolean(document.querySelector('.live-errors'))")
            for title in ("its picture", "the truth", "the error"):
                browser.wait(f"document.querySelector('.live-errors img[alt=\"{title}\"]').naturalWidth === 480")
            self.assertRegex(browser.evaluate("document.querySelector('.live-errors figure:last-child').textContent"), r"^the error: FLIP 0\.\d+")
            self.assertEqual(browser.complaints, [])

    def test_a_verdict_is_in_view_and_an_error_is_said_once(self):
        with Browser(1400, 700, server=self.server.base) as browser:
            browser.open(self.server.address)
            self.opened(browser, "02_lambert_phong")
            self.addCleanup(self.file("lambert").write_text, self.file("lambert").read_text())
            browser.evaluate("document.querySelector('.run-open').click()")
            editor = "document.querySelector('.run-exercise').exercise"
            browser.wait("Boolean(document.querySelector('.CodeMirror'))")
            browser.evaluate(f"{editor}.check(), 0")
            browser.wait("Boolean(document.querySelector('.run-verdict.open'))")
            browser.wait("(box => box.top >= 0 && box.bottom < innerHeight + 1)(document.querySelector('.run-verdict').getBoundingClientRect())")
            browser.evaluate(f"{editor}.editor.setValue({editor}.editor.getValue().replace('{{', '{{ oops')), 0")
            browser.wait("Boolean(document.querySelector('.run-message'))")
            browser.wait("!Live.asked.size")
            said = "[...document.querySelectorAll('article *')].filter(e => !e.children.length && e.textContent.includes('undeclared identifier')).length"
            self.assertEqual(browser.evaluate(said), 1)
            browser.evaluate(f"{editor}.editor.setValue({(self.solution('lambert'))!r}), 0")
            browser.evaluate(f"{editor}.check(), 0")
            browser.wait("Boolean(document.querySelector('.run-verdict.ok .run-next'))")
            browser.evaluate("document.querySelector('.run-next').click()")
            browser.wait("document.querySelectorAll('.run-exercise').length === 2")
            self.assertEqual(browser.complaints, [])

    def file(self, name: str):
        return self.root / f"shaders/02_lambert_phong/exercise/{name}.glsl"

    def solution(self, name: str) -> str:
        return (self.root / f"shaders/02_lambert_phong/solution/{name}.glsl").read_text()


if __name__ == "__main__":
    unittest.main()
