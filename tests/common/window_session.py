"""A program in a window of a virtual X server: its output, the screen, the mouse and the keyboard."""
import contextlib
import ctypes
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
PATIENCE_S = float(os.environ.get("LIGHTWALK_PATIENCE_S", "60"))


def own_cache(folder: Path) -> dict[str, str]:
    """The environment of a program without thumbnails and other caches, except for compiled shaders."""
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return {"XDG_CACHE_HOME": str(folder / "cache"), "MESA_SHADER_CACHE_DIR": os.environ.get("MESA_SHADER_CACHE_DIR", str(cache))}


class Session:
    """One program, started with LIGHTWALK_LOG=1, and its window."""

    def __init__(self, server: XServer, program: Path, options: list[str], folder: Path, **environment: str):
        self.server = server
        self.environment = {**os.environ, "DISPLAY": server.display, "LIGHTWALK_LOG": "1", "LIGHTWALK_REFINE": "off",
                            "LIGHTWALK_TOUR": "off", "XDG_STATE_HOME": str(folder / "state"), **environment}
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.lines: list[str] = []
        self.errors: list[str] = []
        self.places: dict[str, tuple[float, float]] = {}
        self.areas: dict[str, tuple[int, int, int, int]] = {}  # left, top, right, bottom
        self.mouse = (0, 0, 0, 0)  # x, y, buttons and wheel, as the frame drawn last has read them
        self.frames = self.pictures = 0  # frames drawn, and the ones with a picture of their own
        self.keys_wait = False  # for the next frame
        self.types = False  # a field has the keyboard
        self.unfolded: set[str] = set()  # exercises
        self.rests = False  # nothing is drawn until something happens
        self.process = subprocess.Popen([str(program), *options], cwd=folder, env=self.environment, text=True,
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
                self.mouse = tuple(map(int, line.split()[1:]))
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

    def key(self, *keys: str):
        self.xdotool("key", *keys)

    # A window reads the mouse once a frame, and a frame takes as long as it takes: each step waits until it has been read.

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

    def click(self, place: str, button: int = 1):
        """And waits until the picture is at rest."""
        self.tap(place, button)
        self.settled(0, 0, *self.geometry()[2:])

    def tap(self, place: str, button: int = 1, held: str = ""):
        """`held`: a key held meanwhile. An exercise's widgets are in its row, which is unfolded first."""
        of = re.fullmatch(r"(?:mine|reference|lesson|check|words|hint)\.(\d\d\.\w+)", place)
        if of and of[1] not in self.unfolded:
            self.unfolded.add(of[1])
            self.tap(f"exercise.{of[1]}")
        self.wait(lambda: place in self.places, f"a widget '{place}'")
        at = None
        while at != self.places[place]:  # a new widget reaches its position in its second frame
            at = self.places[place]
            self.move(*at)
        with self.holding(held):
            self.press(button)
            self.release(button)
        self.park()

    @contextlib.contextmanager
    def holding(self, key: str):
        if key:
            self.xdotool("keydown", key)
        try:
            yield
        finally:
            if key:
                self.xdotool("keyup", key)

    def drag(self, start: tuple[int, int], end: tuple[int, int], button: int = 1, held: str = ""):
        self.move(*start)
        self.press(button)
        with self.holding(held):
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
        """Until frames have read all keys and the mouse and moved the panels accordingly: the next frame may have begun
        before, the one after it reads, and widgets come to their places in another one."""
        since, began = self.frames, time.monotonic()
        self.wait(lambda: (self.frames >= since + 3 and not self.keys_wait) or
                  (self.rests and (self.frames >= since + 2 or time.monotonic() > began + 0.4)), "frames")

    def replace(self, text: str):
        """Replaces the text of the field that has the keyboard, or is about to get it; ended with Return. One frame reads
        all of the text: a knob counts while it is typed, and 1e39 is 1 at first."""
        self.wait(lambda: self.types, "a field")
        self.process.send_signal(signal.SIGSTOP)
        self.key("ctrl+a")
        if text:
            self.xdotool("type", "--", text)
        else:
            self.key("BackSpace")
        self.key("Return")
        self.process.send_signal(signal.SIGCONT)
        self.wait(lambda: not self.types and not self.keys_wait, "the end of the text")

    def settled(self, *area: int) -> bytes:
        """The pixels of an area once they have stopped changing."""
        before, since = self.pixels(*area), time.monotonic()
        until = time.monotonic() + PATIENCE_S
        while time.monotonic() - since < 0.6:
            if time.monotonic() > until:
                raise AssertionError("the picture does not come to rest")
            time.sleep(0.05)
            now = self.pixels(*area)
            if now != before:
                before, since = now, time.monotonic()
        return before

    def drop(self, *files: Path):
        """Drops files on the window like a file manager: the protocol XDND, version 5, from enter to finished."""
        x11 = ctypes.CDLL("libX11.so.6")
        for function in ("XOpenDisplay", "XDefaultRootWindow", "XInternAtom", "XCreateSimpleWindow"):
            getattr(x11, function).restype = ctypes.c_void_p
        display = ctypes.c_void_p(x11.XOpenDisplay(self.server.display.encode()))
        try:
            self.drop_by(x11, display, "".join(file.resolve().as_uri() + "\r\n" for file in files).encode())
        finally:
            x11.XCloseDisplay(display)

    def drop_by(self, x11, display, uris: bytes):
        def atom(name):
            return x11.XInternAtom(display, name.encode(), 0)

        long, target = ctypes.c_long, int(self.window)
        source = x11.XCreateSimpleWindow(display, long(x11.XDefaultRootWindow(display)), 0, 0, 1, 1, 0, long(0), long(0))

        def send(kind, *data):
            event = (long * 24)(33, 0, 1, 0, target, atom(kind), 32, source, *data)  # 33: ClientMessage
            x11.XSendEvent(display, long(target), 0, long(0), event)

        x, y, width, height = self.geometry()
        x11.XSetSelectionOwner(display, long(atom("XdndSelection")), long(source), long(0))
        send("XdndEnter", 5 << 24, atom("text/uri-list"), 0, 0)
        send("XdndPosition", 0, (x + width // 2) << 16 | (y + height // 2), 0, atom("XdndActionCopy"))
        send("XdndDrop", 0, 0, 0, 0)
        x11.XSync(display, 0)
        event, until = (long * 24)(), time.monotonic() + PATIENCE_S
        while True:
            if time.monotonic() > until:
                raise AssertionError("nobody took what was dropped")
            if not x11.XPending(display):
                time.sleep(0.02)
                continue
            x11.XNextEvent(display, event)
            kind = event[0] & 0xff
            if kind == 30:  # SelectionRequest: owner, requestor, selection, target, property, time
                requestor, selection, form, place, when = event[5:10]
                x11.XChangeProperty(display, long(requestor), long(place), long(form), 8, 0, uris, len(uris))
                answer = (long * 24)(31, 0, 1, 0, requestor, selection, form, place, when)
                x11.XSendEvent(display, long(requestor), 0, long(0), answer)
            elif kind == 33 and event[5] == atom("XdndFinished"):
                return

    def set_minimised(self, minimised: bool):
        """The window manager's part: the property first, then the mapping (ICCCM 4.1.3.1)."""
        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        for function in (x11.XInternAtom, x11.XChangeProperty, x11.XSync, x11.XCloseDisplay):
            function.argtypes = None
        display = ctypes.c_void_p(x11.XOpenDisplay(self.server.display.encode()))
        state = x11.XInternAtom(display, b"WM_STATE", 0)
        value = (ctypes.c_long * 2)(3 if minimised else 1, 0)
        x11.XChangeProperty(display, ctypes.c_ulong(int(self.window)), ctypes.c_ulong(state), ctypes.c_ulong(state),
                            32, 0, value, 2)
        x11.XSync(display, 0)
        x11.XCloseDisplay(display)
        self.xdotool("windowunmap" if minimised else "windowmap", "--sync", self.window)

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
