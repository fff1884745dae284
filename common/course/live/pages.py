"""The server's contents: the pages of ./course docs with one more script, and that script's data."""

import asyncio
import json
import mimetypes
import re
from pathlib import Path

from live import answers
from live.answers import Refused
from live.guard import Guarded
from pages import knob_links
from shots.golden import golden_path
from tornado.web import HTTPError
from tree import chapters, shots

SITE = Path(__file__).parent / "site"
SCRIPTS = ["client.js", "picture.js", "knobs.js", "panel.js", "exercise.js", "chart.js", "start.js"]
STYLES = ["live.css"]
OURS = {name: SITE / name for name in [*SCRIPTS, *STYLES]}
# Scripts that check and draw without a server.
ALONE = re.compile(rb'<script src="[^"]*assets/run/(?!exercise)[^"]*"></script>')


def head(depth: int) -> str:
    """Additions to a page where the server answers; without them it equals the one on disk."""
    up = "../" * depth
    return "".join(f'<link rel="stylesheet" href="{up}live/{name}">' for name in STYLES) + \
           "".join(f'<script defer src="{up}live/{name}"></script>' for name in SCRIPTS)


class Page(Guarded):
    def initialize(self, folder: Path):
        self.folder = folder

    async def get(self, path: str):
        if "\0" in path:
            raise HTTPError(404, reason="There is no such page")
        file = self.folder / (path or "index.html")
        try:
            inside = file.resolve().is_relative_to(self.folder.resolve()) and file.is_file()
        except OSError:  # a name that is too long
            inside = False
        if not inside:
            raise HTTPError(404, reason="There is no such page")
        data = file.read_bytes()
        kind = mimetypes.guess_type(file.name)[0] or "application/octet-stream"
        if file.suffix == ".html":
            data = ALONE.sub(b"", data).replace(b"</head>", head(path.count("/")).encode() + b"</head>", 1)
            chapter = knob_links.chapter_of(file.stem) if file.parent == self.folder else None
            if knobs := await asyncio.to_thread(knob_links.knobs_of, chapter) if chapter else []:
                data = knob_links.marked(data.decode("utf-8"), knobs).encode("utf-8")
            kind = "text/html; charset=utf-8"
        self.set_header("Content-Type", kind)
        self.finish(data)


class Ours(Guarded):
    def get(self, name: str):
        if name not in OURS:
            raise HTTPError(404, reason="There is no such file")
        self.set_header("Content-Type", {".js": "text/javascript; charset=utf-8", ".css": "text/css"}[Path(name).suffix])
        self.finish(OURS[name].read_bytes())


class Golden(Guarded):
    """The accepted picture of a shot: shown until its chapter draws it."""

    def get(self, chapter: str, shot: str):
        if chapter not in chapters() or shot not in [one["name"] for one in shots(chapter)] or \
                not golden_path(chapter, shot).is_file():
            raise HTTPError(404, reason="There is no such picture")
        self.set_header("Content-Type", "image/png")
        self.finish(golden_path(chapter, shot).read_bytes())


class Answer(Guarded):
    """JSON, and refusals as JSON."""

    def say(self, value, status: int = 200):
        self.set_status(status)
        self.set_header("Content-Type", "application/json")
        self.finish(json.dumps(value))

    def refuse(self, why: Refused):
        self.say({"error": str(why)} | why.more, why.status)


class Course(Answer):
    def get(self):
        self.say(answers.catalogue(self.application.refine) | {"progress": self.application.verdicts.progress()})


class Knobs(Answer):
    """The knobs of a chapter, as --list knobs --json tells them."""

    async def get(self, chapter: str):
        if chapter not in chapters():
            raise HTTPError(404, reason="There is no such chapter")
        knobs = await asyncio.to_thread(knob_links.knobs_of, chapter)
        if knobs:
            self.say(knobs)
        else:
            self.refuse(Refused(503, f"chapter {chapter[:2]} is not built: ./course run {chapter[:2]} builds it"))


class Exercise(Answer):
    """An exercise's file: read, and written if it is unchanged since the page read it."""

    def get(self, exercise: str):
        try:
            self.say(answers.read(exercise))
        except Refused as why:
            self.refuse(why)

    def put(self, exercise: str):
        try:
            try:
                request = json.loads(self.request.body)
            except (ValueError, RecursionError):
                raise Refused(400, "the request is not JSON") from None
            if not isinstance(request, dict):
                raise Refused(400, "the request is not an object")
            said = answers.write(exercise, request.get("text"), request.get("base"))
        except Refused as why:
            return self.refuse(why)
        except OSError as error:
            return self.refuse(Refused(500, f"it could not be written: {error.strerror}"))
        self.application.written(exercise)
        self.say(said)
