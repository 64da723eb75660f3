"""A handout's HTML page as a tree: what the notebooks and the script are made from, so that they have the same text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from html import escape
from html.parser import HTMLParser

VOID = {"meta", "br", "img", "hr", "link", "input", "wbr"}


@dataclass
class Element:
    """An element, its children elements and texts."""

    tag: str
    attributes: dict[str, str] = field(default_factory=dict)
    children: list[Element | str] = field(default_factory=list)

    def has_class(self, name: str) -> bool:
        """Whether the class is among its classes."""
        return name in self.attributes.get("class", "").split()

    def elements(self) -> list[Element]:
        """Its children that are elements."""
        return [c for c in self.children if isinstance(c, Element)]

    def walk(self) -> Iterator[Element]:
        """The element and all elements in it, in their order."""
        yield self
        for child in self.elements():
            yield from child.walk()

    def find(self, tag: str) -> Element | None:
        """The first element in it with a tag."""
        return next((e for e in self.walk() if e.tag == tag), None)

    def text(self) -> str:
        """All of its text."""
        return "".join(
            c if isinstance(c, str) else c.text() for c in self.children
        )

    def html(self) -> str:
        """As HTML again."""
        names = "".join(
            f' {k}="{escape(v)}"' for k, v in self.attributes.items()
        )
        if self.tag in VOID:
            return f"<{self.tag}{names}>"
        inside = "".join(
            escape(c, quote=False) if isinstance(c, str) else c.html()
            for c in self.children
        )
        return f"<{self.tag}{names}>{inside}</{self.tag}>"


class _Builder(HTMLParser):
    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.root = Element("")
        self.open = [self.root]

    def handle_starttag(
        self, tag: str, attrs: list[tuple[str, str | None]]
    ) -> None:
        element = Element(tag, {k: v or "" for k, v in attrs})
        self.open[-1].children.append(element)
        if tag not in VOID:
            self.open.append(element)

    def handle_startendtag(
        self, tag: str, attrs: list[tuple[str, str | None]]
    ) -> None:
        element = Element(tag, {k: v or "" for k, v in attrs})
        self.open[-1].children.append(element)

    def handle_endtag(self, tag: str) -> None:
        if tag in VOID:
            return
        if self.open[-1].tag != tag:
            raise ValueError(f"</{tag}> closes <{self.open[-1].tag}>")
        self.open.pop()

    def handle_data(self, data: str) -> None:
        self.open[-1].children.append(data)


def read_page(html: str) -> Element:
    """The tree of a page. Raises ValueError where its tags do not pair."""
    builder = _Builder()
    builder.feed(html)
    builder.close()
    if len(builder.open) != 1:
        raise ValueError(f"<{builder.open[-1].tag}> is never closed")
    return builder.root
