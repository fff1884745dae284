"""The gallery: draws the best picture of each chapter while the programs are being built, then all others if asked."""

import hashlib
import json
import os
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from build.build import alone, build
from build.programs import Programs
from commands import Parser
from many import shards, slurm
from progress import Progress
from shots.rendering import Drawing
from tree import (BUILD, ROOT, UsageError, best_first, chapter_program, chapters, display_words, has_display, relative,
                  say, warn, write_atomically)

SAMPLES = "4"  # of a picture
WORKERS = 2  # beside the compiler
REFRESH_S = 1.0  # between two versions of the page, at least


def gallery_in_shards(words: list[str]) -> int:
    parser = Parser(add_help=False, allow_abbrev=False)
    parser.see = "; see ./course run --help"
    shards.add_arguments(parser)
    slurm.add_arguments(parser)
    parser.add_argument("--out", type=Path)
    arguments, rest = parser.parse_known_args(words)
    if rest or not (arguments.shard or arguments.merge or arguments.slurm is not None):
        parser.error(f"unrecognised argument '{(rest or words)[0]}'")
    slurm.check_arguments(arguments)
    if arguments.slurm is not None:
        arguments.merge = [slurm.run("gallery", arguments, ["run", "--gallery", *words], lambda: build(["programs"]))]
        slurm.finished("gallery")
    if arguments.merge:
        with alone(BUILD, "gallery"):
            return merge_gallery(arguments.merge)
    file = shards.file_of(arguments.out, "gallery", arguments.shard)
    build(["programs"])
    return draw_gallery_shard(file, arguments.shard)


def gallery_pictures(best_only: bool = False) -> list[dict]:
    return [{"chapter": chapter, "name": shot["name"], "caption": shot.get("caption", ""),
             "image": f"{chapter}/{shot['name']}.png", "error": None,
             "command": f"./course run {chapter[:2]} --shot {shot['name']}"}
            for chapter in chapters() for shot in best_first(chapter)[:1 if best_only else None]]


def draw_gallery_shard(file: Path, shard: shards.Shard) -> int:
    """Draws the pictures that belong to a shard and writes it. Exit code 1 where one failed."""
    pictures = gallery_pictures()
    mine = [picture for picture in pictures if shard.takes(picture["image"])]
    with tempfile.TemporaryDirectory(prefix="lightwalk.gallery.") as made:
        Drawer(Path(made), mine).draw_all()
        drawn = {picture["image"]: Path(made, picture["image"]).read_bytes() for picture in mine if not picture["error"]}
        entries = {picture["image"]: {"error": picture["error"], "sha256": hashlib.sha256(drawn.get(picture["image"], b"")).hexdigest()}
                   for picture in mine}
        head = {"pictures": [picture["image"] for picture in pictures], "course": shards.course_version()}
        shards.write(file, "gallery", shard, head, entries, drawn)
    say(f"{relative(file)}: {len(drawn)} of {len(pictures)} pictures")
    return say_failed(mine)


def merge_gallery(paths: list[Path]) -> int:
    """Writes the page of the pictures that all shards drew. Exit code 1 where one failed."""
    made, folder, pictures = shards.merge(paths, "gallery"), BUILD / "gallery", gallery_pictures()
    if made.head["pictures"] != [picture["image"] for picture in pictures]:
        raise UsageError("the shards are of a course with other pictures: make them again")
    for picture in pictures:
        picture["error"] = made.entries[picture["image"]]["error"]
        if not picture["error"]:
            write_atomically(folder / picture["image"], made.file(picture["image"], picture["image"]))
    return finish_gallery(pictures, folder)


def draw_gallery(best_only: bool) -> int:
    """Builds the programs and draws every picture, or each chapter's best one, unless an equal one is there. Exit code 1 where
    one failed."""
    folder, pictures = BUILD / "gallery", gallery_pictures(best_only)
    build([chapters()[0]])  # and with it the shared library
    known, start_s = read_drawn(folder), time.monotonic()
    drawer = Drawer(folder, pictures, known)
    stale = drawer.draw_all(Programs(drawer.page_changed))
    if stale:
        warn(f"drew {stale} pictures in {time.monotonic() - start_s:.1f} s")
    failed = finish_gallery(pictures, folder, best_only)
    if best_only:
        say(f"./course run --gallery draws all {len(gallery_pictures())}")
    return failed


def finish_gallery(pictures: list[dict], folder: Path, best_only: bool = False) -> int:
    from pages.gallery import write_gallery  # here: a chapter starts without jinja2, too

    # With nothing to draw, too: lessons may have got pages.
    write_gallery(pictures, folder / "index.html", all_of_them=len(gallery_pictures()) if best_only else 0)
    failed = say_failed(pictures)
    if not has_display():
        warn(display_words() or "every chapter's pictures are drawn")
    say(f"{relative(folder / 'index.html')}: {sum(not picture['error'] for picture in pictures)} pictures")
    return failed


def say_failed(pictures: list[dict]) -> int:
    failed = [picture for picture in pictures if picture["error"]]
    for picture in failed:
        warn(f"{picture['chapter']}.{picture['name']}: {picture['error']}")
    return 1 if failed else 0


class Drawer:
    """Draws pictures into a folder, a chapter's by one process, since starting one takes longer than a picture: each chapter's best
    as soon as its program stands, then the others. `known`: the key by which each was drawn before; without it all are drawn."""

    def __init__(self, folder: Path, pictures: list[dict], known: dict | None = None):
        self.folder, self.pictures, self.known = folder, pictures, known
        self.lock, self.done, self.total = threading.Lock(), 0, 0
        self.programs, self.keys, self.written_s, self.stopping = None, {}, 0.0, False
        self.drawings: list[Drawing] = []
        self.progress = Progress("drawing")

    def draw_all(self, programs: Programs | None = None) -> int:
        self.programs, waiting = programs, list(dict.fromkeys(picture["chapter"] for picture in self.pictures))
        later, is_building = [], programs is not None
        with self.progress, ThreadPoolExecutor(WORKERS) as pool:
            try:
                if programs:
                    programs.start()
                while waiting:
                    is_building = programs is not None and programs.thread.is_alive()  # asked first: what is ready then is all there will be
                    for chapter in [chapter for chapter in waiting if not programs or chapter in programs.ready()]:
                        waiting.remove(chapter)
                        stale = self.stale(chapter)
                        pool.submit(self.draw, chapter, stale[:1])
                        later.append((chapter, stale[1:]))
                    if not is_building:
                        break
                    time.sleep(0.05)
                for done in [pool.submit(self.draw, *task) for task in later]:
                    done.result()
            except BaseException:
                self.stopping = True
                for drawing in list(self.drawings):
                    if drawing.program:  # None: it could not be started
                        drawing.program.kill()
                pool.shutdown(wait=False, cancel_futures=True)
                raise
            finally:
                if programs:
                    programs.stop()
        if programs:
            self.note_unbuilt()
        return self.total

    def stale(self, chapter: str) -> list[dict]:
        self.keys[chapter] = key_of(chapter)
        found = [picture for picture in self.pictures if picture["chapter"] == chapter and (
            self.known is None or self.known.get(picture["image"]) != self.keys[chapter] or not (self.folder / picture["image"]).exists())]
        with self.lock:
            self.total += len(found)
        return found

    def draw(self, chapter: str, pictures: list[dict]):
        if not pictures:
            return
        with Drawing(chapter, validate="off") as drawing:
            self.drawings.append(drawing)
            for picture in pictures:
                try:
                    picture["error"] = self.draw_one(drawing, picture)
                except Exception as error:  # a thread's own would be lost
                    picture["error"] = str(error)
                if self.stopping:
                    return
                with self.lock:
                    self.done += 1
                    self.progress.show(self.done, self.total, f"{chapter}.{picture['name']}")
                    if self.known is not None and not picture["error"]:
                        self.known[picture["image"]] = self.keys[chapter]
                self.page_changed(picture)
            self.drawings.remove(drawing)

    def draw_one(self, drawing: Drawing, picture: dict) -> str | None:
        file = self.folder / picture["image"]
        beside = file.with_name(f".{file.name}.{threading.get_ident():x}.png")
        beside.parent.mkdir(parents=True, exist_ok=True)
        code, words, _ = drawing.draw(["--shot", picture["name"], "--samples", SAMPLES], beside)
        if self.stopping or code or not beside.exists():
            beside.unlink(missing_ok=True)
            return f"{picture['chapter']} ended with {code}: {words}"
        os.replace(beside, file)
        return None

    def page_changed(self, picture: dict | None = None):
        """Writes the page of the available pictures, initially after the first one."""
        with self.lock:
            if not self.programs or (not picture and not self.written_s) or time.monotonic() < self.written_s + REFRESH_S:
                return
            from pages.gallery import write_gallery

            if not self.written_s:
                say(f"{relative(self.folder / 'index.html')}: the first picture; the page grows while the others are drawn")
            self.written_s = time.monotonic()
            write_gallery(self.pictures, self.folder / "index.html", self.programs.states)
            write_atomically(self.folder / "drawn.json", json.dumps(self.known))

    def note_unbuilt(self):
        for picture in self.pictures:
            if self.programs.states[picture["chapter"]].name != "ready":
                picture["error"] = "its chapter does not compile"
        failed = {picture["image"] for picture in self.pictures if picture["error"]}
        write_atomically(self.folder / "drawn.json",
                         json.dumps({image: key for image, key in self.known.items() if image not in failed}))


def read_drawn(folder: Path) -> dict:
    """Sources of each picture, as noted when it was drawn."""
    try:
        return json.loads((folder / "drawn.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def key_of(chapter: str) -> str:
    """A hash of everything that affects a chapter's pictures: program, shots, shaders, assets, driver."""
    paths = [chapter_program(chapter), ROOT / "tests" / chapter / "shots.json"]
    for folder in ("shaders", "assets"):
        paths += sorted(path for path in (ROOT / folder).rglob("*") if path.is_file())
    stats = [(str(path), path.stat().st_size, path.stat().st_mtime_ns) for path in paths if path.exists()]
    driver = sorted((name, value) for name, value in os.environ.items() if name.startswith(("VK_", "LIGHTWALK_")))
    return hashlib.sha256(repr((stats, driver)).encode()).hexdigest()
