"""The report of a test run on one page, self-contained: build/report/index.html.

It is made of all that lies in a folder of results:

    *.xml    ctest's JUnit files
    *.json   one result each, an object with "kind" and "chapter":

"shot" and "teeth" are described in shots.py. Tables of cases, from probes and from stability tests:

    {"kind": "probe" | "stability", "chapter", "name", "again": a command that runs them again,
     "rows": [{"case": "02.phong", "inputs": "4096 random, 12 by hand", "worst": "2 ULP", "bound": "4 ULP",
               "ok": bool, "text": "one sentence, as a student reads it"}]}

where each cell may be text, a number or null. "test" is the ctest that wrote it, where that is not called like the
result (KIND.NN.NAME): a failure is told once; "title" stands over the table in place of the kind's. Charts of studies,
paths counted from the root:

    {"kind": "chart", "chapter", "name", "title", "svg": path, "table": path of a Markdown table or null, "again": a command}

Charts in docs/studies/NN_name*.svg are shown with or without a result. What failed stands first, in full, and says
what to type to look closer. A file that cannot be read is a failure of its own.
"""

import re
import xml.etree.ElementTree as xml
from html import escape
from pathlib import Path

import report_cards
from page import chapter_title, data_uri, page, table
from report_cards import Pictures, figures_line, read_result
from tree import ROOT, relative, write_atomically

LAST_LINES = 60  # of a failed test's output


def write_report(results_dir: Path, out: Path):
    """Writes the page of the results in a folder. A folder without results gives a page that says so."""
    results = [read_result(path) for path in sorted(results_dir.glob("*.json"))]
    tests = [test for path in sorted(results_dir.glob("*.xml")) for test in read_junit(path)]
    write_atomically(out, render(results, tests))


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


def render(results: list[dict], tests: list[dict]) -> str:
    """The page's HTML."""
    pictures = Pictures()
    chapters = sorted({result["chapter"] for result in results if re.match(r"\d\d_", result["chapter"])})
    failed = [result for result in results if not is_ok(result)]
    explained = {result.get("test", f"{result['kind']}.{result['chapter'][:2]}.{result.get('name')}")
                 for result in failed}
    broken = [test for test in tests if not test["ok"] and test["name"] not in explained]
    body = head(results, tests, len(failed) + len(broken), chapters, {result["chapter"] for result in failed})
    if failed or broken:
        body += '<section id="failed">\n<h2>What failed</h2>\n'
        body += "".join(failure_card(result, pictures) for result in failed)
        body += "".join(test_card(test) for test in broken) + "</section>\n"
    for chapter in chapters:
        body += chapter_section(chapter, [r for r in results if r["chapter"] == chapter], pictures)
    body += test_table(tests)
    return page("Lightwalk: tests", body, report_cards.STYLE, report_cards.SCRIPT)


def badge(ok: bool, text: str) -> str:
    return f'<span class="badge {"good" if ok else "bad"}">{escape(text)}</span>'


def head(results, tests, failures: int, chapters: list[str], failed_chapters: set[str]) -> str:
    if not results and not tests:
        return "<h1>Tests</h1>\n<p>No test has run. <code>./course test</code> runs them.</p>\n"
    shots = sum(result["kind"] == "shot" for result in results)
    cases = sum(len(result.get("rows", [])) for result in results)
    counted = ", ".join(f"{count} {what}" for count, what in ((len(tests), "tests"), (shots, "pictures"),
                                                               (cases, "cases in tables")) if count)
    links = [f'<li><a href="#{chapter}" class="{"bad" if chapter in failed_chapters else ""}">'
             f"{escape(chapter_title(chapter))}</a></li>" for chapter in chapters]
    links = (['<li><a class="bad" href="#failed">What failed</a></li>'] if failures else []) + links
    state = badge(not failures, f"{failures} failed" if failures else "all passed")
    return f"<h1>Tests</h1>\n<p>{state} {counted}.</p>\n<nav><ul>{''.join(links)}</ul></nav>\n"


def again(result: dict, picture: dict | None = None) -> str:
    """What to type to look closer."""
    lines = [result["again"]] if result.get("again") else []
    if picture and picture.get("expected") and picture.get("actual"):
        lines.append(f"build/compare {picture['expected']} {picture['actual']} --heatmap error.png")
    if result["kind"] == "shot" and picture and picture.get("actual"):
        lines.append(f"./course accept {result['chapter'][:2]}.{result['name']}    # if the new picture is right")
    return f'<p class="quiet">Look closer:</p>\n<pre>{escape(chr(10).join(lines))}</pre>\n' if lines else ""


def failure_card(result: dict, pictures: Pictures) -> str:
    title = f"{chapter_title(result['chapter'])}: {result.get('name', result['kind'])}"
    why = "".join(f"<p>{escape(line)}</p>\n" for line in result.get("why", []))
    body = f'<article class="card bad" id="failed-{escape(key_of(result))}">\n<h3>{escape(title)}</h3>\n'
    body += f'<p class="quiet">{escape(kind_text(result["kind"]))}</p>\n{why}'
    shown = [picture for picture in result.get("pictures", []) if not picture["ok"]]
    for picture in shown:
        if len(shown) > 1 or picture["name"] != result.get("name"):
            body += f"<h3>{escape(picture['name'])}</h3>\n"
        reject = result["kind"] == "teeth"
        body += figures_line(picture.get("metrics"), result.get("limits", {}), reject)
        body += pictures.comparison(picture, lossless=True)
    if result.get("rows"):
        body += case_table([row for row in result["rows"] if not row.get("ok")])
    return body + again(result, shown[0] if shown else None) + "</article>\n"


def kind_text(kind: str) -> str:
    return {"shot": "A picture against its golden.", "teeth": "Wrong pictures that this golden must reject.",
            "probe": "A function against the truth.", "stability": "Cases where methods fail, against their bounds.",
            "chart": "A study's chart."}.get(kind, "")


def key_of(result: dict) -> str:
    return re.sub(r"[^\w.-]", "_", f"{result['kind']}.{result['chapter']}.{result.get('name', '')}")


def test_card(test: dict) -> str:
    lines = test["output"].rstrip().splitlines()
    cut = f"... {len(lines) - LAST_LINES} lines before\n" if len(lines) > LAST_LINES else ""
    output = cut + "\n".join(lines[-LAST_LINES:])
    run = "" if test["run"] == "tests" else f' <span class="quiet">({escape(test["run"])})</span>'
    command = f"./course test '^{test['name']}$'" + (" --sanitize" if test["run"] == "sanitizer" else "")
    return (f'<article class="card bad">\n<h3>{escape(test["name"])}{run}</h3>\n<pre>{escape(output)}</pre>\n'
            f'<p class="quiet">Look closer:</p>\n<pre>{escape(command)}</pre>\n</article>\n')


def chapter_section(chapter: str, results: list[dict], pictures: Pictures) -> str:
    body = f'<section id="{escape(chapter)}">\n<h2>{escape(chapter_title(chapter))}</h2>\n'
    shots = [result for result in results if result["kind"] == "shot"]
    if shots:
        body += ('<h3>Pictures</h3>\n<p class="quiet">Pictures that passed are shown as WebP; the figures are those of the '
                 "exact ones.</p>\n") + "".join(shot_card(result, pictures) for result in shots)
    teeth = [(result, picture) for result in results if result["kind"] == "teeth" for picture in result["pictures"]]
    if teeth:
        body += "<h3>Pictures that the goldens must reject</h3>\n" + teeth_table(teeth)
    for kind, title in (("probe", "Functions against the truth"), ("stability", "Where methods fail")):
        for result in results:
            if result["kind"] == kind:
                name = f' <span class="quiet">{escape(result["name"])}</span>' if result.get("name") else ""
                body += f"<h3>{escape(result.get('title') or title)}{name}</h3>\n" + case_table(result.get("rows", []))
    return body + charts(chapter, results) + "</section>\n"


def shot_card(result: dict, pictures: Pictures) -> str:
    if not is_ok(result):
        return (f'<article class="card bad"><h3>{escape(result["name"])} {badge(False, "failed")}</h3>'
                f'<p><a href="#failed-{escape(key_of(result))}">above</a></p></article>\n')
    picture = result["pictures"][0]
    return (f'<article class="card">\n<h3>{escape(result["name"])} {badge(True, "passed")}</h3>\n'
            f'<p>{escape(result.get("caption", ""))}</p>\n'
            f'{figures_line(picture.get("metrics"), result.get("limits", {}))}'
            f'{pictures.comparison(picture, lossless=False)}'
            f'<p class="quiet"><code>{escape(result.get("again", ""))}</code></p>\n</article>\n')


def teeth_table(teeth: list) -> str:
    rows = []
    for result, picture in teeth:
        metrics = picture.get("metrics")
        found = [f"{metrics['flip']['mean']:.4g}", f"{metrics['flip']['p99']:.4g}",
                 str(metrics["max_diff"]["steps"])] if metrics else ["–"] * 3
        rows.append([escape(result["name"]), escape(picture["name"]), *found,
                     badge(picture["ok"], "rejected" if picture["ok"] else "not rejected")])
    bad = [not picture["ok"] for _, picture in teeth]
    return table(["golden", "picture", "FLIP mean", "p99", "largest step", ""], rows, bad, numbers=(2, 3, 4))


def case_table(cases: list[dict]) -> str:
    def cell(value):
        return "" if value is None else escape(f"{value:.4g}" if isinstance(value, float) else str(value))

    rows = [[cell(row.get("case")), cell(row.get("inputs")), cell(row.get("worst")), cell(row.get("bound")),
             cell(row.get("text")), badge(bool(row.get("ok")), "within" if row.get("ok") else "outside")]
            for row in sorted(cases, key=lambda row: bool(row.get("ok")))]
    bad = sorted(not row.get("ok") for row in cases)[::-1]
    return table(["case", "inputs", "worst", "bound", "", ""], rows, bad, numbers=(2, 3))


def charts(chapter: str, results: list[dict]) -> str:
    """The chapter's studies: those that this run made, and those in docs/studies."""
    named = {relative(ROOT / result["svg"]): result for result in results if result["kind"] == "chart"}
    for path in sorted((ROOT / "docs" / "studies").glob(f"{chapter}*.svg")):
        named.setdefault(relative(path), {"name": path.stem, "svg": relative(path)})
    body = ""
    for path, result in named.items():
        title = result.get("title") or "time against error"
        try:
            picture = f'<img src="{data_uri(ROOT / path)}" alt="{escape(result["name"])}: {escape(title)}">'
        except OSError as error:
            picture = f'<div class="missing"><p>{escape(str(error))}</p></div>'
        beside = ROOT / (result.get("table") or Path(path).with_suffix(".md"))
        text = beside.read_text(encoding="utf-8") if beside.is_file() else ""
        command = f'<p class="quiet"><code>{escape(result["again"])}</code></p>\n' if result.get("again") else ""
        body += (f'<article class="card chart">\n<div class="paper">{picture}</div>\n'
                 f"{markdown_tables(text)}{command}</article>\n")
    return f"<h3>What methods cost</h3>\n{body}" if body else ""


def markdown_tables(text: str) -> str:
    """The table of a Markdown file as HTML, folded away; what chart.py writes, no more of Markdown than that."""
    lines = [line.strip() for line in text.splitlines() if line.strip().startswith("|")]
    if len(lines) < 3:
        return ""
    rows = [[escape(cell.strip().replace("\\|", "|")) for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
            for line in lines]
    flush_right = tuple(i for i, cell in enumerate(rows[1]) if cell.endswith("-:"))
    return f"<details><summary>The figures</summary>\n{table(rows[0], rows[2:], numbers=flush_right)}</details>\n"


def test_table(tests: list[dict]) -> str:
    if not tests:
        return ""
    rows, bad = [], []
    for test in sorted(tests, key=lambda test: (test["ok"], test["name"])):
        state = "skipped" if test.get("skipped") else "passed" if test["ok"] else "failed"
        rows.append([escape(test["name"]), escape(test["run"]), f"{test['seconds']:.2f} s", badge(test["ok"], state)])
        bad.append(not test["ok"])
    return f'<section id="tests">\n<h2>All tests</h2>\n{table(["test", "run", "time", ""], rows, bad, numbers=(2,))}</section>\n'
