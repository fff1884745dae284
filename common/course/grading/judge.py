"""Judges one exercise of a submission: compiles it and runs it in a sandbox, and compares outside.

A student's C++ becomes a process of its own, serve_NN (common/judge/serve.h), in a sandbox that holds neither a check nor
a reference nor the truth. judge_NN, this chapter's checks, asks it for one value after the other and decides; each
question has a number that the answer must repeat. A student's GLSL is data that judge_NN compiles and runs, in a sandbox
from which that exercise's reference is missing. The random inputs of the checks are shifted by a seed that is drawn for
the class, and judge_NN's own line is known by a word that is drawn for the run.

No verdict without a control. Before the first verdict on an exercise in a run, its reference passes and its starter fails by the
same path: compiler, sandbox, driver, limits. A tool's failure is no verdict either: where a process ended, was late or was not
started, the control runs again, and then the answer once more, alone. If the control fails, this machine cannot judge the
exercise; if only the answer fails again, the failure is its own, and one that was killed is for a person to look at.
"""

import contextlib
import hashlib
import json
import os
import secrets
import shlex
import signal
import subprocess
import tempfile
import threading
import time
from pathlib import Path

from build.build import build
from check.glsl_answer import Refused, plain
from check.variants import handed_in
from grading import sandbox
from grading.handout import starters
from grading.judge_compile import compile_answer
from grading.judge_picture import EXPECTED, NOT_IN_TIME, THEIRS, DriverEnded, Pictures, ToolFailed
from grading.judge_tree import KEPT, copy_without_answers, library, objects
from grading.sandbox import Limits, Mounts
from grading.submission import printable
from tree import BUILD, LIBRARIES, ROOT, Failure, Unjudged, exercises, shader_files, sources, unjudged, write_atomically

GIB = 1 << 30
JUDGE_S = 60  # of a whole check; a call that does not return is found before
FREE_S = 15  # per exercise, of its sandboxes; time beyond that counts against a student's budget
BUDGET_S = 600
TRIES_S = (0, 1, 5, 15)  # waits before retries after a machine fault
NOT_LOOKED_FOR = "its numbers are right, and operations that GLSL leaves undefined were not looked for in it"
CALL_S = 5  # of one call
MOST_AT_ONCE = 8  # verdicts
WORDS_MOST = 600
NOT_DRAWN = "its numbers are right, and there is no picture"
counted = threading.local()  # .seconds: what the verdict that this thread is on has taken


def targets(chapters: list[str]) -> list[str]:
    return ["serve_main", *[f"{side}_{chapter}" for side in ("judge", "serve") for chapter in chapters]]


def picture_path(digest: str) -> Path:
    return KEPT / "seen" / f"{digest}.png"


def starters_of(wanted: dict[str, str]) -> dict[str, bytes]:
    """The exercises of all chapters of `wanted` (chapter by exercise), as they are handed out."""
    paths = {name: path for chapter in sorted(set(wanted.values())) for name, path in exercises(chapter).items()}
    committed = starters([path.relative_to(ROOT) for path in paths.values()])
    return {name: committed.get(path.relative_to(ROOT), path.read_bytes()) for name, path in paths.items()}


class Turns:
    """Verdicts side by side, at most MOST_AT_ONCE, or one of them alone."""

    def __init__(self):
        self.gate, self.places = threading.Lock(), threading.Semaphore(MOST_AT_ONCE)

    @contextlib.contextmanager
    def with_others(self):
        with self.gate:
            self.places.acquire()
        try:
            yield
        finally:
            self.places.release()

    @contextlib.contextmanager
    def alone(self):
        with self.gate, contextlib.ExitStack() as all_places:
            for _ in range(MOST_AT_ONCE):
                all_places.enter_context(self.places)
            yield


class Judge:
    """Shared state for all students. Raises Unjudged if nothing can be contained here."""

    broken = False  # a control failed in this run, each time that it was tried
    fresh = frozenset()  # exercises to judge again despite a known verdict

    def __init__(self, wanted: dict[str, str], call_s: int = CALL_S, pictures: bool = True):
        self.wanted, self.call_s = wanted, call_s  # chapter by exercise
        self.chapters = sorted(set(wanted.values()))
        sandbox.require()
        build(targets(self.chapters))
        self.folder = BUILD / "grade"
        self.verdicts = KEPT / "verdicts"
        self.paths = {name: path for chapter in self.chapters for name, path in exercises(chapter).items()}
        self.names = {str(path.relative_to(ROOT)): name for name, path in self.paths.items()}
        self.starters = starters_of(wanted)
        commands = json.loads((BUILD / "compile_commands.json").read_text(encoding="utf-8"))
        self.commands = {entry["file"]: shlex.split(entry["command"]) for entry in commands}
        self.seed = self.draw_seed()
        self.versions = {chapter: self.version(chapter, pictures) for chapter in self.chapters}
        self.pictures = Pictures(wanted, self.versions) if pictures else None
        self.kept = contextlib.ExitStack()
        self.running, self.stopped = set(), False
        self.budget_s, self.spent, self.lock = BUDGET_S, {}, threading.Lock()
        self.turns, self.controlled = Turns(), {name: [threading.Lock(), False] for name in self.wanted}

    def __enter__(self):
        # Files copied and drawn here are read by root's replacement user in the sandbox.
        self.kept.callback(os.umask, os.umask(0o022))
        self.tree = Path(self.kept.enter_context(tempfile.TemporaryDirectory(prefix="lightwalk.grade.")))
        sandbox.require_readable([*LIBRARIES, *[self.folder / f"judge_{name}" for name in self.chapters]])
        copy_without_answers(self.tree, {path: self.starters[name] for name, path in self.paths.items()})
        self.libraries = {chapter: library(self.tree, chapter) for chapter in self.chapters
                          if (BUILD / f"libchapter_{chapter}.a").exists()}
        return self

    def __exit__(self, *_):
        self.kept.close()

    def stop(self):
        self.stopped = True
        for one in list(self.running):
            one.kill()

    @contextlib.contextmanager
    def started(self, *arguments, **options):
        if self.stopped:
            raise Failure("grading was stopped")
        running = sandbox.Running(*arguments, **options)
        self.running.add(running)
        try:
            if self.stopped:  # just now
                running.kill()
            yield running
        finally:
            self.running.discard(running)
            running.close()
            counted.seconds = getattr(counted, "seconds", 0) + running.seconds

    def draw_seed(self) -> int:
        """Drawn once for a class: with another one results would be another's."""
        path = self.folder / "seed"
        if not path.exists():
            own = path.with_name(f"seed.{os.getpid()}")
            write_atomically(own, f"{1 + secrets.randbelow(1 << 31)}\n", 0o600)
            with contextlib.suppress(FileExistsError):  # of two gradings that begin at once the first draws for both
                os.link(own, path)
            own.unlink()
        return int(path.read_text(encoding="utf-8"))

    def version(self, chapter: str, with_pictures: bool) -> str:
        """A hash of everything that affects verdicts of this chapter, except for the submission."""
        paths = [self.folder / f"judge_{chapter}", *LIBRARIES, *sources(ROOT / "common/course", "**/*.py"),
                 *shader_files(), *sorted(objects(f"serve_{chapter}"))]
        stats = [(str(path), path.stat().st_size, path.stat().st_mtime_ns) for path in paths]
        return hashlib.sha256(repr((stats, self.seed, self.call_s, with_pictures)).encode()).hexdigest()

    def verdict(self, exercise: str, data: bytes | None, student: str = "") -> dict:
        """The verdict on one file; known ones are not run again. Every failure is this file's. Time counts for the first
        student with this answer."""
        base = {"exercise": exercise, "chapter": self.wanted[exercise], "ok": False, "passed": 0, "failed": 0,
                "first_failure": None, "hint": None, "state": "judged"}
        if data is None or same_text(data, self.starters[exercise]):
            return base | {"state": "missing" if data is None else "unchanged",
                           "first_failure": "was not handed in" if data is None else "is as it was handed out"}
        if self.spent_s(student) > self.budget_s:
            return base | {"state": "over budget", "first_failure": "was not judged: this student's answers have taken more than "
                           f"{self.budget_s / 60:g} minutes beyond the {FREE_S} s that each may take"}
        key = hashlib.sha256(f"{self.versions[base['chapter']]} {exercise} ".encode() + data).hexdigest()
        kept = self.verdicts / f"{key}.json"
        if exercise not in self.fresh:
            with contextlib.suppress(OSError, ValueError):
                found = json.loads(kept.read_text(encoding="utf-8"))
                self.spend(student, found.pop("over_s", 0))
                return base | found
        try:
            self.control(exercise)
            counted.seconds = 0
            found = self.judge_fairly(exercise, data)
            if self.stopped:  # an aborted run gives no verdict
                raise Failure("grading was stopped")
        except Unjudged as error:
            return base | {"state": "failed", "first_failure": words_of(error)}
        except Exception as error:  # this machine's fault, or ours: not kept, said at the end, and no other student's
            return base | {"state": "failed", "first_failure": f"could not be judged: {words_of(error)}"}
        over_s = max(0, round(counted.seconds - FREE_S))
        self.spend(student, over_s)
        found = {name: clean(value) for name, value in found.items()
                 if name in ("killed", "ok", "passed", "failed", "first_failure", "hint", "note", "state", "picture", "picture_expected")}
        if "killed" in found:  # perhaps from outside: never kept
            return base | {name: found[name] for name in found if name != "killed"} | {"unkept": True}
        with contextlib.suppress(OSError):  # only slower the next time
            write_atomically(kept, json.dumps(found | {"over_s": over_s}))
        return base | found

    def spent_s(self, student: str) -> float:
        with self.lock:
            return self.spent.get(student, 0)

    def spend(self, student: str, seconds: float):
        with self.lock:
            self.spent[student] = self.spent.get(student, 0) + seconds

    def judge_fairly(self, exercise: str, data: bytes) -> dict:
        """A verdict on the answer. Raises Failure where this machine reaches none."""
        for number, wait_s in enumerate(TRIES_S):
            time.sleep(wait_s)
            try:
                with self.turns.alone() if number else self.turns.with_others():
                    found = self.judge(exercise, data)
                    # With these inputs the reference itself may lie beside a bound.
                    if not found["ok"] and "suspect" not in found and found.get("state") != "undecided" and \
                            not self.reference_is_right(exercise):
                        found = self.judge(exercise, data, seed=0)
            except Exception as error:
                # The same again, and the control is well: the answer has found a fault of ours, and somebody looks at it.
                found = {"ok": False, "suspect": words_of(error), "state": "undecided",
                         "first_failure": f"the grader fails at it: {words_of(error)}"}
            if self.stopped or "suspect" not in found:
                return found
            self.control(exercise, again=True)
            if number:  # it failed before, too, and the machine was well in between
                return found | ({"state": "undecided"} if "killed" in found else {})
        raise Failure(f"this machine fails at it: {found['suspect']}")

    def control(self, exercise: str, again: bool = False):
        """Raises Unjudged where the reference does not pass or the starter does not fail, here and now; once a run, or again."""
        entry = self.controlled[exercise]
        with entry[0]:
            if isinstance(entry[1], Unjudged) and not again:
                raise entry[1]
            if entry[1] is True and not again:
                return
            before_s = getattr(counted, "seconds", 0)
            try:
                for wait_s in TRIES_S:
                    time.sleep(wait_s)
                    try:
                        with self.turns.alone() if again else self.turns.with_others():
                            self.look_at_control(exercise)
                        entry[1] = True
                        return
                    except Unjudged as why:
                        if self.stopped:  # which says nothing about this machine
                            raise
                        entry[1] = why
                    if self.broken:  # it was waited for already
                        break
                self.broken = True
                raise entry[1]
            finally:
                counted.seconds = before_s  # no student's time

    def look_at_control(self, exercise: str):
        if (reference := self.reference(exercise)) is not None:
            found = self.attempt(exercise, reference)
            if not found["ok"] and "suspect" not in found:  # with the class's inputs it may lie beside a bound
                found = self.attempt(exercise, reference, seed=0)
            if not found["ok"] and found.get("state") != "undecided":
                raise unjudged(exercise, f"its reference does not pass: {found['first_failure']}")
        found = self.attempt(exercise, self.starters[exercise], pictures=False)
        if found["ok"] or "suspect" in found:
            raise unjudged(exercise, f"its starter {'passes' if found['ok'] else 'reaches no verdict: ' + found['first_failure']}")

    def attempt(self, exercise: str, data: bytes, **options) -> dict:
        try:
            return self.judge(exercise, data, **options)
        except Exception as error:
            return {"ok": False, "suspect": words_of(error), "first_failure": words_of(error)}

    def reference(self, exercise: str) -> bytes | None:
        path = self.paths[exercise]
        place = path.parent.parent / "solution" / path.name
        return handed_in(place.read_text(encoding="utf-8")).encode() if place.exists() else None

    def reference_is_right(self, exercise: str) -> bool:
        chapter = self.wanted[exercise]
        kept = self.verdicts / f"{self.versions[chapter][:32]}.{exercise}"
        if not kept.exists():
            done = subprocess.run([self.folder / f"judge_{chapter}", "--exercise", exercise, "--use", "solution"],
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                  env=os.environ | {"LIGHTWALK_CHECK_SEED": str(self.seed)})
            if b'"exercise"' not in done.stdout:  # it has not come to a verdict
                return True
            # Of a trial the reference has no process to run in.
            right = done.returncode == 0 or b"no process to ask" in done.stdout
            with contextlib.suppress(OSError):  # only slower the next time
                write_atomically(kept, "right" if right else "wrong")
            return right
        return kept.read_text(encoding="utf-8") == "right"

    def judge(self, exercise: str, data: bytes, seed: int | None = None, pictures: bool = True) -> dict:
        """A verdict. Where it is "suspect", which says why, the fault may be the machine's."""
        with tempfile.TemporaryDirectory(prefix="lightwalk.grade.") as made:
            source = Path(made) / self.paths[exercise].name
            try:
                source.write_bytes(plain(data, self.paths[exercise]).encode() if source.suffix == ".glsl" else data)
            except Refused as why:
                return {"ok": False, "first_failure": str(why)}
            found = self.numbers(exercise, source, self.seed if seed is None else seed)
            if found["ok"] and self.pictures and pictures:
                try:
                    why = self.pictures.wrong(exercise, source, self)
                except ToolFailed as failed:
                    return found | {"ok": False, "failed": found["failed"] + 1, "suspect": str(failed), "first_failure":
                                    f"the numbers are right, and there is no picture: {failed}"}
                except DriverEnded as shots:
                    return found | {"ok": False, "state": "undecided", "first_failure":
                                    f"{NOT_DRAWN} of {shots}, with which the driver crashed",
                                    "hint": "every number that was tried is right: the person who grades reads the source"}
                if why:
                    found |= {"ok": False, "failed": found["failed"] + 1, "first_failure": why,
                              "hint": "every number that was tried is right, so look for an input that only the picture has"}
                    found |= self.keep_pictures(source.parent) | ({"suspect": why} if NOT_IN_TIME in why else {})
                elif why is not None:
                    found["passed"] += 1
            if found["ok"] and found.get("looked_for") is False:
                found |= {"ok": False, "state": "undecided", "first_failure": NOT_LOOKED_FOR, "hint": found.get("note")}
            return found

    def keep_pictures(self, folder: Path) -> dict:
        """Student's and expected picture, for the student's page, named by their contents."""
        kept = {}
        for key, name in (("picture", THEIRS), ("picture_expected", EXPECTED)):
            with contextlib.suppress(OSError):  # a full disc costs the page its pictures, not the answer its verdict
                data = (folder / name).read_bytes()
                digest = hashlib.sha256(data).hexdigest()
                write_atomically(picture_path(digest), data)
                kept[key] = digest
        return kept

    def numbers(self, exercise: str, source: Path, seed: int) -> dict:
        if source.suffix == ".glsl":
            return self.decide(exercise, seed, source)
        try:
            if why := compile_answer(self, exercise, source):
                return {"ok": False, "first_failure": why}
        except ToolFailed as failed:
            return {"ok": False, "first_failure": str(failed), "suspect": str(failed)}
        ends = [*os.pipe(), *os.pipe()]  # questions: read, write; answers: read, write
        draws = self.has_trial(exercise)  # and looks after the time of its calls itself
        limit = {} if draws else {"LIGHTWALK_TIMEOUT_S": self.call_s}
        with self.started(["/grade/worker", ends[0], ends[3]], self.worker_mounts(source.parent),
                          Limits((6 if draws else 1) * GIB, JUDGE_S + 5, device=draws),
                          {"LIGHTWALK_ROOT": ROOT, "LIGHTWALK_CACHE": "/tmp"} | limit,
                          pass_fds=(ends[0], ends[3]), out=False) as running:
            found = self.decide(exercise, seed, None, worker=(ends[1], ends[2]), ours=ends)
            if not found["ok"] and found.pop("lost", False) and "suspect" not in found:
                found["suspect"] = "the process with the answer has ended, or was late"
                with contextlib.suppress(subprocess.TimeoutExpired):
                    if running.process.wait(1) == 128 + signal.SIGKILL and not running.cage.was_full():
                        found["killed"] = True
            return found

    def library(self, chapter: str) -> list[Path]:
        return [self.libraries[chapter]] if chapter in self.libraries else []

    def has_trial(self, exercise: str) -> bool:
        path = ROOT / "tests" / self.wanted[exercise] / "trials.h"
        return path.exists() and f'"{exercise}"' in path.read_text(encoding="utf-8")

    def mounts(self) -> Mounts:
        """The tree without answers, at its usual place, and the libraries that all programs share."""
        mounts = Mounts()
        for name in ("chapters", "common", "shaders", "tests"):
            mounts.read(self.tree / name, ROOT / name)
        for shared in LIBRARIES:
            mounts.read(shared)
        return mounts

    def worker_mounts(self, folder: Path) -> Mounts:
        mounts = self.mounts()
        mounts.read(folder / "worker", Path("/grade/worker"))
        return mounts

    def judge_mounts(self, exercise: str, source: Path | None) -> Mounts:
        mounts = self.mounts()
        mounts.read(self.folder / f"judge_{self.wanted[exercise]}", Path("/grade/judge"))
        self.mount_references(mounts, exercise)
        if source:
            mounts.read(source, self.paths[exercise])
        return mounts

    def mount_references(self, mounts: Mounts, exercise: str):
        """Of all GLSL exercises but this one, which others may include."""
        for folder in sorted((ROOT / "shaders").glob("*/solution")):
            mounts.empty(folder)
            for path in sources(folder, "*.glsl"):
                if f"{folder.parent.name[:2]}.{path.stem}" != exercise:
                    mounts.read(path)

    def decide(self, exercise: str, seed: int, source: Path | None, worker=(), ours=()) -> dict:
        """Runs the checks, on a shader or on a process that answers, and reads their verdict."""
        nonce = secrets.token_hex(16)
        environment = {"LIGHTWALK_ROOT": ROOT, "LIGHTWALK_CACHE": "/tmp", "LIGHTWALK_CHECK_SEED": seed, "LIGHTWALK_TIMEOUT_S": self.call_s}
        ends = ["--worker", ",".join(map(str, worker))] if worker else []
        with self.started(["/grade/judge", "--exercise", exercise, "--nonce", nonce, *ends], self.judge_mounts(exercise, source),
                          Limits(6 * GIB, JUDGE_S, device=True), environment, pass_fds=worker) as running:
            for end in ours:  # so that each side sees the other's end
                os.close(end)
            done = running.finish()
        if done.late:  # a busy machine is not the student's fault
            return {"ok": False, "first_failure": f"its check did not end within {JUDGE_S} s", "suspect": "there was not enough time"}
        for line in done.out.splitlines():
            with contextlib.suppress(ValueError, RecursionError):
                found = json.loads(line)
                if isinstance(found, dict) and found.get("nonce") == nonce and found.get("exercise") == exercise:
                    found |= {"ok": found.get("ok") is True and done.code == 0}
                    if source and found.get("lost") and not found["ok"]:
                        found["suspect"] = "its check was late, or the system failed"
                    return found
        # Printed text is not trustworthy.
        killed = {"killed": True} if done.code == 128 + signal.SIGKILL and not done.hoarded else {}
        return killed | {"ok": False, "first_failure": f"its check ended with {done.code}{sandbox.signal_words(done.code)}",
                "suspect": f"its check ended with {done.code}"}


def words_of(error: Exception) -> str:
    return clean(str(error) if isinstance(error, (Failure, OSError)) else repr(error))


def clean(value):
    """A word for a table: one line, no control characters, not too long."""
    return printable(value, WORDS_MOST) if isinstance(value, str) else value


def same_text(a: bytes, b: bytes) -> bool:
    """But for line ends, and for spaces at them."""
    return [line.rstrip() for line in a.splitlines()] == [line.rstrip() for line in b.splitlines()]
