"""Each chapter's default methods are not dominated in its own scene, on any device, or the question's "default" in study.json says
why, by a claim or by taste. No better value of a knob makes an error larger in any study, or "unsteady" says why, by knob.
"""
# Builds: 01_obj 02_lambert_phong 03_attenuation 04_surface_maps 05_shadow_maps 06_deferred 07_mipmaps 08_bloom 09_post_effects 10_atmosphere 11_fractals 12_skin 13_mlaa 14_environment 15_terrain_water 16_volume 17_planets 18_playground 19_ambiance

import functools
import json
import re
import subprocess
import unittest

from charts import measured
from charts.study_file import load
from charts.verdict import verdict_of
from pages import advice, claims
from tree import BUILD, ROOT


@functools.cache
def program(chapter: str) -> tuple[str, dict]:
    """The default scene, and every knob's default by its long and its short name."""
    path = str(BUILD / "chapters" / chapter)
    help_text = subprocess.run([path, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout
    listed = json.loads(subprocess.run([path, "--list", "knobs", "--json"], stdout=subprocess.PIPE, text=True, check=True).stdout)
    values = {knob["name"]: knob["default"] for knob in listed}
    short = {b: values[a] for a, b in re.findall(r"--([\w.]+),--([\w.]+) ", help_text) if a in values}
    scene = re.search(r"--scene FILE .*?\((\S+)\)", help_text)
    values = short | values
    own = json.loads((ROOT / "assets" / scene[1]).read_text()) if scene and scene[1].endswith(".json") else {}
    return (f"assets/{scene[1]}" if scene else ""), values | own.get("knobs", {})


def method_knob(study) -> str:
    return study.data.get("method_knob") or ("loader" if study.data["subject"] == "loader" else "method")


def is_default(study, point, values: dict) -> bool:
    """Whether the method and all choices of a point are the program's."""
    set_by_scene = study.set_by(point.scene)
    choices = {name: value for name, value in point.knobs.items() if isinstance(value, str) and name not in set_by_scene}
    return point.method == values.get(method_knob(study), point.method) and \
        all(values.get(name) in (None, value, {"on": True, "off": False}.get(value)) for name, value in choices.items())


COUNTS = re.compile(r"(samples|steps|taps|slices|octaves|reach|resolution|table_scale|frames|levels|bits)$")
FINENESS = re.compile(r"(epsilon_m|footprint|shortest_px|step_m)$")


def towards(name: str, said: str) -> str:
    """Which values of a knob are the better ones. What counts, and what is a fineness, has some, whatever a request says."""
    if said != "either":
        return said
    return "higher" if COUNTS.search(name) else "lower" if FINENESS.search(name) else ""


def unsteady(request: str) -> dict[str, str]:
    return json.loads((ROOT / request).read_text()).get("unsteady", {})


class Defaults(unittest.TestCase):
    maxDiff = None

    def test_default_methods_are_not_dominated(self):
        wrong, excused = [], set()
        for question in advice.questions().values():
            file, values = program(question.chapter)
            for study in question.studies:
                files = {scene: entry.get("file") for scene, entry in study.data.get("scenes", {}).items()}
                own = [scene for scene in question.scenes() if files.get(scene) == file]
                lost = []
                for scene in own or question.scenes():
                    verdict = question.verdict(study, scene)
                    mine = [p for p in verdict.points if is_default(study, p, values)]
                    if mine:
                        lost.append(all(verdict.dominator(p) for p in mine))
                if lost and (any(lost) if own else all(lost)):
                    excused.add(question.entry["id"])
                    why = question.entry.get("default", "")
                    bound = [match["claim"] for match in claims.CLAIM.finditer(why)]
                    if not bound and not why.startswith("Taste: ") or any(map(claims.fault_of, bound)):
                        wrong.append(f"{question.entry['id']}: the default is dominated {'in its own scene' if own else 'in every scene'} on "
                                     f"{study.data['device']}; \"default\" of study.json says why, or another value is the default")
        said = {name for name, question in advice.questions().items() if "default" in question.entry}
        self.assertEqual(sorted(wrong), [])
        self.assertEqual(said - excused, set(), "no default is dominated there; take the line away")


class Convergence(unittest.TestCase):
    maxDiff = None

    def test_better_values_make_no_error_larger(self):
        """Higher ones, unless study.json says "lower", or "either" of a knob that counts nothing. And no study has a pixel that is
        NaN or infinite."""
        wrong, excused, requests = [], set(), set()
        for path in sorted((ROOT / "docs/studies").glob("*.json")):
            request = measured.request_of(json.loads(path.read_text()))
            if not (ROOT / request).exists():
                continue
            requests.add(request)
            study, why = load(path), unsteady(request)
            stated = json.loads((ROOT / request).read_text()).get("better", {})
            better = {name: towards(name, stated.get(name, "higher")) for p in study.points for name in p.knobs}
            wrong += [f"{path.name}: {p.scene}, {p.method}: {p.nan} NaN, {p.inf} infinite" for p in study.points if p.nan or p.inf]
            for scene in study.scenes:
                verdict = verdict_of(study, scene)
                lines: dict[tuple, list] = {}
                for p in verdict.points:
                    for name, value in p.knobs.items():
                        if isinstance(value, (int, float)) and (name in why or better[name]):
                            others = tuple(sorted((k, str(v)) for k, v in p.knobs.items() if k != name))
                            lines.setdefault((p.method, name, others), []).append(p)
                for (method, name, _), points in lines.items():
                    points.sort(key=lambda p: p.knobs[name], reverse=better[name] == "lower")
                    for before, after in zip(points, points[1:]):
                        if verdict.less_accurate(after, before):
                            if name in why:
                                excused.add((request, name))
                            else:
                                wrong.append(f"{path.name}: {scene}, {method}: {name} {before.knobs[name]} to {after.knobs[name]}: "
                                             f"{', '.join(f'{m} {verdict.raw(before, m):.4g} to {verdict.raw(after, m):.4g}' for m in verdict.limits)}")
        said = {(request, name) for request in requests for name in unsteady(request)}
        self.assertEqual(wrong, [], "a better value makes it worse; \"better\" or \"unsteady\" of study.json says why")
        self.assertEqual(said - excused, set(), "no error grows there; take the line away")
