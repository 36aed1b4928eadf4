"""The real command on files as labs have them: the same result as with the documented format, or one error."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy.io

from tests.cli.conftest import EXPERIMENT, Outcome, table

Command = Callable[..., Outcome]
ROWS = [tuple(map(float, row.split(","))) for row in table().split("\n")[1:-1]]
COLUMNS = '[columns]\ntime = { column = "Zeit" }\np = { formula = \'(U - "1 V") * "100 kPa/V"\' }\n'


def logger(data: Path) -> str:
    """Semicolons, decimal commas, lines above, units in their own row, a column of text."""
    rows = "".join(f"{t};{p / 100 + 1:.8f};ok;\n".replace(".", ",") for t, p in ROWS)
    text = "Messung 12;;;\nBediener: Jürgen;;;\n\nZeit;U;Güte;\ns;V;;\n" + rows
    (data / "one.csv").write_bytes(text.encode("latin-1"))
    return EXPERIMENT.replace("[fit]", f'[recording]\nignore = ["Güte"]\n{COLUMNS}[fit]')


def matlab(data: Path) -> str:
    time, p = np.array(ROWS).T
    scipy.io.savemat(data / "one.mat", {"run": {"t": 1e3 * time, "p": p}})
    units = '[columns]\ntime = { column = "t", unit = "ms" }\np = { unit = "kPa" }\n'
    return EXPERIMENT.replace("[fit]", f"{units}[fit]").replace("one.csv", "one.mat")


@pytest.mark.parametrize("write", [logger, matlab])
def test_compare_prints_the_same(
    command: Command, place: Path, data: Path, write: Callable[[Path], str]
) -> None:
    scores = []
    for experiment in (EXPERIMENT, write):
        text = experiment if isinstance(experiment, str) else experiment(data)
        (data / "experiment.toml").write_text(text, encoding="utf-8")
        outcome = command("compare data --json r.json")
        assert outcome.status == 0, outcome.err
        scores.append(json.loads((place / "r.json").read_text())["runs"])
    one, other = (run[0]["signals"] if isinstance(run, list) else run for run in scores)
    assert len(_numbers(one)) > 5
    np.testing.assert_allclose(_numbers(one), _numbers(other), rtol=1e-5, atol=1e-6)


def _numbers(content: object) -> list[float]:
    if isinstance(content, dict):
        return [number for value in content.values() for number in _numbers(value)]
    if isinstance(content, list):
        return [number for value in content for number in _numbers(value)]
    return [float(content)] if isinstance(content, (int, float)) else []
