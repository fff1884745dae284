"""The table of an exercise's specification: each sentence, and the wrong answers that break it (variants.py).

A list of variants, EXERCISE.changes, begins with a row for each sentence of the specification, in its order:

    > Surfaces that are equally far keep = ties_turned
    > `middles` holds the middle of each = -

The words before "=" begin the sentence. Behind it stand wrong variants, which break it and which the check refuses, and
right ones, which use a freedom that it grants. "-" marks a sentence that demands nothing: it defines a word,
gives a reason, or says how.
"""

import re
from dataclasses import dataclass
from pathlib import Path

from check.variants import variants
from tree import ROOT, exercises, relative

# An item of a list begins a sentence; behind a full stop so does a capital, a name in backquotes, a bracket or a call.
END = re.compile(r"(?:(?<=[.?])(?<!\b[A-Z]\.)|(?<=[.?]\)))\s+(?=[A-Z`(]|[a-z_]+\(\))")
ITEM = re.compile(r"\s*(?:- |\d\. )")
FORMULA = re.compile(r" {5}")


@dataclass(frozen=True)
class Row:
    line: int
    words: str
    variants: tuple[str, ...]


def paragraphs(text: str) -> list[str]:
    """The comments between an exercise's markers, each paragraph and item in one line; without formulas, which stand apart."""
    found, inside, fresh, formula = [], False, True, False
    for line in text.splitlines():
        said = line.removeprefix("//")
        if re.fullmatch(r"// \[/?\w+\]", line):
            inside, fresh, formula = "[/" not in line, True, False
        elif not inside or said == line or not said.strip():
            fresh, formula = True, False
        elif item := ITEM.match(said):
            found.append(said[item.end():].strip())
            fresh = False
        elif formula or (fresh and FORMULA.match(said)):
            formula = True
        elif fresh:
            found.append(said.strip())
            fresh = False
        else:
            found[-1] += " " + said.strip()
    return found


def sentences(text: str) -> list[str]:
    """Those of a starter's specification."""
    return [one for paragraph in paragraphs(text) for one in END.split(paragraph) if " " in one]


def rows(path: Path) -> list[Row]:
    """The table at the head of a list of variants."""
    found = []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if line.startswith("> "):
            words, _, names = line[2:].rpartition(" = ")
            found.append(Row(number, words, tuple(names.split())))
    return found


def untested(chapter: str) -> list[str]:
    """A line for each sentence without a row, and for each row that fits no sentence or names no variant."""
    known, wrong = {}, []
    for variant in variants(chapter)[0]:
        known.setdefault(variant.exercise, set()).add(variant.name.split(".")[1])
    for exercise, starter in exercises(chapter).items():
        path = ROOT / "tests" / chapter / "variants" / f"{exercise[3:]}.changes"
        table = rows(path) if path.exists() else []
        if not table:
            wrong.append(f"{relative(path)}:1: no table of the sentences of {exercise}")
            continue
        left = list(table)
        for sentence in sentences(starter.read_text()):
            if left and left[0].words and sentence.startswith(left[0].words):
                left.pop(0)
            else:
                wrong.append(f"{relative(path)}:{(left or table[-1:])[0].line}: no row here for: {sentence}")
        wrong += [f"{relative(path)}:{row.line}: no sentence of {exercise} begins with: {row.words}" for row in left]
        for row in table:
            wrong += [f"{relative(path)}:{row.line}: there is no variant {one}" for one in row.variants
                      if row.variants != ("-",) and one not in known.get(exercise[3:], ())]
    return wrong
