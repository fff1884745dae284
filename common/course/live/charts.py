"""The points of a chart, for the pointer."""

from live.pages import Answer
from tornado.web import HTTPError


class Points(Answer):
    def get(self, name: str):
        raise HTTPError(404, reason="There is no such chart")
