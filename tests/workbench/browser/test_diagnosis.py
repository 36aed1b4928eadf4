"""From a measurement with a hidden effect to the error at the noise, and the same numbers when it is loaded again."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from pam_cosim.workbench import Session
from pam_cosim.workbench.commands.files import save
from pam_cosim.workbench.saved import lean
from pam_cosim.workbench.steps import Step
from tests.reporting.synthetic import make_diagnosis
from tests.workbench.browser.conftest import serving
from tests.workbench.browser.looking import error, noise, quiet, until
from tests.workbench.conftest import Window

LONG = 900.0  # s, for a diagnosis on a machine that does other things too


@pytest.mark.full
def test_a_study_from_the_first_look_to_the_saved_file(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    folder = shutil.copytree(muscle, tmp_path / "rig")
    with serving(folder) as address:
        page = opened(address)
        page.locator("#fit").click()
        until(page, lambda: "fit is done" in page.locator("#status").inner_text())
        before = error(page, "x", "holdout")
        assert before > 2 * noise(page, "x")

        page.locator("#diagnose").click()
        until(page, lambda: page.locator(".ranking tbody tr").count() > 0, LONG)
        page.close()  # it goes on without a window
        page = opened(address)
        until(
            page,
            lambda: page.locator(".verdict h2").count() > 0 and page.locator("#stop").is_disabled(),
            LONG,
        )
        page.locator("#tab-diagnosis").click()
        assert "elasticity" in page.locator(".verdict h2").inner_text()
        assert "Probability" in page.locator(".verdict").inner_text()
        assert page.locator(".ranking tbody tr").count() >= 3
        assert "elasticity" in page.locator(".family-table").inner_text()
        assert "LinearBladder" in page.locator("#legend .key.found").text_content()
        page.locator("#tab-balances").click()
        assert "force balance" in page.locator("#balances").inner_text()

        page.locator("#tab-diagnosis").click()
        page.locator(".verdict button").click()
        until(page, lambda: page.locator(".effect.on").count() == 1)
        until(page, lambda: error(page, "x", "holdout") < 1.15 * noise(page, "x"))
        until(page, lambda: page.locator("#legend .key.found").count() == 0)
        page.locator("#add").click()
        page.locator("#add-dialog").get_by_role("button", name="Write").click()
        page.locator("#add-dialog pre").wait_for()
        page.locator("#add-dialog").get_by_role("button", name="Close").click()
        assert list(folder.glob("*.mo"))

        page.locator("#save").click()
        until(page, lambda: page.locator("#save").inner_text() == "Saved")
        shown = page.locator("#ladder").inner_text(), page.locator("#parameters").inner_text()
        page.close()
    with serving(folder) as address:
        page = opened(address)
        page.locator("#tab-study").click()
        if page.locator(".effect.on").count() == 0:
            page.get_by_role("button", name="Load what was saved").click()
        until(page, lambda: page.locator(".effect.on").count() == 1)
        quiet(page)
        until(
            page,
            lambda: bool(
                (page.locator("#ladder").inner_text(), page.locator("#parameters").inner_text())
                == shown
            ),
        )
        page.close()


def save_diagnosis(folder: Path) -> None:
    """As after a diagnosis; its ranking was made by hand."""
    with Session(folder) as session:
        state = session.state
        found = lean(make_diagnosis("identified", state.data))
        diagnosed = state.after(Step("diagnose", {}), diagnosis=found)
        Window(session).in_its_thread(lambda: session.back(diagnosed))
        save(session)


@pytest.mark.full
def test_a_diagnosis_that_was_taken_back_is_gone_from_the_page(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path
) -> None:
    folder = shutil.copytree(muscle, tmp_path / "rig")
    save_diagnosis(folder)
    with serving(folder) as address:
        page, other = opened(address), opened(address)
        for one in (page, other):
            one.locator("#tab-diagnosis").click()
            one.locator(".verdict h2").wait_for()
            assert one.locator("#add.main").count() == 1
        page.locator("#undo").click()
        for one in (page, other):
            one.locator(".verdict").wait_for(state="hidden")
            assert one.locator("#diagnosis table.ranking:visible").count() == 0
            assert one.locator("#add.main").count() == 0
            one.locator("#add").click()
            assert "No effect is switched on" in one.locator("#add-dialog").inner_text()
            one.locator("#add-dialog").get_by_role("button", name="Close").click()
            one.locator("#tab-balances").click()
            assert "Press Diagnose" in one.locator("#balances").inner_text()
            one.close()
