"""A server of ./course serve for tests, a client without a browser, and a small course whose programs echo their requests."""

import asyncio
import contextlib
import json
import os
import re
import signal
import struct
import subprocess
import sys
import urllib.error
import urllib.request
from pathlib import Path

from small_course import Course, clean_environment

# A chapter's program that answers with its request. The knob "do" makes it crash or hang.
PROGRAM = f"""#!{sys.executable}
import json, os, sys, time
if "--list" in sys.argv:
    print(json.dumps([{{"name": "do", "type": "choice", "options": ["draw", "crash", "hang", "large"], "default": "draw", "help": ""}}]))
    sys.exit()
for line in sys.stdin:
    request = json.loads(line)
    what = request.get("set", {{}}).get("do")
    if what == "crash":
        sys.stderr.write("it fell\\n")
        sys.stderr.flush()
        os.abort()
    time.sleep(1000 if what == "hang" else 0.02)
    picture = b"x" * 1000000 if what == "large" else line.encode()
    print(json.dumps({{"code": 0, "error": "", "bytes": len(picture), "format": "png", "pid": os.getpid()}}), flush=True)
    sys.stdout.buffer.write(picture)
    sys.stdout.flush()
"""


class Server:
    """Use it as a context: `address` with the token, `base` without, `cookie` as a header's value."""

    def __init__(self, root: Path, *words, refine: str = "off", **environment):
        self.process = subprocess.Popen(
            [sys.executable, root / "common/course/cli.py", "serve", "--refine", refine, "--no-build", "--port", "0", *words],
            cwd=root, env=clean_environment() | environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()
        found = re.fullmatch(r"(http://127.0.0.1:(\d+)/)\?token=(.+)", self.address)
        if not found:
            self.__exit__()
            raise RuntimeError(f"the server said {self.address!r}")
        self.base, self.port, self.token = found[1], int(found[2]), found[3]
        self.host, self.origin = f"127.0.0.1:{self.port}", self.base.rstrip("/")
        self.cookie = f"lightwalk_{self.port}={self.token}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()

    def ask(self, path: str, method: str = "GET", body=None, **headers) -> tuple[int, bytes]:
        """Status and body; with cookie and origin unless headers say otherwise (None leaves one out)."""
        sent = {"Cookie": self.cookie, "Origin": self.origin} | {name.replace("_", "-"): value for name, value in headers.items()}
        data = json.dumps(body).encode() if body is not None and not isinstance(body, bytes) else body
        request = urllib.request.Request(self.base + path, data, {name: value for name, value in sent.items() if value is not None},
                                         method=method)
        try:
            with urllib.request.urlopen(request, timeout=30) as answer:
                return answer.status, answer.read()
        except urllib.error.HTTPError as error:
            with error:
                return error.code, error.read()

    def raw_get(self, path: str) -> bytes:
        return f"GET {path} HTTP/1.1\r\nHost: {self.host}\r\nCookie: {self.cookie}\r\n\r\n".encode()

    def handshake(self) -> bytes:
        """The request that opens the socket of a page."""
        return (f"GET /live/socket HTTP/1.1\r\nHost: {self.host}\r\nCookie: {self.cookie}\r\nOrigin: {self.origin}\r\n"
                "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n").encode()

    async def socket(self, **headers):
        """A page's socket."""
        from tornado.httpclient import HTTPRequest
        from tornado.websocket import websocket_connect
        sent = {"Cookie": self.cookie, "Origin": self.origin} | headers
        page = await websocket_connect(HTTPRequest(self.base.replace("http", "ws") + "live/socket", headers=sent))
        self.pages.append(page)
        return page

    def run(self, talk):
        """The result of a function that talks through sockets, which are closed afterwards."""
        async def whole():
            self.pages = []
            try:
                return await talk()
            finally:
                for page in self.pages:
                    page.close()
                for page in (one for one in self.pages if one.close_code is None):
                    with contextlib.suppress(asyncio.TimeoutError):
                        while await asyncio.wait_for(page.read_message(), 2) is not None:
                            pass
        return asyncio.run(whole())

    def talk(self, *messages, answers: int = 1) -> list:
        """What a page's socket says to messages, which are sent together."""
        async def whole():
            page = await self.socket()
            for message in messages:
                await page.write_message(message if isinstance(message, str) else json.dumps(message))
            return [await receive(page) for _ in range(answers)]
        return self.run(whole)

    def memory_mb(self) -> float:
        return int(re.search(r"VmRSS:\s*(\d+)", Path(f"/proc/{self.process.pid}/status").read_text())[1]) / 1024


def frame(text: bytes) -> bytes:
    """A message of a socket as a browser frames it, with a mask of zeros."""
    size = len(text)
    head = bytes([0x80 | size]) if size < 126 else b"\xfe" + struct.pack(">H", size) if size < 65536 else \
        b"\xff" + struct.pack(">Q", size)
    return b"\x81" + head + b"\0\0\0\0" + text


async def receive(socket, timeout_s: float = 20):
    """(answer, picture) or (event, None); None where the socket was closed."""
    message = await asyncio.wait_for(socket.read_message(), timeout_s)
    if message is None or isinstance(message, str):
        return (json.loads(message), None) if message else None
    length = struct.unpack("<I", message[:4])[0]
    return json.loads(message[4:4 + length]), message[4 + length:]


def is_there(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


DRAW = {"do": "draw", "place": "a", "number": 1, "chapter": "01_obj", "shot": "bunny"}


class Live(Course):
    """A small course with a page, and programs that echo their requests."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name in ("01_obj", "02_lambert"):
            cls.write(f"build/chapters/{name}", PROGRAM)
        cls.write("build/docs/index.html", "<html><head></head><body>home</body></html>")
        cls.write("build/docs/source/a.html", "<html><head></head></html>")
        cls.write("build/secret", "hidden words")
        (cls.root / "build/docs/link.html").symlink_to(cls.root / "build/secret")
        cls.write("build/tests/check_01_obj", (cls.root / "programs/tests/check_01_obj").read_text())
        cls.server = Server(cls.root)
        cls.addClassCleanup(cls.server.__exit__)
