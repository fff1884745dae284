"""How learning platforms and students hand in, and archives that nobody's computer makes: each entry of a class is read, or is
a row that says why it is not, at a bounded cost."""
# Builds: nothing

import gzip
import io
import lzma
import os
import socket
import struct
import tarfile
import tempfile
import tracemalloc
import unittest
import zipfile
import zlib
from pathlib import Path

import graded_class
import libarchive
from folder_case import FolderCase
from graded_class import PLACES, right
from grading.submission import find, read
from tree import Failure

LAMBERT = PLACES["02.lambert"]
RIGHT = right("02.lambert").encode()
STARTER = (graded_class.REAL / LAMBERT).read_bytes()
WANTED = set(PLACES.values())
COURSE = {f"course/{LAMBERT}": RIGHT}
READ, NONE, LARGE, BROKEN = "", "holds no exercise", "is larger than 256 KiB", "cannot be read: "
OTHER_KIND = "is not an archive of the kinds"


def zip_of(members: dict[str, bytes], method: int = zipfile.ZIP_DEFLATED, mode: int = 0o644) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method) as archive:
        for name, data in members.items():
            info = zipfile.ZipInfo(name)
            info.compress_type, info.external_attr = method, mode << 16
            archive.writestr(info, data)
    return out.getvalue()


def tar_of(name: str = LAMBERT, data: bytes = RIGHT, **fields) -> bytes:
    info = tarfile.TarInfo(name)
    info.size = len(data)
    for key, value in fields.items():
        setattr(info, key, value)
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w") as archive:
        archive.addfile(info, io.BytesIO(data))
    return out.getvalue()


def by_libarchive(kind: str, packing: str | None = None) -> bytes:
    with tempfile.NamedTemporaryFile() as file:
        with libarchive.file_writer(file.name, kind, packing) as archive:
            for name, data in COURSE.items():
                archive.add_file_from_memory(name, len(data), data)
        return Path(file.name).read_bytes()


def rar_of(name: str, data: bytes) -> bytes:
    """RAR 4, stored: the technical note of unrar, by hand."""
    def block(body: bytes) -> bytes:
        return struct.pack("<H", zlib.crc32(body) & 0xffff) + body
    head = block(struct.pack("<BHH6x", 0x73, 0, 13))
    words = struct.pack("<BHHIIBIIBBHI", 0x74, 0x8000, 32 + len(name), len(data), len(data), 3, zlib.crc32(data), 0x21 << 16, 20, 0x30,
                        len(name), 0o100644) + name.encode()
    return b"Rar!\x1a\x07\x00" + head + block(words) + data + block(struct.pack("<BHH", 0x7b, 0x4000, 7))


def changed_tar(archive: bytes, **fields: bytes) -> bytes:
    """A tar with bytes put into its first header, whose sum is right."""
    head = bytearray(archive)
    for at, value in ((int(name[1:]), value) for name, value in fields.items()):
        head[at:at + len(value)] = value
    head[148:156] = b" " * 8
    head[148:156] = b"%06o\0 " % sum(head[:512])
    return bytes(head)


def saying(archive: bytes, first: int, second: int, data: bytes) -> bytes:
    """A .zip with bytes put into both headers of its one file."""
    out = bytearray(archive)
    for mark, at in ((b"PK\x03\x04", first), (b"PK\x01\x02", second)):
        out[out.find(mark) + at:out.find(mark) + at + len(data)] = data
    return bytes(out)


def overlapping(count: int) -> bytes:
    """A .zip in which so many entries are the same bytes."""
    whole = zip_of({LAMBERT: RIGHT})
    begin, end = whole.find(b"PK\x01\x02"), whole.find(b"PK\x05\x06")
    entries = whole[begin:end] * count
    return whole[:begin] + entries + struct.pack("<4s4H2LH", b"PK\x05\x06", 0, 0, count, count, len(entries), begin, 0)


def long_link() -> bytes:
    """A tar that begins with a name of 8 GiB."""
    info = tarfile.TarInfo("././@LongLink")
    info.type, info.size = b"L", 8 << 30
    return info.tobuf(tarfile.GNU_FORMAT) + b"a" * 2048


def sparse_tar(whole: int) -> bytes:
    """An old GNU sparse member of a few bytes that says it is `whole` bytes long."""
    info = tarfile.TarInfo(LAMBERT)
    info.size = 512
    return changed_tar(info.tobuf(tarfile.GNU_FORMAT), _156=b"S", _386=b"%011o\0%011o\0" % (whole - 512, 512), _483=b"%011o\0" % whole) + \
        b"x" * 512 + bytes(1024)


def xz_of_large_dictionary() -> bytes:
    """An xz header that asks for a dictionary of 1.5 GiB, which takes a decoder as much memory."""
    flags, block = b"\x00\x01", b"\x02\x00\x21\x01\x25\x00\x00\x00"
    return b"\xfd7zXZ\x00" + flags + struct.pack("<I", zlib.crc32(flags)) + block + struct.pack("<I", zlib.crc32(block)) + b"\x01\x00\x00x\x00\x00\x00\x00"


PLAIN, TAR = zip_of({LAMBERT: RIGHT}), tar_of()
IN_ZIPS = PLAIN
for _ in range(30):
    IN_ZIPS = zip_of({"more.zip": IN_ZIPS})
MOODLE = "_assignsubmission_file_"
# By its path in the class: its bytes, and how its refusal begins or what is in it.
ENTRIES = {
    # As platforms and people hand in.
    f"Ann_1001{MOODLE}/work.zip": (zip_of(COURSE), READ), f"Bea_1002{MOODLE}/work.7z": (by_libarchive("7zip"), READ),
    f"Cid_1003{MOODLE}/lambert.glsl": (RIGHT, READ), f"Dot_1004{MOODLE}/my files/deep/course/{LAMBERT}": (RIGHT, READ),
    "Eve_1005_assignsubmission_onlinetext_/onlinetext.html": (b"<p>see the zip", NONE),
    "bom.glsl_is_in/lambert.glsl": (b"\xef\xbb\xbf" + RIGHT, READ),
    "exampleann_4711_987654_lambert.glsl": (RIGHT, READ), "lambert.glsl": (RIGHT, READ), "chapters/" + LAMBERT: (RIGHT, READ),
    "essay.docx": (b"PK", "is neither a folder nor an archive"), "large/lambert.glsl": (RIGHT + b"//" + bytes(1 << 19), LARGE),
    "BEN.ZIP": (zip_of(COURSE), READ), "stored.zip": (zip_of(COURSE, zipfile.ZIP_STORED), READ), "alone.zip": (zip_of({"lambert.glsl": RIGHT}), READ),
    "windows.zip": (zip_of({LAMBERT.replace("/", "\\"): RIGHT}), READ), "drive.zip": (zip_of({"C:\\" + LAMBERT.replace("/", "\\"): RIGHT}), READ),
    "by bzip2.zip": (zip_of(COURSE, zipfile.ZIP_BZIP2), READ), "program.zip": (b"MZ" * 5000 + PLAIN, READ),
    "one in one.zip": (zip_of({"work.zip": zip_of(COURSE)}), READ), "in a tar.tar": (tar_of("more.tar.gz", gzip.compress(TAR)), READ),
    "gz.tar.gz": (gzip.compress(TAR), READ), "xz.tar.xz": (lzma.compress(TAR), READ), "zst.tar.zst": (by_libarchive("gnutar", "zstd"), READ),
    "bz.tar.bz2": (by_libarchive("gnutar", "bzip2"), READ), "rar.rar": (rar_of(f"course/{LAMBERT}", RIGHT), READ),
    "is a zip.tar": (PLAIN, READ), "is a tar.zip": (TAR, READ), "late.tar": (tar_of(mtime=1 << 40), READ),
    "not utf8.tar": (tar_of("\udcff\udcfe/" + LAMBERT), READ),
    # Ways that lead elsewhere.
    "up.zip": (zip_of({"../../" + LAMBERT: RIGHT}), NONE), "root.zip": (zip_of({"/" + LAMBERT: RIGHT}), NONE),
    "up within.zip": (zip_of({"a/../" + LAMBERT: RIGHT}), NONE),
    "zero in name.zip": (PLAIN.replace(LAMBERT.encode(), LAMBERT.encode()[:-4] + b"\0lsl"), NONE),
    "link.zip": (zip_of({LAMBERT: b"/etc/passwd"}, mode=0o120777), NONE),
    "hard link.tar": (tar_of(data=b"", type=tarfile.LNKTYPE, linkname="/etc/passwd"), NONE),
    "link.tar": (tar_of(data=b"", type=tarfile.SYMTYPE, linkname="/etc/passwd"), NONE),
    "device.tar": (tar_of(data=b"", type=tarfile.CHRTYPE, devmajor=1, devminor=5), NONE),
    "list of files.tar": (f"#mtree\n./{LAMBERT} type=file contents=/grade/unpack.py size=100\n".encode(), OTHER_KIND),
    "cpio.tar": (by_libarchive("cpio"), OTHER_KIND),
    # Too much.
    "bomb.zip": (zip_of({LAMBERT: bytes(8 << 20)}), LARGE), "bomb.tar.gz": (gzip.compress(tar_of(data=bytes(8 << 20))), LARGE),
    "zeros.tar.gz": (gzip.compress(bytes(280 << 20), 1), NONE),
    "again and again.zip": (zip_of({f"{i}/{LAMBERT}": bytes(1 << 18) for i in range(1100)}), BROKEN),
    "many.zip": (zip_of({f"{i}": b"" for i in range(20001)}), "holds more than 20000 files"),
    "deep.zip": (IN_ZIPS, NONE), "sparse.tar": (sparse_tar(4 << 30), LARGE), "terabyte.tar": (tar_of(pax_headers={"size": "999999999999"}), LARGE),
    "greedy.tar.xz": (xz_of_large_dictionary(), BROKEN), "says 4 GB.zip": (saying(PLAIN, 22, 24, struct.pack("<I", 0xfffffff0)), LARGE),
    "overlapping.zip": (overlapping(19999), READ), "long way.zip": (zip_of({"a/" * 5000 + LAMBERT: RIGHT}), READ),
    "long name.zip": (zip_of({"a" * 60000: RIGHT, LAMBERT: RIGHT}), READ), "long link.tar": (long_link(), BROKEN),
    "long path.tar": (TAR[:-1024] + tar_of(data=b"x", pax_headers={"path": "x/" * 300000 + LAMBERT}), READ),
    # Damaged.
    "says 0.zip": (saying(PLAIN, 22, 24, bytes(4)), BROKEN), "changed.zip": (zip_of({LAMBERT: RIGHT}, 0).replace(RIGHT[:8], RIGHT[:7] + b"#", 1), BROKEN),
    "encrypted.zip": (saying(PLAIN, 6, 8, b"\1"), BROKEN), "cut.zip": (PLAIN[:len(PLAIN) // 2], BROKEN), "empty.zip": (b"", NONE),
    "no.zip": (b"PK but no zip", BROKEN), "zeros.7z": (b"7z\xbc\xaf\x27\x1c\0\4" + bytes(24), NONE),
    "cut.7z": (by_libarchive("7zip")[:-20], BROKEN), "noise.rar": (b"Rar!\x1a\7\1\0" + b"\xff" * 64, BROKEN),
    "negative.tar": (changed_tar(TAR, _124=b"\xff" * 12), BROKEN), "cut.tar.xz": (lzma.compress(TAR)[:-40], BROKEN),
    "garbage behind.tar.gz": (gzip.compress(TAR) + b"garbage" * 100, READ),
    "two parts.tar.gz": (gzip.compress(TAR[:512]) + gzip.compress(TAR[512:]), READ),
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
class HandIns(FolderCase):
    def test_each_is_read_or_refused_in_a_line(self):
        for name, (data, _) in ENTRIES.items():
            self.write(name, data)
        expected = {name.partition("/")[0]: words for name, (_, words) in ENTRIES.items()}
        found = said_of(self.folder)
        self.assertEqual(set(found), set(expected))
        for name, said in found.items():
            with self.subTest(name):
                self.assertTrue(said == READ if expected[name] == READ else expected[name] in said, said)
                self.assertTrue(said.isprintable() and len(said) < 300, said)

    def test_folders_in_which_nothing_is_followed(self):
        def inside(student: str) -> Path:
            place = self.folder / student / LAMBERT
            place.parent.mkdir(parents=True)
            return place
        inside("folder").mkdir()
        inside("link").symlink_to("/etc/passwd")
        inside("itself").symlink_to("lambert.glsl")
        os.mkfifo(inside("pipe"))
        os.mkfifo(self.folder / "fifo.zip")
        with socket.socket(socket.AF_UNIX) as one:
            self.addCleanup(os.chdir, os.getcwd())
            os.chdir(inside("socket").parent)  # its path may be longer than a socket's name
            one.bind("lambert.glsl")
        for student, name, to in (("linked tree", "shaders", graded_class.REAL / "shaders"), ("round", "a", ".")):
            (self.folder / student).mkdir()
            (self.folder / student / name).symlink_to(to)
        (self.folder / "linked").symlink_to(self.folder / "deep")
        (self.folder.joinpath("deep", *["d" * 20] * 120)).mkdir(parents=True)
        said = said_of(self.folder)
        for student, words in {"folder": "is not a regular file", "link": "is a link", "itself": NONE, "pipe": "is not a regular file",
                               "fifo.zip": "is not a regular file", "socket": LAMBERT, "linked tree": "is a link", "round": NONE, "deep": NONE,
                               "linked": "is a link, which is not followed"}.items():
            self.assertIn(words, said[student], student)
            self.assertNotEqual(said[student], READ, student)

    def test_archives_within_one_are_on_the_disk(self):
        for number in range(20):
            self.write(f"ann/{number}.zip", b"PK" * (4 << 20))
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        self.assertIn(BROKEN, said_of(self.folder)["ann"])
        self.assertLess(tracemalloc.get_traced_memory()[1], 110 << 20)  # one may have 64 MiB

    def test_of_two_courses_the_outermost_is_read_and_a_row_says_so(self):
        other = RIGHT + b"// another\n"

        def read_of(members: dict[str, bytes]):
            notes = []
            return read(find([self.write("one.zip", zip_of(members))])[0], WANTED, {LAMBERT: STARTER}, notes), "; ".join(notes)
        for members, words in (({f"a/old/{LAMBERT}": other, f"work/{LAMBERT}": RIGHT}, "work/ was judged, a/old/ was not"),
                               ({f"z/z/{LAMBERT}": other, LAMBERT: RIGHT}, "the outermost was judged, z/z/ was not"),
                               ({f"a/{LAMBERT}": STARTER, f"b/c/{LAMBERT}": RIGHT}, ""),
                               ({f"course/{LAMBERT}": STARTER, "lambert.glsl": RIGHT}, "in its place lies the starter"),
                               ({f"course/{LAMBERT}": RIGHT, "lambert.glsl": other}, "lies there twice: the one in its place was judged"),
                               ({"a/old/lambert.glsl": other, "z/lambert.glsl": RIGHT}, "z/ was judged, a/old/ was not"),
                               ({"a/lambert.glsl": RIGHT, "b/lambert.glsl": STARTER}, ""),
                               ({"z.zip": zip_of({LAMBERT: STARTER}), "a.zip": zip_of({LAMBERT: RIGHT})}, ""),
                               ({"old/a.zip": zip_of({LAMBERT: other}), "z.zip": zip_of({"lambert.glsl": RIGHT})}, "z.zip was judged, old/a.zip was not"),
                               ({f"__MACOSX/course/{LAMBERT}": other, f"course/{LAMBERT}": RIGHT}, ""),
                               ({"__MACOSX/._lambert.glsl": other, "lambert.glsl": RIGHT}, ""),
                               ({f"1/2/3/4/5/6/7/{LAMBERT}": RIGHT}, "")):
            with self.subTest(str(list(members))):
                found, notes = read_of(members)
                self.assertEqual((found, bool(notes)), ({LAMBERT: RIGHT}, bool(words)))
                self.assertIn(words, notes)
        for members, words in (({f"old/{LAMBERT}": other, f"course_backup/{LAMBERT}": RIGHT}, "course_backup/ and old/"),
                               ({"b/lambert.glsl": other, "a/lambert.glsl": RIGHT}, "a/ and b/"),
                               ({"work.zip": zip_of({LAMBERT: RIGHT}), "old.zip": zip_of({LAMBERT: other})}, "old.zip and work.zip")):
            with self.assertRaisesRegex(Failure, f"{words}, and which is meant is open"):
                read_of(members)
        (self.folder / "one.zip").unlink()
        for name, data in ((f"ann/1/2/3/4/5/6/7/{LAMBERT}", RIGHT), (f"ann/__MACOSX/{LAMBERT}", other)):
            self.write(name, data)
        self.assertEqual(said_of(self.folder), {"ann": READ})
