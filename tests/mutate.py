"""Breaks a chapter's shaders one line at a time and asks whether a test notices. By hand, not by ctest:

    python3 tests/mutate.py 02_lambert_phong [--count 40] [--file blinn_phong] [--all]

Every line of shaders/NN_name/*.{glsl,frag,vert} and shaders/NN_name/solution/*.glsl is changed in each of the ways in
`changes`: a sign, a constant, a comparison, a clamp left out, swapped operands, a statement deleted. --count takes that
many of them, evenly spread. The tree stays as it is: LIGHTWALK_OVERLAY puts the changed file in the place of the other.
A change is

    caught      a shot is over its limits, a check or a test of the chapter fails, or it does not draw at all
    survived    a picture or what a probe returned differs, and nothing failed
    equivalent  all pictures and probes are the same to the last bit
    invalid     it does not compile

where pictures are the chapter's shots and EXTRA, which try knobs that no shot sets. The exit code is 1 where one
survived. Mesa's lavapipe is bit for bit deterministic; with another driver equivalent changes may count as survivors.
"""
import argparse
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "common" / "course"), str(ROOT / "tests")]
from shots.golden import compare, exceeded, golden_path, limits_of  # noqa: E402
from mutations import changes  # noqa: E402
from tree import BUILD, Failure, find_chapter, say, shots, warn  # noqa: E402

EXTRA = {
    "01_obj": [["--scene", "scenes/family.json"]],
    "02_lambert_phong": [
        ["--samples", "3"], ["--samples", "2", "--diffuse", "wrapped", "--wrap", "0.8", "--wrap_power", "2.5"],
        ["--shininess", "3", "--method", "phong"], ["--shininess", "3", "--method", "gouraud"],
        ["--shininess", "700", "--method", "blinn_phong", "--ambient", "off"], ["--scene", "scenes/smart_car.json"]],
    "03_attenuation": [
        ["--falloff", "range_fade", "--fade_k", "0.3", "--lights", "60", "--method", "every_light"],
        ["--falloff", "inverse_square", "--threshold", "0.2", "--lights", "60", "--method", "tiled"],
        ["--scene", "scenes/field.json", "--lights", "1500", "--show", "light_count", "--slices", "9"],
        ["--scene", "scenes/cones.json", "--lights", "40", "--show", "light_count", "--method", "tiled"]],
    "04_surface_maps": [
        ["--method", "steep", "--steps", "5"], ["--method", "offset_limited"], ["--show", "swim", "--method", "flat"],
        ["--mesh", "displaced", "--scene", "scenes/lava.json", "--subdivide", "200"],
        ["--scene", "scenes/column.json", "--samples", "3", "--strength", "2"],
        ["--scene", "scenes/leather.json", "--normal_y", "down", "--filter", "renormalised"]],
}
TIMEOUT_S = 300


def mutants(chapter: str, only: str):
    """(file, line number, the change, the whole changed text)"""
    folder = ROOT / "shaders" / chapter
    for path in sorted(p for kind in ("*.glsl", "*.frag", "*.vert", "*.comp", "solution/*.glsl") for p in folder.glob(kind)):
        if only not in path.name:
            continue
        lines = path.read_text().splitlines()
        seen = set()
        for number, line in enumerate(lines):
            for what, changed in changes(line):
                if changed == line or (number, changed) in seen:
                    continue
                seen.add((number, changed))
                text = "\n".join([*lines[:number], changed, *lines[number + 1:]]) + "\n"
                yield path.relative_to(ROOT), number + 1, what, changed.strip(), text


class Bench:
    """Draws and tests the chapter with or without a change."""

    def __init__(self, chapter: str, folder: pathlib.Path, build: pathlib.Path = BUILD):
        self.chapter, self.folder, self.overlay, self.build = chapter, folder, folder / "overlay", build
        self.pictures = {shot["name"]: (["--shot", shot["name"]], shot) for shot in shots(chapter)}
        self.pictures |= {" ".join(words): ([*words, "--size", "480x270"], None) for words in EXTRA.get(chapter, [])}
        self.overlay.mkdir()
        self.right = {}
        for name in self.pictures:
            failed, picture = self.draw(name)
            if failed:
                raise Failure(f"without any change: {name}: {failed}")
            self.right[name] = (picture.read_bytes())
        for program, words in self.programs():
            failed, self.right[program] = self.test(program, words)
            if failed:
                raise Failure(f"without any change: {program}: {failed}")

    def programs(self):
        return (("check_" + self.chapter, ["--use", "solution", "--probe-log", self.folder / "probes"]), ("test_" + self.chapter, ["~*loaders*"]))

    def run(self, command):
        environment = os.environ | {"LIGHTWALK_BUILD": str(self.build), "LD_LIBRARY_PATH": str(self.build),
                                    "LIGHTWALK_ROOT": str(ROOT),
                                    "LIGHTWALK_OVERLAY": str(self.overlay), "LIGHTWALK_TIMEOUT_S": "20",
                                    "LIGHTWALK_CACHE": str(self.folder / "cache")}
        (self.folder / "probes").write_text("")
        return subprocess.run([str(word) for word in command], cwd=ROOT, capture_output=True, text=True,
                              errors="replace", stdin=subprocess.DEVNULL, timeout=TIMEOUT_S, env=environment)

    def draw(self, name):
        picture = self.folder / "picture.png"
        picture.unlink(missing_ok=True)
        done = self.run([self.build / "chapters" / self.chapter, *self.pictures[name][0], "--screenshot", picture])
        return ("" if done.returncode == 0 else done.stderr.strip()), picture

    def test(self, program, words):
        """(failures, the probes' results)"""
        done = self.run([self.build / "tests" / program, *words])
        said = [line for line in done.stdout.splitlines() if '"ok":false' in line or "FAILED" in line]
        failed = (said or [done.stderr.strip() or "failed"])[0] if done.returncode else ""
        return failed, (self.folder / "probes").read_text()

    def judge(self, file: pathlib.Path, text: str, everything: bool):
        """(verdict, its source) of a shader's change."""
        changed = self.overlay / file
        changed.parent.mkdir(parents=True, exist_ok=True)
        changed.write_text(text)
        try:
            return self.verdict(everything)
        finally:
            changed.unlink()

    def verdict(self, everything: bool = False):
        """(verdict, its source) of the current pictures and tests."""
        differs, caught = [], []
        for program, words in self.programs():
            failed, probes = self.test(program, words)
            if re.search(r"shaders/\S+:\d+: ", failed) and "check_" in program:
                return "invalid", failed
            if failed:
                caught.append(program)
            if probes != self.right[program]:
                differs.append("a probe of " + program)
            if caught and not everything:
                return "caught", caught[0]
        for name, (_, shot) in self.pictures.items():
            failed, picture = self.draw(name)
            if re.search(r"shaders/\S+:\d+: ", failed):
                return "invalid", failed.splitlines()[0]
            if failed:
                caught.append(name)
            elif picture.read_bytes() != self.right[name]:
                differs.append(name)
                if shot and exceeded(compare(golden_path(self.chapter, name), picture), limits_of(self.chapter, name)):
                    caught.append("shot " + name)
            if caught and not everything:
                return "caught", caught[0]
        for script in sorted((ROOT / "tests" / self.chapter).glob("test_*.py")) if differs or everything else []:
            if self.run([sys.executable, script]).returncode:
                caught.append(script.name)
        if caught:
            return "caught", ", ".join(caught)
        return ("survived", ", ".join(differs) + " differs") if differs else ("equivalent", "")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("chapter", help="02, or its name")
    parser.add_argument("--count", type=int, default=0, help="so many, evenly spread; default: all")
    parser.add_argument("--file", default="", help="only files with this in their name")
    parser.add_argument("--all", action="store_true", help="go on after the first test that catches a change")
    given = parser.parse_args()
    chapter = find_chapter(given.chapter)
    chosen = list(mutants(chapter, given.file))
    if 0 < given.count < len(chosen):
        chosen = [chosen[i * len(chosen) // given.count] for i in range(given.count)]
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(chapter, pathlib.Path(folder))
        for file, line, what, changed, text in chosen:
            try:
                verdict, by = bench.judge(file, text, given.all)
            except subprocess.TimeoutExpired:
                verdict, by = "caught", f"no end within {TIMEOUT_S} s"
            counts[verdict] += 1
            say(f"{verdict:10} {file.name}:{line:<3} {what:38} {by if verdict != 'survived' else changed + '   ' + by}")
    told = counts["caught"] + counts["survived"]
    say(f"{sum(counts.values())} changes: {counts['invalid']} do not compile, {counts['equivalent']} change nothing; "
        f"of the other {told}, {counts['caught']} caught ({100 * counts['caught'] / max(told, 1):.1f} %)")
    return 1 if counts["survived"] else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failure as failure:
        warn(f"mutate: {failure}")
        sys.exit(1)
