#!/usr/bin/env python3
"""Times every blur of one bright pixel and prints a table: tests/08_bloom/measure_bloom.py [WxH] [FRAMES] [DEVICE]

GPU milliseconds of the pass "bloom blur", medians over FRAMES (21), methods interleaved in three rounds of which the least
counts. 1920x1080 unless it is said. Then what the lesson promises: the pyramid at sigma 32 against pingpong, and against
`copy`, which reads and writes each of its levels once; and from which radius on `shared` takes less time than `separable`.
Prints "missed" where a promise is not kept on this device, and asserts nothing.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
METHODS = ("copy", "pyramid", "dual_kawase", "three_pass_7tap", "shared", "paired", "separable", "pingpong")
SIGMAS = (1, 2, 4, 8, 16, 32, 64, 128)


def blur_ms(method, sigma, size, frames, device, folder):
    out = Path(folder) / "timings.json"
    command = [ROOT / "build/chapters/08_bloom", "--source", "spot", "--cut", "none", "--shape", "gaussian", "--method", method,
               "--sigma_px", sigma, "--size", size, "--frames", frames, "--timings", out]
    subprocess.run([str(word) for word in command + (["--device", device] if device else [])], cwd=ROOT, check=True,
                   stdout=subprocess.DEVNULL)
    found = json.loads(out.read_text())
    return next(one["gpu_ms"] for one in found["passes"] if one["name"] == "bloom blur"), found["device"], found["driver"]


def main():
    size, frames, device = (sys.argv[1:] + [None] * 3)[:3]
    size, frames = size or "1920x1080", int(frames or 21)
    ms = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(3):
            for sigma in SIGMAS:
                for method in METHODS:
                    one, name, driver = blur_ms(method, sigma, size, frames, device, folder)
                    ms[method, sigma] = min(one, ms.get((method, sigma), one))
    print(f"{size}, {name}, {driver}: ms of the blur")
    print(f"{'sigma':16}" + "".join(f"{sigma:>9}" for sigma in SIGMAS))
    for method in METHODS:
        print(f"{method:16}" + "".join(f"{ms[method, sigma]:9.3f}" for sigma in SIGMAS))
    faster, copies = ms["pingpong", 32] / ms["pyramid", 32], ms["pyramid", 32] / ms["copy", 32]
    print(f"sigma 32: pingpong takes {faster:.1f} times as long as the pyramid (promised: 20): {'kept' if faster >= 20 else 'missed'}")
    print(f"sigma 32: the pyramid takes {copies:.2f} times as long as one read and one write a level (promised: at most 2): "
          f"{'kept' if copies <= 2 else 'missed'}")
    wins = [sigma for sigma in SIGMAS if all(ms["shared", s] < ms["separable", s] for s in SIGMAS if s >= sigma)]
    print(f"shared takes less time than separable from sigma {wins[0]} on, a radius of {3 * wins[0]}" if wins
          else "shared is nowhere faster than separable")


if __name__ == "__main__":
    main()
