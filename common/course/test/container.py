"""./course test --on trixie: a newcomer's commands on a bare Debian of another release, in a container of its own.

The system is debootstrap's smallest; bubblewrap makes its folder the root of a process that sees nothing else of this
machine but the network. ./course installs there what it needs, as on a student's machine. All of it stays in
build/on/SYSTEM, packages, compiler cache and build folder, so that the next run builds only changes.
"""

import filecmp
import os
import shutil
import subprocess
from pathlib import Path

from tree import BUILD, ROOT, UsageError, files, git, relative, walk, warn

SYSTEMS = {"bookworm": "Debian 12", "trixie": "Debian 13"}
MIRROR = "http://deb.debian.org/debian"
TREE = "/srv/lightwalk"  # the course, in there


def test_on(system: str, words: list[str]) -> int:
    """Runs a newcomer's commands, each with only its own packages and earlier ones, or, with words (a pattern, ctest's
    options), that test alone. Its exit code."""
    require(system)
    root = BUILD / "on" / system / "root"
    make_system(system, root)
    copy_tree(root / TREE[1:])
    for command in ([["run"], ["docs"], ["serve", "--port", "0"], ["test"]] if not words else [["test", *words]]):
        warn(f"on {SYSTEMS[system]}: ./course {' '.join(command)}")
        there = contained(root, ["./course", *command])
        code = serves(there) if command[0] == "serve" else subprocess.run(there, stdin=subprocess.DEVNULL).returncode
        if code:
            return code
    return 0


def serves(command: list[str]) -> int:
    """Starts the server and ends it once it has printed its address. 0, or its exit code where it never does."""
    server = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, errors="replace")
    with server.stdout:
        is_there = any(line.startswith("http://") for line in server.stdout)
    server.terminate()
    code = server.wait()
    return 0 if is_there else code or 1


def require(system: str):
    """Raises UsageError where this machine cannot have such a container."""
    if system not in SYSTEMS:
        raise UsageError(f"'{system}' is not a system to test on; there are {', '.join(SYSTEMS)}")
    if os.geteuid() != 0:
        raise UsageError("only root can make a container of another system: sudo ./course test --on " + system)
    for program, package in (("debootstrap", "debootstrap"), ("bwrap", "bubblewrap")):
        if not shutil.which(program):
            raise UsageError(f"there is no {program} to make a container with: apt-get install {package}")


def make_system(system: str, root: Path):
    """Makes it where there is none, or one that an interrupted run has left with packages half installed. Raises UsageError with
    debootstrap's reason: no network, no space."""
    if root.exists() and not subprocess.run(contained(root, ["dpkg", "--audit"], "/"), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE).stdout:
        return
    shutil.rmtree(root, ignore_errors=True)
    warn(f"creating a bare {SYSTEMS[system]} in {relative(root)}: 80 MiB to fetch, a minute or two")
    making = root.with_name("making")
    shutil.rmtree(making, ignore_errors=True)
    making.mkdir(parents=True)
    log = root.with_name("debootstrap.log")
    with open(log, "w", encoding="utf-8") as out:
        code = subprocess.run(["debootstrap", "--variant=minbase", system, making, MIRROR], stdin=subprocess.DEVNULL,
                              stdout=out, stderr=out).returncode
    if code:
        said = [line for line in log.read_text(errors="replace", encoding="utf-8").splitlines() if line.startswith(("E:", "W:"))]
        raise UsageError(f"debootstrap could not make {SYSTEMS[system]} from {MIRROR}: "
                         f"{said[-1] if said else f'it ended with {code}'}; all it said is in {relative(log)}")
    making.rename(root)


def copy_tree(to: Path):
    """Makes `to` the course as it is here, including uncommitted files; equal files are not touched."""
    if (ROOT / ".git").exists():
        if not (to / ".git").exists():
            shutil.rmtree(to, ignore_errors=True)
            git("clone", "--quiet", "--no-hardlinks", str(ROOT), str(to))
        git("-C", str(to), "fetch", "--quiet", str(ROOT), "HEAD")
        git("-C", str(to), "reset", "--quiet", "FETCH_HEAD")
    wanted = set(files())
    for name in wanted:
        if not (to / name).exists() or not filecmp.cmp(ROOT / name, to / name, shallow=False):
            (to / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, to / name)
    for name in set(walk(to)) - wanted:
        (to / name).unlink()


def contained(root: Path, command: list[str], folder: str = TREE) -> list[str]:
    """The command line that runs `command` in the course's folder there, or another one, as that system's root."""
    words = ["bwrap", "--bind", str(root), "/", "--dev", "/dev", "--proc", "/proc", "--die-with-parent", "--unshare-pid",
             "--unshare-ipc", "--unshare-uts", "--hostname", root.parent.name, "--cap-add", "ALL", "--clearenv"]
    environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LANG": "C.UTF-8"}
    for name in ("CI", "TERM"):
        if name in os.environ:
            environment[name] = os.environ[name]
    for name, value in environment.items():
        words += ["--setenv", name, value]
    if os.path.exists("/etc/resolv.conf"):
        words += ["--ro-bind", os.path.realpath("/etc/resolv.conf"), "/etc/resolv.conf"]
    return [*words, "--chdir", folder, "--", *command]
