"""Verdicts on measured methods: the Pareto front, what is enough, the cheapest of that, what is dominated, and what cannot be
told apart. Charts, tables of advice (pages/advice.py), claims of lessons and tests ask here; common/study/cheapest.h is the
same choice for the need rule.

A point has a time (q1, median, q3) and errors. A limit is the error that is small enough in a metric, and nothing below it is
ranked: an error counts as its limit at least. Two errors differ where they are farther apart than the truth's doubt. Two times
differ where their quartiles do not overlap and their medians are more than AS_FAST apart.
"""

import math
from collections.abc import Callable, Iterable
from functools import cached_property

AS_FAST = 0.02  # times are known so well; cheapest.h has the same


class Verdict:
    """The points of one scene on one device. `limits` and `doubts`: by metric; the first metric is the main one."""

    def __init__(self, points: Iterable, limits: dict[str, float], doubts: dict[str, float] | None = None,
                 error_of: Callable = lambda point, metric: point.data["error"].get(metric), higher_is_faster: bool = False):
        self.limits, self.doubts = limits, doubts or {}
        self._error_of, self._higher = error_of, higher_is_faster
        self.points = [p for p in points if math.isfinite(self.time(p)[1]) and p.time[1] >= 0 and
                       all(math.isfinite(self.raw(p, metric)) for metric in limits)]

    def time(self, point) -> tuple[float, float, float]:
        """(q1, median, q3) of what is the less the better: of a throughput, its reciprocals."""
        if not self._higher:
            return point.time
        return tuple(1 / value if value else math.inf for value in reversed(point.time))

    def raw(self, point, metric: str) -> float:
        value = self._error_of(point, metric)
        return math.nan if value is None else float(value)

    def error(self, point) -> tuple[float, ...]:
        """The ranked errors: none is below its limit."""
        return tuple(max(self.raw(point, metric), limit) for metric, limit in self.limits.items())

    def is_enough(self, point) -> bool:
        return all(self.raw(point, metric) <= limit for metric, limit in self.limits.items())

    def faster(self, a, b) -> bool:
        """Beyond both quartiles."""
        return self.time(a)[2] < self.time(b)[0] and self.time(a)[1] * (1 + AS_FAST) < self.time(b)[1]

    def less_accurate(self, a, b) -> bool:
        """In one of the metrics, beyond the truth's doubt."""
        return any(one > other + self.doubts.get(metric, 0) * (1 + 1e-9)
                   for metric, one, other in zip(self.limits, self.error(a), self.error(b)))

    def more_accurate(self, a, b) -> bool:
        """In one of the metrics, and in none less."""
        return self.less_accurate(b, a) and not self.less_accurate(a, b)

    def dominates(self, a, b) -> bool:
        """Not slower and not less accurate, and one of them better. What is not among the best never stands for one of them."""
        if self.faster(b, a) or self.less_accurate(a, b) or (id(b) in self._best and id(a) not in self._best):
            return False
        return self.faster(a, b) or self.more_accurate(a, b)

    @cached_property
    def _best(self) -> set[int]:
        """Those that are enough; where none is, those whose error is not known to be larger than the smallest."""
        least = min(self.points, key=self.error, default=None)
        return {id(p) for p in self.enough or self.points if self.enough or not self.less_accurate(p, least)}

    def same(self, a, b) -> bool:
        """Not to be told apart, neither by time nor by error."""
        return not (self.faster(a, b) or self.faster(b, a) or self.less_accurate(a, b) or self.less_accurate(b, a))

    @property
    def front(self) -> list:
        """The points that none beats in both median time and ranked error, fastest first. Equal ones stay."""
        best = []
        for p in sorted(self.points, key=lambda p: (self.time(p)[1], self.error(p))):
            equal = best and (self.error(p), self.time(p)[1]) == (self.error(best[-1]), self.time(best[-1])[1])
            if not best or equal or self.error(p) < self.error(best[-1]):
                best.append(p)
        return best

    @property
    def enough(self) -> list:
        """Fastest first."""
        return sorted(filter(self.is_enough, self.points), key=lambda p: self.time(p)[1])

    @property
    def cheapest(self):
        """The fastest that is enough, and of those as fast the most accurate; None where none is enough."""
        as_fast = [p for p in self.enough if not any(self.faster(q, p) for q in self.enough)]
        return min(as_fast, key=lambda p: [self.raw(p, metric) for metric in self.limits], default=None)

    @property
    def most_accurate(self):
        """The fastest of those whose error is not known to be larger than the smallest."""
        return min((p for p in self.points if id(p) in self._best), key=lambda p: self.time(p)[1], default=None)

    @property
    def choice(self):
        """The cheapest that is enough; where none is, the most accurate."""
        return self.cheapest or self.most_accurate

    def dominator(self, point):
        """What dominates a point: the choice if it does, else the fastest that does; None for a point that nothing dominates."""
        by = [p for p in self.points if self.dominates(p, point)]
        return self.choice if self.choice in by else min(by, key=lambda p: self.time(p)[1], default=None)

    @property
    def dominated(self) -> list:
        return [p for p in self.points if self.dominator(p)]

    def like(self, point) -> list:
        """The others that cannot be told apart from it."""
        return [p for p in self.points if p is not point and self.same(p, point)]


def verdict_of(study, scene: str, points=None, metric: str | None = None, at: float | None = None) -> Verdict:
    """The verdict on a scene of a study, or on some of its points, by its own metric and one 8-bit step or another limit. A mean FLIP
    hides errors in few pixels, so that its 99th percentile must be below a step, too. Without a limit, as a metric of no picture, all is
    ranked."""
    metric = metric or study.metric
    has_p99 = metric == "flip_mean" and any("flip_p99" in p.data["error"] for p in study.points)
    limits = {metric: at} if at is not None else \
        {name: study.one_step(scene, name)[0] or 0.0 for name in ([metric, "flip_p99"] if has_p99 else [metric])}
    doubts = {name: study.doubling_change(scene, name) or 0.0 for name in limits}
    points = [p for p in study.points if p.scene == scene] if points is None else points
    return Verdict(points, limits, doubts, higher_is_faster=study.higher_is_faster)


def names_of(points: list) -> dict[int, str]:
    """Each point's name among others, by id(): its method, where there are several, and the knobs that differ within it."""
    several = len({p.method for p in points}) > 1
    names = {}
    for p in points:
        own = [q for q in points if q.method == p.method]
        differ = [knob for knob in dict.fromkeys(k for q in own for k in q.knobs)
                  if len({str(q.knobs.get(knob)) for q in own}) > 1 and knob in p.knobs]
        words = [f"{knob.partition('.')[2] or knob} {p.knobs[knob]:g}" if isinstance(p.knobs[knob], float)
                 else f"{knob.partition('.')[2] or knob} {p.knobs[knob]}" for knob in differ]
        if not several and len(differ) == 1 and isinstance(p.knobs[differ[0]], str):
            words = [p.knobs[differ[0]]]  # a knob that is the method by another name
        names[id(p)] = ", ".join([p.method] * (several or not differ) + words)
    return names
