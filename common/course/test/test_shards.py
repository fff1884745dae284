"""./course test in shards, for a CI's matrix. A shard keeps its results and their pictures."""

import json
import shutil
from pathlib import Path

from many import shards
from pages.report import write_report
from test import needs
from tree import BUILD, ROOT, UsageError, relative, say, write_atomically


def words(folder: Path, selection: list[str], shard: shards.Shard | None) -> list[str]:
    """ctest's options for a shard's tests of a selection; nothing without a shard."""
    if not shard:
        return []
    count = len(needs.selected(folder, selection))
    if not count:
        raise UsageError(f"no test matches {' '.join(selection)}; ctest --test-dir build -N lists them")
    # Every Nth of the selected tests; a start behind the last one would run them all.
    return ["-I", f"{shard.number},,{shard.of}"] if shard.number <= count else ["-E", "."]


def write(file: Path, shard: shards.Shard, results: Path, total: int, failed: int, selection: list[str]) -> int:
    """Packs the results of a shard's tests with the pictures they name. The exit code."""
    entries, pictures = {}, {}
    for path in sorted(results.iterdir()):
        if path.suffix == ".json":
            entries[path.name] = json.loads(path.read_text(encoding="utf-8"))
            for one in entries[path.name].get("pictures") or []:
                for name in filter(None, (one.get("actual"), one.get("heatmap"))):
                    pictures[name] = ROOT / name
        elif path.suffix == ".xml":
            entries[f"{path.stem}.{shard.number}-of-{shard.of}.xml"] = path.read_text(encoding="utf-8")
    head = {"selection": selection, "course": shards.course_version(), "counts": [total, failed]}
    shards.write(file, "test", shard, head, entries, {name: path for name, path in pictures.items() if path.exists()})
    say(f"\n{relative(file)}: {total} tests of shard {shard}")
    say(closing_line(total, failed))
    return 1 if failed else 0


def merge(paths: list[Path]) -> int:
    made = shards.merge(paths, "test", per_shard=("counts",))
    results = BUILD / "results"
    shutil.rmtree(results, ignore_errors=True)
    for name, entry in made.entries.items():
        if Path(name).name != name:
            raise UsageError(f"{made.came_from[name]}: '{name}' is no result")
        write_atomically(results / name, entry if isinstance(entry, str) else json.dumps(entry, indent=1) + "\n")
        for one in (entry.get("pictures") or []) if isinstance(entry, dict) else []:
            for picture in filter(None, (one.get("actual"), one.get("heatmap"))):
                parts = Path(picture).parts
                if parts[0] == "build" and ".." not in parts and made.has_file(name, picture):
                    write_atomically(ROOT / picture, made.file(name, picture))
    report = BUILD / "report" / "index.html"
    write_report(results, report)
    total, failed = (sum(counts) for counts in zip(*made.head["counts"]))
    say(f"report: {relative(report)}")
    say(closing_line(total, failed))
    return 1 if failed else 0


def closing_line(total: int, failed: int) -> str:
    """ctest's closing line over all runs, for a CI to read."""
    percent = round(100 * (total - failed) / max(total, 1))
    return f"{min(percent, 99) if failed else 100}% tests passed, {failed} tests failed out of {total}"
