#!/usr/bin/python3
"""Makes README's pictures from goldens, smaller by integer factors so that their outlines are smooth: docs/images/front.py."""

import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from tree import best_first, chapters, find_chapter  # noqa: E402

FRONT = ROOT / "docs/images/front"
GRID = ["15.valley", "16.rings", "17.saturn", "12.portrait", "11.reef", "14.sunset", "19.harbour", "08.neon", "17.earth_night"]
LESSONS = ["02.blinn_phong", "05.columns", "07.hall", "09.film", "13.city", "18.workbench"]
CELL, THUMBNAIL = (320, 180), (160, 90)


def golden(shot: str, size: tuple[int, int]) -> Image.Image:
    """The middle of a golden at a size's shape."""
    number, _, name = shot.partition(".")
    with Image.open(ROOT / "tests" / find_chapter(number) / "golden" / f"{name}.png") as picture:
        picture = picture.convert("RGB")
    scale = min(picture.width / size[0], picture.height / size[1])
    width, height = round(size[0] * scale), round(size[1] * scale)
    left, top = (picture.width - width) // 2, (picture.height - height) // 2
    return picture.crop((left, top, left + width, top + height)).resize(size, Image.Resampling.BOX)


def main():
    FRONT.mkdir(exist_ok=True)
    grid = Image.new("RGB", (3 * CELL[0], 3 * CELL[1]))
    for i, shot in enumerate(GRID):
        grid.paste(golden(shot, CELL), (i % 3 * CELL[0], i // 3 * CELL[1]))
    grid.save(FRONT / "best.jpg", quality=88, optimize=True)
    for shot in LESSONS:
        golden(shot, CELL).save(FRONT / f"lesson_{shot[:2]}.jpg", quality=85, optimize=True)
    for chapter in chapters():
        shot = f"{chapter[:2]}.{best_first(chapter)[0]['name']}"
        golden(shot, THUMBNAIL).save(FRONT / f"{chapter[:2]}.jpg", quality=85, optimize=True)


if __name__ == "__main__":
    main()
