"""The gallery: every picture of the course on one page."""

from html import escape
from pathlib import Path

from tree import write_atomically


def write_gallery(shots: list[dict], out: Path):
    """shots: chapter, name, caption, image (from out's folder), command, error (or None)."""
    figures = "".join(
        f"<figure><img src='{escape(shot['image'])}' alt='{escape(shot['name'])}'>"
        f"<figcaption>{escape(shot['caption'])} <code>{escape(shot['command'])}</code></figcaption></figure>\n"
        for shot in shots if not shot["error"])
    write_atomically(out, f"<!doctype html><meta charset='utf-8'><title>Lightwalk</title>\n{figures}")
