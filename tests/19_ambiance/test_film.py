"""The film as a file: parts that join, and what happens where ffmpeg is missing or ends early."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
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

    def write(self, name: str, *options, ffmpeg: str | None = None) -> subprocess.CompletedProcess:
        environment = dict(os.environ)
        if ffmpeg is not None:
            place = self.folder / "programs"
            place.mkdir(exist_ok=True)
            if ffmpeg:
                (place / "ffmpeg").write_text(ffmpeg)
                (place / "ffmpeg").chmod(0o755)
            environment["PATH"] = f"{place}:/usr/bin:/bin" if ffmpeg else str(place)
        return subprocess.run([PROGRAM, "--scene", FILM, "--size", "48x27", "--film", self.folder / name, *options],
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
        for options, words in ((("a.avi",), "expected a name that ends with .mp4, .mkv or .raw"),
                               (("a.raw", "--frames_from", "150"), "there is no frame from 150 to 150"),
                               (("a.raw", "--scene", "scenes/statue.json"), "scenes/statue.json is no film")):
            done = self.write(*options)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
