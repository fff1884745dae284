"""A first ./course run on the computers that people have: displays, drivers, users and folders, each pair of them once.

Each ends with a window, with a picture, or with one line that names a way out, which is typed until there is one. The tree is a
clone, in a folder with blanks and accents, that ./course built.
"""
# Builds: nothing

import itertools
import os
import re
import shlex
import shutil
import socket
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

from small_course import REAL
from test_bad_drivers import shim
from test_newcomer import clone
from x_server import XServer

VALUES = {"display": ("none", "stale", "X", "Wayland", "16 bits"), "driver": ("lavapipe", "a card that cannot present", "none", "a broken manifest"),
          "person": ("root", "a user", "a user without a home"), "place": ("writable", "read-only", "TMPDIR without exec", "full disc")}
ICD = "/usr/share/vulkan/icd.d"
USER = ("setpriv", "--reuid=12345", "--regid=12345", "--clear-groups")
RUN = ["run", "02", "--size", "96x64"]
PATIENCE_S = 120


def pairwise() -> list[dict[str, str]]:
    """Rows with each pair of values of two keys, the row first that has most new pairs."""
    rows = [dict(zip(VALUES, row)) for row in itertools.product(*VALUES.values())]
    pairs = {id(row): set(itertools.combinations(row.items(), 2)) for row in rows}
    missing, found = set().union(*pairs.values()), []
    while missing:
        found.append(max(rows, key=lambda row: len(pairs[id(row)] & missing)))
        missing -= pairs[id(found[-1])]
    return found


def can_mount() -> bool:
    return os.geteuid() == 0 and subprocess.run(["unshare", "-m", "true"], stderr=subprocess.DEVNULL).returncode == 0


@unittest.skipUnless((REAL / ".git").exists(), "it clones")
@unittest.skipUnless(can_mount(), "only root can be other users and mount folders")
class FirstContact(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="lightwalk."))).resolve()
        cls.folder.chmod(0o755)
        cls.root = cls.folder / "Übung – Course à moi" / "light walk"
        cls.root.parent.mkdir()
        clone(cls.root)
        outer = {name: value for name, value in os.environ.items() if not name.startswith("LIGHTWALK_")}
        done = subprocess.run([cls.root / "course", *RUN, "--screenshot", cls.folder / "first.png"], env=outer, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        assert done.returncode == 0, done.stdout
        cls.give(cls.root)
        cls.shim = shim(cls.folder)
        cls.screens = {}
        for name, depth in (("X", 24), ("16 bits", 16)):
            cls.screens[name] = XServer(depth=depth)
            cls.addClassCleanup(cls.screens[name].close)
        cls.wayland = socket.socket(socket.AF_UNIX)
        cls.addClassCleanup(cls.wayland.close)
        cls.wayland.bind(str(cls.folder / "wayland-9"))
        (cls.folder / "wayland-9").chmod(0o777)
        cls.wayland.listen(64)
        [cls.lavapipe] = Path(ICD).glob("lvp_icd.*json")
        shutil.copy(cls.lavapipe, cls.folder / "second.json")

    @staticmethod
    def give(folder: Path):
        subprocess.run(["chown", "-R", "12345:12345", folder], check=True)

    def test_each_pair(self):
        for number, row in enumerate(pairwise()):
            with self.subTest(**row):
                home = self.folder / str(number)
                home.mkdir()
                self.give(home)
                try:
                    ended = self.follow(row, home)
                    self.assertEqual(ended, "a window" if row["display"] == "X" else ended)
                finally:
                    shutil.rmtree(home, ignore_errors=True)

    def test_what_a_student_types(self):
        """In that clone, as a user whose compiler has no cache yet; test_course_commands.py has the other commands."""
        home = self.folder / "student"
        home.mkdir()
        self.give(home)

        def course(*words: str) -> str:
            done = subprocess.run([*USER, "env", "-i", "PATH=/usr/bin:/bin", f"HOME={home}", f"CCACHE_DIR={home}/ccache", self.root / "course", *words],
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertEqual(done.returncode, 0, done.stdout)
            return done.stdout
        self.assertIn("02.lambert", course("run", "02", "--list", "exercises"))
        place = self.root / "shaders/02_lambert_phong/exercise/lambert.glsl"
        place.write_bytes((REAL / "shaders/02_lambert_phong/solution/lambert.glsl").read_bytes())
        self.assertIn("ok    02.lambert", course("check", "02.lambert"))
        self.assertEqual(course("clean"), "")
        self.assertFalse((self.root / "build").exists())

    def follow(self, row: dict, home: Path) -> str:
        """Types the command, and what it says, until there is something to see."""
        words, root, before = RUN, self.root, []
        (home / "icd").mkdir()
        if row["driver"] != "none":
            shutil.copy(self.lavapipe, home / "icd")
        if row["driver"] == "a broken manifest":
            (home / "icd/broken.json").write_text("{")
        for _ in range(4):
            code, said = self.typed(row, root, words, home, before)
            if code == "a window" or (home / "picture.png").exists():
                return code or "a picture"
            self.assertIn(code, (1, 2), said)
            self.assertNotIn("Traceback", said)
            line = said.strip().splitlines()[-1]
            self.assertLessEqual(said.count("\n"), 3, said)
            before = []
            if found := re.search(r"; type(?:, as root:)? (mv .*)$", line):
                before = [found[1]]
            elif found := re.search(r"\./course (run 02 --screenshot picture\.png)$", line):
                words = [*found[1].split(), *RUN[2:]]
            elif found := re.search(r"as root: apt-get install (\S+)$", line):
                installed = subprocess.run(["dpkg", "-L", found[1]], stdout=subprocess.PIPE, text=True).stdout
                self.assertIn(ICD, installed)  # it brings what was hidden
                shutil.copy(self.lavapipe, home / "icd")
            elif found := re.search(r"; .*type (cp -r .*)$", line):
                subprocess.run(found[1], shell=True, check=True)
                root = Path(shlex.split(found[1])[-1])
                self.addCleanup(shutil.rmtree, root)
            else:
                self.fail(f"no way out: {said}")
        self.fail(f"it leads nowhere: {said}")

    def environment(self, row: dict, home: Path) -> dict[str, str]:
        found = {"PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "XDG_RUNTIME_DIR": str(self.folder)}
        if row["driver"] == "a card that cannot present":
            found |= {"VK_DRIVER_FILES": f"{self.lavapipe}:{self.folder / 'second.json'}", "PLAYS": "blind", "CALLS": "0", "LD_PRELOAD": str(self.shim)}
        if row["person"] != "a user without a home":
            found["HOME"] = str(home)
        if row["display"] in self.screens:
            found["DISPLAY"] = self.screens[row["display"]].display
        found |= {"stale": {"DISPLAY": ":93"}, "Wayland": {"WAYLAND_DISPLAY": "wayland-9"}}.get(row["display"], {})
        if row["place"] == "TMPDIR without exec":
            found["TMPDIR"] = "/mnt"
        return found

    def typed(self, row: dict, root: Path, words: list[str], home: Path, before: list[str]) -> tuple[int | str, str]:
        """The exit code, or that there is a window, and what was printed on the error stream. `before` is typed by root."""
        tree, upper = shlex.quote(str(self.root)), shlex.quote(str(home / "upper"))
        mounts = ["set -e", f"mount --bind {home}/icd {ICD}", *before]
        mounts += {"read-only": [f"mount --bind {tree} {tree}", f"mount -o remount,bind,ro {tree}"],
                   "TMPDIR without exec": ["mount -t tmpfs -o noexec,mode=1777 tmpfs /mnt"],
                   "full disc": [f"mkdir -p {upper}", f"mount -t tmpfs -o size=64k tmpfs {upper}", f"mkdir {upper}/new {upper}/work",
                                 f"chown 12345 {upper}/new", f"mount -t overlay -o lowerdir={tree},upperdir={upper}/new,workdir={upper}/work overlay {tree}",
                                 f"cat /dev/zero 2>/dev/null >{tree}/full || true"]}.get(row["place"], [])
        user = () if row["person"] == "root" else USER
        started = shlex.join([*user, "env", "-i", *[f"{name}={value}" for name, value in self.environment(row, home).items()], str(root / "course"), *words,
                              *(["--events", "on"] if "--screenshot" not in words else [])])
        with open(home / "said", "w+", encoding="utf-8") as errors, subprocess.Popen(
                ["unshare", "-m", "sh", "-c", "\n".join([*mounts, f"exec {started}"])], cwd=home, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                stderr=errors, text=True) as process:
            watch, code = threading.Timer(PATIENCE_S, process.kill), None
            watch.start()
            for line in process.stdout:
                if line == "first picture\n":
                    code = "a window"
                    process.kill()
            process.wait()
            watch.cancel()
            errors.seek(0)
            return process.returncode if code is None else code, errors.read()
