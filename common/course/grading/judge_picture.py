"""Judges the picture of an exercise whose numbers are right: a shot that names it, small.

The reference's picture is drawn outside, once for a class. The student's version of this one exercise is drawn in a
sandbox. Of GLSL, which reads nothing, the references of all other exercises are there. In C++ the chapter's program is
linked with the student's object in place of the starter's. The student's code can read all files of the program, so there
is no GLSL at all: the shaders are the reference picture's, compiled. The result is a PNG, compared in a sandbox as well,
since a hostile file may attack its reader. It comes out through one open file, so that a student's code has no folder of
this machine to fill, and printed text is not quoted.
"""

import contextlib
import functools
import json
import shlex
import shutil
import signal
import subprocess
import threading
import time
from pathlib import Path

from build.build import build
from check.check import PICTURE_LIMITS
from grading import sandbox
from grading.judge_tree import KEPT
from grading.sandbox import Limits, Mounts
from shots.golden import exceeded, unfit
from shots.rendering import render
from tree import BUILD, LIBRARIES, ROOT, SHADER_CACHE, Failure, chapter_program, shots, write_atomically

SIZE = "480x270"
GIB = 1 << 30
DRAWING = Limits(6 * GIB, 60, device=True)
PASS_S = 20  # of one pass of a frame, on a busy machine
COMPARING = Limits(2 * GIB, 20)
MOST_PICTURE_BYTES = 16 << 20
MOST_SHOWN_BYTES = 1 << 20
NOT_IN_TIME = "it was not drawn within"
NOT_COMPARED = "it cannot be compared"
THEIRS, EXPECTED = "wrong.theirs.png", "wrong.expected.png"  # beside the source of a wrong picture


class ToolFailed(Exception):
    """A process ended without a verdict: perhaps by a fault of the machine. Its text is the message otherwise."""


class DriverEnded(Exception):
    """The driver crashed with every shot that shows the exercise; this names them. One that is right has done that to it
    (Mesa 22.3, before its lavapipe got hidden blocks: common/gpu/hidden_blocks.h). One that is wrong can do so on
    purpose, to be seen in no picture."""


class Pictures:
    """Shared state for all students. `version` is a word by chapter that changes with the pictures' dependencies."""

    def __init__(self, wanted: dict[str, str], versions: dict[str, str]):
        self.wanted, self.versions = wanted, versions
        named = sorted(set(wanted.values()))
        build([*named, "compare"])
        self.shots = {exercise: [shot["name"] for shot in shots(chapter) if exercise in shot.get("exercises", [])]
                      for exercise, chapter in wanted.items()}
        self.links = {chapter: link_command(chapter) for chapter in named}
        self.locks = {chapter: threading.Lock() for chapter in named}

    def references(self, exercise: str) -> list[tuple[str, Path]]:
        """The shots that show the exercise, the one first that is drawn in the least time, and their pictures, drawn
        outside when they are first asked for."""
        chapter = self.wanted[exercise]
        folder = KEPT / "pictures" / f"{chapter}.{self.versions[chapter][:16]}"
        with self.locks[chapter]:
            times_s = {}
            for name in self.shots[exercise]:
                picture, took = folder / f"{name}.png", folder / f"{name}.seconds"
                if not took.exists():
                    start_s = time.monotonic()
                    sealed = folder / f"{name}.shaders"
                    sealed.mkdir(parents=True, exist_ok=True)
                    render(chapter, ["--shot", name, "--size", SIZE, "--shaders-into", sealed], picture)
                    write_atomically(took, f"{time.monotonic() - start_s:.3f}\n")
                times_s[name] = float(took.read_text(encoding="utf-8"))
        return [(name, folder / f"{name}.png") for name in sorted(times_s, key=times_s.get)]

    def wrong(self, exercise: str, source: Path, judge) -> str | None:
        """The fault in the picture; empty if right, None without one. The source is alone in its folder. Raises DriverEnded."""
        program = chapter_program(self.wanted[exercise])
        references, crashed = self.references(exercise), []
        if source.suffix == ".cpp" and references:
            self.link(exercise, source.parent, judge)
            program = source.parent / "program"
        for name, expected in references:
            try:
                why = self.drawn_wrong(exercise, source, program, name, expected, judge)
            except DriverEnded:
                crashed.append(name)
                continue
            return why and f"the numbers are right, the picture of {name} is not: {why}"
        if crashed:
            raise DriverEnded(", ".join(crashed))
        return None

    def drawn_wrong(self, exercise: str, source: Path, program: Path, shot: str, expected: Path, judge) -> str:
        picture = source.parent / f"{shot}.png"
        sealed = ["--shaders-from", "/grade/shaders"] if source.suffix == ".cpp" else []
        with picture.open("w+b") as out:
            with judge.started(["/grade/program", "--shot", shot, "--size", SIZE, "--use",
                                f"solution,{exercise}=exercise", "--screenshot", f"/dev/fd/{out.fileno()}", *sealed],
                               self.drawing_mounts(exercise, source, program, expected, judge), DRAWING,
                               {"LIGHTWALK_ROOT": ROOT, "LIGHTWALK_TIMEOUT_S": PASS_S},
                               pass_fds=(out.fileno(),)) as running:
                done = running.finish()
        if done.late:
            return f"{NOT_IN_TIME} {DRAWING.wall_s:g} s"
        if done.code == 128 + signal.SIGSEGV and source.suffix == ".glsl":
            raise DriverEnded(shot)
        if done.code:
            raise ToolFailed(f"the program that draws it ended with {done.code}{sandbox.signal_words(done.code)}")
        if not 0 < picture.stat().st_size < MOST_PICTURE_BYTES:
            raise ToolFailed("the program that draws it wrote none")
        why = self.compare(expected, picture, judge)
        # For the student's page: readable in a sandbox, and at most the size of a small picture. Of GLSL alone: C++ reads its
        # own program, the references of other exercises among it, and could write them into its picture.
        if why and source.suffix == ".glsl" and not why.startswith(NOT_COMPARED) and picture.stat().st_size < MOST_SHOWN_BYTES:
            picture.replace(source.parent / THEIRS)
            shutil.copyfile(expected, source.parent / EXPECTED)
        return why

    def drawing_mounts(self, exercise: str, source: Path, program: Path, expected: Path, judge) -> Mounts:
        mounts = judge.mounts()
        for name in ("assets", "docs"):
            if (ROOT / name).exists():
                mounts.read(ROOT / name)
        mounts.read(program, Path("/grade/program"))
        for chapter in sorted({path.parent.name for path in (ROOT / "tests").glob("*/shots.json")}):
            mounts.empty(ROOT / "tests" / chapter)
            mounts.read(ROOT / "tests" / chapter / "shots.json")
            for name in ("scenes", "data"):
                if (ROOT / "tests" / chapter / name).is_dir():
                    mounts.read(ROOT / "tests" / chapter / name)
        cache = ROOT / "build" / "shader_cache"
        if source.suffix == ".cpp":
            mounts.read(expected.with_suffix(".shaders"), Path("/grade/shaders"))
            for baked in SHADER_CACHE.glob("*.occlusion"):
                mounts.read(baked, cache / baked.name)
            return mounts
        judge.mount_references(mounts, exercise)
        mounts.read(source, judge.paths[exercise])
        if SHADER_CACHE.is_dir():
            mounts.read(SHADER_CACHE, cache)
        return mounts

    def link(self, exercise: str, folder: Path, judge):
        """Makes `program` beside the student's object. Raises ToolFailed."""
        chapter, place = self.wanted[exercise], str(judge.paths[exercise].relative_to(ROOT))
        # Newer CMakes have the linker write its dependencies beside the build's objects.
        words = [word for word in self.links[chapter] if not word.startswith("-Wl,--dependency-file")]
        its = next(i for i, word in enumerate(words) if word.endswith(f"/{place}.o"))
        del words[its]
        words[words.index("-o") + 1] = "/grade/program"
        words.append("/grade/student.o")  # last: its toggles, made without references, are those that are there already
        mounts = judge.mounts()
        for name in ("CMakeFiles", *[path.name for path in BUILD.glob("lib*.a")]):
            mounts.read(BUILD / name)
        mounts.write(folder, Path("/grade"))
        script = f"cd {shlex.quote(str(BUILD))} && {shlex.join(words)}"
        with judge.started(["/bin/sh", "-c", script], mounts, Limits(3 * GIB, 30, processes=True)) as running:
            done = running.finish()
        if done.code:
            raise ToolFailed("it does not link into the chapter's program")

    def compare(self, expected: Path, actual: Path, judge) -> str:
        mounts = Mounts()
        for shared in LIBRARIES:
            mounts.read(shared)
        mounts.read(BUILD / "compare", Path("/grade/compare"))
        mounts.read(expected, Path("/grade/expected.png"))
        mounts.read(actual, Path("/grade/actual.png"))
        with judge.started(["/grade/compare", "/grade/expected.png", "/grade/actual.png", "--json"], mounts,
                           COMPARING) as running:
            done = running.finish()
        with contextlib.suppress(ValueError, KeyError, TypeError, RecursionError):
            metrics = json.loads(done.out)
            if wrong := unfit(metrics):
                return wrong[0]
            if not exceeded(metrics, PICTURE_LIMITS):
                return ""
            most = metrics["max_diff"]
            return f"{most['pixels']} pixels differ from the reference's, most the one at ({most['x']}, {most['y']})"
        return f"{NOT_COMPARED}: it is no PNG that can be read"


@functools.cache
def link_command(chapter: str) -> list[str]:
    done = subprocess.run(["ninja", "-C", BUILD, "-t", "commands", f"chapters/{chapter}"], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, errors="replace")
    lines = done.stdout.strip().splitlines()
    if done.returncode or not lines:
        raise Failure(f"ninja does not say how {chapter} is linked")
    return shlex.split(lines[-1].removeprefix(": && ").removesuffix(" && :"))
