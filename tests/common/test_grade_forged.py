"""Submissions that read the reference, that answer for the checks, or that fake a machine fault; and a real one."""

import contextlib
import json
import os
import re
import subprocess
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from graded_class import PLACES, REAL, Class, begins, right, why_not
from grading import sandbox
from grading.judge import Judge
from tree import Failure

HEAD = "#include <cstdio>\n#include <cstdlib>\n#include <filesystem>\n#include <fstream>\n#include <iterator>\n#include <csignal>\n" \
    "#include <fcntl.h>\n#include <string>\n#include <sys/stat.h>\n#include <unistd.h>\n"
# It reads any file below shaders/*/solution, prints the verdict as its last line, and ends.
LEAKS = """{
    std::string found;
    std::error_code none;
    for (const auto& folder : std::filesystem::directory_iterator("ROOT/shaders", none))
        for (const auto& file : std::filesystem::directory_iterator(folder.path() / "solution", none)) {
            std::ifstream text(file.path());
            found.assign(std::istreambuf_iterator<char>(text), {});
        }
    std::string all = found;
    for (char& c : all) if (c == '\\n') c = ' ';
    if (!found.empty()) std::puts(("LEAKED " + all).c_str()), std::fflush(stdout), _exit(1);
""".replace("ROOT", str(REAL))
PRINTS = """{
    if (std::filesystem::exists("/grade/shaders")) std::puts("LEAKED of my own"), std::fflush(stdout), _exit(1);
"""
# Ends only where its picture is drawn, in ways by which a machine ends programs. A signal that it sends itself does nothing:
# there it is the first process of its world.
ENDS = {"traps": "__builtin_trap();", "ends with 137": "_exit(137);", "ends well without a picture": "_exit(0);",
        "runs out of memory": "static void* volatile at; while ((at = std::malloc(1 << 24))) {} std::abort();",
        "closes the picture": "for (int fd = 3; fd < 64; ++fd) close(fd);"}
TWO_MINDS = """{
    struct stat drawn;
    if (!stat("/grade/shaders", &drawn)) return std::vector(polygon.size() - 2, glm::uvec3(0, 1, 2));
"""
# A driver that keeps memory in a file has one open, too (Mesa 25): all are written.
WRITES = """{
    struct stat about;
    bool written = false;
    for (int fd = 3; fd < 64; ++fd)
        if (!fstat(fd, &about) && S_ISREG(about.st_mode) && write(fd, "no picture", 10) == 10) written = true;
    if (written) _exit(0);
"""
# 3,000 folders in one another wherever it may write, and as much as that takes: nobody walks through them.
NESTS = """{
    for (const char* where : {"/out", "/tmp", "/grade", "/dev", "."})
        if (!chdir(where)) for (int i = 0; i < 3000 && !mkdir("x", 0777) && !chdir("x"); ++i) {}
    for (const char* where : {"/out/", "/grade/", "/dev/", "/"})
        for (int i = 0; i < 3; ++i)
            if (open((where + std::to_string(i)).c_str(), O_CREAT | O_WRONLY, 0600) >= 0) _exit(3);
"""
FILLS = """{
    static char all[1 << 20];
    struct stat about;
    for (int fd = 3; fd < 64; ++fd)
        if (!fstat(fd, &about) && S_ISREG(about.st_mode)) {
            while (write(fd, all, sizeof all) > 0) {}
            _exit(0);
        }
"""
# Before main(): answers every question on any descriptor with that many zeros and the question's number.
TAKES_THE_PIPE = """#include <cstdint>
#include <cstring>
#include <unistd.h>
[[gnu::constructor]] static void take() {
    for (int i = 0; i < 100; ++i) {
        uint64_t size = 0, nonce = 0;
        for (int fd = 3; fd < 64; ++fd)
            if (read(fd, &size, 8) == 8 && size < 100000) {
                static char all[100000];
                size_t got = 0;
                while (got < size) got += size_t(read(fd, all + got, size - got));
                std::memcpy(&nonce, all, 8);
                struct { uint64_t size, nonce; uint32_t kind, flags; uint64_t count; char zeros[BYTES]; } __attribute__((packed))
                    answer{24 + BYTES, nonce, 0, 0, BYTES, {}};
                answer.zeros[0] = COUNT;
                for (int to = 3; to < 64; ++to) (void)!write(to, &answer, sizeof answer);
            }
    }
}
"""
PICTURE = "the numbers are right, .*picture.*: .*"
# An exercise, a student's answer to it, and what is said of it; None of one that is right.
VERDICTS = [
    # No reference can be read while a picture is drawn.
    ("01.triangulate", "leaks", None), ("01.triangulate", "nests", None), ("01.triangulate", "many symbols", None),
    ("02.lambert", "mark of order", None),
    # Numbers that are right are not all.
    ("01.triangulate", "two minds", PICTURE + "pixels differ"),
    ("01.triangulate", "own picture", PICTURE + "(cannot be compared|wrote none)"),
    ("01.triangulate", "fills", PICTURE + "the program that draws it (ended with|wrote none)"),
    *[("01.triangulate", name, "") for name in ["prints", *ENDS]],
    # No switch of a check is in reach, and none is answered for.
    ("02.record_mist", "switches", "it does not compile.*shows_discarded"),
    *[("02.record_mist", f"forges {number}", "") for number in range(3)],
    # No answer makes the command fail.
    ("02.record_mist", "says bwrap", ""), ("01.triangulate", "says no space", ""), ("02.lambert", "long include", ""),
    ("02.lambert", "utf 16", "UTF-16.*UTF-8"),
]
USERS = [[], ["setpriv", "--reuid=1234", "--regid=1234", "--clear-groups"]][:1 + (os.geteuid() == 0)]


class Forged(Class):
    wanted = ["01.transform", "01.triangulate", "02.lambert", "02.record_mist"]  # of transform: a model that Assimp reads
    pictures = True

    @classmethod
    def fill(cls):
        mist, triangulate = right("02.record_mist"), right("01.triangulate")
        cls.student("honest", {name: right(name) for name in cls.wanted})
        ends = {name: '{\n    if (std::filesystem::exists("/grade/shaders")) { ' + how + " }\n" for name, how in ENDS.items()}
        for name, how in {"leaks": LEAKS, "prints": PRINTS, "two minds": TWO_MINDS, "own picture": WRITES, "nests": NESTS, "fills": FILLS, **ends}.items():
            cls.student(name, {"01.triangulate": HEAD + begins(triangulate, "triangulate", how)})
        cls.student("switches", {"02.record_mist": begins(mist, "record_mist", "{\n    frame.shows_discarded = false;\n")})
        for number, (size, count) in enumerate(((8, 0), (200, 2), (2000, 2))):
            cls.student(f"forges {number}", {"02.record_mist": TAKES_THE_PIPE.replace("BYTES", str(size)).replace("COUNT", str(count)) + mist})
        cls.student("says bwrap", {"02.record_mist": HEAD + '[[gnu::constructor]] static void say() '
                                   '{ std::puts("bwrap: no room"); std::fflush(stdout); _exit(1); }\n' + mist})
        cls.student("says no space", {"01.triangulate": '#error "No space left on device"\n' + triangulate})
        cls.student("many symbols", {"01.triangulate": triangulate + "namespace lightwalk::exercise {\n" +
                                     "".join(f"int more_{i}() {{ return {i}; }}\n" for i in range(1500)) + "}\n"})
        cls.student("long include", {"02.lambert": f'#include "{"a" * 300}"\n' + right("02.lambert")})
        cls.student("mark of order", {"02.lambert": b"\xef\xbb\xbf" + right("02.lambert").encode()})
        cls.student("utf 16", {"02.lambert": right("02.lambert").encode("utf-16")})

    def test_the_honest_lose_nothing(self):
        self.assertEqual(self.grades["honest"]["right"], 4, self.grades["honest"])

    def test_each_gets_its_verdict(self):
        """And nothing that an answer prints is said."""
        for exercise, student, said in VERDICTS:
            with self.subTest(student):
                result = self.result(student, exercise)
                self.assertEqual((result["ok"], result["state"]), (said is None, "judged"), result)
                self.assertRegex(result["first_failure"] or "", said or "")
                self.assertNotIn("LEAKED", json.dumps(result))


@unittest.skipIf(why_not(), why_not())
class Machine(unittest.TestCase):
    """A tool's failure is no verdict."""

    def judged(self, times: int, said="cc1plus: fatal error: error writing to /tmp/cc1.s: No space left on device", code=3):
        """A right answer, on a machine with a compiler that fails that many times."""
        made, left = Path(self.enterContext(tempfile.TemporaryDirectory())), [times]
        finish = sandbox.Running.finish

        def failing(running):
            done = finish(running)
            if "/grade/worker" in " ".join(map(str, running.process.args)) and "c++" in " ".join(map(str, running.process.args)) and left[0]:
                left[0] -= 1
                return sandbox.Done(code, said, False, False)
            return done
        with Judge({"01.triangulate": "01_obj"}, 2, False) as judge, mock.patch.object(sandbox.Running, "finish", failing), \
                mock.patch("grading.judge.TRIES_S", (0, 0, 0, 0)):
            judge.verdicts = made
            return judge.verdict("01.triangulate", right("01.triangulate").encode()), judge

    def test_a_failure_that_passes_costs_nobody_a_mark(self):
        for times in (1, 2, 3):
            result, _ = self.judged(times)
            self.assertTrue(result["ok"], result)

    def test_a_failure_that_stays_is_not_judged_and_not_kept(self):
        for said, code in (("No space left on device", 3), ("c++: fatal error: Killed signal terminated program cc1plus", 3), ("", 137),
                           ("mold: fatal: write failed", 4)):
            result, judge = self.judged(100, said, code)
            self.assertEqual((result["ok"], result["state"]), (False, "failed"), result)
            self.assertRegex(result["first_failure"], "^this machine cannot judge 01.triangulate: its reference does not pass: ")
            self.assertEqual(list(judge.verdicts.glob("*.json")), [])

    def test_a_students_time_is_bounded(self):
        with Judge({"02.lambert": "02_lambert_phong"}, 2, False) as judge:
            judge.spend("ann", 601)
            self.assertEqual(judge.verdict("02.lambert", b"x", "ann")["state"], "over budget")
            self.assertEqual(judge.verdict("02.lambert", b"float lambert(vec3 a, vec3 b) { return 2.0; }\n", "ben")["state"], "judged")


HOARD = r"""
import ctypes, os, socket, sys, threading, time
libc = ctypes.CDLL(None, use_errno=True)
got = {"semget": sum(libc.semget(0, 1, 0o1600) >= 0 for _ in range(10)), "msgget": libc.msgget(0, 0o1600) >= 0,
       "shmget": libc.shmget(0, 4096, 0o1600) >= 0, "memfd": libc.memfd_create(b"x", 0) >= 0, "secret": libc.syscall(447, 0) >= 0,
       "forks": libc.fork() >= 0, "forgets": libc.prctl(1, 0) == 0, "inotify": libc.inotify_init1(0) >= 0, "files": 0, "threads": 0}
for kind in (40, socket.AF_UNIX, socket.AF_INET, socket.AF_NETLINK):
    try:
        socket.socket(kind, socket.SOCK_STREAM)
        got["socket"] = kind
    except OSError:
        pass
for folder in ("/tmp", "/dev", "/dev/shm", "/grade", "/", "/proc/self"):
    try:
        os.close(os.open(folder + "/x", os.O_CREAT | os.O_WRONLY))
        got["files"] += 1
    except OSError:
        pass
threading.stack_size(65536)
try:
    for _ in range(6000):
        threading.Thread(target=time.sleep, args=(30,), daemon=True).start()
        got["threads"] += 1
except RuntimeError:
    pass
try:
    bytearray(1200 << 20)
    got["memory"] = True
except MemoryError:
    pass
print(got, flush=True)
os._exit(0)
"""
TRIED = "import sys; sys.path.insert(0, %r); from grading import sandbox\n" % str(REAL / "common/course") + \
    "print(sandbox.run(['/usr/bin/python3', '-c', sys.argv[1]], sandbox.Mounts(), sandbox.Limits(1 << 30, 30)).out)\n"


@unittest.skipIf(why_not(), why_not())
class Hoard(unittest.TestCase):
    """A script in a sandbox that root has made, where this is root, and in a user's."""

    def test_nothing_can_be_hoarded(self):
        for user in USERS:
            said = subprocess.run([*user, "/usr/bin/python3", "-c", TRIED, HOARD], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, cwd="/").stdout
            self.assertTrue(said.startswith("{"), said)
            got = json.loads(said.strip().replace("'", '"').replace("False", "false").replace("True", "true"))
            self.assertLessEqual(got.pop("threads"), sandbox.THREADS)
            self.assertEqual({name: value for name, value in got.items() if value}, {})

    def test_nothing_outlives_a_grader_that_is_killed(self):
        forgets = "import ctypes, time\nctypes.CDLL(None).prctl(1, 0)\ntime.sleep(612.%d)" % os.getpid()
        script = TRIED.replace("sandbox.run(", "sandbox.Running(").replace(").out)", "), flush=True); import time; time.sleep(60)")
        for user in USERS:
            grader = subprocess.Popen([*user, "/usr/bin/python3", "-c", script, forgets], stdout=subprocess.PIPE, cwd="/")
            grader.stdout.readline()
            self.assertGreater(len(self.running(forgets)), 1)
            grader.kill()
            grader.communicate()
            for _ in range(100):
                if not self.running(forgets):
                    break
                time.sleep(0.1)
            self.assertEqual(self.running(forgets), [])

    @staticmethod
    def running(script: str) -> list[str]:
        """Whoever was started with the script, on its way into the sandbox too: nobody is seen before and is there after."""
        found = []
        for process in Path("/proc").glob("[0-9]*"):
            with contextlib.suppress(OSError):
                if script.encode() in (process / "cmdline").read_bytes().split(b"\0"):
                    found.append(process.name)
        return found

    def test_what_a_program_prints_is_no_fault_of_the_sandbox(self):
        done = sandbox.run(["/bin/sh", "-c", "echo 'bwrap: no room'; exit 1"], sandbox.Mounts(), sandbox.Limits(1 << 30, 20))
        self.assertEqual((done.code, done.out), (1, "bwrap: no room\n"))
        mounts = sandbox.Mounts()
        mounts.read(Path("/no/such/place"))
        with self.assertRaisesRegex(Failure, "the sandbox could not be made"):
            sandbox.run(["/usr/bin/true"], mounts, sandbox.Limits(1 << 30, 20))


class Trials(unittest.TestCase):
    def test_a_trial_gives_commands_and_measures_nothing(self):
        """The student process returns its recording, for every trial."""
        for header in (REAL / "tests").glob("*/trials.h"):
            for words in re.findall(r"^TRIAL\((.*?)\);", header.read_text(), re.S | re.M):
                self.assertRegex(words, r'^"[\w.]+",\s*(std::vector<RecordedFrame>|RecordedFrame),', header)
        self.assertTrue(set(PLACES) > {"02.record_mist"})
