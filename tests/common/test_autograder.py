"""Tests for other platforms: ./course handout --autograder, its results by the published forms, ./course check --next and reset."""

import json
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile
from functools import partial
from pathlib import Path

from graded_class import OF, REAL, right, why_not
from check.starters import digest
from grading.autograder import packages, results_of
from grading.rules import Rules
from small_course import Course
from tree import exercises

WANTED = {exercise: chapter for exercise, chapter in OF.items() if chapter[:2] == "02"}


def gradescope_errors(results) -> list[str]:
    """Against the published form: gradescope-autograders.readthedocs.io, "Autograder Specifications", "Output Format"."""
    kinds = {"score": (int, float), "execution_time": (int, float), "output": str, "output_format": str, "test_output_format": str,
             "test_name_format": str, "visibility": str, "stdout_visibility": str, "extra_data": dict, "tests": list, "leaderboard": list}
    test_kinds = {"score": (int, float), "max_score": (int, float), "status": str, "name": str, "name_format": str, "number": str,
                  "output": str, "output_format": str, "tags": list, "visibility": str, "extra_data": dict}
    seen = {"hidden", "after_due_date", "after_published", "visible"}
    formats = {"text", "html", "simple_format", "md", "ansi"}
    found = [] if "tests" in results or "score" in results else ["neither tests nor a score"]
    for one, allowed in ((results, kinds), *((test, test_kinds) for test in results.get("tests", []))):
        for key, value in one.items():
            if key not in allowed or not isinstance(value, allowed[key]) or isinstance(value, bool):
                found.append(f"{key}: {value!r}")
            elif key.endswith("visibility") and value not in seen or key.endswith("_format") and value not in formats or \
                    key == "status" and value not in ("passed", "failed"):
                found.append(f"{key}: {value!r}")
    return found


class Gradescope(unittest.TestCase):
    def one(self, **states) -> dict:
        results = [{"exercise": name, "chapter": chapter, "ok": states.get(name[3:]) == "right", "first_failure": "lambert(...) gave 1, expected 0",
                    "hint": "a hint", "state": states.get(name[3:], "missing").replace("right", "judged").replace("wrong", "judged")}
                   for name, chapter in WANTED.items()]
        return {"student": "submission", "error": None, "right": 1, "of": len(WANTED), "results": results, "alike": []}

    def test_results_have_the_published_form(self):
        results = results_of(self.one(lambert="right", phong="wrong"), Rules(None, WANTED))
        self.assertEqual(gradescope_errors(results), [])
        tests = {test["name"]: test for test in results["tests"]}
        self.assertEqual((results["score"], tests["02.lambert"]["status"], tests["02.phong"]["status"]), (1.0, "passed", "failed"))
        self.assertIn("gave 1, expected 0", tests["02.phong"]["output"])
        self.assertEqual(gradescope_errors({"tests": [{"status": "ok", "score": "1"}], "visibility": "all"}),
                         ["visibility: 'all'", "status: 'ok'", "score: '1'"])

    def test_what_cannot_be_read_is_said(self):
        results = results_of({"student": "s", "error": "holds no exercise", "results": [], "right": 0, "of": 5}, Rules(None, WANTED))
        self.assertEqual((gradescope_errors(results), results["output"], results["score"]), ([], "holds no exercise", 0.0))

    @unittest.skipIf(why_not(), why_not())
    def test_a_submission_is_graded(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "lambert.glsl").write_text(right("02.lambert"))
            done = subprocess.run([sys.executable, REAL / "common/course/cli.py", "handout", "--autograder", "--grade", folder, "--chapter", "02"],
                                  stdout=subprocess.PIPE, text=True)
        results = json.loads(done.stdout)
        self.assertEqual((done.returncode, gradescope_errors(results), results["score"]), (0, [], 1.0), results)


class Written(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory())) / "a"
        subprocess.run([sys.executable, REAL / "common/course/cli.py", "handout", cls.folder, "--autograder"], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)

    def test_gradescope_finds_its_scripts(self):
        with zipfile.ZipFile(self.folder / "gradescope.zip") as archive:
            names = {info.filename: info.external_attr >> 16 & 0o111 for info in archive.infolist()}
        for script in ("setup.sh", "run_autograder"):
            self.assertTrue(names[script])
            subprocess.run(["bash", "-n", self.folder / "gradescope" / script], check=True)
        with tarfile.open(self.folder / "gradescope/course.tar.gz") as archive:
            self.assertIn("course", archive.getnames())

    def test_packages_are_those_of_the_commands(self):
        self.assertTrue({"bubblewrap", "python3-seccomp", "python3-libarchive-c", "cmake"} <= set(packages().split()))

    def test_the_workflow_is_one_that_classroom_reads(self):
        text = (self.folder / "classroom/.github/workflows/classroom.yml").read_text()
        self.assertRegex(text, r"results\.jsonl \|\| \[ \$\? = 1 \]")  # 3: this machine cannot judge, and there are no points
        self.assertRegex(text, r"(?m)^name: Autograding Tests$")
        self.assertRegex(text, r"(?m)^jobs:\n  run-autograding-tests:$")
        self.assertRegex(text, r"(?m)^permissions:\n  contents: read$")
        self.assertRegex(text, r"uses: actions/checkout@[0-9a-f]{40}\n")

    def test_points_are_two_notices(self):
        file = self.folder.parent / "results.jsonl"
        points = partial(subprocess.run, [sys.executable, REAL / "common/course/cli.py", "handout", "--autograder", "--chapter", "02", "--classroom", file],
                         stdout=subprocess.PIPE, text=True)
        names = list(exercises("02_lambert_phong"))
        lines = [json.dumps({"exercise": name, "ok": name == names[0], "first_failure": None if name == names[0] else "gave 1"}) for name in names]
        file.write_text("\n".join(["some words", *lines]))
        done = points()
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"::notice title=Autograding complete::Points 1/{len(names)}\n", done.stdout)
        self.assertIn(f'::notice title=Autograding report::{{"totalPoints": 1, "maxPoints": {len(names)}}}\n', done.stdout)
        for bad in ("", "{", "[" * 100000, '{"ok": true}', lines[0], lines[0] + lines[1][:20]):  # the last two: as a full disc leaves it
            file.write_text(bad)
            done = points(stderr=subprocess.PIPE)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)


class Steps(Course):
    def course(self, *words: str, code: int = 0) -> str:
        return self.run_program([sys.executable, self.root / "common/course/cli.py", *words], code=code)

    def test_reset_keeps_the_old_answer(self):
        file = self.root / "chapters/01_obj/exercise/one.cpp"
        self.restore_afterwards(file)
        starter = file.read_bytes()
        with zipfile.ZipFile(self.root / "tests/starters.zip", "w") as kept:  # as a handout has it
            kept.writestr("chapters/01_obj/exercise/one.cpp", starter)
        (self.root / "tests/starters.txt").touch()
        for number, answer in ((1, b"mine"), (2, b"mine too")):
            file.write_bytes(answer)
            self.course("reset", "01.one")
            self.assertEqual((file.read_bytes(), file.with_name(f"one.cpp.{number}.old").read_bytes()), (starter, answer))
        self.assertIn("is the starter", self.course("reset", "01.one"))
        self.assertIn("is the starter", self.course("reset", "02.one"))  # which is not in the archive
        (self.root / "tests/starters.zip").write_bytes(b"PK")
        self.assertRegex(self.course("reset", "01.one", code=1), r"\Acourse: tests/starters\.zip is damaged[^\n]*\n\Z")
        for words in (("01.nothing",), ("01",), ("",)):
            self.course("reset", *words, code=2)
        for one in file.parent.glob("*.old"):
            one.unlink()

    def test_what_is_untouched_counts_nothing(self):
        file = self.root / "chapters/01_obj/exercise/one.cpp"
        self.restore_afterwards(file)
        listed = self.root / "tests/starters.txt"
        listed.write_text(f"{digest(file.read_bytes())} chapters/01_obj/exercise/one.cpp\n")
        self.assertRegex(self.course("check", "01.one", code=1), r"open  01\.one  0 of [1-9]")
        file.write_text("begun")
        self.assertNotRegex(self.course("check", "01.one", code=1), r"open  01\.one  0 of [1-9]")
        listed.unlink()

    def test_next_is_one_step(self):
        said = self.course("check", "--next")
        self.assertRegex(said, r"\Anext: 01\.one.*\n  read .*\n  edit .*\n  then   \./course check 01\.one\n\Z")
