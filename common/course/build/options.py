"""A chapter's options, compared with the sources before a build that may take minutes. The program itself checks the rest."""

import re
from pathlib import Path

from build.build import used
from tree import ROOT, UsageError, nearest, shots, sources

FLAG = re.compile(r'"(?:-\w,)?(--[a-z][a-z0-9-]*)')
NAME = re.compile(r'"([a-z][\w-]*)"')  # a knob's, or that of a chapter's own command, without its dashes


def check_options(chapter: str, words: list[str]):
    """Raises UsageError for a flag, a shot or a knob that no source names."""
    if not (ROOT / "common/app/options.cpp").exists():
        return
    texts = [path.read_text(errors="replace", encoding="utf-8") for folder in folders(chapter) for path in sources(folder, "**/*.[ch]*")]
    flags = {flag for text in texts for flag in FLAG.findall(text)} | {"--help", "--version"}
    names = {name for text in texts for name in NAME.findall(text)}
    for word, value in zip(words, [*words[1:], ""]):
        flag, _, joined = word.partition("=")
        if not flag.startswith("--"):
            continue
        if flag not in flags and flag[2:].rpartition(".")[2] not in names:
            raise UsageError(f"unrecognised option '{flag}' of chapter {chapter}; {nearest(flag, flags)}; ./course run {chapter[:2]} --help lists all")
        value = joined or value
        known = {shot["name"] for shot in shots(chapter)}
        if flag == "--shot" and value and value not in known:
            raise UsageError(f"chapter {chapter} has no shot '{value}'; {nearest(value, known)}; ./course run {chapter[:2]} --list shots lists all")
        knob = value.partition("=")[0].rpartition(".")[2]
        if flag == "--set" and re.fullmatch(r"[a-z]\w*", knob) and knob not in names:
            raise UsageError(f"no knob of chapter {chapter} is called '{knob}'; ./course run {chapter[:2]} --list knobs lists all")


def folders(chapter: str) -> list[Path]:
    """The folders with the C++ of a chapter's program."""
    rooms = [ROOT / "common" / room for room in ("base", "app", "scene", "study", "window", "gpu", "measure")]
    return [*rooms, *(ROOT / "chapters" / name for name in sorted({chapter, *used(chapter)}))]
