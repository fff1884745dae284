"""Capabilities of this machine, and missing ones."""

import contextlib
import os
import platform
import shutil
import subprocess
import sys
from pathlib import Path

from tree import BUILD, ROOT, chapter_program, chapters, relative, say

HELP = """Prints the versions of the tools, the Vulkan devices, the packages that a command would install, and the free disk space.
Include it when you report a problem."""
TOOLS = [["uname", "-sr"], ["c++", "--version"], ["cmake", "--version"], ["ninja", "--version"],
         [sys.executable, "--version"]]  # the one that runs the course, not the first in PATH
PACKAGES = ROOT / "common" / "course" / "packages"
NEEDS_GB = {"./course run": 1, "./course test": 2}  # of disk, packages not counted


def add_arguments(parser):
    pass


def run(_arguments, _rest) -> int:
    for command in TOOLS:
        say(f"{Path(command[0]).name:10} {first_line(command)}")
    say(f"{'display':10} {os.environ.get('WAYLAND_DISPLAY') or os.environ.get('DISPLAY') or 'none'}")
    say(f"{'disk':10} {disk()}")
    say(f"{'packages':10} {packages()}")
    program = chapter_program(chapters()[0])
    say(output([program, "--list", "devices"]) if program.exists() else "devices    ./course run builds what lists them")
    return 0


def disk() -> str:
    folder = BUILD if BUILD.exists() else ROOT
    free_gb = shutil.disk_usage(folder).free / 1e9
    short = [f"{command} needs {needed} GB" for command, needed in NEEDS_GB.items() if free_gb < needed]
    return f"{free_gb:.1f} GB free in {relative(folder) if folder != ROOT else ROOT}" + (f": too little, {', '.join(short)}" if short else "")


def packages() -> str:
    if not shutil.which("dpkg-query"):
        return "not a Debian system: the lists in common/course/packages say what is needed"
    here = names_here()
    groups = {path.name: [name for package in path.read_text(encoding="utf-8").split() if (name := here.get(package, package)) != "-"]
              for path in sorted(PACKAGES.iterdir())}
    named = sorted({package for group in groups.values() for package in group})
    asked = output(["dpkg-query", "-W", "-f", "${db:Status-Status} ${Package}\\n", *named])
    there = {line.split()[1] for line in asked.splitlines() if line.startswith("installed ")}
    missing = {name: [package for package in group if package not in there] for name, group in groups.items()}
    lines = [f"{name} lacks {' '.join(lacking)}" for name, lacking in missing.items() if lacking]
    return "all installed" if not lines else "missing\n" + "\n".join(f"{'':10} {line}" for line in lines)


def names_here() -> dict[str, str]:
    """What this system calls packages that Debian calls otherwise; "-" where it has none. As ./course reads it."""
    with contextlib.suppress(OSError):
        system = platform.freedesktop_os_release()
        rows = [line.split() for line in (PACKAGES.parent / "releases").read_text(encoding="utf-8").splitlines()]
        return {name: here for *release, name, here in rows if release == [system.get("ID"), system.get("VERSION_ID")]}
    return {}


def output(command: list) -> str:
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace", timeout=30).stdout.strip()
    except (OSError, subprocess.TimeoutExpired):
        return "none"


def first_line(command: list) -> str:
    return output(command).partition("\n")[0]
