"""Tests of texts in ./course grade: names, cells of a table, macros, and error messages."""

import contextlib
import os
import re
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

from folder_case import FolderCase
from graded_class import OF, PLACES, REAL, right, why_not
from grading import sandbox
from grading.alike import added, alike, runs_of
from check.check import note_what_grading_refuses
from check.glsl_answer import Refused, macros_of_checks, plain
from grading.grade import groups, table, write_files
from grading.judge import Judge, Turns
from grading.judge_picture import EXPECTED, THEIRS, DriverEnded, Pictures, ToolFailed
from grading.submission import cell, find, printable
from tree import PYTHON, ROOT, Failure, UsageError

# A user namespace in which there can be no other, and root without the right to make namespaces.
CLOSED = ("unshare", "--map-root-user", "sh", "-c", 'echo 0 >/proc/sys/user/max_user_namespaces && exec "$@"', "")
BARE = ("setpriv", "--bounding-set=-sys_admin", "--inh-caps=-sys_admin")
LAMBERT, PARALLAX = PLACES["02.lambert"], "04.parallax_occlusion"
# An exercise, GLSL in its file, and a word of why it is refused.
REACHES = [
    *[("02.lambert", f"#define {name} 1", name) for name in (
        "probe_outputs", "case_index", "main", "gl_WorkGroupID", "put", "LIGHTS_METHOD")],
    # The preprocessor is asked for names of one's own alone.
    *[("02.lambert", f"{text}\n1\n#endif\n", "defines") for text in (
        "#ifdef pow", "#ifndef sqrt", "#if defined(min)", "#define MY_A normalize\n#if MY_A == 0",
        "#define MY_A MY_B\n#define MY_B clamp\n#if MY_A", "#if 0\n#elif defined max", "int a = __LINE__;", "int a = __VERSION__;",
        "#ifdef GL_EXT_scalar_block_layout", "#ifdef VULKAN", "#ifdef METHOD")],
    ("02.lambert", "float lambert() { check_texels_read = 0; return 1.0; }", "check_texels_read"),
    ("02.lambert", '#include "02_lambert_phong/phong.glsl"', "an exercise that the starter does not build on"),
    ("02.lambert", '#include "common/../02_lambert_phong/solution/lambert.glsl"', "a path below shaders/"),
    ("11.quintic_noise", '#include "11_fractals/solution/noise_derivative.glsl"', "no file of that name"),
    ("11.quintic_noise", '#include "11_fractals/noise_derivative.glsl"', "11.noise_derivative"),
    ("02.lambert", "// \\\n/*\n#define main other\n// */", "a name that others use"),
    ("02.lambert", "#define JOIN(a, b) a##b", "no # within a line"), ("02.lambert", "int n = probe_inputs.length();", "the checks' own"),
    ("02.lambert", "float n = undefined_what;", "the checks' own"), ("06.accumulate_lights", "check_asked[0] = 0u;", "the checks' own"),
    ("02.lambert", "layout(set = 0, binding = 1) buffer Mine { float all[]; } mine;", "that its starter"),
    ("02.lambert", "layout(local_size_x = 1024) in;", "that its starter"),
    ("02.lambert", "#extension GL_EXT_buffer_reference : require", "no exercise needs #extension"),
    ("02.lambert", '#line 1 "/etc/passwd"', "no exercise needs #line"), ("02.lambert", "/* ", "a comment does not end"),
    ("02.lambert", '#error "\\u000a honest 99/99"', "error"),
    ("06.accumulate_lights", "#undef light_reaches_cell", "a name that others use"),
    ("08.blur_line", "#undef barrier", "a name that others use"),
    ("13.propagate_distance", "#ifdef KNOWN_DISTANCES", "by which shaders know"),
    ("08.down_filter", "int n = IMPULSE_X;", "by which shaders know"),
    ("09.histogram_bin", "uint n = picture_bins[0];", "names picture_bins"),
]


class Words(unittest.TestCase):
    def test_names_are_one_printable_word(self):
        self.assertEqual(printable("a\nb\x1b\u202e\udcff"), r"a\u000ab\u001b\u202e\xff")
        self.assertEqual(len(printable("x" * 1000)), 200)
        for text, meant in (("ann", "ann"), ("a=b-c", "a=b-c"), ("=1", "'=1"), ("@x", "'@x"), ("-1", "'-1"), (" =1", " '=1"),
                            ("a;=cmd", "a;'=cmd"), ("a; +1", "a; '+1"), ("\uff1d1", "'\uff1d1"), ("\uff0b1", "'\uff0b1"),
                            ("\u00a0\uff201", "\u00a0'\uff201"), ("a,\ufe63", "a,'\ufe63"), ("\u22121", "'\u22121"),
                            ('"=1', "\"'=1")):
            self.assertEqual(cell(text), meant)

    def test_gradings_that_begin_at_once_have_one_seed(self):
        with tempfile.TemporaryDirectory() as folder:
            judge = Judge.__new__(Judge)
            judge.folder = Path(folder)

            def draws_after_another(_):
                Path(folder, "seed").write_text("5\n")
                return 8

            with mock.patch("grading.judge.secrets.randbelow", draws_after_another):
                self.assertEqual(judge.draw_seed(), 5)
            self.assertEqual([path.name for path in Path(folder).iterdir()], ["seed"])

    def test_what_is_no_class_is_one_line(self):
        for path, words in (("/dev/null", "neither a folder nor an archive"), ("/no/such", "no such file"),
                            ("x" * 300, "too long"), ("a\0b", "no such file")):
            with self.assertRaisesRegex(UsageError, words):
                find([Path(path)])

    def test_names_of_checks_files_are_nobodys_macros(self):
        """Each name in tests/*/*.glsl, of variables too."""
        for shader in sorted((REAL / "tests").glob("*/*.glsl")):
            for name in sorted(set(re.findall(r"^\s*(?:int|float|vec\d)\s+(\w+)", shader.read_text(), re.M)))[:3]:
                with self.subTest(f"{shader.name}: {name}"), self.assertRaisesRegex(Refused, name):
                    plain(f"#define {name} 0".encode(), REAL / LAMBERT)

    def test_what_reaches_for_others_is_refused(self):
        for exercise, text, words in REACHES:
            with self.subTest(text), self.assertRaisesRegex(Refused, words):
                plain(text.encode(), REAL / PLACES[exercise])

    def test_what_is_right_is_not_refused(self):
        for exercise, chapter in OF.items():
            if (place := REAL / PLACES[exercise]).suffix == ".glsl":
                for text in (right(exercise), place.read_text(), right(exercise).replace("\n", "\r\n")):
                    self.assertEqual(len(plain(text.encode(), place).split("\n")), text.count("\n") + 1)
        for text in ("#define MY_OWN 1\nfloat lambert() {}", "#define MINE 2\n#if MINE > 1\n#endif", "#define MINE\n#ifdef MINE\n#endif",
                     "#define MY_A 1\n#define MY_B MY_A\n#if MY_B && defined(MY_A)\n#endif", "#if 0\n#endif"):
            self.assertEqual(plain(text.encode(), REAL / LAMBERT), text)
        for name in ("KNOWN_DISTANCES", "CHECK_KNOWN_AIR", "MOST_READS", "FIELD_WIDTH"):
            self.assertIn(name, macros_of_checks())

    def test_plain_is_what_the_compiler_reads(self):
        path = REAL / LAMBERT
        for text, meant in (("a /* b\n */ c", "a  \n c"), ("a // b\nc", "a \nc"), ("a // b \\\nc\nd", "a \n\nd"),
                            ("a\\\r\nb", "ab\n"), ("a\rb\r\nc", "a\nb\nc"), ("// /*\nb // */", "\nb "),
                            ("/* // */ b", "  b"), ('/* " */ b // "', "  b "), ("a\f\x0bb", "a  b")):
            self.assertEqual(plain(text.encode(), path), meant)
        for text in ("a \0 b", "float \u00e9;", 'a "b"', "a # b", "a \\\\\n\nb", "a \\ b", "#\\\nline 1", "/*", "#extension a : b"):
            with self.assertRaises(Refused, msg=text):
                plain(text.encode(), path)

    def test_a_megabyte_of_anything_is_read_in_a_second(self):
        for data in (b"\n", b"\r", b'"\\"', b"/*/", b"\\\n", b"# ", b"#define a\n", b" ", b"set= ", b'#include "', b"\t\n", b"{", b'"', b"a",
                     b"1.", b"// \n", b"\\", b"('"):
            text = data * ((1 << 20) // len(data))
            start_s = time.process_time()
            with contextlib.suppress(Refused):
                plain(text, REAL / LAMBERT)
            runs_of(text)
            added(text, b"")
            self.assertLess(time.process_time() - start_s, 5, data)  # 0.5 s; two minutes where it grows as the square

    def test_a_student_is_told_beforehand(self):
        result, path = {"note": "first"}, Path(self.enterContext(tempfile.TemporaryDirectory())) / "lambert.glsl"
        path.write_text(right("02.lambert"))
        note_what_grading_refuses(path, result)
        self.assertEqual(result["note"], "first")
        path.write_text("#extension all : warn\n" + right("02.lambert"))
        note_what_grading_refuses(path, result)
        self.assertRegex(result["note"], "first; handed in like this it would be refused: .*#extension")

    def test_alike(self):
        starters = {"01.a": b"int f() {\n    return 0;\n}\n"}
        long = b"int f() {\n" + b"".join(b"    x%d = y[%d] + %d;\n" % (i, i, i) for i in range(60)) + b"}\n"
        renamed = long.replace(b"    x7 = y", b"    z7 = y") + b"// mine\n"
        short = b"int f() {\n    return 1;\n}\n"
        other = long.replace(b"y", b"w")
        found = alike({"ann": {"01.a": long}, "ben": {"01.a": long}, "cat": {"01.a": renamed}, "dan": {"01.a": short},
                       "eve": {"01.a": short}, "fay": {"01.a": other}}, starters)
        self.assertEqual({(a, b): what for a, b, what in found},
                         {("ann", "ben"): "all that they added is the same",
                          ("ann", "cat"): "all that they added is the same to 98 %",
                          ("ben", "cat"): "all that they added is the same to 98 %"})

    def test_who_is_alike_is_said_once(self):
        def one(student, *others):
            return {"student": student, "alike": [{"student": other, "what": "all"} for other in others]}
        found = groups([one("a", "b"), one("b", "a"), one("c"), one("d", "e", "f"), one("e", "d"), one("f", "d")])
        self.assertEqual(found, ["a, b: all", "d, e, f: grades.json says what"])

    def judge_of(self, *verdicts, **more):
        """A judge with these verdicts, one after the other."""
        judge = Judge.__new__(Judge)
        judge.wanted, judge.starters, judge.versions = {"02.lambert": "02"}, {"02.lambert": b""}, {"02": "1"}
        judge.verdicts, judge.fresh = Path(self.enterContext(tempfile.TemporaryDirectory())), frozenset()
        judge.stopped, judge.budget_s, judge.spent, judge.lock = False, 600, {}, threading.Lock()
        judge.turns, judge.controlled = Turns(), {"02.lambert": [threading.Lock(), False]}
        judge.reference, judge.reference_is_right = lambda _: b"reference", lambda _: True
        judge.judge = mock.Mock(side_effect=lambda _, data, **__: self.said(judge, data))
        judge.said = {b"reference": [{"ok": True, "passed": 1, "failed": 0}], b"": [{"ok": False, "first_failure": "x"}], b"x": list(verdicts)} | more
        self.enterContext(mock.patch("grading.judge.TRIES_S", (0, 0, 0)))
        return judge

    @staticmethod
    def said(judge, data):
        verdicts = judge.said[data]
        found = verdicts.pop(0) if len(verdicts) > 1 else verdicts[0]
        if isinstance(found, Exception):
            raise found
        return dict(found)

    RIGHT, WRONG = {"ok": True, "passed": 1, "failed": 0}, {"ok": False, "first_failure": "f(1) gave 2", "passed": 0, "failed": 1}
    ENDED = WRONG | {"suspect": "ended", "first_failure": "it ended"}

    def test_what_goes_wrong_with_one_answer_is_that_ones(self):
        """For any failure: the grading of the others goes on, and somebody looks at this one."""
        found = self.judge_of(RecursionError("too deep")).verdict("02.lambert", b"x")
        self.assertEqual((found["state"], found["ok"]), ("undecided", False))
        self.assertIn("too deep", found["first_failure"])

    def test_a_full_disc_costs_a_page_its_pictures_and_no_verdict(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        for name in (THEIRS, EXPECTED):
            (folder / name).write_bytes(b"a picture")
        for place, kept in ((Path("/proc/none"), set()), (folder, {"picture", "picture_expected"})):
            with mock.patch("grading.judge.KEPT", place):
                self.assertEqual(set(Judge.keep_pictures(None, folder)), kept)

    def test_no_verdict_without_a_control(self):
        """Where the reference does not pass, the starter passes or reaches no verdict, or either no longer does after a process
        has ended: nothing is given, and nothing kept."""
        full = OSError(28, "No space left on device")
        for verdict in (self.RIGHT, self.WRONG, self.ENDED):
            for control in ({b"reference": [self.WRONG]}, {b"reference": [self.ENDED]}, {b"reference": [full]}, {b"": [self.RIGHT]},
                            {b"": [self.ENDED]}, {b"": [full]}):
                with self.subTest(f"{verdict} {control}"):
                    judge = self.judge_of(verdict)
                    judge.said |= control
                    found = judge.verdict("02.lambert", b"x")
                    self.assertEqual(found["state"], "failed", found)
                    self.assertRegex(found["first_failure"], "^this machine cannot judge 02.lambert: its (reference|starter)")
                    self.assertEqual(list(judge.verdicts.iterdir()), [])
        judge = self.judge_of(self.ENDED)
        judge.said[b"reference"] = [self.RIGHT, self.ENDED]
        self.assertEqual((judge.verdict("02.lambert", b"x")["state"], list(judge.verdicts.iterdir())), ("failed", []))

    def test_what_ended_is_judged_once_more_alone(self):
        judge = self.judge_of(self.ENDED, self.RIGHT)
        self.assertTrue(judge.verdict("02.lambert", b"x")["ok"])
        judge = self.judge_of(self.ENDED)  # and again, while the control is well: its own fault
        found = judge.verdict("02.lambert", b"x")
        self.assertEqual((found["state"], found["first_failure"], len(list(judge.verdicts.iterdir()))), ("judged", "it ended", 1))
        judge = self.judge_of(self.ENDED | {"killed": True})  # perhaps from outside: somebody looks, and it is not kept
        found = judge.verdict("02.lambert", b"x")
        self.assertEqual((found["state"], "killed" in found, list(judge.verdicts.iterdir())), ("undecided", False, []))

    def test_a_control_is_run_once(self):
        judge = self.judge_of(self.WRONG)
        for data in (b"x", b"y"):
            judge.said[data] = [self.WRONG]
            judge.verdict("02.lambert", data)
        self.assertEqual([call.args[1] for call in judge.judge.call_args_list], [b"reference", b"", b"x", b"y"])

    def test_what_was_late_or_ended_is_suspect(self):
        judge = Judge.__new__(Judge)
        judge.call_s, judge.judge_mounts = 5, lambda *_: None
        for done, killed in ((sandbox.Done(137, "", True, False), False), (sandbox.Done(137, "", False, False), True),
                             (sandbox.Done(137, "", False, False, True), False), (sandbox.Done(139, "", False, False), False)):
            judge.started = lambda *_, done=done, **__: contextlib.nullcontext(mock.Mock(finish=lambda: done))
            found = judge.decide("02.lambert", 0, None)
            self.assertEqual((found["ok"], "suspect" in found, "killed" in found), (False, True, killed), found)


class NoSandbox(FolderCase):
    """Where nothing can be contained nothing is judged or built, the exit code is the machine's, and earlier grades stay."""

    def assert_refused(self, says: str, *wrapper, **environment):
        self.write("class/ann/empty", "")
        grades = self.write("grades/grades.json", '["mine"]')
        done = subprocess.run([*wrapper, *PYTHON, REAL / "common/course/cli.py", "grade", self.folder / "class", "--out", grades.parent],
                              env=os.environ | environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertRegex(done.stdout, rf"\Acourse: [^\n]*{says}\n\Z")
        self.assertEqual(grades.read_text(), '["mine"]')

    def test_no_bubblewrap(self):
        self.assert_refused("bubblewrap alone, and it is not there: as root, apt-get install bubblewrap", PATH="/nowhere")
        self.assertIn("bubblewrap", (REAL / "common/course/packages/grade").read_text().split())

    @unittest.skipIf(subprocess.run([*CLOSED, "true"], stderr=subprocess.DEVNULL).returncode, "no user namespace can be made here")
    def test_no_user_namespaces(self):
        self.assert_refused(r"cannot contain anything here.*namespace.*; as root, type: sysctl user\.max_user_namespaces=10000", *CLOSED)

    @unittest.skipIf(subprocess.run([*BARE, "true"], stderr=subprocess.DEVNULL).returncode, "only root has rights to give up")
    def test_root_of_a_container_without_privileges(self):
        self.assert_refused("cannot contain anything here.*; a container that was started with --privileged allows it", *BARE)


@unittest.skipIf(why_not(), why_not())
class Crash(FolderCase):
    """A driver that crashes with a shader with correct numbers: its own fault or the student's purpose, so the grader is told, and
    there is no mark until then."""

    def drawn(self, codes, name: str) -> str | None:
        """Pictures' verdict on a source for which drawing one shot after the other ended so."""
        pictures = Pictures.__new__(Pictures)
        pictures.wanted, pictures.link = {PARALLAX: "04_surface_maps"}, lambda *_: ""
        shots = [(shot, self.folder / f"{shot}.png") for shot in ("relief", "wall")]
        pictures.references, pictures.drawing_mounts = lambda _: shots[:len(codes)], lambda *_: None
        ends = iter(codes)
        running = mock.Mock(finish=lambda: sandbox.Done(next(ends), "", False, False))
        judge = mock.Mock(started=lambda *_, **__: contextlib.nullcontext(running))
        with tempfile.TemporaryDirectory(dir=self.folder) as folder:
            return pictures.wrong(PARALLAX, Path(folder) / name, judge)

    def test_which_end_is_the_drivers(self):
        with self.assertRaisesRegex(DriverEnded, "relief, wall"):
            self.drawn((139, 139), "a.glsl")
        for code, name in ((1, "a.glsl"), (134, "a.glsl"), (139, "a.cpp")):  # C++ of a student's crashes by itself
            with self.assertRaisesRegex(ToolFailed, f"the program that draws it ended with {code}"):
                self.drawn((code,), name)
        # One picture without a crash is enough to judge by.
        with self.assertRaisesRegex(ToolFailed, "ended with 1"):
            self.drawn((139, 1), "a.glsl")
        self.assertIsNone(self.drawn((), "a.glsl"))

    def test_the_students_object_is_linked_last(self):
        """Its toggles have no references. Before those of the chapter they would be used, and the chapter's other exercises
        would be starters in its picture."""
        place = "chapters/17_planets/exercise/camera_relative.cpp"
        pictures = Pictures.__new__(Pictures)
        pictures.wanted = {"17.camera_relative": "17_planets"}
        pictures.links = {"17_planets": ["c++", "main.o", f"CMakeFiles/e.dir/./{place}.o", "-o", "program", "libchapter.a"]}
        judge = mock.Mock(paths={"17.camera_relative": ROOT / place})
        judge.started.return_value = contextlib.nullcontext(mock.Mock(finish=lambda: sandbox.Done(0, "", False, False)))
        pictures.link("17.camera_relative", self.folder, judge)
        words = judge.started.call_args.args[0][-1].split()
        self.assertEqual(words[-6:], ["c++", "main.o", "-o", "/grade/program", "libchapter.a", "/grade/student.o"])

    def test_there_is_no_mark_and_it_is_said(self):
        judge = Judge.__new__(Judge)
        judge.paths, judge.seed = {PARALLAX: Path("04_surface_maps/exercise/a.glsl")}, 0
        judge.numbers = lambda *_: {"ok": True, "passed": 7, "failed": 0}
        judge.pictures = mock.Mock(wrong=mock.Mock(side_effect=DriverEnded("relief")))
        found = judge.judge(PARALLAX, b"")
        self.assertEqual((found["ok"], found["state"], found["passed"]), (False, "undecided", 7))
        result = {"exercise": PARALLAX, "chapter": "04_surface_maps", **found}
        grades = [{"student": "ann", "error": None, "right": 0, "of": 1, "alike": [], "results": [result]}]
        self.assertRegex("\n".join(table(grades, ["04_surface_maps"])),
                         r"look at: ann, 04\.parallax_occlusion, which has no mark yet: its numbers are right, .* relief")
        write_files(self.folder, grades, {PARALLAX: "04_surface_maps"})
        self.assertIn('"ann","0","1","?"', (self.folder / "grades.csv").read_text())

    def test_it_is_said_of_a_verdict_that_was_kept(self):
        with Judge({"02.lambert": "02_lambert_phong"}, 2, False) as judge:
            judge.verdicts = self.folder
            judge.pictures = mock.Mock(wrong=mock.Mock(side_effect=DriverEnded("bunny")))
            states = {judge.verdict("02.lambert", right("02.lambert").encode() + b"// crash")["state"] for _ in range(2)}
        self.assertEqual(states, {"undecided"})


@unittest.skipIf(why_not(), why_not())
class Contained(unittest.TestCase):
    def test_nobody_is_root_and_nothing_outlives_it(self):
        """Seen from outside, with the kernel's user numbers."""
        running = sandbox.Running(["/bin/sleep", "60"], sandbox.Mounts(), sandbox.Limits(1 << 30, 60))
        first = Path(f"/proc/{running.first}")
        self.addCleanup(running.close)
        while first.joinpath("cmdline").read_bytes() != b"/bin/sleep\x0060\0":  # on its way there
            time.sleep(0.01)
        users = re.search(r"^Uid:\s*(.*)$", (first / "status").read_text(), re.M)[1].split()
        self.assertNotIn("0", users)
        self.assertRegex((first / "status").read_text(), r"CapEff:\s*0+\n")
        running.close()
        for _ in range(500):
            if not first.exists() or (first / "cmdline").read_bytes() == b"":
                return
            time.sleep(0.01)
        self.fail("it lives")

    def test_time_is_the_processors_or_a_share_of_the_clocks(self):
        """An answer that sleeps is charged, and one that waits for a processor hardly. Of the two limits the kernel knows, the first
        process of a world heeds the hard one alone, which is 3 s beyond: on a busy machine the clock ends it before."""
        for script, least_s, most_s in (("while True: pass", 1.5, 5.5), ("import time; time.sleep(4)", 0.9, 3)):
            running = sandbox.Running(["/usr/bin/python3", "-c", script], sandbox.Mounts(), sandbox.Limits(1 << 30, 2))
            done = running.finish()
            self.assertTrue(least_s < running.seconds < most_s, (script, done, running.seconds))

    def test_what_root_alone_can_read_is_said(self):
        path = Path(self.enterContext(tempfile.TemporaryDirectory())) / "library"
        path.touch(0o600)
        with mock.patch("grading.sandbox.drops_root", lambda: True), self.assertRaisesRegex(Failure, "chmod -R o.rX"):
            sandbox.require_readable([path])
        with mock.patch("grading.sandbox.drops_root", lambda: False):
            sandbox.require_readable([path])

    def test_who_is_mapped(self):
        self.assertTrue(sandbox.is_mapped(65534, "         0          0 4294967295\n"))
        self.assertFalse(sandbox.is_mapped(65534, "         0       1000          1\n"))
