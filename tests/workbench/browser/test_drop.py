"""Recordings that are dropped become a data set; what is wrong is said at its cell."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pam_cosim import study
from tests.workbench.browser.conftest import serving
from tests.workbench.browser.looking import until

WRONG = "<b>oops</b>"


@pytest.mark.full
def test_dropped_recordings_become_a_data_set(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    lines = (muscle / "run-02.csv").read_text().splitlines()
    lines[39] = WRONG + lines[39][lines[39].index(",") :]
    broken = tmp_path / "broken.csv"
    broken.write_text("\n".join(lines))
    folder = tmp_path / "my-rig"
    with serving(folder) as address:
        page = opened(address, wait=".zone")
        page.set_input_files("#recordings", [muscle / "run-01.csv", broken])
        page.locator(".problem").wait_for()
        assert "broken.csv, line 40, column time" in page.locator(".problem h3").inner_text()
        assert page.locator(".excerpt td.wrong").inner_text() == WRONG
        assert page.locator("#drop b", has_text="oops").count() == 0
        assert page.get_by_role("button", name="Make the data set").is_disabled()
        assert not folder.exists() or not list(folder.iterdir())

        page.get_by_role("button", name="Remove broken.csv").click()
        page.set_input_files("#recordings", [muscle / "run-02.csv"])
        until(page, lambda: page.locator(".draft select[data-wish^=role]").count() == 2)
        assert page.locator(".preview").count() == 3
        assert page.locator("select[data-wish=model]").input_value() == "Isotonic"
        page.locator('select[data-wish="role run-02"]').select_option("holdout")
        until(page, lambda: 'role = "holdout"' in (page.locator(".draft pre").text_content() or ""))
        page.get_by_role("button", name="Make the data set").click()
        page.locator("#ladder .holdout:not(:empty)").first.wait_for()
        page.close()
    data = study.read(folder)
    assert [(run.name, run.role) for run in data.runs] == [("run-01", "fit"), ("run-02", "holdout")]


@pytest.mark.full
def test_a_wrong_word_can_be_said_otherwise(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    with serving(tmp_path / "my-rig") as address:
        page = opened(address, wait=".zone")
        page.set_input_files("#recordings", [muscle / "run-01.csv"])
        page.locator(".preview").first.wait_for()
        page.get_by_text("Take other columns").click()
        page.locator('select[data-wish="column p"]').select_option("x")
        page.locator(".problem").wait_for()
        assert "column 'x' cannot be taken for p" in page.locator(".problem").inner_text()
        assert page.get_by_role("button", name="Make the data set").is_disabled()
        page.get_by_text("Take other columns").click()
        page.locator('select[data-wish="column p"]').select_option("p")
        page.locator(".preview").first.wait_for()
        assert page.locator(".problem").count() == 0
        page.close()


@pytest.mark.full
def test_the_list_of_files_may_come_after_the_answer(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    """It comes over the socket, which here keeps it back until the page has asked what becomes of the file."""
    kept: list[Any] = []

    def keeping(page_side: Any) -> None:
        server_side = page_side.connect_to_server()

        def down(message: Any) -> None:
            late = isinstance(message, str) and '"dropped"' in message and "run-01" in message
            kept.append(message) if late else page_side.send(message)

        def up(message: Any) -> None:
            if '"draft"' in str(message):
                for one in kept:
                    page_side.send(one)
            server_side.send(message)

        server_side.on_message(down)
        page_side.on_message(up)

    with serving(tmp_path / "my-rig") as address:
        page = opened(address, wait=".zone", socket=keeping)
        page.set_input_files("#recordings", [muscle / "run-01.csv"])
        page.locator(".preview").first.wait_for()
        assert kept
        page.close()
