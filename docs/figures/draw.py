"""Draws the lessons' diagrams: python3 docs/figures/draw.py [NN_name...] writes docs/images/NN_name.svg; all without names."""

import sys
from importlib import import_module
from pathlib import Path

import drawing

FOLDER = Path(__file__).resolve().parent


def figures() -> dict:
    """Of NN.py and reading_minutes.py, by name."""
    for path in [*sorted(FOLDER.glob("[0-9][0-9].py")), FOLDER / "reading_minutes.py"]:
        import_module(path.stem)
    return drawing.FIGURES


if __name__ == "__main__":
    for name in sys.argv[1:] or figures():
        (FOLDER.parent / "images" / f"{name}.svg").write_text(figures()[name]().svg(), encoding="utf-8")
