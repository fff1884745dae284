"""Finds and reads what students handed in: folders and archives, none of which is trusted.

Only regular files are opened, links are followed nowhere, and of an archive the exercises alone are read, as many bytes of
each as an exercise may have. Whatever is wrong with one submission is that one's Failure.
"""

import bz2
import dataclasses
import gzip
import itertools
import lzma
import mmap
import os
import re
import stat
import tarfile
import unicodedata
import zipfile
from pathlib import Path

from tree import Failure, UsageError

ARCHIVES = (".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2")
MOST_EXERCISE_BYTES = 1 << 18
MOST_ARCHIVE_BYTES = 64 << 20
MOST_UNPACKED_BYTES = 256 << 20
MOST_MEMBERS = 20000
MOST_STUDENTS = 5000


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
        if any((path / name).is_dir() for name in ("chapters", "shaders")):
            return [Submission(name_of(path), path)]
        children = sorted(os.scandir(path), key=lambda one: one.name)
    except OSError as error:
        raise UsageError(f"{shown}: {error.strerror}") from None
    found = []
    for child in children:
        if child.name.startswith("."):
            continue
        where = Path(child.path)
        if child.is_symlink():
            found.append(Submission(name_of(where), where, "is a link, which is not followed"))
        elif child.is_dir(follow_symlinks=False):
            found.append(Submission(name_of(where), where))
        elif child.name.endswith(ARCHIVES):
            regular = child.is_file(follow_symlinks=False)
            found.append(Submission(name_of(where), where, "" if regular else "is not a regular file"))
    if not found:
        raise UsageError(f"{shown}: there is no submission in it")
    return found


def name_of(path: Path) -> str:
    name = path.absolute().name
    return printable(next((name[:-len(end)] for end in ARCHIVES if name.endswith(end)), name)) or "nobody"


def printable(text: str, most: int = 200) -> str:
    """One line without control characters: neither a terminal nor a table takes it for more than a word."""
    shown = "".join(c if unicodedata.category(c)[0] not in "C" and c not in "\u2028\u2029" else
                    f"\\x{ord(c) - 0xdc00:02x}" if 0xdc80 <= ord(c) <= 0xdcff else f"\\u{ord(c):04x}" for c in text)
    return shown if len(shown) <= most else shown[:most - 3] + "..."


def cell(text: str) -> str:
    """Text that no spreadsheet takes for a formula, whatever it takes for the end of a cell."""
    def guarded(found):
        return found[0] + "'" * (unicodedata.normalize("NFKC", found[2]) in "=+-@\u2212|%")
    return re.sub(r"""((?:^|[;,|"'\t\n])\s*)(?=(\S))""", guarded, text)


def time_of(path: Path, wanted) -> float | None:
    """When it was handed in, as far as its files tell: an archive's own time, of a folder that of the newest exercise in it, in
    whole seconds since 1970. None where there is none."""
    try:
        if not stat.S_ISDIR(path.lstat().st_mode):
            return int(path.lstat().st_mtime)
        tops = [path, *[Path(one.path) for one in os.scandir(path) if one.is_dir(follow_symlinks=False)][:100]]
        return max((int((top / name).lstat().st_mtime) for top in tops for name in wanted if (top / name).exists()), default=None)
    except OSError:
        return None


def read(submission: Submission, wanted: set[str]) -> dict[str, bytes]:
    """The exercises in it, by their path in the course. Raises Failure."""
    if submission.refused:
        raise Failure(submission.refused)
    found = {}
    try:
        for name, data in _exercises(submission.path, wanted):
            # One archive may hold a file twice; unpacked the last one would be there.
            found[name] = data.removeprefix(b"\xef\xbb\xbf")
    except Failure:
        raise
    except Exception as error:  # of a library that unpacks: whatever it is, it is this archive's
        raise Failure(printable(f"cannot be read: {error or type(error).__name__}")) from None
    if not found:
        raise Failure("holds no exercise")
    return found


def _exercises(path: Path, wanted: set[str]):
    """(path in the course, bytes) of each exercise. The course may lie in one folder of its own."""
    folder = stat.S_ISDIR(os.stat(path).st_mode)
    for name, read_at_most in _folder(path, wanted) if folder else _archive(path):
        top, _, rest = name.partition("/")
        inside = name if name in wanted else rest if rest in wanted and top not in ("", ".", "..") else None
        if inside:
            data = read_at_most(MOST_EXERCISE_BYTES + 1)
            if len(data) > MOST_EXERCISE_BYTES:
                raise Failure(f"{inside} is larger than {MOST_EXERCISE_BYTES >> 10} KiB")
            yield inside, data


def _folder(path: Path, wanted: set[str]):
    """Of a folder, and of those directly in it, what may be an exercise; no step of the way is a link."""
    tops = [""] + [f"{one.name}/" for one in os.scandir(path) if one.is_dir(follow_symlinks=False)
                   and one.name not in ("chapters", "shaders")][:100]
    for top in tops:
        for name in sorted(wanted):
            try:
                if (path / top / name).exists():
                    yield top + name, lambda most, name=top + name: read_below(path, name, most)
            except OSError:
                raise Failure(f"{printable(top + name)} cannot be read") from None


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


class Bounded:
    """A stream that ends in Failure where it is unpacked to more than an archive of exercises can be."""

    def __init__(self, stream):
        self.stream, self.left = stream, MOST_UNPACKED_BYTES

    def read(self, count=-1):
        data = self.stream.read(min(count, 1 << 20) if count >= 0 else 1 << 20)
        self.left -= len(data)
        if self.left < 0:
            raise Failure(f"unpacks to more than {MOST_UNPACKED_BYTES >> 20} MiB")
        return data


def _archive(path: Path):
    """(name, a function that reads at most so many bytes) of each ordinary file."""
    handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    with os.fdopen(handle, "rb") as file:
        status = os.fstat(handle)
        if not stat.S_ISREG(status.st_mode):
            raise Failure("is not a regular file")
        if status.st_size > MOST_ARCHIVE_BYTES:
            raise Failure(f"is larger than {MOST_ARCHIVE_BYTES >> 20} MiB")
        yield from _zip(file) if path.name.endswith(".zip") else _tar(file)


def _zip(file):
    refuse_many_members(file)
    with zipfile.ZipFile(file) as archive:
        left = [MOST_UNPACKED_BYTES]
        for info in archive.infolist():
            kind = stat.S_IFMT(info.external_attr >> 16)
            if not info.is_dir() and kind in (0, stat.S_IFREG):
                yield info.filename.removeprefix("./"), lambda most, info=info: _start(archive, info, most, left)


def _start(archive, info, most: int, left: list[int]) -> bytes:
    """`left`: how many bytes the members of this archive may still be unpacked to."""
    # The other methods unpack as much at once as the archive says, whatever it is asked for.
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise Failure(f"{printable(info.filename)} is packed by method {info.compress_type}; a .zip is stored or deflated here")
    with archive.open(info) as stream:
        data = stream.read(most)
    left[0] -= len(data)
    if left[0] < 0:
        raise Failure(f"unpacks to more than {MOST_UNPACKED_BYTES >> 20} MiB")
    return data


def refuse_many_members(file):
    """Before a list of them is made, which can be a thousand times their headers' size."""
    with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as all_bytes:
        count, at = 0, all_bytes.find(b"PK\x01\x02")
        while at >= 0:
            count, at = count + 1, all_bytes.find(b"PK\x01\x02", at + 4)
            if count > MOST_MEMBERS:
                raise Failure(f"holds more than {MOST_MEMBERS} files")


def _tar(file):
    magic = file.read(6)
    file.seek(0)
    if magic.startswith(b"\x1f\x8b"):
        file = gzip.GzipFile(fileobj=file)
    elif magic.startswith(b"BZh"):
        file = bz2.BZ2File(file)
    elif magic.startswith(b"\xfd7zXZ\x00"):
        file = Unxz(file)
    with tarfile.open(fileobj=Bounded(file), mode="r|") as archive:
        for number, info in enumerate(archive):
            if number >= MOST_MEMBERS:
                raise Failure(f"holds more than {MOST_MEMBERS} files")
            if info.isfile():
                yield re.sub(r"^\./", "", info.name), lambda most, info=info: archive.extractfile(info).read(most)


class Unxz:
    """xz with a limit of memory, which its own header may set to gigabytes."""

    def __init__(self, file):
        self.file, self.unpacker = file, lzma.LZMADecompressor(lzma.FORMAT_XZ, memlimit=128 << 20)

    def read(self, count):
        while not self.unpacker.eof:
            data = self.unpacker.decompress(self.file.read(65536) if self.unpacker.needs_input else b"", count)
            if data:
                return data
            if self.unpacker.needs_input and not self.file.peek(1):
                raise Failure("cannot be read: it is cut off")
        return b""
