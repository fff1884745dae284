"""Pictures with states: each picture of a lesson again with other values of the knobs that its text names, drawn ahead.

A link in the text or a control below the picture shows them without a server (site/run/states.js); a picture has at most eight. A
point of a chart has its picture in the same way. In a page they are attributes: data-knob and data-value of code, data-states and
data-points of images.
"""

import html
import json
import re
import shutil
from pathlib import Path

from charts.drawn import study_of
from charts.points import can_draw, command_of, places_of
from pages import knob_links
from pages.drawn_pictures import SAMPLED_ONCE, Picture, draw, fine, put, shot_of, size_of
from shots.golden import golden_path
from shots.rendering import text
from tree import ROOT, Failure, chapter_program, warn

MOST_STATES = 8
SIZE = (480, 270)
SAMPLES = "2"  # of a state, half as wide as the lesson's picture
IMAGE = re.compile(r'<img [^>]*src="tree/tests/(\d\d_\w+)/golden/(\w+)\.png"[^>]*>')
CHART = re.compile(r'<img [^>]*src="studies/([\w.]+)\.svg"[^>]*>')


def state(chapter: str, shot: str, knob: str = "", value: str = "") -> Picture:
    """A shot with one knob changed, or as it is, at the size of states."""
    width, height = size_of(chapter, shot)
    scale = min(SIZE[0] / width, 1)
    size = f"{round(width * scale)}x{round(height * scale)}"
    given = ("--set", f"{knob}={value}") if knob else ()
    samples = "1" if chapter in SAMPLED_ONCE else SAMPLES
    return Picture(chapter, shot, ("--shot", shot, "--size", size, "--samples", samples, *given))


def given(chapter: str, shot: str, knob: dict, knobs: list[dict]) -> str:
    for name, value in shot_of(chapter, shot).get("set", {}).items():
        if knob_links.find(knobs, name) is knob:
            return text(value)
    return knob_links.default_text(knob)


def planned(page: str, chapter: str, knobs: list[dict]) -> list[tuple[str, str, str]]:
    """The states of a page's pictures: (shot, knob, value), at most MOST_STATES of a shot. A value in the text goes to the picture
    above it, or to the next one with room; a knob without a value brings all its options; the page's values fill the rest."""
    places, plan = places_of_shots(page, chapter), []
    marks = knob_links.Marks(page, knobs).found
    valued = [mark for mark in marks if mark[2] is not None]

    def near(place: int) -> list[str]:
        return sorted(places, key=lambda shot: min(place - at if at < place else 2 * len(page) for at in places[shot]))

    def count(shot: str) -> int:
        return sum(one[0] == shot for one in plan)

    def add(shot: str, knob: dict, value: str) -> bool:
        entry = (shot, knob["name"], value)
        if entry not in plan and count(shot) < MOST_STATES and not same(value, given(chapter, shot, knob, knobs)):
            plan.append(entry)
        return entry in plan
    for place, knob, value in valued:
        next((shot for shot in near(place) if add(shot, knob, value)), None)
    for place, knob, value in marks:
        if value is None and places:
            has = {entry[0] for entry in plan if entry[1] == knob["name"]}
            shot = next((one for one in near(place) if one in has or count(one) < MOST_STATES), near(place)[0])
            named = [other for _, one, other in valued if one is knob]
            for one in knob_links.options(knob) or [*named, *around(knob, given(chapter, shot, knob, knobs))]:
                add(shot, knob, one)
    for shot in places:
        for _, knob, value in valued:
            add(shot, knob, value)
    return plan


def places_of_shots(page: str, chapter: str) -> dict[str, list[int]]:
    places = {}
    for image in IMAGE.finditer(page):
        if image[1] == chapter:
            places.setdefault(image[2], []).append(image.start())
    return places


def around(knob: dict, base: str) -> list[str]:
    """Other values of a number that a slider shows: less and more, within its range."""
    if not knob_links.is_number(knob):
        return []
    low, high = knob["range"]
    value = float(base)
    tried = (0.25 * value, 4 * value) if value else (low + 0.1 * (high - low), low + 0.5 * (high - low))
    whole = knob["type"] == "integer"
    return [str(round(one)) if whole else f"{float(f'{one:.3g}'):g}" for one in tried if low <= one <= high]


def same(one: str, other: str) -> bool:
    try:
        return float(one) == float(other)
    except ValueError:
        return one == other


def offer(made: Path, only: list[str]) -> None:
    """Draws the pictures of these chapters, which must be built, with sixteen samples, and their states, and puts both into the pages."""
    for chapter in only:
        if not chapter_program(chapter).exists():
            raise Failure(f"{chapter[:2]} is not built, which draws its lesson's pictures: ./course run {chapter[:2]}")
    pages = {page: page.read_text(encoding="utf-8") for page in sorted(made.glob("*.html"))}
    fines = [fine(*one) for one in sorted({image.groups() for page in pages.values() for image in IMAGE.finditer(page)}) if one[0] in only]
    plans = {page: (chapter, planned(words, chapter, knob_links.knobs_of(chapter))) for page, words in pages.items()
             if (chapter := knob_links.chapter_of(page.stem)) in only}
    points = {name: points_of(name) for page in plans for name in CHART.findall(pages[page])}
    states = [state(chapter, *one) for chapter, plan in plans.values() for one in [*((shot,) for shot, *_ in plan), *plan]]
    wrong = draw([*fines, *states, *(picture for found in points.values() for _, picture in found)])
    for picture, words in wrong.items():
        warn(f"{picture.chapter}: {' '.join(picture.words)}: {words}")
    for one in fines:
        if one not in wrong:
            shutil.copyfile(one.file(), made / "tree" / golden_path(one.chapter, one.name).relative_to(ROOT))
    for page, (chapter, plan) in plans.items():
        words = with_states(made, pages[page], chapter, plan, wrong)
        page.write_text(CHART.sub(lambda image: with_points(made, image, points[image[1]], wrong), words), encoding="utf-8")


def with_states(made: Path, page: str, chapter: str, plan: list, wrong: dict) -> str:
    """The page with marks at its knobs and states at its pictures, but for those that look like the picture as it is."""
    knobs, places = knob_links.knobs_of(chapter), []
    for shot, there in places_of_shots(page, chapter).items():
        base, entries = state(chapter, shot), {}
        for _, name, value in (one for one in plan if one[0] == shot):
            picture = state(chapter, shot, name, value)
            if picture in wrong or picture.file().read_bytes() == base.file().read_bytes():
                continue
            knob = next(knob for knob in knobs if knob["name"] == name)
            entries.setdefault(name, {"knob": name, "help": knob["help"], "unit": knob.get("unit", ""), "number": knob_links.is_number(knob),
                                      "base": given(chapter, shot, knob, knobs), "files": {}})["files"][value] = put(made, picture)
        if entries:
            places += [(place, {"base": put(made, base), "knobs": list(entries.values())}) for place in there]
    for place, told in sorted(places, key=lambda one: -one[0]):
        page = with_attribute(page, place, "states", told)
    return knob_links.marked(page, knobs)


def with_attribute(page: str, place: int, name: str, value) -> str:
    """The page with an attribute of JSON at the image that begins at a place."""
    told = html.escape(json.dumps(value, ensure_ascii=False, separators=(",", ":")))
    return f'{page[:place + 5]}data-{name}="{told}" {page[place + 5:]}'


def points_of(chart: str) -> list[tuple[dict, Picture]]:
    """Points of a chart and their pictures: the first point of each method, at most eight."""
    path = study_of(chart)
    study = json.loads(path.read_text(encoding="utf-8")) if path else {}
    if not path or not can_draw(study):
        return []
    found = {}
    for point in places_of(path).get(chart, []):
        told = study["points"][point["point"]]
        words = command_of(study, told)
        if words and told["method"] not in found and len(found) < MOST_STATES:
            words = ("--size", "{}x{}".format(*SIZE), *words)
            found[told["method"]] = (point, Picture(study["chapter"], "chart", words))
    return list(found.values())


def with_points(made: Path, image: re.Match, points: list, wrong: dict) -> str:
    told = [{"x": point["x"], "y": point["y"], "words": point["words"], "file": put(made, picture)}
            for point, picture in points if picture not in wrong]
    return with_attribute(image[0], 0, "points", told) if told else image[0]
