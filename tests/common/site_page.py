"""Shared by the tests of the site: one site, a server of its files, an exercise that is solved in its pages."""

import functools
import http.server
import json
import shutil
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

from live_page import BUILD, has_pages

from pages import publish

# How many colours a canvas shows, of a grid of its pixels.
COLORS = """(canvas => {
  const small = Object.assign(document.createElement("canvas"), {width: 32, height: 18}), to = small.getContext("2d");
  to.drawImage(canvas, 0, 0, 32, 18);
  const data = to.getImageData(0, 0, 32, 18).data, found = new Set();
  for (let i = 0; i < data.length; i += 4) found.add(data.slice(i, i + 3).join());
  return found.size;
})(Program.all[%d].canvas)"""
PICTURE = "Program.all[%d].canvas.toDataURL()"
DRAWN_BY = "Program.all[%d].drawing?.program ? 1 : 0"
LAMBERT = "float lambert(vec3 normal, vec3 to_light) {\n    return max(dot(normal, to_light), 0);\n}\n"
DRAWN = ["02_lambert_phong"]
SQUARE = "vec4 quaternion_square(vec4 q) {\n    return vec4(q.x * q.x - dot(q.yzw, q.yzw), 2 * q.x * q.yzw);\n}\n"


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@functools.cache
def site() -> Path:
    """The site of the course's pages, once for all tests; one chapter's pictures have their states."""
    site.folder = tempfile.TemporaryDirectory()
    made = Path(site.folder.name, "site")
    has_pages()
    shutil.copytree(BUILD / "docs", made)
    site.lessons = {page.stem: page.read_text(encoding="utf-8") for page in made.glob("*.html")}
    publish.finish(made, clip(), DRAWN)
    return made


def clip() -> Path | None:
    """A second of film, where ffmpeg is installed."""
    path = Path(site.folder.name, "clip.mp4")
    command = ["ffmpeg", "-v", "error", "-f", "lavfi", "-i", "testsrc=size=64x36:duration=1", "-pix_fmt", "yuv420p", path]
    return path if shutil.which("ffmpeg") and not subprocess.run(command).returncode else None


def serve() -> tuple[str, callable]:
    """A server of the site's files: its address, and what ends it."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(site())))
    threading.Thread(target=server.serve_forever, daemon=True).start()

    def end():
        server.shutdown()
        server.server_close()
    return f"http://127.0.0.1:{server.server_port}/", end


def remove():
    if hasattr(site, "folder"):
        site.folder.cleanup()


class Solving(unittest.TestCase):
    def press(self, browser, exercise: str, button: str):
        browser.evaluate(f"[...Exercise.all.get('{exercise}').element.querySelectorAll('button')].find(one => one.textContent === '{button}').click()")

    def solve(self, browser, exercise: str, answer: str):
        """The starter is open, the answer solved."""
        browser.evaluate(f"document.querySelector('[data-exercise=\"{exercise}\"]').click()")
        browser.wait(f"!!Exercise.all.get('{exercise}').editor")
        for text, verdict in ((None, "open"), (answer, "ok")):
            if text:
                browser.evaluate(f"Exercise.all.get('{exercise}').editor.setValue({json.dumps(text)}), 0")
            self.press(browser, exercise, "Check")
            browser.wait(f"document.querySelector('.run-verdict.{verdict}') ? 1 : 0")

    def read_offline(self, browser, address: str, end):
        """After one visit, pages that were not looked at are there without the server."""
        browser.open(f"{address}index.html")
        browser.wait("navigator.serviceWorker.ready.then(one => one.active.state === 'activated' ? 1 : 0)")
        end()
        for page in ("16_volume", "index"):
            browser.open(f"{address}{page}.html")
            self.assertIn("Lightwalk", browser.evaluate("document.title"))

    def turn_by_keys(self, browser):
        """An arrow turns Saturn; Tab leads to the first button below it."""
        browser.open(site() / "17_planets.html")
        browser.wait("Program.all.length")
        browser.evaluate("Program.all[0].canvas.scrollIntoView({behavior: 'instant'})")
        browser.wait(DRAWN_BY % 0)
        browser.evaluate("Program.all[0].canvas.focus()")
        before = browser.evaluate("Program.all[0].drawing.camera.yaw")
        browser.press("ArrowRight")
        browser.wait(f"Program.all[0].drawing.camera.yaw === {before + 5}")
        browser.press("Tab")
        browser.wait("document.activeElement.textContent === 'Edit'")
