"""HTML read with the place of each tag in the text."""

from html.parser import HTMLParser


class Placed(HTMLParser):
    """`at()` is the place of the tag that is being handled, counted in characters."""

    def read(self, page: str):
        self.lines = [0]
        for line in page.splitlines(keepends=True):
            self.lines.append(self.lines[-1] + len(line))
        self.feed(page)
        self.close()

    def at(self) -> int:
        line, column = self.getpos()
        return self.lines[line - 1] + column
