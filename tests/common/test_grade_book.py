"""Tests of gradebooks: weights, deadlines, formats of other systems, the students' pages, and the stability of marks."""

import csv
import datetime
import hashlib
import io
import json
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

from graded_class import REAL  # noqa: F401  (the way to the modules)
from grading import feedback, marks
from grading.gradebook import Book, file_name, no_formula, write_books
from grading.judge import picture_path
from grading.roster import Roster, known_as
from grading.rules import Rules
from pages.page import data_uri
from tree import UsageError

WANTED = {"01.transform": "01_obj", "02.lambert": "02_lambert_phong", "02.phong": "02_lambert_phong"}
WRONG = "lambert(normal = (0, 1, 0), to_light = (0, 1, 0)) gave <b>0</b>, expected 1"
NOON = datetime.datetime(2027, 1, 15, 12, 0).astimezone().timestamp()


def result(exercise: str, ok=True, state="judged", said=None, **more) -> dict:
    return {"exercise": exercise, "chapter": WANTED[exercise], "ok": ok, "passed": 1, "failed": 0, "first_failure": said,
            "hint": None, "state": state, **more}


def one(student: str, *results, error=None) -> dict:
    return {"student": student, "path": student, "error": error, "handed_in_s": int(NOON), "results": list(results), "alike": []}


def class_of_three() -> list[dict]:
    missing = [result("02.phong", False, "missing", "was not handed in")]
    return [one("Ann Example_1001_assignsubmission_file", *map(result, WANTED)),
            one("exampleben_LATE_4712_99_course", result("01.transform"), result("02.lambert", False, said=WRONG), *missing),
            one("=cmd|calc", error="cannot be read")]


def rows_of(text: str) -> list[list[str]]:
    return list(csv.reader(io.StringIO(text, newline="")))


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def file(self, text, name="file") -> Path:
        (self.folder / name).write_text(text if isinstance(text, str) else json.dumps(text))
        return self.folder / name

    def rules(self, **given) -> Rules:
        return Rules(self.file(given), WANTED)

    def book(self, roster="", grades=None, **given) -> Book:
        grades = grades or class_of_three()
        return Book(grades, self.rules(**given), Roster(self.file(roster, "roster.csv") if roster else None,
                                                        [student["student"] for student in grades]))

    def written(self, kind: str, book: Book) -> str:
        [name] = write_books(self.folder, book, [kind])
        return (self.folder / name).read_bytes().decode()


class Marks(Files):
    def mark(self, rules: Rules, exercise="02.phong", ok=True, student="ann", state="judged") -> tuple:
        return rules.mark(one(student), result(exercise, ok, state))

    def test_weights(self):
        rules = self.rules(points=100, chapters={"02": {"weight": 2}}, exercises={"02.phong": {"weight": 4.5}})
        self.assertEqual(rules.points, {"01.transform": 100 / 12, "02.lambert": 200 / 12, "02.phong": 75})
        self.assertEqual(Rules(None, WANTED).points, dict.fromkeys(WANTED, 1))

    def test_late_and_missing_are_words(self):
        rules = self.rules(due="2027-01-15 11:59")
        self.assertEqual(self.mark(rules), ("late", None))
        self.assertEqual(self.mark(rules, state="missing"), ("missing", None))
        self.assertEqual(self.mark(rules, state="unchanged"), ("missing", None))
        self.assertEqual(self.mark(rules, state="undecided"), ("look at", None))
        self.assertEqual(self.mark(self.rules(due="2027-01-15 12:00")), ("right", 1))
        self.assertEqual(self.mark(self.rules(due="2027-01-15 11:59", late=0.5)), ("late", 0.5))
        self.assertEqual(self.mark(self.rules(due="2027-01-15 11:59", late=0.5), ok=False), ("late", 0))

    def test_the_most_specific_deadline_counts(self):
        early, late = "2027-01-15 11:00", "2027-01-15 13:00"
        for given, word in (({"due": early, "chapters": {"02": {"due": late}}}, "right"),
                            ({"chapters": {"02": {"due": late}}, "exercises": {"02.phong": {"due": early}}}, "late"),
                            ({"exercises": {"02.phong": {"due": early}}, "students": {"ann": {"due": {"02": late}}}}, "right"),
                            ({"due": late, "students": {"ann": {"due": {"all": early}}}}, "late"),
                            ({"students": {"ann": {"due": {"all": early, "02": late}}}}, "right"),
                            ({"due": early, "students": {"ben": {"due": {"all": late}}}}, "late"),
                            ({"due": late, "students": {"ann": {"handed_in": "2027-01-16 10:00"}}}, "late"),
                            ({"due": "2027-01-15T12:00:00-23:59"}, "right")):
            self.assertEqual(self.mark(self.rules(**given))[0], word, given)

    def test_what_is_wrong_with_rules_is_one_line(self):
        for given, said in (("[", "is not JSON"), ([], "not an object"), ({"dew": 1}, "unknown key 'dew'; there are chapters, due"),
                            ({"late": 2}, "late is 2, expected a number from 0 to 1"), ({"due": "soon"}, "due is 'soon', expected a time"),
                            ({"chapters": {"03": {}}}, "there is no '03'"), ({"exercises": {"02.fong": {}}}, "there is no '02.fong'"),
                            ({"chapters": {"02": {"weight": -1}}}, "chapters: 02: weight is -1"), ({"chapters": []}, "not an object"),
                            ({"students": {"ann": {"due": {"2": "x"}}}}, "students: ann: due: there is no '2'"),
                            ({"points": True}, "points is True"), ({"chapters": {"01": {"weight": 0}, "02": {"weight": 0}}}, "weights are 0")):
            with self.assertRaisesRegex(UsageError, said) as caught:
                Rules(self.file(given), WANTED)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(UsageError, "No such file"):
            Rules(self.folder / "none", WANTED)

    def test_the_same_answer_keeps_its_mark(self):
        """Even with other checks; --regrade replaces it with a message; a new answer is judged for itself."""
        file, data = self.folder / "marks.json", {"ann": {"02.phong": b"x"}}
        right, wrong = result("02.phong"), result("02.phong", False, said="no")
        def kept(new, answers=data, regraded=()):
            grades = [one("ann", new)]
            said = marks.keep(file, grades, answers, set(regraded))
            return grades[0]["results"][0], said
        self.assertEqual(kept(right), (right, []))
        self.assertEqual(kept(wrong), (right, []))
        self.assertEqual(kept(result("02.phong", False, "failed", "no disk"))[0]["state"], "failed")
        self.assertEqual(kept(wrong, regraded=["02.phong"]), (wrong, ["02.phong: ann: right before, wrong now"]))
        self.assertEqual(kept(right), (wrong, []))
        self.assertEqual(kept(right, {"ann": {"02.phong": b"y"}}), (right, []))
        file.write_text("{")
        with self.assertRaisesRegex(UsageError, "holds the marks that were given, so it is not replaced"):
            kept(right)
        self.assertEqual(file.read_text(), "{")


class Platforms(Files):
    def test_canvas(self):
        roster = ('Student,ID,SIS User ID,SIS Login ID,Section,Lightwalk 02 (77),Final Score\n    Points Possible,,,,,10,\n'
                  '"Example, Ann",4711,,ann,A,,\n"=2+5, Ben",4712,00815,ben,"A, ""B""",,\n"Gone, Cat",4713,,cat,A,,\n"Student, Test",9,,,,,\n')
        rows = rows_of(self.written("canvas", self.book(roster, points=30)))
        self.assertEqual(rows[0], ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", "Lightwalk 01 From a text file to a shaded mesh", "Lightwalk 02 (77)"])
        self.assertEqual(rows[1], ["    Points Possible", "", "", "", "", "10", "20"])
        by_id = {row[1]: row for row in rows[2:]}
        self.assertIn('"4712","00815"', (self.folder / "gradebook.canvas.csv").read_text())
        self.assertEqual(by_id["4712"], ["'=2+5, Ben", "4712", "00815", "ben", 'A, "B"', "10", "0"])
        self.assertEqual(by_id["4713"][5:], ["", ""])  # handed in nothing: no grade
        self.assertEqual(len(rows), 2 + 3 + 2)  # of the class, and two that are not in it

    def test_moodle_worksheet(self):
        roster = ("Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,Feedback comments\n"
                  "Participant 1001,Ann Example,ann@example.org,Submitted,,10.00,Yes,\n"
                  "Participant 1002,Cat Gone,cat@example.org,No submission,,10.00,Yes,\n")
        rows = rows_of(self.written("moodle", self.book(roster)))
        self.assertEqual(rows[0], roster.splitlines()[0].split(","))
        self.assertEqual(rows[1][:6], ["Participant 1001", "Ann Example", "ann@example.org", "Submitted", "10", "10.00"])
        self.assertEqual(rows[1][7], "01.transform: right, 1 of 1<br>02.lambert: right, 1 of 1<br>02.phong: right, 1 of 1")
        self.assertEqual((rows[2][4], rows[2][7][:44]), ("", "Your submission: handed in nothing.<br>01.tr"))
        self.assertEqual(len(rows), 3)

    def test_moodle_list(self):
        roster = "First name;Surname;Username;Email address\nBen;Example;exampleben;ben@x.org\n"
        rows = rows_of(self.written("moodle", self.book(roster)))
        self.assertEqual(rows[0][:4] + rows[0][-2:], ["First name", "Surname", "Username", "Email address", "Lightwalk total", "Feedback"])
        ben = next(row for row in rows if row[2] == "exampleben")
        self.assertEqual(ben[4:7], ["1", "0", "1"])
        self.assertIn("02.lambert: wrong, 0 of 1. lambert(normal = (0, 1, 0)", ben[7])
        self.assertIn("02.phong: missing", ben[7])

    def test_a_name_is_found_with_the_other_apostrophe(self):
        file = self.folder / "list.csv"
        file.write_text("First name,Last name\nZo\u00eb,O\u2019Neill\nAnn,D'Arc\n")
        students = ["Zoe\u0308 O'Neill_7_assignsubmission_file_", "Ann D\u2019Arc"]
        self.assertEqual(Roster(file, students).strangers, [])
        self.assertEqual(Roster(file, ["Zoe O'Neill"]).strangers, ["Zoe O'Neill"])

    def test_a_list_of_another_platform(self):
        """Canvas's file has a name in each row, for any list."""
        roster = "Identifier,Full name,Grade,Feedback comments\nParticipant 1001,Ann Example,,\n"
        rows = rows_of(self.written("canvas", self.book(roster, points=100)))
        self.assertEqual([row[:2] + row[-2:] for row in rows[1:3]], [["    Points Possible", "", "33.33", "66.67"],
                                                                     ["Ann Example", "Participant 1001", "33.33", "66.67"]])

    def test_feedback_is_no_formula(self):
        for text, meant in (("f(a = (0, -1, 0)) gave -1", "f(a = (0, -1, 0)) gave -1"), ("=1", "'=1"), ("a\n+x", "a\n'+x"),
                            ("a;-x", "a;'-x"), ("a\n-1.5", "a\n-1.5"), ("x | @y", "x | '@y"), ("a = b", "a = b")):
            self.assertEqual(no_formula(text), meant)

    def test_without_a_list(self):
        self.assertEqual(rows_of(self.written("moodle", self.book()))[1][:2], ["1001", "Ann Example"])
        rows = rows_of(self.written("csv", self.book()))
        self.assertEqual(rows[0], ["student", "name", "id", "points", "of", *WANTED, "error"])
        self.assertEqual(rows[2][1:], ["exampleben", "4712", "1", "3", "1", "0", "missing", ""])
        self.assertEqual(rows[3], ["'=cmd|calc", "'=cmd|calc", "", "missing", "3", "missing", "missing", "missing", "cannot be read"])
        parsed = json.loads(self.written("json", self.book()))
        self.assertEqual(parsed[1]["marks"]["02.lambert"]["said"], WRONG)
        self.assertEqual(known_as("plain"), ("plain", ""))

    def test_a_list_that_cannot_be_used_is_one_line(self):
        for text, said in (("a,b\n1,2\n", "names no column"), ("", "names no column"),
                           ("Username\n=1\n", r":2: Username: '=1' would be read as a formula")):
            with self.assertRaisesRegex(UsageError, said):
                Roster(self.file(text), [])
        (self.folder / "latin").write_bytes(b"Username\n\xff\n")
        with self.assertRaisesRegex(UsageError, "is not UTF-8"):
            Roster(self.folder / "latin", [])
        self.assertEqual(Roster(self.file("ID,Student\n4712,Ben\n"), ["x_4712_1_a", "eve"]).strangers, ["eve"])
        self.assertEqual(Roster(self.file("ID,Student\n1,Ben\n2,Ben\n"), ["Ben"]).strangers, ["Ben"])  # which one?


class Tags(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags, self.links, self.words = [], [], ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.links += [value for name, value in attributes if name in ("href", "src")]

    def handle_data(self, data):
        self.words += data


class Pages(Files):
    def test_a_page_says_what_is_wrong(self):
        png = (REAL / "tests/02_lambert_phong/golden").glob("*.png").__next__().read_bytes()
        digest = hashlib.sha256(png).hexdigest()
        path = picture_path(digest)
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(png)
            self.addCleanup(path.unlink)
        drawn = result("02.phong", False, said="the numbers are right, the picture of bunny is not", picture=digest, picture_expected=digest)
        grades = class_of_three()
        grades[0]["results"][2] = drawn
        book = self.book("", grades, due="2027-01-15 13:00")
        submitted = {grades[1]["student"]: {"02.lambert": b"float </pre><script>alert(1)</script>"}, grades[0]["student"]: {}}
        self.assertEqual(feedback.write_pages(self.folder / "f", book, grades, submitted, {}), 3)
        pages = {name: Tags((self.folder / "f" / f"{file_name(name)}.html").read_text()) for name in (one["student"] for one in grades)}
        ben = pages["exampleben_LATE_4712_99_course"]
        for words in ("exampleben", "first case that is wrong", "lambert(normal = (0, 1, 0), to_light = (0, 1, 0))", "<b>0</b>",
                      "expected", "alert(1)", "missing", "1 of 3 points"):
            self.assertIn(words, ben.words)
        self.assertNotIn("script", ben.tags)
        self.assertIn("Nothing was handed in", pages["=cmd|calc"].words)
        ann = pages["Ann Example_1001_assignsubmission_file"]
        self.assertEqual(ann.links.count(data_uri(path)), 2)
        for page in pages.values():
            self.assertEqual([link for link in page.links if not link.startswith(("data:", "#"))], [])

    def test_names_of_pages(self):
        self.assertEqual(file_name("ann (2)"), "ann (2)")
        names = {file_name(name) for name in ("../../etc", "..\\..\\etc", "a/b", "a:b", ".", "", "a\nb", "x" * 300, "=cmd|calc", "'=cmd|calc")}
        self.assertEqual(len(names), 10)
        for name in names:
            self.assertRegex(name, r"\A[\w ()-][\w .()-]{0,120}\Z")


if __name__ == "__main__":
    unittest.main()
