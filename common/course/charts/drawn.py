"""Charts of the studies in docs/studies, drawn from their JSON into build/charts when a page shows them. In the tree are only
the PNGs that a lesson shows, for readers of the text.
"""

import hashlib
import json
import os
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tree import PYTHON, BUILD, ROOT, Failure, cores, write_atomically

STUDIES = ROOT / "docs" / "studies"
DRAWN = BUILD / "charts"


def shown_by_lessons() -> set[str]:
    """The names of the PNGs in docs/studies that a text of docs shows."""
    texts = (path.read_text(encoding="utf-8") for path in (ROOT / "docs").glob("*.md"))
    return {name for text in texts for name in re.findall(r"studies/([\w./-]+\.png)", text)}


def study_of(chart: str) -> Path | None:
    """The JSON of this chart's study, "05_shadow_maps.h200.acne" or a file's name; the longest name that fits."""
    found = [path for path in STUDIES.glob("*.json") if f"{chart}.".startswith(f"{path.stem}.")]
    return max(found, key=lambda path: len(path.stem), default=None)


def draw_charts(studies) -> None:
    """Draws the charts of these studies that are not drawn as things stand. Raises Failure."""
    code = b"".join(path.read_bytes() for path in sorted(Path(__file__).parent.glob("*.py")))
    keys = {path: hashlib.sha256(code + path.read_bytes()).hexdigest() for path in sorted(set(studies))}
    known = json.loads((DRAWN / "drawn.json").read_text(encoding="utf-8")) if (DRAWN / "drawn.json").exists() else {}
    stale = [path for path, key in keys.items() if known.get(path.name) != key]

    def draw(path: Path) -> str:
        done = subprocess.run([*PYTHON, ROOT / "common/course", "charts.chart", path, "--out", DRAWN], text=True, errors="replace",
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env=os.environ | {"OMP_NUM_THREADS": "1"})
        return done.stdout.strip().splitlines()[-1] if done.returncode else ""

    if stale:
        DRAWN.mkdir(parents=True, exist_ok=True)
        with ThreadPoolExecutor(min(cores(), 8)) as pool:
            wrong = [words for words in pool.map(draw, stale) if words]
        if wrong:
            raise Failure(f"a chart was not drawn: {wrong[0]}")
        write_atomically(DRAWN / "drawn.json", json.dumps(known | {path.name: keys[path] for path in stale}))


def vector_of(picture: Path) -> Path | None:
    """The SVG of a PNG in docs/studies, a path from the root; None for any other file."""
    study = study_of(picture.stem) if picture.parent == Path("docs/studies") and picture.suffix == ".png" else None
    if not study:
        return None
    draw_charts([study])
    vector = DRAWN / f"{picture.stem}.svg"
    return vector if vector.exists() else None
