"""A small study as tests of charts, verdicts and claims use it."""

import copy

from charts.study_file import Study


def point(scene, method, error, ms, knobs=None, **more):
    return {"scene": scene, "method": method, "knobs": knobs or {},
            "error": {"flip_mean": error, "flip_p99": 0.02, "nan": 0, "inf": 0},
            "time_ms": {"median": ms, "q1": ms * 0.9, "q3": ms * 1.2, "rounds": 9}, **more}


STUDY = {
    "chapter": "02_lambert_phong", "title": "Reflection", "subject": "frame", "device": "NVIDIA H200",
    "driver": "570", "stage": "fragment", "command": "./course study 02", "error_metric": "flip_mean",
    "time_unit": "ms", "truth": {"method": "supersampled", "knobs": {"samples": 64}, "doubling_change": 0.0005},
    "points": [point("bunny", "gouraud", 0.05, 0.1), point("bunny", "phong", 0.02, 0.2, {"samples": 1, "bias": 2}),
               point("bunny", "phong", 0.004, 0.8, {"samples": 4, "bias": 2}), point("bunny", "slow", 0.03, 1.0),
               point("bunny", "exact", 0, 4.0), point("bunny", "broken", None, 0.15)],
}


def study(**changes):
    return Study(copy.deepcopy(STUDY) | changes)


def over_lights(**changes):
    """Three scenes that set `lights`, and one that sets nothing."""
    points = [point("yard", "uncut", 0.01, 0.3), point("yard", "culled", 0.02, 0.2, {"threshold": 0.1})]
    for lights in (1, 10, 100):
        label = f"{lights} lights"
        points += [point(label, "uncut", 0, 0.1 * lights, {"lights": lights})]
        points += [point(label, "culled", threshold, 0.05 * lights / (1 + threshold),
                         {"lights": lights, "threshold": threshold}) for threshold in (0.01, 0.1)]
    for p in points[2:]:
        p["error"]["hit_texels"] = p["time_ms"]["median"] / 10
    scenes = {f"{n} lights": {"file": "x.json", "set": {"lights": n}, "one_step": {"flip_mean": 0.03 + n / 1e4},
                              "doubling": {"flip_mean": n / 1e4}} for n in (1, 10, 100)}
    charts = [{"name": "main"}, {"name": "lights", "title": "Time against lights", "x": "knob lights", "y": "time"},
              {"name": "threshold", "x": "knob threshold", "scenes": ["1 lights", "10 lights"]},
              {"name": "texels", "x": "hit_texels", "y": "time", "methods": ["culled"]},
              {"name": "errors", "x": "hit_texels", "y": "flip_mean"},
              {"name": "rule", "x": "knob lights", "x_scale": "linear"}]
    return study(**{"points": points, "scenes": scenes | {"yard": {"set": {}}}, "charts": charts, "size": [960, 540],
                    **changes})
