"""Pictures of the smallest programs in a browser: two drivers draw the same, SwiftShader in Chromium and Mesa's llvmpipe in Firefox.

tests/common/programs holds Firefox's pictures, a quarter as wide as the page's canvas, and in distances.json the distance of Chromium's:
the mean difference of a channel and the largest difference, in steps of 1/255. Three times that is allowed, as for goldens.
`python3 tests/common/test_page_pictures.py --accept` draws both again.
"""

import base64
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path

from browser import WHY_NONE, Browser, Firefox

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from pages import running  # noqa: E402

EXPECTED = Path(__file__).with_name("programs")
DISTANCES = EXPECTED / "distances.json"
MARGIN = 3
LEAST = {"mean": 0.1, "max": 6}  # a driver's roundings: no limit is smaller
PAGE = """<!doctype html><meta charset="utf-8"><title>Programs</title><body>
%s<script>Answers.list = []; Program.scenes = %s;</script>"""
DRAWN = """(async () => {
  Program.all.splice(0);
  const listing = document.createElement("p");
  document.body.replaceChildren(listing);
  const one = new Program(%s, listing, %s);
  one.start();
  await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  one.drawing?.draw(one.numbers());
  return [one.said.textContent, one.canvas.toDataURL()];
})()"""


def text_of(name: str) -> str:
    return running.scenes()[name].get("text") or (running.MINIMAL / f"{name}.frag").read_text(encoding="utf-8")


class Programs:
    """The programs on a page from a file, in one browser."""

    def __init__(self, browser):
        self.browser, self.folder = browser, tempfile.TemporaryDirectory()
        page = Path(self.folder.name, "programs.html")
        scripts = "".join(f'<script src="{(running.OWN / name).as_uri()}"></script>' for name in ("gl.js", "program.js", "exercise.js", "answers.js"))
        page.write_text(PAGE % (scripts, json.dumps(running.scenes())), encoding="utf-8")
        browser.open(page)
        self.folder.cleanup()

    def draw(self, name: str):
        """The message below the picture, and the picture at a quarter of its width and height."""
        from PIL import Image

        said, data = self.browser.evaluate(DRAWN % (json.dumps(name), json.dumps(text_of(name))))
        picture = Image.open(io.BytesIO(base64.b64decode(data.partition(",")[2]))).convert("RGB")
        return said, picture.reduce(4)


def distance(one, other) -> dict:
    from PIL import ImageChops, ImageStat

    difference = ImageChops.difference(one, other)
    return {"mean": round(sum(ImageStat.Stat(difference).mean) / 3, 3), "max": max(high for _, high in difference.getextrema())}


def limit(measured: dict) -> dict:
    return {key: max(MARGIN * measured[key], least) for key, least in LEAST.items()}


class Comparing(unittest.TestCase):
    def compare(self, browser, names):
        programs = Programs(browser)
        measured = json.loads(DISTANCES.read_text())
        from PIL import Image

        for name in names:
            with self.subTest(name):
                said, picture = programs.draw(name)
                self.assertEqual(said, "")
                found = distance(picture, Image.open(EXPECTED / f"{name}.webp").convert("RGB"))
                for key, most in limit(measured[name]).items():
                    self.assertLessEqual(found[key], most, f"{key} of {name}: {found}")


class InChromium(Comparing):
    def test_every_scene_has_its_picture(self):
        self.assertEqual(sorted(path.stem for path in EXPECTED.glob("*.webp")), sorted(running.scenes()))
        self.assertEqual(sorted(json.loads(DISTANCES.read_text())), sorted(running.scenes()))

    @unittest.skipIf(WHY_NONE, WHY_NONE)
    def test_programs_look_like_their_pictures(self):
        with Browser(webgl=True) as browser:
            self.compare(browser, sorted(running.scenes())[::3])


def accept():
    EXPECTED.mkdir(exist_ok=True)
    distances = {}
    with Firefox() as one, Browser(webgl=True) as other:
        both = Programs(one), Programs(other)
        for name in sorted(running.scenes()):
            (said, picture), (said_too, other_picture) = (programs.draw(name) for programs in both)
            if said or said_too:
                raise SystemExit(f"{name}: {said or said_too}")
            picture.save(EXPECTED / f"{name}.webp", "WEBP", lossless=True, method=6)
            distances[name] = distance(picture, other_picture)
            print(name, distances[name], flush=True)
    DISTANCES.write_text(json.dumps(distances, indent=1) + "\n")


if __name__ == "__main__":
    accept() if sys.argv[1:] == ["--accept"] else unittest.main()
