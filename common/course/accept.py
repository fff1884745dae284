"""Makes the pictures of now the goldens. The only way to change one."""

import sys
from pathlib import Path

from build import build
from progress import Progress
from shots import compare, golden_path, render_shot, unfit
from tree import BUILD, Failure, UsageError, find_shots, relative, say, write_atomically

HELP = """Renders shots with the reference and makes them the goldens of tests/NN_name/golden, after it said what
changed and by how much. Look at each picture first: whatever is accepted is what the tests hold to be right.

  ./course accept              every shot
  ./course accept 02           those of chapter 02
  ./course accept 02.bunny     one

A picture on which nothing was drawn, or with NaN in it, is refused."""


def add_arguments(parser):
    parser.add_argument("shot", nargs="?", default="", metavar="NN[.SHOT]")
    parser.add_argument("--yes", action="store_true", help="do not ask")


def run(arguments, _rest) -> int:
    found = find_shots(arguments.shot)
    build(sorted({chapter for chapter, _ in found} | {"compare"}))
    new, refused = [], 0
    with Progress("rendering") as progress:
        for number, (chapter, shot) in enumerate(found):
            progress.show(number, len(found), f"{chapter}.{shot['name']}")
            try:
                line, picture = judge(chapter, shot)
            except Failure as failure:
                line, picture = f"refused: {failure}", None
                refused += 1
            progress.clear()
            say(f"{chapter[:2]}.{shot['name']}: {line}")
            if picture:
                new.append((picture, golden_path(chapter, shot["name"])))
    if new and confirmed(new, arguments.yes):
        for picture, golden in new:
            write_atomically(golden, picture.read_bytes())
        say(f"accepted {len(new)}: look at each before you commit it")
    return 1 if refused else 0


def judge(chapter: str, shot: dict) -> tuple[str, Path | None]:
    """Renders a shot: (what is new about it, the picture; none where it equals the golden). Raises Failure."""
    golden = golden_path(chapter, shot["name"])
    picture = BUILD / "accept" / chapter / f"{shot['name']}.png"
    render_shot(chapter, shot, picture)
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
        return f"{reason}: {relative(picture)}", picture
    if golden.read_bytes() == picture.read_bytes():
        return "as it was", None
    flip, step = metrics["flip"], metrics["max_diff"]
    return (f"FLIP mean {flip['mean']:.6f}, p99 {flip['p99']:.6f}, largest step {step['steps']} at "
            f"({step['x']}, {step['y']}), {step['pixels']} pixels differ: {relative(picture)}, error "
            f"{relative(heatmap)}"), picture


def confirmed(new: list, yes: bool) -> bool:
    if yes:
        return True
    if not sys.stdin.isatty():
        raise UsageError("nothing was accepted; look at the pictures above, then add --yes")
    return input(f"Have you looked at {'them' if len(new) > 1 else 'it'}? Accept {len(new)}? [y/N] ").lower() == "y"
