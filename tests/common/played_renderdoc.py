"""A fake of RenderDoc's library: it records its calls. For tests on machines with drivers that the real one refuses."""

import re
import subprocess
from pathlib import Path

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
