"""Puts labels beside points so that they cover neither each other nor a curve."""

import math

from matplotlib.transforms import Bbox

# Where a label may stand, seen from its point: (x, y) offset in points, then how it is aligned. Best first.
PLACES = [((9, 0), "left", "center"), ((-9, 0), "right", "center"), ((0, 9), "center", "bottom"),
          ((0, -9), "center", "top"), ((8, 7), "left", "bottom"), ((8, -7), "left", "top"), ((-8, 7), "right", "bottom"),
          ((-8, -7), "right", "top"), ((10, 18), "left", "bottom"), ((10, -18), "left", "top"),
          ((-10, 18), "right", "bottom"), ((-10, -18), "right", "top"), ((0, 26), "center", "bottom"),
          ((0, -26), "center", "top")]
POINT_RADIUS = 7  # of a marker with its ring, in points


class Labels:
    """Places labels one after the other; what is placed first has the choice."""

    def __init__(self, axes):
        """axes: the panel, which may be of several: a label may leave one of them for another."""
        self.renderer = axes[0].figure.canvas.get_renderer()
        self.frame = Bbox.union([axis.get_window_extent(self.renderer) for axis in axes])
        self.scale = self.renderer.points_to_pixels(1.0)
        self.boxes = []  # of labels and points, in pixels
        self.samples = []  # along curves, in pixels

    def avoid_curve(self, points):
        """points: (axis, x, y, its bar's ends in x, those in y) in order. No curve runs from one axis to another."""
        radius = POINT_RADIUS * self.scale
        pixels = [(axis, axis.transData.transform((x, y))) for axis, x, y, _, _ in points]
        for i, (axis, at) in enumerate(pixels):
            self.boxes.append(Bbox.from_extents(at[0] - radius, at[1] - radius, at[0] + radius, at[1] + radius))
            ends = [axis.transData.transform((x, points[i][2])) for x in points[i][3]]
            self.boxes.append(Bbox.from_extents(ends[0][0], at[1] - radius / 2, ends[1][0], at[1] + radius / 2))
            low, high = (axis.transData.transform((points[i][1], y))[1] for y in points[i][4])
            if high > low:
                self.boxes.append(Bbox.from_extents(at[0] - radius / 2, low, at[0] + radius / 2, high))
            if i and pixels[i - 1][0] is axis:
                before = pixels[i - 1][1]
                steps = max(2, int(math.dist(before, at) / (3 * self.scale)))
                self.samples += [before + (at - before) * k / steps for k in range(1, steps)]

    def avoid_texts(self, texts):
        self.boxes += [text.get_window_extent(self.renderer) for text in texts]

    def place(self, text, anchors, colour, size, weight, must):
        """Writes `text` beside one of the anchors (as in avoid_curve), where it covers least. Unless it `must` be written, it
        is left out where it would cover anything."""
        if not text:
            return
        best = None
        for rank_of_anchor, (axis, x, y, *bars) in enumerate(anchors):
            centre = axis.transData.transform((x, y))
            reach = [abs(axis.transData.transform((end, y))[0] - centre[0]) / self.scale for end in bars[0]]
            rise = [abs(axis.transData.transform((x, end))[1] - centre[1]) / self.scale for end in bars[1]]
            for rank, (offset, align, valign) in enumerate(PLACES):
                if valign == "center":  # beside the bar, not on it
                    offset = (max(offset[0], reach[1] + 5) if align == "left" else min(offset[0], -reach[0] - 5), 0)
                if align == "center":
                    offset = (0, max(offset[1], rise[1] + 5) if valign == "bottom" else min(offset[1], -rise[0] - 5))
                note = axis.annotate(text, (x, y), xytext=offset, textcoords="offset points", ha=align, va=valign,
                                     color=colour, fontsize=size, weight=weight, zorder=5, annotation_clip=False)
                box = note.get_window_extent(self.renderer)
                cost = self.cost(box) + 0.02 * rank + 0.1 * rank_of_anchor
                note.remove()
                if best is None or cost < best[0]:
                    best = (cost, box, axis, (x, y), offset, align, valign)
        if best is None or (best[0] >= 1 and not must):
            return
        _, box, axis, at, offset, align, valign = best
        axis.annotate(text, at, xytext=offset, textcoords="offset points", ha=align, va=valign, color=colour,
                      fontsize=size, weight=weight, zorder=5, annotation_clip=False)
        self.boxes.append(box.padded(2 * self.scale))

    def cost(self, box):
        """0 where it covers nothing; what it covers, and how far it leaves the panel."""
        covered = sum(1 + overlap(box, other) / max(box.width * box.height, 1)
                      for other in self.boxes if overlap(box, other) > 0)
        around = box.padded(1.5 * self.scale)
        on_curve = sum(around.contains(*at) for at in self.samples)
        outside = (max(0, box.x1 - self.frame.x1, self.frame.x0 - box.x0) +
                   max(0, box.y1 - self.frame.y1, self.frame.y0 - box.y0))
        return covered + 0.35 * on_curve + 0.5 * outside / self.scale


def overlap(a, b):
    """The common area, in square pixels."""
    width = min(a.x1, b.x1) - max(a.x0, b.x0)
    height = min(a.y1, b.y1) - max(a.y0, b.y0)
    return width * height if width > 0 and height > 0 else 0.0
