"""Builds the course and starts it; without a display, draws its pictures instead."""

import hashlib
import json
import os
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from build.build import alone, build
from progress import Progress
from shots.rendering import render
from tree import (BUILD, ROOT, Failure, UsageError, chapter_program, chapters, find_chapter, relative, say, shots,
                  warn, write_atomically)

HELP = """Builds the course and starts it.

  ./course run                  a menu of the chapters; without a display, build/gallery/index.html
  ./course run 02 [options]     chapter 02, by its number or its name, with the chapter's own options
  ./course run 02 --help        a list of these options
  ./course run --gallery        the pictures, with or without a display"""


def run_words(words: list[str]) -> int:
    if words and words[0] in ("--help", "-h"):
        say(HELP)
        return 0
    if words and words[0].startswith("-") and words != ["--gallery"]:
        raise UsageError(f"name the chapter first, as in ./course run 01 {' '.join(words)}")
    if words and words != ["--gallery"]:
        return start(find_chapter(words[0]), words[1:])
    build(["programs"])
    if words or not has_display():
        with alone(BUILD, "gallery"):
            return draw_gallery()
    menu = BUILD / "menu"
    return execute(menu if menu.exists() else chapter_program(chapters()[0]), [])


def has_display() -> bool:
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def start(chapter: str, options: list[str]) -> int:
    build([chapter])
    return execute(chapter_program(chapter), options)


def execute(program: Path, options: list[str]):
    """Becomes the program, so that its exit code and its signals are ours."""
    try:
        os.execv(program, [str(program), *options])
    except OSError as error:
        raise Failure(f"{relative(program)}: {error.strerror}") from None


def draw_gallery() -> int:
    """Draws every chapter's shots that are not drawn yet as things stand. Exit code 1 where one failed."""
    from pages.gallery import write_gallery  # here: a chapter starts without jinja2, too

    folder = BUILD / "gallery"
    pictures = [{"chapter": chapter, "name": shot["name"], "caption": shot.get("caption", ""),
                 "image": f"{chapter}/{shot['name']}.png", "error": None,
                 "command": f"./course run {chapter[:2]} --shot {shot['name']}"}
                for chapter in chapters() for shot in shots(chapter)]
    known, keys = read_keys(folder), {chapter: key_of(chapter) for chapter in chapters()}
    stale = [picture for picture in pictures
             if known.get(picture["image"]) != keys[picture["chapter"]] or not (folder / picture["image"]).exists()]
    start_s = time.monotonic()
    draw(folder, stale)
    write_gallery(pictures, folder / "index.html")  # with nothing to draw, too: lessons may have got pages
    if stale:
        drawn = {picture["image"]: keys[picture["chapter"]] for picture in pictures if not picture["error"]}
        write_atomically(folder / "drawn.json", json.dumps(drawn))
        warn(f"drew {len(stale)} pictures in {time.monotonic() - start_s:.1f} s")
    failed = [picture for picture in pictures if picture["error"]]
    for picture in failed:
        warn(f"{picture['chapter']}.{picture['name']}: {picture['error']}")
    if not has_display():
        warn("there is no display to open a window on")
    say(f"{relative(folder / 'index.html')}: {len(pictures) - len(failed)} pictures")
    return 1 if failed else 0


def draw(folder: Path, pictures: list[dict]):
    """Draws them, as many at a time as there are cores: half of a picture's time is one thread's."""
    def one(picture):
        try:
            render(picture["chapter"], ["--shot", picture["name"], "--samples", "4"], folder / picture["image"])
        except Failure as failure:
            picture["error"] = str(failure)
        return picture

    with Progress("drawing") as progress, ThreadPoolExecutor(min(os.cpu_count() or 1, 4)) as pool:
        waiting = [pool.submit(one, picture) for picture in pictures]
        try:
            for done, future in enumerate(as_completed(waiting), 1):
                picture = future.result()
                progress.show(done, len(pictures), f"{picture['chapter']}.{picture['name']}")
        except KeyboardInterrupt:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def read_keys(folder: Path) -> dict:
    """What each picture was drawn from, as noted when it was drawn."""
    try:
        return json.loads((folder / "drawn.json").read_text())
    except (OSError, ValueError):
        return {}


def key_of(chapter: str) -> str:
    """Changes with whatever a chapter's pictures are made of: program, shots, shaders, assets, driver."""
    paths = [chapter_program(chapter), ROOT / "tests" / chapter / "shots.json"]
    for folder in ("shaders", "assets"):
        paths += sorted(path for path in (ROOT / folder).rglob("*") if path.is_file())
    stats = [(str(path), path.stat().st_size, path.stat().st_mtime_ns) for path in paths if path.exists()]
    driver = sorted((name, value) for name, value in os.environ.items() if name.startswith(("VK_", "LIGHTWALK_")))
    return hashlib.sha256(repr((stats, driver)).encode()).hexdigest()
