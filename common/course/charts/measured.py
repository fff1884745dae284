"""The version of the sources that a study measured, so that a page can mark an outdated one.

A study's JSON keeps under "measured" a hash of its methods' sources: the C++ and GLSL of its chapter, its own request
(study.json, study_lamps.json, timings.json) and that request's scenes. Borrowed modules belong to other studies. Comments,
blanks, help texts and exercises do not count. Errors measured again without times (./course study --errors) have theirs under
"errors_measured".
"""

import hashlib
import json
import re
from collections.abc import Callable
from pathlib import Path

from tree import ROOT

SOURCES = (".cpp", ".h", ".glsl", ".comp", ".frag", ".vert")
# Comments, includes, and texts that a person reads: help and titles.
UNREAD = re.compile(r"//[^\n]*|/\*.*?\*/|^[ \t]*#include[^\n]*|\"[^\"\n]*[ ][^\"\n]*\"", re.S | re.M)
UNMEASURED = ("title", "rounds", "charts", "verdicts", "unsteady")  # parts of a request that change no row
Reader = Callable[[str], str]


def sources(listed: list[str], chapter: str) -> list[str]:
    """The listed files that determine a chapter's methods."""
    return sorted(name for name in listed if name.split("/")[:2] in (["chapters", chapter], ["shaders", chapter]) and
                  Path(name).suffix in SOURCES and "/exercise/" not in name)


def version_of(listed: list[str], read: Reader, chapter: str, request: str = "") -> str:
    request = request or f"chapters/{chapter}/study.json"
    names = sources(listed, chapter)
    if request in listed:
        names.append(request)
        scenes = {f"assets/{scene}" for scene in re.findall(r"\bscenes/[\w./-]+\.json", read(request))}
        names += [name for name in listed if name in scenes]
    digest = hashlib.sha256()
    for name in names:
        text = read(name)
        if name == request:
            text = json.dumps({key: value for key, value in json.loads(text).items() if key not in UNMEASURED})
        plain = UNREAD.sub("", text) if Path(name).suffix in SOURCES else re.sub(r'"label": *"[^"]*"', "", text)
        digest.update(f"{name}\0{''.join(plain.split())}\0".encode())
    return digest.hexdigest()[:12]


def request_of(study: dict) -> str:
    """The file that says what a study's JSON measured."""
    if own := re.search(r"--study-file (chapters/\S+\.json)", study.get("command", "")):
        return own[1]
    return f"chapters/{study['chapter']}/{'timings' if '--timings' in study.get('command', '') else 'study'}.json"


def here(chapter: str, request: str = "") -> str:
    if (chapter, request) not in _here:
        listed = [str(path.relative_to(ROOT)) for folder in ("chapters", "shaders", "assets/scenes")
                  for path in sorted((ROOT / folder).rglob("*")) if path.is_file()]
        _here[chapter, request] = version_of(listed, lambda name: (ROOT / name).read_text(encoding="utf-8"), chapter, request)
    return _here[chapter, request]


_here: dict[tuple[str, str], str] = {}


def is_of_earlier(study: Path, key: str = "measured") -> bool:
    """True if a study's JSON measured other sources than the current ones. False if it does not say. Timings of several chapters'
    programs have the version of each (timings.py). The key "errors_measured" is that of errors alone."""
    try:
        said = json.loads(study.read_text(encoding="utf-8"))
        names = said.get("programs", [said["chapter"]])
        return (key in said and all((ROOT / "chapters" / name).is_dir() for name in names) and
                said[key] != "+".join(here(name, request_of(said)) for name in names))
    except (OSError, ValueError, KeyError):
        return False


def has_old_times_alone(study: Path) -> bool:
    """True where only the times are of an earlier version: errors were measured again without them."""
    try:
        return "errors_measured" in json.loads(study.read_text(encoding="utf-8")) and not is_of_earlier(study, "errors_measured")
    except (OSError, ValueError):
        return False


def earlier() -> list[Path]:
    return [path for path in sorted((ROOT / "docs/studies").rglob("*.json")) if is_of_earlier(path)]
