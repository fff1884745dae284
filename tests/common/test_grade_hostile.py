"""Submissions that attack their grading (hostile.py): each is contained, gets no mark, and costs nobody else one."""

import ctypes
import os
import socket
import threading
from pathlib import Path

from graded_class import CHAPTERS, REAL, Class, right
from hostile import ABSTRACT, ATTACKS, OUTSIDE
from tree import BUILD

PR_SET_CHILD_SUBREAPER = 36
HONEST = ("01.triangulate", "02.lambert", "02.record_mist", "03.light_reaches_box")


class Hostile(Class):
    wanted = ["01.parse_face", "01.triangulate", "02.lambert", "02.record_mist", "03.light_reaches_box"]

    @classmethod
    def fill(cls):
        # A process that loses its parent becomes this one's child, whoever else grades on this machine.
        if ctypes.CDLL(None, use_errno=True).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0):
            raise OSError(ctypes.get_errno(), "prctl")
        Path(OUTSIDE).unlink(missing_ok=True)
        cls.heard = []
        listening = [socket.socket(socket.AF_INET), socket.socket(socket.AF_UNIX)]
        listening[0].bind(("127.0.0.1", 0))
        listening[1].bind(f"\0{ABSTRACT}.{os.getpid()}")
        for one in listening:
            one.listen()
            cls.addClassCleanup(one.close)
            threading.Thread(target=cls.listen, args=(one,), daemon=True).start()
        words = {"ROOT": str(REAL), "BUILD": str(BUILD), "CLASS": str(cls.folder), ABSTRACT: f"{ABSTRACT}.{os.getpid()}",
                 "PORT": str(listening[0].getsockname()[1])}
        for name in ("aa honest", "zz honest"):
            # Judged twice: a line more makes it another file.
            cls.student(name, {exercise: right(exercise) + f"// {name}\n" for exercise in HONEST})
        for name, (answers, _) in ATTACKS.items():
            cls.student(name, {exercise: with_words(text, words) for exercise, text in answers.items()})

    @classmethod
    def listen(cls, one):
        try:
            one.accept()
            cls.heard.append("a connection")
        except OSError:
            pass

    @classmethod
    def judges_are_built(cls):
        cls.before = {path: path.read_bytes() for path in cls.guarded()}

    @staticmethod
    def guarded():
        paths = [*(REAL / "tests/03_attenuation").glob("checks*"), *(REAL / "shaders/02_lambert_phong").rglob("*.glsl")]
        return [*paths, *(REAL / "chapters/03_attenuation").rglob("*.cpp"),
                *[BUILD / "grade" / f"judge_{chapter}" for chapter in CHAPTERS if (BUILD / "grade" / f"judge_{chapter}").exists()]]

    def test_attacks_get_no_mark_and_are_told_why(self):
        for name, (answers, words) in ATTACKS.items():
            for exercise in answers:
                with self.subTest(name):
                    self.assertIsNone(self.grades[name]["error"])
                    result = self.result(name, exercise)
                    self.assertFalse(result["ok"], result)
                    self.assertNotIn("BROKE OUT", result["first_failure"])
                    self.assertRegex(result["first_failure"], words)
                    self.assertTrue(result["first_failure"].isprintable(), result)
                    self.assertLess(len(result["first_failure"]), 1000)

    def test_the_honest_lose_nothing(self):
        for name in ("aa honest", "zz honest"):
            for exercise in HONEST:
                self.assertTrue(self.result(name, exercise)["ok"], self.result(name, exercise))
            self.assertEqual(self.grades[name]["right"], len(HONEST))

    def test_nothing_is_left_behind(self):
        self.assertEqual([path for path, text in self.before.items() if path.read_bytes() != text], [])
        self.assertEqual(self.heard, [])
        for path in (OUTSIDE, self.folder / "x", REAL / "x", "/x", "/usr/x"):
            self.assertFalse(os.path.exists(path), path)
        # A process that has lost its parent is this one's child (fill()); of one that has ended there are no words.
        children = Path(f"/proc/self/task/{os.getpid()}/children").read_text().split()
        self.assertEqual(list(filter(None, (Path(f"/proc/{one}/cmdline").read_bytes() for one in children))), [])


def with_words(text, words: dict[str, str]):
    if isinstance(text, bytes):
        return text
    for word, meant in words.items():
        text = text.replace(word, meant)
    return text
