"""The whole study on the page: values with units, signals, free parameters; all is undone, and saved as files."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from tests.workbench.browser.conftest import serving
from tests.workbench.browser.looking import error, until

Open = Callable[..., Any]


@pytest.mark.full
def test_every_value_and_signal_is_changed_and_taken_back(opened: Open, muscle: Path) -> None:
    with serving(muscle) as address:
        page = opened(address)
        before = error(page, "x")
        page.locator("#tab-study").click()
        field = page.get_by_label("Value of muscle.L0", exact=True)
        field.fill("25 cm")
        field.press("Enter")
        until(page, lambda: error(page, "x") != before)
        assert page.locator("#status-text").inner_text() == "state muscle.L0 = 250 mm"
        page.get_by_label("Filter parameters").fill("sleeve at rest")
        assert page.locator("tr[data-name]:visible").count() == 1
        page.get_by_label("Filter parameters").fill("")
        page.get_by_label("Leave muscle.L0 free").click()
        page.locator('#parameters input[data-parameter="muscle.L0"]').wait_for()
        fitted = page.get_by_label("Fit T", exact=True)
        until(page, lambda: fitted.is_enabled())
        was = fitted.is_checked()
        fitted.click()
        until(page, lambda: page.locator(".steps li code").count() == 3)
        assert page.get_by_label("Fit T", exact=True).is_checked() is not was
        for _ in range(3):
            steps = page.locator(".steps li code").count()
            page.get_by_role("button", name="Undo").click()
            until(page, lambda: page.locator(".steps li code").count() < steps)  # noqa: B023
        until(page, lambda: error(page, "x") == before)
        assert page.locator("#status-text").inner_text() == "Ready"
        page.go_back()
        until(page, lambda: page.locator("#curves").is_visible())
        page.close()


@pytest.mark.full
def test_what_is_typed_has_a_unit_or_is_refused_at_its_field(opened: Open, muscle: Path) -> None:
    with serving(muscle) as address:
        page = opened(address)
        page.locator("#tab-study").click()
        for label, nonsense, meant, shown in (
            ("Value of muscle.L0", "1e999", "25 cm", "250"),
            ("Beginning of run-01, s", "soon", "500 ms", "0.5"),
            ("Noise of p", "5 apples", "20 mbar", "2"),
        ):
            field = page.get_by_label(label, exact=True)
            for text, refused in ((nonsense, "true"), (meant, "false")):
                steps = page.locator(".steps li code").count()
                field.fill(text)
                field.press("Enter")
                until(page, lambda: page.locator("#alert").is_visible() is (refused == "true"))  # noqa: B023
                if refused == "true":
                    assert field.input_value() == text
                    assert field.get_attribute("aria-invalid") == "true"
                    assert page.locator(".steps li code").count() == steps
                else:
                    until(page, lambda: field.input_value() == shown)  # noqa: B023
        page.close()


@pytest.mark.full
def test_zoomed_in_every_sample_of_a_long_recording_is_drawn(
    opened: Open, muscle: Path, tmp_path: Path
) -> None:
    """A recording of 20 000 samples, of which the page is sent 4000 points."""
    folder = shutil.copytree(muscle, tmp_path / "long")
    head, *rows = (folder / "run-01.csv").read_text().splitlines()
    table = np.array([[float(cell) for cell in row.split(",")] for row in rows])
    times = 2e-4 * np.arange(20_000)
    columns = [np.interp(times, table[:, 0], column) for column in table.T]
    np.savetxt(folder / "run-01.csv", np.transpose(columns), "%.9g", ",", header=head, comments="")
    with serving(folder) as address:
        page = opened(address)
        page.locator(".run button").first.click()
        page.locator(".stack").focus()
        for _ in range(14):
            page.keyboard.press("+")
        shown = tmp_path / "shown.csv"

        def is_raw() -> bool:
            with page.expect_download() as downloading:
                page.locator("#download").select_option("csv")
            downloading.value.save_as(shown)
            drawn = [row.split(",") for row in shown.read_text().splitlines()]
            steps = np.diff([float(row[3]) for row in drawn if row[:2] == ["run-01", "x"]])
            return len(steps) > 50 and bool(np.allclose(steps, 2e-4, atol=1e-6))

        until(page, is_raw)
        page.close()


@pytest.mark.full
@pytest.mark.parametrize("kind", ["png", "svg", "csv"])
def test_what_is_shown_is_downloaded(opened: Open, muscle: Path, tmp_path: Path, kind: str) -> None:
    with serving(muscle) as address:
        page = opened(address)
        page.locator(".curve").first.wait_for()
        with page.expect_download() as downloading:
            page.locator("#download").select_option(kind)
        file = tmp_path / f"curves.{kind}"
        downloading.value.save_as(file)
        page.close()
    if kind == "csv":
        head, *rows = file.read_text().splitlines()
        assert head == "run,signal,unit,time,measured,model,residual"
        assert {row.split(",")[0] for row in rows} == {"run-01", "run-02"}
    elif kind == "svg":
        root = ElementTree.parse(file).getroot()
        words = "".join(root.itertext())
        assert len(root.findall(".//{*}path")) > 6 and "p, " in words and "measured" in words
    else:
        assert file.read_bytes().startswith(b"\x89PNG")
