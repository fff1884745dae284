"""Measures what chapters teach and draws the charts: time against error."""

import re
import subprocess
import sys
from pathlib import Path

from build import build
from tree import BUILD, ROOT, Failure, UsageError, chapter_program, chapters, find_chapter, relative, say

HELP = """Measures every method of a chapter against the truth and draws the chart, as SVG and PNG, with a table.

  ./course study                   every chapter that has a study
  ./course study 02                one
  ./course study 02 --device H200 --out docs/studies

An interrupted study goes on where it was when it is started again. Times mean something on a machine that does nothing
else; those of a software driver are labelled as the CPU's."""


def add_arguments(parser):
    parser.add_argument("chapter", nargs="?", metavar="NN", help="its number or its name")
    parser.add_argument("--device", help="part of a device's name: ./course run 01 --list devices")
    parser.add_argument("--out", type=Path, default=BUILD / "studies", metavar="FOLDER",
                        help="where the JSON, the charts and the table go (build/studies)")


def run(arguments, _rest) -> int:
    studied = [name for name in chapters() if (ROOT / "chapters" / name / "study.json").exists()]
    named = [find_chapter(arguments.chapter)] if arguments.chapter else studied
    for chapter in named:
        if chapter not in studied:
            raise UsageError(f"chapter {chapter} has no study; there are {', '.join(studied) or 'none'}")
    build(named)
    folder = arguments.out.absolute()
    folder.mkdir(parents=True, exist_ok=True)
    for chapter in named:
        device = f"_{re.sub(r'[^a-z0-9]+', '_', arguments.device.lower())}" if arguments.device else ""
        file = folder / f"{chapter}{device}.json"
        options = ["--device", arguments.device] if arguments.device else []
        # Its own progress goes to the terminal.
        measured = subprocess.run([chapter_program(chapter), "--study", file, *options], cwd=ROOT)
        if measured.returncode:
            raise Failure(f"the study of {chapter} ended with {measured.returncode}")
        if subprocess.run([sys.executable, ROOT / "common/course/chart.py", file]).returncode:
            raise Failure(f"the chart of {chapter} was not drawn")
        say(f"{relative(file)}; {relative(file.with_suffix('.svg'))}")
    return 0
