"""The socket of a page: requests and pictures, checks, and changes on disk."""

import asyncio
import json
import struct

from live import answers, charts
from live.answers import Refused
from live.guard import Guarded
from live.programs import is_cpp
from pages.made import cells, made
from tornado.iostream import StreamClosedError
from tornado.websocket import WebSocketClosedError, WebSocketHandler
from tree import Failure, chapters, shots

MESSAGE_BYTES = 1 << 16
MOST_PLACES = 64  # pictures on one page
MOST_EVENTS = 200
SEND_S = 20  # a page that takes nothing for so long is gone
PASSED_ON = ("size", "turn_rad", "tilt_rad", "notches", "time_s", "pan", "set", "use", "look")  # the program checks them (common/window/pictures.h)


class Socket(WebSocketHandler, Guarded):
    sockets = set()

    def check_origin(self, origin):
        return self.application.guard.knows_origin(self.request)

    def open(self, *_):
        self.frames, self.events, self.wake = {}, [], asyncio.Event()
        self.watched, self.places, self.pointed = {}, set(), None
        self.sender = asyncio.ensure_future(self.send())
        self.set_nodelay(True)
        self.sockets.add(self)

    def on_close(self):
        self.sockets.discard(self)
        self.application.programs.forget(self)
        if hasattr(self, "sender"):
            self.sender.cancel()
        if getattr(self, "pointed", None):
            self.pointed.cancel()

    async def send(self):
        """Sends one thing after the other. Pictures that wait here are replaced by newer ones of their place."""
        try:
            while True:
                await self.wake.wait()
                self.wake.clear()
                while self.events or self.frames:
                    if self.events:
                        await self.put(json.dumps(self.events.pop(0)))
                    else:
                        answer, picture = self.frames.pop(next(iter(self.frames)))
                        said = json.dumps(answer).encode()
                        await self.put(struct.pack("<I", len(said)) + said + picture, binary=True)
        except (WebSocketClosedError, StreamClosedError):
            self.gone()

    async def put(self, message, binary: bool = False):
        patience = asyncio.get_running_loop().call_later(SEND_S, self.gone)
        try:
            await self.write_message(message, binary)
        finally:
            patience.cancel()

    def gone(self):
        """Ends the connection without a word: nobody reads it."""
        if self.ws_connection and getattr(self.ws_connection, "stream", None):
            self.ws_connection.stream.close()
        else:
            self.close()

    def tell(self, event: dict):
        if len(self.events) >= MOST_EVENTS:
            self.gone()
            return
        self.events.append(event)
        self.wake.set()

    def on_message(self, message):
        try:
            request = json.loads(message)
            if not isinstance(request, dict):
                raise ValueError
            action = {"draw": self.draw, "check": self.check, "watch": self.watch, "point": self.point}[request.get("do")]
        except (ValueError, KeyError, TypeError, RecursionError):
            self.close(1007, "a message is not a request")
            return
        try:
            action(request)
        except Refused as why:
            self.tell({"event": "refused", "error": str(why), "place": str(request.get("place"))[:60]})

    def draw(self, request: dict):
        place, number = request.get("place"), request.get("number")
        if not isinstance(place, str) or len(place) > 60 or not isinstance(number, int):
            raise Refused(400, "a picture has a place and a number")
        self.places.add(place)
        if len(self.places) > MOST_PLACES:
            raise Refused(400, f"a page has at most {MOST_PLACES} pictures")
        chapter, asked = what_to_draw(request)

        self.application.programs.ask(chapter, (self, place), asked,
                                      lambda answer, picture: self.deliver(place, number, answer, picture))

    def deliver(self, place: str, number: int, answer: dict, picture: bytes):
        self.frames[place] = (answer | {"place": place, "number": number}, picture)
        self.wake.set()

    def point(self, request: dict):
        """A point of a chart was clicked; the one before is no longer waited for."""
        charts.requests_of(request.get("chart"), request.get("number"))
        if self.pointed:
            self.pointed.cancel()
        self.pointed = asyncio.ensure_future(charts.show(self, request["chart"], request["number"]))

    def check(self, request: dict):
        exercise = str(request.get("exercise"))
        answers.file_of(exercise)
        self.application.check(exercise)

    def watch(self, request: dict):
        exercise = str(request.get("exercise"))
        self.watched[exercise] = answers.read(exercise)["version"]


def words_of_shot(chapter: str, shot) -> list[str]:
    if shot not in [one["name"] for one in shots(chapter)]:
        raise Refused(404, f"chapter {chapter[:2]} has no such picture")
    return ["--shot", shot]


def words_of_cell(chapter: str, picture) -> list[str]:
    """Command line for a cell of docs/images/pictures.json; its knobs are the page's to turn."""
    name, i = picture if isinstance(picture, list) and len(picture) == 2 else (None, None)
    known = cells(name) if isinstance(name, str) and name in made() else []
    if isinstance(i, bool) or not isinstance(i, int) or not 0 <= i < len(known) or known[i]["chapter"] != chapter:
        raise Refused(404, f"chapter {chapter[:2]} has no such picture")
    return [word for kind in ("shot", "scene") if kind in known[i] for word in (f"--{kind}", known[i][kind])]


def what_to_draw(request: dict) -> tuple[str, dict]:
    """The chapter, and the request to its program. A page names a shot or a cell of a lesson's picture, and never a file.
    Raises Refused."""
    chapter = request.get("chapter")
    if chapter not in chapters():
        raise Refused(404, "there is no such chapter")
    try:
        words = words_of_cell(chapter, request["picture"]) if "picture" in request else words_of_shot(chapter, request.get("shot"))
    except Failure as why:
        raise Refused(500, str(why)) from None
    asked = {key: request[key] for key in PASSED_ON if key in request}
    return chapter, asked | {"words": words, "still": request.get("still") is True}


class Work:
    """Checks and builds, one of a kind at a time, told to every page."""

    def __init__(self, application, build: bool):
        self.application, self.build, self.running, self.again = application, build, {}, set()

    def tell(self, event: dict):
        for socket in list(Socket.sockets):
            socket.tell(event)

    def start(self, kind: str, exercise: str):
        """A check or a build; another one after it where one is running."""
        if (kind, exercise) in self.running:
            self.again.add((kind, exercise))
            return
        self.running[kind, exercise] = asyncio.ensure_future(self.run(kind, exercise))

    async def run(self, kind: str, exercise: str):
        said = {"check": "checking", "build": "building"}[kind]

        def say(line: str):
            self.tell({"event": "working", "exercise": exercise, "words": line[:300]})
        try:
            say(said)
            if kind == "check":
                result = await answers.check(exercise, say, self.build)
                if not self.application.closing:
                    self.application.verdicts.keep(exercise, result["digest"], result)
                self.tell({"event": "checked", "result": result, "progress": self.application.verdicts.progress()})
            else:
                chapter, _ = answers.file_of(exercise)
                self.tell({"event": "built", "exercise": exercise, "ok": await answers.build_chapter(chapter, say)})
        except (Refused, OSError) as why:
            self.tell({"event": "working", "exercise": exercise, "words": str(why)})
        finally:
            del self.running[kind, exercise]
        if (kind, exercise) in self.again:
            self.again.discard((kind, exercise))
            self.start(kind, exercise)

    def written(self, exercise: str):
        chapter, _ = answers.file_of(exercise)
        if is_cpp(chapter, exercise) and self.build:
            self.start("build", exercise)

    def look_at_disk(self):
        """Tells each page about changed files that it shows."""
        for socket in list(Socket.sockets):
            for exercise, known in list(socket.watched.items()):
                try:
                    there = answers.read(exercise)
                except (Refused, OSError):
                    continue
                if there["version"] != known:
                    socket.watched[exercise] = there["version"]
                    socket.tell({"event": "disk", "exercise": exercise, "version": there["version"], "text": there["text"]})

    async def end(self):
        for socket in list(Socket.sockets):
            socket.sender.cancel()
            socket.gone()
        tasks = [*self.running.values(), *(socket.sender for socket in Socket.sockets)]
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
