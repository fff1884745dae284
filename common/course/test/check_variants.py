"""Tests the checks with variants (variants.py): check_variants.py NN_name. A failure is exit code 1 and a line.

One process gives the verdicts on all shaders, which take the student's place one after the other. C++ may leave anything
behind: each answer has a process of its own, of one program with all of them (common/check/variants.h).
"""

import json
import os
import select
import subprocess
import tempfile
from pathlib import Path

from check.check import TIMEOUT_S, wrong_picture
from check.variants import DRAWN, Variant, variants
from tree import BUILD, ROOT, Failure, exercises, relative, run_on_chapter, shots

SIZE = "320x240"  # of pictures: a right answer matches the reference at any size, and landscapes take seconds at full size


class Checks:
    """The chapter's checks in one process, begun anew where it has died."""

    def __init__(self, chapter: str):
        programs = [BUILD / "tests" / f"{kind}_{chapter}" for kind in ("variants", "check")]
        self.program = next((program for program in programs if program.exists()), programs[-1])
        self.process = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def start(self):
        # Options that compile checks' shaders fast make pictures slow.
        environment = os.environ | {"GALLIVM_PERF": "nopt"}
        try:
            self.process = subprocess.Popen([self.program, "--requests", "--strict"], cwd=ROOT, env=environment, text=True, errors="replace",
                                            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        except OSError as error:
            raise Failure(f"{relative(self.program)}: {error.strerror}") from None

    def end(self) -> int:
        """The exit code of a process that has ended by itself."""
        if not self.process:
            return 0
        with self.process as process:
            process.kill()
        self.process = None
        return process.returncode

    def ask(self, exercise: str, **answer: str) -> dict:
        """The verdict on an answer: overlay=FOLDER, of shaders, or variant=NAME, in C++."""
        if "variant" in answer:
            self.end()
        if not self.process:
            self.start()
        try:
            self.process.stdin.write(json.dumps({"exercise": exercise, **answer}) + "\n")
            self.process.stdin.flush()
        except OSError:
            pass  # it has died: there is no line
        ready = select.select([self.process.stdout], [], [], TIMEOUT_S)[0]
        line = self.process.stdout.readline() if ready else ""
        if not line.startswith("{"):
            code = self.end() if ready else 0
            how = f"was ended by signal {-code}" if code < 0 else f"ended with {code}" if ready else f"did not end within {TIMEOUT_S} s"
            return {"first_failure": f"it {how}"}
        if "variant" in answer:
            self.end()
        return json.loads(line)


def drawn_wrong(chapter: str, exercise: str, overlay: str) -> str:
    """The fault in its pictures; empty if none."""
    for shot in shots(chapter):
        if exercise in shot.get("exercises", []):
            try:
                why = wrong_picture(chapter, exercise, shot, overlay, SIZE)
            except Failure as failure:
                why = str(failure)
            if why:
                return why
    return ""


def run_variant(chapter: str, variant: Variant, known: dict[str, Path], checks: Checks) -> str:
    """The fault in the check's verdict; empty if none."""
    exercise = f"{chapter[:2]}.{variant.exercise}"
    if exercise not in known:
        return f"{variant.where}: there is no exercise {exercise}"
    if variant.name.endswith(".cpp"):
        found = checks.ask(exercise, variant=variant.name.removesuffix(".cpp"))
    else:
        with tempfile.TemporaryDirectory(prefix="lightwalk.") as made:
            overlaid = Path(made) / known[exercise].relative_to(ROOT)
            overlaid.parent.mkdir(parents=True)
            overlaid.write_text(variant.text, encoding="utf-8")
            found = checks.ask(exercise, overlay=made)
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
    with Checks(chapter) as checks:
        wrong = [line for variant in found if (line := run_variant(chapter, variant, known, checks))]
    return mistakes + wrong + [f"{exercise}: tests/{chapter}/variants has no right and no wrong answer to it"
                               for exercise in without]


if __name__ == "__main__":
    run_on_chapter(main)
