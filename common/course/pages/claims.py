"""Claims in words that lessons bind to studies, and sentences that compare measured things and have none.

    Tiles are faster than clusters here.<!-- claim: 03.lights#scene=1,000 lights | 10,000 lights; ms(tiled) < ms(clustered) -->

Before # stands a question (advice.py), which is asked on each device, or on one as 03.lights@cpu and @gpu, or a file, where
13_mlaa.h200 is docs/studies/13_mlaa.h200.json. `scene` has the scenes in which the claim holds, divided by |; all where it is left
out; `elsewhere; WHY` marks what was measured by programs that are not in the tree. The rest is an expression in Python's syntax of comparisons, + - * /, and, or, not, round(), min(), max() and

    ms(P), mb_per_s(P), flip_mean(P), NAME(P)   a point's time or error; value("ms.PASS", P) as tables have it
    least(NAME, P), most(NAME, P)      of all points that P selects
    enough(P)                          one of them is enough
    dominated(P)                       each of them is dominated
    taken(P)                           the verdict takes one of them
    same(P, Q)                         cannot be told apart
    near(X, Y)                         within a tenth
    of(SCENE, NAME, P)                 a point's value in another scene
    at("/path")                        a value of the file

P is a method, or "method; knob=value", or "knob=value"; a name alone needs no quotes. `python3 common/course pages.claims` lists
the sentences that compare without a claim, and counts both.
"""

import ast
import functools
import re
from pathlib import Path

from charts.study_file import StudyError, load
from charts.verdict import verdict_of
from pages import advice, tables
from tree import ROOT, Failure, lessons, say

CLAIM = re.compile(r"<!-- claim: (?P<claim>.*?) -->", re.S)
OPERATIONS = {ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b, ast.Mult: lambda a, b: a * b, ast.Div: lambda a, b: a / b}
COMPARISONS = {ast.Lt: lambda a, b: a < b, ast.LtE: lambda a, b: a <= b, ast.Gt: lambda a, b: a > b, ast.GtE: lambda a, b: a >= b,
               ast.Eq: lambda a, b: a == b, ast.NotEq: lambda a, b: a != b}


class Scene:
    """What a claim's functions ask: one scene of one study."""

    def __init__(self, data: dict, scene: str | None, verdict):
        self.data, self.scene, self._verdict = data, scene, verdict

    @functools.cached_property
    def verdict(self):
        return self._verdict()

    def selected(self, selector: str) -> dict[str, str]:
        method, _, rest = selector.partition(";") if "=" not in selector.partition(";")[0] else ("", "", selector)
        return {**({"scene": self.scene} if self.scene else {}), **({"method": method.strip()} if method.strip() else {}),
                **tables.selection(rest)}

    def value(self, name: str, selector: str) -> float:
        point = tables.points(self.data, self.selected(selector))[0]
        if name == "mb_per_s":
            return point["mb_per_s"]["median"]
        return tables.value_of(self.data, point, name)

    def points(self, selector: str) -> list:
        wanted = self.selected(selector)
        found = [p for p in self.verdict.points if all(p.method == value if key == "method" else key == "scene" or
                 tables.same(p.knobs.get(key), value) for key, value in wanted.items())]
        if not found:
            raise Failure(f"no point is {selector}")
        return found

    def of_all(self, name: str, selector: str) -> list[float]:
        return [tables.value_of(self.data, p.data, name) for p in self.points(selector)]

    def call(self, name: str, words: list):
        verdicts = {"enough": lambda p: any(map(self.verdict.is_enough, self.points(p))),
                    "dominated": lambda p: all(self.verdict.dominator(one) for one in self.points(p)),
                    "taken": lambda p: self.verdict.choice in self.points(p),
                    "same": lambda p, q: all(self.verdict.same(a, b) for a in self.points(p) for b in self.points(q)),
                    "least": lambda metric, p: min(self.of_all(metric, p)), "most": lambda metric, p: max(self.of_all(metric, p)),
                    "near": near, "round": round, "min": min, "max": max,
                    "value": self.value, "of": lambda scene, name, p: Scene(self.data, scene, None).value(name, p), "at": lambda path: tables.at_path(self.data, path)}
        return verdicts[name](*words) if name in verdicts else self.value(name, *words)

    def evaluate(self, node: ast.expr):
        match node:
            case ast.Expression():
                return self.evaluate(node.body)
            case ast.Constant(value=int() | float() | str() as value):
                return value
            case ast.Name(id=name):
                return name
            case ast.BoolOp(op=op, values=values):
                return (all if isinstance(op, ast.And) else any)(self.evaluate(value) for value in values)
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                return not self.evaluate(operand)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return -self.evaluate(operand)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATIONS:
                return OPERATIONS[type(op)](self.evaluate(left), self.evaluate(right))
            case ast.Compare(left=left, ops=ops, comparators=others) if all(type(op) in COMPARISONS for op in ops):
                values = [self.evaluate(one) for one in (left, *others)]
                return all(COMPARISONS[type(op)](a, b) for op, a, b in zip(ops, values, values[1:]))
            case ast.Call(func=ast.Name(id=name), args=words, keywords=[]):
                return self.call(name, [self.evaluate(word) for word in words])
        raise Failure(f"'{ast.unparse(node)}' means nothing in a claim")


def scenes_of(source: str, named: list[str]) -> list[Scene]:
    name, _, device = source.partition("@")
    if name in advice.questions():
        question = advice.questions()[name]
        studies = [study for study in question.studies if device in ("", "cpu" if study.software else "gpu")]
        found = [Scene(study.data, scene, functools.partial(question.verdict, study, scene)) for study in studies
                 for scene in (named or question.scenes()) if question.points(study, scene)]
    else:
        file = source if source.endswith(".json") else f"docs/studies/{source}.json"
        data = tables.load(file)
        there = named or list(dict.fromkeys(point.get("scene") for point in data.get("points", data.get("rows", [])))) or [None]
        found = [Scene(data, scene, lambda scene=scene: verdict_of(load(ROOT / file), scene)) for scene in there]
    if not found:
        raise Failure(f"{source} has no such scene")
    return found


def near(a: float, b: float) -> bool:
    return abs(a - b) <= 0.1 * max(abs(a), abs(b))


def parts_of(claim: str) -> tuple[str, list[str], str]:
    """Its source, its scenes and its expression, which is empty for data that are elsewhere."""
    if re.match(r"elsewhere; \S", claim):
        return "", [], ""
    source, _, rest = " ".join(claim.split()).partition("#")
    named = re.match(r"\s*scene=([^;]*);", rest)
    return source.strip(), [one.strip() for one in named[1].split("|")] if named else [], (rest[named.end():] if named else rest.lstrip("; ")).strip()


def fault_of(claim: str) -> str:
    """Why a claim is false or cannot be read; empty where it holds, or where its data are elsewhere."""
    source, named, text = parts_of(claim)
    if not source:
        return ""
    try:
        tree = ast.parse(text, mode="eval")
        for scene in scenes_of(source, named):
            if scene.evaluate(tree) is not True:
                return f"{scene.scene or source}, {scene.data.get('device', '')}: it is not so that {text}"
    except SyntaxError as error:
        return f"{text}: {error.msg}"
    except (Failure, StudyError, KeyError, TypeError, ValueError, ZeroDivisionError) as error:
        return f"{type(error).__name__}: {error}" if isinstance(error, (KeyError, TypeError)) else str(error)
    return ""


def check_claims(text: Path) -> list[str]:
    words = (ROOT / text).read_text(encoding="utf-8")
    return [f"{text}:{words.count(chr(10), 0, match.start()) + 1}: a claim does not hold: {fault}"
            for match in CLAIM.finditer(words) if (fault := fault_of(match["claim"]))]


# Words that compare costs or errors of themselves, or where the sentence names what is measured. A maximum is no comparison.
COMPARES = re.compile(
    r"\b(?:faster|slower|fastest|slowest|cheaper|cheapest|dearer|dearest|outperforms?|(?<!\d )beats|wins?|loses? to|no advantage|"
    r"(?:more|less|most|least|as) accurate|as fast as|no slower|(?<!at )the same time|"
    r"costs? (?:\w+ ){0,2}(?:less|more)|(?:takes?|took) (?:less time|more time|no longer|longer than)|comes? closest|the nearest in|"
    r"(?:twice|times) as (?:long|slow|fast|accurate|wrong)|"
    r"(?:half|third|quarter|fifth|sixth|seventh|eighth|ninth|tenth|twice|double) (?:of )?(?:the|its|their|that) (?:time|error|cost)|"
    r"(?:smaller|smallest|larger|less|lower|lowest|least|greater) (?:\w+ )?(?:errors?|FLIP|RMSE|times?|cost))\b", re.I)
PERHAPS = re.compile(r"\b(?:better|best|worse|worst|as good as|half|twice|double(?! precision)|times (?:as|the)|"
                     r"a (?:third|quarter|fifth|sixth|seventh|eighth|ninth|tenth)|hardly|nearly)\b", re.I)
MEASURED = re.compile(r"\b(?:errors?|FLIP|RMSE|ms|milliseconds|(?<!same )time|costs?|evaluates?)\b")
BOUND = re.compile(r"⟦bound⟧|\[\d\d\.\w+\]|build/tests/|ctest |--method auto")  # by a figure, a claim, a test; the rule's own words
SKIPPED = ("Exercises", "Questions", "Further reading", "What you will be able to do", "The first ten minutes")


def sentences(text: Path) -> list[tuple[int, str, str]]:
    """(its paragraph's line, section, sentence) of a text's prose: without code, tables, quotations and answers; comments are
    marks."""
    words = (ROOT / text).read_text(encoding="utf-8")

    def blank(match: re.Match) -> str:
        return "\n" * match[0].count("\n")

    words = re.sub(r"^([ \t]*)(```+|~~~+).*?^\1\2[ \t]*$", blank, words, flags=re.S | re.M)
    words = re.sub(r"<!-- verdict: .*?<!-- /verdict -->", blank, words, flags=re.S)
    words = re.sub(r"<!-- (?:figure|claim): .*?-->", lambda m: "⟦bound⟧" + blank(m), words, flags=re.S)
    words = re.sub(r"<!--.*?-->", blank, words, flags=re.S)
    found, section, begin, part = [], "", 0, []

    def end():
        for one in re.split(r"(?<=[.!?])(?:\*\*)?((?:\s*⟦bound⟧)*)\s+(?=[A-Z`*$\[0-9])", " ".join(part)) if part else []:
            if one.strip() and not one.replace("⟦bound⟧", "").strip() and found:
                found[-1] = (*found[-1][:2], found[-1][2] + one)
            elif one.strip():
                found.append((begin, section, one.strip()))
        part.clear()

    for number, line in enumerate(words.split("\n"), 1):
        starts = line.startswith("#") or re.match(r"\s*(?:[-*]|\d+\.) ", line)
        if starts or not line.strip() or line.lstrip().startswith(("|", "<", "!")) or line.startswith("    ") and not part:
            end()
        if line.startswith("## "):
            section = re.sub(r"^#+\s*", "", line)
        elif line.strip() and not line.startswith("#") and not line.lstrip().startswith(("|", "<", "!")) and (part or starts or not line.startswith("    ")):
            begin = begin if part else number
            part.append(line.strip())
    end()
    return found


def unbound(text: Path) -> list[tuple[int, str, str]]:
    """Sentences that compare measured things without a claim or a figure's source."""
    return [(line, section, words) for line, section, words in sentences(text)
            if not BOUND.search(words) and not section.startswith(SKIPPED) and
            (COMPARES.search(words) or PERHAPS.search(words) and MEASURED.search(words))]


if __name__ == "__main__":
    loose = [(lesson, *found) for lesson in lessons() for found in unbound(lesson)]
    for lesson, line, section, words in loose:
        say(f"{lesson}:{line}: {section}: {words}")
    made = [match["claim"] for lesson in lessons() for match in CLAIM.finditer((ROOT / lesson).read_text(encoding="utf-8"))]
    say(f"{len(made)} claims, {sum(claim.startswith('elsewhere;') for claim in made)} of them measured elsewhere; {len(loose)} sentences "
        "compare without one")
