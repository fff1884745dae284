"""Cuts long work into independent shards, and merges their results by name.

A shard is the part K of N of a command's work: `--shard 3/16`. A piece's shard follows from its name alone
(a submission's file, a frame, a scene of a study), so that neither the order of the pieces nor later additions move
another one from shard to shard. A shard's result is one file, KIND.3-of-16.zip, which is written when all of it is done:

    shard.json   {"kind", "shard": [3, 16], "command", "head", "entries": {name: value}}
    files/...    files of the entries: pictures, answers

`head` must be equal in all shards (the class, the size, the seed); a merge refuses shards that differ in it.
The same shard of the same input gives the same bytes where its entries hold no times.

    add_arguments(parser)                      --shard, --merge
    shard.takes(name)                          whether a piece belongs to it
    write(file_of(out, kind, shard), ...)      at the end of a shard
    merge(paths, kind)                         a Merged: head, entries, file(name)
"""

import argparse
import dataclasses
import hashlib
import json
import os
import re
import shlex
import sys
import tempfile
import zipfile
import zlib
from pathlib import Path

from tree import BUILD, ROOT, Failure, UsageError, files, relative

MOST = 10000  # shards
STAMP = (1980, 1, 1, 0, 0, 0)  # of all members: the same content is the same bytes


@dataclasses.dataclass(frozen=True)
class Shard:
    number: int  # from 1
    of: int

    def __str__(self) -> str:
        return f"{self.number}/{self.of}"

    def takes(self, name: str) -> bool:
        """By a hash of the name: parts of nearly equal size, and no piece's place depends on another's."""
        digest = hashlib.sha256(os.fsencode(name)).digest()
        return int.from_bytes(digest[:8], "big") % self.of == self.number - 1


def argument(word: str) -> Shard:
    """Raises ArgumentTypeError."""
    found = re.fullmatch(r"0*([1-9]\d{0,5})/0*([1-9]\d{0,5})", word)
    if not found or int(found[1]) > int(found[2]) or int(found[2]) > MOST:
        raise argparse.ArgumentTypeError(f"'{word}' is not a shard; expected K/N with 1 <= K <= N <= {MOST}, such as 3/16")
    return Shard(int(found[1]), int(found[2]))


def add_arguments(parser):
    parser.add_argument("--shard", type=argument, metavar="K/N", help="do part K of N, and write it to a file for --merge")
    parser.add_argument("--merge", type=Path, nargs="+", metavar="FILE", help="merge shards: their files, or folders of them")


def check_arguments(arguments):
    """Raises UsageError where both were given."""
    if arguments.shard and arguments.merge:
        raise UsageError("--shard makes a part and --merge puts parts together: one of them")


def file_of(out: Path | None, kind: str, shard: Shard) -> Path:
    """Where a shard is written: `out` where it is named like a file (.zip), else a file in the folder `out`, or in
    build/shards. Raises UsageError where nothing can be written there: before the work, not behind it."""
    out = (out or BUILD / "shards").absolute()
    file = out if out.suffix == ".zip" else out / f"{kind}.{shard.number}-of-{shard.of}.zip"
    if file.is_dir():
        raise UsageError(f"{file} is a folder; --out takes a folder's name without .zip")
    check_writable(file.parent)
    return file


def check_writable(folder: Path):
    """Makes nothing. Raises UsageError."""
    there = next(place for place in (folder, *folder.parents) if place.exists())
    try:
        with tempfile.TemporaryFile(dir=there):
            pass
    except OSError as error:
        raise UsageError(f"{folder} cannot be written: {error.strerror}") from None


def write(file: Path, kind: str, shard: Shard, head: dict, entries: dict, files: dict[str, bytes | Path] | None = None):
    """Writes a shard whole or not at all. `files`: by name, bytes or where they lie."""
    about = {"kind": kind, "shard": [shard.number, shard.of], "command": command_words(sys.argv[1:]), "head": head,
             "entries": entries}
    file.parent.mkdir(parents=True, exist_ok=True)
    beside = file.with_name(f".{file.name}.{os.getpid()}")
    try:
        with zipfile.ZipFile(beside, "w") as archive:
            members = {"shard.json": json.dumps(about, indent=1).encode() + b"\n"}
            members |= {f"files/{name}": content for name, content in sorted((files or {}).items())}
            for name, content in members.items():
                info = zipfile.ZipInfo(name, STAMP)
                info.compress_type = zipfile.ZIP_STORED if name.endswith((".png", ".webp", ".mp4", ".mkv")) else zipfile.ZIP_DEFLATED
                info.external_attr = 0o644 << 16
                archive.writestr(info, content if isinstance(content, bytes) else Path(content).read_bytes())
        os.replace(beside, file)
    finally:
        beside.unlink(missing_ok=True)


def command_words(words: list[str]) -> str:
    kept, words = [], list(words)
    while words:
        word = words.pop(0)
        if word == "--shard":
            del words[:1]
        elif not word.startswith("--shard="):
            kept.append(word)
    return shlex.join(["./course", *kept])


DAMAGED = (OSError, zipfile.BadZipFile, zlib.error, EOFError, KeyError, ValueError, TypeError, AttributeError, NotImplementedError,
           RuntimeError, MemoryError)  # results of reading a damaged or foreign file


class Merged:
    def __init__(self, of: int):
        self.of, self.head, self.entries, self.came_from = of, {}, {}, {}

    def file(self, entry: str, name: str) -> bytes:
        try:
            with zipfile.ZipFile(self.came_from[entry]) as archive:
                return archive.read(f"files/{name}")
        except DAMAGED as error:
            raise UsageError(f"{self.came_from[entry]}: is damaged: {error}") from None

    def has_file(self, entry: str, name: str) -> bool:
        with zipfile.ZipFile(self.came_from[entry]) as archive:
            return f"files/{name}" in archive.namelist()


def merge(paths: list[Path], kind: str, per_shard=()) -> Merged:
    """Reads shards of one kind. Keys of the head in `per_shard` may differ; they become lists by shard. Raises UsageError
    for shards that do not belong together, and Failure for a missing one, with the command that makes it."""
    found = {}
    for path in files_in(paths, kind):
        about = read(path, kind)
        number, of = about["shard"]
        first = next(iter(found.values()), (path, about))
        if of != first[1]["shard"][1]:
            raise UsageError(f"{relative(path)} is a shard of {of} and {relative(first[0])} one of {first[1]['shard'][1]}: "
                             "merge those of one cut")
        for key in sorted(set(about["head"]) | set(first[1]["head"])):
            if key not in per_shard and about["head"].get(key) != first[1]["head"].get(key):
                raise UsageError(f"{relative(path)} and {relative(first[0])} differ in {short(key)[1:-1]}: "
                                 f"{short(about['head'].get(key))} and {short(first[1]['head'].get(key))}; make both again")
        if number in found and found[number][1]["entries"] != about["entries"]:
            raise UsageError(f"{relative(path)} and {relative(found[number][0])} are both shard {number}/{of}, and differ: "
                             "keep one of them")
        found.setdefault(number, (path, about))
    of = next(iter(found.values()))[1]["shard"][1]
    if missing := [number for number in range(1, of + 1) if number not in found]:
        command = next(iter(found.values()))[1]["command"]
        named = ", ".join(map(str, missing[:20])) + (", ..." if len(missing) > 20 else "")
        raise Failure(f"of {of} shards {'one is' if len(missing) == 1 else f'{len(missing)} are'} missing: {named}; "
                      f"{command} --shard {missing[0]}/{of} makes {'it' if len(missing) == 1 else 'the first of them'}")
    merged = Merged(of)
    for number in sorted(found):
        path, about = found[number]
        for name, value in about["entries"].items():
            if name in merged.entries:
                raise UsageError(f"{relative(path)} and {relative(merged.came_from[name])} both have '{short(name)[1:-1]}'")
            merged.entries[name], merged.came_from[name] = value, path
        for key, value in about["head"].items():
            if key in per_shard:
                merged.head.setdefault(key, []).append(value)
            else:
                merged.head[key] = value
    return merged


def safe(digest: str) -> str:
    """A digest that a shard names a file by. Raises UsageError if it could lead elsewhere."""
    if not re.fullmatch(r"[0-9a-f]{1,64}", digest):
        raise UsageError(f"'{digest}' is no file of a shard")
    return digest


def short(value) -> str:
    text = json.dumps(value)
    return text if len(text) <= 80 else text[:77] + "..."


def files_in(paths: list[Path], kind: str) -> list[Path]:
    """The files themselves, and shards of this kind in folders. Raises UsageError."""
    found = []
    for path in paths:
        if path.is_dir():
            inside = sorted(path.glob(f"{kind}.*-of-*.zip"), key=lambda one: [int(n) for n in re.findall(r"\d+", one.name)])
            if not inside:
                raise UsageError(f"{path}: there is no {kind}.K-of-N.zip in it, which ./course ... --shard K/N --out {path} makes")
            found += inside
        elif path.exists():
            found.append(path)
        else:
            raise UsageError(f"{path}: there is no such file or folder")
    return found


def read(path: Path, kind: str) -> dict:
    try:
        with zipfile.ZipFile(path) as archive:
            about = json.loads(archive.read("shard.json"))
        number, of = about["shard"]
        whole = (type(number) is type(of) is int and 1 <= number <= of <= MOST and about["kind"].isprintable()
                 and about["command"].isprintable() and isinstance(about["head"], dict) and isinstance(about["entries"], dict))
    except DAMAGED as error:
        raise UsageError(f"{path}: is not a shard: {error}") from None
    if not whole:
        raise UsageError(f"{path}: is not a shard")
    if about["kind"] != kind:
        raise UsageError(f"{path}: is a shard of {about['kind'][:40]}, expected {kind}")
    return about


def digest(words: list[str]) -> str:
    return hashlib.sha256("\0".join(words).encode(errors="surrogatepass")).hexdigest()[:16]


def course_version() -> str:
    """A hash of the course's sources except for students' files, independent of its folder: it must agree between machines."""
    kinds = (".py", ".cpp", ".h", ".glsl", ".vert", ".frag", ".comp", ".geom", ".json", ".cmake")
    names = [name for name in files() if name.suffix in kinds and name.parts[0] in ("common", "chapters", "shaders", "tests")
             and "golden" not in name.parts and "exercise" not in name.parts]
    return digest([f"{name} {hashlib.sha256((ROOT / name).read_bytes()).hexdigest()}" for name in names])
