"""Charts that answer: the points under the pointer, and the picture that was measured beside its truth and its error."""

import asyncio
import json
import tempfile
from pathlib import Path

from charts import drawn
from charts.points import can_draw, places_of, request_of
from live.answers import Refused
from live.pages import Answer
from shots.golden import compare
from tree import Failure

SIZE = [480, 270]
ERROR = "chart.2"  # the place of the third picture


def study_of(chart) -> Path:
    if path := isinstance(chart, str) and drawn.study_of(chart):
        return path
    raise Refused(404, "there is no such chart")


class Points(Answer):
    async def get(self, chart: str):
        try:
            path = study_of(chart)
            places = await asyncio.to_thread(places_of, path)
            self.say({"points": places.get(chart, []), "draws": can_draw(json.loads(path.read_text(encoding="utf-8")))})
        except Refused as why:
            self.refuse(why)
        except Failure as why:
            self.refuse(Refused(500, str(why)))


def requests_of(chart, number) -> tuple[str, dict, dict]:
    """The chapter, and the requests for a point's picture and for its truth. Raises Refused."""
    study = json.loads(study_of(chart).read_text(encoding="utf-8"))
    if not can_draw(study) or isinstance(number, bool) or not isinstance(number, int) or not 0 <= number < len(study["points"]):
        raise Refused(404, "there is no picture of that point")
    requests = [request_of(study, study["points"][number], truth) for truth in (False, True)]
    if None in requests:
        raise Refused(404, "there is no scene of that point")
    return study["chapter"], *({"words": ["--scene", file], "size": SIZE, "still": True, "set": knobs} for file, knobs in requests)


async def show(socket, chart, number):
    """Sends a point's picture, its truth and the error between them, each to a place of the page, or words where one cannot be made."""
    programs = socket.application.programs
    chapter, *requests = requests_of(chart, number)
    answered = [asyncio.get_running_loop().create_future() for _ in requests]
    for i, request in enumerate(requests):
        def deliver(answer, picture, i=i):
            socket.deliver(f"chart.{i}", number, answer, picture)
            if not answered[i].done():
                answered[i].set_result((answer, picture))
        programs.ask(chapter, (socket, f"chart.{i}"), request, deliver)
    try:
        done = await asyncio.gather(*answered)
        if any(answer["code"] for answer, _ in done):
            raise Failure("the error needs both pictures")
        mean, heat = await asyncio.to_thread(compared, *(picture for _, picture in done))
    except Failure as why:
        socket.deliver(ERROR, number, {"code": 1, "error": str(why), "format": "png"}, b"")
    else:
        socket.deliver(ERROR, number, {"code": 0, "error": "", "format": "png", "flip_mean": mean}, heat)


def compared(picture: bytes, truth: bytes) -> tuple[float | None, bytes]:
    """FLIP's mean, where it has one, and its map. Raises Failure."""
    with tempfile.TemporaryDirectory(prefix="lightwalk_error_") as folder:
        files = [Path(folder, name) for name in ("picture.png", "truth.png", "error.png")]
        for file, data in zip(files, (picture, truth)):
            file.write_bytes(data)
        return compare(files[1], files[0], files[2])["flip"]["mean"], files[2].read_bytes()
