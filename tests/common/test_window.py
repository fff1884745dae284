"""The window as a person uses it: keys, mouse, resizing. Under Xvfb, validated."""
import json
import os
import subprocess
import time
import unittest

from window_case import CHAPTER, HEIGHT, PANEL, WIDTH, StartedTest, WindowTest, copy_of_course, read_png
from window_session import BUILD, ROOT, Session

from check.starters import digest


class Window(WindowTest):
    def headless(self, width: int, height: int) -> tuple[bytes, bytes]:
        """The scene without a window: the file's bytes, and RGB."""
        file = self.folder / "headless.png"
        subprocess.run([CHAPTER, "--screenshot", file, "--size", f"{width}x{height}", "--scene", self.scene], check=True)
        return file.read_bytes(), read_png(file)[2]

    def test_space_presses_what_the_arrow_keys_mark(self):
        since = self.session.said()
        for _ in range(12):
            self.session.key("Down")
            self.session.key("space")
            if "reloaded" in self.session.lines[since:]:
                break
        self.session.wait_for_line("reloaded", since)
        self.session.key("Escape")  # takes the mark away; the next one would close the window
        self.session.read_all()
        self.assertIsNone(self.session.process.poll())

    def test_picture_is_the_one_without_a_window(self):
        shot = self.screenshot()
        self.assertRegex(shot.name, r"^lightwalk_01_\d{4}-\d\d-\d\d_\d{6}.*\.png$")
        self.assertEqual(shot.parent, self.folder)
        self.assertTrue(shot.read_bytes() == self.headless(WIDTH, HEIGHT)[0], "not the picture that --screenshot writes")
        self.assert_same(read_png(shot)[2], self.start)

    def test_f2_toggles_every_exercise(self):
        pressed = time.monotonic()
        self.session.key("F2", says="toggle all mine")
        self.session.wait(lambda: self.session.pixels(0, 60, WIDTH, HEIGHT - 60) != self.start[60 * 3 * WIDTH:],
                          "another picture")
        print(f"\ntoggle to new picture: {time.monotonic() - pressed:.2f} s")
        self.session.key("F2", says="toggle all reference")
        self.assert_as_at_the_start()

    def test_one_exercise_is_toggled_with_the_mouse(self):
        self.session.click("mine.01.transform", says="toggle 01.transform mine")
        self.picture_after(self.start)
        self.session.click("reference.01.transform", says="toggle 01.transform reference")
        self.assert_as_at_the_start()

    def test_knob_is_changed_with_the_mouse(self):
        for loader in ("parallel", "textbook"):
            self.session.click("knob.loader")
            self.session.click("option.loader." + loader, says="knob loader " + loader)
        self.assert_as_at_the_start()

    def test_resizes(self):
        for width, height in ((500, 300), (1300, 850), (341, 200), self.session.geometry()[2:]):
            self.session.resize(width, height)
            self.session.settled(0, 0, min(width, 200), min(height, 150))
            if width > PANEL + 100:
                picture = self.session.pixels(0, 0, width - PANEL, height)
                self.assertGreater(len({picture[i:i + 3] for i in range(0, len(picture), 3)}), 100)
        self.assert_as_at_the_start()

    def test_minimises(self):
        self.picture()
        self.assert_rests()
        self.session.set_minimised(True)
        self.assert_rests()
        self.session.set_minimised(False)
        self.session.focus()
        self.assert_as_at_the_start()

    def test_camera_moves_and_comes_home(self):
        for button, keys in ((1, []), (2, []), (3, [])):
            self.session.drag((200, 200), (320, 240), button)
            self.picture_after(self.start)
            self.session.key("Home", *keys)
            self.assert_as_at_the_start()
        self.session.move(300, 300)
        self.session.turn(1)
        self.session.park()
        self.picture_after(self.start)
        self.session.key("Home")
        self.assert_as_at_the_start()
        self.session.move(200, 300)
        self.session.press(3)
        with self.session.holding("w"):
            since = self.session.pictures
            self.session.wait(lambda: self.session.pictures >= since + 3, "pictures of the flight")
        self.session.release(3)
        self.session.park()
        away = self.picture_after(self.start)
        self.session.key("f")
        self.assert_other(self.picture_after(away), self.start)
        self.session.key("Home")
        self.assert_as_at_the_start()

    def test_looks_at_a_pass(self):
        self.session.click("look")
        self.session.click("look.clay depth: depth")
        depth = self.picture_after(self.start)
        values = {depth[i:i + 3] for i in range(0, len(depth), 3)}
        self.assertTrue(len(values) > 50 and sum(v[0] == v[1] == v[2] for v in values) > 0.9 * len(values))
        self.session.click("look")
        self.session.click("look.clay: hdr")
        # encode_srgb.comp does the same to the same values.
        self.assert_as_at_the_start()
        self.session.click("look")
        self.session.click("look.the picture")
        self.assert_as_at_the_start()

    def test_split_view(self):
        flip = float(self.session.key("F3", says=r"flip (\S+)")[1])
        self.assertTrue(0.01 < flip < 1.0, flip)
        shown = self.picture_after(self.start)
        # Below the names of the two sides, the right half is the reference.
        for y in range(60, HEIGHT):
            right = slice(3 * (y * WIDTH + WIDTH // 2 + 10), 3 * (y + 1) * WIDTH)
            self.assert_same(shown[right], self.start[right], f"in row {y}")
        self.session.drag((WIDTH // 2, 200), (WIDTH // 4, 200))
        moved = self.picture_after(shown)
        # The uncovered part shows the reference, as in the whole picture.
        row = slice(3 * (100 * WIDTH + WIDTH // 4 + 10), 3 * 101 * WIDTH)
        self.assert_same(moved[row], self.start[row])
        self.session.key("F3", says="split off")
        self.assert_as_at_the_start()

    def test_panel_hides(self):
        window = (0, 0, WIDTH + PANEL, HEIGHT)
        before = self.session.pixels(*window)
        self.session.key("h")
        try:
            self.session.wait(lambda: self.session.pixels(*window) != before, "a window without a panel")
            whole = self.session.settled(*window)
        finally:
            self.session.key("h")
        self.assertTrue(whole == self.headless(WIDTH + PANEL, HEIGHT)[1], "the picture does not reach to where the panel was")
        self.assert_as_at_the_start()


class NoDisplay(unittest.TestCase):
    def test_says_what_to_do_instead(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        for program in (CHAPTER, BUILD / "menu"):
            for display in ({}, {"DISPLAY": ":4711"}):
                done = subprocess.run([program], env={**environment, **display}, capture_output=True, text=True)
                self.assertEqual(done.returncode, 2)
                self.assertRegex(done.stderr, r"^error: no display.*\n$")
                self.assertIn("--screenshot" if program == CHAPTER else "./course run", done.stderr)


class Menu(StartedTest):
    def test_a_tile_says_how_many_exercises_are_solved(self):
        root = copy_of_course(self.folder)
        (root / "build/live").mkdir(parents=True)
        solved = {"of": digest((ROOT / "shaders/02_lambert_phong/exercise/lambert.glsl").read_bytes()), "ok": True}
        known = {"02.lambert": solved, "02.phong": solved, "05.pcf": solved | {"ok": False}}  # of phong's file it says nothing
        (root / "build/live/verdicts.json").write_text(json.dumps(known))
        menu = self.start(BUILD / "menu", "--events", "on", LIGHTWALK_ROOT=str(root))
        self.assertEqual([place for place in menu.places if place.startswith("solved.")], ["solved.02_lambert_phong"])
        self.end(menu)

    def test_click_starts_a_chapter_and_comes_back(self):
        menu = self.start(BUILD / "menu", "--validate", "on")
        menu.settled(0, 0, 400, 300)
        self.assertEqual(self.going_on(menu), [])
        for _ in range(2):
            since = menu.said()
            menu.click("chapter.01_obj")
            menu.wait_for_line("started 01_obj", since)
            menu.wait(lambda: "Lightwalk 01" in self.titles(menu), "the chapter's window")
            menu.wait_for_line("first picture", since)
            menu.xdotool("windowfocus", "--sync", menu.xdotool("search", "--onlyvisible", "--name", "Lightwalk 01").strip())
            menu.key("Escape")
            menu.wait_for_line("01_obj ended with 0", since)
            menu.wait(lambda: "Lightwalk" in self.titles(menu).splitlines(), "the menu's window")
            menu.focus()
        menu.wait(lambda: self.going_on(menu) == ["go_on.01_obj"], "its tile says so")
        self.end(menu)
        later = self.start(BUILD / "menu", "--validate", "on")
        self.assertEqual(self.going_on(later), ["go_on.01_obj"])
        self.end(later)

    @staticmethod
    def going_on(menu: Session) -> list[str]:
        return [place for place in list(menu.places) if place.startswith("go_on.")]

    def test_a_chapter_that_is_not_built_shows_how_far_it_is_and_a_click_asks_for_it(self):
        states = self.folder / "states"
        states.write_text("01_obj ready 0 0\n02_lambert_phong building 3 9\n03_attenuation waiting 0 0\n")
        menu = self.start(BUILD / "menu", "--programs", str(self.folder))
        menu.wait(lambda: "chapter.03_attenuation" in menu.places, "its tile")
        tile = menu.areas["chapter.02_lambert_phong"]
        area = tile[0], tile[1], tile[2] - tile[0], tile[3] - tile[1]
        third = menu.settled(*area)
        states.write_text("01_obj ready 0 0\n02_lambert_phong building 9 9\n03_attenuation waiting 0 0\n")
        menu.wait(lambda: menu.pixels(*area) != third, "a longer bar")
        menu.tap("chapter.03_attenuation")
        menu.wait_for_line("wanted 03_attenuation", 0)
        self.assertEqual((self.folder / "wanted").read_text(), "03_attenuation\n")
        self.assertFalse([line for line in menu.lines if line.startswith("started")])
        self.end(menu)

    @staticmethod
    def titles(menu: Session) -> str:
        ids = menu.xdotool("search", "--onlyvisible", "--name", "Lightwalk", check=False).split()
        return "\n".join(menu.xdotool("getwindowname", i, check=False) for i in ids)
