"""The socket of a page: requests and pictures, checks, and changes on disk."""

import asyncio
import json
import re
import struct

from live import answers, charts
from live.answers import Refused
from live.guard import Bucket, Guarded
from live.programs import is_cpp
from pages.made import cells, made
from tornado.iostream import StreamClosedError
from tornado.web import HTTPError
from tornado.websocket import WebSocketClosedError, WebSocketHandler
from tree import Failure, chapters, shots

MESSAGE_BYTES = 1 << 16
MESSAGES_A_S, MESSAGES_AT_ONCE = 150, 400
MOST_SOCKETS = 40
MOST_PLACES = 64  # pictures on one page
MOST_EVENTS = 200
SEND_S = 20  # a page that takes nothing for so long is gone
MOST_PIXELS = 1920 * 1080
USE = re.compile(r"(solution|exercise)(,\d\d\.\w{1,40}=(solution|exercise)){0,20}")


class Socket(WebSocketHandler, Guarded):
    sockets = set()

    def prepare(self):
        Guarded.prepare(self)
        if len(self.sockets) >= MOST_SOCKETS:
            raise HTTPError(503, reason=f"More than {MOST_SOCKETS} pages are open")

    def check_origin(self, origin):
        return self.application.guard.knows_origin(self.request)

    def open(self, *_):
        self.bucket = Bucket(MESSAGES_A_S, MESSAGES_AT_ONCE)
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
        if not self.bucket.take():
            self.close(1008, "too many messages")
            return
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


def number(value, low: float, high: float) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not low <= value <= high:
        raise Refused(400, f"expected a number from {low:g} to {high:g}")
    return value


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
    size = request.get("size", [480, 270])
    if not isinstance(size, list) or len(size) != 2:
        raise Refused(400, "a size is two numbers")
    size = [int(number(side, 16, 2048)) for side in size]
    if size[0] * size[1] > MOST_PIXELS:
        raise Refused(400, f"a picture has at most {MOST_PIXELS} pixels")
    asked = {"words": words, "size": size, "still": request.get("still") is True}
    for name, low, high in (("turn_rad", -1e3, 1e3), ("tilt_rad", -10, 10), ("notches", -200, 200), ("time_s", -1e6, 1e6)):
        if name in request:
            asked[name] = number(request[name], low, high)
    if "pan" in request:
        if not isinstance(request["pan"], list) or len(request["pan"]) != 2:
            raise Refused(400, "pan is two numbers")
        asked["pan"] = [number(share, -1e3, 1e3) for share in request["pan"]]
    knobs = request.get("set", {})
    if not isinstance(knobs, dict) or len(knobs) > 300 or not all(
            isinstance(value, str) and len(value) < 200 and len(name) < 200 for name, value in knobs.items()):
        raise Refused(400, "knobs are short texts by name")
    use, look = request.get("use", "solution"), request.get("look", "")
    if not isinstance(use, str) or not USE.fullmatch(use) or not isinstance(look, str) or len(look) > 200:
        raise Refused(400, "use and look are as --use and --look take them")
    return chapter, asked | {"set": knobs, "use": use, "look": look}


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
                    self.application.verdicts.keep(exercise, result["version"], result)
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
        """An exercise was saved by a page: one in C++ is built."""
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
