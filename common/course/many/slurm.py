"""Runs the shards of a command (shards.py) as an array job of Slurm, as universities have it. No scheduler of our own.

`--slurm[=OPTIONS]` writes KIND.sbatch, a script that a person can read and submit, into the folder of the shards, submits it,
waits with a line of progress, and merges. The folder and the course must lie where all nodes see them. The job is
Slurm's: a task whose node failed is queued again, one that waits for a drained node goes to another. A part that died is
submitted once more; one that died again is named, and the same command goes on from there. So it does after Ctrl+C, which
leaves the job in the queue.
"""

import json
import re
import shlex
import shutil
import subprocess
import time
from pathlib import Path

from many import shards
from many.shards import check_writable, course_version
from progress import Progress
from tree import BUILD, ROOT, Failure, UsageError, relative, warn, write_atomically

POLL_S = 1.0
ATTEMPTS = 2  # a part that dies twice has a reason
SHARDS = 16
# Resources of each task, unless OPTIONS override them.
ASKS = {"cpus-per-task": "2", "mem": "8G", "time": "04:00:00"}
OURS = ("--array", "-a", "--output", "-o", "--error", "-e", "--chdir", "-D", "--wrap", "--parsable")
WAITING = ("PENDING", "CONFIGURING", "REQUEUED", "REQUEUE_HOLD", "REQUEUE_FED", "SUSPENDED", "RESIZING", "SPECIAL_EXIT", "STOPPED")


def add_arguments(parser):
    parser.add_argument("--slurm", nargs="?", const="", metavar="=OPTIONS",
                        help="have Slurm do the parts and merge them; options of sbatch: --slurm='--partition=short --mem=16G'")
    parser.add_argument("--shards", type=int, metavar="N", help=f"how many parts Slurm is given ({SHARDS})")


def check_arguments(arguments):
    """Those of shards, too. Raises UsageError with sbatch's requirements."""
    shards.check_arguments(arguments)
    if arguments.slurm is None:
        if arguments.shards is not None:
            raise UsageError("--shards says how many parts --slurm makes: give both")
        return
    if arguments.shard or arguments.merge:
        raise UsageError("--slurm makes all parts and merges them: leave out --shard and --merge")
    if arguments.shards is not None and not 1 <= arguments.shards <= 1000:
        raise UsageError(f"--shards is {arguments.shards}, expected 1 to 1000")
    options(arguments.slurm)
    if not shutil.which("sbatch"):
        raise UsageError("there is no sbatch: this is no machine that submits to Slurm (Debian's package slurm-client)")


def options(text: str) -> list[str]:
    try:
        words = shlex.split(text)
    except ValueError as error:
        raise UsageError(f"--slurm: {error}: {text}") from None
    if words and not words[0].startswith("-"):
        raise UsageError(f"--slurm takes options of sbatch, such as --slurm='--partition=short'; '{words[0]}' is none: "
                         "put --slurm last, or a = behind it")
    for word in words:
        if "\n" in word:
            raise UsageError("--slurm: an option has a line break")
        if word.partition("=")[0] in OURS:
            raise UsageError(f"--slurm: {word.partition('=')[0]} is set by the course")
    return words


def script(kind: str, words: list[str], folder: Path, of: int, given: list[str], cwd: Path) -> str:
    """The array job's text. `words`: the command's, without --slurm, --shards and --out."""
    asked = {word.lstrip("-").partition("=")[0] for word in given} | \
            {name for short, name in (("-c", "cpus-per-task"), ("-t", "time")) if any(word.startswith(short) for word in given)}
    lines = [f"--{name}={value}" for name, value in ASKS.items()
             if name not in asked and not (name == "mem" and any(one.startswith("mem") for one in asked))] + [shlex.join(given)] * bool(given)
    command = shlex.join([str(ROOT / "course"), *words])
    return "\n".join([
        "#!/bin/bash",
        f"# {shlex.join(['./course', *words])}, in {of} parts: one for each task of this array job.",
        "# ./course wrote and submitted this file and merges what the parts make. A part that died, by hand:",
        f"#     sbatch --array=3 {shlex.quote(str(folder / f'{kind}.sbatch'))}",
        f"#SBATCH --job-name=lightwalk-{kind}",
        f"#SBATCH --array=1-{of}",
        f'#SBATCH --output="{folder}/{kind}.%a.log"' if " " in str(folder) else f"#SBATCH --output={folder}/{kind}.%a.log",
        f'#SBATCH --chdir="{cwd}"' if " " in str(cwd) else f"#SBATCH --chdir={cwd}",
        "#SBATCH --requeue",
        *[f"#SBATCH {line}" for line in lines],
        "",
        f'exec {command} --shard "$SLURM_ARRAY_TASK_ID/{of}" --out {shlex.quote(str(folder))}',
        ""])


def without(words: list[str], *names: str) -> list[str]:
    """A command's words without these options and their values."""
    kept, words = [], list(words)
    while words:
        word = words.pop(0)
        if word in names:
            if words and (word != "--slurm" or words[0].startswith("-") and " " in words[0]):
                words.pop(0)
        elif word.partition("=")[0] not in names:
            kept.append(word)
    return kept


def run(kind: str, arguments, words: list[str], prepare=lambda: None) -> Path:
    """Has Slurm make all shards of a command and returns their folder, to be merged. `words`: the command's own. `prepare`
    is called before the first task runs, for shared builds. Raises Failure with the parts that died."""
    of = arguments.shards or SHARDS
    given, folder = options(arguments.slurm), BUILD / "slurm" / kind
    check_writable(folder)
    words = without(words, "--slurm", "--shards", "--out")
    about = {"command": words, "of": of, "cwd": str(Path.cwd()), "course": course_version()}
    prepare()
    folder.mkdir(parents=True, exist_ok=True)
    job = goes_on(folder, about)
    if not job:
        for old in [*folder.glob(f"{kind}.*.zip"), *folder.glob(f"{kind}.*.log")]:
            old.unlink()
    file = folder / f"{kind}.sbatch"
    write_atomically(file, script(kind, words, folder, of, given, Path.cwd()))
    with Progress(f"{kind}, Slurm") as progress:
        attempt = 0
        while True:
            if job and job["id"]:
                wait(job["id"], kind, folder, of, progress)
            missing = [number for number in range(1, of + 1) if not is_made(folder, kind, number, of)]
            if not missing:
                return folder
            if attempt == ATTEMPTS:
                raise Failure(f"part{'s' if len(missing) > 1 else ''} {', '.join(map(str, missing[:20]))} of {of} died "
                              f"{ATTEMPTS} times; {relative(folder / f'{kind}.{missing[0]}.log')}: {last_line(folder, kind, missing[0])}; "
                              f"the same command tries {'them' if len(missing) > 1 else 'it'} again")
            if attempt:
                progress.say(f"part{'s' if len(missing) > 1 else ''} {', '.join(map(str, missing[:20]))} of {of} died: submitted again")
            attempt += 1
            job = about | {"id": submit(file, missing, of)}
            write_atomically(folder / "job.json", json.dumps(job, indent=1) + "\n")
            progress.say(f"job {job['id']}: {len(missing)} parts; {relative(file)}")


def finished(kind: str):
    (BUILD / "slurm" / kind / "job.json").unlink(missing_ok=True)


def goes_on(folder: Path, about: dict) -> dict | None:
    """The unmerged job of the same command on the same course: it may still run."""
    try:
        job = json.loads((folder / "job.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    if {key: job.get(key) for key in about} != about:
        if job.get("id") and states(job["id"]):
            raise UsageError(f"job {job['id']} of another command still writes to {relative(folder)}: wait for it, or scancel {job['id']}")
        return None
    warn(f"going on with job {job['id']}")
    return job


def submit(file: Path, numbers: list[int], of: int) -> str:
    array = f"1-{of}" if len(numbers) == of else ",".join(map(str, numbers))
    done = subprocess.run(["sbatch", "--parsable", f"--array={array}", file], stdin=subprocess.DEVNULL, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    found = re.fullmatch(r"(\d+)(?:;.*)?", done.stdout.strip())
    if done.returncode or not found:
        said = (done.stderr.strip() or done.stdout.strip() or f"it ended with {done.returncode}").splitlines()[-1]
        raise Failure(f"sbatch {relative(file)}: {said}")
    return found[1]


def states(job: str) -> list[str] | None:
    """Of the tasks that are still in the queue; empty where none is, None where Slurm does not answer now."""
    done = subprocess.run(["squeue", "--jobs", job, "--array", "--noheader", "--format=%T"], stdin=subprocess.DEVNULL, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode:
        return [] if "Invalid job id" in done.stderr else None
    return done.stdout.split()


def wait(job: str, kind: str, folder: Path, of: int, progress: Progress):
    """Until no task of the job is queued or runs."""
    while (now := states(job)) != []:
        made = sum(is_made(folder, kind, number, of) for number in range(1, of + 1))
        if now is None:
            progress.show(made, of, "Slurm does not answer")
        else:
            waiting = sum(state in WAITING for state in now)
            progress.show(made, of, f"{len(now) - waiting} running, {waiting} waiting")
        time.sleep(POLL_S)
    progress.show(sum(is_made(folder, kind, number, of) for number in range(1, of + 1)), of)


def is_made(folder: Path, kind: str, number: int, of: int) -> bool:
    return (folder / f"{kind}.{number}-of-{of}.zip").exists()


def last_line(folder: Path, kind: str, number: int) -> str:
    try:
        lines = (folder / f"{kind}.{number}.log").read_text(errors="replace", encoding="utf-8").strip().splitlines()
    except OSError:
        lines = []
    return lines[-1][:300] if lines else "it said nothing"
