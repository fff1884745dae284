"""A driver that is too old, full, lost in mid-run, never done, or silent when it is: one line, no picture, never a hang.

A small library between the programs and Vulkan's loader plays such a driver.
"""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from bad_input import BUILD, CHAPTERS, BadInput
from window_session import XServer

SHIM = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>

/* Whether PLAYS says this fault, and as many calls as CALLS says went well before. */
static int plays(const char* fault, int* calls) {
    const char* name = getenv("PLAYS");
    return name && !strcmp(name, fault) && (*calls)++ >= atoi(getenv("CALLS"));
}
#define REAL(name) ((PFN_##name)dlsym(RTLD_NEXT, #name))

void vkGetPhysicalDeviceProperties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* out) {
    static int calls;
    REAL(vkGetPhysicalDeviceProperties2)(device, out);
    if (plays("old", &calls)) out->properties.apiVersion = VK_API_VERSION_1_2;
}
VkResult vkGetPhysicalDeviceSurfaceSupportKHR(VkPhysicalDevice device, uint32_t family, VkSurfaceKHR surface, VkBool32* out) {
    static VkPhysicalDevice first;
    static int calls;
    const VkResult result = REAL(vkGetPhysicalDeviceSurfaceSupportKHR)(device, family, surface, out);
    if (!first) first = device;
    if (device == first && plays("blind", &calls)) *out = VK_FALSE;
    return result;
}
VkResult vkCreateDevice(VkPhysicalDevice device, const VkDeviceCreateInfo* info, const VkAllocationCallbacks* memory,
                        VkDevice* out) {
    static int calls;
    return plays("taken", &calls) ? VK_ERROR_INITIALIZATION_FAILED : REAL(vkCreateDevice)(device, info, memory, out);
}
VkResult vkAllocateMemory(VkDevice device, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks* memory,
                          VkDeviceMemory* out) {
    static int calls;
    return plays("full", &calls) ? VK_ERROR_OUT_OF_DEVICE_MEMORY : REAL(vkAllocateMemory)(device, info, memory, out);
}
VkResult vkQueueSubmit2(VkQueue queue, uint32_t count, const VkSubmitInfo2* submits, VkFence fence) {
    static int calls;
    return plays("lost", &calls) ? VK_ERROR_DEVICE_LOST : REAL(vkQueueSubmit2)(queue, count, submits, fence);
}
VkResult vkWaitSemaphores(VkDevice device, const VkSemaphoreWaitInfo* info, uint64_t timeout) {
    static int calls;
    if (plays("never done", &calls)) return VK_TIMEOUT;
    const VkResult waited = REAL(vkWaitSemaphores)(device, info, timeout);
    static int done_calls;
    return plays("never told", &done_calls) ? VK_TIMEOUT : waited;
}
"""
SAYS = {"old": "lacks Vulkan 1.3", "taken": "vkCreateDevice", "full": "memory of .*OutOfDeviceMemory",
        "lost": "the device was lost", "never done": "did not end within",
        "never told": "the frame did not end within"}


def shim(folder: Path) -> Path:
    (folder / "shim.c").write_text(SHIM)
    subprocess.run(["cc", "-shared", "-fPIC", "-o", folder / "shim.so", folder / "shim.c"], check=True)
    return folder / "shim.so"


class Drivers(BadInput):
    @classmethod
    def setUpClass(cls):
        cls.shim = shim(Path(cls.enterClassContext(tempfile.TemporaryDirectory())))

    def playing(self, fault: str, calls: int) -> dict[str, str]:
        # A sanitizer's library wants to be the first of all.
        before = "verify_asan_link_order=0" + (":" + os.environ["ASAN_OPTIONS"] if "ASAN_OPTIONS" in os.environ else "")
        return {"LD_PRELOAD": str(self.shim), "PLAYS": fault, "CALLS": str(calls), "ASAN_OPTIONS": before}

    def test_without_a_fault_nothing_changes(self):
        done = self.run_program(CHAPTERS["02"], "--size", "64x48", "--screenshot", self.picture, **self.playing("none", 0))
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_pictures(self):
        for fault, counts, code in (("old", (0,), 2), ("taken", (0,), 1), ("full", (0, 3, 12), 1), ("lost", (0, 1, 4), 1),
                                    ("never done", (0,), 1), ("never told", (0,), 1)):
            for calls in counts:
                for chapter in ("02", "04"):
                    self.draw(chapter, code=code, says=SAYS[fault], **self.playing(fault, calls))

    def test_figures(self):
        """The existing file stays."""
        out = self.write("times.json", "before")
        for fault, calls in (("full", 2), ("lost", 2), ("never done", 1)):
            self.refuse(CHAPTERS["02"], "--size", "64x48", "--timings", out, code=1, says=SAYS[fault],
                        **self.playing(fault, calls))
        self.assertEqual(out.read_text(), "before")

    @unittest.skipIf(os.geteuid() or BUILD.name == "sanitizer", "only root can be another user, and a sanitizer has threads of its own")
    def test_threads_are_refused(self):
        """lavapipe would wait for them without end; a comparison does without."""
        self.folder.chmod(0o777)
        limited = ["--reuid=12346", "--regid=12346", "--clear-groups", "prlimit"]
        drawing = [CHAPTERS["02"], "--size", "64x48", "--screenshot", self.picture]
        self.refuse(Path("/usr/bin/setpriv"), *limited, "--nproc=4", *drawing, code=1, says=r"starts \d threads of the \d+ that its software driver needs")
        done = self.run_program("setpriv", *limited, "--nproc=100", *drawing)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        compared = [self.run_program("setpriv", *limited, f"--nproc={most}", BUILD / "compare", self.picture, self.picture, LIGHTWALK_SANDBOXED="1")
                    for most in (1, 100)]  # without a process for the reader
        self.assertEqual(compared[0].stdout, compared[1].stdout, compared[0].stderr)
        self.assertEqual(compared[0].returncode, 0)

    def test_windows(self):
        server = XServer()
        self.addCleanup(server.close)
        for fault, calls, code in (("old", 0, 2), ("full", 5, 1), ("lost", 8, 1), ("never done", 2, 1)):
            for program in (CHAPTERS["02"], BUILD / "menu"):
                if program.name == "menu" and fault == "never done":
                    continue  # it draws no passes
                self.refuse(program, code=code, says=SAYS[fault], DISPLAY=server.display, **self.playing(fault, calls))
