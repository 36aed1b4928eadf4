"""The windows of a session: each is sent everything there is when it opens, and from then on every change."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress

from pam_cosim.workbench.protocol import KEPT, LINES, Json, text_of_message

Listener = Callable[[str | bytes], None]
MOST_LINES = 2000  # of progress that a new window is sent


class Windows:
    """The listeners of a session, and the messages for a new one."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._listeners: list[Listener] = []
        self._kept: dict[str, str | bytes] = {}
        self._lines: list[str] = []

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Adds a window; returns the function that removes it. The listener is called from other threads and must not
        wait."""
        with self._lock:
            for message in (*self._kept.values(), *self._lines):
                listener(message)
            self._listeners.append(listener)

        def end() -> None:
            with self._lock, suppress(ValueError):
                self._listeners.remove(listener)

        return end

    def tell(self, event: Json, *, line: bool = False) -> None:
        """Sends an event to all; ``line``: to later windows too, as a line of progress."""
        kind = event["event"]
        keep_as = kind if kind in KEPT else None
        self.send(text_of_message(event), keep_as, line=line or kind in LINES)

    def send(self, message: str | bytes, keep_as: str | None = None, *, line: bool = False) -> None:
        """Sends a message to all, and to later windows as long as no other is kept by this name."""
        with self._lock:
            if keep_as is not None:
                self._kept.pop(keep_as, None)
                self._kept[keep_as] = message
            if line and isinstance(message, str):
                self._lines = [*self._lines[-MOST_LINES:], message]
            for listener in self._listeners:
                listener(message)

    def forget(self, *kinds: str, lines: bool = False) -> bool:
        """Keeps events or curves of these kinds no longer; returns whether there were any."""
        with self._lock:
            removed = [self._kept.pop(kind, None) for kind in kinds]
            if lines:
                self._lines = []
        return any(removed)
