"""Tests of ./course grade: the parts of a submission that are read, and the feedback."""

import bz2
import csv
import io
import json
import lzma
import os
import struct
import tarfile
import threading
import unittest
import zipfile
import zlib
from pathlib import Path
from unittest import mock

from graded_class import CHAPTERS, PLACES, REAL, Class, right
from grading.grade import grade, table, write_files
from grading.judge import Judge, same_text
from grading.submission import cell, find

LAMBERT, FADE = PLACES["02.lambert"], PLACES["03.range_fade"]
RIGHT = right("02.lambert").encode()
OPEN = (REAL / LAMBERT).read_bytes()


def zipped(path: Path, members: dict, compression=zipfile.ZIP_DEFLATED, **attributes):
    with zipfile.ZipFile(path, "w", compression) as archive:
        for name, data in members.items():
            info = zipfile.ZipInfo(name)
            info.compress_type = compression
            for key, value in attributes.items():
                setattr(info, key, value)
            archive.writestr(info, data)


def repeated(path: Path, data: bytes, times: int):
    """A zip that has one exercise many times, each of another name to zipfile's eyes and the same to ours."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for i in range(times):
            archive.writestr(f"{i}/{LAMBERT}", data)


def tarred(path: Path, members: dict, mode="w:gz", **attributes):
    with tarfile.open(path, mode) as archive:
        for name, data in members.items():
            info = tarfile.TarInfo(name)
            info.size = len(data)
            for key, value in attributes.items():
                setattr(info, key, value)
            archive.addfile(info, io.BytesIO(data))


class Submissions(Class):
    """A class in which every way to hand in is tried: right where it can be read, and named where it cannot."""

    wanted = ["02.lambert", "03.range_fade"]

    @classmethod
    def fill(cls):
        at, member = cls.folder, {f"course/{LAMBERT}": RIGHT}
        cls.student("plain", {"02.lambert": RIGHT})
        cls.student("bom", {"02.lambert": b"\xef\xbb\xbf" + RIGHT})
        cls.student("dos", {"02.lambert": RIGHT.replace(b"\n", b"\r\n")})
        cls.student("starter in dos", {"02.lambert": OPEN.replace(b"\n", b"\r\n")})
        cls.student("nested/course", {"02.lambert": RIGHT})
        zipped(at / "zip.zip", member)
        zipped(at / "stored.zip", member, zipfile.ZIP_STORED)
        zipped(at / "dots.zip", {**member, f"../../{LAMBERT}": OPEN, f"/{LAMBERT}": OPEN})
        zipped(at / "of links.zip", member, external_attr=0o120777 << 16)
        for kind in ("gz", "bz2", "xz"):
            tarred(at / f"tar.{kind}.tar.{kind}", member, f"w:{kind}")
        tarred(at / "tar.tar", {f"./{LAMBERT}": RIGHT}, "w:")
        tarred(at / "not utf8.tar", {"\udcff\udcfe": b"", **member}, "w:")
        tarred(at / "link.tar", {**member}, "w:", type=tarfile.SYMTYPE, linkname="/etc/passwd")
        tarred(at / "device.tar", {**member}, "w:", type=tarfile.CHRTYPE)
        # The fault.
        whole = (at / "zip.zip").read_bytes()
        (at / "damaged.zip").write_bytes(whole[:60] + bytes(40) + whole[100:])
        (at / "cut.zip").write_bytes(whole[:len(whole) // 2])
        (at / "no.zip").write_bytes(b"PK but no zip")
        (at / "empty.zip").write_bytes(b"")
        xz = (at / "tar.xz.tar.xz").read_bytes()
        (at / "cut.tar.xz").write_bytes(xz[:len(xz) // 2])
        locked = bytearray(whole)
        for magic, flags in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
            struct.pack_into("<H", locked, locked.find(magic) + flags, 1)
        (at / "locked.zip").write_bytes(locked)
        cls.bombs()
        os.mkfifo(at / "fifo.zip")
        os.mkfifo(at / "pipe")
        inside = at / "a pipe inside" / Path(LAMBERT).parent
        inside.mkdir(parents=True)
        os.mkfifo(inside / "lambert.glsl")
        (at / "linked").symlink_to(at / "plain")
        (at / "linked.zip").symlink_to(at / "zip.zip")
        (at / "links inside").mkdir()
        for name in ("shaders", "chapters"):
            (at / "links inside" / name).symlink_to(at / "plain" / name)
        inside = at / "a link inside" / Path(LAMBERT).parent
        inside.mkdir(parents=True)
        (inside / "lambert.glsl").symlink_to(at / "plain" / LAMBERT)
        (at / "nothing").mkdir()
        cls.student("large", {"02.lambert": RIGHT + b"//" + bytes(1 << 19)})
        cls.student("a name\nhonest 2 of 2\x1b[2J", {"02.lambert": RIGHT})
        cls.student("=cmd|calc!A0", {"02.lambert": RIGHT})
        os.makedirs(os.fsencode(at) + b"/\xff\xfe latin/" + os.fsencode(Path(LAMBERT).parent))
        with open(os.fsencode(at) + b"/\xff\xfe latin/" + os.fsencode(LAMBERT), "wb") as file:
            file.write(RIGHT)
        zipped(at / "plain.zip", {LAMBERT: OPEN + b"// twice"})

    @classmethod
    def bombs(cls):
        at = cls.folder
        info = tarfile.TarInfo("zeros")
        info.size = 2 << 30
        head = info.tobuf()
        for name, pack in (("bomb.tar.xz", lzma.LZMACompressor(preset=0)), ("bomb.tar.bz2", bz2.BZ2Compressor(9))):
            data = pack.compress(head)
            for _ in range(300):  # more than may be unpacked
                data += pack.compress(bytes(1 << 20))
            (at / name).write_bytes(data + pack.flush())
        zipped(at / "bomb.zip", {f"course/{LAMBERT}": bytes(64 << 20)})
        # These two methods unpack all of a member at once, however little of it is asked for.
        zipped(at / "bomb by bzip2.zip", {f"course/{LAMBERT}": bytes(300 << 20)}, zipfile.ZIP_BZIP2)
        zipped(at / "bomb by lzma.zip", {f"course/{LAMBERT}": bytes(300 << 20)}, zipfile.ZIP_LZMA)
        zipped(at / "many.zip", {f"{i}": b"" for i in range(21000)})
        repeated(at / "again and again.zip", bytes(1 << 18), 1100)
        tarred(at / "many.tar.gz", {f"{i}": b"" for i in range(21000)}, "w:gz")
        (at / "greedy.tar.xz").write_bytes(xz_of_large_dictionary())

    def right(self, student):
        self.assertIsNone(self.grades[student]["error"])
        self.assertTrue(self.result(student, "02.lambert")["ok"], self.result(student, "02.lambert"))

    def test_what_can_be_read_is_judged(self):
        for student in ("plain", "bom", "dos", "nested", "zip", "stored", "dots", "tar.gz", "tar.bz2", "tar.xz",
                        "tar", "not utf8", r"a name\u000ahonest 2 of 2\u001b[2J", "=cmd|calc!A0", r"\xff\xfe latin"):
            with self.subTest(student):
                self.right(student)

    def test_what_cannot_be_read_is_named(self):
        for student, words in (("damaged", "cannot be read"), ("cut", "cannot be read"), ("no", "cannot be read: File is"),
                               ("empty", "cannot be read"), ("cut (2)", "cannot be read: it is cut off|cannot be read"),
                               ("locked", "is encrypted"), ("fifo", "is not a regular file"),
                               ("a pipe inside", "is not a regular file"), ("linked", "is a link"),
                               ("linked (2)", "is a link"), ("links inside", "is a link"), ("a link inside", "is a link"),
                               ("nothing", "holds no exercise"), ("of links", "holds no exercise"),
                               ("link", "holds no exercise|Damaged tar"), ("device", "holds no exercise|Damaged tar"),
                               ("large", "larger than 256 KiB"), ("bomb", "unpacks to more|larger than 256 KiB"),
                               ("bomb (2)", "unpacks to more|larger than 256 KiB"),
                               ("bomb (3)", "unpacks to more|larger than 256 KiB"), ("many", "more than 20000 files"),
                               ("many (2)", "more than 20000 files"), ("bomb by bzip2", "packed by method 12"),
                               ("bomb by lzma", "packed by method 14"), ("again and again", "unpacks to more than 256 MiB"),
                               ("greedy", "cannot be read: .*[Mm]emory")):
            with self.subTest(student):
                self.assertRegex(self.grades[student]["error"] or "nothing", words)
                self.assertEqual(self.grades[student]["right"], 0)

    def test_what_was_not_changed_is_not_judged(self):
        self.assertEqual(self.result("starter in dos", "02.lambert")["state"], "unchanged")
        self.assertEqual(self.result("plain", "03.range_fade")["state"], "missing")
        self.assertTrue(same_text(b"a \r\nb", b"a\nb\n"))

    def test_two_of_one_name_are_two(self):
        self.assertEqual(self.grades["plain (2)"]["right"], 0)

    def test_no_two_students_are_one_row(self):
        """For any file names: the second "ann" is not the folder "ann (2)"."""
        at = self.outside / "names"
        for name in ("ann", "ann (2)", "ann (2) (2)", "=b", "'=b"):
            (at / name).mkdir(parents=True)
        for name in ("ann.zip", "ann.tar", "ann (2).zip"):
            (at / name).touch()
        found = [one.student for one in find([at])]
        self.assertEqual(len({cell(name) for name in found}), 8, found)
        self.assertEqual(len(set(found)), 8, found)

    def test_files_and_table(self):
        out = self.outside / "out"
        out.mkdir()
        write_files(out, list(self.grades.values()), {name: "" for name in self.wanted})
        with (out / "grades.csv").open(newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(len(rows), len(self.grades) + 1)
        self.assertEqual(rows[0][:5], ["student", "right", "of", "02.lambert", "03.range_fade"])
        by_name = {row[0]: row for row in rows}
        self.assertEqual(by_name["plain"][1:5], ["1", "2", "1", "missing"])
        self.assertIn("'=cmd|calc!A0", by_name)
        self.assertEqual(json.loads((out / "grades.json").read_text()), list(self.grades.values()))
        lines = table(list(self.grades.values()), list(CHAPTERS[1:]))
        self.assertEqual(len([line for line in lines if not line.startswith("alike")]), len(self.grades) + 1)
        for line in lines:
            self.assertTrue(line.isprintable(), line)
        self.assertRegex(next(line for line in lines if line.startswith("plain ")), r"plain +1/2 +1/1 +0/1$")

    def test_again_nothing_is_run(self):
        with Judge({name: "02_lambert_phong" if name[:2] == "02" else "03_attenuation" for name in self.wanted}, 2, False) as judge, \
                mock.patch("grading.sandbox.Running", side_effect=AssertionError("it was run")):
            judge.verdicts = self.outside / "verdicts"
            again = grade(find([self.folder / "plain", self.folder / "zip.zip"]), judge)
        self.assertEqual([one["right"] for one in again], [1, 1])

    def test_what_was_ended_is_not_kept(self):
        """SIGTERM and Ctrl+C: a check that was killed on the way says nothing about the answer."""
        with Judge({"02.lambert": "02_lambert_phong"}, 2, False) as judge:
            judge.verdicts = self.outside / "ended"
            for after_s in (0.0, 0.02, 0.05, 0.1):  # before its process is there, and while we wait for its words
                threading.Timer(after_s, judge.stop).start()
                found = judge.verdict("02.lambert", RIGHT + b"// ended")
                self.assertEqual((found["state"], found["ok"]), ("failed", False), found)
                judge.stopped = False
            self.assertTrue(judge.verdict("02.lambert", RIGHT + b"// ended")["ok"])

    def test_random_inputs_are_those_of_the_seed(self):
        """A table of answers to the inputs that everybody can see is worth nothing."""
        wrong = b"float lambert(vec3 n, vec3 l) { return l.z > 0.3 ? 9.0 : max(dot(n, l), 0.0); }\n"
        with Judge({"02.lambert": "02_lambert_phong"}, 2, False) as judge:
            said = {judge.judge("02.lambert", wrong, seed)["first_failure"] for seed in (0, 1, 2)}
        self.assertEqual(len(said), 3, said)


class Pictures(Class):
    """Numbers that are right are not all."""

    wanted = ["01.transform", "01.triangulate", "02.lambert"]  # of transform: a model that Assimp reads
    pictures = True

    @classmethod
    def fill(cls):
        cls.student("honest", {name: right(name) for name in cls.wanted})
        two_faces = right("02.lambert").replace("{\n", "{\n#ifdef METHOD\n    return 0.3;\n#endif\n", 1)
        # A driver that keeps memory in a file has one open, too (Mesa 25): all are written.
        writes = """{
    struct stat about;
    bool written = false;
    for (int fd = 3; fd < 64; ++fd)
        if (!fstat(fd, &about) && S_ISREG(about.st_mode) && write(fd, "no picture", 10) == 10) written = true;
    if (written) _exit(0);
"""
        # 3,000 folders in one another wherever it may write, and as much as that takes: nobody walks through them.
        nests = """{
    for (const char* where : {"/out", "/tmp", "/grade", "/dev", "."})
        if (!chdir(where)) for (int i = 0; i < 3000 && !mkdir("x", 0777) && !chdir("x"); ++i) {}
    for (const char* where : {"/out/", "/grade/", "/dev/", "/"})
        for (int i = 0; i < 3; ++i)
            if (open((where + std::to_string(i)).c_str(), O_CREAT | O_WRONLY, 0600) >= 0) _exit(3);
"""
        fills = """{
    static char all[1 << 20];
    struct stat about;
    for (int fd = 3; fd < 64; ++fd)
        if (!fstat(fd, &about) && S_ISREG(about.st_mode)) {
            while (write(fd, all, sizeof all) > 0) {}
            _exit(0);
        }
"""
        two_minds = "{\n    struct stat drawn;\n    if (!stat(\"/grade/shaders\", &drawn)) return std::vector(polygon.size() - 2, glm::uvec3(0, 1, 2));\n"
        head = "#include <fcntl.h>\n#include <sys/stat.h>\n#include <unistd.h>\n#include <cstdlib>\n#include <string>\n"
        cls.student("two faces", {"02.lambert": two_faces})
        cls.student("two minds", {"01.triangulate": head + body(right("01.triangulate"), two_minds)})
        cls.student("own picture", {"01.triangulate": head + body(right("01.triangulate"), writes)})
        cls.student("nests", {"01.triangulate": head + body(right("01.triangulate"), nests)})
        cls.student("fills", {"01.triangulate": head + body(right("01.triangulate"), fills)})

    def test_pictures(self):
        self.assertEqual(self.grades["honest"]["right"], 3, self.grades["honest"])
        self.assertTrue(self.result("nests", "01.triangulate")["ok"], self.result("nests", "01.triangulate"))
        for student, exercise, words in (("two faces", "02.lambert", "pixels differ|one colour"),
                                         ("two minds", "01.triangulate", "pixels differ"),
                                         ("own picture", "01.triangulate", "cannot be compared|wrote none"),
                                         ("fills", "01.triangulate", "the program that draws it (?:ended with|wrote none)")):
            result = self.result(student, exercise)
            self.assertFalse(result["ok"], result)
            self.assertRegex(result["first_failure"], f"the numbers are right, .*picture.*: .*({words})")


def body(text: str, begins: str) -> str:
    """C++ with a different beginning of the exercise."""
    at = text.index("{\n", text.rindex("std::vector<glm::uvec3> triangulate("))
    return text[:at] + begins + text[at + 2:]


def xz_of_large_dictionary() -> bytes:
    """An xz header that asks for a dictionary of 1.5 GiB, which takes a decoder as much memory."""
    flags = b"\x00\x01"
    stream = b"\xfd7zXZ\x00" + flags + struct.pack("<I", zlib.crc32(flags))
    block = b"\x02\x00\x21\x01\x25\x00\x00\x00"
    return stream + block + struct.pack("<I", zlib.crc32(block)) + b"\x01\x00\x00x\x00\x00\x00\x00"


if __name__ == "__main__":
    unittest.main()
