#!/usr/bin/env python3
"""Times skin's passes and says which promises hold: tests/12_skin/measure_skin.py [DEVICE] [FRAMES] [--truth]

GPU milliseconds by pass at 1920x1080, the least of three medians over FRAMES (31): `separable` near and very near, six
Gaussians on a map of 2048 texels, and on the map that a head of 100 pixels gets; with --truth `exact` too, which takes minutes. Asserts nothing.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PASSES = ("skin irradiance", "skin blur", "skin sum", "skin exact", "skin", "skin separable")
RUNS = {
    "lambert": {"method": "lambert"},
    "preintegrated": {"method": "preintegrated"},
    "separable": {"method": "separable"},
    "separable, very near": {"method": "separable", "dolly": 0.4},
    "gaussians_2, 2048": {"method": "gaussians_2", "map_size": 2048},
    "gaussians_6, 2048": {"method": "gaussians_6", "map_size": 2048},
    "gaussians_6, as needed": {"method": "gaussians_6"},
    "gaussians_6, 100 pixels": {"method": "gaussians_6", "dolly": 8.6},
}
TRUTH = {"exact, 2048": {"method": "exact", "map_size": 2048}}


def timings(knobs, frames, device):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "timings.json")
        words = [ROOT / "build/chapters/12_skin", "--size", "1920x1080", "--frames", frames, "--timings", out]
        words += [word for name, value in knobs.items() for word in (f"--{name}", value)]
        subprocess.run(list(map(str, words + (["--device", device] if device else []))), check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
        return json.loads(out.read_text())


def main(device="", frames=31, *, truth=False):
    runs = RUNS | (TRUTH if truth else {})
    least = {run: {} for run in runs}
    for _ in range(3):
        for run, knobs in runs.items():
            found = timings(knobs, frames, device)
            for one in found["passes"]:
                ms = least[run].get(one["name"], one["gpu_ms"])
                least[run][one["name"]] = min(ms, one["gpu_ms"])
    print(f"{found['device']}, {found['driver']}, 1920x1080: ms")
    print(f"{'':26}" + "".join(f"{name:>16}" for name in PASSES))
    for run, passes in least.items():
        print(f"{run:26}" + "".join(f"{passes[name]:16.3f}" if name in passes else " " * 16 for name in PASSES))
    blurs = [least[run]["skin blur"] + least[run]["skin sum"] for run in ("gaussians_6, 2048", "gaussians_6, 100 pixels")]
    for what, ms, most in (("separable", least["separable"]["skin separable"], 0.2), ("six Gaussians at 2048", blurs[0], 1.0),
                           ("six Gaussians for a head of 100 pixels, over those at 2048", blurs[1] / blurs[0], 0.1)):
        print(f"{what}: {ms:.3f} (promised: below {most}): {'kept' if ms < most else 'missed'}")


if __name__ == "__main__":
    main(*[word for word in sys.argv[1:] if word != "--truth"], truth="--truth" in sys.argv)
