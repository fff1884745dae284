"""Tests of the course's descriptions for other systems: the workflow of a public CI, the dev container, editors,
docs/elsewhere.md and the hours of docs/teaching.md."""
# Builds: nothing

import argparse
import json
import re
import subprocess
import unittest

from cli import COMMANDS
from test import run_tests
from test.container import SYSTEMS
from tree import ROOT, chapters, lesson_pages

try:
    import yaml
except ImportError:
    yaml = None


def commands(text: str) -> list[list[str]]:
    """The words of each ./course in a shell's line."""
    return [found.split() for found in re.findall(r"\./course ([^&;|\n]*)", text)]


class Workflow(unittest.TestCase):
    @unittest.skipUnless(yaml, "there is no python3-yaml, which mkdocs brings")
    def test_its_steps_are_commands_of_the_course(self):
        said = yaml.safe_load((ROOT / ".github/workflows/test.yml").read_text())
        part, report = said["jobs"]["part"], said["jobs"]["report"]
        steps = [step["run"] for job in (part, report) for step in job["steps"] if "run" in step]
        for step in steps:
            script = re.sub(r"\$\{\{ matrix\.(\w+) \}\}", "1", step)
            self.assertEqual(subprocess.run(["bash", "-n"], input=script, text=True).returncode, 0, script)
            for command, *words in commands(script):
                self.assertEqual(command, "test")
                parser = argparse.ArgumentParser()
                run_tests.add_arguments(parser)
                _, rest = parser.parse_known_args(words)
                self.assertEqual(rest, [])
        parts = part["strategy"]["matrix"]["part"]
        shard = next(words for step in steps for words in commands(step) if "--shard" in words)
        self.assertEqual(shard[shard.index("--shard") + 1:][:1] and "".join(shard).count(f"/{len(parts)}"), 1)
        self.assertEqual(parts, list(range(1, len(parts) + 1)))
        self.assertEqual(part["strategy"]["matrix"]["system"], ["bookworm", "trixie"])
        self.assertEqual(report["needs"], "part")
        uploads = [step["with"]["name"] for job in (part, report) for step in job["steps"] if "upload-artifact" in step.get("uses", "")]
        self.assertEqual(len(uploads), 2)

    @unittest.skipUnless(yaml, "there is no python3-yaml, which mkdocs brings")
    def test_the_workflow_of_the_site_publishes_what_it_writes(self):
        said = yaml.safe_load((ROOT / ".github/workflows/pages.yml").read_text())
        steps = said["jobs"]["publish"]["steps"]
        for step in steps:
            self.assertEqual(len({"run", "uses"} & set(step)), 1, step)
            self.assertEqual(subprocess.run(["bash", "-n"], input=step.get("run", ""), text=True).returncode, 0, step)
        written = [words for step in steps for words in commands(step.get("run", ""))]
        self.assertEqual(written, [["docs", "--site", "site"]])
        uploaded = next(step for step in steps if "upload-pages-artifact" in step.get("uses", ""))
        self.assertEqual(uploaded["with"]["path"], written[0][-1])
        self.assertIn("actions/deploy-pages@", steps[-1]["uses"])
        self.assertEqual(said["permissions"], {"contents": "read", "pages": "write", "id-token": "write"})
        self.assertIn(said["jobs"]["publish"]["container"]["image"], [f"debian:{system}" for system in SYSTEMS])

    def test_an_action_is_one_commit_in_all_workflows(self):
        used = {}
        for path in (ROOT / ".github/workflows").glob("*.yml"):
            text = path.read_text()
            for what in re.findall(r"uses: (.*)", text):  # by its commit: a tag may be moved to another one
                self.assertRegex(what, r"^[\w./-]+@[0-9a-f]{40} # v[\d.]+$", path.name)
                action, _, version = what.partition("@")
                self.assertEqual(used.setdefault(action, version), version, f"{path.name}: {action}")
            self.assertRegex(text, r"(?m)^permissions:\n  contents: read\n", path.name)
        self.assertGreater(len(used), 5)

    def test_the_container_does_what_the_readme_says(self):
        said = json.loads((ROOT / ".devcontainer/devcontainer.json").read_text())
        first = re.findall(r"^    (\./course \w+)$", (ROOT / "README.md").read_text(), re.M)[:2]
        made = [words for key in ("updateContentCommand", "postCreateCommand") for words in commands(said[key])]
        self.assertEqual([f"./course {' '.join(words)}" for words in made], first)
        self.assertEqual(said["image"], "debian:12")


class Editors(unittest.TestCase):
    def read(self, name: str) -> dict:
        return json.loads((ROOT / ".vscode" / name).read_text())

    def test_each_chapter_is_started_by_a_command_of_the_course_and_debugged(self):
        tasks, launch = self.read("tasks.json"), self.read("launch.json")
        for said in (tasks, launch):
            self.assertEqual(said["inputs"][0]["options"], chapters())
        for task in tasks["tasks"]:
            self.assertEqual(task["command"], "./course", task["label"])
            self.assertIn(task["args"][0], COMMANDS, task["label"])
        for configuration in launch["configurations"]:
            self.assertEqual(configuration["program"], "${workspaceFolder}/build/chapters/${input:chapter}")
            self.assertIn(configuration["preLaunchTask"], [task["label"] for task in tasks["tasks"]])


class Page(unittest.TestCase):
    def test_it_names_what_the_program_asks_for(self):
        source = (ROOT / "common/gpu/device_features.cpp").read_text()
        page = (ROOT / "docs/elsewhere.md").read_text()
        needed = re.findall(r"need\(has1\d\.(\w+)", source) + re.findall(r"FEATURE\((\w+)\)[,}]", source)
        self.assertGreater(len(needed), 12)
        for name in needed:
            self.assertIn(f"`{name}`", page)

    def test_hours_follow_from_the_lessons(self):
        """As the page says they were estimated."""
        rows = re.findall(r"^\| (\d\d) [^|]*\|[^|]*\| (\d+), (\d+), (\d+) \| ([\d.]+) \|$", (ROOT / "docs/teaching.md").read_text(), re.M)
        self.assertGreater(len(rows), 15)
        for number, *counts, hours in rows:
            [name] = [chapter for chapter in chapters() if chapter.startswith(number)]
            text = "\n".join((ROOT / page).read_text() for page in lesson_pages(name))
            graded = [len(re.findall(rf"^### \d\d\.\w+ \({grade}\)$", text, re.M)) for grade in ("easy", "medium", "hard")]
            self.assertEqual(list(map(int, counts)), graded, name)
            text = re.sub(r"^( *)```.*?^\1```|<details>.*?</details>|<!--.*?-->", "", text, flags=re.M | re.S)
            text = re.sub(r"^\|.*$|!?\[[^\]]*\]\([^)]*\)", "", text, flags=re.M)
            estimate = len(text.split()) / 120 / 60 + (15 * graded[0] + 35 * graded[1] + 75 * graded[2]) / 60
            self.assertLess(abs(float(hours) - estimate), 0.35, name)
