"""Marks in a page: each knob and each value of a knob that a text names.

`<code>pcf</code>` becomes `<code data-knob="shadow.filter" data-value="pcf">`, where the text means a knob of its chapter: by
the knob's path or by its name as --set takes it (`filter`, `bias_m = 0`), by a value behind a knob in the same block
(`method` ... `hard`), or by an option that one knob alone has. The pages of ./course serve turn that knob; the site shows a
picture that was drawn with it.
"""

import functools
import html
import json
import re
import subprocess
from html.parser import HTMLParser
from pathlib import Path

from tree import ROOT, chapter_program, chapters, lesson_pages

BLOCKS = ("p", "li", "td", "summary")
ELSEWHERE = ("pre", "a", "h1", "h2", "h3")  # code, links and headings, which do something else
ENDLESS = ("area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr")
GIVEN = re.compile(r"([\w.]+)\s*=\s*(\S+)")
NUMBER = re.compile(r"-?[\d.]+")
LIST_S = 60


def knobs_of(chapter: str) -> list[dict]:
    """The knobs of a chapter, as its program tells them, once for each build of it; none where it is not built."""
    program = chapter_program(chapter)
    return knobs_told(program, program.stat().st_mtime_ns) if program.exists() else []


@functools.cache
def knobs_told(program: Path, _built_at: int) -> list[dict]:
    said = subprocess.run([program, "--list", "knobs", "--json"], cwd=ROOT, stdout=subprocess.PIPE, timeout=LIST_S)
    return [] if said.returncode else json.loads(said.stdout)


def chapter_of(page: str) -> str | None:
    """The chapter of a lesson's page, by the page's name without its suffix."""
    return next((chapter for chapter in chapters() if page in [path.stem for path in lesson_pages(chapter)]), None)


def options(knob: dict) -> list[str]:
    return knob["options"] if knob["type"] == "choice" else ["on", "off"] if knob["type"] == "switch" else []


def is_number(knob: dict) -> bool:
    return isinstance(knob["default"], (int, float)) and not isinstance(knob["default"], bool) and "range" in knob


def default_text(knob: dict) -> str:
    value = knob["default"]
    if isinstance(value, list):
        return " ".join(f"{one:.6g}" for one in value)
    return ("on" if value else "off") if isinstance(value, bool) else value if isinstance(value, str) else f"{value:.6g}"


def find(knobs: list[dict], name: str) -> dict | None:
    """A knob by its path, or by its name as --set takes it: the one that answers to its name alone, or the only one."""
    named = [knob for knob in knobs if knob["name"].split(".")[-1] == name]
    exact = next((knob for knob in knobs if knob["name"] == name), None)
    alone = next((knob for knob in named if knob.get("alone")), None)
    return exact or alone or (named[0] if len(named) == 1 else None)


def meant(knobs: list[dict], words: str, last: dict | None) -> tuple[dict | None, str | None, bool]:
    """(the knob that a text in a code element means, its value, whether the text names the knob itself)."""
    text = re.sub(r"^--(set )?", "", words.strip())
    given = GIVEN.fullmatch(text)
    name, value = given.groups() if given else (text, None)
    if knob := find(knobs, name):
        return knob, value, True
    if words.strip().startswith("--"):  # an option of the program
        return None, None, False
    if last and (text in options(last) or is_number(last) and NUMBER.fullmatch(text)):
        return last, text, False
    owners = [knob for knob in knobs if knob["type"] == "choice" and text in knob["options"]]
    return (owners[0], text, False) if len(owners) == 1 else (None, None, False)


class Placed(HTMLParser):
    """HTML read with the place of each tag in the text: `at()` is the place of the tag that is being handled, counted in characters."""

    def read(self, page: str):
        self.lines = [0]
        for line in page.splitlines(keepends=True):
            self.lines.append(self.lines[-1] + len(line))
        self.feed(page)
        self.close()

    def at(self) -> int:
        line, column = self.getpos()
        return self.lines[line - 1] + column


class Marks(Placed):
    """The places of a page where a mark goes: `found` is a list of (place behind "<code", knob, value)."""

    def __init__(self, page: str, knobs: list[dict]):
        super().__init__(convert_charrefs=True)
        self.knobs, self.found, self.open, self.words, self.last = knobs, [], [], None, {}
        self.read(page)

    def handle_starttag(self, tag, attributes):
        if tag == "code" and not self.inside("code"):
            self.words, self.place = "", self.at() + len("<code")
        if tag not in ENDLESS:
            self.open.append((tag, self.at()))

    def handle_data(self, data):
        if self.words is not None:
            self.words += data

    def handle_endtag(self, tag):
        if tag == "code" and self.words is not None:
            self.note()
            self.words = None
        if self.inside(tag):
            while self.open.pop()[0] != tag:
                pass

    def inside(self, *tags: str) -> bool:
        return any(tag in tags for tag, _ in self.open)

    def note(self):
        block = next((one for one in reversed(self.open) if one[0] in BLOCKS), None)
        if not block or not self.inside("article") or self.inside(*ELSEWHERE):
            return
        knob, value, named = meant(self.knobs, self.words, self.last.get(block))
        if named:
            self.last[block] = knob
        if knob:
            self.found.append((self.place, knob, value))


def marked(page: str, knobs: list[dict]) -> str:
    out, done = [], 0
    for place, knob, value in Marks(page, knobs).found:
        given = "" if value is None else f' data-value="{html.escape(value)}"'
        out += [page[done:place], f' data-knob="{knob["name"]}"{given}']
        done = place
    return "".join(out) + page[done:]
