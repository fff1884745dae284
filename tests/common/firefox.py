"""A Firefox on a virtual X server, which a test drives by WebDriver BiDi (https://w3c.github.io/webdriver-bidi) over a web socket of
its own (RFC 6455). Headless it offers no WebGL; on X it has Mesa's software driver."""

import base64
import json
import os
import re
import shutil
import socket
import struct
import subprocess
import tempfile
import time
from pathlib import Path

from browser import Driven
from x_server import XServer

FIREFOX = shutil.which("firefox-esr") or shutil.which("firefox")
TIMEOUT_S = 120
MASK = b"mask"
# WebGL by software, no requests to the network, no first-run pages.
PREFERENCES = {"webgl.force-enabled": True, "webgl.disable-fail-if-major-performance-caveat": True, "gfx.webrender.software": True,
               "app.update.enabled": False, "datareporting.policy.dataSubmissionEnabled": False, "browser.shell.checkDefaultBrowser": False,
               "network.captive-portal-service.enabled": False, "network.connectivity-service.enabled": False,
               "app.normandy.enabled": False,
               "services.settings.server": "data:,none/v1", "remote.active-protocols": 1, "security.fileuri.strict_origin_policy": True}


class Firefox(Driven):
    """One page. Use it as a context; `complaints` collects the errors on the page's console."""

    def __init__(self, width: int = 1280, height: int = 900, dark: bool = False):
        self.profile = Path(tempfile.mkdtemp(prefix="lightwalk_firefox_"))
        preferences = PREFERENCES | {"layout.css.prefers-color-scheme.content-override": 0 if dark else 1}
        (self.profile / "user.js").write_text("".join(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n"
                                                      for name, value in preferences.items()))
        self.said = self.profile / "said"
        self.server = XServer()
        environment = os.environ | {"HOME": str(self.profile), "DISPLAY": self.server.display, "LIBGL_ALWAYS_SOFTWARE": "1"}
        environment.pop("WAYLAND_DISPLAY", None)
        with open(self.said, "w") as out:
            self.process = subprocess.Popen([FIREFOX, "--no-remote", "--profile", self.profile, "--remote-debugging-port", "0", "about:blank"],
                                            env=environment, stdin=subprocess.DEVNULL, stdout=out, stderr=out)
        self.number, self.buffer, self.socket, self.complaints = 0, b"", None, []
        try:
            self.connect()
            self.call("session.new", capabilities={})
            self.call("session.subscribe", events=["log.entryAdded"])
            self.context = self.call("browsingContext.getTree")["contexts"][0]["context"]
            self.call("browsingContext.setViewport", context=self.context, viewport={"width": width, "height": height})
        except BaseException:
            self.__exit__()
            raise

    def __exit__(self, *given):
        super().__exit__(*given)
        self.server.close()
        if self.socket:
            self.socket.close()

    def connect(self):
        end = time.monotonic() + TIMEOUT_S
        while not (found := re.search(r"WebDriver BiDi listening on ws://127\.0\.0\.1:(\d+)", self.said.read_text())):
            if time.monotonic() > end or self.process.poll() is not None:
                raise RuntimeError(f"Firefox does not listen: {self.said.read_text()[-300:]}")
            time.sleep(0.1)
        self.socket = socket.create_connection(("127.0.0.1", int(found[1])), TIMEOUT_S)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(f"GET /session HTTP/1.1\r\nHost: 127.0.0.1:{found[1]}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
        while b"\r\n\r\n" not in self.buffer:
            self.read()
        head, _, self.buffer = self.buffer.partition(b"\r\n\r\n")
        if b" 101 " not in head.split(b"\r\n")[0]:
            raise RuntimeError(f"Firefox refuses: {head.decode(errors='replace')}")

    def read(self):
        data = self.socket.recv(1 << 20)
        if not data:
            raise RuntimeError("Firefox has ended")
        self.buffer += data

    def take(self, count: int) -> bytes:
        while len(self.buffer) < count:
            self.read()
        data, self.buffer = self.buffer[:count], self.buffer[count:]
        return data

    def receive(self) -> dict:
        """The next message; its parts are joined."""
        data = b""
        while True:
            first, length = self.take(2)
            if length > 125:
                length, = struct.unpack(">H" if length == 126 else ">Q", self.take(2 if length == 126 else 8))
            data += self.take(length)
            if first & 0x80:
                return json.loads(data)

    def call(self, method: str, **parameters) -> dict:
        """One command and its result. Raises RuntimeError where Firefox refuses it."""
        self.number += 1
        data = json.dumps({"id": self.number, "method": method, "params": parameters}).encode()
        # A client's frame is masked, not by zeros, which Firefox takes for none; its length takes as few bytes as it can.
        size = len(data)
        length = bytes([0x80 | size]) if size < 126 else struct.pack(">BH", 0xFE, size) if size < 65536 else struct.pack(">BQ", 0xFF, size)
        masked = bytes(one ^ MASK[i % 4] for i, one in enumerate(data))
        self.socket.sendall(b"\x81" + length + MASK + masked)
        while True:
            answer = self.receive()
            if answer.get("method") == "log.entryAdded" and answer["params"]["level"] == "error":
                self.complaints.append(answer["params"]["text"])
            if answer.get("id") == self.number:
                if answer["type"] == "error":
                    raise RuntimeError(f"{method}: {answer['message']}")
                return answer["result"]

    def open(self, path: Path | str):
        """Loads a file, or an address, and waits until it and its pictures are there."""
        address = path if isinstance(path, str) else path.resolve().as_uri()
        self.call("browsingContext.navigate", context=self.context, url=address, wait="complete")

    def evaluate(self, expression: str):
        """The value of a JavaScript expression as JSON; a promise is waited for."""
        text = f"(async () => JSON.stringify(await ({expression})) ?? 'null')()"
        answer = self.call("script.evaluate", expression=text, target={"context": self.context}, awaitPromise=True)
        if answer["type"] == "exception":
            raise RuntimeError(answer["exceptionDetails"]["text"])
        return json.loads(answer["result"]["value"])

    def press(self, key: str):
        """A key as a person presses it: "ArrowRight", "Tab"."""
        value = {"Tab": "\ue004", "ArrowLeft": "\ue012", "ArrowRight": "\ue014"}[key]
        actions = [{"type": kind, "value": value} for kind in ("keyDown", "keyUp")]
        self.call("input.performActions", context=self.context, actions=[{"type": "key", "id": "keys", "actions": actions}])

    def picture(self, path: Path):
        """A PNG of the window."""
        data = self.call("browsingContext.captureScreenshot", context=self.context, origin="viewport")["data"]
        Path(path).write_bytes(base64.b64decode(data))
