"""./course study --stretch: the criterion of success."""
import json
import unittest

from check.stretch import measure, missing
from tree import BUILD, ROOT, exercises


def found(error, time_ms, reference_error=0.01):
    return {"reference": {"error": reference_error, "time_ms": 10.0}, "yours": {"error": error, "time_ms": time_ms}}


class StretchTest(unittest.TestCase):
    def test_error_first_then_time(self):
        task = {"margin": 0.9}
        self.assertEqual(missing(task, found(0.01, 9.0)), "")
        self.assertIn("at most 0.010000", missing(task, found(0.0101, 1.0)))
        self.assertIn("95 %", missing(task, found(0.0, 9.5)))
        self.assertIn("at most 0.001000", missing(task | {"error": 0.001}, found(0.002, 1.0)))
        self.assertTrue(missing(task, found(float("nan"), 1.0)))

    def test_every_task_names_what_there_is(self):
        files = sorted((ROOT / "tests").glob("*/stretch.json"))
        self.assertTrue(files)
        for file in files:
            task = json.loads(file.read_text())
            self.assertIn(task["exercise"], exercises(file.parent.name))
            self.assertTrue(0 < task["margin"] < 1)

    @unittest.skipUnless((BUILD / "chapters" / "02_lambert_phong").exists() and
                         (ROOT / "shaders" / "02_lambert_phong" / "solution").exists(), "chapter 02 is not built")
    def test_a_starter_does_not_reach_it(self):
        """Nor its error, where its picture differs."""
        for file in sorted((ROOT / "tests").glob("*/stretch.json")):
            chapter, task = file.parent.name, json.loads(file.read_text())
            task["options"][-1] = "96x54"
            with self.subTest(chapter=chapter):
                result = measure(chapter, task, rounds=2, frames=1)
                if chapter != "03_attenuation":  # its starter culls nothing: right, and faster with culling
                    self.assertIn("its error is", missing(task, result))
