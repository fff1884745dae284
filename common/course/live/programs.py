"""The chapters' programs behind the pages: one for each chapter, kept warm, asked for one picture at a time."""

import asyncio
import collections
import contextlib
import json
import os
import signal
import time

from tree import ROOT, chapter_program, exercises

IDLE_S = 60  # without a question; then it is ended
ANSWER_S = 120  # a first picture compiles its shaders
MOST_PROGRAMS = 4  # the one asked longest ago makes room
LINE_BYTES = 1 << 20
PICTURE_BYTES = 1 << 25


class Gone(Exception):
    """The program ended, or did not answer, and has been ended; the words say how. The next question starts it again."""


class Program:
    """One chapter's program: started by the first draw(), ended by end()."""

    def __init__(self, chapter: str):
        self.chapter, self.process, self.said, self.reader = chapter, None, collections.deque(maxlen=5), None
        self.started_from = None

    async def draw(self, request: dict) -> tuple[dict, bytes]:
        """The answer and the picture. Raises Gone."""
        try:
            return await asyncio.wait_for(self.ask(request), ANSWER_S)
        except asyncio.TimeoutError:
            why = f"chapter {self.chapter[:2]} did not answer within {ANSWER_S} s and was ended"
        except (OSError, ValueError, KeyError, asyncio.IncompleteReadError):
            why = await self.last_words()
        except asyncio.CancelledError:
            await self.end()
            raise
        await self.end()
        raise Gone(f"{why}; the next picture starts it again")

    async def ask(self, request: dict) -> tuple[dict, bytes]:
        if self.process and self.started_from != self.version():  # it was built since
            await self.end()
        if not self.process:
            await self.start()
        self.process.stdin.write(json.dumps(request).encode() + b"\n")
        await self.process.stdin.drain()
        line = await self.process.stdout.readline()
        if not line:
            raise ConnectionError
        answer = json.loads(line)
        if not 0 <= answer["bytes"] <= PICTURE_BYTES:
            raise ValueError
        return answer, await self.process.stdout.readexactly(answer["bytes"])

    def version(self):
        """Changes where the program was built again."""
        try:
            at = chapter_program(self.chapter).stat()
            return at.st_mtime_ns, at.st_ino
        except OSError:
            return None

    async def start(self):
        self.started_from = self.version()
        self.process = await asyncio.create_subprocess_exec(
            chapter_program(self.chapter), "--pictures", cwd=ROOT, limit=LINE_BYTES, stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.PIPE, start_new_session=True)
        self.said.clear()
        self.reader = asyncio.ensure_future(self.listen(self.process.stderr))

    async def listen(self, stderr):
        with contextlib.suppress(ValueError):  # a line without an end
            async for line in stderr:
                self.said.append(line.decode(errors="replace").strip())

    async def last_words(self) -> str:
        """How it ended."""
        if not self.process:
            return f"chapter {self.chapter[:2]} is not built: ./course run {self.chapter[:2]} builds it"
        with contextlib.suppress(asyncio.TimeoutError):
            await asyncio.wait_for(self.process.wait(), 5)
            await asyncio.wait_for(self.reader, 1)
        code, words = self.process.returncode, next((line for line in reversed(self.said) if line), "")
        how = f"was ended by {signal.Signals(-code).name}" if code and code < 0 else f"ended with {code}"
        return f"chapter {self.chapter[:2]} {how}" + (f": {words[:300]}" if words else "")

    async def end(self):
        process, self.process = self.process, None
        if not process:
            return
        if process.returncode is None:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)  # it has nothing to put away
            await process.wait()
        if self.reader:
            self.reader.cancel()


class Programs:
    """All programs, and their waiting requests. A newer request from the same place on a page replaces the older one:
    intermediate positions of a drag are not drawn."""

    def __init__(self):
        self.programs, self.waiting, self.tasks, self.used_s = {}, {}, {}, {}
        self.dropped = 0

    def ask(self, chapter: str, place: tuple, request: dict, deliver):
        """deliver(answer, picture) is called when it is drawn, and never where a newer question came before."""
        waiting = self.waiting.setdefault(chapter, {})
        self.dropped += place in waiting
        waiting[place] = (request, deliver)
        if chapter not in self.tasks:
            self.tasks[chapter] = asyncio.ensure_future(self.work(chapter))

    def forget(self, client):
        """A client has gone, and so have its requests."""
        for waiting in self.waiting.values():
            for place in [place for place in waiting if place[0] is client]:
                del waiting[place]

    async def work(self, chapter: str):
        """Draws a chapter's waiting requests, in order."""
        program = self.programs.setdefault(chapter, Program(chapter))
        try:
            while self.waiting.get(chapter):
                place = next(iter(self.waiting[chapter]))
                request, deliver = self.waiting[chapter].pop(place)
                self.used_s[chapter] = time.monotonic()
                await self.make_room(chapter)
                began_s = time.monotonic()
                try:
                    answer, picture = await program.draw(request)
                except Gone as why:
                    answer, picture = {"code": 3, "error": str(why), "bytes": 0}, b""
                answer["ms"] = round(1000 * (time.monotonic() - began_s), 1)
                self.used_s[chapter] = time.monotonic()
                deliver(answer, picture)
        finally:
            del self.tasks[chapter]

    async def make_room(self, chapter: str):
        others = [one for one, program in self.programs.items()
                  if program.process and one != chapter and one not in self.tasks]
        warm = sum(program.process is not None for one, program in self.programs.items() if one != chapter)
        if others and warm >= MOST_PROGRAMS:
            await self.programs[min(others, key=lambda one: self.used_s.get(one, 0))].end()

    async def end_idle(self):
        """Ends programs that were idle for a minute; called now and then."""
        for chapter, program in list(self.programs.items()):
            if program.process and chapter not in self.tasks and time.monotonic() > self.used_s.get(chapter, 0) + IDLE_S:
                await program.end()

    async def end(self):
        for task in list(self.tasks.values()):
            task.cancel()
        await asyncio.gather(*self.tasks.values(), return_exceptions=True)
        for program in self.programs.values():
            await program.end()

    def running(self) -> dict[str, int]:
        """Process ids by chapter."""
        return {chapter: program.process.pid for chapter, program in self.programs.items() if program.process}


def is_cpp(chapter: str, exercise: str) -> bool:
    return exercises(chapter)[exercise].suffix == ".cpp"
