"""The page of ./course test --device, self-contained: what was expected, what the device drew, and the difference."""

from pathlib import Path

import pages.report  # noqa: F401  the filters of report_parts.html
from pages.page import page
from pages.report_cards import Pictures
from tree import write_atomically

EXACT = 20  # pictures outside limits that are embedded losslessly, 1.5 MB each with the golden and the difference


def write_page(out: Path, made: dict, results: list[dict], lines: list[str]):
    """`made` is the run's file and `lines` its summary; `results` are test/device.py's, in the order in which they are shown."""
    write_atomically(out, page("device.html", made=made, results=results, lines=lines, exact=EXACT, pictures=Pictures()))
