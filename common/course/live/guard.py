"""Who may ask the server, and how often."""

import hmac
import time
from urllib.parse import urlsplit

from pages.page import POLICY
from tornado.web import HTTPError, RequestHandler

# A lesson asks for some sixty files; ten tabs that open at once are below the burst.
REQUESTS_A_S, REQUESTS_AT_ONCE = 100, 800
STRANGERS_A_S, STRANGERS_AT_ONCE = 20, 60  # who has no token yet
MOST_STRANGERS = 100  # connections on which nobody has shown a token


class Bucket:
    """So many at once, so many a second."""

    def __init__(self, a_second: float, at_once: float):
        self.a_second, self.at_once, self.left, self.at_s = a_second, at_once, at_once, time.monotonic()

    def take(self) -> bool:
        now_s = time.monotonic()
        self.left = min(self.at_once, self.left + self.a_second * (now_s - self.at_s))
        self.at_s = now_s
        if self.left < 1:
            return False
        self.left -= 1
        return True


class Guard:
    """Requirements on a request: this server's name as its host, and the token; from a page also the page's origin.

    The host is checked because a foreign page may point a name of its own at this machine. On a Unix socket, readable
    by its user alone, and behind an authenticating proxy, there is no token.
    """

    def __init__(self, token: str | None, hosts: set[str]):
        self.token, self.hosts = token, hosts
        # Strangers' requests are counted apart, so that they cannot use up the budget of token holders.
        self.bucket, self.strangers = Bucket(REQUESTS_A_S, REQUESTS_AT_ONCE), Bucket(STRANGERS_A_S, STRANGERS_AT_ONCE)

    def knows_host(self, request) -> bool:
        return request.host.lower() in self.hosts

    def knows_origin(self, request) -> bool:
        """Whether the request comes from one of our own pages."""
        origin = request.headers.get("Origin", "")
        return urlsplit(origin).scheme in ("http", "https") and urlsplit(origin).netloc.lower() == request.host.lower() \
            and self.knows_host(request)

    def has_token(self, given: str) -> bool:
        return self.token is None or hmac.compare_digest(given.encode(errors="replace"), self.token.encode())


class Guarded(RequestHandler):
    """A request that passes the guard, or an answer of one line."""

    NAME = "lightwalk"

    def cookie_name(self) -> str:
        return f"{self.NAME}_{self.request.host.rpartition(':')[2] or 'socket'}"  # cookies know no ports

    def set_default_headers(self):
        self.set_header("Server", "Lightwalk")
        self.set_header("Content-Security-Policy", POLICY)
        self.set_header("X-Content-Type-Options", "nosniff")
        self.set_header("Referrer-Policy", "no-referrer")
        self.set_header("Cross-Origin-Resource-Policy", "same-origin")
        self.set_header("Cache-Control", "no-cache")

    def prepare(self):
        guard = self.application.guard
        given = self.get_query_argument("token", "")
        known = guard.has_token(self.get_cookie(self.cookie_name(), "")) or bool(given) and guard.has_token(given)
        if not (guard.bucket if known else guard.strangers).take():
            self.set_header("Retry-After", "1")
            raise HTTPError(429, reason="Too many requests: wait a second")
        if not guard.knows_host(self.request):
            raise HTTPError(403, reason="This server does not have that name")
        if not guard.has_token(self.get_cookie(self.cookie_name(), "")):
            if self.request.method != "GET" or not given or not guard.has_token(given):
                raise HTTPError(403, reason="Open the address that ./course serve printed: it has a token")
            self.set_cookie(self.cookie_name(), given, httponly=True, samesite="Strict")
            self.redirect("/" + self.request.path.lstrip("/"))  # never //elsewhere
            return
        self.application.waiting.pop(getattr(self.request.connection, "stream", None), None)
        if self.request.method != "GET" and not guard.knows_origin(self.request):
            raise HTTPError(403, reason="Another page may not ask this")

    def write_error(self, status_code, **_):
        self.set_header("Content-Type", "text/plain; charset=utf-8")
        self.finish(f"{self._reason}\n")
