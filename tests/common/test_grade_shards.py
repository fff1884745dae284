"""Tests of shards (common/course/many/shards.py): the division of work, merges and their refusals, and equal tables for a
class graded in shards and at once."""

import argparse
import contextlib
import io
import json
import tempfile
import unittest
import zipfile
from pathlib import Path
from unittest import mock

from folder_case import FolderCase
from graded_class import PLACES, right, why_not
from many import shards
from many.shards import Shard
from tree import Failure, UsageError
import cli  # noqa: E402

NAMES = [f"student {i:04}.zip" for i in range(2000)]


RESULT = {"exercise": "01.transform", "chapter": "01_obj", "ok": True, "passed": 1, "failed": 0, "first_failure": None, "hint": None,
          "state": "judged"}
ENTRY = {"at": 0, "read": True, "answers": {}, "grade": {"student": "ann", "path": "ann", "error": None, "handed_in_s": None,
                                                         "results": [RESULT], "alike": []}}
HEAD = {"exercises": [["01.transform", "01_obj"]], "submissions": 1, "inputs": "a", "class": "b", "course": "c"}


class Cut(unittest.TestCase):
    def test_each_piece_is_in_one_shard(self):
        of = 16
        parts = [[name for name in NAMES if Shard(k, of).takes(name)] for k in range(1, of + 1)]
        self.assertEqual(sorted(sum(parts, [])), NAMES)
        self.assertLess(max(map(len, parts)), 1.4 * len(NAMES) / of)

    def test_the_cut_is_known_for_ever(self):
        """The same on every machine and in every process: shards of one class meet again in one merge."""
        self.assertEqual([next(k for k in range(1, 17) if Shard(k, 16).takes(name)) for name in ("ann", "ben.zip", "\udcff")],
                         [15, 5, 1])

    def test_what_is_no_shard(self):
        for word in ("0/3", "4/3", "3", "a/b", "1/0", "-1/2", "1/20000", "1/2/3", "", "1 /2"):
            with self.assertRaisesRegex(argparse.ArgumentTypeError, "is not a shard; expected K/N"):
                shards.argument(word)
        self.assertEqual(str(shards.argument("03/16")), "3/16")

    def test_the_command_that_makes_it_again(self):
        self.assertEqual(shards.command_words(["grade", "a class", "--shard", "1/2", "--out", "F"]),
                         "./course grade 'a class' --out F")
        self.assertEqual(shards.command_words(["grade", "--shard=1/2", "x"]), "./course grade x")


class Merge(FolderCase):
    def write(self, number, of=3, head=None, entries=None, name="", **files) -> Path:
        shard = Shard(number, of)
        file = shards.file_of(self.folder / name, "film", shard)
        with mock.patch("sys.argv", ["cli.py", "run", "19", "--film", "x.mp4", "--shard", str(shard), "--out", "F"]):
            shards.write(file, "film", shard, head or {"size": [960, 540]},
                         entries if entries is not None else {f"frame {number}": number}, files)
        return file

    def test_all_that_shards_made(self):
        for number in (3, 1, 2):
            self.write(number, **{"a.png": b"picture %d" % number})
        (self.folder / ".film.2-of-3.zip.77").write_bytes(b"half")
        made = shards.merge([self.folder], "film")
        self.assertEqual(made.entries, {"frame 1": 1, "frame 2": 2, "frame 3": 3})
        self.assertEqual(made.file("frame 2", "a.png"), b"picture 2")
        self.assertEqual(made.head, {"size": [960, 540]})

    def test_the_same_bytes(self):
        first = self.write(1, **{"b": b"x"}).read_bytes()
        self.assertEqual(self.write(1, **{"b": b"x"}).read_bytes(), first)

    def test_a_dead_one_is_named(self):
        self.write(1)
        self.write(3)
        with self.assertRaisesRegex(Failure, r"^of 3 shards one is missing: 2; \./course run 19 --film x\.mp4 --out F --shard 2/3 makes it$"):
            shards.merge([self.folder], "film")
        with self.assertRaisesRegex(Failure, "of 3 shards 2 are missing: 2, 3; .* --shard 2/3 makes the first"):
            shards.merge([self.folder / "film.1-of-3.zip"], "film")

    def test_nothing_is_counted_twice(self):
        files = [self.write(number) for number in (1, 2, 3)]
        self.assertEqual(shards.merge([self.folder, *files, files[1]], "film").entries, {"frame 1": 1, "frame 2": 2, "frame 3": 3})
        other = self.write(2, name="other", entries={"frame 2": 9})
        with self.assertRaisesRegex(UsageError, "other.* and .* are both shard 2/3, and differ"):
            shards.merge([self.folder, other], "film")
        self.write(2, entries={"frame 1": 1})
        with self.assertRaisesRegex(UsageError, "both have 'frame 1'"):
            shards.merge([self.folder], "film")

    def test_what_does_not_belong_together(self):
        self.write(1)
        self.write(2, head={"size": [10, 10]})
        with self.assertRaisesRegex(UsageError, r"differ in size: \[10, 10\] and \[960, 540\]; make both again"):
            shards.merge([self.folder], "film")
        self.assertEqual(shards.merge([self.folder, self.write(3)], "film", per_shard=("size",)).head["size"][1], [10, 10])
        other = self.write(1, of=2, name="two")
        with self.assertRaisesRegex(UsageError, "is a shard of 2 and .* one of 3"):
            shards.merge([self.folder / "film.1-of-3.zip", other], "film")

    def test_what_is_no_shard(self):
        for name, data in (("no.zip", b"no"), ("empty.zip", b"")):
            (self.folder / name).write_bytes(data)
            with self.assertRaisesRegex(UsageError, f"{name}: is not a shard"):
                shards.merge([self.folder / name], "film")
        with zipfile.ZipFile(self.folder / "a.zip", "w") as archive:
            archive.writestr("shard.json", '{"shard": [5, 3], "kind": "film"}')
        for path, words in (("a.zip", "is not a shard"), ("none", "no such file"), ("", "no film.K-of-N.zip in it")):
            with self.assertRaisesRegex(UsageError, words):
                shards.merge([self.folder / path], "film")
        with self.assertRaisesRegex(UsageError, "is a shard of film, expected grade"):
            shards.merge([self.write(1)], "grade")
        with self.assertRaisesRegex(UsageError, "cannot be written"):
            shards.file_of(Path("/proc/x"), "film", Shard(1, 2))


@unittest.skipIf(why_not(), why_not())
class Graded(unittest.TestCase):
    """The command itself, of GLSL alone: a check takes a tenth of a second."""

    @classmethod
    def setUpClass(cls):
        cls.outside = Path(cls.enterClassContext(tempfile.TemporaryDirectory())).resolve()
        cls.folder = cls.outside / "class"
        lambert = right("02.lambert")
        for i in range(12):
            path = cls.folder / f"student {i:02}" / PLACES["02.lambert"]
            path.parent.mkdir(parents=True)
            path.write_text(lambert.replace("max(", "min(") if i % 4 == 1 else lambert + f"// {i % 3}\n")
        (cls.folder / "nothing").mkdir()
        cls.enterClassContext(mock.patch("grading.grade.exercises", lambda chapter: {"02.lambert": None}))

    def course(self, *words, code=0) -> str:
        """Output of ./course grade."""
        out, said = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(said), \
                mock.patch("sys.argv", ["cli.py", "grade", *map(str, words)]):
            try:
                got = cli.main(["grade", *map(str, words)])
            except (UsageError, Failure) as error:
                got, out = 2 if isinstance(error, UsageError) else 1, io.StringIO(f"course: {error}\n")
        self.assertEqual(got, code, out.getvalue() + said.getvalue())
        return out.getvalue()

    def files(self, folder: Path) -> dict[str, bytes]:
        return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}

    def test_a_class_in_shards_is_the_class_in_one(self):
        where = self.outside
        whole = self.course(self.folder, "--chapter", "02", "--out", where / "whole")
        self.assertIn("student 00  ", whole)
        for number in (3, 1):
            self.course(self.folder, "--chapter", "02", "--shard", f"{number}/3", "--out", where / "parts")
        words = self.course("--merge", where / "parts", "--out", where / "merged", code=1)
        self.assertRegex(words, "of 3 shards one is missing: 2; ./course grade .*class --chapter 02 --out .*parts --shard 2/3 makes it")
        self.assertFalse((where / "merged").exists())
        self.course(self.folder, "--chapter", "02", "--shard", "2/3", "--out", where / "parts")
        parts = sorted((where / "parts").iterdir(), reverse=True)
        self.assertEqual(self.course("--merge", *parts, parts[0], "--out", where / "merged"), whole)
        self.assertEqual(self.files(where / "merged"), self.files(where / "whole"))

    def merged(self, about, code: int) -> str:
        file = self.outside / "grade.1-of-1.zip"
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr("shard.json", about if isinstance(about, str) else json.dumps(about))
        return self.course("--merge", file, "--out", self.outside / "damaged", code=code)

    def test_damaged_shards(self):
        def about(**more):
            return {"kind": "grade", "shard": [1, 1], "command": "x", "head": HEAD, "entries": {"ann": ENTRY}} | more

        def entry(**more):
            return about(entries={"ann": ENTRY | more})

        def result(**more):
            return entry(grade=ENTRY["grade"] | {"results": [RESULT | more]})
        self.merged(about(), 0)
        for name in ("grades.csv", "grades.json", "marks.json"):  # their owner's alone
            self.assertEqual((self.outside / "damaged" / name).stat().st_mode & 0o777, 0o600, name)
        for bad in ("", "[]", "{", "[" * 100000, about(head=[]), about(head=HEAD | {"exercises": 1}), about(head=HEAD | {"exercises": [[1]]}),
                    about(head=HEAD | {"submissions": "1"}), about(head={}), about(entries=[]), about(entries={"ann": None}), about(shard=["1", 1]),
                    about(command=1), entry(answers=1), entry(answers={"01.transform": "../x"}), entry(grade=1), entry(answers={"01.transform": "abc"}),
                    result(ok="yes"), result(state=1), result(passed="1"), result(exercise=[]), result(picture=1), result(picture="../../x"),
                    about(kind="a\nb"), about(kind="x" * 100000), about(command="a\nb"), about(head=HEAD | {"exercises": [[{}, "01_obj"]]})):
            with self.subTest(str(bad)[:120]):
                self.assertRegex(self.merged(bad, 2), r"\Acourse: [^\n]*\n\Z")

    def test_a_bad_word_is_one_line_and_2(self):
        for words, said in ((["--merge", "/no/such"], "no such file"), ([], "name a class"),
                            ([self.folder, "--merge", self.folder], "leave out its folder"),
                            ([self.folder, "--shard", "5/3"], "'5/3' is not a shard"),
                            ([self.folder, "--shard", "1/3", "--out", "/proc/x"], "cannot be written"),
                            (["--shard", "1/3", "--merge", "x"], "one of them")):
            printed = self.course(*words, code=2)
            self.assertRegex(printed, rf"\Acourse: [^\n]*{said}[^\n]*\n\Z")
