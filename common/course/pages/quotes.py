"""Code that lessons quote from the source.

A lesson quotes code by a marker. In docs/NN_name.md

    <!-- quote: chapters/01_obj/main.cpp#frame -->
    ```cpp
    (filled by ./course docs --quote)
    ```

and in main.cpp the lines between `// [frame]` and `// [/frame]`, each on a line of its own. The block equals them
without their indentation; other markers within them are left out.
"""

import re
from pathlib import Path

from check.starters import check_starters
from pages import advice
from pages.tables import check_tables, fill
from tree import ROOT, Failure, files, say, write_atomically

HELP = ("Fills the code that lessons quote (<!-- quote: FILE#MARKER --> before a block of code) from the source, and the\n"
        "tables of studies (<!-- table: FILE#... -->) and their verdicts (<!-- verdict: NN.name -->) from their JSON; writes\n"
        "docs/which.md, and tests/starters.txt, which says what is handed out as each exercise's starter.")

QUOTE = re.compile(r"\s*<!-- quote: (\S+?)#(\S+) -->\s*$")
FENCE = re.compile(r"\s*(```+|~~~+)")
MARKER = re.compile(r"\s*(?://|#) \[(/?)([\w.-]+)\]\s*$")
# A picture may be a link: [![words](picture)](page), in which the page's address follows a ")".
LINK = re.compile(r"(?:!?\[[^\]]*|(?<=\))[^\[\]()]*)\]\(<?([^)\s>]+)>?[^)]*\)|(?:src|href)=[\"']([^\"']+)[\"']")


def add_arguments(parser):
    parser.add_argument("--quote", action="store_true", help="fill what is quoted")


def run(_arguments, _rest) -> int:
    if advice.check_page():
        write_atomically(ROOT / advice.PAGE, advice.page())
    wrong = [problem for name in lessons() for problem in check_quotes(name, write=True)]
    check_starters(write=True)
    for problem in wrong:
        say(problem)
    return 1 if wrong else 0


def lessons() -> list[Path]:
    return [name for name in files() if name.suffix == ".md"]


def quoted(source: Path, marker: str) -> list[str]:
    """The lines that a marker names, without their common indentation. Raises Failure."""
    if not (ROOT / source).is_file():
        raise Failure(f"there is no {source}")
    if "solution" in source.parts:
        raise Failure(f"{source} would give the exercise away, and is in no handout")
    found, inside = [], False
    for line in (ROOT / source).read_text(encoding="utf-8").splitlines():
        match = MARKER.match(line)
        if match and match[2] == marker:
            if match[1]:
                break
            inside = True
        elif inside and not match:
            found.append(line.rstrip())
    else:
        raise Failure(f"{source} has no lines from [{marker}] to [/{marker}]")
    indents = [len(line) - len(line.lstrip()) for line in found if line]
    return [line[min(indents, default=0):] for line in found]


def check_quotes(lesson: Path, write: bool = False) -> list[str]:
    """Compares what a lesson quotes with the source: code, tables, verdicts. Or fills it; then only faults remain."""
    lines = before = (ROOT / lesson).read_text(encoding="utf-8").splitlines()
    faults = []
    for check in (check_code, check_tables, advice.check_blocks):
        found, lines = check(lesson, lines)
        faults += [one for one in found if not write or not one.endswith(" fills it")]
    if write and lines != before:
        write_atomically(ROOT / lesson, "\n".join(lines) + "\n")
    return faults


def check_code(lesson: Path, lines: list[str]) -> tuple[list[str], list[str]]:
    """The faults in a lesson's quoted blocks of code, and its lines with them filled."""
    def code(match: re.Match, i: int) -> tuple[int, int]:
        fence = FENCE.match(lines[i]) if i < len(lines) else None
        if not fence:
            raise Failure("no block of code follows the quote")
        end = next((j for j in range(i + 1, len(lines)) if lines[j].strip() == fence[1]), None)
        if end is None:
            raise Failure("the quoted block does not end")
        return i + 1, end

    return fill(lesson, lines, QUOTE, code, lambda match, *_: quoted(Path(match[1]), match[2]),
                lambda match, *_: [f"the block is not what {match[1]} says at [{match[2]}]"])
