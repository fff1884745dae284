"""Writes grades as other systems import them: gradebook.moodle.csv, gradebook.canvas.csv, gradebook.csv, gradebook.json, and for
each student a page of feedback: feedback/NAME.html.

    moodle   the columns of the class list (or of the grading worksheet), points per chapter and in all, feedback as text
    canvas   Student, ID, SIS User ID, SIS Login ID, Section, a column for each chapter; a second line with the points possible
    csv      a column for each exercise with its points, or a word instead: late, missing, look at
    json     the same, with the words of each failure

In Moodle's and Canvas's numeric columns, a chapter without a submission is "-" or empty: no grade, where a 0 would be one.
So is a chapter with an answer that was not judged, or that has to be looked at. A name that a spreadsheet would take for a formula gets an apostrophe; an identifier never changes.
"""

import csv
import hashlib
import io
import json
import re
from pathlib import Path

from grading.roster import IDENTITY, Roster, attempt, known_as
from grading.rules import Rules
from grading.submission import cell, printable
from tree import chapter_title, write_atomically

MOST_NAME_BYTES = 120  # of a page's file: file systems have 255
FORMATS = ("moodle", "canvas", "csv", "json")
UNKNOWN = ("not judged", "look at")  # words of marks that are still to come
CANVAS_COLUMNS = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")


class Book:
    """A class with its marks. `rows`: a student's, in the order of the grades, then students without a submission."""

    def __init__(self, grades: list[dict], rules: Rules, roster: Roster):
        self.rules, self.roster = rules, roster
        self.chapters = list(dict.fromkeys(rules.wanted.values()))
        people = {}  # all that one person handed in, where a list says so
        for one in grades:
            people.setdefault(id(roster.of(one["student"])) if roster.of(one["student"]) else one["student"], []).append(one)
        self.rows = [self.row(entries, roster.of(entries[0]["student"])) for entries in people.values()]
        for row in roster.absent:
            name = roster.name(row)
            nothing = {"student": name, "error": "handed in nothing", "results": [], "alike": []}
            self.rows.append(self.row([nothing], row))

    def row(self, entries: list[dict], identity: dict[str, str]) -> dict:
        """Of several entries the latest that has an exercise counts for it."""
        entries = sorted(entries, key=lambda one: (attempt(one["student"]), one.get("handed_in_s") or 0))
        one, results, marks = entries[-1], {}, {}
        for entry in entries:
            for result in entry["results"]:
                if result["state"] not in ("missing", "unchanged") or result["exercise"] not in results:
                    results[result["exercise"]] = (entry, result)
        for exercise in self.rules.wanted:
            entry, result = results.get(exercise) or (one, {"exercise": exercise, "state": "missing", "ok": False,
                                                            "first_failure": None, "hint": None})
            word, points = self.rules.mark(entry, result)
            marks[exercise] = {"word": word, "student": entry["student"], "points": points, "of": self.rules.points[exercise],
                               "said": result["first_failure"] if word in ("wrong", "late", "look at", "not judged", "over budget") else None,
                               "hint": result["hint"] if word in ("wrong", "late") and not result["ok"] else None,
                               "right": bool(result["ok"])}
        name, number = known_as(one["student"])
        return {"student": one["student"], "name": self.roster.name(identity) if identity else name,
                "id": next((identity[c] for c in identity if c.lower() in ("id", "identifier", "id number", "idnumber", "username")
                            and identity[c]), number),
                "identity": identity, "error": error_of(entries), "marks": marks, "nothing": nothing_of(marks.values()),
                "points": self.total(marks.values()), "of": round(self.rules.most, 4), "chapters": {
                    chapter: self.total(marks[e] for e, of in self.rules.wanted.items() if of == chapter)
                    for chapter in self.chapters}}

    @staticmethod
    def total(marks) -> float | None:
        """None where nothing was handed in, and where a mark is still to come."""
        marks = list(marks)
        if nothing_of(marks):
            return None
        return round(sum(mark["points"] or 0 for mark in marks), 6)

    def most(self, chapter: str) -> float:
        return sum(self.rules.points[e] for e, of in self.rules.wanted.items() if of == chapter)

    def title(self, chapter: str) -> str:
        """Of a chapter's column: the platform's own where the class list has one that begins so, with its number."""
        title = f"Lightwalk {chapter_title(chapter)}"
        return next((column for column in self.roster.columns if column.startswith(f"Lightwalk {chapter[:2]}")), title)


def error_of(entries: list[dict]) -> str | None:
    errors = [one["error"] for one in entries]
    return "; ".join(dict.fromkeys(errors)) if all(errors) else None


def nothing_of(marks) -> str:
    """The word that stands instead of points; empty where there are some."""
    words = {mark["word"] for mark in marks}
    return next((word for word in UNKNOWN if word in words), "missing" if words <= {"missing"} else "")


def number(value: float | None, nothing: str) -> str:
    return nothing if value is None else f"{value:.2f}".rstrip("0").rstrip(".")


def words_of(row: dict) -> str:
    """A student's feedback as text: a line for each exercise that was handed in, or was not."""
    lines = []
    if row["error"]:
        lines.append(f"Your submission: {row['error']}.")
    for exercise, mark in row["marks"].items():
        line = f"{exercise}: {mark['word']}"
        if mark["points"] is not None:
            line += f", {number(mark['points'], '')} of {number(mark['of'], '')}"
        if mark["said"]:
            line += f". {mark['said']}"
        if mark["hint"]:
            line += f" (hint: {mark['hint']})"
        lines.append(line)
    return "\n".join(lines)


def write_books(out: Path, book: Book, formats: list[str]) -> list[str]:
    makers = {"moodle": moodle, "canvas": canvas, "csv": plain_csv, "json": as_json}
    names = []
    for kind in dict.fromkeys(formats):
        names.append(f"gradebook.{kind}.csv" if kind in ("moodle", "canvas") else f"gradebook.{kind}")
        write_atomically(out / names[-1], makers[kind](book), 0o600)
    return names


def as_csv(rows: list[list[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, quoting=csv.QUOTE_ALL, lineterminator="\r\n").writerows(rows)
    return text.getvalue()


def moodle(book: Book) -> str:
    """A grading worksheet, where the list is one: Moodle reads Grade and Feedback comments. Else any list with an identifier,
    for the gradebook's own import."""
    worksheet = {"Identifier", "Grade", "Feedback comments"} <= set(book.roster.columns)
    if worksheet:
        rows = [book.roster.columns]
        for row in book.rows:
            most = Roster.most(row["identity"], row["of"])
            points = None if row["points"] is None else round(row["points"] * most / row["of"], 2) if row["of"] else 0.0
            # The other columns are the students' words as well: a text handed in online, a name.
            safe = {column: text if text.strip() == "-" else cell(text) for column, text in row["identity"].items()}
            filled = safe | {"Grade": number(points, ""), "Feedback comments": no_formula(words_of(row)).replace("\n", "<br>")}
            if row["identity"]:  # Moodle knows its own numbers alone
                rows.append([filled.get(column, "") for column in book.roster.columns])
        return as_csv(rows)
    columns = Roster.identity(book.roster.columns) or ["ID number", "Full name"]
    rows = [[*columns, *[book.title(chapter) for chapter in book.chapters], "Lightwalk total", "Feedback"]]
    for row in book.rows:
        identity = row["identity"] or {"ID number": row["id"], "Full name": cell(row["name"])}
        rows.append([*[guarded(column, identity.get(column, "")) for column in columns],
                     *[number(row["chapters"][chapter], "-") for chapter in book.chapters], number(row["points"], "-"),
                     no_formula(words_of(row))])
    return as_csv(rows)


def no_formula(text: str) -> str:
    """Prose that no spreadsheet takes for a formula, wherever it ends a cell; a vector may hold negative numbers."""
    return re.sub(r"((?:^|[;|\t\n])\s*)(?=[=+@\uff1d\uff0b\uff20]|-(?![\d.]))", r"\1'", text)


def guarded(column: str, text: str) -> str:
    """Identifiers stay exact; names are escaped against formulas."""
    return cell(text) if column.lower() in IDENTITY and "name" in column.lower() or column.lower() == "student" else text


def canvas(book: Book) -> str:
    rows = [[*CANVAS_COLUMNS, *[book.title(chapter) for chapter in book.chapters]],
            ["    Points Possible", *[""] * (len(CANVAS_COLUMNS) - 1), *[number(book.most(chapter), "") for chapter in book.chapters]]]
    for row in book.rows:
        known = {column: text for column, text in row["identity"].items() if column in CANVAS_COLUMNS}
        identity = known or {"Student": row["name"], "ID": row["id"]}
        rows.append([*[guarded(column, identity.get(column, "")) for column in CANVAS_COLUMNS],
                     *[number(row["chapters"][chapter], "") for chapter in book.chapters]])
    return as_csv(rows)


def plain_csv(book: Book) -> str:
    rows = [["student", "name", "id", "points", "of", *book.rules.wanted, "error"]]
    for row in book.rows:
        marks = [mark["word"] if mark["points"] is None else number(mark["points"], "") for mark in row["marks"].values()]
        rows.append([cell(row["student"]), cell(row["name"]), row["id"], number(row["points"], row["nothing"]), number(row["of"], ""),
                     *marks, cell(row["error"] or "")])
    return as_csv(rows)


def as_json(book: Book) -> str:
    kept = ("student", "name", "id", "error", "points", "of", "chapters", "marks")
    return json.dumps([{key: row[key] for key in kept} for row in book.rows], indent=1, ensure_ascii=True) + "\n"


def file_name(student: str) -> str:
    """A student's page: no name leads out of its folder, and no two are one."""
    safe = re.sub(r"[^\w .()-]", "_", printable(student, 100)).strip(". ") or "nobody"
    safe = safe.encode()[:MOST_NAME_BYTES].decode(errors="ignore")
    return safe if safe == student else f"{safe}.{hash_of(student)}"


def page_names(rows: list[dict]) -> list[str]:
    """A page for each row, even for equal names: the first of a name keeps it, ignoring case."""
    names, taken = [], set()
    for number, row in enumerate(rows):
        name = file_name(row["student"])
        if name.casefold() in taken:
            name += f".{hash_of(json.dumps([number, row['student'], row['id']]))}"
        taken.add(name.casefold())
        names.append(name)
    return names


def hash_of(text: str) -> str:
    return hashlib.sha256(text.encode(errors="surrogatepass")).hexdigest()[:8]
