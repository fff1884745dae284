"""What the report and the gallery share: one self-contained page, light or dark as the reader's system is."""

import base64
import io
from html import escape
from pathlib import Path

try:
    from PIL import Image
except ImportError:  # ./course run does not need it; pictures are then embedded as they lie on disk
    Image = None

TYPES = {".png": "image/png", ".svg": "image/svg+xml", ".jpg": "image/jpeg", ".webp": "image/webp"}

STYLE = """
:root { color-scheme: light dark; --paper: #fbfbfa; --card: #fff; --ink: #1d2129; --quiet: #5f6975; --line: #dfe3e8;
  --accent: #0b63b0; --good: #18794e; --good-soft: #e2f4ea; --bad: #b42318; --bad-soft: #fdebe9; --code: #f1f3f5; }
@media (prefers-color-scheme: dark) { :root { --paper: #14171c; --card: #1c2027; --ink: #e8eaed; --quiet: #9aa4b1;
  --line: #323843; --accent: #79b8ff; --good: #56d39b; --good-soft: #173528; --bad: #ff8f85; --bad-soft: #432320;
  --code: #262b34; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
main { max-width: 1240px; margin: 0 auto; padding: 24px 24px 80px; }
h1 { font-size: 30px; margin: 8px 0 0; letter-spacing: -.01em; }
h2 { font-size: 23px; margin: 48px 0 12px; padding-top: 12px; border-top: 1px solid var(--line); }
h3 { font-size: 17px; margin: 26px 0 10px; }
p { margin: 6px 0; max-width: 78ch; }
a { color: var(--accent); }
code, pre { font: 13.5px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; background: var(--code); border-radius: 4px; }
code { padding: 1px 5px; overflow-wrap: anywhere; }
pre { padding: 10px 12px; overflow: auto; max-height: 340px; white-space: pre-wrap; }
img { display: block; max-width: 100%; height: auto; }
.quiet { color: var(--quiet); }
.badge { display: inline-block; padding: 0 9px; border-radius: 99px; font-size: 13.5px; font-weight: 600; }
.badge.good { color: var(--good); background: var(--good-soft); }
.badge.bad { color: var(--bad); background: var(--bad-soft); }
nav ul { display: flex; flex-wrap: wrap; gap: 8px; padding: 0; margin: 14px 0; list-style: none; }
nav a { display: block; padding: 3px 12px; border: 1px solid var(--line); border-radius: 99px; background: var(--card);
  text-decoration: none; }
nav a.bad { border-color: var(--bad); color: var(--bad); }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 14px 16px; margin: 14px 0;
  break-inside: avoid; }
.card.bad { border-left: 5px solid var(--bad); }
.card h3 { margin: 0 0 4px; }
table { border-collapse: collapse; width: 100%; font-size: 14.5px; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 6px 10px; border-bottom: 1px solid var(--line); vertical-align: top; }
th { color: var(--quiet); font-weight: 600; }
td.number, th.number { text-align: right; white-space: nowrap; }
tr.bad td { background: var(--bad-soft); }
.wide { overflow-x: auto; }
:focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; border-radius: 4px; }
"""


def page(title: str, body: str, style: str = "", script: str = "") -> str:
    """A whole HTML document. `body`, `style` and `script` are trusted; escape what came from a file."""
    end = f"<script>{script}</script>\n" if script else ""
    return (f'<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{escape(title)}</title>\n'
            '<meta name="viewport" content="width=device-width, initial-scale=1">\n<link rel="icon" href="data:,">\n'
            f"<style>{STYLE}{style}</style>\n</head>\n<body>\n<main>\n{body}</main>\n{end}</body>\n</html>\n")


def data_uri(path: Path, lossless: bool = True) -> str:
    """A picture as a data URI: as it is, or as WebP of quality 92, about a tenth of the size, where exact pixels do not
    matter. Raises OSError where it cannot be read or is no picture."""
    path = Path(path)
    data, kind = path.read_bytes(), TYPES.get(path.suffix.lower(), "application/octet-stream")
    if kind == "image/png" and not data.startswith(b"\x89PNG"):
        raise OSError(f"{path} is not a PNG")
    if not lossless and Image and kind == "image/png":
        out = io.BytesIO()
        with Image.open(io.BytesIO(data)) as picture:
            picture.convert("RGB").save(out, "WEBP", quality=92, method=4)
        data, kind = out.getvalue(), "image/webp"
    return f"data:{kind};base64,{base64.b64encode(data).decode()}"


def table(head: list[str], rows: list[list[str]], bad: list[bool] | None = None, numbers: tuple = ()) -> str:
    """A table of cells that are HTML already; `bad` marks rows, `numbers` are the columns to be set flush right."""
    def cells(tag, row):
        return "".join(f'<{tag}{" class=number" if i in numbers else ""}>{cell}</{tag}>' for i, cell in enumerate(row))

    marks = bad or [False] * len(rows)
    body = "".join(f'<tr{" class=bad" if mark else ""}>{cells("td", row)}</tr>\n' for row, mark in zip(rows, marks))
    return f'<div class="wide"><table>\n<tr>{cells("th", head)}</tr>\n{body}</table></div>\n'


def chapter_title(chapter: str) -> str:
    """"02_lambert_phong" as a person writes it."""
    number, _, name = chapter.partition("_")
    return f"{number} {name.replace('_', ' ')}" if name else chapter
