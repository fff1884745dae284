"""Draws pictures with the chapters' programs: one at a time, or many in one process.

A program that draws one picture spends most of its time starting a device, compiling for it and reading the scene.
"""

import contextlib
import json
import os
import select
import signal
import subprocess
import tempfile
from pathlib import Path

from tree import ROOT, Failure, chapter_program, relative

class Crashed(Failure):
    """The program ended as one does that reads or writes where it must not: it, or the driver within it."""


TIMEOUT_S = 300  # under a sanitizer; a picture takes a second or two
# The C library fills allocated memory with a byte: on lavapipe, with images in ordinary memory, a picture that reads
# unwritten texels shows NaN, where it would mostly be black.
UNWRITTEN = {"MALLOC_PERTURB_": "1"}


def surroundings(environment: dict) -> dict:
    return os.environ | UNWRITTEN | environment


def run_program(command: list, **environment) -> subprocess.CompletedProcess:
    """Runs one of our programs, with more in its environment. Raises Failure with its own words where it cannot be run or does not end."""
    try:
        return subprocess.run([str(word) for word in command], cwd=ROOT, env=surroundings(environment), text=True,
                              errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              timeout=TIMEOUT_S)
    except OSError as error:
        raise Failure(f"{relative(command[0])}: {error.strerror}") from None
    except subprocess.TimeoutExpired:
        raise Failure(f"{Path(command[0]).name} did not end within {TIMEOUT_S} s") from None


def render(chapter: str, options: list, picture: Path, **environment):
    """Draws a picture without a window, with more in its environment. Raises Failure with the program's own words."""
    picture.parent.mkdir(parents=True, exist_ok=True)
    picture.unlink(missing_ok=True)
    done = run_program([chapter_program(chapter), *options, "--screenshot", picture], **environment)
    if done.returncode or not picture.exists():
        crashed = done.returncode == -signal.SIGSEGV or "stack smashing" in done.stderr
        raise (Crashed if crashed else Failure)(f"{chapter} ended with {done.returncode}: {last_words(done.stderr, done.stdout)}")


def render_shot(chapter: str, shot: dict, picture: Path, use: str = "solution", size: str = "", **environment):
    """In its own size, or WxH."""
    options = ["--shot", shot["name"], "--use", use, "--validate", "on", *(["--size", size] if size else [])]
    render(chapter, options, picture, **environment)


class Asked:
    """A program that answers each line of JSON with a line of JSON, whose "bytes" follow it. If it dies, the next question starts it
    again, unless all are `stopped`."""

    stopped = False  # the command was interrupted: threads ask no more

    def __init__(self, command: list, timeout_s: float = TIMEOUT_S, environment: dict | None = None):
        self.command, self.timeout_s, self.environment = [str(word) for word in command], timeout_s, environment
        self.program = self.stderr = None
        self.picture = b""  # the bytes behind the last answer

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Lets it end by itself."""
        if self.program:
            with contextlib.suppress(OSError):
                self.program.stdin.close()
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.program.wait(self.timeout_s)
            self.end()

    def end(self) -> int:
        program, self.program = self.program, None
        if not program:
            return 0
        program.kill()
        with program, self.stderr:
            return program.wait()

    def ask(self, question) -> tuple[dict | None, str, int]:
        """(answer, text on stderr, exit code). Without an answer it has died or was late."""
        if Asked.stopped:
            raise Failure("drawing was stopped")
        if not self.program:
            self.stderr = tempfile.TemporaryFile("w+", errors="replace", encoding="utf-8")
            try:
                self.program = subprocess.Popen(self.command, cwd=ROOT, env=self.environment, stdin=subprocess.PIPE,
                                                stdout=subprocess.PIPE, stderr=self.stderr)
            except OSError as error:
                raise Failure(f"{relative(self.command[0])}: {error.strerror}") from None
        begin = self.stderr.seek(0, os.SEEK_END)
        with contextlib.suppress(OSError):  # it has died: there is no answer
            self.program.stdin.write(json.dumps(question).encode() + b"\n")
            self.program.stdin.flush()
        out = self.program.stdout
        in_time = bool(select.select([out], [], [], self.timeout_s)[0])
        line = out.readline() if in_time else b""
        if in_time and not line:  # it is dying: of what is known in a moment
            with contextlib.suppress(subprocess.TimeoutExpired):
                self.program.wait(5)
        answer = json.loads(line) if line.startswith(b"{") else {}
        self.picture = out.read(answer.get("bytes", 0))
        self.stderr.seek(begin)
        said = self.stderr.read()
        return (answer, said, 0) if answer and len(self.picture) == answer.get("bytes", 0) else (None, said, self.end())


class Drawing(Asked):
    """A chapter's program that draws one picture after the other: draws() as often as wanted, then close(). On a device, by
    a part of its name, and with more in its environment. Not for tests of output and exit."""

    def __init__(self, chapter: str, validate: str = "on", device: str = "", **environment):
        self.chapter = chapter
        on = ["--device", device] if device else []
        super().__init__([chapter_program(chapter), "--pictures", "--validate", validate, *on], environment=surroundings(environment))

    def draw(self, options: list, picture: Path) -> tuple[int, str, str]:
        """(exit code, error, text on stderr)."""
        answer, said, code = self.ask([*map(str, options), "--screenshot", str(picture)])
        return (answer["code"], answer["error"], said) if answer else (code, last_words(said), said)


def render_many(chapter: str, pictures: list[tuple[list, Path]], device: str = "", **environment) -> list[str]:
    """Draws (options, picture) each, and returns each one's error, in the program's words."""
    wrong = []
    with Drawing(chapter, device=device, **environment) as drawing:
        for options, picture in pictures:
            picture.parent.mkdir(parents=True, exist_ok=True)
            picture.unlink(missing_ok=True)
            code, words, _ = drawing.draw(options, picture)
            wrong.append(f"{chapter} ended with {code}: {words}" if code or not picture.exists() else "")
    return wrong


def last_words(*said: str) -> str:
    return (next((text.strip() for text in said if text.strip()), "it said nothing"))[-2000:]


def text(value) -> str:
    """A knob's value as --set takes it."""
    return "on" if value is True else "off" if value is False else value if isinstance(value, str) else json.dumps(value)
