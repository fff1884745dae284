"""Progress of long work: one line that is drawn over on a terminal, a plain line every tenth and every ten seconds elsewhere."""

import os
import shutil
import sys
import time

QUIET_S = 10  # at most, elsewhere than on a terminal


class Progress:
    """with Progress("building") as progress: progress.show(done, total, "the last step")"""

    def __init__(self, label: str, stream=sys.stderr):
        self.label, self.stream = label, stream
        self.terminal = stream.isatty() and os.environ.get("TERM") != "dumb"  # an editor's shell draws nothing over
        self.tenth = -1
        self.said_s = 0.0
        self.drawn = False

    def show(self, done: int, total: int, note: str = ""):
        if self.terminal:
            filled = 24 * done // max(total, 1)
            line = f"{self.label} [{'#' * filled}{' ' * (24 - filled)}] {done}/{total} {note}"
            self.stream.write(f"\r{line[:shutil.get_terminal_size().columns - 1]}\033[K")
            self.drawn = True
        elif 10 * done // max(total, 1) != self.tenth or time.monotonic() > self.said_s + QUIET_S:
            self.tenth = 10 * done // max(total, 1)
            self.said_s = time.monotonic()
            self.stream.write(f"{self.label} {done}/{total} {note}".rstrip() + "\n")
        self.stream.flush()

    def say(self, line: str):
        """A line of its own, above the bar."""
        self.clear()
        self.stream.write(line + "\n")
        self.stream.flush()

    def clear(self):
        if self.drawn:
            self.stream.write("\r\033[K")
            self.stream.flush()
            self.drawn = False

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.clear()
