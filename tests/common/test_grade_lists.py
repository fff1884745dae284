"""Class lists and rules with the damage that platforms, spreadsheets and hands do to them: what would give a student another's
grade, or none, is refused in a line; and grades that are 0, halves, or not yet known."""
# Builds: nothing

import json
import time
import unittest
from unittest import mock

from graded_class import REAL  # noqa: F401  (the way to the modules)
from grading import feedback, grade, marks
from grading.roster import Roster
from grading.rules import Rules
from grading.submission import Submission, read
from test_grade_book import WANTED, Files, one, result, rows_of
from tree import UsageError

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
}


class Lists(Files):
    def test_what_would_mix_up_students_is_one_line(self):
        for name, (text, said) in REFUSED.items():
            with self.subTest(name), self.assertRaisesRegex(UsageError, said) as caught:
                Roster(self.file(text), [])
            self.assertNotIn("\n", str(caught.exception))

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
        self.assertEqual(feedback.write_pages(self.folder / "f", book, grades, {first: {"02.phong": b"mine"}}, {}), 3)

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

    def test_a_regrade_goes_both_ways(self):
        file, data = self.folder / "marks.json", {"ann": {"02.phong": b"x"}}
        for ok, before in ((True, None), (False, "right"), (True, "wrong")):
            said = marks.keep(file, [one("ann", result("02.phong", ok))], data, {"02.phong"})
            self.assertEqual(said, [f"02.phong: ann: {before} before, {'right' if ok else 'wrong'} now"] if before else [])
        other = [one("ann", result("02.phong", False))]
        self.assertEqual(marks.keep(file, other, data, {"02.lambert"}), [])
        self.assertTrue(other[0]["results"][0]["ok"])

    def test_marks_of_no_answer_are_not_read(self):
        file = self.folder / "marks.json"
        file.write_text(json.dumps({"ann": {"02.phong": {"answer": 5, "result": result("02.phong")}}}))
        with self.assertRaisesRegex(UsageError, "cannot be read"):
            marks.keep(file, [], {}, set())


class Given(Files):
    def test_a_megabyte_of_keys_is_refused_in_a_second(self):
        keys = ", ".join(f'"{number // 2}": 1' for number in range(80_000))
        start_s = time.process_time()
        self.assertRaises(UsageError, Rules, self.file(f"{{{keys}}}"), WANTED)
        self.assertLess(time.process_time() - start_s, 5)  # 0.1 s; half a minute where it grows as the square

    def test_a_key_twice_and_a_key_of_two_lines(self):
        for text, said in (('{"points": 100, "points": 10}', "the key 'points' stands there twice"),
                           ('{"exercises": {"02.phong": {"weight": 1}, "02.phong": {"weight": 0}}}', "'02.phong' stands there twice"),
                           ('{"a\\nb": 1}', r"unknown key 'a\\u000ab'"), ('{"students": {"a\\nb": {"due": {"x": 1}}}}', "there is no 'x'"),
                           ('{"%s": 1}' % ("x" * 100000), "unknown key")):
            with self.subTest(text[:40]), self.assertRaisesRegex(UsageError, said) as caught:
                Rules(self.file(text), {"02.phong": "02_lambert_phong"})
            self.assertNotIn("\n", str(caught.exception))
            self.assertLess(len(str(caught.exception)), 600)


if __name__ == "__main__":
    unittest.main()
