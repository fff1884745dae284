"""Packages of npm that tests use: tests/package.json and its lock file, installed once into build/npm."""

import fcntl
import functools
import os
import shutil
import subprocess
from pathlib import Path

LISTED = Path(__file__).resolve().parents[1]
FOLDER = Path(os.environ.get("LIGHTWALK_BUILD", LISTED.parent / "build")) / "npm"


@functools.cache
def why_not(package: str) -> str:
    """Why a package cannot be used here, which is a reason to skip a test; empty where it is there."""
    if not shutil.which("node") or not shutil.which("npm"):
        return f"there is no npm, which installs {package}"
    FOLDER.mkdir(parents=True, exist_ok=True)
    with open(FOLDER / ".lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not is_installed():
            for name in ("package.json", "package-lock.json"):
                shutil.copyfile(LISTED / name, FOLDER / name)
            done = subprocess.run(["npm", "ci", "--no-audit", "--no-fund", "--fetch-retries=0"], cwd=FOLDER, capture_output=True, text=True)
            if done.returncode:
                return f"npm cannot install {package}: {(done.stderr.strip().splitlines() or ['it said nothing'])[0]}"
    return ""


def is_installed() -> bool:
    """npm notes the packages that it installed."""
    note = FOLDER / "node_modules" / ".package-lock.json"
    return note.exists() and note.stat().st_mtime > (LISTED / "package-lock.json").stat().st_mtime
