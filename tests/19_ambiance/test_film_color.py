"""A film's colours and loudness, as other programs read them: ffprobe, ffmpeg's frames and its EBU R 128 meter."""

import json
import re
import subprocess
import unittest
from pathlib import Path

from folder_case import FolderCase
from picture_drawing import BUILD, BUILT, HAS_SOLUTION
from tree import ROOT

PROGRAM = BUILD / "chapters" / "19_ambiance"
CHART = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, 1, 1), (1, 0, 1), (1, 1, 1), (0.2, 0.2, 0.2)]


def said_by(*words) -> bytes:
    return subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=True).stdout


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class FilmColor(FolderCase):
    def write(self, text: dict, *options, name: str = "a.mp4") -> Path:
        film, out = self.folder / "a.film", self.folder / name
        film.write_text(json.dumps(text))
        subprocess.run([PROGRAM, "--scene", film, "--film", out, *options], check=True, stdout=subprocess.DEVNULL)
        return out

    def test_a_chart_keeps_its_colours_as_bt709(self):
        """Eight flat pictures, one a second, as raw frames and as a film."""
        (self.folder / "a.json").write_text(json.dumps({"camera": {"position": [0, 0, 3], "target": [0, 0, 0]}, "objects": []}))
        steps = ["steps", *([i, list(color)] for i, color in enumerate(CHART))]
        film = {"duration_s": len(CHART),
                "knobs": {"post.fade": "on", "post.fade_by": 1, "post.fade_color": steps},
                "scenes": [{"name": "chart", "kind": "lights", "scene": str(self.folder / "a.json"), "from_s": 0,
                            "to_s": len(CHART)}]}
        options = "--size", "64x48", "--fps", "1"
        raw = self.write(film, *options, name="a.raw").read_bytes()
        out = self.write(film, *options)
        stream = json.loads(said_by("ffprobe", "-v", "error", "-select_streams", "v", "-show_streams", "-of", "json",
                                    out))["streams"][0]
        self.assertEqual([stream.get(key) for key in ("color_range", "color_space", "color_primaries", "color_transfer")],
                         ["tv", "bt709", "bt709", "bt709"])
        # Each plane's mean by hand, through the matrix of ITU-R BT.709: no reader's guess is in between.
        planes = said_by("ffmpeg", "-v", "error", "-i", out, "-f", "rawvideo", "-pix_fmt", "yuv420p", "-")
        size = 64 * 48 * 3 // 2
        self.assertEqual(len(raw), 4 * 64 * 48 * len(CHART))
        self.assertEqual(len(planes), size * len(CHART))
        for i in range(len(CHART)):
            color = tuple(raw[4 * 64 * 48 * i:][:3])
            frame = planes[i * size:(i + 1) * size]
            y = sum(frame[:64 * 48]) / (64 * 48)
            u = sum(frame[64 * 48:64 * 48 + 32 * 24]) / (32 * 24)
            v = sum(frame[64 * 48 + 32 * 24:]) / (32 * 24)
            luma, blue, red = (y - 16) / 219, (u - 128) / 224, (v - 128) / 224
            r, b = luma + 1.5748 * red, luma + 1.8556 * blue
            g = (luma - 0.2126 * r - 0.0722 * b) / 0.7152
            found = [round(255 * c) for c in (r, g, b)]
            self.assertLess(max(abs(f - c) for f, c in zip(found, color)), 5, f"{color} became {found}")

    def test_music_is_as_loud_as_players_expect(self):
        """-14 LUFS, and no peak above -1 dB: the effect of a film's ffmpeg options on its music."""
        film = json.loads((ROOT / "assets/films/ambiance.film").read_text())
        said = subprocess.run(["ffmpeg", "-hide_banner", "-nostats", "-i", ROOT / "assets" / film["music"], "-af",
                               f"volume={film['music_gain_db']:g}dB,ebur128=peak=true", "-f", "null", "-"],
                              stderr=subprocess.PIPE, text=True, check=True).stderr.rpartition("Summary:")[2]
        self.assertAlmostEqual(float(re.search(r"I:\s+(\S+) LUFS", said)[1]), -14, delta=0.5)
        self.assertLess(float(re.search(r"Peak:\s+(\S+) dBFS", said)[1]), -1)

    def test_the_gain_is_in_the_file(self):
        loud = {}
        for gain in (0, -12):
            out = self.write({"duration_s": 4, "music": str(ROOT / "assets/audio/ambiance.ogg"),
                              "music_gain_db": gain, "scenes": []}, "--size", "32x18", "--fps", "5")
            said = subprocess.run(["ffmpeg", "-hide_banner", "-nostats", "-i", out, "-af", "volumedetect", "-f", "null", "-"],
                                  stderr=subprocess.PIPE, text=True, check=True).stderr
            loud[gain] = float(re.search(r"mean_volume: (\S+) dB", said)[1])
        self.assertAlmostEqual(loud[0] - loud[-12], 12, delta=0.5)
