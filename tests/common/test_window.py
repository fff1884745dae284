#!/usr/bin/env python3
"""The window as a person uses it: keys, mouse, resizing, and shaders edited while it runs. Under Xvfb, validated."""
import json
import os
import re
import shutil
import struct
import subprocess
import tempfile
import time
import unittest
import zlib
from pathlib import Path

from window_session import BUILD, ROOT, Session, XServer

CHAPTER = BUILD / "chapters" / "01_obj"
WIDTH, HEIGHT, PANEL = 360, 580, 340
FRAGMENT = "shaders/01_obj/clay.frag"


def read_png(path: Path) -> tuple[int, int, bytes]:
    """Width, height and RGB of an 8-bit RGB or RGBA picture."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, color = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    channels = {2: 3, 6: 4}[color]
    raw, stride, before, rgb = zlib.decompress(packed), width * channels, bytearray(width * channels), bytearray()
    for y in range(height):
        method, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a = line[i - channels] if i >= channels else 0
            b, c = before[i], before[i - channels] if i >= channels else 0
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[i] = line[i] + (0, a, b, (a + b) // 2, nearest)[method] & 255
        before = line
        rgb += bytes(v for i, v in enumerate(line) if i % channels < 3)
    return width, height, bytes(rgb)


def copy_of_course(folder: Path) -> Path:
    """Shaders to edit; everything else is only linked."""
    root = folder / "course"
    root.mkdir()
    shutil.copytree(ROOT / "shaders", root / "shaders")
    for name in ("assets", "chapters", "tests", "docs"):
        if (ROOT / name).exists():
            (root / name).symlink_to(ROOT / name)
    return root


def own_scene(folder: Path) -> Path:
    scene = folder / "my_scene.json"
    scene.write_text((ROOT / "assets" / "scenes" / "bunny.json").read_text())
    return scene


class PictureTest(unittest.TestCase):
    """Pictures are megabytes: a message says where they differ, not how."""

    def assert_same(self, picture: bytes, expected: bytes, why: str = ""):
        if picture == expected:
            return
        self.assertEqual(len(picture), len(expected), why)
        places = [i // 3 for i in range(0, len(picture), 3) if picture[i:i + 3] != expected[i:i + 3]]
        self.fail(f"{len(places)} pixels differ, from ({places[0] % WIDTH}, {places[0] // WIDTH}) to "
                  f"({places[-1] % WIDTH}, {places[-1] // WIDTH}) {why}")

    def assert_other(self, picture: bytes, expected: bytes):
        self.assertTrue(picture != expected, "the picture is the same")


class Window(PictureTest):
    """One window, used by one test after the other; each leaves it as it found it."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="lightwalk_window_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.course = copy_of_course(cls.folder)
        cls.scene = own_scene(cls.folder)
        cls.server = XServer()
        cls.addClassCleanup(cls.server.close)
        cls.session = Session(cls.server, CHAPTER,
                              ["--validate", "on", "--size", f"{WIDTH}x{HEIGHT}", "--scene", str(cls.scene)],
                              cls.folder, LIGHTWALK_ROOT=str(cls.course))
        cls.start = cls.picture()

    @classmethod
    def tearDownClass(cls):
        cls.session.key("Escape")
        code = cls.session.end()
        said = [line for line in cls.session.errors if not re.match(r"error: (shaders/|pass 'encode_srgb')", line)
                and "my_scene.json" not in line and not line.startswith("    ")]
        assert code == 0 and not said, f"exit code {code}, it said {said}"

    @classmethod
    def picture(cls) -> bytes:
        return cls.session.settled(0, 0, WIDTH, HEIGHT)

    def screenshot(self) -> Path:
        since = self.session.said()
        self.session.key("F12")
        return Path(self.session.wait_for_line(r"screenshot (.*)", since)[1])

    def assert_as_at_the_start(self):
        """Soon: a message over the picture goes away by itself."""
        until = time.monotonic() + 15
        while self.session.pixels(0, 0, WIDTH, HEIGHT) != self.start and time.monotonic() < until:
            time.sleep(0.1)
        self.assert_same(self.session.pixels(0, 0, WIDTH, HEIGHT), self.start)

    def assert_last_good_picture_stays(self):
        """Between the message at the top and the error at the bottom."""
        rows = slice(3 * WIDTH * 60, 3 * WIDTH * (HEIGHT // 2))
        self.assert_same(self.picture()[rows], self.start[rows], "the last good picture did not stay")

    def edit(self, old: str, new: str, shader: str = FRAGMENT) -> float:
        """Replaces text in a shader as an editor does; returns the moment. After the test it is as it was."""
        file = self.course / shader
        text = file.read_text()
        self.assertIn(old, text)
        self.addCleanup(file.write_text, (ROOT / shader).read_text())
        file.write_text(text.replace(old, new))
        return time.monotonic()

    def test_picture_is_the_one_without_a_window(self):
        shot = self.screenshot()
        self.assertRegex(shot.name, r"^lightwalk_01_\d{4}-\d\d-\d\d_\d{6}.*\.png$")
        self.assertEqual(shot.parent, self.folder)
        headless = self.folder / "headless.png"
        subprocess.run([CHAPTER, "--screenshot", headless, "--size", f"{WIDTH}x{HEIGHT}", "--scene", self.scene],
                       check=True)
        self.assertEqual(shot.read_bytes(), headless.read_bytes(), "not the picture that --screenshot writes")
        self.assert_same(read_png(shot)[2], self.start)

    def test_f2_toggles_every_exercise(self):
        since, pressed = self.session.said(), time.monotonic()
        self.session.key("F2")
        self.session.wait_for_line("toggle all mine", since)
        self.session.wait(lambda: self.session.pixels(0, 60, WIDTH, HEIGHT - 60) != self.start[60 * 3 * WIDTH:],
                          "another picture")
        print(f"\ntoggle to new picture: {time.monotonic() - pressed:.2f} s")
        self.assert_other(self.picture(), self.start)
        since = self.session.said()
        self.session.key("F2")
        self.session.wait_for_line("toggle all reference", since)
        self.assert_as_at_the_start()

    def test_one_exercise_is_toggled_with_the_mouse(self):
        since = self.session.said()
        self.session.click("mine.01.transform")
        self.session.wait_for_line("toggle 01.transform mine", since)
        self.assert_other(self.picture(), self.start)
        self.session.click("reference.01.transform")
        self.session.wait_for_line("toggle 01.transform reference", since)
        self.assert_as_at_the_start()

    def test_knob_is_changed_with_the_mouse(self):
        for loader in ("parallel", "textbook"):
            since = self.session.said()
            self.session.click("knob.loader")
            self.session.click("option.loader." + loader)
            self.session.wait_for_line("knob loader " + loader, since)
        self.assert_as_at_the_start()

    def test_resizes(self):
        for width, height in ((500, 300), (1300, 850), (341, 200), (WIDTH + PANEL, HEIGHT)):
            self.session.xdotool("windowsize", "--sync", self.session.window, str(width), str(height))
            self.session.settled(0, 0, min(width, 200), min(height, 150))
            if width > PANEL + 100:
                picture = self.session.pixels(0, 0, width - PANEL, height)
                self.assertGreater(len({picture[i:i + 3] for i in range(0, len(picture), 3)}), 100)
        self.assert_as_at_the_start()

    def assert_rests(self):
        stat = Path(f"/proc/{self.session.process.pid}/stat")
        before = sum(map(int, stat.read_text().split()[13:15]))
        time.sleep(1.0)
        used = sum(map(int, stat.read_text().split()[13:15])) - before
        self.assertLess(used / os.sysconf("SC_CLK_TCK"), 0.2, "seconds of work in a second in which nothing changes")

    def test_minimises(self):
        self.picture()
        self.assert_rests()
        self.session.set_minimised(True)
        time.sleep(0.7)
        self.assert_rests()
        self.session.set_minimised(False)
        self.session.focus()
        self.assert_as_at_the_start()

    def test_broken_shader_is_reported_and_mended(self):
        since = self.session.said()
        line = next(i for i, text in enumerate((self.course / FRAGMENT).read_text().splitlines(), 1) if "color =" in text)
        self.edit("color = ", "color = no_such_thing + ")
        self.session.wait_for_line(rf"error: {FRAGMENT}:{line}: .*no_such_thing.*", since)
        shown = self.session.settled(0, 0, WIDTH, HEIGHT)
        red = sum(1 for i in range(0, len(shown), 3) if shown[i] > 180 and shown[i + 1] < 130 and shown[i + 2] < 130)
        self.assertGreater(red, 200, "no red text on the screen")
        self.assert_last_good_picture_stays()
        since = self.session.said()
        self.edit("color = no_such_thing + ", "color = ")
        self.session.wait_for_line("no error", since)
        self.assert_as_at_the_start()

    def test_shader_edit_shows(self):
        edited = self.edit("color = ", "color = vec4(0.0, 0.3, 0.0, 0.0) + ")
        self.session.wait(lambda: self.session.pixels(0, 0, WIDTH, HEIGHT) != self.start, "the edit to show")
        print(f"\nedit to new picture: {time.monotonic() - edited:.2f} s")
        self.edit("color = vec4(0.0, 0.3, 0.0, 0.0) + ", "color = ")
        self.assert_as_at_the_start()

    def test_binding_that_is_gone_is_reported(self):
        since = self.session.said()
        self.edit("hdr", "radiance", "shaders/common/encode_srgb.comp")
        self.session.wait_for_line(r"error: pass 'encode_srgb': .* 'hdr'.* radiance.*", since)
        self.edit("radiance", "hdr", "shaders/common/encode_srgb.comp")
        self.session.wait_for_line("no error", since)
        self.assert_as_at_the_start()

    def test_broken_scene_is_reported_on_reload(self):
        text = self.scene.read_text()
        since = self.session.said()
        self.scene.write_text(text.replace('"camera"', '"camra"'))
        self.session.key("F5")
        self.session.wait_for_line(r"error: .*my_scene\.json.*camra.*", since)
        self.assert_last_good_picture_stays()
        self.scene.write_text(text)
        since = self.session.said()
        self.session.key("F5")
        self.session.wait_for_line("no error", since)
        self.assert_as_at_the_start()

    def test_camera_moves_and_comes_home(self):
        for button, keys in ((1, []), (2, []), (3, [])):
            self.session.drag((200, 200), (320, 240), button)
            self.assert_other(self.picture(), self.start)
            self.session.key("Home", *keys)
            self.assert_as_at_the_start()
        self.session.xdotool("mousemove", "--window", self.session.window, "300", "300", "click", "4")
        self.session.park()
        self.assert_other(self.picture(), self.start)
        self.session.key("Home")
        self.assert_as_at_the_start()
        self.session.xdotool("mousemove", "--window", self.session.window, "200", "300", "mousedown", "3")
        time.sleep(0.3)
        self.session.xdotool("keydown", "w")
        time.sleep(0.5)
        self.session.xdotool("keyup", "w", "mouseup", "3")
        self.session.park()
        self.assert_other(self.picture(), self.start)
        self.session.key("f")
        self.assert_other(self.picture(), self.start)
        self.session.key("Home")
        self.assert_as_at_the_start()

    def test_looks_at_a_pass(self):
        self.session.click("look")
        self.session.click("look.clay depth: depth")
        depth = self.picture()
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
        since = self.session.said()
        self.session.key("F3")
        flip = float(self.session.wait_for_line(r"flip (\S+)", since)[1])
        self.assertTrue(0.01 < flip < 1.0, flip)
        shown = self.picture()
        # Below the names of the two sides, the right half is the reference.
        for y in range(60, HEIGHT):
            right = slice(3 * (y * WIDTH + WIDTH // 2 + 10), 3 * (y + 1) * WIDTH)
            self.assert_same(shown[right], self.start[right], f"in row {y}")
        self.session.drag((WIDTH // 2, 200), (WIDTH // 4, 200))
        moved = self.picture()
        self.assert_other(moved, shown)
        # What the divider uncovered is the reference, as it was in the whole picture.
        row = slice(3 * (100 * WIDTH + WIDTH // 4 + 10), 3 * 101 * WIDTH)
        self.assert_same(moved[row], self.start[row])
        self.session.key("F3")
        self.session.wait_for_line("split off", since)
        self.assert_as_at_the_start()

    def test_scene_is_saved_and_read_back(self):
        self.session.drag((200, 200), (320, 240))
        self.picture()
        turned = self.screenshot()
        since = self.session.said()
        before = self.scene.read_text()
        self.session.key("ctrl+s")
        self.assertEqual(Path(self.session.wait_for_line(r"saved (.*)", since)[1]), self.scene)
        headless = self.folder / "saved.png"
        subprocess.run([CHAPTER, "--screenshot", headless, "--size", f"{WIDTH}x{HEIGHT}", "--scene", self.scene],
                       check=True)
        self.assertEqual(turned.read_bytes(), headless.read_bytes(), "the saved scene is another picture")
        self.scene.write_text(before)
        self.session.key("Home")
        self.assert_as_at_the_start()

    def test_an_edited_scene_is_not_saved_over(self):
        """Ctrl+S asks first, and what was edited stays beside camera and knobs."""
        before = self.scene.read_text()
        self.addCleanup(self.session.key, "F5")
        self.addCleanup(self.scene.write_text, before)
        edited = json.loads(before) | {"include": [], "ambient": [0.5, 0.25, 0.125]}
        self.scene.write_text(json.dumps(edited))
        since = self.session.said()
        self.session.key("ctrl+s")
        self.session.wait_for_line("asks before saving .*", since)
        self.assertEqual(json.loads(self.scene.read_text()), edited)
        self.session.key("ctrl+s")
        self.session.wait_for_line(r"saved .*my_scene.json", since)
        saved = json.loads(self.scene.read_text())
        self.assertEqual({key: saved[key] for key in edited if key not in ("camera", "knobs")},
                         {key: edited[key] for key in edited if key not in ("camera", "knobs")})
        self.scene.write_text("{broken")
        since = self.session.said()
        self.session.key("ctrl+s")
        self.session.wait_for_line("asks before saving .*", since)
        self.session.key("ctrl+s")
        self.session.wait_for_line("not saved", since)
        self.assertEqual(self.scene.read_text(), "{broken")

    def test_split_while_the_clock_runs(self):
        """The reference is compared only when it has been drawn."""
        since = self.session.said()
        self.session.key("space")
        self.session.key("F3")
        self.session.wait_for_line(r"flip (\S+)", since)
        self.session.key("F3")
        self.session.wait_for_line("split off", since)
        self.session.key("space")
        self.assert_as_at_the_start()

    def test_an_error_that_quotes_a_very_long_line(self):
        since = self.session.said()
        self.edit("void main() {", "void main() { int wrong = nothing + " + "1 + " * 50000 + "1;")
        self.session.wait_for_line("error: shaders/01_obj/clay.frag.*", since)
        self.assert_last_good_picture_stays()
        since = self.session.said()
        (self.course / FRAGMENT).write_text((ROOT / FRAGMENT).read_text())
        self.session.wait_for_line("no error", since)
        self.assert_as_at_the_start()

    def test_clock_runs_and_stops(self):
        self.session.key("space")
        time.sleep(1.0)
        frames = {self.session.pixels(WIDTH, 0, PANEL, HEIGHT) for _ in range(20) if not time.sleep(0.1)}
        self.assertGreater(len(frames), 5, "the panel's clock does not move")
        self.session.key("space")
        self.picture()
        self.assert_rests()
        self.assert_as_at_the_start()

    def test_panel_hides(self):
        self.session.key("h")
        whole = self.session.settled(0, 0, WIDTH + PANEL, HEIGHT)
        rows = [whole[3 * (y * (WIDTH + PANEL) + WIDTH):3 * (y + 1) * (WIDTH + PANEL)] for y in range(HEIGHT)]
        self.assertGreater(min(rows[5]), 120, "the picture does not reach to where the panel was")
        self.session.key("h")
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


class Menu(unittest.TestCase):
    def test_click_starts_a_chapter_and_comes_back(self):
        with tempfile.TemporaryDirectory() as folder:
            server = XServer()
            self.addCleanup(server.close)
            menu = Session(server, BUILD / "menu", ["--validate", "on"], Path(folder))
            try:
                menu.settled(0, 0, 400, 300)
                for _ in range(2):
                    since = menu.said()
                    menu.click("chapter.01_obj")
                    menu.wait_for_line("started 01_obj", since)
                    menu.wait(lambda: "Lightwalk 01" in self.titles(menu), "the chapter's window")
                    time.sleep(2)
                    menu.xdotool("windowfocus", menu.xdotool("search", "--onlyvisible", "--name", "Lightwalk 01").strip())
                    menu.key("Escape")
                    menu.wait_for_line("01_obj ended with 0", since)
                    time.sleep(1)
                    menu.focus()
                menu.key("Escape")
                self.assertEqual(menu.end(), 0)
                self.assertEqual(menu.errors, [])
            finally:
                menu.close()

    @staticmethod
    def titles(menu: Session) -> str:
        ids = menu.xdotool("search", "--onlyvisible", "--name", "Lightwalk", check=False).split()
        return "\n".join(menu.xdotool("getwindowname", i, check=False) for i in ids)


if __name__ == "__main__":
    unittest.main()
