"""The chapters' programs behind the pages: one for each chapter, kept warm, asked for one picture at a time."""

import asyncio
import signal
import time

from shots.rendering import Asked
from tree import Failure, chapter_program, exercises

IDLE_S = 60  # without a question; then it is ended
ANSWER_S = 120  # a first picture compiles its shaders
MOST_PROGRAMS = 4  # the one asked longest ago makes room


class Gone(Exception):
    """The program ended, or did not answer, and has been ended; the words say how. The next question starts it again."""


class Program:
    """One chapter's program: started by the first draw(), ended by end()."""

    def __init__(self, chapter: str):
        self.chapter, self.asked, self.started_from = chapter, None, None

    @property
    def pid(self) -> int | None:
        return self.asked.program.pid if self.asked and self.asked.program else None

    async def draw(self, request: dict) -> tuple[dict, bytes]:
        version = self.version()
        if not self.asked or version != self.started_from:  # it was built since
            self.end()
            self.asked, self.started_from = Asked([chapter_program(self.chapter), "--pictures"], ANSWER_S), version
        asked, began_s = self.asked, time.monotonic()
        try:
            answer, said, code = await asyncio.to_thread(asked.ask, request)
        except Failure:
            raise Gone(f"chapter {self.chapter[:2]} is not built: ./course run {self.chapter[:2]} builds it") from None
        if answer:
            return answer, asked.picture
        words = ([""] + [line.strip() for line in said.splitlines() if line.strip()])[-1]
        how = f"did not answer within {ANSWER_S} s and was ended" if time.monotonic() - began_s > ANSWER_S else \
            f"was ended by {signal.Signals(-code).name}" if code < 0 else f"ended with {code}"
        raise Gone(f"chapter {self.chapter[:2]} {how}{f': {words[:300]}' if words else ''}; the next picture starts it again")

    def version(self):
        """Changes where the program was built again."""
        try:
            at = chapter_program(self.chapter).stat()
            return at.st_mtime_ns, at.st_ino
        except OSError:
            return None

    def end(self):
        if self.asked:
            self.asked.end()


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
        for waiting in self.waiting.values():
            for place in [place for place in waiting if place[0] is client]:
                del waiting[place]

    async def work(self, chapter: str):
        program = self.programs.setdefault(chapter, Program(chapter))
        try:
            while self.waiting.get(chapter):
                place = next(iter(self.waiting[chapter]))
                request, deliver = self.waiting[chapter].pop(place)
                self.used_s[chapter] = time.monotonic()
                self.make_room(chapter)
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

    def make_room(self, chapter: str):
        others = [one for one, program in self.programs.items()
                  if program.pid and one != chapter and one not in self.tasks]
        warm = sum(program.pid is not None for one, program in self.programs.items() if one != chapter)
        if others and warm >= MOST_PROGRAMS:
            self.programs[min(others, key=lambda one: self.used_s.get(one, 0))].end()

    def end_idle(self):
        """Ends programs that were idle for a minute; called now and then."""
        for chapter, program in list(self.programs.items()):
            if program.pid and chapter not in self.tasks and time.monotonic() > self.used_s.get(chapter, 0) + IDLE_S:
                program.end()

    async def end(self):
        for task in self.tasks.values():
            task.cancel()
        for program in self.programs.values():
            program.end()
        await asyncio.gather(*self.tasks.values(), return_exceptions=True)

    def running(self) -> dict[str, int]:
        return {chapter: program.pid for chapter, program in self.programs.items() if program.pid}


def is_cpp(chapter: str, exercise: str) -> bool:
    return exercises(chapter)[exercise].suffix == ".cpp"
