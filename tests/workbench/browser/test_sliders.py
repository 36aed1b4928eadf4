"""A slider moves the curves and the error; zoom and rules show where."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.workbench.browser.conftest import serving
from tests.workbench.browser.looking import drag, error, picture, settled, until

Open = Callable[..., Any]


@pytest.fixture(scope="module")
def address(muscle: Path) -> Iterator[str]:
    with serving(muscle) as told:
        yield told


@pytest.mark.full
def test_a_slider_moves_curve_and_error(opened: Open, address: str) -> None:
    page = opened(address)
    before, curve = error(page, "p"), picture(page)
    drag(page, "valve.C_A", 0.95)
    until(page, lambda: error(page, "p") > 1.5 * before)
    assert picture(page) != curve
    assert float(
        page.locator('input[inputmode=decimal][aria-label="valve.C_A"]').input_value()
    ) == pytest.approx(0.88, abs=0.005)


@pytest.mark.full
def test_undo_takes_the_value_back(opened: Open, address: str) -> None:
    page = opened(address)
    page.get_by_role("button", name="Reset").click()
    before = settled(page, lambda: error(page, "p"))
    drag(page, "valve.C_A", 0.1)
    until(page, lambda: error(page, "p") != before)
    page.get_by_role("button", name="Undo").click()
    until(page, lambda: error(page, "p") == before)


@pytest.mark.full
def test_an_end_of_a_run_is_dragged_and_where_it_begins_moved(opened: Open, address: str) -> None:
    """What is cut begins at its new first sample; both are steps that are taken back."""
    page = opened(address)
    first = page.locator('.start[data-run="run-01"]')
    until(page, lambda: "rest" in first.locator("summary").inner_text())
    whole = picture(page)
    box = page.locator(".curve").first.bounding_box()
    assert box is not None
    left, height = box["x"] + 52, box["y"] + box["height"] / 3  # where charts begin
    page.mouse.move(left + 1, height)
    page.mouse.down()
    page.mouse.move(left + 40, height)
    page.mouse.move(left + 80, height)
    page.mouse.up()
    until(page, lambda: "estimated" in first.locator("summary").inner_text())
    first.locator("summary").click()
    assert float(first.get_by_label("First time of run-01").input_value()) > 0.5
    cut = picture(page)
    drag(page, "muscle.gas.p@run-01", 0.8)
    until(page, lambda: first.locator("select").input_value() == "by hand")
    assert picture(page) != cut
    page.get_by_role("button", name="Undo").click()
    until(page, lambda: first.locator("select").input_value() == "estimated")
    first.get_by_label("First time of run-01").fill("0")
    first.get_by_label("First time of run-01").press("Enter")
    until(page, lambda: first.locator("select").input_value() == "rest")
    until(page, lambda: picture(page) == whole)


@pytest.mark.full
def test_a_second_window_shows_the_same(opened: Open, address: str) -> None:
    first, second = opened(address), opened(address)
    before = second.locator("#ladder").inner_text()
    drag(first, "valve.C_A", 0.3)
    slider = 'input[type=range][data-parameter="valve.C_A"]'

    def same() -> bool:
        ladders = [page.locator("#ladder").inner_text() for page in (first, second)]
        places = [page.locator(slider).input_value() for page in (first, second)]
        return ladders[0] == ladders[1] != before and places[0] == places[1]

    until(second, same)


@pytest.mark.full
def test_charts_zoom_together_and_a_rule_lights_up_its_times(opened: Open, address: str) -> None:
    page = opened(address)
    whole = [picture(page, i) for i in range(3)]
    page.locator(".stack").focus()
    for key in ("+", "+", "ArrowRight"):
        page.keyboard.press(key)
    until(page, lambda: all(picture(page, i) != whole[i] for i in range(3)))
    page.keyboard.press("Home")
    until(page, lambda: [picture(page, i) for i in range(3)] == whole)
    rule = page.locator(".rules button").first
    rule.click()
    until(page, lambda: all(picture(page, i) != whole[i] for i in range(3)))
    assert rule.get_attribute("aria-pressed") == "true"


@pytest.mark.full
def test_all_can_be_reached_by_keys_and_is_seen(opened: Open, address: str) -> None:
    """Tab goes through everything that can be pressed; what has the focus is outlined."""
    page = opened(address)
    reached, plain = set(), []
    for _ in range(150):
        page.keyboard.press("Tab")
        what, outline = page.evaluate(
            """() => { const e = document.activeElement; const s = getComputedStyle(e);
            return [e === document.body ? '' : e.id || e.getAttribute('aria-label') || e.textContent.trim(),
            s.outlineStyle + s.outlineWidth]; }"""
        )
        if not what:
            break
        reached.add(what)
        if outline.startswith("none") or outline.endswith("0px"):
            plain.append(what)
    for expected in (
        "fit",
        "diagnose",
        "add",
        "save",
        "theme",
        "tab-curves",
        "whole",
        "bench",
        "run-01",
        "valve.C_A",
        "Search effects",
    ):
        assert expected in reached, sorted(reached)
    assert plain == []
