"""clang-format over the C++ of the tree."""

import re
import shutil
import subprocess
from pathlib import Path

from tree import ROOT, Failure, files, say, warn

HELP = "Runs clang-format over the tree's C++, or with --check lists the files it would change."
VERSION = "14"  # Debian 12's; others lay out some things differently


def add_arguments(parser):
    parser.add_argument("--check", action="store_true", help="change nothing; exit code 1 if a file would change")


def run(arguments, _rest) -> int:
    if not formatter():
        raise Failure(f"there is no clang-format {VERSION} here; Debian 12 has it, and other versions "
                      "lay out some things differently")
    names = unformatted()
    if names and not arguments.check:
        done = subprocess.run([formatter(), "-i", *names], cwd=ROOT, stderr=subprocess.PIPE, text=True, errors="replace")
        if done.returncode:
            raise Failure(f"clang-format: {(done.stderr.strip().splitlines() or ['it said nothing'])[-1]}")
    for name in names:
        say(f"{'formatted' if not arguments.check else 'not formatted:'} {name}")
    if names and not arguments.check:  # lessons quote some of these lines
        return subprocess.run([ROOT / "course", "docs", "--quote"]).returncode
    return 1 if names and arguments.check else 0


def formatter() -> str | None:
    for name in (f"clang-format-{VERSION}", "clang-format"):
        if shutil.which(name):
            version = subprocess.run([name, "--version"], stdout=subprocess.PIPE, text=True, errors="replace").stdout
            if re.search(rf"version {VERSION}\.", version):
                return name
    return None


def unformatted() -> list[Path]:
    """The files that clang-format would change; none where there is no clang-format of our version."""
    names = [name for name in files() if name.suffix in (".cpp", ".h")]
    if not names:
        return []
    program = formatter()
    if not program:
        warn(f"no clang-format {VERSION} here: the layout of the code is not checked")
        return []
    done = subprocess.run([program, "--dry-run", *names], cwd=ROOT, stderr=subprocess.PIPE, text=True, errors="replace")
    changed = set(re.findall(r"^(.+?):\d+:\d+: warning: code should be clang-formatted", done.stderr, re.M))
    return [name for name in names if str(name) in changed]
