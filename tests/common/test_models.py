"""The conformance set, as ./course run --models draws it: each property that a model file can state is drawn, named as left out, or refused."""
# Builds: 04_surface_maps
import json
import os
import subprocess
import unittest

import models
from folder_case import FolderCase
from tree import BUILD, PYTHON, ROOT, chapter_program

os.environ.setdefault("GALLIVM_PERF", "nopt")


class Conformance(FolderCase):
    def test_all(self):
        self.assertTrue(chapter_program(models.CHAPTER).exists(), "build it first")
        for result in models.verdicts([], self.folder):
            with self.subTest(result["name"], says=result["says"]):
                self.assertEqual(result["wrong"], "")

    @unittest.skipUnless(BUILD == ROOT / "build", "./course builds there")
    def test_the_command_writes_a_page(self):
        done = subprocess.run([*PYTHON, ROOT / "common/course/cli.py", "run", "--models", "sheen"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 of 1 right; build/models/index.html\n", done.stdout)
        self.assertIn("data:image/", (BUILD / "models/index.html").read_text(encoding="utf-8"))

    def test_list(self):
        """--list model says what was read and what was left out."""
        program = [chapter_program(models.CHAPTER), "--list", "model"]
        said = models.run_program([*program, models.SET / "sheen.gltf"])
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("left out: KHR_materials_sheen (1 material)", said.stdout)
        listed = json.loads(models.run_program([*program, models.SET / "skin.gltf", "--json"]).stdout)
        self.assertEqual((listed["vertices"], listed["triangles"], listed["skins"], len(listed["cameras"])), (4, 2, 1, 1))
        self.assertEqual(listed["left_out"], [])
        listed = json.loads(models.run_program([*program, models.SET / "face_colors.ply", "--json"]).stdout)
        self.assertEqual([one["what"] for one in listed["left_out"]], ["colours of faces"])
