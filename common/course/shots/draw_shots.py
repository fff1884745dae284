"""Draws the pictures for the tests of a chapter's shots and teeth, as a test that comes before them:

    python3 common/course shots.draw_shots NN_name

A partial run of ./course test has no teeth: only the shots are drawn.

All pictures of a program are drawn by one process (rendering.render_many). A picture's failure is reported by its own
test, which finds it in build/shots/NN_name/drawn.json:

    {"run": the name of the run, "pictures": {path from the root: its failure, or ""}}

The run is one of ./course test; a test that is run alone, or after another such run, draws for itself.
"""

import json
import time
from pathlib import Path

from shots.rendering import render, render_many, text
from tree import BUILD, Failure, exercises, find_shots, is_edited, relative, run_on_chapter, say, test_run, write_atomically


def picture_path(chapter: str, name: str, wrong: int | None = None) -> Path:
    """Of a shot, or of a picture that its golden must reject."""
    return BUILD / "shots" / chapter / (f"{name}.png" if wrong is None else f"{name}.wrong{wrong}.png")


def right_picture(chapter: str, shot: dict) -> tuple[str, str, list, Path]:
    """(description, the chapter that draws it, its options, the file) of the reference's picture."""
    return shot["name"], chapter, ["--shot", shot["name"], "--use", "solution"], picture_path(chapter, shot["name"])


def wrong_pictures(chapter: str, shot: dict) -> list[tuple[str, str, list, Path]]:
    """The same for each picture that the golden must reject."""
    same = ["--shot", shot["name"]]
    files = exercises(chapter)
    # One that was edited since the last commit is no starter: somebody works on it.
    wrong = [(f"the starter of {exercise}", chapter, [*same, "--use", f"solution,{exercise}=exercise"])
             for exercise in shot.get("exercises", []) if exercise not in files or not is_edited(files[exercise])]
    for entry in shot.get("rejects", []):
        if any(f"{exercise}=exercise" in entry.get("use", "") and is_edited(path) for exercise, path in files.items()):
            continue
        sets = [word for knob, value in entry.get("set", {}).items() for word in ("--set", f"{knob}={text(value)}")]
        if "chapter" in entry:
            scene = ["--scene", shot["scene"]] if "scene" in shot else []
            size = "x".join(str(side) for side in shot.get("size", [960, 540]))
            options = [*scene, "--size", size, "--time", shot.get("time_s", 0), *sets]
            wrong.append((f"drawn by {entry['chapter']}", entry["chapter"], options))
        else:
            use = entry.get("use", "solution")
            name = ", ".join(sets[1::2] + (["--use " + use] if "use" in entry else []))
            wrong.append((name, chapter, [*same, "--use", use, *sets]))
    return [(*picture, picture_path(chapter, shot["name"], number)) for number, picture in enumerate(wrong)]


def drawn_path(chapter: str) -> Path:
    return BUILD / "shots" / chapter / "drawn.json"


def drawn_in_this_run(chapter: str) -> dict[str, str]:
    """The failure ("" for none) of each picture drawn in this run of ./course test, by its path from the root."""
    run, path = test_run().get("name"), drawn_path(chapter)
    drawn = json.loads(path.read_text()) if run and path.exists() else {"run": None}
    return drawn["pictures"] if run and drawn["run"] == run else {}


def render_unless_drawn(chapter: str, program: str, options: list, picture: Path):
    """render() for a test of `chapter`, unless this run of ./course test has drawn that picture. Raises Failure as render() does."""
    pictures = drawn_in_this_run(chapter)
    if relative(picture) not in pictures:
        render(program, [*options, "--validate", "on"], picture)
    elif words := pictures[relative(picture)]:
        raise Failure(words)


def main(chapter: str, teeth: bool) -> list[str]:
    by_program, found, start = {}, {}, time.monotonic()
    # Grouped by scene, which is then read once.
    for _, shot in sorted(find_shots(chapter), key=lambda entry: entry[1].get("scene", "")):
        wrong = wrong_pictures(chapter, shot) if teeth else []
        for _, program, options, picture in [right_picture(chapter, shot), *wrong]:
            by_program.setdefault(program, []).append((options, picture))
    for program, pictures in by_program.items():
        found |= {relative(picture): words for (_, picture), words in zip(pictures, render_many(program, pictures))}
    write_atomically(drawn_path(chapter), json.dumps({"run": test_run().get("name"), "pictures": found}, indent=1) + "\n")
    say(f"{len(found)} pictures in {time.monotonic() - start:.1f} s")
    return []


if __name__ == "__main__":
    run_on_chapter(lambda chapter: main(chapter, teeth=not test_run().get("part")))
