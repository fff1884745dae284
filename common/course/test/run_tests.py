"""Builds the tests' programs, runs them, writes the report."""

import json
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from build.build import build
from many import shards
from pages.report import write_report
from test.container import test_on
from test.needs import NOTHING, build_for, selected
from test.reached import is_of_chapters, reached
from test.suites import EVERY_COMMIT, branch_base, changed_since, concerned, times
from tree import BUILD, ROOT, Failure, UsageError, chapters, relative, say, write_atomically

ALONE = True
HELP = """Builds what the tests need, runs them and writes build/report/index.html.

  ./course test                  what a person runs before a commit, and a CI on each: suites first and engine
  ./course test --all            all four suites, as before a release
  ./course test -L platform      one suite; other options are passed to ctest as well
  ./course test shots.02         the tests whose name matches this regular expression
  ./course test --changed [COMMIT]    the tests of first and engine that the files changed since then reach, by includes, shaders,
                                 shots and scenes, and those of platform that they concern; by default since the branch left
                                 the main one, on that since its parent. Where no more than chapters has changed, of platform
                                 theirs alone.
  ./course test --with-changed [COMMIT]    all of first and engine, and those of platform that these files concern, if they are
                                 few
  ./course test --sanitize       these tests under the sanitizers of addresses and of undefined behaviour
  ./course test --shard 3/16 --out F    part 3 of 16, into the folder F, for a CI's matrix; --merge F writes the report of all
  ./course test --device NAME    every shot and every check on one device, such as a graphics card (hardware), within limits of
                                 its own; --against FILE compares with an earlier run, and --device --help says more
  ./course test --on trixie      ./course run, docs, serve and test on a bare Debian 13, in a container in build/on/trixie;
                                 bookworm is Debian 12. A pattern or options select tests. It requires root.

The suites, by what they prove (tests/suites.txt lists their tests):
  first      all that a newcomer sees is right: programs, checks on the references, pictures, shaders, links
  engine     all that draws: units, stability, equal methods, wrong answers are rejected
  platform   what stands around the chapters: pages, live pages, grading, the command, windows
  field      studies, need rules, figures of lessons, all knobs, wrong pictures, other systems, drivers and browsers

The last line counts all tests that ran; the lines before say how long each suite took, which tests were slowest, and which
took over a minute without a reason in tests/suites.txt."""
PASSES_OPTIONS = True
FEW = 16  # tests of platform beside first and engine: about four minutes
MANY = 40  # tests whose names would fill the screen
RASTER_THREADS = "LP_NUM_THREADS"  # lavapipe's: 0 draws in the thread that asks


def add_arguments(parser):
    parser.usage = ("./course test [PATTERN | --all | --changed [COMMIT] | --with-changed [COMMIT] | --device NAME] [--on SYSTEM] [--sanitize] [--shard K/N [--out FOLDER]] "
                    "[--merge FILE...] [OPTIONS OF CTEST]")
    parser.add_argument("--all", action="store_true", help="all four suites")
    parser.add_argument("--changed", nargs="?", const="", metavar="COMMIT", help="the tests that changed files reach")
    parser.add_argument("--with-changed", nargs="?", const="", metavar="COMMIT", help="first, engine, and what changed files concern")
    parser.add_argument("--on", metavar="SYSTEM", help="test on a bare bookworm or trixie, in a container")
    shards.add_arguments(parser)
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for the file of a shard (build/shards)")
    parser.add_argument("--sanitize", action="store_true", help="run the tests under the sanitizers")


def run(arguments, rest) -> int:
    shards.check_arguments(arguments)
    # The word behind an option of ctest's is that option's: Python's releases disagree on that.
    pattern = rest[0] if rest and not rest[0].startswith("-") else None
    if pattern:
        try:
            re.compile(pattern)
        except re.error as error:
            raise UsageError(f"'{pattern}' is not a regular expression: {error}") from None
        if rest[1:] and not rest[1].startswith("-"):
            raise UsageError(f"one regular expression selects the tests: '{pattern}|{rest[1]}' matches both")
    said = [word for word, given in ((pattern, pattern), ("--all", arguments.all), ("--changed", arguments.changed is not None),
                                     ("--with-changed", arguments.with_changed is not None)) if given]
    if len(said) > 1:
        raise UsageError(f"{said[0]} and {said[1]} each say which tests are run: one of them")
    if arguments.merge:
        if said or rest or arguments.on or arguments.sanitize:
            raise UsageError("--merge writes the report of tests that were run: leave out what else was given")
        return merge_shards(arguments.merge)
    if arguments.on and arguments.shard:
        raise UsageError("--shard is of this system's tests: --on has none")
    if arguments.on and "changed" in "".join(said):
        raise UsageError(f"{said[0]} is of this system's tests: --on has none")
    if arguments.on:
        return test_on(arguments.on, rest + ["--sanitize"] * arguments.sanitize + ["--all"] * arguments.all)
    selection = ["-R", *rest] if pattern else rest
    results = BUILD / "results"
    file = shards.file_of(arguments.out, "test", arguments.shard) if arguments.shard else None
    if not selection or file:
        shutil.rmtree(results, ignore_errors=True)
    results.mkdir(parents=True, exist_ok=True)
    if not selection:  # as many programs as processors draw: threads of the rasteriser's own cost 3 to 18% of their time, and gain nothing
        os.environ.setdefault(RASTER_THREADS, "0")
    if not selection and not arguments.all:
        given = arguments.changed if arguments.changed is not None else arguments.with_changed
        selection = EVERY_COMMIT if given is None else of_changes(given, reduced=arguments.changed is not None)

    preset, junit = ("sanitizer", results / "sanitizer.xml") if arguments.sanitize else ("default", results / "tests.xml")
    folder, options = build_for(selection, lambda *asked: shard_words(*asked, arguments.shard), preset, also=["every_shader"] if arguments.all else [])
    total, failed = run_ctest(folder, junit, options)
    for line in times(junit, with_reasons=not arguments.sanitize) if total else []:
        say(line)
    if file:
        return write_shard(file, arguments.shard, results, total, failed, rest)
    report = BUILD / "report" / "index.html"
    write_report(results, report)
    if not total:
        raise UsageError(f"no test matches {' '.join(selection)}; ctest --test-dir build -N lists them")
    say(f"\nreport: {relative(report)}")
    say(closing_line(total, failed))
    return 1 if failed else 0


def of_changes(commit: str, reduced: bool) -> list[str]:
    """ctest's options for the tests that the files changed since a commit reach or concern, which two lines say. Not reduced: all
    of first and engine, and of platform only a few."""
    files = changed_since(since := commit or branch_base())
    if commit and files is None:
        raise UsageError(f"--changed {commit}: git knows no such commit")
    folder = build(NOTHING)
    more = concerned([name for _, name in selected(folder, ["-L", "^platform$"])], files)
    if reduced and files is not None and is_of_chapters(files):
        more, left = [[test for test in more if bool(set(test.split(".")) & set(chapters())) == own] for own in (True, False)]
        if left:
            say(f"left to ./course test -L platform, as no more than chapters has changed: {' '.join(left)}")
    why = f"changes since {since} concern" if files is not None else f"git knows no {since}, so these are all"
    too_many = not reduced and len(more) > FEW
    say(f"platform: {why} {len(more)} tests" + (": " + " ".join(more) if more else "") +
        (", more than a run of each commit has time for: ./course test -L platform" if too_many else ""))
    if too_many:
        more = []
    every = [name for _, name in selected(folder, EVERY_COMMIT)]
    if files is not None and reduced:
        every = reached(every, files)
    say(f"first and engine: {len(every)} tests" + (": " + " ".join(every) if len(every) < MANY else ""))
    return ["-R", f"^({'|'.join(map(re.escape, [*every, *more]))})$"]


def run_ctest(folder: Path, junit: Path, selection: list[str]) -> tuple[int, int]:
    junit.unlink(missing_ok=True)
    # One more than there are processors: windows wait more than they work.
    command = ["ctest", "--test-dir", str(folder), "--output-on-failure", "--no-label-summary", "-j", str((os.cpu_count() or 1) + 1),
               "--output-junit", str(junit), *(["--progress"] if sys.stdout.isatty() else []), *selection]
    code = subprocess.run(command, stdin=subprocess.DEVNULL).returncode
    if not junit.exists():
        if code:
            raise Failure(f"{' '.join(command)} ended with {code}")
        return 0, 0
    suite = xml.parse(junit).getroot()
    total, failed = int(suite.get("tests")), int(suite.get("failures"))
    if code and not failed:
        raise Failure(f"{' '.join(command)} ended with {code} although no test failed")
    return total, failed


def shard_words(folder: Path, selection: list[str], shard: shards.Shard | None) -> list[str]:
    """ctest's options for a shard's tests of a selection; nothing without a shard."""
    if not shard:
        return []
    count = len(selected(folder, selection))
    if not count:
        raise UsageError(f"no test matches {' '.join(selection)}; ctest --test-dir build -N lists them")
    # Every Nth of the selected tests; a start behind the last one would run them all.
    return ["-I", f"{shard.number},,{shard.of}"] if shard.number <= count else ["-E", "."]


def write_shard(file: Path, shard: shards.Shard, results: Path, total: int, failed: int, selection: list[str]) -> int:
    """Packs the results of a shard's tests with the pictures they name. The exit code."""
    entries, pictures = {}, {}
    for path in sorted(results.iterdir()):
        if path.suffix == ".json":
            entries[path.name] = json.loads(path.read_text(encoding="utf-8"))
            for one in entries[path.name].get("pictures") or []:
                for name in filter(None, (one.get("actual"), one.get("heatmap"))):
                    pictures[name] = ROOT / name
        elif path.suffix == ".xml":
            entries[f"{path.stem}.{shard.number}-of-{shard.of}.xml"] = path.read_text(encoding="utf-8")
    head = {"selection": selection, "course": shards.course_version(), "counts": [total, failed]}
    shards.write(file, "test", shard, head, entries, {name: path for name, path in pictures.items() if path.exists()})
    say(f"\n{relative(file)}: {total} tests of shard {shard}")
    say(closing_line(total, failed))
    return 1 if failed else 0


def merge_shards(paths: list[Path]) -> int:
    made = shards.merge(paths, "test", per_shard=("counts",))
    results = BUILD / "results"
    shutil.rmtree(results, ignore_errors=True)
    for name, entry in made.entries.items():
        if Path(name).name != name:
            raise UsageError(f"{made.came_from[name]}: '{name}' is no result")
        write_atomically(results / name, entry if isinstance(entry, str) else json.dumps(entry, indent=1) + "\n")
        for one in (entry.get("pictures") or []) if isinstance(entry, dict) else []:
            for picture in filter(None, (one.get("actual"), one.get("heatmap"))):
                parts = Path(picture).parts
                if parts[0] == "build" and ".." not in parts and made.has_file(name, picture):
                    write_atomically(ROOT / picture, made.file(name, picture))
    report = BUILD / "report" / "index.html"
    write_report(results, report)
    total, failed = (sum(counts) for counts in zip(*made.head["counts"]))
    say(f"report: {relative(report)}")
    say(closing_line(total, failed))
    return 1 if failed else 0


def closing_line(total: int, failed: int) -> str:
    """ctest's closing line over all runs, for a CI to read."""
    percent = round(100 * (total - failed) / max(total, 1))
    return f"{min(percent, 99) if failed else 100}% tests passed, {failed} tests failed out of {total}"
