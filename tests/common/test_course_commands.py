"""Each command of ./course with each of its options, for real, and what it makes opened: as a user without root, a home or a display,
whose umask hides and whose locale is not there, in a built tree of the first two chapters."""
# Builds: 01_obj 02_lambert_phong check_01_obj check_02_lambert_phong compare

import ast
import io
import json
import re
import subprocess
import unittest
import urllib.request
import xml.etree.ElementTree
import zipfile
from pathlib import Path

from PIL import Image

from commands import COMMANDS, names
from cut_course import USER, enter, why_not
from small_course import REAL, until

DRIVER = next(Path("/usr/share/vulkan/icd.d").glob("lvp_icd.*json"), "")
LAMBERT = Path("shaders/02_lambert_phong/exercise/lambert.glsl")
# In order: the words behind ./course, the exit code, what it says, and what it makes.
ROWS = [
    ("doctor", 0, r"GB free in build", ""),
    ("release --only gpu", 0, r"gpu: not run: no Vulkan device of this machine is hardware\n", ""),
    ("run", 0, r"nobody answers at DISPLAY=:93[^\n]*\n.*index\.html: 2 pictures", "build/gallery"),
    ("run 02 --size 96x64 --screenshot OUT/one.png", 0, r"", "OUT/one.png"),
    ("run --gallery --shard 1/2 --out OUT/gallery", 0, r"\.zip: 7 of 12 pictures", "OUT/gallery"),
    ("run --gallery --shard 2/2 --out OUT/gallery", 0, r"\.zip: 5 of 12 pictures", "OUT/gallery"),
    ("run --gallery --merge OUT/gallery", 0, r"index\.html: 12 pictures", "build/gallery"),
    ("check 02.lambert --hint", 1, r"open  02\.lambert .*\n.*expected 0\n.*the cosine between", ""),
    ("check --progress", 1, r"0 of 5", ""),
    ("check --next", 0, r"01\.", ""),
    ("check 02.lambert --json", 1, r'\A\{"exercise": "02.lambert", "ok": false', ""),
    ("shader 02_lambert_phong/shade.frag", 0, r"float lambert\(", ""),
    ("shader lambert.glsl --chapter 02 --use exercise", 0, r"float lambert\(", ""),
    ("shader --list", 0, r"02_lambert_phong/shade\.frag", ""),
    ("accept 02.teapot", 0, r"02\.teapot: as it was", ""),
    ("reset 01.transform", 0, r"transform\.glsl is the starter", ""),
    (f"accept 02.mist --yes --second-driver {DRIVER}", 0, r"02\.mist: as it was", "tests/02_lambert_phong/golden"),
    ("format --check", 0, r"", ""),
    ("format", 0, r"", ""),
    ("docs --quote", 0, r"", ""),
    ("docs --check 02 --list", 0, r"\./course run 02 --shot teapot[^\n]*\n(.*\n)*no figure is wrong", ""),
    ("docs --slides 02 --out OUT/slides", 0, r"02_lambert_phong\.html: \d\d slides", "OUT/slides"),
    ("docs --book 02 --out OUT/book.pdf", 0, r"book\.pdf: \d\d pages", "OUT/book.pdf"),
    ("docs", 0, r"build/docs/index\.html: \d\d pages", "build/docs"),
    ("docs --site OUT/site --no-film", 0, r"site/index\.html: \d\d pages", "OUT/site"),
    ("study 01 --errors --size 96x54 --rounds 1 --device llvmpipe --shard 1/1 --out OUT/studies", 0, r"", "OUT/studies"),
    ("study --merge OUT/studies --out OUT/merged", 0, r"", "OUT/merged"),
    ("study 02 --timings --rounds 1 --size 96x54 --out OUT/timings", 0, r"", "OUT/timings"),
    ("study 01 --errors --size 96x54 --rounds 1 --out OUT/slurm --slurm --shards 1", 0, r"job 7: 1 parts", "OUT/slurm"),
    ("study 02 --stretch --json", 1, r'\A\{.*"missing": "its error is', "build/stretch/02_lambert_phong"),
    ("test ^shots.01$ --shard 1/1 --out OUT/shards", 0, r"", "OUT/shards"),
    ("test --merge OUT/shards", 0, r"100% tests passed, 0 tests failed out of 1", "build/report/index.html"),
    ("test --device llvmpipe 02.teapot --out OUT/device.json", 0, r"1 of 1", "OUT/device.json"),
    ("test --device llvmpipe 02.teapot --out OUT/again.json --against OUT/device.json", 0, r"1 of 1", "build/report/device.html"),
    ("handout OUT/sources --sources", 0, r"files, 10 exercises, no solutions", "OUT/sources/docs"),
    ("handout OUT/autograder --autograder --chapter 02 --rules OUT/rules.json", 0, r"", "OUT/autograder"),
    ("handout --autograder --prepare --chapter 02", 0, r"", "build/tests/check_02_lambert_phong"),
    ("handout OUT/handout", 0, r"files, 10 exercises, no solutions", "OUT/handout/docs"),
    ("grade OUT/class --chapter 02 --out OUT/grades --rules OUT/rules.json --budget 5 --format csv", 0, r"ann +1/5", "OUT/grades"),
    ("grade OUT/class --chapter 02 --out OUT/again --json --regrade 02.lambert", 0, r'"02\.lambert"', "OUT/again"),
    ("grade OUT/class --chapter 02 --shard 1/1 --out OUT/parts", 0, r"", "OUT/parts"),
    ("grade --merge OUT/parts --roster OUT/canvas.csv --format canvas --out OUT/whole", 0, r"ann +1/5", "OUT/whole"),
]
SERVED = "serve --no-build --port 0 --address 127.0.0.2 --refine off --open"
# What another test runs, each in one call; those of test_course.py and test_live.py with a small course's programs.
ELSEWHERE = {
    "common/test_newcomer.py": ("run --menu", "fuzz"),
    "common/test_first_contact.py": ("clean",),
    "common/test_models.py": ("run --models",),
    "19_ambiance/test_film.py": ("run --film", "run --table", "run --page", "run --slurm", "run --shards"),
    "common/test_grade_slurm.py": ("grade --slurm", "grade --shards"),
    "common/test_course_new.py": ("new",),
    "common/test_live.py": ("serve --behind", "serve --socket"),
    "common/test_course.py": ("test --all", "test --changed", "test --with-changed", "test --sanitize"),
    "common/test_course_container.py": ("test --on",),
    "common/test_autograder.py": ("handout --classroom", "handout --grade"),
    "common/test_pages_small.py": ("docs --open",),
}
# Of a desktop and of a cluster with one node, which are none of the course's.
PROGRAMS = {"xdg-open": 'cp -p "$1" /mnt/mine/opened; exec sleep 5', "squeue": "",
            "sbatch": 'for SLURM_ARRAY_TASK_ID in $(seq "${2#--array=1-}"); do export SLURM_ARRAY_TASK_ID; sh "$3" >&2 || exit; done; echo 7'}
TEXTS = [path.read_text(encoding="utf-8") for path in [REAL / "README.md", *sorted((REAL / "docs").glob("*.md"))]]
CHAPTERS = re.compile(r"run (\d\d|NN|--menu|--size)\b(?!.*--(film|table|page))")  # whose options are its own


def named(text: str) -> set[tuple[str, str]]:
    """The commands of the course in a text, and the options of each."""
    found = {(words.split()[0], option) for words in re.findall(r"\./course ([a-z][^`\n|#]*)", text) if not CHAPTERS.match(words)
             for option in ["", *re.findall(r"(?<![\w='-])--[a-z][a-z-]+", re.split(r"  |; |, |=(?=')", words)[0])]}
    return {(command, option) for command, option in found if option != "--help" and command in names()}


def words_of_calls(file: Path) -> list[set[str]]:
    """The words in the texts of each call, with the name of what is called."""
    calls = [part for part in ast.walk(ast.parse(file.read_text(encoding="utf-8"))) if isinstance(part, ast.Call)]
    return [{word for part in ast.walk(call) if isinstance(part, ast.Constant) and isinstance(part.value, str) for word in part.value.split()} |
            {getattr(call.func, "id", "")} for call in calls]


class Options(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.helped = {(command, "") for command in names()}
        for key in COMMANDS:
            if key not in ("run --table", "run --page"):  # their help is that of --film
                said = subprocess.run([REAL / "course", *key.split(), "--help"], check=True, stdout=subprocess.PIPE, text=True).stdout
                cls.helped |= {(key.split()[0], option) for option in re.findall(r"^  (--[a-z][a-z-]+)", said, re.M)} | named(said)

    def test_each_that_help_names_is_run(self):
        run = named("\n".join(f"./course {words}" for words in [SERVED] + [row[0] for row in ROWS] + [words for of in ELSEWHERE.values() for words in of]))
        self.assertEqual(sorted(self.helped - run), [])
        for file, rows in ELSEWHERE.items():
            calls = words_of_calls(REAL / "tests" / file)
            self.assertEqual([words for words in rows if not any(call.issuperset(words.split()) for call in calls)], [], file)

    def test_each_that_a_text_names_is_in_help(self):
        self.assertEqual(sorted(named("\n".join(TEXTS)) - self.helped - {("run", "--size")}), [])  # which a film's chapter takes


def opened(path: Path):
    """Raises where a file, or a file of a folder, is empty or is not what it is called."""
    for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
        if not file.is_file() or file.name in ("__init__.py", ".nojekyll"):
            continue
        data = file.read_bytes()
        if not data:
            raise ValueError(f"{file} is empty")
        if file.suffix in (".png", ".jpg", ".webp"):
            Image.open(io.BytesIO(data)).load()
        elif file.suffix == ".json":
            json.loads(data)
        elif file.suffix == ".svg":
            xml.etree.ElementTree.fromstring(data)
        elif file.suffix == ".zip" and zipfile.ZipFile(io.BytesIO(data)).testzip():
            raise ValueError(f"{file} is damaged")
        elif not data.startswith({".pdf": b"%PDF", ".woff2": b"wOF2"}.get(file.suffix, b"")):
            raise ValueError(f"{file} is something else")
    if path.is_dir() and not any(path.rglob("*.*")):
        raise ValueError(f"{path} has no file")


@unittest.skipIf(why_not(), why_not())
class Rows(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.out = enter()
        cls.environment = {"PATH": f"{cls.out}/bin:/usr/bin:/bin", "CCACHE_DIR": "/mnt/compiled", "DISPLAY": ":93", "LC_ALL": "ja_JP.eucJP", "TZ": "Asia/Kathmandu"}
        cls.put(cls.out / "class/ann" / LAMBERT, (REAL / str(LAMBERT).replace("exercise", "solution")).read_text())
        cls.put(cls.out / "rules.json", "{}")
        for name, script in PROGRAMS.items():
            cls.put(cls.out / "bin" / name, f"#!/bin/sh\n{script}\n")
            (cls.out / "bin" / name).chmod(0o755)
        cls.put(cls.out / "canvas.csv", "Student,ID,SIS User ID,SIS Login ID,Section\nExample Ann,1,1,ann,one\n")

    @classmethod
    def put(cls, path: Path, text: str):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        subprocess.run(["chown", "-R", f"{USER}:{USER}", cls.out, path], check=True)

    def start(self, *words) -> subprocess.Popen:
        return subprocess.Popen(["setpriv", f"--reuid={USER}", f"--regid={USER}", "--clear-groups", "sh", "-c", 'umask 077; exec "$0" "$@"', REAL / "course", *words],
                                cwd="/", env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, encoding="utf-8")

    def course(self, words: str, code: int = 0) -> str:
        with self.start(*words.replace("OUT", str(self.out)).split()) as process:
            said = process.stdout.read()
        self.assertEqual(process.returncode, code, said)
        self.assertNotRegex(said, "Traceback|WARNING|Warning:")
        return said

    def test_1_each_row(self):
        for words, code, says, made in ROWS:
            with self.subTest(words):
                said = self.course(words, code)
                self.assertRegex(said, f"(?s){says}")
                if made:
                    opened(self.out / made[4:] if made.startswith("OUT/") else REAL / made)

    def test_2_what_is_served(self):
        """The browser gets a page of the user's alone, not the address with its token; nobody waits for it."""
        with self.start(*SERVED.split()) as server:
            self.addCleanup(server.terminate)
            address, opened = server.stdout.readline().strip(), self.out / "opened"
            until(opened.exists)
            until(opened.read_text)
            self.assertIn(f'url={address}"', opened.read_text())
            self.assertEqual(opened.stat().st_mode & 0o777, 0o600)
            page = urllib.request.build_opener(urllib.request.HTTPCookieProcessor()).open(address).read()
            server.terminate()
            self.assertRegex(address, r"\Ahttp://127\.0\.0\.2:\d+/\?token=")
            self.assertIn(b"Lightwalk", page)
            self.assertEqual(server.wait(), 0)

    def test_3_what_is_handed_out(self):
        """It takes this tree's place, with its build: what differs is built again."""
        handout = self.out / "handout"
        (handout / "build").mkdir()
        subprocess.run(["sh", "-ec", 'chown -R "$3" "$1"; mount --bind "$2/build" "$1/build"; mount --rbind "$1" "$2"', "", handout, REAL, f"{USER}:{USER}"], check=True)
        self.assertEqual([path for kind in ("chapters", "shaders") for path in (REAL / kind).rglob("solution")], [])
        self.assertIn("open  02.lambert", self.course("check 02.lambert", 1))
        self.assertIn("next: 01.transform", self.course("check --next"))
        answer = (self.out / "class/ann" / LAMBERT).read_text()
        self.put(REAL / LAMBERT, answer)
        self.assertIn("ok    02.lambert", self.course("check 02.lambert"))
        self.assertIn("1 of 5 exercises are solved", self.course("check 02", 1))
        self.course("run 02 --use exercise --size 96x64 --screenshot OUT/handed.png")
        opened(self.out / "handed.png")
        self.assertIn(f"your answer is {LAMBERT}.1.old", self.course("reset 02.lambert"))
        self.assertEqual((REAL / f"{LAMBERT}.1.old").read_text(), answer)
        self.assertIn("open  02.lambert", self.course("check 02.lambert", 1))
