"""What the programs do with input that is wrong: one line that says so, exit code 2, and nothing left behind.

Exit code 1 where the input is fine and the work fails: a shader that does not compile or does not end.
LIGHTWALK_BUILD names the build folder where it is not build/ in the tree.
"""
import io
import json
import os
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
CHAPTERS = {"01": BUILD / "chapters" / "01_obj", "02": BUILD / "chapters" / "02_lambert_phong",
            "04": BUILD / "chapters" / "04_surface_maps"}
TIMEOUT_S = 120  # under a sanitizer; without one a run takes a second
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
LOADERS = ("textbook", "tinyobjloader", "assimp", "scan", "parallel")


def png(size=(64, 64), mode="RGB") -> bytes:
    return encoded(size, "PNG", mode)


def encoded(size, kind, mode="RGB") -> bytes:
    """A picture with enough in it that half of its bytes are not all of it."""
    image = Image.frombytes("RGB", size, bytes((x * x * 31 + x * 7) % 251 for x in range(3 * size[0] * size[1])))
    out = io.BytesIO()
    image.convert(mode).save(out, kind)
    return out.getvalue()


def radiance(width=64, height=8) -> bytes:
    """A run-length coded .hdr."""
    row = bytes([2, 2, width >> 8, width & 255]) + 4 * (bytes([width]) + bytes(range(100, 100 + width)))
    return b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width) + height * row


@unittest.skipUnless(CHAPTERS["02"].exists() or "LIGHTWALK_BUILD" in os.environ, "the chapters are not built")
class BadInput(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.picture = self.folder / "picture.png"

    def write(self, name, content) -> pathlib.Path:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def run_program(self, program, *arguments, **environment):
        return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, errors="replace",
                              stdin=subprocess.DEVNULL, timeout=TIMEOUT_S, cwd=ROOT, env=os.environ | environment)

    def refuse(self, program, *arguments, code=2, says="", **environment):
        """Runs it and asserts its exit code, its one line, and that no file is there that was not before.

        A shader's errors (exit code 1) are a line each, and the line of the source that is meant, indented.
        """
        with self.subTest(program=program.name, arguments=[str(a) for a in arguments], **environment):
            before = sorted(self.folder.rglob("*"))
            done = self.run_program(program, *arguments, **environment)
            lines = done.stderr.splitlines()
            if code == 1:
                lines[1:] = [line for line in lines[1:] if not re.match(r"    |shaders/\S+:\d+: ", line)]
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertEqual(len(lines), 1, done.stderr)
            self.assertTrue(lines[0].startswith("error: "), done.stderr)
            self.assertGreater(len(lines[0]), 20, done.stderr)
            if says:
                self.assertRegex(lines[0], says)
            self.assertEqual(sorted(self.folder.rglob("*")), before)

    def draw(self, chapter, *arguments, **expected):
        """Refuses a picture of 64x48 that these options ask for."""
        self.refuse(CHAPTERS[chapter], "--size", "64x48", "--screenshot", self.picture, *arguments, **expected)

    # --- models

    def test_models_that_are_none(self):
        whole = {"bunny.obj": (ROOT / "assets/models/bunny_low.obj").read_bytes()[:20000],
                 "family.glb": (ROOT / "assets/models/suzanne_family.glb").read_bytes()}
        files = [self.folder / "missing.obj", self.folder, self.write("empty.obj", ""), self.write("empty.glb", b""),
                 self.write("binary.obj", bytes(range(256)) * 64), self.write("binary.glb", bytes(range(256)) * 64),
                 self.write("zeros.obj", bytes(4096)), self.write("picture.obj", png()),
                 self.write("cut.obj", TRIANGLE + "f 1 2"), self.write("cut.glb", whole["family.glb"][:2000]),
                 self.write("header.glb", whole["family.glb"][:12]), self.write("cut.gltf", '{"asset": {"version"'),
                 self.write("bunny.ply", whole["bunny.obj"]), self.write("bunny.glb", whole["bunny.obj"]),
                 self.write("bunny.stl", whole["bunny.obj"]), self.write("bunny.txt", whole["bunny.obj"]),
                 self.write("bunny", whole["bunny.obj"]), self.write("bunny.png", png()),
                 self.write("family.obj", whole["family.glb"]),
                 self.write("huge.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"
                                        "property float y\nproperty float z\nelement face 4000000000\n"
                                        "property list uchar int vertex_index\nend_header\n0 0 0\n"),
                 self.write("huge.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"),
                 self.write("huge.stl", bytes(80) + struct.pack("<I", 0xffffffff) + bytes(50))]
        for file in files:
            self.draw("02", "--scene", file, says=re.escape(file.name))
        for loader in LOADERS:
            for file in (files[0], files[2], files[4], files[8], self.folder):
                self.draw("01", "--scene", file, "--loader", loader, says=re.escape(file.name))
            self.refuse(CHAPTERS["01"], "--dump-mesh", files[4], "--loader", loader)
        for command in ("--dump-mesh", "--load-bench"):
            for file in (files[0], files[2], files[4], files[8], self.folder):
                self.refuse(CHAPTERS["01"], command, file, says=re.escape(file.name))

    def test_obj_lines_that_cannot_be_meant(self):
        """Each is refused by our three loaders at its line; the libraries may read some of them, but not crash."""
        bad = {"zero": (4, "f 0 1 2\n"), "beyond": (4, "f 1 2 4\n"), "far": (4, "f 1 2 99999999999999999999\n"),
               "before": (4, "f -1 -2 -4\n"), "two": (4, "f 1 2\n"), "letters": (4, "f a b c\n"),
               "slashes": (4, "f 1//// 2 3\n"), "uv": (4, "f 1/1 2/1 3/1\n"), "normal": (4, "f 1//1 2//1 3//1\n"),
               "comma": (4, "v 0,5 1 2\nf 1 2 3\n"), "nan": (4, "v nan 0 0\nf 1 2 4\n"),
               "inf": (4, "v inf 0 0\nf 1 2 4\n"), "great": (4, "v 1e400 0 0\nf 1 2 4\n"),
               "short": (4, "v 1 2\nf 1 2 3\n"), "word": (4, "v 1 2 x\nf 1 2 3\n"),
               "fraction": (4, "f 1.5 2 3\n"), "plus": (4, "f 1 2 3/\x01\n")}
        for name, (line, text) in bad.items():
            file = self.write(f"{name}.obj", TRIANGLE + text)
            for loader in ("textbook", "scan", "parallel"):
                self.refuse(CHAPTERS["01"], "--dump-mesh", file, "--loader", loader, says=f"{name}.obj:{line}: ")
            for loader in ("tinyobjloader", "assimp"):
                with self.subTest(name=name, loader=loader):
                    done = self.run_program(CHAPTERS["01"], "--dump-mesh", file, "--loader", loader)
                    self.assertIn(done.returncode, (0, 2), done.stderr)
                    self.assertEqual(done.stderr.count("error: "), 1 if done.returncode else 0, done.stderr)
        for name, text in (("no_face", TRIANGLE), ("comment", "# nothing\n")):
            self.refuse(CHAPTERS["01"], "--dump-mesh", self.write(f"{name}.obj", text), says="no face")
        self.write("bad.mtl", "newmtl a\nKd red\n")
        self.refuse(CHAPTERS["01"], "--dump-mesh",
                    self.write("mtl.obj", "mtllib bad.mtl\n" + TRIANGLE + "usemtl a\nf 1 2 3\n"), says=r"bad\.mtl:2: ")

    def test_obj_lines_that_are_unusual_but_fine(self):
        good = {"negative": "f -3 -2 -1\n", "skipped": "vn 0 0 1\nf 1//1 2//1 3//1\n", "continued": "f 1 \\\n2 3\n",
                "no_end": "f 1 2 3", "stray": "f 1 2 3\ng", "colours": "v 0 0 0 1 0 0\nf 1 2 3\n",
                "tiny": "v 1e-400 0 0\nf 1 2 3\n", "bom": None, "crlf": None, "name with spaces": "f 1 2 3\n"}
        for name, text in good.items():
            whole = TRIANGLE + (text or "f 1 2 3\n")
            whole = "\ufeff" + whole if name == "bom" else whole.replace("\n", "\r\n") if name == "crlf" else whole
            file = self.write(f"{name}.obj", whole)
            for loader in ("textbook", "scan", "parallel"):
                with self.subTest(name=name, loader=loader):
                    done = self.run_program(CHAPTERS["01"], "--dump-mesh", file, "--loader", loader,
                                            LC_ALL="de_DE.UTF-8")
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    self.assertEqual(json.loads(done.stdout)["triangles"], 1)
        file = self.write("no_mtl.obj", "mtllib missing.mtl\n" + TRIANGLE + "usemtl a\nf 1 2 3\n")
        done = self.run_program(CHAPTERS["01"], "--dump-mesh", file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"\Awarning: .*missing\.mtl")

    # --- scenes

    def scene(self, name, **keys) -> pathlib.Path:
        return self.write(name, json.dumps(keys))

    def test_scene_files(self):
        cube = {"name": "cube", "model": "models/cube.obj"}
        scenes = {
            "syntax.json": ('{\n "objects": [\n  {"model": }\n ]\n}', r"syntax\.json:3"),
            "cut.json": ('{"objects": [{"model": "models/cube', r"cut\.json:1"),
            "empty.json": ("", r"empty\.json"),
            "binary.json": (bytes(range(256)), r"binary\.json"),
            "list.json": ("[]", "object"), "number.json": ("7", "object"),
            "deep.json": ('{"objects": ' + "[" * 100000, r"deep\.json"),
            "key.json": ({"objects": [cube], "camra": {}}, "camra.*known.*camera"),
            "inner_key.json": ({"objects": [cube | {"modle": 1}]}, "modle.*known.*model"),
            "type.json": ({"camera": {"position": "here"}}, "position.*three numbers"),
            "type_of_list.json": ({"objects": {}}, "objects.*list"),
            "type_of_name.json": ({"objects": [{"model": 7}]}, "model.*text"),
            "type_of_light.json": ({"objects": [cube], "lights": [{"type": "laser"}]}, "laser.*directional"),
            "type_of_maps.json": ({"objects": [cube | {"material": {"maps": {"diffuse": 7}}}]}, "diffuse"),
            "range.json": ({"objects": [cube], "camera": {"fov_deg": 200}}, "fov_deg.*170"),
            "huge.json": ('{"camera": {"far_m": 1e999}}', r"huge\.json"),
            "nan.json": ('{"camera": {"far_m": NaN}}', r"nan\.json:1"),
            "blind.json": ({"objects": [cube], "camera": {"position": [0, 0, 0], "target": [0, 0, 0]}}, "target"),
            "flat.json": ({"objects": [cube | {"scale": 0}]}, "scale"),
            "no_model.json": ({"objects": [{"model": "models/missing.obj"}]}, r"no_model\.json:1.*missing\.obj"),
            "no_map.json": ({"objects": [cube | {"material": {"maps": {"diffuse": "no.png"}}}]}, r"no\.png"),
            "slot.json": ({"objects": [cube | {"material": {"maps": {"colour": "models/smart_car_albedo.png"}}}]},
                          "colour.*diffuse"),
            "no_include.json": ({"include": ["missing.json"]}, r"missing\.json"),
            "cycle.json": ({"include": ["back.json"]}, "cycle"), "back.json": ({"include": ["cycle.json"]}, "cycle"),
            "self.json": ({"include": ["self.json"]}, "cycle"),
            "no_parent.json": ({"objects": [cube | {"parent": "nobody"}]}, "nobody"),
            "own_parent.json": ({"objects": [cube | {"parent": "cube"}]}, "cycle"),
            "parents.json": ({"objects": [cube | {"parent": "b"}, cube | {"name": "b", "parent": "cube"}]}, "cycle"),
            "twins.json": ({"objects": [cube, cube]}, "two objects"),
            "knob.json": ({"objects": [cube], "knobs": {"speed": 1}}, "speed.*has"),
            "knob_value.json": ({"objects": [cube], "knobs": {"wrap": "much"}}, "wrap.*expected"),
            "knob_type.json": ({"objects": [cube], "knobs": {"wrap": [1]}}, "wrap.*expected"),
            "rough.json": ({"objects": [cube | {"material": {"roughness": 1.5}}]}, "roughness.*1.5.*0.*1"),
            "metal.json": ({"objects": [cube | {"material": {"metalness": "much"}}]}, "metalness.*number"),
        }
        for name, (content, _) in scenes.items():
            self.write(name, json.dumps(content) if isinstance(content, dict) else content)
        for name, (_, says) in scenes.items():
            self.draw("02", "--scene", self.folder / name, says=says)

    def test_environments(self):
        """Some of these are found only when the image is read; the scene's line and key are named all the same."""
        cube = {"model": "models/cube.obj"}
        images = {"cut.hdr": radiance(64, 32)[:900], "zero.hdr": b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 0\n",
                  "text.hdr": "no picture", "empty.hdr": b"", "square.hdr": radiance(64, 64), "wide.hdr": radiance(64, 8),
                  "cut.pfm": b"PF\n4 2\n-1.0\n"}
        for name, content in images.items():
            image = self.write(name, content)
            says = {"square.hdr": "64x64.*twice as wide", "wide.hdr": "64x8.*twice as wide"}.get(name, re.escape(name))
            for given, key in ((str(image), "environment"), ({"image": str(image)}, "image")):
                text = '{"objects": [%s],\n"environment": %s}' % (json.dumps(cube), json.dumps(given))
                self.draw("02", "--scene", self.write("scene.json", text), says=rf"scene\.json:2: key '{key}': .*" + says)
        self.write("folder.hdr/x", "")
        good = self.write("good.hdr", radiance(64, 32))
        for given, says in ((str(self.folder / "none.hdr"), r"key 'environment'.*none\.hdr"),
                            (str(self.folder / "folder.hdr"), r"key 'environment'.*folder\.hdr"),
                            ("models/cube.obj", r"key 'environment'.*\.hdr"), ("", r"key 'environment'.*\.hdr"),
                            (7, "key 'environment'.*object"), ({}, "key 'image' is missing"),
                            ({"image": 7}, "key 'image'.*text"),
                            ({"image": str(good), "intensity": -1}, "key 'intensity' is -1"),
                            ({"image": str(good), "turn": 1}, "key 'turn' is unknown")):
            self.draw("02", "--scene", self.scene("scene.json", objects=[cube], environment=given), says=says)
        for given in (str(good), {"image": str(good), "intensity": 0, "rotation_deg": 720}):
            scene = self.scene("scene.json", objects=[cube], environment=given)
            done = self.run_program(CHAPTERS["02"], "--size", "64x48", "--scene", scene, "--screenshot", self.picture)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.picture.unlink()

    def test_motions(self):
        wrong = {"{}": "key 'motion'", "7": "key 'motion'", '{"spin_deg_per_s": NaN}': r"scene\.json:1",
                 '{"spin_deg_per_s": 1e999}': r"scene\.json:1", '{"spin_deg_per_s": [1]}': "key 'spin_deg_per_s'",
                 '{"path": []}': "key 'path'", '{"path": [{"time_s": 1}, {"time_s": 1}]}': "key 'time_s'",
                 '{"path": [{"time_s": 1, "positon": [0, 0, 0]}]}': "positon.*known.*position"}
        for motion, says in wrong.items():
            scene = self.write("scene.json", '{"objects": [{"model": "models/cube.obj", "motion": %s}]}' % motion)
            self.draw("02", "--scene", scene, says=says)

    def test_lights(self):
        """What a light can be given wrong, by the key that the error must name. NaN and infinities are no JSON."""
        wrong = {"intensity": ["-1", "-1e-9", "1000001", "1e300", "1e999", "-1e999", "NaN", "Infinity", '"bright"', "[1]"],
                 "range_m": ["-1", "1e7", "1e999", "NaN", "-Infinity"], "softness": ["-0.1", "1.1", "NaN"],
                 "inner_deg": ["-1", "31", "181"], "outer_deg": ["-1", "19", "181", "1e999"],
                 "color": ["[1, 1]", "[1, 1, 2]", "[-1, 0, 0]", "[NaN, 0, 0]", "1"],
                 "position": ["[0, 0, 1e999]", "[0, Infinity, 0]", "0"], "direction": ["[0, 0, 0]", "[0, NaN, 1]"]}
        right = {"type": '"spot"', "inner_deg": "20", "outer_deg": "30"}
        for key, values in wrong.items():
            for number, value in enumerate(values):
                keys = ", ".join(f'"{name}": {text}' for name, text in (right | {key: value}).items())
                number_is_no_json = value.strip("[]-0, 1").startswith(("NaN", "Inf")) or "999" in value
                scene = self.write(f"{key}{number}.json", f'{{"lights": [\n{{{keys}}}]}}')
                self.draw("02", "--scene", scene,
                          says=rf"{key}{number}\.json:2" + ("" if number_is_no_json else ".*(inner_deg|" + key + ")"))
        for light in ('"type": "point", "softness": 1', '"type": "directional", "range_m": 3', '"type": "laser"'):
            self.draw("02", "--scene", self.write("key.json", f'{{"lights": [\n{{{light}}}]}}'), says=r"key\.json:2")

    def test_textures_that_are_damaged(self):
        jpeg, hdr = encoded((64, 64), "JPEG"), radiance()
        textures = {
            "empty.png": b"", "text.png": "no picture", "cut.png": png()[:-200], "header.png": png()[:20],
            "grey.png": png(mode="L")[:60], "cut.jpg": jpeg[:len(jpeg) // 2], "header.jpg": jpeg[:30],
            "cut.hdr": hdr[:len(hdr) // 2], "row.hdr": hdr[:70], "text.hdr": "no picture", "header.hdr": hdr[:15],
            "empty.hdr": b"",
            "huge.hdr": b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 999999999 +X 999999999\n" + bytes(64),
            "huge.png": png()[:16] + struct.pack(">II", 1 << 30, 1 << 30) + png()[24:],
            "none.png": png()[:16] + struct.pack(">II", 0, 0) + png()[24:],
            "folder.png": None,
        }
        for name, content in textures.items():
            texture = self.folder / name
            texture.mkdir() if content is None else self.write(name, content)
            scene = self.scene(name + ".json", objects=[
                {"model": "models/cube.obj", "material": {"maps": {"diffuse": str(texture)}}}])
            self.draw("02", "--scene", scene, says=re.escape(name))
        for slot, mode in (("normal", "L"), ("normal", "LA"), ("orm", "L"), ("orm", "LA"), ("detail_normal", "L")):
            texture = self.write(f"{mode}.png", png(mode=mode))
            scene = self.scene(f"{slot}.json", objects=[
                {"model": "models/cube.obj", "material": {"maps": {slot: str(texture)}}}])
            for chapter in ("02", "04"):
                self.draw(chapter, "--scene", scene, says=f"{slot} map: .*{mode}.png: has .* channel.*three")
        mtl = self.write("cut.mtl", f"newmtl a\nmap_Kd {self.folder / 'cut.jpg'}\n".replace(str(self.folder) + "/", ""))
        model = self.write("cut.obj", f"mtllib {mtl.name}\n{TRIANGLE}vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n")
        done = self.run_program(CHAPTERS["01"], "--size", "64x48", "--scene", model, "--screenshot", self.picture)
        self.assertEqual(done.returncode, 0, done.stderr)  # what an MTL file names is not worth losing the shape for
        self.assertRegex(done.stderr, r"\Awarning: [^\n]*cut\.jpg[^\n]*\n\Z")
        whole = self.write("whole.hdr", hdr)
        scene = self.scene("whole.json", objects=[
            {"model": "models/cube.obj", "material": {"maps": {"diffuse": str(whole)}}}])
        done = self.run_program(CHAPTERS["02"], "--size", "64x48", "--scene", scene, "--screenshot", self.picture)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    # --- options

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
                (["--set", "wrap"], "NAME=VALUE"), (["--set", "speed=1"], "speed.*has"), (["--set", "=1"], "knob"),
                (["--set", "wrap=2"], "wrap=2.*0 to 1"), (["--set", "wrap=nan"], "wrap=nan"),
                (["--set", "wrap=inf"], "wrap"), (["--set", "wrap=1e999"], "wrap"), (["--set", "wrap="], "wrap"),
                (["--set", "shininess=-5"], "shininess"), (["--set", "samples=1.5"], "samples"),
                (["--set", "samples=1e10"], "samples"), (["--set", "wrap_tint=1,1"], "wrap_tint"),
                (["--set", "wrap_tint=1,1,1,1"], "wrap_tint"), (["--wrap", "7"], "wrap"),
                (["--method", "best"], "best.*phong"), (["--method", "auto"], "budget"),
                (["--method", "auto", "--budget", "nan"], "budget"), (["--method", "auto", "--budget", "-1"], "budget"),
                (["--budget", "much"], "budget"), (["--explain"], "auto"),
                (["--shot", "missing"], "missing.*teapot"), (["--shot", ""], "shot"),
                (["--device", "quantum"], "quantum.*there are"), (["--validate", "maybe"], "validate"),
                (["--list", "everything"], "list"), (["--unknown"], "unknown"), (["stray"], "stray"),
                (["--scene"], "scene"), (["--scene", ""], "scene|file"), (["--size"], "size"),
                (["--set"], "set")):
            self.refuse(CHAPTERS["02"], "--screenshot", self.picture, *arguments, says=says)
        self.refuse(CHAPTERS["01"], "--screenshot", self.picture, "--loader", "fastest", says="fastest.*textbook")
        self.refuse(CHAPTERS["01"], "--loads", "0", "--screenshot", self.picture, says="loads")

    def test_a_chapter_that_there_is_not(self):
        for words in (["run", "77"], ["run", "no_such"], ["nonsense"], ["check", "77"], ["accept", "02.none"]):
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


if __name__ == "__main__":
    unittest.main()
