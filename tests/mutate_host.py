"""Breaks lines of the C++ one at a time and asks whether a test notices. By hand, not by ctest, on a finished build:

    python3 tests/mutate_host.py [--count 60] [--file common/gpu] [--chapters 03,04]

The lines are those of common/gpu, common/scene, common/measure and the chapters (not of their exercises, which have
variants of their own); --count takes so many of their changes, evenly spread. One file is recompiled, linked into a
copy of the build folder that is links but for what changed, and the tests of what it belongs to are run there: the unit
tests of common and of the chapters asked for (every one by default), their checks, their shots against the goldens, their
Python tests. The verdicts are those of mutate.py; what changes no picture, no probe and fails no test counts as equivalent.
"""
import argparse
import collections
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "common" / "course"), str(ROOT / "tests")]
from mutate import TIMEOUT_S, Bench  # noqa: E402
from mutations import host_changes  # noqa: E402
from tree import BUILD, Failure, chapters, find_chapter, say, warn  # noqa: E402

FOLDERS = ("common/gpu", "common/scene", "common/measure", "chapters")
COMMON, CHECK = "liblightwalk.so", "liblightwalk_check.so"


def mutants(only: str):
    """(file, line number, the change, the changed line, the whole changed text)"""
    for path in sorted(p for folder in FOLDERS for p in (ROOT / folder).rglob("*.cpp")):
        file = path.relative_to(ROOT)
        if only not in str(file) or path.stem.endswith("_main") or path.parent.name in ("exercise", "solution"):
            continue
        lines = path.read_text().splitlines()
        for number, line in enumerate(lines):
            for what, changed in host_changes(line):
                if changed != line:
                    yield file, number + 1, what, changed.strip(), "\n".join([*lines[:number], changed, *lines[number + 1:]]) + "\n"


class HostBench:
    """A copy of the build folder in which one object may be another."""

    def __init__(self, names: list[str], folder: pathlib.Path):
        self.names, self.folder, self.build = names, folder, folder / "build"
        self.compile = {}  # of each file: the command, and its inputs, possibly several files
        for entry in json.loads((BUILD / "compile_commands.json").read_text()):
            unit = pathlib.Path(entry["file"]).resolve()
            together = re.findall('#include "(.*)"', unit.read_text()) if "Unity" in unit.parts else [unit]
            self.compile |= {pathlib.Path(file).resolve(): (entry["command"], unit) for file in together}
        self.links: dict[str, str] = {}
        self.fresh()
        self.benches = {}
        for name in names:
            (folder / name).mkdir()
            self.benches[name] = Bench(name, folder / name, self.build)
        if failed := self.common_fails():
            raise Failure(f"without any change: {failed}")

    def prove(self, file: pathlib.Path):
        """A file that is compiled and linked again without a change changes nothing."""
        verdict, by = self.judge(file, (ROOT / file).read_text())
        if verdict != "equivalent":
            raise Failure(f"{file} without any change: {verdict} {by}")

    def fresh(self):
        """Everything is a link to the real build folder."""
        shutil.rmtree(self.build, ignore_errors=True)
        for inner in (self.build, self.build / "chapters", self.build / "tests"):
            inner.mkdir()
            for entry in (BUILD / inner.relative_to(self.build)).iterdir():
                if entry.name not in ("chapters", "tests") or inner != self.build:
                    (inner / entry.name).symlink_to(entry)

    def link(self, target: str, made: pathlib.Path, instead_of: str, archive: str):
        """Links a target again: the object takes its namesake's place, or comes before the archive that holds that."""
        if target not in self.links:
            said = subprocess.run(["ninja", "-C", str(BUILD), "-t", "commands", target], capture_output=True, text=True)
            self.links[target] = said.stdout.splitlines()[-1]
        command = self.links[target]
        held = instead_of.partition("/")[2].startswith(f"{archive[3:-2]}.dir/")
        old, new = (archive, f"{made} {archive}") if held and f" {instead_of}" not in command else (instead_of, made)
        if f" {old}" not in command:
            return  # a main.cpp is in one program alone
        command = command.replace(f" {old}", f" {new}", 1)
        (self.build / target).unlink()
        command = re.sub(rf"-o {re.escape(target)}(?= )", f"-o {self.build / target}", command)
        subprocess.run(command, shell=True, cwd=BUILD, check=True, capture_output=True)

    def make(self, file: pathlib.Path, text: str) -> bool:
        """Whether the changed file compiles; then the programs that hold it are there."""
        command, unit = self.compile.get(ROOT / file, (None, None))
        if command is None:
            return False
        words = [word for word in shlex.split(command) if word != "-Werror"]
        instead_of = words[words.index("-o") + 1]
        made, changed = self.folder / "changed.o", self.folder / file.name
        changed.write_text(text)
        if unit != ROOT / file:
            (self.folder / "unit.cpp").write_text(unit.read_text().replace(f'"{ROOT / file}"', f'"{changed}"'))
            changed = self.folder / "unit.cpp"
        words[words.index("-o") + 1] = str(made)
        words[words.index("-c") + 1:] = [str(changed)]
        words[1:1] = ["-iquote", str((ROOT / file).parent), "-w"]
        if subprocess.run(words, cwd=BUILD, capture_output=True).returncode:
            return False
        self.fresh()
        if file.parts[0] == "common":
            targets = [CHECK if file.parts[1] in ("check", "judge") else COMMON]
        else:
            targets = [f"{kind}{name}" for name in self.names if name >= file.parts[1]
                       for kind in ("chapters/", "tests/test_", "tests/check_") if (BUILD / f"{kind}{name}").exists()]
        for target in targets:
            self.link(target, made, instead_of, f"libchapter_{file.parts[1]}.a")
        return True

    def common_fails(self):
        """Failures of common's own tests, or ""."""
        failed, _ = next(iter(self.benches.values())).test("test_common", ["--abort", "~*speed*"])
        return failed

    def judge(self, file: pathlib.Path, text: str):
        """(verdict, its source)"""
        try:
            if not self.make(file, text):
                return "invalid", ""
        except subprocess.CalledProcessError:
            return "invalid", "does not link"
        if file.parts[0] == "common" and (failed := self.common_fails()):
            return "caught", failed.strip().splitlines()[-1]
        differs = []
        for name, bench in self.benches.items():
            if file.parts[0] == "chapters" and name < file.parts[1]:
                continue
            verdict, by = bench.verdict()
            if verdict == "caught":
                return verdict, by
            if verdict == "survived":
                differs.append(by)
        return ("survived", "; ".join(differs)) if differs else ("equivalent", "")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=60, help="so many, evenly spread; 0: all")
    parser.add_argument("--file", default="", help="only files with this in their path")
    parser.add_argument("--chapters", default="", help="judged by these alone, such as 03,04; default: all")
    given = parser.parse_args()
    names = [find_chapter(word) for word in given.chapters.split(",") if word] or chapters()
    chosen = list(mutants(given.file))
    if 0 < given.count < len(chosen):
        chosen = [chosen[i * len(chosen) // given.count] for i in range(given.count)]
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        bench = HostBench(names, pathlib.Path(folder))
        for kind in ("common", "chapters"):
            if files := [file for file, *_ in chosen if file.parts[0] == kind]:
                bench.prove(files[-1])
        for file, line, what, changed, text in chosen:
            try:
                verdict, by = bench.judge(file, text)
            except subprocess.TimeoutExpired:
                verdict, by = "caught", f"no end within {TIMEOUT_S} s"
            counts[verdict] += 1
            say(f"{verdict:10} {file}:{line:<3} {what:38} {by if verdict != 'survived' else changed + '   ' + by}")
    told = counts["caught"] + counts["survived"]
    say(f"{sum(counts.values())} changes: {counts['invalid']} do not compile, {counts['equivalent']} change nothing; "
        f"of the other {told}, {counts['caught']} caught ({100 * counts['caught'] / max(told, 1):.1f} %)")
    return 1 if counts["survived"] else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failure as failure:
        warn(f"mutate_host: {failure}")
        sys.exit(1)
