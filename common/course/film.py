"""Writes the course's film, whole or in shards that know nothing of each other, and joins them; prints benchmarks as a table."""

import json
import shutil
import subprocess
from pathlib import Path

from build.build import build
from many.shards import Shard, parse
from tree import ROOT, Failure, UsageError, chapter_program, find_chapter, say

HELP = """Writes the film of chapter 19.

  ./course film OUT.mp4 [options]               all of it
  ./course film OUT.mp4 --shard 3/16 [options]  the third of sixteen parts, into OUT.parts
  ./course film OUT.mp4 --merge                 joins the parts of OUT.parts, with the sound
  ./course film --table A.json B.json ...       benchmarks (chapter 19's --benchmark) as one table

The options are the chapter's: --size 1920x1080, --fps 60, --samples 8, --shutter 0.5, --codec av1. A shard that failed is made
again by the same command; one that is there already is left as it is."""

PASSES_OPTIONS = True


def add_arguments(parser):
    parser.add_argument("out", nargs="?", metavar="OUT.mp4")
    parser.add_argument("--shard", metavar="I/N")
    parser.add_argument("--merge", action="store_true")
    parser.add_argument("--table", nargs="+", metavar="FILE", default=[])


def run(arguments, rest) -> int:
    if arguments.table:
        say(table([json.loads(Path(name).read_text()) for name in arguments.table]))
        return 0
    if not arguments.out:
        raise UsageError("name the file that the film is written to; see ./course film --help")
    out = Path(arguments.out)
    parts = out.with_suffix(".parts")
    if arguments.merge:
        return merge(out, parts)
    build([find_chapter("19")])
    if not arguments.shard:
        return write(out, rest)
    mine = shard(arguments.shard)
    part = parts / f"{mine.number:04}_of_{mine.of:04}{out.suffix}"
    if part.exists():
        return 0
    parts.mkdir(parents=True, exist_ok=True)
    first, end = cut(frame_count(rest), mine.number, mine.of)
    return write(part, [*rest, "--frames_from", str(first), "--frames_to", str(end)])


def shard(text: str) -> Shard:
    try:
        return parse(text)
    except ValueError as error:
        raise UsageError(f"--shard: {error}") from None


def cut(frames: int, number: int, count: int) -> tuple[int, int]:
    """The frames of one part: parts differ by one frame at most, and together are all."""
    return frames * (number - 1) // count, frames * number // count


def frame_count(options: list[str]) -> int:
    film, fps = find_film(option(options, "scene", "films/ambiance.film")), float(option(options, "fps", "30"))
    return round(json.loads(film.read_text())["duration_s"] * fps)


def option(options: list[str], name: str, otherwise: str) -> str:
    for i, word in enumerate(options):
        if word == f"--{name}" and i + 1 < len(options):
            return options[i + 1]
        if word.startswith(f"--{name}="):
            return word.partition("=")[2]
    return otherwise


def find_film(name: str) -> Path:
    for path in (Path(name), ROOT / "assets" / name, ROOT / name):
        if path.exists():
            return path
    raise UsageError(f"there is no film {name}")


def write(out: Path, options: list[str]) -> int:
    return subprocess.run([chapter_program(find_chapter("19")), "--film", out, *options]).returncode


def merge(out: Path, parts: Path) -> int:
    """The parts' pictures as they are, and the film's sound in one piece."""
    found = sorted(parts.glob(f"*_of_*{out.suffix}"))
    counts = {path.stem.partition("_of_")[2] for path in found}
    if len(counts) != 1:
        raise UsageError(f"{parts} holds {'parts of different cuts' if counts else 'no parts'}")
    count = int(counts.pop())
    missing = [i for i in range(1, count + 1) if not (parts / f"{i:04}_of_{count:04}{out.suffix}").exists()]
    if missing:
        raise Failure(f"{parts}: {', '.join(f'{i}/{count}' for i in missing)} missing; ./course film {out} --shard {missing[0]}/{count}")
    unfinished = out.with_name(f"{out.stem}.part{out.suffix}")
    if out.suffix == ".raw":
        with open(unfinished, "wb") as whole:
            for path in found:
                with open(path, "rb") as part:
                    shutil.copyfileobj(part, whole)
    else:
        listed = parts / "list.txt"
        listed.write_text("".join(f"file '{path.name}'\n" for path in found))
        film = find_film("films/ambiance.film")
        music = json.loads(film.read_text()).get("music")
        sound = ["-i", film.parents[1] / music, "-map", "0:v", "-map", "1:a", "-c:a", "aac", "-b:a", "160k", "-shortest"] if music else []
        try:
            done = subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "concat", "-safe", "0", "-i", listed, *sound, "-c:v",
                                   "copy", "-movflags", "+faststart", unfinished])
        except FileNotFoundError:
            raise Failure("ffmpeg is not installed; it joins films (Debian's package ffmpeg)") from None
        if done.returncode:
            unfinished.unlink(missing_ok=True)
            raise Failure(f"ffmpeg failed, with code {done.returncode}")
    unfinished.replace(out)
    return 0


def table(systems: list[dict]) -> str:
    """One row for each scene: mean and 99th percentile of GPU milliseconds on each system, and what anti-aliasing adds."""
    heads = [f"{one['device']}, {one['size'][0]}×{one['size'][1]}" for one in systems]
    lines = ["| scene | " + " | ".join(f"{head}: mean | p99 | MLAA | processor" for head in heads) + " |",
             "|---|" + "---:|" * (4 * len(systems))]
    for scene in systems[0]["scenes"]:
        cells = []
        for one in systems:
            same = next((other for other in one["scenes"] if other["name"] == scene["name"]), None)
            if same is None:
                cells += ["", "", "", ""]
                continue
            off, on = same["antialiasing"]["none"], same["antialiasing"]["mlaa"]
            cells += [f"{on['mean_ms']:.2f}", f"{on['p99_ms']:.2f}", f"{on['mean_ms'] - off['mean_ms']:.2f}",
                      f"{on['processor_ms']:.2f}"]
        lines.append(f"| {scene['name']} | " + " | ".join(cells) + " |")
    return "\n".join(lines)
