"""A frame releases its memory: a window is open for hours. Each chapter draws a few frames and many, and the peak memory
of both runs is compared."""
import os
import subprocess
import unittest
from pathlib import Path

from folder_case import FolderCase
from picture_drawing import BUILD, BUILT, CHAPTERS, ROOT

FEW, MANY = 8, 40
TRIED = [name for name in CHAPTERS if name[:2] in ("10", "14", "15", "18")]  # with an earlier leak
BOUND_MB = 0.8  # a frame


def most_memory_mb(chapter: str, frames: int, picture: Path) -> float:
    program = subprocess.Popen([BUILD / "chapters" / chapter, "--screenshot", picture, "--size", "32x24", "--frames", str(frames)],
                               cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(program.pid, 0)
    program.returncode = os.waitstatus_to_exitcode(status)
    if program.returncode != 0:
        raise AssertionError(f"{chapter}: exit code {program.returncode}")
    return usage.ru_maxrss / 1024.0


def kept_mb(chapter: str, picture: Path) -> float:
    """Memory kept by frames, and noise: starting and compiling shaders differs by up to 30 MB from run to run."""
    few, many = (most_memory_mb(chapter, frames, picture) for frames in (FEW, MANY))
    return (many - few) / (MANY - FEW)


@unittest.skipUnless(BUILT, "the chapters are not built")
@unittest.skipIf("LSAN_OPTIONS" in os.environ, "a sanitizer keeps what was freed")
class MemoryTest(FolderCase):
    def test_frames_keep_nothing(self):
        for chapter in TRIED:
            with self.subTest(chapter=chapter):
                self.assertTrue(any(kept_mb(chapter, self.folder / "picture.png") < BOUND_MB for _ in range(3)),
                                f"at least {BOUND_MB} MB a frame, three times of three")
