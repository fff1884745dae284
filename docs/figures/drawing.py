"""Diagrams as one would draw them on a board: plain SVG from a few words, all of them from one hand.

A function of docs/figures/NN.py makes one diagram, docs/images/NN_name.svg, and the text tests ask that the one that is
committed is just what the function draws:

    from drawing import EYE, LIGHT, NORMAL, Drawing, figure

    @figure("02_vectors", 900, 400, "A light, an eye and the normal at a point")
    def draw_vectors(drawing: Drawing):
        p = drawing.panel(origin=(450, 60), scale=250)   # pixels from the left and the bottom; pixels for one unit
        p.ground(-1.5, 1.5)
        p.arrow((0, 0), (0, 1), NORMAL, "*n*")
        p.arrow((0, 0), polar(0.9, 130), LIGHT, "*l*")
        p.arc((0, 0), 0.4, 90, 130, "θ_{i}")

`python3 docs/figures/draw.py [NN_name...]` writes them.

Positions are in the panel's units, x to the right and y up; angles are in degrees, counter-clockwise from the x axis.
Widths, text, arrow heads and `offset` are in pixels, whatever the scale. A text may hold *bold* (vectors), _{sub} and
^{super}; lines are parted by "\\n".

The background is painted, so that a page in dark mode shows the same picture. Labels have a rim in its colour, and a
drawing whose labels overlap or leave the picture is refused when it is written: move them with `offset`.
"""

import re
from collections.abc import Callable
from math import atan2, cos, degrees, hypot, radians, sin

BACKGROUND = "#fbfaf6"
INK, GREY, FAINT = "#1f2430", "#5d6472", "#b9bec8"
BLUE, RED, GREEN, ORANGE, PURPLE = "#1550b8", "#b3201f", "#11703a", "#b45309", "#7226a8"
PALE_BLUE, PALE_RED, PALE_GREEN, PALE_ORANGE, PALE_GREY = "#d6e4fb", "#f8d9d6", "#d5eddc", "#fbe6c4", "#e7e6e1"
# One colour for one thing, in every chapter.
NORMAL, LIGHT, EYE, HALF, MIRROR, SURFACE = GREEN, ORANGE, BLUE, PURPLE, RED, PALE_GREY

TEXT, SMALL = 22, 18  # pixels; nothing is smaller
THICK, THIN = 3.0, 1.6
HEAD = 13  # of an arrow
FONT = "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif"

Point = tuple[float, float]


def polar(radius: float, angle: float, center: Point = (0, 0)) -> Point:
    """The point at this distance from `center` in this direction."""
    return center[0] + radius * cos(radians(angle)), center[1] + radius * sin(radians(angle))


def between(a: Point, b: Point, share: float = 0.5) -> Point:
    return a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share


def _number(value: float) -> str:
    return f"{round(value, 1) + 0.0:.1f}".removesuffix(".0")


def _pieces(text: str) -> list[tuple[str, str]]:
    """("bold" | "sub" | "super" | "", words) of a label."""
    found = []
    for bold, sub, above, plain in re.findall(r"\*([^*]+)\*|_\{([^}]*)\}|\^\{([^}]*)\}|([^*_^]+|.)", text):
        found.append(("bold", bold) if bold else ("sub", sub) if sub else ("super", above) if above else ("", plain))
    return found


def _width(text: str, size: float) -> float:
    """About as wide as a label is, in pixels, in the widest of the fonts."""
    def of(letter):
        return 0.34 if letter in " iljtfI.,:;'|!()[]·" else 0.92 if letter in "mwMW→" else 0.7 if letter.isupper() else 0.6
    return size * sum(of(letter) * (0.72 if kind in ("sub", "super") else 1.08 if kind else 1)
                      for kind, words in _pieces(text) for letter in words)


def _tspans(text: str) -> str:
    out = []
    for kind, words in _pieces(text):
        words = words.replace("&", "&amp;").replace("<", "&lt;")
        shift = {"sub": 0.28, "super": -0.38}.get(kind)
        if shift:
            # The shift is taken back by an empty span: baseline-shift is not known everywhere.
            out.append(f'<tspan dy="{shift / 0.72:.2f}em" font-size="72%">{words}</tspan>'
                       f'<tspan dy="{-shift:.2f}em">&#8203;</tspan>')
        else:
            out.append(f'<tspan font-weight="bold">{words}</tspan>' if kind else words)
    return "".join(out)


class Drawing:
    """A picture of width × height pixels. `title` describes it in a sentence, for screen readers."""

    def __init__(self, width: int, height: int, title: str):
        self.width, self.height, self.title = width, height, title
        self.shapes: list[str] = []
        self.labels: list[tuple[str, float, float, float, float]] = []  # text, left, top, right, bottom
        self.texts: list[str] = []

    def panel(self, origin: Point = (0, 0), scale: float = 1.0) -> "Panel":
        """Where to draw. `origin` in pixels from the left and the bottom; `scale` in pixels for one unit."""
        return Panel(self, origin, scale)

    def complaints(self) -> list[str]:
        """Labels that overlap or leave the picture."""
        wrong = [f"'{text}' leaves the picture" for text, left, top, right, bottom in self.labels
                 if left < 2 or top < 2 or right > self.width - 2 or bottom > self.height - 2]
        for i, (text, left, top, right, bottom) in enumerate(self.labels):
            wrong += [f"'{text}' overlaps '{other[0]}'" for other in self.labels[:i]
                      if left < other[3] and other[1] < right and top < other[4] and other[2] < bottom]
        return wrong

    def svg(self) -> str:
        """Raises ValueError where a label cannot be read."""
        if wrong := self.complaints():
            raise ValueError("; ".join(wrong))
        title = self.title.replace("&", "&amp;").replace("<", "&lt;")
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" width="{self.width}" '
            f'height="{self.height}" role="img" font-family="{FONT}" stroke-linecap="round" stroke-linejoin="round">',
            f"<title>{title}</title>",
            f'<rect width="{self.width}" height="{self.height}" rx="10" fill="{BACKGROUND}"/>',
            *self.shapes, *self.texts, "</svg>"]) + "\n"


FIGURES: dict[str, Callable[[], Drawing]] = {}  # by the names of their files in docs/images


def figure(name: str, width: int, height: int, title: str):
    """A function that draws on it makes the diagram docs/images/NAME.svg."""
    def register(draw):
        def drawn() -> Drawing:
            drawing = Drawing(width, height, title)
            draw(drawing)
            return drawing
        FIGURES[name] = drawn
        return draw
    return register


class Panel:
    """A part of a drawing with its own origin and scale."""

    def __init__(self, drawing: Drawing, origin: Point, scale: float):
        self.drawing, self.origin, self.scale = drawing, origin, scale

    def pixel(self, at: Point) -> Point:
        return self.origin[0] + self.scale * at[0], self.drawing.height - self.origin[1] - self.scale * at[1]

    def _points(self, points) -> str:
        return " ".join(",".join(map(_number, self.pixel(point))) for point in points)

    @staticmethod
    def _style(color, width, dash, fill) -> str:
        dashes = f' stroke-dasharray="{_number(2.5 * width)} {_number(3 * width)}"' if dash else ""
        stroke = f'stroke="{color}" stroke-width="{_number(width)}"{dashes}' if color else 'stroke="none"'
        return f'fill="{fill or "none"}" {stroke}'

    def line(self, points, color=INK, width=THICK, dash=False, closed=False, fill=None):
        """Straight from point to point; `closed` and `fill` make it a polygon. `color` None: no outline."""
        kind = "polygon" if closed or fill else "polyline"
        self.drawing.shapes.append(f'<{kind} points="{self._points(points)}" {self._style(color, width, dash, fill)}/>')

    def curve(self, function, first: float, last: float, color=INK, width=THICK, dash=False, fill=None, steps=96,
              arrow=False):
        """function(t) -> point, for t from first to last; `arrow` puts a head at the end."""
        points = [function(first + (last - first) * i / steps) for i in range(steps + 1)]
        if not arrow:
            self.line(points, color, width, dash, fill=fill)
            return
        # The head is straight and as long as the last bit of the curve.
        tip = points[-1]
        head = 1.1 * HEAD / self.scale
        while len(points) > 2 and hypot(points[-1][0] - tip[0], points[-1][1] - tip[1]) < head:
            points.pop()
        self.line(points, color, width, dash)
        self.arrow(points[-1], tip, color, width=width)

    def box(self, low: Point, high: Point, color=INK, width=THICK, dash=False, fill=None, label="", ink=None,
            size=SMALL):
        """Its label stands in the middle, in the colour `ink`, else that of the outline."""
        self.line([low, (high[0], low[1]), high, (low[0], high[1])], color, width, dash, True, fill)
        if label:
            self.text(between(low, high), label, ink or color, size, rim=False)

    def circle(self, center: Point, radius: float, color=INK, width=THICK, dash=False, fill=None):
        """The radius is in units."""
        x, y = self.pixel(center)
        self.drawing.shapes.append(f'<circle cx="{_number(x)}" cy="{_number(y)}" r="{_number(radius * self.scale)}" '
                                   f'{self._style(color, width, dash, fill)}/>')

    def dot(self, at: Point, color=INK, label="", offset: Point = (0, 16), radius_px=5.5, **text):
        x, y = self.pixel(at)
        self.drawing.shapes.append(f'<circle cx="{_number(x)}" cy="{_number(y)}" r="{_number(radius_px)}" fill="{color}"/>')
        if label:
            self.text(at, label, color, offset=offset, **text)

    def arrow(self, tail: Point, tip: Point, color=INK, label="", at: float = 1.0, offset: Point | None = None,
              width=THICK, dash=False, both=False, **text):
        """`label` stands at the share `at` of the way: beyond the tip for 1, beside the arrow elsewhere."""
        (x0, y0), (x1, y1) = self.pixel(tail), self.pixel(tip)
        length = max(hypot(x1 - x0, y1 - y0), 1e-6)
        ux, uy = (x1 - x0) / length, (y1 - y0) / length
        heads = [(x1, y1, ux, uy)] + ([(x0, y0, -ux, -uy)] if both else [])
        inset = 0.8 * HEAD
        a = (x0 + ux * inset, y0 + uy * inset) if both else (x0, y0)
        b = (x1 - ux * inset, y1 - uy * inset)
        self.drawing.shapes.append(f'<path d="M{_number(a[0])},{_number(a[1])} L{_number(b[0])},{_number(b[1])}" '
                                   f"{self._style(color, width, dash, None)}/>")
        for x, y, dx, dy in heads:
            left = (x - HEAD * dx - 0.42 * HEAD * dy, y - HEAD * dy + 0.42 * HEAD * dx)
            right = (x - HEAD * dx + 0.42 * HEAD * dy, y - HEAD * dy - 0.42 * HEAD * dx)
            points = " ".join(f"{_number(px)},{_number(py)}" for px, py in ((x, y), left, right))
            self.drawing.shapes.append(f'<polygon points="{points}" fill="{color}"/>')
        if label:
            reach = 18 if at == 1.0 else 0
            beside = (ux * reach, -uy * reach) if reach else (16 * -uy, 16 * -ux)
            self.text(between(tail, tip, at), label, color, offset=offset or beside, **text)

    def arc(self, center: Point, radius: float, first: float, last: float, label="", color=INK, offset: Point = (0, 0),
            **text):
        """An angle from `first` to `last` degrees; its label stands outside of its middle."""
        self.curve(lambda angle: polar(radius, angle, center), first, last, color, THIN, steps=64)
        if label:
            middle = radians((first + last) / 2)
            beyond = 14 + 0.3 * _width(label, text.get("size", TEXT)) * abs(cos(middle))
            self.text(polar(radius, (first + last) / 2, center), label, color,
                      offset=(beyond * cos(middle) + offset[0], beyond * sin(middle) + offset[1]), **text)

    def right_angle(self, corner: Point, first: float, color=INK):
        """The little square between the directions `first` and first + 90 degrees."""
        s = 14 / self.scale
        a, b = polar(s, first, corner), polar(s, first + 90, corner)
        self.line([a, (a[0] + b[0] - corner[0], a[1] + b[1] - corner[1]), b], color, THIN)

    def ground(self, left: float, right: float, y: float = 0.0, depth_px: float = 22):
        """The ground: a line with hatching below it."""
        d = depth_px / self.scale
        self.line([(left, y), (right, y), (right, y - d), (left, y - d)], None, fill=SURFACE)
        self.line([(left, y), (right, y)], INK)

    def span(self, a: Point, b: Point, label="", color=GREY, offset: Point = (0, 0), **text):
        """How long something is: a thin arrow with two heads, and its label in the middle."""
        angle = degrees(atan2(b[1] - a[1], b[0] - a[0]))
        self.arrow(a, b, color, width=THIN, both=True)
        if label:
            side = (-16 * sin(radians(angle)), 16 * cos(radians(angle)))
            self.text(between(a, b), label, color, offset=(side[0] + offset[0], side[1] + offset[1]), **text)

    def lamp(self, at: Point, radius_px: float = 10, color=LIGHT):
        """A light: a disc with rays."""
        r = radius_px / self.scale
        for i in range(8):
            self.line([polar(1.35 * r, 45 * i, at), polar(1.9 * r, 45 * i, at)], color, 2.2)
        self.circle(at, r, color, 2.2, fill=PALE_ORANGE)

    def eye(self, at: Point, facing: float, size_px: float = 34, color=EYE):
        """An eye that looks in the direction `facing`, in degrees; `at` is its pupil's middle."""
        s = size_px / self.scale
        back = polar(s, facing + 180, at)
        lids = [polar(s, facing + 180 + turn, back) for turn in (-152, 152)]
        self.line([lids[0], back, lids[1]], color, 2.6)
        self.curve(lambda angle: polar(0.8 * s, angle, back), facing - 34, facing + 34, color, 2.6, steps=24)
        self.circle(polar(0.62 * s, facing, back), 0.15 * s, color, 2.6, fill=color)

    def text(self, at: Point, text: str, color=INK, size=TEXT, anchor="middle", offset: Point = (0, 0), bold=False,
             rim=True):
        """`offset` is in pixels, y up. `anchor`: start, middle or end. The middle of the text's height is at `at`. A text
        on a filled shape looks better without its `rim`."""
        x, y = self.pixel(at)
        x, y = x + offset[0], y - offset[1]
        lines = text.split("\n")
        step = 1.25 * size
        for i, line in enumerate(lines):
            baseline = y + (i - (len(lines) - 1) / 2) * step + 0.35 * size
            wide = _width(line, size) * (1.08 if bold else 1)
            left = x - wide * {"start": 0, "middle": 0.5, "end": 1}[anchor]
            self.drawing.labels.append((line, left, baseline - 0.8 * size, left + wide, baseline + 0.22 * size))
            weight = ' font-weight="bold"' if bold else ""
            edge = f' stroke="{BACKGROUND}" stroke-width="5" paint-order="stroke"' if rim else ""
            self.drawing.texts.append(
                f'<text x="{_number(x)}" y="{_number(baseline)}" font-size="{size}" text-anchor="{anchor}" fill="{color}"'
                f"{weight}{edge}>{_tspans(line)}</text>")
