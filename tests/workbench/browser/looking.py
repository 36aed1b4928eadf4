"""What a person sees on the page, as values."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from typing import Any

ERROR = re.compile(r"([\d.]+(?:e-?\d+)?)\s*\S*$")


def error(page: Any, signal: str, role: str = "fit") -> float:
    """The root mean square error that stands in the ladder."""
    text = page.locator(f'#ladder .{role}[data-signal="{signal}"]').inner_text()
    found = ERROR.search(text.replace("\u00a0", " ").replace("\u2212", "-"))
    assert found, text
    return float(found.group(1))


def noise(page: Any, signal: str) -> float:
    """The noise that stands in the ladder."""
    return error(page, signal, "noise")


def picture(page: Any, signal: int = 0) -> str:
    """The curves of a signal, pixel by pixel."""
    text: str = page.locator(".curve").nth(signal).evaluate("canvas => canvas.toDataURL()")
    return text


def drag(page: Any, parameter: str, share: float) -> None:
    """Drags a slider with the mouse to a share of its length."""
    slider = page.locator(f'input[type=range][data-parameter="{parameter}"]')
    box, at = slider.bounding_box(), float(slider.input_value()) / 1000
    middle, left, long = box["y"] + box["height"] / 2, box["x"] + 8, box["width"] - 16
    page.mouse.move(left + at * long, middle)
    page.mouse.down()
    for step in range(1, 6):
        page.mouse.move(left + (at + (share - at) * step / 5) * long, middle)
    page.mouse.up()


def until(page: Any, holds: Callable[[], bool], seconds: float = 120.0) -> None:
    """Waits until something holds; the page's policy lets no script be made from text, so it is asked from here."""
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, (
            f"waited {seconds:g} s; the page says: {page.locator('#status').inner_text()}"
        )
        page.wait_for_timeout(50)


def settled(page: Any, value: Callable[[], float]) -> float:
    """What a value is when it no longer changes."""
    seen, now = None, value()
    while now != seen:
        page.wait_for_timeout(500)
        seen, now = now, value()
    return now


def quiet(page: Any, seconds: float = 240.0) -> None:
    """Waits until nothing runs."""
    until(
        page,
        lambda: page.locator("#stop").is_disabled() and page.locator("body.busy").count() == 0,
        seconds,
    )
