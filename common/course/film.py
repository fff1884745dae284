"""Writes the course's film, whole or in shards that know nothing of each other, and joins them; prints benchmarks as a table."""

import hashlib
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from build.build import build
from many import shards, slurm
from many.shards import Shard
from pages.film_figures import cells_of
from tree import ROOT, Failure, UsageError, chapter_program, find_chapter, say, write_atomically

HELP = """Writes the film of chapter 19.

  ./course run 19 --film OUT.mp4 [options]               all of it
  ./course run 19 --film OUT.mp4 --shard 3/16 [options]  the third of sixteen parts, into the folder OUT.parts
  ./course run 19 --film OUT.mp4 --merge                 joins the parts of OUT.parts, with the sound
  ./course run 19 --film OUT.mp4 --slurm [options]       Slurm makes the parts, and they are joined; --slurm='--partition=short'
  ./course run 19 --table A.json B.json ...              benchmarks (--benchmark) as one table
  ./course run 19 --page PAGE.html A.json ...            the same as a page with charts

The options are the chapter's: --size 1920x1080, --fps 60, --samples 8, --shutter 0.5, --codec av1. A part that failed is made
again by the same command; one that is there already and whole is left as it is."""

PASSES_OPTIONS = True
KIND = "film"


def add_arguments(parser):
    parser.add_argument("chapter", metavar="19")
    parser.add_argument("--film", nargs="?", metavar="OUT.mp4", help="write the film")
    parser.add_argument("--shard", type=shards.argument, metavar="K/N", help="write part K of N")
    parser.add_argument("--merge", action="store_true", help="join the parts")
    parser.add_argument("--out", type=Path, metavar="FOLDER", help="folder of the parts (OUT.parts)")
    parser.add_argument("--table", nargs="+", metavar="FILE", default=[])
    parser.add_argument("--page", nargs="+", metavar="FILE", default=[])
    slurm.add_arguments(parser)


def run(arguments, rest) -> int:
    if find_chapter(arguments.chapter) != find_chapter("19"):
        raise UsageError("only chapter 19 writes a film: ./course run 19 --film OUT.mp4")
    if rest and (arguments.merge or arguments.table or arguments.page):
        raise UsageError(f"{rest[0]} belongs to drawing, and nothing is drawn: leave it out")
    if arguments.out and not arguments.shard and not arguments.merge and arguments.slurm is None:
        raise UsageError("--out is the folder of the parts: add --shard, --merge or --slurm")
    if arguments.table:
        say(table(read_systems(arguments.table)))
        return 0
    if arguments.page:
        return write_page(arguments.page)
    if not arguments.film:
        raise UsageError("name the file that the film is written to: ./course run 19 --film OUT.mp4")
    slurm.check_arguments(arguments)
    out = Path(arguments.film)
    if out.suffix not in (".mp4", ".mkv", ".raw"):
        raise UsageError(f"{out}: expected a name that ends with .mp4, .mkv or .raw")
    parts = arguments.out or out.with_suffix(".parts")
    if arguments.merge:
        return merge(out, shards.merge([parts], KIND))
    if arguments.slurm is not None:
        made = shards.merge([slurm.run(KIND, arguments, sys.argv[1:], lambda: build([find_chapter("19")]))], KIND)
        merge(out, made)
        slurm.finished(KIND)
        return 0
    build([find_chapter("19")])
    return write_shard(out, parts, arguments.shard, rest) if arguments.shard else write(out, rest)


def write_shard(out: Path, parts: Path, shard: Shard, options: list[str]) -> int:
    """The shard's frames as a film of their own, in a shard's file. The exit code."""
    film = find_film(option(options, "scene", "films/ambiance.film"))
    try:
        said = json.loads(film.read_text(encoding="utf-8"))
        frames = round(version(said, options)[0] * float(option(options, "fps", "30")))
        head = {"frames": frames, "ending": out.suffix, "music": said.get("music"), "gain_db": said.get("music_gain_db", 0),
                "music_from_s": version(said, options)[1], "options": options,
                "text": hashlib.sha256(film.read_bytes()).hexdigest()[:16], "course": shards.course_version()}
    except (OSError, ValueError, KeyError, TypeError, AttributeError, OverflowError) as error:
        raise UsageError(f"{film}: is no film, or --fps no number: {error}") from None
    if frames < 1:
        raise UsageError("with these options the film has no frame")
    file = shards.file_of(parts, KIND, shard)
    if file.exists():
        if shards.read(file, KIND)["head"] == head:
            return 0
        raise UsageError(f"{file} is of another film, other options or another version of the course: remove it")
    first, end = cut(frames, shard.number, shard.of)
    with tempfile.TemporaryDirectory(prefix=".film.", dir=existing(parts)) as folder:
        part = Path(folder, f"part{out.suffix}")
        if code := write(part, [*options, "--frames_from", str(first), "--frames_to", str(end)]):
            return code
        shards.write(file, KIND, shard, head, {str(shard.number): [first, end]}, {f"part{out.suffix}": part})
    return 0


def existing(folder: Path) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def cut(frames: int, number: int, count: int) -> tuple[int, int]:
    """The frames of one part: parts differ by one frame at most, and together are all."""
    return frames * (number - 1) // count, frames * number // count


def version(said: dict, options: list[str]) -> tuple[float, float]:
    """Of the film or of its cut that the options name: how long it is, and where its music begins. Seconds."""
    name = option(options, "cut", "whole")
    if name == "whole":
        return said["duration_s"], 0.0
    if name not in said.get("cuts", {}):
        raise UsageError(f"the film has no cut '{name}'")
    cut = said["cuts"][name]
    return sum(end - first for first, end in cut["parts"]), cut.get("music_from_s", 0.0)


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
    raise UsageError(f"there is no file {name}")


def write(out: Path, options: list[str]) -> int:
    return subprocess.run([chapter_program(find_chapter("19")), "--film", out, *options]).returncode


def merge(out: Path, made: shards.Merged) -> int:
    """The parts' pictures unchanged, and the film's sound in one piece. An existing file of this name stays until the film
    is complete, and the parts stay."""
    if made.head["ending"] != out.suffix:
        raise UsageError(f"{out}: the parts are {made.head['ending']} files; name the film so")
    try:
        with tempfile.TemporaryDirectory(prefix=".film.", dir=existing(out.absolute().parent)) as folder:
            parts = []
            for number in range(1, made.of + 1):
                parts.append(Path(folder, f"{number:04}{out.suffix}"))
                parts[-1].write_bytes(made.file(str(number), f"part{out.suffix}"))
            whole = Path(folder, out.name)
            join(parts, whole, made.head["music"], made.head.get("gain_db", 0), made.head.get("music_from_s", 0))
            whole.replace(out)
    except OSError as error:
        raise Failure(f"{out} is not joined, its parts are whole: {error.strerror or error}") from None
    return 0


def join(parts: list[Path], into: Path, music: str | None, gain_db: float = 0, music_from_s: float = 0):
    if into.suffix == ".raw":
        with open(into, "wb") as whole:
            for path in parts:
                with open(path, "rb") as part:
                    shutil.copyfileobj(part, whole)
        return
    listed = parts[0].with_name("list.txt")
    listed.write_text("".join(f"file '{path.name}'\n" for path in parts), encoding="utf-8")
    sound = ["-ss", f"{music_from_s:g}", "-i", find_film(music), "-map", "0:v", "-map", "1:a", "-af", f"volume={gain_db:g}dB,apad", "-c:a", "aac", "-b:a", "160k", "-shortest"] if music else []
    try:
        done = subprocess.run(["ffmpeg", "-v", "error", "-y", "-f", "concat", "-safe", "0", "-i", listed, *sound, "-c:v",
                               "copy", "-movflags", "+faststart", into], stderr=subprocess.PIPE, text=True, errors="replace")
    except FileNotFoundError:
        raise Failure("ffmpeg is not installed; it joins films (Debian's package ffmpeg)") from None
    if done.returncode:
        said = done.stderr.strip().splitlines()
        raise Failure(f"ffmpeg failed, with code {done.returncode}{': ' + said[-1] if said else ''}; the parts are whole")


def read_systems(names: list[str]) -> list[dict]:
    """Benchmarks, one of each system: where several files are of one, at one size, the last counts. Raises UsageError."""
    systems = {}
    for name in names:
        try:
            one = json.loads(Path(name).read_text(encoding="utf-8"))
            systems[one["device"], tuple(one["size"])] = one
            if not all("gpu_sum" in scene for scene in one["scenes"]):
                raise KeyError("scenes")
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise UsageError(f"{name}: is no benchmark: {error}") from None
    return list(systems.values())


def table(systems: list[dict]) -> str:
    """One row for each scene and system: played in order, the mean of its frames and the longest at its cut over that mean; the
    processor's time of a frame; and the GPU's sum over passes, warm, with the cost of anti-aliasing."""
    heads = [f"{one['device']}, {one['size'][0]}×{one['size'][1]}" for one in systems]
    lines = ["| scene | " + " | ".join(f"{head}: played | cut | processor | GPU sum | MLAA" for head in heads) + " |",
             "|---|" + "---:|" * (5 * len(systems))]
    for scene in systems[0]["scenes"]:
        lines.append(f"| {scene['name']} | " + " | ".join(cell for one in systems for cell in cells_of(one, scene["name"])) + " |")
    return "\n".join(lines)


def write_page(names: list[str]) -> int:
    if not names[0].endswith(".html") or len(names) < 2:
        raise UsageError("--page takes the page's name, which ends with .html, and benchmarks")
    from pages.film_page import page
    write_atomically(Path(names[0]), page(read_systems(names[1:])))
    return 0
