"""A few random scenes, validated; random_scenes.py draws many."""
import tempfile
import unittest

from random_scenes import CHAPTERS, draw, random_scene

FEW = 5


@unittest.skipUnless(CHAPTERS, "the chapters are not built")
class RandomScenes(unittest.TestCase):
    def test_the_same_seed_makes_the_same_scene(self):
        self.assertEqual(random_scene(7), random_scene(7))
        self.assertNotEqual(random_scene(7), random_scene(8))

    def test_no_chapter_has_anything_to_say(self):
        for seed in range(FEW):
            program = CHAPTERS[seed * len(CHAPTERS) // FEW]
            with self.subTest(program=program.name, seed=seed), tempfile.TemporaryDirectory() as folder:
                command, wrong = draw(program, seed, folder)
                self.assertEqual(wrong, "", " ".join(command))


if __name__ == "__main__":
    unittest.main()
