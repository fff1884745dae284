"""The checks' last verdict on each exercise, valid while its file is unchanged."""

import hashlib
import json

from check.starters import digest, untouched
from tree import BUILD, chapters, exercises, write_atomically


def version(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()[:16]


class Verdicts:
    def __init__(self):
        self.path = BUILD / "live" / "verdicts.json"
        try:
            self.known = json.loads(self.path.read_text(encoding="utf-8"))
            if not isinstance(self.known, dict):
                raise ValueError
        except (OSError, ValueError, RecursionError):
            self.known = {}

    def keep(self, exercise: str, of: str, result: dict):
        """`of`: the digest of the file that was checked, by which windows find the verdict, too."""
        self.known[exercise] = {"of": of, "ok": result["ok"]}
        write_atomically(self.path, json.dumps(self.known))

    def is_solved(self, exercise: str, path) -> bool | None:
        """None where the file has not been checked."""
        said = self.known.get(exercise)
        if not isinstance(said, dict) or said.get("of") != digest(path.read_bytes()):
            return None
        return said.get("ok") is True

    def progress(self) -> dict:
        """By chapter: how many exercises there are, which are solved, and which are as they were handed out."""
        new = untouched()
        return {chapter: {"exercises": len(files), "solved": [name for name, path in files.items() if self.is_solved(name, path)],
                          "untouched": [name for name in files if name in new]}
                for chapter in chapters() if (files := exercises(chapter))}
