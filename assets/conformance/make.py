#!/usr/bin/env python3
"""Writes the conformance set: one small model file for each property that a format can state, and conformance.json,
which says what is right. Whoever changes it runs it here; its files are in the tree.

Most of the glTF files are an unlit square that fills the picture of the file's own camera: a point of the picture has
then a colour that follows from glTF 2.0 alone. `points`: [x, y, [r, g, b]] with x and y from 0 to 1, from the upper left,
and sRGB from 0 to 255.
"""

import json

import gltf_cases  # noqa: F401
import other_cases  # noqa: F401
from parts import HERE, cases

(HERE / "conformance.json").write_text(json.dumps({"cases": cases}, indent=1) + "\n")
print(len(cases), "cases")
