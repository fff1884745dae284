"""What this machine has."""

import os
import subprocess

from tree import chapter_program, chapters, say

HELP = "Prints the versions of the tools and the Vulkan devices. Include them when you report a problem."
TOOLS = [["uname", "-sr"], ["c++", "--version"], ["cmake", "--version"], ["ninja", "--version"],
         ["python3", "--version"]]


def add_arguments(parser):
    pass


def run(_arguments, _rest) -> int:
    for command in TOOLS:
        say(f"{command[0]:10} {first_line(command)}")
    say(f"{'display':10} {os.environ.get('WAYLAND_DISPLAY') or os.environ.get('DISPLAY') or 'none'}")
    program = chapter_program(chapters()[0])
    say(output([program, "--list", "devices"]) if program.exists() else "devices    ./course run builds what lists them")
    return 0


def output(command: list) -> str:
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=30).stdout.strip()
    except (OSError, subprocess.TimeoutExpired):
        return "none"


def first_line(command: list) -> str:
    return output(command).partition("\n")[0]
