"""Keeps verdicts on answers: marks.json beside the grades. Grading again with other checks, another driver or another
number for the random inputs gives the same answer the same mark, unless --regrade names its exercise.

    {"ann": {"02.phong": {"answer": the SHA-256 of the answer, "result": {...}}}}
"""

import hashlib
import json
import re
from pathlib import Path

from tree import UsageError, write_atomically

FINAL = ("judged", "undecided")  # states that are an answer's own; "unkept": it was killed, perhaps from outside


def keep(file: Path, grades: list[dict], submitted: dict[str, dict[str, bytes]], regraded: set[str]) -> list[str]:
    """Replaces new results by kept ones, keeps new answers' results, and reports changed marks of a regraded exercise.
    Raises UsageError for an unreadable file: a grade would be lost."""
    try:
        kept = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        before = {(student, exercise): (answer_of(entry), checked(dict(entry["result"]), exercise))
                  for student, entries in kept.items() for exercise, entry in entries.items()}
    except (OSError, ValueError, TypeError, AttributeError, KeyError, RecursionError) as error:
        raise UsageError(f"{file} cannot be read: {error!r}; it holds the marks that were given, so it is not replaced") from None
    changed = []
    for one in grades:
        student = one["student"]
        for i, result in enumerate(one["results"]):
            exercise, data = result["exercise"], submitted.get(student, {}).get(result["exercise"])
            if data is None or result["state"] not in FINAL or result.get("unkept"):
                continue
            answer = hashlib.sha256(data).hexdigest()
            old_answer, old = before.get((student, exercise), (None, None))
            if old_answer == answer and exercise not in regraded:
                one["results"][i] = old
            else:
                if old_answer == answer and verdict(old) != verdict(result):
                    changed.append(f"{exercise}: {student}: {verdict(old)} before, {verdict(result)} now")
                kept.setdefault(student, {})[exercise] = {"answer": answer, "result": result}
    write_atomically(file, json.dumps(kept, indent=1) + "\n", 0o600)
    return changed


def answer_of(entry: dict) -> str:
    """Its hash. Raises ValueError for anything else."""
    if not re.fullmatch("[0-9a-f]{64}", entry["answer"]):
        raise ValueError(f"{entry['answer']!r} is the hash of no answer")
    return entry["answer"]


def checked(result: dict, exercise: str) -> dict:
    """A result as the grader writes it. Raises ValueError for any other."""
    words = ("exercise", "chapter", "state")
    maybe = ("first_failure", "hint", "note", "picture", "picture_expected")
    right = (all(isinstance(result.get(key), str) for key in words) and isinstance(result.get("ok"), bool)
             and all(type(result.get(key)) is int for key in ("passed", "failed")) and result["exercise"] == exercise
             and all(result.get(key) is None or isinstance(result[key], str) for key in maybe))
    if not right:
        raise ValueError(f"what it says of {exercise!r} is no result")
    return result


def verdict(result: dict) -> str:
    return "look at" if result["state"] == "undecided" else "right" if result["ok"] else "wrong"
