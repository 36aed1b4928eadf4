"""What a diagnosis tells while it goes on."""

from __future__ import annotations


class Message(str):
    """A line of progress: text to be printed as it is, and its place.

    Attributes:
        detail: a result of the step that the last headline named; otherwise the line is a headline itself.
        event: what it is about, as data (``diagnosis.events``); None: it is a text alone.
    """

    __slots__ = ("detail", "event")
    detail: bool
    event: object

    def __new__(cls, text: str, *, detail: bool = False, event: object = None) -> Message:
        """A headline, or a detail, which is indented below it."""
        message = super().__new__(cls, f"  {text}" if detail else text)
        message.detail = detail
        message.event = event
        return message
