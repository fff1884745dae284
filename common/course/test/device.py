"""All shots and all checks on one device, with a page and a file of figures."""

import datetime
import functools
import json
from pathlib import Path

from build.build import build
from many.shards import check_writable
from pages.page import page as filled
from pages.report import Pictures  # and the filters of report_parts.html
from progress import Progress
from shots.draw_shots import right_picture
from shots.golden import distance_of, exceeded, golden_path, hardware_limits, limits_of, unfit
from shots.rendering import last_words, render_many, run_program
from test.results import check_rows
from test.shots import compared, picture_entry
from tree import (BUILD, Failure, UsageError, chapter_program, exercises, find_shots, git, has_solutions, relative, say,
                  write_atomically)

ALONE = True
HELP = """Draws all shots on one device, compares each with its golden, and runs all checks there: each reference must pass its
check, and each starter must fail. Writes build/report/device.html (expected, this device, difference; the farthest picture
first) and a file of figures.

  ./course test --device hardware           the first graphics card
  ./course test --device "RTX 4070"         the device whose name contains these words; ./course doctor lists devices
  ./course test --device hardware 04        the shots and checks of chapter 04; 04.relief is one shot
  ./course test --device hardware --against FILE    compare with an earlier run of the same device: the shots that moved

A hardware device may differ from a golden by a FLIP mean of 0.01 and a 99th percentile of 0.06, and at most one pixel in a
thousand by more than 32 steps of 1/255. A shot that needs more has an entry in tests/NN_name/golden/distances.json with the
device's name and the cause. A software device has the limits of ./course test.

Exit code 1 where a shot is outside its limits or a check is wrong, 2 where there is no such device, or FILE belongs to another."""
KIND = "shots and checks of a device"
FIGURES = ("flip_mean", "flip_p99", "step_p999", "max_diff")
LISTED = 20  # lines of a summary
EXACT = 20  # pictures outside limits that the page has losslessly, 1.5 MB each with the golden and the difference


def add_arguments(parser):
    parser.add_argument("--device", nargs="?", const="hardware", required=True, metavar="NAME",
                        help="a part of the device's name; the first graphics card by default")
    parser.add_argument("shots", nargs="?", default="", metavar="NN[.SHOT]", help="one chapter or one shot (all)")
    parser.add_argument("--against", type=Path, metavar="FILE", help="an earlier run's file of figures")
    parser.add_argument("--out", type=Path, metavar="FILE", default=BUILD / "report" / "device.json",
                        help="the file of figures (build/report/device.json)")


def run(arguments, _rest, make=build) -> int:
    """Builds with make(targets), draws, checks, writes and prints. The exit code."""
    if not has_solutions():
        raise UsageError("a handout has no references to draw with; --device needs the whole course")
    found = find_shots(arguments.shots)
    earlier = read_run(arguments.against) if arguments.against else None
    check_writable(arguments.out.absolute().parent)
    drawn = sorted({chapter for chapter, _ in found})
    checked = [] if "." in arguments.shots else [chapter for chapter in drawn if exercises(chapter)]
    make(drawn[:1])  # which names the devices before all others are built
    device = find_device(drawn[0], arguments.device)
    if earlier and earlier["device"] != device["name"]:
        raise UsageError(f"--against {relative(arguments.against)} is a run of {earlier['device']}, not of {device['name']}")
    make([*drawn, *(f"check_{chapter}" for chapter in checked), "compare"])
    results = shot_results(device, found)
    checks = check_results(device, checked)
    made = {"kind": KIND, "device": device["name"], "type": device["type"], "driver": device["driver"], **origin(),
            "within": sum(result["ok"] for result in results), "of": len(results), "checks": checks,
            "shots": {result["id"]: entry(result) for result in results}}
    write_atomically(arguments.out, json.dumps(made, indent=1) + "\n")
    lines = summary(made) + (moved(made, earlier, arguments.against) if earlier else [])
    page = BUILD / "report" / "device.html"
    write_atomically(page, filled("device.html", made=made, results=results, lines=lines, exact=EXACT, pictures=Pictures()))
    for line in lines:
        say(line)
    say(f"report: {relative(page)}; figures: {relative(arguments.out)}")
    return 1 if made["within"] < made["of"] or checks["wrong"] else 0


def find_device(chapter: str, wanted: str) -> dict:
    """The device that the programs choose for --device: its name, type and driver. 'hardware' is the first that is no software."""
    done = run_program([chapter_program(chapter), "--list", "devices", "--json"])
    if done.returncode:
        raise UsageError(last_words(done.stderr, done.stdout).removeprefix("error: "))
    there = json.loads(done.stdout)
    for device in there:
        named = wanted.lower() in device["name"].lower() or wanted.lower() == device["type"]
        if not device["lacks"] and (named or wanted == "hardware" and device["type"] != "software"):
            return device
    known = ", ".join(f"{device['name']} ({device['type']}{', lacks ' * bool(device['lacks'])}{device['lacks']})" for device in there)
    raise UsageError(f"--device {wanted}: no usable device of that name; there are: {known}")


def shot_results(device: dict, found: list) -> list[dict]:
    """Each shot's result, the farthest from its golden first. One process draws a chapter."""
    results = []
    with Progress("drawing") as progress:
        for chapter in sorted({chapter for chapter, _ in found}):
            # Grouped by scene, which is then read once.
            shots = sorted((shot for its, shot in found if its == chapter), key=lambda shot: shot.get("scene", ""))
            progress.show(len(results), len(found), chapter)
            wanted = [(right_picture(chapter, shot)[2], BUILD / "device" / chapter / f"{shot['name']}.png") for shot in shots]
            failures = render_many(chapter, wanted, device["name"])
            results += [judge(device, chapter, shot, picture, failure)
                        for shot, (_, picture), failure in zip(shots, wanted, failures)]
    return sorted(results, key=lambda result: -result["distance"])


def judge(device: dict, chapter: str, shot: dict, picture: Path, failure: str) -> dict:
    """A shot's result as shots.py describes it, with its distance and the causes of wider limits."""
    name, golden = shot["name"], golden_path(chapter, shot["name"])
    limits, causes = (limits_of(chapter, name), []) if device["type"] == "software" else hardware_limits(chapter, name, device["name"])
    metrics = None
    try:
        if failure or not golden.exists():
            raise Failure(failure or f"there is no {relative(golden)}")
        metrics = compared(golden, picture, lambda metrics: metrics["max_diff"]["steps"] == 0)
        metrics["step_p999"] = common_step(golden, picture)
        why = unfit(metrics) + exceeded(metrics, limits)
    except Failure as error:
        why = [str(error)]
    return {"kind": "device", "chapter": chapter, "name": name, "id": f"{chapter[:2]}.{name}", "caption": shot.get("caption", ""),
            "ok": not why, "why": why, "causes": causes, "limits": limits, "distance": metrics["flip"]["mean"] if metrics else 1.0,
            "again": f"./course run {chapter[:2]} --shot {name} --device '{device['name']}'",
            "picture": picture_entry(name, not why, golden, picture, metrics)}


def common_step(expected: Path, actual: Path) -> int:
    """The largest step of any channel that more than a thousandth of the pixels reach: the 99.9th percentile."""
    from PIL import Image, ImageChops  # here: help needs no package

    with Image.open(expected) as a, Image.open(actual) as b:
        channels = ImageChops.difference(a.convert("RGB"), b.convert("RGB")).split()
    counts = functools.reduce(ImageChops.lighter, channels).histogram()
    left = 0.001 * sum(counts)
    for step in range(255, 0, -1):
        left -= counts[step]
        if left < 0:
            return step
    return 0


def check_results(device: dict, named: list[str]) -> dict:
    """How many exercises have a reference that passes and a starter that fails on the device, and what is wrong elsewhere."""
    known, wrong = {exercise for chapter in named for exercise in exercises(chapter)}, {}
    with Progress("checking") as progress:
        for number, chapter in enumerate(named):
            progress.show(number, len(named), chapter)
            try:
                rows = check_rows(chapter, LIGHTWALK_DEVICE=device["name"])
            except Failure as error:
                rows = [{"case": exercise, "ok": False, "text": str(error)} for exercise in exercises(chapter)]
            for row in rows:
                if not row["ok"]:
                    wrong.setdefault(row["case"], []).append(row["text"])
    return {"right": len(known - set(wrong)), "of": len(known), "wrong": [f"{case}: {', '.join(said)}" for case, said in wrong.items()]}


def origin() -> dict:
    try:
        commit = git("describe", "--always", "--dirty", "--exclude", "*").decode().strip()
    except Failure:
        commit = None
    return {"date": datetime.date.today().isoformat(), "commit": commit}


def entry(result: dict) -> dict:
    metrics = result["picture"]["metrics"]
    figures = {key: round(value, 6) for key, value in distance_of(metrics).items()} if metrics else {}
    return {"ok": result["ok"], **figures} | ({"why": result["why"]} if result["why"] else {})


def summary(made: dict) -> list[str]:
    checks, outside = made["checks"], {name: shot for name, shot in made["shots"].items() if not shot["ok"]}
    lines = [f"{made['device']}, {made['driver']}: {made['within']} of {made['of']} shots within limits"]
    lines += first_of([f"  {name}: {'; '.join(shot['why'])}" for name, shot in outside.items()])
    if not outside:
        name, shot = next(iter(made["shots"].items()))
        lines.append(f"  farthest: {name}, {figures_words(shot)}")
    if checks["of"]:
        lines.append(f"checks: {checks['right']} of {checks['of']} exercises: the reference passes, the starter fails")
        lines += first_of([f"  {line}" for line in checks["wrong"]])
    return lines


def figures_words(shot: dict) -> str:
    if "flip_mean" not in shot:
        return "no picture"
    return f"FLIP mean {shot['flip_mean']:.4f}, p99 {shot['flip_p99']:.4f}, step of one pixel in a thousand {shot['step_p999']}"


def first_of(lines: list[str]) -> list[str]:
    more = len(lines) - LISTED
    return lines if more <= 0 else [*lines[:LISTED], f"  and {more} more"]


def read_run(path: Path) -> dict:
    try:
        made = json.loads(path.read_text(encoding="utf-8"))
        if made["kind"] == KIND and all(figures_words(shot) and shot["ok"] in (True, False) for shot in made["shots"].values()):
            return made | {key: str(made[key]) for key in ("device", "driver", "date")}
        raise ValueError("it is of another kind")
    except OSError as error:
        raise UsageError(f"--against {relative(path)}: {error.strerror}") from None
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise UsageError(f"--against {relative(path)} is not a file of figures of ./course test --device: {error!r}") from None


def moved(made: dict, earlier: dict, path: Path) -> list[str]:
    """Lines that say which shots have other figures than in the earlier run, the largest change first."""
    now, then = made["shots"], earlier["shots"]
    both = [name for name in now if name in then]
    changed = sorted((name for name in both if key_figures(now[name]) != key_figures(then[name])),
                     key=lambda name: -abs(now[name].get("flip_mean", 1) - then[name].get("flip_mean", 1)))
    lines = [f"against {relative(path)} ({earlier['driver']}, {earlier['date']}, commit {earlier.get('commit')}): "
             f"{len(changed)} of {len(both)} shots moved"]
    for name in changed:
        crossed = {(True, False): "; now outside", (False, True): "; now within"}.get((then[name]["ok"], now[name]["ok"]), "")
        lines.append(f"  {name}: {figures_words(then[name])} -> {figures_words(now[name])}{crossed}")
    new = [name for name in now if name not in then]
    return [lines[0], *first_of(lines[1:]), *([f"  not in that run: {', '.join(new)}"] if new else [])]


def key_figures(shot: dict) -> tuple:
    return shot["ok"], *(shot.get(key) for key in FIGURES)
