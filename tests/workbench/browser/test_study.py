"""The whole study on the page: values with units, signals, free parameters; all is undone, and saved as files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

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
        assert len(root.findall(".//{*}path")) > 6 and "p, " in "".join(root.itertext())
    else:
        assert file.read_bytes().startswith(b"\x89PNG")
