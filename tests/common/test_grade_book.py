"""Tests of gradebooks: weights, deadlines, class lists with the damage that platforms, spreadsheets and hands do to them, formats of
other systems, the students' pages, and the stability of marks."""
# Builds: nothing

import csv
import datetime
import hashlib
import io
import json
import os
import time
from pathlib import Path
from unittest import mock

from folder_case import FolderCase
from graded_class import REAL  # (the way to the modules)
from html_seen import Seen
from grading import feedback, grade, marks
from grading.gradebook import Book, file_name, no_formula, page_names, write_books
from grading.judge import picture_path
from grading.roster import Roster, known_as
from grading.rules import Rules
from grading.submission import Submission, read, time_of
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


class Files(FolderCase):
    def file(self, text, name="file") -> Path:
        return self.write(name, text if isinstance(text, (str, bytes)) else json.dumps(text))

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
        for text, said in RULES.items():
            with self.subTest(text[:60]), self.assertRaisesRegex(UsageError, said) as caught:
                Rules(self.file(text), WANTED)
            self.assertNotIn("\n", str(caught.exception))
            self.assertLess(len(str(caught.exception)), 600)
        with self.assertRaisesRegex(UsageError, "No such file"):
            Rules(self.folder / "none", WANTED)
        keys = ", ".join(f'"{number // 2}": 1' for number in range(80_000))
        start_s = time.process_time()
        self.assertRaises(UsageError, Rules, self.file(f"{{{keys}}}"), WANTED)
        self.assertLess(time.process_time() - start_s, 5)  # 0.1 s; half a minute where it grows as the square

    def test_a_time_that_no_calendar_has(self):
        rules, file = Rules(None, WANTED), self.file("", "ann.zip")
        os.utime(file, (253402300800 + 86400 * 400,) * 2)  # a file system may have cut it
        for seconds in (4e11, -1e18, 1e300, time_of(file, [])):
            rules.handed_in("ann", seconds)

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
        self.assertEqual(kept(right, regraded=["02.lambert"]), (wrong, []))
        self.assertEqual(kept(right, regraded=["02.phong"]), (right, ["02.phong: ann: wrong before, right now"]))
        self.assertEqual(kept(wrong, {"ann": {"02.phong": b"y"}}), (wrong, []))

    def test_marks_that_are_damaged_are_not_replaced(self):
        answer, file = {"answer": "a" * 64, "result": result("02.phong")}, self.folder / "marks.json"
        for bad in ("", "[]", "{", "[" * 100000, {"ann": 1}, {"ann": {"02.phong": answer | {"result": {}}}}, {"ann": {"02.phong": answer | {"answer": 5}}},
                    {"ann": {"02.phong": {"result": result("02.phong")}}}, {"ann": {"02.phong": answer | {"result": result("02.phong", state=1)}}}):
            before = self.file(bad, "marks.json").read_text()
            with self.subTest(str(bad)[:80]), self.assertRaisesRegex(UsageError, "cannot be read: .*it holds the marks that were given, so it is not replaced"):
                marks.keep(file, [], {}, set())
            self.assertEqual(file.read_text(), before)


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
        file = self.file("First name,Last name\nZo\u00eb,O\u2019Neill\nAnn,D'Arc\n")
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


WORKSHEET = "Identifier,Full name,Status,Grade,Maximum Grade,Feedback comments\n"
CANVAS = "Student,ID,SIS User ID,SIS Login ID,Section\n"
ILIAS = "Lastname;Firstname;Login\n"
REFUSED = {
    "Moodle: two rows of one participant": (WORKSHEET + "Participant 1001,Ann,,,10,\nParticipant 1002,Ben,,,10,\nParticipant 1001,Ann,,,10,\n",
                                            ":4: Identifier: 'Participant 1001' stands in line 2 too"),
    "Moodle: a name's comma": (WORKSHEET + "Participant 1001,Example, Ann,,,10,\n", ":2: has 7 cells, the first line 6"),
    "Moodle: a quote that is closed a line later": (WORKSHEET + 'Participant 1001,"Ann,,,10,\nParticipant 1002,Ben",,,10,\n',
                                                       ":3: Full name: .* a quote is not closed"),
    "Moodle: a quote that is never closed": (WORKSHEET + 'Participant 1001,"Ann,,,10,\nParticipant 1002,Ben,,,10,\n', "is no CSV"),
    "Moodle: no number as the maximum": (WORKSHEET + "Participant 1001,Ann,,,1.000.0,\n", ":2: the maximum grade is no number: '1.000.0'"),
    "Moodle: two columns of grades": (WORKSHEET.replace("Status", "Grade"), "names the column 'grade' twice"),
    "Canvas: a long number by a spreadsheet": (CANVAS + "Ann,1.23457E+11,,ann,A\n", ":2: ID: '1.23457E[+]11' was rounded"),
    "Canvas: a number with a point": (CANVAS + "Ann,4711.0,,ann,A\n", ":2: ID: '4711.0' was rounded"),
    "Canvas: one login of two students": (CANVAS + "Ann,4711,,ann,A\nBen,4712,,ANN,A\n", ":3: SIS Login ID: 'ANN' stands in line 2 too"),
    "Canvas: two columns of numbers": (CANVAS.replace("SIS User ID", "ID"), "names the column 'id' twice"),
    "Canvas: a name without quotes": (CANVAS + "Example, Ann,4711,,ann,A\n", ":2: has 6 cells, the first line 5"),
    "ILIAS: one login twice": (ILIAS + "Example;Ann;aexample\nExample;Anton;aexample\n", ":3: Login: 'aexample' stands in line 2 too"),
    "ILIAS: a login as a number": (ILIAS + "Example;Ann;2,01E+9\n", ":2: Login: '2,01E[+]9' was rounded"),
    "ILIAS: a formula": (ILIAS + "Example;Ann;=1+1\n", ":2: Login: '=1[+]1' would be read as a formula"),
    "ILIAS: a semicolon in a name": (ILIAS + "Example; PhD;Ann;aexample\n", ":2: has 4 cells, the first line 3: a name with a ';'"),
    "ILIAS: text behind a quote": (ILIAS + 'Example;"Ann"a;aexample\n', ":2: is no CSV"),
    "no column of a person": ("a,b\n1,2\n", "names no column"),
    "nothing": ("", "names no column"),
    "a cell that does not end": ("ID,Name\n1,\"" + "x" * 200000, "is no CSV"),
    "UTF-16": (b"\xff\xfe", "is not UTF-8"),
}
RULES = {
    "[": "is not JSON", "": "is not JSON", "[" * 100000: "is not JSON", "[]": "not an object", '{"dew": 1}': "unknown key 'dew'; there are chapters, due",
    '{"late": 2}': "late is 2, expected a number from 0 to 1", '{"late": true}': "late is True", '{"late": null}': "late is None",
    '{"due": "soon"}': "due is 'soon', expected a time", '{"due": 1}': "due is 1", '{"points": true}': "points is True", '{"points": "x"}': "points is 'x'",
    '{"points": NaN}': "points is nan", '{"chapters": {"03": {}}}': "there is no '03'", '{"chapters": []}': "not an object",
    '{"exercises": {"02.fong": {}}}': "there is no '02.fong'", '{"chapters": {"02": {"weight": -1}}}': "chapters: 02: weight is -1",
    '{"chapters": {"02": {"weight": null}}}': "weight is None", '{"students": {"ann": {"due": 1}}}': "due is not an object",
    '{"students": {"ann": {"due": {"2": "x"}}}}': "students: ann: due: there is no '2'",
    '{"chapters": {"01": {"weight": 0}, "02": {"weight": 0}}}': "weights are 0",
    '{"points": 100, "points": 10}': "the key 'points' stands there twice",
    '{"exercises": {"02.phong": {"weight": 1}, "02.phong": {"weight": 0}}}': "'02.phong' stands there twice",
    '{"a\\nb": 1}': r"unknown key 'a\\u000ab'", '{"students": {"a\\nb": {"due": {"x": 1}}}}': "there is no 'x'",
    '{"%s": 1}' % ("x" * 100000): "unknown key"}


class Lists(Files):
    def test_what_would_mix_up_students_is_one_line(self):
        for name, (text, said) in REFUSED.items():
            with self.subTest(name), self.assertRaisesRegex(UsageError, said) as caught:
                Roster(self.file(text), [])
            self.assertNotIn("\n", str(caught.exception))
        self.assertEqual(Roster(self.file("ID,Student\n4712,Ben\n"), ["x_4712_1_a", "eve"]).strangers, ["eve"])
        self.assertEqual(Roster(self.file("ID,Student\n1,Ben\n2,Ben\n"), ["Ben"]).strangers, ["Ben"])  # which one?

    def test_the_platforms_time_counts(self):
        student = "Ann_1001_assignsubmission_file_"
        file = self.file('Identifier,Full name,Last modified (submission)\nParticipant 1001,Ann,"Thursday, 14 January 2027, 11:58 PM"\n')
        self.assertEqual(datetime.datetime.fromtimestamp(Roster(file, [student]).handed_in_s(student)), datetime.datetime(2027, 1, 14, 23, 58))

    def test_a_large_class_is_found_in_its_list_at_once(self):
        file = self.file("Identifier,Full name\n" + "".join(f"Participant {i},Name {i}\n" for i in range(5000)))
        start_s = time.process_time()
        roster = Roster(file, [f"Name {i}" if i % 2 else f"Name {i}_{i}_assignsubmission_file_" for i in range(5000)])
        self.assertEqual((len(roster.found), len(roster.strangers)), (5000, 0))
        self.assertLess(time.process_time() - start_s, 10)  # 0.2 s; two minutes where each student reads the whole list

    def test_a_comma_in_the_maximum_is_a_comma(self):
        roster = WORKSHEET.replace(",", ";") + "Participant 1001;Ann Example;;;20,00;\n"
        self.assertEqual(rows_of(self.written("moodle", self.book(roster)))[1][3], "20")

    def test_a_students_words_are_no_formula_in_the_worksheet(self):
        roster = WORKSHEET + "Participant 1001,=Ann,-,,10,\n"
        self.assertEqual(rows_of(self.written("moodle", self.book(roster)))[1][1:3], ["'=Ann", "-"])

    def test_rows_that_are_no_person_are_left_out(self):
        roster = Roster(self.file(CANVAS[:-1] + ",Lightwalk 02 (7)\n,,,,,Manual Posting\n    Points Possible,,,,,3\nAnn,4711,,ann,A,\n"), ["ann_4711_1_a.zip"])
        self.assertEqual((len(roster.rows), roster.absent, roster.strangers), (1, [], []))

    def test_a_number_is_the_whole_number(self):
        roster = Roster(self.file("ID,Student\nA47-11,Ann\n"), ["ben_4711_1_a.zip"])
        self.assertEqual(roster.strangers, ["ben_4711_1_a.zip"])

    def test_a_folder_of_ilias_is_found_by_its_login(self):
        text = ILIAS + "Example;Ann;aexample\nExample;Ann;annex\n"
        roster = Roster(self.file(text), ["Example_Ann_annex_1234", "Example_Ann_other_1235"])
        self.assertEqual((roster.of("Example_Ann_annex_1234")["Login"], roster.strangers), ("annex", ["Example_Ann_other_1235"]))
        self.assertEqual(roster.name(roster.of("Example_Ann_annex_1234")), "Ann Example")


class Several(Files):
    def test_all_entries_of_a_number_are_one_student(self):
        """Canvas and Moodle write an entry for each file, and for a text."""
        first, later = "annex_4711_11_lambert.glsl", "annex_LATE_4711_12_lambert-1.glsl"
        text, files = "Ann Example_1001_assignsubmission_onlinetext_", "Ann Example_1001_assignsubmission_file_"
        grades = [one(later, result("02.lambert")), one(first, result("02.lambert", False), result("02.phong")),
                  one(text, error="holds no exercise"), one(files, result("01.transform")), one("ben", error="holds no exercise")]
        roster = "Identifier,ID,Full name\nParticipant 1001,1,Ann Example\nParticipant 1002,4711,Ann Ex\n"
        book = self.book(roster, grades)
        self.assertEqual([(row["name"], row["points"], row["error"]) for row in book.rows],
                         [("Ann Ex", 2, None), ("Ann Example", 1, None), ("ben", None, "holds no exercise")])
        self.assertEqual(book.rows[0]["marks"]["02.lambert"]["student"], later)
        self.assertEqual(len(rows_of(self.written("moodle", book))), 1 + 3)
        self.assertEqual(feedback.write_pages(self.folder / "f", book, grades, {first: {"02.phong": b"mine"}}), 3)

    def test_a_name_that_holds_anothers_number_is_nobodys(self):
        list_of = self.file(WORKSHEET + "Participant 1001,Ann,,,10,\nParticipant 2002,Eve,,,10,\n")
        for name in ("Eve_1001_assignsubmission_ x_2002_assignsubmission_file_", "Eve_2002_assignsubmission_file__1001_assignsubmission_.zip"):
            self.assertEqual(Roster(list_of, [name]).strangers, [name])

    def test_a_name_that_two_claim_is_nobodys(self):
        list_of = self.file("ID,Student\n4712,Ben\n4713,Eve\n")
        roster = Roster(list_of, ["ben_4712_1_a", "Ben", "Eve", "EVE"])
        self.assertEqual((set(roster.found), roster.strangers), ({"ben_4712_1_a"}, ["Ben", "Eve", "EVE"]))
        self.assertEqual([row["Student"] for row in roster.absent], ["Eve"])

    def test_nobody_is_alike_with_oneself(self):
        names = ["ann_4711_11_a.glsl", "ann_4711_12_b.glsl", "ben_4712_13_a.glsl"]
        with mock.patch.object(grade, "alike", lambda *_: [(names[0], names[1], "all"), (names[1], names[2], "all")]):
            grades = grade.complete({name: one(name) for name in names}, {}, WANTED)
        self.assertEqual([[other["student"] for other in row["alike"]] for row in grades], [[], [names[2]], [names[1]]])

    def test_a_file_that_was_handed_in_again_is_known_by_its_name(self):
        for name in ("annex_4711_12_lambert-1.glsl", "annex_4711_12_lambert (2).glsl", "lambert.glsl"):
            (self.folder / name).write_bytes(b"mine")
            inside = "shaders/02_lambert_phong/exercise/lambert.glsl"
            self.assertEqual(read(Submission(name, self.folder / name), {inside}), {inside: b"mine"})


class Grades(Files):
    def points(self, *results, **rules) -> dict:
        return self.book("", [one("ann", *results)], **rules).rows[0]

    def test_nothing_and_halves_are_numbers(self):
        wrong = [result(exercise, False) for exercise in ("01.transform", "02.lambert", "02.phong")]
        self.assertEqual(self.points(*wrong)["points"], 0)
        late = self.points(result("01.transform"), due="2027-01-15 11:59", late=0.5)
        self.assertEqual((late["points"], late["chapters"]), (0.5, {"01_obj": 0.5, "02_lambert_phong": None}))
        self.assertEqual(self.points(result("01.transform"), points=0)["points"], 0)
        self.assertIn("ann", self.written("moodle", self.book("", [one("ann")], points=0)))
        free = self.points(result("01.transform"), result("02.phong"), exercises={"02.phong": {"weight": 0}})
        self.assertEqual((free["points"], free["of"], free["marks"]["02.phong"]["points"]), (1, 2, 0))

    def test_a_mark_that_is_still_to_come_is_no_0(self):
        for state, word in (("failed", "not judged"), ("undecided", "look at")):
            grades = [one("ann", result("01.transform"), result("02.lambert", False, state, "no space"), result("02.phong"))]
            book = self.book("", grades)
            self.assertEqual((book.rows[0]["points"], book.rows[0]["chapters"]["01_obj"], book.rows[0]["nothing"]), (None, 1, word))
            self.assertEqual(rows_of(self.written("canvas", book))[2][5:], ["1", ""])
            self.assertEqual(rows_of(self.written("moodle", book))[1][2:5], ["1", "-", "-"])
            self.assertEqual(rows_of(self.written("csv", book))[1][3:7], [word, "3", "1", word])


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
        self.assertEqual(feedback.write_pages(self.folder / "f", book, grades, submitted), 3)
        pages = {name: Seen((self.folder / "f" / f"{file_name(name)}.html").read_text()) for name in (one["student"] for one in grades)}
        ben = pages["exampleben_LATE_4712_99_course"]
        for words in ("exampleben", "first case that is wrong", "lambert(normal = (0, 1, 0), to_light = (0, 1, 0))", "<b>0</b>",
                      "expected", "alert(1)", "missing", "1 of 3 points"):
            self.assertIn(words, ben.words)
        self.assertNotIn("script", ben.tags)
        self.assertIn("Nothing was handed in", pages["=cmd|calc"].words)
        ann = pages["Ann Example_1001_assignsubmission_file"]
        self.assertEqual([link for _, link in ann.links].count(data_uri(path)), 2)
        for page in pages.values():
            self.assertEqual([link for _, link in page.links if not link.startswith(("data:", "#"))], [])

    def test_names_of_pages(self):
        self.assertEqual(file_name("ann (2)"), "ann (2)")
        names = {file_name(name) for name in ("../../etc", "..\\..\\etc", "a/b", "a:b", ".", "", "a\nb", "x" * 300, "=cmd|calc", "'=cmd|calc")}
        self.assertEqual(len(names), 10)
        for name in names:
            self.assertRegex(name, r"\A[\w ()-][\w .()-]{0,120}\Z")
        students = ["\u6f22" * 84, "\u6f22" * 85, "ann", "ann", "Ann", "\u202eann", "x" * 300, ".", ""]
        names = page_names([{"student": name, "id": ""} for name in students])
        self.assertEqual(len({name.casefold() for name in names}), len(students), names)
        self.assertEqual(names[2], "ann")
        for name in names:
            (self.folder / f".{name}.html.1234567.7f0000000000").touch()
