"""Reads archives that nobody trusts: in a sandbox, by libarchive (unpack.py).

members() gives (name, a function that reads at most so many bytes) of each ordinary file that may matter, in its order.
"""

import io
import json
import os
import signal
import stat
import tempfile
from pathlib import Path

from grading import sandbox
from tree import Failure

ENDINGS = (".zip", ".7z", ".rar", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".txz", ".tar.bz2", ".tbz2", ".tar.zst", ".tzst")
MOST_ARCHIVE_BYTES = 64 << 20
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


def members(file, limits: dict[str, int]):
    """`limits`: how many bytes a file of this name, or of this ending, may have."""
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
                why = "it takes too long" if done.late else "it unpacks to too much" if done.code == 128 + signal.SIGXFSZ else \
                    "it takes too much memory" if done.code else "it is cut off"
                raise Failure(f"cannot be read: {why}") from None
            if "end" in head:
                if head["end"]:
                    raise Failure(head["end"])
                return
            size = head["bytes"]
            data = io.BytesIO(out.read(size)) if size >= 0 else None
            yield head["name"], lambda most, data=data: bytes(most) if data is None else data.getvalue()[:most]
