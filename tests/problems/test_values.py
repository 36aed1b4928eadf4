"""One order of precedence for values, the same in every function that takes them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError

GAIN = (Path(__file__).parent / "Gain.mo").read_text(encoding="utf-8")
RUNS = ("run-1", "run-2")
TIMES = np.linspace(0.0, 2.0, 41)


def written(
    folder: Path,
    parameters: str = "",
    of_run: str = "",
    fit: str = "tau = {min = 0.05, max = 0.25}",
) -> Path:
    """A data set of two runs, of which the second may state values of its own; the gain was 2."""
    folder.mkdir(exist_ok=True)
    rng = np.random.default_rng(4)
    for name in RUNS:
        y = 2.0 * (1 - np.exp(-TIMES / 0.2)) + 0.01 * rng.standard_normal(len(TIMES))
        rows = [f"{t!r},1,{value!r}" for t, value in zip(TIMES.tolist(), y.tolist(), strict=True)]
        text = "\n".join(["time [s],u,y", *rows, ""])
        (folder / f"{name}.csv").write_text(text, encoding="utf-8")
    (folder / "Gain.mo").write_text(GAIN, encoding="utf-8")
    (folder / "experiment.toml").write_text(
        f'model = "Gain.mo"\n[signals.y]\nsigma = 0.01\n[parameters]\n{parameters}\n[fit]\n{fit}\n'
        f'[[runs]]\nfile = "run-1.csv"\nstart = "rest"\n'
        f'[[runs]]\nfile = "run-2.csv"\nstart = "rest"\n[runs.parameters]\n{of_run}\n',
        encoding="utf-8",
    )
    return folder


def ends(runs: Any) -> list[float]:
    """The last reading of the model in each run: its gain."""
    return [float(run.model["y"][-1]) for run in runs]


def compared(problem: pam.Problem) -> list[float]:
    return ends(pam.compare(problem).runs)


def fitted(problem: pam.Problem) -> list[float]:
    return ends(pam.fit(problem).comparison.runs)


def profiled(problem: pam.Problem) -> list[float]:
    """The gain that every point of a profile has: a profile of tau is lowest where the fit has it."""
    fit = pam.fit(problem)
    profiles = pam.profile(problem, fit)
    assert profiles.profiles
    return ends(fit.comparison.runs)


def checked(problem: pam.Problem) -> list[float]:
    """What a check took for the gain of each run; its simulations are not kept."""
    data = pam.check(problem, workers=0).data
    return [run.parameters.get("k", 1.0) for run in data.runs]


def diagnosed(problem: pam.Problem) -> list[float]:
    return ends(pam.diagnose(problem, workers=0, explain=False).base.comparison.runs)


def predicted(problem: pam.Problem) -> list[float]:
    fit = pam.fit(problem)
    bands = [pam.predict(fit, run=name, samples=4, files=problem.files) for name in RUNS]
    return [float(one.bands["y"].value[-1]) for one in bands]


FUNCTIONS: Mapping[str, Callable[[pam.Problem], list[float]]] = {
    "compare": compared,
    "fit": fitted,
    "profile": profiled,
    "check": checked,
    "diagnose": diagnosed,
    "predict": predicted,
}
# What the data set states of all runs and of the second, what is stated beside it, and the gain of each run.
SOURCES: Mapping[str, tuple[str, str, dict[str, Any], tuple[float, float]]] = {
    "default": ("", "", {}, (1, 1)),
    "earlier fit": ("", "", {"fitted": {"k": 3}}, (3, 3)),
    "data set": ("k = 4", "", {"fitted": {"k": 3}}, (4, 4)),
    "run": ("k = 4", "k = 5", {"fitted": {"k": 3}}, (4, 5)),
    "caller": ("k = 4", "k = 5", {"fitted": {"k": 3}, "values": {"k": 6}}, (6, 6)),
    "caller of a run": ("k = 4", "k = 5", {"values": {"k@run-2": 7}}, (4, 7)),
    "caller of both": ("k = 4", "", {"values": {"k@run-1": 7, "k": "6"}}, (7, 6)),
    "ratio": ("k = 4", "k = 5", {"values": {"k/stated": 0.5}}, (2, 2.5)),
    "ratio of a run": ("k = 4", "k = 5", {"values": {"k/stated@run-2": 2}}, (4, 10)),
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "rig"


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("source", SOURCES)
def test_every_function_uses_the_value_that_counts(
    folder: Path, function: str, source: str
) -> None:
    shared, of_run, stated, gains = SOURCES[source]
    problem = pam.problem(pam.read(written(folder, shared, of_run)), **stated)
    assert FUNCTIONS[function](problem) == pytest.approx(gains, rel=1e-3)


@pytest.mark.parametrize("function", [pam.compare, pam.fit, pam.diagnose, pam.check])
def test_short_forms_take_the_same_values(folder: Path, function: Any) -> None:
    data = pam.read(written(folder, "k = 4"))
    product = function(data, parameters={"k@run-2": 7})
    found = product.comparison.data if isinstance(product, pam.study.fits.Fit) else product.data
    assert [run.parameters["k"] for run in found.runs] == [4, 7]
    with pytest.raises(InputError, match="state them in pam.problem"):
        function(pam.problem(data), parameters={"k": 7})


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("kk", "no parameter or input 'kk'; did you mean 'k'"),
        ("k@run-9", "has no run 'run-9'; did you mean 'run-"),
        ("y", "is an output"),
    ],
)
def test_every_function_refuses_an_unknown_name_alike(
    folder: Path, function: str, name: str, text: str
) -> None:
    data = pam.read(written(folder))
    for stated in ({"values": {name: 1}}, {"start": {name: 1}}, {"free": [name]}):
        with pytest.raises(InputError, match=text):
            FUNCTIONS[function](pam.problem(data, **stated))


def test_a_stated_parameter_that_is_freed_is_fitted_from_where_it_was_stated(folder: Path) -> None:
    data = pam.read(written(folder, "k = 1.5"))
    fit = pam.fit(data, free=["k", "tau"])
    assert fit.parameters["k"].value == pytest.approx(2, abs=0.01)
    assert fit.parameters["tau"].value == pytest.approx(0.2, rel=0.05)


@pytest.mark.parametrize("name", ["k/stated", "k@run-1"])
def test_the_advice_for_runs_that_state_several_values_works(folder: Path, name: str) -> None:
    data = pam.read(written(folder, "k = 1.5", "k = 1.6"))
    with pytest.raises(InputError, match=rf"--free '{name}'"):
        pam.fit(data, free=["k"])
    assert pam.fit(data, free=[name]).parameters[name].determined


def test_a_stated_initial_state_is_where_a_run_begins(folder: Path) -> None:
    data = pam.read(written(folder, "k = 4"))
    first = [run.model["y"][0] for run in pam.compare(data, parameters={"s@run-2": 3}).runs]
    assert first == pytest.approx([0, 3])
    assert pam.fit(data, parameters={"s": 1}).comparison.runs[1].model["y"][0] == pytest.approx(1)


def test_the_table_says_where_each_value_comes_from(folder: Path) -> None:
    data = pam.read(written(folder, "k = 4", "k = 5"))
    problem = pam.problem(data, values={"k@run-2": 6, "b": 0.5})
    sources = {(row.name, row.value): row.source for row in problem.values}
    assert sources == {
        ("k", 4): "stated by the data set for run-1",
        ("k", 6): "stated by the caller, in place of 5 of run-2",
        ("b", 0.5): "stated by the caller",
        ("tau", 0.1): "fitted from here",
    }
    assert "tau  0.1  fitted from here, between 0.05 and 0.25" in str(problem)
    assert "k      6  stated by the caller, in place of 5 of run-2" in str(problem)


def test_a_model_states_values_before_those_that_a_fit_would_begin_at(folder: Path) -> None:
    free = "tau = {min = 0.05, max = 0.25, start = 0.15}"
    data = pam.read(written(folder, "k = 4", fit=free))
    pam.add(pam.fit(data), output=folder / "Better.mo")
    better = pam.problem(data, str(folder / "Better.mo"))
    rows = {row.name: row.source for row in better.values}
    assert better.free[0].start == pytest.approx(pam.fit(data).values["tau"])
    assert rows["k"] == "stated by the data set"


def better(folder: Path, data: Any, **stated: Any) -> tuple[Any, str]:
    fit = pam.fit(data, **stated)
    pam.add(fit, output=folder / "Better.mo")
    return fit, str(folder / "Better.mo")


@pytest.mark.parametrize(
    "stated",
    [
        {"free": ["k", "tau"]},
        {"free": ["k/stated"]},
        {"parameters": {"k@run-2": 2.5, "u@run-1": 1.5}},
        {"parameters": {"k": 2.5, "b": 0.1}},
        {"parameters": {"s@run-1": 0.4}},
    ],
)
def test_the_loop_closes_for_values_in_place_of_stated_ones(
    folder: Path, stated: dict[str, Any]
) -> None:
    data = pam.read(written(folder, "k = 1.5"))
    fit, model = better(folder, data, **stated)
    assert fit.comparison.scores["all"] != pam.compare(data).scores["all"]
    assert pam.compare(data, model).scores["all"] == fit.comparison.scores["all"]


def test_what_is_stated_afterwards_overrules_a_verdict_and_one_line_says_so(folder: Path) -> None:
    data = pam.read(written(folder, "k = 1.5"))
    _, model = better(folder, data, free=["k", "tau"])
    changed = pam.problem(pam.read(written(folder, "k = 3")), model)
    assert [run.parameters["k"] for run in changed.data.runs] == [3, 3]
    notes = {note for run in changed.data.runs for note in run.notes}
    assert len(notes) == 1
    assert "the data set states k = 3, and it stated 1.5 when the verdict in Better.mo" in str(
        notes
    )
    stated = pam.problem(data, model, values={"k": 4})
    assert [run.parameters["k"] for run in stated.data.runs] == [4, 4]


@pytest.mark.parametrize(
    ("stated", "text"),
    [
        ({"start": {"tau": 3}}, "between 0.05 and 0.25, and its initial guess 3 lies outside"),
        ({"free": ["b/stated"]}, "factor on the value that run-1 states, and it states none"),
        ({"free": ["k@run-2"]}, "held out and never fitted: state its value by --set"),
        ({"free": ["u"]}, "'u' is no parameter of Gain and cannot be fitted"),
    ],
)
def test_what_cannot_be_fitted_is_refused_with_the_reason(
    folder: Path, stated: dict[str, Any], text: str
) -> None:
    data = pam.read(written(folder, "k = 2"), roles={"run-2": "holdout"})
    with pytest.raises(InputError, match=text):
        pam.problem(data, **stated)


def test_a_parameter_that_every_fitted_run_is_given_is_not_fitted(folder: Path) -> None:
    free = "k = {min = 1, max = 3}\ntau = {min = 0.05, max = 0.25}"
    data = pam.read(written(folder, fit=free))
    assert list(pam.fit(data, parameters={"k@run-1": 2, "k@run-2": 2}).parameters) == ["tau"]
    with pytest.raises(InputError, match="the caller states k, tau; leave a free parameter out"):
        pam.fit(data, parameters={"k": 2, "tau": 0.2})
    assert pam.fit(data, parameters={"k": 2}).parameters


def test_a_factor_and_a_value_exclude_each_other_and_a_factor_keeps_to_the_range(
    folder: Path,
) -> None:
    data = pam.read(written(folder, "k = 4"))
    with pytest.raises(InputError, match="state one of the two"):
        pam.compare(data, parameters={"k": 3, "k/stated": 1.1})
    with pytest.raises(InputError, match="must be between 0"):
        pam.compare(data, parameters={"k/stated": -1})


def test_an_initial_state_of_one_run_leaves_the_others_as_they_begin(folder: Path) -> None:
    file = written(folder, "k = 2").joinpath("experiment.toml")
    file.write_text(file.read_text().replace('start = "rest"\n', ""))
    data = pam.read(folder)
    fit, model = better(folder, data, parameters={"s@run-1": 0.4})
    assert pam.compare(data, model).scores["all"] == fit.comparison.scores["all"]
