"""What the editor exports: Khronos' validator accepts it, and it is drawn as the scene that it came from.

The validator is of npm; where there is no npm, or no network, that part is passed over.
"""
# Builds: 04_surface_maps test_18_playground
import json
import os
import subprocess
from pathlib import Path

from PIL import Image, ImageChops

import npm
from pictures import BUILD, ROOT, ChapterPictures

VALIDATE = """
const validator = require('gltf-validator'), fs = require('fs'), path = require('path');
(async () => {
  for (const file of process.argv.slice(1)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {uri: path.basename(file),
      externalResourceFunction: uri => new Promise((ok, no) => fs.readFile(
        path.resolve(path.dirname(file), decodeURIComponent(uri)), (e, data) => e ? no(e.toString()) : ok(new Uint8Array(data))))});
    console.log(JSON.stringify({file, messages: report.issues.messages.filter(m => m.severity < 2)}));
  }
})();
"""
CONFORMANCE = ROOT / "assets" / "conformance"
# Those that are not read at all, or need a light or time of their own.
LEFT_OUT = {"next_version", "required_unknown", "single_sided"}
SCENE = {"camera": {"position": [1.2, 0.8, 3], "target": [0, 0, 0], "up": [0.2, 1, 0], "fov_deg": 40, "near_m": 0.1, "far_m": 50},
         "ambient": [0.2, 0.2, 0.25], "background": [0.1, 0.1, 0.1],
         "lights": [{"type": "directional", "direction": [-0.3, -0.5, -1], "intensity": 0.6}]}
# Tangents follow from the texture coordinates, as the specification allows.
EXPECTED = {"MESH_PRIMITIVE_GENERATED_TANGENT_SPACE"}
# glTF has no specular colour beside the base colour; tints beside a body are at most its base colour, and
# no metal transmits; the export names what it leaves out.
CANNOT_BE_SAID = {"specular_glossiness"}
CUBE = str(CONFORMANCE / "flat_normals.gltf")
MATERIALS = [{"diffuse": [0.8, 0.2, 0.1], "roughness": 0.05, "metalness": 1},
             {"diffuse": [0.2, 0.7, 0.1], "roughness": 0.35, "metalness": 0},
             {"diffuse": [0.2, 0.3, 0.8], "opacity": 0.5, "transmission": [0.2, 0.1, 0.5], "metalness": 0}, {"diffuse": [0, 0, 0], "emissive": [3, 1.2, 0]}]
MIXED = {**SCENE, "objects": [
    {"model": CUBE, "position": [i - 1.5, 0.3, 0], "scale": [0.2, 0.3, 0.2], "rotation_deg": [20, 40, 10 * i],
     "material": material} for i, material in enumerate(MATERIALS)] + [
    {"name": "group", "position": [0, -0.6, 0], "scale": [-1, 1, 1]},
    {"name": "kept", "parent": "group", "model": CUBE, "scale": 0.2, "rotation_deg": [0, 30, 0],
     "material": {"maps": {"diffuse": "textures/wood_albedo.jpg"}}}],
    "lights": [*SCENE["lights"], {"type": "point", "position": [0, 2, 1], "range_m": 6, "color": [1, 0.5, 0.2]},
               {"type": "spot", "position": [2, 2, 2], "direction": [-1, -1, -1], "inner_deg": 10, "outer_deg": 20}]}


class RoundTrip(ChapterPictures):
    chapter = "04_surface_maps"

    def exported(self, **scenes: dict) -> dict[str, tuple[Path, Path]]:
        """Of each scene its file and its export; both lie in a folder of the scene's name."""
        made = {}
        for name, scene in scenes.items():
            (self.folder / name).mkdir()
            file = self.folder / name / "scene.json"
            file.write_text(json.dumps(scene))
            made[name] = file, file.with_name("out.gltf")
        done = subprocess.run([BUILD / "tests" / "test_18_playground", "[.exported]"], capture_output=True, text=True,
                              input="\n".join(str(f) for f, _ in made.values()))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return made

    def conformance(self) -> dict[str, dict]:
        return {file.stem: {**SCENE, "objects": [{"name": "one", "model": str(file)}]}
                for file in sorted(CONFORMANCE.glob("*.gl*")) if file.stem not in LEFT_OUT}

    def steps(self, one: Path, other: Path) -> int:
        """By how many codes of 255 two scenes differ, at most, in all but 1 of 1000 pixels: edges are drawn from other
        numbers."""
        pictures = []
        for scene in (one, other):
            picture = scene.with_suffix(".png")
            self.run_program("--scene", scene, "--size", "160x120", "--screenshot", picture, silent=False)
            pictures.append(Image.open(picture).convert("RGB"))
        far = sorted(max(p) for p in ImageChops.difference(*pictures).getdata())
        return far[-len(far) // 1000]

    def test_the_validator_accepts_it(self):
        if why := npm.why_not("gltf-validator"):
            self.skipTest(why)
        files = [out for _, out in self.exported(mixed=MIXED, **self.conformance()).values()]
        done = subprocess.run(["node", "-e", VALIDATE, *files], capture_output=True, text=True, check=True,
                              env={**os.environ, "NODE_PATH": str(npm.FOLDER / "node_modules")})
        reports = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(len(reports), len(files))
        for report in reports:
            with self.subTest(report["file"]):
                self.assertEqual([m for m in report["messages"] if m["code"] not in EXPECTED], [])

    def test_the_picture_is_the_same(self):
        for name, (file, out) in self.exported(mixed=MIXED, **self.conformance()).items():
            if name in CANNOT_BE_SAID:
                continue
            with self.subTest(name):
                again = file.with_name("again.json")
                again.write_text(json.dumps({**json.loads(file.read_text()), "objects": [{"model": str(out)}]}))
                self.assertLessEqual(self.steps(file, again), 1)
