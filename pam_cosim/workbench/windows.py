"""Who looks at a session: each window is told all that there is when it opens, and from then on what happens."""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress

from pam_cosim.workbench.protocol import PageEvent

Listener = Callable[[str | bytes], None]
MOST_LINES = 2000  # of progress that a new window is told


class Windows:
    """The listeners of a session, and what a new one has to know."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._listeners: list[Listener] = []
        self._kept: dict[str, str | bytes] = {}
        self._lines: list[str] = []

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Adds a window; returns what takes it away. The listener is called from other threads and must not wait."""
        with self._lock:
            for message in (*self._kept.values(), *self._lines):
                listener(message)
            self._listeners.append(listener)

        def end() -> None:
            with self._lock, suppress(ValueError):
                self._listeners.remove(listener)

        return end

    def keep(self, event: PageEvent) -> None:
        """What a window that opens later is told instead of the last event of this kind."""
        with self._lock:
            self._kept[event.event] = event.message()

    def tell(self, event: PageEvent) -> None:
        """Tells an event to all."""
        self.send(event.message(), event.event if event.kept else None, every=event.every)

    def send(
        self, message: str | bytes, keep_as: str | None = None, *, every: bool = False
    ) -> None:
        """Sends a message to all, and to those that come later as long as no other is kept by this name."""
        with self._lock:
            if keep_as is not None:
                self._kept.pop(keep_as, None)
                self._kept[keep_as] = message
            if every and isinstance(message, str):
                self._lines = [*self._lines[-MOST_LINES:], message]
            for listener in self._listeners:
                listener(message)

    def forget(self, *kinds: type[PageEvent], lines: bool = False) -> None:
        """What these events said is no longer so: a window that opens later is not told."""
        with self._lock:
            for kind in kinds:
                self._kept.pop(kind.event, None)
            if lines:
                self._lines = []

    def forget_frame(self, kind: str) -> bool:
        """Curves of this kind are gone; whether there were any."""
        with self._lock:
            return self._kept.pop(kind, None) is not None
