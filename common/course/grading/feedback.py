"""A page for each student that needs no network: the right exercises, the faults of the others in words, and for pictures
the student's beside the expected one. It contains no reference."""

import re
from pathlib import Path

from grading.gradebook import Book, number, page_names
from grading.judge import picture_path
from pages.page import data_uri, page
from tree import write_atomically

# A check's message about numbers: common/check/probe.h.
NUMBERS = re.compile(r"(?P<input>.+?\)) gave (?P<theirs>.+), expected (?P<expected>.+)", re.S)
MOST_SHOWN = 20000  # characters of an answer


def write_pages(out: Path, book: Book, grades: list[dict], submitted: dict[str, dict[str, bytes]]) -> int:
    results = {one["student"]: {result["exercise"]: result for result in one["results"]} for one in grades}
    for row, name in zip(book.rows, page_names(book.rows)):
        chapters = [{"name": chapter, "points": number(row["chapters"][chapter], row["nothing"] or "missing"), "of": number(book.most(chapter), ""),
                     "exercises": [exercise_entry(exercise, mark, results.get(mark["student"], {}).get(exercise),
                                                  submitted.get(mark["student"], {}).get(exercise),
                                                  book.rules.due_of(mark["student"], exercise))
                                   for exercise, mark in row["marks"].items() if book.rules.wanted[exercise] == chapter]}
                    for chapter in book.chapters]
        at = book.rules.handed_in(row["student"], next((one.get("handed_in_s") for one in grades if one["student"] == row["student"]), None))
        write_atomically(out / f"{name}.html", page(
            "feedback.html", row=row, chapters=chapters, points=number(row["points"], row["nothing"]), of=number(row["of"], ""),
            handed_in=at.strftime("%Y-%m-%d %H:%M") if at else ""), 0o600)
    return len(book.rows)


def exercise_entry(exercise: str, mark: dict, result: dict | None, data: bytes | None, due) -> dict:
    found = NUMBERS.fullmatch(mark["said"] or "")
    pictures = []
    for key, title in (("picture_expected", "expected"), ("picture", "yours")):
        path = picture_path((result or {}).get(key) or "none")
        if path.exists():
            pictures.append({"title": title, "image": data_uri(path)})
    handed_in = data is not None and mark["word"] != "missing" and not mark["right"]
    return {"name": exercise, **mark, "points": number(mark["points"], ""), "of": number(mark["of"], ""),
            "numbers": found.groupdict() if found else None, "pictures": pictures if len(pictures) == 2 else [],
            "due": due.strftime("%Y-%m-%d %H:%M") if due else "",
            "code": data.decode(errors="replace")[:MOST_SHOWN] if handed_in else ""}
