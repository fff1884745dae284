"""Tests of ./course: commands and their output."""
# Builds: nothing

import io
import json
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from small_course import INTERRUPTIBLE, REAL, Course, until

import commands
from build.build import trim
from progress import Progress
from shots.golden import LIMITS, exceeded


class Commands(Course):
    def test_help_names_every_command_and_each_has_help(self):
        listed = set(re.findall(r"^  \./course (\w+)", self.course("--help"), re.M))
        self.assertEqual(listed, set(commands.names()))
        self.assertLessEqual(len(listed), 18)
        for key in {module: key for key, module in reversed(commands.COMMANDS.items())}.values():
            said = self.course(*key.split(), "--help")
            self.assertIn(key.split()[-1], said)

    def test_old_names_say_where_they_went(self):
        for old, new in commands.MOVED.items():
            self.assertEqual(self.course(old, "--help" if old == "next" else "02", code=2), f"course: '{old}' is now ./course {new}\n")
            words = new.split()
            self.assertIn(commands.selected(words[0], words[1:]), commands.COMMANDS)
            self.assertNotIn(old, commands.names())

    def test_the_tests_have_the_packages_of_every_command_that_they_try(self):
        groups = dict(re.findall(r'^    (\S.*)\) groups="([^"]*)" ;;', (REAL / "course").read_text(), re.M))
        for command, needed in groups.items():
            if not command.startswith(("fuzz", "*")):
                self.assertLessEqual(set(needed.split()), set(groups["test"].split()), command)

    def test_bad_words_are_one_line_and_2(self):
        (self.outside / "class/ann").mkdir(parents=True)
        for words, expected in (("rum", "no command 'rum'; the nearest are run and"), ("run 03", "no chapter '03'; the nearest are 01_obj and 02_lambert; the README"), ("run lamb", "the nearest are 02_lambert and 01_obj"),
                                ("run --size 1x1", "./course run 01 --size"), ("check 01.two", "the nearest is 01.one; ./course run 01 --list exercises"),
                                ("accept 01.cat", "the nearest are 01.car and 01.bunny; ./course run NN --list shots"), ("fuzz 0", "0 seconds is too short"),
                                ("clean all", "unrecognised argument"), ("test (", "not a regular expression"),
                                ("test shots.01 shots.02", "'shots.01|shots.02' matches both"), ("test shots --all", "shots and --all each say which"),
                                ("test --merge x --sanitize", "--merge writes the report"),
                                ("run --gallery --shard 3/2", "'3/2' is not a shard"),
                                ("run --gallery --merge", "expected at least one argument"),
                                ("run --gallery --out x", "unrecognised argument '--out'"),
                                ("run --gallery --shrad", "unrecognised argument '--shrad'"),
                                ("reset 01.", "'01.' names no exercise"), ("check 01.", "'01.' names no exercise"),
                                ("check 01 --next", "--next names one step"), ("check --next --json", "--next names one step"),
                                ("check --progress --hint", "one of --progress and --hint"), ("shader --list mesh.frag", "--list names all shaders"),
                                ("study --rounds 0", "--rounds is 0, expected 1 or more"), ("docs --no-film", "add --site FOLDER"),
                                ("serve --socket s --open", "--socket is instead of an address"),
                                ("grade chapters --budget -1", "'-1' is no number of minutes"), ("grade chapters --budget nan", "'nan' is no number of minutes"),
                                ("grade chapters --rules x.json", "--rules says what a gradebook holds: add --format"),
                                (f"grade {self.outside}/class --out {self.outside}/class/grades", "and would be a submission the next time"),
                                ("handout /", "name a folder"), ("grade nobody", "no such file")):
            printed = self.course(*words.split(), code=2)
            self.assertIn(expected, printed)
            self.assertEqual(printed.count("\n"), 1, printed)

    def test_run_passes_options_and_exit_code_and_keeps_the_folder(self):
        for word in ("02", "2", "lambert", "02_lambert"):
            printed = self.course("run", word, "--set", "method=phong", "--help", cwd="/usr")
            self.assertIn("02_lambert --set method=phong --help in /usr\n", printed)
        self.course("run", "01", "--fail", code=7)

    def test_through_a_link(self):
        (self.outside / "link").symlink_to(self.root / "course")
        self.assertIn("01_obj in", self.run_program([self.outside / "link", "run", "01"]))

    def test_display_starts_the_menu_that_it_builds(self):
        self.course("run", "01")
        self.assertIn("build/menu: No such file", self.course("run", **self.display(), code=1))
        self.put("build/menu", "#!/bin/sh\necho the menu\n")
        self.assertIn("the menu", self.course("run", **self.display()))

    def test_gallery_draws_what_is_new(self):
        def gallery():
            return self.course("run", "--gallery")

        page = self.root / "build/gallery/index.html"
        self.assertRegex(self.course("run"), r"index\.html: 2 pictures\n\./course run --gallery draws all 3\n\Z")
        self.assertIn("01_obj/bunny.png", page.read_text())
        self.assertIn("draws all 3 pictures", page.read_text())
        self.assertNotIn("car.png", page.read_text())
        self.assertNotIn("drew", self.course("run"))
        self.assertRegex(gallery(), r"drew 1 [\s\S]*index\.html: 3 pictures\n\Z")
        self.assertIn("car.png", page.read_text())
        self.course("run")
        self.assertNotIn("drew", gallery())  # what --gallery drew is kept
        self.put("shaders/common/new.glsl")
        self.assertIn("drew 3", gallery())
        self.put("tests/02_lambert/shots.json", json.dumps({"shots": [{"name": "bunny", "caption": "One."}]}))
        self.assertIn("drew 1", self.course("run"))
        self.put("crash")
        self.put("shaders/common/newer.glsl")
        self.assertIn("mesh.frag:3", self.course("run", code=1))
        (self.root / "crash").unlink()
        self.assertIn("drew 2", self.course("run"))

    def test_interrupt_is_quiet_and_130(self):
        self.course("run", "01")
        log = self.root / "compiling"
        self.put("compile", f"touch {log}; sleep 120\n")
        self.put("chapters/01_obj/exercise/one.cpp", "changed")
        course = subprocess.Popen([self.root / "course", "check", "01"], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, **INTERRUPTIBLE)
        while not log.exists():
            time.sleep(0.02)
        os.killpg(course.pid, signal.SIGINT)
        printed, _ = course.communicate(timeout=60)
        self.assertEqual(course.returncode, 130, printed)
        self.assertNotIn("Traceback", printed)

    def test_doctor_fuzz_and_clean(self):
        said = self.course("doctor")
        for line in ("cmake", r"packages +(all installed|missing\n)", r"[\d.]+ GB free in"):
            self.assertRegex(said, line)
        self.assertIn("obj: 9 runs, nothing found\n1 of 1 targets held", self.course("fuzz", "1"))
        self.put("broken")
        self.assertIn("0 of 1 targets held; not fuzz_obj", self.course("fuzz", "1", code=1))
        self.course("clean")
        self.assertFalse((self.root / "build").exists())

    def test_progress_without_a_terminal_is_few_lines(self):
        out = io.StringIO()
        with Progress("x", out) as progress:
            for i in range(1001):
                progress.show(i, 1000)
        self.assertEqual(out.getvalue().count("\n"), 11)


class Cache(unittest.TestCase):
    def test_what_was_used_longest_ago_goes_first(self):
        with tempfile.TemporaryDirectory() as folder:
            for at in range(8):
                path = Path(folder, f"{at}.spv")
                path.write_bytes(bytes(4096))
                os.utime(path, (0, (3 - at) % 8))
            trim(Path(folder), 8 * 4096)
            self.assertEqual(len(os.listdir(folder)), 8)
            trim(Path(folder), 7 * 4096)
            self.assertEqual(sorted(os.listdir(folder)), ["0.spv", "4.spv", "5.spv", "6.spv", "7.spv"])
            trim(Path(folder) / "absent", 0)


class Tests(Course):
    """The small tree has unit.common, and of two chapters shots and wrong pictures, and checks; and two texts, of
    which one is this file's stand-in, a test of the platform."""

    def test_green_red_and_the_closing_line(self):
        self.accept()
        self.assertEqual(self.course("test", "--all").splitlines()[-1], "100% tests passed, 0 tests failed out of 9")
        self.assertTrue((self.root / "build/report/index.html").exists())
        self.put("broken")
        self.assertEqual(self.course("test", "--all", code=1).splitlines()[-1], "89% tests passed, 1 tests failed out of 9")

    def test_pattern_labels_and_nothing(self):
        self.accept()
        self.assertIn("out of 1", self.course("test", "shots.01").splitlines()[-1])
        self.assertIn("out of 2", self.course("test", "-L", "rejects").splitlines()[-1])
        self.assertIn("no test matches -R nothing", self.course("test", "nothing", code=2))

    def test_few_tests_build_what_they_need(self):
        """Without `rest`, which does not build here."""
        self.accept()
        self.put("no_rest")
        self.assertIn("out of 1", self.course("test", "shots.02").splitlines()[-1])
        self.assertIn("the build failed", self.course("test", "unit", code=1))
        self.assertIn("the build failed", self.course("test", code=1))

    def test_without_all_two_suites_are_run_with_and_without_sanitizers(self):
        self.accept()
        self.assertIn("out of 6", self.course("test", "--sanitize").splitlines()[-1])
        self.assertTrue((self.root / "build/results/sanitizer.xml").exists())
        said = self.course("test")
        self.assertIn("out of 6", said.splitlines()[-1])
        self.assertRegex(said, r"time of tests, some at once: first \d+ s in 5 tests, engine \d+ s in 1 tests\nslowest: ")
        self.assertIn("out of 1", self.course("test", "-L", "platform").splitlines()[-1])
        for said in (self.course("test", "--changed"), self.course("test", "--with-changed")):
            self.assertIn("platform: git knows no HEAD~1, so these are all 1 tests: text.course\n", said)
            self.assertIn("out of 7", said.splitlines()[-1])
        self.assertEqual(self.course("test", "--changed", "shots", code=2), "course: --changed shots: git knows no such commit\n")

    def test_nothing_to_build_says_nothing(self):
        self.course("run", "01")
        self.assertRegex(self.course("run", "01"), r"\A01_obj in /\n\Z")


class Shots(Course):
    def setUp(self):
        for golden in self.root.glob("tests/*/golden/*"):
            golden.unlink()
        self.course("run", "01")

    def shot(self, *words, code=0):
        return self.run_program([sys.executable, self.root / "common/course", "test.shots", *words], code)

    def test_missing_golden_fails(self):
        self.assertIn("there is no tests/01_obj/golden/bunny.png", self.shot("shots", "01_obj", code=1))

    def test_difference_fails_over_a_limit_and_passes_under_it(self):
        self.accept()
        self.put("drift", "~")
        self.shot("shots", "01_obj")
        self.put("drift", "!")
        self.assertIn("flip_mean is 0.5, at most 0.002", self.shot("shots", "01_obj", code=1))
        self.assertTrue((self.root / "build/shots/01_obj/bunny.flip.png").exists())

    def test_two_steps_never_fail(self):
        self.accept()
        self.put("drift", "^^")  # FLIP 0.5
        self.shot("shots", "01_obj")
        self.put("drift", "^^^")
        self.assertIn("flip_mean is 0.5, at most 0.002", self.shot("shots", "01_obj", code=1))
        metrics = {"flip": {"mean": 0.0, "p99": 0.0}, "max_diff": {"steps": 2, "x": 0, "y": 0}}
        self.assertEqual(exceeded(metrics, LIMITS), [])
        for key in ("mean", "p99"):
            self.assertEqual(len(exceeded(metrics | {"flip": metrics["flip"] | {key: math.nan}}, LIMITS)), 1, key)

    def limits(self):
        self.shot("shots", "01_obj", code=None)
        return json.loads((self.root / "build/results/shot.01.bunny.json").read_text())["limits"]

    def test_limits_are_three_times_what_accept_measured_and_never_less_than_the_usual(self):
        self.assertIn("no second driver is measured", self.accept())
        self.assertEqual(self.limits(), LIMITS)
        self.put("drift.sse4.1", "!")
        self.assertIn("differ so much that tests would allow more than usual: flip_mean 1.5 instead of 0.002, flip_p99 1.5 instead of 0.05, "
                      "max_diff 300 instead of 64", self.accept())
        self.assertEqual(self.limits(), {"flip_mean": 1.5, "flip_p99": 1.5, "max_diff": 300})
        self.put("drift.sse4.1", "~")
        self.accept()
        self.assertEqual(self.limits(), LIMITS | {"flip_mean": 0.003})

    def test_a_second_driver_is_measured_and_remembered_while_the_golden_stays(self):
        self.assertIn("is not a file", self.course("accept", "--yes", "--second-driver", "/no/such", code=2))
        self.put("second")
        self.put("drift.second", "!")
        self.course("accept", "--yes", "--second-driver", str(self.root / "second"))
        self.assertEqual(self.limits()["max_diff"], 300)
        self.accept()
        self.assertEqual(self.limits()["max_diff"], 300)
        self.put("drift", "!")
        self.accept()
        self.assertEqual(self.limits(), LIMITS)

    def test_nearly_constant_fails_and_is_not_accepted(self):
        self.put("flat")
        self.assertIn("refused: the picture is nearly one colour", self.course("accept", "01", "--yes", code=1))
        self.assertEqual(list(self.root.glob("tests/01_obj/golden/*")), [])
        (self.root / "flat").unlink()
        self.accept()
        self.put("flat")
        self.assertIn("nearly one colour", self.shot("shots", "01_obj", code=1))

    def test_wrong_pictures(self):
        self.accept()
        self.shot("wrong", "02_lambert")
        result = json.loads((self.root / "build/results/wrong_picture.02.bunny.json").read_text())
        self.assertEqual([picture["name"] for picture in result["pictures"]],
                         ["the starter of 02.one", "drawn by 01_obj", "method=none"])
        self.assertEqual(list(self.root.glob("build/shots/02_lambert/*.wrong*")), [], "rejected pictures are kept")
        self.put("starter_is_right")
        self.assertIn("does not reject the picture: the starter of 02.one",
                      self.shot("wrong", "02_lambert", code=1))
        self.assertTrue((self.root / "build/shots/02_lambert/bunny.wrong0.flip.png").exists())

    def test_ended_accept_draws_no_more(self):
        self.course("run", "01")
        self.put("tests/01_obj/shots.json", json.dumps({"shots": [{"name": f"shot{i}", "caption": "One."} for i in range(20)]}))
        slow = self.root / "slow"
        self.put("slow")
        accept = subprocess.Popen([self.root / "course", "accept", "01", "--yes"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **INTERRUPTIBLE)
        until(slow.read_text, 300)
        accept.send_signal(signal.SIGTERM)  # to it alone
        self.assertEqual(accept.wait(60), 143)
        self.assertLess(len(slow.read_text()), 10)
        self.assertFalse((self.root / "tests/01_obj/golden/shot0.png").exists())

    def test_accept_asks_first_and_says_what_changed(self):
        self.assertIn("add --yes", self.course("accept", "01.car", code=2))
        self.assertEqual(list(self.root.glob("tests/01_obj/golden/*")), [])
        self.assertIn("a new picture", self.course("accept", "01.car", "--yes"))
        self.assertIn("01.car: as it was", self.course("accept", "01.car", "--yes"))
        self.put("drift", "!")
        self.assertIn("FLIP mean 0.500000", self.course("accept", "01.car", "--yes"))
        self.assertIn("!", (self.root / "tests/01_obj/golden/car.png").read_text())
