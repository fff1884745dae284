"""The part of the course visible to a student's code while it is judged: the handout's sources."""

import functools
import json
import re
import shlex
import shutil
import subprocess
from pathlib import Path

from build.build import used
from grading.handout import COMPILED, LEFT_OUT
from tree import BUILD, MANIFEST, ROOT, chapters, exercises, files

KEPT = BUILD / "grade"  # what one call leaves to the next: verdicts, references' pictures, pictures to be shown


def library(folder: Path, chapter: str) -> Path:
    """The objects of a chapter and those that it uses that have neither references nor the truth in them."""
    path = folder / f"lib{chapter}.a"
    members = []
    for name in sorted({chapter} | used(chapter)):
        members += [one for one in objects(f"chapter_{name}") if not is_answer(one)]
    said = subprocess.run(["nm", "-A", "-C", *members], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                          errors="replace").stdout
    telling = {line.partition(".o:")[0] + ".o" for line in said.splitlines()
               if "lightwalk::truth::" in line or re.search(r" [TWVDBR] lightwalk::solution::", line)}
    members = [one for one in members if str(one) not in telling]
    subprocess.run(["ar", "rc", path, *members], check=True, stdout=subprocess.DEVNULL)
    return path


@functools.cache
def object_files() -> list[Path]:
    found = []
    for entry in json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8")):
        words = shlex.split(entry["command"])
        found.append(Path(entry["directory"]) / words[words.index("-o") + 1])
    return sorted(found)


def objects(target: str) -> list[Path]:
    folder = BUILD / "CMakeFiles" / f"{target}.dir"
    return [path for path in object_files() if path.is_relative_to(folder)]


def is_answer(compiled: Path) -> bool:
    """Whether an object belongs to a reference, or to a part without source in the handout."""
    name = str(compiled).partition(".dir/")[2].removesuffix(".o")
    return "/solution/" in name or "/exercise/" in name or any(Path(name).match(pattern) for pattern in COMPILED)


def copy_without_answers(to: Path, starters: dict[Path, bytes]):
    """The headers and shaders that a student's file may include, and an empty place for each reference."""
    kept = {".h", ".glsl", ".vert", ".frag", ".geom", ".comp"}
    for name in files():
        if name.parts[0] not in ("chapters", "common", "shaders", "tests") or name.suffix not in kept:
            continue
        if "exercise" in name.parts:  # the starters, below
            continue
        if "solution" in name.parts:
            (to / name.parent).mkdir(parents=True, exist_ok=True)
        elif (name.parts[0] != "tests" or name.parts[1] == "common" or name.suffix == ".glsl") and \
                not any(name.match(pattern) for pattern in LEFT_OUT):
            (to / name.parent).mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, to / name)
    for folder in (path for path in (ROOT / "tests").iterdir() if path.is_dir()):
        (to / "tests" / folder.name).mkdir(parents=True, exist_ok=True)
    shutil.copyfile(ROOT / MANIFEST, to / MANIFEST)
    for path in (path for chapter in chapters() for path in exercises(chapter).values()):
        place = to / path.relative_to(ROOT)
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(starters.get(path, b""))  # of another chapter's the reference is used, which is found by its starter's name
