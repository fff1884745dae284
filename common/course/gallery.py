"""The gallery: every picture of the course on one page, chapter by chapter."""

import os
from pathlib import Path

from page import page
from tree import ROOT, write_atomically


def write_gallery(shots: list[dict], out: Path):
    """shots: chapter, name, caption, image (from out's folder), command, error (or None), and where it has one "lesson"
    (from out's folder); without it docs/NN_name.md, if there is one."""
    chapters = {}
    for shot in shots:
        chapters.setdefault(shot["chapter"], []).append(shot)
    write_atomically(out, page("gallery.html", drawn=sum(not shot["error"] for shot in shots), chapters=[
        {"name": chapter, "lesson": of_chapter[0].get("lesson") or lesson(chapter, out), "shots": of_chapter}
        for chapter, of_chapter in chapters.items()]))


def lesson(chapter: str, out: Path) -> str:
    path = ROOT / "docs" / f"{chapter}.md"
    return os.path.relpath(path, Path(out).parent) if path.exists() else ""
