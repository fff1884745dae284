"""A program in a window of a virtual X server: its output, the screen, the mouse and the keyboard."""
import contextlib
import functools
import os
import re
import signal
import subprocess
import threading
import time
from pathlib import Path

from x_server import XServer

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
PATIENCE_S = 60


def own_cache(folder: Path) -> dict[str, str]:
    """The environment of a program without thumbnails and other caches, except for compiled shaders."""
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return {"XDG_CACHE_HOME": str(folder / "cache"), "MESA_SHADER_CACHE_DIR": os.environ.get("MESA_SHADER_CACHE_DIR", str(cache))}


def keys_of(text: str) -> int:
    """To type it: Shift is one of its own for each letter that needs it."""
    return sum(1 + (letter.isupper() or letter in '~!@#$%^&*()_+{}|:"<>?') for letter in text)


def answered(action):
    """Adds `says` to an action: the first line since then that matches it as a whole is waited for and returned as a match."""
    @functools.wraps(action)
    def waiting(self, *words, says: str = "", **options):
        since = self.said()
        action(self, *words, **options)
        return self.wait_for_line(says, since) if says else None
    return waiting


class Session:
    """One program, started with --events, and its window."""

    def __init__(self, server: XServer, program: Path, options: list[str], folder: Path, refine: str = "off",
                 tour: bool = False, **environment: str):
        self.server = server
        self.environment = {**os.environ, "DISPLAY": server.display,
                            "XDG_STATE_HOME": str(folder / "state"), **environment}
        self.environment.pop("WAYLAND_DISPLAY", None)
        left = folder / "state" / "lightwalk" / "18_playground.tour.panel.json"
        if not tour and not left.exists():  # as who has seen the editor's tour
            left.parent.mkdir(parents=True, exist_ok=True)
            left.write_text('{"left": true}')
        self.lines: list[str] = []
        self.errors: list[str] = []
        self.places: dict[str, tuple[float, float]] = {}
        self.areas: dict[str, tuple[int, int, int, int]] = {}  # left, top, right, bottom
        self.mouse = (0, 0, 0, 0)  # x, y, buttons and wheel, as the frame drawn last has read them
        self.frames = self.pictures = 0  # frames drawn, and the ones with a picture of their own
        self.keys_down = 0  # keys that went down and have arrived
        self.size = (0, 0)  # of the window's picture and panels, since it has changed
        self.keys_wait = False  # for the next frame
        self.types = False  # a field has the keyboard
        self.unfolded: set[str] = set()  # exercises
        self.rests = False  # nothing is drawn until something happens
        self.process = subprocess.Popen([str(program), *options, "--events", "on", "--refine", refine], cwd=folder, env=self.environment, text=True,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.readers = [threading.Thread(target=self.read, args=(pipe, target), daemon=True)
                        for pipe, target in ((self.process.stdout, self.lines), (self.process.stderr, self.errors))]
        for reader in self.readers:
            reader.start()
        self.window = ""
        until = time.monotonic() + PATIENCE_S
        while not self.window and self.process.poll() is None and time.monotonic() < until:
            found = self.xdotool("search", "--onlyvisible", "--name", "Lightwalk", check=False).split()
            self.window = found[0] if found else ""
            time.sleep(0.1)
        try:
            if not self.window:
                raise AssertionError("no window appeared: " + "\n".join(self.errors))
            self.wait_for_line("first picture", 0)
            self.focus()
            self.park()
        except BaseException:
            self.close()
            raise

    def read(self, pipe, target: list[str]):
        for line in pipe:
            line = line.rstrip("\n")
            place = re.fullmatch(r"place (.*) (-?\d+) (-?\d+) (-?\d+) (-?\d+)", line)
            if line.startswith("mouse "):
                self.mouse, self.rests = tuple(map(int, line.split()[1:])), False
            elif line == "key":
                self.keys_down, self.rests = self.keys_down + 1, False
            elif line.startswith("size "):
                self.size, self.rests = tuple(map(int, line.split()[1:])), False
            elif line.startswith("frame "):
                words = line.split()
                self.keys_wait, self.types, self.rests = "keys" in words, "text" in words, False
                self.frames, self.pictures = int(words[1]), self.pictures + ("picture" in words)
            elif line == "rests":
                self.rests = True
            elif place:
                left, top, right, bottom = self.areas[place[1]] = tuple(map(int, place.groups()[1:]))
                self.places[place[1]] = ((left + right) / 2, (top + bottom) / 2)
            else:
                target.append(line)

    def xdotool(self, *words: str, check: bool = True) -> str:
        return subprocess.run(["xdotool", *words], env=self.environment, check=check, capture_output=True,
                              text=True).stdout

    def focus(self):
        self.xdotool("windowfocus", "--sync", self.window)

    # A window reads its input once a frame, and a frame takes as long as it takes: each step waits until it has been read. A
    # pointer that moved before a key was read would give the key another place.

    @answered
    def key(self, *keys: str):
        """One of them may end the program."""
        with self.arriving(sum(len(key.split("+")) for key in keys)):
            self.xdotool("key", *keys)

    def type(self, text: str):
        with self.arriving(keys_of(text)):
            self.xdotool("type", "--", text)

    @contextlib.contextmanager
    def arriving(self, keys: int):
        """Waits until so many keys, sent meanwhile, have arrived in the program."""
        wanted = self.keys_down + keys
        yield
        until = time.monotonic() + PATIENCE_S
        while self.keys_down < wanted and self.process.poll() is None:
            if time.monotonic() > until:
                raise AssertionError(f"{wanted - self.keys_down} of {keys} keys did not arrive")
            time.sleep(0.005)

    def resize(self, width: int, height: int):
        if self.geometry()[2:] == (width, height):
            return
        self.xdotool("windowsize", "--sync", self.window, str(width), str(height))
        self.wait(lambda: self.size == (width, height), f"a window of {width}x{height}")

    @answered
    def move(self, x: float, y: float):
        at = (round(x), round(y))
        self.xdotool("mousemove", "--window", self.window, *map(str, at))
        self.wait(lambda: self.mouse[:2] == at, f"the mouse at {at}")

    def press(self, button: int = 1):
        self.xdotool("mousedown", str(button))
        self.wait(lambda: self.mouse[2] != 0, f"button {button} down")

    def release(self, button: int = 1):
        self.xdotool("mouseup", str(button))
        self.wait(lambda: self.mouse[2] == 0, f"button {button} up")

    def turn(self, notches: int):
        """The wheel: up is positive."""
        wheel = self.mouse[3] + notches
        self.xdotool("click", "--repeat", str(abs(notches)), "4" if notches > 0 else "5")
        self.wait(lambda: self.mouse[3] == wheel, f"the wheel at {wheel}")

    @answered
    def click(self, place: str):
        """And waits until the picture is at rest."""
        self.tap(place)
        self.settled(0, 0, *self.geometry()[2:])

    @answered
    def tap(self, place: str):
        """An exercise's widgets are in its row, which is unfolded first."""
        of = re.fullmatch(r"(?:mine|reference|lesson|check|words|hint)\.(\d\d\.\w+)", place)
        if of and of[1] not in self.unfolded:
            self.unfolded.add(of[1])
            self.tap(f"exercise.{of[1]}")
        self.wait(lambda: place in self.places, f"a widget '{place}'")
        at = None
        while at != self.places[place]:  # a new widget reaches its position in its second frame
            at = self.places[place]
            self.move(*at)
        self.press()
        self.release()
        self.park()

    @contextlib.contextmanager
    def holding(self, key: str):
        with self.arriving(1):
            self.xdotool("keydown", key)
        try:
            yield
        finally:
            self.xdotool("keyup", key)

    @answered
    def drag(self, start: tuple[int, int], end: tuple[int, int], button: int = 1):
        self.move(*start)
        self.press(button)
        for step in (0.25, 0.5, 0.75, 1.0):
            self.move(*(a + (b - a) * step for a, b in zip(start, end)))
        self.release(button)
        self.park()

    def park(self):
        """The mouse out of the way: its pointer is part of the screen."""
        width, height = self.geometry()[2:]
        self.xdotool("mousemove", "9999", "9999")
        self.wait(lambda: not (0 <= self.mouse[0] < width and 0 <= self.mouse[1] < height), "the mouse outside")

    def wait(self, condition, what: str):
        until = time.monotonic() + PATIENCE_S
        while not condition():
            if self.process.poll() is not None:
                raise AssertionError(f"it ended while waiting for {what}: " + "\n".join(self.errors))
            if time.monotonic() > until:
                raise AssertionError(f"waited in vain for {what}; it said: {self.lines} {self.errors}")
            time.sleep(0.02)

    def wait_for_line(self, pattern: str, since: int) -> re.Match:
        """The first line after the first `since` that matches as a whole."""
        self.wait(lambda: any(re.fullmatch(pattern, line) for line in self.lines[since:]), f"a line '{pattern}'")
        return next(m for m in (re.fullmatch(pattern, line) for line in self.lines[since:]) if m)

    def said(self) -> int:
        return len(self.lines)

    def geometry(self) -> tuple[int, int, int, int]:
        words = dict(re.findall(r"(\w+)=(\d+)", self.xdotool("getwindowgeometry", "--shell", self.window)))
        return tuple(int(words[key]) for key in ("X", "Y", "WIDTH", "HEIGHT"))

    def pixels(self, left: int, top: int, width: int, height: int) -> bytes:
        x, y = self.geometry()[:2]
        return self.server.screen(x + left, y + top, width, height)

    def read_all(self):
        """Until frames have dealt with the input that has arrived: the next one may have begun before, the one after it reads,
        and widgets come to their places in another one."""
        since = self.frames
        self.wait(lambda: not self.keys_wait and (self.rests or self.frames >= since + 3), "frames")

    def replace(self, text: str):
        """Replaces the text of the field that has the keyboard, or is about to get it; ended with Return. One frame reads
        all of the text: a knob counts while it is typed, and 1e39 is 1 at first."""
        self.wait(lambda: self.types, "a field")
        with self.arriving(3 + max(keys_of(text), 1)):  # Ctrl, A and Return
            self.process.send_signal(signal.SIGSTOP)
            self.xdotool("key", "ctrl+a")
            self.xdotool(*(["type", "--", text] if text else ["key", "BackSpace"]))
            self.xdotool("key", "Return")
            self.process.send_signal(signal.SIGCONT)
        self.wait(lambda: not self.types and not self.keys_wait, "the end of the text")

    def settled(self, *area: int) -> bytes:
        """The pixels of an area once the program draws nothing more, or many frames that are all alike, and the screen shows
        what it drew. The menu says nothing of its frames."""
        before, since, frames = self.pixels(*area), time.monotonic(), self.frames
        until = time.monotonic() + PATIENCE_S
        while time.monotonic() - since < 0.4:
            if time.monotonic() > until:
                raise AssertionError("the picture does not come to rest")
            time.sleep(0.05)
            now = self.pixels(*area)
            if now != before:
                frames = self.frames
            if now != before or not (self.rests or self.frames == 0 or self.frames >= frames + 20):
                before, since = now, time.monotonic()
        return before

    def set_minimised(self, minimised: bool):
        since = self.said()
        self.server.set_minimised(int(self.window), minimised)
        self.xdotool("windowunmap" if minimised else "windowmap", "--sync", self.window)
        self.wait_for_line("minimised" if minimised else "restored", since)

    def close(self):
        """Ends it in any state; after end() it does nothing."""
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        for reader in self.readers:
            reader.join(5)
        self.process.stdout.close()
        self.process.stderr.close()

    def end(self, patience_s: float = 20) -> int:
        """Its exit code."""
        try:
            return self.process.wait(patience_s)
        except subprocess.TimeoutExpired:
            raise AssertionError("it did not end") from None
        finally:
            self.close()
