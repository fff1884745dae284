"""--capture and F11: one frame for RenderDoc. Its library is replaced by one of our own, which records its calls; the real one
offers Vulkan 1.3 only on drivers that can replay the addresses of buffers, and lavapipe cannot."""

import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from bad_input import BUILD, CHAPTERS, BadInput
from window_case import CHAPTER, StartedTest

HEADER = Path("/usr/include/renderdoc_app.h")
# Implements the functions of the header, and records the calls in $SAID.
LIBRARY = r"""
#include <renderdoc_app.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
static char path[4096], made[4200];
static unsigned captures, capturing;
static void say(const char* what) { FILE* f = fopen(getenv("SAID"), "a"); fprintf(f, "%s\n", what); fclose(f); }
static void RENDERDOC_CC keys(RENDERDOC_InputButton* k, int n) { say(n ? "keys" : "no keys"); (void)k; }
static void RENDERDOC_CC overlay(uint32_t a, uint32_t o) { say(a | o ? "overlay" : "no overlay"); }
static int RENDERDOC_CC option(RENDERDOC_CaptureOption o, uint32_t v) { (void)o; (void)v; return 1; }
static void RENDERDOC_CC start(void* d, void* w) { say("start"); capturing = 1; (void)d; (void)w; }
static uint32_t RENDERDOC_CC is(void) { return capturing; }
static uint32_t RENDERDOC_CC end(void* d, void* w) {
    say("end"); capturing = 0; (void)d; (void)w;
    if (getenv("FAILS")) return 0;
    snprintf(made, sizeof made, "%s_frame0.rdc", path);
    FILE* f = fopen(made, "w"); fputs("RDOC", f); fclose(f);
    ++captures;
    return 1;
}
static uint32_t RENDERDOC_CC count(void) { return captures; }
static uint32_t RENDERDOC_CC get(uint32_t i, char* name, uint32_t* length, uint64_t* time) {
    (void)time;
    if (i >= captures) return 0;
    if (name) strcpy(name, made);
    *length = strlen(made) + 1;
    return 1;
}
static void RENDERDOC_CC place(const char* text) { snprintf(path, sizeof path, "%s", text); }
int RENDERDOC_CC RENDERDOC_GetAPI(RENDERDOC_Version version, void** out) {
    static RENDERDOC_API_1_1_2 api;
    api.SetCaptureKeys = keys; api.MaskOverlayBits = overlay; api.SetCaptureOptionU32 = option; api.StartFrameCapture = start;
    api.EndFrameCapture = end; api.IsFrameCapturing = is; api.GetNumCaptures = count; api.GetCapture = get;
    api.SetCaptureFilePathTemplate = place;
    *out = &api;
    return version == eRENDERDOC_API_Version_1_1_2;
}
"""


def why_not(library: Path) -> str:
    """Why it cannot be played to a course with this liblightwalk.so; empty where it can."""
    if not HEADER.exists():
        return "there is no renderdoc_app.h: apt-get install librenderdoc-dev, then build"
    return "" if b"RENDERDOC_GetAPI" in library.read_bytes() else "the course was built before there was renderdoc_app.h"


def play(folder: Path) -> dict[str, str]:
    """Makes the library there. The environment in which a program takes it for RenderDoc; it writes to folder/said."""
    source = folder / "renderdoc.c"
    source.write_text(LIBRARY)
    subprocess.run(["cc", "-shared", "-fPIC", "-o", folder / "librenderdoc.so", source], check=True)
    layers = [name for path in Path("/usr/share/vulkan/implicit_layer.d").glob("renderdoc*.json")
              for name in re.findall(r'"(DISABLE_VULKAN_RENDERDOC\w+)"', path.read_text())]
    return {"LD_LIBRARY_PATH": str(folder), "SAID": str(folder / "said")} | dict.fromkeys(layers, "1")


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


@unittest.skipIf(why_not(BUILD / "liblightwalk.so"), why_not(BUILD / "liblightwalk.so"))
class F11(StartedTest):
    """Where its library is loaded; elsewhere the window says how to load it."""

    def test_f11(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        environment = play(folder) | {"LD_PRELOAD": str(folder / "librenderdoc.so")}  # as RenderDoc starts a program
        session = self.start(CHAPTER, "--size", "64x48", **environment)
        path = Path(session.key("F11", says=r"capture (.*)")[1])
        self.assertRegex(path.name, r"\Alightwalk_01_[\d_-]+\.rdc\Z")
        self.assertEqual(path.read_text(), "RDOC")
        self.assertEqual((folder / "said").read_text().split("\n")[2:-1], ["start", "end"])  # one frame, and no other
        self.end(session)
