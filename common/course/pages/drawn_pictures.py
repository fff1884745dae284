"""Pictures that chapters draw for the pages, kept in build/site/pictures.

A name has a hash of all that decides a picture: the words that draw it, the chapter's sources and those of the chapters before it,
shared shaders, and the shot with its golden, or the scene. So a picture is drawn once, and again when one of these changes.
"""

import functools
import hashlib
import re
import time
from dataclasses import dataclass
from pathlib import Path

from charts import measured
from pages.page import encoded
from shots.golden import golden_path
from shots.rendering import Drawing
from tree import BUILD, ROOT, chapters, shots, warn

KEPT = BUILD / "site" / "pictures"
SAMPLES = 16
SAMPLED_ONCE = ("07_mipmaps", "13_mlaa")  # more samples would hide their subject
NOTED = 50  # pictures between two lines of progress


@dataclass(frozen=True)
class Picture:
    """`words` as the chapter's program takes them. A `whole` one is kept without loss."""
    chapter: str
    name: str
    words: tuple[str, ...]
    whole: bool = False

    @functools.lru_cache(None)  # noqa: B019  (as many as there are pictures)
    def file(self) -> Path:
        key = hashlib.sha256(repr((self.words, version(self.chapter))).encode())
        for option, value in zip(self.words, self.words[1:]):
            if option == "--shot":
                key.update(repr(shot_of(self.chapter, value)).encode() + golden_path(self.chapter, value).read_bytes())
            elif option == "--scene":
                key.update((ROOT / value).read_bytes())
        return KEPT / self.chapter / f"{self.name}.{key.hexdigest()[:16]}.{'png' if self.whole else 'webp'}"


@functools.cache
def version(chapter: str) -> str:
    """Of the sources of a chapter and of those before it, and of the shaders that all share."""
    common = hashlib.sha256(b"".join(path.read_bytes() for path in sorted((ROOT / "shaders/common").rglob("*.*"))))
    return " ".join([common.hexdigest(), *(measured.here(one) for one in chapters() if one <= chapter)])


def shot_of(chapter: str, name: str) -> dict:
    return next(shot for shot in shots(chapter) if shot["name"] == name)


def size_of(chapter: str, shot: str) -> tuple[int, int]:
    return tuple(shot_of(chapter, shot).get("size", (960, 540)))


def fine(chapter: str, shot: str) -> Picture:
    samples = 1 if chapter in SAMPLED_ONCE else SAMPLES
    return Picture(chapter, shot, ("--shot", shot, "--samples", str(samples)), whole=True)


def finest(golden: Path) -> Path:
    """A golden, a path from the root, or the same shot with sixteen samples where that is drawn."""
    found = re.fullmatch(r"tests/(\d\d_\w+)/golden/(\w+)\.png", golden.as_posix())
    if found and found[2] in [shot["name"] for shot in shots(found[1])]:
        drawn = fine(*found.groups()).file()
        return drawn if drawn.exists() else ROOT / golden
    return ROOT / golden


def draw(pictures: list[Picture]) -> dict[Picture, str]:
    """Draws the pictures that are not kept, a process for each chapter. Returns the errors."""
    stale = [one for one in dict.fromkeys(pictures) if not one.file().exists()]
    wrong, start_s, drawing = {}, time.monotonic(), None
    for number, picture in enumerate(sorted(stale, key=lambda one: one.chapter), 1):
        if drawing and drawing.chapter != picture.chapter:
            drawing.close()
            drawing = None
        drawing = drawing or Drawing(picture.chapter, validate="off")
        file = picture.file()
        beside = file.with_name(f".{file.name}.png")
        file.parent.mkdir(parents=True, exist_ok=True)
        code, words, _ = drawing.draw(list(picture.words), beside)
        if code or not beside.exists():
            wrong[picture] = words
        elif picture.whole:
            beside.replace(file)
        else:
            file.write_bytes(webp(beside))
            beside.unlink()
        if number % NOTED == 0:
            warn(f"{number} of {len(stale)} pictures of lessons are drawn")
    if drawing:
        drawing.close()
    if stale:
        warn(f"drew {len(stale) - len(wrong)} pictures of lessons in {time.monotonic() - start_s:.0f} s")
    return wrong


def webp(path: Path) -> bytes:
    return encoded(path, quality=78, method=4)


def put(made: Path, picture: Picture) -> str:
    """Copies a drawn picture into the site, below states/, and returns its address."""
    to = made / "states" / picture.chapter[:2] / picture.file().name
    if not to.exists():
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_bytes(picture.file().read_bytes())
    return to.relative_to(made).as_posix()
