"""The gallery: every picture of the course on one page, chapter by chapter."""

from pathlib import Path

from pages.page import lesson_link, page
from tree import write_atomically

REFRESH_S = 4  # how often a browser reads the page again while it grows


def write_gallery(shots: list[dict], out: Path, states: dict | None = None, all_of_them: int = 0):
    """shots: chapter, name, caption, image (from out's folder), command, error (or None), and where it has one "lesson"
    (from out's folder); without it page.lesson_link(). With the states of the chapters' programs the page is one that grows.
    all_of_them: number of pictures that ./course run --gallery draws, where these are each chapter's best."""
    chapters = {}
    for shot in shots:
        shot["shown"] = not shot["error"] and (states is None or (out.parent / shot["image"]).exists())
        chapters.setdefault(shot["chapter"], []).append(shot)
    drawn = sum(shot["shown"] for shot in shots)
    write_atomically(out, page("gallery.html", drawn=drawn, all_of_them=all_of_them, refresh=REFRESH_S if states is not None else None, chapters=[
        {"name": chapter, "lesson": of_chapter[0].get("lesson") or lesson_link(chapter, out.parent), "shots": of_chapter,
         "waits": waits(of_chapter, states[chapter]) if states is not None else ""}
        for chapter, of_chapter in chapters.items()]))


def waits(shots: list[dict], state) -> str:
    """The missing part of a chapter; empty if complete."""
    if state.name == "failed":
        return "it does not compile"
    if state.name == "waiting":
        return "waits for the compiler"
    if state.name == "building":
        return f"compiling, step {state.done} of {state.total}" if state.total else "compiling"
    left = sum(not shot["shown"] and not shot["error"] for shot in shots)
    return f"{left} pictures to come" if left else ""
