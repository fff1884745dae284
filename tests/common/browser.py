"""Debian's Chromium and Firefox, which a test drives with Playwright (browser.js)."""

import json
import os
import select
import shutil
import subprocess
import time
from pathlib import Path

import npm
from x_server import XServer

from pages.book import find_browser

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
WHY_NONE = npm.why_not("playwright-core") if find_browser() else "Chromium is not installed"
TIMEOUT_S = 120
# WebGL by software, no requests to the network.
PREFERENCES = {"webgl.force-enabled": True, "webgl.disable-fail-if-major-performance-caveat": True, "gfx.webrender.software": True,
               "app.update.enabled": False, "datareporting.policy.dataSubmissionEnabled": False, "network.captive-portal-service.enabled": False,
               "network.connectivity-service.enabled": False, "app.normandy.enabled": False, "services.settings.server": "data:,none/v1",
               "security.fileuri.strict_origin_policy": True}


class Browser:
    """One page of Chromium. Use it as a context; `complaints` collects the errors on the page's console."""

    name = "chromium"

    def __init__(self, width: int = 1280, height: int = 900, dark: bool = False, server: str = "", webgl: bool = False):
        """server: an address, "http://127.0.0.1:8100/", that pages may ask. webgl: by software."""
        given = {"name": self.name, "launch": self.launch(webgl, dark), "server": server,
                 "page": {"viewport": {"width": width, "height": height}, "colorScheme": "dark" if dark else "light"}}
        self.complaints = []
        self.process = subprocess.Popen(["node", Path(__file__).with_suffix(".js"), json.dumps(given)], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True, env=self.environment())

    def launch(self, webgl: bool, dark: bool) -> dict:
        drawn = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if webgl else ["--disable-gpu"]
        return {"executablePath": find_browser(), "args": ["--no-sandbox", "--disable-dev-shm-usage", *drawn]}

    def environment(self) -> dict:
        return os.environ | {"NODE_PATH": str(npm.FOLDER / "node_modules")}

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()  # and it ends the browser
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()

    def call(self, function: str, *words, **options):
        """A function of Playwright's page: call("keyboard.press", "Tab"). Raises RuntimeError where it fails or does not answer."""
        self.process.stdin.write(json.dumps({"call": function, "with": [*words, *[options] * bool(options)]}) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline() if select.select([self.process.stdout], [], [], TIMEOUT_S)[0] else ""
        answer = json.loads(line) if line else {"error": f"no answer within {TIMEOUT_S} s, or it has ended", "complaints": []}
        self.complaints += answer["complaints"]
        if "error" in answer:
            raise RuntimeError(f"{function}: {answer['error']}")
        return answer["value"]

    def open(self, path: Path | str):
        """Loads a file, or an address, and waits until it and its pictures are there."""
        self.call("goto", path if isinstance(path, str) else path.resolve().as_uri())

    def evaluate(self, expression: str):
        """The value of a JavaScript expression; a promise is waited for."""
        return self.call("evaluate", expression)

    def wait(self, expression: str, timeout_s: float = 60):
        """The value of a JavaScript expression once it is true. Raises RuntimeError where it never is."""
        end = time.monotonic() + timeout_s
        while not (value := self.there(expression)):
            if time.monotonic() > end:
                raise RuntimeError(f"never true within {timeout_s} s: {expression}")
            time.sleep(0.05)
        return value

    def there(self, expression: str):
        """The value, or None while the page that was asked makes room for another."""
        try:
            return self.evaluate(expression)
        except RuntimeError as error:
            if "context was destroyed" in str(error) or "navigat" in str(error):
                return None
            raise

    def press(self, key: str):
        """A key as a person presses it: "ArrowRight", "Tab"."""
        self.call("keyboard.press", key)

    def drag(self, start: tuple, end: tuple):
        """From one point of the window to another with the left button, in CSS pixels."""
        for function, words in (("move", start), ("down", ()), ("move", end), ("up", ())):
            self.call(f"mouse.{function}", *words)

    def resize(self, width: int, height: int):
        self.call("setViewportSize", {"width": width, "height": height})

    def picture(self, path: Path, whole: bool = True):
        """A PNG of the window or of the whole page."""
        self.call("screenshot", path=str(path), fullPage=whole)


class Firefox(Browser):
    """The same of Firefox, by WebDriver BiDi. Headless it offers no WebGL; on a virtual X server it has Mesa's software driver."""

    name = "firefox"

    def launch(self, webgl: bool, dark: bool) -> dict:
        self.screen = XServer()
        return {"executablePath": FIREFOX, "channel": "moz-firefox", "headless": False,
                "firefoxUserPrefs": PREFERENCES | {"layout.css.prefers-color-scheme.content-override": 0 if dark else 1}}

    def environment(self) -> dict:
        environment = super().environment() | {"DISPLAY": self.screen.display, "LIBGL_ALWAYS_SOFTWARE": "1"}
        environment.pop("WAYLAND_DISPLAY", None)
        return environment

    def __exit__(self, *given):
        super().__exit__(*given)
        self.screen.close()
