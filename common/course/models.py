"""./course run --models: a contact sheet of the course's own conformance set, with a verdict for each file."""

import argparse
import json
import tempfile
from pathlib import Path

from build.build import build
from pages.page import data_uri, page
from shots.rendering import run_program
from tree import BUILD, ROOT, chapter_program, relative, write_atomically

HELP = """Draws one small model file for each property that glTF, MTL, OBJ, PLY or STL can state, and says of each whether
the picture is right. Writes build/models/index.html.

  ./course run --models [NAME...]"""

CHAPTER = "04_surface_maps"
SET = ROOT / "assets" / "conformance"
SIZE = (160, 160)
BARE_SIZE = (320, 180)
STEPS = 3  # of 255, by which a colour may differ


def add_arguments(parser: argparse.ArgumentParser):
    parser.add_argument("--models", nargs="*", dest="name", default=[], metavar="NAME", help="cases by name; all if none is given")


class Picture:
    """A program's result for a file: exit code, message, and the picture as rows of (r, g, b)."""

    def __init__(self, case: dict, folder: Path, name: str):
        import numpy
        from PIL import Image
        self.path = folder / f"{name}.png"
        own_camera = "--camera-of-file" in case["options"]
        width, height = SIZE if own_camera else BARE_SIZE
        done = run_program([chapter_program(CHAPTER), "--scene", SET / case["file"], "--size", f"{width}x{height}",
                            "--screenshot", self.path, *case["options"]])
        self.code, self.said = done.returncode, (done.stderr + done.stdout).strip()
        self.texels = None
        if self.path.exists():
            with Image.open(self.path) as image:
                self.texels = numpy.asarray(image.convert("RGB")).astype(int)

    def at(self, x: float, y: float):
        """The mean of 3 x 3 pixels around a point."""
        rows, columns = self.texels.shape[:2]
        row, column = int(y * rows), int(x * columns)
        return self.texels[max(row - 1, 0):row + 2, max(column - 1, 0):column + 2].reshape(-1, 3).mean(0)

    def thing(self):
        return self.texels[self.mask()]

    def mask(self):
        return abs(self.texels - self.texels[0, 0]).sum(2) > 6


def wrong(case: dict, draw) -> str:
    """Why a case fails; empty where it is right. `draw`: the picture of a case."""
    import numpy
    picture = draw(case)
    if "refused" in case:
        if picture.code != 2 or "\n" in picture.said or case["refused"] not in picture.said:
            return f"expected to be refused with '{case['refused']}', got exit code {picture.code}: {picture.said[:100]}"
        return ""
    if picture.code or picture.texels is None:
        return f"exit code {picture.code}: {picture.said[:100]}"
    if "warned" in case and not ("warning" in picture.said and case["warned"] in picture.said):
        return f"expected a warning with '{case['warned']}', got '{picture.said[:100]}'"
    if "warned" not in case and picture.said:
        return f"it said: {picture.said[:100]}"
    steps = case.get("steps", STEPS)
    for x, y, expected in case.get("points", []):
        found = picture.at(x, y)
        if abs(found - expected).max() > steps:
            return f"at ({x}, {y}) {found.round().tolist()}, expected {expected}"
    for x, y in case.get("holes", []):
        found = picture.at(x, y)
        if found[0] > 1.3 * max(found[1], found[2]):
            return f"at ({x}, {y}) {found.round().tolist()}, expected what lies behind"
    if "differ" in case:
        one, other = (picture.at(*point) for point in case["differ"])
        if abs(one - other).max() <= 6:
            return f"{one.round().tolist()} and {other.round().tolist()} should differ"
    if "reddish" in case:
        red, green, blue = picture.at(*case["reddish"])
        if red < 1.3 * max(green, blue):
            return f"[{red:.0f}, {green:.0f}, {blue:.0f}], expected red"
    if "mixed_with" in case:
        x, y, front, alpha = case["mixed_with"]
        behind = (picture_behind(draw) / 255) ** 2.2
        ahead = (numpy.array(front) / 255) ** 2.2
        mixed = 255 * (alpha * ahead + (1 - alpha) * behind) ** (1 / 2.2)
        if abs(picture.at(x, y) - mixed).max() > 8:
            return f"{picture.at(x, y).round().tolist()}, expected about {mixed.round().tolist()}"
    if "filtered" in case:
        x, y, tint = case["filtered"]
        passed = 255 * (numpy.array(tint) * (picture_behind(draw) / 255) ** 2.2) ** (1 / 2.2)
        if abs(picture.at(x, y) - passed).max() > 8:
            return f"{picture.at(x, y).round().tolist()}, expected about {passed.round().tolist()}"
    return wrong_thing(case, picture, draw)


def picture_behind(draw):
    return draw({"file": "single_sided.gltf", "options": ["--camera-of-file", "1"]}).at(0.5, 0.5)


def wrong_thing(case: dict, picture: Picture, draw) -> str:
    """The same for the bare view."""
    import numpy
    for word, right in (("like", lambda d: d < 1), ("unlike", lambda d: d > 0.4)):
        if word in case:
            other = draw({"file": case[word], "options": case["options"]})
            difference = abs(picture.texels - other.texels).mean() if other.texels is not None else 255
            if not right(difference):
                return f"{difference:.2f} away from {case[word]}, which it should be {word}"
    thing = picture.thing()
    if "drawn" in case and len(thing) < 0.01 * picture.mask().size:
        return "nothing of it is seen"
    if "textured" in case and thing.std(0).max() < 6:
        return "it is flat"
    if "one_colour" in case and thing.std(0).max() > 4:
        return f"its colours spread by {thing.std(0).max():.1f}"
    if "halves" in case:
        columns = numpy.where(picture.mask())[1]
        left = columns < (columns.min() + columns.max()) / 2
        if thing[left].mean(0)[0] - thing[~left].mean(0)[0] < 12 or thing[~left].mean(0)[1] - thing[left].mean(0)[1] < 12:
            return f"{thing[left].mean(0).round()} and {thing[~left].mean(0).round()}"
    return ""


def verdicts(names: list[str], folder: Path) -> list[dict]:
    cases = json.loads((SET / "conformance.json").read_text(encoding="utf-8"))["cases"]
    drawn = {}

    def draw(case):
        key = json.dumps([case["file"], case["options"]])
        if key not in drawn:
            drawn[key] = Picture(case, folder, f"{len(drawn):03}")
        return drawn[key]

    results = []
    for case in cases:
        if names and case["name"] not in names:
            continue
        why = wrong(case, draw)
        picture = draw(case)
        results.append({**case, "wrong": why, "said": picture.said, "code": picture.code,
                        "image": data_uri(picture.path, lossless=False) if picture.path.exists() else ""})
    return results


def run(arguments, rest) -> int:
    build([CHAPTER])
    with tempfile.TemporaryDirectory() as folder:
        results = verdicts(arguments.name, Path(folder))
    for result in results:
        print(f"{'WRONG' if result['wrong'] else 'right'}  {result['name']:32} {result['wrong'] or result['says']}")
    out = BUILD / "models" / "index.html"
    write_atomically(out, page("models.html", results=results))
    right = sum(not result["wrong"] for result in results)
    print(f"{right} of {len(results)} right; {relative(out)}")
    return 0 if right == len(results) else 1
