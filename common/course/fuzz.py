"""Feeds broken files to what reads files, with libFuzzer under the sanitizers.

Each target is a program build/fuzz/fuzz_NAME (target `fuzzers` builds them all). Its seeds are tests/common/corpus/NAME,
which the ordinary tests replay; what it learns stays in build/fuzz/corpus/NAME.
"""

import os
import subprocess
import sys
import time

from build import build
from tree import ROOT, Failure, UsageError, relative, say

HELP = """Builds the fuzz targets with clang and runs each for its share of SECONDS (60).

What breaks one is kept in build/fuzz/found: mend it, and move the file to tests/common/corpus/NAME so that the tests
replay it. Exit code 1 if something was found."""


def add_arguments(parser):
    parser.add_argument("seconds", nargs="?", type=int, default=60, metavar="SECONDS")


def run(arguments, _rest) -> int:
    if arguments.seconds < 1:
        raise UsageError(f"{arguments.seconds} seconds is no time to fuzz; give 1 or more")
    folder = build(["fuzzers"], preset="fuzz")
    programs = sorted(path for path in folder.glob("fuzz_*") if os.access(path, os.X_OK) and path.is_file())
    if not programs:
        raise Failure(f"{relative(folder)} holds no fuzz_*")
    broken = [program.name for program in programs if not fuzz(program, max(arguments.seconds // len(programs), 1))]
    say(f"{len(programs) - len(broken)} of {len(programs)} targets held" + (f"; not {', '.join(broken)}" if broken else ""))
    return 1 if broken else 0


def fuzz(program, seconds: int) -> bool:
    """True where nothing was found."""
    name = program.name.removeprefix("fuzz_")
    learned, found = program.parent / "corpus" / name, program.parent / "found"
    seeds = ROOT / "tests" / "common" / "corpus" / name
    for folder in (learned, found):
        folder.mkdir(parents=True, exist_ok=True)
    log = program.parent / f"{name}.log"
    before = set(found.iterdir())
    with open(log, "w") as out:
        process = subprocess.Popen([program, f"-max_total_time={seconds}", "-timeout=10", "-rss_limit_mb=2048",
                                    "-print_final_stats=1", f"-artifact_prefix={found}/{name}-", learned,
                                    *([seeds] if seeds.is_dir() else [])],
                                   cwd=ROOT, stdin=subprocess.DEVNULL, stdout=out, stderr=out)
        try:
            code = wait(process, name, seconds)
        except KeyboardInterrupt:
            process.wait()
            raise
    new = sorted(set(found.iterdir()) - before)
    if not code:
        runs = [line.split()[-1] for line in log.read_text(errors="replace").splitlines() if "executed_units" in line]
        say(f"{name}: {runs[0] if runs else '?'} runs, nothing found")
        return True
    what = next((line for line in log.read_text(errors="replace").splitlines() if "ERROR" in line), "it failed")
    say(f"{name}: {what}\n  {', '.join(relative(path) for path in new) or 'no file kept'}; all it said: {relative(log)}")
    return False


def wait(process, name: str, seconds: int) -> int:
    """Until it ends, with the seconds counted on a terminal."""
    start = time.monotonic()
    while True:
        try:
            return process.wait(timeout=1)
        except subprocess.TimeoutExpired:
            if sys.stderr.isatty():
                print(f"\r{name}: {time.monotonic() - start:.0f} of {seconds} s\033[K\r", end="", file=sys.stderr, flush=True)
