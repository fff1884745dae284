"""Checks the texts: lessons' quotes, links, lengths and diagrams, credits, the parts of each chapter, the layout of the code.

As a program it prints the faults, one "file:line: fault" each, and ends with 1 if there is any.
"""

import fnmatch
import re
import shutil
import subprocess
import sys
import tempfile
from importlib import import_module
from pathlib import Path

from check.check import grades
from check.lesson_tests import check_named, of_chapters
from check.starters import check_starters
from pages import advice, claims, tables
from pages.quotes import FENCE, LINK, MARKER, QUOTE, check_quotes, lessons
from shots.golden import measured_distances
from test.lesson_commands import wrong_words
from test.order import check_order
from tree import ROOT, chapters, exercises, files, has_solutions, lesson_pages, relative, say, shots, slug

# An environment variable where code reads it.
VARIABLE = re.compile(r"[\"'](LIGHTWALK_[A-Z_]+)[\"']|\b(LIGHTWALK_[A-Z_]+)=")
MOST_VARIABLES = 8
SHOT_KEYS = ("name", "caption", "scene", "size", "time_s", "frames", "set", "exercises", "rejects")  # limits are measured, not stated
REJECTED_KEYS = ("chapter", "set", "use")
# Paths that mean something on one machine only.
PRIVATE = re.compile(r"(?<![\w.])/(?:%s)/\w" % "|".join(["work", "root", "home", "Users"]))


def text_of(name: Path | str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def all_exercises() -> set[str]:
    return {exercise for chapter in chapters() for exercise in exercises(chapter)}


def prose(name: Path) -> list[tuple[int, str]]:
    """(line number, text) of a Markdown file without its code."""
    return [(number, re.sub(r"`[^`]*`", "", line)) for start, language, lines in blocks(name) if language == "text"
            for number, line in enumerate(lines, start)]


def anchors(name: Path) -> set[str]:
    """The headings' anchors as GitHub makes them."""
    found = set()
    text = text_of(name)
    for title in re.findall(r"^#+\s+(.*?)\s*#*$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), re.M):
        base = slug(re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title))
        anchor, count = base, 0
        while anchor in found:
            count += 1
            anchor = f"{base}-{count}"
        found.add(anchor)
    return found | set(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", text))


def check_links(name: Path) -> list[str]:
    wrong = []
    for number, line in prose(name):
        if re.match(r"[^\[\]]*\]\(", line):
            wrong.append(f"{name}:{number}: the words of a link begin on the line before; the pages would not follow it")
        for match in LINK.finditer(line):
            link = match[1] or match[2]
            if re.match(r"[a-z]+:", link):
                continue
            path, _, anchor = link.partition("#")
            target = (ROOT / name.parent / path).resolve() if path else ROOT / name
            if not target.exists() or not target.is_relative_to(ROOT):
                wrong.append(f"{name}:{number}: the link {link} leads nowhere")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target.relative_to(ROOT)):
                wrong.append(f"{name}:{number}: {target.name} has no heading #{anchor}")
    return wrong


def blocks(name: Path) -> list[tuple[int, str, list[str]]]:
    """(line number, language or "", lines) of a Markdown file's blocks of code and, with a language of "text", of its paragraphs."""
    found, fence, language, block, start = [], None, "", [], 0
    for number, line in enumerate([*text_of(name).splitlines(), ""], 1):
        match = FENCE.match(line)
        if fence:
            if line.strip() == fence:
                found.append((start, language, block))
                fence, block = None, []
            else:
                block.append(line)
        elif match or not line.strip():
            if block:
                found.append((start, "text", block))
            block = []
            if match:
                fence, language, start = match[1], line.strip()[len(match[1]):], number
        else:
            start = start if block else number
            block.append(line)
    return found


def ends(words: str) -> bool:
    """Whether a paragraph's last words end a sentence, behind marks of emphasis, code and brackets."""
    return bool(re.search(r"[.:?!…][*_)\"'”’`]*$", words))


def check_paragraphs(name: Path) -> list[str]:
    """A paragraph is whole: it ends with a sentence, or leads to a formula, a table or code that is not folded."""
    wrong, found = [], blocks(name)
    for i, (number, language, lines) in enumerate(found):
        if language != "text" or re.match(r"(    |\s*(#|\||<|!\[|\[!\[))", lines[0]):
            continue
        words = re.sub(r"<!--.*?-->|</details>", "", " ".join(line.strip() for line in lines)).strip()
        if not words or words.endswith("|"):
            continue
        following = found[i + 1] if i + 1 < len(found) else (0, "text", [""])
        if words.endswith(":") and following[2][0].lstrip().startswith("<details>"):
            wrong.append(f"{name}:{number + len(lines) - 1}: the sentence goes on in a fold, which a reader of the main thread does not open")
        if ends(words):
            continue
        # A formula ends a sentence that has a verb: five words or a word such as Then.
        sentence = re.split(r"(?<=[.:?!]) ", words)[-1].split()
        whole = len(sentence) > 4 or sentence[-1] in ("Then", "So", "Hence", "is", "are", "by", "so")
        goes_on = i + 2 < len(found) and re.match(r"\s*[a-z(]", found[i + 2][2][0])
        leads = following[1] == "math" and (whole or goes_on) or following[1] not in ("text", "math") or \
            following[2][0].startswith(("    ", "|", "       ")) or "<!-- table" in following[2][0] or words.endswith("`")
        if not leads:
            wrong.append(f"{name}:{number + len(lines) - 1}: the paragraph has no end: '… {words[-40:]}'")
    return wrong


def check_next(name: Path) -> list[str]:
    """A page names the next one once."""
    numbers = [number for number, line in prose(name) if line.startswith("Next:")]
    return [f"{name}:{number}: a second 'Next:' on this page" for number in numbers[1:]]


def check_snippets(name: Path) -> list[str]:
    """GLSL that a page does not quote from a file compiles, as the stage that its words are of."""
    wrong, lines = [], text_of(name).splitlines()
    for number, language, code in blocks(name):
        if language != "glsl" or QUOTE.match(lines[number - 2]) or not shutil.which("glslangValidator"):
            continue
        text = "\n".join(code)
        stage = "vert" if "gl_Position" in text else "comp" if "local_size" in text else "frag"
        if "#version" not in text:
            text = "#version 460\n" + text
        if "void main" not in text:
            text += "\nvoid main() {}\n"
        with tempfile.TemporaryDirectory() as made:
            file = Path(made) / f"snippet.{stage}"
            file.write_text(text, encoding="utf-8")
            done = subprocess.run(["glslangValidator", "-V", "--target-env", "vulkan1.3", file, "-o", Path(made) / "out"],
                                  stdout=subprocess.PIPE, text=True, errors="replace")
        if done.returncode:
            said = next((line for line in done.stdout.splitlines() if line.startswith("ERROR")), "").replace(f"{file}:", "")
            wrong.append(f"{name}:{number}: the shader does not compile: {said}")
    return wrong


# A path or a file's name in code: a folder and a slash, or an ending.
PATH = re.compile(r"(?:(?:[\w.-]+|\.\.)/)+[\w.-]*|[\w-]+\.(?:h|cpp|py|glsl|vert|geom|frag|comp|json|cmake|md|txt)")
ABOUT_THE_TREE = ("docs/framework.md", "docs/pixel.md", ".github/CONTRIBUTING.md")


def check_paths(name: Path) -> list[str]:
    """A page about the tree names only what is there: from the root, or as C++ and GLSL include it. NN and words in capitals
    stand for others, and so does a chapter that the page imagines."""
    wrong, text = [], text_of(name)
    imagined = set(re.findall(r"\./course new (\d\d_\w+)", text))
    names = {path.name for path in files()}
    for span in re.finditer(r"(?<!`)`([^`\n]+)`(?!`)", text):
        word = span[1].strip().rstrip("/")
        if not PATH.fullmatch(span[1].strip()) or word.startswith(("build", ".")) or re.search(r"\bNN|[A-Z]{3}", word) or \
           any(one in word for one in imagined):
            continue
        folder, last = Path(word).parent, Path(word).name
        there = any((ROOT / room / folder / below / last).exists() for room in ("", "shaders", "chapters", "common", "assets", "tests")
                    for below in ("", "exercise", "solution"))
        if not there and ("/" in word or last not in names):
            wrong.append(f"{name}:{text.count(chr(10), 0, span.start()) + 1}: there is no {word}")
    return wrong


STATION = re.compile(r"\*\*\d+\. \[(\S+)\]\(")
WALK, MOST_STATIONS = Path("docs/pixel.md"), 15


def check_walk() -> list[str]:
    """The way of a pixel leads through few files: a paragraph "**N. [FILE](...)**" quotes lines of its file, each but a command."""
    if not (ROOT / WALK).exists():
        return []
    text = text_of(WALK)
    stations = [(paragraph, STATION.match(paragraph)[1]) for paragraph in re.split(r"\n{2,}", text) if STATION.match(paragraph)]
    wrong = [f"{WALK}: {len(stations)} files, at most {MOST_STATIONS}"] * (len(stations) > MOST_STATIONS)
    for paragraph, file in stations:
        if not (ROOT / file).is_file():
            wrong.append(f"{WALK}: there is no {file}")
            continue
        code = " ".join(text_of(file).split())
        spans = [" ".join(span.split()) for span in re.findall(r"`([^`]+)`", paragraph) if not span.startswith("-")]
        if not spans:
            wrong.append(f"{WALK}: of {file} it quotes nothing")
        wrong += [f"{WALK}: {file} has no '{span}'" for span in spans if span not in code]
    return wrong


def check_chapters() -> list[str]:
    """Each chapter has a lesson and tests; its shots name existing files; one of them rejects an earlier chapter."""
    wrong, known = [], all_exercises()
    for number, chapter in enumerate(chapters()):
        for needed in (f"docs/{chapter}.md", f"tests/{chapter}/shots.json"):
            if not (ROOT / needed).exists():
                wrong.append(f"{needed}: chapter {chapter} needs it")
        for kind in ("chapters", "shaders") if has_solutions() else ():
            exercise, solution = ({path.name for path in Path(ROOT, kind, chapter, below).glob("*.*") if path.suffix != ".old"}
                                  for below in ("exercise", "solution"))
            wrong += [f"{kind}/{chapter}/exercise/{name}: there is no solution of this name" for name in sorted(exercise - solution)]
            wrong += [f"{kind}/{chapter}/solution/{name}: there is no exercise of this name" for name in sorted(solution - exercise)]
        file, found = f"tests/{chapter}/shots.json", shots(chapter)
        names = [shot["name"] for shot in found]
        wrong += [f"{file}: two shots are called {name}" for name in sorted(set(names)) if names.count(name) > 1]
        wrong += [f"{file}: {shot['name']} has no caption" for shot in found if not shot.get("caption")]
        wrong += [f"{file}: there is no exercise {exercise}" for shot in found
                  for exercise in shot.get("exercises", []) if exercise not in known]
        earlier = [entry["chapter"] for shot in found for entry in shot.get("rejects", []) if "chapter" in entry]
        wrong += [f"{file}: {name} is no earlier chapter" for name in earlier if name not in chapters()[:number]]
        # A scene that sets knobs, or includes one that does, cannot be read by chapters that lack them.
        scenes = {shot["scene"] for shot in found if "scene" in shot}
        missing = sorted(scene for scene in scenes if not (ROOT / scene).is_file())
        wrong += [f"{file}: there is no scene {scene}" for scene in missing]
        scenes -= set(missing)
        readable = not scenes or any(not re.search('"(knobs|include)"', text_of(scene)) for scene in scenes)
        if found and number and readable and not earlier:
            wrong.append(f"{file}: no golden has to reject the picture of an earlier chapter")
        goldens = sorted(path.stem for path in (ROOT / "tests" / chapter / "golden").glob("*.png"))
        wrong += [f"tests/{chapter}/golden/{name}.png: no shot has this name" for name in goldens if name not in names]
        measured = measured_distances(chapter)
        entries = [(shot["name"], SHOT_KEYS, shot) for shot in found] + \
            [(f"{shot['name']}: rejects", REJECTED_KEYS, entry) for shot in found for entry in shot.get("rejects", [])]
        wrong += [f"{file}: {name}: '{key}' is unknown here; known: {', '.join(keys)}" for name, keys, entry in entries
                  for key in entry if key not in keys]
        wrong += [f"{file}: nobody measured how far drivers differ on {name}; ./course accept {chapter[:2]}.{name}"
                  for name in goldens if name in names and not measured.get(name)]
        wrong += [f"tests/{chapter}/golden/distances.json: {name} has no golden" for name in measured
                  if name not in goldens]
    return wrong


def check_private_paths(name: Path) -> list[str]:
    try:
        lines = text_of(name).splitlines()
    except UnicodeDecodeError:
        return []
    return [f"{name}:{number}: a path of one machine: {line.strip()[:80]}"
            for number, line in enumerate(lines, 1) if PRIVATE.search(line)]


def check_lesson(chapter: str) -> list[str]:
    """A lesson names no chapter that is not there, and states its exercises in full."""
    pages, wrong = lesson_pages(chapter), []
    if not pages:
        return []
    name, text = pages[0], "\n".join(map(text_of, lessons()))
    if any("\n## Exercises\n" in text_of(page) for page in pages):
        graded = grades(chapter)
        wrong += [f"{name}: there is no heading '### {exercise} (easy)', or medium, or hard"
                  for exercise in exercises(chapter) if exercise not in graded]
        harder = ["easy", "medium", "hard"]
        for page in pages:
            on_page = [grade for exercise, grade in graded.items() if f"\n### {exercise} (" in text_of(page)]
            if sorted(on_page, key=harder.index) != on_page:
                wrong.append(f"{page}: a harder exercise stands before an easier one")
        wrong += [f"{name}: it does not quote {relative(path)}#{marker[2]}, what the exercise asks for"
                  for path in exercises(chapter).values() for marker in map(MARKER.match, path.read_text(encoding="utf-8").splitlines())
                  if marker and not marker[1] and f"<!-- quote: {relative(path)}#{marker[2]} -->" not in text]
    there = {other[:2] for other in chapters()}
    return wrong + [f"{page}:{number}: there is no chapter {other}" for page in pages for number, line in prose(page)
                    for group in re.findall(r"[Cc]hapters? (\d\d(?:(?:, | and | to )\d\d)*)", line)
                    for other in re.findall(r"\d\d", group) if other not in there]


def check_index() -> list[str]:
    """docs/index.md leads from each term to a page that has it, to knobs, shots and exercises that are there, and names every exercise."""
    page = Path("docs/index.md")
    if not (ROOT / page).exists():
        return []
    wrong, named, terms, known = [], set(), [], all_exercises()
    code = "\n".join(text_of(name) for name in files() if name.suffix in (".h", ".cpp") and name.parts[0] in ("chapters", "common"))
    drawn = {f"{chapter[:2]}.{shot['name']}" for chapter in chapters() for shot in shots(chapter)}
    for number, line in enumerate(text_of(page).splitlines(), 1):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("|") or len(cells) != 6 or cells[0] in ("term", "---"):
            continue
        term, _, section, knobs, seen, asked = cells
        terms.append(term.casefold())
        target = re.search(r"\((\w+\.md)", section)
        text = text_of(f"docs/{target[1]}") if target and (ROOT / "docs" / target[1]).exists() else ""
        if term.casefold() not in " ".join(text.split()).casefold():
            wrong.append(f"{page}:{number}: {target and target[1]} does not have the word '{term}'")
        for knob in re.findall(r"`([^`]*)`", knobs):
            for word in filter(None, [knob.partition("=")[0].split(".")[-1], knob.partition("=")[2]]):
                if f'"{word}"' not in code:
                    wrong.append(f"{page}:{number}: no knob or value is called {word}")
        wrong += [f"{page}:{number}: there is no shot {shot}" for shot in filter(None, seen.split(", ")) if shot not in drawn]
        found = set(re.findall(r"\[(\d\d\.\w+)\]", asked))
        wrong += [f"{page}:{number}: there is no exercise {exercise}" for exercise in sorted(found - known)]
        named |= found
    if terms != sorted(terms):
        before, after = next((a, b) for a, b in zip(terms, terms[1:]) if b < a)
        wrong.append(f"{page}: its terms are not in alphabetical order: '{before}' stands before '{after}'")
    return wrong + [f"{page}: no row names the exercise {exercise}; link it in the last column of its term" for exercise in sorted(known - named)]


def check_figures() -> list[str]:
    """docs/images/NAME.svg is the drawing of that name in docs/figures, and a lesson shows it."""
    shown, wrong = "".join(map(text_of, lessons())), []
    folder = str(ROOT / "docs/figures")
    sys.path.insert(0, folder)
    try:
        drawn = import_module("draw").figures() if Path(folder, "draw.py").exists() else {}
    except Exception as error:  # any failure of a script
        return [f"docs/figures: {error}"]
    finally:
        sys.path.remove(folder)
    images = {name.stem: name for name in files() if name.match("docs/images/*.svg")}
    for name in sorted(drawn.keys() | images.keys()):
        image = Path(f"docs/images/{name}.svg")
        if name not in drawn:
            wrong.append(f"{image}: nothing in docs/figures draws it")
            continue
        try:
            if name not in images or text_of(image) != drawn[name]().svg():
                wrong.append(f"{image}: not what its function draws; python3 docs/figures/draw.py {name}")
        except Exception as error:  # of a figure's own code
            wrong.append(f"docs/figures, {name}: {error}")
        if f"images/{image.name}" not in shown:
            wrong.append(f"{image}: no lesson shows it")
    return wrong


def check_generated() -> list[str]:
    """Generated files are in the tree only if a text shows them: charts as PNG; ./course docs draws the others."""
    texts = "".join(text_of(name) for name in files() if name.suffix == ".md" and name.parts[0] in ("docs", "README.md"))
    return [f"{name}: no text shows it; ./course docs draws charts from their JSON" for name in files()
            if (name.parts[:2] == ("docs", "studies") and name.suffix in (".png", ".svg") or
                name.parts[:2] == ("docs", "images") and name.suffix in (".png", ".webp", ".jpg")) and name.name not in texts]


def check_variables() -> list[str]:
    """docs/development.md has a row for each environment variable that a program or a test reads or sets, and no other."""
    page = Path("docs/development.md")
    if not (ROOT / page).exists():
        return []
    code = [name for name in files() if name.suffix in (".cpp", ".h", ".py", ".sh") or str(name) in ("course", ".ci/run")]
    read = {"".join(found): name for name in code for found in VARIABLE.findall((ROOT / name).read_text(errors="replace", encoding="utf-8"))}
    named = set(re.findall(r"^\| `(LIGHTWALK_\w+)`", text_of(page), re.M))
    return [f"{page}: {len(named)} environment variables, at most {MOST_VARIABLES}; a test's own is an option of the program"] * \
           (len(named) > MOST_VARIABLES) + \
           [f"{read[variable]}: {page} does not name {variable}" for variable in sorted(read.keys() - named)] + \
           [f"{page}: nothing reads {variable}" for variable in sorted(named - read.keys())]


def braces(pattern: str) -> list[str]:
    """a_{b,c}.png as a_b.png and a_c.png."""
    match = re.search(r"\{([^}]*)\}", pattern)
    if not match:
        return [pattern]
    return [name for part in match[1].split(",")
            for name in braces(pattern[:match.start()] + part + pattern[match.end():])]


def check_credits() -> list[str]:
    """Each file of assets is in the first column of CREDITS.md's table, and the other way round."""
    credits = Path("assets/CREDITS.md")
    present = {str(name.relative_to("assets")) for name in files() if name.parts[0] == "assets"} - {"CREDITS.md"}
    if not (ROOT / credits).exists():
        return [f"{credits}: it is missing"] if present else []
    wrong, credited = [], set()
    for number, line in enumerate(text_of(credits).splitlines(), 1):
        cells = line.split("|")
        if len(cells) < 4 or cells[1].strip() in ("file", "") or set(cells[1].strip()) <= set("-: "):
            continue
        for pattern in re.split(r",\s+", cells[1].strip()):
            for name in braces(pattern):
                found = fnmatch.filter(present, name)
                credited.update(found)
                if not found:
                    wrong.append(f"{credits}:{number}: there is no assets/{name}")
    return wrong + [f"assets/{name}: {credits} does not name it" for name in sorted(present - credited)]


def check_all() -> list[str]:
    wrong = []
    for name in files():
        if name.suffix == ".md":
            wrong += check_quotes(name) + check_links(name) + tables.check_figures(name) + claims.check_claims(name)
            if name.parts[0] == "docs" and name.parts[:2] != ("docs", "studies"):
                wrong += check_paragraphs(name) + check_next(name) + check_snippets(name)
            wrong += wrong_words(name, text_of(name))
        wrong += check_private_paths(name)
        if str(name) in ABOUT_THE_TREE:
            wrong += check_paths(name)
    wrong += [problem for chapter in chapters() for problem in check_lesson(chapter)]
    wrong += [problem for name in of_chapters(lessons()) for problem in check_named(name)]
    wrong += advice.check_page()
    return wrong + check_walk() + check_order(files()) + check_chapters() + check_starters() + check_credits() + check_variables() + \
        check_index() + check_figures() + check_generated()


if __name__ == "__main__":
    problems = check_all()
    for problem in problems:
        say(problem)
    sys.exit(1 if problems else 0)
