"""A composition exists once: a scene with the same knobs is the same picture, to the byte, drawn by its chapter, as a
film's scene, and by the editor without its marks; and chapter 15's world stands elsewhere (compositions/anywhere.cpp).
"""
import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "common"))
from part_in_ci import part  # noqa: E402
from picture_drawing import BUILD, BUILT, HAS_SOLUTION, ROOT, Drawing, knobs_of, sets, steps  # noqa: E402

# Chapters with the same bloom, tones and encoding as a film's scene, by the scene's kind. Chapters 10 and 11 encode
# by a curve of their own.
KINDS = {"06_deferred": "lights", "12_skin": "head", "14_environment": "surroundings", "15_terrain_water": "water",
         "16_volume": "volume", "17_planets": "planets", "18_playground": "workbench"}
# Knobs of a chapter alone; shots that leave them at their defaults can be shown by a film.
ALONE = {"method", "samples", "cull", "overdraw", "prepass", "show", "level", "dolly", "select", "picker.method", "mlaa.method"}
SIZE = (96, 54)


def shots_of(chapter: str) -> list[dict]:
    return json.loads((ROOT / "tests" / chapter / "shots.json").read_text())["shots"]


def settings(shot: dict) -> dict:
    """The shot's settings, its scene file and that file's includes."""
    found, files = {}, [ROOT / shot["scene"]]
    while files:
        file = files.pop()
        if file.suffix == ".json":
            scene = json.loads(file.read_text())
            found = {**scene.get("knobs", {}), **found}
            files += [file.parent / name for name in scene.get("include", [])]
    return {**found, **shot.get("set", {})}


def film_of(kind: str, shot: dict) -> dict:
    return {"duration_s": 5, "knobs": {"smoothed": 0}, "scenes": [
        {"name": "only", "kind": kind, "scene": str(ROOT / shot["scene"]), "from_s": 0, "to_s": 5,
         "clock_s": shot.get("time_s", 0), "knobs": shot.get("set", {})}]}


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class Worlds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="lightwalk_worlds_")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.count = 0

    def drawing(self, program: Path | str) -> Drawing:
        drawing = Drawing(program)
        self.addCleanup(drawing.close)
        return drawing

    def draw(self, drawing: Drawing, *options) -> Path:
        type(self).count += 1
        picture = Path(self.folder.name, f"{self.count}.png")
        code, wrong, _ = drawing.draw(["--size", "{}x{}".format(*SIZE), *map(str, options)], picture)
        self.assertEqual((code, wrong), (0, ""), options)
        return picture

    def shot(self, drawing: Drawing, shot: dict) -> Path:
        return self.draw(drawing, "--shot", shot["name"])

    def film(self, name: str, content: dict) -> Path:
        file = Path(self.folder.name, f"{name}.film")
        file.write_text(json.dumps(content))
        return file

    def without_bloom(self, scene: str) -> Path:
        """A copy of the scene for a chapter that has no bloom."""
        content = json.loads((ROOT / scene).read_text())
        content["knobs"] = {name: value for name, value in content["knobs"].items() if not name.startswith("bloom.")}
        for placed in content["objects"]:
            placed["model"] = str(ROOT / "assets" / placed["model"])
        file = Path(self.folder.name, Path(scene).name)
        file.write_text(json.dumps(content))
        return file

    def test_a_film_shows_what_the_chapter_shows(self):
        film = self.drawing("19_ambiance")
        for chapter, kind in KINDS.items():
            own = self.drawing(chapter)
            shown = [shot for shot in shots_of(chapter)
                     if "scene" in shot and not ALONE & settings(shot).keys() and shot.get("frames", 1) == 1]
            self.assertGreaterEqual(len(shown), 2, chapter)
            for shot in part(shown, len(shown)):
                with self.subTest(chapter=chapter, shot=shot["name"]):
                    there = self.draw(film, "--scene", self.film(shot["name"], film_of(kind, shot)), "--time", 0)
                    self.assertEqual(steps(self.shot(own, shot), there), 0)

    def test_a_film_shows_its_water_s_rays(self):
        """With land and city in them: it was the sky alone."""
        shot = {"scene": "assets/scenes/lake_city.json", "set": {"water.reflection": "rays"}}
        there = self.draw(self.drawing("19_ambiance"), "--scene", self.film("rays", film_of("water", shot)))
        own = self.draw(self.drawing("15_terrain_water"), "--scene", ROOT / shot["scene"], *sets("water.reflection=rays"))
        self.assertEqual(steps(own, there), 0)

    def test_the_editor_without_its_marks_shows_what_the_chapter_shows(self):
        # The editor's probe is one of its sky: a room's own probe it does not have yet.
        own, editor = self.drawing("14_environment"), self.drawing("18_playground")
        known = knobs_of("18_playground")
        shown = [shot for shot in shots_of("14_environment")
                 if shot["name"] != "probe" and all(name in known for name in settings(shot)) and shot.get("frames", 1) == 1]
        self.assertGreaterEqual(len(shown), 3)
        for shot in part(shown, len(shown)):
            with self.subTest(shot=shot["name"]):
                knobs = sets("marks.on=off", *(f"{name}={value}" for name, value in shot.get("set", {}).items()))
                there = self.draw(editor, "--scene", ROOT / shot["scene"], "--time", shot.get("time_s", 0), *knobs)
                self.assertEqual(steps(self.shot(own, shot), there), 0)

    def test_a_world_stands_elsewhere(self):
        """In a throw-away chapter that names none of its modules."""
        anywhere, scene = self.drawing(BUILD / "tests" / "anywhere"), self.without_bloom("assets/scenes/lake_city.json")
        plain, mirror, cube = (self.draw(anywhere, "--scene", scene, *sets(f"show={show}"))
                               for show in ("world", "mirror", "cube"))
        one = {"scene": scene}
        film = self.draw(anywhere, "--scene", self.film("five_seconds", film_of("water", one)), "--time", 4.9)
        for other in (mirror, cube, film):
            self.assertGreater(steps(plain, other), 20)
        chapter = self.draw(self.drawing("15_terrain_water"), "--scene", scene, *sets("post.tone=off"))
        self.assertEqual(steps(plain, chapter), 0)


if __name__ == "__main__":
    unittest.main()
