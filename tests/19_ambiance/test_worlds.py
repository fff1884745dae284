"""A composition exists once: a scene with the same knobs is the same picture, to the byte, drawn by its chapter, as a
film's scene, and by the editor without its marks; and chapter 15's world stands elsewhere (compositions/anywhere.cpp).
"""
# Builds: 05_shadow_maps 06_deferred 08_bloom 09_post_effects 10_atmosphere 11_fractals 12_skin 13_mlaa 14_environment 15_terrain_water 16_volume 17_planets 18_playground 19_ambiance anywhere compare
import json
import re
import tempfile
import unittest
from pathlib import Path

from picture_drawing import BUILD, BUILT, CHEAP, HAS_SOLUTION, ROOT, Drawing, knobs_of, sets, steps

# The kind of a film's scene that shows a chapter's world, and the module whose method its --method chooses. Chapters 01 to 04
# and 07 have no world: their frames draw a scene pass by pass, which is what they teach.
KINDS = {"05_shadow_maps": ("stage", "shadow"), "06_deferred": ("lights", "gbuffer"), "08_bloom": ("surfaces", "bloom"),
         "09_post_effects": ("lens", "dof"), "10_atmosphere": ("islands", "atmosphere"), "11_fractals": ("fractal", None),
         "12_skin": ("head", "skin"), "13_mlaa": ("outlines", "mlaa"), "14_environment": ("surroundings", "environment"),
         "15_terrain_water": ("water", "land"), "16_volume": ("volume", "volume"), "17_planets": ("planets", "planets"),
         "18_playground": ("workbench", None)}
# Knobs of a chapter outside its world: they show tables, edges or numbers in place of a picture, or draw it several times.
ALONE = {"06_deferred": {"cull", "overdraw", "prepass", "order", "above_m"}, "08_bloom": {"source", "spot_x", "show", "level", "gain"},
         "09_post_effects": {"source", "reference", "effects"}, "10_atmosphere": {"show", "gain"}, "11_fractals": {"method"},
         "12_skin": {"show", "level"}, "13_mlaa": {"show", "walk_m_per_s", "turn_deg_per_s"},
         "18_playground": {"show", "select", "method", "picker.method", "mlaa.method"}}
# Anti-aliasing that draws its picture with several samples, or gathers them in frames before; a film filters finished ones,
# and its scene has no frames before its first.
SAMPLED = {"msaa_4x", "supersample_4", "taa"}
SIZE = (96, 54)


def shots_of(chapter: str) -> list[dict]:
    return json.loads((ROOT / "tests" / chapter / "shots.json").read_text())["shots"]


def scene_of(chapter: str, shot: dict) -> Path:
    """The shot's scene file, or the chapter's own."""
    if "scene" in shot:
        return ROOT / shot["scene"]
    sources = "".join(path.read_text() for path in sorted((ROOT / "chapters" / chapter).glob("*.[hc]*")))
    return ROOT / "assets" / re.search(r'default_scene\(\) const override { return "(.*?)"', sources)[1]


def settings(scene: Path, shot: dict) -> dict:
    """The shot's settings, its scene file and that file's includes."""
    found, files = {}, [scene]
    while files:
        file = files.pop()
        if file.suffix == ".json":
            content = json.loads(file.read_text())
            found = {**content.get("knobs", {}), **found}
            files += [file.parent / name for name in content.get("include", [])]
    return {**found, **shot.get("set", {})}


def can_show(chapter: str, shot: dict) -> bool:
    if "samples" in settings(scene_of(chapter, shot), {}):  # of the scene file: a film has samples of its own
        return False
    knobs = settings(scene_of(chapter, shot), shot)
    return not ALONE.get(chapter, set()) & knobs.keys() and not (chapter == "13_mlaa" and knobs.get("method") in SAMPLED)


def cheaper(chapter: str, shot: dict) -> dict:
    """The shot with less preparation before its first frame."""
    cheap = (one.split("=") for one in CHEAP.get(chapter[:2], ()))
    return {**shot, "set": {**shot.get("set", {}), **{name: json.loads(value) for name, value in cheap}}}


def words_of(shot: dict) -> list[str]:
    return [f"{name}={value if isinstance(value, str) else json.dumps(value)}" for name, value in shot.get("set", {}).items()]


def film_of(kind: str, scene: Path, shot: dict, method: str | None = None, film_knobs: dict | None = None) -> dict:
    """A film of one scene. Samples are left out: a film encodes each of them, a chapter their mean."""
    knobs = {(f"{method}.method" if name == "method" else name): value for name, value in shot.get("set", {}).items()
             if f"{method}.{name}" not in (film_knobs or {}) and name != "samples"}
    return {"duration_s": 5, "knobs": film_knobs or {"smoothed": 0}, "scenes": [
        {"name": "only", "kind": kind, "scene": str(scene), "from_s": 0, "to_s": 5, "clock_s": shot.get("time_s", 0),
         "knobs": knobs}]}


@unittest.skipUnless(BUILT and HAS_SOLUTION, "needs the programs and the reference solutions")
class Worlds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="lightwalk_worlds_")))
        cls.count = 0

    def drawing(self, program: Path | str) -> Drawing:
        drawing = Drawing(program)
        self.addCleanup(drawing.close)
        return drawing

    def draw(self, drawing: Drawing, *options) -> Path:
        type(self).count += 1
        picture = self.folder / f"{self.count}.png"
        code, wrong, _ = drawing.draw(["--size", "{}x{}".format(*SIZE), *map(str, options)], picture)
        self.assertEqual((code, wrong), (0, ""), options)
        return picture

    def shot(self, drawing: Drawing, shot: dict) -> Path:
        return self.draw(drawing, "--shot", shot["name"], *sets(*words_of(shot), "samples=1"))

    def film(self, name: str, content: dict) -> Path:
        file = self.folder / f"{name}.film"
        file.write_text(json.dumps(content))
        return file

    def without_bloom(self, scene: str) -> Path:
        """A copy of the scene for a chapter that has no bloom."""
        content = json.loads((ROOT / scene).read_text())
        content["knobs"] = {name: value for name, value in content["knobs"].items() if not name.startswith("bloom.")}
        for placed in content["objects"]:
            placed["model"] = str(ROOT / "assets" / placed["model"])
        file = self.folder / Path(scene).name
        file.write_text(json.dumps(content))
        return file

    def test_a_film_shows_what_the_chapter_shows(self):
        film = self.drawing("19_ambiance")
        for chapter, (kind, method) in KINDS.items():
            own = self.drawing(chapter)
            shown = [shot for shot in shots_of(chapter) if can_show(chapter, shot)]
            self.assertGreaterEqual(2 * len(shown), len(shots_of(chapter)), chapter)
            for shot in (cheaper(chapter, shot) for shot in shown[:1]):
                with self.subTest(chapter=chapter, shot=shot["name"]):
                    scene = scene_of(chapter, shot)
                    # Chapter 13's filter is the film's own.
                    filtered = {"smoothed": 1} | {f"mlaa.{name}": value for name, value in shot.get("set", {}).items()
                                                  if name in ("method", "reach", "reads")} if chapter == "13_mlaa" else None
                    film_file = self.film(shot["name"], film_of(kind, scene, shot, method, filtered))
                    there = self.draw(film, "--scene", film_file, "--time", 0, "--frames", shot.get("frames", 1))
                    # Chapters 10 and 11 encode linear light; the film keeps what tones leave of it in half floats.
                    self.assertLessEqual(steps(self.shot(own, shot), there), 1 if chapter[:2] in ("10", "11") else 0)

    def test_a_film_shows_its_water_s_rays(self):
        """With land and city in them: it was the sky alone."""
        scene, shot = ROOT / "assets/scenes/lake_city.json", cheaper("15", {"set": {"water.reflection": "rays"}})
        there = self.draw(self.drawing("19_ambiance"), "--scene", self.film("rays", film_of("water", scene, shot)))
        own = self.draw(self.drawing("15_terrain_water"), "--scene", scene, *sets(*words_of(shot)))
        self.assertEqual(steps(own, there), 0)

    def test_the_editor_without_its_marks_shows_what_the_chapter_shows(self):
        own, editor = self.drawing("14_environment"), self.drawing("18_playground")
        known = knobs_of("18_playground")
        shown = [shot for shot in shots_of("14_environment")
                 if all(name in known for name in settings(scene_of("14_environment", shot), shot))]
        self.assertGreaterEqual(len(shown), 4)
        self.assertIn("probe", [shot["name"] for shot in shown])
        for shot in shown[:1]:
            with self.subTest(shot=shot["name"]):
                knobs = sets("marks.on=off", *words_of(shot))
                there = self.draw(editor, "--scene", scene_of("14_environment", shot), "--time", shot.get("time_s", 0), *knobs)
                self.assertEqual(steps(self.shot(own, shot), there), 0)

    def test_a_world_stands_elsewhere(self):
        """In a throw-away chapter that names none of its modules."""
        anywhere, scene = self.drawing(BUILD / "tests" / "anywhere"), self.without_bloom("assets/scenes/lake_city.json")
        plain, mirror, cube = (self.draw(anywhere, "--scene", scene, *sets(f"show={show}"))
                               for show in ("world", "mirror", "cube"))
        film = self.draw(anywhere, "--scene", self.film("five_seconds", film_of("water", scene, {})), "--time", 4.9)
        for other in (mirror, cube, film):
            self.assertGreater(steps(plain, other), 20)
        chapter = self.draw(self.drawing("15_terrain_water"), "--scene", scene, *sets("post.tone=off"))
        self.assertEqual(steps(plain, chapter), 0)
