"""Figures that lessons take from a study's JSON: rows of tables, and numbers in running text.

A table's rows are written by ./course docs --quote. A comment before the table has the settings of all cells, then a line with
those of each column, then a line for each row; the first column stays as it is.

    <!-- table: docs/studies/13_mlaa.lavapipe.json#value=edge_rmse; format=.3f
    method=none | method=mlaa
    scene=city, a street
    scene=letters -->
    | | none | `mlaa` |
    |---|---:|---:|
    | city | 0.104 | 0.071 |
    | letters | 0.131 | 0.078 |

A cell is the point that `scene`, `method` and knobs select. It shows `value`: an error's name; `ms`, the median time, or
`ms.PASS` that of passes (joined by +, or all that begin so: post*); `VALUE over METHOD` its ratio to that method's in the same
scene, `VALUE less METHOD` its difference; a path that begins with / within the file, instead of a point, where an entry of a
list is called by its number, `name` or `to` (`missing` is shown where it leads to nothing). $KEY is the KEY of the row; `name`
and `pass` are for that alone. `file` is another JSON file, for one column. `format` is Python's, and `.3s` three significant
digits, which is the rule where none is given. `cell` is a text with {VALUE:FORMAT}, for cells with more than a number (\\; is
a semicolon). A knob or method with several values, as in steps=8,16, gives one after the other, or with `join=range` the
smallest and the largest. `bold=least` marks the smallest of a column. A column or row that is `-` is left as it is, and
`only=4` fills a row's first four columns. `all` is a row that selects no more than its columns.

A number in running text is followed by its source, and is right where the source, rounded to as many digits, is it:

    within 0.0034<!-- figure: docs/studies/19_ambiance.lavapipe.json#scene=even keys; method=arc_length; value=flip_mean -->

`tolerance=5%` allows more. In a path, `*` is the mean over a list, and names joined by + are a sum. A constant's source is a
line of the code, in which {} stands for the number: common/window/sound_player.cpp#fade_s = {}; scale=1000. Sources that are
commands are read by ./course docs --check (test/figures.py).
"""

import functools
import json
import re
import statistics
from decimal import Decimal
from pathlib import Path

from tree import ROOT, Failure

TABLE = re.compile(r"\s*<!-- table: (\S+?\.json)#(.*)$")
FIGURE = re.compile(r"(?P<number>[-−+]?[\d,]*\.?\d+(?:e[-+]?\d+)?)(?P<unit>(?:%|°| ?(?:px|ms|dB|µs|µm|[ms]))?[*$]{0,2})"
                    r"<!-- figure: (?P<source>.*?) -->", re.S)
PLACEHOLDER = re.compile(r"\{([^}:]+)(?::([^}]*))?\}")
OWN = ("scene", "method", "value", "format", "cell", "join", "bold", "only", "tolerance", "scale", "file", "missing",
       "name", "pass")
BETWEEN = re.compile(r"\s+(over|less)\s+")
NUMBER = r"([-+]?[\d.]+(?:e[-+]?\d+)?)"


@functools.cache
def load(name: str) -> dict:
    try:
        return json.loads((ROOT / name).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise Failure(f"{name} cannot be read: {error}") from None


def selection(text: str) -> dict[str, str]:
    """key=value, separated by semicolons; `all` selects nothing more."""
    if text.strip() == "all":
        return {}
    found = {}
    for part in filter(None, (one.strip() for one in re.split(r"(?<!\\);", text))):
        key, equals, value = part.partition("=")
        if not equals:
            raise Failure(f"'{part}' selects nothing; expected KEY=VALUE")
        found[key.strip()] = value.strip().replace("\\;", ";")
    return found


def same(value, wanted: str) -> bool:
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        try:
            return float(wanted) == float(value)
        except ValueError:
            return False
    return str(value) == wanted


class Missing(Failure):
    """A path that leads to nothing, or a point that does not exist."""


def points(study: dict, wanted: dict[str, str]) -> list[dict]:
    """The points selected, a list of values in their order. Raises Failure unless each is one."""
    whole = {point.get("method") for point in study.get("points", [])}  # "1,000 moved" is one
    lists = [key for key in wanted if "," in wanted[key] and key not in ("scene", "value", "format", "cell") and
             not (key == "method" and wanted[key] in whole)]
    if lists:
        return [point for value in wanted[lists[0]].split(",")
                for point in points(study, {**wanted, lists[0]: value.strip()})]
    knobs = {key: value for key, value in wanted.items() if key not in OWN}
    found = [point for point in study.get("points", study.get("rows", []))
             if all(same(point.get(key), wanted[key]) for key in ("scene", "method") if key in wanted) and
             all(same(point.get("knobs", {}).get(key, point.get(key)), value) for key, value in knobs.items())]
    if len(found) != 1:
        raise (Failure if found else Missing)(f"{len(found)} points are {'; '.join(f'{k}={v}' for k, v in wanted.items() if k in ('scene', 'method') or k in knobs)}")
    return found


def at_path(study, path: str):
    """What a path such as /scenes/dawn/ms leads to."""
    keys = path[1:].split("/")
    for i, key in enumerate(keys):
        rest = "".join("/" + one for one in keys[i + 1:])
        if key == "*":
            return statistics.mean(at_path(one, rest) if rest else one for one in study)
        if isinstance(study, list) and "+" in key:
            return sum(at_path(study, f"/{name}{rest}") for name in key.split("+"))
        try:
            if isinstance(study, list) and not key.isdigit():
                study = next(one for one in study if key in (one.get("name"), one.get("to")))
            else:
                study = study[int(key)] if isinstance(study, list) else study[key]
        except (KeyError, IndexError, TypeError, StopIteration):
            raise Missing(f"there is no {path}") from None
    return study


def value_of(study: dict, point: dict, name: str) -> float:
    """One number (or text) of a point, or of the whole file where its name begins with /."""
    name, between, other = ([*BETWEEN.split(name.strip(), 1), "", ""])[:3]
    if between:
        one = value_of(study, point, name)
        if other.startswith("/"):
            another = value_of(study, point, other)
        else:
            another = value_of(study, points(study, {"scene": point["scene"], "method": other})[0], name)
        return one / another if between == "over" else one - another
    if name.startswith("/"):
        return at_path(study, name)
    if name == "ms":
        return point["time_ms"]["median"]
    if name.startswith("ms."):
        passes = point["time_ms"].get("once", {}) | point["time_ms"]["per_pass"]
        if name.endswith("*"):
            return sum(ms for one, ms in passes.items() if one.startswith(name[3:-1]))
        return passes[name[3:]] if name[3:] in passes else sum(passes[part] for part in name[3:].split("+"))
    for place in (point.get("error", {}), point):
        if name in place:
            return place[name]["median"] if isinstance(place[name], dict) else place[name]
    raise Failure(f"a point has no '{name}'; there are {', '.join(sorted(point.get('error', {})))} and ms")


def shown(number: float, form: str = "") -> str:
    """A number as a lesson prints it. `.3s` is so many significant digits, without an exponent."""
    if match := re.fullmatch(r"\.(\d)s", form or ".3s"):
        rounded = Decimal(f"{number:.{int(match[1]) - 1}e}")
        return f"{rounded:f}"
    return format(round(number) if form.endswith("d") else number, form)


def cell(study: dict, wanted: dict[str, str]) -> tuple[str, float]:
    text = wanted.get("cell") or "{" + wanted.get("value", "flip_mean") + ":" + wanted.get("format", "") + "}"
    scale = float(wanted.get("scale", 1))
    first = []

    def fill(point: dict) -> str:
        def one(match: re.Match) -> str:
            value = value_of(study, point, match[1])
            if isinstance(value, str):
                return value
            number = scale * value
            first.append(number)
            return shown(number, match[2] or "")
        return PLACEHOLDER.sub(one, text)

    selects = [key for key in wanted if key not in OWN] + [key for key in ("scene", "method") if key in wanted]
    of_file = all(match[1].startswith("/") for match in PLACEHOLDER.finditer(text))
    try:
        texts = [fill(point) for point in (points(study, wanted) if selects and not of_file else [{}])]
    except Missing:
        if "missing" not in wanted:
            raise
        return wanted["missing"], 0.0
    if wanted.get("join") == "range":
        texts = sorted(set(texts), key=lambda one: float(one.strip("%")))
        return (texts[0] if len(texts) == 1 else f"{texts[0]} to {texts[-1]}"), first[0]
    if len(set(texts)) == 1:
        texts = texts[:1]
    if len(texts) > 1 and all(one.endswith("%") for one in texts):
        texts[:-1] = [one[:-1] for one in texts[:-1]]
    return " / ".join(texts), first[0]


def split_row(line: str) -> list[str]:
    return [part.strip() for part in re.split(r"(?<!\\)\|", line.strip().strip("|"))]


def table_rows(source: str, common: str, body: list[str], old: list[list[str]]) -> list[list[str]]:
    """The rows of a table as its source has them; `old` as they stand."""
    study, shared = load(source), selection(common)
    columns, rows = split_row(body[0]) if body else [], body[1:]
    if len(rows) != len(old):
        raise Failure(f"{len(rows)} rows are selected, the table has {len(old)}")
    new, numbers = [], {}
    for i, (line, before) in enumerate(zip(rows, old)):
        row = [before[0]]
        if len(before) != len(columns) + 1:
            raise Failure(f"{len(columns)} columns are selected, the row {before[0]} has {len(before) - 1}")
        for k, (column, was) in enumerate(zip(columns, before[1:])):
            wanted = {**shared, **(selection(column) if column != "-" else {}), **(selection(line) if line.strip() != "-" else {})}
            if "-" in (column, line.strip()) or k >= int(wanted.get("only", k + 1)):
                row.append(was)
                continue
            wanted = {key: re.sub(r"\$(\w+)", lambda named: wanted[named[1]], text) for key, text in wanted.items()}
            text, number = cell(load(wanted["file"]) if "file" in wanted else study, wanted)
            row.append(text)
            numbers[i, k] = number
        new.append(row)
    if shared.get("bold") == "least":
        for k in range(len(columns)):
            least = min((number for (_, column), number in numbers.items() if column == k), default=None)
            for i, row in enumerate(new):
                if numbers.get((i, k)) == least is not None:
                    head, space, rest = row[k + 1].partition(" ")
                    row[k + 1] = f"**{head}**{space}{rest}"
    return new


def fill(text: Path, lines: list[str], begin: re.Pattern, block_of, new_of, stale) -> tuple[list[str], list[str]]:
    """The faults of the blocks behind comments, and the lines with the blocks filled. block_of(match, i) says from where to where
    a block goes whose comment's first line is before line i, new_of(match, i, first, block) what it has to be, and stale(match,
    block, new) what is wrong with it."""
    wrong, out, i = [], [], 0
    while i < len(lines):
        match = begin.match(lines[i])
        out.append(lines[i])
        i += 1
        if not match:
            continue
        try:
            first, end = block_of(match, i)
            block = lines[first:end]
        except Failure as error:
            wrong.append(f"{text}:{i}: {error}")
            continue
        try:
            new = new_of(match, i, first, block)
        except (Failure, KeyError, TypeError, ValueError) as error:
            wrong.append(f"{text}:{i}: {match[1]}: {error}")
            new = block
        if new != block:
            wrong += [f"{text}:{i}: {words}; ./course docs --quote fills it" for words in stale(match, block, new)]
        out += [*lines[i:first], *new]
        i = end
    return wrong, out


def check_tables(lesson: Path, lines: list[str]) -> tuple[list[str], list[str]]:
    def table(match: re.Match, i: int) -> tuple[int, int]:
        after = next((k for k in range(i - 1, len(lines)) if lines[k].rstrip().endswith("-->")), len(lines)) + 1
        first = next((k for k in range(after, len(lines)) if lines[k].strip()), len(lines))
        end = next((k for k in range(first, len(lines)) if not lines[k].lstrip().startswith("|")), len(lines))
        if end - first < 3:
            raise Failure("no table follows")
        return first, end

    def rows(match: re.Match, i: int, first: int, block: list[str]) -> list[str]:
        settings = [line.replace("-->", "").strip() for line in lines[i:first]]
        indent = block[0][:len(block[0]) - len(block[0].lstrip())]
        old = [split_row(line) for line in block[2:]]
        new = table_rows(match[1], match[2].replace("-->", "").strip(), [line for line in settings if line], old)
        return block[:2] + [line if row == was else f"{indent}| {' | '.join(row)} |" for row, was, line in zip(new, old, block[2:])]

    def stale(match: re.Match, block: list[str], new: list[str]) -> list[str]:
        return [f"{match[1]} has {' | '.join(split_row(b))}, the table {' | '.join(split_row(a))}" for a, b in zip(block, new) if a != b]

    return fill(lesson, lines, TABLE, table, rows, stale)


def agrees(text: str, found: float, tolerance: str = "") -> bool:
    """Whether a number as it is printed is `found`: to its digits, or within a tolerance of so many percent."""
    number = text.replace(",", "").replace("−", "-")
    said = float(number)
    if tolerance:
        return abs(said - found) <= float(tolerance.strip("% ")) / 100 * abs(found) + 1e-12
    mantissa, _, exponent = number.lower().partition("e")
    digits = len(mantissa.partition(".")[2])
    return abs(said - found) <= 0.5001 * 10.0 ** (int(exponent or 0) - digits)


def figures(text: str) -> list[tuple[int, str, str, str]]:
    """(line, number, unit, source) of each number of a text that names its source."""
    return [(text.count("\n", 0, match.start()) + 1, match["number"], match["unit"].strip("* "), " ".join(match["source"].split()))
            for match in FIGURE.finditer(text)]


def printed(text: str, pattern: str) -> float | None:
    """The number that stands for {} in a line of the text; None where no line is like the pattern."""
    parts = [r"\s+".join(map(re.escape, part.split())) for part in pattern.split("{}")]
    match = re.search(rf"\s*{NUMBER}\s*".join(parts) if len(parts) == 2 else pattern, text)
    return float(match[1]) if match else None


def found_in(file: str, rest: str) -> tuple[float, dict[str, str]]:
    """What a source's file has, and the source's options. Raises Failure where it has nothing."""
    if not file.endswith(".json"):
        pattern, _, options = rest.partition(";")
        wanted, path = selection(options), ROOT / file
        found = printed(path.read_text(encoding="utf-8"), pattern.strip()) if path.is_file() else None
        if found is None:
            raise Missing(f"{file} has no such line")
    else:
        wanted, study = selection(rest), load(file)
        point = points(study, wanted)[0] if not wanted.get("value", "").startswith("/") else {}
        found = value_of(study, point, wanted.get("value", "flip_mean"))
    return float(wanted.get("scale", 1)) * found, wanted


def check_figures(lesson: Path) -> list[str]:
    wrong = []
    text = (ROOT / lesson).read_text(encoding="utf-8")
    for line, number, unit, source in figures(text):
        file, _, rest = source.partition("#")
        if file.startswith("build/"):
            continue
        try:
            found, wanted = found_in(file, rest)
        except (Failure, KeyError, TypeError, ValueError) as error:
            wrong.append(f"{lesson}:{line}: {source}: {error}")
            continue
        if not agrees(number, 100 * found if unit.startswith("%") else found, wanted.get("tolerance", "")):
            wrong.append(f"{lesson}:{line}: the text says {number}{unit}, {file} {found:.6g}")
    marked, begun = len(figures(text)), len(re.findall(r"<!-- figure: ", text))
    if marked != begun:
        wrong.append(f"{lesson}: {begun - marked} of {begun} comments '<!-- figure:' follow no number")
    return wrong


def without_sources(text: str, note=lambda files: "") -> str:
    """A lesson's text for a page: without these comments. A table's is replaced by the note on its files, if there is one."""
    def noted(match: re.Match) -> str:
        said = note(re.findall(r"[\w./-]+\.json", match[0]))
        return f"{match[1]}{said}\n\n" if said else ""
    text = re.sub(r"^([ \t]*)<!-- table: .*?-->[ \t]*\n", noted, text, flags=re.S | re.M)
    text = re.sub(r"^[ \t]*<!-- (?:/verdict|verdict: .*?) -->[ \t]*\n", "", text, flags=re.M)
    return re.sub(r"\s*<!-- claim: .*?-->|<!-- figure: .*?-->", "", text, flags=re.S)
