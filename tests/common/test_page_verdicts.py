"""The page and ./course check give the same verdict on each answer: all variants in GLSL of the exercises that a browser
can check.

python3 tests/common/test_page_verdicts.py [--firefox] [NN | NN.name ...] prints a table of both verdicts, with marks where
they differ.
"""

import json
import sys
import tempfile
import unittest
from pathlib import Path

from browser import WHY_NONE, Browser, Firefox

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "common/course"))
from check.variants import Variant, variants  # noqa: E402
from pages import in_browser  # noqa: E402
from tree import BUILD, chapters, write_atomically  # noqa: E402

SITE = ROOT / "common/course/pages/site/run"
LEAST = 60


def answers(fit: list[str]) -> list[tuple[str, Variant]]:
    """The variants in GLSL of these exercises."""
    return [(f"{chapter[:2]}.{variant.exercise}", variant) for chapter in chapters() for variant in variants(chapter)[0]
            if variant.name.endswith(".glsl") and f"{chapter[:2]}.{variant.exercise}" in fit]


def chromium():
    return Browser(webgl=True)


def said(folder: Path, asked: list[tuple[str, Variant]], browsed):
    """The page's verdict on each answer, in order."""
    names = sorted({exercise for exercise, _ in asked})
    scripts = [*(SITE / name for name in ("gl.js", "undefined.js", "tables.js")), folder / "undefined.js",
               *(folder / f"{name}.js" for name in names)]
    page = folder / "verdicts.html"
    page.write_text("<!doctype html>" + "".join(f'<script src="{path.as_uri()}"></script>' for path in scripts))
    with browsed() as browser:
        browser.open(page)
        for exercise, variant in asked:
            yield browser.evaluate(f"Tables.check(Tables.known.get({json.dumps(exercise)}), {json.dumps(variant.text)})")


def compared(folder: Path, wanted=lambda name: True, browsed=chromium) -> list[dict]:
    fit = [name for name in in_browser.write(folder) if wanted(name)]
    asked = answers(fit)
    rows = []
    for (exercise, variant), result in zip(asked, said(folder, asked, browsed)):
        first = result["first_failure"] or ""
        same = result["ok"] == (not variant.words) and (not variant.words or any(one in first for one in variant.words.split(" | ")))
        rows.append({"exercise": exercise, "answer": variant.name, "check": variant.verdict, "page": "right" if result["ok"] else f"wrong: {first}",
                     "note": result.get("note", ""), "why": result.get("why", ""), "same_verdict": result["ok"] == (not variant.words), "same_words": same})
    return rows


def table(rows: list[dict]) -> str:
    lines = ["| answer | `./course check` | the page | |", "|---|---|---|---|"]
    for row in rows:
        cells = [f"{row['exercise'][:3]}{row['answer']}", row["check"], row["page"][:160], "" if row["same_verdict"] else "DIFFERENT"]
        lines.append("| " + " | ".join(cell.replace("|", "/").replace("\n", " ") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


@unittest.skipIf(WHY_NONE, WHY_NONE)
class Verdicts(unittest.TestCase):
    def test_every_answer_has_the_verdict_of_the_check(self):
        with tempfile.TemporaryDirectory() as folder:
            fit = in_browser.write(Path(folder))
            self.assertGreaterEqual(len(fit), LEAST)
            chosen = fit[::8]
            rows = compared(Path(folder), lambda name: name in chosen)
        write_atomically(BUILD / "report" / "verdicts.md", table(rows))
        self.assertGreater(len(rows), 2 * len(chosen))
        self.assertEqual([row for row in rows if not row["same_verdict"]], [])


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if not word.startswith("-")]
    with tempfile.TemporaryDirectory() as made:
        found = compared(Path(made), lambda name: not words or any(name == word or name.startswith(f"{word}.") for word in words),
                         Firefox if "--firefox" in sys.argv else chromium)
    if "-v" not in sys.argv:
        print(table(found))
        print(json.dumps([row for row in found if not row["same_words"] or row["note"]], indent=1))
        print(f"{len(found)} answers, {sum(not row['same_verdict'] for row in found)} with another verdict, "
              f"{sum(not row['same_words'] for row in found)} in other words, {sum(bool(row['note']) for row in found)} not looked at for undefined operations")
