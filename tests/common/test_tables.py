"""Tables and numbers that lessons take from studies, and the tests that they name."""

import json
import re
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from charts import measured, study, timings
from check import lesson_tests
from folder_case import FolderCase
from pages import advice, tables
from pages.quotes import lessons
from tree import ROOT, UsageError, chapters, shots

STUDY = {"points": [{"scene": "a, b", "method": "slow", "knobs": {"steps": 8}, "error": {"flip_mean": 0.01234},
                     "time_ms": {"median": 1807.6, "per_pass": {"one": 2, "two": 3}}},
                    {"scene": "a, b", "method": "slow", "knobs": {"steps": 16}, "error": {"flip_mean": 0.00555},
                     "time_ms": {"median": 40.04, "per_pass": {"one": 2, "two": 3}}},
                    {"scene": "c", "method": "fast", "knobs": {}, "error": {"flip_mean": 0.2}, "time_ms": {"median": 1}}],
         "truth": {"doubling": 0.0031}}
LESSON = """<!-- table: studies.json#scene=a, b; method=slow
value=ms | value=flip_mean; format=.1% | -
steps=8
steps=8,16 -->
| | time | error | words |
|---|---|---|---|
| eight | 1 | 2 | kept |
| both | 1 | 2 | kept |
""".splitlines()


class Tables(unittest.TestCase):
    def setUp(self):
        self.root = Path(self.enterContext(tempfile.TemporaryDirectory(prefix="lightwalk_tables_")))
        (self.root / "studies.json").write_text(json.dumps(STUDY))
        tables.load.cache_clear()
        self.enterContext(mock.patch.object(tables, "ROOT", self.root))
        self.addCleanup(tables.load.cache_clear)

    def wrong_of(self, text: str) -> list[str]:
        (self.root / "lesson.md").write_text(text)
        return tables.check_figures(Path("lesson.md"))

    def test_what_selects_no_point_or_several_is_said(self):
        for cell, words in (("method=none", "0 points are"), ("scene=a, b", "2 points are"), ("value=no", "a point has no 'no'"),
                            ("steps", "'steps' selects nothing")):
            lines = ["<!-- table: studies.json#scene=a, b; method=slow", f"{cell}", "all -->", "| | x |", "|---|---|", "| a | 1 |"]
            if cell == "value=no":
                lines[2] = "steps=8 -->"
            self.assertIn(words, "".join(tables.check_tables(Path("lesson.md"), lines)[0]), cell)
        self.assertIn("no table follows", tables.check_tables(Path("lesson.md"), LESSON[:4])[0][0])
        self.assertIn("2 rows are selected, the table has 1", tables.check_tables(Path("lesson.md"), LESSON[:-1])[0][0])

    def test_a_number_in_running_text_is_its_source_s(self):
        source = "<!-- figure: studies.json#scene=a, b; method=slow; steps=8; value=%s -->"
        self.assertEqual(self.wrong_of(f"It is 0.012{source % 'flip_mean'} or **1.2%**{source % 'flip_mean'}."), [])
        self.assertEqual(self.wrong_of(f"It is 1900 ms{source % 'ms; tolerance=6%'}."), [])
        self.assertEqual(self.wrong_of("By 0.003<!-- figure: studies.json#value=/truth/doubling -->."), [])
        self.assertIn("the text says 0.013", self.wrong_of(f"It is 0.013{source % 'flip_mean'}.")[0])
        self.assertIn("follow no number", self.wrong_of(f"It is {source % 'flip_mean'}.")[0])

    def test_a_constant_is_the_code_s(self):
        (self.root / "player.cpp").write_text("constexpr double fade_s = 0.005;\n")
        source = "<!-- figure: player.cpp#%s -->"
        self.assertEqual(self.wrong_of(f"A fade of 5 ms{source % 'fade_s = {}; scale=1000'}."), [])
        self.assertIn("the text says 6ms", self.wrong_of(f"6 ms{source % 'fade_s = {}; scale=1000'}.")[0].replace(" ms", "ms"))
        self.assertIn("player.cpp has no such line", self.wrong_of(f"5 ms{source % 'fade_ms = {}'}.")[0])
        self.assertIn("none.cpp has no such line", self.wrong_of("5 ms<!-- figure: none.cpp#fade_s = {} -->.")[0])


# What prints a table, named somewhere in its section: a test, a test's program or a figure's script.
PRINTS = re.compile(r'build/tests/|\[\d\d\.\w+\]|"\[figures\]"|docs/figures/')


def typed(lines: list[str]) -> list[int]:
    """The lines at which tables of three fractions or more begin that name no source. A source is a comment before the table, or
    one in each row, or what prints it. Examples by hand and tables of sources have none."""
    found, i = [], 0
    while i < len(lines):
        begin = i
        while i < len(lines) and lines[i].lstrip().startswith("|"):
            i += 1
        if i - begin < 3:
            i = max(i, begin + 1)
            continue
        above = begin
        while above > 0 and not lines[above - 1].strip():
            above -= 1
        section = next((k for k in range(begin, 0, -1) if lines[k].startswith("#")), 0)
        end = next((k for k in range(i, len(lines)) if lines[k].startswith("#")), len(lines))
        folds = " ".join(lines[section:begin]).split("<details>")
        by_hand = "example by hand" in folds[-1] and "</details>" not in folds[-1]
        rows = lines[begin + 2:i]
        sourced = "-->" in lines[above - 1] or any(advice.BEGIN.match(line) for line in lines[max(0, above - 3):above]) or all("<!-- figure: " in row for row in rows) or \
            PRINTS.search("\n".join(lines[section:end])) or "| source |" in lines[begin] or by_hand
        if not sourced and len(re.findall(r"\d\.\d|\d%", " ".join(rows))) > 2:
            found.append(begin + 1)
    return found


class Lessons(unittest.TestCase):
    def test_every_table_and_number_with_a_source_is_right(self):
        for name in lessons():
            lines = (ROOT / name).read_text().splitlines()
            self.assertEqual(tables.check_tables(name, lines)[0] + tables.check_figures(name), [])

    def test_no_table_of_fractions_is_typed(self):
        for name in lesson_tests.of_chapters(lessons()):
            lines = (ROOT / name).read_text().splitlines()
            self.assertEqual([f"{name}:{at}" for at in typed(lines)], [], "<!-- table: ... -->")
        table = ["| | m |", "|---|---|", "| a | 1.2 |", "| b | 1.3 |", "| c | 1.4 |"]
        self.assertEqual(typed(["Errors on the reef:", "", *table]), [3])
        for named in ("(`[11.reef]`)", "<details><summary>An example by hand</summary>", "<!-- table: a.json#all -->"):
            self.assertEqual(typed([named, "", *table]), [], named)
        self.assertEqual(typed(["(`[11.reef]`)", "## Next", *table]), [3])

    def test_a_time_in_running_text_names_its_source(self):
        typed_times = []
        for name in lesson_tests.of_chapters(lessons()):
            text = re.sub(r"```.*?```|<!-- table: .*?-->", "", (ROOT / name).read_text(), flags=re.S)
            text = re.sub(r"^ *\|.*$", "", tables.FIGURE.sub("", text), flags=re.M)
            typed_times += [f"{name}: {one}" for one in re.findall(r"(?<![\w.,])[\d.,]*\d\s(?:ms|µs)\b", text)]
        self.assertEqual(typed_times, [], "<!-- figure: ... --> behind the number")

    def test_no_name_of_a_test_matches_nothing(self):
        texts = lesson_tests.of_chapters(lessons())
        self.assertGreater(sum(len(lesson_tests.named_in(text)) for text in texts), 100)
        self.assertEqual([line for text in texts for line in lesson_tests.check_named(text)], [])
        self.assertTrue(lesson_tests.SENTENCE.search('the shadow is gone (`"peter-panning: a bias*"`).'))


class Measured(FolderCase):
    FILES = {"chapters/01_a/a.cpp": "int a = 1; // one\n", "shaders/01_a/b.glsl": "float b;\n", "chapters/02_c/c.cpp": "int c;",
             "shaders/01_a/exercise/b.glsl": "0", "chapters/01_a/study.json": '{"title": "A b", "scenes": ["assets/scenes/s.json"]}',
             "assets/scenes/s.json": "{}"}

    def version(self) -> str:
        return measured.version_of(sorted(self.FILES), self.FILES.__getitem__, "01_a")

    def test_a_study_is_of_an_earlier_version_when_its_sources_have_changed(self):
        same = [{"chapters/01_a/a.cpp": "int  a = 1;\n// another\n"}, {"chapters/02_c/c.cpp": "int d;"},
                {"shaders/01_a/exercise/b.glsl": "1"},
                {"chapters/01_a/study.json": '{"title": "C d", "scenes": ["assets/scenes/s.json"], "verdicts": [1]}'}]
        other = [{"chapters/01_a/a.cpp": "int a = 2;"}, {"shaders/01_a/b.glsl": "float c;"}, {"assets/scenes/s.json": "{ 1 }"}]
        was = self.version()
        for change in same + other:
            files = self.FILES | change
            now = measured.version_of(sorted(files), files.__getitem__, "01_a")
            self.assertEqual(now == was, change in same, change)

    def test_a_study_with_a_request_of_its_own_is_of_that_one(self):
        request = measured.request_of({"chapter": "01_a", "command": "build/chapters/01_a --study FILE --study-file chapters/01_a/study_own.json"})
        self.assertEqual(request, "chapters/01_a/study_own.json")
        self.assertEqual(measured.request_of({"chapter": "01_a", "command": "./course study 01 --timings"}), "chapters/01_a/timings.json")
        own = self.FILES | {request: '{"runs": [{"words": "--scene scenes/other.json"}]}', "assets/scenes/other.json": "{}"}

        def version(**changed: str) -> str:
            files = own | {name.replace("__", "/") + ".json": text for name, text in changed.items()}
            return measured.version_of(sorted(files), files.__getitem__, "01_a", request)
        self.assertEqual(version(), version(assets__scenes__s="[]"))
        self.assertNotEqual(version(), version(assets__scenes__other="[]"))

    def test_each_study_says_what_it_measured(self):
        for path in (ROOT / "docs/studies").glob("*.json"):
            self.assertRegex(json.loads(path.read_text()).get("measured", ""), r"^[0-9a-f]{12}$", path.name)
        for path in (ROOT / "docs/studies/tables").glob("*.json"):
            self.assertIn("measured", json.loads(path.read_text()), path.name)

    def test_errors_are_measured_again_without_the_times(self):
        file = self.folder / "a.json"
        old = {"device": "d", "driver": "e", "command": "c", "measured": "0",
               "points": [{"scene": "s", "method": "m", "knobs": {}, "error": {"x": 1}, "time_ms": {"median": 5}}]}
        file.write_text(json.dumps(old))
        new = {"chapter": chapters()[0], "device": "f", "driver": "g", "command": "h", "measured": measured.here(chapters()[0]),
               "points": [{"scene": "s", "method": "m", "knobs": {}, "error": {"x": 2}, "time_ms": {"median": 9}}]}
        both = study.errors_into(file, new)
        self.assertEqual((both["points"][0]["error"], both["points"][0]["time_ms"], both["device"]), ({"x": 2}, {"median": 5}, "d"))
        file.write_text(json.dumps(old | {"size": [240, 135]}))
        with self.assertRaisesRegex(UsageError, "240x135"):
            study.errors_into(file, new | {"size": [480, 270]})
        file.write_text(json.dumps(both))  # a page still marks the times
        self.assertEqual((measured.is_of_earlier(file), measured.has_old_times_alone(file)), (True, True))
        file.write_text(json.dumps(both | {"errors_measured": "0"}))
        self.assertEqual((measured.is_of_earlier(file), measured.has_old_times_alone(file)), (True, False))


class Realisations(unittest.TestCase):
    # Knobs that draw another sea, nebula or grain: two realisations have no pixels in common to compare.
    RANDOM = {"seed", "water.method", "water.waves", "water.seed", "volume.noise", "volume.field.variety", "post.grain", "post.dither"}

    def test_no_study_compares_two_of_them_by_pixel(self):
        for chapter in chapters():
            for file in sorted((ROOT / "chapters" / chapter).glob("study*.json")):
                request = json.loads(file.read_text())
                for one in [*request.get("curves", []), *request.get("candidates", [])]:
                    self.assertFalse(self.RANDOM & set(one.get("set", {})), f"{file.name} of {chapter}: {one}")
        for kind, ways in json.loads((ROOT / "chapters/19_ambiance/ways.json").read_text()).items():
            self.assertFalse(self.RANDOM & {knob for way in ways for knob in way}, kind)


class Timings(unittest.TestCase):
    FOUND = {"frames": 2, "status": ["5,177 mixed of 100 pixels"], "once": [{"name": "table", "gpu_ms": 4}],
             "passes": [{"name": "a", "gpu_ms": 1, "frames": 2}, {"name": "twice", "gpu_ms": 3, "frames": 4}, {"name": "read back", "gpu_ms": 9, "frames": 2}]}

    def test_a_run_is_a_point_of_a_table(self):
        point = timings.point_of("city", "mlaa", self.FOUND)
        self.assertEqual((point["time_ms"], point["error"]["mixed"]), ({"median": 7, "per_pass": {"a": 1, "twice": 6}, "once": {"table": 4}}, 5177))
        study = {"points": [point, timings.point_of("city", "none", self.FOUND | {"passes": [{"name": "a", "gpu_ms": 2, "frames": 2}]})]}
        for value, text in (("ms.a+twice", "7.00"), ("ms.table", "4.00"), ("ms over none", "3.50"), ("ms less none", "5.00"), ("mixed", "5180")):
            self.assertEqual(tables.cell(study, {"scene": "city", "method": "mlaa", "value": value})[0], text, value)

    def test_runs_name_what_exists(self):
        for chapter in filter(timings.request_of, chapters()):
            for run in timings.request_of(chapter)["runs"]:
                self.assertTrue(timings.methods(run))
                for scene in re.findall(r"--scene (\S+)", run.get("words", "")):
                    self.assertTrue((ROOT / "assets" / scene).is_file(), scene)
                for shot in re.findall(r"--shot (\S+)", run.get("words", "")):
                    self.assertIn(shot, [one["name"] for one in shots(chapter)])


class Candidates(unittest.TestCase):
    # Whole-surface sums, and a path that no method of a frame's is.
    TOO_DEAR = {"12_skin": "a sum over all texels of the head", "19_ambiance": "a path of 1,024 lengths, which costs nothing in a frame"}

    def test_a_reference_that_is_affordable_is_a_candidate(self):
        for chapter in chapters():
            request = study.study_of(chapter)
            truth = request.get("truth", {})
            if not truth.get("exact") or chapter in self.TOO_DEAR:
                continue
            methods = {one["method"] for one in request.get("candidates", request["curves"])}
            wanted = {truth["set"].get("method", "")} | set(truth["set"].values())
            self.assertTrue(methods & wanted, f"{chapter}: {methods} lacks the reference")

    def test_laws_that_bodies_have_are_candidates(self):
        """Chapter 17's truth has a reference of clouds and rings, beside the law that a scene sets or a body has."""
        methods = {one["method"] for one in study.study_of("17_planets")["candidates"]}
        self.assertLessEqual({"own", "hapke"}, methods)
