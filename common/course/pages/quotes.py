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
from pages.tables import check_tables
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
    if advice.questions():
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
    """Compares a lesson's quoted blocks with the source, or fills them."""
    lines = (ROOT / lesson).read_text(encoding="utf-8").splitlines()
    wrong, out, i = [], [], 0
    while i < len(lines):
        out.append(lines[i])
        match = QUOTE.match(lines[i])
        i += 1
        if not match:
            continue
        here = f"{lesson}:{i}"
        fence = FENCE.match(lines[i]) if i < len(lines) else None
        if not fence:
            wrong.append(f"{here}: no block of code follows the quote")
            continue
        end = next((j for j in range(i + 1, len(lines)) if lines[j].strip() == fence[1]), None)
        if end is None:
            wrong.append(f"{here}: the quoted block does not end")
            continue
        body = lines[i + 1:end]
        try:
            source = quoted(Path(match[1]), match[2])
        except Failure as failure:
            wrong.append(f"{here}: {failure}")
            source = body
        if body != source and not write:
            wrong.append(f"{here}: the block is not what {match[1]} says at [{match[2]}]; ./course docs --quote fills it")
        out += [lines[i], *source, lines[end]]
        i = end + 1
    for check in (check_tables, advice.check_blocks):
        problems, out = check(lesson, out, write)
        wrong += problems
    if write and out != lines:
        write_atomically(ROOT / lesson, "\n".join(out) + "\n")
    return wrong
