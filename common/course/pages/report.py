"""The report of a test run on one page, self-contained: build/report/index.html.

It is made from a folder of results:

    *.xml    ctest's JUnit files
    *.json   one result each, an object with "kind" and "chapter":

"shot" and "wrong_picture" are described in shots.py. Tables of cases, from probes and from stability tests:

    {"kind": "probe" | "stability", "chapter", "name", "again": a command that runs them again,
     "rows": [{"case": "02.phong", "inputs": "4096 random, 12 by hand", "worst": "2 ULP", "bound": "4 ULP",
               "ok": bool, "text": "one sentence, as a student reads it"}]}

where each cell may be text, a number or null. "test" is the ctest that wrote it, if its name differs from the
result's (KIND.NN.NAME): a failure is told once; "title" replaces the kind's title. Charts of studies,
paths counted from the root:

    {"kind": "chart", "chapter", "name", "title", "picture": path of a PNG or null, "table": path of a Markdown table or null,
     "again": a command}

Charts in docs/studies/NN_name*.png are shown with or without a result. Failures come first, in full, with
the command that shows more. A file that cannot be read is a failure of its own.
"""

import json
import re
import xml.etree.ElementTree as xml
from pathlib import Path

from pages.page import TEMPLATES, chart_uri, data_uri, lesson_link, page
from tree import ROOT, relative, write_atomically

LAST_LINES = 60  # of a failed test's output
KINDS = {"shot": "A picture against its golden.", "wrong_picture": "Wrong pictures that this golden must reject.",
         "probe": "A function against the truth.", "stability": "Cases where methods fail, against their bounds.",
         "chart": "A study's chart."}
FIGURES = (("flip_mean", "FLIP mean", lambda m: m["flip"]["mean"]),
           ("flip_p99", "p99", lambda m: m["flip"]["p99"]),
           ("step_p999", "step of one pixel in a thousand", lambda m: m.get("step_p999")),
           ("max_diff", "largest step", lambda m: m["max_diff"]["steps"]))


def write_report(results_dir: Path, out: Path):
    """Writes the page of the results in a folder. A folder without results gives a page that says so."""
    results = [read_result(path) for path in sorted(results_dir.glob("*.json"))]
    tests = [test for path in sorted(results_dir.glob("*.xml")) for test in read_junit(path)]
    write_atomically(out, render(results, tests, out.parent))


def read_junit(path: Path) -> list[dict]:
    """ctest's tests: name, ok, seconds, output, and the run (the file's name) they belong to."""
    try:
        suite = xml.parse(path).getroot()
    except (OSError, xml.ParseError) as error:
        return [{"name": path.name, "run": path.stem, "ok": False, "seconds": 0.0,
                 "output": f"{path.name} cannot be read: {error}"}]
    return [{"name": case.get("name", "?"), "run": path.stem, "seconds": float(case.get("time") or 0),
             "ok": case.get("status", "run") in ("run", "disabled", "notrun") and case.find("failure") is None,
             "skipped": case.get("status") in ("disabled", "notrun"),
             "output": case.findtext("system-out") or ""} for case in suite.iter("testcase")]


def is_ok(result: dict) -> bool:
    return result["ok"] if "ok" in result else all(row.get("ok") for row in result.get("rows", []))


def render(results: list[dict], tests: list[dict], folder: Path) -> str:
    failed = [result for result in results if not is_ok(result)]
    explained = {result.get("test", f"{result['kind']}.{result['chapter'][:2]}.{result.get('name')}")
                 for result in failed}
    broken = [test for test in tests if not test["ok"] and test["name"] not in explained]
    shots = sum(result["kind"] == "shot" for result in results)
    cases = sum(len(result.get("rows", [])) for result in results)
    counts = (len(tests), "tests"), (shots, "pictures"), (cases, "cases in tables")
    names = sorted({result["chapter"] for result in results if re.match(r"\d\d_", result["chapter"])})
    return page("report.html", results=results, failed=failed, broken=broken, kinds=KINDS, pictures=Pictures(),
                counted=[f"{count} {what}" for count, what in counts if count],
                tests=sorted(tests, key=lambda test: (test["ok"], test["name"])),
                chapters=[chapter(name, [result for result in results if result["chapter"] == name])
                          | {"lesson": lesson_link(name, folder)} for name in names])


def chapter(name: str, results: list[dict]) -> dict:
    return {"name": name, "results": results, "failed": not all(map(is_ok, results)), "charts": charts(name, results),
            "rejected": [(result["name"], picture) for result in results if result["kind"] == "wrong_picture"
                      for picture in result["pictures"]]}


def again(result: dict, picture: dict | None) -> str:
    lines = [result["again"]] if result.get("again") else []
    if picture and picture.get("expected") and picture.get("actual"):
        lines.append(f"build/compare {picture['expected']} {picture['actual']} --heatmap error.png")
    if result["kind"] == "shot" and picture and picture.get("actual"):
        lines.append(f"./course accept {result['chapter'][:2]}.{result['name']}    # if the new picture is right")
    return "\n".join(lines)


def key_of(result: dict) -> str:
    return re.sub(r"[^\w.-]", "_", f"{result['kind']}.{result['chapter']}.{result.get('name', '')}")


def last_lines(output: str) -> str:
    lines = output.rstrip().splitlines()
    cut = f"... {len(lines) - LAST_LINES} lines before\n" if len(lines) > LAST_LINES else ""
    return cut + "\n".join(lines[-LAST_LINES:])


def charts(chapter_name: str, results: list[dict]) -> list[dict]:
    """The chapter's studies: those of this run, and those in docs/studies. Without a picture if the tree has none."""
    named = {result["name"]: result for result in results if result["kind"] == "chart"}
    for path in sorted((ROOT / "docs" / "studies").glob(f"{chapter_name}*.png")):
        named.setdefault(path.stem, {"name": path.stem, "picture": relative(path)})
    shown = []
    for result in named.values():
        path = result.get("picture")
        chart = {"alt": f"{result['name']}: {result.get('title') or 'time against error'}", "again": result.get("again")}
        try:
            chart["uri"] = chart_uri(ROOT / path) if path else None
        except OSError as error:
            chart["error"] = error
        beside = ROOT / (result.get("table") or (Path(path).with_suffix(".md") if path else "none.md"))
        if beside.is_file():
            chart |= markdown_table(beside.read_text(encoding="utf-8"))
        if path or "rows" in chart or "error" in chart:
            shown.append(chart)
    return shown


def markdown_table(text: str) -> dict:
    """The rows of a Markdown file's table, the head first, and which columns are numbers; supports only the Markdown of
    chart.py."""
    lines = [line.strip() for line in text.splitlines() if line.strip().startswith("|")]
    if len(lines) < 3:
        return {}
    rows = [[cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in lines]
    return {"rows": rows[:1] + rows[2:], "numbers": [cell.endswith("-:") for cell in rows[1]]}


class Pictures:
    def __init__(self):
        self.count = 0

    def image(self, path: str | None, alt: str, lossless: bool) -> dict:
        """alt, and uri and id, or an error that names the missing file."""
        try:
            if not path:
                raise OSError("there is none")
            uri = data_uri(ROOT / path, lossless)
        except OSError as error:
            return {"alt": alt, "error": error}
        self.count += 1
        return {"alt": alt, "uri": uri, "id": f"picture{self.count}"}

    def compare(self, picture: dict, lossless: bool) -> dict:
        """The images expected, actual and heat; no heat where they are equal, which are embedded once."""
        metrics, name = picture.get("metrics"), picture["name"]
        equal = bool(metrics) and metrics["max_diff"]["steps"] == 0
        expected = self.image(picture.get("expected"), f"{name}, expected", lossless)
        if equal and "id" in expected:
            actual = {"alt": f"{name}, actual", "same": expected["id"]}
        else:
            actual = self.image(picture.get("actual"), f"{name}, actual", lossless)
        both = "error" not in expected and "error" not in actual
        heat = self.image(picture.get("heatmap"), f"{name}, FLIP error", lossless) if both and not equal else None
        return {"name": name, "expected": expected, "actual": actual, "heat": heat}


def figures(metrics: dict | None, limits: dict | None) -> list[tuple]:
    measured = [(label, value_of(metrics), (limits or {}).get(key)) for key, label, value_of in FIGURES] if metrics else []
    return [figure for figure in measured if figure[1] is not None]


def read_result(path: Path) -> dict:
    """A result file, or a failed result that says why it cannot be read: the report must not lose it."""
    try:
        result = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(result, dict) or "kind" not in result or "chapter" not in result:
            raise ValueError('it needs "kind" and "chapter"')
        return result
    except (OSError, ValueError) as error:
        return {"kind": "unreadable", "chapter": "tests", "name": path.name, "ok": False,
                "why": [f"{path.name} cannot be used: {error}"]}


TEMPLATES.filters |= {"again": again, "figures": figures, "key_of": key_of, "last_lines": last_lines}
TEMPLATES.tests["ok"] = is_ok
