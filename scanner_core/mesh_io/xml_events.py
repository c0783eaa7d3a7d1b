"""XML of files from outside, element by element: no tree is made, and whoever declares entities is refused."""

from __future__ import annotations

from xml.etree import ElementTree

from scanner_core.mesh_io.malformed import MalformedError


class Elements:
    """What hears of the elements; those that matter override the methods."""

    def doctype(self, _name: str, _public: str | None, _system: str | None) -> None:
        raise MalformedError("its XML declares entities, which it does not need")

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        """An element begins; `tag` has its namespace in braces."""

    def end(self, tag: str) -> None:
        """An element ends."""

    def data(self, _text: str) -> None:
        """Text between the elements means nothing."""

    def close(self) -> None:
        """The document ends."""


def hear(xml: bytes, elements: Elements) -> None:
    """Tell `elements` of a whole document; MalformedError when it is damaged or declares entities."""
    parser = ElementTree.XMLParser(target=elements)
    try:
        parser.feed(xml)
        parser.close()
    except MalformedError:
        raise
    except (ElementTree.ParseError, LookupError, ValueError) as fault:
        raise MalformedError(f"its XML is damaged ({fault})") from None
