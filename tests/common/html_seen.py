"""A page of HTML as tests look at it."""

from html.parser import HTMLParser


class Seen(HTMLParser):
    """`links`: (tag, address) of all that the text loads or leads to; `names`: what can be led to."""

    def __init__(self, text: str):
        super().__init__()
        self.tags, self.links, self.names, self.words = [], [], set(), ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.links += [(tag, value) for name, value in attributes if name in ("href", "src", "data", "poster") and value]
        self.names |= {value for name, value in attributes if name in ("id", "name") and value}

    def handle_data(self, data):
        self.words += data
