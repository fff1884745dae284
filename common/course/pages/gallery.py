"""The gallery: every picture of the course on one page, chapter by chapter."""

from pathlib import Path

from pages.page import lesson_link, page
from tree import write_atomically


def write_gallery(shots: list[dict], out: Path):
    """shots: chapter, name, caption, image (from out's folder), command, error (or None), and where it has one "lesson"
    (from out's folder); without it page.lesson_link()."""
    chapters = {}
    for shot in shots:
        chapters.setdefault(shot["chapter"], []).append(shot)
    write_atomically(out, page("gallery.html", drawn=sum(not shot["error"] for shot in shots), chapters=[
        {"name": chapter, "lesson": of_chapter[0].get("lesson") or lesson_link(chapter, out.parent), "shots": of_chapter}
        for chapter, of_chapter in chapters.items()]))
