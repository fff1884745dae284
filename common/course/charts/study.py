"""Measures what chapters teach and draws the charts: time against error.

chapters/NN_name/study.json lists the measurements (common/study/study.h); two of its keys are for this file:

    "scenes": ["build/study/grid.obj", ...],
    "generate": {"build/study/grid.obj": ["tests/01_obj/make_big_obj.py", "104"]}

A missing file under "generate" is made by `python3 SCRIPT ARGUMENTS... FILE`, once. Results go
to build/study, where an interrupted study waits for the next call, and are then copied to the folder of the charts as NN_name.DEVICE.json, .svg, .png and .md.
"""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

from build.build import build
from charts import study_shards, timings
from charts.measured import here
from charts.study_charts import chart_paths
from charts.study_file import SOFTWARE
from many import shards, slurm
from tree import (PYTHON, BUILD, ROOT, Failure, UsageError, chapter_program, chapters, find_chapter, relative, say, warn,
                  write_atomically)

ALONE = True
SHARDS_APART = True
HELP = """Measures the time and the error of every method of a chapter, and draws charts (SVG, PNG) and a table.

  ./course study                   every chapter that has a study
  ./course study 02                one chapter
  ./course study 02 --device H200 --out FOLDER
  ./course study 02 --size 480x270  pixels, instead of the study's own size
  ./course study 02 --errors       errors alone, which are the same on a busy machine; times stay as they were
  ./course study 14 --timings      the passes that a lesson quotes (chapters/NN_name/timings.json), into docs/studies/tables
  ./course study 02 --stretch      the stretch task: an exercise with the reference's error in less time; --stretch --help
  ./course study --shard 3/16 --out F    the scenes of part 3 of 16, into the folder F; --merge F makes the charts of all

The files are docs/studies/NN_name.DEVICE.json and .md, with the charts that a lesson shows as PNG; all charts are in
build/charts, as SVG and PNG, those after the first with their names before .svg and .png. An interrupted study continues where it stopped when it is started again. Times are meaningful only on a machine that
does nothing else; those of a software driver are labelled as the CPU's."""
# Parts of a device's name that do not identify it.
NOISE = {"nvidia", "geforce", "amd", "radeon", "intel", "graphics", "apple", "mesa"}


def add_arguments(parser):
    parser.add_argument("chapter", nargs="?", metavar="NN", help="number or name of the chapter")
    parser.add_argument("--device", help="part of a device's name: ./course run 01 --list devices")
    parser.add_argument("--size", metavar="WxH", help="size in pixels, such as 1920x1080, instead of the study's own")
    parser.add_argument("--rounds", type=int, metavar="N", help="how often each method is timed, instead of the study's own number")
    parser.add_argument("--errors", action="store_true", help="measure errors alone, and keep the times that are there")
    parser.add_argument("--timings", action="store_true", help="measure the passes of chapters/NN_name/timings.json instead")
    parser.add_argument("--out", type=Path, metavar="FOLDER",
                        help="folder for the JSON, the charts and the table (docs/studies)")
    shards.add_arguments(parser)
    slurm.add_arguments(parser)


def run(arguments, _rest) -> int:
    slurm.check_arguments(arguments)
    if arguments.rounds is not None and arguments.rounds < 1:
        raise UsageError(f"--rounds is {arguments.rounds}, expected 1 or more")
    studied = [name for name in chapters() if study_of(name)]
    if arguments.size and not re.fullmatch(r"[1-9]\d*x[1-9]\d*", arguments.size):
        raise UsageError(f"--size is '{arguments.size}', expected WIDTHxHEIGHT, such as 1920x1080")
    if arguments.timings:
        return measure_timings(arguments)
    named = [find_chapter(arguments.chapter)] if arguments.chapter else studied
    for chapter in named:
        if chapter not in studied:
            raise UsageError(f"chapter {chapter} has no study; there are {', '.join(studied) or 'none'}")
    if arguments.shard:
        return measure_shard(arguments, named)
    out = (arguments.out or ROOT / "docs" / "studies").absolute()
    shards.check_writable(out)
    if arguments.merge:
        return merge(arguments.merge, named, out)
    if arguments.slurm is not None:
        folder = slurm.run("study", arguments, sys.argv[1:], lambda: build(named))
        code = merge([folder], named, out)
        slurm.finished("study")
        return code
    build(named)
    for chapter in named:
        generate(study_of(chapter).get("generate", {}))
        if arguments.errors:
            arguments.rounds = 1
        measured = measure(chapter, arguments)
        draw(chapter, measured, out, arguments.errors)
    return 0


def measure_timings(arguments) -> int:
    timed = [name for name in chapters() if timings.request_of(name)]
    named = [find_chapter(arguments.chapter)] if arguments.chapter else timed
    for chapter in named:
        if chapter not in timed:
            raise UsageError(f"chapter {chapter} has no timings.json; there are {', '.join(timed) or 'none'}")
    out = (arguments.out or timings.FOLDER).absolute()
    shards.check_writable(out)
    build(sorted({program for chapter in named for program in timings.programs(chapter)}))
    timings.run(named, arguments.device, arguments.size, out, device_slug)
    return 0


def measure_shard(arguments, named: list[str]) -> int:
    shard, entries = arguments.shard, {}
    file = shards.file_of(arguments.out, "study", shard)
    mine = {chapter: labels for chapter in named if (labels := study_shards.taken(chapter, study_of(chapter), shard))}
    build(list(mine))
    for chapter, labels in mine.items():
        study = study_of(chapter)
        generate(study.get("generate", {}))
        part = study_shards.part_of(chapter, study, labels, shard)
        measured = measure(chapter, arguments, part, f".{shard.number}-of-{shard.of}")
        entries |= study_shards.entries(chapter, json.loads(measured.read_text(encoding="utf-8")))
    head = {"chapters": named, "size": arguments.size, "course": shards.course_version()}
    shards.write(file, "study", shard, head, entries)
    say(f"{relative(file)}: {len(entries)} of {sum(len(study_shards.labels(study_of(chapter))) for chapter in named)} scenes")
    return 0


def merge(paths: list[Path], named: list[str], out: Path) -> int:
    made = shards.merge(paths, "study")
    merged = {chapter: study for chapter in named if (study := study_shards.whole(chapter, study_of(chapter), made))}
    for chapter, study in merged.items():
        measured = BUILD / "study" / f"{chapter}.merged.json"
        write_atomically(measured, json.dumps(study, indent=1) + "\n")
        draw(chapter, measured, out)
    machines = sorted({entry["study"]["machine"] for entry in made.entries.values()})
    say(f"{len(made.entries)} scenes of {made.of} shards; all times of a chapter are of one machine: {'; '.join(machines)}")
    return 0


def study_of(chapter: str) -> dict:
    """Contents of the chapter's study.json; {} without one. Raises Failure for an unusable one."""
    return timings.request_of(chapter, "study.json")


class SceneEntry:
    """An entry of "scenes": a file, or {"scene": file, "set": {knob: value}, "label": "100 lights"}."""

    def __init__(self, entry: str | dict):
        entry = entry if isinstance(entry, dict) else {"scene": entry}
        self.file, self.set = entry["scene"], entry.get("set", {})
        self.label = entry.get("label") or Path(self.file).stem


def generate(files: dict):
    """Makes the files that a study reads and that are too large to keep."""
    for name, (script, *words) in files.items():
        file = ROOT / name
        if file.exists():
            continue
        warn(f"making {name}")
        file.parent.mkdir(parents=True, exist_ok=True)
        beside = file.with_name(f".{file.name}.{os.getpid()}")
        try:
            if subprocess.run([*PYTHON, ROOT / script, *words, beside], cwd=ROOT).returncode:
                raise Failure(f"{script} could not make {name}")
            os.replace(beside, file)
        finally:
            beside.unlink(missing_ok=True)


def measure(chapter: str, arguments, study: Path | None = None, part: str = "") -> Path:
    """Runs the study with its progress on the terminal, and returns the file of its result. `study`: replaces the
    chapter's own study.json, for a part called `part`."""
    device, size, rounds = arguments.device, arguments.size, arguments.rounds
    key = part + ("." + re.sub(r"[^a-z0-9]+", "_", device.lower()) if device else "")
    file = BUILD / "study" / f"{chapter}{key}.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    partial = file.with_name(file.name + ".partial")
    if partial.exists():
        warn(f"going on with the study of {chapter} that was interrupted")
    command = [chapter_program(chapter), "--study", file, *(["--device", device] if device else []),
               *(["--size", size] if size else []), *(["--study-rounds", str(rounds)] if rounds else []),
               *(["--study-file", study] if study else [])]
    code = None
    try:
        code = subprocess.run(command, cwd=ROOT, stdin=subprocess.DEVNULL).returncode
    except OSError as error:
        raise Failure(f"{relative(command[0])}: {error.strerror}") from None
    finally:
        if code not in (0, 2):
            warn(f"\nwhat was measured is kept: ./course study {chapter[:2]} goes on from there" if partial.exists()
                 else "\nnothing was finished that could be kept")
    if code:
        raise (UsageError("") if code == 2 else Failure(f"the study of {chapter} ended with {code}"))
    return file


def key_of(point: dict) -> str:
    return json.dumps([point["scene"], point["method"], point["knobs"]], sort_keys=True)


def errors_into(file: Path, study: dict) -> dict:
    """The study in `file` with the errors of another, and its own times. Points that it lacks have the other's times. Raises
    UsageError where their pictures have different sizes."""
    try:
        old = json.loads(file.read_text(encoding="utf-8"))
    except OSError:
        return study
    if old.get("size") != study.get("size"):
        width, height = old["size"]
        raise UsageError(f"{relative(file)} has the times of {width}x{height} pixels; add --size {width}x{height}")
    times = {key_of(point): point["time_ms"] for point in old["points"]}
    points = [point | {"time_ms": times.get(key_of(point), point["time_ms"])} for point in study["points"]]
    kept = {key: old[key] for key in ("device", "driver", "command", "measured") if key in old}
    return study | kept | {"points": points, "errors_measured": study["measured"]}


def device_slug(study: dict) -> str:
    """The device in a file's name: lavapipe, h200, rtx4090; for a loader the number of threads: cpu2."""
    if study.get("subject") == "loader":
        return "cpu" + (re.findall(r"\d+", study.get("stage", "")) or [""])[0]
    names = f"{study.get('device', '')} {study.get('driver', '')}".lower()
    if any(name in names for name in SOFTWARE):
        return "lavapipe" if "llvmpipe" in names or "lavapipe" in names else "software"
    words = re.findall(r"[a-z0-9]+", re.sub(r"\(.*?\)", " ", study.get("device", "").lower()))
    return "".join(word for word in words if word not in NOISE) or "device"


def draw(chapter: str, measured: Path, folder: Path, errors: bool = False):
    """Puts the result into the folder under the device's name, with the chart and the table beside it."""
    study = json.loads(measured.read_text(encoding="utf-8")) | {"measured": here(chapter)}
    file = folder / f"{chapter}.{device_slug(study)}.json"
    write_atomically(file, json.dumps(errors_into(file, study) if errors else study, indent=1, ensure_ascii=False) + "\n")
    if subprocess.run([*PYTHON, ROOT / "common/course", "charts.chart", file]).returncode:
        raise Failure(f"the chart of {chapter} was not drawn")
    beside = [path.with_name(path.name + ".svg") for path in chart_paths(study, file.with_suffix(""))]
    drawn = [path if path.exists() else BUILD / "charts" / path.name for path in beside]
    say("; ".join(relative(path) for path in (file, *drawn)))
