"""Shaders and scenes that are edited while the window shows them, and a window at rest. Under Xvfb, validated."""
import json
import subprocess
import time
from pathlib import Path

from window_case import CHAPTER, HEIGHT, PANEL, WIDTH, WindowTest, read_png
from window_session import ROOT

FRAGMENT = "shaders/01_obj/clay.frag"


class Edits(WindowTest):
    def edit(self, old: str, new: str, shader: str = FRAGMENT) -> float:
        """Replaces text in a shader as an editor does; returns the moment. After the test it is as it was."""
        file = self.course / shader
        text = file.read_text()
        self.assertIn(old, text)
        self.addCleanup(file.write_text, (ROOT / shader).read_text())
        file.write_text(text.replace(old, new))
        return time.monotonic()

    def test_broken_shader_is_reported_and_mended(self):
        since = self.session.said()
        line = next(i for i, text in enumerate((self.course / FRAGMENT).read_text().splitlines(), 1) if "color =" in text)
        self.edit("color = ", "color = no_such_thing + ")
        self.session.wait_for_line(rf"error: {FRAGMENT}:{line}: .*no_such_thing.*", since)
        shown = self.session.settled(WIDTH, 0, PANEL, HEIGHT)
        red = sum(1 for i in range(0, len(shown), 3) if shown[i] > 180 and shown[i + 1] < 130 and shown[i + 2] < 130)
        self.assertGreater(red, 200, "no red text beside the picture")
        self.assertGreaterEqual(self.session.areas["errors"][0], WIDTH)
        self.assert_last_good_picture_stays()
        since = self.session.said()
        self.edit("color = no_such_thing + ", "color = ")
        self.session.wait_for_line("no error", since)
        self.assert_as_at_the_start()

    def test_scene_is_saved_and_read_back(self):
        self.session.drag((200, 200), (320, 240))
        self.picture()
        turned = self.screenshot()
        before = self.scene.read_text()
        self.assertEqual(Path(self.session.key("ctrl+s", says=r"saved (.*)")[1]), self.scene)
        headless = self.folder / "saved.png"
        subprocess.run([CHAPTER, "--screenshot", headless, "--size", f"{WIDTH}x{HEIGHT}", "--scene", self.scene],
                       check=True)
        self.assertEqual(turned.read_bytes(), headless.read_bytes(), "the saved scene is another picture")
        self.scene.write_text(before)
        self.session.key("Home")
        self.assert_as_at_the_start()

    def test_an_edited_scene_is_not_saved_over(self):
        """Ctrl+S asks first, and external edits stay beside camera and knobs."""
        before = self.scene.read_text()
        self.addCleanup(self.session.key, "F5")
        self.addCleanup(self.scene.write_text, before)
        edited = json.loads(before) | {"include": [], "ambient": [0.5, 0.25, 0.125]}
        self.scene.write_text(json.dumps(edited))
        self.session.key("ctrl+s", says="asks before saving .*")
        self.assertEqual(json.loads(self.scene.read_text()), edited)
        self.session.key("ctrl+s", says=r"saved .*my_scene.json")
        saved = json.loads(self.scene.read_text())
        self.assertEqual({key: saved[key] for key in edited if key not in ("camera", "knobs")},
                         {key: edited[key] for key in edited if key not in ("camera", "knobs")})
        self.scene.write_text("{broken")
        self.session.key("ctrl+s", says="asks before saving .*")
        self.session.key("ctrl+s", says="not saved")
        self.assertEqual(self.scene.read_text(), "{broken")


class Refining(WindowTest):
    """At rest the picture gathers sixteen samples, says how many, and shows one sample as soon as something moves."""

    refine = "on"

    def test_it_gathers_what_samples_gathers_and_then_rests(self):
        self.session.wait(lambda: self.session.xdotool("getwindowname", self.session.window).strip().endswith("16 of 16 samples"), "sixteen samples")
        picture, file = self.picture(), self.folder / "headless.png"
        subprocess.run([CHAPTER, "--screenshot", file, "--size", f"{WIDTH}x{HEIGHT}", "--scene", self.scene, "--samples", "16"], check=True)
        # The order of sums may round one step of 1/255 away.
        self.assertLessEqual(max(abs(a - b) for a, b in zip(picture, read_png(file)[2], strict=True)), 1)
        self.assert_rests()
