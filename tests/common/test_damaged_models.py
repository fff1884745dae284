"""Each file of the conformance set, cut off and damaged in many ways: drawn, or refused in one line with exit code 2.
A number behind the file, 100, damages each so many times."""
# Builds: 04_surface_maps
import random
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from shots.rendering import Drawing
from tree import ROOT

NUMBERS = [b"0", b"-1", b"1e30", b"nan", b"65536", b"4294967295", b"99999999999999999999", b""]
CHAPTER = "04_surface_maps"
SET = ROOT / "assets" / "conformance"
CUTS, FAULTS = 2, int(sys.argv.pop()) if sys.argv[-1].isdigit() else 2
# Files that others name.
SHOWN_BY = {".mtl": lambda file: file.with_suffix(".obj").name, ".png": lambda _: "texture.gltf",
            ".bin": lambda _: "escaped_name.gltf"}
MODELS = {".gltf", ".glb", ".obj", ".ply", ".stl", ".off", ".fbx", ".dae", ".3mf"}


def damaged(data: bytes, rng: random.Random) -> bytes:
    """One fault or a few, most of them near the beginning, where the lengths are."""
    out = bytearray(data)
    for _ in range(rng.choice([1, 1, 1, 2, 8])):
        at = rng.randrange(min(len(out), rng.choice([64, 1024, 1 << 30]))) if out else 0
        kind = rng.randrange(7)
        if kind == 0:
            out[at:at + 1] = bytes([rng.randrange(256)])
        elif kind == 1:
            out[at:at + 4] = rng.choice([b"\xff\xff\xff\xff", b"\0\0\0\0", b"\xff\xff\xff\x7f", b"\0\0\0\x80"])
        elif kind == 2:
            del out[at:]
        elif kind == 3:
            del out[at:at + rng.randint(1, 64)]
        elif kind == 4:
            out[at:at] = out[at:at + rng.randint(1, 4096)]
        elif kind == 5:
            out[at:at] = bytes(rng.randrange(256) for _ in range(rng.randint(1, 16)))
        else:
            numbers = list(re.finditer(rb"-?\d+(\.\d+)?", out[at:at + 4096]))
            if numbers:
                begin, end = rng.choice(numbers).span()
                out[at + begin:at + end] = rng.choice(NUMBERS)
    return bytes(out)


def variants(file: Path) -> list[bytes]:
    data = file.read_bytes()
    cut = [data[:len(data) * i // CUTS] for i in range(CUTS)]
    return cut + [damaged(data, random.Random(f"{file.name} {i}")) for i in range(FAULTS)]


class DamagedModels(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory())) / "set"
        shutil.copytree(SET, self.folder)
        self.drawing = self.enterContext(Drawing(CHAPTER, "off"))

    def draw(self, model: str) -> tuple[int, str, str]:
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
