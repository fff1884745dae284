"""Test of ./course release, whose ./course test is a script here."""
# Builds: nothing

import subprocess
import sys

from small_course import Course


# Writes what a step's tests leave, and ends as they would.
COURSE = """#!/bin/sh
cd "$(dirname "$0")" && mkdir -p build/results || exit
write() { echo "<testsuite><testcase name='shots.01' status='run'/><testcase name='shots.02' status='$2'/></testsuite>" >build/results/$1.xml; }
case "$*" in
    *--all*)
        [ ! -e build/cut ] || [ "$4" != 3/8 ] || { rm build/cut; kill -9 $PPID; exit 1; }
        echo "$4" >>build/parts
        write tests run ;;
    *--sanitize*) write sanitizer fail; exit 1 ;;
    *) echo "course: only root can | make a container" >&2; exit 2 ;;
esac
"""


class Release(Course):
    def commit(self) -> str:
        for words in ("init -q", "add -A", "-c user.name=x -c user.email=x commit -qm x --allow-empty"):
            subprocess.run(["git", "-C", self.root, *words.split()], check=True)
        return subprocess.run(["git", "-C", self.root, "rev-parse", "HEAD"], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    def release(self, *steps: str, code: int = 0) -> str:
        only = [word for step in steps for word in ("--only", step)]
        return self.run_program([sys.executable, self.root / "common/course/cli.py", "release", *only], code)

    def rows(self) -> dict[str, tuple[str, str, str]]:
        """Tests, failed ones and the result in the page's row of a command."""
        lines = (self.root / "docs/release.md").read_text().splitlines()
        cells = [line.strip("| ").split(" | ") for line in lines if line.startswith("| `./course")]
        return {row[0].strip("`").removeprefix("./course "): (row[2], row[3], row[-1]) for row in cells}

    def test_a_commit_keeps_the_rows_of_earlier_runs(self):
        self.put("course", COURSE)
        self.put("docs/release.md")
        commit = self.commit()
        self.assertIn("all.8-of-8: passed\ndocs/release.md: 1 of 6 steps passed\n", self.release("all"))
        self.assertEqual(self.rows()["test --all"], ("16", "0", "passed"))
        self.assertEqual(self.rows()["release --only gpu"], ("0", "0", "not run yet"))
        self.assertIn(f"| commit | `{commit}` |", (self.root / "docs/release.md").read_text())
        self.assertIn("1 of 6 steps passed", self.release("sanitizers", "trixie", code=1))
        for command, row in (("test --all", ("16", "0", "passed")), ("test --sanitize", ("2", "1", "failed: shots.02")),
                             ("test --on trixie", ("0", "0", "not run: only root can / make a container"))):
            self.assertEqual(self.rows()[command], row)
        self.commit()
        self.release("trixie")  # what cannot run here is no failure
        self.assertEqual(self.rows()["release --only all"], ("0", "0", "not run yet"))
        self.put("docs/01_obj.md", "changed")
        self.put("new.txt")
        self.assertRegex(self.release(code=2), r"\Acourse: a release is of a commit, [^\n]*docs/01_obj.md and 1 more\n\Z")

    def test_a_run_that_was_cut_short_goes_on(self):
        self.put("course", COURSE)
        self.put("docs/release.md")
        self.commit()
        self.put("build/cut")
        self.put("build/parts")
        self.release("all", code=-9)
        self.assertEqual(self.rows()["test --all"], ("4", "0", "6 of its 8 parts are not run yet"))
        self.release("all")
        self.assertEqual(self.rows()["test --all"], ("16", "0", "passed"))
        self.release("all")
        self.assertEqual((self.root / "build/parts").read_text().split(), [f"{part}/8" for part in range(1, 9)])
