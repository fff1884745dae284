"""Tests of ./course serve without a browser: exercises are read, written, checked and watched."""

import asyncio
import json
import socket
import unittest

from live_case import Live
from live_server import receive


class Exercises(Live):
    def read(self) -> dict:
        return json.loads(self.server.ask("live/exercise/01.one")[1])

    def test_it_is_read_and_written_where_it_is_as_it_was_read(self):
        file = self.root / "chapters/01_obj/exercise/one.cpp"
        self.restore_afterwards(file)
        read = self.read()
        self.assertEqual((read["text"], read["file"]), ("open", "chapters/01_obj/exercise/one.cpp"))
        status, said = self.server.ask("live/exercise/01.one", "PUT", {"text": "mine", "base": read["version"]})
        self.assertEqual((status, file.read_text()), (200, "mine"))
        status, said = self.server.ask("live/exercise/01.one", "PUT", {"text": "late", "base": read["version"]})
        self.assertEqual((status, file.read_text()), (409, "mine"))
        self.assertEqual(json.loads(said)["text"], "mine")

    def test_its_mode_and_its_letters_stay(self):
        file = self.root / "chapters/01_obj/exercise/one.cpp"
        self.restore_afterwards(file)
        file.write_bytes(b"// \xfcber\n")
        file.chmod(0o640)
        read = self.read()
        self.assertEqual(read["text"], "// \u00fcber\n")
        status, said = self.server.ask("live/exercise/01.one", "PUT", {"text": read["text"] + "// more", "base": read["version"]})
        self.assertEqual((status, file.read_bytes(), file.stat().st_mode & 0o777), (200, b"// \xfcber\n// more", 0o640))
        self.server.ask("live/exercise/01.one", "PUT", {"text": "\u20ac", "base": json.loads(said)["version"]})
        self.assertEqual(file.read_bytes(), "\u20ac".encode())
        file.chmod(0o644)

    def test_nothing_else_is_written(self):
        version = self.read()["version"]
        for name in ("01.two", "01.one.cpp", "..", "02.one%2f..", "course"):
            self.assertEqual(self.server.ask(f"live/exercise/{name}", "PUT", {"text": "x", "base": version})[0], 404, name)
        for body, status in ((b"{", 400), (b"[" * 100000, 400), ([], 400), ({"text": 1, "base": version}, 400), ({"text": "\0", "base": version}, 400),
                             ({"text": "\ud800", "base": version}, 400), ({"text": "x" * 300000, "base": version}, 413)):
            self.assertEqual(self.server.ask("live/exercise/01.one", "PUT", body)[0], status, str(body)[:40])
        for method in ("POST", "DELETE", "PATCH"):
            self.assertEqual(self.server.ask("live/exercise/01.one", method, {})[0], 405)
        self.assertEqual(self.read()["text"], "open")

    def test_a_link_is_not_followed(self):
        file, target = self.root / "chapters/02_lambert/exercise/one.cpp", self.outside / "target"
        self.restore_afterwards(file)
        target.write_text("theirs")
        file.unlink()
        file.symlink_to(target)
        self.addCleanup(file.unlink)
        self.assertEqual(self.server.ask("live/exercise/02.one")[0], 404)

    def test_a_body_of_100_mb_is_refused(self):
        with socket.create_connection(("127.0.0.1", self.server.port)) as one:
            one.sendall(f"PUT /live/exercise/01.one HTTP/1.1\r\nHost: {self.server.host}\r\nOrigin: {self.server.origin}\r\n"
                        f"Cookie: {self.server.cookie}\r\nContent-Length: 100000000\r\n\r\n".encode())
            self.assertIn(one.recv(1000).split()[1:2], ([b"400"], [b"413"], []))

    def test_checked_from_starter_to_solved(self):
        file = self.root / "chapters/01_obj/exercise/one.cpp"
        self.restore_afterwards(file)

        async def talk():
            page = await self.server.socket()
            await page.write_message(json.dumps({"do": "check", "exercise": "01.one"}))
            return await self.verdict(page)
        event = self.server.run(talk)
        self.assertEqual((event["result"]["ok"], event["result"]["first_failure"], event["result"]["hint"]),
                         (False, "one(0) gave 1, expected 0", "think"))
        self.server.ask("live/exercise/01.one", "PUT", {"text": "right", "base": self.read()["version"]})
        event = self.server.run(talk)
        self.assertEqual((event["result"]["ok"], event["progress"]["01_obj"]["solved"]), (True, ["01.one"]))
        file.write_text("right no more")
        progress = json.loads(self.server.ask("live/course")[1])["progress"]
        self.assertEqual(progress["01_obj"], {"exercises": 1, "solved": [], "untouched": []})

    async def verdict(self, page) -> dict:
        while True:
            event, _ = await receive(page)
            if event["event"] == "checked":
                return event

    def test_an_edit_on_disk_is_told(self):
        async def talk():
            page = await self.server.socket()
            await page.write_message(json.dumps({"do": "watch", "exercise": "01.one"}))
            await asyncio.sleep(0.3)
            self.put("chapters/01_obj/exercise/one.cpp", "theirs")
            return await receive(page)
        event, _ = self.server.run(talk)
        self.assertEqual((event["event"], event["text"]), ("disk", "theirs"))


if __name__ == "__main__":
    unittest.main()
