"""Resources for running programs and checking exercises within a page: our scripts, the packaged editor, tables of checks,
scenes."""

import json
import shutil
from pathlib import Path

from pages import in_browser
from pages.quotes import quoted
from tree import ROOT, Failure, write_atomically

OWN = Path(__file__).parent / "site" / "run"
SCRIPTS = ["gl.js", "undefined.js", "tables.js", "program.js", "exercise.js", "answers.js", "states.js"]
CODEMIRROR = Path("/usr/share/javascript/codemirror")
EDITOR = ["lib/codemirror.js", "lib/codemirror.css", "mode/clike/clike.js", "addon/edit/matchbrackets.js",
          "addon/edit/closebrackets.js", "addon/comment/comment.js"]
MINIMAL = ROOT / "docs" / "minimal"
TRIED = "11_fractals"  # the program that runs on the first page, which does not list it


def write(assets: Path):
    """Writes run/, cm/ and tables/ to the folder of the pages' assets."""
    for name in [*SCRIPTS, "run.css"]:
        (assets / "run").mkdir(parents=True, exist_ok=True)
        shutil.copyfile(OWN / name, assets / "run" / name)
    if not CODEMIRROR.exists():
        raise Failure(f"there is no {CODEMIRROR}; the packages are in common/course/packages/docs")
    (assets / "cm").mkdir()
    for name in EDITOR:
        shutil.copyfile(CODEMIRROR / name, assets / "cm" / Path(name).name)
    fit = in_browser.write(assets / "tables")
    write_atomically(assets / "run" / "data.js", f"Answers.list = {json.dumps(fit)};\n"
                     f"Program.scenes = {json.dumps(scenes(), ensure_ascii=False, separators=(',', ':'))};\n")


def scenes() -> dict[str, dict]:
    """docs/minimal/scenes.json; the one of the first page with its text."""
    if not (MINIMAL / "scenes.json").exists():
        return {}
    found = json.loads((MINIMAL / "scenes.json").read_text(encoding="utf-8"))
    if TRIED in found:
        found[TRIED]["text"] = "\n".join(quoted((MINIMAL / f"{TRIED}.frag").relative_to(ROOT), "minimal")) + "\n"
    return found
