"""Tests of ./course grade: a class with its table and files, what is kept, and pictures."""

import csv
import json
import os
import threading
import zipfile
from unittest import mock

from graded_class import CHAPTERS, PLACES, REAL, Class, right
from grading.grade import grade, table, write_files
from grading.judge import Judge, same_text
from grading.submission import cell, find

LAMBERT = PLACES["02.lambert"]
RIGHT = right("02.lambert").encode()
OPEN = (REAL / LAMBERT).read_bytes()


class Submissions(Class):
    """The rows of a class, its files, and what is kept of it."""

    wanted = ["02.lambert", "03.range_fade"]

    @classmethod
    def fill(cls):
        for name, data in (("plain", RIGHT), ("dos", RIGHT.replace(b"\n", b"\r\n")), ("starter in dos", OPEN.replace(b"\n", b"\r\n")),
                           ("nested/course", RIGHT), ("a name\nhonest 2 of 2\x1b[2J", RIGHT), ("=cmd|calc!A0", RIGHT)):
            cls.student(name, {"02.lambert": data})
        with zipfile.ZipFile(cls.folder / "plain.zip", "w") as archive:
            archive.writestr(LAMBERT, OPEN + b"// twice")
        with zipfile.ZipFile(cls.folder / "zip.zip", "w") as archive:
            archive.writestr(f"course/{LAMBERT}", RIGHT)
        (cls.folder / "nothing").mkdir()
        place = os.fsencode(cls.folder) + b"/\xff\xfe latin/" + os.fsencode(LAMBERT)
        os.makedirs(os.path.dirname(place))
        with open(place, "wb") as file:
            file.write(RIGHT)

    def test_what_can_be_read_is_judged(self):
        for student in ("plain", "dos", "nested", "zip", r"a name\u000ahonest 2 of 2\u001b[2J", "=cmd|calc!A0", r"\xff\xfe latin"):
            with self.subTest(student):
                self.assertIsNone(self.grades[student]["error"])
                self.assertTrue(self.result(student, "02.lambert")["ok"], self.result(student, "02.lambert"))
        self.assertEqual((self.grades["nothing"]["error"], self.grades["nothing"]["right"]), ("holds no exercise", 0))

    def test_what_was_not_changed_is_not_judged(self):
        self.assertEqual(self.result("starter in dos", "02.lambert")["state"], "unchanged")
        self.assertEqual(self.result("plain", "03.range_fade")["state"], "missing")
        self.assertTrue(same_text(b"a \r\nb", b"a\nb\n"))

    def test_two_of_one_name_are_two(self):
        self.assertEqual(self.grades["plain (2)"]["right"], 0)

    def test_no_two_students_are_one_row(self):
        """For any file names: the second "ann" is not the folder "ann (2)"."""
        at = self.outside / "names"
        for name in ("ann", "ann (2)", "ann (2) (2)", "=b", "'=b"):
            (at / name).mkdir(parents=True)
        for name in ("ann.zip", "ann.tar", "ann (2).zip"):
            (at / name).touch()
        found = [one.student for one in find([at])]
        self.assertEqual(len({cell(name) for name in found}), 8, found)
        self.assertEqual(len(set(found)), 8, found)

    def test_files_and_table(self):
        out = self.outside / "out"
        out.mkdir()
        write_files(out, list(self.grades.values()), {name: "" for name in self.wanted})
        with (out / "grades.csv").open(newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(len(rows), len(self.grades) + 1)
        self.assertEqual(rows[0][:5], ["student", "right", "of", "02.lambert", "03.range_fade"])
        by_name = {row[0]: row for row in rows}
        self.assertEqual(by_name["plain"][1:5], ["1", "2", "1", "missing"])
        self.assertIn("'=cmd|calc!A0", by_name)
        self.assertEqual(json.loads((out / "grades.json").read_text()), list(self.grades.values()))
        lines = table(list(self.grades.values()), list(CHAPTERS[1:]))
        self.assertEqual(len([line for line in lines if not line.startswith("alike")]), len(self.grades) + 1)
        for line in lines:
            self.assertTrue(line.isprintable(), line)
        self.assertRegex(next(line for line in lines if line.startswith("plain ")), r"plain +1/2 +1/1 +0/1$")

    def test_again_nothing_is_run(self):
        with Judge({name: "02_lambert_phong" if name[:2] == "02" else "03_attenuation" for name in self.wanted}, 2, False) as judge, \
                mock.patch("grading.sandbox.Running", side_effect=AssertionError("it was run")):
            judge.verdicts = self.outside / "verdicts"
            again = grade(find([self.folder / "plain", self.folder / "=cmd|calc!A0"]), judge)
        self.assertEqual([one["right"] for one in again], [1, 1])

    def test_what_was_ended_is_not_kept(self):
        """SIGTERM and Ctrl+C: a check that was killed on the way says nothing about the answer."""
        with Judge({"02.lambert": "02_lambert_phong"}, 2, False) as judge:
            judge.verdicts = self.outside / "ended"
            for after_s in (0.0, 0.02, 0.05, 0.1):  # before its process is there, and while we wait for its words
                threading.Timer(after_s, judge.stop).start()
                found = judge.verdict("02.lambert", RIGHT + b"// ended")
                self.assertEqual((found["state"], found["ok"]), ("failed", False), found)
                judge.stopped = False
            self.assertTrue(judge.verdict("02.lambert", RIGHT + b"// ended")["ok"])

    def test_random_inputs_are_those_of_the_seed(self):
        """A table of answers to the inputs that everybody can see is worth nothing."""
        wrong = b"float lambert(vec3 n, vec3 l) { return l.z > 0.3 ? 9.0 : max(dot(n, l), 0.0); }\n"
        with Judge({"02.lambert": "02_lambert_phong"}, 2, False) as judge:
            said = {judge.judge("02.lambert", wrong, seed)["first_failure"] for seed in (0, 1, 2)}
        self.assertEqual(len(said), 3, said)
