"""Makes slides of a lesson: one HTML file that needs no network. Spoken text stays in the lesson; on a slide are the first
sentence of each paragraph, the pictures, the formulas, the code and the charts, and each question before its answer."""

import math
import re
from pathlib import Path

from pages.lesson_html import Lesson, blocks, code_css, embedded, inner, katex_css, katex_js, words
from pages.page import TEMPLATES
from tree import BUILD, ROOT, chapter_title, find_lesson, lessons, relative, say, shots, unwritable, write_atomically

HELP = """Makes slides of a chapter's lesson: build/slides/NN_name.html, one file that needs no network.

  ./course docs --slides 02        arrow keys, space or a click; F fills the screen; printed, a slide is a page
  ./course docs --slides 02 --out FOLDER

Without a chapter, it makes those of all lessons."""
MOST_BULLETS = 5
SHORT_LINES = 14  # of code below its explanation
LEFT_OUT = ("further reading",)
SENTENCE = re.compile(r"(?<=[.!?])[\"')*]*(?=\s+[^\s])")


def add_arguments(parser):
    parser.add_argument("--slides", action="store_true", help="make slides")
    parser.add_argument("chapter", nargs="?", metavar="NN", help="number or name of the lesson")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder for the files (build/slides)")


def run(arguments, _rest) -> int:
    named = [find_lesson(arguments.chapter)] if arguments.chapter else lessons()
    out = (arguments.out or BUILD / "slides").absolute()
    for chapter in [lesson.stem for lesson in named]:
        slides = make(chapter)
        try:
            write_atomically(out / f"{chapter}.html", page(chapter, slides))
        except OSError as error:
            raise unwritable(out, error) from None
        say(f"{relative(out / f'{chapter}.html')}: {len(slides)} slides")
    return 0


def page(chapter: str, slides: list[dict]) -> str:
    return TEMPLATES.get_template("slides.html").render(title=chapter_title(chapter), slides=slides, katex_css=katex_css(),
                                                        katex_js=katex_js(), code_css=code_css())


def make(chapter: str) -> list[dict]:
    charts = set()  # which have letters of their own, and a slide each

    def picture(path: Path) -> str:
        image = embedded(path)
        if path.parts[:2] == ("docs", "studies"):
            charts.add(image)
        return image

    lesson = Lesson(Path("docs") / f"{chapter}.md", picture)
    # Another text is not in this file: of a link to it the words stay.
    found = blocks(re.sub(r'<a href="(?!https?:)[^"]*"[^>]*>(.*?)</a>', r"\1", lesson.html, flags=re.S))
    title = next((words(text) for tag, _, text in found if tag == "h1"), chapter)
    first = next((inner(text) for tag, _, text in found if tag == "p" and "<img" not in text and words(text)), "")
    goldens = [path for shot in shots(chapter) if (path := ROOT / "tests" / chapter / "golden" / f"{shot['name']}.png").exists()]
    head = lesson.html[:lesson.html.find("<h2")]
    own = re.search(r'<img [^>]*src="(data:[^"]+)"', head)
    image = own[1] if own else embedded(goldens[0]) if goldens else None
    slides = [{"kind": "title", "title": title, "text": sentence(first), "image": image,
               "command": f"./course run {chapter[:2]}" if goldens else "./course run"}]
    over, heading, part = "", "", []
    for block in [*found, ("h2", {}, "<h2></h2>")]:
        if block[0] not in ("h1", "h2", "h3"):
            part.append(block)
            continue
        if heading and over.lower() not in LEFT_OUT:
            slides += questions(part) if over.lower() == "questions" else section(heading, over if heading != over else "", part, charts)
        part, heading = [], words(re.sub(r'<a class="headerlink".*?</a>', "", block[2]))
        if block[0] == "h1":
            heading = ""
        if block[0] == "h2":
            over = heading
    return slides


def sentence(text: str, count: int = 1) -> str:
    """The first sentences of a paragraph's HTML; the whole of it where a tag or a formula would be cut."""
    for found in SENTENCE.finditer(text):
        begin = text[:found.end()]
        if balanced(begin) and not re.search(r"\b(?:e\.g|i\.e|vs|cf|Fig|Eq|et al|p|pp)\.$", words(begin)):
            count -= 1
            if not count:
                return begin
    return text


def balanced(text: str) -> bool:
    opened = len(re.findall(r"<(?!/|img|br)\w", text))
    return opened == text.count("</") and text.count("(") == text.count(")")


def section(heading: str, over: str, part: list, charts: set[str]) -> list[dict]:
    bullets, beside, alone = [], [], []
    for tag, attributes, text in part:
        kind = attributes.get("class", "") or ""
        if tag == "p" and "<img" in text:
            beside.append({"image": re.search(r'src="([^"]+)"', text)[1], "caption": ""})
        elif tag == "figure":
            alone.append({"kind": "pair", "images": re.findall(r'<img src="([^"]+)"', text),
                          "names": re.findall(r"<figcaption><span>(.*?)</span>.*<span>(.*?)</span></figcaption>", text)})
        elif tag == "p" and re.fullmatch(r"<p><em>.*</em></p>", text, re.S) and beside and not beside[-1]["caption"]:
            beside[-1]["caption"] = sentence(inner(inner(text)))
        elif tag == "p" and words(text) and 'class="whole"' not in text:
            if words(text).endswith(":") and len(words(text)) < 40 and not bullets:
                continue
            bullets.append(inner(text))
        elif tag == "div" and "highlight" in kind:
            alone.append(code(text))
        elif tag == "pre":
            alone.append(code(text))
        elif tag in ("div", "span") and "arithmatex" in kind:
            bullets.append(text)
        elif tag in ("ul", "ol"):
            bullets += [sentence(re.split(r"<(?:ul|ol|details|pre|div)\b", inner(item[2]).replace("<p>", "").replace("</p>", " "))[0])
                        for item in blocks(inner(text)) if item[0] == "li"]
        elif tag == "table":
            alone.append({"kind": "table", "html": text, "images": "<img" in text})
    alone = [{"kind": "text", "bullets": [], "picture": one} for one in beside if one["image"] in charts] + alone
    beside = [one for one in beside if one["image"] not in charts]
    # Where there is room, a paragraph has two sentences; slides of one section have equally much on them.
    bullets = [text if text.startswith("<div") else sentence(text, 2 if len(bullets) < 3 else 1) for text in bullets]
    slides, count = [], max(1, math.ceil(len(bullets) / MOST_BULLETS))
    each = math.ceil(len(bullets) / count)
    while bullets or beside:
        slides.append({"kind": "text", "bullets": bullets[:each], "picture": beside.pop(0) if beside else None})
        bullets = bullets[each:]
    short = next((one for one in alone if one["kind"] == "code" and one["lines"] <= SHORT_LINES), None)
    if short and len(slides) == 1 and len(slides[0]["bullets"]) <= 4 and not slides[0]["picture"]:  # they fit on one
        slides[0]["code"] = short
        alone = [one for one in alone if one is not short]
    return [{"title": heading, "over": over, **slide} for slide in slides + alone]


def code(text: str) -> dict:
    name = re.search(r'<span class="filename">(.*?)</span>', text)
    text = re.sub(r'<span class="filename">.*?</span>', "", text, count=1)
    lines = words(text).rstrip("\n").split("\n")
    return {"kind": "code", "html": text, "file": name[1] if name else "", "lines": max(len(lines), 12),
            "columns": max([50, *map(len, lines)])}


def questions(part: list) -> list[dict]:
    """Each question, and on the slide behind it the question with its answer."""
    slides = []
    for tag, _, text in part:
        for item in blocks(inner(text)) if tag == "ol" else []:
            question, answer = split_answer(inner(item[2]))
            shown = {"title": "Question", "over": f"{len(slides) // 2 + 1}", "kind": "question", "question": question}
            slides += [shown | {"answer": ""}, shown | {"answer": answer, "title": "Answer"}]
    return slides


def split_answer(text: str) -> tuple[str, str]:
    before, found, answer = text.partition("<details")
    if not found:
        return text, ""
    answer = re.sub(r"^[^>]*>\s*(?:<summary>.*?</summary>)?", "", answer, count=1, flags=re.S)
    return before, answer.rpartition("</details>")[0]
