"""Tests of ./course where the machine is against it: folders that cannot be written, another user, signals, two at once."""

import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from small_course import INTERRUPTIBLE, REAL, Course, clean_environment, make_tree, until

from build.format_tree import formatter
from tree import write_atomically

COMMANDS = ("run 01", "run", "check", "check --progress", "test", "accept --yes", "study", "study 01 --stretch", "docs", "format --check",
            "docs --quote", "fuzz 1", "handout OUT/copy", "doctor", "clean")


def can(*command) -> bool:
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0
    except OSError:
        return False


AS_OTHER = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups")
READ_ONLY = ("bwrap", "--bind", "/", "/", "--dev-bind", "/dev", "/dev")


class Trouble(Course):
    def setUp(self):
        self.outside.chmod(0o755)

    def assert_clear(self, printed: str):
        """Some words, none of Python's and none for each of a hundred files."""
        self.assertNotIn("Traceback", printed)
        self.assertLess(printed.count("\n"), 6, printed)

    def try_all(self, *wrapper):
        self.course("check", "01", code=1)  # finished parts stay
        for command in COMMANDS:
            with self.subTest(command):
                words = command.replace("OUT", str(self.outside)).split()
                printed = self.run_program([*wrapper, self.root / "course", *words], code=None)
                if words[-1] != "--quote" and words[0] not in ("doctor", "handout"):
                    self.assert_clear(printed)
                self.assertNotIn("Traceback", printed)
        shutil.rmtree(self.outside / "copy", ignore_errors=True)

    @unittest.skipUnless(can(*READ_ONLY, "true"), "bubblewrap makes a folder read-only for this test, and cannot here")
    def test_a_tree_that_cannot_be_written(self):
        self.try_all(*READ_ONLY, "--ro-bind", str(self.root), str(self.root))
        for folder in (self.root, self.root / "build"):
            printed = self.run_program([*READ_ONLY, "--ro-bind", str(folder), str(folder), self.root / "course", "check"], 2)
            self.assertRegex(printed, r"\Acourse: .*Read-only file system; what is built goes below the course; for a copy of your own, type .*\n\Z")
        with tempfile.TemporaryDirectory() as home:
            printed = self.run_program([*READ_ONLY, "--ro-bind", str(self.root), str(self.root), self.root / "course", "check"], 2, HOME=home)
            subprocess.run(printed.partition(" type ")[2], shell=True, check=True)
            self.assertIn("open  01.one", self.run_program([Path(home) / "lightwalk/course", "check", "01"], 1))
            self.assertIn("01_obj in", self.run_program([*READ_ONLY, "--ro-bind", str(self.root), str(self.root), self.root / "course", "run", "01"], HOME=home))

    @unittest.skipUnless(can(*AS_OTHER, "true"), "only root can be another user")
    def test_a_tree_of_another_user(self):
        self.try_all(*AS_OTHER)
        self.run_program(["git", "-C", self.root, "init", "-q"])
        self.addCleanup(shutil.rmtree, self.root / ".git")
        for words in ([["format", "--check"]] if formatter() else []) + [["handout", "/tmp/lightwalk.never"]]:
            printed = self.run_program([*AS_OTHER, self.root / "course", *words], 1, HOME="/nonexistent")
            self.assertRegex(printed, r"\Acourse: git does not trust this copy, which is another user's: git config .*\n\Z")

    @unittest.skipUnless(can(*AS_OTHER, "true"), "only root can be another user")
    def test_processes_and_threads_are_refused(self):
        """At the start, in a build, and later in Python."""
        def limited(most: int, *words: str, code: int = 3) -> str:
            return self.run_program(["timeout", "600", "setpriv", "--reuid=12346", "--regid=12346", "--clear-groups", "prlimit", f"--nproc={most}",
                                     self.root / "course", *words], code, HOME=str(self.outside)).splitlines(True)[-1]
        self.put("compile", "for i in $(seq 60); do sleep 2 >/dev/null 2>&1 & done\n")
        subprocess.run(["chown", "-R", "12346:12346", self.outside], check=True)
        self.addCleanup(subprocess.run, ["chown", "-R", "0:0", self.outside], check=True)
        says = r"\Acourse: this machine starts no more processes and threads: raise ulimit -u \(\d+\), or the limit of the container's processes\n\Z"
        self.assertRegex(limited(1, "doctor", code=2), r"\A.*course: \d+: Cannot fork\n\Z")
        for most, command in ((6, "doctor"), (6, "check 01"), (6, "docs"), (40, "check 01")):
            self.assertRegex(limited(most, *command.split()), says)
        self.put("common/course/run.py", "import threading, time\n\nHELP = ''\n\n\ndef add_arguments(_):\n"
                 "    [threading.Thread(target=time.sleep, args=[1], daemon=True).start() for _ in range(200)]\n")
        self.assertRegex(limited(150, "run"), says)

    def test_a_power_cut_leaves_empty_files(self):
        self.course("check", "01", code=1)
        for name, left in (("build.ninja", ""), ("build.ninja", "\0" * 4096), ("CMakeFiles/rules.ninja", "")):
            with self.subTest(name, left=left[:1]):
                (self.root / "build" / name).write_text(left)
                self.assertIn("configuring build", self.course("check", "01", code=1))
                self.assertNotIn("configuring", self.course("check", "01", code=1))

    def test_clean_removes_what_is_its_own(self):
        precious = self.outside / "precious"
        precious.mkdir()
        (precious / "thesis").write_text("all of it")
        for folder in (precious, self.root, self.outside, "/"):
            printed = self.course("clean", LIGHTWALK_BUILD=str(folder), code=2)
            self.assertIn("is not a build folder of this course: nothing was removed", printed)
        self.assertTrue((precious / "thesis").exists() and (self.root / "course").exists())
        self.course("check", "01", code=1)
        elsewhere = self.outside / "elsewhere"
        (self.root / "build").rename(elsewhere)
        (self.root / "build").symlink_to(elsewhere)
        self.course("clean")
        self.assertFalse(elsewhere.exists() or (self.root / "build").is_symlink())
        self.course("clean")

    def slow_build(self) -> subprocess.Popen:
        """Starts a check with a sleeping build, and waits for the build."""
        self.course("check", "01", code=None)
        log = self.root / "log"
        log.unlink(missing_ok=True)
        self.addCleanup(log.unlink, missing_ok=True)
        self.put("compile", f"echo start >>{log}; sleep 2; echo stop >>{log}\n")
        self.put("chapters/01_obj/exercise/one.cpp", f"changed {random.random()}")
        course = subprocess.Popen([self.root / "course", "check", "01"], env=clean_environment(), text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **INTERRUPTIBLE)
        self.addCleanup(course.stdout.close)
        while not log.exists():
            time.sleep(0.02)
        return course

    def test_ended_it_ends_the_build(self):
        course = self.slow_build()
        course.send_signal(signal.SIGTERM)
        self.assertEqual(course.wait(timeout=60), 143)
        time.sleep(2.2)
        self.assertEqual((self.root / "log").read_text(), "start\n")

    def test_ended_it_ends_what_it_fuzzes_with(self):
        slow = self.root / "slow"
        self.put("slow")
        self.course("run", "01")
        fuzz = subprocess.Popen([self.root / "course", "fuzz", "60"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **INTERRUPTIBLE)
        until(slow.read_text, 300)
        fuzz.send_signal(signal.SIGTERM)
        self.assertEqual(fuzz.wait(60), 143)
        self.assertFalse(Path(f"/proc/{slow.read_text().strip()}").exists())

    def test_killed_it_leaves_the_lock_to_the_build(self):
        course = self.slow_build()
        course.kill()
        course.wait()
        self.assertIn("waiting for another ./course", self.course("check", "01", code=None))
        self.assertEqual((self.root / "log").read_text(), "start\nstop\n" * ((self.root / "log").read_text().count("start")))

    def test_two_at_once(self):
        self.put("chapters/01_obj/exercise/one.cpp", "right")
        self.put("starter_is_right")  # and its picture is
        running = [subprocess.Popen([self.root / "course", *words.split()], env=clean_environment(), text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT) for words in ("check 01", "check 01", "run", "run", "check --progress")]
        for one in running:
            printed, _ = one.communicate(timeout=60)
            self.assertNotIn("Traceback", printed)
            self.assertNotIn("open  01", printed)

    def test_where_the_course_lies(self):
        for name, works in (("Grüße an dich", True), ("a$b", False), ("a;b", False), ("a#b", False),
                            ('a"b', False), ("a\\b", False), ("a,b", False), ("a\nb", False)):
            with self.subTest(name):
                root = self.outside / name
                make_tree(root)
                printed = self.run_program([root / "course", "check", "01"], code=1 if works else 2)
                if works:
                    self.assertIn("open  01.one", printed)
                else:
                    self.assertRegex(printed, r"\Acourse: the course lies in .* move the course to another folder\n\Z")


class Saves(Course):
    def test_what_cannot_be_written_is_named(self):
        """Not the file beside it, which nobody knows."""
        folder = self.outside / "folder"
        folder.mkdir()
        with self.assertRaises(IsADirectoryError) as raised:
            write_atomically(folder, "text")
        self.assertEqual(raised.exception.filename, str(folder))

    def test_on_a_full_disk_the_old_file_stays(self):
        file = self.outside / "full"
        write_atomically(file, "old")
        code = (f"import resource, signal, sys; sys.path.insert(0, {str(REAL / 'common/course')!r})\nfrom pathlib import Path\n"
                "from tree import write_atomically\nsignal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
                "resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))\n"
                f"try:\n write_atomically(Path({str(file)!r}), 'x' * 100000)\nexcept OSError as e: print(e.strerror)\n")
        self.assertIn("File too large", self.run_program([sys.executable, "-c", code]))
        self.assertEqual(file.read_text(), "old")
        self.assertEqual([path.name for path in Path(self.outside).glob(".full*")], [])
