"""Makes one PDF of all lessons: build/book/lightwalk.pdf. Chromium prints it, twice at least: the pages of the table of contents
are known after the first time, and the second must agree.
"""

import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from pages.lesson_html import Lesson, blocks, code_css, embedded, katex_css, katex_js, words
from pages.page import TEMPLATES
from tree import BUILD, Failure, UsageError, find_lesson, lesson_pages, lessons, relative, say, unwritable, warn

ALONE = True
HELP = """Makes one PDF of all lessons: build/book/lightwalk.pdf, with contents, numbered figures and the answers at its end.

  ./course docs --book          all chapters
  ./course docs --book 02 05           some of them
  ./course docs --book --out FILE"""
# Debian's Chromium without windows (its command in /usr/bin is a script that outlives its child), or any with them.
BROWSERS = ("/usr/lib/chromium/chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
PRINTING_S = 1800
MOST_PRINTINGS = 4  # two, unless the numbers themselves move a page
MOST_SIDE, QUALITY = 1100, 80  # of pictures, in pixels and as JPEG: 9 cm at 300 dpi, and less than 40 MB in all


def add_arguments(parser):
    parser.add_argument("--book", action="store_true", help="make a PDF")
    parser.add_argument("chapters", nargs="*", metavar="NN", help="numbers or names of chapters")
    parser.add_argument("--out", type=Path, metavar="FILE", help="the PDF (build/book/lightwalk.pdf)")


def run(arguments, _rest) -> int:
    named = [page for first in map(find_lesson, arguments.chapters) for page in lesson_pages(first.stem) or [first]] or lessons()
    out = (arguments.out or BUILD / "book" / "lightwalk.pdf").absolute()
    if out.suffix != ".pdf":
        raise UsageError(f"{arguments.out} is not called like a PDF: name a FILE.pdf")
    if out.is_dir():
        raise UsageError(f"{arguments.out} is a folder: name a FILE.pdf")
    browser = find_browser()
    if not browser:
        raise UsageError("there is no chromium to print with; the packages are in common/course/packages/book")
    try:
        out.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise unwritable(out.parent, error) from None
    book = [chapter_part(page.stem) for page in named]
    with tempfile.TemporaryDirectory(prefix=".book.", dir=out.parent) as made:
        file, printed = Path(made, "book.html"), Path(made, "book.pdf")
        print_until_settled(browser, book, file, printed)
        printed.replace(out)
    say(f"{relative(out)}: {page_count(out)} pages, {out.stat().st_size / 1e6:.1f} MB")
    return 0


def find_browser() -> str | None:
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def print_until_settled(browser: str, book: list[dict], file: Path, printed: Path):
    """Prints with the page numbers of the printing before until no page has moved. Raises Failure where that does not end."""
    places = None
    for what in ("laying out", *["printing"] * (MOST_PRINTINGS - 1)):
        warn(f"{what} {len(book)} chapters")
        file.write_text(page(book, places or {}), encoding="utf-8")
        print_pdf(browser, file, printed)
        before, places = places, pages_of(printed)
        if places == before:
            return
    raise Failure(f"pages still moved in printing {MOST_PRINTINGS}: the contents name wrong ones")


def page(book: list[dict], places: dict[str, int]) -> str:
    return TEMPLATES.get_template("book.html").render(chapters=book, pages=places, katex_css=katex_css(), katex_js=katex_js(),
                                                      code_css=code_css())


def print_pdf(browser: str, file: Path, out: Path):
    with tempfile.TemporaryDirectory(prefix="lightwalk.browser.") as profile:
        # In a container, and as root, Chromium has no sandbox of its own; the printed pages are ours.
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
                   f"--user-data-dir={profile}", "--no-pdf-header-footer", "--generate-pdf-document-outline",
                   f"--print-to-pdf={out}", file.as_uri()]
        try:
            done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                  errors="replace", timeout=PRINTING_S)
        except subprocess.TimeoutExpired:
            raise Failure(f"{browser} did not print within {PRINTING_S} s") from None
    if done.returncode or not out.exists():
        raise Failure(f"{browser} could not print: {(done.stdout.strip().splitlines() or ['it said nothing'])[-1]}")


def pages_of(pdf: Path) -> dict[str, int]:
    """The page of each place that a link of the book leads to."""
    said = told("pdfinfo", "-dests", pdf)
    return {name: int(number) for number, name in re.findall(r"^\s*(\d+)\s+\[.*?\]\s+\"(.*)\"$", said, re.M)}


def page_count(pdf: Path) -> int:
    found = re.search(r"^Pages:\s+(\d+)", told("pdfinfo", pdf), re.M)
    return int(found[1]) if found else 0


def told(*command) -> str:
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                              errors="replace").stdout
    except FileNotFoundError:
        raise Failure(f"there is no {command[0]}; the packages are in common/course/packages/book") from None


def chapter_part(chapter: str) -> dict:
    """A chapter as the book has it: title, HTML, sections for the contents, answers for the end."""
    number = chapter.split("_")[0]
    lesson = Lesson(Path("docs") / f"{chapter}.md", lambda path: embedded(path, MOST_SIDE, QUALITY, flat=False))
    text, answers = without_answers(lesson.html, number)
    text = own_names(with_figures(text, number), number)
    sections, title = [], chapter
    for tag, _, block in blocks(text):
        if tag == "h1":
            title = words(block)
        elif tag == "h2" and (found := re.search(r'id="([^"]+)"', block)):
            sections.append({"id": found[1], "title": words(block)})
    return {"name": chapter, "number": number, "short": short(number), "id": f"chapter-{number}", "title": title, "sections": sections, "answers": answers,
            "html": re.sub(r"<h1\b", f'<h1 data-id="chapter-{number}"', text, count=1)}


def short(number: str) -> str:
    """15a as it is, 02 as 2."""
    return number.lstrip("0") or "0"


def without_answers(text: str, number: str) -> tuple[str, list[str]]:
    """The lesson with each folded answer as a number, and those answers. Other folds stay open."""
    answers = []

    def answer(found):
        answers.append(found[1].strip())
        return f'<p class="answer-at"><a href="#answer-{number}-{len(answers)}">Answer {short(number)}.{len(answers)}</a></p>'
    text = re.sub(r"<details>\s*<summary>Answer</summary>(.*?)</details>", answer, text, flags=re.S)
    text = re.sub(r"<details\b[^>]*>\s*<summary>(.*?)</summary>", r'<div class="aside"><p class="aside-title">\1</p>', text, flags=re.S)
    return text.replace("</details>", "</div>"), answers


def with_figures(text: str, number: str) -> str:
    """Pictures that stand alone are numbered figures; the paragraph in italics behind one is its caption."""
    count = [0]

    def caption(words_of_it: str) -> str:
        count[0] += 1
        return f"<figcaption><b>Figure {short(number)}.{count[0]}.</b> {words_of_it}</figcaption>"

    def figure(found):
        if found["pair"]:
            images = "".join(re.findall(r'<img src="[^"]+"[^>]*>', found["pair"]))
            names = re.findall(r"<span>(.*?)</span>", found["pair"])
            return f'<figure class="two"><div>{images}</div>{caption(found["below"] or f"{names[0]}; {names[-1]}.")}</figure>'
        alt = re.search(r'alt="([^"]*)"', found["one"])
        return f'<figure class="one">{found["one"]}{caption(found["below"] or (alt[1] + "." if alt else ""))}</figure>'
    return re.sub(r'(?:(?P<pair><figure class="compare">.*?</figure>)|<p>(?P<one><img [^>]*>)</p>)'
                  r"(?:\s*<p><em>(?P<below>(?:(?!</p>).)*)</em></p>)?", figure, text, flags=re.S)


def own_names(text: str, number: str) -> str:
    """Two chapters have headings of one name; a link to another text is its words, to another chapter the chapter."""
    text = re.sub(r'\bid="([^"]+)"', rf'id="c{number}-\1"', text)
    text = re.sub(r'href="#(?!answer-)([^"]+)"', rf'href="#c{number}-\1"', text)
    text = re.sub(r'<a class="headerlink".*?</a>', "", text)
    text = re.sub(r'<p><a class="whole".*?</a></p>', "", text, flags=re.S)
    text = re.sub(r'href="(\d\d[a-z]?)_\w+\.(?:html|md)(?:#[^"]*)?"', r'href="#chapter-\1"', text)
    return re.sub(r'<a href="(?!#|https?:)[^"]*"[^>]*>(.*?)</a>', r"\1", text, flags=re.S)
