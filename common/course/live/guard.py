"""Who may ask the server."""

import hmac
from urllib.parse import urlsplit

from pages.page import POLICY
from tornado.web import HTTPError, RequestHandler


class Guard:
    """Requirements on a request: this server's name as its host, and the token; from a page also the page's origin.

    The host is checked because a foreign page may point a name of its own at this machine. On a Unix socket, readable
    by its user alone, and behind an authenticating proxy, there is no token.
    """

    def __init__(self, token: str | None, hosts: set[str]):
        self.token, self.hosts = token, hosts

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
        if not guard.knows_host(self.request):
            raise HTTPError(403, reason="This server does not have that name")
        if not guard.has_token(self.get_cookie(self.cookie_name(), "")):
            if self.request.method != "GET" or not given or not guard.has_token(given):
                raise HTTPError(403, reason="Open the address that ./course serve printed: it has a token")
            self.set_cookie(self.cookie_name(), given, httponly=True, samesite="Strict")
            self.redirect("/" + self.request.path.lstrip("/"))  # never //elsewhere
            return
        if self.request.method != "GET" and not guard.knows_origin(self.request):
            raise HTTPError(403, reason="Another page may not ask this")

    def write_error(self, status_code, **_):
        self.set_header("Content-Type", "text/plain; charset=utf-8")
        self.finish(f"{self._reason}\n")
