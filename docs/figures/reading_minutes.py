"""How many minutes the main thread of each lesson takes to read, with its code.

python3 docs/figures/reading_minutes.py measures them into reading_minutes.json, from which draw.py draws. A test allows the file
four minutes of difference, so that not every word changes the picture.
"""

import json
import sys
from pathlib import Path

from drawing import BLUE, FAINT, GREY, INK, PALE_BLUE, RED, SMALL, THIN, Drawing, figure

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common" / "course"))
from pages.reading import WORDS_A_MINUTE, minutes  # noqa: E402
from tree import lessons  # noqa: E402

MEASURED = Path(__file__).with_suffix(".json")
TAKEN = json.loads(MEASURED.read_text(encoding="utf-8"))
MOST = 45  # minutes that a main thread may take
ROW, WIDE = 30, 14  # pixels of a bar with its space, and of a minute


@figure("reading_minutes", 1000, 110 + ROW * len(TAKEN),
        f"Minutes of reading for each lesson's main thread with its code, at {WORDS_A_MINUTE} words a minute")
def draw_minutes(drawing: Drawing):
    p = drawing.panel()
    left, top = 280, drawing.height - 70
    for minute in range(0, MOST + 1, 15):
        p.line([(left + WIDE * minute, top + 10), (left + WIDE * minute, top - ROW * len(TAKEN))], RED if minute == MOST else FAINT, THIN)
        p.text((left + WIDE * minute, top + 28), f"{minute} min", RED if minute == MOST else GREY, SMALL)
    for i, (page, spent) in enumerate(TAKEN.items()):
        y = top - ROW * i - 20
        number, _, name = page.partition("_")
        p.text((left - 12, y), f"{number} {name.replace('_', ' ')}", INK, SMALL, anchor="end")
        p.box((left, y - 9), (left + WIDE * spent, y + 9), BLUE, THIN, fill=PALE_BLUE)
        p.text((left + WIDE * spent + 8, y), f"{spent}", BLUE, SMALL, anchor="start")


if __name__ == "__main__":
    MEASURED.write_text(json.dumps({page.stem: round(minutes(page)) for page in lessons()}, indent=1) + "\n", encoding="utf-8")
