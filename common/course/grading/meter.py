"""The time that a verdict takes of this machine: its sandboxes' processor time, and the time in which all of them sleep.

A student is charged by it (judge.py). The clock would charge for a busy machine, and processor time alone nothing for an
answer that sleeps: a process that waits for a processor is runnable, and counts as neither.
"""

import contextlib
import os
import threading
import time
from pathlib import Path

LOOK_S = 0.25
TICKS_PER_S = os.sysconf("SC_CLK_TCK")
current = threading.local()  # .meter: of the verdict that this thread is on


class Meter:
    """Looks at the sandboxes that add() names, several times a second, until its block ends."""

    def __init__(self):
        self.running, self.processor_s, self.slept_s = [], {}, 0.0
        self.ended = threading.Event()
        self.looking = threading.Thread(target=self.look_on, daemon=True)

    def __enter__(self):
        current.meter = self
        self.looking.start()
        return self

    def __exit__(self, *_):
        current.meter = None
        self.ended.set()
        self.looking.join()

    @property
    def seconds(self) -> float:
        return sum(self.processor_s.values()) + self.slept_s

    def add(self, running):
        self.running.append(running)

    def look_on(self):
        last_s = time.monotonic()
        while not self.ended.wait(LOOK_S):
            now_s = time.monotonic()
            states = self.look()
            if states and not states & set("RD"):
                self.slept_s += min(now_s - last_s, 2 * LOOK_S)  # this thread may have waited for a processor itself
            last_s = now_s

    def look(self) -> set[str]:
        """Notes each process's time; the states of all their threads."""
        states = set()
        for process in [pid for one in list(self.running) if one.first for pid in family(one.first)]:
            with contextlib.suppress(OSError, ValueError, IndexError):
                fields = stat(Path(f"/proc/{process}/stat"))
                self.processor_s[process, fields[19]] = (int(fields[11]) + int(fields[12])) / TICKS_PER_S
                states |= {stat(task / "stat")[0] for task in Path(f"/proc/{process}/task").iterdir()}
        return states


def stat(path: Path) -> list[str]:
    """The fields behind the name, which may hold any character: the state first."""
    return path.read_text(errors="replace", encoding="utf-8").rpartition(")")[2].split()


def family(first: int) -> list[int]:
    """A process and all below it."""
    found = [first]
    for process in found:
        with contextlib.suppress(OSError, ValueError):
            for task in Path(f"/proc/{process}/task").iterdir():
                found += map(int, (task / "children").read_text(encoding="utf-8").split())
    return found
