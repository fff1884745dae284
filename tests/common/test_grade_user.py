"""The attacks on grading once more by a user, whose sandboxes are made in another way than root's.

Run by root it builds what grading takes, and becomes nobody. Run by a user it has nothing to add to the other tests.
"""
# Builds: 01_obj 02_lambert_phong 03_attenuation compare serve_main serve_01_obj serve_02_lambert_phong serve_03_attenuation judge_01_obj judge_02_lambert_phong judge_03_attenuation serve_06_deferred serve_07_mipmaps serve_08_bloom serve_11_fractals serve_13_mlaa judge_06_deferred judge_07_mipmaps judge_08_bloom judge_11_fractals judge_13_mlaa

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import graded_class
import test_grade_later
from build.build import build
from grading.judge import targets

# What only whoever owns the build folder may do was done before: building, and drawing the seed. Verdicts and pictures that
# are kept go elsewhere.
AS_USER = """
import os, pathlib, sys, unittest
from build import build
build.build = lambda *wanted, **how: None
from grading import judge, judge_picture
draws = judge.Judge.draw_seed
judge.Judge.draw_seed = lambda self: draws(self) if os.access(self.folder, os.W_OK) else 7
judge.KEPT = judge_picture.KEPT = pathlib.Path(os.environ["HOME"]) / "kept"
unittest.main(module=None, argv=["as a user", *sys.argv[1:]])
"""
TESTS = ("test_grade_hostile", "test_grade_handins", "test_grade_forged", "test_grade_later.Later")  # its other class builds
LATER = {graded_class.OF[exercise] for exercise in
         (*test_grade_later.TABLES, *(exercise for exercise, _, _ in test_grade_later.ATTACKS.values()))}


def as_nobody(words: list[str], home: str) -> subprocess.CompletedProcess:
    here = str(Path(__file__).parent)
    paths = os.pathsep.join([here, str(graded_class.REAL / "common/course")])
    user = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
    # Git reads another user's copy only where it is told to.
    trusted = {"GIT_CONFIG_COUNT": "1", "GIT_CONFIG_KEY_0": "safe.directory", "GIT_CONFIG_VALUE_0": "*"}
    own = {"PYTHONPATH": paths, "HOME": home, "LIGHTWALK_CACHE": f"{home}/shaders"}
    return subprocess.run([*user, sys.executable, *words], cwd=here, env=os.environ | trusted | own, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True)


@unittest.skipUnless(os.geteuid() == 0, "a user's own tests are these already")
@unittest.skipIf(graded_class.why_not(), graded_class.why_not())
class AsUser(unittest.TestCase):
    def test_each_attack_ends_as_it_does_for_root(self):
        build([*targets(sorted({*graded_class.CHAPTERS, *LATER})), *graded_class.CHAPTERS, "compare"])
        with tempfile.TemporaryDirectory() as home:
            Path(home).chmod(0o777)
            said = as_nobody(["-c", "import graded_class; print(graded_class.why_not())"], home)
            if said.returncode or said.stdout.strip():
                self.skipTest(f"nobody cannot read the course or contain anything here: {(said.stdout or said.stderr).strip()[-200:]}")
            for tests in TESTS:
                with self.subTest(tests):
                    done = as_nobody(["-c", AS_USER, tests], home)
                    self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-6000:])
