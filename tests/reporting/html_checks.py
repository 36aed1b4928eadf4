"""What every report must be: well-formed, self-contained, free of numbers that do not exist."""

from __future__ import annotations

import re
from html.parser import HTMLParser

VOID = {"meta", "img", "br", "link", "hr", "input"}


class Page(HTMLParser):
    """Collects tags, attributes and text; remembers tags that do not close in order."""

    def __init__(self, html):
        super().__init__(convert_charrefs=True)
        self.open, self.faults, self.attributes, self.tags = [], [], [], []
        self.texts = []
        self.feed(html)
        self.close()
        self.faults += [f"<{tag}> is never closed" for tag in self.open]

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += [(tag, name, value) for name, value in attrs]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"</{tag}> out of order at {self.getpos()}")

    def handle_data(self, data):
        if "style" not in self.open:
            self.texts.append(data)

    @property
    def text(self):
        """Visible text with single spaces."""
        return re.sub(r"\s+", " ", " ".join(self.texts)).replace("\u00a0", " ")


def checked(html):
    """The parsed page, after the checks that hold for all."""
    page = Page(html)
    assert page.faults == []
    assert page.tags[0] == "html"
    assert "script" not in page.tags and "link" not in page.tags
    for tag, name, value in page.attributes:
        if name in ("src", "href", "srcset", "poster", "data"):
            anchored = value.startswith("#") and f'id="{value[1:]}"' in html
            assert anchored or value.startswith("data:"), (
                f"<{tag} {name}={value[:60]}> is not inside the page"
            )
        assert not name.startswith("on"), f"<{tag} {name}>"
    css = html[html.index("<style>") : html.index("</style>")]
    assert "url(" not in css and "@import" not in css
    assert re.search(r"\b(nan|NaN|inf|None)\b", page.text) is None
    assert all(value for tag, name, value in page.attributes if tag == "img" and name == "alt")
    return page
