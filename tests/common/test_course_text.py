"""Tests of the check of texts: quotes, links, charts, credits, limits, and what a chapter needs."""
# Builds: nothing

import json
import shutil
import subprocess
import sys

from small_course import LESSON, MAIN, REAL, SHOTS_02, Course

ONE, TWO = "docs/01_obj.md", "docs/02_lambert.md"
FOLD = "\n\n<details><summary>The code</summary>\n\nYes.\n</details>\n"
BLOCK = "layout(location = 0) out vec4 color;\n{}uniform Light {{ vec3 radiance; }};\nvoid main() {{ color = vec4(radiance, 1.0); }}\n"
WALK = "**1. [chapters/01_obj/main.cpp](../chapters/01_obj/main.cpp)**: `{}`, not `--show`.\n"
WALKED = {"chapters/01_obj/main.cpp": MAIN + "int pixel(int a,\n          int b);\n"}
SCRIPT = "class D:\n    def svg(self): return '<svg/>'\n\ndef figures(): return {'01_ray': D}\n"
RAY = {"docs/figures/draw.py": SCRIPT, ONE: LESSON + "![a ray](images/01_ray.svg)\n"}
SVG = {"docs/images/01_ray.svg": "<svg/>"}
STRANGE = SHOTS_02["shots"][0] | {"limits": {}, "rejects": [{"chapter": "01_obj", "sett": {}}]}
HEADERS = {"common/gpu/frame.h": "", "common/window/window.h": ""}


def index(of: str, by: str, *more: str) -> dict[str, str]:
    """A page of terms, of which the first is right but for `by` in place of `of`."""
    exercises = " ".join(f"[{name}](02_lambert.md)" for name in ("01.one", "02.one"))
    right = f"glossy surfaces | shine | [02](02_lambert.md) | `method=phong` | 02.bunny | {exercises}"
    rows = "".join(f"| {row} |\n" for row in (right.replace(of, by), *more))
    return {"chapters/02_lambert/knobs.h": 'Choice method{*this, "method", {"phong"}};\n', TWO: "# Two\n\nMatt and glossy\nsurfaces.\n",
            "docs/index.md": f"# Index\n\n| term | also called | section | knob | shot | exercise |\n|---|---|---|---|---|---|\n{rows}"}


# Files that differ from a right tree, None for one that is not there; and each line that is printed, or a part of it.
ROWS = [
    ({},),
    ({ONE: LESSON.replace("#frame", "#gone")}, "has no lines from [gone] to [/gone]"),
    ({ONE: LESSON.replace("01_obj/main.cpp#frame", "01_obj/solution/one.cpp#x")}, "would give the exercise away"),
    # Links
    *[({TWO: f"# Two\n{bad}\n`[a](code.md)` [b](https://example.org)\n"}, f"{TWO}:2: ") for bad in (
        "[a](nowhere.md)", "![a](01.png)", "[a](01_obj.md#no-such)", "<img src='x.png'>", "[a](../../x)",
        "[![a](01_obj.md)<br>b](nowhere.md)")],
    # Paragraphs
    *[({TWO: f"# Two\n\n{bad}\n\nMore.\n"}, f"{TWO}:{3 + bad.startswith('-')}: the paragraph has no end") for bad in (
        "You need not compute the angles, because", "In general, the ray\n\n```math\nt = 1\n```\n\nThe denominator is 1.",
        "A **word** and <!-- a remark -->", "- A point\n  that goes")],
    ({TWO: "# Two\n\nThen\n\n```math\nt = 1\n```\n\nThe window\n\n```math\nw\n```\n\nis narrow (*so*).\n\n"
           "Run this\n\n    make\n\nWhat is it?\n\n| a |\n|---|\n\n<details><summary>x</summary>\n\nYes.\n</details>\n"},),
    ({TWO: "# Two\n\nIt does this:" + FOLD}, f"{TWO}:3: the sentence goes on in a fold"),
    ({TWO: "# Two\n\nIt does this." + FOLD},),
    ({TWO: "# Two\n\nNext: [one](01_obj.md).\n\nNext: [one](01_obj.md) again.\n"}, f"{TWO}:5: a second 'Next:' on this page"),
    # The index
    (index("", ""),),
    (index("glossy surfaces", "mirror"), "docs/index.md:5: 02_lambert.md does not have the word 'mirror'"),
    (index("phong", "gouraud"), "docs/index.md:5: no knob or value is called gouraud"),
    (index("bunny", "cow"), "docs/index.md:5: there is no shot 02.cow"),
    (index("02.one", "02.two"), "docs/index.md:5: there is no exercise 02.two", "no row names the exercise 02.one"),
    (index("[02.one]", "[one]"), "docs/index.md: no row names the exercise 02.one; link it in the last column of its term"),
    (index("glossy surfaces", "surfaces", "matt | | [02](02_lambert.md) | | |"),
     "not in alphabetical order: 'surfaces' stands before 'matt'"),
    # Commands
    *[({TWO: f"# Two\n\nSee `./course {bad}`.\n"}, f"{TWO}:3:") for bad in (
        "paint", "check 01 --hnt", "check 01.three", "study 01 --turns 3")],
    ({TWO: "# Two\n\n    ./course check 01.one --hint   # a word\n    ./course grade --merge\n    ./course accept 20.new\n"},),
    # The way of a pixel
    (WALKED | {"docs/pixel.md": "# Way\n\n" + WALK.format("int pixel(int a, int\nb);")},),
    (WALKED | {"docs/pixel.md": "# Way\n\n" + WALK.format("int pixel(int a)")},
     "docs/pixel.md: chapters/01_obj/main.cpp has no 'int pixel(int a)'"),
    (WALKED | {"docs/pixel.md": "# Way\n" + 16 * ("\n" + WALK.format("int pixel("))}, "docs/pixel.md: 16 files, at most 15"),
    # Chapters
    ({TWO: "# Two\nAs in chapter 01.\nMore in chapters 02 and 14.\n`chapter 15`\n"}, f"{TWO}:3: there is no chapter 14"),
    ({TWO: "see /" + "work/main/x.\n"}, "a path of one machine"),
    ({TWO: None}, f"{TWO}: chapter 02_lambert needs it"),
    ({"shaders/02_lambert/exercise/lost.glsl": "", "shaders/02_lambert/solution/alone.glsl": ""},
     "shaders/02_lambert/exercise/lost.glsl: there is no solution of this name",
     "shaders/02_lambert/solution/alone.glsl: there is no exercise of this name"),
    ({"tests/02_lambert/shots.json": '{"shots": [{"name": "a", "caption": "", "scene": "assets/no.json", "exercises": ["02.no"]}]}'},
     "tests/02_lambert/shots.json: a has no caption", "there is no exercise 02.no",
     "tests/02_lambert/shots.json: there is no scene assets/no.json",
     "no golden has to reject the picture of an earlier chapter"),
    ({"tests/02_lambert/shots.json": json.dumps({"shots": [STRANGE]})},
     "tests/02_lambert/shots.json: bunny: 'limits' is unknown here; known: name, caption, ",
     "tests/02_lambert/shots.json: bunny: rejects: 'sett' is unknown here; known: chapter, set, use"),
    # Charts, diagrams and credits
    ({"docs/studies/01_obj.gpu.png": ""}, "docs/studies/01_obj.gpu.png: no text shows it; ./course docs draws charts from their JSON"),
    ({"docs/studies/01_obj.gpu.png": "", ONE: LESSON + "![a chart](studies/01_obj.gpu.png)\n"},),
    (RAY, "the link images/01_ray.svg leads nowhere", "docs/images/01_ray.svg: not what its function draws"),
    (RAY | SVG,),
    (RAY | SVG | {ONE: LESSON}, "docs/images/01_ray.svg: no lesson shows it"),
    (RAY | SVG | {"docs/figures/draw.py": SCRIPT.replace("return '<svg/>'", "raise ValueError('a label is outside')")},
     "docs/figures, 01_ray: a label is outside"),
    (RAY | SVG | {"docs/figures/draw.py": "figures = dict\n"}, "docs/images/01_ray.svg: nothing in docs/figures draws it"),
    ({"assets/models/c.obj": ""}, "assets/models/c.obj: assets/CREDITS.md does not name it"),
    ({"assets/models/b.obj": None}, "assets/CREDITS.md:3: there is no assets/models/b.obj"),
    # The order of the tree's parts
    *[(HEADERS | {name: text}, fault) for name, text, fault in (
        ("common/base/x.cpp", '\n#include "common/gpu/frame.h"\n', "common/base/x.cpp:2: common/base may not include 'common/gpu/frame.h'"),
        ("common/gpu/x.h", '# include  "../window/window.h"\n',
         "common/gpu may not include '../window/window.h', which belongs to common/window"),
        ("common/window/x.h", '#include "01_obj/main.cpp"\n', "belongs to chapter 01"),
        ("common/attic/x.h", "", "common/attic: not a room"),
        ("chapters/01_obj/x.h", '#include "02_lambert/main.cpp"\n', "chapter 01 may not include '02_lambert/main.cpp'"),
        ("chapters/02_lambert/x.h", '#include "build/x.h"\n', "'build/x.h' leads to no part"),
        ("shaders/01_obj/x.glsl", '#include "02_lambert/main.cpp"\n', "chapter 01 may not include"),
        ("tests/common/x.cpp", '#include "01_obj/main.cpp"\n', "tests/common may not include"),
        ("tests/01_obj/x.cpp", '#include "02_lambert/main.cpp"\n', "tests/01 may not include"),
        ("common/course/build/x.py", "import os\n    from test.needs import y\n", "x.py:2: build may not import test"),
        ("common/course/attic/x.py", "", "common/course/attic: not a package"))],
]
if shutil.which("glslangValidator"):
    ROWS += [({TWO: f"# Two\n\n```glsl\n{BLOCK.format('')}```\n"}, f"{TWO}:3: the shader does not compile: ERROR: 3: "),
             ({TWO: f"# Two\n\n```glsl\n{BLOCK.format('layout(binding = 0) ')}```\n\n"
                    "```glsl\nfloat twice(float x) { return 2.0 * x; }\n```\n"},)]


class Text(Course):
    def wrong(self):
        check = [sys.executable, self.root / "common/course", "test.text_check"]
        done = subprocess.run(check, stdout=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 1 if done.stdout else 0)
        return done.stdout

    def test_each_row(self):
        for files, *faults in ROWS:
            with self.subTest(faults, files=list(files)):
                self.doCleanups()  # the row before
                for name, text in files.items():
                    self.remove(name) if text is None else self.put(name, text)
                lines = self.wrong().splitlines()
                self.assertEqual(len(lines), len(faults), lines)
                for line, fault in zip(lines, faults):
                    self.assertIn(fault, line)

    def test_a_quote_is_written_anew(self):
        self.put(ONE, LESSON.replace("twice", "thrice"))
        self.assertIn(f"{ONE}:3: the block is not what chapters/01_obj/main.cpp says", self.wrong())
        self.course("docs", "--quote")
        self.assertEqual((self.root / ONE).read_text(), LESSON)

    def test_the_index_has_the_words_of_older_courses(self):
        text = (REAL / "docs/index.md").read_text().casefold()
        for word in ("DOT3", "skydome", "scene graph", "greyscale", "grayscale", "Perez", "descriptor heap", "specular albedo", "backscatter",
                     "range-based", "resource heap", "model pool", "scan lines", "dispersion", "glow", "trigger point", "sphere of music"):
            self.assertIn(word.casefold(), text)

    def test_exercises_stand_in_the_lesson_graded_and_in_full(self):
        lesson = "# One\n## Exercises\n### 01.one (easy)\n<!-- quote: {0}#one -->\n```\n// What it does.\n```\n"
        file = "chapters/01_obj/exercise/one.cpp"
        self.put(file, "// [one]\n// What it does.\n// [/one]\nright\n")
        self.put("docs/01_obj.md", lesson.format(file))
        self.restore_afterwards(self.root / "tests/starters.txt")
        self.course("docs", "--quote")  # another starter
        self.assertEqual(self.wrong(), "")
        self.put("docs/01_obj.md", "# One\n## Exercises\n### 01.one (easy)\n")
        self.assertIn(f"docs/01_obj.md: it does not quote {file}#one", self.wrong())
        self.put("docs/01_obj.md", lesson.format(file).replace("01.one (easy)", "01.one"))
        self.assertIn("docs/01_obj.md: there is no heading '### 01.one (easy)'", self.wrong())
        self.put("docs/01_obj.md", lesson.format(file).replace("(easy)", "(hard)") + "### 01.two (medium)\n")
        self.assertIn("docs/01_obj.md: a harder exercise stands before an easier one", self.wrong())

    def test_environment_variables_both_ways_and_few(self):
        def table(*names: str):
            self.put("docs/development.md", "# D\n" + "".join(f"| `LIGHTWALK_{name}` | x |\n" for name in names))
        self.put("chapters/02_lambert/more.h", '// std::getenv("LIGHTWALK_' + 'MORE")\n')
        table()
        read = [line.partition("LIGHTWALK_")[2] for line in self.wrong().splitlines()]
        self.assertIn("MORE", read)
        self.remove("chapters/02_lambert/more.h")
        read.remove("MORE")
        table(*read)
        self.assertEqual(self.wrong(), "")
        table(*read, *"ABCDEFGHI")
        self.assertIn("at most 8", self.wrong())
        self.assertIn("docs/development.md: nothing reads LIGHTWALK_A", self.wrong())

    def test_limits_without_a_measurement(self):
        self.addCleanup(lambda: [path.unlink() for path in self.root.glob("tests/*/golden/*")])
        self.accept()
        self.assertEqual(self.wrong(), "")
        measured = self.root / "tests/01_obj/golden/distances.json"
        known = json.loads(measured.read_text())
        self.put("tests/01_obj/golden/distances.json", json.dumps({"car": known["car"], "cat": known["car"]}))
        self.assertIn("nobody measured how far drivers differ on bunny; ./course accept 01.bunny", self.wrong())
        self.assertIn("golden/distances.json: cat has no golden", self.wrong())
