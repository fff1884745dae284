"""A class for the tests of ./course grade: students with answers in a folder, judged once for all tests.

python3 tests/common/graded_class.py [NN ...] judges a right answer to every exercise of these chapters (all): after a change of
a check it says whether grading still takes what is right. A C++ exercise that cannot be called in another process needs a
TRIAL (common/check/trial.h).
"""

import resource
import sys
import tempfile
import unittest
from pathlib import Path

REAL = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REAL / "common/course"))
from grading import sandbox  # noqa: E402
from grading.grade import grade  # noqa: E402
from grading.judge import Judge  # noqa: E402
from grading.submission import find  # noqa: E402
from tree import Failure, chapters, exercises, find_chapter  # noqa: E402
from check.variants import handed_in  # noqa: E402

CHAPTERS = ("01_obj", "02_lambert_phong", "03_attenuation")
OF = {exercise: chapter for chapter in chapters() for exercise in exercises(chapter)}
PLACES = {exercise: str(exercises(chapter)[exercise].relative_to(REAL)) for exercise, chapter in OF.items()}


def why_not() -> str:
    """Why nothing can be contained on this machine; empty where it can."""
    try:
        sandbox.require()
    except Failure as failure:
        return str(failure)
    return ""


def right(exercise: str, place: str = "") -> str:
    """An answer that is right: the reference, as a student would write it."""
    place = REAL / (place or PLACES[exercise]).replace("/exercise/", "/solution/")
    return handed_in(place.read_text(encoding="utf-8"))


def begins(text: str, name: str, with_: str) -> str:
    """C++ or GLSL whose exercise begins in another way."""
    at = text.index("{\n", text.rindex(f" {name}("))
    return text[:at] + with_ + text[at + 2:]


@unittest.skipIf(why_not(), why_not())
class Class(unittest.TestCase):
    """Subclasses fill `folder` in fill() and read `grades`, by student."""

    wanted = [exercise for exercise, chapter in OF.items() if chapter in CHAPTERS]
    pictures = False

    @classmethod
    def setUpClass(cls):
        cls.outside = Path(cls.enterClassContext(tempfile.TemporaryDirectory())).resolve()
        cls.folder = cls.outside / "class"
        cls.folder.mkdir()
        cls.fill()
        with Judge({name: OF[name] for name in cls.wanted}, 2, cls.pictures) as judge:
            judge.verdicts = cls.outside / "verdicts"
            cls.judges_are_built()
            cls.grades = {one["student"]: one for one in grade(find([cls.folder]), judge)}

    @classmethod
    def fill(cls):
        raise NotImplementedError

    @classmethod
    def judges_are_built(cls):
        """Called before the first answer is judged."""

    @classmethod
    def student(cls, name: str, answers: dict[str, str | bytes]) -> Path:
        for exercise, text in answers.items():
            path = cls.folder / name / PLACES[exercise]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text.encode() if isinstance(text, str) else text)
        return cls.folder / name

    def result(self, student: str, exercise: str) -> dict:
        return next(one for one in self.grades[student]["results"] if one["exercise"] == exercise)


def processor_s() -> float:
    """Of this process and its finished children."""
    return sum(used.ru_utime + used.ru_stime for used in map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))


def main(words: list[str]) -> int:
    """Prints the measured cost; exit code 1 if a right answer is refused."""
    wanted = {exercise: chapter for chapter in ([find_chapter(word) for word in words] or chapters())
              for exercise in exercises(chapter)}
    with tempfile.TemporaryDirectory() as made:
        for chapter in set(wanted.values()):
            for exercise, path in exercises(chapter).items():
                place = path.relative_to(REAL)
                (Path(made) / place).parent.mkdir(parents=True, exist_ok=True)
                (Path(made) / place).write_text(right(exercise, str(place)))
        with Judge(wanted) as judge:
            for exercise in wanted:  # once for a class
                judge.pictures.references(exercise)
            before_s = processor_s()
            [one] = grade(find([Path(made)]), judge)
    print(f"{processor_s() - before_s:.1f} s of processor time for {len(wanted)} answers, where none was judged before")
    for result in one["results"]:
        print("ok  " if result["ok"] else "open", result["exercise"], result["first_failure"] or "")
    return 0 if one["right"] == one["of"] else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
