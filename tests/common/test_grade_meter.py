"""What a student's budget counts: processor time and time asleep, but no wait for a processor (grading/meter.py)."""
# Builds: nothing

import contextlib
import os
import subprocess
import sys
import time
import types
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common" / "course"))
from grading.meter import Meter, family  # noqa: E402

LOOP = "while :; do :; done"


class Metered(unittest.TestCase):
    def started(self, script: str) -> types.SimpleNamespace:
        process = subprocess.Popen(["bash", "-c", script])
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return types.SimpleNamespace(first=process.pid, process=process)

    def metered(self, script: str, seconds: float) -> Meter:
        with Meter() as meter:
            one = self.started(script)
            meter.add(one)
            time.sleep(seconds)
            one.process.kill()
        return meter

    def test_an_answer_that_sleeps_is_charged(self):
        start_s = time.monotonic()
        meter = self.metered("sleep 60", 2.0)
        self.assertGreater(meter.seconds, 0.8)
        self.assertLess(meter.seconds, time.monotonic() - start_s + 0.5)  # on a busy machine 2 s are more

    def test_a_busy_machine_charges_nobody(self):
        others = [self.started(LOOP) for _ in range(6 * (os.cpu_count() or 1))]
        meter = self.metered(LOOP, 3.0)
        for one in others:
            one.process.kill()
        self.assertLess(meter.seconds, 1.5)
        self.assertGreater(meter.seconds, 0.05)

    def test_what_it_starts_counts_too(self):
        one = self.started(f"({LOOP}) & ({LOOP}) & sleep 9; wait")
        with Meter() as meter:
            meter.add(one)
            time.sleep(2.0)
            below = family(one.first)
            for process in reversed(below):
                with contextlib.suppress(ProcessLookupError):
                    os.kill(process, 9)
        self.assertGreaterEqual(len(below), 4)
        self.assertGreater(sum(meter.processor_s.values()), 0.1)

    def test_nothing_started_is_nothing(self):
        with Meter() as meter:
            time.sleep(0.6)
        self.assertEqual(meter.seconds, 0)


if __name__ == "__main__":
    unittest.main()
