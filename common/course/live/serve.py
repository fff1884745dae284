"""Serves the lessons with pictures that answer."""

import asyncio
import errno
import logging
import secrets
import shutil
import signal
import socket
import subprocess
from pathlib import Path

from build.build import build
from pages import docs
from tree import BUILD, Failure, UsageError, say, warn, write_atomically

HELP = """Serves the lessons with pictures that answer: drag one to orbit, turn the knobs below it, solve the exercises beside it.

It prints an address to open in a browser of this machine; Ctrl+C ends it. The address has a token, without which nothing
is answered. From another machine: ssh -L 8100:127.0.0.1:8100 THIS_MACHINE, then open the same address there.

  ./course serve                 build the course, write the pages and serve them on 127.0.0.1, port 8100
  ./course serve --open          and open the browser
  ./course serve --no-build      serve what is built"""
PORT, ADDRESS = 8100, "127.0.0.1"
BODY_BYTES = 1 << 20
LOOK_S, IDLE_LOOK_S = 1.0, 5.0


def add_arguments(parser):
    parser.add_argument("--port", type=int, default=PORT, metavar="N", help=f"the port, 0 for any that is free ({PORT})")
    parser.add_argument("--address", default=ADDRESS, metavar="IP",
                        help="listen on another address: anyone who reaches it and has the token can edit and run your exercises")
    parser.add_argument("--socket", metavar="FILE", help="listen on a Unix socket, your user's alone, without a token")
    parser.add_argument("--behind", metavar="HOST", help="the name, with its port if it has one, that a proxy in front is "
                        "reached by; without a token only with --socket")
    parser.add_argument("--open", action="store_true", help="open the pages in the browser")
    parser.add_argument("--refine", choices=("auto", "on", "off"), default="auto", help="whether pictures at rest gather samples: "
                        "if that takes at most 4 s (auto), always, or never")
    parser.add_argument("--no-build", action="store_true", help="serve what is built")


def run(arguments, _rest) -> int:
    try:
        import tornado.web  # noqa: F401
    except ImportError:
        raise Failure("there is no tornado; the packages are in common/course/packages/serve") from None
    if not 0 <= arguments.port <= 65535:
        raise UsageError(f"--port {arguments.port}: expected a number from 0 to 65535")
    listening, where = listen(arguments)
    folder = BUILD / "docs"
    if not arguments.no_build:
        build(["programs", "compare"])  # charts show the error of a point's picture
        if is_old(folder):
            say("writing the pages")
            docs.make(folder)
    if not (folder / "index.html").is_file():
        raise UsageError("there are no pages to serve: ./course docs writes them")
    logging.getLogger("tornado.access").disabled = True
    logging.getLogger("tornado.general").disabled = True
    return asyncio.run(serve(arguments, listening, where, folder))


def is_old(folder: Path) -> bool:
    """Whether the pages were written before something that they show was."""
    index = folder / "index.html"
    if not index.is_file():
        return True
    at = index.stat().st_mtime
    sources = [Path(docs.__file__).parent, docs.ROOT / "docs", docs.ROOT / "README.md"]
    return any(path.stat().st_mtime > at for source in sources for path in [source, *source.rglob("*")]
               if "__pycache__" not in path.parts and path.exists())


def listen(arguments):
    """The listening socket, and the host and port of its address. Raises UsageError."""
    from tornado.netutil import bind_unix_socket

    if arguments.socket:
        if arguments.open or arguments.port != PORT or arguments.address != ADDRESS:
            raise UsageError("--socket is instead of an address: leave out --open, --port and --address")
        path = Path(arguments.socket)
        if path.exists() and not path.is_socket():
            raise UsageError(f"--socket {path}: is there already, and is no socket")
        if answers_at(path):
            raise UsageError(f"--socket {path}: another server answers there")
        try:
            return bind_unix_socket(str(path), mode=0o600), None
        except (OSError, ValueError) as error:
            raise UsageError(f"--socket {path}: {getattr(error, 'strerror', None) or error}") from None
    try:
        family = socket.AF_INET6 if ":" in arguments.address else socket.AF_INET
        listening = socket.socket(family, socket.SOCK_STREAM | socket.SOCK_NONBLOCK)
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listening.bind((arguments.address, arguments.port))
        listening.listen(128)
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            raise UsageError(f"port {arguments.port} is taken: ./course serve --port 0 takes one that is free") from None
        raise UsageError(f"--address {arguments.address}, port {arguments.port}: {error.strerror or error}") from None
    host = f"[{arguments.address}]" if ":" in arguments.address else arguments.address
    return listening, (host, listening.getsockname()[1])


def answers_at(path: Path) -> bool:
    with socket.socket(socket.AF_UNIX) as one:
        one.settimeout(1)
        try:
            one.connect(str(path))
        except OSError:
            return False
        return True


def application(folder: Path, guard, can_build: bool, refine: str):
    import tornado.web
    from live import charts, pages
    from live.answers import Verdicts
    from live.programs import Programs
    from live.page_socket import MESSAGE_BYTES, Socket, Work

    made = tornado.web.Application([
        (r"/live/socket", Socket), (r"/live/course", pages.Course), (r"/live/knobs/([^/]+)", pages.Knobs),
        (r"/live/exercise/([^/]+)", pages.Exercise), (r"/live/golden/([^/]+)/([^/]+)", pages.Golden),
        (r"/live/chart/([^/]+)", charts.Points), (r"/live/(.*)", pages.Ours),
        (r"/(.*)", pages.Page, {"folder": folder})], websocket_max_message_size=MESSAGE_BYTES, websocket_ping_interval=20,
        websocket_ping_timeout=60)
    made.guard, made.programs, made.verdicts, made.closing = guard, Programs(), Verdicts(), False
    made.refine = refine
    made.work = Work(made, can_build)
    made.check = lambda exercise: made.work.start("check", exercise)
    made.written = made.work.written
    return made


def show(address: str):
    """Opens the browser, and does not wait for it. Every user of this machine can read a program's arguments, so it gets a
    page of this user's alone that leads to the address."""
    page = BUILD / "live" / "open.html"
    write_atomically(page, f'<!doctype html><meta http-equiv="refresh" content="0; url={address}"><title>Lightwalk</title>\n', 0o600)
    if not shutil.which("xdg-open"):
        warn("there is no xdg-open to show it with")
        return
    subprocess.Popen(["xdg-open", page], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)


async def serve(arguments, listening, where, folder: Path) -> int:
    from live.guard import Guard
    from tornado.httpserver import HTTPServer

    token = None if arguments.socket else secrets.token_urlsafe(24)
    hosts = {arguments.behind.lower()} if arguments.behind else set()
    if where:
        hosts |= {f"{name}:{where[1]}" for name in (where[0], "localhost", "127.0.0.1")}
    elif not hosts:
        hosts = {"localhost"}
    made = application(folder, Guard(token, hosts), not arguments.no_build, arguments.refine)
    server = HTTPServer(made, max_body_size=BODY_BYTES, max_header_size=1 << 15, body_timeout=30, idle_connection_timeout=120)
    server.add_socket(listening)
    address = f"http://{where[0]}:{where[1]}/?token={token}" if where else f"unix:{arguments.socket}"
    say(address)
    if where and where[0] not in ("127.0.0.1", "[::1]", "localhost"):
        warn("anyone who reaches this address and has the token can edit and run your exercises; the token travels in plain text")
    if arguments.open and where:
        show(address)
    ended = asyncio.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        asyncio.get_running_loop().add_signal_handler(number, ended.set)
    rounds = 0
    while not ended.is_set():
        try:
            await asyncio.wait_for(ended.wait(), LOOK_S)
        except asyncio.TimeoutError:
            rounds += 1
            made.work.look_at_disk()
            if rounds % IDLE_LOOK_S == 0:
                made.programs.end_idle()
    made.closing = True
    server.stop()
    await made.work.end()
    await made.programs.end()
    if arguments.socket:
        Path(arguments.socket).unlink(missing_ok=True)
    return 0
