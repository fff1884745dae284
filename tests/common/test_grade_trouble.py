"""Files that ./course grade is given and that are damaged: one line each, exit code 2, and nothing half written."""

import json
import os
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile
from pathlib import Path

from graded_class import OF, REAL, right
from grading import marks
from grading.gradebook import Book, moodle
from grading.roster import Roster
from grading.rules import Rules
from tree import UsageError

WANTED = dict(list(OF.items())[:2])
RESULT = {"exercise": "01.transform", "chapter": "01_obj", "ok": True, "passed": 1, "failed": 0, "first_failure": None, "hint": None,
          "state": "judged"}
ENTRY = {"at": 0, "read": True, "answers": {}, "grade": {"student": "ann", "path": "ann", "error": None, "handed_in_s": None,
                                                         "results": [RESULT], "alike": []}}
HEAD = {"exercises": [["01.transform", "01_obj"]], "submissions": 1, "inputs": "a", "class": "b", "course": "c"}


class Trouble(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def merged(self, about) -> subprocess.CompletedProcess:
        file = self.folder / "grade.1-of-1.zip"
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("shard.json", about if isinstance(about, str) else json.dumps(about))
        return self.course("--merge", file)

    def course(self, *words) -> subprocess.CompletedProcess:
        return subprocess.run([sys.executable, REAL / "common/course/cli.py", "grade", "--out", self.folder / "out", *words], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def test_damaged_shards(self):
        def about(**more):
            return {"kind": "grade", "shard": [1, 1], "command": "x", "head": HEAD, "entries": {"ann": ENTRY}} | more

        def entry(**more):
            return about(entries={"ann": ENTRY | more})

        def result(**more):
            return entry(grade=ENTRY["grade"] | {"results": [RESULT | more]})
        self.assertEqual(self.merged(about()).returncode, 0, self.merged(about()).stderr)
        for bad in ("", "[]", "{", "[" * 100000, about(head=[]), about(head=HEAD | {"exercises": 1}), about(head=HEAD | {"exercises": [[1]]}),
                    about(head=HEAD | {"submissions": "1"}), about(head={}), about(entries=[]), about(entries={"ann": None}), about(shard=["1", 1]),
                    about(command=1), entry(at="x"), entry(answers=1), entry(answers={"01.transform": "../x"}), entry(grade=1), entry(read=1),
                    entry(answers={"01.transform": "abc"}), result(ok="yes"), result(state=1), result(passed="1"), result(exercise=[]),
                    result(picture=1), result(picture="../../x"), about(head=HEAD | {"exercises": [[["01.transform"], "01_obj"]]}),
                    about(head=HEAD | {"exercises": [["01.transform", "x" * 100000]]}), about(kind="a\nb"), about(kind="x" * 100000),
                    about(command="a\nb"), about(head=HEAD | {"exercises": [[{}, "01_obj"]]}), about(entries={"a\nb": ENTRY})):
            done = self.merged(bad)
            with self.subTest(str(bad)[:120]):
                self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr[-600:])

    def test_damaged_marks(self):
        answer = {"answer": "a", "result": RESULT}
        file = self.folder / "marks.json"
        for bad in ("", "[]", "{", "[" * 100000, {"ann": 1}, {"ann": {"01.transform": answer | {"result": {}}}},
                    {"ann": {"01.transform": {"result": RESULT}}}, {"ann": {"01.transform": answer | {"result": RESULT | {"state": 1}}}}):
            text = bad if isinstance(bad, str) else json.dumps(bad)
            file.write_text(text)
            with self.subTest(text[:80]), self.assertRaisesRegex(UsageError, "cannot be read"):
                marks.keep(file, [], {}, set())
            self.assertEqual(file.read_text(), text)

    def test_damaged_rosters_and_rules(self):
        file = self.folder / "a"
        for bad in (b"ID,Name\n1,\"" + b"x" * 200000, b"\xff\xfe", b"a,b\n", b"ID\n=1\n", b"ID\n\0\n" * 3):
            file.write_bytes(bad)
            with self.subTest(bad[:20]):
                try:
                    Roster(file, ["ann"])
                except UsageError as error:
                    self.assertEqual(str(error).count("\n"), 0)
        for bad in ("", "[" * 100000, "[]", '{"points": "x"}', '{"due": 1}', '{"chapters": 1}', '{"students": {"ann": {"due": 1}}}',
                    '{"points": NaN}', '{"late": true}', '{"late": null}', '{"chapters": {"01": {"weight": null}}}',
                    '{"exercises": {"%s": {"weight": null}}}' % next(iter(WANTED))):
            file.write_text(bad)
            with self.subTest(bad[:20]), self.assertRaises(UsageError):
                Rules(file, WANTED)

    def test_a_large_class_is_found_in_its_list_at_once(self):
        file = self.folder / "class.csv"
        file.write_text("Identifier,Full name\n" + "".join(f"Participant {i},Name {i}\n" for i in range(5000)))
        start_s = time.process_time()
        roster = Roster(file, [f"Name {i}" if i % 2 else f"Name {i}_{i}_assignsubmission_file_" for i in range(5000)])
        self.assertEqual((len(roster.found), len(roster.strangers)), (5000, 0))
        self.assertLess(time.process_time() - start_s, 10)  # 0.2 s; two minutes where each student reads the whole list

    def test_no_points_are_no_points(self):
        file = self.folder / "rules.json"
        file.write_text('{"points": 0}')
        rules = Rules(file, WANTED)
        self.assertEqual((rules.most, set(rules.points.values())), (0, {0.0}))
        book = Book([{"student": "ann", "error": None, "results": [], "alike": []}], rules, Roster(None, []))
        self.assertIn("ann", moodle(book))

    def test_marks_and_grades_are_their_owners_alone(self):
        self.assertEqual(self.merged({"kind": "grade", "shard": [1, 1], "command": "x", "head": HEAD, "entries": {"ann": ENTRY}}).returncode, 0)
        for name in ("grades.csv", "grades.json", "marks.json"):
            self.assertEqual((self.folder / "out" / name).stat().st_mode & 0o777, 0o600, name)

    def test_a_full_temporary_folder_is_one_line(self):
        (self.folder / "ann").mkdir()
        (self.folder / "ann" / "lambert.glsl").write_text(right("02.lambert"))
        done = subprocess.run([sys.executable, REAL / "common/course/cli.py", "grade", self.folder / "ann", "--chapter", "02"], text=True,
                              env=os.environ | {"TMPDIR": "/proc/self/fdinfo"}, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertNotIn("Traceback", done.stderr)


if __name__ == "__main__":
    unittest.main()
