"""The film as a file: parts that join, a missing or crashed ffmpeg, and a full disk."""

# Builds: 05_shadow_maps 19_ambiance
import errno
import json
import os
import resource
import shutil
import subprocess
import time
import unittest
from pathlib import Path
from unittest import mock

import film
from commands import Parser
from folder_case import FolderCase
from many import shards
from many.shards import Shard
from tree import PYTHON, ROOT, Failure, UsageError
from picture_drawing import BUILD, BUILT, HAS_SOLUTION

PROGRAM = BUILD / "chapters" / "19_ambiance"
FILM = Path(__file__).resolve().parent / "short.film"
EARLY = "#!/bin/sh\nhead -c 5000 >/dev/null\necho 'no such codec' >&2\nexit 3\n"
FULL = "#!/bin/sh\ncat >/dev/full\n"
CLUSTER = '#!/bin/sh\nfor SLURM_ARRAY_TASK_ID in 1 2; do export SLURM_ARRAY_TASK_ID; sh "$3" >&2 || exit; done\necho 7\n'
WHOLE = '#!/bin/sh\nfor last; do :; done\nexec cat >"$last"\n'


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class Film(FolderCase):
    def write(self, name: str, *options, ffmpeg: str | None = None, scene: Path | str = FILM,
              most_bytes: int | None = None) -> subprocess.CompletedProcess:
        environment = dict(os.environ)
        if ffmpeg is not None:
            place = self.folder / "programs"
            place.mkdir(exist_ok=True)
            if ffmpeg:
                (place / "ffmpeg").write_text(ffmpeg)
                (place / "ffmpeg").chmod(0o755)
            environment["PATH"] = f"{place}:/usr/bin:/bin" if ffmpeg else str(place)
        command = [PROGRAM, "--scene", scene, "--size", "48x27", "--film", self.folder / name, *options]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment) as program:
            if most_bytes:
                self.wait_for_frames(program, name)
                # Only now: newer drivers keep the device's memory in files, to which the limit applies.
                if program.poll() is None:
                    resource.prlimit(program.pid, resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
            stdout, stderr = program.communicate(timeout=300)
        return subprocess.CompletedProcess(command, program.returncode, stdout, stderr)

    def wait_for_frames(self, program, name: str):
        while program.poll() is None and not any(part.stat().st_size for part in self.folder.glob(f".film.*/{name}")):
            time.sleep(0.002)

    def test_parts_join_without_a_seam_and_each_frame_is_its_picture(self):
        """With temporal anti-aliasing as well."""
        films = []
        for method in ("mlaa", "taa"):
            for name, *frames in (("whole.raw", "43", "49"), ("first.raw", "43", "46"), ("second.raw", "46", "49")):
                done = self.write(name, "--frames_from", frames[0], "--frames_to", frames[1], "--set", f"mlaa.method={method}",
                                  "--set", "mlaa.taa.warm_up=3")
                self.assertEqual(done.returncode, 0, done.stderr)
            whole, first, second = ((self.folder / f"{name}.raw").read_bytes() for name in ("whole", "first", "second"))
            self.assertEqual(len(whole), 6 * 48 * 27 * 4)
            self.assertEqual(whole, first + second)
            films.append(whole)
        self.assertNotEqual(*films)

    def test_frames_go_to_ffmpeg(self):
        done = self.write("a.mp4", "--frames_to", "2", ffmpeg=WHOLE)
        self.assertEqual((done.returncode, (self.folder / "a.mp4").stat().st_size), (0, 2 * 48 * 27 * 4), done.stderr)

    def test_what_was_there_stays_where_it_fails(self):
        for ffmpeg, words in (("", "ffmpeg cannot be started: No such file or directory"),
                              (EARLY, "ffmpeg ended before the last frame, with code 3: no such codec"),
                              (FULL, "ffmpeg ended before the last frame, with code 1: cat: write error: No space left on device")):
            with self.subTest(words):
                (self.folder / "a.mp4").write_text("a film")
                done = self.write("a.mp4", "--frames_to", "60", ffmpeg=ffmpeg)
                self.assertEqual((done.returncode, (self.folder / "a.mp4").read_text()), (1, "a film"))
                self.assertIn(words, done.stderr)
                self.assertEqual(len([line for line in done.stderr.splitlines() if line.startswith("error:")]), 1, done.stderr)
                self.assertEqual(list(self.folder.glob(".film*")), [])

    def test_bad_input(self):
        for options, scene, words in ((("a.avi",), FILM, "expected a name that ends with .mp4, .mkv or .raw"),
                                      (("a.raw", "--frames_from", "150"), FILM, "there is no frame from 150 to 150"),
                                      (("a.raw",), "scenes/statue.json", "scenes/statue.json is no film")):
            done = self.write(*options, scene=scene)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(words, done.stderr)

    def test_a_saved_scene_in_a_film_and_in_a_chapter(self):
        """Terrain of the editor's: where a scene's kind has none it is left out, by a chapter and by a film alike."""
        for knobs, code, words in (({"ground.plain_m": 0.7, "shadow.method": "hard"}, 0,
                                    "lacks ground, jacksboro_dem.png of chapter 18_playground; left out"),
                                   ({"shadow.method": "soft"}, 2, "key 'knobs': shadow.method=soft: expected one of")):
            saved, film_file = self.folder / "saved.json", self.folder / "saved.film"
            saved.write_text(json.dumps({"objects": [{"model": "terrain/jacksboro_dem.png"}, {"model": "models/cube.obj"}],
                                         "lights": [{"direction": [0, -1, 0]}], "knobs_of": "18_playground", "knobs": knobs}))
            film_file.write_text(json.dumps({"duration_s": 1, "scenes": [
                {"name": "a", "kind": "stage", "scene": str(saved), "from_s": 0, "to_s": 1}]}))
            own = subprocess.run([PROGRAM.with_name("05_shadow_maps"), "--scene", saved, "--size", "48x27", "--screenshot",
                                  self.folder / "a.png"], capture_output=True, text=True)
            for by, done in (("this chapter", own), ("a film's scene", self.write("a.raw", "--frames_to", "1", scene=film_file))):
                with self.subTest(by=by, knobs=knobs):
                    self.assertEqual(done.returncode, code, done.stderr)
                    lines = [line for line in done.stderr.splitlines() if "saved.json" in line]
                    self.assertEqual(len(lines), 1, done.stderr)
                    self.assertIn(f"{by} {words}" if code == 0 else words, lines[0])

    def test_a_full_disk_is_one_line_and_what_was_there_stays(self):
        (self.folder / "a.raw").write_text("a film")
        done = self.write("a.raw", "--frames_to", "60", most_bytes=100000)  # as many as fit
        self.assertEqual((done.returncode, (self.folder / "a.raw").read_text()), (1, "a film"), done.stderr)
        self.assertEqual(done.stderr.count("error:"), 1)
        self.assertIn("a.raw: File too large", done.stderr)
        self.assertEqual(list(self.folder.glob(".film*")), [])

    def test_no_link_is_followed_and_sigterm_leaves_nothing(self):
        theirs = self.folder / "theirs"
        theirs.write_text("not a film")
        for name in ("a.part.raw", "a.raw"):  # an existing file of that name is replaced, not written through
            (self.folder / name).symlink_to(theirs)
        self.assertEqual(self.write("a.raw", "--frames_to", "2").returncode, 0)
        self.assertEqual((theirs.read_text(), (self.folder / "a.raw").is_symlink()), ("not a film", False))
        command = [PROGRAM, "--scene", FILM, "--size", "48x27", "--film", self.folder / "b.raw"]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as program:
            self.wait_for_frames(program, "b.raw")
            program.terminate()
        self.assertEqual(sorted(one.name for one in self.folder.iterdir()), ["a.part.raw", "a.raw", "theirs"])

    def part(self, parts: Path, number: int, of: int = 3, **head):
        """A shard that holds its number as its film."""
        piece = self.folder / f"{number}.raw"
        piece.write_bytes(bytes([number]))
        shard = Shard(number, of)
        shards.write(shards.file_of(parts, "film", shard), "film", shard, {"ending": ".raw", "music": None, **head},
                     {str(number): [number - 1, number]}, {"part.raw": piece})

    def test_parts_are_merged_into_a_film_of_their_kind(self):
        parts, out = self.folder / "a.parts", self.folder / "a.raw"
        for number in (3, 1, 2):
            self.part(parts, number)
        film.merge(out, shards.merge([parts], "film"))
        self.assertEqual(out.read_bytes(), bytes([1, 2, 3]))
        with self.assertRaisesRegex(UsageError, "the parts are .raw files"):
            film.merge(self.folder / "a.mp4", shards.merge([parts], "film"))

    def test_a_disk_that_is_full_at_the_merge_leaves_the_parts(self):
        parts, out = self.folder / "a.parts", self.folder / "a.raw"
        for number in (1, 2, 3):
            self.part(parts, number)
        full = OSError(errno.ENOSPC, "No space left on device")
        with mock.patch.object(film.shutil, "copyfileobj", side_effect=full), \
             self.assertRaisesRegex(Failure, "a.raw is not joined, its parts are whole: No space left on device"):
            film.merge(out, shards.merge([parts], "film"))
        self.assertFalse(out.exists())
        film.merge(out, shards.merge([parts], "film"))
        self.assertEqual(out.read_bytes(), bytes([1, 2, 3]))

    def course(self, *words) -> str:
        programs = f"{self.folder}/programs:{os.environ['PATH']}"
        done = subprocess.run([*PYTHON, ROOT / "common/course/cli.py", *words], capture_output=True, text=True, env=os.environ | {"PATH": programs})
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    @unittest.skipUnless(shutil.which("ffmpeg") and shutil.which("ffprobe") and BUILD == ROOT / "build", "needs ffmpeg and the default build")
    def test_what_would_change_nothing_or_is_no_film_is_refused(self):
        broken = self.folder / "broken.film"
        broken.write_text("{")
        for words in (["--fps", "abc"], ["--fps", "0"], ["--scene", str(broken)], ["--scene", str(self.folder)]):
            with self.subTest(words), self.assertRaises(UsageError):
                film.write_shard(self.folder / "x.raw", self.folder / "parts", Shard(1, 2), words)
        for words in ("--film x.raw --merge --fps 60", "--film x.raw --out parts", "--table a.json --size 96x54"):
            parser = Parser()
            film.add_arguments(parser)
            with self.subTest(words), self.assertRaisesRegex(UsageError, "leave it out|add --shard"):
                film.run(*parser.parse_known_args(["19", *words.split()]))
        with self.assertRaises(IsADirectoryError), mock.patch("film.read_systems", lambda names: []), mock.patch("pages.film_page.page", lambda systems: ""):
            (self.folder / "page.html").mkdir()
            film.write_page([str(self.folder / "page.html"), "a.json"])

    def test_a_cluster_writes_shards_and_the_course_joins_them_to_a_film_with_all_frames(self):
        out, parts = self.folder / "a.mp4", BUILD / "slurm/film"
        words = ["--scene", str(FILM), "--size", "48x27", "--fps", "4", "--validate", "on"]
        (self.folder / "programs").mkdir()
        for name, text in (("sbatch", CLUSTER), ("squeue", "#!/bin/sh\n")):
            (self.folder / "programs" / name).write_text(text)
            (self.folder / "programs" / name).chmod(0o755)
        self.course("run", "19", "--film", out, *words, "--slurm", "--shards", "2")
        file = parts / "film.1-of-2.zip"
        before = file.stat().st_mtime_ns
        self.assertEqual(film.write_shard(out, parts, Shard(1, 2), words), 0)
        self.assertEqual(file.stat().st_mtime_ns, before, "a part that is whole is left as it is")
        with self.assertRaisesRegex(UsageError, "is of another film, other options or another version"):
            film.write_shard(out, parts, Shard(1, 2), [*words, "--codec", "av1"])
        said = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                               "stream=nb_read_frames,width,height", "-of", "json", out], capture_output=True, text=True)
        stream = json.loads(said.stdout)["streams"][0]
        self.assertEqual((stream["nb_read_frames"], stream["width"], stream["height"]), ("20", 48, 28))

    def test_benchmarks_of_several_systems_are_one_table(self):
        def system(name, scale):
            figures = {"mean_ms": scale, "p99_ms": 2 * scale, "processor_ms": 0.5}
            more = {**figures, "mean_ms": scale + 0.25}
            return {"device": name, "size": [480, 270], "cuts": [{"to": "dawn", "longest_ms": 6 * scale, "mean_ms": 4 * scale}],
                    "scenes": [{"name": "dawn", "mean_ms": 4 * scale, "processor_ms": 0.75, "gpu_sum": {"none": figures, "mlaa": more}}]}

        for name, scale in (("a", 1), ("b", 3)):
            (self.folder / name).write_text(json.dumps(system(name, scale)))
        lines = self.course("run", "19", "--table", self.folder / "a", self.folder / "b").splitlines()
        self.assertIn("a, 480×270: played", lines[0])
        self.assertEqual(lines[2], "| dawn | 4.00 | 1.50 | 0.75 | 1.25 | 0.25 | 12.00 | 1.50 | 0.75 | 3.25 | 0.25 |")

    def test_a_page_of_several_systems(self):
        from pages import film_page

        def system(name, software, scale):
            figures = {"mean_ms": scale, "p99_ms": 2 * scale, "processor_ms": 0.5, "min_ms": 0.5 * scale}
            return {"device": name, "driver": "1 <2>", "software": software, "size": [480, 270],
                    "scenes": [{"name": name, "gpu_sum": {"none": figures, "mlaa": figures}} for name in ("dawn", "car")],
                    "cuts": [{"to": "car", "longest_ms": 3 * scale, "mean_ms": 2 * scale}]}

        text = film_page.page([system("a <b>", False, 1), system("lavapipe", True, 30)])
        self.assertIn("a &lt;b&gt;", text)
        self.assertEqual(text.count("<svg"), 2, "a software renderer shares no axis with a GPU")
        self.assertEqual(text.count("<td>dawn</td>"), 1)
        self.assertIn("1.50", text)  # the cut
        out = self.folder / "page.html"
        (self.folder / "a.json").write_text(json.dumps(system("a", False, 1)))
        self.course("run", "19", "--page", out, self.folder / "a.json")
        self.assertTrue(out.read_text().startswith("<!doctype html>"))
        for wrong in (["a.txt", "b.json"], [str(out)], [str(out), str(FILM)], [str(out), "none.json"]):
            with self.assertRaises(UsageError):
                film.write_page(wrong)

    def test_the_chart_of_ways_chooses_as_the_program_does(self):
        from pages import film_page

        ways = [{"error": 0.02, "gpu_ms": 10, "knobs": {}}, {"error": 0.04, "gpu_ms": 4, "knobs": {}}, {"error": 0.3, "gpu_ms": 1, "knobs": {}}]
        scene = {"name": "dawn", "as_set_ms": 6, "ways": ways}
        for budget, ms in ((0.01, 10), (0.02, 10), (0.05, 4), (1, 1)):
            self.assertEqual(film_page.cheapest(scene, budget)["gpu_ms"], ms, budget)
        rough = {"name": "julia", "as_set_ms": 6, "ways": [{**way, "error": way["error"] + 0.2} for way in ways]}
        figure = film_page.ways_chart({"device": "a", "driver": "b", "software": True, "size": [4, 3], "scenes": [scene, rough]}, "made so")
        words = {text.get_text().strip() for axes in figure.axes for text in axes.texts}
        self.assertLessEqual({"40%", "none: the truest errs 0.22", "0", "1", "2"}, words)
