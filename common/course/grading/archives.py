"""Reads archives that nobody trusts: a .zip here, any other in a sandbox, by libarchive (unpack.py).

members() gives (name, a function that reads at most so many bytes) of each ordinary file that may matter, in its order.
"""

import io
import json
import os
import stat
import tempfile
import zipfile
from pathlib import Path

from grading import sandbox
from tree import Failure

ENDINGS = (".zip", ".7z", ".rar", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".txz", ".tar.bz2", ".tbz2", ".tar.zst", ".tzst")
MOST_ARCHIVE_BYTES = 64 << 20
MOST_UNPACKED_BYTES = 256 << 20
MOST_MEMBERS = 20000
UNPACKING = sandbox.Limits(1 << 29, 20)


def is_archive(name: str) -> bool:
    return name.lower().endswith(ENDINGS)


def open_regular(path: Path):
    """An archive's file. Raises Failure for a link, a pipe, one that is too large."""
    handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    file = os.fdopen(handle, "rb")
    status = os.fstat(handle)
    if not stat.S_ISREG(status.st_mode):
        file.close()
        raise Failure("is not a regular file")
    if status.st_size > MOST_ARCHIVE_BYTES:
        file.close()
        raise Failure(f"is larger than {MOST_ARCHIVE_BYTES >> 20} MiB")
    return file


def members(file, name: str, limits: dict[str, int], say):
    """`limits`: how many bytes a file of this name may have; `say`: makes a name printable."""
    if name.lower().endswith(".zip"):
        yield from zipped(file, say)
    else:
        yield from unpacked(file, limits)


def zipped(file, say):
    refuse_many_members(file)
    with zipfile.ZipFile(file) as archive:
        left = [MOST_UNPACKED_BYTES]
        for info in archive.infolist():
            kind = stat.S_IFMT(info.external_attr >> 16)
            if not info.is_dir() and kind in (0, stat.S_IFREG):
                # Written by a program that takes its own separators for everybody's.
                yield info.filename.replace("\\", "/"), lambda most, info=info: start(archive, info, most, left, say)


def start(archive, info, most: int, left: list[int], say) -> bytes:
    """`left`: how many bytes the members of this archive may still be unpacked to."""
    # The other methods unpack as much at once as the archive says, regardless of the requested size.
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise Failure(f"{say(info.filename)} is packed by method {info.compress_type}; a .zip is stored or deflated here")
    if info.flag_bits & 1:
        raise Failure(f"{say(info.filename)} is encrypted")
    with archive.open(info) as stream:
        data = stream.read(most)
    left[0] -= len(data)
    if left[0] < 0:
        raise Failure(f"unpacks to more than {MOST_UNPACKED_BYTES >> 20} MiB")
    return data


def refuse_many_members(file):
    """Before a list of them is made, which can be a thousand times their headers' size. A part at a time: Python 3.11's
    mmap.find() reads beyond the end of a file that fills its last page, and dies."""
    count, before = 0, b""
    file.seek(0)
    while got := file.read(1 << 20):
        count += (before + got).count(b"PK\x01\x02")
        before = got[-3:]
        if count > MOST_MEMBERS:
            raise Failure(f"holds more than {MOST_MEMBERS} files")
    file.seek(0)


def unpacked(file, limits: dict[str, int]):
    mounts = sandbox.Mounts()
    mounts.read(Path(__file__).with_name("unpack.py"), Path("/grade/unpack.py"))
    with tempfile.TemporaryFile() as out:
        words = ["/usr/bin/python3", "-I", "/grade/unpack.py", file.fileno(), out.fileno(), json.dumps(limits)]
        # Else libarchive's Python looks for it by starting a process.
        library = next((str(one) for one in sorted(Path("/usr/lib").glob("*/libarchive.so.*"))), "libarchive.so.13")
        running = sandbox.Running(words, mounts, UNPACKING, {"LIBARCHIVE": library}, pass_fds=(file.fileno(), out.fileno()))
        done = running.finish()
        out.seek(0)
        while True:
            line = out.readline(1 << 16)
            try:
                head = json.loads(line)
            except ValueError:
                why = "it takes too long" if done.late else "it takes too much memory" if done.code else "it is cut off"
                raise Failure(f"cannot be read: {why}") from None
            if "end" in head:
                if head["end"]:
                    raise Failure(head["end"])
                return
            size = head["bytes"]
            data = io.BytesIO(out.read(size)) if size >= 0 else None
            yield head["name"], lambda most, data=data: bytes(most) if data is None else data.getvalue()[:most]
