"""The commands that pages print: `./course run 08 --shot forge --set method=window` or `build/chapters/08_bloom ...`, in running
text and in blocks.

A chapter's program reads each of its own, and draws those that set something, small (./course docs --check). What ./course itself reads
is parsed without any program (text_check).
"""

import importlib
import itertools
import re
import shlex
import tempfile
from dataclasses import dataclass
from pathlib import Path

from commands import COMMANDS, Parser, names, selected
from pages.quotes import lessons
from shots.rendering import last_words, render_many, run_program
from tree import ROOT, UsageError, chapter_program, chapters, exercises, shots

PROGRAM = re.compile(r"(?:\./course run (\d\d)\b|\bbuild/chapters/(\w+))((?:(?! {2,}\w)[^\n`;|&#)])*)")
COURSE = re.compile(r"\./course ([a-z]+)((?:(?! {2,}\w)[^\n`;|&#)])*)")
SPAN = re.compile(r"(?<!`)`([^`]+)`(?!`)")
LOOP = re.compile(r"\bfor (\w+) in ([^;]+);")
# Options with a value that say how large a picture is, or where it goes.
ASIDE = ("--size", "--screenshot", "--frames")
# Options by which a program does something else than draw a picture, or measures for a minute.
OTHER = ("--study", "--timings", "--capture", "--list", "--help", "--explain", "--dump-mesh", "--load-bench", "--mip-bench",
         "--benchmark", "--ways", "--levels")
DRAWN = ("--size", "32x18")


@dataclass(frozen=True)
class Printed:
    """A command on a page; `words` are the program's."""
    page: Path
    line: int
    chapter: str
    words: tuple[str, ...]

    def __str__(self):
        return f"{self.page}:{self.line}: ./course run {self.chapter[:2]} {shlex.join(self.words)}"


def pieces(text: str) -> list[tuple[int, str]]:
    """(line, text) of code in running text and of lines of code, each with the lines that it goes on in."""
    found, taken = [], re.sub(r"\\\n", "  ", text)  # as long as before
    spans = [match for match in SPAN.finditer(text) if "\n\n" not in match[1]]
    found += [(match.start(), re.sub(r"\s+", " ", match[1])) for match in spans]
    for match in re.finditer(r"^(?: {4,}|(?=\./course|build/)).*$", taken, re.M):
        if not any(span.start() < match.end() and match.start() < span.end() for span in spans):
            line = match[0].split(" # ")[0]
            found.append((match.start(), re.sub(r" {2,}(?=-)", " ", line)))
    return [(text.count("\n", 0, at) + 1, piece) for at, piece in sorted(found)]


def printed_on(page: Path, text: str) -> list[Printed]:
    found, known = [], {chapter[:2]: chapter for chapter in chapters()}
    made = set(re.findall(r"\./course new (\d\d)", text))  # a page's example, which is in nobody's tree
    for line, piece in pieces(text):
        loops = LOOP.findall(piece)
        for values in itertools.product(*(values.split() for _, values in loops)):
            here = piece.replace('"$PWD/', f'"{ROOT}/')
            for (name, _), value in zip(loops, values):
                here = re.sub(rf"\$(?:{name}\b|\{{{name}\}})", value, here)
            for match in PROGRAM.finditer(here):
                words = shlex.split(match[3])
                if match[1] not in made and words != ["..."] and selected("run", words) == "run" and not {"NAME", "NN"} & set(words):
                    found.append(Printed(page, line, match[2] or known.get(match[1], match[1]), tuple(words)))
    return found


def printed() -> list[Printed]:
    once = {(one.chapter, one.words): one for page in reversed(lessons())
            for one in reversed(printed_on(page, (ROOT / page).read_text(encoding="utf-8")))}
    return sorted(once.values(), key=lambda one: (str(one.page), one.line))


def is_drawn(words: tuple[str, ...]) -> bool:
    """True where a golden does not have the picture: something is set beside a shot and whose exercises run."""
    options = {word for word in words if word.startswith("--")}
    return bool(options - {"--shot", "--use", *ASIDE}) and not options & set(OTHER)


def small(words: tuple[str, ...]) -> list[str]:
    kept = [word for i, word in enumerate(words) if word not in ASIDE and (i == 0 or words[i - 1] not in ASIDE)]
    return [*kept, *DRAWN]


def wrong_of(chapter: str) -> list[str]:
    """A line for each command that the chapter's built program refuses, or fails to draw."""
    drawn, wrong = [], []
    for one in (one for one in printed() if one.chapter == chapter):
        done = run_program([chapter_program(chapter), *one.words, *([] if "--list" in one.words else ["--list", "shots"])])
        if done.returncode:
            wrong.append(f"{one}: {last_words(done.stderr, done.stdout)}")
        elif is_drawn(one.words):
            drawn.append(one)
    with tempfile.TemporaryDirectory() as folder:
        said = render_many(chapter, [(small(one.words), Path(folder) / f"{i}.png") for i, one in enumerate(drawn)])
    return wrong + [f"{one}: {words}" for one, words in zip(drawn, said) if words]


def wrong_words(page: Path, text: str) -> list[str]:
    """A line for each command of ./course but run that it would refuse: an option, an exercise or a shot that is not there."""
    wrong, examples = [], set(re.findall(r"\./course new (\d\d)_", text))  # chapters that the page imagines
    for line, piece in pieces(text):
        for match in COURSE.finditer(piece):
            module = importlib.import_module(COMMANDS[selected(match[1], match[2].split())]) if match[1] in names() else None
            if hasattr(module, "run_words"):
                continue
            try:
                refuse(match[1], module, match[2].split(), examples)
            except (UsageError, ValueError) as error:
                wrong.append(f"{page}:{line}: {match[0].strip()}: {error}")
    return wrong


def refuse(command: str, module, words: list[str], examples: set[str] = frozenset()):
    """Raises UsageError for words that a command does not take. Words in capitals stand for others; nothing is asked of
    chapters whose number is in `examples`."""
    if module is None:
        raise UsageError(f"there is no command '{command}'")
    parser = Parser(prog=command, allow_abbrev=False)
    module.add_arguments(parser)
    words = [word for word in words if word != "..."]
    if words and words[-1].startswith("--"):  # it may be named without its value
        words.append("1")
    _, rest = parser.parse_known_args(words)
    rest = [word for word in rest if word != "1"]
    if rest and not getattr(module, "PASSES_OPTIONS", False):
        raise UsageError(f"unrecognised argument '{rest[0]}'")
    for word in words:
        chapter = next((one for one in chapters() if re.fullmatch(rf"{one[:2]}\.[a-z]\w*", word)), None)
        if chapter and chapter[:2] not in examples and word not in [*exercises(chapter), *(f"{chapter[:2]}.{shot['name']}" for shot in shots(chapter))]:
            raise UsageError(f"there is no {word}")
