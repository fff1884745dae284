"""Advice from verdicts: "what should I use?", as tables of lessons and as docs/which.md.

"verdicts" of chapters/NN_name/study*.json has the questions that a study answers:

    "verdicts": [{"id": "05.shadow", "question": "Which filter for a shadow?", "scenes": [...], "methods": [...],
                  "knobs": {"objects.shaded": "raster"}, "enough": {"flip_mean": 0.01}, "limit": "a mean FLIP of 0.01",
                  "not_for": [{"method": "vsm", "where": "blockers one behind the other", "test": "[05.leaks]"}]}]

`scenes`, `methods` and `knobs` leave points out; `enough` has limits by metric instead of one 8-bit step, and `limit` says it in
words. A test named in `not_for` shows the failure. `default` says why the program's default stays although it is dominated: by a
claim (claims.py), or by taste. In a text, the block between

    <!-- verdict: 05.shadow -->
    <!-- /verdict -->

is filled by ./course docs --quote, which also writes docs/which.md.
"""

import functools
import json
import re
from dataclasses import dataclass, field
from pathlib import Path

from charts import measured
from charts.study_file import Study, figures, load
from charts.verdict import Verdict, names_of, verdict_of
from check import lesson_tests
from pages.tables import fill
from tree import ROOT, Failure, chapter_title, chapters, slug

PAGE = Path("docs/which.md")
BEGIN, END = re.compile(r"\s*<!-- verdict: ([\w.]+) -->\s*$"), re.compile(r"\s*<!-- /verdict -->\s*$")
KEYS = {"id", "question", "scenes", "methods", "knobs", "enough", "limit", "not_for", "default"}


@dataclass(frozen=True)
class Question:
    """One question of a chapter and the studies that answer it, those of a CPU first."""
    chapter: str
    entry: dict = field(hash=False)
    studies: tuple[Study, ...]

    def scenes(self) -> list[str]:
        there = dict.fromkeys(scene for study in self.studies for scene in study.scenes)
        wanted = self.entry.get("scenes", list(there))
        if missing := [scene for scene in wanted if scene not in there]:
            raise Failure(f"{self.chapter}: verdict {self.entry['id']} names the scene '{missing[0]}'; there are {', '.join(there)}")
        return wanted

    def points(self, study: Study, scene: str) -> list:
        knobs = {name: values if isinstance(values, list) else [values] for name, values in self.entry.get("knobs", {}).items()}
        return [p for p in study.points if p.scene == scene and p.method in self.entry.get("methods", [p.method]) and
                all(p.knobs.get(name, values[0]) in values for name, values in knobs.items())]

    def verdict(self, study: Study, scene: str) -> Verdict:
        points = self.points(study, scene)
        if "enough" not in self.entry:
            return verdict_of(study, scene, points)
        limits = self.entry["enough"]
        doubts = {name: study.doubling_change(scene, name) or 0.0 for name in limits}
        return Verdict(points, limits, doubts, higher_is_faster=study.higher_is_faster)


@functools.cache
def studies_of(request: Path) -> tuple[Study, ...]:
    found = []
    for file in sorted((ROOT / "docs/studies").glob(f"{request.parent.name}*.json")):
        if measured.request_of(json.loads(file.read_text(encoding="utf-8"))) == str(request):
            found.append(load(file))
    return tuple(sorted(found, key=lambda study: (not study.software, len(study.data["stage"]), study.data["stage"])))


@functools.cache
def questions() -> dict[str, Question]:
    """All questions by their ids, in the order of the chapters. Raises Failure for a verdict that cannot be used."""
    found: dict[str, Question] = {}
    for chapter in chapters():
        for file in sorted((ROOT / "chapters" / chapter).glob("study*.json")):
            request = file.relative_to(ROOT)
            for entry in json.loads(file.read_text(encoding="utf-8")).get("verdicts", []):
                if unknown := set(entry) - KEYS:
                    raise Failure(f"{request}: a verdict has \"{min(unknown)}\"; it has {', '.join(sorted(KEYS))}")
                if not {"id", "question"} <= set(entry) or entry["id"] in found or not entry["id"].startswith(f"{chapter[:2]}."):
                    raise Failure(f"{request}: a verdict needs a \"question\" and an \"id\" of its own that begins with {chapter[:2]}.")
                for failure in entry.get("not_for", []):
                    if "test" in failure and not lesson_tests.matched(f"test_{chapter}", failure["test"]):
                        raise Failure(f"{request}: no test of the chapter is called {failure['test']}")
                question = Question(chapter, entry, studies_of(request))
                if not question.studies:
                    raise Failure(f"{request}: no study in docs/studies answers {entry['id']}")
                question.scenes()
                found[entry["id"]] = question
    return found


def code(name: str) -> str:
    """`method`, knobs"""
    method, comma, rest = name.partition(", ")
    if " " in method:
        return f"`{name}`"
    return f"`{method}`{comma}{rest}"


def error_text(verdict: Verdict, point) -> str:
    """The errors, main first; the others where they decide that it is not enough."""
    values = {metric: verdict.raw(point, metric) for metric in verdict.limits}
    main, *others = values
    over = [metric for metric in others if values[metric] > verdict.limits[metric]]
    words = {"flip_p99": "99th percentile"}
    return " (".join([figures(values[main], 2)] + [f"{words.get(m, m)} {figures(values[m], 2)}" for m in over[:1]]) + ")" * bool(over[:1])


def taken(question: Question, study: Study, scene: str) -> str:
    """A cell: what to take, its time and error, and what is as good."""
    verdict = question.verdict(study, scene)
    if not verdict.points:
        return ""
    names, choice = names_of(verdict.points), verdict.choice
    unit = study.unit
    text = f"{code(names[id(choice)])}: {figures(choice.time[1])} {unit}, {error_text(verdict, choice)}"
    alike = [names[id(p)] for p in verdict.like(choice)]
    if alike:
        text += f"; as good: {', '.join(code(name) for name in alike[:2])}" + (f" and {len(alike) - 2} more" if len(alike) > 2 else "")
    if verdict.cheapest:
        return text
    half = Verdict([p for p in verdict.points if 2 * verdict.time(p)[1] <= verdict.time(choice)[1]], verdict.limits, verdict.doubts,
                   higher_is_faster=study.higher_is_faster).choice
    if half:
        text += f"; in half the time: {code(names[id(half)])}, {figures(half.time[1])} {unit}, {error_text(verdict, half)}"
    return f"*none is enough;* {text}"


def group(point, names: dict[int, str]) -> str:
    """The method's name, or that of the knob's value which stands for it."""
    return names[id(point)].partition(", ")[0]


def beaten(question: Question, scene: str) -> list[str]:
    """The methods of which all points are dominated, on each device."""
    result: list[str] | None = None
    for study in question.studies:
        verdict = question.verdict(study, scene)
        if not verdict.points:
            continue
        names, lost = names_of(verdict.points), {id(p) for p in verdict.dominated}
        methods = dict.fromkeys(group(p, names) for p in verdict.points)
        here = [m for m in methods if all(id(p) in lost for p in verdict.points if group(p, names) == m)]
        result = here if result is None else [m for m in result if m in here]
    return result or []


def failures(question: Question) -> list[str]:
    """Lines on what not to use where: scenes in which no setting of a method taken elsewhere is enough on any device, and
    failures with their tests."""
    chosen: dict[str, None] = {}
    enough: dict[str, set[str]] = {}
    failed: dict[str, dict[str, None]] = {}
    for study in question.studies:
        for scene in question.scenes():
            verdict = question.verdict(study, scene)
            if not verdict.points:
                continue
            names = names_of(verdict.points)
            if verdict.cheapest:
                chosen[group(verdict.choice, names)] = None
            for p in verdict.points:
                (enough.setdefault(group(p, names), set()).add(scene) if verdict.is_enough(p) else
                 failed.setdefault(group(p, names), {}).setdefault(scene))
    lines = []
    for method in chosen:
        fails = [scene for scene in question.scenes() if scene in failed.get(method, {}) and scene not in enough.get(method, set())]
        if fails:
            lines.append(f"{code(method)} is enough with no setting in: {'; '.join(fails)}.")
    for failure in question.entry.get("not_for", []):
        lines.append(f"Not {code(failure['method'])} for {failure['where']}" + (f" (`{failure['test']}`)" if "test" in failure else "") + ".")
    return lines + ([question.entry["default"]] if "default" in question.entry else [])


def device_text(study: Study) -> str:
    if study.data["subject"] == "loader":
        return f"{study.data['stage']}"
    name = "lavapipe" if study.software else re.sub(r"\s*(80GB HBM3|HBM3)", "", study.data["device"])
    return f"{'CPU' if study.software else 'GPU'} ({', '.join(filter(None, (name, study.size_text('').strip())))})"


def table(question: Question) -> list[str]:
    studies = [study for study in question.studies if any(question.points(study, scene) for scene in question.scenes())]
    head = ["scene", *map(device_text, studies), "dominated on each"]
    rows = [[scene, *(taken(question, study, scene) or "–" for study in studies), ", ".join(map(code, beaten(question, scene))) or "–"]
            for scene in question.scenes()]
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in [head, ["---"] * len(head), *rows]]
    study = studies[0]
    metrics = list(question.verdict(study, question.scenes()[0]).limits)
    words = question.entry.get("limit") or ("below one 8-bit step" + (", in its 99th percentile too" if "flip_p99" in metrics else ""))
    versions = ", ".join(dict.fromkeys(s.data["measured"][:7] for s in studies if "measured" in s.data))
    lines += ["", f"*Error: {study.metric_label(metrics[0])}. Enough: {words}." + f" Measured with code {versions}." * bool(versions) + "*"]
    below = failures(question)
    return lines + ([""] + [f"- {line}" for line in below] if below else [])


def block(name: str) -> list[str]:
    """What stands between a text's markers. Raises Failure for an unknown question."""
    if name not in questions():
        raise Failure(f"there is no verdict {name}; there are {', '.join(questions())}")
    question = questions()[name]
    return ["", f"**{question.entry['question']}**", "", *table(question), ""]


def check_blocks(text: Path, lines: list[str]) -> tuple[list[str], list[str]]:
    def verdict(match: re.Match, i: int) -> tuple[int, int]:
        end = next((j for j in range(i, len(lines)) if END.match(lines[j]) or BEGIN.match(lines[j])), None)
        if end is None or not END.match(lines[end]):
            raise Failure(f"the verdict {match[1]} does not end; expected <!-- /verdict -->")
        return i, end

    return fill(text, lines, BEGIN, verdict, lambda match, *_: block(match[1]),
                lambda match, *_: [f"the verdict {match[1]} is not that of its studies"])


def page() -> str:
    lines = ["# What should I use?", "",
             "<!-- Written by ./course docs --quote from docs/studies; edit \"verdicts\" in chapters/NN_name/study.json instead. -->", "",
             "Each table answers one question from a study that is in the tree. In each scene it names the cheapest method that is *enough*, on a "
             "software rasteriser and on a GPU, with its time and its error; where none is enough, the most accurate one. Below the limit no error "
             "is ranked, and a time or an error that the study cannot tell apart from another is *as good*. A method is *dominated* if another is "
             "not slower beyond both quartiles and not less accurate beyond the reference's own uncertainty, and better in one of the two. "
             "[The study format](study_format.md#verdicts) has the definitions. Times of pictures are of whole frames. Below each table stand the versions of the code that was measured: `./course docs --check` "
             "lists those that are not the present one.", "",
             "| chapter | questions |", "|---|---|"]
    by_chapter: dict[str, list[Question]] = {}
    for question in questions().values():
        by_chapter.setdefault(question.chapter, []).append(question)
    for chapter, own in by_chapter.items():
        lines.append(f"| [{chapter[:2]}](#{slug(chapter_title(chapter))}) | {' · '.join(q.entry['question'] for q in own)} |")
    for chapter, own in by_chapter.items():
        lines += ["", f"## {chapter_title(chapter)}", "", f"Why: [the lesson]({chapter}.md)."]
        for question in own:
            lines += ["", f"**{question.entry['question']}**", "", *table(question)]
    return "\n".join(lines) + "\n"


def check_page() -> list[str]:
    """Empty where docs/which.md is what the studies say, and where none asks a question."""
    file = ROOT / PAGE
    return [] if not questions() or file.exists() and file.read_text(encoding="utf-8") == page() else [f"{PAGE}: it is not what the studies say; ./course docs --quote writes it"]
