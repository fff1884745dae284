"""Tests of ./course serve without a browser: access, pictures, charts, exercises' files, hostile clients, and the programs behind
the pages."""

import asyncio
import json
import os
import socket
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

from live_server import DRAW, Live, Server, frame, is_there, receive
from small_course import clean_environment, until

from live import programs, serve


class Opening(unittest.TestCase):
    def test_it_builds_the_programs_and_what_compares_their_pictures(self):
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
        [(answer, picture)] = self.server.talk(DRAW | {"set": {"a": "1"}, "turn_rad": 0.5, "size": [320, 180], "still": True, "screenshot": "x"})
        self.assertEqual((answer["place"], answer["number"], answer["code"]), ("a", 1, 0))
        self.assertEqual(json.loads(picture), {"words": ["--shot", "bunny"], "size": [320, 180], "still": True, "turn_rad": 0.5, "set": {"a": "1"}})

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
        asked = [DRAW | {"set": {"do": what}, "place": str(i)} for i, what in enumerate(("draw", "crash", "draw"))]
        before, crashed, after = (answer for answer, _ in self.server.talk(*asked, answers=3))
        self.assertEqual(crashed["code"], 3)
        self.assertEqual(crashed["error"], "chapter 01 was ended by SIGABRT: it fell; the next picture starts it again")
        self.assertEqual(after["code"], 0)
        self.assertNotEqual(before["pid"], after["pid"])

    def test_what_is_no_request_ends_the_socket(self):
        for message in ("{", "[]", '{"do": "delete"}', '{"do": ["draw"]}', "[" * 20000):
            self.assertEqual(self.server.talk(message), [None], message[:30])

    def test_what_a_request_may_not_say(self):
        for more in ({"shot": "../x"}, {"shot": ["bunny"]}, {"chapter": "99_none"}, {"chapter": None}, {"place": 1}, {"number": "1"}, {"picture": ["x", 0]}):
            self.assertEqual(self.server.talk(DRAW | more)[0][0].get("event"), "refused", more)

    def test_another_origin_opens_no_socket(self):
        from tornado.httpclient import HTTPClientError
        for headers in ({"Origin": "http://evil.example"}, {"Cookie": "lightwalk=1"}, {"Host": "evil.example"}):
            with self.assertRaises(HTTPClientError) as refused:
                self.server.run(lambda: self.server.socket(**headers))
            self.assertEqual(refused.exception.code, 403, headers)


class Charts(Live):
    STUDY = {"chapter": "01_obj", "subject": "frame", "scenes": {"a room": {"file": "scenes/a.json", "set": {"lamp": 2}}},
             "truth": {"method": "", "knobs": {"rays": True}},
             "points": [{"scene": "a room", "method": "pcf", "knobs": {"bias": 0.5, "snap": False}}, {"scene": "none", "method": "x"},
                        {"scene": "a room", "method": "x", "knobs": {"do": "crash"}}]}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.write("docs/studies/01_obj.gpu.json", json.dumps(cls.STUDY))
        cls.write("build/compare", (cls.root / "programs/compare").read_text())

    def test_a_points_picture_its_truth_and_the_error(self):
        said = self.server.talk({"do": "point", "chart": "01_obj.gpu.acne", "number": 0}, answers=3)
        (picture, asked), (truth, asked_of_truth), (error, heat) = sorted(said, key=lambda one: one[0]["place"])
        self.assertEqual([picture["place"], truth["place"], error["place"]], ["chart.0", "chart.1", "chart.2"])
        request = {"words": ["--scene", "scenes/a.json"], "size": [480, 270], "still": True}
        self.assertEqual(json.loads(asked), request | {"set": {"method": "pcf", "lamp": "2", "bias": "0.5", "snap": "off"}})
        self.assertEqual(json.loads(asked_of_truth), request | {"set": {"lamp": "2", "rays": "on"}})
        self.assertEqual((error["error"], heat, error.get("flip_mean")), ("", b"hot", 0.5))

    def test_an_error_that_cannot_be_made_is_said(self):
        said = {answer["place"]: answer["error"] for answer, _ in self.server.talk({"do": "point", "chart": "01_obj.gpu", "number": 2}, answers=3)}
        self.assertIn("was ended by SIGABRT", said["chart.0"])
        self.assertEqual((said["chart.1"], said["chart.2"]), ("", "the error needs both pictures"))

    def test_what_is_no_point_is_refused(self):
        for chart, number in (("01_obj.gpu", 1), ("01_obj.gpu", 3), ("01_obj.gpu", -1), ("01_obj.gpu", True), ("../01_obj.gpu", 0), (None, 0)):
            self.assertEqual(self.server.talk({"do": "point", "chart": chart, "number": number})[0][0]["event"], "refused", (chart, number))
        self.assertEqual(self.server.ask("live/chart/02_none")[0], 404)


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

class Hostile(Live):
    def test_a_message_of_100_mb_is_not_taken(self):
        async def talk():
            page = await self.server.socket()
            try:
                await page.write_message("x" * 100_000_000)
            except Exception:  # however it notices that the other side has gone
                return None
            return await receive(page)
        self.assertIsNone(self.server.run(talk))
        self.assertLess(self.server.memory_mb(), 150)
        self.assertEqual(self.server.ask("live/course")[0], 200)

    def test_a_socket_that_never_reads_holds_nothing_up(self):
        with socket.socket() as deaf:
            deaf.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            deaf.connect(("127.0.0.1", self.server.port))
            deaf.sendall(self.server.handshake())
            for number in range(300):
                deaf.sendall(frame(json.dumps(DRAW | {"place": str(number % 60), "number": number, "set": {"do": "large"}}).encode()))

            self.assertEqual(self.server.talk(DRAW | {"chapter": "02_lambert"})[0][0]["code"], 0)
            self.assertLess(self.server.memory_mb(), 250)

    def test_an_end_leaves_no_program_behind(self):
        with Server(self.root) as server:
            pid = server.talk(DRAW)[0][0]["pid"]
            self.assertTrue(is_there(pid))
        until(lambda: not is_there(pid))
        self.assertEqual(server.process.returncode, 0)


class Chapters(Live):
    """The programs behind the pages, without a server."""

    def draw(self, *requests, **constants):
        """The answers to one request after the other, and the programs running at the end."""
        async def talk():
            made, answers = programs.Programs(), []
            try:
                for chapter, what in requests:
                    done = asyncio.get_running_loop().create_future()
                    made.ask(chapter, (None, "a"), {"words": [], "set": {"do": what}}, lambda *answer: done.set_result(answer))
                    answers.append((await asyncio.wait_for(done, 30))[0])
                await asyncio.sleep(0.1)
                made.end_idle()
                return answers, made.running()
            finally:
                await made.end()
        with mock.patch.multiple(programs, chapter_program=lambda name: self.root / "build/chapters" / name, **constants):
            return asyncio.run(talk())

    def test_an_idle_one_is_ended(self):
        self.assertEqual(list(self.draw(("01_obj", "draw"))[1]), ["01_obj"])
        self.assertEqual(self.draw(("01_obj", "draw"), IDLE_S=0)[1], {})

    def test_one_that_hangs_is_ended_and_said(self):
        answers, running = self.draw(("01_obj", "hang"), ("01_obj", "draw"), ANSWER_S=1)
        self.assertEqual(answers[0]["error"], "chapter 01 did not answer within 1 s and was ended; the next picture starts it again")
        self.assertEqual(answers[1]["code"], 0)

    def test_the_one_asked_longest_ago_makes_room(self):
        self.assertEqual(list(self.draw(("01_obj", "draw"), ("02_lambert", "draw"), MOST_PROGRAMS=1)[1]), ["02_lambert"])

    def test_one_that_was_built_again_is_started_again(self):
        first = self.draw(("01_obj", "draw"), ("01_obj", "draw"))[0]
        self.assertEqual(first[0]["pid"], first[1]["pid"])
        path = self.root / "build/chapters/01_obj"
        with mock.patch.object(programs.Program, "version", side_effect=[1, 2]):
            again = self.draw(("01_obj", "draw"), ("01_obj", "draw"))[0]
        self.assertNotEqual(again[0]["pid"], again[1]["pid"])
        self.assertTrue(os.access(path, os.X_OK))

    def test_one_that_is_not_built_says_how_to(self):
        answers, _ = self.draw(("03_none", "draw"))
        self.assertIn("chapter 03 is not built: ./course run 03 builds it", answers[0]["error"])
