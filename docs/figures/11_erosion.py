"""A sum of octaves, and the same with each octave weighted by how steep those before it are, along a line.

python3 docs/figures/11_erosion.py writes docs/images/11_erosion.svg.
"""

from math import cos, sin

from drawing import BLUE, FAINT, INK, RED, SMALL, THIN, Drawing


def heights(x: float, erosion: float, octaves: int = 7) -> float:
    """Waves instead of noise: only the weight's effect is shown."""
    total, slope, amplitude, frequency = 0.0, 0.0, 1.0, 1.0
    for k in range(octaves):
        phase = frequency * x + 1.3 * k
        slope += cos(phase)
        total += amplitude * sin(phase) / (1 + erosion * slope * slope)
        amplitude *= 0.46
        frequency *= 2.236
    return total


def draw() -> Drawing:
    drawing = Drawing(900, 360, "Two mountain lines over each other: a plain sum of octaves is rough everywhere, the eroded one is rough on "
                                "its heights and in its valleys and smooth on its slopes")
    for row, (erosion, color, name) in enumerate(((0.0, RED, "fBm: rough everywhere"), (1.0, BLUE, "eroded: steep places are smooth"))):
        p = drawing.panel((40, 250 - 165 * row), 56)
        p.line([(0, -1.1), (14.6, -1.1)], FAINT, THIN)
        p.curve(lambda x, e=erosion: (x, heights(x, e)), 0, 14.6, color, 2.4, steps=700)
        p.text((14.6, 1.5), name, color if color else INK, SMALL, anchor="end", offset=(0, 12))
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
