"""Models and pictures that are wrong: one line that says so, exit code 2, and nothing left behind."""
import json
import re
import struct
import unittest

from bad_input import CHAPTERS, ROOT, BadInput, encoded, png, radiance

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
LOADERS = ("textbook", "tinyobjloader", "assimp", "scan", "parallel")


class Files(BadInput):
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
               "slashes": (4, "f 1//// 2 3\n"),
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
        scene = self.scene("swell.json", objects=[
            {"model": "models/cube.obj", "material": {"maps": {"displacement": "no_swell.png"}}}])
        self.draw("04", "--scene", scene, says="no_swell.png")
        mtl = self.write("cut.mtl", f"newmtl a\nmap_Kd {self.folder / 'cut.jpg'}\n".replace(str(self.folder) + "/", ""))
        model = self.write("cut.obj", f"mtllib {mtl.name}\n{TRIANGLE}vt 0 0\nusemtl a\nf 1/1 2/1 3/1\n")
        done = self.run_program(CHAPTERS["01"], "--size", "64x48", "--scene", model, "--screenshot", self.picture)
        self.assertEqual(done.returncode, 0, done.stderr)  # a bad MTL file must not lose the shape
        self.assertRegex(done.stderr, r"\Awarning: [^\n]*cut\.jpg[^\n]*\n\Z")
        whole = self.write("whole.hdr", hdr)
        scene = self.scene("whole.json", objects=[
            {"model": "models/cube.obj", "material": {"maps": {"diffuse": str(whole)}}}])
        done = self.run_program(CHAPTERS["02"], "--size", "64x48", "--scene", scene, "--screenshot", self.picture)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
