"""The list of a class as a learning platform exports it: --roster FILE.csv. Its columns are kept as they are, so that the file
./course grade writes can be imported there.

A submission belongs to the row with the number in the submission's name, as these platforms write it,

    Moodle   Ann Example_123456_assignsubmission_file       "Participant 123456" in the column Identifier
    Canvas   exampleann_4711_987654_lightwalk.zip           4711 in the column ID (exampleann_LATE_4711_... where it was late)
    ILIAS    Example_Ann_annexample_1234                    annexample in the column Login

or to the row with the submission's name in a cell: a login, a number, an address, a full name. A platform writes an entry for each
file of a student, and for text: all with the row's number are that student's. A name that fits one row twice fits none.
"""

import csv
import datetime
import io
import re
import unicodedata
from pathlib import Path

from grading.submission import printable
from tree import UsageError

# Once: a name or a file of a student's may look like another's number.
MOODLE = re.compile(r"(?!.*_\d+_assignsubmission_.*_\d+_assignsubmission_)(?P<name>.+?)_(?P<id>\d+)_assignsubmission_")
CANVAS = re.compile(r"(?P<name>[^_]+)_(?:LATE_)?(?P<id>\d+)_\d+_")
ILIAS = re.compile(r"[^_]+_[^_]+_(?P<name>[^_]+)_\d+$")
# Columns that identify a person; never grades.
IDENTITY = ("identifier", "id", "id number", "idnumber", "sis user id", "sis login id", "login id", "username", "user name",
            "email", "email address", "student", "full name", "name", "first name", "last name", "surname", "section", "root account",
            "integration id", "group", "groups", "department", "institution", "login", "lastname", "firstname", "e-mail")
# One person's alone.
UNIQUE = ("identifier", "id", "id number", "idnumber", "sis user id", "sis login id", "login id", "username", "user name", "login")
NAMES = ("student", "full name", "name")
GRADES = ("grade", "feedback comments")
MOST_GRADES = ("maximum grade",)
HANDED_IN = ("last modified (submission)",)
FORMULA = ("=", "+", "-", "@")
ROUNDED = re.compile(r"\d+[.,]\d+(E\+?\d+)?", re.I)  # what a spreadsheet makes of a long number


class Roster:
    """Rows of a class. `of(student)` is a student's row, empty for one that is not in it."""

    def __init__(self, file: Path | None, students: list[str]):
        self.columns, self.rows = self.read(file) if file else ([], [])
        self.file = file
        self.numbered, self.named = {}, {}  # rows by (column, number), and by each name of a person
        for row in self.rows:
            self.note(row)
        claims = {}  # by row: who is it, and whether by the platform's number
        for student in students:
            row, by_number = self.find(student)
            if row is not None:
                claims.setdefault(id(row), []).append((student, row, by_number))
        self.found = {}
        for claimed in claims.values():
            sure = [claim for claim in claimed if claim[2]]
            self.found |= {student: row for student, row, _ in sure or claimed * (len(claimed) == 1)}
        taken = {id(row) for row in self.found.values()}
        self.absent = [row for row in self.rows if id(row) not in taken]
        self.strangers = [student for student in students if self.rows and student not in self.found]

    def read(self, file: Path) -> tuple[list[str], list[dict[str, str]]]:
        try:
            text = file.read_text(encoding="utf-8-sig")
        except OSError as error:
            raise UsageError(f"{file}: {error.strerror}") from None
        except UnicodeDecodeError:
            raise UsageError(f"{file}: is not UTF-8 text; export the list as CSV (UTF-8)") from None
        first = text.partition("\n")[0]
        separator = max(",;\t", key=first.count)
        lines, reader = [], csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True)
        try:
            for line in reader:
                lines.append((reader.line_num, line))
        except csv.Error as error:
            raise UsageError(f"{file}:{reader.line_num}: is no CSV: {error}") from None
        columns = [column.strip() for column in lines[0][1]] if lines else []
        lower = [column.lower() for column in columns]
        if not any(column in IDENTITY for column in lower):
            raise UsageError(f"{file}: the first line names no column of a class list, such as ID, Username or Email address")
        if twice := [column for column in lower if column in IDENTITY + GRADES + MOST_GRADES and lower.count(column) > 1]:
            raise UsageError(f"{file}: the first line names the column '{twice[0]}' twice")
        rows, seen = [], {}
        for number, line in lines[1:]:
            if len(line) > len(columns):
                raise UsageError(f"{file}:{number}: has {len(line)} cells, the first line {len(columns)}: a name with a "
                                 f"'{separator}' stands in quotes")
            row = dict(zip(columns, [*line, *[""] * len(columns)]))
            first = next(iter(row.values())).strip()
            # Canvas has rows of points and of postings, and one of its test student.
            if first == "Student, Test" or "points possible" in first.lower() or not any(row[c].strip() for c in self.identity(columns)):
                continue
            for column in self.identity(columns):
                if wrong := wrong_with(column.lower(), row[column]):
                    raise UsageError(f"{file}:{number}: {column}: '{printable(row[column], 40)}' {wrong}")
                key = (column, folded(row[column]))
                if column.lower() in UNIQUE and key[1] and seen.setdefault(key, number) != number:
                    raise UsageError(f"{file}:{number}: {column}: '{printable(row[column], 40)}' stands in line {seen[key]} too")
            rows.append(row)
            if self.most(row, 1) is None:
                raise UsageError(f"{file}:{number}: the maximum grade is no number: '{printable(self.most_text(row), 40)}'")
        return columns, rows

    @staticmethod
    def most_text(row: dict[str, str]) -> str:
        return next((cell.strip() for column, cell in row.items() if column.lower() in MOST_GRADES), "")

    @classmethod
    def most(cls, row: dict[str, str], otherwise: float) -> float | None:
        """The points that its platform gives at most, with a point or a comma; None where it says something else."""
        text = cls.most_text(row)
        if not text:
            return otherwise
        return float(text.replace(",", ".")) if re.fullmatch(r"[0-9]{1,9}([.,][0-9]{1,9})?", text) else None

    @staticmethod
    def identity(columns: list[str]) -> list[str]:
        return [column for column in columns if column.lower() in IDENTITY]

    def note(self, row: dict[str, str]):
        columns = self.identity(self.columns)
        for column in columns:
            if number := re.fullmatch(r"\D*(\d+)", row[column].strip()):
                self.numbered.setdefault((column.lower(), number[1]), row)
        for name in {folded(row[column]) for column in columns} | {folded(self.name(row))}:
            self.named.setdefault(name, []).append(row)

    def find(self, student: str) -> tuple[dict[str, str] | None, bool]:
        """A row, and whether the platform's number or login in the submission's name says so."""
        name, by_number = student, False
        for pattern, column in ((MOODLE, "identifier"), (CANVAS, "id")):
            if match := pattern.match(student):
                if row := self.numbered.get((column, match["id"])):
                    return row, True
                name = match["name"]
        if (match := ILIAS.match(student)) and "login" in map(str.lower, self.columns):
            name, by_number = match["name"], True
        fits = self.named.get(folded(name), [])
        return (fits[0], by_number) if len(fits) == 1 else (None, False)

    def name(self, row: dict[str, str]) -> str:
        lower = {column.lower(): cell for column, cell in row.items()}
        whole = next((lower[column] for column in NAMES if lower.get(column)), "")
        return printable(whole or " ".join(filter(None, (lower.get("first name") or lower.get("firstname"),
                                                           lower.get("last name") or lower.get("surname") or lower.get("lastname"))))
                         or next((cell for cell in row.values() if cell), "nobody"))

    def handed_in_s(self, student: str) -> float | None:
        """When the platform says that it was handed in, where the list has that column (Moodle's worksheet, in English)."""
        text = next((cell for column, cell in self.of(student).items() if column.lower() in HANDED_IN), "").strip()
        for form in ("%A, %d %B %Y, %I:%M %p", "%d %B %Y, %I:%M %p", "%Y-%m-%d %H:%M:%S", "%Y-%m-%d %H:%M"):
            try:
                return datetime.datetime.strptime(text, form).timestamp()
            except (ValueError, OverflowError):
                continue
        return None

    def of(self, student: str) -> dict[str, str]:
        return self.found.get(student, {})


def wrong_with(column: str, text: str) -> str:
    """Empty where nothing is, for a cell of a column that names a person."""
    if text.startswith(FORMULA) and column not in NAMES:
        return "would be read as a formula"
    if re.search(r"[\r\n\0]", text.strip()):
        return "is more than one line: a quote is not closed"
    if column in UNIQUE and ROUNDED.fullmatch(text.strip()):
        return "was rounded by a spreadsheet: export the list again"
    return ""


def folded(name: str) -> str:
    """A name as it is compared. A list may write O'Neill with one apostrophe and the folder with the other, and archives of
    some systems hold accents apart from their letters."""
    return unicodedata.normalize("NFKC", re.sub("[\u2018\u2019\u02bc\u00b4`]", "'", name)).strip().casefold()


def attempt(student: str) -> int:
    """The number that Canvas gives to a file, which grows from one to the next; 0 elsewhere."""
    match = re.match(r"[^_]+_(?:LATE_)?\d+_(\d+)_", student)
    return int(match[1]) if match else 0


def known_as(student: str) -> tuple[str, str]:
    """(name, number) of a submission named by a platform; elsewhere the submission's own name and nothing."""
    for pattern in (MOODLE, CANVAS):
        if match := pattern.match(student):
            return match["name"], match["id"]
    return student, ""
