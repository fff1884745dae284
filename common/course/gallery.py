"""The gallery: every picture of the course on one page, chapter by chapter."""

import os
from html import escape
from pathlib import Path

from page import chapter_title, page
from tree import ROOT, write_atomically

STYLE = """
.shots { display: grid; grid-template-columns: repeat(auto-fill, minmax(330px, 1fr)); gap: 18px; }
figure { margin: 0; background: var(--card); border: 1px solid var(--line); border-radius: 10px; overflow: hidden;
  display: flex; flex-direction: column; }
figure a img { width: 100%; aspect-ratio: 16 / 9; object-fit: cover; background: var(--code); }
figcaption { padding: 10px 14px 12px; display: flex; flex-direction: column; gap: 6px; flex: 1; }
figcaption code { margin-top: auto; align-self: start; }
.missing { aspect-ratio: 16 / 9; display: grid; place-items: center; padding: 12px; color: var(--bad);
  background: var(--bad-soft); overflow: auto; font-size: 13.5px; }
h2 { display: flex; justify-content: space-between; align-items: baseline; gap: 14px; }
h2 a { font-size: 16px; font-weight: 400; }
"""


def write_gallery(shots: list[dict], out: Path):
    """shots: chapter, name, caption, image (from out's folder), command, error (or None), and where it has one "lesson"
    (from out's folder); without it docs/NN_name.md, if there is one."""
    chapters = list(dict.fromkeys(shot["chapter"] for shot in shots))
    links = "".join(f'<li><a href="#{escape(chapter)}">{escape(chapter_title(chapter))}</a></li>'
                    for chapter in chapters)
    drawn = sum(not shot["error"] for shot in shots)
    body = (f"<h1>Lightwalk</h1>\n<p>{drawn} pictures of {len(chapters)} chapters. A click shows one in full; the "
            f"line below it draws it again.</p>\n<nav><ul>{links}</ul></nav>\n") if shots else \
        "<h1>Lightwalk</h1>\n<p>No chapter has a picture yet.</p>\n"
    for chapter in chapters:
        of_chapter = [shot for shot in shots if shot["chapter"] == chapter]
        body += (f'<section id="{escape(chapter)}">\n<h2><span>{escape(chapter_title(chapter))}</span>'
                 f'{lesson_link(chapter, of_chapter[0], out)}</h2>\n'
                 f'<div class="shots">\n{"".join(figure(shot) for shot in of_chapter)}</div>\n</section>\n')
    write_atomically(out, page("Lightwalk: gallery", body, STYLE))


def lesson_link(chapter: str, shot: dict, out: Path) -> str:
    lesson = shot.get("lesson")
    path = ROOT / "docs" / f"{chapter}.md"
    if not lesson and path.exists():
        lesson = os.path.relpath(path, Path(out).parent)
    return f'<a href="{escape(lesson)}">the lesson</a>' if lesson else ""


def figure(shot: dict) -> str:
    if shot["error"]:
        picture = f'<div class="missing"><p>not drawn: {escape(shot["error"])}</p></div>'
    else:
        image = escape(shot["image"])
        picture = (f'<a href="{image}"><img src="{image}" loading="lazy" '
                   f'alt="{escape(shot["name"])}: {escape(shot["caption"])}"></a>')
    return (f'<figure>{picture}<figcaption><span><strong>{escape(shot["name"])}</strong><br>{escape(shot["caption"])}'
            f'</span><code>{escape(shot["command"])}</code></figcaption></figure>\n')
