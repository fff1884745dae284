"""Pictures of chapter 02 that must be equal to others."""
from PIL import Image

from pictures import LINEAR, ChapterPictures, to_code

WIDTH, HEIGHT, SAMPLES = 12, 8, 8
MODEL = """v -9 -3 0
v 9 -3 0
v 0 9 0
vn -0.5 -0.3 1
vn 0.6 -0.4 1
vn 0.1 0.7 1
f 1//1 2//2 3//3
"""
SCENE = {
    "camera": {"position": [0, 0, 1], "target": [0, 0, 0], "fov_deg": 100, "near_m": 0.1, "far_m": 10},
    "background": [1, 0, 1], "ambient": [0.02, 0.05, 0.01],
    "lights": [{"type": "directional", "direction": [-0.2, 0.1, -1], "intensity": 0.8},
               {"type": "directional", "direction": [0.7, -0.5, -1], "intensity": 0.6, "color": [1, 0.5, 0.2]}]}


class PicturesTest(ChapterPictures):
    chapter = "02_lambert_phong"

    def setUp(self):
        super().setUp()
        (self.folder / "triangle.obj").write_text(MODEL)

    def draw(self, scale, *options, shininess=250):
        """Rows of (r, g, b) codes: one triangle that faces the camera and fills the picture."""
        material = {"diffuse": [0.3, 0.2, 0.1], "specular": [0.01, 0.02, 0.03], "shininess": shininess}
        scene = SCENE | {"objects": [{"model": str(self.folder / "triangle.obj"), "material": material}]}
        picture = super().draw(scene, *options, size=f"{scale * WIDTH}x{scale * HEIGHT}")
        image = Image.open(picture).convert("RGB").load()
        return [[image[x, y] for x in range(scale * WIDTH)] for y in range(scale * HEIGHT)]

    def test_samples_are_the_average_of_smaller_pixels(self):
        """Pictures shifted within a pixel, and a larger picture with pixels at the same points: their means agree."""
        got, fine, one = self.draw(1, "--samples", "256"), self.draw(SAMPLES), self.draw(1)
        worst = moved = 0
        for y in range(HEIGHT):
            for x in range(WIDTH):
                for c in range(3):
                    mean = sum(LINEAR[fine[SAMPLES * y + j][SAMPLES * x + i][c]]
                               for j in range(SAMPLES) for i in range(SAMPLES)) / SAMPLES ** 2
                    worst = max(worst, abs(got[y][x][c] - to_code(mean)))
                    moved = max(moved, abs(one[y][x][c] - to_code(mean)))
        self.assertLess(worst, 1.5)  # steps of 1/255; both were rounded
        self.assertGreater(moved, 5)  # so that it matters where the samples lie

    def test_each_part_has_its_own_material_and_texture(self):
        """Under ambient light of 1 and no other a surface shows its colour as it is."""
        texture = Image.new("RGB", (64, 64), (200, 30, 90))
        texture.paste((40, 180, 250), (32, 0, 64, 64))
        texture.save(self.folder / "halves.png")
        (self.folder / "parts.mtl").write_text("newmtl plain\nKd 1 0 1\nKs 0 0 0\n"
                                               "newmtl halves\nKd 1 1 1\nKs 0 0 0\nmap_Kd halves.png\n")
        (self.folder / "parts.obj").write_text(
            "mtllib parts.mtl\nv -5 -5 0\nv 0 -5 0\nv 0 5 0\nv -5 5 0\nv 5 -5 0\nv 5 5 0\nvt 0.9 0.5\nvt 0.1 0.5\n"
            "usemtl plain\nf 1/1 2/1 3/1 4/1\nusemtl halves\nf 2/2 5/1 6/1 3/2\n")
        scene = {"camera": SCENE["camera"], "ambient": [1, 1, 1], "lights": [], "objects": [{"model": str(self.folder / "parts.obj")}]}
        for method in ("gouraud", "blinn_phong_normalised"):
            image = Image.open(super().draw(scene, "--method", method, size="64x48")).convert("RGB")
            self.assertEqual(image.getpixel((8, 24)), (255, 0, 255))
            self.assertEqual(image.getpixel((34, 24)), (200, 30, 90))

    def test_the_knob_shininess_takes_the_place_of_the_material_s(self):
        for method in ("gouraud", "phong", "blinn_phong_normalised"):
            own = self.draw(4, "--method", method)
            self.assertEqual(self.draw(4, "--method", method, "--shininess", "250", shininess=3), own)
            self.assertNotEqual(self.draw(4, "--method", method, shininess=3), own)
