"""Tests the checks with answers whose verdict is known: check_variants.py NN_name. A failure is exit code 1 and a line.

tests/NN_name/variants/EXERCISE.WHAT.glsl or .cpp is an exercise as somebody could hand it in. Its first line says what the
check must make of it: "// right", or "// wrong: " and words that the first failure must hold. A shader stands in for the
student's by LIGHTWALK_OVERLAY; of each C++ one the build makes a check program, build/tests/variants/NN.EXERCISE.WHAT.
A shader with "// right, in its pictures too" is drawn as well, in every shot that shows its exercise.
"""

import os
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from check import check_numbers, wrong_picture
from tree import BUILD, ROOT, Failure, exercises, run_on_chapter, shots

DRAWN = "right, in its pictures too"
drawing = threading.Lock()  # the pictures of an exercise have one place


def verdict_of(path: Path) -> tuple[bool, str]:
    """Whether it is right, and what must be said where it is not."""
    kind, _, words = path.read_text().partition("\n")[0].removeprefix("// ").partition(": ")
    if kind not in ("right", DRAWN, "wrong") or (kind == "wrong") != bool(words):
        raise ValueError(f"{path.name}: the first line is '// right' or '// wrong: WORDS'")
    return kind != "wrong", words


def drawn_wrong(chapter: str, exercise: str, overlay: str) -> str:
    """What is wrong with its pictures; empty where nothing is. One at a time."""
    for shot in shots(chapter):
        if exercise in shot.get("exercises", []):
            try:
                # What makes shaders of checks compile fast makes those of pictures slow.
                why = wrong_picture(chapter, exercise, shot, overlay, GALLIVM_PERF="")
            except Failure as failure:
                why = str(failure)
            if why:
                return why
    return ""


def run_variant(chapter: str, path: Path, known: dict[str, Path]) -> str:
    """What is wrong with the check's verdict on it; empty where nothing is."""
    exercise = f"{chapter[:2]}.{path.name.partition('.')[0]}"
    if exercise not in known:
        return f"{path.name}: there is no exercise {exercise}"
    is_right, words = verdict_of(path)
    if path.suffix == ".cpp":
        found = check_numbers(chapter, exercise, program=BUILD / "tests" / "variants" / f"{chapter[:2]}.{path.stem}")
    else:
        with tempfile.TemporaryDirectory(prefix="lightwalk.") as made:
            overlaid = Path(made) / known[exercise].relative_to(ROOT)
            overlaid.parent.mkdir(parents=True)
            overlaid.write_text(path.read_text())
            found = check_numbers(chapter, exercise, LIGHTWALK_OVERLAY=made, LIGHTWALK_PROBE_STRICT="1")
            if found.get("ok") is True and path.read_text().startswith(f"// {DRAWN}\n"):
                with drawing:
                    why = drawn_wrong(chapter, exercise, made)
                if why:
                    return f"{path.name} is right, but {why}"
    ok, said = found.get("ok") is True, found.get("first_failure") or ""
    if ok != is_right:
        return f"{path.name} is {'right' if is_right else 'wrong'}, but the check " + \
            ("lets it pass" if ok else f"says: {said}")
    return "" if words in said else f"{path.name}: the check says: {said}; not: {words}"


def main(chapter: str) -> list[str]:
    known = exercises(chapter)
    paths = sorted((ROOT / "tests" / chapter / "variants").glob("*.*"))
    without = [exercise for exercise in known
               if {verdict_of(path)[0] for path in paths if path.name.startswith(exercise[3:] + ".")} != {True, False}]
    with ThreadPoolExecutor(min(os.cpu_count() or 1, 4)) as pool:
        wrong = [line for line in pool.map(lambda path: run_variant(chapter, path, known), paths) if line]
    return wrong + [f"{exercise}: tests/{chapter}/variants has no right and no wrong answer to it" for exercise in without]


if __name__ == "__main__":
    run_on_chapter(main)
