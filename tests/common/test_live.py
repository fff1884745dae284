"""Tests of ./course serve without a browser: access, pictures and charts."""

import json
import socket
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from live_case import DRAW, Live
from live_server import receive
from small_course import clean_environment


class Opening(unittest.TestCase):
    def test_a_browsers_arguments_have_no_token_and_nobody_waits_for_it(self):
        from live import serve
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(serve, "BUILD", Path(folder)), \
                mock.patch.object(serve.shutil, "which", lambda _: "/usr/bin/xdg-open"), \
                mock.patch.object(serve.subprocess, "Popen") as started:
            serve.show("http://127.0.0.1:1/?token=secret")
            [words], options = started.call_args
            page = Path(words[1])
            self.assertNotIn("secret", " ".join(map(str, words)))
            self.assertIn("secret", page.read_text())
            self.assertEqual((page.stat().st_mode & 0o777, options["start_new_session"]), (0o600, True))
            started.return_value.wait.assert_not_called()

    def test_it_builds_the_programs_and_what_compares_their_pictures(self):
        from live import serve
        with mock.patch.object(serve, "listen", lambda _: (None, None)), mock.patch.object(serve, "build") as built, \
                mock.patch.object(serve, "is_old", lambda _: False), mock.patch.object(Path, "is_file", lambda _: True), \
                mock.patch.object(serve, "serve", mock.Mock()), mock.patch.object(serve.asyncio, "run"):
            serve.run(mock.Mock(port=0, no_build=False), [])
        built.assert_called_once_with(["programs", "compare"])


class Words(Live):
    def test_bad_words_are_one_line(self):
        port = str(self.server.port)
        for words, says in ((["--port", port], f"course: port {port} is taken: ./course serve --port 0 takes one that is free\n"),
                            (["--port", "70000"], "course: --port 70000: expected a number from 0 to 65535\n"),
                            (["--address", "8.8.8.8"], "course: --address 8.8.8.8, port 8100: Cannot assign requested address\n"),
                            (["--socket", self.root / "course"], f"course: --socket {self.root}/course: is there already, and is no socket\n"),
                            (["--prot", "1"], "course: unrecognised argument '--prot'; see ./course serve --help\n")):
            self.assertEqual(self.run_program([sys.executable, self.root / "common/course/cli.py", "serve", "--no-build", *words],
                                              code=2), says)

    def test_without_pages_it_says_how_to_write_them(self):
        index = self.root / "build/docs/index.html"
        self.restore_afterwards(index)
        index.unlink()
        self.assertEqual(self.run_program([sys.executable, self.root / "common/course/cli.py", "serve", "--no-build", "--port", "0"],
                                          code=2), "course: there are no pages to serve: ./course docs writes them\n")

    def test_a_unix_socket_is_its_users_alone_and_needs_no_token(self):
        path = self.outside / "live.sock"
        process = subprocess.Popen([sys.executable, self.root / "common/course/cli.py", "serve", "--no-build", "--socket", path,
                                    "--behind", "hub.example"], env=clean_environment(), stdout=subprocess.PIPE, text=True)
        try:
            self.assertEqual(process.stdout.readline(), f"unix:{path}\n")
            self.assertEqual(path.stat().st_mode & 0o777, 0o600)
            self.assertIn("another server answers there", self.run_program(
                [sys.executable, self.root / "common/course/cli.py", "serve", "--no-build", "--socket", path], code=2))
            for host, status in (("hub.example", b"200"), ("other.example", b"403")):
                with socket.socket(socket.AF_UNIX) as one:
                    one.connect(str(path))
                    one.sendall(f"GET /live/course HTTP/1.0\r\nHost: {host}\r\n\r\n".encode())
                    self.assertEqual(one.recv(1000).split()[1], status)
        finally:
            process.terminate()
            process.wait()
            process.stdout.close()
        self.assertFalse(path.exists())


class Guarded(Live):
    def test_a_page_is_the_one_on_disk_with_scripts_more(self):
        status, body = self.server.ask("source/a.html")
        self.assertEqual(status, 200)
        self.assertIn(b'<script defer src="../live/start.js"></script></head>', body)
        self.assertEqual((self.root / "build/docs/source/a.html").read_text(), "<html><head></head></html>")

    def test_what_a_page_runs_alone_is_left_out(self):
        page = self.root / "build/docs/source/alone.html"
        self.restore_afterwards(page)
        page.write_text('<head></head><script src="../assets/lesson.js"></script><script src="../assets/run/answers.js"></script>')
        status, body = self.server.ask("source/alone.html")
        self.assertEqual((status, b"lesson.js" in body, b"answers.js" in body), (200, True, False))

    def test_without_the_token_nothing_is_answered(self):
        for path in ("", "live/course", "live/exercise/01.one", "live/start.js", "live/socket"):
            for headers in ({"Cookie": None}, {"Cookie": f"lightwalk_{self.server.port}=wrong"}):
                self.assertEqual(self.server.ask(path, **headers)[0], 403, path)
        self.assertEqual(self.server.ask(f"?token={self.server.token}x", Cookie=None)[0], 403)

    def test_the_token_becomes_a_cookie_that_no_script_reads(self):
        with socket.create_connection(("127.0.0.1", self.server.port)) as one:
            one.sendall(f"GET //evil.example/?token={self.server.token} HTTP/1.0\r\nHost: {self.server.host}\r\n\r\n".encode())
            said = one.recv(10000).decode()
        self.assertIn("HTTP/1.1 302", said)
        self.assertIn("\r\nLocation: /evil.example/\r\n", said)
        self.assertRegex(said, r"Set-Cookie: lightwalk_\d+=.*HttpOnly; .*SameSite=Strict")

    def test_strangers_take_no_turn_and_no_room_of_the_students(self):
        """Requests without the token, and connections that say nothing."""
        for _ in range(900):
            status = self.server.ask("index.html", Cookie=None)[0]
            self.assertIn(status, (403, 429))
        self.assertEqual(self.server.ask("index.html")[0], 200)
        silent = [socket.create_connection(("127.0.0.1", self.server.port)) for _ in range(500)]
        self.addCleanup(lambda: [one.close() for one in silent])
        self.assertEqual(self.server.ask("index.html")[0], 200)

    def test_another_host_or_origin_is_refused(self):
        self.assertEqual(self.server.ask("", Host="evil.example")[0], 403)
        self.assertEqual(self.server.ask("", Host=f"evil.example:{self.server.port}")[0], 403)
        body = {"text": "x", "base": "y"}
        for origin in ("http://evil.example", "null", "", f"http://127.0.0.1:{self.server.port + 1}", None):
            self.assertEqual(self.server.ask("live/exercise/01.one", "PUT", body, Origin=origin)[0], 403, origin)
        self.assertEqual(self.server.ask("live/exercise/01.one", "PUT", body)[0], 409)

    def test_no_path_leaves_the_pages(self):
        for path in ("../secret", "%2e%2e/secret", "..%2fsecret", "source/../../secret", "source/%2e%2e/%2e%2e/secret", "/etc/passwd",
                     "%2fetc%2fpasswd", "link.html", "live/../../secret", "live/cm/../../../secret", "live/golden/../secret",
                     "live/golden/01_obj/..%2f..%2fshots", "live/exercise/..%2f..%2fsecret", "live/exercise/01.%2e%2e%2fone", "%00",
                     "a" * 5000, "source", ""):
            with socket.create_connection(("127.0.0.1", self.server.port)) as one:
                one.sendall(self.server.raw_get(f"/{path}").replace(b"HTTP/1.1", b"HTTP/1.0"))
                said = b""
                while part := one.recv(65536):
                    said += part
            self.assertEqual(said.split()[1], b"404" if path else b"200", path)
            self.assertNotIn(b"hidden words", said)

    def test_pages_may_load_nothing_from_elsewhere(self):
        with socket.create_connection(("127.0.0.1", self.server.port)) as one:
            one.sendall(self.server.raw_get("/"))
            said = one.recv(10000).decode()
        self.assertIn("default-src 'none'", said)
        self.assertIn("connect-src 'self' blob:;", said)


class Pictures(Live):
    def test_a_picture_is_what_was_asked(self):
        async def talk():
            page = await self.server.socket()
            await page.write_message(json.dumps(DRAW | {"set": {"a": "1"}, "turn_rad": 0.5, "size": [320, 180], "still": True}))
            return await receive(page)
        answer, picture = self.server.run(talk)
        self.assertEqual((answer["place"], answer["number"], answer["code"]), ("a", 1, 0))
        self.assertEqual(json.loads(picture), {"words": ["--shot", "bunny"], "size": [320, 180], "still": True, "turn_rad": 0.5,
                                               "set": {"a": "1"}, "use": "solution", "look": ""})

    def test_ten_tabs_are_all_answered(self):
        async def talk():
            pages = [await self.server.socket() for _ in range(10)]
            for number, page in enumerate(pages):
                await page.write_message(json.dumps(DRAW | {"number": number}))
            return [(await receive(page))[0]["number"] for page in pages]
        self.assertEqual(self.server.run(talk), list(range(10)))

    def test_only_the_newest_of_many_is_drawn(self):
        async def talk():
            page, numbers = await self.server.socket(), []
            for number in range(100):
                await page.write_message(json.dumps(DRAW | {"number": number}))
            while 99 not in numbers:
                numbers.append((await receive(page))[0]["number"])
            return numbers
        numbers = self.server.run(talk)
        self.assertEqual(numbers, sorted(numbers))
        self.assertLess(len(numbers), 60)

    def test_a_crash_is_said_and_the_next_picture_drawn(self):
        async def talk():
            page = await self.server.socket()
            answers = []
            for what in ("draw", "crash", "draw"):
                await page.write_message(json.dumps(DRAW | {"set": {"do": what}}))
                answers.append((await receive(page))[0])
            return answers
        before, crashed, after = self.server.run(talk)
        self.assertEqual(crashed["code"], 3)
        self.assertEqual(crashed["error"], "chapter 01 was ended by SIGABRT: it fell; the next picture starts it again")
        self.assertEqual(after["code"], 0)
        self.assertNotEqual(before["pid"], after["pid"])

    def test_what_is_no_request_ends_the_socket(self):
        async def ended(message) -> bool:
            page = await self.server.socket()
            await page.write_message(message)
            return await receive(page) is None
        for message in ("{", "[]", '{"do": "delete"}', '{"do": ["draw"]}', "[" * 20000):
            self.assertTrue(self.server.run(lambda: ended(message)), message[:30])

    def test_what_a_request_may_not_say(self):
        async def talk(more):
            page = await self.server.socket()
            await page.write_message(json.dumps(DRAW | more))
            return (await receive(page))[0].get("event")
        for more in ({"shot": "../x"}, {"shot": ["bunny"]}, {"chapter": "99_none"}, {"chapter": None}, {"size": [4, 4]}, {"size": [4096, 4096]},
                     {"size": "large"}, {"turn_rad": "1"}, {"turn_rad": 1e9}, {"pan": [1]}, {"set": {"a": 1}}, {"set": [1]},
                     {"set": {str(i): "" for i in range(400)}}, {"use": "solution,../x=exercise"}, {"look": 1}, {"place": 1}, {"number": "1"},
                     {"time_s": float("nan")}, {"notches": True}):
            self.assertEqual(self.server.run(lambda: talk(more)), "refused", more)

    def test_another_origin_opens_no_socket(self):
        from tornado.httpclient import HTTPClientError
        for headers in ({"Origin": "http://evil.example"}, {"Cookie": "lightwalk=1"}, {"Host": "evil.example"}):
            with self.assertRaises(HTTPClientError) as refused:
                self.server.run(lambda: self.server.socket(**headers))
            self.assertEqual(refused.exception.code, 403, headers)


class Charts(Live):
    STUDY = {"chapter": "01_obj", "subject": "frame", "scenes": {"a room": {"file": "scenes/a.json", "set": {"lamp": 2}}},
             "truth": {"method": "", "knobs": {"rays": True}},
             "points": [{"scene": "a room", "method": "pcf", "knobs": {"bias": 0.5, "snap": False}}, {"scene": "none", "method": "x"}]}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write("docs/studies/01_obj.gpu.json", json.dumps(cls.STUDY))
        cls.write("build/compare", (cls.root / "programs/compare").read_text())

    def test_a_points_picture_its_truth_and_the_error(self):
        async def talk():
            page = await self.server.socket()
            await page.write_message(json.dumps({"do": "point", "chart": "01_obj.gpu.acne", "number": 0}))
            return [await receive(page) for _ in range(3)]
        (picture, asked), (truth, asked_of_truth), (error, heat) = sorted(self.server.run(talk), key=lambda one: one[0]["place"])
        self.assertEqual([picture["place"], truth["place"], error["place"]], ["chart.0", "chart.1", "chart.2"])
        request = {"words": ["--scene", "scenes/a.json"], "size": [480, 270], "still": True}
        self.assertEqual(json.loads(asked), request | {"set": {"method": "pcf", "lamp": "2", "bias": "0.5", "snap": "off"}})
        self.assertEqual(json.loads(asked_of_truth), request | {"set": {"lamp": "2", "rays": "on"}})
        self.assertEqual((heat, error["flip_mean"]), (b"hot", 0.5))

    def test_an_error_that_cannot_be_made_is_said(self):
        async def talk():
            page = await self.server.socket()
            await page.write_message(json.dumps({"do": "point", "chart": "01_obj.gpu", "number": 0}))
            return {answer["place"]: answer["error"] for answer, _ in [await receive(page) for _ in range(3)]}
        self.restore_afterwards(self.root / "build/compare")
        (self.root / "build/compare").unlink()
        self.assertEqual(self.server.run(talk), {"chart.0": "", "chart.1": "", "chart.2": "build/compare: No such file or directory; ./course serve builds it"})

    def test_what_is_no_point_is_refused(self):
        async def talk(chart, number):
            page = await self.server.socket()
            await page.write_message(json.dumps({"do": "point", "chart": chart, "number": number}))
            return (await receive(page))[0]["event"]
        for chart, number in (("01_obj.gpu", 1), ("01_obj.gpu", 2), ("01_obj.gpu", -1), ("01_obj.gpu", True), ("../01_obj.gpu", 0), (None, 0)):
            self.assertEqual(self.server.run(lambda: talk(chart, number)), "refused", (chart, number))
        self.assertEqual(self.server.ask("live/chart/02_none")[0], 404)


if __name__ == "__main__":
    unittest.main()
