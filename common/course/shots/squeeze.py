"""PNGs for the tree: the same pixels in about two thirds of the bytes that a chapter writes, which every clone fetches.

    python3 common/course shots.squeeze FILE...    replaces each where it becomes smaller
"""

import io
import sys
from pathlib import Path

from tree import say, write_atomically

try:
    from PIL import Image
except ImportError:  # the picture is then as the chapter wrote it
    Image = None


def squeezed(png: bytes) -> bytes:
    """Without an alpha that is 1 everywhere, and deflated as well as zlib can; the same bytes where that is not less."""
    if not Image or not png.startswith(b"\x89PNG"):
        return png
    out = io.BytesIO()
    with Image.open(io.BytesIO(png)) as picture:
        if picture.mode == "RGBA" and picture.getextrema()[3] == (255, 255):
            picture = picture.convert("RGB")
        picture.save(out, "PNG", optimize=True)
    return min(png, out.getvalue(), key=len)


def main(files: list[str]):
    before = after = 0
    for path in map(Path, files):
        png = path.read_bytes()
        small = squeezed(png)
        before, after = before + len(png), after + len(small)
        if len(small) < len(png):
            write_atomically(path, small)
    say(f"{len(files)} files, {before / 1e6:.1f} MB, now {after / 1e6:.1f} MB")


if __name__ == "__main__":
    main(sys.argv[1:])
