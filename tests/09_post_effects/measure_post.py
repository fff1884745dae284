#!/usr/bin/env python3
"""Times the stack of effects: tests/09_post_effects/measure_post.py [--size WxH] [--frames N] [--device NAME]

One line for each number of effects, 1 to 16: milliseconds of all passes of the module `post` together, fused and one pass each
(with floats between the passes, and with half floats). The least of three rounds' medians, methods in turn. Above them `copy`,
one read and one write of the picture; below, what chapter 09 promises, kept or missed on this device. Asserts nothing.
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COUNTS = (1, 2, 4, 8, 12, 14, 16)
WAYS = {"fused": ["fused", "float"], "each, float": ["pass_each", "float"], "each, half": ["pass_each", "half"]}


class Stopwatch:
    def __init__(self, arguments, folder):
        self.out = Path(folder) / "post.json"
        self.options = ["--source", "chart", "--size", arguments.size, "--frames", str(arguments.frames), "--timings", str(self.out)]
        if arguments.device:
            self.options += ["--device", arguments.device]
        self.least, self.device = {}, ""

    def __call__(self, method, store, effects):
        subprocess.run([ROOT / "build/chapters/09_post_effects", *self.options, "--post.method", method, "--post.store", store,
                        "--effects", str(effects)], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        run = json.loads(self.out.read_text())
        self.device = f"{run['device']}, {run['driver']}"
        ms = sum(step["gpu_ms"] for step in run["passes"] if step["name"].startswith("post"))
        key = method, store, effects
        self.least[key] = min(ms, self.least.get(key, ms))


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--size", default="1920x1080")
    parser.add_argument("--frames", type=int, default=21)
    parser.add_argument("--device")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        watch = Stopwatch(arguments, folder)
        for _ in range(3):
            watch("copy", "float", 14)
            for effects in COUNTS:
                for method, store in WAYS.values():
                    watch(method, store, effects)
    copy = watch.least["copy", "float", 14]
    print(f"{arguments.size}, {watch.device}\none read and one write of the picture: {copy:.4f} ms\n{'effects':>8}"
          + "".join(f"{way:>14}" for way in WAYS))
    for effects in COUNTS:
        print(f"{effects:8}" + "".join(f"{watch.least[(*way, effects)]:14.4f}" for way in WAYS.values()))
    fused, each, half = (watch.least[(*way, 12)] for way in WAYS.values())
    for words, figure, kept in (
            ("all 14 that need their pixel alone, over one read and one write (promised: at most 1.5)",
             watch.least["fused", "float", 14] / copy, watch.least["fused", "float", 14] <= 1.5 * copy),
            ("12 effects, a pass each over fused (promised: at least 5)", each / fused, each >= 5 * fused),
            ("the same with half floats between the passes", half / fused, half >= 5 * fused)):
        print(f"{words}: {figure:.2f}, {'kept' if kept else 'missed'}")


if __name__ == "__main__":
    main()
