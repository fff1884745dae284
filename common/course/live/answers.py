"""The exercises as a page edits them: one file each, and nothing else can be written."""

import asyncio
import contextlib
import json
import os
import signal
import stat

from check.check import TIMEOUT_S, grades, in_order
from check.starters import digest
from check.verdicts import Verdicts, version  # noqa: F401  (the server keeps them)
from pages.made import cells, made
from tree import PYTHON, BUILD, ROOT, chapters, exercises, has_solutions, relative, shots, write_atomically

MOST_BYTES = 1 << 18  # of an exercise; the longest starter has 4 KiB
CHECK_S = 900  # with a build from nothing
# A picture at rest is drawn with four times the samples where that takes at most so long: never, or however long, as asked.
REFINE_MS = {"off": 0, "auto": 4000, "on": 1_000_000}  # longest picture of which a finer one is drawn


class Refused(Exception):
    """A request that is not answered: an HTTP status and one line."""

    def __init__(self, status: int, words: str, **more):
        super().__init__(words)
        self.status, self.more = status, more


def file_of(exercise: str):
    """(chapter, the file) of an exercise's id. Raises Refused: nothing but exercises has an address."""
    for chapter in chapters():
        if chapter[:2] != exercise[:2]:
            continue
        path = exercises(chapter).get(exercise)
        # A link would lead elsewhere.
        if path and path.is_file() and path.resolve() == path and path.is_relative_to(ROOT):
            return chapter, path
    raise Refused(404, f"there is no exercise {exercise[:60]!r}")


def encoding_of(data: bytes) -> str:
    """Of an old editor's file every byte is a letter, and is one again when it is written."""
    try:
        data.decode("utf-8")
    except UnicodeDecodeError:
        return "latin-1"
    return "utf-8"


def read(exercise: str) -> dict:
    chapter, path = file_of(exercise)
    data = path.read_bytes()
    return {"exercise": exercise, "chapter": chapter, "file": relative(path), "version": version(data),
            "text": data.decode(encoding_of(data))}


def write(exercise: str, text, base) -> dict:
    """Replaces the file where it still is the version that the page has edited. Raises Refused."""
    _, path = file_of(exercise)
    if not isinstance(text, str) or not isinstance(base, str) or "\0" in text:
        raise Refused(400, 'a request to write is {"text": ..., "base": the version that was edited}')
    there = path.read_bytes()
    try:
        data = text.encode("utf-8")
        with contextlib.suppress(UnicodeEncodeError):
            data = text.encode(encoding_of(there))
    except UnicodeEncodeError:
        raise Refused(400, "the text is not Unicode") from None
    if len(data) > MOST_BYTES:
        raise Refused(413, f"an exercise has at most {MOST_BYTES >> 10} KiB")
    if version(there) != base:
        raise Refused(409, f"{relative(path)} was changed on disk since it was read; nothing was written",
                      version=version(there), text=there.decode(encoding_of(there)))
    if data != there:
        write_atomically(path, data, stat.S_IMODE(path.stat().st_mode))
    return {"exercise": exercise, "version": version(data)}


def catalogue(refine: str = "auto") -> dict:
    """The pages' data about the course: shots and exercises by chapter, and the lessons' other pictures."""
    def one(chapter: str) -> dict:
        return {"shots": {shot["name"]: {key: shot[key] for key in ("caption", "size", "time_s", "set", "exercises")
                                         if key in shot} for shot in shots(chapter)},
                "exercises": [{"id": name, "file": relative(exercises(chapter)[name]), "grade": grades(chapter).get(name)}
                              for name in in_order(chapter)]}
    pictures = {name: {"columns": made()[name]["columns"], "cells": cells(name)} for name in made()}
    return {"chapters": {chapter: one(chapter) for chapter in chapters()}, "pictures": pictures, "solutions": has_solutions(),
            "refine_ms": REFINE_MS[refine]}


async def run(words: list, say, limit_s: float = CHECK_S) -> tuple[int, str]:
    """Runs a program with its words on stderr passed on to say(line) as they come. Returns its code and its output."""
    process = await asyncio.create_subprocess_exec(
        *words, cwd=ROOT, limit=1 << 20, stdin=asyncio.subprocess.DEVNULL, stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE, start_new_session=True)

    async def pass_on():
        async for line in process.stderr:
            say(line.decode(errors="replace").rstrip())

    try:
        out, _, code = await asyncio.wait_for(asyncio.gather(process.stdout.read(), pass_on(), process.wait()), limit_s)
        return code, out.decode(errors="replace")
    except asyncio.TimeoutError:
        return -1, ""
    finally:
        if process.returncode is None:
            os.killpg(process.pid, signal.SIGTERM)
            await process.wait()


def course(*words: str) -> list:
    return [*PYTHON, ROOT / "common/course/cli.py", *words]


async def check(exercise: str, say, build: bool = True) -> dict:
    """Runs ./course check on an exercise: its protocol's object, with "version", that of the checked file."""
    chapter, path = file_of(exercise)
    data = path.read_bytes()
    of = {"version": version(data), "digest": digest(data)}
    if build:
        words = []
        code, out = await run(course("check", exercise, "--json"), lambda line: (words.append(line), say(line)))
        if code in (3, -1):  # no verdict: this machine cannot judge, or it took too long
            raise Refused(503, (words or [f"it did not end within {CHECK_S} s"])[-1])
    else:  # the numbers alone, by programs already built
        program = BUILD / "tests" / f"check_{chapter}"
        if program.exists():
            code, out = await run([program, "--exercise", exercise, "--use", "exercise"], say, TIMEOUT_S)
        else:
            code, out = 1, f"the checks of chapter {chapter[:2]} are not built: ./course check {chapter[:2]} builds them"
    for line in out.splitlines():
        try:
            result = json.loads(line)
        except ValueError:
            continue
        if isinstance(result, dict) and result.get("exercise") == exercise:
            return result | {"ok": result.get("ok") is True and code == 0} | of
    return {"exercise": exercise, "ok": False, "passed": 0, "failed": 0, "hint": None,
            "first_failure": (out.strip().splitlines() or [f"the check ended with {code}"])[-1]} | of


async def build_chapter(chapter: str, say) -> bool:
    """Builds a chapter's program, in a process of its own, which has the lock of all builds."""
    code, _ = await run([*PYTHON, "-c", "import sys; sys.path.insert(0, sys.argv[1]); from build.build import build; "
                         "build([sys.argv[2]])", ROOT / "common/course", chapter], say)
    return code == 0
