"""What must be true of a commit that people get: each step is a run of ./course test, and docs/release.md has a row for it."""

import json
import os
import platform
import re
import resource
import shutil
import subprocess
import time
import xml.etree.ElementTree as xml
from datetime import date
from pathlib import Path

from build.build import build
from build.doctor import first_line, output
from test.container import MIRROR, SYSTEMS, TREE
from tree import BUILD, ROOT, UsageError, chapter_program, chapters, cores, git, relative, say, write_atomically

ALONE = True
STEPS = {
    "all": "all four suites",
    "sanitizers": "first and engine under the sanitizers of addresses and of undefined behaviour",
    "driver": "first with a second driver",
    "bookworm": "a newcomer's commands on a bare Debian 12",
    "trixie": "a newcomer's commands on a bare Debian 13",
    "gpu": "pictures on a GPU",
}
HELP = """Proves a commit before people get it, and writes docs/release.md. It runs for hours and asks nothing.

  ./course release                               all steps
  ./course release --only driver --only gpu      these steps; the page keeps what others have shown of the same commit

A step, or a part of all, that has passed for this commit is not run again: a run that was cut short goes on.

Steps:
""" + "\n".join(f"  {step:11} {what}" for step, what in STEPS.items()) + """

A step that cannot run here (no root, no network, no GPU) says why in its row. The exit code is 1 if a step failed."""
FOLDER, PAGE = BUILD / "release", ROOT / "docs" / "release.md"
PARTS = {"all": 8}  # of a step that takes hours: a run that was cut short goes on with the first that has not passed
MOST_NAMED = 8  # failed tests in a row of the page
ROW = "| `{command}` | {what} | {tests} | {failed} | {minutes:.1f} | {processor_minutes:.1f} | {result} |\n"


def add_arguments(parser):
    parser.usage = "./course release [--only STEP]..."
    parser.add_argument("--only", action="append", choices=STEPS, metavar="STEP", help="one step; may be repeated")


def run(arguments, _rest) -> int:
    if not (ROOT / ".git").exists():
        raise UsageError("a release is of a commit, and there is no git history here")
    commit = git("rev-parse", "HEAD").decode().strip()
    changed = [line[3:] for line in git("status", "--porcelain").decode(errors="replace").splitlines()]
    if changed := [name for name in changed if name != str(PAGE.relative_to(ROOT))]:
        raise UsageError(f"a release is of a commit, and this tree differs from it: {changed[0]}"
                         + (f" and {len(changed) - 1} more" if changed[1:] else ""))
    for step in arguments.only or STEPS:
        for part in parts_of(step):
            if kept(part).get("commit") == commit and kept(part)["ok"]:
                continue
            row = run_part(step, part)
            say(f"{part}: {row['result']}")
            write_atomically(FOLDER / f"{part}.json", json.dumps(row | {"commit": commit}, indent=1) + "\n")
            write_atomically(PAGE, page(commit))
    write_atomically(PAGE, page(commit))
    rows = rows_of(commit)
    say(f"{relative(PAGE)}: {sum(row['ok'] is True for row in rows)} of {len(STEPS)} steps passed")
    return 1 if any(row["ok"] is False for row in rows) else 0


def parts_of(step: str) -> list[str]:
    """Names of the step's parts, of logs and results: the step's own where it is run as one."""
    count = PARTS.get(step, 1)
    return [f"{step}.{number}-of-{count}" for number in range(1, count + 1)] if count > 1 else [step]


def run_part(step: str, part: str) -> dict:
    try:
        words, environment, which = prepared(step)
    except UsageError as why:
        return row_of(step, f"not run: {why}", None)
    more = ["--shard", part.removeprefix(f"{step}.").replace("-of-", "/"), "--out", FOLDER / step] if part != step else []
    junit, log = junit_of(step), FOLDER / f"{part}.log"
    junit.unlink(missing_ok=True)
    log.parent.mkdir(parents=True, exist_ok=True)
    say(f"{part}: ./course {' '.join(map(str, [*words, *more[:2]]))}; its output goes to {relative(log)}")
    began_s, used_s = time.monotonic(), processor_s()
    with open(log, "w", encoding="utf-8") as out:
        course = subprocess.Popen([ROOT / "course", *words, *more], env=os.environ | environment, stdin=subprocess.DEVNULL, stdout=out, stderr=out)
        try:
            code = course.wait()
        except BaseException:
            course.terminate()  # and it ends its own children
            course.wait()
            raise
    tests, failed = counted(junit)
    last = (log.read_text(errors="replace", encoding="utf-8").strip().splitlines() or [f"it ended with {code}"])[-1].removeprefix("course: ")
    result = "passed" if not code else f"not run: {last}" if code == 2 and not tests else \
        f"failed: {', '.join([*failed[:MOST_NAMED], *['…'] * (len(failed) > MOST_NAMED)]) or last}"
    return row_of(step, result, True if not code else None if code == 2 and not tests else False, command="./course " + " ".join(words),
                  what=STEPS[step] + which, tests=tests, failed=len(failed),
                  minutes=(time.monotonic() - began_s) / 60, processor_minutes=(processor_s() - used_s) / 60)


def row_of(step: str, result: str, ok: bool | None, **more) -> dict:
    said = result.replace(f"{ROOT}/", "").replace("|", "/")[:300]
    return {"command": f"./course release --only {step}", "what": STEPS[step], "tests": 0, "failed": 0, "minutes": 0,
            "processor_minutes": 0, "result": said, "ok": ok} | more


def processor_s() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def prepared(step: str) -> tuple[list[str], dict[str, str], str]:
    """(words of ./course, environment, which driver or device) of a step. Raises UsageError where it cannot run here."""
    if step in SYSTEMS:
        return ["test", "--on", step], {}, ""
    if step == "sanitizers":
        return ["test", "--sanitize"], {}, ""
    if step == "driver":
        manifest, version = second_driver()
        return ["test", "-L", "^first$"], {"VK_DRIVER_FILES": str(manifest)}, f", Mesa {version}"
    if step == "gpu":
        device = hardware()
        return ["test", "--device", device], {}, f", {device}"
    return ["test", "--all"], {}, ""


def junit_of(step: str) -> Path:
    build_folder = BUILD / "on" / step / "root" / TREE[1:] / "build" if step in SYSTEMS else BUILD
    return build_folder / "results" / ("sanitizer.xml" if step == "sanitizers" else "tests.xml")


def counted(junit: Path) -> tuple[int, list[str]]:
    cases = list(xml.parse(junit).getroot().iter("testcase")) if junit.exists() else []
    return len(cases), [case.get("name") for case in cases if case.get("status") == "fail"]


def hardware() -> str:
    build([chapters()[0]])
    devices = [re.split(" {2,}", line.strip()) for line in output([chapter_program(chapters()[0]), "--list", "devices"]).splitlines()]
    found = [device[0] for device in devices if len(device) > 2 and device[2] != "software"]
    if not found:
        raise UsageError("no Vulkan device of this machine is hardware")
    return found[0]


def second_driver() -> tuple[Path, str]:
    """Manifest and version of the software driver of Debian 12's backports, which is unpacked into build/second_driver."""
    folder = BUILD / "second_driver"
    manifest = folder / "lvp_icd.json"
    if not manifest.exists():
        system = platform.freedesktop_os_release()
        if system.get("VERSION_CODENAME") != "bookworm":
            raise UsageError(f"the second driver is a package for Debian 12, and this is {system.get('PRETTY_NAME')}")
        shutil.rmtree(folder, ignore_errors=True)
        (folder / "lists" / "partial").mkdir(parents=True)
        sources = folder / "sources.list"
        sources.write_text(f"deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] {MIRROR} bookworm-backports main\n", encoding="utf-8")
        settings = {"Dir::Etc::sourcelist": sources, "Dir::Etc::sourceparts": "-", "Dir::State::lists": folder / "lists", "Dir::Cache": folder}
        apt = ["apt-get", "-q", *[f"-o{name}={value}" for name, value in settings.items()]]
        unpack(folder, [*apt, "update"])
        unpack(folder, [*apt, "download", "mesa-vulkan-drivers"])
        unpack(folder, ["dpkg", "-x", *folder.glob("*.deb"), "root"])
        given = json.loads(next(folder.glob("root/usr/share/vulkan/icd.d/lvp_icd*.json")).read_text(encoding="utf-8"))
        given["ICD"]["library_path"] = str(next(folder.glob("root/usr/lib/*/libvulkan_lvp.so")))
        write_atomically(manifest, json.dumps(given))
    return manifest, next(folder.glob("*.deb")).name.split("_")[1].replace("%3a", ":")


def unpack(folder: Path, command: list):
    done = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    if done.returncode:
        said = [line for line in done.stdout.splitlines() if line.startswith(("E:", "W:", "dpkg"))]
        raise UsageError(f"{command[0]} could not get Mesa of bookworm-backports: {said[0] if said else f'it ended with {done.returncode}'}")


def kept(part: str) -> dict:
    path = FOLDER / f"{part}.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def rows_of(commit: str) -> list[dict]:
    return [whole(step, [row for part in parts_of(step) if (row := kept(part)).get("commit") == commit]) for step in STEPS]


def whole(step: str, rows: list[dict]) -> dict:
    """One row of those of a step's parts that have run."""
    missing = len(parts_of(step)) - len(rows)
    if not rows:
        return row_of(step, "not run yet", None)
    sums = {key: sum(row[key] for row in rows) for key in ("tests", "failed", "minutes", "processor_minutes")}
    results = [*dict.fromkeys(row["result"] for row in rows if not row["ok"]), *[f"{missing} of its {len(rows) + missing} parts are not run yet"] * bool(missing)]
    ok = False if any(row["ok"] is False for row in rows) else True if not results else None
    return rows[0] | sums | {"ok": ok, "result": "; ".join(results) or "passed"}


def page(commit: str) -> str:
    model = re.search(r"^model name\s*: (.*)$", Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.M)
    memory_gb = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 1e9
    return f"""# Release

What was proven of a commit before people got it. `./course release` runs the steps and writes this page.

| | |
|---|---|
| commit | `{commit}` |
| date | {date.today()} |
| machine | {cores()} cores, {model[1] if model else platform.machine()}, {memory_gb:.0f} GB |
| system | {platform.freedesktop_os_release().get('PRETTY_NAME')}, Linux {platform.release()} |
| tools | {first_line(['c++', '--version'])}; {first_line(['cmake', '--version'])}; Python {platform.python_version()} |

| command | proves | tests | failed | minutes | processor minutes | result |
|---|---|---:|---:|---:|---:|---|
""" + "".join(ROW.format(**row) for row in rows_of(commit))
