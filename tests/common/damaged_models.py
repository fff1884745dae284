#!/usr/bin/env python3
"""Models that are damaged: damaged_models.py [COUNT [SEED]]

Writes one model in every format that a scene may name (with Debian's assimp, package assimp-utils), damages each file
COUNT (100) times, and loads what is left with chapter 01, each OBJ with all its loaders. A file is read, or refused
with one line, code 2 and within 30 s; whatever else happens is a finding: it is printed, and its file is kept in
build/damaged_models. The same seed makes the same files. Exit code 1 where there is one.
"""
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("LIGHTWALK_BUILD", ROOT / "build"))
CHAPTER = BUILD / "chapters" / "01_obj"
# Those of assimp's exporters with a format that a scene may name, and their file's ending. Its binary FBX is not
# among them: assimp 5.2.5 cannot read its own output.
EXPORTS = {"gltf2": "gltf", "glb2": "glb", "ply": "ply", "plyb": "ply", "stl": "stl", "stlb": "stl", "collada": "dae",
           "fbxa": "fbx", "3ds": "3ds", "obj": "obj"}
LOADERS = {"obj": ("textbook", "scan", "parallel", "tinyobjloader", "assimp")}
TIMEOUT_S = 30
NUMBERS = [b"0", b"-1", b"1e30", b"nan", b"65536", b"4294967295", b"99999999999999999999", b""]


def sources(folder: Path) -> dict[str, bytes]:
    """The same small model in each format."""
    files = {"off.off": b"OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n"}
    (folder / "off.off").write_bytes(files["off.off"])
    for kind, ending in EXPORTS.items():
        file = folder / f"{kind}.{ending}"
        subprocess.run(["assimp", "export", ROOT / "assets/models/suzanne_family.glb", file, f"-f{kind}"], check=True,
                       stdout=subprocess.DEVNULL)
        files[file.name] = file.read_bytes()
    return files


def damaged(data: bytes, rng: random.Random) -> bytes:
    """One fault or a few, most of them near the beginning, where the lengths are."""
    out = bytearray(data)
    for _ in range(rng.choice([1, 1, 1, 2, 8])):
        at = rng.randrange(min(len(out), rng.choice([64, 1024, 1 << 30]))) if out else 0
        kind = rng.randrange(7)
        if kind == 0:
            out[at:at + 1] = bytes([rng.randrange(256)])
        elif kind == 1:
            out[at:at + 4] = rng.choice([b"\xff\xff\xff\xff", b"\0\0\0\0", b"\xff\xff\xff\x7f", b"\0\0\0\x80"])
        elif kind == 2:
            del out[at:]
        elif kind == 3:
            del out[at:at + rng.randint(1, 64)]
        elif kind == 4:
            out[at:at] = out[at:at + rng.randint(1, 4096)]
        elif kind == 5:
            out[at:at] = bytes(rng.randrange(256) for _ in range(rng.randint(1, 16)))
        else:
            numbers = list(re.finditer(rb"-?\d+(\.\d+)?", out[at:at + 4096]))
            if numbers:
                begin, end = rng.choice(numbers).span()
                out[at + begin:at + end] = rng.choice(NUMBERS)
    return bytes(out)


def load(file: Path, loader: str | None) -> str:
    """'read', 'refused', or the fault."""
    command = [CHAPTER, "--dump-mesh", file, *(("--loader", loader) if loader else ())]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=TIMEOUT_S)
    except subprocess.TimeoutExpired:
        return f"hangs: {' '.join(map(str, command))}"
    errors = [line for line in done.stderr.splitlines() if not line.startswith("warning: ")]
    if done.returncode == 0 and not errors:
        return "read"
    if done.returncode == 2 and len(errors) == 1 and errors[0].startswith(f"error: {file}"):
        contained = re.search(r"crashed on it|needs more than|takes more than|without an answer", errors[0])
        return f"refused, {contained[0]}" if contained else "refused"
    return f"code {done.returncode}, {errors}: {' '.join(map(str, command))}"


def main(count=100, seed=1) -> int:
    if not shutil.which("assimp"):
        print("damaged_models: no assimp; apt install assimp-utils", file=sys.stderr)
        return 2
    kept, counts = BUILD / "damaged_models", Counter()
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        files = sources(Path(folder))
        jobs = [(name, Path(folder, name), pool.submit(load, Path(folder, name), None)) for name in files]
        for name, data in files.items():
            for number in range(count):
                file = Path(folder, f"{seed}_{number}_{name}")
                file.write_bytes(damaged(data, random.Random(f"{seed} {number} {name}")))
                loaders = LOADERS.get(name.rpartition(".")[2], (None,))
                jobs += [(name, file, pool.submit(load, file, loader)) for loader in loaders]
        for name, file, job in jobs:
            ending = job.result()
            whole = file.name == name
            finding = ending != "read" if whole else not ending.startswith(("read", "refused"))
            counts[name, "FINDING" if finding else ending] += 1
            if finding:
                kept.mkdir(exist_ok=True)
                shutil.copy(file, kept)
                print(ending, flush=True)
    for (name, ending), many in sorted(counts.items()):
        print(f"{name:16} {ending:32} {many}")
    findings = sum(many for (_, ending), many in counts.items() if ending == "FINDING")
    print(f"{sum(counts.values())} runs, {findings} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
