"""Tests whose results are tables of the report: build/results/KIND.NN.json, as report.py describes them.

    test.results check NN_name        the chapter's checks: the reference passes, and the starter does not
    test.results stability NN_name    the cases of tests/NN_name/test_stability.cpp
    test.results charts               the studies in docs/studies: each can be read, and its chart and table are there

A failure is exit code 1 and a line that says why.
"""

import json
import re
import sys

from charts.study_charts import chart_paths, charts_of
from charts.study_file import StudyError, load, markdown_table
from shots.rendering import run_program
from charts.drawn import shown_by_lessons
from tree import BUILD, ROOT, Failure, exercises, is_edited, relative, say, warn, write_atomically

# Table titles that replace report.py's default for their kind.
TITLES = {"study": "The study, run quickly", "need": "The need rule on other scenes"}


def write_result(name: str, result: dict):
    write_atomically(BUILD / "results" / f"{name}.json", json.dumps(result, indent=1, ensure_ascii=False) + "\n")


def table(kind: str, chapter: str, name: str, again: str, rows: list[dict]) -> list[str]:
    """Writes a table of cases for the test NAME.NN, and returns a line for each that is not ok."""
    test = f"{name}.{chapter[:2]}"
    write_result(test, {"kind": kind, "chapter": chapter, "name": name, "title": TITLES.get(name),
                        "test": test, "again": again, "rows": rows})
    return [f"{row['case']}: {row.get('text') or 'not ok'}" for row in rows if not row["ok"]]


def check_rows(chapter: str, **environment) -> list[dict]:
    """A row for each exercise of which the reference was checked, and for each fault beside. Raises Failure where the checks
    say nothing."""
    program, found = BUILD / "tests" / f"check_{chapter}", {}
    for use in ("exercise", "solution"):
        done = run_program([program, "--use", use], **environment)
        found[use] = {line["exercise"]: line for line in map(json.loads, re.findall(r"^\{.*", done.stdout, re.M))}
        if not found[use]:
            raise Failure(f"{program.name} ended with {done.returncode}: {done.stderr.strip()[-500:]}")
    rows = [{"case": exercise, "inputs": f"{result['passed'] + result['failed']} checks", "ok": result["ok"] is True,
             "text": result.get("first_failure") or f"{result['passed']} passed, {result['failed']} failed"}
            for exercise, result in found["solution"].items()]
    if done.returncode and all(row["ok"] for row in rows):
        rows.append({"case": program.name, "ok": False, "text": f"ended with {done.returncode}: {done.stderr.strip()[-500:]}"})
    for exercise, path in exercises(chapter).items():
        if exercise not in found["solution"]:
            rows.append({"case": exercise, "inputs": "no check", "ok": False, "text": "nothing checks it"})
        if found["exercise"].get(exercise, {}).get("ok") and not is_edited(path):  # else somebody works on it
            rows.append({"case": exercise, "inputs": "the starter", "ok": False, "text": "the starter passes"})
    return rows


def check(chapter: str) -> list[str]:
    return table("probe", chapter, "check", f"build/tests/check_{chapter} --use solution", check_rows(chapter))


def stability(chapter: str) -> list[str]:
    again = f"build/tests/test_{chapter} '-#' '[#test_stability]'"
    done = run_program([BUILD / "tests" / f"test_{chapter}", "-#", "[#test_stability]", "-r", "rows"])
    rows = [case_row(json.loads(line)) for line in done.stdout.splitlines() if line.startswith("{")]
    if not rows and not done.returncode:
        raise Failure(f"test_{chapter} has no case in test_stability.cpp")
    if done.returncode and all(row["ok"] for row in rows):
        rows.append({"case": f"test_{chapter}", "ok": False, "text": f"ended with {done.returncode}: {done.stderr.strip()[-500:]}"})
    return table("stability", chapter, "stability", again, rows)


def case_row(case: dict) -> dict:
    text = f"{case['seconds']:.2f} s" if case["ok"] else " ".join(case["failure"].split()) or "it did not end"
    return {"case": case["case"], "inputs": f"{case['checks']} checks", "ok": case["ok"], "text": text}


def charts() -> list[str]:
    said, shown = [], shown_by_lessons()
    for path in sorted((ROOT / "docs" / "studies").glob("*.json")):
        why, chapter, again = [], path.name.split(".")[0], ""
        markdown, charts = path.with_suffix(".md"), [(path.stem, path.with_suffix(""))]
        try:
            study = load(path)
            chapter, again = study.data["chapter"], study.data["command"]
            beside = chart_paths(study.data, path.with_suffix(""))
            charts = [(chart.title, place) for chart, place in zip(charts_of(study), beside)]
            if not markdown.exists() or markdown.read_text(encoding="utf-8") != markdown_table(study):
                why.append(f"{relative(markdown)} is not the table of {path.name}: python3 common/course charts.chart "
                           f"{relative(path)} writes it")
        except StudyError as error:
            why.append(str(error))
        for i, (title, place) in enumerate(charts):
            picture = place.with_name(place.name + ".png")
            wrong = [] if i else why
            if picture.name in shown and not picture.exists():
                wrong.append(f"there is no {relative(picture)}: python3 common/course charts.chart {relative(path)} draws it")
            table_path = relative(markdown) if markdown.exists() and not i else None
            write_result(f"chart.{place.name}", {"kind": "chart", "chapter": chapter, "name": place.name,
                                                 "title": title, "ok": not wrong, "why": wrong, "test": "text.charts",
                                                 "picture": relative(picture) if picture.exists() else None, "table": table_path, "again": again})
            said += wrong
    return said


def main(words: list[str]) -> int:
    if words == ["charts"]:
        wrong = charts()
    elif len(words) == 2 and words[0] in ("check", "stability"):
        wrong = {"check": check, "stability": stability}[words[0]](words[1])
    else:
        warn(__doc__)
        return 2
    for line in wrong:
        say(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
