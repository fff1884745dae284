"""Tests the checks with variants (variants.py): check_variants.py NN_name. A failure is exit code 1 and a line. In GLSL,
functions without a body and functions that return zero are wrong answers to every exercise.

One process gives the verdicts on all shaders, which take the student's place one after the other. C++ may leave anything
behind: each answer has a process of its own, of one program with all of them (common/check/variants.h).
"""

import contextlib
import os
import re
import signal
import tempfile
from pathlib import Path

from check.check import TIMEOUT_S, wrong_picture
from check.variants import DRAWN, Variant, variants
from shots.rendering import Asked
from tree import BUILD, ROOT, Failure, exercises, run_on_chapter, shots

FUNCTION = re.compile(r"^(\w+)(\s+\w+\s*\([^)]*\)\s*)\{(?:[^\n]*\}$|.*?^\})", re.M | re.S)
BODIES = {"with empty functions": "", "with functions that return zero": " return ZERO; "}
SIZE = "320x240"  # of pictures: a right answer matches the reference at any size, and landscapes take seconds at full size


def checks_of(chapter: str) -> Asked:
    """The chapter's checks in one process, begun anew where it has died."""
    programs = [BUILD / "tests" / f"{kind}_{chapter}" for kind in ("variants", "check")]
    # Options that compile checks' shaders fast make pictures slow.
    return Asked([next((program for program in programs if program.exists()), programs[-1]), "--requests", "--strict"], TIMEOUT_S,
                 os.environ | {"GALLIVM_PERF": "nopt"})


def ask(checks: Asked, exercise: str, **answer: str) -> dict:
    """The verdict on an answer: overlay=FOLDER, of shaders, or variant=NAME, in C++, which has a process of its own."""
    if "variant" in answer:
        checks.close()
    found, _, code = checks.ask({"exercise": exercise, **answer})
    if "variant" in answer:
        checks.close()
    how = f"did not end within {TIMEOUT_S} s" if code == -signal.SIGKILL else f"was ended by signal {-code}" if code < 0 else f"ended with {code}"
    return found or {"first_failure": f"it {how}"}


def drawn_wrong(chapter: str, exercise: str, overlay: str) -> str:
    for shot in shots(chapter):
        if exercise in shot.get("exercises", []):
            try:
                why = wrong_picture(chapter, exercise, shot, overlay, SIZE)
            except Failure as failure:
                why = str(failure)
            if why:
                return why
    return ""


@contextlib.contextmanager
def overlaid(path: Path, text: str):
    """A folder to lay over the tree, in which the file has another text."""
    with tempfile.TemporaryDirectory(prefix="lightwalk.") as made:
        changed = Path(made) / path.relative_to(ROOT)
        changed.parent.mkdir(parents=True)
        changed.write_text(text, encoding="utf-8")
        yield made


def passes_without_an_answer(exercise: str, path: Path, checks: Asked) -> list[str]:
    """With which bodies of its functions an exercise in GLSL passes."""
    wrong = []
    for what, body in BODIES.items() if path.suffix == ".glsl" else ():
        text = FUNCTION.sub(lambda f: f"{f[1]}{f[2]}{{{'' if f[1] == 'void' else body.replace('ZERO', f'{f[1]}(0)')}}}",  # noqa: B023
                            path.read_text(encoding="utf-8"))
        with overlaid(path, text) as made:
            if ask(checks, exercise, overlay=made).get("ok") is True:
                wrong.append(f"{exercise}: it passes {what}")
    return wrong


def run_variant(chapter: str, variant: Variant, known: dict[str, Path], checks: Asked) -> str:
    exercise = f"{chapter[:2]}.{variant.exercise}"
    if exercise not in known:
        return f"{variant.where}: there is no exercise {exercise}"
    if variant.name.endswith(".cpp"):
        found = ask(checks, exercise, variant=variant.name.removesuffix(".cpp"))
    else:
        with overlaid(known[exercise], variant.text) as made:
            found = ask(checks, exercise, overlay=made)
            if found.get("ok") is True and variant.verdict == DRAWN and (why := drawn_wrong(chapter, exercise, made)):
                return f"{variant.where}: {variant.name} is right, but {why}"
    ok, said = found.get("ok") is True, found.get("first_failure") or ""
    if ok == bool(variant.words):
        return f"{variant.where}: {variant.name} is {'wrong' if variant.words else 'right'}, but the check " + \
            ("lets it pass" if ok else f"says: {said}")
    if not any(words in said for words in variant.words.split(" | ")):
        return f"{variant.where}: {variant.name}: the check says: {said}; not: {variant.words}"
    hint = found.get("hint") or ""
    return "" if variant.hint in hint else f"{variant.where}: {variant.name}: the check hints: {hint}; not: {variant.hint}"


def main(chapter: str) -> list[str]:
    known = exercises(chapter)
    found, mistakes = variants(chapter)
    verdicts = {(variant.exercise, bool(variant.words)) for variant in found}
    without = [exercise for exercise in known if not {(exercise[3:], True), (exercise[3:], False)} <= verdicts]
    with checks_of(chapter) as checks:
        wrong = [line for variant in found if (line := run_variant(chapter, variant, known, checks))]
        for exercise, path in known.items():
            wrong += passes_without_an_answer(exercise, path, checks)
    return mistakes + wrong + [f"{exercise}: tests/{chapter}/variants has no right and no wrong answer to it"
                               for exercise in without]


if __name__ == "__main__":
    run_on_chapter(main)
