"""Reads the exercises out of an archive of any kind, inside of a sandbox: unpack.py FD OUT_FD WANTED, which is JSON: how many bytes
a file of such a name, or of such an ending, may have.

Writes, for each of those, a line of JSON {"name", "bytes"} and its bytes (-1: it has more); at the end {"end": ""}, or the
fault. The archive is not trusted: memory and time are the sandbox's to limit, and a member's size is looked at before its bytes.
"""

import ctypes
import json
import os
import sys

import libarchive
from libarchive import ffi

unpacked_bytes = ffi.libarchive.archive_filter_bytes
unpacked_bytes.argtypes, unpacked_bytes.restype = [ctypes.c_void_p, ctypes.c_int], ctypes.c_int64
format_of = ffi.libarchive.archive_format
format_of.argtypes, format_of.restype = [ctypes.c_void_p], ctypes.c_int

FORMATS = {0x30000: "tar", 0x50000: "zip", 0xD0000: "rar", 0xE0000: "7z", 0x100000: "rar 5"}  # archive.h; a list of files (mtree) is none
FORMAT_MASK, MOST_NAME = 0xFF0000, 1 << 15
MOST_MEMBERS = 20000
MOST_UNPACKED_BYTES = 256 << 20


def main(archive_fd: int, out_fd: int, wanted: dict[str, int]):
    endings = {name: most for name, most in wanted.items() if name.startswith(".")}
    with os.fdopen(out_fd, "wb") as out:
        def tell(head: dict, data: bytes = b""):
            out.write(json.dumps(head).encode() + b"\n" + data)
        try:
            with libarchive.fd_reader(archive_fd) as archive:
                tell({"end": walk(archive, wanted, endings, tell)})
        except Exception as error:
            tell({"end": words_of(error)})


def words_of(error: Exception) -> str:
    return "cannot be read: " + (str(error).partition(" (errno=")[0] or type(error).__name__)


def walk(archive, wanted: dict[str, int], endings: dict[str, int], tell) -> str:
    """Reports each wanted file. Returns the fault; empty for none."""
    more = f"unpacks to more than {MOST_UNPACKED_BYTES >> 20} MiB"
    try:
        for number, entry in enumerate(archive):
            if number >= MOST_MEMBERS:
                return f"holds more than {MOST_MEMBERS} files"
            if unpacked_bytes(archive._pointer, 0) > MOST_UNPACKED_BYTES:
                return more
            if format_of(archive._pointer) & FORMAT_MASK not in FORMATS:
                return f"is not an archive of the kinds {', '.join(FORMATS.values())}"
            name = entry.pathname or ""
            name = (os.fsdecode(name) if isinstance(name, bytes) else name).replace("\\", "/")
            last = name.rpartition("/")[2]
            most = wanted.get(last) or next((most for end, most in endings.items() if last.lower().endswith(end)), 0)
            if most and len(name) < MOST_NAME and entry.isreg and not entry.islnk:
                data = b"".join(entry.get_blocks(1 << 16)) if entry.size <= most else None
                if data is not None and len(data) != entry.size:  # a sum is wrong, of which libarchive only warns
                    return f"cannot be read: {last} is damaged"
                tell({"name": name, "bytes": -1 if data is None else len(data)}, data or b"")
    except libarchive.ArchiveError as error:
        return more if unpacked_bytes(archive._pointer, 0) > MOST_UNPACKED_BYTES else words_of(error)
    return ""


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), json.loads(sys.argv[3]))
