"""Random scenes, drawn by chapters under core and synchronisation validation with random values of their knobs: all output is a
finding, except a knob's refusal by its name. The same seed makes the same scene; a number behind the file, 50, draws so many."""
import json
import random
import re
import sys
import tempfile
import unittest
from pathlib import Path

from folder_case import FolderCase
from shots.rendering import Drawing, run_program
from tree import BUILD

FEW = int(sys.argv.pop()) if sys.argv[-1].isdigit() else 3
CHAPTERS = sorted(path for path in (BUILD / "chapters").glob("[0-9][0-9]_*") if path.is_file() and not path.suffix)
MODELS = ["cube.obj", "sphere.obj", "ring.obj", "plane.obj", "ground.obj", "bunny_low.obj", "suzanne_family.glb",
          "smart_car.obj", "cornell_box.obj", "column.obj"]
SIZE = "72x40"


def vector(rng, lower, upper):
    return [round(rng.uniform(lower, upper), 3) for _ in range(3)]


def random_material(rng) -> dict:
    material = {}
    if rng.random() < 0.5:
        material["diffuse"] = vector(rng, 0, 1)
    if rng.random() < 0.3:
        material |= {"specular": vector(rng, 0, 1), "shininess": rng.choice([0, 1, 8, 200, 100000])}
    if rng.random() < 0.2:
        material |= {"opacity": rng.choice([0, 0.3, 1]), "blend": rng.random() < 0.5}
        if material["blend"]:
            material["transmission"] = [0.2, 0, 1]
    if rng.random() < 0.2:
        material["emissive"] = vector(rng, 0, 20)
    if rng.random() < 0.3:
        material |= {"roughness": rng.choice([0, 0.5, 1]), "metalness": rng.choice([0, 1])}
    if rng.random() < 0.4:
        material["maps"] = dict(rng.sample([
            ("diffuse", "textures/metal_albedo.jpg"), ("normal", "textures/metal_normal.png"),
            ("orm", "textures/metal_orm.png"), ("height", "textures/lava_height.png"),
            ("opacity", "textures/squares.png"), ("emissive", "textures/saturn_ring.png")], rng.randint(1, 4)))
    return material


def random_object(rng, number) -> dict:
    thing = {"name": f"object {number}", "model": "models/" + rng.choice(MODELS), "position": vector(rng, -3, 3),
             "rotation_deg": vector(rng, -180, 180), "material": random_material(rng),
             "scale": rng.choice([1, 0.01, 20, -1, [1, -1, 1], [0.2, 1, 5]])}
    if number and rng.random() < 0.3:
        thing["parent"] = f"object {rng.randrange(number)}"
    if rng.random() < 0.1:
        del thing["model"]
    if rng.random() < 0.2:
        thing["motion"] = {"spin_deg_per_s": rng.uniform(-90, 90)}
    return thing


def random_light(rng) -> dict:
    kind = rng.choice(["directional", "point", "spot"])
    light = {"type": kind, "color": vector(rng, 0, 1), "intensity": rng.choice([0, 0.5, 3, 1000])}
    if rng.random() < 0.5:
        light["shadow"] = True
    if kind != "point":
        light["direction"] = rng.choice([[0, -1, 0], [0, 1, 0], [1, 0, 0]] + [vector(rng, 0.1, 1)])
    if kind != "directional":
        light |= {"position": vector(rng, -4, 4), "range_m": rng.choice([0, 0.1, 5, 1000])}
    if kind == "spot":
        inner = rng.choice([0, 20, 90])
        light |= {"inner_deg": inner, "outer_deg": inner + rng.choice([0, 15, 60])}
    return light


def random_scene(seed) -> dict:
    rng = random.Random(seed)
    return {"camera": {"position": vector(rng, -6, 6), "target": vector(rng, -0.5, 0.5), "fov_deg": rng.choice([1, 45, 120]),
                       "near_m": rng.choice([0.001, 0.05, 2]), "far_m": rng.choice([10, 1000, 1e7])},
            "ambient": vector(rng, 0, 0.2), "background": vector(rng, 0, 0.2),
            "objects": [random_object(rng, i) for i in range(rng.choice([0, 1, 3, 8]))],
            "lights": [random_light(rng) for _ in range(rng.choice([0, 1, 2, 5, 40]))]}


def random_knobs(program, rng) -> list:
    """A few of the chapter's knobs at random values, and its method."""
    options = []
    for knob in json.loads(run_program([program, "--list", "knobs", "--json"]).stdout):
        if rng.random() > 0.25 or knob["name"] in ("samples", "loader"):
            continue
        if knob["type"] == "choice":
            chosen = rng.choice(knob["options"])
            options += ["--set", f"{knob['name']}={chosen}"]
            if chosen == "lens":
                options += ["--set", "dof.views=2"]  # each of hundreds of views is a picture
        elif knob["type"] == "switch":
            options += ["--set", f"{knob['name']}={rng.choice(['on', 'off'])}"]
        elif knob["type"] == "number":
            options += ["--set", f"{knob['name']}={knob['range'][0]}"]
    return options


def run(program, folder, *options):
    """Draws a picture with them, under validation, in memory that is filled: a picture of unwritten memory has NaN in it, and is
    refused."""
    done = run_program([program, "--size", SIZE, "--validate", "on", *options, "--screenshot", f"{folder}/picture.png"])
    # How far what takes long has come is said on a busy machine.
    done.stderr = "".join(line for line in done.stderr.splitlines(True) if not line.startswith("drawing: "))
    return done


def draw(program, seed, folder) -> tuple:
    """The command that draws that scene with that chapter, and the fault: empty if it is right."""
    rng = random.Random(f"{program.name} {seed}")
    scene = Path(folder) / f"scene_{seed}.json"
    scene.write_text(json.dumps(random_scene(seed), indent=1))
    options = ["--scene", str(scene), *random_knobs(program, rng), "--frames", str(rng.choice([1, 2])), "--time", str(rng.choice([0, 1.5]))]
    done = run(program, folder, *options)
    said = "".join(line for line in done.stderr.splitlines(True) if not line.startswith("warning: "))
    refused = re.fullmatch(r"error: ([\w.]+) [^\n]*\n", said)
    if done.returncode == 2 and refused and any(word.startswith(f"{refused[1]}=") for word in options):
        return done.args, ""  # a knob that we have set, which does not go with the others, and says so
    return done.args, "" if done.returncode == 0 and not said else f"exit code {done.returncode}: {said[:2000]}"


@unittest.skipUnless(CHAPTERS, "the chapters are not built")
class RandomScenes(FolderCase):
    def test_no_chapter_has_anything_to_say(self):
        for seed in range(FEW):
            program = CHAPTERS[seed * len(CHAPTERS) // FEW]
            with self.subTest(program=program.name, seed=seed), tempfile.TemporaryDirectory() as folder:
                command, wrong = draw(program, seed, folder)
                self.assertEqual(wrong, "", " ".join(command))

    def test_what_they_have_found(self):
        """A finely cut surface with holes, which casts a shadow: its caster was drawn with the wrong vertex shader. And rays from water
        where there is no ground, a pool."""
        scene = {"objects": [{"model": "models/ground.obj", "material": {"maps": {
            "height": "textures/lava_height.png", "opacity": "textures/squares.png"}}}],
                 "lights": [{"type": "directional", "direction": [0.3, -1, 0.2], "shadow": True}]}
        (self.folder / "scene.json").write_text(json.dumps(scene))
        for chapter, *options in (("05_shadow_maps", "--scene", f"{self.folder}/scene.json", "--set", "maps.mesh=displaced", "--set", "maps.subdivide=2"),
                                  ("15_terrain_water", "--scene", "scenes/pool.json", "--set", "water.reflection=rays")):
            done = run(BUILD / "chapters" / chapter, self.folder, *options)
            self.assertEqual((done.returncode, done.stderr), (0, ""), chapter)

    def test_nothing_at_all(self):
        """Every view of a scene without objects: resources that were never made are not read."""
        views = {"08": ["picture", "cut_out", "spread", "level"],
                 "12": ["picture", "irradiance", "level", "stretch", "occlusion", "thickness"],
                 "13": ["picture", "edges"]}
        (self.folder / "scene.json").write_text('{"lights": [{"type": "directional", "shadow": true}]}')
        for program in CHAPTERS:
            with Drawing(program) as drawing:
                for view in views.get(program.name[:2], [""]):
                    with self.subTest(program=program.name, view=view):
                        options = ["--scene", f"{self.folder}/scene.json", "--size", SIZE]
                        options += ["--set", f"show={view}"] if view else []
                        options += ["--world", "head"] if program.name[:2] == "13" else []
                        code, wrong, said = drawing.draw(options, self.folder / "picture.png")
                        said = [line for line in said.splitlines() if not line.startswith("drawing: ")]
                        self.assertEqual((code, wrong, said), (0, "", []))
