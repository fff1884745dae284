"""A headless Chromium that a test drives through its debugging pipe: no driver, no sockets, no packages.

The pipe protocol is JSON, each message ended by a zero byte, on descriptors 3 (to the browser) and 4 (from it):
https://chromedevtools.github.io/devtools-protocol/.
"""

import base64
import json
import os
import select
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "common/course"))
from pages.book import find_browser  # noqa: E402

CHROMIUM = find_browser()
TIMEOUT_S = 60


class Driven:
    """A browser's page as a context: `process` and `evaluate()` are the browser's own."""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        # Its children may still be writing there for a moment.
        shutil.rmtree(self.profile, ignore_errors=True)

    def wait(self, expression: str, timeout_s: float = TIMEOUT_S):
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
            if "navigated or closed" in str(error) or "context was destroyed" in str(error):
                return None
            raise


class Browser(Driven):
    """One page. Use it as a context; `complaints` collects the errors on the page's console."""

    def __init__(self, width: int = 1280, height: int = 900, dark: bool = False, server: str = "", webgl: bool = False):
        """server: an address, "http://127.0.0.1:8100/", that pages may ask. webgl: by software."""
        self.server = server
        self.profile = tempfile.mkdtemp(prefix="lightwalk_browser_")
        to_browser, self.write_end = os.pipe()
        self.read_end, from_browser = os.pipe()
        # The shell moves the pipe to the descriptors that Chromium expects.
        command = f'exec "$0" "$@" 3<&{to_browser} 4>&{from_browser}'
        self.process = subprocess.Popen(
            ["bash", "-c", command, CHROMIUM, "--headless", "--no-sandbox", "--disable-dev-shm-usage",
             *(["--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if webgl else ["--disable-gpu"]),
             "--no-first-run", "--disable-background-networking", "--remote-debugging-pipe",
             f"--user-data-dir={self.profile}", f"--window-size={width},{height}", "about:blank"],
            pass_fds=(to_browser, from_browser), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.number, self.session, self.buffer, self.events, self.complaints = 0, None, b"", [], []
        try:
            self.start(dark)
        except BaseException:
            self.__exit__()
            raise

    def start(self, dark: bool):
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def __exit__(self, *given):
        super().__exit__(*given)
        os.close(self.write_end)
        os.close(self.read_end)

    def call(self, method: str, **parameters) -> dict:
        """One command and its result. Raises RuntimeError where the browser refuses it or does not answer."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.write_end, json.dumps(message).encode() + b"\0")
        end = time.monotonic() + TIMEOUT_S
        while time.monotonic() < end:
            answer = self.receive(end - time.monotonic())
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]
        raise RuntimeError(f"{method}: no answer within {TIMEOUT_S} s")

    def receive(self, timeout_s: float) -> dict:
        """The next message, {} where none comes in time; events are noted."""
        while b"\0" not in self.buffer:
            if not select.select([self.read_end], [], [], max(timeout_s, 0))[0]:
                return {}
            data = os.read(self.read_end, 1 << 20)
            if not data:
                raise RuntimeError("the browser has ended")
            self.buffer += data
        message, _, self.buffer = self.buffer.partition(b"\0")
        message = json.loads(message)
        if "method" in message:
            self.note(message)
        return message

    def note(self, event: dict):
        self.events.append(event["method"])
        parameters = event.get("params", {})
        if event["method"] == "Runtime.exceptionThrown":
            self.complaints.append(parameters["exceptionDetails"]["text"])
        elif event["method"] == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
            self.complaints.append(str(parameters["args"]))
        elif event["method"] == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            if "GPU stall due to ReadPixels" not in parameters["entry"]["text"]:  # of every program that is drawn
                self.complaints.append(parameters["entry"]["text"])
        elif event["method"] == "Network.requestWillBeSent":
            url = parameters["request"]["url"]
            own = (self.server,) if self.server else ()
            if not url.startswith(("data:", "file:", "about:", "blob:", *own)):
                self.complaints.append(f"asks the network for {url}")

    def open(self, path: Path | str):
        """Loads a file, or an address, and waits until it and its pictures are there."""
        self.events.clear()
        self.call("Page.navigate", url=path if isinstance(path, str) else path.resolve().as_uri())
        end = time.monotonic() + TIMEOUT_S
        while "Page.loadEventFired" not in self.events and time.monotonic() < end:
            self.receive(end - time.monotonic())

    def evaluate(self, expression: str):
        """The value of a JavaScript expression; a promise is waited for."""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", expression))
        return answer["result"].get("value")

    def press(self, key: str):
        """A key as a person presses it: "ArrowRight", "Tab"."""
        code = {"ArrowLeft": 37, "ArrowRight": 39, "Tab": 9, "Home": 36, "End": 35}[key]
        for kind in ("rawKeyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key, windowsVirtualKeyCode=code)

    def drag(self, start: tuple, end: tuple):
        """From one point of the window to another with the left button, in CSS pixels."""
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=start[0], y=start[1], button="left", clickCount=1)
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=end[0], y=end[1], button="left", buttons=1)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=end[0], y=end[1], button="left", clickCount=1)

    def picture(self, path: Path, whole: bool = True):
        """A PNG of the window or of the whole page."""
        data = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=whole)["data"]
        Path(path).write_bytes(base64.b64decode(data))
