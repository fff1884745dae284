"""A virtual X server and its screen."""
import ctypes
import os
import shutil
import struct
import subprocess
import tempfile
from pathlib import Path


class XServer:
    """Xvfb on a free display. Its screen lies in a file, in the format of xwd."""

    def __init__(self, width: int = 1400, height: int = 900, depth: int = 24):
        missing = [name for name in ("Xvfb", "xdotool") if not shutil.which(name)]
        if missing:  # a window that nobody has tried is not a window that works
            raise AssertionError(f"not installed: {', '.join(missing)}; apt install xvfb xdotool")
        self.folder = tempfile.TemporaryDirectory(prefix="lightwalk_x_")
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x{depth}", "-fbdir", self.folder.name,
             "-nolisten", "tcp", "-noreset", "-ac"], pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as answer:
            number = answer.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        self.display = ":" + number

    def set_text_scale(self, scale: float):
        """A desktop's setting for dense screens: the resource Xft.dpi."""
        resources = f"Xft.dpi:\t{96 * scale:.0f}\n".encode()
        x11 = ctypes.CDLL("libX11.so.6")
        for function in (x11.XOpenDisplay, x11.XDefaultRootWindow):
            function.restype = ctypes.c_void_p
        display = ctypes.c_void_p(x11.XOpenDisplay(self.display.encode()))
        root = ctypes.c_ulong(x11.XDefaultRootWindow(display))
        resource_manager, string = ctypes.c_ulong(23), ctypes.c_ulong(31)  # predefined atoms, Xatom.h
        x11.XChangeProperty(display, root, resource_manager, string, 8, 0, resources, len(resources))
        x11.XCloseDisplay(display)

    def set_minimised(self, window: int, minimised: bool):
        """The window manager's part before the mapping: the window's property (ICCCM 4.1.3.1)."""
        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        for function in (x11.XInternAtom, x11.XChangeProperty, x11.XSync, x11.XCloseDisplay):
            function.argtypes = None
        display = ctypes.c_void_p(x11.XOpenDisplay(self.display.encode()))
        state = x11.XInternAtom(display, b"WM_STATE", 0)
        value = (ctypes.c_long * 2)(3 if minimised else 1, 0)
        x11.XChangeProperty(display, ctypes.c_ulong(window), ctypes.c_ulong(state), ctypes.c_ulong(state), 32, 0, value, 2)
        x11.XSync(display, 0)
        x11.XCloseDisplay(display)

    def close(self):
        self.process.terminate()
        self.process.wait(10)
        self.folder.cleanup()

    def screen(self, left: int, top: int, width: int, height: int) -> bytes:
        """Three bytes a pixel: red, green, blue; rows from the top."""
        with open(Path(self.folder.name, "Xvfb_screen0"), "rb") as file:
            header = struct.unpack(">25I", file.read(100))
            line, colors = header[12], header[19]
            file.seek(header[0] + 12 * colors + top * line)
            data = file.read(height * line)
        rows = b"".join(data[y * line + 4 * left:y * line + 4 * (left + width)] for y in range(height))
        rgb = bytearray(3 * width * height)
        rgb[0::3], rgb[1::3], rgb[2::3] = rows[2::4], rows[1::4], rows[0::4]
        return bytes(rgb)
