"""Unreadable inputs and protected outputs: pipes, devices, links, impossible names.

One line with the reason, exit code 2, and existing files stay.
"""
import contextlib
import json
import os
import stat
import struct
import time
import unittest

from bad_input import CHAPTERS, ROOT, BadInput, encoded

CHAPTER_03 = CHAPTERS["02"].with_name("03_attenuation")
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def pfm(values=(1.0,) * 24) -> bytes:
    return b"PF\n4 2\n-1.0\n" + struct.pack("<24f", *values)


class Places(BadInput):
    def pipe(self, name):
        os.mkfifo(self.folder / name)
        return self.folder / name

    def test_inputs_that_are_no_files(self):
        """Nobody writes to the pipe: opening it would block forever."""
        cube = {"model": "models/cube.obj"}
        self.write("pipe.obj.mtl", "")
        for kind, place in (("pipe", str(self.pipe("pipe.obj"))), ("device", "/dev/zero")):
            self.draw("02", "--scene", place, says=f"is a {kind}|unknown model format")
            self.draw("02", "--scene", self.scene("scene.json", objects=[{"model": place}]), says=f"is a {kind}|format")
            self.draw("02", "--scene", self.scene("scene.json", include=[place]), says=f"is a {kind}")
            self.draw("02", "--scene", self.scene("scene.json", objects=[
                cube | {"material": {"maps": {"diffuse": place}}}]), says=f"is a {kind}")
            for loader in ("textbook", "tinyobjloader", "assimp"):
                self.refuse(CHAPTERS["01"], "--dump-mesh", self.folder / "pipe.obj", "--loader", loader, says="is a pipe")
        self.pipe("pipe.mtl")
        model = self.write("mtl.obj", "mtllib pipe.mtl\n" + TRIANGLE + "usemtl a\nf 1 2 3\n")
        done = self.run_program(CHAPTERS["01"], "--dump-mesh", model)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"\Awarning: [^\n]*pipe\.mtl")

    def test_names_that_no_file_has(self):
        (self.folder / "around.json").symlink_to("around.json")
        self.draw("02", "--scene", self.folder / "around.json", says="no file .*around.json, .*[Ss]ymbolic link")
        self.draw("02", "--scene", self.folder / ("x" * 300 + ".json"), says="no file .*, File name too long")
        self.draw("02", "--scene", self.scene("scene.json", include=["around.json"]), says=r"around\.json")
        self.draw("02", "--scene", self.scene("scene.json", include=["x" * 300]), says="no file")
        self.draw("02", LIGHTWALK_ROOT=str(self.folder), says="LIGHTWALK_ROOT=.*shaders/common")
        # A line break, or an escape sequence, in a name stays within the line.
        name = self.write("two\nlines\x1b[31m.json", '{"objects": [],\n "red\\u001b[31m\\nkey": 1}')
        self.draw("02", "--scene", name, says=r"two\\x0alines\\x1b\[31m\.json:2: key 'red\\x1b\[31m\\x0akey' is unknown")
        model = os.fsencode(self.folder) + b"/\xff\xfe.obj"
        with open(model, "w") as out:
            out.write(TRIANGLE + "f 1 2 3\n")
        done = self.run_program(CHAPTERS["01"], "--load-bench", os.fsdecode(model), "--json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(len(json.loads(done.stdout)["loaders"]), 5)

    def test_outputs_that_are_no_files(self):
        pipe, target = self.pipe("pipe.png"), self.write("inner/target.png", "old")
        link = self.folder / "link.png"
        link.symlink_to("inner/target.png")
        places = [(pipe, "is a pipe")]
        if os.geteuid() == 0:  # who could destroy the system's own, should this fail
            with contextlib.suppress(PermissionError):
                os.mknod(self.folder / "device.png", stat.S_IFCHR | 0o600, os.makedev(1, 3))
                places.append((self.folder / "device.png", "is a device"))
        else:
            places += [("/dev/null", "is a device"), ("/dev/stdout", "is a pipe")]
        for option in ("--screenshot", "--timings", "--study"):
            for place, says in places:
                self.refuse(CHAPTERS["02"], "--size", "64x48", option, place, says=f"cannot be written: {says}")
        self.assertTrue(pipe.is_fifo())
        done = self.run_program(CHAPTERS["02"], "--size", "64x48", "--screenshot", link)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(link.is_symlink())
        self.assertEqual(target.read_bytes()[:4], b"\x89PNG")

    def test_numbers_that_no_picture_can_be_made_of(self):
        nan = self.write("nan.pfm", pfm((1.0,) * 23 + (float("nan"),)))
        cube = {"model": "models/cube.obj"}
        self.draw("02", "--scene", self.scene("scene.json", objects=[cube], environment=str(nan)),
                  says=r"scene\.json:1: key 'environment': .*nan\.pfm: 1 of its values are NaN")
        self.draw("02", "--scene", self.scene("scene.json", objects=[
            cube | {"material": {"maps": {"diffuse": str(nan)}}}]), says=r"nan\.pfm: 1 of its values are NaN")
        self.write("great.mtl", "newmtl a\nNs 1e30\nKs 1 1 1\nKe 1e38 0 0\nd -1\n")
        model = self.write("great.obj", "mtllib great.mtl\n" + TRIANGLE + "usemtl a\nf 1 2 3\n")
        done = self.run_program(CHAPTERS["02"], "--size", "64x48", "--scene", model, "--screenshot", self.picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"\Awarning: [^\n]*great\.mtl: material 'a': [^\n]*shininess 1e\+30 is drawn as 100000")
        self.draw("02", "--scene", self.write("far.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                  says=r"far\.obj: .*1e\+30")

    @unittest.skipUnless((ROOT / "shaders/02_lambert_phong/solution/lambert.glsl").exists(), "a handout")
    def test_a_picture_that_fails_leaves_the_one_before(self):
        self.picture.write_bytes(b"the one before")
        self.write("overlay/shaders/02_lambert_phong/solution/lambert.glsl",
                   "float lambert(vec3 normal, vec3 to_light) { return uintBitsToFloat(0x7fc00000u); }\n")
        self.draw("02", code=1, says="holds [1-9][0-9]* NaN", LIGHTWALK_OVERLAY=str(self.folder / "overlay"))
        self.assertEqual(self.picture.read_bytes(), b"the one before")

    @unittest.skipUnless((ROOT / "shaders/02_lambert_phong/solution/lambert.glsl").exists(), "a handout")
    def test_a_byte_order_mark_is_no_part_of_a_shader(self):
        place = "shaders/02_lambert_phong/solution/lambert.glsl"
        self.write(f"overlay/{place}", b"\xef\xbb\xbf" + (ROOT / place).read_bytes())
        done = self.run_program(CHAPTERS["02"], "--size", "16x16", "--screenshot", self.picture, LIGHTWALK_OVERLAY=str(self.folder / "overlay"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))

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
        cache.chmod(0o700)
        if os.geteuid() == 0:
            os.chown(cache, 1234, 1234)
            self.assertEqual(kept(), [])
        cache.rmdir()
        self.assertNotEqual(kept(), [])
        self.assertEqual(cache.stat().st_mode & 0o777, 0o700)

    def test_a_size_that_is_too_large_is_refused_at_once(self):
        start = time.monotonic()
        self.refuse(CHAPTERS["02"], "--size", "16384x16384", "--screenshot", self.picture, says="16384x16384: too large")
        self.assertLess(time.monotonic() - start, 20)  # under a sanitizer; it took half a minute to draw

    def test_pictures_that_are_cut_off(self):
        for kind in ("GIF", "BMP", "TGA"):
            whole = encoded((64, 64), kind)
            texture = self.write(f"cut.{kind.lower()}", whole[:len(whole) * 2 // 3])
            self.draw("02", "--scene", self.scene("scene.json", objects=[
                {"model": "models/cube.obj", "material": {"maps": {"diffuse": str(texture)}}}]), says="is cut off")

    def test_a_face_that_names_what_is_not_there(self):
        model = self.write("absent.obj", TRIANGLE + "vn 0 0 1\n\nf 1//1 2//7 3//7\nf 1/5 2/5 3/5\n")
        said = None
        for loader in ("textbook", "scan", "parallel"):
            done = self.run_program(CHAPTERS["01"], "--dump-mesh", model, "--loader", loader)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, said or done.stderr)
            said = done.stderr
        self.assertRegex(said, r"\Awarning: [^\n]*absent\.obj:6: [^\n]*5 in the file[^\n]*\n\Z")

    def test_a_scene_without_lights(self):
        scene = self.scene("dark.json", objects=[{"model": "models/cube.obj"}], ambient=[0.2, 0.2, 0.2])
        for method in ("tiled", "clustered"):
            done = self.run_program(CHAPTER_03, "--size", "64x48", "--scene", scene, "--method", method, "--validate",
                                    "on", "--screenshot", self.picture)
            self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
