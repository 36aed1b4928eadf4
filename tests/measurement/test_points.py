"""Points at rest: tables without time, the curves they are put into, and what is wrong with them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, read_data_set, write_data_set
from pam_cosim.model.interface import Interface, Variable
from tests.measurement.bench import variables

BENCH = Interface(
    model="Rig.Benches.Isotonic",
    inputs=variables(Variable("branch", "1", start=0.0), Variable("p", "Pa"), Variable("F", "N")),
    outputs=variables(Variable("x", "m")),
    parameters=variables(
        Variable("muscle.D0", "m", start=0.02, min=0.0), Variable("muscle.k", "N/m", start=1.0)
    ),
)
EXPERIMENT = """\
title = "loops"
model = "Rig.Benches.Isotonic"
kind = "static"
[signals.x]
sigma = "0.1 mm"
[fit]
"muscle.D0" = { min = "10 mm", max = "30 mm" }
[[runs]]
file = "loops.csv"
"""
PRESSURES = (0, 100, 200, 300, 400)
Read = Callable[..., DataSet]


def loop_rows(loads: tuple[float, ...] = (20.0, 60.0)) -> list[str]:
    """Up and down under each load, with a column for the direction; the contraction lags by 1 mm."""
    rows = []
    for load in loads:
        for word, way in (("up", 1), ("down", -1)):
            rows += [f"{p},{load:g},{p / 10 - load / 20 - way:g},{word}" for p in PRESSURES[::way]]
    return rows


def table(rows: list[str], header: str = "p [kPa],F [N],x [mm],branch") -> str:
    return "\n".join([header, *rows, ""])


@pytest.fixture
def read(tmp_path: Path) -> Read:
    def call(
        text: str,
        experiment: str = EXPERIMENT,
        interface: Interface = BENCH,
        name: str = "loops.csv",
    ) -> DataSet:
        (tmp_path / "experiment.toml").write_text(experiment)
        (tmp_path / name).write_text(text)
        return read_data_set(tmp_path, lambda _: interface)

    return call


def test_branches_and_loads_are_curves(read: Read) -> None:
    data = read(table(loop_rows()))
    assert [run.name for run in data.runs] == [
        "loops F = 20 N, up", "loops F = 60 N, up", "loops F = 20 N, down", "loops F = 60 N, down"
    ]  # fmt: skip
    up = data.runs[0]
    assert up.is_static and up.along is not None and (up.along.name, up.along.unit) == ("p", "Pa")
    np.testing.assert_allclose(up.time, np.array(PRESSURES) * 1e3)
    np.testing.assert_allclose(up.inputs["branch"], 1.0)
    np.testing.assert_allclose(
        data.runs[3].measurements["x"], (np.array(PRESSURES) / 10 - 3 + 1) * 1e-3
    )


def test_a_set_pressure_is_one_though_it_is_read_with_noise(read: Read) -> None:
    rng = np.random.default_rng(2)
    rows = [
        f"{p + rng.normal(0, 0.3):.3f},{f:g},{p / 10 - f / 20:g}"
        for f in np.linspace(0, 90, 10)
        for p in (100, 200, 300)
    ]
    data = read(table(rows, "p [kPa],F [N],x [mm]"))
    assert [run.name for run in data.runs] == [f"loops p = {p} kPa" for p in (100, 200, 300)]
    assert all(
        run.along is not None and run.along.name == "F" and len(run.time) == 10 for run in data.runs
    )


@pytest.mark.parametrize("noise", [0.0, 2.0])
def test_the_direction_follows_from_the_order(read: Read, noise: float) -> None:
    rng = np.random.default_rng(4)
    cycle = [0, 100, 200, 300, 400, 300, 200, 100, 0, 100, 200]
    rows = [f"{p + rng.uniform(-noise, noise):.2f},{f},{p / 10:g}" for f in (20, 60) for p in cycle]
    data = read(table(rows, "p [kPa],F [N],x [mm]"), EXPERIMENT + 'branch = "order"\n')
    counts = {run.name: len(run.time) for run in data.runs}
    assert counts == {
        "loops F = 20 N, up": 7,
        "loops F = 60 N, up": 7,
        "loops F = 20 N, down": 4,
        "loops F = 60 N, down": 4,
    }


def test_values_are_held_out(read: Read) -> None:
    held = EXPERIMENT + 'hold_out = { F = ["60 N"], p = ["2 bar"] }\n'
    data = read(table(loop_rows()), held)
    roles = {run.name: (run.role, len(run.time)) for run in data.runs}
    assert roles["loops F = 20 N, up"] == ("fit", 4)
    assert roles["loops F = 20 N, up, held out"] == ("holdout", 1)
    assert roles["loops F = 60 N, down, held out"] == ("holdout", 5)
    assert "loops F = 60 N, up" not in roles


def test_noise_shows_in_repeated_points_and_along_curves(read: Read) -> None:
    rng = np.random.default_rng(5)
    rows = [
        f"{p},{f},{p / 10 - f / 20 + rng.normal(0, 0.05):.5f}"
        for _ in range(5) for f in (20, 60) for p in np.linspace(0, 400, 9)
    ]  # fmt: skip
    data = read(table(rows, "p [kPa],F [N],x [mm]"), EXPERIMENT.replace('sigma = "0.1 mm"\n', ""))
    sigma = data.signals["x"].sigma
    assert sigma == pytest.approx(0.05e-3, rel=0.2)


def test_what_is_written_reads_back(read: Read, tmp_path: Path) -> None:
    data = read(table(loop_rows()))
    again = write_data_set(tmp_path / "again", data, BENCH)
    assert [replace(r, file=Path()).name for r in again.runs] == [r.name for r in data.runs]
    for a, b in zip(data.runs, again.runs, strict=True):
        np.testing.assert_allclose(a.measurements["x"], b.measurements["x"])
        np.testing.assert_allclose(a.inputs["branch"], b.inputs["branch"])


ROWS = loop_rows()
TOML, CSV = "experiment.toml", "loops.csv"
NOT_STATIC = EXPERIMENT.replace('kind = "static"', "")
AT_REST = EXPERIMENT.replace('kind = "static"', 'kind = "rest"')
IMPOSED, TIMED = "p [kPa],x [mm]", "time [s],p [kPa],F [N],x [mm],branch"


@pytest.mark.parametrize(
    ("text", "experiment", "words"),
    [
        (
            table([*ROWS[:3], "3,2,9,left"]),
            "",
            [f"{CSV}:5: column 'branch': 'left' is none of up, down, none"],
        ),
        (table([*ROWS[:3], "3,2,9,0.5"]), "", [f"{CSV}:5: column 'branch'", "0.5 is no direction"]),
        (
            table([f"0,{r}" for r in ROWS], TIMED),
            "",
            [f"{CSV}:1: column 'time'", "have no time", "ignore"],
        ),
        (
            table(["0,20,1,up", ",20,5,up"]),
            "",
            [f"{CSV}:3: column 'p'", "the cell is empty; every row must have"],
        ),
        (
            table(["0,1", "100,5"], IMPOSED),
            "",
            [f"{CSV}:1", "no column 'F', nor a value", "a row imposes p, F"],
        ),
        (
            table(["0,1", "100,5"], "q [kPa],x [mm]"),
            "",
            [f"{CSV}:1: column 'q'", "no input or output 'q'"],
        ),
        (table(["0,20,1,3"], "p [kPa],F [N],x [mm],muscle.k"), "", ["'muscle.k' is a parameter"]),
        (
            table(ROWS),
            'branch = "up"',
            [f"{TOML}:10", f"branch is stated here and a column of {CSV}"],
        ),
        (table(ROWS), 'branch = "left"', [f"{TOML}:10", "'left' is not possible", "'order'"]),
        (table(ROWS), AT_REST, [f"{TOML}:3", "'rest' is not possible"]),
        (
            table(ROWS),
            'hold_out = { p = ["250 kPa"] }',
            [f"{TOML}:10", "no row has p = '250 kPa'", "nearest"],
        ),
        (
            table(ROWS),
            'hold_out = { x = ["2 mm"] }',
            [f"'x' is no column of {CSV} that is imposed; those are p, F"],
        ),
        (table(ROWS), 'hold_out = { F = ["2 kPa"] }', [f"{TOML}:10", "F:", "kPa"]),
        (table(ROWS), 'hold_out = { F = ["20 N", "60 N"] }', [f"no row of {CSV} remains to fit"]),
        (table(ROWS), NOT_STATIC + 'branch = "up"\n', ["branch is for points at rest"]),
        (
            table(ROWS),
            '[runs.recording]\nresample = "1 s"',
            [f"{TOML}:11", "resample is for recordings over time"],
        ),
        *(
            (table(ROWS), f"{key} = {value}", [f"{TOML}:10", f"{key} is for recordings over time"])
            for key, value in (
                ("from", '"1 s"'),
                ("to", "3"),
                ("gaps", '"split"'),
                ("interpolation", '"linear"'),
                ("start", '"rest"'),
                ("lead", '"1 s"'),
                ("periodic", "false"),
            )
        ),
        *(
            (
                table(ROWS),
                EXPERIMENT.replace('kind = "static"', f'kind = "static"\n{key} = {value}'),
                [f"{TOML}:4", f"{key} is for recordings over time"],
            )
            for key, value in (
                ("start", '"rest"'),
                ("before", '{ p = "1 bar", for = "1 s" }'),
                ("lead", '"1 s"'),
                ("periodic", "false"),
                ("gaps", '"split"'),
            )
        ),
        (
            table(ROWS),
            '[[runs.loggers]]\nfile = "loops.csv"\noffset = 0',
            ["other loggers", "have none"],
        ),
        (
            table(ROWS),
            '[runs.fit]\n"muscle.k" = { min = "0 N/m", max = "9 N/m" }',
            [f"{CSV}' holds 4 curves"],
        ),
        (
            table(["20,1", "20,2"], "F [N],x [mm]"),
            'branch = "order"\n[runs.parameters]\np = "1 bar"',
            [f"{TOML}:10", f"the rows of {CSV} do not determine a direction"],
        ),
    ],
)
def test_what_is_wrong_is_said_once(
    read: Read, text: str, experiment: str, words: list[str]
) -> None:
    whole = experiment if experiment.startswith("title") else f"{EXPERIMENT}{experiment}\n"
    with pytest.raises(InputError) as error:
        read(text, whole)
    for word in words:
        assert word in str(error.value)
