"""Runs that begin in the middle: what is chosen, what is estimated, and that a fit does not see the difference."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.arrays import Array
from pam_cosim.fitting import Free, linearised, residual_rows, with_starts
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_model
from pam_cosim.measurement import DataSet, Run
from pam_cosim.model.references import START_VALUES
from pam_cosim.simulation import Simulator
from pam_cosim.starts import InitialState, StartProbe, measured_initial_state
from pam_cosim.starts.start_values import StartValues, eliminate
from rig.measurement import measure, write_data_set
from rig.plan import default_plan

CUT = 2.5  # s


def _folder(tmp_path: Path, cut: float, start: str = "") -> Path:
    """Runs of the independent rig, one of them held out, without their first seconds."""
    plan = (default_plan()[0], default_plan()[2], default_plan()[4])
    folder = tmp_path / "data"
    write_data_set(folder, _measured(plan))
    for file in folder.glob("*.csv"):
        head, *rows = file.read_text().splitlines()
        file.write_text(
            "\n".join([head, *(r for r in rows if float(r.split(",")[0]) >= cut)]) + "\n"
        )
    text = (folder / "experiment.toml").read_text()
    (folder / "experiment.toml").write_text(f'start = "{start}"\n{text}' if start else text)
    return folder


@cache
def _measured(plan: tuple[object, ...]) -> list[object]:
    return measure(plan, seed=3)  # type: ignore[arg-type, return-value]


@pytest.fixture
def data(tmp_path: Path) -> Callable[..., DataSet]:
    return lambda cut=CUT, start="": pam.read(_folder(tmp_path, cut, start))


def _chi2(fit: pam.Fit, role: str) -> float:
    return fit.comparison.chi2_reduced(role)


@contextmanager
def _settled(data: DataSet) -> Iterator[tuple[Objective, Array, Array]]:
    """An objective with two free parameters, search coordinates, and the residuals there once the starts settled."""
    free = (Free("valve.C_A", 0.5, 0.9, 0.7, "1"), Free("muscle.mu_fb", 0.005, 0.05, 0.018, "1"))
    path = build_model(
        "Isotonic", sensitivities=(*(f.name for f in free), START_VALUES), where_smooth=True
    )
    with Simulator(path) as simulator:
        begun = with_starts(simulator, pam.read(data.folder))
        objective = Objective(simulator, begun, begun.fit_runs, free, tolerance=1e-9)
        z = np.array([f.to_z(f.start) for f in free])
        for _ in range(3):
            objective._latest = None
            at = objective.residuals(z)
        yield objective, z, at


def test_what_other_starts_leave_of_a_change_is_known_beside_a_fitted_model(
    data: Callable[..., DataSet],
) -> None:
    rows = 10**6
    with _settled(data()) as (objective, z, _):
        linear = linearised(objective, z, rows)
        known = Objective(
            objective.simulator, objective.data, objective.runs, objective.free,
            objective.starts.settings, tolerance=1e-9, starts_are_known=True,
        )  # fmt: skip
        moved = z + 0.01
        here, there = residual_rows(known, z, rows), residual_rows(known, moved, rows)
        fitted = residual_rows(objective, moved, rows)
    assert linear is not None and here is not None and there is not None and fitted is not None
    change = there - here
    off = linear.residual + linear.left_by_starts(change) - fitted
    off_with_the_same_starts = linear.residual + change - fitted
    assert np.linalg.norm(off) < 0.1 * np.linalg.norm(off_with_the_same_starts)


def test_a_whole_recording_begins_at_rest(data: Callable[..., DataSet]) -> None:
    compared = pam.compare(data(cut=0.0))
    assert {run.start.mode for run in compared.data.runs} == {"rest"}
    assert "begins" not in str(compared)


def test_a_cut_recording_is_told_first(data: Callable[..., DataSet]) -> None:
    compared = pam.compare(data())
    assert {run.start.mode for run in compared.data.runs} == {"estimated"}
    told = str(compared).splitlines()[1:4]
    assert [line.split(" begins at ")[0].strip() for line in told] == ["run-01", "run-02", "run-03"]
    assert all(line.endswith(": estimated") for line in told)
    assert compared.as_dict()["runs"][0]["start"] == "estimated"  # type: ignore[index]


def test_a_run_begins_at_start_values_that_are_given_with_its_name(
    data: Callable[..., DataSet],
) -> None:
    """A fit holds them, and a comparison with them is the same."""
    free = ["muscle.mu_fb"]
    estimated = pam.fit(data(), free=free)
    held = pam.fit(data(start="rest"), free=free, start=estimated.start_values)
    assert (
        _chi2(held, "fit") == pytest.approx(_chi2(estimated, "fit"), rel=0.02) and not held.starts
    )
    compared = pam.compare(data(start="rest"), parameters=held.values | estimated.start_values)
    assert compared.chi2_reduced("fit") == pytest.approx(_chi2(held, "fit"), rel=1e-6)


def test_cut_and_whole_have_the_same_parameters_and_leave_noise(
    data: Callable[..., DataSet],
) -> None:
    whole, cut = pam.fit(data(cut=0.0)), pam.fit(data())
    for role in ("fit", "holdout"):
        assert 0.9 < _chi2(cut, role) < 1.1
    for name, estimate in cut.parameters.items():
        other = whole.parameters[name]
        assert estimate.low < other.high and other.low < estimate.high
    assert not whole.starts
    assert {name.rpartition("@")[2] for name in cut.starts} == {"run-01", "run-02", "run-03"}


def test_at_rest_a_cut_recording_is_wrong(data: Callable[..., DataSet]) -> None:
    assert _chi2(pam.fit(data(start="rest")), "fit") > 1000


def _measured_starts(
    effects: list[str], data: DataSet, folder: Path
) -> Iterator[tuple[Simulator, Run, InitialState]]:
    """Of each run, by the model of the bench with these effects."""
    model = folder / "WithEffects.mo"
    pam.add(effects, to="Isotonic", output=model)
    with Simulator(build_model(str(model))) as simulator:
        for run in data.runs:
            own = data.parameters_of(run, {})
            yield simulator, run, measured_initial_state(StartProbe(simulator, data, run, own))


def test_a_reading_at_the_end_of_its_range_shows_no_start(
    data: Callable[..., DataSet], tmp_path: Path
) -> None:
    """Beyond the end a position of kilometres changes the reading no more than one of millimetres."""
    starts = list(_measured_starts(["PositionCeiling"], data(start="measured"), tmp_path))
    assert starts
    for _, _, begins in starts:
        assert set(begins.values) == {"muscle.gas.p"}
        assert begins.settle == "others"


@pytest.mark.parametrize("thermometer", ["ThermocoupleLag", "ThermocoupleSheath"])
def test_the_temperature_of_a_gas_is_shown_through_a_slow_thermometer(
    thermometer: str, data: Callable[..., DataSet], tmp_path: Path
) -> None:
    """Where a muscle under pressure began with the mass of an empty one, its gas had a thousand kelvins."""
    data_set, runs = data(start="measured"), 0
    for simulator, run, begins in _measured_starts(["EnergyGas", thermometer], data_set, tmp_path):
        assert begins.values.keys() >= {"muscle.gas.T", "muscle.gas.p", "thermometer.T"}
        times = run.time[:1]
        start = simulator.run(
            times,
            parameters={**data_set.parameters_of(run, {}), **begins.values},
            outputs=["muscle.gas.T"],
            start_time=float(times[0]),
            settle=begins.settle,
        )
        assert start["muscle.gas.T"][0] == pytest.approx(run.measurements["T"][0], rel=0.2)
        runs += 1
    assert runs == len(data_set.runs)


@pytest.mark.parametrize(
    "gas", ["EnergyGas", "ConvectiveGas", "FlexibleGas", "FreeConvectionGas", "RealGas"]
)
def test_a_gas_that_leaks_or_flows_begins_at_a_temperature_that_gases_have(
    gas: str, data: Callable[..., DataSet], tmp_path: Path
) -> None:
    """No mass of the gas is at rest there; with that of an empty muscle its gas had a thousand kelvins."""
    data_set, runs = data(cut=1.0, start="measured"), 0
    without_thermometer = replace(
        data_set, signals={n: s for n, s in data_set.signals.items() if n != "T"}
    )
    models = _measured_starts([gas, "OrificeLeak"], without_thermometer, tmp_path)
    for simulator, run, begins in models:
        own = data_set.parameters_of(run, {})
        start = begins.trajectory(simulator, run, own, run.time[:1], ["muscle.gas.T"])
        assert 230.0 < start["muscle.gas.T"][0] < 430.0
        runs += 1
    assert runs == len(data_set.runs)


def test_a_reading_through_states_of_the_instrument_shows_what_it_reads(
    data: Callable[..., DataSet], tmp_path: Path
) -> None:
    """A muscle under pressure came to rest without any, since no single state gave the reading."""
    starts = list(_measured_starts(["PressureDelay"], data(start="measured"), tmp_path))
    assert starts
    for _, run, begins in starts:
        assert begins.shown["muscle.gas.p"] == "p"  # not T, which shows it less well
        read = begins.values["muscle.gas.p"] - 101325.0
        assert read == pytest.approx(run.measurements["p"][0], rel=0.05, abs=2e3)


def test_steady_is_right_where_the_rig_rested(data: Callable[..., DataSet]) -> None:
    """At 3.3 s the muscle has been at the pressure of the supply for some time, with the inlet still open."""
    data_set = data(cut=3.3, start="steady")
    first = replace(data_set, runs=(replace(data_set.runs[0], role="fit"),))
    assert _chi2(pam.fit(first), "fit") < 1.2


def test_slopes_with_the_start_following_are_those_of_the_whole(
    data: Callable[..., DataSet],
) -> None:
    """The eliminated slopes are the differences of what is left when the starts are estimated anew."""
    with _settled(data()) as (objective, z, at):
        jacobian = objective.jacobian(z, at)
        for i in range(len(z)):
            low, high = z.copy(), z.copy()
            step = 1e-4 * abs(z[i])
            low[i], high[i] = z[i] - step, z[i] + step
            below, above = objective.residuals(low), objective.residuals(high)
            size = float(np.linalg.norm(jacobian[:, i]))
            # The sum of squares and its slope are what a descent goes by.
            slope = (above @ above - below @ below) / (2 * step)
            assert slope == pytest.approx(2 * at @ jacobian[:, i], rel=1e-3)
            assert np.linalg.norm((above - below) / (2 * step) - jacobian[:, i]) < 0.02 * size


def test_a_force_that_is_missing_is_no_start(tmp_path: Path) -> None:
    """It is there from the first sample on, but no pressure that the manometer allows explains it."""
    times, rng = np.linspace(0.0, 4.0, 201), np.random.default_rng(1)
    command = {
        "time": times,
        "u_in": np.where(times < 2.0, 0.3, 0.0),
        "u_out": np.where(times < 2.0, 0.0, 0.3),
    }
    run = pam.simulate("Isometric", inputs=command, stop_time=4.0, interval=0.02)
    p = run["p"] + 500.0 * rng.standard_normal(len(times))
    force = run["F"] - 0.3 * np.ptp(run["F"]) + 1.0 * rng.standard_normal(len(times))
    rows = np.column_stack([times, command["u_in"], command["u_out"], p, force])
    np.savetxt(
        tmp_path / "run.csv",
        rows,
        delimiter=",",
        comments="",
        header="time [s],u_in [A],u_out [A],p [Pa],F [N]",
    )
    (tmp_path / "experiment.toml").write_text(
        'model = "PneumaticMuscle.Benches.Isometric"\n[signals.p]\nsigma = "0.5 kPa"\n[signals.F]\nsigma = "1 N"\n'
        '[[runs]]\nfile = "run.csv"\nrole = "fit"\ninterpolation = "previous"\n'
    )
    compared = pam.compare(pam.read(tmp_path))
    assert [run.start.mode for run in compared.data.runs] == ["rest"]


@pytest.mark.parametrize(
    ("offsets", "mode"),
    [((3.5e3, 3.5e3, 3.5e3), "rest"), ((4e3, 8e3, 15e3), "estimated")],
    ids=["of an instrument", "of each run"],
)
def test_an_offset_of_an_instrument_is_the_same_in_all_runs(
    data: Callable[..., DataSet], offsets: tuple[float, ...], mode: str
) -> None:
    whole = data(0.0)
    runs = [
        replace(run, measurements={**run.measurements, "p": run.measurements["p"] + offset})
        for run, offset in zip(whole.runs, offsets, strict=True)
    ]
    compared = pam.compare(replace(whole, runs=tuple(runs)))
    assert [one.run.start.mode for one in compared.runs] == [mode] * 3


def _one_start(bound: float) -> StartValues:
    """One state that is known to be zero, give or take one."""
    return StartValues(
        Run("run-01", Path("x.csv"), "fit", "linear", {}, np.zeros(2), {}, {}),
        ("s",),
        np.zeros(1),
        np.ones(1),
        np.zeros(1),
        np.array([-bound]),
        np.array([bound]),
    )


def test_a_start_that_lies_far_from_what_is_known_of_it_is_reached() -> None:
    """Held-out runs ended on the way: each step went as far as it was known, and there are eight of them."""
    one = _one_start(1e3)

    def simulate() -> tuple[str, Array, Array]:
        return "run", 100.0 * (one.values - 40.0), np.array([[100.0]])

    eliminate(one, simulate)
    assert one.values == pytest.approx([40.0], rel=1e-3)
