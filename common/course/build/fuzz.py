"""Feeds broken files to the readers, with libFuzzer under the sanitizers.

A target is tests/FOLDER/fuzz/fuzz_NAME.cpp; its program is build/fuzz/tests/fuzz_NAME. Its seeds are
tests/FOLDER/corpus/NAME, which the ordinary tests replay; new inputs stay in build/fuzz/corpus/NAME.
"""

import subprocess
import time
from pathlib import Path

from build.build import build
from progress import Progress
from tree import ROOT, Failure, UsageError, relative, say

HELP = """Builds the fuzz targets with clang and runs each for its share of SECONDS (60).

Input that breaks a target is kept in build/fuzz/found. Correct the fault, and move the file to the target's corpus in tests,
so that the tests replay it. Exit code 1 if something was found."""


def add_arguments(parser):
    parser.add_argument("seconds", nargs="?", type=int, default=60, metavar="SECONDS")


def run(arguments, _rest) -> int:
    if arguments.seconds < 1:
        raise UsageError(f"{arguments.seconds} seconds is too short; give 1 or more")
    sources = sorted(ROOT.glob("tests/*/fuzz/fuzz_*.cpp"))
    if not sources:
        raise Failure("there is no tests/*/fuzz/fuzz_*.cpp")
    folder = build([source.stem for source in sources], preset="fuzz")
    seconds = max(arguments.seconds // len(sources), 1)
    broken = [source.stem for source in sources if not fuzz(folder, source, seconds)]
    say(f"{len(sources) - len(broken)} of {len(sources)} targets held" + (f"; not {', '.join(broken)}" if broken else ""))
    return 1 if broken else 0


def fuzz(folder: Path, source: Path, seconds: int) -> bool:
    """True where nothing was found."""
    name = source.stem.removeprefix("fuzz_")
    learned, found = folder / "corpus" / name, folder / "found"
    seeds = source.parents[1] / "corpus" / name
    for made in (learned, found):
        made.mkdir(parents=True, exist_ok=True)
    log = folder / f"{name}.log"
    before = set(found.iterdir())
    with open(log, "w", encoding="utf-8") as out:
        process = subprocess.Popen([folder / "tests" / source.stem, f"-max_total_time={seconds}", "-timeout=10",
                                    "-rss_limit_mb=2048", "-print_final_stats=1", f"-artifact_prefix={found}/{name}-",
                                    learned, *([seeds] if seeds.is_dir() else [])],
                                   cwd=ROOT, stdin=subprocess.DEVNULL, stdout=out, stderr=out)
        try:
            code = wait(process, name, seconds)
        except BaseException:
            process.terminate()
            process.wait()
            raise
    new = sorted(set(found.iterdir()) - before)
    lines = log.read_text(errors="replace", encoding="utf-8").splitlines()
    if not code:
        runs = [line.split()[-1] for line in lines if "executed_units" in line]
        say(f"{name}: {runs[0] if runs else '?'} runs, nothing found")
        return True
    what = next((line for line in lines if "ERROR" in line), "it failed")
    say(f"{name}: {what}\n  {', '.join(relative(path) for path in new) or 'no file kept'}; all it said: {relative(log)}")
    return False


def wait(process, name: str, seconds: int) -> int:
    start = time.monotonic()
    with Progress(name) as progress:
        while True:
            try:
                return process.wait(timeout=1)
            except subprocess.TimeoutExpired:
                progress.show(min(round(time.monotonic() - start), seconds), seconds, "s")
