"""A small course for the tests of ./course: its programs are scripts, its pictures text files.

Files at its root change their behaviour: "crash" (no picture), "crash.mine" (none of an exercise), "crash.once", "slow" (a second each), "flat" (an empty picture), "drift" (words added to each picture),
"drift.sse4.1" (to the pictures of a driver held to SSE4.1), "drift.second" (of the second driver, with the file "second" as
manifest), "starter_is_right" (a starter draws the solution's picture), "broken" (a unit test and a fuzz target fail), "no_rest" (the
whole course does not build).
"""

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

REAL = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REAL / "common/course"))

from check.starters import LIST as STARTERS, listed  # noqa: E402

CMAKE = """cmake_minimum_required(VERSION 3.25)
project(small NONE)
set(LIGHTWALK_CHAPTERS 01_obj 02_lambert)
file(COPY programs/ DESTINATION ${PROJECT_BINARY_DIR} USE_SOURCE_PERMISSIONS)
foreach(name ${LIGHTWALK_CHAPTERS})
  add_custom_target(${name})
  set(exercise ${PROJECT_SOURCE_DIR}/chapters/${name}/exercise/one.cpp)
  add_custom_command(OUTPUT check_${name}.built DEPENDS ${exercise}
    COMMAND sh ${PROJECT_SOURCE_DIR}/compile ${exercise}
    COMMAND ${CMAKE_COMMAND} -E touch check_${name}.built)
  add_custom_target(check_${name} DEPENDS check_${name}.built)
endforeach()
add_custom_target(compare)
add_custom_target(rest ALL COMMAND sh -c "! test -e ${PROJECT_SOURCE_DIR}/no_rest" VERBATIM)
add_custom_target(programs)
add_custom_target(menu)
add_custom_target(every_shader)
add_custom_target(fuzz_obj)
enable_testing()
add_test(NAME unit.common COMMAND sh -c "! test -e ${PROJECT_SOURCE_DIR}/broken")
include(tests/build.cmake)
"""
PRESETS = {"version": 4, "configurePresets": [
    {"name": "default", "generator": "Ninja", "binaryDir": "${sourceDir}/build"},
    {"name": "sanitizer", "inherits": "default", "binaryDir": "${sourceDir}/build/sanitizer"},
    {"name": "fuzz", "inherits": "default", "binaryDir": "${sourceDir}/build/fuzz"}]}
COMPILE = """! grep -q 'syntax error' $1 || { echo $1:1: error: no; exit 1; }
"""
CHAPTER = """#!PYTHON
import json, os, sys, time
name = os.path.basename(sys.argv[0])
def draw(words):
    use = words[words.index("--use") + 1] if "--use" in words else "solution"
    if os.path.exists("crash") or "exercise" in use and os.path.exists("crash.mine"):
        return "mesh.frag:3: no such function"
    if os.path.exists("slow"):
        open("slow", "a").write("x")
        time.sleep(1)
    if os.path.exists("crash.once"):
        os.unlink("crash.once")
        return "killed"
    starter = "exercise" in use and not os.path.exists("starter_is_right")
    knobs = [word for word in words if "=" in word and word != use]
    text = "flat" if os.path.exists("flat") else f"{name} {starter} {knobs}"
    drivers = ("drift", "drift." + os.environ.get("GALLIUM_OVERRIDE_CPU_CAPS", "-"),
               "drift." + os.path.basename(os.environ.get("VK_DRIVER_FILES", "-")))
    drift = "".join(open(name).read() for name in drivers if os.path.exists(name))
    open(words[words.index("--screenshot") + 1], "w").write(text + drift)
words = sys.argv[1:]
if "--pictures" in words:
    for line in sys.stdin:
        wrong = draw(json.loads(line))
        print(json.dumps({"code": 1 if wrong else 0, "error": wrong or ""}), flush=True)
elif "--screenshot" in words:
    sys.exit(draw(words))
else:
    print(name, *words, "in", os.getcwd())
    sys.exit(7 if "--fail" in words else 0)
"""
COMPARE = """#!PYTHON
import json, sys
for line in sys.stdin:
    words = json.loads(line)
    a, b = (open(name).read() for name in words[:2])
    if "--heatmap" in words:
        open(words[words.index("--heatmap") + 1], "w").write("hot")
    d = 0.0 if a == b else 0.001 if a == b.rstrip("~") else 0.5
    steps = len(b) - len(a) if a == b.rstrip("^") else int(d * 200)
    print(json.dumps({"flip": {"mean": d, "p99": d, "max": d}, "rmse": d,
                      "max_diff": {"steps": steps, "x": 1, "y": 2, "pixels": 3 * (a != b)},
                      "nan": {"reference": 0, "test": 0}, "inf": {"reference": 0, "test": 0},
                      "nearly_constant": {"reference": "flat" in a, "test": "flat" in b}}), flush=True)
"""
CHECK = """#!PYTHON
import json, os, sys
name = os.path.basename(sys.argv[0]).removeprefix("check_")
exercise = sys.argv[sys.argv.index("--exercise") + 1] if "--exercise" in sys.argv else name[:2] + ".one"
use = sys.argv[sys.argv.index("--use") + 1]
said = open(f"chapters/{name}/{use}/{exercise[3:]}.cpp").read()
if "die" in said:
    os.abort()
ok = "right" in said
print("a line that is no JSON")
print(json.dumps({"exercise": exercise, "ok": ok, "passed": 2 + ok, "failed": 1 - ok,
                  "first_failure": None if ok else "one(0) gave 1, expected 0", "hint": "think"}))
sys.exit(0 if ok else 1)
"""
CHART = """import sys
open(sys.argv[1].replace(".json", ".svg"), "w").write("<svg/>")
"""
FUZZ = """#!/bin/sh
test -e slow && { echo $$ >slow; exec sleep 120; }
echo stat::number_of_executed_units: 9
! test -e broken
"""
TEST = """import unittest


class Nothing(unittest.TestCase):
    def test_nothing(self):
        pass
"""
MAIN = """int x;
// [frame]
  draw();
      // [inner]
      twice();
// [/inner]
// [/frame]
"""
LESSON = """# The lesson
See [the chapter](../chapters/01_obj/main.cpp) and [there](01_obj.md#the-lesson).
<!-- quote: chapters/01_obj/main.cpp#frame -->
```cpp
draw();
    twice();
```
"""
SHOTS_01 = {"shots": [{"name": "bunny", "caption": "A bunny.", "exercises": ["01.one"]},
                      {"name": "car", "caption": "A car."}]}
SHOTS_02 = {"shots": [{"name": "bunny", "caption": "Lit.", "set": {"method": "phong"}, "exercises": ["02.one"],
                       "rejects": [{"chapter": "01_obj"}, {"set": {"method": "none"}}]}]}
FILES = {
    "CMakeLists.txt": CMAKE, "CMakePresets.json": json.dumps(PRESETS), "compile": COMPILE,
    ".clang-format": "DisableFormat: true\n", ".gitignore": "/build/\n__pycache__/\n", "tests/common/test_course.py": TEST,
    "programs/compare": COMPARE, "programs/tests/fuzz_obj": FUZZ, "tests/01_obj/fuzz/fuzz_obj.cpp": "",
    "programs/chapters/01_obj": CHAPTER, "programs/chapters/02_lambert": CHAPTER,
    "programs/tests/check_01_obj": CHECK, "programs/tests/check_02_lambert": CHECK,
    "chapters/01_obj/main.cpp": MAIN, "chapters/02_lambert/main.cpp": "",
    "chapters/01_obj/exercise/one.cpp": "open", "chapters/01_obj/solution/one.cpp": "right",
    "chapters/02_lambert/exercise/one.cpp": "open", "chapters/02_lambert/solution/one.cpp": "right",
    "common/course/charts/chart.py": CHART, "docs/01_obj.md": LESSON, "docs/02_lambert.md": "# Two\n",
    "assets/CREDITS.md": "| file | what | who |\n|---|---|---|\n| models/{a,b}.obj | x | y |\n",
    "assets/models/a.obj": "v", "assets/models/b.obj": "v",
    "tests/01_obj/shots.json": json.dumps(SHOTS_01), "tests/02_lambert/shots.json": json.dumps(SHOTS_02),
}


def write(path: Path, text: str):
    """One that begins with #! is a program."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    if text.startswith("#!"):
        path.chmod(0o755)


def until(condition, timeout_s: float = 30):
    """Waits for an external event."""
    end = time.monotonic() + timeout_s
    while not condition():
        if time.monotonic() > end:
            raise AssertionError("it did not happen in time")
        time.sleep(0.05)


def make_tree(root: Path):
    shutil.copytree(REAL / "common/course", root / "common/course",
                    ignore=shutil.ignore_patterns("*.h", "*.cpp", "__pycache__"))
    for name in ("course", "tests/build.cmake", "tests/needs.cmake", "tests/run.py", "tests/suites.txt"):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(REAL / name, root / name)
    for name, text in FILES.items():
        write(root / name, text.replace("#!PYTHON", f"#!{sys.executable}"))
    starters = {path.relative_to(root): path.read_bytes() for path in root.glob("*/*/exercise/*")}
    (root / STARTERS).write_text(listed(starters))


def clean_environment() -> dict[str, str]:
    """Without the user's display, build folder and CI."""
    outer = ("DISPLAY", "WAYLAND_DISPLAY", "LIGHTWALK_BUILD", "CI", "VK_DRIVER_FILES",
             "GALLIUM_OVERRIDE_CPU_CAPS")
    return {name: value for name, value in os.environ.items() if name not in outer}


# For subprocess: a group of its own, which SIGINT ends, too, where the test runs behind "&": a shell has it ignored there.
INTERRUPTIBLE = {"start_new_session": True, "preexec_fn": lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)}


class Course(unittest.TestCase):
    """A tree, made once for the tests of a class."""

    @classmethod
    def setUpClass(cls):
        cls.outside = Path(cls.enterClassContext(tempfile.TemporaryDirectory())).resolve()
        cls.root = cls.outside / "tree"
        make_tree(cls.root)

    def run_program(self, command, code=0, cwd="/", **environment):
        """Runs it, asserts its exit code (any, for None), and returns all that it printed."""
        done = subprocess.run(command, cwd=cwd, env=clean_environment() | environment, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if code is not None:
            self.assertEqual(done.returncode, code, done.stdout)
        return done.stdout

    def course(self, *words, **options):
        return self.run_program([self.root / "course", *words], **options)

    @classmethod
    def write(cls, name: str, text: str):
        write(cls.root / name, text)

    def put(self, name: str, text: str = ""):
        """A file of the tree for this test; afterwards it is as before."""
        self.restore_afterwards(self.root / name)
        self.write(name, text)

    def remove(self, name: str):
        self.restore_afterwards(self.root / name)
        (self.root / name).unlink()

    def restore_afterwards(self, path: Path):
        before = path.read_bytes() if path.exists() else None
        self.addCleanup(lambda: path.unlink(missing_ok=True) if before is None else path.write_bytes(before))

    def display(self) -> dict[str, str]:
        """Variables of a display at which somebody answers."""
        one = socket.socket(socket.AF_UNIX)
        self.addCleanup(one.close)
        place = Path(self.enterContext(tempfile.TemporaryDirectory())) / "wayland-9"
        one.bind(str(place))
        one.listen(8)
        return {"WAYLAND_DISPLAY": place.name, "XDG_RUNTIME_DIR": str(place.parent)}

    def accept(self):
        return self.course("accept", "--yes")
