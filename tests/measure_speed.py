#!/usr/bin/env python3
"""Measures what a person waits for, and prints a table: tests/measure_speed.py [RUNS]

Whole processes on the software rasteriser or the device the driver offers, medians of RUNS (7) after one warm-up. It
asserts nothing: run it on an idle machine and compare. The edit is measured as a headless run with a changed shader,
recompiled; the window does the same work in a running process.
"""
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build"


def seconds(command, runs, prepare=None, **environment):
    taken = []
    for run in range(runs + 1):
        if prepare:
            prepare(run)
        start = time.perf_counter()
        subprocess.run([str(word) for word in command], cwd=ROOT, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, env=os.environ | environment)
        if run:
            taken.append(time.perf_counter() - start)
    return statistics.median(taken)


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "picture.png"
        overlay = Path(folder) / "shaders/02_lambert_phong/shade.frag"
        overlay.parent.mkdir(parents=True)
        source = (ROOT / "shaders/02_lambert_phong/shade.frag").read_text()
        one, two = BUILD / "chapters/01_obj", BUILD / "chapters/02_lambert_phong"

        def edit(run):
            overlay.write_text(f"{source}\n// edit {time.time()} {run}\n")

        rows = [
            ("warm screenshot, chapter 01, 960x540", [one, "--screenshot", picture], {}),
            ("warm screenshot, chapter 02, 960x540", [two, "--screenshot", picture], {}),
            ("the same with the other toggles", [two, "--use", "exercise", "--screenshot", picture], {}),
            ("the same after an edit of a shader", [two, "--screenshot", picture],
             {"prepare": edit, "LIGHTWALK_OVERLAY": folder}),
            ("./course run 01 --help, nothing changed", [ROOT / "course", "run", "01", "--help"], {}),
        ]
        for name, command, options in rows:
            print(f"{name:45} {seconds(command, runs, **options):6.2f} s", flush=True)


if __name__ == "__main__":
    main()
