"""The film as a file: parts that join, and what happens where ffmpeg is missing or ends early."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common/course"))
import film  # noqa: E402
from picture_drawing import BUILD, BUILT, HAS_SOLUTION  # noqa: E402

PROGRAM = BUILD / "chapters" / "19_ambiance"
FILM = Path(__file__).resolve().parent / "short.film"
EARLY = "#!/bin/sh\nhead -c 5000 >/dev/null\nexit 3\n"
WHOLE = '#!/bin/sh\nfor last; do :; done\nexec cat >"$last"\n'


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class Film(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="lightwalk_film_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name: str, *options, ffmpeg: str | None = None, scene: Path | str = FILM) -> subprocess.CompletedProcess:
        environment = dict(os.environ)
        if ffmpeg is not None:
            place = self.folder / "programs"
            place.mkdir(exist_ok=True)
            if ffmpeg:
                (place / "ffmpeg").write_text(ffmpeg)
                (place / "ffmpeg").chmod(0o755)
            environment["PATH"] = f"{place}:/usr/bin:/bin" if ffmpeg else str(place)
        return subprocess.run([PROGRAM, "--scene", scene, "--size", "48x27", "--film", self.folder / name, *options],
                              capture_output=True, text=True, timeout=300, env=environment)

    def test_parts_join_without_a_seam_and_each_frame_is_its_picture(self):
        for name, *frames in (("whole.raw", "43", "49"), ("first.raw", "43", "46"), ("second.raw", "46", "49")):
            done = self.write(name, "--frames_from", frames[0], "--frames_to", frames[1])
            self.assertEqual(done.returncode, 0, done.stderr)
        whole, first, second = ((self.folder / f"{name}.raw").read_bytes() for name in ("whole", "first", "second"))
        self.assertEqual(len(whole), 6 * 48 * 27 * 4)
        self.assertEqual(whole, first + second)

    def test_frames_go_to_ffmpeg(self):
        done = self.write("a.mp4", "--frames_to", "2", ffmpeg=WHOLE)
        self.assertEqual((done.returncode, (self.folder / "a.mp4").stat().st_size), (0, 2 * 48 * 27 * 4), done.stderr)

    def test_what_was_there_stays_where_it_fails(self):
        for ffmpeg, words in (("", "ffmpeg cannot be started: No such file or directory"),
                              (EARLY, "ffmpeg ended before the last frame, with code 3")):
            with self.subTest(words):
                (self.folder / "a.mp4").write_text("a film")
                done = self.write("a.mp4", "--frames_to", "60", ffmpeg=ffmpeg)
                self.assertEqual((done.returncode, (self.folder / "a.mp4").read_text()), (1, "a film"))
                self.assertIn(words, done.stderr)
                self.assertEqual(done.stderr.count("error:"), 1)
                self.assertEqual(list(self.folder.glob("*.part*")), [])

    def test_bad_input(self):
        for options, scene, words in ((("a.avi",), FILM, "expected a name that ends with .mp4, .mkv or .raw"),
                                      (("a.raw", "--frames_from", "150"), FILM, "there is no frame from 150 to 150"),
                                      (("a.raw",), "scenes/statue.json", "scenes/statue.json is no film")):
            done = self.write(*options, scene=scene)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(words, done.stderr)

    def test_shards_are_all_frames_once(self):
        for frames, count in ((6360, 16), (7, 3), (3, 5)):
            cuts = [film.cut(frames, i, count) for i in range(1, count + 1)]
            self.assertEqual([first for first, _ in cuts[1:]], [end for _, end in cuts[:-1]])
            self.assertEqual((cuts[0][0], cuts[-1][1]), (0, frames))
            self.assertLessEqual(max(end - first for first, end in cuts) - min(end - first for first, end in cuts), 1)
        self.assertEqual((film.shard("3/16").number, film.shard("3/16").of), (3, 16))
        for wrong in ("0/4", "5/4", "3", "a/b"):
            with self.assertRaises(film.UsageError):
                film.shard(wrong)

    def test_parts_are_merged_unless_one_is_missing(self):
        parts = self.folder / "a.parts"
        parts.mkdir()
        for i in (1, 3):
            (parts / f"000{i}_of_0003.raw").write_bytes(bytes([i]))
        out = self.folder / "a.raw"
        with self.assertRaisesRegex(film.Failure, "2/3 missing; ./course film .*a.raw --shard 2/3"):
            film.merge(out, parts)
        self.assertFalse(out.exists())
        (parts / "0002_of_0003.raw").write_bytes(bytes([2]))
        film.merge(out, parts)
        self.assertEqual(out.read_bytes(), bytes([1, 2, 3]))

    def test_benchmarks_of_several_systems_are_one_table(self):
        def system(name, scale):
            figures = {"mean_ms": scale, "p99_ms": 2 * scale, "processor_ms": 0.5}
            more = {**figures, "mean_ms": scale + 0.25}
            return {"device": name, "size": [480, 270],
                    "scenes": [{"name": "dawn", "antialiasing": {"none": figures, "mlaa": more}}]}

        lines = film.table([system("a", 1), system("b", 3)]).splitlines()
        self.assertIn("a, 480×270: mean", lines[0])
        self.assertEqual(lines[2], "| dawn | 1.25 | 2.00 | 0.25 | 0.50 | 3.25 | 6.00 | 0.25 | 0.50 |")


if __name__ == "__main__":
    unittest.main()
