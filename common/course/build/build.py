"""Configures and builds the C++ side: nothing is said where nothing is to do."""

import contextlib
import errno
import fcntl
import os
import re
import shlex
import shutil
import subprocess
import time
from pathlib import Path

from progress import Progress
from tree import ROOT, SHADER_CACHE, Failure, UsageError, chapters, relative, say_left_alone, sources, warn


class BuildFailure(Failure):
    """The build failed; `said` is the compiler's output."""

    said = ""


SPEAKING = {"LC_ALL": "C.UTF-8"}  # of compilers, whose messages are read
STATUS = re.compile(r"\[(\d+)/(\d+)\] ")


# Characters with special meaning to CMake, ninja, ccache or the linker in a path.
SPECIAL = "$;#\"\\,\n"


@contextlib.contextmanager
def alone(folder: Path, what: str = "build"):
    """Two commands at once in one tree that do the same do it one after the other. Yields the lock's file descriptor: a
    process that has it keeps the lock when we are gone."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / f".lock.{what}", "w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            warn(f"waiting for another ./course with the same task in this folder ({what})")
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield lock.fileno()


def build(targets: list[str] = (), preset: str = "default", show=None, give_way=lambda: False,
          started=lambda ninja: None) -> Path | None:
    """Builds the targets (all if none is given) of a preset and returns its folder. Raises Failure. show(done, total,
    what) replaces the bar; if give_way() is true after a step, the build ends there and None is returned.
    started(ninja) has the process."""
    folder = ROOT / "build" / ("" if preset == "default" else preset)
    if special := sorted(set(str(ROOT)) & set(SPECIAL)):
        raise UsageError(f"the course lies in {str(ROOT)!r}: a build takes {' and '.join(map(repr, special))} in a path for a "
                         "command; move the course to another folder")
    say_left_alone()
    refuse_future()
    with alone(folder) as lock:
        if not is_configured(folder):
            configure(preset, folder, lock)
        elif not is_linked(folder):
            configure(preset, folder, lock, again=True)
        try:
            built, ended = run_ninja(folder, list(targets), lock, show, give_way, started)
        except BuildFailure as failure:
            if re.search(r"Cannot fork|Resource temporarily unavailable", failure.said):
                raise OSError(errno.EAGAIN, os.strerror(errno.EAGAIN)) from None
            at = os.statvfs(folder)
            if at.f_bavail * at.f_frsize < 1 << 16 or at.f_files and not at.f_favail:
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(folder)) from None
            raise
        if built:
            trim(SHADER_CACHE)
    return folder if ended else None


CACHE_BYTES = 2**28  # deflated; a build of nineteen chapters with its tests, and leftovers of edits, held 230 MiB


def trim(cache: Path, most: int = CACHE_BYTES):
    """Trims a cache above `most` bytes: removes the least recently used files until three quarters are left."""
    try:
        entries = [(entry.stat(), entry.path) for entry in os.scandir(cache)]
    except OSError:
        return  # there is none, or something else removes from it as well
    kept = sum(at.st_blocks * 512 for at, _ in entries)
    if kept <= most:
        return
    for at, path in sorted(entries, key=lambda entry: entry[0].st_mtime):
        if kept <= 0.75 * most:
            return
        with contextlib.suppress(OSError):
            os.unlink(path)
            kept -= at.st_blocks * 512


def is_configured(folder: Path) -> bool:
    """True where ninja can go on by itself; it runs cmake again where a file of the build changed."""
    cache = folder / "CMakeCache.txt"
    return all(begins_as_written(folder / name) for name in ("build.ninja", "CMakeFiles/rules.ninja")) and \
        cache.exists() and f"CMAKE_HOME_DIRECTORY:INTERNAL={ROOT}\n" in cache.read_text(errors="replace", encoding="utf-8")


def is_linked(folder: Path) -> bool:
    """False where a file includes a chapter that its own is not linked with yet."""
    known = linked(folder)
    return all(included(chapter) <= known.get(chapter, set()) for chapter in chapters())


def linked(folder: Path) -> dict[str, set[str]]:
    """The chapters that cmake found included by each, which it is linked with."""
    with contextlib.suppress(OSError):
        return {words[0]: set(words[1:]) for words in map(str.split, (folder / "chapters.links").read_text(encoding="utf-8").splitlines())}
    return {}


INCLUDED = re.compile(r'^#include "(\d\d_[a-z0-9_]+)/', re.M)


def included(chapter: str) -> set[str]:
    """The chapters that files of this one include, of those before it: what cmake links it with."""
    found = {name for path in sources(ROOT / "chapters" / chapter, "**/*.[ch]*")
             for name in INCLUDED.findall(path.read_text(errors="replace", encoding="utf-8")) if path.suffix in (".cpp", ".h")}
    return {name for name in found if name < chapter and (ROOT / "chapters" / name).is_dir()}


def used(chapter: str) -> set[str]:
    """Those, and the ones that these use."""
    found, asked = set(), [chapter]
    while asked:
        new = included(asked.pop()) - found
        found |= new
        asked += new
    return found


SLACK_S = 5  # clocks of network file systems


def refuse_future():
    """Raises Failure for sources from the future: ninja would run cmake again and again."""
    now_s = time.time() + SLACK_S
    newest = max(((one.stat().st_mtime, one) for folder in (".", "chapters", "common", "shaders", "tests")
                  for one in configured_by(ROOT / folder)), default=(0, None), key=lambda pair: pair[0])
    if newest[0] > now_s:
        hours = (newest[0] - now_s) / 3600
        raise Failure(f"{relative(newest[1])} is from the future, by {hours:.1f} h, or the clock is wrong: set the clock, or type "
                      f"find {shlex.quote(str(ROOT))} -newermt now -exec touch {{}} +")


def configured_by(folder: Path) -> list[Path]:
    """Files that cmake reads: those that make ninja run it again."""
    here = [ROOT / name for name in ("CMakeLists.txt", "CMakePresets.json")] if folder == ROOT / "." else []
    found = here or [*folder.glob("*.cmake"), *folder.glob("*/*.cmake"), *folder.glob("*/shots.json"), *folder.glob("*.txt")]
    return [path for path in found if path.is_file()]


def begins_as_written(path: Path) -> bool:
    """False for a file that a power cut left empty or filled with zeros: CMake begins its own with a comment."""
    try:
        with open(path, "rb") as file:
            return file.read(1) == b"#"
    except FileNotFoundError:
        return False


def configure(preset: str, folder: Path, lock: int | None = None, again: bool = False):
    """Runs cmake; without `again` anew, in a tree that was moved or half configured. CMake before 3.24 has no --fresh."""
    if not again:
        (folder / "CMakeCache.txt").unlink(missing_ok=True)
        shutil.rmtree(folder / "CMakeFiles", ignore_errors=True)
        warn(f"configuring {relative(folder)}; the first build compiles all that the chapters share, which takes about a minute")
    done = subprocess.run(["cmake", "--preset", preset], cwd=ROOT, text=True, errors="replace", env=os.environ | SPEAKING,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, pass_fds=() if lock is None else (lock,))
    if done.returncode:
        warn(done.stdout.rstrip())
        raise Failure(f"cmake --preset {preset} failed")


def run_ninja(folder: Path, targets: list[str], lock: int, show, give_way, started) -> tuple[bool, bool]:
    """Whether there was something to do, and whether it is done. Two ninjas never build in one folder, even if we are
    killed: a ninja that outlives us holds the lock."""
    said = []
    ninja = subprocess.Popen(["ninja", "-C", folder, *targets], env=os.environ | SPEAKING | {"NINJA_STATUS": "[%f/%t] "}, text=True,
                             errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             pass_fds=(lock,))
    started(ninja)
    try:
        with ninja.stdout, Progress("building") as progress:
            skip = built = gave_way = False
            for line in ninja.stdout:
                status = STATUS.match(line)
                if skip:  # the command of the step that failed, some lines long on a screen
                    skip = False
                    continue
                skip = line.startswith("FAILED: ")
                if status:
                    note = line[status.end():].strip()
                    if not note.startswith(("Re-checking globbed", "Re-running CMake")):
                        built = True
                        (show or progress.show)(int(status[1]), int(status[2]), note.rsplit("/", 1)[-1])
                        if give_way() and not gave_way:
                            gave_way = True
                            ninja.terminate()
                elif not line.startswith(("ninja: Entering", "ninja: no work", "-- ")):
                    said.append(line)
                    progress.say(line.rstrip())
    except BaseException:
        ninja.terminate()  # and it ends its own children
        raise
    finally:
        code = ninja.wait()
    if code and (gave_way or give_way()):
        return built, False
    if code:
        failure = BuildFailure("the build failed")
        failure.said = "".join(said)
        raise failure
    return built, True
