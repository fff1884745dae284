"""Tests of ./course serve without a browser: hostile clients, and the programs behind the pages."""

import asyncio
import json
import os
import socket
import sys
import unittest
from unittest import mock

from live_case import DRAW, Live
from live_server import Server, frame, is_there, receive, until
from small_course import REAL

sys.path.insert(0, str(REAL / "common/course"))
from live import programs  # noqa: E402


class Hostile(Live):
    def answers(self) -> bool:
        return self.server.ask("live/course")[0] == 200

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
        self.assertTrue(self.answers())

    def test_a_flood_of_messages_ends_the_socket(self):
        async def talk():
            page = await self.server.socket()
            for number in range(10000):
                try:
                    await page.write_message(json.dumps(DRAW | {"number": number}))
                except Exception:
                    break
            while await receive(page):
                pass
            return page.close_code
        self.assertEqual(self.server.run(talk), 1008)
        self.assertTrue(self.answers())

    def test_a_socket_that_never_reads_holds_nothing_up(self):
        with socket.socket() as deaf:
            deaf.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            deaf.connect(("127.0.0.1", self.server.port))
            deaf.sendall(self.server.handshake())
            for number in range(300):
                deaf.sendall(frame(json.dumps(DRAW | {"place": str(number % 60), "number": number, "set": {"do": "large"}}).encode()))

            async def talk():
                page = await self.server.socket()
                await page.write_message(json.dumps(DRAW | {"chapter": "02_lambert"}))
                return (await receive(page))[0]["code"]
            self.assertEqual(self.server.run(talk), 0)
            self.assertLess(self.server.memory_mb(), 250)

    def test_more_pages_than_there_is_room_for_are_turned_away(self):
        from tornado.httpclient import HTTPClientError

        async def talk():
            pages = []
            with self.assertRaises(HTTPClientError) as refused:
                for _ in range(60):
                    pages.append(await self.server.socket())
            return len(pages), refused.exception.code
        opened, code = self.server.run(talk)
        self.assertEqual((opened <= 40, code), (True, 503))

    def test_an_end_leaves_no_program_behind(self):
        with Server(self.root) as server:
            async def talk():
                page = await server.socket()
                await page.write_message(json.dumps(DRAW))
                return (await receive(page))[0]["pid"]
            pid = server.run(talk)
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
                await made.end_idle()
                return answers, made.running()
            finally:
                await made.end()
        with mock.patch.multiple(programs, chapter_program=lambda name: self.root / "build/chapters" / name, ROOT=self.root, **constants):
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
        with mock.patch.object(programs.Program, "version", side_effect=[1, 2, 2, 2]):
            again = self.draw(("01_obj", "draw"), ("01_obj", "draw"))[0]
        self.assertNotEqual(again[0]["pid"], again[1]["pid"])
        self.assertTrue(os.access(path, os.X_OK))

    def test_one_that_is_not_built_says_how_to(self):
        answers, _ = self.draw(("03_none", "draw"))
        self.assertIn("chapter 03 is not built: ./course run 03 builds it", answers[0]["error"])


if __name__ == "__main__":
    unittest.main()
