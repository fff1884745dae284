"""An instructor's rules for marks: --rules FILE, a JSON file with optional keys.

    {"points": 100,                                    of the whole course; without it one for each exercise
     "late": 0.5,                                      the value of a late answer; without it: nothing, and the cell says late
     "due": "2027-02-12 23:59",
     "chapters": {"02": {"weight": 2, "due": "2027-01-15 23:59"}},
     "exercises": {"02.phong": {"weight": 3}},
     "students": {"ann": {"due": {"02": "2027-01-22 23:59", "02.phong": "..."}, "handed_in": "2027-01-16 10:00"}}}

An exercise is worth its weight times its chapter's. A deadline is the most specific one that is written: the student's for
the exercise, for the chapter, for all ("all"), the exercise's, the chapter's, the course's. Times without an offset are this machine's.
A submission's time is "handed_in"; without it from the platform's time (Moodle's worksheet as --roster, column "Last
modified (submission)"); without that from the time of the archive, or of the newest exercise in the folder, which a student can set.
"""

import datetime
import json
from collections import Counter
from pathlib import Path

from grading.submission import printable
from tree import UsageError

KEYS = {"": {"points", "late", "due", "chapters", "exercises", "students"}, "chapters": {"weight", "due"},
        "exercises": {"weight", "due"}, "students": {"due", "handed_in"}}


class Rules:
    """`wanted`: chapter by exercise. Raises UsageError with the file and the key."""

    def __init__(self, file: Path | None, wanted: dict[str, str]):
        self.file, self.wanted = file, wanted
        self.given = self.read(file) if file else {}
        for key in ("chapters", "exercises", "students"):
            for name, value in self.part(self.given, key).items():
                self.known(value, key, name)
        known = {"all", *wanted, *[chapter[:2] for chapter in wanted.values()]}
        for key, names in (("chapters", {chapter[:2] for chapter in wanted.values()}), ("exercises", set(wanted))):
            for name in self.part(self.given, key):
                if name not in names:
                    self.wrong(f"{key}: there is no '{name}' among what is graded; there are {', '.join(sorted(names)[:8])}")
        self.late = self.number(self.given, "late", None, 0, 1)
        self.due = {"all": self.time(self.given, "due")}
        for key in ("chapters", "exercises"):
            self.due |= {name: self.time(value, "due", name) for name, value in self.part(self.given, key).items()}
        self.students = {}
        for student, value in self.part(self.given, "students").items():
            due = self.part(value, "due")
            if strange := sorted(set(due) - known):
                self.wrong(f"students: {student}: due: there is no '{strange[0]}'")
            self.students[student] = ({name: self.time(due, name, student) for name in due}, self.time(value, "handed_in", student))
        shares = {exercise: self.weight("exercises", exercise) * self.weight("chapters", chapter[:2])
                  for exercise, chapter in wanted.items()}
        most = self.number(self.given, "points", None, 0, 1e6)
        all_shares = sum(shares.values())
        if not all_shares:
            self.wrong("all weights are 0")
        self.points = {exercise: share if most is None else share * most / all_shares for exercise, share in shares.items()}
        self.most = all_shares if most is None else most

    def read(self, file: Path) -> dict:
        try:
            given = json.loads(file.read_text(encoding="utf-8-sig"), object_pairs_hook=self.no_key_twice)
        except OSError as error:
            raise UsageError(f"{file}: {error.strerror}") from None
        except (ValueError, RecursionError) as error:
            raise UsageError(f"{file} is not JSON: {error}") from None
        self.known(given, "", "")
        return given

    def no_key_twice(self, pairs: list[tuple]) -> dict:
        if twice := [name for name, count in Counter(name for name, _ in pairs).items() if count > 1]:
            self.wrong(f"the key '{twice[0]}' stands there twice")
        return dict(pairs)

    def wrong(self, what: str):
        raise UsageError(f"{self.file}: {printable(what, 400)}")

    def known(self, value, key: str, name: str):
        if not isinstance(value, dict):
            self.wrong(f"{key or 'the file'}{f': {name}' if name else ''} is not an object in braces")
        if strange := sorted(set(value) - KEYS[key]):
            self.wrong(f"{f'{key}: {name}: ' if key else ''}unknown key '{strange[0]}'; there are {', '.join(sorted(KEYS[key]))}")

    def part(self, value: dict, key: str) -> dict:
        found = value.get(key, {})
        if not isinstance(found, dict):
            self.wrong(f"{key} is not an object in braces")
        return found

    def number(self, value: dict, key: str, default, least: float, most: float, where: str = ""):
        found = value.get(key, default)
        if key in value and (isinstance(found, bool) or not isinstance(found, (int, float)) or not least <= found <= most):
            self.wrong(f"{where}{key} is {found!r}, expected a number from {least:g} to {most:g}")
        return found

    def weight(self, key: str, name: str) -> float:
        return self.number(self.part(self.given, key).get(name, {}), "weight", 1, 0, 1000, f"{key}: {name}: ")

    def time(self, value: dict, key: str, where: str = "") -> datetime.datetime | None:
        if key not in value:
            return None
        try:
            return datetime.datetime.fromisoformat(value[key]).astimezone()
        except (TypeError, ValueError, OverflowError):
            self.wrong(f"{where + ': ' if where else ''}{key} is {value[key]!r}, expected a time such as \"2027-01-15 23:59\"")

    def due_of(self, student: str, exercise: str) -> datetime.datetime | None:
        own = self.students.get(student, ({}, None))[0]
        chapter = self.wanted[exercise][:2]
        places = [(own, exercise), (own, chapter), (own, "all"), (self.due, exercise), (self.due, chapter), (self.due, "all")]
        return next((due[name] for due, name in places if due.get(name)), None)

    def handed_in(self, student: str, seconds: float | None) -> datetime.datetime | None:
        """`seconds`: the time of the files."""
        stated = self.students.get(student, ({}, None))[1]
        if stated or seconds is None:
            return stated
        try:
            return datetime.datetime.fromtimestamp(seconds).astimezone()
        except (ValueError, OverflowError, OSError):  # no calendar has it
            return None

    def mark(self, one: dict, result: dict) -> tuple[str, float | None]:
        """(word, points) of a result: right, wrong, late, missing, look at; None where a word stands instead of points."""
        worth, state = self.points[result["exercise"]], result["state"]
        if state in ("missing", "unchanged"):
            return "missing", None
        if state == "undecided":
            return "look at", None
        if state == "failed":
            return "not judged", None
        if state == "over budget":
            return "over budget", 0.0
        due, at = self.due_of(one["student"], result["exercise"]), self.handed_in(one["student"], one.get("handed_in_s"))
        if due and at and at > due:
            return "late", None if self.late is None else worth * self.late * result["ok"]
        return ("right", worth) if result["ok"] else ("wrong", 0.0)
