"""Points out submissions that are alike: a hint to look, and no verdict.

Short answers are alike because there is one way to write them. So only additions to the starter count, as words of code
without comments and spaces, in runs of five; a pair is named if the additions of two students are equal or nearly so,
and if one exercise of some length is identical, comments included.
"""

import functools
import math
import re
from collections import Counter
from itertools import combinations

# A comment or a text that does not end is one all the same: to find that out at each of its letters would take minutes.
TOKEN = re.compile(rb"//[^\n]*|/\*.*?(?:\*/|\Z)|\"(?:[^\"\\\n]|\\[^\n])*\"?|[A-Za-z_]\w*|\d[\w.]*|[^\s\w]", re.S)
RUN = 5
NEARLY = 0.9  # shared runs over all runs of either
LEAST_RUNS = 150  # over all exercises: about 200 words of code
LEAST_BYTES = 200  # of an exercise that is the same with its comments, beyond the starter


def alike(submitted: dict[str, dict[str, bytes]], starters: dict[str, bytes]) -> list[tuple[str, str, str]]:
    runs, texts, numbers, seen = {}, {}, {}, {}
    for student, answers in submitted.items():
        runs[student] = set()
        for exercise, data in answers.items():
            starter = starters[exercise]
            if (exercise, data) not in seen:  # equal files are taken apart once
                seen[exercise, data] = [numbers.setdefault((exercise, run), len(numbers))
                                        for run in runs_of(data) - runs_of(starter)]
            runs[student].update(seen[exercise, data])
            texts.setdefault((exercise, b"\n".join(added(data, starter))), []).append(student)
    same = {}
    for (exercise, text), students in texts.items():
        # Where most of a class has the same letters, the letters were given to them.
        if len(text) >= LEAST_BYTES and len(students) <= max(2, len(submitted) // 4):
            for pair in combinations(students, 2):
                same.setdefault(pair, []).append(exercise)
    order = {student: i for i, student in enumerate(submitted)}
    found = []
    for pair in sorted(set(same) | nearly_equal(runs, order), key=lambda pair: (order[pair[0]], order[pair[1]])):
        a, b = (runs[student] for student in pair)
        exercises = same.get(pair, [])
        if min(len(a), len(b)) >= LEAST_RUNS and len(a & b) >= NEARLY * len(a | b):
            what = "all that they added is " + ("the same" if a == b else f"the same to {100 * len(a & b) // len(a | b)} %")
            found.append((*pair, what))
        elif exercises:
            found.append((*pair, f"the same letter by letter: {', '.join(sorted(exercises))}"))
    return found


def nearly_equal(runs: dict[str, set[int]], order: dict[str, int]) -> set[tuple[str, str]]:
    """The pairs that may have NEARLY of their runs in common, and all that do: a class of 2,000 has two million pairs.
    Two such sets share one of the rarest runs of each, of those 1 - NEARLY of its size (the prefix filter of Chaudhuri,
    Ganti and Kaushik, A Primitive Operator for Similarity Joins, ICDE 2006)."""
    often = Counter(run for of_one in runs.values() for run in of_one)
    having, found = {}, set()
    for student in order:
        mine = sorted(runs[student], key=lambda run: (often[run], run))
        if len(mine) < LEAST_RUNS:
            continue
        for run in mine[:len(mine) - math.ceil(NEARLY * len(mine)) + 1]:
            others = having.setdefault(run, [])
            found.update((other, student) for other in others
                         if NEARLY * max(len(mine), len(runs[other])) <= min(len(mine), len(runs[other])))
            others.append(student)
    return found


@functools.lru_cache(512)
def runs_of(data: bytes) -> set[bytes]:
    words = [word for word in TOKEN.findall(data) if not word.startswith((b"//", b"/*"))]
    return {b" ".join(words[i:i + RUN]) for i in range(max(len(words) - RUN + 1, 0))}


def added(data: bytes, starter: bytes) -> list[bytes]:
    known = {line.strip() for line in starter.splitlines()}
    return [line.strip() for line in data.splitlines() if line.strip() and line.strip() not in known]
