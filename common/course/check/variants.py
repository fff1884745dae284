"""Variants: right and wrong answers to each exercise, with the verdict that its check must reach (tests/NN_name/variants).

A variant is either a whole file, EXERCISE.VARIANT.glsl or EXERCISE.VARIANT.cpp, with its verdict in the first line:

    // right
    // right, in its pictures too     every shot that shows the exercise is drawn with it as well
    // wrong: WORDS                   the check's first failure must contain these words; with WORDS | OTHERS either,
                                      where drivers differ on undefined operations
    // wrong: WORDS; hint: WORDS      and so must its hint

or an entry in EXERCISE.changes, which lists the few lines in which it differs from the solution:

    == half: wrong: expected 0.5
    - return the line of the solution;
    + return half of it;

The "-" lines are consecutive lines of the solution and must occur there exactly once; the "+" lines replace them. A lone "+"
deletes them. To insert a line, repeat the line beside it after "-" and "+". Comments, lines without code and indentation are
ignored when lines are compared. A line that begins with "#" is a comment. Variants in a list thus follow the solution, and
one that no longer fits is an error with its file and line.

Each exercise has a wrong answer to every sentence of its specification that can fail by itself, and a right one that is written
otherwise. No sentence has a second wrong answer.

The build runs variants.py NN_name FILE: it writes all C++ variants of a chapter to FILE, each in a namespace of its own
(common/check/variants.h).
"""

import re
import sys
from dataclasses import dataclass
from pathlib import Path

from tree import ROOT, Failure, exercises, relative, warn, write_atomically

DRAWN = "right, in its pictures too"


@dataclass(frozen=True)
class Variant:
    name: str  # EXERCISE.VARIANT.glsl or .cpp
    where: str  # FILE:LINE of its verdict
    verdict: str
    text: str

    def __post_init__(self):
        if self.verdict not in ("right", DRAWN) and not re.match(r"wrong: \S", self.verdict):
            raise Failure(f"{self.where}: '{self.verdict}' is no verdict; write right, {DRAWN}, or wrong: WORDS")

    @property
    def exercise(self) -> str:
        return self.name.partition(".")[0]

    @property
    def words(self) -> str:
        return self.verdict.partition("wrong: ")[2].partition("; hint: ")[0]

    @property
    def hint(self) -> str:
        return self.verdict.partition("; hint: ")[2]


def variants(chapter: str) -> tuple[list[Variant], list[str]]:
    """The chapter's, sorted by name, and a line for each that cannot be read."""
    found, mistakes = {}, []
    for path in sorted((ROOT / "tests" / chapter / "variants").glob("[a-z]*.*[a-z]")):  # no editor's lock, no backup
        try:
            read = listed(chapter, path, mistakes) if path.suffix == ".changes" else [whole(path)]
        except Failure as failure:
            mistakes.append(str(failure))
            continue
        for variant in read:
            if variant.name in found:
                mistakes.append(f"{variant.where}: {variant.name} is at {found[variant.name].where} too")
            found[variant.name] = variant
    return [found[name] for name in sorted(found)], mistakes


def whole(path: Path) -> Variant:
    text = path.read_text(encoding="utf-8")
    return Variant(path.name, f"{relative(path)}:1", text.partition("\n")[0].removeprefix("// "), text)


def listed(chapter: str, path: Path, mistakes: list[str]) -> list[Variant]:
    """The variants of one list; each that does not fit adds a line to `mistakes`."""
    exercise = exercises(chapter).get(f"{chapter[:2]}.{path.stem}")
    if not exercise:
        raise Failure(f"{relative(path)}:1: there is no exercise {chapter[:2]}.{path.stem}")
    solution = handed_in((exercise.parents[1] / "solution" / exercise.name).read_text(encoding="utf-8"))
    found = []
    for number, what, verdict, changes in entries(path.read_text(encoding="utf-8"), relative(path)):
        try:
            found.append(Variant(f"{path.stem}.{what}{exercise.suffix}", f"{relative(path)}:{number}", verdict,
                                 changed(solution, changes, relative(path))))
        except Failure as failure:
            mistakes.append(str(failure))
    return found


def handed_in(solution: str) -> str:
    """A solution as a student would write it."""
    return solution.replace("namespace lightwalk::solution", "namespace lightwalk::exercise")


Change = tuple[int, list[str], list[str]]  # the line of the list where it begins, old lines, new ones


def entries(text: str, name: str) -> list[tuple[int, str, str, list[Change]]]:
    """A list's answers: line, name, verdict and changes of each. Raises Failure."""
    found, before = [], "=="
    for number, line in enumerate(text.splitlines(), 1):
        if not line or line[0] == "#":
            continue
        sign, _, rest = line.partition(" ")
        if header := re.fullmatch(r"== (\w+): (.+)", line):
            found.append((number, header[1], header[2], []))
        elif sign == "-" and found:
            if before != "-":
                found[-1][3].append((number, [], []))
            found[-1][3][-1][1].append(rest)
        elif sign == "+" and before in ("-", "+"):
            found[-1][3][-1][2].append(rest)
        else:
            raise Failure(f"{name}:{number}: '{line}' has no meaning here; write == WHAT: VERDICT, then - OLD and + NEW")
        before = sign
    for *_, changes in found:
        for number, old, new in changes:
            if not new:
                raise Failure(f"{name}:{number}: nothing replaces '{old[0]}'; write + NEW, or a lone + to delete it")
    return found


def changed(solution: str, changes: list[Change], name: str) -> str:
    """The solution with these changes. Raises Failure where old lines are not in it, or in two places."""
    lines = solution.splitlines()
    code = [(place, bare(line)) for place, line in enumerate(lines) if bare(line)]
    taken = set()
    for number, old, new in changes:
        wanted = [bare(line) for line in old]
        found = [i for i in range(len(code)) if [text for _, text in code[i:i + len(wanted)]] == wanted]
        if len(found) != 1:
            count = f"{len(found)} times; name a line beside it too" if found else "nowhere"
            lines_said = f"'{old[0].strip()}'" + " and what follows" * (len(old) > 1)
            raise Failure(f"{name}:{number}: {lines_said} is in the solution {count}")
        first, last = code[found[0]][0], code[found[0] + len(wanted) - 1][0]
        if taken & set(range(first, last + 1)):
            raise Failure(f"{name}:{number}: '{old[0].strip()}' is changed already")
        taken |= set(range(first, last + 1))
        indent = " " * (indentation(lines[first]) - indentation(old[0]))
        lines[first:last + 1] = ["\n".join(indent + line for line in new)] + [""] * (last - first)
    return "\n".join(lines) + "\n"


def indentation(line: str) -> int:
    return len(line) - len(line.lstrip())


def bare(line: str) -> str:
    """Without comment and indentation."""
    return line.partition("//")[0].strip()


def program(chapter: str) -> str:
    found, mistakes = variants(chapter)
    for mistake in mistakes:
        warn(mistake)  # its test fails for it; meanwhile all else is built
    header = f"{chapter}/exercises.h"
    declared = re.findall(r'EXERCISE\("\d\d\.(\w+)",[^,]+,\s*(\w+),', (ROOT / "chapters" / header).read_text(encoding="utf-8"))
    text = f'#include "common/check/variants.h"\n\n#include "{header}"\n'
    for variant in (variant for variant in found if variant.name.endswith(".cpp")):
        name = variant.name.removesuffix(".cpp")
        space = f"lightwalk::exercise::answer_{name.replace('.', '_')}"
        chosen = "".join(f" Chosen_{function}::function = {space}::{function};" for exercise, function in declared
                         if exercise == variant.exercise)
        text += f'\n#line 1 "{variant.where}: {name}"\n' + variant.text.replace("namespace lightwalk::exercise", f"namespace {space}")
        text += f'namespace lightwalk {{\nstatic const RegisterVariant registered_{name.replace(".", "_")}("{name}", [] {{{chosen} }});\n}}\n'
    return text


if __name__ == "__main__":
    write_atomically(Path(sys.argv[2]), program(sys.argv[1]))
