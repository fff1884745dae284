"""The pages as a site for any static host: ./course docs --site FOLDER.

To the output of ./course docs it adds: small pictures, loaded as they come into view; a start page with a short film; a service
worker, which keeps the site for reading without a network; a policy that lets a page load nothing from elsewhere."""

import functools
import hashlib
import json
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from urllib.parse import unquote

from build.build import build
from many.shards import check_writable
from pages import docs, drawn_pictures, states
from pages.page import POLICY, encoded
from tree import Failure, UsageError, chapters, say, warn, write_atomically

OWN = Path(__file__).parent / "site" / "run"
CHAPTER = "19_ambiance"  # which draws the film
MARK = ".lightwalk-site"  # in a folder that this command may replace
WIDEST = 800
MOST_BYTES = 60_000_000
FILM = "assets/films/ambiance.film"
# The film's seconds that the start page shows: valley, sea, chronosphere, harbour, Julia set, Saturn, head, car, knot, courtyard, clouds.
BEST_S = [[48.5, 50], [57, 58.2], [70, 71.2], [124, 125.2], [90, 91.2], [26, 27.2], [109, 110], [153, 154.2], [141, 142],
          [205, 206.2], [42, 43]]
DRAWN_AS = ["--cut", "short", "--size", "640x360", "--fps", "24", "--samples", "1", "--codec", "h264"]
INDENTED = re.compile(r"(<(pre|textarea|script|style)\b.*?</\2>)|\n\s+", re.S)
ENCODED_AS = ["-an", "-c:v", "libx264", "-preset", "veryslow", "-crf", "31", "-pix_fmt", "yuv420p", "-movflags", "+faststart"]


def write(folder: Path, film: bool = True) -> int:
    """Builds the pages' programs and writes the site. Raises UsageError for a folder with other files in it."""
    if folder.exists() and not (folder.is_dir() and ((folder / MARK).exists() or not any(folder.iterdir()))):
        raise UsageError(f"--site {folder}: it has other files in it; name a folder that is empty, or that does not exist")
    if not folder.parent.is_dir():
        raise UsageError(f"--site {folder}: there is no folder {folder.parent}")
    if (folder / ".git").exists() or folder.is_mount():
        raise UsageError(f"--site {folder}: it is {'a repository' if (folder / '.git').exists() else 'a mounted disc'}, and would be replaced whole; "
                         "name a folder of the site's own")
    check_writable(Path(os.path.realpath(folder)).parent)
    build(["programs", *(f"check_{chapter}" for chapter in chapters())])
    clip = start_film() if film else None
    return docs.make(folder, lambda made: finish(made, clip, chapters()))


def start_film() -> Path | None:
    """The start page's film, kept until its sources change. None where it cannot be made, which is said."""
    build([CHAPTER])
    cut = json.dumps(best_of(json.loads((docs.ROOT / FILM).read_text(encoding="utf-8"))))
    key = hashlib.sha256(repr((drawn_pictures.version(CHAPTER), cut, DRAWN_AS, ENCODED_AS)).encode()).hexdigest()[:16]
    out = drawn_pictures.KEPT / f"start.{key}.mp4"
    if out.exists():
        return out
    if not shutil.which("ffmpeg"):
        warn("the start page shows a picture: its film needs ffmpeg, the package in common/course/packages/film")
        return None
    warn("drawing the start page's film, which is kept; --no-film shows a picture instead")
    out.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=out.parent) as folder:
        film, drawn, made = (Path(folder, name) for name in ("start.film", "drawn.mp4", "made.mp4"))
        film.write_text(cut, encoding="utf-8")
        # The film's own command, as a person would type it: it knows the codecs.
        for command in (["./course", "run", "19", "--film", drawn, "--scene", film, *DRAWN_AS], ["ffmpeg", "-v", "error", "-i", drawn, *ENCODED_AS, made]):
            if subprocess.run(command, cwd=docs.ROOT, stdout=subprocess.DEVNULL).returncode:
                raise Failure(f"the start page's film could not be written: {command[0]} failed; --no-film leaves it out")
        made.replace(out)
    return out


def best_of(film: dict) -> dict:
    """The film, cut to its best seconds, without titles and sound."""
    return {key: value for key, value in film.items() if not key.startswith("music")} | {"titles": [], "cuts": {"short": {"parts": BEST_S}}}


def finish(made: Path, clip: Path | None, drawn: list[str]):
    """Makes the pages, written to a folder, into the site; the pictures of these chapters are drawn for it."""
    states.offer(made, drawn)
    smaller_fonts(made)
    for chart in made.rglob("*.svg"):
        chart.write_text(short(chart.read_text(encoding="utf-8")), encoding="utf-8")
    smaller = {path: small(path) for path in sorted(made.rglob("*")) if path.suffix in (".png", ".jpg") and "assets/images" not in str(path)}
    for path in made.rglob("*.html"):
        up = "../" * (len(path.relative_to(made).parts) - 1)
        text = re.sub(r'\b(src|href)="([^":]+\.(?:png|jpg))"', lambda found: renamed(found, path, smaller), path.read_text(encoding="utf-8"))
        if "arithmatex" not in text:  # a page without formulas
            text = re.sub(r'<(?:script src|link rel="stylesheet" href)="[^"]*katex\.min\.(?:js"></script|css")>', "", text)
        text = re.sub(r"<img (?![^>]*loading=)", '<img loading="lazy" decoding="async" ', text)
        head = f'<meta http-equiv="Content-Security-Policy" content="{meta_policy()}">'
        text = text.replace("<head>", f"<head>{head}", 1).replace("</body>", f'<script src="{up}offline.js"></script></body>', 1)
        if path == made / "index.html":
            text = start_page(made, text, clip)
        text = re.sub(r'<img (?![^>]*width=)([^>]*)src="([^":]+)"', lambda found: sized(found, path), text)
        path.write_text(INDENTED.sub(lambda found: found[1] or "\n", text), encoding="utf-8")
    for path, other in smaller.items():
        if other:
            path.unlink()
    for path in made.rglob("*.js.map"):
        path.unlink()
    shutil.rmtree(made / "assets" / "javascripts" / "lunr")  # the search's stemmers for languages other than English
    for name in ("offline.js", "worker.js"):
        shutil.copyfile(OWN / name, made / name)
    (made / MARK).write_text("Written by ./course docs --site, which replaces this folder.\n", encoding="utf-8")
    (made / ".nojekyll").write_text("", encoding="utf-8")  # GitHub's pages leave out names that begin with _
    write_atomically(made / "kept.js", kept(made))
    size = sum(path.stat().st_size for path in made.rglob("*") if path.is_file())
    if size > MOST_BYTES:
        warn(f"the site has {size / 1e6:.0f} MB, more than the {MOST_BYTES / 1e6:.0f} MB that it should have")
    else:
        say(f"the site has {size / 1e6:.0f} MB")


def short(chart: str) -> str:
    """A vector picture with places in hundredths of its units, and without names that nothing refers to."""
    used = set(re.findall(r'(?:url\(#|href="#)([^)"]+)', chart))
    chart = re.sub(r' id="([^"]*)"', lambda found: found[0] if found[1] in used else "", chart)
    chart = re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", chart, flags=re.S)
    chart = re.sub(r' (?:d|x|y)="[^"]*"', lambda found: re.sub(r"(\.\d\d)\d+", r"\1", found[0]), chart).replace("DejaVuSans-", "").replace("xlink:href", "href")
    return re.sub(r"\s*\n\s*", "\n", chart)


def smaller_fonts(made: Path):
    """The faces with only the letters used in texts, as WOFF2: a twentieth of the package's size."""
    import logging

    from fontTools import subset

    logging.disable(logging.WARNING)  # of the package's dates; main() resets its loggers
    style = made / "assets" / "lesson.css"
    for face in (made / "assets" / "fonts").glob("*.ttf"):
        subset.main([str(face), "--unicodes=U+20-17F,U+2B0-2FF,U+370-3FF,U+2000-22FF,U+25A0-25FF,U+2713",
                     "--layout-features=kern,liga,tnum,ccmp,locl,mark,mkmk", "--no-hinting", "--flavor=woff2",
                     f"--output-file={face.with_suffix('.woff2')}"])
        face.unlink()
    logging.disable(logging.NOTSET)
    style.write_text(re.sub(r"(fonts/[\w-]+)\.ttf", r"\1.woff2", style.read_text(encoding="utf-8")), encoding="utf-8")


def start_page(made: Path, page: str, clip: Path | None) -> str:
    """The start page with the chapters' pictures as small as it shows them, its first one whole, and the film over that."""
    def picture(found: re.Match, size: tuple[int, int], kind: str) -> str:
        to = (made / found[2]).with_suffix(f".{kind}.webp")
        to.write_bytes(encoded((made / found[2]).with_suffix(".png"), size, quality=82, method=4))
        return f'{found[1]}{to.relative_to(made)}"'
    page = re.sub(r'(<a class="card"[^>]*>\s*<img [^>]*src=")([^"]+)"', lambda found: picture(found, (480, 270), "card"), page)
    page = re.sub(r'(<div class="hero"[^>]*>\s*<img [^>]*src=")([^"]+)"', lambda found: picture(found, (1200, 675), "hero"), page)
    if clip:
        shutil.copyfile(clip, made / "assets" / "start.mp4")
        page = with_film(page)
    return page


def with_film(page: str) -> str:
    """The film in the place of the start page's picture, which shows until it plays."""
    return re.sub(r'(<div class="hero"[^>]*>\s*)<img [^>]*src="([^"]+)"[^>]*>', r'\1<video autoplay muted loop playsinline '
                  r'preload="metadata" poster="\2" aria-label="Some seconds of the film that the course ends with">'
                  r'<source src="assets/start.mp4" type="video/mp4"></video>', page, count=1)


def small(path: Path) -> Path | None:
    data = encoded(path, None if "images" in path.parts else (WIDEST, 10 * WIDEST), quality=82, method=4)
    if len(data) >= path.stat().st_size:
        return None
    other = path.with_suffix(".webp")
    other.write_bytes(data)
    return other


def renamed(found: re.Match, page: Path, smaller: dict[Path, Path | None]) -> str:
    meant = (page.parent / unquote(found[2])).resolve()
    other = smaller.get(meant)
    return f'{found[1]}="{found[2][:found[2].rindex(".")]}.webp"' if other else found[0]


def sized(found: re.Match, page: Path) -> str:
    """The image with its size, so that a page keeps its place while pictures above come in."""
    file = (page.parent / unquote(found[2])).resolve()
    size = size_of(file) if file.is_file() else None
    return f'<img width="{size[0]}" height="{size[1]}" {found[1]}src="{found[2]}"' if size else found[0]


@functools.cache
def size_of(file: Path) -> tuple[int, int] | None:
    if file.suffix == ".svg":
        head = file.read_text(encoding="utf-8")[:2000]
        said = [re.search(rf'<svg[^>]*\b{side}="([\d.]+)(pt|px|)"', head) for side in ("width", "height")]
        return tuple(round(float(one[1]) * (4 / 3 if one[2] == "pt" else 1)) for one in said) if all(said) else None
    from PIL import Image

    with Image.open(file) as picture:
        return picture.size


def meta_policy() -> str:
    """serve's policy, without directives that need a server."""
    return "; ".join(part for part in POLICY.split("; ") if not part.startswith("frame-ancestors")) + "; media-src 'self'"


def kept(made: Path) -> str:
    """Files that the service worker keeps at the first visit, and a version that changes with any file."""
    files = sorted(path for path in made.rglob("*") if path.is_file() and path.name not in (MARK, ".nojekyll", "worker.js"))
    version = hashlib.sha256()
    for path in files:
        version.update(path.read_bytes())
    names = [path.relative_to(made).as_posix() for path in files]
    first = [name for name in names if not name.startswith(("source/", "whole/", "studies/", "open/", "states/")) and name != "assets/start.mp4"]
    return f"const VERSION = {json.dumps(version.hexdigest()[:16])}, KEPT = {json.dumps(first)};\n"
