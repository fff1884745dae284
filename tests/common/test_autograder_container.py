"""./course handout --autograder as Gradescope uses it: its two scripts in a bare Debian, and results.json by the published form."""
# Builds: nothing

import json
import shutil
import subprocess
import tempfile
import unittest
import zipfile

from graded_class import REAL, right
from test import container
from test_autograder import gradescope_errors
from tree import BUILD, UsageError


def why_not() -> str:
    try:
        container.require("bookworm")
    except UsageError as error:
        return str(error)
    return ""


@unittest.skipIf(why_not(), why_not())
class Container(unittest.TestCase):
    """One image for all submissions, as there."""

    @classmethod
    def setUpClass(cls):
        cls.root = BUILD / "on" / "gradescope" / "root"
        container.make_system("bookworm", cls.root)
        made = cls.enterClassContext(tempfile.TemporaryDirectory())
        subprocess.run([REAL / "course", "handout", f"{made}/a", "--autograder", "--chapter", "02"], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        cls.at = cls.root / "autograder"
        shutil.rmtree(cls.at, ignore_errors=True)
        for name in ("source", "results"):
            (cls.at / name).mkdir(parents=True)
        with zipfile.ZipFile(f"{made}/a/gradescope.zip") as archive:
            archive.extractall(cls.at / "source")
        cls.within("/autograder/source/setup.sh")

    @classmethod
    def within(cls, script: str) -> str:
        done = subprocess.run(container.contained(cls.root, ["bash", script], "/autograder"), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode:
            raise AssertionError(f"{script} ended with {done.returncode}:\n{done.stdout[-4000:]}")
        return done.stdout

    def graded(self, **answers: str) -> dict:
        """The results of a submission, a file for each of chapter 02's exercises."""
        shutil.rmtree(self.at / "submission", ignore_errors=True)
        (self.at / "submission").mkdir()
        (self.at / "results/results.json").unlink(missing_ok=True)
        for name, text in answers.items():
            (self.at / "submission" / name.replace("__", ".")).write_text(text)
        self.within("/autograder/source/run_autograder")
        results = json.loads((self.at / "results/results.json").read_text())
        self.assertEqual(gradescope_errors(results), [])
        return results

    def test_answers_get_their_points(self):
        results = self.graded(lambert__glsl=right("02.lambert"), record_mist__cpp=right("02.record_mist"),
                              phong__glsl="float phong(vec3 n, vec3 l, vec3 e, float s) { return 0.0; }\n")
        status = {test["name"]: (test["status"], test["score"]) for test in results["tests"]}
        self.assertEqual([status[name] for name in ("02.lambert", "02.record_mist", "02.phong")],
                         [("passed", 1.0), ("passed", 1.0), ("failed", 0.0)], results)
        self.assertEqual(results["score"], 2.0)

    def test_nothing_readable_is_said(self):
        results = self.graded(notes__txt="I have done nothing.\n")
        self.assertEqual(results["score"], 0.0)
        self.assertTrue(results["output"])
