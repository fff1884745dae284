"""The page and ./course check give the same verdict on each answer: variants in GLSL of the exercises that a browser can check.
build/report/verdicts.md has both."""

import json
import unittest
from pathlib import Path

from browser import WHY_NONE, Browser
from folder_case import FolderCase

from check.variants import Variant, variants
from pages import in_browser
from tree import BUILD, ROOT, chapters, write_atomically

SITE = ROOT / "common/course/pages/site/run"
LEAST = 60


def answers(fit: list[str]) -> list[tuple[str, Variant]]:
    """The variants in GLSL of these exercises."""
    return [(f"{chapter[:2]}.{variant.exercise}", variant) for chapter in chapters() for variant in variants(chapter)[0]
            if variant.name.endswith(".glsl") and f"{chapter[:2]}.{variant.exercise}" in fit]


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


def compared(folder: Path, chosen: list[str], browsed=lambda: Browser(webgl=True)) -> list[dict]:
    asked = answers(chosen)
    return [{"answer": f"{exercise[:3]}{variant.name}", "check": variant.verdict,
             "page": "right" if result["ok"] else f"wrong: {result['first_failure']}", "same_verdict": result["ok"] == (not variant.words)}
            for (exercise, variant), result in zip(asked, said(folder, asked, browsed))]


def table(rows: list[dict]) -> str:
    lines = ["| answer | `./course check` | the page | |", "|---|---|---|---|"]
    for row in rows:
        cells = [row["answer"], row["check"], row["page"][:160], "" if row["same_verdict"] else "DIFFERENT"]
        lines.append("| " + " | ".join(cell.replace("|", "/").replace("\n", " ") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


@unittest.skipIf(WHY_NONE, WHY_NONE)
class Verdicts(FolderCase):
    def test_every_answer_has_the_verdict_of_the_check(self):
        fit = in_browser.write(self.folder)
        self.assertGreaterEqual(len(fit), LEAST)
        rows = compared(self.folder, fit[::8])
        endless = Variant("lambert.endless.glsl", "", "wrong: a loop",
                          "float lambert(vec3 n, vec3 l) { float s = 0.0; while (true) s += 1.0; return s; }")
        loop, = said(self.folder, [("02.lambert", endless)], lambda: Browser(webgl=True))
        write_atomically(BUILD / "report" / "verdicts.md", table(rows))
        self.assertGreater(len(rows), 2 * len(fit[::8]))
        self.assertEqual([row for row in rows if not row["same_verdict"]], [])
        self.assertRegex(loop["first_failure"], r"^lambert\(.*\) does not return: does a loop never end\?$")
