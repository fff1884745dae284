"""Builds the tests' programs, runs them, writes the report."""

import json
import os
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as xml
from pathlib import Path

from many import shards
from pages.report import write_report
from test import test_shards
from test.container import test_on
from test.needs import build_for
from test.test_shards import closing_line
from tree import BUILD, RUN, Failure, UsageError, chapters, git, relative, say, write_atomically

ALONE = True
HELP = """Builds what the tests need, runs them and writes build/report/index.html.

  ./course test                  what a person runs before a commit, and a CI on each
  ./course test --all            everything, as before a release
  ./course test shot.02          the tests whose name matches this regular expression
  ./course test --sanitize       these tests, then those without windows and texts once more under the sanitizers of
                                 addresses and of undefined behaviour
  ./course test -L window        other options are passed to ctest
  ./course test --shard 3/16 --out F    part 3 of 16, into the folder F, for a CI's matrix; --merge F writes the report of all
  ./course test --on trixie      ./course run, docs, serve and test on a bare Debian 13, in a container in build/on/trixie;
                                 bookworm is Debian 12. A pattern or options select tests. It requires root.

Without --all the tests that draw most are left out (studies, need rules, stretch tasks, the goldens' rejections, all knobs)
and those in Firefox, only one chart of a chapter and one page of each kind are checked, and of wrong answers to exercises, attacks on grading,
charts, equal methods, random scenes, sites, shards, what is kept from frame to frame and lessons on a phone a part is tried,
another with each commit. The last line counts all tests that ran."""
PASSES_OPTIONS = True
RASTER_THREADS = "LP_NUM_THREADS"  # lavapipe's: 0 draws in the thread that asks
STUDIES = ["-LE", "study"]
SANITIZED = ["-LE", "window|text|study"]  # studies draw the same pictures as shots, many times
LEFT_OUT = r"^teeth\.[0-9]+\.|common\.knobs\.|\.(need|stretch|newcomer|window_built|page_firefox)$"
SHARE = 4  # variants of answers are tried in one chapter of so many
# The longest tests take turns: a commit runs those of one line.
TURNS = ("equal_methods|live_rest|course_shards|window_passes|window_tour|random_scenes",
         "grade_forged|window_fields|autograder|live_links|grade_trouble",
         "grade_user|page_start|grade_shards|window_properties",
         "page_site|course_new|window_panels|film_slurm|page_verdicts",
         "window_session|grade_later|warm|grade_slurm|course_trouble",
         "window_film|window_files|window_monkey|page_pictures")


def add_arguments(parser):
    parser.usage = "./course test [PATTERN | --all] [--on SYSTEM] [--sanitize] [--shard K/N [--out FOLDER]] [--merge FILE...] [OPTIONS OF CTEST]"
    parser.add_argument("--all", action="store_true", help="every test: studies, needs, teeth, all knobs, all pages")
    parser.add_argument("--on", metavar="SYSTEM", help="test on a bare bookworm or trixie, in a container")
    shards.add_arguments(parser)
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for the file of a shard (build/shards)")
    parser.add_argument("--sanitize", action="store_true", help="then run those without windows and texts once more under the sanitizers")


def run(arguments, rest) -> int:
    shards.check_arguments(arguments)
    if arguments.merge:
        return test_shards.merge(arguments.merge)
    # The word behind an option of ctest's is that option's: Python's releases disagree on that.
    pattern = rest[0] if rest and not rest[0].startswith("-") else None
    if pattern:
        try:
            re.compile(pattern)
        except re.error as error:
            raise UsageError(f"'{pattern}' is not a regular expression: {error}") from None
    if arguments.on and arguments.shard:
        raise UsageError("--shard is of this system's tests: --on has none")
    if arguments.on:
        return test_on(arguments.on, rest + ["--sanitize"] * arguments.sanitize + ["--all"] * arguments.all)
    selection = ["-R", *rest] if pattern else rest
    results = BUILD / "results"
    file = shards.file_of(arguments.out, "test", arguments.shard) if arguments.shard else None
    if not selection or file:
        shutil.rmtree(results, ignore_errors=True)
    results.mkdir(parents=True, exist_ok=True)
    in_part = not arguments.all and not selection
    tries_part = not arguments.all and (in_part or os.environ.get("CI") == "true")
    if not selection:  # as many programs as processors draw: threads of the rasteriser's own cost 3 to 18% of their time, and gain nothing
        os.environ.setdefault(RASTER_THREADS, "0")
    selection = part() if in_part else selection

    def of_shard(folder, chosen):
        return test_shards.words(folder, chosen, arguments.shard)

    folder, options = build_for(selection, of_shard, also=["every_shader"] if arguments.all else [])
    runs = [run_ctest(folder, results / "tests.xml", options, tries_part)]
    if arguments.sanitize:
        say("\nunder the sanitizers:")
        folder, options = build_for(SANITIZED + (selection[len(STUDIES):] if in_part else selection), of_shard, "sanitizer")
        runs.append(run_ctest(folder, results / "sanitizer.xml", options, tries_part))
    if file:
        return test_shards.write(file, arguments.shard, results, runs, rest)
    report = BUILD / "report" / "index.html"
    write_report(results, report)
    total, failed = (sum(counts) for counts in zip(*runs))
    if not total:
        raise UsageError(f"no test matches {' '.join(selection)}; ctest --test-dir build -N lists them")
    say(f"\nreport: {relative(report)}")
    say(closing_line(total, failed))
    return 1 if failed else 0


def chosen(commit: int) -> tuple[int, int]:
    """(a line of TURNS, which of SHARE parts of the chapters have their wrong answers tried). By other digits than those by
    which a test chooses cases (tests/common/part_in_ci.py): with the same ones a line would always try the same cases."""
    return (commit >> 128) % len(TURNS), (commit >> 96) % SHARE


def part() -> list[str]:
    """ctest's options for the tests of a run without --all, chosen by the commit."""
    try:
        turn, share = chosen(int(git("rev-parse", "HEAD"), 16))
    except (Failure, ValueError):
        turn, share = 0, 0
    others = [chapter[:2] for i, chapter in enumerate(chapters()) if i % SHARE != share]
    waiting = "|".join(tests for i, tests in enumerate(TURNS) if i != turn)
    return [*STUDIES, "-E", LEFT_OUT + rf"|\.({waiting})$" + (rf"|^variants\.({'|'.join(others)})$" if others else "")]


def run_ctest(folder: Path, junit: Path, selection: list[str], tries_part: bool) -> tuple[int, int]:
    """(tests, failures). Raises Failure where ctest itself failed."""
    junit.unlink(missing_ok=True)
    # One more than there are processors: windows wait more than they work.
    write_atomically(folder / RUN, json.dumps({"pid": os.getpid(), "name": f"{os.getpid()} {time.time()}", "part": tries_part}) + "\n")
    command = ["ctest", "--test-dir", str(folder), "--output-on-failure", "-j", str((os.cpu_count() or 1) + 1),
               "--output-junit", str(junit), *(["--progress"] if sys.stdout.isatty() else []), *selection]
    code = subprocess.run(command, stdin=subprocess.DEVNULL).returncode
    (folder / RUN).unlink(missing_ok=True)
    if not junit.exists():
        if code:
            raise Failure(f"{' '.join(command)} ended with {code}")
        return 0, 0
    suite = xml.parse(junit).getroot()
    total, failed = int(suite.get("tests")), int(suite.get("failures"))
    if code and not failed:
        raise Failure(f"{' '.join(command)} ended with {code} although no test failed")
    return total, failed
