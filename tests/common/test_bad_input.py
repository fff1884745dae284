"""Input that is wrong, one of each kind: options, scenes, models, textures, landscapes, sounds, shaders. One line that says
what is wrong, exit code 2 (1 where the input is fine and the work fails), and no file that was not there before."""
# Builds: 01_obj 02_lambert_phong 04_surface_maps 06_deferred 14_environment 15_terrain_water
import json
import os
import re
import struct
import subprocess
import unittest

from bad_input import BUILD, CHAPTERS, ROOT, BadInput, encoded, png, radiance

CUBE = {"model": "models/cube.obj"}
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
SOLUTION = "02_lambert_phong/solution/lambert.glsl"
needs_solution = unittest.skipUnless((ROOT / "shaders" / SOLUTION).exists(), "a handout has no reference")

OPTIONS = [
    (["--size", "0x0"], "WIDTHxHEIGHT"), (["--size", "abc"], "WIDTHxHEIGHT"), (["--size", "99999999999999999999x1"], "WIDTHxHEIGHT"),
    (["--size", "16384x16384"], "16384x16384: too large"), (["--size", ""], "size.*empty"), (["--size"], "size"),
    (["--frames", "0"], "frames"), (["--frames", "1e99"], "frames"), (["--time", "nan"], "time"), (["--time", "soon"], "time"),
    (["--seed", "-1"], "seed"), (["--use", "nonsense"], "nonsense"), (["--use", "99.none=solution"], "99.none"),
    (["--use", "01.transform=mine"], "mine"), (["--set", "wrap"], "NAME=VALUE"),
    (["--set", "speed=1"], "unknown knob 'speed'; the nearest are samples and method"), (["--set", "wrap=2"], "wrap=2.*0 to 1"),
    (["--set", "wrap=nan"], "wrap=nan"), (["--set", "wrap="], "wrap"), (["--set", "samples=1.5"], "samples"),
    (["--set", "wrap_tint=1,1"], "wrap_tint"), (["--wrap", "7"], "wrap"), (["--method", "best"], "best.*phong"),
    (["--method", "auto"], "budget"), (["--method", "auto", "--budget", "-1"], "budget"), (["--explain"], "auto"),
    (["--shot", "missing"], "unknown shot 'missing'; the nearest are .* and .*; --list shots lists all"),
    (["--device", "quantum"], "quantum.*there are"), (["--validate", "maybe"], "validate"), (["--list", "everything"], "list"),
    (["--unknown"], "unknown"), (["stray"], "stray"),
    (["scenes/cones.json"], "options begin with --, a scene is --scene FILE"), (["--scene", ""], "scene|file")]

# The keys of a scene file, or its text: what the reader alone cannot see; test_scene_file.cpp has the reader's own refusals. The error
# names the file, and for text its line.
SCENES = {
    "syntax": ('{\n "objects": [\n  {"model": }\n ]\n}', r"syntax\.json:3"), "binary": (bytes(range(256)), r"binary\.json"),
    "no_model": ({"objects": [{"model": "models/missing.obj"}]}, r"no_model\.json:1.*missing\.obj"),
    "slot": ({"objects": [CUBE | {"material": {"maps": {"colour": "models/smart_car_albedo.png"}}}]}, "colour.*diffuse"),
    "no_include": ({"include": ["missing.json"]}, r"missing\.json"),
    "knob": ({"knobs": {"speed": 1}}, r"knob\.json: key 'knobs': unknown knob 'speed'; the nearest are"),
    "knob_value": ({"knobs": {"wrap": "much"}}, r"knob_value\.json: key 'knobs': wrap.*expected"),
    "rough": ({"objects": [CUBE | {"material": {"roughness": 1.5}}]}, "roughness.*1.5.*0.*1"),
    "role_part": ({"objects": [CUBE | {"role": {"nose": "skin"}}]}, "key 'role' names 'nose'.*models/cube.obj"),
    "direction": ('{"lights": [\n{"type": "directional", "direction": [0, 0, 0]}]}', r"direction\.json:2.*direction"),
    "of_another": ('{"lights": [\n{"type": "directional", "range_m": 3}]}', r"of_another\.json:2.*range_m"),
    "cut_sky": ('{\n"environment": "@cut.hdr"}', r"cut_sky\.json:2: key 'environment': .*cut\.hdr"),
    "square": ({"environment": "@square.hdr"}, "key 'environment': .*square.hdr.*64x64.*twice as wide"),
    "not_a_number": ({"environment": "@nan.pfm"}, r"key 'environment': .*nan\.pfm: 1 of its values are NaN")}

FILES = {
    "cut.hdr": radiance(64, 32)[:900], "square.hdr": radiance(64, 64), "nan.pfm": b"PF\n4 2\n-1.0\n" + struct.pack("<24f", *[1.0] * 23, float("nan")),
    # Models.
    "empty.obj": "", "binary.glb": bytes(range(256)) * 64, "zeros.obj": bytes(4096), "picture.obj": png(), "cut.obj": TRIANGLE + "f 1 2",
    "cut.glb": (ROOT / "assets/models/suzanne_family.glb").read_bytes()[:2000], "cut.gltf": '{"asset": {"version"', "bunny.ply": TRIANGLE,
    "bunny.txt": TRIANGLE, "bunny": TRIANGLE, "far.obj": "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "huge.ply": "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 4000000000\nproperty list uchar int vertex_index\nend_header\n0 0 0\n",
    "huge.off": "OFF\n4000000000 4000000000 0\n0 0 0\n", "huge.stl": bytes(80) + struct.pack("<I", 0xffffffff) + bytes(50),
    # Textures.
    "cut.gif": encoded((64, 64), "GIF")[:2000], "none.png": png()[:16] + struct.pack(">II", 0, 0) + png()[24:]}
MODELS = ("empty.obj", "binary.glb", "zeros.obj", "picture.obj", "cut.obj", "cut.glb", "cut.gltf", "bunny.ply", "bunny.txt", "bunny", "far.obj",
          "huge.ply", "huge.off", "huge.stl", "missing.obj", "")
TEXTURES = ("cut.gif", "none.png", "nan.pfm", "")  # test_image.cpp has the others

# Chapters with files of their own: the file, what lies beside it, the scene's key.
GREY = png(mode="L")
LANDSCAPES = [("colour.png", png(), None, "3 channels"), ("pixel.png", png((1, 1), "L"), None, "at least 2x2"),
              ("cut.png", GREY[:900], None, "cut.png"), ("hills.png", GREY, "metres", r"hills\.json: "),
              ("hills.png", GREY, '{"max_elevation_m": "high"}', r"hills\.json: "),
              ("hills.png", GREY, '{"min_elevation_m": 9, "max_elevation_m": 3}', r"hills\.json: ")]
BEAT = (ROOT / "assets/audio/beat.ogg").read_bytes()
SOUNDS = [("cut.ogg", BEAT[:len(BEAT) // 2], r"scene\.json:1: .*cut\.ogg: ends in the middle, after 1[0-9]\.\d+ s"),
          ("head.ogg", BEAT[:200], r"head\.ogg: ends before its sound begins"), ("text.ogg", "no sound", "is not sound; expected Ogg Vorbis"),
          ("damaged.ogg", BEAT[:len(BEAT) // 2] + bytes(64) + BEAT[len(BEAT) // 2 + 64:], r"is damaged at \d+\.\d+ s")]


class Refused(BadInput):
    def setUp(self):
        super().setUp()
        for name, content in FILES.items():
            self.write(name, content)

    def file(self, name: str, content) -> str:
        """A file written from keys, text or bytes; "@NAME" within is a file of the folder."""
        text = json.dumps(content) if isinstance(content, dict) else content
        return str(self.write(name, text if isinstance(text, bytes) else text.replace('"@', f'"{self.folder}/')))

    def overlay(self, text) -> str:
        """A folder in which the solution says this instead."""
        self.write(f"overlay/shaders/{SOLUTION}", text)
        return str(self.folder / "overlay")

    def fine(self, program, *words, said="", **environment):
        done = self.run_program(program, "--size", "64x48", "--screenshot", self.picture, *words, **environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, rf"\A{said}\Z")

    def test_options(self):
        for words, says in OPTIONS:
            self.refuse(CHAPTERS["02"], "--screenshot", self.picture, *words, says=says)
        self.refuse(CHAPTERS["02"], "--screenshot", self.picture.with_suffix(".jpg"), says="a PNG is written; expected a name in .png")
        self.refuse(CHAPTERS["01"], "--screenshot", self.picture, "--loader", "fastest", says="fastest.*textbook")
        for limit in ("soon", "0", "nan"):
            self.draw("02", says=f"LIGHTWALK_TIMEOUT_S is '{limit}'; it takes a number of seconds", LIGHTWALK_TIMEOUT_S=limit)
        self.draw("02", LIGHTWALK_ROOT=str(self.folder), says="LIGHTWALK_ROOT=.*shaders/common")
        nothing = {"VK_DRIVER_FILES": "/nonexistent", "VK_ICD_FILENAMES": "/nonexistent"}
        self.draw("02", says="no Vulkan driver is found by VK_DRIVER_FILES=/nonexistent; type unset VK_DRIVER_FILES", **nothing)
        for name, value in (("longest_m", 0), ("shortest_m", "inf"), ("waves", 17), ("slope", -1)):
            self.draw("15", "--set", f"water.{name}={value}", says=rf"water\.{name}")

    def test_names_of_chapters_and_exercises(self):
        for words in (["run", "77"], ["nonsense"], ["accept", "02.none"], ["check", "02.phong\n"], ["shader", "a\nb"], ["accept", ""], ["study", ""]):
            with self.subTest(words=words):
                done = self.run_program(ROOT / "course", *words)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertRegex(done.stderr, r"\Acourse: [^\n]{15,}\n\Z")

    def test_scenes(self):
        files = {name: self.file(f"{name}.json", content) for name, (content, _) in SCENES.items()}
        for name, file in files.items():
            self.draw("02", "--scene", file, says=SCENES[name][1])
        # A line break, or an escape sequence, in a name stays within the line.
        odd = self.write("two\nlines\x1b[31m.json", '{"objects": [],\n "red\\u001b[31m\\nkey": 1}')
        self.draw("02", "--scene", odd, says=r"two\\x0alines\\x1b\[31m\.json:2: key 'red\\x1b\[31m\\x0akey' is unknown")
        (self.folder / "around.json").symlink_to("around.json")
        self.draw("02", "--scene", self.folder / "around.json", says="no file .*around.json, .*[Ss]ymbolic link")
        self.draw("02", "--scene", self.folder / ("x" * 300 + ".json"), says="no file .*, File name too long")

    def test_models_and_textures(self):
        for name in MODELS:
            self.draw("02", "--scene", self.folder / name, says=re.escape(name))
        for loader in ("textbook", "tinyobjloader", "assimp", "scan", "parallel"):
            self.draw("01", "--scene", self.folder / "cut.obj", "--loader", loader, says=r"cut\.obj")
        self.refuse(CHAPTERS["01"], "--load-bench", self.folder / "empty.obj", says=r"empty\.obj")
        for name in TEXTURES:
            scene = self.file("scene.json", {"objects": [CUBE | {"material": {"maps": {"diffuse": f"@{name}"}}}]})
            self.draw("02", "--scene", scene, says=re.escape(name))
        self.write("grey.png", GREY)
        scene = self.file("scene.json", {"objects": [CUBE | {"material": {"maps": {"normal": "@grey.png"}}}]})
        self.draw("04", "--scene", scene, says="normal map: .*grey.png: has .* channel.*three")

    def test_pipes_and_devices(self):
        """Nobody writes to the pipe: opening it would block forever."""
        pipe = self.folder / "pipe.obj"
        os.mkfifo(pipe)
        for kind, place in (("pipe", str(pipe)), ("device", "/dev/zero")):
            for keys in ({"objects": [{"model": place}]}, {"include": [place]}, {"objects": [CUBE | {"material": {"maps": {"diffuse": place}}}]}):
                self.draw("02", "--scene", self.file("scene.json", keys), says=f"is a {kind}|format")
        outside = self.write("file.txt", "mine")
        for option in ("--screenshot", "--timings", "--study"):
            for place in (pipe, self.folder / "none" / "out.png", self.folder, "/proc/x", outside / "out.png", self.folder / ("x" * 300), ""):
                self.refuse(CHAPTERS["02"], "--size", "64x48", option, place, says="written|screenshot|timings|study")
        self.assertTrue(pipe.is_fifo())
        self.assertEqual(outside.read_text(), "mine")

    def test_landscapes_and_sounds(self):
        for name, content, beside, says in LANDSCAPES:
            file = self.write(name, content)
            if beside is not None:
                self.write("hills.json", beside)
            self.draw("15", "--scene", file, says=says)
        beat = json.loads((ROOT / "assets/scenes/beat.json").read_text())
        for name, content, says in SOUNDS:
            self.draw("14", "--scene", self.file("scene.json", beat | {"music": str(self.write(name, content))}), says=says)

    @needs_solution
    def test_shaders(self):
        good = (ROOT / "shaders" / SOLUTION).read_text()
        self.picture.write_bytes(b"the one before")
        for text, says in ((good.replace("max(", "maximum("), rf"shaders/{SOLUTION}:\d+: .*maximum"), (good.replace("}", ""), r"shaders/\S+:\d+: "),
                           ('#include "none.glsl"\n' + good, r"lambert\.glsl:1: .*none\.glsl"),
                           ('#include "phong.glsl"\n' + good, 'no file shaders/phong.glsl; write "02_lambert_phong/phong.glsl"'),
                           (bytes(range(256)), ""), ("", "lambert"),
                           ("uniform sampler2D lost;\n" + good.replace("max(", "texture(lost, vec2(0)).r + max("),
                            r"error: chapters/02_lambert_phong/main\.cpp:\d+: pass 'shade' draws or dispatches without 'lost'"),
                           ("float lambert(vec3 normal, vec3 to_light) { return uintBitsToFloat(0x7fc00000u); }\n", "holds [1-9][0-9]* NaN")):
            self.draw("02", code=1, says=says, LIGHTWALK_OVERLAY=self.overlay(text))
        endless = """float lambert(vec3 normal, vec3 to_light) {
            float sum = 0.0;
            for (uint i = 0u; i < 4000000000u; ++i)
                for (uint k = 0u; k < 4000000000u; ++k) sum = fract(sum + normal.x * float(i ^ k));
            return sum;
        }
        """
        # Lavapipe leaves a loop after 65536 turns; so it takes many pixels.
        self.refuse(CHAPTERS["02"], "--size", "1920x1080", "--screenshot", self.picture, code=1, says="pass 'shade' did not end within 2",
                    LIGHTWALK_TIMEOUT_S="2", LIGHTWALK_OVERLAY=self.overlay(endless))
        self.assertEqual(self.picture.read_bytes(), b"the one before")
        self.fine(CHAPTERS["02"], LIGHTWALK_OVERLAY=self.overlay("\ufeff" + good))

    def test_warnings(self):
        """The shape is worth seeing: what is missing or beyond all limits beside it is told, and the picture drawn."""
        for mtl, says in ((None, r"missing\.mtl"), ("newmtl a\nNs 1e30\nKs 1 1 1\n", r"a\.mtl: material 'a': [^\n]*shininess 1e\+30 is drawn as 100000"),
                          ("newmtl a\nmap_Kd cut.jpg\n", r"cut\.jpg")):
            name = "missing.mtl" if mtl is None else self.write("a.mtl", mtl).name
            model = self.write("a.obj", f"mtllib {name}\n{TRIANGLE}vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n")
            self.fine(CHAPTERS["02"], "--scene", model, said=rf"warning: [^\n]*{says}[^\n]*\n")

    def test_a_black_picture_is_told(self):
        dark = {"objects": [CUBE], "lights": [], "ambient": [0, 0, 0], "background": [0, 0, 0]}
        told = rf"warning: {re.escape(str(self.picture))} is entirely black"
        self.fine(CHAPTERS["02"], "--scene", self.file("dark.json", dark),
                  said=told + ": look at the camera, at the lights and at what each pass wrote, --look PASS: shade, shade depth, encode_srgb\n")
        faint = dark | {"ambient": [1e-5, 1e-5, 1e-5]}
        self.fine(CHAPTERS["02"], "--scene", self.file("faint.json", faint),
                  said=told + r", and its linear light reaches \d[^\s]*: look at the exposure and the last pass\n")
        self.fine(CHAPTERS["02"], "--scene", self.file("lit.json", dark | {"background": [0, 0, 1]}))
        self.fine(CHAPTERS["02"], "--scene", self.file("dark.json", dark), "--look", "shade")

    @unittest.skipIf("sanitizer" in str(BUILD), "a sanitizer takes more addresses than any limit would leave")
    def test_little_memory(self):
        """For any driver, running out of memory is reported, and no file is blamed."""
        for mebibytes in (200, 320, 440, 560):
            with self.subTest(mebibytes=mebibytes):
                self.picture.unlink(missing_ok=True)
                done = self.run_program("prlimit", f"--as={mebibytes << 20}", BUILD / "chapters" / "06_deferred", "--size", "320x180",
                                        "--screenshot", self.picture)
                self.assertIn(done.returncode, (0, 1, 2), done.stderr)
                self.assertEqual(self.picture.exists(), done.returncode == 0)
                self.assertNotRegex(done.stderr, "broken|cut off")
                if done.returncode:
                    self.assertRegex(done.stderr, "(?m)^error: .{15,}$")

    def test_long_work_tells_how_far_it_is(self):
        """The first message comes after 3 s; faster pictures need none."""
        with subprocess.Popen([CHAPTERS["02"], "--set", "samples=4096", "--screenshot", self.picture], cwd=ROOT, stderr=subprocess.PIPE,
                              text=True) as drawing:
            said = drawing.stderr.readline()
            drawing.kill()
        self.assertRegex(said or "drawing: 1 of 4096 samples", r"\Adrawing: \d+ of 4096 samples\n?\Z")

    def test_a_cache_that_others_can_write_is_not_used(self):
        tree, temporary, theirs = (self.folder / name for name in ("tree", "temporary", "theirs"))
        for folder in (tree, temporary, theirs):
            folder.mkdir(0o700)
        for name in ("assets", "shaders", "tests"):
            (tree / name).symlink_to(ROOT / name)
        (tree / "build").write_text("no folder, so the cache is in the temporary one")
        cache = temporary / f"lightwalk_shader_cache.{os.geteuid()}"

        def kept() -> list[str]:
            done = self.run_program("env", "-u", "LIGHTWALK_CACHE", f"TMPDIR={temporary}", f"LIGHTWALK_ROOT={tree}", CHAPTERS["01"],
                                    "--size", "16x16", "--screenshot", self.picture)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            return os.listdir(cache)
        cache.symlink_to(theirs)
        self.assertEqual(kept(), [])
        cache.unlink()
        cache.mkdir()
        cache.chmod(0o777)
        self.assertEqual(kept(), [])
        cache.rmdir()
        self.assertNotEqual(kept(), [])
        self.assertEqual(cache.stat().st_mode & 0o777, 0o700)
