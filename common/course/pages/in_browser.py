"""Tables of checks for the pages: exercises that a browser can check, with their data.

A chapter's check program writes the probes of its exercises (check_NN_name --tables FOLDER): inputs, truths in double precision,
bounds and hints. From them come tables/NN.name.js: the GLSL around an answer, as OpenGL ES 3.00, which WebGL 2 takes, and the
table. An exercise has one if its check is probes alone and the reference compiles as ES; tables/list.json names them, and says
of each other one why it has none.
"""

import json
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from check.glsl_answer import Refused, includes_of, spliced, without_comments
from tree import BUILD, LIBRARIES, ROOT, Failure, chapters, exercises, relative, warn, write_atomically, shader_files

HEAD = "#version 300 es\nprecision highp float; precision highp int; precision highp sampler2D; precision highp sampler3D;\n"
SCALARS = {"float": "uintBitsToFloat({})", "int": "int({})", "uint": "{}", "bool": "({} != 0u)"}
WORDS = {"float": "floatBitsToUint({})", "int": "uint({})", "uint": "{}", "bool": "uint({})"}
# Whether an answer to these is right depends on how exact a device's functions are; ./course check has one device.
BY_DEVICE = {"05.hidden_share": "atan"}
MOST_OUTPUTS = 13  # with an undefined operation and its two operands: four targets, which all devices have


class Unfit(Exception):
    """Its text says why a browser cannot check an exercise."""


def made() -> dict[str, dict]:
    """The tables by exercise, from the check programs that are built; others are missing."""
    found = {}
    for chapter in chapters():
        program = BUILD / "tests" / f"check_{chapter}"
        if program.exists():
            found |= of_chapter(chapter, program)
    return found


def of_chapter(chapter: str, program: Path) -> dict[str, dict]:
    """The probes that the program wrote, again where it or a shader is newer."""
    folder = BUILD / "tables" / chapter
    done = folder / "undefined.json"
    sources = [program, *LIBRARIES, *shader_files()]
    if not done.exists() or done.stat().st_mtime < max(path.stat().st_mtime for path in sources if path.exists()):
        shutil.rmtree(folder, ignore_errors=True)
        said = subprocess.run([program, "--tables", folder], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        if said.returncode:
            warn(f"{relative(program)} wrote no tables, so pages do not check its exercises; ./course check {chapter[:2]} builds it")
            return {}
    return {path.stem: json.loads(path.read_text(encoding="utf-8")) for path in sorted(folder.glob("*.*.json"))}


def write(folder: Path) -> list[str]:
    """Writes FOLDER/NN.name.js for each exercise that a browser can check, undefined.js and list.json. Returns the ids."""
    found, fit, unfit = made(), [], {}
    for chapter in chapters():
        for exercise, path in exercises(chapter).items():
            try:
                if path.suffix != ".glsl":
                    raise Unfit("it is C++")
                if exercise in BY_DEVICE:
                    raise Unfit(f"its verdict depends on how exact a device's {BY_DEVICE[exercise]} is")
                if exercise not in found:
                    raise Unfit("its check compares no table of a function's results")
                script = table(exercise, path, found[exercise])
            except (Unfit, Refused) as why:
                unfit[exercise] = str(why)
                continue
            write_atomically(folder / f"{exercise}.js", f"Tables.take({json.dumps(script, separators=(',', ':'))});\n")
            fit.append(exercise)
    if fit:
        undefined = next((BUILD / "tables").glob("*/undefined.json")).read_text(encoding="utf-8")
        write_atomically(folder / "undefined.js", f"Tables.undefined = {undefined.strip()};\n")
    write_atomically(folder / "list.json", json.dumps({"in_the_page": fit, "elsewhere": unfit}, indent=1) + "\n")
    return fit


def table(exercise: str, path: Path, recorded: dict) -> dict:
    if recorded["others"]:
        raise Unfit("its check asks for more than a function's results")
    solution = path.parent.parent / "solution" / path.name
    text = bare(solution.read_text(encoding="utf-8"))
    probes = [ported(probe, relative(solution)) for probe in recorded["probes"]]
    for probe in probes:
        if said := refused(HEAD + probe["before"] + re.sub(r"^\s*#\s*include.*$", "", text, flags=re.M) + probe["after"] + probe["main"]):
            raise Unfit(f"OpenGL ES refuses it: {said}")
    starter = path.read_text(encoding="utf-8")
    includes = sorted({name for one in (starter, text) for name in includes_of(bare(one))})
    return {"exercise": exercise, "file": relative(path), "starter": starter, "hint": recorded["hint"], "includes": includes,
            "probes": probes}


def bare(text: str) -> str:
    return without_comments(spliced(text))


def ported(probe: dict, answer: str) -> dict:
    """A probe with the ES text before and after the answer, and of main(). Raises Unfit."""
    before, after = around(probe.pop("text"), answer)
    result, _, parameters = re.fullmatch(r"\s*(\w+)\s+(\w+)\s*\((.*)\)\s*", probe["signature"]).groups()
    parameters = [tuple(one.split()) for one in parameters.split(",") if one.strip()]
    structs = dict(re.findall(r"\bstruct\s+(\w+)\s*\{(.*?)\}", before + after, re.S))
    inputs = [(name, kind, leaves(kind, structs)) for kind, name in parameters]
    outputs = leaves(result, structs)
    if len(outputs) > MOST_OUTPUTS:
        raise Unfit(f"its result has {len(outputs)} numbers")
    whole = [is_whole(kind) for _, kind, words in inputs for _ in words]
    if len(whole) != len(probe["inputs"][0]) or len(outputs) != len(probe["truth"][0]):
        raise Unfit("a row of its table has another number of values than its function")
    return probe | {"before": before, "after": after, "whole": whole, "whole_result": is_whole(result), "outputs": len(outputs),
                    "parameters": [[name, len(words)] for name, _, words in inputs],
                    "main": main(probe["signature"], inputs, result, structs)}


def around(text: str, answer: str) -> tuple[str, str]:
    """The text before and after the answer's file, as ES: its includes come first."""
    parts = re.split(r'^#line \d+ "([^"]*)"\n', text, flags=re.M)
    defines = "".join(re.findall(r"^#define .*\n", parts[0], re.M))
    pieces = list(zip(parts[1::2], parts[2::2]))
    own = [i for i, (name, _) in enumerate(pieces) if name == answer]
    if not own:
        raise Unfit("its check does not include it")
    before = "".join(piece for name, piece in pieces[:own[-1]] if name != answer)
    return defines + squeezed(before), squeezed("".join(piece for _, piece in pieces[own[-1] + 1:]))


def squeezed(text: str) -> str:
    lines = [line.strip() for line in bare(text).splitlines()]
    return "".join(f"{line}\n" for line in lines if line and not line.startswith("#extension"))


def is_whole(kind: str) -> bool:
    """As common/check/probe.cpp: a struct's members are floats, or their bits."""
    return kind in ("int", "uint", "bool") or bool(re.fullmatch(r"[iu]vec[234]", kind))


def leaves(kind: str, structs: dict[str, str]) -> list[tuple[str, str]]:
    """The numbers of a type in order: (their type, how to reach one from a value). Raises Unfit."""
    if kind in SCALARS:
        return [(kind, "")]
    if vector := re.fullmatch(r"([iu]?)vec([234])", kind):
        scalar = {"": "float", "i": "int", "u": "uint"}[vector[1]]
        return [(scalar, f".{axis}") for axis in "xyzw"[:int(vector[2])]]
    if matrix := re.fullmatch(r"mat([234])", kind):
        count = int(matrix[1])
        return [("float", f"[{i}][{k}]") for i in range(count) for k in range(count)]
    if kind not in structs:
        raise Unfit(f"it has a {kind}")
    found = []
    for member in structs[kind].split(";"):
        words = re.fullmatch(r"\s*(\w+)\s+([\w\s,]+?)\s*", member)
        if member.strip() and not words:
            raise Unfit(f"a {kind} has a list")
        for name in re.findall(r"\w+", words[2]) if words else ():
            found += [(scalar, f".{name}{way}") for scalar, way in leaves(words[1], structs)]
    return found


def constructed(kind: str, structs: dict[str, str], words: list[str]) -> str:
    """A value of a type from its next words, which are taken."""
    if kind in SCALARS:
        return SCALARS[kind].format(words.pop(0))
    if kind not in structs:
        return f"{kind}({', '.join(constructed(scalar, structs, words) for scalar, _ in leaves(kind, structs))})"
    members = [(found[1], name) for member in structs[kind].split(";") if (found := re.fullmatch(r"\s*(\w+)\s+([\w\s,]+?)\s*", member))
               for name in re.findall(r"\w+", found[2])]
    return f"{kind}({', '.join(constructed(one, structs, words) for one, _ in members)})"


def main(signature: str, inputs: list, result: str, structs: dict[str, str]) -> str:
    """Calls the function once for each row: PROBE_TURNS times, with other results of undefined operations in each."""
    words = [f"probe_word(probe_at + {i})" for i in range(sum(len(one) for _, _, one in inputs))]
    stride = len(words)
    arguments = ", ".join(constructed(kind, structs, words) for _, kind, _ in inputs)
    name = re.match(r"\s*\w+\s+(\w+)", signature)[1]
    numbers = [WORDS[scalar].format(f"probe_value{way}") for scalar, way in leaves(result, structs)]
    plain = place(numbers)
    noted = place(["uint(undefined_what)", "floatBitsToUint(undefined_a)", "floatBitsToUint(undefined_b)", *numbers])
    return f"""
uniform highp usampler2D probe_rows;
#ifdef PROBE_TURNS
layout(location = 0) out uvec4 probe_out[{noted[0]}];
#else
layout(location = 0) out uvec4 probe_out[{plain[0]}];
#endif
uint probe_word(int at) {{ return texelFetch(probe_rows, ivec2(at & 1023, at >> 10), 0).r; }}
void main() {{
    int probe_row = int(gl_FragCoord.x) + 64 * int(gl_FragCoord.y);
#ifdef PROBE_TURNS
    float probe_results[PROBE_TURNS] = float[PROBE_TURNS](PROBE_RESULTS);
    undefined_result = probe_results[probe_row % PROBE_TURNS];
    probe_row /= PROBE_TURNS;
#endif
    int probe_at = {stride} * probe_row;
    {result} probe_value = {name}({arguments});
#ifdef PROBE_TURNS
    {noted[1]}
#else
    {plain[1]}
#endif
}}
"""


def place(numbers: list[str]) -> tuple[int, str]:
    """Number of targets for the numbers, and the code that writes them."""
    padded = numbers + ["0u"] * (-len(numbers) % 4)
    return len(padded) // 4, " ".join(f"probe_out[{i // 4}] = uvec4({', '.join(padded[i:i + 4])});" for i in range(0, len(padded), 4))


def refused(text: str) -> str:
    """The first thing that the reference compiler has against a fragment shader; empty where it takes it."""
    validator = shutil.which("glslangValidator")
    if not validator:
        raise Failure("there is no glslangValidator; the packages are in common/course/packages/build")
    with tempfile.NamedTemporaryFile("w", suffix=".frag", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        said = subprocess.run([validator, file.name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    lines = [line for line in said.stdout.splitlines() if line.startswith("ERROR:")]
    return lines[0].removeprefix("ERROR: ") if said.returncode and lines else said.stdout if said.returncode else ""
