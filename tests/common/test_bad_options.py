"""Options, drivers and shaders that are wrong: one line that says so, and nothing left behind.

Exit code 2; 1 where the input is fine and the work fails: a shader that does not compile or does not end.
"""
import json
import subprocess
import unittest

from bad_input import BUILD, CHAPTERS, ROOT, BadInput
from part_in_ci import part


class Options(BadInput):
    def test_options(self):
        for arguments, says in (
                (["--size", "0x0"], "WIDTHxHEIGHT"), (["--size", "100000x100000"], "WIDTHxHEIGHT"),
                (["--size", "abc"], "WIDTHxHEIGHT"), (["--size", "-1x5"], "WIDTHxHEIGHT"),
                (["--size", "64"], "WIDTHxHEIGHT"), (["--size", "64x48x3"], "WIDTHxHEIGHT"),
                (["--size", "99999999999999999999x1"], "WIDTHxHEIGHT"), (["--size", "nanxnan"], "WIDTHxHEIGHT"),
                (["--size", ""], "size.*empty"),
                (["--frames", "0"], "frames"), (["--frames", "-3"], "frames"), (["--frames", "1e99"], "frames"),
                (["--frames", "nan"], "frames"), (["--time", "nan"], "time"), (["--time", "inf"], "time"),
                (["--time", "1e30"], "time"), (["--time", "soon"], "time"),
                (["--seed", "nan"], "seed"), (["--seed", "99999999999999999999"], "seed"), (["--seed", "-1"], "seed"),
                (["--use", "nonsense"], "nonsense"), (["--use", ""], "use"), (["--use", "99.none=solution"], "99.none"),
                (["--use", "01.transform=mine"], "mine"), (["--use", "exercise,"], "use|exercise"),
                (["--set", "wrap"], "NAME=VALUE"), (["--set", "speed=1"], "unknown knob 'speed'; the nearest are samples and method"), (["--set", "=1"], "knob"),
                (["--set", "wrap=2"], "wrap=2.*0 to 1"), (["--set", "wrap=nan"], "wrap=nan"),
                (["--set", "wrap=inf"], "wrap"), (["--set", "wrap=1e999"], "wrap"), (["--set", "wrap="], "wrap"),
                (["--set", "shininess=-5"], "shininess"), (["--set", "samples=1.5"], "samples"),
                (["--set", "samples=1e10"], "samples"), (["--set", "wrap_tint=1,1"], "wrap_tint"),
                (["--set", "wrap_tint=1,1,1,1"], "wrap_tint"), (["--wrap", "7"], "wrap"),
                (["--method", "best"], "best.*phong"), (["--method", "auto"], "budget"),
                (["--method", "auto", "--budget", "nan"], "budget"), (["--method", "auto", "--budget", "-1"], "budget"),
                (["--budget", "much"], "budget"), (["--explain"], "auto"),
                (["--shot", "missing"], "unknown shot 'missing'; the nearest are .* and .*; --list shots lists all"), (["--shot", ""], "shot"),
                (["--device", "quantum"], "quantum.*there are"), (["--validate", "maybe"], "validate"),
                (["--list", "everything"], "list"), (["--unknown"], "unknown"), (["stray"], "stray"),
                (["--scene"], "scene"), (["--scene", ""], "scene|file"), (["--size"], "size"),
                (["--set"], "set")):
            self.refuse(CHAPTERS["02"], "--screenshot", self.picture, *arguments, says=says)
        self.refuse(CHAPTERS["01"], "--screenshot", self.picture, "--loader", "fastest", says="fastest.*textbook")
        self.refuse(CHAPTERS["01"], "--loads", "0", "--screenshot", self.picture, says="loads")

    def test_a_chapter_that_there_is_not(self):
        for words in (["run", "77"], ["run", "no_such"], ["nonsense"], ["check", "77"], ["accept", "02.none"],
                      ["run\n"], ["check", "02.phong\n"], ["shader", "a\nb"], ["accept", ""], ["accept", "02."], ["accept", "."],
                      ["study", ""], ["grade", ""], ["docs", "--slides", ""]):
            with self.subTest(words=words):
                done = self.run_program(ROOT / "course", *words)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertRegex(done.stderr, r"\Acourse: [^\n]{15,}\n\Z")

    def test_places_that_cannot_be_written(self):
        outside = self.write("file.txt", "mine")
        long_name = self.folder / ("x" * 300 + ".png")
        for option in ("--screenshot", "--timings", "--study"):
            for place in (self.folder / "none" / "out.png", self.folder, "/proc/x", "/proc/none/x.png",
                          outside / "out.png", long_name, ""):
                self.refuse(CHAPTERS["02"], "--size", "64x48", option, place, says="written|screenshot|timings|study")
        self.assertEqual(outside.read_text(), "mine")

    def test_a_study_that_cannot_be_measured(self):
        study = json.loads((ROOT / "chapters/02_lambert_phong/study.json").read_text())
        for name in ("assets", "shaders", "tests"):
            (self.folder / "course" / name).parent.mkdir(exist_ok=True)
            (self.folder / "course" / name).symlink_to(ROOT / name)
        (self.folder / "course/build").symlink_to(BUILD)
        scene = study["scenes"][0]
        for changes, says in (({"scenes": [scene, {"scene": scene, "lamps": 3}]}, "study.json:.*'lamps' is unknown"),
                              ({"scenes": [{"scene": scene, "set": {"lamps": 3}}]}, "study.json:.*unknown knob 'lamps'"),
                              ({"scenes": [scene, scene]}, "two scenes are called 'teapot'"),
                              ({"error_metric": "beauty"}, "'beauty', which the truth does not have"),
                              ({"truth": study["truth"] | {"exact": True}}, "'doubled' does not go with"),
                              ({"scenes": "teapot"}, "a list")):
            self.write("course/chapters/02_lambert_phong/study.json", json.dumps(study | changes))
            self.refuse(CHAPTERS["02"], "--size", "64x48", "--study", self.folder / "out.json", says=says,
                        LIGHTWALK_ROOT=str(self.folder / "course"))

    # --- no driver

    def test_no_driver(self):
        nothing = {"VK_DRIVER_FILES": "/nonexistent", "VK_ICD_FILENAMES": "/nonexistent"}
        for name in CHAPTERS:
            self.draw(name, says="driver.*install", **nothing)
        self.draw("02", "--validate", "on", says="driver.*install", **nothing)
        broken = str(self.write("driver.json", json.dumps({"file_format_version": "1.0.0", "ICD": {
            "library_path": "/nonexistent.so", "api_version": "1.3.0"}})))
        self.draw("02", says="driver.*install", VK_DRIVER_FILES=broken, VK_ICD_FILENAMES=broken)
        self.refuse(CHAPTERS["02"], "--list", "devices", says="driver.*install", **nothing)

    # --- shaders

    SOLUTION = "02_lambert_phong/solution/lambert.glsl"
    needs_solution = unittest.skipUnless((ROOT / "shaders" / SOLUTION).exists(), "a handout has no reference")

    def overlay(self, name, text) -> str:
        """A folder in which shaders/name says this instead."""
        self.write(f"overlay/shaders/{name}", text)
        return str(self.folder / "overlay")

    @needs_solution
    def test_a_shader_that_does_not_compile(self):
        name = self.SOLUTION
        good = (ROOT / "shaders" / name).read_text()
        for change, says in ((("max(", "maximum("), f"shaders/{name}:\\d+: .*maximum"),
                             (("return", "retrn"), f"shaders/{name}:\\d+: "), (("}", ""), r"shaders/\S+:\d+: "),
                             (("float lambert", '#include "none.glsl"\nfloat lambert'),
                              r"lambert\.glsl:3: .*none\.glsl")):
            self.draw("02", code=1, says=says, LIGHTWALK_OVERLAY=self.overlay(name, good.replace(*change)))
        self.draw("02", code=1, LIGHTWALK_OVERLAY=self.overlay(name, bytes(range(256))))
        self.draw("02", code=1, LIGHTWALK_OVERLAY=self.overlay(name, ""), says="lambert")

    @needs_solution
    def test_a_shader_that_never_ends(self):
        endless = """float lambert(vec3 normal, vec3 to_light) {
            float sum = 0.0;
            for (uint i = 0u; i < 4000000000u; ++i)
                for (uint k = 0u; k < 4000000000u; ++k) sum = fract(sum + normal.x * float(i ^ k));
            return sum;
        }
        """
        # Lavapipe leaves a loop after 65536 turns; so it takes many pixels.
        self.refuse(CHAPTERS["02"], "--size", "1920x1080", "--screenshot", self.picture, code=1,
                    says="pass 'shade' did not end within 2", LIGHTWALK_TIMEOUT_S="2",
                    LIGHTWALK_OVERLAY=self.overlay(self.SOLUTION, endless))

    def test_a_time_limit_that_is_none(self):
        for limit in ("soon", "-1", "0", "nan", "5s"):
            self.draw("02", says=f"LIGHTWALK_TIMEOUT_S is '{limit}'; it takes a number of seconds", LIGHTWALK_TIMEOUT_S=limit)
        for limit in ("1e300", "inf"):
            done = self.run_program(CHAPTERS["02"], "--size", "64x48", "--screenshot", self.picture, LIGHTWALK_TIMEOUT_S=limit)
            self.assertEqual((done.returncode, done.stderr), (0, ""))


class Trouble(BadInput):
    @unittest.skipIf("sanitizer" in str(BUILD), "a sanitizer takes more addresses than any limit would leave")
    def test_little_memory_is_one_line(self):
        """For any driver, running out of memory is reported, and no file is blamed."""
        for program in (CHAPTERS["02"], BUILD / "chapters" / "06_deferred"):
            for mebibytes in part(range(200, 700, 40), 3):
                with self.subTest(program=program.name, mebibytes=mebibytes):
                    self.picture.unlink(missing_ok=True)
                    done = self.run_program("prlimit", f"--as={mebibytes << 20}", program, "--size", "320x180",
                                            "--screenshot", self.picture)
                    self.assertIn(done.returncode, (0, 1, 2), done.stderr)
                    self.assertEqual(self.picture.exists(), done.returncode == 0)
                    self.assertNotRegex(done.stderr, "broken|cut off")
                    if done.returncode:
                        self.assertRegex(done.stderr, "(?m)^error: .{15,}$")

    def test_whoever_waits_is_told(self):
        """The first message comes after 3 s; faster pictures need none."""
        drawing = subprocess.Popen([CHAPTERS["02"], "--set", "samples=4096", "--screenshot", self.picture], cwd=ROOT,
                                   stderr=subprocess.PIPE, text=True)
        with drawing:
            said = drawing.stderr.readline()
            drawing.kill()
        self.assertRegex(said or "drawing: 1 of 4096 samples", r"\Adrawing: \d+ of 4096 samples\n?\Z")
        self.assertFalse(self.picture.exists() and said)


if __name__ == "__main__":
    unittest.main()
