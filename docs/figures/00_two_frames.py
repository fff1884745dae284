"""Two frames in flight: the CPU records a frame while the GPU draws the one before, and the screen shows the one before that.

python3 docs/figures/00_two_frames.py writes docs/images/00_two_frames.svg.
"""

from drawing import BLUE, GREY, INK, ORANGE, PALE_BLUE, PALE_GREEN, PALE_ORANGE, PURPLE, RED, SMALL, THIN, Drawing

COLORS = ((BLUE, PALE_BLUE), (ORANGE, PALE_ORANGE))


def draw() -> Drawing:
    drawing = Drawing(1000, 370, "Rows of CPU, GPU and screen over time. Frames alternate between two sets of commands, semaphores and fences. The CPU waits "
                                 "for the fence of two frames ago, the GPU for an acquired image, the screen for a finished one")
    p = drawing.panel((110, 60), 1)
    rows = {"CPU": 210, "GPU": 120, "screen": 30}
    for name, y in rows.items():
        p.text((-14, y + 20), name, INK, SMALL, anchor="end")
    step, record, gpu = 200, 110, 180
    for i in range(4):
        color, fill = COLORS[i % 2]
        begin = i * step
        p.box((begin, rows["CPU"]), (begin + record, rows["CPU"] + 40), color, THIN, fill=fill)
        p.text((begin + record / 2, rows["CPU"] + 20), f"record {i}", color, SMALL, rim=False)
        start = begin + record + 12
        if start + gpu < 870:
            p.box((start, rows["GPU"]), (start + gpu, rows["GPU"] + 40), color, THIN, fill=fill)
            p.text((start + gpu / 2, rows["GPU"] + 20), f"draw {i}", color, SMALL, rim=False)
            p.arrow((begin + record, rows["CPU"] + 4), (start + 4, rows["GPU"] + 40), GREY, width=THIN)
            shown = start + gpu + 12
            if shown + 130 < 870:
                p.box((shown, rows["screen"]), (shown + 150, rows["screen"] + 40), color, THIN, fill=PALE_GREEN)
                p.text((shown + 75, rows["screen"] + 20), f"show {i}", color, SMALL, rim=False)
                p.arrow((start + gpu - 4, rows["GPU"]), (shown + 4, rows["screen"] + 40), PURPLE, width=THIN)
        if i >= 2:
            ended = (i - 2) * step + record + 12 + gpu
            p.arrow((ended, rows["GPU"] + 40), (max(begin + 10, ended + 10), rows["CPU"]), RED, width=THIN, dash=True)
    p.text((0, 278), "fence (red): the CPU reuses a set when its frame has ended", RED, SMALL, anchor="start")
    p.text((0, -16), "semaphore (purple): the screen waits for the drawing", PURPLE, SMALL, anchor="start")
    p.arrow((520, -38), (850, -38), GREY, width=THIN)
    p.text((690, -20), "time", GREY, SMALL)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
