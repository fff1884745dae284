"""Shared parts of report and gallery: one self-contained page, light or dark as the reader's system is."""

import base64
import io
import os
from importlib.util import find_spec
from pathlib import Path

from jinja2 import Environment, FileSystemLoader

from tree import BUILD, ROOT, Failure, chapter_title

TYPES = {".png": "image/png", ".svg": "image/svg+xml", ".jpg": "image/jpeg", ".webp": "image/webp"}

SMALL = 560  # 207 pictures that passed take 6 MB of a report so, and 30 at their own size
# Mkdocs' theme has small scripts and styles within its pages; nothing is asked from elsewhere.
POLICY = ("default-src 'none'; script-src 'self' 'unsafe-inline' blob:; style-src 'self' 'unsafe-inline'; font-src 'self' data:; "
          "img-src 'self' data: blob:; connect-src 'self' blob:; worker-src 'self' blob:; form-action 'none'; base-uri 'none'; "
          "frame-ancestors 'self'")

# Missing values are skipped: results have optional keys.
TEMPLATES = Environment(loader=FileSystemLoader(Path(__file__).parent / "templates"), autoescape=True, trim_blocks=True,
                        lstrip_blocks=True, keep_trailing_newline=True)


def page(template: str, **values) -> str:
    return TEMPLATES.get_template(template).render(values)


def encoded(path: Path, most: tuple[int, int] | None = None, kind: str = "WEBP", **options) -> bytes:
    """A picture in another format, at most so large. Raises OSError where it cannot be read or is no picture."""
    try:
        from PIL import Image
    except ImportError:
        raise Failure("there is no PIL; the packages are in common/course/packages/book") from None
    out = io.BytesIO()
    with Image.open(path) as picture:
        picture = picture.convert("RGB")
        if most:
            picture.thumbnail(most, Image.Resampling.LANCZOS)
        picture.save(out, kind, **options)
    return out.getvalue()


def uri(data: bytes, kind: str) -> str:
    return f"data:{kind};base64,{base64.b64encode(data).decode()}"


def data_uri(path: Path, lossless: bool = True) -> str:
    """A picture as a data URI: as it is, or as a WebP of at most SMALL pixels a side, where exact pixels do not matter. Raises
    OSError where it cannot be read or is no picture."""
    path = Path(path)
    data, kind = path.read_bytes(), TYPES.get(path.suffix.lower(), "application/octet-stream")
    if kind == "image/png" and not data.startswith(b"\x89PNG"):
        raise OSError(f"{path} is not a PNG")
    if not lossless and find_spec("PIL") and kind == "image/png":  # ./course run does without it
        data, kind = encoded(path, (SMALL, SMALL), quality=80, method=4), "image/webp"
    return uri(data, kind)


def chart_uri(path: Path) -> str:
    """A chart as a data URI: a WebP of the same pixels, which takes a quarter less than the PNG. Raises OSError as data_uri()."""
    if not find_spec("PIL") or Path(path).suffix != ".png":
        return data_uri(path)
    return uri(encoded(path, lossless=True, quality=50, method=2), "image/webp")


def lesson_link(chapter: str, folder: Path) -> str:
    """The chapter's lesson, from a folder: its page where ./course docs made it, else its text; empty without any."""
    for path in (BUILD / "docs" / f"{chapter}.html", ROOT / "docs" / f"{chapter}.md"):
        if path.exists():
            return os.path.relpath(path, folder)
    return ""


TEMPLATES.filters["chapter_title"] = chapter_title
