"""Pictures with music: functions of time alone, silent or not."""
import shutil
import subprocess
import unittest

from bad_input import BUILD, ROOT, BadInput

CHAPTER = BUILD / "chapters" / "14_environment"
SMALL = ("--size", "96x54", "--environment.prefilter.samples", "4")


class Music(BadInput):
    def draw(self, name, *arguments, scene="assets/scenes/beat.json") -> bytes:
        picture = self.folder / f"{name}.png"
        done = self.run_program(CHAPTER, "--scene", scene, *SMALL, *arguments, "--validate", "on", "--screenshot", picture)
        said = [line for line in done.stderr.splitlines() if not line.startswith("drawing: ")]  # where it takes long
        self.assertEqual((done.returncode, said), (0, []), arguments)
        return picture.read_bytes()

    def test_time_alone(self):
        cold = self.draw("cold", "--time", "9.25")
        # The last of 16 frames, a sixtieth of a second apart, is a quarter of a second later: exactly, as a float has it.
        self.assertEqual(cold, self.draw("frames", "--time", "9", "--frames", "16"))
        self.assertNotEqual(cold, self.draw("later", "--time", "9.5"))

    def test_silence(self):
        silent = self.draw("off", "--time", "9.25", "--music.plays", "off")
        self.assertEqual(silent, self.draw("before", "--time", "-1"))
        self.assertEqual(silent, self.draw("after", "--time", "60"))
        scene = self.write("silent.json", (ROOT / "assets/scenes/beat.json").read_text().replace('"music": "audio/beat.ogg",', ""))
        self.assertEqual(silent, self.draw("without", "--time", "9.25", scene=scene))

    @unittest.skipUnless(shutil.which("ldd"), "ldd is missing")
    def test_programs_do_not_load_sound_libraries(self):
        """They take 12 ms to load; only a window with music does."""
        libraries = subprocess.run(["ldd", CHAPTER], capture_output=True, text=True, check=True).stdout
        self.assertNotIn("SDL2", libraries)
