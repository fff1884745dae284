"""A built course of its first two chapters that a test may write to: an overlay over this tree, at its path, in a mount namespace of
the test's own. What is written is memory's, and gone with the process."""

import ctypes
import os
import re
import shutil
import subprocess
from pathlib import Path

from small_course import REAL

USER = 12345
KEPT = re.compile(r"0[0-2]a?_")  # of chapters and lessons


def run(*command):
    subprocess.run(command, check=True, cwd="/", stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def why_not() -> str:
    """Why there can be none here; empty where there can."""
    if not (REAL / ".git").exists() or os.environ.get("LIGHTWALK_BUILD", str(REAL / "build")) != str(REAL / "build"):
        return "it lays itself over a checkout with its build"
    done = subprocess.run(["unshare", "-m", "sh", "-c", "mount -t tmpfs tmpfs /mnt && cd /mnt && mkdir a b c d && "
                           "mount -t overlay -o lowerdir=a,upperdir=b,workdir=c,metacopy=on overlay d"], stderr=subprocess.PIPE, text=True)
    return f"no overlay can be mounted here: {done.stderr.strip()}" if done.returncode else ""


def enter() -> Path:
    """Lays it over REAL for this process and its children, as another user's. Returns a folder of that user's."""
    if ctypes.CDLL(None, use_errno=True).unshare(0x20000):  # CLONE_NEWNS
        raise OSError(ctypes.get_errno(), "unshare")
    os.chdir("/")
    run("mount", "--make-rprivate", "/")
    run("mount", "-t", "tmpfs", "-o", "mode=755", "tmpfs", "/mnt")
    compiled = Path(os.environ.get("CCACHE_DIR", Path.home() / ".cache/ccache"))
    compiled.mkdir(parents=True, exist_ok=True)
    for name, lower, over in (("tree", REAL, REAL), ("ccache", compiled, "/mnt/compiled")):
        for part in (f"{name}.new", f"{name}.work"):
            Path("/mnt", part).mkdir()
        Path(over).mkdir(exist_ok=True)
        run("mount", "-t", "overlay", "-o", f"lowerdir={lower},upperdir=/mnt/{name}.new,workdir=/mnt/{name}.work,metacopy=on", "overlay", over)
    mine = Path("/mnt/mine")
    mine.mkdir()
    cut()
    run("chown", "-R", f"{USER}:{USER}", REAL, "/mnt/compiled", mine)
    return mine


def git(*words):
    run("git", "-c", "safe.directory=*", "-C", REAL, "-c", "user.name=x", "-c", "user.email=x", *words)


def cut():
    """Later chapters and their lessons go, what tests of the rest build, and links to them lead elsewhere."""
    folders = ("chapters", "shaders", "tests", "docs", "docs/studies", "docs/studies/tables", "docs/images")
    for path in [path for name in folders for path in (REAL / name).glob("[0-9][0-9]*_*") if not KEPT.match(path.name)]:
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    for name in ("framework", "teaching"):
        (REAL / f"docs/{name}.md").unlink()
    for path in (REAL / "tests/common").glob("test_*.py"):
        path.write_text("# Builds: nothing\n")

    def led(link: re.Match) -> str:
        if (page.parent / link[1]).exists():
            return link[0]
        there = "tests/01_obj/golden/bunny.png" if link[1].endswith((".png", ".jpg")) else "LICENSE"
        return f"]({os.path.relpath(REAL / there, page.parent)})"
    for page in [REAL / "README.md", *(REAL / "docs").glob("*.md")]:
        page.write_text(re.sub(r"\]\(([^)#:\s]+)(#[^)\s]*)?\)", led, page.read_text()))
    (REAL / "chapters/02_lambert_phong/timings.json").write_text(
        '{"size": [96, 54], "frames": 3, "runs": [{"scene": "teapot", "knob": "method", "methods": ["phong", "blinn_phong"]}]}')
    study = REAL / "chapters/01_obj/study.json"
    study.write_text(study.read_text().replace('"assets/models/smart_car.obj", "assets/models/bunny.obj", ', "").replace("grid.obj", "small.obj").replace('"104"', '"1"'))
    stretch = REAL / "tests/02_lambert_phong/stretch.json"
    stretch.write_text(stretch.read_text().replace("statue", "teapot").replace("960x540", "96x54"))
    run(REAL / "course", "docs", "--quote")
    git("add", "-A")
    git("commit", "-qm", "cut")
