"""The film of the site's start page, written by the course."""

import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from pages import publish  # noqa: E402


class Film(unittest.TestCase):
    def test_its_seconds_are_of_one_scene_each_and_few(self):
        film = json.loads((ROOT / publish.FILM).read_text())
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


if __name__ == "__main__":
    unittest.main()
