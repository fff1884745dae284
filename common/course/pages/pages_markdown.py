"""A lesson's Markdown as mkdocs wants it, from Markdown that reads well where it lies.

Additions of a page to a forge's rendering:

    <!-- compare -->                  the two pictures of the table that follows, under one slider; the head of the
    | flat | normal map |             table names them
    |---|---|
    | ![A](a.png) | ![B](b.png) |

    <!-- quote: FILE#MARKER -->       the block of code that follows has FILE over it; below that of a shader is a link to
                                      the whole shader
    ### 02.phong (medium)             the address #02.phong as well, and how hard it is as a mark
    <details>                         Markdown inside, in a list too

Links lead to the pages' copies: Site.target() gives the address, and notes the required file.
"""

import html
import os
import re
from pathlib import Path

from charts.drawn import vector_of
from charts.measured import has_old_times_alone, is_of_earlier
from pages.quotes import FENCE, LINK, QUOTE
from pages.tables import without_sources
from tree import ROOT, Failure, slug

EXERCISE = re.compile(r"### (\d\d\.\w+) \((easy|medium|hard)\)$")
ITEM = re.compile(r"(?:[-*+]|\d+[.)]) +(?=\S)")
DETAILS = re.compile(r"( *)<details>(?:<summary>(.*)</summary>)?$")
SUMMARY = re.compile(r" *<summary>(.*)</summary>$")
COMPARE = re.compile(r"\s*<!-- compare -->\s*$")
PICTURE = re.compile(r"!\[([^\]]*)\]\(([^)\s]+)\)$")
STUDY = re.compile(r"(?<!!)\[([^\]]*)\]\((studies/[^)\s]+?)\.md\)")
EARLIER = ' <span class="earlier" title="The chapter\'s code has changed since this study was measured.">(earlier version)</span>'
OLD_TIMES = EARLIER.replace("(earlier", "(times: earlier").replace("study was", "study's times were")
EARLIER_TABLE = '<span class="earlier">Measured with an earlier version of the code.</span>'
PICTURES = (".png", ".svg", ".jpg", ".webp")

# Texts whose own name is another page's: index.md is the first page.
MOVED = {Path("README.md"): Path("course.md"), Path("docs/index.md"): Path("terms.md")}


class Site:
    """Which files of the tree the pages show, and where. Paths are counted from the tree's root and from the site's."""

    def __init__(self):
        self.pictures: dict[Path, Path] = {}  # of the tree: of the site
        self.sources: dict[Path, Path] = {}
        self.wholes: dict[Path, Path] = {}  # shaders with all that they include
        self.texts: dict[Path, Path] = {}
        self.waiting: list[Path] = []  # texts nobody has turned yet

    def target(self, path: Path) -> Path:
        """Where a file of the tree is among the pages. Raises Failure where there is none."""
        if not (ROOT / path).exists():
            raise Failure(f"there is no {path}")
        # mkdocs ignores folders with names that begin with a dot
        inside = path.relative_to("docs") if path.parts[0] == "docs" else Path("tree", *(part.lstrip(".") for part in path.parts))
        if path.suffix in PICTURES:
            if vector := vector_of(path):  # a chart is sharper so
                return self.pictures.setdefault(vector, inside.with_suffix(".svg"))
            return self.pictures.setdefault(path, inside)
        if path.suffix != ".md":
            return self.sources.setdefault(path, Path("source") / f"{path}.md")
        if path not in self.texts:
            self.texts[path] = MOVED.get(path, inside)
            self.waiting.append(path)
        return self.texts[path]


def convert(site: Site, text: Path) -> str:
    """The Markdown for mkdocs of one text of the tree. Raises Failure, with file and line."""
    def note(files: list[str]) -> str:
        return EARLIER_TABLE if any(is_of_earlier(ROOT / file) for file in files) else ""
    lines = folded(indented(without_sources((ROOT / text).read_text(encoding="utf-8"), note).splitlines()))
    out, fence, i, whole = [], None, 0, ""
    while i < len(lines):
        line, i = lines[i], i + 1
        try:
            before, fence = fence, fence_after(fence, line)
            if before:
                out += [line] if fence or not whole else [line, "", whole]
            elif fence:
                quote = QUOTE.match(lines[i - 2]) if i > 1 else None
                out.append(titled(line, quote[1]) if quote else line)
                whole = whole_link(site, text, line, quote)
            elif COMPARE.match(line):
                out += ["", slider(site, text, lines[i:i + 3]), ""]
                i += 3
            else:
                out.append(convert_line(site, text, line))
        except Failure as failure:
            raise Failure(f"{text}:{i}: {failure}") from None
    return "\n".join(out) + "\n"


def titled(fence: str, source: str) -> str:
    """The head of a block that quotes a file. A specification is prose: its lines wrap."""
    mark, language = re.match(r"(\s*[`~]+)(.*)", fence).groups()
    if Path(source).parent.name != "exercise":
        return f'{fence} title="{source}"'
    return f'{mark} {{.{language.strip()} .spec title="{source}"}}'


def indented(lines: list[str]) -> list[str]:
    """With four spaces for each level of a list, as this Markdown requires; forges take two or three."""
    out, columns, fence = [], [], None  # where the text of each list's item begins
    for line in lines:
        indent = len(line) - len(line.lstrip())
        if line.strip() and not fence:
            while columns and indent < columns[-1]:
                columns.pop()
        begin = columns[-1] if columns else 0
        out.append(" " * (4 * len(columns)) + line[begin:] if line.strip() else "")
        fence = fence_after(fence, line)
        item = None if fence else ITEM.match(line[begin:])
        if item:
            columns.append(begin + len(item[0]))
    return out


def fence_after(fence: str | None, line: str) -> str | None:
    """Which fence is open after a line."""
    match = FENCE.match(line)
    if fence:
        return None if line.strip() == fence else fence
    return match[1] if match else None


def folded(lines: list[str]) -> list[str]:
    """With <details> as pymdownx.details writes it, because the other way to have Markdown inside knows no lists."""
    out, inside, fence = [], 0, None
    for line in lines:
        fence = fence_after(fence, line)
        details = None if fence else DETAILS.match(line)
        if details:
            if out and out[-1].strip():
                out.append("")  # a block of its own, also right below the text of a list's item
            out.append(f"{' ' * 4 * inside}{details[1]}??? \"{(details[2] or '').replace(chr(34), '&quot;')}\"")
            inside += 1
        elif inside and not fence and (summary := SUMMARY.match(line)):
            at = next(i for i in range(len(out) - 1, -1, -1) if out[i].lstrip().startswith("???"))
            out[at] = out[at].replace('""', f'"{summary[1].replace(chr(34), "&quot;")}"')
            out.append("")
        elif inside and not fence and line.strip() == "</details>":
            inside -= 1
            out.append("")
        else:
            out.append(" " * 4 * inside + line if line.strip() else line)
    return out


def whole_link(site: Site, text: Path, fence: str, quote: re.Match | None) -> str:
    """Below a block that quotes a shader, a link to all of it; empty for other blocks. An exercise's is in its file."""
    shader = Path(quote[1]) if quote else Path()
    if shader.parts[:1] != ("shaders",) or shader.parent.name in ("exercise", "solution"):
        return ""
    target = site.wholes.setdefault(shader, Path("whole") / shader.relative_to("shaders").with_suffix(f"{shader.suffix}.md"))
    indent = fence[:len(fence) - len(fence.lstrip())]
    return f"{indent}[the whole shader]({os.path.relpath(target, site.target(text).parent)}){{.whole}}"


def convert_line(site: Site, text: Path, line: str) -> str:
    exercise = EXERCISE.match(line)
    if exercise:
        name, grade = exercise.groups()
        anchor = slug(f"{name} ({grade})")
        return f'<a id="{name}" class="exercise"></a>\n\n### {name} <span class="grade {grade}">{grade}</span> {{#{anchor}}}'
    line = with_versions(text, line)
    parts = re.split(r"(`[^`]*`)", line)
    return "".join(part if part.startswith("`") else LINK.sub(lambda found: link(site, text, found), part)
                   for part in parts)


def with_versions(text: Path, line: str) -> str:
    """A line with a mark behind each table of a study that measured outdated sources."""
    def marked(found: re.Match) -> str:
        study = ROOT / text.parent / f"{found[2]}.json"
        if not is_of_earlier(study):
            return found[0]
        return found[0] + (OLD_TIMES if has_old_times_alone(study) else EARLIER)
    return STUDY.sub(marked, line)


def link(site: Site, text: Path, found: re.Match) -> str:
    """A link or a picture with its target where the pages have it."""
    old = found[1] or found[2]
    return found[0] if re.match(r"[a-z]+:|#", old) else found[0].replace(old, address(site, text, old))


def address(site: Site, text: Path, old: str) -> str:
    path, _, anchor = old.partition("#")
    named = Path(os.path.normpath(text.parent / path))
    new = os.path.relpath(site.target(named), site.target(text).parent)
    return f"{new}#{anchor}" if anchor else new


def slider(site: Site, text: Path, table: list[str]) -> str:
    """The table of two pictures as one to compare. Raises Failure where it is no such table."""
    rows = [[cell.strip() for cell in row.strip().strip("|").split("|")] for row in table]
    pictures = [PICTURE.match(cell) for cell in rows[2]] if len(rows) == 3 else []
    if [len(row) for row in rows] != [2, 2, 2] or not all(pictures):
        raise Failure("after <!-- compare --> comes a table of two names over two pictures")
    names = [html.escape(name) for name in rows[0]]
    images = "".join(f'<img src="{address(site, text, picture[2])}" alt="{html.escape(picture[1])}">'
                     for picture in pictures)
    return (f'<figure class="compare"><div class="slide">{images}<input type="range" min="0" max="100" value="50" '
            f'step="0.5" aria-label="{names[0]} left of the divider, {names[1]} right of it"></div>'
            f"<figcaption><span>{names[0]}</span><span>drag, or arrow keys</span><span>{names[1]}</span></figcaption>"
            "</figure>")
