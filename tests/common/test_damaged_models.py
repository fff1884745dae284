"""Each file of the conformance set, cut off and damaged in many ways: drawn, or refused in one line with exit code 2."""
# Builds: 04_surface_maps
import random
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common" / "course"))
from damaged_models import damaged  # noqa: E402
from shots.rendering import Drawing  # noqa: E402
from tree import ROOT  # noqa: E402

CHAPTER = "04_surface_maps"
SET = ROOT / "assets" / "conformance"
CUTS, FAULTS = 6, 10
# Files that others name.
SHOWN_BY = {".mtl": lambda file: file.with_suffix(".obj").name, ".png": lambda _: "texture.gltf",
            ".bin": lambda _: "escaped_name.gltf"}
MODELS = {".gltf", ".glb", ".obj", ".ply", ".stl", ".off", ".fbx", ".dae", ".3mf"}


def variants(file: Path) -> list[bytes]:
    data = file.read_bytes()
    cut = [data[:len(data) * i // CUTS] for i in range(CUTS)]
    return cut + [damaged(data, random.Random(f"{file.name} {i}")) for i in range(FAULTS)]


class DamagedModels(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "set"
        shutil.copytree(SET, self.folder)
        self.drawing = None

    def draw(self, model: str) -> tuple[int, str, str]:
        if not self.drawing or not self.drawing.is_alive():
            self.drawing = Drawing(CHAPTER, "off")
            self.addCleanup(self.drawing.close)
        return self.drawing.draw(["--scene", self.folder / model, "--size", "32x18"], self.folder / "picture.png")

    def test_drawn_or_refused_in_one_line(self):
        files = [f for f in sorted(SET.iterdir()) if f.suffix in MODELS or f.name in ("corners.png", "a square.bin")
                 or f.suffix == ".mtl"]
        counts = {0: 0, 2: 0}
        for file in files:
            model = SHOWN_BY.get(file.suffix, lambda f: f.name)(file)
            for number, data in enumerate(variants(file)):
                (self.folder / file.name).write_bytes(data)
                code, error, said = self.draw(model)
                with self.subTest(file=file.name, variant=number, error=error):
                    self.assertIn(code, (0, 2))
                    self.assertEqual(bool(error), code == 2)
                    self.assertNotIn("\n", error)
                    self.assertEqual([line for line in said.splitlines() if not line.startswith("warning: ")], [])
                    counts[code] += 1
            shutil.copy(file, self.folder / file.name)
        self.assertGreater(counts[0], 0)
        self.assertGreater(counts[2], 0)


if __name__ == "__main__":
    unittest.main()
