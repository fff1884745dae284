"""Finds and reads submissions: untrusted folders and archives. Every entry of a class becomes a submission, or a reason for
its refusal.

An exercise is known by its path in the course, which may lie in folders of its own. Of several courses in a submission the one of
the shortest path counts, then the one with more changed exercises, and a note says so. Where an exercise has no such path, or is
the starter there, a file is one by its name alone. Without any, archives within the submission, as Moodle hands them out, are
looked into. Of several archives, and of several files of one name, the same counts.

Only regular files are opened, links are followed nowhere, and of an archive the exercises alone are read, as many bytes of
each as an exercise may have. A fault of one submission is that one's Failure.
"""

import contextlib
import dataclasses
import itertools
import os
import re
import stat
import tempfile
import unicodedata
from pathlib import Path

from grading.archives import ENDINGS, MOST_ARCHIVE_BYTES, is_archive, members, open_regular
from tree import Failure, UsageError

MOST_EXERCISE_BYTES = 1 << 18
MOST_STUDENTS = 5000
DEEPEST = 12  # folders around a course
MOST_FOLDERS = 300  # in which one is looked for
MOST_TREES = 20
LITTER = {".DS_Store", "Thumbs.db", "desktop.ini", "__MACOSX"}  # of file managers
LATEST_S = 253_370_764_800  # the year 9999: latest valid time of a file


@dataclasses.dataclass
class Submission:
    student: str  # as it is printed: no control characters, and no two alike
    path: Path
    refused: str = ""  # why it is not even opened


def find(paths: list[Path]) -> list[Submission]:
    """A folder without a course in it is taken for a folder of submissions. Raises UsageError."""
    found = [one for path in paths for one in _find(path)]
    if len(found) > MOST_STUDENTS:
        raise UsageError(f"{len(found)} submissions; {MOST_STUDENTS} at most")
    taken = set()
    for one in found:
        names = itertools.chain([one.student], (f"{one.student} ({number})" for number in itertools.count(2)))
        one.student = next(name for name in names if cell(name) not in taken)
        taken.add(cell(one.student))
    return found


def _find(path: Path) -> list[Submission]:
    shown = printable(str(path))
    try:
        mode = path.stat().st_mode
    except (FileNotFoundError, ValueError):  # a name with a zero in it is one of nothing
        raise UsageError(f"{shown}: there is no such file or folder") from None
    except OSError as error:
        raise UsageError(f"{shown}: {error.strerror}") from None
    if stat.S_ISREG(mode):
        return [Submission(name_of(path), path)]
    if not stat.S_ISDIR(mode):
        raise UsageError(f"{shown}: is neither a folder nor an archive")
    try:
        if any(path.glob("chapters/[0-9][0-9]_*/exercise")) or any(path.glob("shaders/[0-9][0-9]_*/exercise")):
            return [Submission(name_of(path), path)]
        children = sorted(os.scandir(path), key=lambda one: one.name)
    except OSError as error:
        raise UsageError(f"{shown}: {error.strerror}") from None
    found = []
    for child in children:
        if child.name in LITTER:
            continue
        where = Path(child.path)
        if child.is_symlink():
            found.append(Submission(name_of(where), where, "is a link, which is not followed"))
        elif child.is_dir(follow_symlinks=False):
            found.append(Submission(name_of(where), where))
        elif not child.is_file(follow_symlinks=False):
            found.append(Submission(name_of(where), where, "is not a regular file"))
        else:
            found.append(Submission(name_of(where), where, "" if is_archive(child.name) or where.suffix in (".glsl", ".cpp") else
                                    f"is neither a folder nor an archive: one of {', '.join(ENDINGS[:5])} ..."))
    if not found:
        raise UsageError(f"{shown}: there is no submission in it")
    return found


def name_of(path: Path) -> str:
    name = path.absolute().name
    return printable(next((name[:-len(end)] for end in sorted(ENDINGS, key=len, reverse=True) if name.lower().endswith(end)), name)) or "nobody"


def printable(text: str, most: int = 200) -> str:
    """One line without control characters: neither a terminal nor a table takes it for more than a word."""
    shown = "".join(c if unicodedata.category(c)[0] not in "C" and c not in "\u2028\u2029" else
                    f"\\x{ord(c) - 0xdc00:02x}" if 0xdc80 <= ord(c) <= 0xdcff else f"\\u{ord(c):04x}" for c in text)
    return shown if len(shown) <= most else shown[:most - 3] + "..."


def cell(text: str) -> str:
    """Text that no spreadsheet takes for a formula, for any cell separator."""
    def guarded(found):
        return found[0] + "'" * (unicodedata.normalize("NFKC", found[2]) in "=+-@\u2212|%")
    return re.sub(r"""((?:^|[;,|"'\t\n])\s*)(?=(\S))""", guarded, text)


def time_of(path: Path, wanted) -> float | None:
    """When it was handed in, as far as its files tell: an archive's own time, of a folder that of the newest exercise or archive in
    it, in whole seconds since 1970. They are the student's to set. None where there is none, or none that a calendar has."""
    try:
        if not stat.S_ISDIR(path.lstat().st_mode):
            times = [path.lstat().st_mtime]
        else:
            inside = list(os.scandir(path))[:1000]
            tops = [path, *[Path(one.path) for one in inside if one.is_dir(follow_symlinks=False)][:100]]
            times = [(top / name).lstat().st_mtime for top in tops for name in wanted if (top / name).exists()] or \
                    [one.stat(follow_symlinks=False).st_mtime for one in inside if one.is_file(follow_symlinks=False)]
    except OSError:
        return None
    return max((int(one) for one in times if 0 <= one < LATEST_S), default=None)


def read(submission: Submission, wanted: set[str], starters: dict[str, bytes] | None = None, notes: list[str] | None = None) -> dict[str, bytes]:
    """The exercises in it, by their path in the course. `starters`, by path, tell what was changed; `notes` gets a line for each
    choice between several. Raises Failure."""
    if submission.refused:
        raise Failure(submission.refused)
    try:
        found = _exercises(submission.path, Reading(wanted, starters or {}, [] if notes is None else notes))
    except Failure:
        raise
    except Exception as error:  # of a library that unpacks: any failure is this archive's
        raise Failure(printable(f"cannot be read: {error or type(error).__name__}")) from None
    if not found:
        raise Failure("holds no exercise")
    return {name: data.removeprefix(b"\xef\xbb\xbf") for name, data in found.items()}


@dataclasses.dataclass
class Reading:
    wanted: set[str]
    starters: dict[str, bytes]
    notes: list[str]

    def is_changed(self, inside: str, data: bytes) -> bool:
        return b"".join(data.split()) != b"".join(self.starters.get(inside, b"\0").split())


def _exercises(path: Path, reading: Reading) -> dict[str, bytes]:
    wanted = reading.wanted
    if stat.S_ISDIR(os.stat(path).st_mode):
        return _placed(_folder(path, wanted), reading)
    if is_archive(path.name):
        with open_regular(path) as file:
            return _placed(members(file, limits(wanted)), reading)
    # Canvas puts a name and two numbers before a file's own, and a number behind it where it was handed in again
    own = re.sub(r"(-\d{1,3}| \(\d{1,3}\))(?=\.\w+$)", "", path.name)
    name = next((one for one in by_name(wanted) if own == one or own.endswith(f"_{one}")), path.name)
    return _placed([(name, lambda most: read_below(path.parent, path.name, most))], reading)


def _placed(files, reading: Reading, within: int = 0) -> dict[str, bytes]:
    """Of (name, reader) the exercises by path; without any, by name alone, and the contents of an archive among them."""
    named = by_name(reading.wanted)
    trees, loose, nested, texts = {}, {}, [], {}  # the exercises by path, and by name alone, each by the folder they lie in
    with contextlib.ExitStack() as kept:  # on the disk: twenty of them would be a gigabyte of memory
        for name, read_at_most in files:
            words = name.split("/")
            if LITTER & set(words) or words[-1].startswith("._"):
                continue
            if inside := place_of(name, reading.wanted):
                data = bounded(read_at_most, inside)
                # One archive may hold a file twice; unpacked the last one would be there.
                trees.setdefault(name[:len(name) - len(inside)].removeprefix("./"), {})[inside] = texts.setdefault(data, data)
                if len(trees) > MOST_TREES and len(texts) > MOST_TREES:
                    raise Failure(f"holds more than {MOST_TREES} courses; hand in one")
            elif words[-1] in named and ".." not in words and words[0]:
                data = bounded(read_at_most, words[-1])
                loose.setdefault(name[:-len(words[-1])].removeprefix("./"), {})[named[words[-1]]] = texts.setdefault(data, data)
            elif is_archive(words[-1]) and not within and len(nested) < 20:
                file = kept.enter_context(tempfile.TemporaryFile())
                file.write(read_at_most(MOST_ARCHIVE_BYTES))
                nested.append((name, file))
        if not trees:
            for name, file in nested:
                file.seek(0)
                trees[name] = _placed(members(file, limits(reading.wanted)), reading, within + 1)
        found = chosen(trees, reading)
        for inside, data in chosen(loose, reading).items():
            if inside not in found or not reading.is_changed(inside, found[inside]) and reading.is_changed(inside, data):
                if inside in found:
                    reading.notes.append(f"{printable(inside.rpartition('/')[2])} was judged as it lies alone: in its place lies the starter")
                found[inside] = data
            elif data != found[inside] and reading.is_changed(inside, data):
                reading.notes.append(f"{printable(inside.rpartition('/')[2])} lies there twice: the one in its place was judged")
        return found


def chosen(trees: dict[str, dict[str, bytes]], reading: Reading) -> dict[str, bytes]:
    """One text for each exercise, of courses by the folders before them. Raises Failure where it is open which is meant."""
    ranks = {top: (top.count("/"), -sum(reading.is_changed(*one) for one in files.items())) for top, files in trees.items()}
    found, source, passed = {}, {}, {}
    for top in sorted(trees, key=lambda top: (ranks[top], top)):
        for inside, data in trees[top].items():
            if inside not in found or not reading.is_changed(inside, found[inside]) and reading.is_changed(inside, data):
                found[inside], source[inside] = data, top
            elif data != found[inside] and reading.is_changed(inside, data):
                if ranks[top] == ranks[source[inside]]:
                    raise Failure(f"holds two courses, {shown(source[inside])} and {shown(top)}, and which is meant is open; hand in one")
                passed[top] = source[inside]
    for top, instead in passed.items():
        reading.notes.append(f"holds more than one course: {shown(instead)} was judged, {shown(top)} was not")
    return found


def shown(top: str) -> str:
    return printable(top) or "the outermost"


def place_of(name: str, wanted: set[str]) -> str | None:
    words = name.removeprefix("./").split("/")
    if ".." in words or "." in words or not words[0]:
        return None
    return next((inside for skipped in range(min(len(words), DEEPEST + 1)) if (inside := "/".join(words[skipped:])) in wanted), None)


def by_name(wanted: set[str]) -> dict[str, str]:
    last = [name.rpartition("/")[2] for name in wanted]
    return {name.rpartition("/")[2]: name for name in wanted if last.count(name.rpartition("/")[2]) == 1}


def limits(wanted: set[str]) -> dict[str, int]:
    return {name.rpartition("/")[2]: MOST_EXERCISE_BYTES for name in wanted} | {end: MOST_ARCHIVE_BYTES // 2 for end in ENDINGS}


def bounded(read_at_most, name: str) -> bytes:
    data = read_at_most(MOST_EXERCISE_BYTES + 1)
    if len(data) > MOST_EXERCISE_BYTES:
        raise Failure(f"{printable(name)} is larger than {MOST_EXERCISE_BYTES >> 10} KiB")
    return data


def _folder(path: Path, wanted: set[str]):
    """Candidates of a folder and its subfolders: exercises by path, then exercises or archives by name alone; links are
    never followed."""
    tops = folders_in(path)
    for top in tops:
        for name in sorted(wanted):
            try:
                if (path / top / name).exists():
                    yield top + name, lambda most, name=top + name: read_below(path, name, most)
            except OSError:
                raise Failure(f"{printable(top + name)} cannot be read") from None
    named = by_name(wanted)
    for top in tops:
        for one in sorted(itertools.islice(os.scandir(path / top), 2000), key=lambda one: one.name):
            if (one.name in named or is_archive(one.name)) and not one.is_symlink():
                yield top + one.name, lambda most, name=top + one.name: read_below(path, name, most)


def folders_in(path: Path) -> list[str]:
    """The ways to those in which a course may lie, "" first, each with a slash."""
    found = [""]
    for top in found:
        if top.count("/") < DEEPEST and len(found) < MOST_FOLDERS:
            inside = sorted(f"{top}{one.name}/" for one in itertools.islice(os.scandir(path / top), 2000)
                            if one.is_dir(follow_symlinks=False) and one.name not in ("chapters", "shaders", *LITTER))
            found += inside[:MOST_FOLDERS - len(found)]
    return found


def read_below(folder: Path, name: str, most: int) -> bytes:
    """At most so many bytes of a regular file; a link on the way to it raises Failure."""
    at = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        for part in name.split("/"):
            try:
                next_at = os.open(part, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK, dir_fd=at)
            except OSError as error:
                raise Failure(f"{printable(name)}: {'is a link' if os.path.islink(f'/proc/self/fd/{at}/{part}') else error.strerror}") from None
            os.close(at)
            at = next_at
        if not stat.S_ISREG(os.fstat(at).st_mode):
            raise Failure(f"{printable(name)}: is not a regular file")
        data = b""
        while len(data) < most and (got := os.read(at, most - len(data))):
            data += got
        return data
    finally:
        os.close(at)
