"""Tests of the check of texts: quotes, links, charts, credits, limits, and what a chapter needs."""
# Builds: nothing

import json
import shutil
import subprocess
import sys
import unittest

from small_course import LESSON, REAL, SHOTS_02, Course


class Text(Course):
    def wrong(self):
        check = [sys.executable, self.root / "common/course", "test.text_check"]
        done = subprocess.run(check, stdout=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 1 if done.stdout else 0)
        return done.stdout

    def test_the_tree_is_right(self):
        self.assertEqual(self.wrong(), "")

    def test_quotes(self):
        self.put("docs/01_obj.md", LESSON.replace("twice", "thrice"))
        self.assertIn("docs/01_obj.md:3: the block is not what chapters/01_obj/main.cpp says", self.wrong())
        self.course("docs", "--quote")
        self.assertEqual((self.root / "docs/01_obj.md").read_text(), LESSON)
        self.put("docs/01_obj.md", LESSON.replace("#frame", "#gone"))
        self.assertIn("has no lines from [gone] to [/gone]", self.wrong())
        self.put("docs/01_obj.md", LESSON.replace("01_obj/main.cpp#frame", "01_obj/solution/one.cpp#x"))
        self.assertIn("would give the exercise away", self.wrong())

    def test_links(self):
        for bad in ("[a](nowhere.md)", "![a](01.png)", "[a](01_obj.md#no-such)", "<img src='x.png'>", "[a](../../x)", "[![a](01_obj.md)<br>b](nowhere.md)"):
            self.put("docs/02_lambert.md", f"# Two\n{bad}\n`[a](code.md)` [b](https://example.org)\n")
            self.assertEqual(self.wrong().count("docs/02_lambert.md:2:"), 1, bad)

    def test_paragraphs_without_an_end(self):
        for bad in ("You need not compute the angles, because", "In general, the ray\n\n```math\nt = 1\n```\n\nThe denominator is 1.",
                    "A **word** and <!-- figure: x -->", "- A point\n  that goes"):
            self.put("docs/02_lambert.md", f"# Two\n\n{bad}\n\nMore.\n")
            self.assertIn("docs/02_lambert.md", self.wrong(), bad)
            self.assertIn("the paragraph has no end", self.wrong(), bad)
        self.put("docs/02_lambert.md", "# Two\n\nThen\n\n```math\nt = 1\n```\n\nThe window\n\n```math\nw\n```\n\nis narrow (*so*).\n\n"
                                       "Run this\n\n    make\n\nWhat is it?\n\n| a |\n|---|\n\n<details><summary>x</summary>\n\nYes.\n</details>\n")
        self.assertEqual(self.wrong(), "")

    def test_sentences_do_not_go_on_in_a_fold(self):
        fold = "\n\n<details><summary>The code</summary>\n\nYes.\n</details>\n"
        self.put("docs/02_lambert.md", "# Two\n\nIt does this:" + fold)
        self.assertIn("docs/02_lambert.md:3: the sentence goes on in a fold", self.wrong())
        self.put("docs/02_lambert.md", "# Two\n\nIt does this." + fold)
        self.assertEqual(self.wrong(), "")

    def test_a_page_names_the_next_one_once(self):
        self.put("docs/02_lambert.md", "# Two\n\nNext: [one](01_obj.md).\n\nNext: [one](01_obj.md) again.\n")
        self.assertEqual(self.wrong(), "docs/02_lambert.md:5: a second 'Next:' on this page\n")

    @unittest.skipUnless(shutil.which("glslangValidator"), "no compiler of GLSL here")
    def test_shaders_on_pages_compile(self):
        block = "layout(location = 0) out vec4 color;\n{}uniform Light {{ vec3 radiance; }};\nvoid main() {{ color = vec4(radiance, 1.0); }}\n"
        self.put("docs/02_lambert.md", f"# Two\n\n```glsl\n{block.format('')}```\n")
        self.assertIn("docs/02_lambert.md:3: the shader does not compile: ERROR: 3: ", self.wrong())
        self.put("docs/02_lambert.md", f"# Two\n\n```glsl\n{block.format('layout(binding = 0) ')}```\n\n```glsl\nfloat twice(float x) {{ return 2.0 * x; }}\n```\n")
        self.assertEqual(self.wrong(), "")

    def test_the_index_leads_to_what_is_there(self):
        self.put("chapters/02_lambert/knobs.h", 'Choice method{*this, "method", {"phong"}};\n')
        self.put("docs/02_lambert.md", "# Two\n\nMatt and glossy\nsurfaces.\n")
        exercises = " ".join(f"[{name}](02_lambert.md)" for name in ("01.one", "02.one"))

        def index(*rows: str):
            self.put("docs/index.md", "# Index\n\n| term | also called | section | knob | shot | exercise |\n|---|---|---|---|---|---|\n" +
                     "".join(f"| {row} |\n" for row in rows))
            return self.wrong()
        right = f"glossy surfaces | shine | [02](02_lambert.md) | `method=phong` | 02.bunny | {exercises}"
        self.assertEqual(index(right), "")
        self.assertIn("docs/index.md:5: 02_lambert.md does not have the word 'mirror'", index(right.replace("glossy surfaces", "mirror")))
        self.assertIn("docs/index.md:5: no knob or value is called gouraud", index(right.replace("phong", "gouraud")))
        self.assertIn("docs/index.md:5: there is no shot 02.cow", index(right.replace("bunny", "cow")))
        self.assertIn("docs/index.md:5: there is no exercise 02.two", index(right.replace("02.one", "02.two")))
        self.assertIn("docs/index.md: no row names the exercise 02.one; link it in the last column of its term", index(right.replace("[02.one]", "[one]")))
        self.assertIn("not in alphabetical order: 'surfaces' stands before 'matt'", index(right.replace("glossy surfaces", "surfaces"), "matt | | [02](02_lambert.md) | | |"))

    def test_the_index_has_the_words_of_older_courses(self):
        text = (REAL / "docs/index.md").read_text().casefold()
        for word in ("DOT3", "skydome", "scene graph", "greyscale", "grayscale", "Perez", "descriptor heap", "specular albedo", "backscatter",
                     "range-based", "resource heap", "model pool", "scan lines", "dispersion", "glow", "trigger point", "sphere of music"):
            self.assertIn(word.casefold(), text)

    def test_commands_that_the_course_refuses(self):
        for bad in ("./course paint", "./course check 01 --hnt", "./course check 01.three", "./course study 01 --turns 3"):
            self.put("docs/02_lambert.md", f"# Two\n\nSee `{bad}`.\n")
            self.assertEqual(self.wrong().count("docs/02_lambert.md:3:"), 1, bad)
        self.put("docs/02_lambert.md", "# Two\n\n    ./course check 01.one --hint   # a word\n    ./course grade --merge\n    ./course accept 20.new\n")
        self.assertEqual(self.wrong(), "")

    def test_the_way_of_a_pixel_quotes_its_files(self):
        walk = "# Way\n\n**1. [chapters/01_obj/main.cpp](../chapters/01_obj/main.cpp)**: `{}`, not `--show`.\n"
        self.put("chapters/01_obj/main.cpp", (self.root / "chapters/01_obj/main.cpp").read_text() + "int pixel(int a,\n          int b);\n")
        self.put("docs/pixel.md", walk.format("int pixel(int a, int\nb);"))
        self.assertEqual(self.wrong(), "")
        self.put("docs/pixel.md", walk.format("int pixel(int a)"))
        self.assertEqual(self.wrong(), "docs/pixel.md: chapters/01_obj/main.cpp has no 'int pixel(int a)'\n")
        self.put("docs/pixel.md", "# Way\n" + 16 * ("\n" + walk.format("int pixel(")[6:]))
        self.assertIn("docs/pixel.md: 16 files, at most 15", self.wrong())

    def test_lessons_that_are_ahead_of_the_course(self):
        self.put("docs/02_lambert.md", "# Two\nAs in chapter 01.\nMore in chapters 02 and 14.\n`chapter 15`\n")
        self.assertEqual(self.wrong(), "docs/02_lambert.md:3: there is no chapter 14\n")

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

    def test_charts_that_no_lesson_shows_are_not_in_the_tree(self):
        self.put("docs/studies/01_obj.gpu.png", "")
        self.assertEqual(self.wrong(), "docs/studies/01_obj.gpu.png: no text shows it; ./course docs draws charts from their JSON\n")
        self.put("docs/01_obj.md", LESSON + "![a chart](studies/01_obj.gpu.png)\n")
        self.assertEqual(self.wrong(), "")

    def test_diagrams_are_what_their_functions_draw(self):
        script = "class D:\n    def svg(self): return '<svg/>'\n\ndef figures(): return {'01_ray': D}\n"
        self.put("docs/figures/draw.py", script)
        self.put("docs/01_obj.md", LESSON + "![a ray](images/01_ray.svg)\n")
        self.assertIn("docs/images/01_ray.svg: not what its function draws", self.wrong())
        self.put("docs/images/01_ray.svg", "<svg/>")
        self.assertEqual(self.wrong(), "")
        self.put("docs/01_obj.md", LESSON)
        self.assertEqual(self.wrong(), "docs/images/01_ray.svg: no lesson shows it\n")
        self.put("docs/figures/draw.py", script.replace("return '<svg/>'", "raise ValueError('a label is outside')"))
        self.assertIn("docs/figures, 01_ray: a label is outside", self.wrong())
        self.put("docs/figures/draw.py", "figures = dict\n")
        self.assertIn("docs/images/01_ray.svg: nothing in docs/figures draws it", self.wrong())

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

    def test_credits_both_ways(self):
        self.put("assets/models/c.obj")
        self.assertIn("assets/models/c.obj: assets/CREDITS.md does not name it", self.wrong())
        self.remove("assets/models/b.obj")
        self.assertIn("assets/CREDITS.md:3: there is no assets/models/b.obj", self.wrong())

    def test_limits_without_a_measurement(self):
        self.addCleanup(lambda: [path.unlink() for path in self.root.glob("tests/*/golden/*")])
        self.accept()
        self.assertEqual(self.wrong(), "")
        measured = self.root / "tests/01_obj/golden/distances.json"
        known = json.loads(measured.read_text())
        self.put("tests/01_obj/golden/distances.json", json.dumps({"car": known["car"], "cat": known["car"]}))
        self.assertIn("nobody measured how far drivers differ on bunny; ./course accept 01.bunny", self.wrong())
        self.assertIn("golden/distances.json: cat has no golden", self.wrong())
        self.put("tests/02_lambert/shots.json", json.dumps({"shots": [SHOTS_02["shots"][0] | {"limits": {}, "rejects": [{"sett": {}}]}]}))
        self.assertIn("tests/02_lambert/shots.json: bunny: 'limits' is unknown here; known: name, caption, ", said := self.wrong())
        self.assertIn("tests/02_lambert/shots.json: bunny: rejects: 'sett' is unknown here; known: chapter, set, use", said)

    def test_the_order_of_the_trees_parts(self):
        for name, text, words in (
                ("common/base/x.cpp", '\n#include "common/gpu/frame.h"\n', "common/base/x.cpp:2: common/base may not include 'common/gpu/frame.h'"),
                ("common/gpu/x.h", '# include  "../window/window.h"\n', "common/gpu may not include '../window/window.h', which belongs to common/window"),
                ("common/window/x.h", '#include "01_obj/main.cpp"\n', "belongs to chapter 01"), ("common/attic/x.h", "", "common/attic: not a room"),
                ("chapters/01_obj/x.h", '#include "02_lambert/main.cpp"\n', "chapter 01 may not include '02_lambert/main.cpp'"),
                ("chapters/02_lambert/x.h", '#include "build/x.h"\n', "'build/x.h' leads to no part"),
                ("shaders/01_obj/x.glsl", '#include "02_lambert/main.cpp"\n', "chapter 01 may not include"),
                ("tests/common/x.cpp", '#include "01_obj/main.cpp"\n', "tests/common may not include"),
                ("tests/01_obj/x.cpp", '#include "02_lambert/main.cpp"\n', "tests/01 may not include"),
                ("common/course/build/x.py", "import os\n    from test.needs import y\n", "x.py:2: build may not import test"),
                ("common/course/attic/x.py", "", "common/course/attic: not a package")):
            with self.subTest(name):
                self.put("common/gpu/frame.h")
                self.put("common/window/window.h")
                self.put(name, text)
                self.assertIn(words, self.wrong())
                (self.root / name).unlink()

    def test_private_paths_and_what_a_chapter_needs(self):
        self.put("docs/02_lambert.md", "see /" + "work/main/x\n")
        self.assertIn("a path of one machine", self.wrong())
        self.remove("docs/02_lambert.md")
        self.assertIn("docs/02_lambert.md: chapter 02_lambert needs it", self.wrong())
        self.put("shaders/02_lambert/exercise/lost.glsl")
        self.put("shaders/02_lambert/solution/alone.glsl")
        self.assertIn("shaders/02_lambert/exercise/lost.glsl: there is no solution of this name", said := self.wrong())
        self.assertIn("shaders/02_lambert/solution/alone.glsl: there is no exercise of this name", said)
        self.put("tests/02_lambert/shots.json", '{"shots": [{"name": "a", "caption": "", "scene": "assets/no.json", "exercises": ["02.no"]}]}')
        self.assertIn("tests/02_lambert/shots.json: there is no scene assets/no.json", said := self.wrong())
        self.assertIn("there is no exercise 02.no", said)
        self.assertIn("tests/02_lambert/shots.json: a has no caption", said)
        self.assertIn("no golden has to reject the picture of an earlier chapter", self.wrong())
