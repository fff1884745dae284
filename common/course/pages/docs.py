"""Makes the lessons into pages that need no network: build/docs."""

import json
import logging
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from charts.drawn import draw_charts, shown_by_lessons, study_of
from check.check import in_order
from pages import running
from pages.drawn_pictures import finest
from pages.page import TEMPLATES
from pages.pages_markdown import MOVED, Site, convert
from pages.reading import minutes
from pages.shader import whole
from tree import BUILD, ROOT, Failure, UsageError, best_first, chapters, lessons, relative, say, write_atomically

ALONE = True
HELP = """Writes the lessons as pages: build/docs/index.html.

They open without a server and without a network, with typeset formulas, coloured code and a search.

  ./course docs                 write the pages
  ./course docs --open          write the pages and open them in the browser
  ./course docs --site FOLDER   write a site for any static host (docs/publish.md)

What else is made of lessons; each takes --help:

  ./course docs --slides [02]   slides of a lesson, one HTML file that needs no network
  ./course docs --book          one PDF of all lessons
  ./course docs --quote         fill the code and tables that lessons quote from the source
  ./course docs --check [02]    run what lessons name, and compare the output with the text"""
KATEX = Path("/usr/share/javascript/katex")
LATO = Path("/usr/share/fonts/truetype/lato")
LANGUAGES = {".frag": "glsl", ".comp": "glsl",
             ".py": "python", ".sh": "bash", ".json": "json", ".cmake": "cmake", ".cpp": "cpp", ".h": "cpp"}
OTHERS = {"which.md": "What should I use?", "index.md": "Index", "keys.md": "Keys", "formats.md": "Model formats", "vulkan.md": "Vulkan without the framework",
          "descriptors.md": "Where do descriptors live?",
          "framework.md": "The framework",
          "pixel.md": "From the command to a pixel", "serve.md": "Live lessons",
          "teaching.md": "For instructors", "development.md": "For developers", "elsewhere.md": "Windows and macOS",
          "devices.md": "Devices",
          "publish.md": "Publish the lessons"}
OWN = Path(__file__).parent / "site"
SHOWN, FIRST = "15", "02.lambert"  # on the first page: a chapter's picture, an exercise


def add_arguments(parser):
    parser.add_argument("--open", action="store_true", help="open the pages in the browser")
    parser.add_argument("--site", type=Path, metavar="FOLDER", help="write a site for a static host to this folder, building what it needs")
    parser.add_argument("--no-film", action="store_true", help="with --site: a start page without its film, which takes minutes to draw")


def run(arguments, _rest) -> int:
    start_s = time.monotonic()
    if arguments.no_film and not arguments.site:
        raise UsageError("--no-film is of a site: add --site FOLDER")
    index = (arguments.site or BUILD / "docs") / "index.html"
    if arguments.site:
        from pages import publish

        count = publish.write(arguments.site, not arguments.no_film)
    else:
        count = make(index.parent)
    say(f"{relative(index)}: {count} pages in {time.monotonic() - start_s:.1f} s")
    if arguments.open:
        show(index)
    return 0


def show(page: Path):
    if not shutil.which("xdg-open"):
        raise Failure(f"there is no xdg-open to show it with; open {page}")
    if subprocess.run(["xdg-open", page], stdout=subprocess.DEVNULL).returncode:
        raise Failure(f"xdg-open could not show {page}")


def make(folder: Path, then=None) -> int:
    """Writes the pages to a folder, which it replaces. Returns their number. The same tree gives the same bytes. `then`
    changes the result before it is moved into place."""
    folder = Path(os.path.realpath(folder))  # mkdocs would look for another one beside its settings; a link stays one
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".docs.", dir=folder.parent) as beside:
        source, made = Path(beside, "source"), Path(beside, "made")
        write_sources(source)
        build_site(source, made)
        finish(made)
        if then:
            then(made)
        if folder.exists():
            folder.rename(Path(beside, "old"))
        made.rename(folder)
    return len(list(folder.rglob("*.html")))


def write_sources(folder: Path):
    """The input of mkdocs: texts, their pictures, and the sources they name."""
    draw_charts(filter(None, map(study_of, shown_by_lessons())))
    site = Site()
    for text in [*lessons(), Path("README.md"), Path("docs/study_format.md"), *[Path("docs") / name for name in OTHERS]]:
        if (ROOT / text).exists():
            site.target(text)
    order = lessons()
    while site.waiting:
        text = site.waiting.pop()
        page = convert(site, text)
        if text in order:
            page = re.sub(r"\A# .*\n", lambda title: f"{title[0]}\n{about(order, text)}\n", page)
        write_atomically(folder / site.texts[text], page)
    write_atomically(folder / "index.md", home(site))
    for path, target in site.pictures.items():
        (folder / target).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(finest(path), folder / target)
    for path, target in site.sources.items():
        write_atomically(folder / target, source_page(path))
    for path, target in site.wholes.items():
        write_atomically(folder / target, whole_page(path))
    assets = folder / "assets"
    shutil.copytree(KATEX / "fonts", assets / "katex" / "fonts", ignore=shutil.ignore_patterns("*.ttf", "*.woff"))
    for name in ("katex.min.css", "katex.min.js"):
        shutil.copyfile(KATEX / name, assets / "katex" / name)
    (assets / "fonts").mkdir()
    for face in ("Regular", "Italic", "Bold", "BoldItalic"):
        shutil.copyfile(LATO / f"Lato-{face}.ttf", assets / "fonts" / f"Lato-{face}.ttf")
    for name in ("favicon.svg", "lesson.css", "lesson.js"):
        shutil.copyfile(OWN / name, assets / name)
    running.write(assets)


def about(order: list[Path], lesson: Path) -> str:
    """The line below a lesson's title: reading time, number of exercises, position in the course, next lesson."""
    exercises = len(re.findall(r"^### \d\d\.\w+ \(", (ROOT / lesson).read_text(encoding="utf-8"), re.M))
    at = order.index(lesson)
    parts = [f"{minutes(lesson):.0f} minutes to read", *[f"{exercises} exercises"] * (exercises > 0), f"page {at + 1} of {len(order)}"]
    if at + 1 < len(order):
        following = order[at + 1]
        parts.append(f"next: [{title_and_teaser(following)[0]}]({following.name})")
    return " · ".join(parts) + "\n{.about}\n"


def source_page(path: Path) -> str:
    """A file that a text names, to read; for a folder, its listing."""
    head = f"---\nhide:\n  - toc\n---\n\n# {path}\n\n"
    if (ROOT / path).is_dir():
        return head + "\n".join(f"- `{one.name}`" for one in sorted((ROOT / path).iterdir())) + "\n"
    language = "glsl" if path.parts[0] == "shaders" else LANGUAGES.get(path.suffix, "text")
    text = (ROOT / path).read_text(encoding="utf-8", errors="replace")
    fence = "`" * max([3, *(len(ticks) + 1 for ticks in re.findall(r"^`{3,}", text, re.M))])
    return f"{head}{fence}{language}\n{text.rstrip()}\n{fence}\n"


def whole_page(path: Path) -> str:
    """A shader with all includes; exercises are starters, so that no page reveals an answer."""
    text = whole(str(path.relative_to("shaders")), "exercise")
    return (f"---\nhide:\n  - toc\n---\n\n# {path}\n\n"
            f"The whole shader, as `./course shader {path.relative_to('shaders')} --use exercise` prints it without knobs.\n\n"
            f"```glsl\n{text.rstrip()}\n```\n")


def title_and_teaser(lesson: Path) -> tuple[str, str]:
    found = re.match(r"# (.*)\n+((?:.+\n)*)", (ROOT / lesson).read_text(encoding="utf-8"))
    title, teaser = found.groups() if found else (lesson.stem, "")
    return re.sub(r"^\d+[a-z]? ", "", title), re.sub(r"\[([^\]]*)\]\([^)]*\)|[*`]", r"\1", teaser).replace("\n", " ").strip()


def home(site: Site) -> str:
    """The first page: a card for each chapter with its first picture."""
    cards = []
    for chapter in chapters():
        lesson = Path("docs") / f"{chapter}.md"
        if not (ROOT / lesson).exists():
            continue
        title, teaser = title_and_teaser(lesson)
        goldens = [Path("tests") / chapter / "golden" / f"{shot['name']}.png" for shot in best_first(chapter)]
        first = next((golden for golden in goldens if (ROOT / golden).exists()), None)
        cards.append({"number": chapter[:2], "page": site.target(lesson).with_suffix(".html"), "title": title,
                      "teaser": teaser, "exercises": len(in_order(chapter)),
                      "picture": site.target(first) if first else None})
    picture = next((card["picture"] for card in sorted(cards, key=lambda one: one["number"] != SHOWN) if card["picture"]), None)
    begin = lessons()[0].with_suffix(".html").name if lessons() else None
    return TEMPLATES.get_template("docs_home.jinja").render(cards=cards, picture=picture, begin=begin, **tried())


def tried() -> dict:
    """The program that runs on the first page, and the exercise that it leads to; nothing in a course without them."""
    scene, first = running.scenes().get(running.TRIED), FIRST in in_order(chapters()[1]) if len(chapters()) > 1 else False
    chapter = next((name for name in chapters() if name[:2] == running.TRIED[:2]), None)
    if not scene or not first or not chapter:
        return {}
    return {"try": {"program": running.TRIED, "lines": len(scene["text"].splitlines()), "number": chapter[:2], "page": f"{chapter}.html"},
            "first": {"exercise": FIRST, "page": f"{chapters()[1]}.html#{FIRST}"}}


def nav() -> list:
    pages = [{f"{page.stem.split('_')[0]} {title_and_teaser(page)[0]}": page.name} for page in lessons()]
    return [{"Lightwalk": "index.md"}, {"Lessons": pages},
            {"Beside them": [{"How to use the course": "course.md"}, {"The study format": "study_format.md"},
                             *[{title: str(MOVED.get(Path("docs") / name, name))} for name, title in OTHERS.items()
                               if (ROOT / "docs" / name).exists()]]}]


def build_site(source: Path, made: Path):
    os.environ["SOURCE_DATE_EPOCH"] = "0"  # else today is in the pages
    try:
        from mkdocs.commands import build
        from mkdocs.config import load_config
        from mkdocs.exceptions import MkDocsException
    except ImportError as error:
        raise Failure(f"there is no {error.name}; the packages are in common/course/packages/docs") from None
    complaints = []
    logger = logging.getLogger("mkdocs")
    logger.handlers, logger.propagate = [Complaints(complaints)], False
    try:
        build.build(load_config(str(OWN / "mkdocs.yml"), docs_dir=str(source), site_dir=str(made), nav=nav()))
    except MkDocsException as error:
        raise Failure("; ".join(complaints[:3]) or str(error)) from None


# Where the theme looks for the search's index and its worker: in __search until its version 8, since 9 in __index, which it
# reads from a script (a page from a file) or as JSON (a page from ./course serve), and in its settings.
SEARCH = """{
  const worker = URL.createObjectURL(new Blob([%s], {type: "text/javascript"}));
  const settings = document.getElementById("__config");
  window.__search = {index: Promise.resolve(window.__index), worker};
  settings.textContent = JSON.stringify({...JSON.parse(settings.textContent), search: worker});
}
"""


def finish(made: Path):
    """Removes parts that need a server; the search's index and worker become a script, which a page from a file may read."""
    for name in ("404.html", "sitemap.xml", "sitemap.xml.gz"):
        (made / name).unlink(missing_ok=True)
    index = json.loads((made / "search" / "search_index.json").read_text(encoding="utf-8"))
    index["docs"] = [entry | {"text": plain(entry["text"])} for entry in index["docs"]
                     if not entry["location"].startswith(("source/", "studies/", "tree/", "whole/"))]
    worker = next((made / "assets" / "javascripts" / "workers").glob("search.*.js")).read_text(encoding="utf-8")
    write_atomically(made / "search" / "search_index.json", script(index))
    write_atomically(made / "search" / "search_index.js", f"window.__index = {script(index)};\n")
    write_atomically(made / "assets" / "search.js", SEARCH % script(worker))
    search_later(made)
    pages = {page.stem: (ROOT / page).read_text(encoding="utf-8") for page in lessons()}
    for chapter in chapters():
        for exercise in in_order(chapter):
            page = next((name for name, text in pages.items() if f"\n### {exercise} (" in text), chapter)
            write_atomically(made / "open" / f"{exercise}.html", TEMPLATES.get_template("docs_open.html").render(
                page=f"../{page}.html#{exercise}"))


# The search's index is larger than a page: it comes with the first look at the search's field.
LATER = """new Promise(done => {
    const load = () => done(window.__index ?? new Promise(loaded => {
      const script = document.createElement("script");
      script.src = SOURCE;
      script.onload = () => loaded(window.__index);
      document.head.append(script);
    }));
    for (const event of ["focusin", "pointerdown", "click", "keydown"])
      addEventListener(event, ({target, key}) => { if (target.closest?.("[data-md-component=search], [data-md-toggle=search], [for=__search]") || "fs/".includes(key ?? "-")) load(); }, true);
    if (new URLSearchParams(location.search).has("q")) load();
  })"""


def search_later(made: Path):
    """Where the theme takes a promise for its index (up to its version 8), pages come without the index."""
    bundle = next((made / "assets" / "javascripts").glob("bundle.*.js")).read_text(encoding="utf-8")
    own = (made / "assets" / "search.js").read_text(encoding="utf-8")
    if "__index" in bundle.replace("md-annotation__index", "") or "Promise.resolve(window.__index)" not in own:
        return
    write_atomically(made / "assets" / "search.js", 'const SOURCE = new URL("../search/search_index.js", document.currentScript.src).href;\n' +
                     own.replace("Promise.resolve(window.__index)", LATER))
    (made / "search" / "search_index.json").unlink()  # the script has it
    for path in made.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        path.write_text(re.sub(r'<script src="[./]*search/search_index\.js"></script>\n?', "", text), encoding="utf-8")


def plain(text: str) -> str:
    """A text of the search's index with its formulas as one reads them aloud: letters and numbers."""
    return re.sub(r"\\[(\[](.*?)\\[)\]]", lambda found: re.sub(r"\\[a-zA-Z]+|\\.|[{}]", "", found[1]).strip(), text,
                  flags=re.S)


def script(value) -> str:
    return json.dumps(value, ensure_ascii=False)


class Complaints(logging.Handler):
    def __init__(self, kept: list[str]):
        super().__init__(logging.WARNING)
        self.kept = kept

    def emit(self, record):
        self.kept.append(record.getMessage())


if __name__ == "__main__":
    make(BUILD / "docs")
