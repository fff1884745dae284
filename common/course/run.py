"""Builds the course and starts it; without a display, draws its pictures instead."""

import argparse
import hashlib
import json
import os
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from build.build import alone, build
from many import shards, slurm
from progress import Progress
from shots.rendering import render
from tree import (BUILD, ROOT, Failure, UsageError, chapter_program, chapters, find_chapter, relative, say, shots,
                  warn, write_atomically)

HELP = """Builds the course and starts it.

  ./course run                  a menu of the chapters; without a display, build/gallery/index.html
  ./course run 02 [options]     chapter 02, by its number or its name, with the chapter's own options
  ./course run 02 --help        a list of these options
  ./course run --gallery        the pictures, with or without a display
  ./course run --gallery --shard 3/16 --out F    part 3 of 16 of them, into the folder F; --merge F writes the page
  ./course run --gallery --slurm                 Slurm draws the parts"""


def run_words(words: list[str]) -> int:
    if words and words[0] in ("--help", "-h"):
        say(HELP)
        return 0
    if words and words[0].startswith("-") and words[0] != "--gallery":
        raise UsageError(f"name the chapter first, as in ./course run 01 {' '.join(words)}")
    if words[1:] and words[0] == "--gallery":
        return gallery_in_shards(words[1:])
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


class GalleryWords(argparse.ArgumentParser):
    def error(self, message):
        raise UsageError(f"{message}; see ./course run --help")


def gallery_in_shards(words: list[str]) -> int:
    parser = GalleryWords(add_help=False, allow_abbrev=False)
    shards.add_arguments(parser)
    slurm.add_arguments(parser)
    parser.add_argument("--out", type=Path)
    arguments, rest = parser.parse_known_args(words)
    if rest or not (arguments.shard or arguments.merge or arguments.slurm is not None):
        parser.error(f"unrecognised argument '{(rest or words)[0]}'")
    shards.check_arguments(arguments)
    slurm.check_arguments(arguments)
    if arguments.slurm is not None:
        arguments.merge = [slurm.run("gallery", arguments, ["run", "--gallery", *words], lambda: build(["programs"]))]
        slurm.finished("gallery")
    if arguments.merge:
        with alone(BUILD, "gallery"):
            return merge_gallery(arguments.merge)
    file = shards.file_of(arguments.out, "gallery", arguments.shard)
    build(["programs"])
    return draw_gallery_shard(file, arguments.shard)


def gallery_pictures() -> list[dict]:
    return [{"chapter": chapter, "name": shot["name"], "caption": shot.get("caption", ""),
             "image": f"{chapter}/{shot['name']}.png", "error": None,
             "command": f"./course run {chapter[:2]} --shot {shot['name']}"}
            for chapter in chapters() for shot in shots(chapter)]


def draw_gallery_shard(file: Path, shard: shards.Shard) -> int:
    """Draws the pictures that belong to a shard and writes it. Exit code 1 where one failed."""
    pictures = gallery_pictures()
    mine = [picture for picture in pictures if shard.takes(picture["image"])]
    with tempfile.TemporaryDirectory(prefix="lightwalk.gallery.") as made:
        draw(Path(made), mine)
        drawn = {picture["image"]: Path(made, picture["image"]).read_bytes() for picture in mine if not picture["error"]}
        entries = {picture["image"]: {"error": picture["error"], "sha256": hashlib.sha256(drawn.get(picture["image"], b"")).hexdigest()}
                   for picture in mine}
        head = {"pictures": [picture["image"] for picture in pictures], "course": shards.course_version()}
        shards.write(file, "gallery", shard, head, entries, drawn)
    say(f"{relative(file)}: {len(drawn)} of {len(pictures)} pictures")
    return say_failed(mine)


def merge_gallery(paths: list[Path]) -> int:
    """Writes the page of the pictures that all shards drew. Exit code 1 where one failed."""
    made, folder, pictures = shards.merge(paths, "gallery"), BUILD / "gallery", gallery_pictures()
    if made.head["pictures"] != [picture["image"] for picture in pictures]:
        raise UsageError("the shards are of a course with other pictures: make them again")
    for picture in pictures:
        picture["error"] = made.entries[picture["image"]]["error"]
        if not picture["error"]:
            write_atomically(folder / picture["image"], made.file(picture["image"], picture["image"]))
    return finish_gallery(pictures, folder)


def draw_gallery() -> int:
    """Draws every chapter's shots that are not drawn yet as things stand. Exit code 1 where one failed."""
    folder, pictures = BUILD / "gallery", gallery_pictures()
    known, keys = read_keys(folder), {chapter: key_of(chapter) for chapter in chapters()}
    stale = [picture for picture in pictures
             if known.get(picture["image"]) != keys[picture["chapter"]] or not (folder / picture["image"]).exists()]
    start_s = time.monotonic()
    draw(folder, stale)
    if stale:
        drawn = {picture["image"]: keys[picture["chapter"]] for picture in pictures if not picture["error"]}
        write_atomically(folder / "drawn.json", json.dumps(drawn))
        warn(f"drew {len(stale)} pictures in {time.monotonic() - start_s:.1f} s")
    return finish_gallery(pictures, folder)


def finish_gallery(pictures: list[dict], folder: Path) -> int:
    from pages.gallery import write_gallery  # here: a chapter starts without jinja2, too

    write_gallery(pictures, folder / "index.html")  # with nothing to draw, too: lessons may have got pages
    failed = say_failed(pictures)
    if not has_display():
        warn("there is no display to open a window on")
    say(f"{relative(folder / 'index.html')}: {sum(not picture['error'] for picture in pictures)} pictures")
    return failed


def say_failed(pictures: list[dict]) -> int:
    failed = [picture for picture in pictures if picture["error"]]
    for picture in failed:
        warn(f"{picture['chapter']}.{picture['name']}: {picture['error']}")
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
