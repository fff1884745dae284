"""The pictures of a chapter's shots, and those that their goldens must reject."""

from pathlib import Path

from shots.rendering import render_many, text
from tree import BUILD, exercises, is_edited

Picture = tuple[str, str, list, Path]  # description, the chapter that draws it, its options, the file


def picture_path(chapter: str, name: str, wrong: int | None = None) -> Path:
    return BUILD / "shots" / chapter / (f"{name}.png" if wrong is None else f"{name}.wrong{wrong}.png")


def right_picture(chapter: str, shot: dict) -> Picture:
    return shot["name"], chapter, ["--shot", shot["name"], "--use", "solution"], picture_path(chapter, shot["name"])


def wrong_pictures(chapter: str, shot: dict) -> list[Picture]:
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


def draw(pictures: list[Picture]) -> dict[Path, str]:
    """Draws the pictures, those of a program by one process. The failure of each, "" for none."""
    found = {}
    for program in sorted({program for _, program, *_ in pictures}):
        mine = [(options, picture) for _, by, options, picture in pictures if by == program]
        found |= dict(zip((picture for _, picture in mine), render_many(program, mine)))
    return found
