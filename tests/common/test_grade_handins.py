"""How learning platforms and students hand in: each entry of a class is read, or is a row that says why it is not."""

import datetime
import io
import os
import struct
import tarfile
import tempfile
import time
import unittest
import zipfile
import zlib
from pathlib import Path

import graded_class
from graded_class import OF, PLACES, right
from check.glsl_answer import Refused, plain
from grading.alike import added, runs_of
from grading.gradebook import page_names
from grading.rules import Rules
from grading.roster import Roster
from grading.submission import find, read, time_of
from tree import Failure

LAMBERT = PLACES["02.lambert"]
RIGHT = right("02.lambert").encode()
WANTED = {place: None for place in PLACES.values()}


def zip_of(members: dict[str, bytes]) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in members.items():
            archive.writestr(name, data)
    return out.getvalue()


def by_libarchive(kind: str, packing: str | None, members: dict[str, bytes]) -> bytes:
    import libarchive
    with tempfile.NamedTemporaryFile() as file:
        with libarchive.file_writer(file.name, kind, packing) as archive:
            for name, data in members.items():
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


def sparse_tar(name: str, whole: int) -> bytes:
    """An old GNU sparse member of a few bytes that says it is `whole` bytes long."""
    info = tarfile.TarInfo(name)
    info.size = 512
    head = bytearray(info.tobuf(tarfile.GNU_FORMAT))
    head[156:157] = b"S"
    head[386:410] = b"%011o\0%011o\0" % (whole - 512, 512)
    head[483:495] = b"%011o\0" % whole
    head[148:156] = b" " * 8
    head[148:156] = b"%06o\0 " % sum(head)
    return bytes(head) + b"x" * 512 + bytes(1024)


@unittest.skipIf(graded_class.why_not(), graded_class.why_not())
class HandIns(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        at = cls.at = Path(made.name)
        course = {f"course/{LAMBERT}": RIGHT}

        def put(name: str, data: bytes):
            (at / name).parent.mkdir(parents=True, exist_ok=True)
            (at / name).write_bytes(data)
        put("Ann Example_1001_assignsubmission_file_/work.zip", zip_of(course))
        put("Bea Example_1002_assignsubmission_file_/work.7z", by_libarchive("7zip", None, course))
        put("Cid Example_1003_assignsubmission_file_/lambert.glsl", RIGHT)
        put("Dot Example_1004_assignsubmission_file_/my files/deep/course/" + LAMBERT, RIGHT)
        put("Eve Example_1005_assignsubmission_onlinetext_/onlinetext.html", b"<p>see the zip")
        put("seven.7z", by_libarchive("7zip", None, course))
        put("zst.tar.zst", by_libarchive("gnutar", "zstd", course))
        put("rar.rar", rar_of(f"course/{LAMBERT}", RIGHT))
        put("BEN.ZIP", zip_of(course))
        put("windows.zip", zip_of({f"course/{LAMBERT}".replace("/", "\\"): RIGHT}))
        put("in itself.zip", zip_of({"work.zip": zip_of(course)}))
        put("alone.zip", zip_of({"lambert.glsl": RIGHT}))
        put("exampleann_4711_987654_lambert.glsl", RIGHT)
        put("lambert.glsl", RIGHT)
        put("essay.docx", b"PK")
        put("sparse.tar", sparse_tar(f"course/{LAMBERT}", 4 << 30))
        put("chapters/" + LAMBERT, RIGHT)
        put("thrice.zip", zip_of({"a.zip": zip_of({"b.zip": zip_of(course)})}))

    def test_every_entry_is_a_row(self):
        self.assertEqual({one.path.name for one in find([self.at])}, {one.name for one in os.scandir(self.at)})

    def test_what_can_be_read_is_read(self):
        rows = {one.path.name: one for one in find([self.at])}
        for name in ("Ann Example_1001_assignsubmission_file_", "Bea Example_1002_assignsubmission_file_",
                     "Cid Example_1003_assignsubmission_file_", "Dot Example_1004_assignsubmission_file_", "seven.7z", "zst.tar.zst",
                     "rar.rar", "BEN.ZIP", "windows.zip", "in itself.zip", "alone.zip", "exampleann_4711_987654_lambert.glsl",
                     "lambert.glsl", "chapters"):
            with self.subTest(name):
                self.assertEqual(read(rows[name], set(WANTED)), {LAMBERT: RIGHT})
        self.assertEqual(rows["BEN.ZIP"].student, "BEN")

    def test_of_two_courses_the_outermost_is_read_and_a_row_says_so(self):
        starter = {LAMBERT: (graded_class.REAL / LAMBERT).read_bytes()}
        other = RIGHT + b"// another\n"

        def read_of(members: dict[str, bytes]):
            with tempfile.NamedTemporaryFile(suffix=".zip") as file:
                file.write(zip_of(members))
                file.flush()
                notes = []
                return read(find([Path(file.name)])[0], set(WANTED), starter, notes), notes

        for members, right_one, words in (
                ({f"a/old/{LAMBERT}": other, f"work/{LAMBERT}": RIGHT}, RIGHT, "work/ was judged, a/old/ was not"),
                ({f"z/z/{LAMBERT}": other, LAMBERT: RIGHT}, RIGHT, "the outermost was judged, z/z/ was not"),
                ({f"a/{LAMBERT}": starter[LAMBERT], f"b/c/{LAMBERT}": RIGHT}, RIGHT, ""),
                ({f"course/{LAMBERT}": starter[LAMBERT], "lambert.glsl": RIGHT}, RIGHT, "in its place lies the starter"),
                ({f"__MACOSX/course/{LAMBERT}": other, f"course/{LAMBERT}": RIGHT}, RIGHT, ""),
                ({"__MACOSX/._lambert.glsl": other, "lambert.glsl": RIGHT}, RIGHT, ""),
                ({f"1/2/3/4/5/6/7/{LAMBERT}": RIGHT}, RIGHT, "")):
            with self.subTest(str(list(members))):
                found, notes = read_of(members)
                self.assertEqual(found, {LAMBERT: right_one})
                self.assertIn(words, "; ".join(notes))
                self.assertEqual(bool(words), bool(notes))
        with self.assertRaisesRegex(Failure, "course_backup/ and old/, and which is meant is open"):
            read_of({f"old/{LAMBERT}": other, f"course_backup/{LAMBERT}": RIGHT})
        folder = Path(self.enterContext(tempfile.TemporaryDirectory())) / "ann"
        for name, data in ((f"1/2/3/4/5/6/7/{LAMBERT}", RIGHT), (f"__MACOSX/{LAMBERT}", other)):
            (folder / name).parent.mkdir(parents=True)
            (folder / name).write_bytes(data)
        self.assertEqual(read(find([folder.parent])[0], set(WANTED)), {LAMBERT: RIGHT})

    def test_form_feeds_are_white_space(self):
        self.assertEqual(plain(b"a\f\x0bb", graded_class.REAL / LAMBERT), "a  b")

    def test_what_cannot_be_read_says_why(self):
        rows = {one.path.name: one for one in find([self.at])}
        for name, words in (("Eve Example_1005_assignsubmission_onlinetext_", "holds no exercise"), ("essay.docx", "neither a folder nor"),
                            ("sparse.tar", "larger than 256 KiB"), ("thrice.zip", "holds no exercise")):
            with self.subTest(name), self.assertRaisesRegex(Failure, words):
                read(rows[name], set(WANTED))


class Names(unittest.TestCase):
    def test_a_page_for_each_whatever_they_are_called(self):
        students = ["\u6f22" * 84, "\u6f22" * 85, "ann", "ann", "Ann", "\u202eann", "x" * 300, ".", ""]
        names = page_names([{"student": name, "id": ""} for name in students])
        self.assertEqual(len({name.casefold() for name in names}), len(students), names)
        self.assertEqual(names[2], "ann")
        with tempfile.TemporaryDirectory() as folder:
            for name in names:
                (Path(folder) / f".{name}.html.1234567.7f0000000000").touch()

    def test_a_time_that_no_calendar_has(self):
        rules = Rules(None, dict(list(OF.items())[:3]))
        for seconds in (4e11, -1e18, 1e300):
            rules.handed_in("ann", seconds)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "ann.zip"
            file.touch()
            os.utime(file, (253402300800 + 86400 * 400, 253402300800 + 86400 * 400))
            rules.handed_in("ann", time_of(file, []))  # a file system may have cut it

    def test_the_platforms_time_counts(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "class.csv"
            file.write_text('Identifier,Full name,Last modified (submission)\nParticipant 1001,Ann,"Thursday, 14 January 2027, 11:58 PM"\n')
            student = "Ann_1001_assignsubmission_file_"
            at = Roster(file, [student]).handed_in_s(student)
        self.assertEqual(datetime.datetime.fromtimestamp(at), datetime.datetime(2027, 1, 14, 23, 58))


class Readers(unittest.TestCase):
    def test_a_megabyte_of_anything_is_read_in_a_second(self):
        for data in (b"\n", b"\r", b'"\\"', b"/*/", b"\\\n", b"# ", b"#define a\n", b" ", b"set= ", b'#include "', b"\t\n", b"{", b'"', b"a",
                     b"1.", b"// \n", b"\\", b"('"):
            text = data * ((1 << 20) // len(data))
            start_s = time.process_time()
            try:
                plain(text, graded_class.REAL / LAMBERT)
            except Refused:
                pass
            runs_of(text)
            added(text, b"")
            self.assertLess(time.process_time() - start_s, 5, data)  # 0.5 s; two minutes where it grows as the square


if __name__ == "__main__":
    unittest.main()
