"""Recordings that are dropped become a data set; what is wrong is said at its cell."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
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
        assert page.locator("[data-wish=model]").get_attribute("placeholder") == "Isotonic"
        assert page.locator("#drop", has_text="--").count() == 0  # no option of a terminal
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
        say(page, "column p", "x")
        page.locator(".problem").wait_for()
        assert "column 'x' cannot be taken for p" in page.locator(".problem").inner_text()
        assert page.get_by_role("button", name="Make the data set").is_disabled()
        page.get_by_role("button", name="Take back p").click()
        page.locator(".preview").first.wait_for()
        assert page.locator(".problem").count() == 0
        page.close()


def say(page: Any, field: str, text: str) -> None:
    """Types into a field of the draft, and waits until the draft answers it."""
    one = page.locator(f'[data-wish="{field}"]')
    one.fill(text)
    one.press("Tab")
    page.locator(".chips li", has_text=text).wait_for()
    page.locator(".draft:not(.waiting)").wait_for()


@pytest.mark.full
def test_a_wire_whose_zero_is_elsewhere_becomes_a_contraction(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    """In German, with a zero, a type of muscle and a braid angle; a wrong answer is taken back, and the page stays."""
    head, *rows = (muscle / "run-01.csv").read_text().splitlines()
    names = head.split(",")
    place = next(i for i, name in enumerate(names) if name.startswith("x "))
    names = [german(name) for name in names]
    cells = [row.split(",") for row in rows]
    for row in cells:
        row[place] = f"{312.6 - float(row[place]):.4f}" if row[place] else ""
    lines = [";".join(names), *(";".join(row).replace(".", ",") for row in cells)]
    file = tmp_path / "Versuch_1.csv"
    file.write_text("\n".join(lines), encoding="cp1252")
    folder = tmp_path / "prüfstand"
    with serving(folder) as address:
        page = opened(address, wait=".zone")
        page.set_input_files("#recordings", [file])
        page.locator(".problem").wait_for()
        assert "which reading is zero" in page.locator(".problem").inner_text()
        page.locator(".problem").get_by_role("button", name='x = "313 mm" - Seilweg').click()
        page.locator(".preview").first.wait_for()
        say(page, "muscle", "any-geometry")
        page.locator('[data-wish="parameter muscle.sleeve.alpha_0"]').wait_for()
        say(page, "parameter muscle.sleeve.alpha_0", "25 deg")
        page.locator(".problem").wait_for()
        page.get_by_role("button", name="muscle.sleeve.turns = 0").click()
        page.locator(".chips li", has_text="turns").wait_for()
        page.locator(".preview").first.wait_for()
        page.locator('[data-wish="zero x"]').fill("312.6 mm")
        page.locator('[data-wish="zero x"]').press("Tab")
        page.locator(".chips li", has_text="312.6 mm").wait_for()
        until(page, lambda: page.locator(".draft:not(.waiting) .preview").count() > 0)
        assert page.locator(".problem").count() == 0
        page.get_by_role("button", name="Make the data set").click()
        page.locator("#ladder .fit:not(:empty)").first.wait_for()
        page.go_back()
        assert page.locator("#title").inner_text() == "prüfstand"
        page.close()
    data = study.read(folder)
    recorded = [float(row.split(",")[place]) * 1e-3 for row in rows]
    np.testing.assert_allclose(data.runs[0].measurements["x"], recorded, atol=1e-7)


@pytest.mark.full
def test_an_input_that_was_not_recorded_has_a_field(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    rows = [row.split(",") for row in (muscle / "run-01.csv").read_text().splitlines()]
    place = next(i for i, name in enumerate(rows[0]) if name.startswith("p_supply"))
    file, folder = tmp_path / "run-01.csv", tmp_path / "my-rig"
    file.write_text("\n".join(",".join(row[:place] + row[place + 1 :]) for row in rows))
    with serving(folder) as address:
        page = opened(address, wait=".zone")
        page.set_input_files("#recordings", [file])
        page.get_by_role("button", name="state p_supply", exact=True).click()
        assert page.evaluate("document.activeElement.dataset.wish") == "parameter p_supply"
        say(page, "parameter p_supply", "207 kPa")
        page.get_by_role("button", name="Make the data set").click()
        page.locator("#ladder .fit:not(:empty)").first.wait_for()
        page.close()
    assert study.read(folder).parameters["p_supply"] == pytest.approx(207e3)


def german(heading: str) -> str:
    """A heading of the recordings as a German logger has it."""
    name, unit = heading.split(" ")
    words = {"time": "Zeit", "u_in": "Ventilstrom_ein", "u_out": "Ventilstrom_aus", "x": "Seilweg"}
    words |= {"p_supply": "Versorgungsdruck", "p": "Druck", "T": "Temperatur"}
    return f"{words[name]} {unit}"


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
