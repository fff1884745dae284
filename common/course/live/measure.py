"""Measures how fast pictures answer: python3 common/course live.measure [NN...]

A row of Markdown for each chapter, the first shot of each: the first picture of a program that has just been started and
of one that is warm, the median for a knob that is dragged, at 480 x 270 as a JPEG, and pictures a second while orbiting.
Then the knob again as the page drags it, a picture of 960 x 540: at half that size, and smaller where it takes too long.
The load of the machine stands beside them: other work on the same cores makes all of it longer.
"""

import asyncio
import os
import statistics
import sys
import time

from live.programs import Program
from pages.knob_links import knobs_of
from tree import find_chapter, say, shots

SIZE, ROUNDS = [480, 270], 20
DEFAULT = ("02", "03", "04", "05", "06", "07", "08")


def knob_to_drag(chapter: str) -> dict:
    """The last number that is declared and is not 0: it is dragged upwards from its default. Far from it a chapter may
    take many times as long, as lights do that reach everything."""
    numbers = [knob for knob in knobs_of(chapter) if knob["type"] == "number" and isinstance(knob["default"], float) and knob["default"] > 0]
    return numbers[-1]


def scale_for(known: list[tuple[float, float]]) -> float:
    """The share of the whole size that the page asks for next, from the (scale, ms) that it knows, the newest first
    (Picture.scale_for and learn in site/picture.js)."""
    (scale, ms), fixed = known[0], 0
    per_pixel = max(ms, 1) / scale ** 2
    if before := next((one for one in known[1:4] if abs(one[0] - scale) > 0.02), None):
        per_pixel = max((ms - before[1]) / (scale ** 2 - before[0] ** 2), 1)
        fixed = max(ms - per_pixel * scale ** 2, 0)
    return min(max((max(90 - fixed, fixed / 2) / per_pixel) ** 0.5, 0.5 * scale, 0.15), 1.25 * scale, 0.5)


async def measure(chapter: str) -> str:
    program, words = Program(chapter), ["--shot", shots(chapter)[0]["name"]]
    knob = knob_to_drag(chapter)

    async def timed_ms(**more) -> float:
        began_s = time.monotonic()
        answer, picture = await program.draw({"words": words, "size": SIZE} | more)
        if answer["code"] or not picture:
            raise SystemExit(f"{chapter}: {answer['error']}")
        return 1000 * (time.monotonic() - began_s)
    try:
        first, warm = await timed_ms(still=True), await timed_ms(still=True)
        dragged = [await timed_ms(set={knob["name"]: f"{min(knob['default'] * (1 + i / ROUNDS), knob['range'][1]):g}"}) for i in range(ROUNDS)]
        scale, known, as_page = 0.5, [], []
        for i in range(ROUNDS):
            size = [round(2 * side * scale) for side in SIZE]
            as_page.append((await timed_ms(size=size, set={knob["name"]: f"{min(knob['default'] * (1 + i / ROUNDS), knob['range'][1]):g}"}), size))
            known.insert(0, (scale, as_page[-1][0]))
            scale = scale_for(known)
        orbit = [await timed_ms(turn_rad=0.02 * i) for i in range(ROUNDS)]
    finally:
        program.end()
    return (f"| {chapter[:2]} {words[1]} | {first / 1000:.1f} s | {warm / 1000:.2f} s | {knob['name']} | {statistics.median(dragged):.0f} ms | "
            f"{statistics.median(ms for ms, _ in as_page[ROUNDS // 2:]):.0f} ms at {as_page[-1][1][0]} × {as_page[-1][1][1]} | {1000 / statistics.median(orbit):.1f} |")


def main(words: list[str]) -> int:
    say("| shot | first picture | warm | knob | dragged, median | as the page drags it | orbit, pictures a second |\n|---|--:|--:|---|--:|--:|--:|")
    for word in words or DEFAULT:
        say(asyncio.run(measure(find_chapter(word))))
    say(f"\nload {os.getloadavg()[0]:.0f} on {os.cpu_count()} cores")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
