"""A lesson as blocks of HTML, of which slides and the book are made: the same Markdown as the pages', with its pictures in it."""

import functools
import html
import os
import re
from pathlib import Path

from pages.docs import KATEX
from pages.knob_links import Placed
from pages.page import TYPES, encoded, uri
from pages.pages_markdown import Site, convert
from tree import ROOT, Failure, slug

VOID = ("img", "br", "hr", "input", "link", "meta", "col", "source", "wbr")
MOST_VECTOR_BYTES = 600_000  # a chart of more is smaller as pixels
KATEX_FACES = re.compile(r"url\(fonts/([\w-]+)\.woff2\) format\(['\"]woff2['\"]\)[^;}]*")


def markdown_to_html(text: str) -> str:
    """With the extensions that mkdocs.yml names."""
    try:
        import markdown
        from pymdownx.arithmatex import arithmatex_fenced_format
    except ImportError as error:
        raise Failure(f"there is no {error.name}; the packages are in common/course/packages/docs") from None
    maths = {"name": "math", "class": "arithmatex", "format": arithmatex_fenced_format(which="generic")}
    return markdown.markdown(text, extensions=[
        "attr_list", "md_in_html", "tables", "sane_lists", "toc", "pymdownx.details", "pymdownx.highlight", "pymdownx.arithmatex",
        "pymdownx.superfences"], extension_configs={
            "toc": {"slugify": slug}, "pymdownx.highlight": {"pygments_lang_class": True},
            "pymdownx.arithmatex": {"generic": True}, "pymdownx.superfences": {"custom_fences": [maths]}})


class Lesson:
    """One text of the tree: `html`, in which each picture is `picture(path)` and each link to another text is its words."""

    def __init__(self, text: Path, picture):
        self.text, self.site = text, Site()
        self.of = {}
        source = convert(self.site, text)
        self.html = self.with_pictures(markdown_to_html(source), picture)

    def with_pictures(self, page: str, picture) -> str:
        places = {str(target): path for path, target in self.site.pictures.items()}
        folder = self.site.target(self.text).parent

        def source(found):
            place = os.path.normpath(folder / html.unescape(found[1]))
            return f'src="{picture(places[place])}"' if place in places else found[0]
        return re.sub(r'src="([^"]+)"', source, page)


class Blocks(Placed):
    """The outermost elements of a page, in order: `found` is a list of (tag, attributes, HTML)."""

    def __init__(self, page: str):
        super().__init__(convert_charrefs=False)
        self.page, self.found, self.depth, self.begin = page, [], 0, 0
        self.read(page)

    def handle_starttag(self, tag, attributes):
        if self.depth == 0:
            self.begin, self.first = self.at(), (tag, dict(attributes))
        if tag not in VOID:
            self.depth += 1
        elif self.depth == 0:
            self.found.append((*self.first, self.get_starttag_text()))

    def handle_startendtag(self, tag, attributes):
        if tag in VOID and self.depth == 0:
            self.found.append((tag, dict(attributes), self.get_starttag_text()))

    def handle_endtag(self, tag):
        if tag in VOID:
            return
        self.depth -= 1
        if self.depth == 0:
            self.found.append((*self.first, self.page[self.begin:self.at()] + f"</{tag}>"))


def blocks(page: str) -> list[tuple[str, dict, str]]:
    return Blocks(page).found


def inner(element: str) -> str:
    return element[element.index(">") + 1:element.rindex("</")]


def words(element: str) -> str:
    return html.unescape(re.sub(r"<[^>]+>", "", element)).strip()


def embedded(path: Path, most_side: int = 1600, quality: int = 86, flat: bool = True) -> str:
    """A picture of the tree as a data URI: a vector as it is, unless it is large; pixels as JPEG, or, with `flat`, PNG where that
    is smaller. A PDF has a JPEG as it is, and a PNG unpacked."""
    file = ROOT / path
    if file.suffix == ".svg":
        if file.stat().st_size <= MOST_VECTOR_BYTES or not file.with_suffix(".png").exists():
            return uri(file.read_bytes(), TYPES[".svg"])
        file = file.with_suffix(".png")
    return pixels(file, most_side, quality, flat)


@functools.lru_cache(None)
def pixels(file: Path, most_side: int, quality: int, flat: bool) -> str:
    most = (most_side, most_side)
    jpeg = encoded(file, most, "JPEG", quality=quality, subsampling=0, optimize=True)
    png = encoded(file, most, "PNG", optimize=True) if flat else jpeg
    return uri(png, "image/png") if len(png) < len(jpeg) else uri(jpeg, "image/jpeg")


def katex_css() -> str:
    css = (KATEX / "katex.min.css").read_text(encoding="utf-8")
    return KATEX_FACES.sub(lambda found: f"url({uri((KATEX / 'fonts' / f'{found[1]}.woff2').read_bytes(), 'font/woff2')}) format('woff2')",
                           css)


def katex_js() -> str:
    return (KATEX / "katex.min.js").read_text(encoding="utf-8").replace("</script", "<\\/script")


def code_css() -> str:
    try:
        from pygments.formatters import HtmlFormatter
    except ImportError as error:
        raise Failure(f"there is no {error.name}; the packages are in common/course/packages/docs") from None
    return HtmlFormatter(style="tango").get_style_defs(".highlight")
