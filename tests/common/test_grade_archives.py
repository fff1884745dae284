"""Archives and folders that nobody's computer makes: each is read, or refused in a line, at a bounded cost."""

import gzip
import io
import os
import socket
import struct
import tarfile
import tempfile
import tracemalloc
import unittest
import zipfile
from pathlib import Path

import graded_class
import libarchive
from grading.archives import MOST_MEMBERS, refuse_many_members
from grading.submission import find, read
from test_grade_handins import LAMBERT, RIGHT, WANTED, by_libarchive, zip_of
from tree import Failure

NONE, LARGE, BROKEN = "holds no exercise", "is larger than 256 KiB", "cannot be read: "
READ = ""
MARK = b"PK\x01\x02"


def zip_with(name: str, data: bytes, mode: int = 0o644, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method) as archive:
        info = zipfile.ZipInfo(name)
        info.compress_type, info.external_attr = method, (mode or 0o644) << 16
        archive.writestr(info, data)
    return out.getvalue()


def saying(archive: bytes, size: int) -> bytes:
    """A .zip that gives another size for its one file."""
    data = bytearray(archive)
    for mark, at in ((MARK, 24), (b"PK\x03\x04", 22)):
        data[data.find(mark) + at:data.find(mark) + at + 4] = struct.pack("<I", size)
    return bytes(data)


def tar_of(*members: tuple[str, bytes | None, dict]) -> bytes:
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w") as archive:
        for name, data, fields in members:
            info = tarfile.TarInfo(name)
            info.size = len(data or b"")
            for key, value in fields.items():
                setattr(info, key, value)
            archive.addfile(info, io.BytesIO(data or b""))
    return out.getvalue()


def zip_in_zips(deep: int) -> bytes:
    data = zip_of({LAMBERT: RIGHT})
    for _ in range(deep):
        data = zip_of({"more.zip": data})
    return data


def with_bits(archive: bytes, at: int, bits: int) -> bytes:
    """A .zip with bits set in both headers of its one file; `at` counts in the first."""
    data = bytearray(archive)
    data[at] |= bits
    data[data.find(MARK) + at + 2] |= bits
    return bytes(data)


def overlapping(count: int) -> bytes:
    """A .zip in which so many entries are the same bytes."""
    whole = zip_of({LAMBERT: RIGHT})
    begin, end = whole.find(MARK), whole.find(b"PK\x05\x06")
    entries = whole[begin:end] * count
    return whole[:begin] + entries + struct.pack("<4s4H2LH", b"PK\x05\x06", 0, 0, count, count, len(entries), begin, 0)


def negative_tar() -> bytes:
    head = bytearray(PLAIN_TAR)
    head[124:136] = b"\xff" * 12
    head[148:156] = b" " * 8
    head[148:156] = b"%06o\0 " % sum(head[:512])
    return bytes(head)


def long_link() -> bytes:
    """A tar that begins with a name of 8 GiB."""
    info = tarfile.TarInfo("././@LongLink")
    info.type, info.size = b"L", 8 << 30
    return info.tobuf(tarfile.GNU_FORMAT) + b"a" * 2048


PLAIN_TAR = tar_of((LAMBERT, RIGHT, {}))
LISTED = f"#mtree\n./{LAMBERT} type=file contents=/grade/unpack.py size=100\n".encode()  # which libarchive reads from its own world
# The file's name: its bytes, and how its refusal begins or what is in it.
ARCHIVES = {
    "up.zip": (zip_of({"../../" + LAMBERT: RIGHT}), NONE),
    "root.zip": (zip_of({"/" + LAMBERT: RIGHT}), NONE),
    "up within.zip": (zip_of({"a/../" + LAMBERT: RIGHT}), NONE),
    "drive.zip": (zip_of({"C:\\" + LAMBERT.replace("/", "\\"): RIGHT}), READ),
    "zero in name.zip": (zip_of({LAMBERT: RIGHT}).replace(LAMBERT.encode(), LAMBERT.encode()[:-4] + b"\0lsl"), NONE),
    "link.zip": (zip_with(LAMBERT, b"/etc/passwd", 0o120777), NONE),
    "pipe.zip": (zip_with(LAMBERT, b"", 0o010644), NONE),
    "bzip.zip": (zip_with(LAMBERT, RIGHT, method=zipfile.ZIP_BZIP2), "is packed by method 12"),
    "bomb.zip": (zip_with(LAMBERT, bytes(8 << 20)), LARGE),
    "says 0.zip": (saying(zip_with(LAMBERT, RIGHT), 0), BROKEN),
    "says 4 GB.zip": (saying(zip_with(LAMBERT, RIGHT), 0xfffffff0), READ),
    "changed.zip": (zip_with(LAMBERT, RIGHT, method=0).replace(RIGHT[:8], RIGHT[:7] + b"#", 1), BROKEN),
    "one in one.zip": (zip_in_zips(1), READ),
    "deep.zip": (zip_in_zips(30), NONE),
    "cut.zip": (zip_of({LAMBERT: RIGHT})[:-10], BROKEN),
    "empty.zip": (b"", BROKEN),
    "long way.zip": (zip_of({"a/" * 5000 + LAMBERT: RIGHT}), READ),
    "long name.zip": (zip_of({"a" * 60000: RIGHT, LAMBERT: RIGHT}), READ),
    "program.zip": (b"MZ" * 5000 + zip_of({LAMBERT: RIGHT}), READ),
    "is a tar.zip": (PLAIN_TAR, BROKEN),
    "is a zip.tar": (zip_of({LAMBERT: RIGHT}), READ),
    "hard link.tar": (tar_of((LAMBERT, None, {"type": tarfile.LNKTYPE, "linkname": "/etc/passwd"})), NONE),
    "link.tar": (tar_of((LAMBERT, None, {"type": tarfile.SYMTYPE, "linkname": "/etc/passwd"})), NONE),
    "device.tar": (tar_of((LAMBERT, None, {"type": tarfile.CHRTYPE, "devmajor": 1, "devminor": 5})), NONE),
    "linked folder.tar": (tar_of(("shaders", None, {"type": tarfile.SYMTYPE, "linkname": "/"}), (LAMBERT, RIGHT, {})), READ),
    "bomb.tar.gz": (gzip.compress(tar_of((LAMBERT, bytes(8 << 20), {}))), LARGE),
    "zeros.tar.gz": (gzip.compress(bytes(280 << 20), 1), NONE),
    "two parts.tar.gz": (gzip.compress(PLAIN_TAR[:512]) + gzip.compress(PLAIN_TAR[512:]), READ),
    "in a tar.tar": (tar_of(("more.tar.gz", gzip.compress(PLAIN_TAR), {})), READ),
    "terabyte.tar": (tar_of((LAMBERT, RIGHT, {"pax_headers": {"size": "999999999999"}})), LARGE),
    "late.tar": (tar_of((LAMBERT, RIGHT, {"mtime": 1 << 40})), READ),
    "zeros.7z": (b"7z\xbc\xaf\x27\x1c\0\4" + bytes(24), NONE),
    "encrypted.zip": (with_bits(zip_of({LAMBERT: RIGHT}), 6, 1), "is encrypted"),
    "other name within.zip": (zip_of({LAMBERT: RIGHT}).replace(LAMBERT.encode(), b"../" + LAMBERT.encode()[3:], 1), BROKEN),
    "overlapping.zip": (overlapping(19999), BROKEN if libarchive.ffi.version_number() < 3007000 else READ),
    "list of files.tar": (LISTED, "is not an archive of the kinds"),
    "cpio.tar": (by_libarchive("cpio", None, {LAMBERT: RIGHT}), "is not an archive of the kinds"),
    "negative.tar": (negative_tar(), BROKEN),
    "long link.tar": (long_link(), BROKEN),
    "long path.tar": (tar_of((LAMBERT, RIGHT, {}), (LAMBERT, b"x", {"pax_headers": {"path": "x/" * 300000 + LAMBERT}})), READ),
    "garbage behind.tar.gz": (gzip.compress(PLAIN_TAR) + b"garbage" * 100, READ),
    "cut.7z": (by_libarchive("7zip", None, {LAMBERT: RIGHT})[:-20], BROKEN),
    "noise.rar": (b"Rar!\x1a\7\1\0" + b"\xff" * 64, BROKEN),
}


def said_of(folder: Path) -> dict[str, str]:
    """Of each entry of a class: READ, or why it is refused."""
    found = {}
    for one in find([folder]):
        try:
            found[one.path.name] = READ if read(one, WANTED) == {LAMBERT: RIGHT} else "something else"
        except Failure as failure:
            found[one.path.name] = str(failure)
    return found


@unittest.skipIf(graded_class.why_not(), graded_class.why_not())
class Archives(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_each_is_read_or_refused_in_a_line(self):
        for name, (data, _) in ARCHIVES.items():
            (self.folder / name).write_bytes(data)
        for name, said in said_of(self.folder).items():
            with self.subTest(name):
                expected = ARCHIVES[name][1]
                self.assertEqual((expected in said, bool(said)), (True, bool(expected)), said)
                self.assertTrue(said.isprintable() and len(said) < 300, said)

    def test_folders(self):
        def inside(student: str) -> Path:
            place = self.folder / student / LAMBERT
            place.parent.mkdir(parents=True)
            return place
        inside("folder").mkdir()
        inside("link").symlink_to("/etc/passwd")
        inside("itself").symlink_to("lambert.glsl")
        os.mkfifo(inside("pipe"))
        with socket.socket(socket.AF_UNIX) as one:
            self.addCleanup(os.chdir, os.getcwd())
            os.chdir(inside("socket").parent)  # its path may be longer than a socket's name
            one.bind("lambert.glsl")
        (self.folder / "linked tree").mkdir()
        (self.folder / "linked tree" / "shaders").symlink_to(graded_class.REAL / "shaders")
        (self.folder / "round").mkdir()
        (self.folder / "round" / "a").symlink_to(".")
        (self.folder.joinpath("deep", *["d" * 20] * 120)).mkdir(parents=True)
        said = said_of(self.folder)
        for student, words in {"folder": "is not a regular file", "link": "is a link", "itself": NONE, "pipe": "is not a regular file",
                               "socket": LAMBERT, "linked tree": "is a link", "round": NONE, "deep": NONE}.items():
            self.assertIn(words, said[student], student)
            self.assertNotEqual(said[student], READ, student)

    def test_archives_within_one_are_on_the_disk(self):
        (self.folder / "ann").mkdir()
        for number in range(20):
            (self.folder / "ann" / f"{number}.zip").write_bytes(bytes(8 << 20))
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        self.assertIn(BROKEN, said_of(self.folder)["ann"])
        self.assertLess(tracemalloc.get_traced_memory()[1], 110 << 20)  # one may have 64 MiB

    def test_members_are_counted_wherever_they_lie(self):
        for before in range((1 << 20) - 4, (1 << 20) + 1):
            refuse_many_members(io.BytesIO(bytes(before) + MARK * MOST_MEMBERS))
            with self.assertRaisesRegex(Failure, "more than 20000 files"):
                refuse_many_members(io.BytesIO(bytes(before) + MARK * (MOST_MEMBERS + 1)))


if __name__ == "__main__":
    unittest.main()
