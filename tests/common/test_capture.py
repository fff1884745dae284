"""--capture: a frame for RenderDoc, in which passes and objects have their names."""
import ctypes.util
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from bad_input import CHAPTERS, BadInput  # noqa: E402

LOADED = ctypes.util.find_library("renderdoc") or Path("/usr/lib/librenderdoc.so").exists()


class Captured(BadInput):
    @unittest.skipUnless(LOADED and shutil.which("renderdoccmd") and Path("/usr/include/renderdoc_app.h").exists(),
                         "there is no RenderDoc: apt-get install --no-install-recommends renderdoc librenderdoc-dev")
    def test_a_frame_with_the_names_of_its_passes(self):
        out = self.folder / "frame.rdc"
        done = self.run_program(CHAPTERS["01"], "--size", "64x48", "--frames", "2", "--capture", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([path.name for path in self.folder.glob("frame*")], ["frame.rdc"])
        xml = self.folder / "frame.xml"
        subprocess.run(["renderdoccmd", "convert", "-f", out, "-o", xml, "-c", "xml"], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        text = xml.read_text(errors="replace")
        self.assertEqual(text.count('name="vkQueueSubmit2"') + text.count('name="vkQueueSubmit"') > 0, True)
        for name in ("shade", "encode_srgb", "pass times"):
            self.assertIn(f">{name}<", text)

    def test_what_cannot_be_written_is_one_line(self):
        self.refuse(CHAPTERS["01"], "--size", "64x48", "--capture", "/no/such/frame.rdc", says="written|capture|RenderDoc")


if __name__ == "__main__":
    unittest.main()
