"""How long a lesson's main thread takes to read: all that is neither folded nor an exercise, a deeper section, a question or a
reference, with its code, at 120 words a minute."""

import re
from pathlib import Path

from tree import ROOT

WORDS_A_MINUTE = 120
CODE = re.compile(r"^( *)(```+|~~~+).*?^\1\2\s*$", re.M | re.S)
HIDDEN = re.compile(r"<details>.*?</details>|<!--.*?-->", re.S)
BESIDE = re.compile(r"(Exercises|Deeper|Questions|Further reading)\b")


def sections(text: str) -> list[tuple[str, str]]:
    """(heading, text) for each section of the second level; the head of the page has an empty heading."""
    hidden = CODE.sub(lambda found: re.sub(r"^#", "\0", found[0], flags=re.M), text)
    parts = re.split(r"^## (.*)$", hidden, flags=re.M)
    parts = [part.replace("\0", "#") for part in parts]
    return [("", parts[0]), *zip(parts[1::2], parts[2::2])]


def minutes(page: Path) -> float:
    """Of a page of the tree, docs/02_lambert_phong.md for one."""
    text = HIDDEN.sub("", (ROOT / page).read_text(encoding="utf-8"))
    return sum(len(part.split()) for heading, part in sections(text) if not BESIDE.match(heading)) / WORDS_A_MINUTE
