"""Tests of ./course serve in a browser: lessons on a copy of the course, drawn by their programs."""

import base64
import os
import signal
import unittest
from pathlib import Path

from browser import Browser
from live_page import LivePage
from live_server import is_there
from small_course import REAL, until

CHAPTER, EXERCISE = "02_lambert_phong", "02.lambert"
FILE = f"shaders/{CHAPTER}/exercise/lambert.glsl"
SHOWN = "Picture.all[0].answers[0]"
# An image's colours, one after the other, once it is there: while one is read, an image draws nothing.
PIXELS = ("(async image => {{ await image.decode(); const c = make('canvas', {{width: 320, height: 180}}).getContext('2d'); "
          "c.drawImage(image, 0, 0, 320, 180); return [...c.getImageData(0, 0, 320, 180).data].filter((_, i) => i % 4 < 3); }})({})")
IMAGE = "Picture.all[0].sides[0].image.src"
EDITOR = "document.querySelector('.run-exercise').exercise"


@unittest.skipUnless((REAL / FILE.replace("exercise", "solution")).exists(), "a handout has no answer to type")
class InBrowser(LivePage):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser = Browser(1400, 1000, server=cls.server.base)
        cls.addClassCleanup(cls.browser.__exit__)
        cls.browser.open(cls.server.address)

    def setUp(self):
        self.browser.complaints.clear()
        self.opened(self.browser, CHAPTER)

    def tearDown(self):
        self.assertEqual(self.browser.complaints, [])

    def middle(self, selector: str) -> tuple[float, float, float]:
        """The middle of an element, which is brought into view, and its width."""
        return self.browser.evaluate(f"(e => {{ e.scrollIntoView({{block: 'center', behavior: 'instant'}}); const r = "
                                     f"e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2, r.width]; }})"
                                     f"({selector})")

    def answered(self, condition: str = "true"):
        """Waits for the whole picture after the latest request."""
        self.browser.wait(f"Boolean(!Picture.all[0].drawing_soon && !Live.asked.size && {SHOWN}?.format === 'png' && ({condition}))")

    def picture(self) -> bytes:
        return base64.b64decode(self.browser.evaluate(
            "fetch(Picture.all[0].sides[0].image.src).then(a => a.blob()).then(b => new Promise(done => { const r = new FileReader();"
            " r.onload = () => done(r.result.split(',')[1]); r.readAsDataURL(b); }))"))

    def choose(self):
        x, y, _ = self.middle("Picture.all[0].frame")
        self.browser.drag((x, y), (x, y))
        self.answered()

    def test_a_picture_is_dragged_and_its_knobs_turned(self):
        self.choose()
        first = self.picture()
        self.assertTrue(first.startswith(b"\x89PNG"))
        x, y, width = self.middle("Picture.all[0].frame")
        self.browser.drag((x, y + 60), (x + width / 4, y + 60))
        self.answered("Picture.all[0].state.turn_rad < -0.5")
        turned = self.picture()
        self.assertNotEqual(turned, first)
        row = "document.querySelector('.live-panel .live-knob input[type=range]')"
        x, y, width = self.middle(row)
        self.browser.drag((x, y), (x + width / 3, y))
        self.answered("Object.keys(Picture.all[0].state.set).length === 1")
        self.assertNotEqual(self.picture(), turned)
        self.browser.evaluate("document.querySelector('.live-panel button').click()")
        self.answered("Picture.all[0].state.turn_rad === 0 && !Object.keys(Picture.all[0].state.set).length")
        self.assertEqual(self.picture(), first)
        self.assertGreater(self.browser.evaluate(f"{SHOWN}.passes.length"), 1)

    def test_each_cell_of_a_picture_is_live(self):
        """Six methods side by side: the page crops parts of the chapter's pictures."""
        self.opened(self.browser, "04_surface_maps")
        self.browser.wait("Boolean(document.querySelectorAll('.live-grid .live-frame img[src^=\"blob:\"]').length >= 12)")
        cell = "Picture.all.find(p => p.cell?.set.method === 'relief')"

        def drawn(condition: str):
            self.browser.wait(f"Boolean(!Live.asked.size && !{cell}.drawing_soon && {cell}.answers[0]?.format === 'png' && "
                              f"{cell}.sides[0].shown === {cell}.answers[0] && ({condition}))")
            return self.browser.evaluate(PIXELS.format(f"{cell}.sides[0].image"))
        x, y, width = self.middle(f"{cell}.frame")
        shown = self.browser.evaluate(PIXELS.format(f"{cell}.sides[0].image"))
        self.browser.drag((x, y), (x, y))
        first = drawn("true")
        self.assertEqual(self.browser.evaluate(f"{cell}.answers[0].size"), [640, 360])
        # The lesson's picture has sixteen samples, this one four.
        self.assertLess(sum(abs(a - b) for a, b in zip(first, shown)) / len(first), 8)
        x, y, width = self.middle(f"{cell}.frame")
        self.browser.drag((x, y), (x + width / 4, y))
        self.assertNotEqual(drawn(f"{cell}.state.turn_rad < -0.5"), first)
        self.assertEqual(self.browser.evaluate(f"{cell}.panel.value(Knobs.find({cell}.panel.knobs, 'method'))"), "relief")

    def test_a_pair_under_a_slider_is_turned_together(self):
        self.opened(self.browser, "04_surface_maps")
        pair = "Picture.all.find(p => p.sides[1]?.cell?.[0] === '04_wall_parallax')"
        x, y, width = self.middle(f"{pair}.frame")
        self.browser.drag((x + width / 4, y), (x + width / 3, y))
        self.browser.wait(f"Boolean(!Live.asked.size && !{pair}.drawing_soon && {pair}.answers.length === 2 && {pair}.answers.every(a => a.format === 'png'))")
        self.assertLess(self.browser.evaluate(f"{pair}.state.turn_rad"), -0.1)
        self.assertEqual(self.browser.evaluate(f"{pair}.sides.map(s => s.image.src.startsWith('blob:'))"), [True, True])
        self.browser.drag((x, y), (x + width / 4, y))
        self.assertLess(abs(self.browser.evaluate(f"+{pair}.divider.value") - 75), 3)

    def test_what_moves_is_drawn_as_large_as_time_allows(self):
        scales = [self.browser.evaluate(f"Picture.scale_for({scale}, {ms})") for scale, ms in
                  ((0.5, 40), (0.5, 360), (0.5, 5000), (0.2, 10), (0.2, 90), (0.15, 1000))]
        self.assertEqual([round(scale, 3) for scale in scales], [0.5, 0.25, 0.25, 0.25, 0.2, 0.15])
        # Most of it is not for pixels: a smaller picture would not come sooner.
        self.assertAlmostEqual(self.browser.evaluate("Picture.scale_for(0.25, 300, {scale: 0.5, ms: 360})"), 0.3125)
        self.assertAlmostEqual(self.browser.evaluate("Picture.scale_for(0.25, 95, {scale: 0.5, ms: 360})"), 0.243, delta=0.001)
        self.choose()
        self.browser.evaluate("Picture.prototype.learn = () => {}; Picture.all[0].moving_scale = 0.25; "
                              "Picture.all[0].listeners.push(({answer}) => answer && (window.widths ??= []).push(answer.size[0]))")
        x, y, width = self.middle("Picture.all[0].frame")
        whole = self.browser.evaluate(f"{SHOWN}.size[0]")
        self.browser.drag((x, y + 60), (x + width / 4, y + 60))
        self.answered("Picture.all[0].state.turn_rad < -0.5")
        self.browser.wait(f"window.widths.includes({whole})")
        self.assertLessEqual(abs(min(self.browser.evaluate("window.widths")) - whole / 4), 1)

    def test_a_knob_in_the_text_is_a_link(self):
        self.choose()
        before = self.picture()
        link = "[...document.querySelectorAll('.live-link')].find(c => c.textContent === 'method')"
        self.browser.evaluate(f"{link}.click()")
        self.browser.wait("Boolean(Picture.all.some(p => p.state.set.method))")
        self.browser.wait("!Live.asked.size")
        shown = self.browser.evaluate("Picture.all.find(p => p.state.set.method).panel.element.querySelector('[data-knob=method] select').value")
        self.assertEqual(shown, self.browser.evaluate("Picture.all.find(p => p.state.set.method).state.set.method"))
        self.assertTrue(before)

    def test_two_methods_stand_under_one_slider(self):
        self.choose()
        self.browser.evaluate("(s => { s.value = s.options[1].value; s.onchange(); })(document.querySelector('.live-split'))")
        self.browser.wait("Boolean(!Live.asked.size && document.querySelector('.live-second')?.src.startsWith('blob:'))")
        x, y, width = self.middle("Picture.all[0].frame")
        self.browser.drag((x, y), (x + width / 4, y))
        self.assertLess(abs(self.browser.evaluate("+Picture.all[0].divider.value") - 75), 3)
        self.assertEqual(self.browser.evaluate("Picture.all[0].state.turn_rad"), 0)

    def test_an_exercise_from_starter_to_solved(self):
        file, answer = self.root / FILE, (REAL / FILE.replace("exercise", "solution")).read_text()
        starter = file.read_text()
        self.addCleanup(file.write_text, starter)
        self.browser.evaluate(f"document.querySelector('.run-open[data-exercise=\"{EXERCISE}\"]').click()")
        self.browser.wait("Boolean(document.querySelector('.CodeMirror'))")
        self.middle("document.querySelector('.run-exercise')")
        self.browser.evaluate(f"{EDITOR}.check()")
        self.browser.wait("Boolean(document.querySelector('.run-verdict.open'))")
        self.browser.wait("(box => box.top >= 0 && box.bottom < innerHeight + 1)(document.querySelector('.run-verdict').getBoundingClientRect())")
        self.browser.evaluate(f"{EDITOR}.editor.setValue({EDITOR}.editor.getValue().replace('{{', '{{ oops'))")
        self.browser.wait("Boolean(document.querySelector('.run-message'))")
        line = next(i for i, line in enumerate(file.read_text().splitlines()) if "oops" in line)
        self.assertIn(self.browser.evaluate("[...document.querySelectorAll('.run-mark')].length"), (1, 2))
        self.assertLessEqual(abs(self.browser.evaluate(f"{EDITOR}.editor.marks[0].line.lineNo()") - line), 1)
        self.browser.wait("!Live.asked.size")
        said = "[...document.querySelectorAll('article *')].filter(e => !e.children.length && e.textContent.includes('undeclared identifier')).length"
        self.assertEqual(self.browser.evaluate(said), 1)
        self.browser.evaluate(f"{EDITOR}.editor.setValue('')")
        self.type_text(answer)
        self.browser.wait("!document.querySelector('.run-message')")
        self.browser.evaluate(f"{EDITOR}.check()")
        self.browser.wait("Boolean(document.querySelector('.run-verdict.ok'))")
        self.assertEqual(file.read_text(), answer)
        self.assertIn("1 of ", self.browser.evaluate("document.querySelector('.live-progress').textContent"))
        self.browser.evaluate("document.querySelector('.run-verdict.ok .run-next').click()")
        self.browser.wait("document.querySelectorAll('.run-exercise').length === 2")
        self.browser.open(f"{self.server.base}{CHAPTER}.html")  # which waits for the new page; a reload would answer before
        self.browser.wait("document.querySelector('.live-progress')?.textContent.startsWith('1 of ')")

    def type_text(self, text: str):
        self.browser.evaluate(f"{EDITOR}.editor.focus()")
        self.browser.call("keyboard.insertText", text)

    def test_a_file_that_is_changed_on_disk_is_not_overwritten(self):
        file = self.root / FILE
        starter = file.read_text()
        self.addCleanup(file.write_text, starter)
        self.browser.evaluate(f"document.querySelector('.run-open[data-exercise=\"{EXERCISE}\"]').click()")
        self.browser.wait("Boolean(document.querySelector('.CodeMirror'))")
        file.write_text(starter + "// theirs\n")
        self.browser.wait(f"{EDITOR}.editor.getValue().endsWith('theirs\\n')")
        self.browser.evaluate(f"clearTimeout({EDITOR}.typing); {EDITOR}.save = () => {{}}")
        self.browser.evaluate(f"{EDITOR}.editor.setValue('// mine')")
        file.write_text(starter + "// again\n")
        self.browser.wait("Boolean(document.querySelector('.run-conflict'))")
        self.assertTrue(file.read_text().endswith("again\n"))
        self.browser.evaluate("document.querySelector('.run-conflict button').click()")
        self.assertTrue(self.browser.evaluate(f"{EDITOR}.editor.getValue()").endswith("again\n"))

    def test_a_point_of_a_chart_has_figures_picture_truth_and_error(self):
        chart = "document.querySelector('.live-chart')"
        self.browser.evaluate(f"{chart}.dispatchEvent(new PointerEvent('pointerenter')), 0")
        self.browser.wait(f"Number({chart}.dataset.points) > 1", 120)
        for point in ("first", "last"):
            place = self.browser.evaluate(f"(async () => {{ const e = {chart}; e.scrollIntoView({{block: 'center', behavior: 'instant'}});"
                                          f"const all = (await Live.get('chart/' + e.querySelector('img').src.match(/studies\\/([\\w.]+)\\.svg/)[1])).points;"
                                          f"const p = {'all[0]' if point == 'first' else 'all.at(-1)'}, b = e.querySelector('img').getBoundingClientRect();"
                                          f"return [b.left + p.x * b.width, b.top + p.y * b.height, p.words]; }})()")
            self.browser.call("mouse.move", *place[:2])
            self.browser.wait(f"!{chart}.querySelector('.live-words').hidden")
            self.assertIn("quartiles", self.browser.evaluate(f"{chart}.querySelector('.live-words').textContent"))
        self.browser.drag(tuple(place[:2]), tuple(place[:2]))
        self.browser.wait("Boolean(document.querySelector('.live-errors'))")
        for title in ("its picture", "the truth", "the error"):
            self.browser.wait(f"document.querySelector('.live-errors img[alt=\"{title}\"]').naturalWidth === 480")
        self.assertRegex(self.browser.evaluate("document.querySelector('.live-errors figure:last-child').textContent"), r"^the error: FLIP 0\.\d+")

    def test_a_crash_is_said_and_mended(self):
        self.choose()
        program = [int(path.parent.name) for path in Path("/proc").glob("[0-9]*/cmdline") if is_ours(path, self.server.process.pid)]
        self.assertEqual(len(program), 1)
        os.kill(program[0], signal.SIGSEGV)
        until(lambda: not is_there(program[0]) or is_zombie(program[0]))
        said = "new MutationObserver(() => { const t = Picture.all[0].note.textContent; if (t) (window.said ??= []).push(t); })" \
               ".observe(Picture.all[0].note, {childList: true, characterData: true, subtree: true})"
        self.browser.evaluate(said)
        self.browser.evaluate("Picture.all[0].change({turn_rad: 1})")
        self.browser.wait("Boolean(window.said?.some(t => t.includes('SIGSEGV')))")
        self.answered(f"{SHOWN}.code === 0")


class Refining(LivePage):
    refine = "on"

    def test_a_picture_at_rest_gathers_sixteen_samples(self):
        with Browser(1400, 1000, server=self.server.base) as browser:
            browser.open(self.server.address)
            self.opened(browser, "02_lambert_phong")
            browser.evaluate("Picture.all[0].draw(true)")
            browser.wait(f"Boolean({SHOWN}?.format === 'png' && {IMAGE}.startsWith('blob:'))")
            first = browser.evaluate(IMAGE)
            browser.wait("Picture.all[0].note.textContent === '16 samples'")
            whole = browser.evaluate(IMAGE)
            self.assertNotEqual(whole, first)
            browser.evaluate("Picture.all[0].change({turn_rad: 0.3}, false)")
            self.assertEqual(browser.evaluate("Picture.all[0].samples"), 1)
            browser.wait("Picture.all[0].note.textContent !== '16 samples'")
            browser.wait("Picture.all[0].note.textContent === '16 samples'")
            self.assertNotEqual(browser.evaluate(IMAGE), whole)
            self.assertEqual(browser.complaints, [])


def is_ours(path: Path, parent: int) -> bool:
    """A chapter's program that the server has started."""
    try:
        return b"--pictures" in path.read_bytes() and f"PPid:\t{parent}\n" in (path.parent / "status").read_text()
    except OSError:
        return False


def is_zombie(pid: int) -> bool:
    return "State:\tZ" in Path(f"/proc/{pid}/status").read_text()
