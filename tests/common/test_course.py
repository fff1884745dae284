"""Tests of ./course: what a person types and reads."""

import io
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest
import zipfile
from pathlib import Path

from small_course import LESSON, REAL, SHOTS_02, Course

sys.path.insert(0, str(REAL / "common/course"))
import cli  # noqa: E402
from check_teeth import with_bodies  # noqa: E402
from progress import Progress  # noqa: E402
from shots import LIMITS, exceeded  # noqa: E402
from study_file import Study, markdown_table  # noqa: E402


class Commands(Course):
    def test_help_names_every_command_and_each_has_help(self):
        listed = set(re.findall(r"^  \./course (\w+)", self.course("--help"), re.M))
        self.assertEqual(listed, set(cli.COMMANDS))
        for command in cli.COMMANDS:
            self.assertTrue(self.course(command, "--help").strip())

    def test_bad_words_are_one_line_and_2(self):
        for words, expected in (("rum", "no command 'rum'; there are run"), ("run 03", "there are 01_obj, 02_lambert"),
                                ("run --size 1x1", "./course run 01 --size"), ("check 01.two", "chapter 01 has 01.one"),
                                ("accept 01.cat", "there are 01.bunny, 01.car"), ("fuzz 0", "no time to fuzz"),
                                ("clean all", "means nothing here"), ("test (", "no regular expression"),
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

    def test_display_starts_the_menu_or_the_first_chapter(self):
        self.assertIn("01_obj in", self.course("run", DISPLAY=":9"))
        self.put("build/menu", "#!/bin/sh\necho the menu\n")
        (self.root / "build/menu").chmod(0o755)
        self.assertIn("the menu", self.course("run", DISPLAY=":9"))

    def test_gallery_draws_what_is_new(self):
        self.assertIn("3 pictures", self.course("run"))
        self.assertIn("01_obj/bunny.png", (self.root / "build/gallery/index.html").read_text())
        self.assertNotIn("drew", self.course("run"))
        self.put("shaders/common/new.glsl")
        self.assertIn("drew 3", self.course("run"))
        self.put("tests/02_lambert/shots.json", json.dumps({"shots": [{"name": "bunny", "caption": "One."}]}))
        self.assertIn("drew 1", self.course("run"))
        self.put("crash")
        self.put("shaders/common/newer.glsl")
        self.assertIn("mesh.frag:3", self.course("run", code=1))
        (self.root / "crash").unlink()
        self.assertIn("drew 3", self.course("run"))

    def test_interrupt_is_quiet_and_130(self):
        self.course("run", "01")
        self.put("compile", "sleep 20\n")
        self.put("chapters/01_obj/exercise/one.cpp", "changed")
        course = subprocess.Popen([self.root / "course", "check", "01"], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, start_new_session=True)
        time.sleep(1.5)
        os.killpg(course.pid, signal.SIGINT)
        printed, _ = course.communicate(timeout=10)
        self.assertEqual(course.returncode, 130, printed)
        self.assertNotIn("Traceback", printed)

    def test_doctor_fuzz_and_clean(self):
        self.assertIn("cmake", self.course("doctor"))
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


class Tests(Course):
    """The small tree has unit.common, three shots, two teeth of shots, two checks and their teeth, and two texts, of which one is
    this file's empty stand-in."""

    def test_green_red_and_the_closing_line(self):
        self.accept()
        self.assertEqual(self.course("test").splitlines()[-1], "100% tests passed, 0 tests failed out of 12")
        self.assertTrue((self.root / "build/report/index.html").exists())
        self.put("broken")
        self.assertEqual(self.course("test", code=1).splitlines()[-1], "92% tests passed, 1 tests failed out of 12")

    def test_pattern_labels_and_nothing(self):
        self.accept()
        self.assertIn("out of 2", self.course("test", "shot.01").splitlines()[-1])
        self.assertIn("out of 4", self.course("test", "-L", "teeth").splitlines()[-1])
        self.assertIn("no test matches -R nothing", self.course("test", "nothing", code=2))

    def test_sanitizers_are_counted(self):
        self.accept()
        self.assertIn("out of 22", self.course("test", "--sanitize").splitlines()[-1])
        self.assertIn("out of 13", self.course("test", CI="true").splitlines()[-1])

    def test_nothing_to_build_says_nothing(self):
        self.course("run", "01")
        self.assertRegex(self.course("run", "01"), r"\A01_obj in /\n\Z")


class Shots(Course):
    def setUp(self):
        for golden in self.root.glob("tests/*/golden/*"):
            golden.unlink()
        self.course("run", "01")

    def shot(self, *words, code=0):
        return self.run_program([sys.executable, self.root / "common/course/shots.py", *words], code)

    def test_missing_golden_fails(self):
        self.assertIn("there is no tests/01_obj/golden/bunny.png", self.shot("check", "01_obj", "bunny", code=1))

    def test_result_is_written(self):
        self.accept()
        self.shot("check", "01_obj", "bunny")
        result = json.loads((self.root / "build/results/shot.01.bunny.json").read_text())
        self.assertTrue(result["ok"])
        [picture] = result["pictures"]
        for key in ("expected", "actual", "heatmap"):
            self.assertTrue((self.root / picture[key]).exists(), key)

    def test_difference_fails_over_a_limit_and_passes_under_it(self):
        self.accept()
        self.put("drift", "~")
        self.shot("check", "01_obj", "bunny")
        self.put("drift", "!")
        self.assertIn("flip_mean is 0.5, at most 0.002", self.shot("check", "01_obj", "bunny", code=1))

    def test_two_steps_never_fail(self):
        self.accept()
        self.put("drift", "^^")  # FLIP 0.5
        self.shot("check", "01_obj", "bunny")
        self.put("drift", "^^^")
        self.assertIn("flip_mean is 0.5, at most 0.002", self.shot("check", "01_obj", "bunny", code=1))
        metrics = {"flip": {"mean": 0.0, "p99": 0.0}, "max_diff": {"steps": 2, "x": 0, "y": 0}}
        self.assertEqual(exceeded(metrics, LIMITS), [])
        for key in ("mean", "p99"):
            self.assertEqual(len(exceeded(metrics | {"flip": metrics["flip"] | {key: math.nan}}, LIMITS)), 1, key)

    def limits(self):
        self.shot("check", "01_obj", "bunny", code=None)
        return json.loads((self.root / "build/results/shot.01.bunny.json").read_text())["limits"]

    def test_limits_are_three_times_what_accept_measured_and_never_less_than_the_usual(self):
        self.assertIn("LIGHTWALK_SECOND_DRIVER is not set", self.accept())
        self.assertEqual(self.limits(), LIMITS)
        self.put("drift.sse4.1", "!")
        self.assertIn("01.bunny is allowed more than others: flip_mean 1.5, flip_p99 1.5, max_diff 300", self.accept())
        self.assertEqual(self.limits(), {"flip_mean": 1.5, "flip_p99": 1.5, "max_diff": 300})
        self.put("drift.sse4.1", "~")
        self.accept()
        self.assertEqual(self.limits(), LIMITS | {"flip_mean": 0.003})

    def test_a_second_driver_is_measured_and_remembered_while_the_golden_stays(self):
        self.assertIn("which is no file", self.course("accept", "--yes", code=2, LIGHTWALK_SECOND_DRIVER="/no/such"))
        self.put("second")
        self.put("drift.second", "!")
        self.course("accept", "--yes", LIGHTWALK_SECOND_DRIVER=str(self.root / "second"))
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
        self.assertIn("nearly one colour", self.shot("check", "01_obj", "bunny", code=1))

    def test_program_that_fails_is_quoted(self):
        self.accept()
        self.put("crash")
        self.assertIn("mesh.frag:3: no such function", self.shot("check", "01_obj", "bunny", code=1))

    def test_teeth(self):
        self.accept()
        self.shot("teeth", "02_lambert", "bunny")
        result = json.loads((self.root / "build/results/teeth.02.bunny.json").read_text())
        self.assertEqual([picture["name"] for picture in result["pictures"]],
                         ["02.one as handed out", "drawn by 01_obj", "method=none"])
        self.put("no_teeth")
        self.assertIn("does not reject the picture: 02.one as handed out",
                      self.shot("teeth", "02_lambert", "bunny", code=1))

    def test_accept_asks_first_and_says_what_changed(self):
        self.assertIn("add --yes", self.course("accept", "01.car", code=2))
        self.assertEqual(list(self.root.glob("tests/01_obj/golden/*")), [])
        self.assertIn("a new picture", self.course("accept", "01.car", "--yes"))
        self.assertIn("01.car: as it was", self.course("accept", "01.car", "--yes"))
        self.put("drift", "!")
        self.assertIn("FLIP mean 0.500000", self.course("accept", "01.car", "--yes"))
        self.assertIn("!", (self.root / "tests/01_obj/golden/car.png").read_text())


class Exercises(Course):
    def test_check_says_what_is_wrong(self):
        self.put("chapters/02_lambert/exercise/one.cpp", "right")
        self.put("no_teeth")
        self.accept()
        printed = self.course("check", "01", code=1)
        self.assertIn("open  01.one  2 of 3 checks  chapters/01_obj/exercise/one.cpp\n"
                      "      one(0) gave 1, expected 0", printed)
        self.assertNotIn("think", printed)
        self.assertIn("hint: think", self.course("check", "01.one", "--hint", code=1))
        self.assertIn("1 of 2 exercises are right; next: 01.one", self.course("check", code=1))
        lines = self.course("check", "--json", code=1).splitlines()
        self.assertEqual([json.loads(line)["ok"] for line in lines if line[0] == "{"], [False, True])
        self.assertIn("02_lambert               [#] 1 of 1", self.course("progress", code=1))

    def test_the_picture_comes_last(self):
        self.put("chapters/02_lambert/exercise/one.cpp", "right")
        self.accept()
        self.assertIn("the numbers are right, the picture of bunny is not", self.course("check", "02", code=1))
        self.put("no_teeth")
        self.assertIn("ok    02.one", self.course("check", "02"))

    def test_a_picture_is_compared_with_the_reference_drawn_here(self):
        self.put("chapters/02_lambert/exercise/one.cpp", "right")
        self.put("no_teeth")
        self.accept()
        self.put("drift", "as this processor draws it")  # unlike the golden, but like the reference
        self.assertIn("ok    02.one", self.course("check", "02"))

    def test_in_a_handout_the_picture_waits_for_what_else_it_shows(self):
        self.put("no_teeth")
        self.accept()
        folder = self.outside / "waiting"
        self.course("handout", str(folder))
        self.addCleanup(shutil.rmtree, folder)
        (folder / "chapters/02_lambert/exercise/one.cpp").write_text("right")
        check = [folder / "course", "check", "02"]
        self.assertIn("compared once the numbers of 01.one are right", self.run_program(check))
        (folder / "chapters/01_obj/exercise/one.cpp").write_text("right")
        self.assertNotIn("compared once", self.run_program(check))
        (folder / "no_teeth").unlink()
        self.assertIn("the picture of bunny is not: 3 pixels differ", self.run_program(check, code=1))

    def test_a_file_that_does_not_compile_becomes_an_empty_object(self):
        script = REAL / "common/course/compile_exercise.sh"
        source, made = self.outside / "a.cpp", self.outside / "a.o"
        command = ["sh", script, "c++", "-Wall", "-o", made, "-c", source]
        source.write_text("int f() { int unused; return 1; }")
        self.assertIn("unused", self.run_program(command))
        self.assertIn(b"1fv", made.read_bytes())
        source.write_text("int f() { return }")
        self.assertIn("error", self.run_program(command))
        self.assertNotIn(b"1fv", made.read_bytes())
        self.assertIn("a.cpp:1:18: error", Path(f"{made}.error").read_text())
        source.write_text("int f() { return 1; }")
        self.assertEqual(self.run_program(command), "")
        self.assertFalse(Path(f"{made}.error").exists())

    def test_exercises_come_in_the_lessons_order(self):
        self.put("chapters/01_obj/exercise/and.cpp", "right")
        self.put("docs/01_obj.md", "# One\n### 01.one (easy)\n### 01.and (hard)\n")
        printed = self.course("check", "01", code=1)
        self.assertLess(printed.index("01.one  2 of 3"), printed.index("01.and  3 of 3"))
        self.assertIn("one.cpp  (easy)", printed)

    def test_handout_of_a_tree_with_history(self):
        def git(*words):
            self.run_program(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b.c", *words])
        self.put("chapters/01_obj/exercise/one.cpp", "open")
        git("init", "-q")
        self.addCleanup(shutil.rmtree, self.root / ".git")
        git("add", "-A")
        git("commit", "-q", "-m", "all")
        self.put("grades.csv", "ann 2")
        self.put("chapters/01_obj/exercise/one.cpp", "right")
        folder = self.outside / "committed"
        self.assertIn("one.cpp: handed out as committed", self.course("handout", str(folder)))
        self.assertFalse((folder / "grades.csv").exists())
        self.assertEqual((folder / "chapters/01_obj/exercise/one.cpp").read_text(), "open")

    def test_a_check_that_dies_is_open(self):
        self.put("chapters/01_obj/exercise/one.cpp", "die")
        self.assertIn("ended by signal 6", self.course("check", "01", code=1))

    def test_handout_has_no_solution_and_works(self):
        self.accept()
        folder = self.outside / "handout"
        self.assertIn("2 exercises", self.course("handout", str(folder)))
        self.assertEqual(list(folder.rglob("solution")), [])
        self.assertTrue((folder / "chapters/01_obj/exercise/one.cpp").exists())
        self.assertIn("out of 3", self.run_program([folder / "course", "test"]).splitlines()[-1])
        self.course("handout", str(folder), code=2)

    def test_a_check_must_refuse_the_starter_and_take_the_solution(self):
        self.course("run", "01")
        check = [sys.executable, self.root / "common/course/check_teeth.py", "01_obj"]
        self.run_program(check)
        self.put("chapters/01_obj/exercise/one.cpp", "right")
        self.assertIn("01.one: it passes as handed out", self.run_program(check, code=1))
        self.put("chapters/01_obj/solution/one.cpp", "wrong")
        self.assertIn("01.one: the reference does not pass", self.run_program(check, code=1))

    def test_the_checks_of_the_reference_are_in_the_report(self):
        self.course("run", "01")
        check = [sys.executable, self.root / "common/course/results.py", "check", "01_obj"]
        self.run_program(check)
        result = json.loads((self.root / "build/results/check.01.json").read_text())
        self.assertEqual((result["kind"], result["test"], len(result["rows"])), ("probe", "check.01", 1))
        self.put("chapters/01_obj/solution/one.cpp", "wrong")
        self.assertIn("01.one: one(0) gave 1, expected 0", self.run_program(check, code=1))

    def test_a_chart_is_that_of_its_study(self):
        self.course("run", "01")
        charts = [sys.executable, self.root / "common/course/results.py", "charts"]
        point = {"scene": "a", "method": "b", "error": {"ulp": 1}, "mb_per_s": {"median": 2, "q1": 1, "q3": 3}}
        study = {"chapter": "01_obj", "title": "t", "subject": "loader", "device": "d", "driver": "CPU", "stage": "s",
                 "command": "c", "error_metric": "ulp", "time_unit": "MB/s", "points": [point]}
        self.put("docs/studies/01_obj.cpu1.json", json.dumps(study))
        printed = self.run_program(charts, code=1)
        self.assertIn("docs/studies/01_obj.cpu1.md is not the table", printed)
        self.assertIn("there is no docs/studies/01_obj.cpu1.svg", printed)
        for kind, text in (("svg", ""), ("png", ""), ("md", markdown_table(Study(study)))):
            self.put(f"docs/studies/01_obj.cpu1.{kind}", text)
        self.run_program(charts)
        two = study | {"charts": [{"name": "main"}, {"name": "again", "title": "Once more"}]}
        self.put("docs/studies/01_obj.cpu1.json", json.dumps(two))
        printed = self.run_program(charts, code=1)
        self.assertEqual([f"there is no docs/studies/01_obj.cpu1.again.{kind}" in printed for kind in ("svg", "png")],
                         [True, True])
        for kind in ("svg", "png"):
            self.put(f"docs/studies/01_obj.cpu1.again.{kind}", "")
        self.run_program(charts)
        found = json.loads((self.root / "build/results/chart.01_obj.cpu1.again.json").read_text())
        self.assertEqual((found["title"], found["ok"], found["table"]), ("Once more", True, None))
        self.put("docs/studies/01_obj.cpu1.json", "{}")
        self.assertIn('has no "chapter"', self.run_program(charts, code=1))

    def test_functions_without_bodies(self):
        text = ("// f(x) {\nfloat f(vec3 a,\n        float b) {\n    if (b > 0.0) { return 1.0; }\n    return b;\n}\n"
                "void g() { h(); }\n")
        self.assertEqual(with_bodies(text, " return ZERO; "), "// f(x) {\nfloat f(vec3 a,\n        float b) "
                         "{ return float(0); }\nvoid g() {}\n")

    def test_grade(self):
        self.put("chapters/02_lambert/exercise/one.cpp", "right")
        students = self.outside / "students"
        for name, text in (("ann", "right"), ("ben", "wrong"), ("cat", "syntax error"), ("dan", None)):
            folder = students / name / "chapters/01_obj/exercise"
            folder.mkdir(parents=True)
            if text:
                (folder / "one.cpp").write_text(text)
        with zipfile.ZipFile(students / "eve.zip", "w") as archive:
            archive.writestr("course/chapters/01_obj/exercise/one.cpp", "right")
            archive.writestr("../../chapters/01_obj/exercise/one.cpp", "wrong")
        grades = [" ".join(line.split()) for line in self.course("grade", str(students)).splitlines() if " of 2 " in f"{line} "]
        self.assertEqual(grades, ["ann 2 of 2", "ben 1 of 2 open: 01.one", "cat 1 of 2 open: 01.one",
                                  "dan 0 of 2 holds no exercise", "eve 2 of 2"])
        self.assertIn("does not compile: 1: error: no", self.course("grade", "--json", str(students / "cat")))


class Text(Course):
    def wrong(self):
        check = [sys.executable, self.root / "common/course/text_check.py"]
        done = subprocess.run(check, stdout=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 1 if done.stdout else 0)
        return done.stdout

    def test_the_tree_is_right(self):
        self.assertEqual(self.wrong(), "")

    def test_quotes(self):
        self.put("docs/01_obj.md", LESSON.replace("twice", "thrice"))
        self.assertIn("docs/01_obj.md:3: the block is not what chapters/01_obj/main.cpp says", self.wrong())
        self.course("quote")
        self.assertEqual((self.root / "docs/01_obj.md").read_text(), LESSON)
        self.put("docs/01_obj.md", LESSON.replace("#frame", "#gone"))
        self.assertIn("has no lines from [gone] to [/gone]", self.wrong())
        self.put("docs/01_obj.md", LESSON.replace("01_obj/main.cpp#frame", "01_obj/solution/one.cpp#x"))
        self.assertIn("would give the exercise away", self.wrong())

    def test_links(self):
        for bad in ("[a](nowhere.md)", "![a](01.png)", "[a](01_obj.md#no-such)", "<img src='x.png'>", "[a](../../x)"):
            self.put("docs/02_lambert.md", f"# Two\n{bad}\n`[a](code.md)` [b](https://example.org)\n")
            self.assertEqual(self.wrong().count("docs/02_lambert.md:2:"), 1, bad)

    def test_credits_both_ways(self):
        self.put("assets/models/c.obj")
        self.assertIn("assets/models/c.obj: assets/CREDITS.md does not name it", self.wrong())
        self.remove("assets/models/b.obj")
        self.assertIn("assets/CREDITS.md:3: there is no assets/models/b.obj", self.wrong())

    def test_limits_without_a_measurement(self):
        self.addCleanup(lambda: [path.unlink() for path in self.root.glob("tests/*/golden/*")])
        self.accept()
        self.assertEqual(self.wrong(), "")
        measured = self.root / "tests/01_obj/golden/distances.json"
        known = json.loads(measured.read_text())
        self.put("tests/01_obj/golden/distances.json", json.dumps({"car": known["car"], "cat": known["car"]}))
        self.assertIn("nobody measured how far drivers differ on bunny; ./course accept 01.bunny", self.wrong())
        self.assertIn("golden/distances.json: cat has no golden", self.wrong())
        self.put("tests/02_lambert/shots.json", json.dumps({"shots": [SHOTS_02["shots"][0] | {"limits": {"max_diff": 99}}]}))
        self.assertIn("tests/02_lambert/shots.json: bunny says its own limits", self.wrong())

    def test_private_paths_and_what_a_chapter_needs(self):
        self.put("docs/02_lambert.md", "see /" + "work/main/x\n")
        self.assertIn("a path of one machine", self.wrong())
        self.remove("docs/02_lambert.md")
        self.assertIn("docs/02_lambert.md: chapter 02_lambert needs it", self.wrong())
        self.put("tests/02_lambert/shots.json", '{"shots": [{"name": "a", "caption": "", "exercises": ["02.no"]}]}')
        self.assertIn("there is no exercise 02.no", self.wrong())
        self.assertIn("no golden has to reject the picture of an earlier chapter", self.wrong())


if __name__ == "__main__":
    unittest.main()
