"""Builds the course and starts it: the menu, a chapter, or without a display the gallery."""

import os
import subprocess
from pathlib import Path

from build.build import alone, build
from build.options import check_options
from build.programs import Programs, unbuilt
from gallery import draw_gallery, gallery_in_shards
from tree import (BUILD, CLOSED, Failure, UsageError, chapter_program, chapters, find_chapter, has_display, relative, say, warn,
                  write_atomically)

HELP = """Builds the course and starts it.

  ./course run                  a menu of the chapters, each of which can be started as soon as it is built; without a
                                display, each chapter's best picture on build/gallery/index.html
  ./course run 02 [options]     chapter 02, by its number or its name, with the chapter's own options
  ./course run 02 --help        a list of these options
  ./course run --menu [options] the menu, with options of the chapters that it starts: --device NAME, for instance
  ./course run --gallery        every picture of the course on that page, with or without a display
  ./course run --gallery --shard 3/16 --out F    part 3 of 16 of them, into the folder F; --merge F writes the page
  ./course run --gallery --slurm                 Slurm draws the parts"""


def run_words(words: list[str]) -> int:
    if words and words[0] in ("--help", "-h"):
        say(HELP)
        return 0
    if words and words[0].partition("=")[0] == "--device" and has_display():
        return open_menu(words)
    if words and words[0].startswith("-") and words[0] not in ("--gallery", "--menu"):
        raise UsageError(f"name the chapter first, as in ./course run 01 {' '.join(words)}")
    if words[1:] and words[0] == "--gallery":
        return gallery_in_shards(words[1:])
    if words[:1] == ["--menu"]:
        return open_menu(words[1:])
    if words and words != ["--gallery"]:
        return start(find_chapter(words[0]), words[1:])
    if words or not has_display():
        with alone(BUILD, "gallery"):
            return draw_gallery(best_only=not words)
    return open_menu([])


def start(chapter: str, options: list[str]) -> int:
    check_options(chapter, options)
    is_built([chapter], chapter_program(chapter))
    return execute(chapter_program(chapter), options)


def is_built(targets: list[str], program: Path) -> bool:
    """Builds. False where the folder cannot be written, as another's, and the program is there as it was built before."""
    try:
        build(targets)
    except OSError as error:
        if error.errno not in CLOSED or not program.exists():
            raise
        warn(f"{relative(BUILD)} cannot be written: {program.name} is started as it was built")
        return False
    return True


def open_menu(options: list[str]) -> int:
    """The menu, as soon as the first chapter stands; the others are built beside it, the one that was clicked first."""
    if not is_built([chapters()[0], "menu"], BUILD / "menu") or not unbuilt():
        return execute(BUILD / "menu", options)
    folder = BUILD / "menu_of_chapters"
    folder.mkdir(parents=True, exist_ok=True)
    wanted = folder / "wanted"
    wanted.unlink(missing_ok=True)

    def say_states():
        lines = [f"{chapter} {state.name} {state.done} {state.total}\n" for chapter, state in programs.states.items()]
        write_atomically(folder / "states", "".join(lines))

    programs = Programs(say_states, lambda: wanted.read_text(encoding="utf-8").strip() if wanted.exists() else None)
    say_states()
    try:
        menu = subprocess.Popen([BUILD / "menu", "--programs", folder, *options])
    except OSError as error:
        raise Failure(f"{relative(BUILD / 'menu')}: {error.strerror}") from None
    try:
        programs.start()
        code = menu.wait()
    finally:
        menu.terminate()
        programs.stop()
    if waiting := len(chapters()) - len(programs.ready()):
        warn(f"{waiting} chapters are not built; the next ./course run goes on with them")
    return code if code >= 0 else 128 - code


def execute(program: Path, options: list[str]):
    """Becomes the program, so that its exit code and its signals are ours."""
    try:
        os.execv(program, [str(program), *options])
    except OSError as error:
        raise Failure(f"{relative(program)}: {error.strerror}") from None
