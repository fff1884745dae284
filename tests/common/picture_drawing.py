"""Shared by the tests that compare pictures of several chapters: their knobs, a process that draws, two pictures' steps,
and a scene with something of everything. LIGHTWALK_BUILD names the build folder where it is not build/ in the tree.
"""
import json
import math
import os
import subprocess
from pathlib import Path

from PIL import Image, ImageChops

from shots.rendering import Drawing
from tree import BUILD, ROOT

CHAPTERS = sorted(path.name for path in (ROOT / "chapters").glob("[0-9][0-9]_*"))
BUILT = (BUILD / "compare").exists() or "LIGHTWALK_BUILD" in os.environ
HAS_SOLUTION = any((ROOT / "shaders").glob("*/solution"))


def knobs_of(chapter: str) -> dict:
    """{name: entry of --list knobs}"""
    listed = subprocess.run([BUILD / "chapters" / chapter, "--list", "knobs", "--json"], capture_output=True, text=True,
                            stdin=subprocess.DEVNULL, timeout=120, cwd=ROOT, check=True)
    return {knob["name"]: knob for knob in json.loads(listed.stdout)}


def sets(*settings: str) -> list[str]:
    """NAME=VALUE each, as options."""
    return [word for setting in settings for word in ("--set", setting)]


class Drawer(Drawing):
    """Draws pictures of one chapter into a folder, each as its program's first frame: a chapter is made for each."""

    def __init__(self, chapter: str, folder: Path):
        super().__init__(chapter)
        self.folder, self.count = Path(folder), 0

    def draw(self, *options) -> tuple[Path, str]:
        """The picture, and the error: empty if the program succeeded."""
        self.count += 1
        picture = self.folder / f"{self.chapter}_{self.count}.png"
        code, wrong, said = super().draw(list(options), picture)
        # Progress messages of slow work appear on a busy machine.
        said = "\n".join(line for line in said.splitlines() if line.strip() and not line.startswith("drawing: "))
        return picture, f"exit code {code}: {wrong or said}" if code or said else ""


class Live(Drawer):
    """One program of a chapter that goes on: what it draws may depend on what it has drawn before."""

    def draw(self, words: list, size: tuple, **request) -> tuple[Path, str]:
        """The picture of a request, which changes what `words` have loaded, and the error: empty if there is none."""
        words = ["--frames", "1", *words]  # without any word it would be the chapter's best shot
        answer, said, code = self.ask({"words": words, "size": size, "still": True} | request)
        answer = answer or {"error": f"exit code {code}: {said}"}
        self.count += 1
        picture = self.folder / f"{self.chapter}_live_{self.count}.png"
        picture.write_bytes(self.picture)
        return picture, "\n".join([answer["error"], *answer.get("errors", [])]).strip()


def steps(one: Path, other: Path) -> int:
    """By how many codes of 255 the pixel that differs most does, in its worst channel."""
    with Image.open(one) as first, Image.open(other) as second:
        difference = ImageChops.difference(first.convert("RGB"), second.convert("RGB"))
    return max(most for _, most in difference.getextrema())


def pixels_beyond(one: Path, other: Path, bound: int) -> float:
    """The share of pixels that differ by more codes than that, in any channel."""
    with Image.open(one) as first, Image.open(other) as second:
        red, green, blue = ImageChops.difference(first.convert("RGB"), second.convert("RGB")).split()
    worst = ImageChops.lighter(ImageChops.lighter(red, green), blue)
    return sum(worst.histogram()[bound + 1:]) / (worst.width * worst.height)


# Knobs that shorten a chapter's preparation, which takes most of a small picture's time, and bear on no comparison.
CHEAP = {
    "12": ("skin.sky_rays=1", "skin.sky_size=16"), "13": ("skin.sky_rays=1", "skin.sky_size=16"),
    "14": ("backdrop.shadow.directions=4", "backdrop.shadow.resolution=16", "environment.prefilter.samples=4"),
    "15": ("ground.levels=7", "land.shadow_steps=8", "atmosphere.table_scale=0.25", "environment.prefilter.samples=4"),
    "16": ("volume.field.voxels=16", "volume.steps=32", "finish.width=64"),
    "18": ("environment.prefilter.samples=4",)}


def cheap(chapter: str) -> list[str]:
    return sets(*CHEAP.get(chapter[:2], ()))


def thing(model: str, position: list, **keys) -> dict:
    return {"model": f"models/{model}.obj", "position": position, **keys}


def tiles(name: str) -> dict:
    """A material with maps of everything."""
    return {"maps": {"diffuse": f"textures/{name}_albedo.jpg", "normal": f"textures/{name}_normal.png",
                     "height": f"textures/{name}_height.png"}}


# Surfaces that are opaque, cut out, transparent, luminous and moving, in front of and behind each other; 33 lights of every
# kind, of which three cast shadows. It says nothing of knobs: every chapter with lights draws it.
EVERYTHING = {
    "camera": {"position": [0, 2.2, 7], "target": [0, 0.7, 0], "fov_deg": 50, "near_m": 0.05, "far_m": 100},
    "background": [0.02, 0.03, 0.05], "ambient": [0.05, 0.05, 0.06],
    "objects": [
        thing("plane", [0, 0, 0], name="floor", scale=12, rotation_deg=[0, 25, 0], material=tiles("stone_tiles")),
        thing("column", [-2.2, 0, -1.5], name="column"),
        thing("sphere", [-0.4, 0.5, -1.8], name="bumps", scale=1.3, rotation_deg=[20, 40, 70], material=tiles("stone_tiles")),
        thing("suzanne", [0, 1, 0.3], name="head", material={"diffuse": [0.7, 0.4, 0.2], "specular": [0.1, 0.1, 0.1],
                                                            "shininess": 40}, motion={"spin_deg_per_s": 40}),
        thing("cube", [2.1, 0.7, -0.6], name="holes", rotation_deg=[0, 30, 0], scale=0.8,
              material={"maps": {"opacity": "textures/squares.png"}}, motion={"spin_deg_per_s": -30}),
        thing("sphere", [-1.2, 0.6, 1.6], name="glass", scale=0.6,
              material={"diffuse": [0.2, 0.5, 0.9], "opacity": 0.4}),
        thing("sphere", [1.2, 0.5, 1.9], name="near glass", scale=0.5,
              material={"diffuse": [0.9, 0.3, 0.2], "opacity": 0.5}),
        thing("sphere", [0.4, 0.3, 2.4], name="lamp", scale=0.2, material={"emissive": [2, 1.5, 0.6]})],
    "lights": [
        {"type": "directional", "direction": [0.4, -1, -0.5], "intensity": 0.5, "shadow": True},
        {"type": "spot", "position": [-3, 4, 2], "direction": [0.6, -0.8, -0.3], "intensity": 30, "range_m": 12,
         "inner_deg": 12, "outer_deg": 25, "color": [1, 0.8, 0.5], "shadow": True, "size_m": 0.1},
        {"type": "point", "position": [1.8, 2.6, 1.2], "intensity": 4, "range_m": 8, "shadow": True}] + [
        {"type": "point", "position": [round(4.5 * math.sin(2.4 * i) * (i / 30) ** 0.5, 3), 0.3 + 0.05 * (i % 7),
                                       round(4.5 * math.cos(2.4 * i) * (i / 30) ** 0.5, 3)],
         "color": [[1, 0.4, 0.3], [0.4, 1, 0.5], [0.4, 0.5, 1]][i % 3], "intensity": 0.6, "range_m": 1.5}
        for i in range(30)]}
