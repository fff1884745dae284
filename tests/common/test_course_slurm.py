"""Tests of --slurm: its script, its refusals, and a part that dies. Commands with it are run by test_course_commands.py."""
# Builds: nothing

import argparse
import contextlib
import io
import os
import subprocess
from pathlib import Path
from unittest import mock

from folder_case import FolderCase
from small_course import REAL
from many import slurm
from progress import Progress
from tree import Failure, UsageError


def words_of(*words) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    slurm.add_arguments(parser)
    parser.add_argument("--shard")
    parser.add_argument("--merge")
    return parser.parse_args(words)


class Script(FolderCase):
    def test_a_person_can_read_it(self):
        text = slurm.script("grade", ["grade", "a class", "--chapter", "02"], Path("/f"), 16, ["--partition=short", "-t", "60"],
                            Path("/home of"))
        self.assertEqual(text.splitlines()[1], "# ./course grade 'a class' --chapter 02, in 16 parts: one for each task of this array job.")
        for line in ("#SBATCH --array=1-16", "#SBATCH --partition=short -t 60", "#SBATCH --mem=8G", "#SBATCH --requeue",
                     '#SBATCH --chdir="/home of"', "#SBATCH --output=/f/grade.%a.log",
                     f"exec {REAL}/course grade 'a class' --chapter 02 --shard \"$SLURM_ARRAY_TASK_ID/16\" --out /f"):
            self.assertIn(line, text.splitlines())
        self.assertNotIn("--time", text)
        self.assertEqual(subprocess.run(["bash", "-n"], input=text, text=True).returncode, 0)

    def test_the_words_of_a_part(self):
        for words in (["--slurm"], ["--slurm=--mem=1G -t 3"], ["--slurm", "--mem=1G -t 3"], ["--shards", "4", "--slurm"], ["--shards=4"],
                      ["--out", "x y"]):
            self.assertEqual(slurm.without(["grade", "c", *words, "--json"], "--slurm", "--shards", "--out"), ["grade", "c", "--json"])

    def test_a_bad_word_is_one_line(self):
        with mock.patch("shutil.which", lambda name: "/bin/true"):
            slurm.check_arguments(words_of("--slurm=--partition=short --mem=16G", "--shards", "8"))
            for words, said in ((["--slurm", "class"], "put --slurm last"), (["--slurm=--array=3"], "--array is set by the course"),
                                (["--slurm=--x='"], "No closing quotation"), (["--slurm", "--shard", "1/2"], "leave out --shard"),
                                (["--shards", "4"], "give both"), (["--slurm", "--shards", "0"], "expected 1 to 1000")):
                with self.assertRaisesRegex(UsageError, said):
                    slurm.check_arguments(words_of(*words))
        with mock.patch("shutil.which", lambda name: None), self.assertRaisesRegex(UsageError, "no sbatch.*slurm-client"):
            slurm.check_arguments(words_of("--slurm"))

    def test_what_slurm_refuses_is_said(self):
        self.write("sbatch", "#!/bin/sh\necho 'sbatch: error: invalid partition specified: short' >&2; exit 1\n").chmod(0o755)
        with mock.patch.dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}"), \
                self.assertRaisesRegex(Failure, "invalid partition specified: short"):
            slurm.submit(Path("x.sbatch"), [1], 1)

    def test_a_part_that_died_is_submitted_once_more(self):
        def submit(_file, numbers, of):
            asked.append(numbers)
            for number in numbers:
                if number != 2 or len(asked) == lives:
                    (self.folder / f"slurm/{kind}/{kind}.{number}-of-{of}.zip").touch()
            return str(len(asked))
        self.enterContext(mock.patch.multiple(slurm, BUILD=self.folder, submit=submit, states=lambda job: [], course_version=lambda: ""))
        for kind, lives in (("grade", 2), ("study", 3)):
            asked, said = [], io.StringIO()
            with mock.patch.object(slurm, "Progress", lambda label: Progress(label, said)), \
                    self.assertRaisesRegex(Failure, "^part 2 of 3 died 2 times; ") if lives > 2 else contextlib.nullcontext():
                self.assertEqual(slurm.run(kind, words_of("--slurm", "--shards", "3"), [kind]), self.folder / "slurm" / kind)
            self.assertEqual(asked, [[1, 2, 3], [2]])
            self.assertRegex(said.getvalue(), r"\Ajob 1: 3 parts; .*\n(.*\n)*part 2 of 3 died: submitted again\njob 2: 1 parts; ")
