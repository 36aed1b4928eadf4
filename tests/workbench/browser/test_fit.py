"""Fit, effects as switches, and the file that Add writes."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tests.workbench.browser.conftest import serving
from tests.workbench.browser.looking import error, noise, quiet, until

EFFECT = "LinearBladder"


def test_a_fit_an_effect_and_its_file(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    """The error falls by a fit, falls to the noise with the effect that is missing, on the held-out run too."""
    folder = shutil.copytree(muscle, tmp_path / "rig")
    with serving(folder) as address:
        page = opened(address)
        stated = error(page, "x")
        page.locator("#fit").click()
        until(page, lambda: "fit is done" in page.locator("#status").inner_text())
        fitted = error(page, "x")
        assert noise(page, "x") < fitted < stated
        assert "95 %" in page.locator("#parameters .parameter").first.inner_text()

        page.get_by_label("Search effects").fill(EFFECT)
        page.locator(f'input[data-effect="{EFFECT}"]').check()
        until(page, lambda: page.locator('input[data-parameter="bladder.k"]').count() == 1)
        page.locator(".effect.on .about summary").click()
        assert "=" in page.locator(".effect.on pre").inner_text()
        assert "contraction" in page.locator(".effect.on .about p").first.inner_text()
        page.locator("#fit").click()
        until(page, lambda: error(page, "x", "holdout") < 1.1 * noise(page, "x"))
        quiet(page)

        page.locator("#add").click()
        page.locator("#add-dialog input").fill("../Outside.mo")  # a bad name is answered in words
        page.locator("#add-dialog").get_by_role("button", name="Write").click()
        page.locator("#add-dialog .caution:not([hidden])").wait_for()
        assert "Outside.mo" in page.locator("#add-dialog .caution").inner_text()
        assert not (tmp_path / "Outside.mo").exists()
        page.locator("#add-dialog input").fill("Better.mo")
        page.locator("#add-dialog").get_by_role("button", name="Write").click()
        page.locator("#add-dialog pre").wait_for()
        assert (
            page.locator("#add-dialog pre").inner_text().strip()
            == (folder / "Better.mo").read_text().strip()
        )
        page.close()
