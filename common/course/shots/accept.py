"""Makes the pictures of now the goldens, and measures how far drivers differ from them. The only way to change either."""

import io
import json
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from build.build import build
from progress import Progress
from shots.golden import (LIMITS, compare, distance_of, distances_path, golden_path, hardware_distances, limits_by,
                          measured_distances, recorded_distances, unfit)
from shots.rendering import Asked, render_many
from tree import BUILD, Failure, UsageError, find_shots, relative, say, write_atomically

# llvmpipe limited to an older processor. Other devices ignore it.
PROCESSORS = {name: {"GALLIUM_OVERRIDE_CPU_CAPS": name} for name in ("avx", "sse4.1")}

ALONE = True
HELP = """Renders shots with the reference and makes them the goldens of tests/NN_name/golden, after listing
the changes with their size. Look at each picture first: the tests take every accepted picture for right.

  ./course accept              every shot
  ./course accept 02           the shots of chapter 02
  ./course accept 02.bunny     one shot

An empty picture, or one with NaN in it, is refused.

Each shot is drawn again by Mesa's llvmpipe restricted to AVX and to SSE4.1, and by a second driver: --second-driver names
its manifest (an ICD's .json, as Vulkan's loader takes it in VK_DRIVER_FILES), for instance another Mesa's lavapipe. How
far these are from the golden goes to tests/NN_name/golden/distances.json; the tests allow three times as much, and never
less than what common/course/shots/golden.py says. Where a distance is large, mend the shader or the scene first: a ray that
just hits or just misses, or texture coordinates far from 0."""


def add_arguments(parser):
    parser.add_argument("shot", nargs="?", default="", metavar="NN[.SHOT]")
    parser.add_argument("--second-driver", type=Path, metavar="FILE", help="manifest of a second Vulkan driver")
    parser.add_argument("--yes", action="store_true", help="accept without asking")


def run(arguments, _rest) -> int:
    found = find_shots(arguments.shot)
    drivers = other_drivers(arguments.second_driver)
    build(sorted({chapter for chapter, _ in found} | {"compare"}))
    pictures, distances, new, refused, seen = {}, {}, [], 0, 0
    by_chapter = {chapter: [shot["name"] for its, shot in found if its == chapter] for chapter, _ in found}
    with Progress("rendering") as progress, ThreadPoolExecutor(2) as pool:
        try:
            for chapter, results in zip(by_chapter, pool.map(lambda chapter: draw(chapter, by_chapter[chapter], drivers), by_chapter)):
                for name, result in zip(by_chapter[chapter], results):
                    seen += 1
                    progress.show(seen, len(found), f"{chapter}.{name}")
                    try:
                        line, picture, is_new = judge(chapter, name, result.pop("golden"))
                        distances[chapter, name] = measure(chapter, name, picture, result, is_new)
                        line += "\n  " + farthest(distances[chapter, name])
                        if wider := wider_limits(distances[chapter, name]):
                            line += f"\n  drivers differ so much that tests would allow more than usual: {wider}; mend the shader or the scene first"
                        pictures[chapter, name] = picture
                        new += [(chapter, name)] if is_new else []
                    except Failure as failure:
                        line = f"refused: {failure}"
                        refused += 1
                    progress.clear()
                    say(f"{chapter[:2]}.{name}: {line}")
        except BaseException:
            Asked.stopped = True
            raise
    accepted = new if new and confirmed(new, arguments.yes) else []
    for chapter, name in accepted:
        write_atomically(golden_path(chapter, name), squeezed(pictures[chapter, name].read_bytes()))
    keep_distances({key: value for key, value in distances.items() if key not in new or key in accepted})
    if accepted:
        say(f"accepted {len(accepted)}: look at each before you commit it")
    return 1 if refused else 0


def other_drivers(manifest: Path | None) -> dict:
    """Drivers to compare with the usual one: a name, and its environment. Reports if there is no second."""
    if not manifest:
        say("without --second-driver FILE no second driver is measured (./course accept --help)")
        return PROCESSORS
    if not manifest.is_file():
        raise UsageError(f"--second-driver {manifest}: is not a file; it takes a Vulkan driver's manifest (.json)")
    return PROCESSORS | {"second driver": {"VK_DRIVER_FILES": str(manifest.absolute())}}


def drawn_by(chapter: str, name: str, driver: str = "") -> Path:
    return BUILD / "accept" / chapter / (f"{name}.{driver.replace(' ', '_')}.png" if driver else f"{name}.png")


def draw(chapter: str, names: list[str], drivers: dict) -> list[dict]:
    """Draws shots with the reference, by one process for each driver. For each shot the failures by driver, "" for none; those
    of the driver that draws goldens under "golden"."""
    failures = {"golden": render_many(chapter, [(["--shot", name, "--use", "solution"], drawn_by(chapter, name)) for name in names])}
    for driver, environment in drivers.items():
        # A driver may keep its compiled shaders regardless of the processor limit.
        failures[driver] = render_many(chapter, [(["--shot", name], drawn_by(chapter, name, driver)) for name in names],
                                       MESA_SHADER_CACHE_DISABLE="true", **environment)
    return [{driver: all_of[i] for driver, all_of in failures.items()} for i in range(len(names))]


def judge(chapter: str, name: str, failure: str) -> tuple[str, Path, bool]:
    """(novelty, the picture, whether it differs from the golden) of a shot that was drawn. Raises Failure."""
    if failure:
        raise Failure(failure)
    golden, picture = golden_path(chapter, name), drawn_by(chapter, name)
    old = golden if golden.exists() else picture
    heatmap = picture.with_suffix(".flip.png")
    try:
        metrics = compare(old, picture, heatmap)
    except Failure as failure:  # another size, or a golden that is no picture
        old, reason = picture, str(failure)
        metrics = compare(picture, picture)
    else:
        reason = "a new picture"
    if unfit(metrics):
        raise Failure("; ".join(unfit(metrics)))
    if old is picture:
        return f"{reason}: {relative(picture)}", picture, True
    flip, step = metrics["flip"], metrics["max_diff"]
    if not step["pixels"]:  # a golden is squeezed: its bytes differ from what a chapter writes
        return "as it was", picture, False
    return (f"FLIP mean {flip['mean']:.6f}, p99 {flip['p99']:.6f}, largest step {step['steps']} at "
            f"({step['x']}, {step['y']}), {step['pixels']} pixels differ: {relative(picture)}, error "
            f"{relative(heatmap)}"), picture, True


def measure(chapter: str, name: str, picture: Path, failures: dict, is_new: bool) -> dict:
    """How far the others' pictures are from this one, by driver. Raises Failure."""
    # A driver that is not here now said something of the golden as it still is.
    distances = {} if is_new else dict(measured_distances(chapter).get(name, {}))
    for driver, failure in failures.items():
        other = drawn_by(chapter, name, driver)
        if failure:
            raise Failure(f"{driver}: {failure}")
        metrics = compare(picture, other)
        if unfit(metrics):
            raise Failure(f"{driver}: " + "; ".join(unfit(metrics)))
        distances[driver] = {key: round(value, 6) for key, value in distance_of(metrics).items()}
    return distances


def farthest(distances: dict) -> str:
    most = {key: max(distance[key] for distance in distances.values()) for key in LIMITS}
    return (f"others: FLIP mean {most['flip_mean']:.6f}, p99 {most['flip_p99']:.6f}, largest step {most['max_diff']} "
            f"({max(distances, key=lambda driver: distances[driver]['max_diff'])})")


def wider_limits(distances: dict) -> str:
    """The limits that measured distances would widen; empty where they widen none."""
    limits = limits_by(distances.values())
    return ", ".join(f"{key} {value:.6g} instead of {LIMITS[key]}" for key, value in limits.items() if value != LIMITS[key])


def squeezed(png: bytes) -> bytes:
    """The same pixels in about two thirds of the bytes that a chapter writes, which every clone fetches: without an alpha that is 1
    everywhere, and deflated as well as zlib can; the same bytes where that is not less, or where there is no PIL."""
    try:
        from PIL import Image
    except ImportError:
        return png
    if not png.startswith(b"\x89PNG"):
        return png
    out = io.BytesIO()
    with Image.open(io.BytesIO(png)) as picture:
        if picture.mode == "RGBA" and picture.getextrema()[3] == (255, 255):
            picture = picture.convert("RGB")
        picture.save(out, "PNG", optimize=True)
    return min(png, out.getvalue(), key=len)


def keep_distances(distances: dict):
    for chapter in sorted({chapter for chapter, _ in distances}):
        # Of a shot that is gone nothing stays.
        known = {shot["name"] for _, shot in find_shots(chapter)}
        kept = {name: of for name, of in recorded_distances(chapter).items() if name in known}
        kept |= {name: of | hardware_distances(chapter, name) for (its, name), of in distances.items() if its == chapter}
        lines = [f" {json.dumps(name)}: {{\n" + ",\n".join(f"  {json.dumps(driver)}: {json.dumps(distance)}"
                 for driver, distance in sorted(of.items())) + "\n }" for name, of in sorted(kept.items())]
        write_atomically(distances_path(chapter), "{\n" + ",\n".join(lines) + "\n}\n")


def confirmed(new: list, yes: bool) -> bool:
    if yes:
        return True
    if not sys.stdin.isatty():
        raise UsageError("nothing was accepted; look at the pictures above, then add --yes")
    say(f"Have you looked at {'them' if len(new) > 1 else 'it'}? Accept {len(new)}? [y/N]")
    return sys.stdin.readline().strip().lower() == "y"  # an end of the input is no
