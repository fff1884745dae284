"""Tests of ./course release, whose ./course test is a script here."""
# Builds: nothing

import subprocess
import sys

from small_course import Course


# Writes what a step's tests leave, and ends as they would.
COURSE = """#!/bin/sh
cd "$(dirname "$0")" || exit
echo "$@ $VK_DRIVER_FILES" >>build/ran
mkdir -p build/results
write() { echo "<testsuite><testcase name='shots.01' status='run'/><testcase name='shots.02' status='$2'/></testsuite>" >build/results/$1.xml; }
case "$*" in
    *--all*) write tests run ;;
    *--sanitize*) write sanitizer fail; exit 1 ;;
    *--on*) echo "course: only root can | make a container" >&2; exit 2 ;;
    *) echo compiling; echo "course: the build failed in $(pwd)/chapters" >&2; exit 1 ;;
esac
"""


class Release(Course):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.root / "course").write_text(COURSE)
        (cls.root / "docs/release.md").write_text("")
        cls.git("init", "-q")
        cls.commit()

    @classmethod
    def git(cls, *words):
        return subprocess.run(["git", "-C", cls.root, *words], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    @classmethod
    def commit(cls):
        cls.git("add", "-A")
        cls.git("-c", "user.name=x", "-c", "user.email=x", "commit", "-qm", "x", "--allow-empty")

    def release(self, *words, code=0, **environment):
        return self.run_program([sys.executable, self.root / "common/course/cli.py", "release", *words], code, **environment)

    def rows(self) -> dict[str, list[str]]:
        """The cells of the page behind each command."""
        lines = (self.root / "docs/release.md").read_text().splitlines()
        cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("| `./course")]
        return {row[0].strip("`").removeprefix("./course "): row[1:] for row in cells}

    def test_a_row_for_each_step_of_the_commit(self):
        self.assertIn("all: passed\ndocs/release.md: 1 of 6 steps passed\n", self.release("--only", "all"))
        self.assertEqual(self.rows()["test --all"][1:3] + self.rows()["test --all"][-1:], ["2", "0", "passed"])
        self.assertEqual(self.rows()["release --only gpu"][-1], "not run yet")
        page = (self.root / "docs/release.md").read_text()
        self.assertIn(f"| commit | `{self.git('rev-parse', 'HEAD')}` |", page)
        self.assertRegex(page, r"\| machine \| \d+ cores, .+, \d+ GB \|")

        said = self.release("--only", "sanitizers", "--only", "trixie", "--only", "gpu", code=1)
        self.assertIn("1 of 6 steps passed", said)
        rows = self.rows()
        self.assertEqual(rows["test --all"][-1], "passed")  # of the run before
        self.assertEqual(rows["test --sanitize"][1:3] + rows["test --sanitize"][-1:], ["2", "1", "failed: shots.02"])
        self.assertEqual(rows["test --on trixie"][-1], "not run: only root can / make a container")
        self.assertEqual(rows["release --only gpu"][-1], "not run: no Vulkan device of this machine is hardware")

        self.commit()
        self.release("--only", "trixie")  # what cannot run here is no failure
        self.assertEqual(self.rows()["release --only all"][-1], "not run yet")

    def test_a_release_is_of_a_commit(self):
        self.put("docs/01_obj.md", "changed")
        self.put("new.txt", "")
        self.assertRegex(self.release(code=2), r"\Acourse: a release is of a commit, [^\n]*docs/01_obj.md and 1 more\n\Z")
        self.assertIn("invalid choice: 'nothing'", self.release("--only", "nothing", code=2))
