"""Puts labels beside points so that they cover neither each other, nor a point, nor a curve.

Labels are wanted one after the other and written together: each has many places, near ones first, and takes the one
that costs least given where all others stand; this is repeated until none moves. A label that stands away from its
point has a thin line to it.
"""
import math

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.transforms import Bbox

RADII = (9, 17, 27, 40, 56, 76, 100, 128)  # from the point to the label's edge, in points
NEAR = RADII[1]  # as far as a label needs no line to its point
ANGLES = tuple(math.radians(angle) for angle in (0, 180, 90, 270, 30, 330, 150, 210, 60, 300, 120, 240,
                                                   15, 345, 165, 195, 45, 315, 135, 225, 75, 285, 105, 255))  # best first
POINT_RADIUS = 7  # of a marker with its ring, in points
PASSES = 8
TRIED = 60  # positions of a label tried at one anchor before giving up
OWN = 1.7  # how many times farther than its own the next point of another curve has to be from a value


class Label:
    """A text, its possible positions, and the chosen one."""

    def __init__(self, text, colour, size, weight, must):
        self.text, self.colour, self.size, self.weight, self.must = text, colour, size, weight, must
        self.places = []  # (cost without other labels, box, axis, anchor in data, its pixel, leader or None)
        self.taken = None


class Labels:
    def __init__(self, axes):
        """axes: the panel, which may be of several: a label may leave one of them for another."""
        self.figure = axes[0].figure
        self.renderer = self.figure.canvas.get_renderer()
        self.frame = Bbox.union([axis.get_window_extent(self.renderer) for axis in axes])
        self.scale = self.renderer.points_to_pixels(1.0)
        self.boxes = []  # of points, their bars and texts, in pixels
        self.samples = []  # along curves, in pixels
        self.points = []  # (pixel, the curve it is of)
        self.curves = 0
        self.wanted = []

    def avoid_curve(self, points):
        """points: (axis, x, y, its bar's ends in x, those in y) in order. No curve runs from one axis to another."""
        radius = POINT_RADIUS * self.scale
        pixels = [(axis, axis.transData.transform((x, y))) for axis, x, y, _, _ in points]
        for i, (axis, at) in enumerate(pixels):
            self.points.append((at, self.curves))
            self.boxes.append(Bbox.from_extents(at[0] - radius, at[1] - radius, at[0] + radius, at[1] + radius))
            ends = [axis.transData.transform((x, points[i][2])) for x in points[i][3]]
            self.boxes.append(Bbox.from_extents(ends[0][0], at[1] - radius / 2, ends[1][0], at[1] + radius / 2))
            low, high = (axis.transData.transform((points[i][1], y))[1] for y in points[i][4])
            if high > low:
                self.boxes.append(Bbox.from_extents(at[0] - radius / 2, low, at[0] + radius / 2, high))
            if i and pixels[i - 1][0] is axis:
                self.avoid_between(pixels[i - 1][1], at)
        self.curves += 1

    def avoid_front(self, points):
        """The same points once more, in the order of the line through them."""
        for one, two in zip(points, points[1:]):
            if one[0] is two[0]:
                self.avoid_between(*(axis.transData.transform((x, y)) for axis, x, y, _, _ in (one, two)))

    def avoid_between(self, before, at):
        steps = max(2, int(math.dist(before, at) / (3 * self.scale)))
        self.samples += [before + (at - before) * k / steps for k in range(1, steps)]

    def avoid_line(self, axis, y):
        (x0, x1), height = axis.get_window_extent(self.renderer).intervalx, axis.transData.transform((1, y))[1]
        self.samples += [(x, height) for x in np.arange(x0, x1, 8 * self.scale)]

    def avoid_texts(self, texts):
        self.boxes += [text.get_window_extent(self.renderer) for text in texts]

    def want(self, text, anchors, colour, size, weight, must):
        """`text` beside one of the anchors (as in avoid_curve), the first if nothing speaks against it. Unless it `must` be
        written, it is left out where it would cover anything or could be taken for another point's."""
        if text:
            self.wanted.append((Label(text, colour, size, weight, must), anchors))

    def write(self):
        """Writes the labels: required ones first, the rest into the space left."""
        self.fixed = np.array([box.extents for box in self.boxes]).reshape(-1, 4)
        self.line = np.array(self.samples).reshape(-1, 2)
        must = [self.with_places(label, anchors) for label, anchors in self.wanted if label.must]
        for _ in range(PASSES):
            moved = False
            for label in must:
                others = [other.taken for other in must if other is not label and other.taken]
                best = best_among(label.places, others, self.scale)
                moved, label.taken = moved or best is not label.taken, best
            if not moved:
                break
        placed = [self.put(label) for label in must]
        for label, anchors in self.wanted:
            if label.must:
                continue
            self.with_places(label, anchors)
            free = [place for place in label.places
                    if place[0] < 1 and among(place, placed, self.scale) < 1 and self.is_own(place)]
            if free:
                label.taken = free[0]
                placed.append(self.put(label))

    def column(self, entries):
        """Labels right of the curves' ends, one below the other in the ends' order. entries: (text, anchor, colour)."""
        ends = sorted(((axis.transData.transform((x, y)), text, colour) for text, (axis, x, y, *_), colour in entries),
                      key=lambda end: end[0][1])
        left = max(at[0] for at, _, _ in ends) + 20 * self.scale
        step = 15 * self.scale
        heights = spaced([at[1] for at, _, _ in ends], step, self.frame.y0 + step / 2, self.frame.y1 - step / 2)
        for (at, text, colour), height in zip(ends, heights):
            self.line_to((at[0] + 7 * self.scale, at[1]), (left - 3 * self.scale, height), colour)
            x, y = self.share((left, height))
            self.figure.text(x, y, text, ha="left", va="center", color=colour, fontsize=11.5, weight="bold", zorder=5,
                             gid="label")

    def with_places(self, label, anchors):
        """Measures the text once and lists its positions, each with its own cost."""
        sample = self.figure.text(0, 0, label.text, fontsize=label.size, weight=label.weight)
        extent = sample.get_window_extent(self.renderer)
        sample.remove()
        half = np.array([extent.width, extent.height * 0.9]) / 2  # without the room for accents
        for rank_of_anchor, (axis, x, y, *_) in enumerate(anchors):
            at = axis.transData.transform((x, y))
            found = []
            for radius in RADII if label.must else RADII[:2]:
                for rank, angle in enumerate(ANGLES):
                    u = np.array([math.cos(angle), math.sin(angle)])
                    reach = min(half[0] / max(abs(u[0]), 1e-9), half[1] / max(abs(u[1]), 1e-9))
                    centre = at + u * (radius * self.scale + reach)
                    rather = 0.006 * radius * (1 + 0.03 * radius) + 0.02 * rank + 0.15 * rank_of_anchor
                    found.append((np.concatenate([centre - half, centre + half]), rather, radius, u, reach))
            costs = self.costs(np.array([box for box, *_ in found])) + [rather for _, rather, *_ in found]
            for k in np.argsort(costs, kind="stable")[:TRIED]:
                box, _, radius, u, reach = found[k]
                leader, cost = None, float(costs[k])
                if radius > NEAR:
                    end = (box[:2] + box[2:]) / 2 - u * (reach + self.scale)
                    leader = np.linspace(at + u * POINT_RADIUS * self.scale, end, int(radius // 3) + 2)
                    cost += self.cost_of_line(leader, at)
                label.places.append((cost, Bbox.from_extents(*box), axis, (x, y), at, leader))
        label.places.sort(key=lambda place: place[0])
        return label

    def costs(self, boxes):
        """For each box (rows x0, y0, x1, y1) the cost of covered marks, and of leaving the panel; 0 if free."""
        around = boxes + np.array([-1.5, -1.5, 1.5, 1.5]) * self.scale
        x0, y0, x1, y1 = around.T
        frame = self.frame
        outside = (np.maximum(0, x1 - frame.x1) + np.maximum(0, frame.x0 - x0) + np.maximum(0, y1 - frame.y1) +
                   np.maximum(0, frame.y0 - y0))
        width = np.minimum(x1[:, None], self.fixed[:, 2]) - np.maximum(x0[:, None], self.fixed[:, 0])
        height = np.minimum(y1[:, None], self.fixed[:, 3]) - np.maximum(y0[:, None], self.fixed[:, 1])
        common = np.where((width > 0) & (height > 0), width * height, 0.0)
        covered = np.sum((common > 0) + common / ((x1 - x0) * (y1 - y0))[:, None], axis=1)
        x, y = self.line.T
        on_curve = (x > x0[:, None]) & (x < x1[:, None]) & (y > y0[:, None]) & (y < y1[:, None])
        return 10 * covered + 1.5 * np.sum(on_curve, axis=1) + 2 * outside

    def cost_of_line(self, leader, at):
        x, y = leader.T[:, :, None]
        on = (self.fixed[:, 0] < x) & (x < self.fixed[:, 2]) & (self.fixed[:, 1] < y) & (y < self.fixed[:, 3])
        on &= ~((self.fixed[:, 0] < at[0]) & (at[0] < self.fixed[:, 2]) & (self.fixed[:, 1] < at[1]) &
                (at[1] < self.fixed[:, 3]))  # marks at the point itself do not count
        cost = 0.5 + 1.5 * int(np.sum(on.any(axis=1)))
        if len(self.line):
            gaps = np.min(np.linalg.norm(self.line[None] - leader[:, None], axis=2), axis=1)
            cost += 0.3 * int(np.sum(gaps < 2 * self.scale))
        return cost

    def is_own(self, place):
        """True where no point of another curve could be meant."""
        _, box, _, _, at, _ = place
        centre = np.array([(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2])
        mine = {curve for pixel, curve in self.points if np.allclose(pixel, at)}
        reach = math.dist(centre, at) * OWN
        return all(curve in mine and math.dist(centre, pixel) >= math.dist(centre, at) - 1e-6
                   or math.dist(centre, pixel) > reach for pixel, curve in self.points)

    def put(self, label):
        _, box, axis, anchor, at, leader = label.taken
        offset = ((box.x0 + box.x1) / 2 - at[0]) / self.scale, ((box.y0 + box.y1) / 2 - at[1]) / self.scale
        axis.annotate(label.text, anchor, xytext=offset, textcoords="offset points", ha="center", va="center",
                      color=label.colour, fontsize=label.size, weight=label.weight, zorder=5, annotation_clip=False)
        if leader is not None:
            self.line_to(leader[0], leader[-1], label.colour)
        return label.taken

    def line_to(self, start, end, colour):
        (x0, y0), (x1, y1) = self.share(start), self.share(end)
        self.figure.add_artist(Line2D([x0, x1], [y0, y1], color=colour, linewidth=0.8, alpha=0.6, zorder=4.5))

    def share(self, pixel):
        """A pixel as shares of the figure, which hold for any resolution that it is saved in."""
        return self.figure.transFigure.inverted().transform(pixel)


def best_among(places, others, scale):
    """The cheapest position; positions are sorted by their own cost."""
    best, least = None, math.inf
    for place in places:
        if place[0] >= least:
            break
        cost = place[0] + among(place, others, scale)
        if cost < least:
            best, least = place, cost
    return best


def among(place, others, scale):
    """Cost of a position with labels at `others`."""
    _, box, _, _, _, leader = place
    padded, cost = box.padded(2 * scale), 0.0
    for _, other, _, _, _, line in others:
        cost += 20 * padded.overlaps(other)
        if line is not None:
            cost += 2 * int(np.sum(inside(padded, line)))
        if leader is not None:
            cost += 2 * int(np.sum(inside(other.padded(2 * scale), leader)))
        if leader is not None and line is not None:
            cost += 1.0 * bool(np.min(np.linalg.norm(line[None] - leader[:, None], axis=2)) < 3 * scale)
    return cost


def inside(box, points):
    if not len(points):
        return np.zeros(0, bool)
    return (points[:, 0] > box.x0) & (points[:, 0] < box.x1) & (points[:, 1] > box.y0) & (points[:, 1] < box.y1)


def spaced(heights, step, low, high):
    """Rising heights moved as little as possible so that neighbours are `step` apart, and kept between low and high where
    they fit: neighbours that would touch are moved as one, about their mean."""
    groups = []  # [sum of wished heights of the lowest, count]
    for i, height in enumerate(heights):
        groups.append([height, 1])
        while len(groups) > 1:
            (a, n), (b, m) = groups[-2:]
            if a / n + n * step <= b / m:
                break
            groups[-2:] = [[a + b - m * n * step, n + m]]
    found = []
    for total, count in groups:
        first = min(max(total / count, low), high - (count - 1) * step)
        first = max(first, found[-1] + step) if found else first
        found += [first + k * step for k in range(count)]
    return found
