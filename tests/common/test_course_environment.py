"""Tests of ./course with what people have beside it: copies and locks of editors, environments, clocks, displays."""

import io
import os
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from small_course import Course, clean_environment, write

from tree import PYTHON

ONE = "chapters/01_obj/exercise/one.cpp"


class Beside(Course):
    """What lies among the sources and is none of them."""

    def test_copies_and_locks_take_part_in_nothing(self):
        self.put(ONE, "right")
        self.put("starter_is_right")  # and its picture is
        before = self.course("check", "01")
        names = ("one (copy).cpp", "backup_one.cpp", "._one.cpp", ".one.cpp.swp", "one.cpp~", "one.cpp.orig", "one_old.glsl", "one.o")
        for name in names:
            self.put(f"chapters/01_obj/exercise/{name}", "open")
        lock = self.root / "chapters/01_obj/exercise/.#one.cpp"
        lock.symlink_to("me@host.1:17")
        self.addCleanup(lock.unlink)
        shutil.copytree(self.root / "chapters/02_lambert", self.root / "chapters/02_lambert_backup")
        self.addCleanup(shutil.rmtree, self.root / "chapters/02_lambert_backup")
        for words, code in ((["check", "01"], 0), (["check"], 1), (["check", "--progress"], 1), (["run", "01"], 7)):
            printed = self.course(*words, code=None)
            with self.subTest(words):
                self.assertNotIn("Traceback", printed)
                self.assertNotIn("No such file", printed)
                if words[0] == "check":
                    self.assertEqual(printed.count("left alone: "), 1, printed)
                    self.assertNotIn("backup_one ", printed)
        self.assertIn("left alone: chapters/01_obj/exercise/.#one.cpp, ", printed := self.course("check", "01"))
        self.assertEqual([line for line in printed.splitlines() if not line.startswith("left alone")],
                         [line for line in before.splitlines()][-len(printed.splitlines()) + 1:])

    def test_a_lock_beside_any_source_stops_nothing(self):
        self.put("common/app/options.cpp", '"--size"')
        self.put("shaders/01_obj/mesh.frag", "void main() {}")
        self.put("shaders/01_obj/solution/clay.glsl", "float clay() { return 1.0; }")
        self.put("shaders/01_obj/mesh (copy).frag", "void main() {}")
        folders = [path for path in self.root.rglob("*") if path.is_dir() and path.relative_to(self.root).parts[0] in ("chapters", "docs", "shaders", "tests")]
        for folder in folders:
            for ending in ("cpp", "h", "glsl", "frag", "md", "json", "changes", "py"):
                lock = folder / f".#one.{ending}"
                lock.symlink_to("me@host.1:17")
                self.addCleanup(lock.unlink)
        self.assertIn("01_obj in", self.course("run", "01"))
        self.assertEqual(self.course("shader", "--list"), "01_obj/clay.glsl\n01_obj/mesh.frag\n")
        self.course("docs", "--quote")
        said = self.run_program([*PYTHON, "-c", f"""import sys, pathlib
sys.path.insert(0, {str(self.root / "common/course")!r})
from check import glsl_answer, lesson_tests, variants
from grading.judge import Judge
from grading.sandbox import Mounts
from live import serve
from tree import ROOT
path = ROOT / "shaders/01_obj/solution/clay.glsl"
mounts, index = Mounts(), ROOT / "docs/index.html"
index.write_text("newer than all")
Judge.mount_references(None, mounts, "02.one")
print(glsl_answer.plain(b"", path), lesson_tests.cases("test_01_obj"), variants.variants("01_obj"), serve.is_old(index.parent))
print([word for word in mounts.words if "#" in word])
index.unlink()
"""])
        self.assertEqual(said, " [] ([], []) False\n[]\n")

    def test_a_backup_of_a_starter_is_kept_aside_in_silence(self):
        self.put("chapters/01_obj/exercise/one.cpp.1.old", "open")
        self.assertNotIn("left alone", self.course("check", "01", code=None))


class Environment(Course):
    def test_variables_of_others_change_nothing(self):
        before = self.course("check", code=1)
        for name, value in (("PYTHONSAFEPATH", "1"), ("PYTHONHOME", "/nowhere"), ("PYTHONPATH", "/nowhere"), ("PYTHONOPTIMIZE", "2"),
                            ("PYTHONWARNINGS", "error"), ("PYTHONIOENCODING", "ascii"), ("LC_ALL", "ja_JP.eucJP"), ("LC_ALL", "C"), ("CDPATH", "/"), ("GREP_OPTIONS", "--colour=always"),
                            ("CXXFLAGS", "--nothing"), ("CMAKE_GENERATOR", "Unix Makefiles"), ("CMAKE_TOOLCHAIN_FILE", "/nowhere"), ("NINJA_STATUS", "x"),
                            ("VK_INSTANCE_LAYERS", "VK_LAYER_NOTHING"), ("MESA_DEBUG", "1"), ("MALLOC_CHECK_", "3")):
            shutil.rmtree(self.root / "build", ignore_errors=True)
            with self.subTest(name):
                printed = self.course("check", code=1, **{name: value})
                self.assertEqual([line for line in printed.splitlines() if not line.startswith(("building", "checking", "configuring"))],
                                 [line for line in before.splitlines() if not line.startswith(("building", "checking", "configuring"))])

    def test_a_copy_without_the_history(self):
        self.assertIn("one.cpp is the starter\n", self.course("reset", "01.one"))
        self.put(ONE, "mine")
        self.assertIn("neither tests/starters.zip nor git's history has it; a new copy of the course does\n", self.course("reset", "01.one", code=1))
        self.assertEqual(self.course("release", code=2), "course: a release is of a commit, and there is no git history here\n")

    def test_who_has_no_home_has_one_in_the_build(self):
        """Else ccache ends each compilation, and matplotlib each chart."""
        self.put("compile", "echo $HOME >$0.home\n")
        for home in ("/nonexistent", str(self.outside)):
            self.put(ONE, home)
            self.course("check", "01", code=None, HOME=home)
            self.assertEqual((self.root / "compile.home").read_text().strip(), home if home == str(self.outside) else f"{self.root}/build/home")

    def test_the_first_python_in_path_is_not_asked(self):
        bad = self.outside / "bad"
        write(bad / "python3", "#!/bin/sh\nexit 127\n")
        shutil.rmtree(self.root / "build", ignore_errors=True)
        self.assertIn("open  01.one", self.course("check", code=1, PATH=f"{bad}:{os.environ['PATH']}"))

    def test_a_tree_from_the_future_is_said_at_once(self):
        self.course("check", code=1)
        file = self.root / "CMakeLists.txt"
        at = file.stat()
        self.addCleanup(os.utime, file, (at.st_atime, at.st_mtime))
        os.utime(file, (time.time() + 9 * 3600,) * 2)
        start_s = time.monotonic()
        printed = self.course("check", code=1)
        self.assertRegex(printed, r"\Acourse: CMakeLists.txt is from the future, by 9.0 h, .* type find .* -exec touch \{\} \+\n\Z")
        self.assertLess(time.monotonic() - start_s, 10)
        subprocess.run(printed.partition(" type ")[2], shell=True, check=True)  # the way out works
        self.assertIn("open  01.one", self.course("check", code=1))

    def test_output_that_cannot_be_written(self):
        for words in ("--help", "check", "run --help", "doctor"):
            closed = subprocess.run(f"exec {self.root}/course {words} >&-", shell=True, text=True, env=clean_environment(), stderr=subprocess.PIPE)
            full = subprocess.run(f"exec {self.root}/course {words} >/dev/full", shell=True, text=True, env=clean_environment(), stderr=subprocess.PIPE)
            with self.subTest(words):
                self.assertEqual((closed.returncode, closed.stderr), (1, "course: standard output is closed\n"))
                self.assertEqual(full.returncode, 1, full.stderr)
                self.assertNotIn("Traceback", full.stderr)
                self.assertIn("No space left on device", full.stderr)

    def test_a_display_that_is_gone_is_none(self):
        for variables in ({"DISPLAY": ":93"}, {"DISPLAY": "localhost:93.0"}, {"WAYLAND_DISPLAY": "wayland-93", "XDG_RUNTIME_DIR": str(self.outside)},
                          {"DISPLAY": ":93", "WAYLAND_DISPLAY": "wayland-93", "XDG_RUNTIME_DIR": str(self.outside)}):
            with self.subTest(str(variables)):
                printed = self.course("run", **variables)
                self.assertIn("nobody answers at ", printed)
                self.assertIn("build/gallery/index.html", printed)
                self.assertNotIn("./course run draws", printed)

    def test_progress_fits_the_terminal(self):
        from progress import Progress

        class Terminal(io.StringIO):
            def isatty(self):
                return True
        for columns in (40, 80, 200):
            self.addCleanup(os.environ.pop, "COLUMNS", None)
            os.environ["COLUMNS"] = str(columns)
            to = Terminal()
            Progress("building", to).show(3, 10, "x" * 300)
            self.assertEqual(len(to.getvalue().removeprefix("\r").removesuffix("\033[K")), columns - 1)
        with mock.patch.dict(os.environ, TERM="dumb"):  # an editor's shell
            to = Terminal()
            Progress("building", to).show(3, 10, "one.cpp")
            self.assertEqual(to.getvalue(), "building 3/10 one.cpp\n")


class Control(Course):
    def test_no_verdict_where_the_reference_has_none(self):
        kept = self.root / "build/live/verdicts.json"
        for answer in ("my answer", "right", "die"):
            for reference in ("die", "open"):
                with self.subTest(answer=answer, reference=reference):
                    kept.unlink(missing_ok=True)
                    self.put(ONE, answer)
                    self.put("chapters/01_obj/solution/one.cpp", reference)
                    printed = self.course("check", "01", code=3)
                    self.assertRegex(printed, "course: this machine cannot judge 01.one: its reference does not pass: ")
                    self.assertNotRegex(printed, "(ok  |open)  01.one")
                    self.assertFalse(kept.exists() and "01.one" in kept.read_text())
        self.put("chapters/01_obj/solution/one.cpp", "right")
        self.put(ONE, "die")  # of itself, while the reference is well
        self.assertRegex(self.course("check", "01", code=1), r"open  01\.one .*\n.* ended by signal 6")
        self.assertIn("01.one", kept.read_text())

    def test_no_picture_is_wrong_where_the_reference_has_none(self):
        kept = self.root / "build/live/verdicts.json"
        kept.unlink(missing_ok=True)
        self.put(ONE, "right")
        self.put("starter_is_right")
        self.put("crash")  # as where the disc is full
        self.assertIn("cannot judge 01.one: there is no picture of bunny to compare with: 01_obj ended with 1: mesh.frag:3",
                      self.course("check", "01", code=3))
        self.assertFalse(kept.exists() and "01.one" in kept.read_text())
        (self.root / "crash").unlink()
        self.put("crash.once")  # from outside
        self.assertIn("ok    01.one", self.course("check", "01"))
        self.put("crash.mine")
        self.assertRegex(self.course("check", "01", code=1), r"open  01\.one .*\n      01_obj ended with 1: mesh\.frag:3")

    def test_a_program_that_cannot_be_started_judges_nobody(self):
        self.course("check", "01", code=1)
        program = self.root / "build/tests/check_01_obj"
        program.chmod(0o644)
        self.addCleanup(program.chmod, 0o755)
        self.assertIn("this machine cannot judge: build/tests/check_01_obj: Permission denied", self.course("check", "01", code=3))


class Compilers(unittest.TestCase):
    """common/course/build/compile_exercise.sh, with compilers that the machine ends."""

    def compiled(self, compiler: str, source: str = "int a;"):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="a course of mine, é ")))
        write(folder / "cc", compiler)
        (folder / "one.cpp").write_text(source)
        self.made = folder / "one.o"
        script = Path(__file__).resolve().parents[2] / "common/course/build/compile_exercise.sh"
        done = subprocess.run(["sh", script, folder / "cc", "-o", folder / "one.o", "-c", folder / "one.cpp"], cwd=folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return done, {path.suffix for path in folder.glob("one.o.*")}

    def test_a_compiler_that_was_ended_is_the_machines(self):
        ended = "case \"$*\" in *empty*) exit 0 ;; esac\n"
        for says, left in (("c++: fatal error: Killed signal terminated program cc1plus", ".ended"), ("", ".ended"),
                           ("virtual memory exhausted: Cannot allocate memory", ".ended"), ("one.cpp:1:5: error: expected ';'", ".error"),
                           ("one.cpp:1:10: fatal error: nothing.h: No such file or directory", ".error")):
            with self.subTest(says):
                done, found = self.compiled(f"#!/bin/sh\n{ended}echo \"{says}\"\nexit 1\n")
                self.assertEqual((done.returncode, found & {".ended", ".error"}), (0, {left}), done.stdout)
        # Once: it is tried again.
        done, found = self.compiled("#!/bin/sh\n[ -e tried ] && exit 0\ntouch tried\necho Killed\nexit 1\n")
        self.assertEqual((done.returncode, found & {".ended", ".error"}), (0, set()), done.stdout)

    def test_a_file_that_does_not_compile_becomes_an_empty_object(self):
        for source, said, is_there in (("int f() { int unused; return 1; }", "unused", True), ("int f() { return }", "one.cpp:1:18: error", False),
                                       ("int f() { return 1; }", "", True)):
            done, found = self.compiled('#!/bin/sh\nexec c++ -Wall "$@"\n', source)
            self.assertEqual((said in done.stdout, ".error" in found), (True, not is_there), done.stdout)
            self.assertEqual(b"1fv" in self.made.read_bytes(), is_there)

    def test_the_compiler_speaks_english(self):
        done, _ = self.compiled("#!/bin/sh\necho \"one.cpp:1:1: error: $LC_ALL\"\ncase \"$*\" in *empty*) exit 0 ;; esac\nexit 1\n")
        self.assertIn("error: C", done.stdout)
