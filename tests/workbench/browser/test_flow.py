"""From a stranger's files to the written model without leaving the page: three laboratories record the same rig."""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pam_cosim import study
from tests.workbench.browser.conftest import serving
from tests.workbench.browser.looking import error, noise, until

LONG = 900.0  # s, for a diagnosis on a machine that does other things too
WIRE = 312.6  # mm, which a draw wire reads at rest
SAME = (1.0, 0.0)
FROM_KPA, FROM_A, FROM_WIRE = (0.01, 0.0), (1000.0, 0.0), (-1.0, WIRE)


@dataclass(frozen=True)
class Laboratory:
    """How a laboratory records: its headings by the rig's columns, each with factor and offset, and its answers."""

    columns: dict[str, tuple[str, tuple[float, float]]]
    names: tuple[str, str]
    answers: dict[str, str]
    comma: bool = False
    head: str = ""

    def record(self, folder: Path, own: Path) -> Path:
        """Writes a recording of the rig in the laboratory's form."""
        source = folder / f"run-0{1 + self.names.index(own.stem)}.csv"
        with source.open() as stream:
            header, *rows = csv.reader(stream)
        place = {name.split(" ")[0]: i for i, name in enumerate(header)}
        mark, point = (";", ",") if self.comma else (",", ".")
        lines = [mark.join(name for name, _ in self.columns.values())]
        for row in rows:
            values = (
                float(row[place[name]]) * factor + offset
                for name, (_, (factor, offset)) in self.columns.items()
            )
            lines.append(mark.join(f"{value:.6g}".replace(".", point) for value in values))
        own.write_text(self.head + "\n".join(lines) + "\n", encoding="utf-8")
        return own


LABORATORIES = {
    "wire": Laboratory(
        {
            "time": ("Time (ms)", (1000.0, 0.0)),
            "p": ("Druck [bar]", FROM_KPA),
            "x": ("Weg_mm", FROM_WIRE),
            "T": ("Temp", SAME),
            "u_in": ("I_valve1 (mA)", FROM_A),
            "u_out": ("I_valve2 (mA)", FROM_A),
            "p_supply": ("Versorgung", FROM_KPA),
        },
        ("versuch_1", "versuch_2"),
        {"zero x": f"{WIRE} mm"},
        comma=True,
    ),
    "formula": Laboratory(
        {
            "time": ("t [s]", SAME),
            "p": ("Pressure (bar)", FROM_KPA),
            "x": ("Position (mm)", FROM_WIRE),
            "T": ("Gas temp (°C)", SAME),
            "u_in": ("Valve in [mA]", FROM_A),
            "u_out": ("Valve out [mA]", FROM_A),
            "p_supply": ("Supply", FROM_KPA),
        },
        ("run1", "run2"),
        {
            "column x": f'"{WIRE} mm" - Position',
            "column p_supply": 'Supply * "1 bar"',
        },
        head="\ufeff# Rig 2\n# operator: A\n\n",
    ),
    "japanese": Laboratory(
        {
            "time": ("時間[s]", SAME),
            "p": ("圧力[bar]", FROM_KPA),
            "x": ("変位[mm]", SAME),
            "T": ("温度[℃]", SAME),
            "u_in": ("給気弁電流[mA]", FROM_A),
            "u_out": ("排気弁電流[mA]", FROM_A),
            "p_supply": ("供給圧力[bar]", FROM_KPA),
        },
        ("実験1", "実験2"),
        {},
        comma=True,
    ),
}


@pytest.mark.full
@pytest.mark.parametrize("name", LABORATORIES)
def test_a_strangers_files_become_a_fitted_model(
    opened: Callable[..., Any], muscle: Path, tmp_path: Path, name: str
) -> None:
    laboratory = LABORATORIES[name]
    files = [laboratory.record(muscle, tmp_path / f"{run}.csv") for run in laboratory.names]
    folder = tmp_path / "new-rig"
    with serving(folder) as address:
        page = opened(address, wait=".zone")
        page.set_input_files("#recordings", files)
        page.locator(".draft:not(.waiting) section").first.wait_for()
        assert page.get_by_text(laboratory.names[0]).count() > 0
        loads = zip(laboratory.names, ("2.27 kg", "4 kg"), strict=True)
        for field, text in {
            **laboratory.answers,
            "muscle": "physical",
            **{f"parameter load.m@{run}": load for run, load in loads},
        }.items():
            answer(page, field, text)
        page.locator(f'[data-wish="role {laboratory.names[1]}"]').select_option("holdout")
        drafted(page)
        page.get_by_role("button", name="Make the data set").click()
        page.locator("#ladder .fit:not(:empty)").first.wait_for()

        page.locator("#fit").click()
        until(page, lambda: "fit is done" in page.locator("#status").inner_text())
        assert error(page, "x", "holdout") > 2 * noise(page, "x")
        page.locator("#diagnose").click()
        page.locator(".verdict .steps-on button").wait_for(timeout=1000 * LONG)
        assert "elasticity" in page.locator(".verdict h2").inner_text()
        page.locator(".verdict .steps-on button").click()
        until(page, lambda: page.locator(".effect.on").count() > 0)
        until(page, lambda: error(page, "x", "holdout") < 1.3 * noise(page, "x"))
        page.locator("#add").click()
        page.locator("#add-dialog").get_by_role("button", name="Write").click()
        page.locator("#add-dialog pre").wait_for()
        page.close()
    assert list(folder.glob("*.mo"))
    recorded = np.genfromtxt(muscle / "run-01.csv", delimiter=",", skip_header=1)
    run = study.read(folder).runs[0]
    for signal, column, factor in (("p", 4, 1e3), ("x", 5, 1e-3)):
        np.testing.assert_allclose(
            run.measurements[signal], recorded[:, column] * factor, atol=1e-2 * factor
        )


def answer(page: Any, field: str, text: str) -> None:
    """Types into a field of the draft, and waits until the draft has taken it."""
    one = page.locator(f'[data-wish="{field}"]')
    one.fill(text)
    one.press("Tab")
    page.locator(".chips li", has_text=text).first.wait_for()
    drafted(page)


def drafted(page: Any) -> None:
    """Waits for the draft of what was said last: it is asked for a moment after that."""
    page.wait_for_timeout(700)
    page.locator(".draft:not(.waiting)").wait_for()
