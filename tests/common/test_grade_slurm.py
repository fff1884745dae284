"""Tests of --slurm: its script, its refusals, and a class graded by a real Slurm on this machine, with a part that is
killed and a node that is drained."""

import argparse
import os
import subprocess
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import slurm_cluster
from graded_class import REAL, why_not
from many import slurm
from tree import Failure, UsageError

COUNT, PARTS = 12, 3


def words_of(*words) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    slurm.add_arguments(parser)
    parser.add_argument("--shard")
    parser.add_argument("--merge")
    return parser.parse_args(words)


class Script(unittest.TestCase):
    def test_a_person_can_read_it(self):
        text = slurm.script("grade", ["grade", "a class", "--chapter", "02"], Path("/f"), 16, ["--partition=short", "-t", "60"], Path("/home of"))
        self.assertEqual(text.splitlines()[1], "# ./course grade 'a class' --chapter 02, in 16 parts: one for each task of this array job.")
        for line in ("#SBATCH --array=1-16", "#SBATCH --partition=short", "#SBATCH -t 60", "#SBATCH --mem=8G", "#SBATCH --requeue",
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
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "sbatch").write_text("#!/bin/sh\necho 'sbatch: error: invalid partition specified: short' >&2; exit 1\n")
        (folder / "sbatch").chmod(0o755)
        with mock.patch.dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}"), \
                self.assertRaisesRegex(Failure, "invalid partition specified: short"):
            slurm.submit(Path("x.sbatch"), [1], 1)


@unittest.skipIf(slurm_cluster.why_not(), slurm_cluster.why_not())
@unittest.skipIf(why_not(), why_not())
class Graded(unittest.TestCase):
    def test_by_slurm_and_by_hand(self):
        """A part is killed at its work and a node drained; the table is that of one run."""
        parts, made = PARTS, Path(self.enterContext(tempfile.TemporaryDirectory()))
        slurm_cluster.make_class(made / "class", COUNT)
        words = ["--chapter", "02"]
        with slurm_cluster.Cluster() as cluster:
            running = slurm_cluster.grade(made / "class", made / "slurm", *words, "--slurm", "--shards", str(parts))
            printed, said = slurm_cluster.kill_and_drain(cluster, running, parts)
        self.assertEqual(running.returncode, 0, said)
        self.assertRegex(said, rf"job \d+: {parts} parts; build/slurm/grade/grade.sbatch")
        self.assertRegex(said, rf"part 2 of {parts} died: submitted again")
        self.assertRegex(said, rf"grade, Slurm {parts}/{parts}")
        whole, _ = slurm_cluster.grade(made / "class", made / "whole", *words).communicate()
        self.assertEqual(printed, whole)
        self.assertEqual(slurm_cluster.files(made / "slurm"), slurm_cluster.files(made / "whole"))


if __name__ == "__main__":
    unittest.main()
