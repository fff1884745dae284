"""The site in a browser (Chromium, WebGL by software): programs that are drawn and edited, exercises that are solved, answers as
files, reading without a network; from files and from a server of files."""

import html
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path
from statistics import mean
from unittest import mock

from browser import WHY_NONE, Browser
from contrast import hard_to_read
from site_page import COLORS, DRAWN, DRAWN_BY, LAMBERT, PICTURE, SQUARE, Solving, remove, serve, site

from charts.drawn import DRAWN as DRAWN_CHARTS
from pages import docs, drawn_pictures, knob_links, publish, running, states
from shots.golden import golden_path
from tree import UsageError, lessons

tearDownModule = remove

PHONE = 390, 844
LOADED = "performance.getEntriesByType('resource').reduce((sum, one) => sum + one.encodedBodySize, " \
         "performance.getEntriesByType('navigation')[0].encodedBodySize)"
MOST_PAGE_BYTES = 1_500_000
STATES = "States.all.find(one => one.has('method', 'gouraud'))"


def state_bytes(golden: Path) -> int:
    """Size of a golden as a state's file; its one sample is noisier than a state."""
    from PIL import Image

    with tempfile.TemporaryDirectory() as folder, Image.open(golden) as picture:
        picture.thumbnail(states.SIZE)
        picture.save(Path(folder, "state.png"))
        return len(drawn_pictures.webp(Path(folder, "state.png")))


@unittest.skipIf(WHY_NONE, WHY_NONE)
class InBrowser(Solving):
    def test_the_start_page_has_a_shader_to_change_and_leads_to_the_first_exercise(self):
        with Browser(webgl=True) as browser:
            browser.open(site() / "index.html")
            if clip_there := (site() / "assets/start.mp4").exists():
                browser.wait("(film => film.muted && film.loop && film.currentTime > 0)(document.querySelector('.hero video'))")
                browser.evaluate("document.querySelector('.hero > div').click()")
                self.assertTrue(browser.evaluate("document.querySelector('.hero video').paused"))
            self.assertEqual(clip_there, bool(shutil.which("ffmpeg")))
            browser.evaluate("Program.all[0].canvas.scrollIntoView({behavior: 'instant'})")
            browser.wait(DRAWN_BY % 0)
            browser.evaluate("Program.all[0].edit().then(() => 0)")
            before = browser.evaluate(PICTURE % 0)
            number = browser.evaluate("Program.all[0].constants()[0].name")
            browser.evaluate(f"Program.all[0].sliders.querySelectorAll('label').forEach(one => {{ if (one.textContent.startsWith('{number}'))"
                             " { const range = one.querySelector('input'); range.value = 0.7 * range.value; range.oninput(); } }), 0")
            browser.wait(f"Program.all[0].said.textContent === '' && {PICTURE % 0} !== {json.dumps(before)}")
            self.assertNotEqual(browser.evaluate("Program.all[0].editor.getValue()"), browser.evaluate("Program.all[0].first"))
            browser.evaluate("Program.all[0].editor.setValue(Program.all[0].text.replace('void main() {', 'void main() { no_such;')), 0")
            browser.wait("Program.all[0].said.textContent.includes('no_such') && document.querySelector('.run-message') ? 1 : 0")
            browser.evaluate("Program.all[0].reset()")
            browser.wait("Program.all[0].said.textContent === '' && Program.all[0].text === Program.all[0].first")
            browser.evaluate("document.querySelector('.try a[href*=\"#02.lambert\"]').click()")
            browser.wait("location.hash === '#02.lambert' && document.querySelector('[data-exercise=\"02.lambert\"]') ? 1 : 0")
            self.assertEqual(browser.complaints, [])

    def test_a_first_exercise_is_solved_and_seen_from_a_file(self):
        for page, exercise, answer, program in (("02_lambert_phong", "02.lambert", LAMBERT, 0), ("11_fractals", "11.quaternion_square", SQUARE, 0)):
            with self.subTest(exercise), Browser(webgl=True) as browser:
                browser.open(site() / f"{page}.html")
                self.solve(browser, exercise, answer)
                self.press(browser, exercise, "See it in the picture")
                browser.wait(f"{DRAWN_BY % program} && Program.all[{program}].mine.size && Program.all[{program}].said.textContent === ''")
                browser.wait(f"{COLORS % program} > 20")
                following = browser.evaluate("document.querySelector('.run-next').textContent")
                self.assertEqual(following, {"02.lambert": "02.wrapped_diffuse", "11.quaternion_square": "11.julia_distance"}[exercise])
                mine = "document.querySelector('.run-progress').textContent"
                self.assertRegex(browser.evaluate(mine), r"^1 of \d+ solved$")
                browser.open(site() / f"{page}.html")
                self.assertRegex(browser.evaluate(mine), r"^1 of \d+ solved$", "the browser did not keep it")
                self.assertEqual(browser.complaints, [])

    def test_each_place_of_an_answer_is_in_its_program(self):
        for name, scene in running.scenes().items():
            text = scene.get("text") or (running.MINIMAL / f"{name}.frag").read_text()
            for exercise, (old, *_, last) in scene.get("mine", {}).items():
                self.assertEqual(text.count(old), 1, f"{name}: {exercise}")
                self.assertTrue(len(scene["mine"][exercise]) == 2 or last in text, f"{name}: {exercise}")

    def test_answers_travel_as_files(self):
        with Browser(webgl=True) as browser:
            browser.open(site() / "02_lambert_phong.html")
            self.solve(browser, "02.lambert", LAMBERT)
            names = "Answers.archive().then(blob => blob.arrayBuffer()).then(data => Answers.unpacked(new Uint8Array(data)))"
            self.assertEqual(browser.evaluate(names), [["shaders/02_lambert_phong/exercise/lambert.glsl", LAMBERT]])
            data = bytes(browser.evaluate("Answers.archive().then(blob => blob.arrayBuffer()).then(data => [...new Uint8Array(data)])"))
            with tempfile.TemporaryDirectory() as folder:
                import tarfile

                Path(folder, "answers.tar").write_bytes(data)
                with tarfile.open(Path(folder, "answers.tar")) as archive:
                    self.assertEqual(archive.extractfile("shaders/02_lambert_phong/exercise/lambert.glsl").read().decode(), LAMBERT)
            said = browser.evaluate("Answers.import_files([new File(['float a;'], 'lambert.glsl'), new File(['?'], 'none.glsl')])")
            self.assertEqual(said, "imported 02.lambert; no exercise of these pages: none.glsl")
            self.assertEqual(browser.evaluate("Exercise.all.get('02.lambert').editor.getValue()"), "float a;")

    def test_by_keyboard_on_a_phone_and_in_the_dark(self):
        with Browser(webgl=True, dark=True) as browser:
            browser.resize(*PHONE)
            self.turn_by_keys(browser)
            self.assertEqual(browser.evaluate("[innerWidth, document.documentElement.scrollWidth]"), [390, 390])
            self.assertEqual(browser.evaluate("getComputedStyle(document.body).backgroundColor"), "rgb(20, 24, 31)")
            # A chart keeps the size of its words, and is dark.
            chart = "document.querySelector('article img[src*=\"studies/\"]')"
            self.assertGreater(browser.evaluate(f"{chart}.getBoundingClientRect().width"), 600)
            self.assertIn("invert", browser.evaluate(f"getComputedStyle({chart}).filter"))

    def test_names_in_the_text_and_controls_turn_a_picture(self):
        """From a file, and by the keyboard."""
        with Browser(1280, 900) as browser:
            browser.open(site() / "02_lambert_phong.html")
            self.assertGreater(browser.evaluate("document.querySelectorAll('.states-link').length"), 10)
            first = browser.evaluate(f"{STATES}.image.getAttribute('src')")
            browser.evaluate(f"{STATES}.image.scrollIntoView({{block: 'center', behavior: 'instant'}}), {STATES}.image.decode().then(() => 0)")
            wide = browser.evaluate(f"{STATES}.image.width")
            browser.evaluate(f"{STATES}.set('method', 'gouraud'), 0")
            state = browser.evaluate(f"{STATES}.image.getAttribute('src')")
            self.assertRegex(state, r"^states/02/\w+\.\w+\.webp$")
            browser.wait(f"{STATES}.image.complete && {STATES}.image.naturalWidth === 480")
            self.assertEqual(browser.evaluate(f"{STATES}.image.width"), wide)
            browser.evaluate(f"{STATES}.beside.click()")
            pair = f"[...{STATES}.frame.querySelectorAll('img')].map(one => one.getAttribute('src'))"
            self.assertEqual(browser.evaluate(pair)[1], state)
            browser.evaluate(f"{STATES}.frame.querySelector('input').focus()")
            before = browser.evaluate(f"{STATES}.frame.querySelector('input').value")
            browser.press("ArrowRight")
            self.assertNotEqual(browser.evaluate(f"{STATES}.frame.querySelector('input').value"), before)
            base = browser.evaluate(f"{STATES}.find('method').base")
            browser.evaluate(f"{STATES}.set('method', {json.dumps(base)}), 0")
            self.assertEqual(browser.evaluate(f"[{STATES}.image.getAttribute('src'), {STATES}.frame]"), [first, None])
            # Far from its picture, a name brings a copy into the corner.
            browser.evaluate("window.link = [...document.querySelectorAll('.states-link')].pop(); link.scrollIntoView({block: 'center', behavior: 'instant'}); link.click(); 0")
            browser.wait("document.querySelector('.states-dock img')?.naturalWidth > 300")
            self.assertEqual(browser.complaints, [])

    def test_a_point_of_a_chart_shows_its_picture(self):
        with Browser(1280, 900) as browser:
            browser.open(site() / "02_lambert_phong.html")
            count = browser.evaluate("document.querySelectorAll('.states-chart button').length")
            self.assertGreater(count, 2)
            browser.evaluate("document.querySelector('.states-chart button').click()")
            browser.wait("document.querySelector('.states-dock img')?.naturalWidth === 480")
            self.assertIn("quartiles", browser.evaluate("document.querySelector('.states-dock').textContent"))
            self.assertEqual(browser.complaints, [])

    def test_a_server_of_files_and_then_none(self):
        address, end = serve()
        with Browser(webgl=True, server=address) as browser:
            self.read_offline(browser, address, end)

    def test_every_page_keeps_to_its_budget_before_a_click_and_can_be_read(self):
        """Lessons and other texts, and of pages of sources the largest of each folder. Texts in light and in dark, with an editor
        and all that folds open."""
        largest = {page.relative_to(site()).parts[0]: page for page in sorted(site().glob("*/**/*.html"), key=lambda page: page.stat().st_size)
                   if page.parent.name != "open"}
        shown, loaded = [*sorted(site().glob("*.html")), *largest.values()], {}
        read = {"index", DRAWN[0], *(lesson.stem for lesson in lessons()[::6])}
        address, end = serve()
        self.addCleanup(end)
        with Browser(webgl=True, server=address) as browser:
            for page in shown:
                browser.open(f"{address}{page.relative_to(site())}")
                loaded[page] = browser.evaluate(LOADED)
                if page.stem in read:
                    browser.evaluate("document.querySelector('.run-open')?.click()")
                    browser.evaluate("[...document.querySelectorAll('article details')].forEach(one => { one.open = true; })")
                    self.assertEqual(hard_to_read(browser), {}, page)
                self.assertEqual(browser.complaints, [])
        print(f"of {len(loaded)} pages {max(loaded, key=loaded.get).name} loads most: {max(loaded.values()) / 1e6:.2f} MB")
        self.assertEqual({page.name: size for page, size in loaded.items() if size >= MOST_PAGE_BYTES}, {})


class OnDisk(unittest.TestCase):
    def test_a_picture_has_at_most_eight_states(self):
        from PIL import Image

        page = (site() / "02_lambert_phong.html").read_text()
        told = [json.loads(html.unescape(found)) for found in re.findall(r'data-states="([^"]*)"', page)]
        self.assertGreater(len(told), 2)
        for one in told:
            files = [file for knob in one["knobs"] for file in knob["files"].values()]
            self.assertTrue(1 <= len(files) <= 8, files)
            for file in [one["base"], *files]:
                with Image.open(site() / file) as picture:
                    self.assertLessEqual(picture.width, 480)
                    self.assertEqual(picture.format, "WEBP")
        drawn = {path.relative_to(site()).as_posix() for path in (site() / "states").rglob("*.webp")}
        self.assertEqual(drawn, {file for one in told for file in [one["base"], *(f for knob in one["knobs"] for f in knob["files"].values())]} |
                         {point["file"] for found in re.findall(r'data-points="([^"]*)"', page) for point in json.loads(html.unescape(found))})

    def test_its_size_with_the_pictures_of_all_chapters(self):
        """The test draws one chapter's. A state of another one is counted with the size of its golden as a state's file."""
        size = sum(path.stat().st_size for path in site().rglob("*") if path.is_file())
        states_of_all = 0
        for name, text in site.lessons.items():
            chapter = knob_links.chapter_of(name)
            if not chapter or chapter in DRAWN:
                continue
            plan = states.planned(text, chapter, knob_links.knobs_of(chapter))
            for shot in [*(one[0] for one in plan), *{one[0] for one in plan}]:
                states_of_all += state_bytes(golden_path(chapter, shot))
            points = sum(len(states.points_of(chart)) for chart in states.CHART.findall(text))
            states_of_all += points * mean(state_bytes(golden) for golden in golden_path(chapter, "").parent.glob("*.png"))
        print(f"the site: {size / 1e6:.1f} MB, and {states_of_all / 1e6:.1f} MB of states")
        self.assertGreater(states_of_all, 2e6)
        self.assertLess(size + states_of_all, publish.MOST_BYTES)

    def test_a_shorter_chart_is_the_same_picture(self):
        from PIL import Image, ImageChops, ImageStat

        chart = DRAWN_CHARTS / "04_surface_maps.h200.svg"
        shorter = site() / "studies" / chart.name
        self.assertLess(shorter.stat().st_size, 0.75 * chart.stat().st_size)
        with tempfile.TemporaryDirectory() as folder, Browser(960, 1100) as browser:
            pictures = []
            for file in (chart, shorter):
                Path(folder, "page.html").write_text(f'<img src="{file.as_uri()}">')
                browser.open(Path(folder, "page.html"))
                browser.wait("document.images[0].naturalWidth > 0")
                browser.picture(Path(folder, "seen.png"))
                with Image.open(Path(folder, "seen.png")) as picture:
                    pictures.append(picture.convert("L"))
        self.assertLess(ImageStat.Stat(ImageChops.difference(*pictures)).mean[0], 0.1)
        self.assertGreater(ImageStat.Stat(pictures[0]).stddev[0], 20)

    def test_its_exercises(self):
        listed = json.loads((site() / "assets/tables/list.json").read_text())
        self.assertGreaterEqual(len(listed["in_the_page"]), 60)
        self.assertFalse(set(listed["in_the_page"]) & set(listed["elsewhere"]))
        self.assertIn("01.triangulate", listed["elsewhere"])

    def test_every_picture_says_its_size(self):
        """Pictures come in as one scrolls: without sizes an exercise's address would lead elsewhere."""
        for lesson in lessons():
            page = (site() / f"{lesson.stem}.html").read_text()
            self.assertEqual(re.findall(r"<img (?![^>]*width=)[^>]*>", page), [], lesson)

    def test_a_policy_in_every_page(self):
        pages = [page for page in site().rglob("*.html") if page.parent.name != "open"]  # which only lead on
        self.assertGreater(len(pages), 50)
        for page in pages:
            self.assertIn("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'self'", page.read_text(), page)

    def test_a_folder_with_other_files_is_left_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "mine").write_text("x")
            with self.assertRaisesRegex(UsageError, "it has other files in it"):
                publish.write(Path(folder))
            self.assertEqual([path.name for path in Path(folder).iterdir()], ["mine"])
            Path(folder, "mine").unlink()
            Path(folder, publish.MARK).write_text("an older site")
            Path(folder, ".git").mkdir()
            with self.assertRaisesRegex(UsageError, "it is a repository, and would be replaced whole"):
                publish.write(Path(folder))

    def test_a_folder_named_from_here_is_taken_from_here(self):
        """As the workflow names it; mkdocs has a folder of its own in mind."""
        def build_site(source, made):
            self.assertTrue(source.is_absolute() and made.is_absolute(), source)
            made.mkdir()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(docs, "write_sources", Path.mkdir), \
                mock.patch.object(docs, "build_site", build_site), mock.patch.object(docs, "finish"):
            os.chdir(folder)
            self.assertEqual(docs.make(Path("site")), 0)
            self.assertTrue(Path(folder, "site").is_dir())
            Path(folder, "link").symlink_to("site")  # as a server's folder: the pages go where it leads
            docs.make(Path("link"))
            self.assertTrue(Path(folder, "link").is_symlink())
            os.chdir(before)


class Film(unittest.TestCase):
    def test_its_seconds_are_of_one_scene_each_and_few(self):
        film = json.loads((docs.ROOT / publish.FILM).read_text())
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
