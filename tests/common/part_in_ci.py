"""Of many like cases a CI tries a part, another with each commit; without CI=true all of them."""
import os
import subprocess
from pathlib import Path


def part(cases, of: int) -> list:
    """Every `of`th case of a sequence, from one that the commit decides; outside a repository from the first. Where there
    are fewer cases, one."""
    cases = list(cases)
    if os.environ.get("CI") != "true" or not cases:
        return cases
    said = subprocess.run(["git", "rev-parse", "HEAD"], cwd=Path(__file__).parent, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout.strip()
    return cases[int(said or "0", 16) % min(of, len(cases))::of]
