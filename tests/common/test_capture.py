"""--capture: one frame for RenderDoc. Its library is replaced by one of our own, which records its calls; the real one
offers Vulkan 1.3 only on drivers that can replay the addresses of buffers, and lavapipe cannot."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bad_input import CHAPTERS, BadInput  # noqa: E402
from played_renderdoc import play, why_not  # noqa: E402

class Captured(BadInput):
    def setUp(self):
        super().setUp()
        if why := why_not(CHAPTERS["01"].parents[1] / "liblightwalk.so"):
            self.skipTest(why)
        place = Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.said, self.environment = place / "said", play(place)

    def test_the_last_frame_alone_is_captured(self):
        out = self.folder / "frame.rdc"
        done = self.run_program(CHAPTERS["01"], "--size", "64x48", "--frames", "3", "--capture", out, **self.environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(out.read_text(), "RDOC")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["frame.rdc"])
        self.assertEqual(self.said.read_text().split("\n")[:-1], ["no keys", "no overlay", "start", "end"])

    def test_no_capture_is_a_failure_and_no_file(self):
        self.environment["FAILS"] = "1"
        done = self.run_program(CHAPTERS["01"], "--size", "64x48", "--capture", self.folder / "x.rdc", **self.environment)
        self.assertEqual((done.returncode, done.stderr), (1, "error: RenderDoc made no capture\n"))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_what_cannot_be_written_is_one_line(self):
        done = self.run_program(CHAPTERS["01"], "--size", "64x48", "--capture", "/no/such/frame.rdc", **self.environment)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"\Aerror: [^\n]*/no/such[^\n]*\n\Z")

    @unittest.skipUnless(Path("/usr/lib/librenderdoc.so").exists(), "there is no RenderDoc: apt-get install renderdoc")
    def test_the_real_one(self):
        """A capture in which passes and objects have their names; or, where the driver cannot, one line that says so."""
        out = self.folder / "frame.rdc"
        done = self.run_program(CHAPTERS["01"], "--size", "64x48", "--capture", out)
        if done.returncode:
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, r"\Aerror: --capture: RenderDoc hides Vulkan 1.3 [^\n]*\n\Z")
            return
        xml = self.folder / "frame.xml"
        subprocess.run(["renderdoccmd", "convert", "-f", out, "-o", xml, "-c", "xml"], check=True, stdout=subprocess.DEVNULL)
        for name in ("clay", "encode_srgb"):
            self.assertIn(f">{name}<", xml.read_text(errors="replace"))


if __name__ == "__main__":
    unittest.main()
