#!/usr/bin/python3
"""Makes the pictures of this folder that chapters draw: docs/images/make.py [NAME...], after ./course run.

pictures.json says what each shows. A picture has cells, side by side in rows of `columns`. Everything beside "cells"
holds for all of them: the chapter, a shot or a scene, knobs ("set"), exercises ("use"), the size, the samples (16), the
part to keep ("crop": left, top, width, height) and how many times to enlarge it ("zoom"). The pages of ./course serve
draw the same cells.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from pages.made import cells, made  # noqa: E402
from tree import BUILD  # noqa: E402

GAP = 4  # pixels between cells, and half of it around them


def draw(cell: dict, folder: str) -> Image.Image:
    file = Path(folder) / "cell.png"
    words = [f"--{kind}={cell[kind]}" for kind in ("shot", "scene", "use") if kind in cell]
    words += [word for knob in cell["set"].items() for word in ("--set", "=".join(knob))]
    width, height = cell["size"]
    subprocess.run([BUILD / "chapters" / cell["chapter"], *words, "--size", f"{width}x{height}", "--samples",
                    str(cell.get("samples", 16)), "--screenshot", file], cwd=ROOT, check=True, stdout=subprocess.DEVNULL,
                   env=os.environ | {"LIGHTWALK_ROOT": str(ROOT)})
    picture = Image.open(file).convert("RGB")
    if "crop" in cell:
        left, top, width, height = cell["crop"]
        picture = picture.crop((left, top, left + width, top + height))
    zoom = cell.get("zoom", 1)
    return picture.resize((picture.width * zoom, picture.height * zoom), Image.Resampling.NEAREST)


def make(name: str):
    with tempfile.TemporaryDirectory() as folder:
        drawn = [draw(cell, folder) for cell in cells(name)]
    if len(drawn) == 1:
        whole = drawn[0]
    else:
        columns, (width, height) = made()[name]["columns"], (drawn[0].width + GAP, drawn[0].height + GAP)
        whole = Image.new("RGB", (columns * width, -(-len(drawn) // columns) * height), "white")
        for i, picture in enumerate(drawn):
            whole.paste(picture, (i % columns * width + GAP // 2, i // columns * height + GAP // 2))
    photograph = ROOT / "docs/images" / f"{name}.jpg"  # of shaded surfaces: a fourth of the PNG
    if photograph.exists():
        whole.save(photograph, quality=85, subsampling=0, optimize=True, progressive=True)
    else:
        whole.save(photograph.with_suffix(".png"), optimize=True)


if __name__ == "__main__":
    for one in sys.argv[1:] or made():
        make(one)
