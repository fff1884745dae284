"""Compiles a student's C++ in a sandbox, and tells the answer's mistakes from the machine's."""

import re
import shlex
import shutil
import signal
from pathlib import Path

from grading.judge_picture import ToolFailed
from grading.judge_tree import objects
from grading.sandbox import Limits
from tree import BUILD, ROOT

GIB = 1 << 30
COMPILER = Limits(3 * GIB, 30, processes=True)
# Tools' messages on a machine out of resources. An answer may print them too.
MACHINE = re.compile("No space left on device|Killed|[Oo]ut of memory|virtual memory exhausted|Cannot allocate memory|Too many open "
                     "files|Resource temporarily unavailable|Input/output error|quota exceeded|internal compiler error|Bus error")


def parts(chapter: str) -> list[Path]:
    """Objects linked with a student's object, except for the library. They precede it: of several definitions, the linker
    takes the first."""
    return [*objects("serve_main"), *objects(f"serve_{chapter}")]


def compile_answer(judge, exercise: str, source: Path) -> str:
    """Makes `worker` beside the source; returns the compiler's error. Raises ToolFailed."""
    chapter, place = judge.wanted[exercise], judge.paths[exercise]
    words = list(judge.commands[str(place)])
    words[words.index("-o") + 1] = "/grade/student.o"
    header = next(word for word in words if word.endswith("cmake_pch.hxx"))
    link = [words[0], *(["-fuse-ld=mold"] if shutil.which("mold") else []), "-o", "/grade/worker",
            *parts(chapter), "/grade/student.o", *judge.library(chapter), f"-L{BUILD}", "-llightwalk_check", "-llightwalk", "-lfmt",
            f"-Wl,-rpath,{BUILD}", "-Wl,--warn-unresolved-symbols"]
    # Which of the two has failed: a student's symbols may have any name.
    script = f"{shlex.join([*words, '-DLIGHTWALK_NO_SOLUTION', '-g0'])} || exit 3; {shlex.join(map(str, link))} || exit 4"
    mounts = judge.mounts()
    for path in (header, f"{header}.gch", *parts(chapter), *judge.library(chapter)):
        mounts.read(path)
    mounts.read(source, place)
    mounts.write(source.parent, Path("/grade"))
    with judge.started(["/bin/sh", "-c", script], mounts, COMPILER) as running:
        done = running.finish()
    name = str(place.relative_to(ROOT))
    endless = done.late or "CPU time limit exceeded" in done.out or done.code == 128 + signal.SIGXCPU
    if endless or done.long:
        said = "it does not compile: the compiler " + ("did not end" if endless else "complains without an end")
        if endless:
            raise ToolFailed(said)
        return said
    lines = done.out.replace(f"{ROOT}/", "").splitlines()
    # Missing symbols cannot be called: a reference, the truth, a main of its own.
    missing = [re.sub(r"^.*undefined (?:symbol|reference to)[: ]*", "", line) for i, line in enumerate(lines)
               if "undefined" in line and "student.o" in "".join(lines[max(i - 1, 0):i + 3])]
    if missing:
        return f"it does not link: there is no {missing[0]}"
    if done.code not in (0, 3, 4):
        raise ToolFailed(f"it does not compile: the compiler ended with {done.code}")
    if done.code:
        errors = [line for line in lines if "error" in line]
        what = errors[0] if errors else lines[-1] if lines else f"the compiler ended with {done.code}, without a word"
        said = f"it does not link: {what}" if done.code == 4 else \
            f"it does not compile: {name + what.partition(name)[2] if name in what else what}"
        located = any(re.match(rf"{re.escape(name)}:\d+:\d+: (fatal )?error: ", line) for line in lines)
        if done.code == 4 or not located or MACHINE.search(done.out):
            raise ToolFailed(said)
        return said
    return ""
