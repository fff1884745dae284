"""Tests the checks with variants (variants.py): check_variants.py NN_name. A failure is exit code 1 and a line.

A shader replaces the student's through LIGHTWALK_OVERLAY; for each C++ variant the build makes a check program,
build/tests/variants/NN.EXERCISE.WHAT.
"""

import os
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from check.check import check_numbers, wrong_picture
from check.variants import DRAWN, Variant, variants
from tree import BUILD, ROOT, Failure, exercises, run_on_chapter, shots

SIZE = "320x240"  # of pictures: a right answer matches the reference at any size, and landscapes take seconds at full size
drawing = threading.Lock()  # the pictures of an exercise have one place


def drawn_wrong(chapter: str, exercise: str, overlay: str) -> str:
    """The fault in its pictures; empty if none. One at a time."""
    for shot in shots(chapter):
        if exercise in shot.get("exercises", []):
            try:
                # Options that compile checks' shaders fast make pictures slow.
                why = wrong_picture(chapter, exercise, shot, overlay, SIZE, GALLIVM_PERF="")
            except Failure as failure:
                why = str(failure)
            if why:
                return why
    return ""


def run_variant(chapter: str, variant: Variant, known: dict[str, Path]) -> str:
    """The fault in the check's verdict; empty if none."""
    exercise = f"{chapter[:2]}.{variant.exercise}"
    if exercise not in known:
        return f"{variant.where}: there is no exercise {exercise}"
    if variant.name.endswith(".cpp"):
        program = BUILD / "tests" / "variants" / f"{chapter[:2]}.{variant.name.removesuffix('.cpp')}"
        found = check_numbers(chapter, exercise, program=program)
    else:
        with tempfile.TemporaryDirectory(prefix="lightwalk.") as made:
            overlaid = Path(made) / known[exercise].relative_to(ROOT)
            overlaid.parent.mkdir(parents=True)
            overlaid.write_text(variant.text)
            found = check_numbers(chapter, exercise, options=("--strict",), LIGHTWALK_OVERLAY=made)
            if found.get("ok") is True and variant.verdict == DRAWN:
                with drawing:
                    why = drawn_wrong(chapter, exercise, made)
                if why:
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
    with ThreadPoolExecutor(min(os.cpu_count() or 1, 4)) as pool:
        wrong = [line for line in pool.map(lambda variant: run_variant(chapter, variant, known), found) if line]
    return mistakes + wrong + [f"{exercise}: tests/{chapter}/variants has no right and no wrong answer to it"
                               for exercise in without]


if __name__ == "__main__":
    run_on_chapter(main)
