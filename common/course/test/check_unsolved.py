"""Tests the checks on exercises that nobody has solved: check_unsolved.py NN_name. A failure is exit code 1 and a line that says why.

The reference of each exercise passes its check. The starter does not, nor do GLSL functions with empty bodies or bodies
that only return zero. An exercise that was edited since the last commit is skipped: somebody works on it.
"""

import json
import re
import tempfile
from pathlib import Path

from shots.rendering import run_program
from tree import BUILD, ROOT, Failure, exercises, is_edited, run_on_chapter

FUNCTION = re.compile(r"^(\w+)(\s+\w+\s*\([^)]*\)\s*)\{", re.M)


def passed(chapter: str, use: str, root: Path = ROOT, **environment) -> dict[str, bool]:
    """Which of the chapter's exercises pass their check. Raises Failure where the program says nothing."""
    done = run_program([BUILD / "tests" / f"check_{chapter}", "--use", use], LIGHTWALK_ROOT=str(root), **environment)
    lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    if not lines:
        raise Failure(f"check_{chapter} ended with {done.returncode}: {done.stderr.strip()}")
    return {line["exercise"]: line["ok"] for line in lines}


def with_bodies(glsl: str, body: str) -> str:
    """The text with each function's body replaced; ZERO stands for zero of its type."""
    out, at = [], 0
    for match in FUNCTION.finditer(glsl):
        if match.start() < at:
            continue
        out += [glsl[at:match.start()], match[1], match[2], "{", "" if match[1] == "void" else
                body.replace("ZERO", f"{match[1]}(0)"), "}"]
        at, depth = match.end(), 1
        while depth and at < len(glsl):
            depth += {"{": 1, "}": -1}.get(glsl[at], 0)
            at += 1
    return "".join(out) + glsl[at:]


def passed_with_bodies(chapter: str, body: str) -> dict[str, bool]:
    """The exercises that pass in a tree of links to this one with other bodies in the GLSL exercises."""
    glsl = {exercise: path for exercise, path in exercises(chapter).items() if path.suffix == ".glsl"}
    if not glsl:
        return {}
    with tempfile.TemporaryDirectory(prefix="lightwalk.") as made:
        inside = Path("shaders") / chapter / "exercise"
        for level in (Path(), Path("shaders"), Path("shaders") / chapter, inside):
            (Path(made) / level).mkdir(exist_ok=True)
            for path in (ROOT / level).iterdir():
                if path.relative_to(ROOT) not in (inside, *inside.parents) and path not in glsl.values():
                    (Path(made) / level / path.name).symlink_to(path)
        for path in glsl.values():
            (Path(made) / inside / path.name).write_text(with_bodies(path.read_text(encoding="utf-8"), body), encoding="utf-8")
        found = passed(chapter, "exercise", Path(made))
    return {exercise: ok for exercise, ok in found.items() if exercise in glsl}


def main(chapter: str) -> list[str]:
    wrong = [f"{exercise}: the reference does not pass" for exercise, ok in passed(chapter, "solution").items() if not ok]
    known = exercises(chapter)
    checked = passed(chapter, "exercise")
    wrong += [f"{exercise}: nothing checks it" for exercise in known if exercise not in checked]
    wrong += [f"{exercise}: the starter passes" for exercise, ok in checked.items()
              if ok and not is_edited(known[exercise])]
    for what, body in (("with empty functions", ""), ("with functions that return zero", " return ZERO; ")):
        wrong += [f"{exercise}: it passes {what}" for exercise, ok in passed_with_bodies(chapter, body).items() if ok]
    return wrong


if __name__ == "__main__":
    run_on_chapter(main)
