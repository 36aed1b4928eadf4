"""Priors, transformed parameters, and parameters of one run alone: from the file to the estimate."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim import InputError
from pam_cosim.fitting import Free, read_parameters, write_parameters
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_model
from pam_cosim.measurement import Prior
from pam_cosim.simulation import Simulator
from tests.fitting.models import TRUE_C_D, N, discharge, vessel_data

HEAD = """title = "two vessels"
model = "PneumaticMuscle.Benches.VesselOrifice"
[signals.p]
sigma = "1 kPa"
[parameters]
"tank.V" = "16.2 l"
"tank.p_start" = "690 kPa"
"tank.T_start" = "293.15 K"
"orifice.d" = "2.71 mm"
[fit]
{fit}
"""
RUN = '[[runs]]\nfile = "{name}.csv"\n'


def write(
    folder: Path, fit: str, runs: dict[str, str], c_d: dict[str, float] | None = None
) -> Path:
    """A data set of the independent vessel; each run with its own discharge coefficient, and further lines."""
    folder.mkdir(exist_ok=True)
    text = HEAD.format(fit=fit)
    for k, (name, lines) in enumerate(runs.items()):
        p = discharge((c_d or {}).get(name, TRUE_C_D))[0] + 1e3 * np.random.default_rng(
            [k, 5]
        ).standard_normal(61)
        rows = [f"{t},{value / 1e3:.5f}" for t, value in enumerate(p)]
        (folder / f"{name}.csv").write_text("\n".join(["time [s],p [kPa]", *rows, ""]))
        text += RUN.format(name=name) + lines + "\n"
    (folder / "experiment.toml").write_text(text)
    return folder


BOTH = '"orifice.C_d" = { min = 0.5, max = 1.1 }\n"tank.n" = { min = 1.0, max = 1.4 }'


def test_prior_adds_to_the_chi_square_as_one_more_measurement() -> None:
    """A tight prior holds, a wide one does nothing, and one as exact as the data comes to the weighted mean."""
    data = vessel_data(fit=(replace(N, prior=None),))
    free = pam.fit(data).parameters["tank.n"]
    sd = (free.high - free.low) / 3.92
    far = free.value - 4 * sd
    between = pam.fit(replace(data, fit={"tank.n": replace(N, prior=Prior(far, sd))}))
    estimate = between.parameters["tank.n"]
    assert estimate.value == pytest.approx(free.value - 2 * sd, abs=0.1 * sd)
    assert estimate.surprise == pytest.approx(2, abs=0.1) and between.chi2_priors == pytest.approx(
        4, abs=0.4
    )
    assert (estimate.high - estimate.low) / 3.92 == pytest.approx(sd / np.sqrt(2), rel=0.1)
    assert "sd from the prior" in str(between)
    assert between.as_dict()["chi2_priors"] == between.chi2_priors
    wide = pam.fit(
        replace(data, fit={"tank.n": replace(N, prior=Prior(far, 1e3 * sd))})
    ).parameters["tank.n"]
    assert wide.value == pytest.approx(free.value, abs=1e-3 * sd)


def test_prior_of_the_logarithm_is_as_steep_as_the_fit_takes_it_for() -> None:
    """The rows of a prior against differences, in either search coordinate."""
    data, off = vessel_data(fit=(replace(N, prior=None),)), Prior(1.1, 0.05, logarithmic=True)
    for transform in ("log", "linear"):
        free = Free("tank.n", 1.0, 1.4, 1.2, "1", transform=transform, prior=off)  # type: ignore[arg-type]
        with Simulator(build_model(data.model, sensitivities=["tank.n"])) as simulator:
            objective = Objective(simulator, data, data.fit_runs, [free])
            z, step = np.array([free.to_z(1.25)]), 1e-6
            here, there = (objective.residuals(at)[-1] for at in (z, z + step))
            assert objective.jacobian(z, objective.residuals(z))[-1, 0] == pytest.approx(
                (there - here) / step, rel=1e-4
            )
        assert here == pytest.approx(-np.log(1.25 / 1.1) / 0.05)


def test_run_has_a_parameter_of_its_own(tmp_path: Path) -> None:
    own = '[runs.fit]\n"orifice.C_d" = { min = 0.4, max = 1.1, transform = "log" }'
    truth = {"a": 0.84, "b": 0.6, "c": 0.84}
    folder = write(tmp_path / "rig", BOTH, {"a": "", "b": own, "c": 'role = "holdout"'}, truth)
    data = pam.read(folder)
    assert set(data.fit) == {"orifice.C_d", "tank.n", "orifice.C_d@b"}
    fit = pam.fit(data)
    assert fit.values["orifice.C_d"] == pytest.approx(0.84, abs=0.01)
    assert fit.values["orifice.C_d@b"] == pytest.approx(0.6, abs=0.01)
    assert fit.residuals["holdout"].chi2_reduced < 1.5
    plain = json.loads(json.dumps(fit.as_dict()))["parameters"]
    assert plain["orifice.C_d@b"]["run"] == "b" and "run" not in plain["orifice.C_d"]
    write_parameters(tmp_path / "p.json", fit)
    values = read_parameters(tmp_path / "p.json")
    assert values == fit.values
    again = pam.compare(data, parameters=values)
    assert again.scores["all"]["p"].rmse == pytest.approx(
        fit.comparison.scores["all"]["p"].rmse, rel=1e-4
    )
    with pytest.raises(InputError, match="no run 'd'"):
        pam.compare(data, parameters={"orifice.C_d@d": 0.6})


HELD = 'role = "holdout"\n[runs.fit]\n"tank.n" = { min = 1.0, max = 1.4 }'
TWICE = '[runs.parameters]\n"tank.n" = 1.2\n[runs.fit]\n"tank.n" = { min = 1.0, max = 1.4 }'
BAD = [
    (
        '"tank.n" = { min = 0, max = 1.4, transform = "log" }',
        "",
        "a logarithm needs bounds above zero|outside",
    ),
    (
        '"orifice.d" = { min = "0 mm", max = "3 mm", transform = "log" }',
        "",
        "above zero|outside the model's range",
    ),
    (
        '"tank.n" = { min = 1.0, max = 1.4, transform = "square" }',
        "",
        "'square' is not possible; write 'log' or 'linear'",
    ),
    (
        '"tank.n" = { min = 1.0, max = 1.4, prior = { mean = 1.2 } }',
        "",
        "'sd' is missing: write prior = ",
    ),
    (
        '"tank.n" = { min = 1.0, max = 1.4, prior = { mean = 1.2, sd = 0 } }',
        "",
        "sd of the prior of tank.n must be greater",
    ),
    (
        '"tank.n" = { min = 1.0, max = 1.4, prior = { mean = 1.2, sd = "1 kg" } }',
        "",
        "sd of the prior of tank.n",
    ),
    (
        '"tank.n" = { min = 1.0, max = 1.4, prior = { mean = 1.2, sb = 1 } }',
        "",
        "unknown key 'sb'; Known: mean, sd",
    ),
    (BOTH, TWICE, "free under .runs.fit. and has a value under .runs.parameters."),
    (
        BOTH,
        '[runs.fit]\n"tank.m" = { min = 1.0, max = 1.4 }',
        "no parameter 'tank.m'; did you mean",
    ),
]


@pytest.mark.parametrize(("fit", "lines", "message"), BAD)
def test_what_cannot_be_is_one_message_with_its_line(
    fit: str, lines: str, message: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=message) as caught:
        pam.read(write(tmp_path / "rig", fit, {"a": lines}))
    assert caught.value.line is not None


def test_holdout_run_has_nothing_of_its_own_to_fit(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="free in a run that is never fitted"):
        pam.read(write(tmp_path / "rig", BOTH, {"a": "", "b": HELD}))
