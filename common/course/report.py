"""The report of a test run on one page."""

import json
from html import escape
from pathlib import Path

from tree import write_atomically


def write_report(results_dir: Path, out: Path):
    """results_dir holds ctest's JUnit files (*.xml) and what shots.py wrote (*.json)."""
    results = [json.loads(path.read_text()) for path in sorted(results_dir.glob("*.json"))]
    rows = "".join(f"<tr><td>{escape(r['chapter'])}<td>{escape(r['name'])}<td>{escape('; '.join(r['why']) or 'ok')}\n"
                   for r in sorted(results, key=lambda r: r["ok"]))
    write_atomically(out, f"<!doctype html><meta charset='utf-8'><title>Tests</title>\n<table>{rows}</table>\n")
