"""Tests of ./course test --on: a line with the reason if it cannot run, and the copy of the tree. ./course release runs it."""
# Builds: nothing

import os
import shutil
import subprocess
import sys
import unittest
from unittest import mock

from small_course import REAL, Course, write

from test import container
from test_course_trouble import AS_OTHER, READ_ONLY, can


class Refusals(Course):
    def refuse(self, expected: str, *words, **environment):
        command = [sys.executable, self.root / "common/course/cli.py", "test", "--on", *words]
        printed = self.run_program(command, 2, **environment)
        self.assertRegex(printed, rf"\Acourse: [^\n]*{expected}[^\n]*\n\Z")
        self.assertFalse((self.root / "build/on/trixie/root").exists())

    def only(self, **programs: str) -> str:
        """A PATH on which there are these programs alone: their texts."""
        folder = self.outside / "bin"
        for name, text in programs.items():
            write(folder / name, f"#!/bin/sh\n{text}\n")
            self.addCleanup((folder / name).unlink)
        return str(folder)

    def test_an_unknown_system(self):
        self.refuse("'woody' is not a system to test on; there are bookworm, trixie", "woody")

    @unittest.skipUnless(can(*AS_OTHER, "true"), "only root can be another user")
    def test_not_root(self):
        self.outside.chmod(0o755)
        shutil.rmtree(self.root / "build", ignore_errors=True)
        (self.root / "build").mkdir(mode=0o777)
        (self.root / "build").chmod(0o777)
        printed = self.run_program([*AS_OTHER, self.root / "course", "test", "--on", "trixie"], 2, HOME="/nonexistent")
        self.assertEqual(printed, "course: only root can make a container of another system: sudo ./course test --on trixie\n")

    @unittest.skipIf(os.geteuid(), "as root")
    def test_what_is_missing(self):
        self.refuse("there is no debootstrap .*: apt-get install debootstrap", "trixie", PATH=self.only())
        self.refuse("there is no bwrap .*: apt-get install bubblewrap", "trixie", PATH=self.only(debootstrap=""))

    @unittest.skipIf(os.geteuid(), "as root")
    def test_what_is_missing_is_installed_and_nothing_else(self):
        path = self.only(**{"dpkg-query": "", "apt-get": "exit 1"}) + ":/usr/bin:/bin"
        wanted = " ".join(name for group in ("base", "on") for name in
                          (REAL / "common/course/packages" / group).read_text().split())
        for words in (["--on", "trixie"], ["--on=trixie"], ["unit", "--on", "trixie"]):
            shutil.rmtree(self.root / "build/packages", ignore_errors=True)
            printed = self.run_program([self.root / "course", "test", *words], 1, PATH=path)
            self.assertEqual(printed.splitlines()[0], f"course: installing {wanted}")

    @unittest.skipIf(os.geteuid(), "as root")
    @unittest.skipUnless(can(*READ_ONLY, "true"), "another system's name is mounted")
    def test_another_release_is_asked_for_what_it_has(self):
        """By the names in its lists: what it lacks is left out, and said where only its apt knows."""
        apt = 'case "$*" in *"install "*unheard*) exit 1 ;; esac; echo "$@" >>OUT/asked'.replace("OUT", str(self.outside))
        path = self.only(**{"dpkg-query": "", "apt-get": apt, "apt-cache": '[ "$2" != unheard ]'}) + ":/usr/bin:/bin"
        self.put("common/course/packages/browsers", "firefox-esr\nunheard\nxvfb\n")
        self.put("common/course/packages/base", "python3\n")
        (self.outside / "release").write_text("ID=ubuntu\nVERSION_ID=22.04\n")
        shutil.rmtree(self.root / "build/packages", ignore_errors=True)
        self.put("course", (self.root / "course").read_text().replace('format) groups="base format"', 'format) groups="base browsers"'))
        printed = self.run_program([*READ_ONLY, "--ro-bind", str(self.outside / "release"), "/usr/lib/os-release", self.root / "course", "format", "--check"],
                                   None, PATH=path)
        self.assertIn("this is ubuntu 22.04, whose packages are known by name alone; the course was run on Debian 12 and 13", printed)
        self.assertIn("course: installing python3 unheard xvfb\n", printed)
        self.assertIn("course: ubuntu 22.04 has no package unheard\n", printed)
        self.assertRegex((self.outside / "asked").read_text(), r"install python3 xvfb\n\Z")


class Tree(Course):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for words in ("init -q", "add -A", "-c user.name=x -c user.email=x commit -qm x"):
            subprocess.run(["git", "-C", cls.root, *words.split()], check=True)

    def test_the_tree_there_is_the_tree_here(self):
        there = self.outside / "there"
        self.put("new.txt", "not committed")
        self.put("docs/02_lambert.md", "# Changed\n")
        self.remove("assets/models/b.obj")
        self.put("build/built", "left out")

        def copied():
            with mock.patch.multiple(container, ROOT=self.root), mock.patch("tree.ROOT", self.root):
                container.copy_tree(there)
            return {str(path.relative_to(there)): path.stat().st_mtime_ns for path in there.rglob("*")
                    if path.is_file() and ".git" not in path.parts}
        first = copied()
        self.assertEqual((there / "new.txt").read_text(), "not committed")
        self.assertEqual((there / "docs/02_lambert.md").read_text(), "# Changed\n")
        self.assertNotIn("assets/models/b.obj", first)
        self.assertNotIn("build/built", first)
        self.assertTrue(os.access(there / "course", os.X_OK))
        (there / "build").mkdir()
        (there / "build/kept").write_text("")
        (self.root / "new.txt").unlink()
        self.put("docs/01_obj.md", "# Again\n")
        second = copied()
        self.assertNotIn("new.txt", second)
        self.assertIn("build/kept", second)
        changed = {name for name in second if second[name] != first.get(name)} - {"build/kept"}
        self.assertEqual(changed, {"docs/01_obj.md"})
