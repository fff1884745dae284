"""A control group for a sandbox, where this user may make one: of all its processes together, the kernel's own memory
included, so much memory and so many threads. Where there is none, the limits of each process must do (sandbox.py)."""

import contextlib
import functools
import itertools
import os
import time
from pathlib import Path

NUMBERS = itertools.count()
# Of version 1 each controller has a tree, of version 2 all share one: (file in the group, its value's name).
FILES = {"memory": "memory.limit_in_bytes", "pids": "pids.max"}


class Cage:
    """`joins`: files into which a process writes its number to be in it."""

    def __init__(self, memory_bytes: int, tasks: int):
        self.folders = []
        name = f"lightwalk.{os.getpid()}.{next(NUMBERS)}"
        for controllers, parent in hierarchies().items():
            folder = parent / name
            try:
                folder.mkdir()
            except OSError:
                continue
            self.folders.append(folder)
            limits = {"memory": memory_bytes, "pids": tasks}
            for controller in controllers:
                file = FILES[controller] if (folder / FILES[controller]).exists() else f"{controller}.max"
                with contextlib.suppress(OSError):
                    (folder / file).write_text(str(limits[controller]), encoding="utf-8")
        self.joins = [folder / "cgroup.procs" for folder in self.folders]

    def was_full(self) -> bool:
        """Whether a process was killed because the group had come to its limit of memory."""
        for folder in self.folders:
            for name in ("memory.events", "memory.oom_control"):
                with contextlib.suppress(OSError, ValueError):
                    words = dict(line.split() for line in (folder / name).read_text(encoding="utf-8").splitlines())
                    if int(words.get("oom_kill", 0)):
                        return True
        return False

    def close(self):
        """When all in it have ended: the kernel lets go of a group a moment after its last process."""
        for folder in self.folders:
            for wait_s in (0, 0.01, 0.05, 0.2, 1):
                time.sleep(wait_s)
                try:
                    folder.rmdir()
                    break
                except OSError:
                    continue
        self.folders = []


@functools.cache
def hierarchies() -> dict[tuple[str, ...], Path]:
    """By controllers: the folder of this process's own group, where groups can be made in it."""
    found = {}
    with contextlib.suppress(OSError):
        mounts = [line.split() for line in Path("/proc/self/mounts").read_text(encoding="utf-8").splitlines()]
        for line in Path("/proc/self/cgroup").read_text(encoding="utf-8").splitlines():
            number, names, path = line.split(":", 2)
            words = tuple(name for name in names.split(",") if name in FILES)
            for _, place, kind, options, *_ in mounts:
                folder = Path(place + path) if Path(place + path).is_dir() else Path(place)
                if kind == "cgroup" and words and set(words) <= set(options.split(",")):
                    usable(found, words, folder)
                elif kind == "cgroup2" and number == "0":
                    have = (folder / "cgroup.subtree_control").read_text(encoding="utf-8").split()
                    usable(found, tuple(name for name in FILES if name in have), folder)
    return found


def usable(found: dict, controllers: tuple[str, ...], folder: Path):
    if controllers and not any(set(controllers) & set(known) for known in found) and os.access(folder, os.W_OK):
        found[controllers] = folder
