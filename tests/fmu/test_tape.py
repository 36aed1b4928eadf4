"""A model as data gives the numbers of the compiled model to the last bit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from pam_cosim.cache import cache_dir
from pam_cosim.compiler import with_sensitivities
from pam_cosim.compiler.ode import Ode, Statement
from pam_cosim.errors import SimulationFailure
from pam_cosim.fmu import build_source
from pam_cosim.fmu.build import cached_lean_model, cached_taped_model
from pam_cosim.fmu.read import TABLES
from pam_cosim.simulation import Inputs, Simulator
from tests.fmu import models
from tests.library.catalogue import on_bench

TIMES = np.linspace(0.0, 2.0, 81)


Both = Callable[[Ode], tuple[Path, Path]]


@pytest.fixture(autouse=True)
def _without_models(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A cache in which there is no model, but what the compiler keeps for itself."""
    for kind in ("zig", "binaries"):
        (cache_dir() / kind).mkdir(parents=True, exist_ok=True)
        (tmp_path / kind).symlink_to(cache_dir() / kind)
    monkeypatch.setenv("PAM_COSIM_CACHE", str(tmp_path))


@pytest.fixture
def both() -> Both:
    """A model as data and compiled."""

    def made(ode: Ode) -> tuple[Path, Path]:
        taped, compiled = (
            cached_taped_model("key", lambda: ode),
            cached_lean_model("key", lambda: ode),
        )
        assert (taped / TABLES).exists() and not (compiled / TABLES).exists()
        assert (
            cached_taped_model("key", lambda: ode) == compiled
        )  # which is faster, once it is there
        return taped, compiled

    return made


def every_operation() -> Ode:
    """Outputs of a state between -1.3 and 1.3 and of an input."""
    x, v, u = (ca.SX.sym(name) for name in "xvu")
    one = {"x": x, "wide": 40 * x, "positive": x * x + 0.1, "inside": x / 2, "above": x * x + 1.5}
    y = {
        **{f"{f}_{n}": getattr(ca, f)(e) for f in ("sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "asinh", "erf",
                                                 "exp", "floor", "ceil", "fabs", "sign") for n, e in one.items()},
        **{f: getattr(ca, f)(one["positive"]) for f in ("log", "sqrt")},
        **{f: getattr(ca, f)(one["inside"]) for f in ("asin", "acos", "atanh")},
        "acosh": ca.acosh(one["above"]), "pow": one["positive"] ** u, "constpow": one["positive"] ** 1.7,
        "square": x**2, "cube": x**3, "inverse": 1 / one["above"], "half": one["positive"] ** 0.5,
        "add": x + u, "sub": x - u, "mul": x * u, "div": x / (u + 3), "neg": -u, "twice": 2 * x, "const": ca.SX(0.1),
        "lt": x < u, "le": x <= u, "eq": ca.eq(x, u), "ne": ca.ne(x, u), "not": ca.logic_not(u < 0),
        "and": ca.logic_and(x < u, u < 1), "or": ca.logic_or(x < u, u < 0), "fmod": ca.fmod(x, 0.3),
        "copysign": ca.copysign(x, u), "fmin": ca.fmin(x, u), "fmax": ca.fmax(x, u), "atan2": ca.atan2(x, u),
        "choice": ca.if_else(x < u, x, u),
    }  # fmt: skip
    return models.ode(
        "Test.Operations", {"x": (x, v, 1.3), "v": (v, -9 * x, 0.0)}, y, inputs={"u": u}
    )


def warning_lag() -> Ode:
    """Warns, then ends, with numbers in the messages."""
    lag = models.lag()
    [x] = ca.vertsplit(lag.x)
    warning = Statement(x < 0.5, ("x is ", " by now"), ((x, 4),), False)
    return replace(lag, statements=(warning, Statement(x < 0.9, ("it is too much",), (), True)))


@pytest.mark.parametrize(
    "make",
    [every_operation, models.lag, models.delayed_mix, models.van_der_pol, models.forced],
    ids=lambda m: m.__name__,
)
def test_the_numbers_are_the_same(make: Callable[[], Ode], both: Both) -> None:
    ode = make()
    outcomes = []
    for path in both(ode):
        with Simulator(path) as simulator:
            inputs = {n: [-0.5, 1.5, 0.2] for n in simulator.interface.inputs}
            course = Inputs([0.0, 1.0, 2.0], inputs) if inputs else None
            outcomes.append((simulator.run(TIMES, inputs=course).values, simulator.statistics))
    (taped, work), (compiled, same_work) = outcomes
    assert work == same_work and taped.keys() == compiled.keys()
    for name, values in compiled.items():
        assert np.array_equal(taped[name], values), name


def test_sensitivities_are_the_same(both: Both) -> None:
    paths = both(
        with_sensitivities(models.oscillator(), list(models.oscillator().interface.parameters))
    )
    outcomes = []
    for path in paths:
        with Simulator(path) as simulator:
            assert simulator.interface.sensitivities
            outcomes.append(simulator.run(TIMES).values)
    assert all(np.array_equal(outcomes[0][name], outcomes[1][name]) for name in outcomes[1])


def test_assertions_of_the_model_are_reported(both: Both) -> None:
    said = []
    for path in both(warning_lag()):
        with Simulator(path) as simulator:
            with pytest.raises(SimulationFailure) as failed:
                simulator.run(np.linspace(0, 50, 51), inputs=Inputs([0.0, 50.0], {"u": [1.0, 1.0]}))
            said.append(str(failed.value))
    assert said[0] == said[1] and "by now" in said[0] and "too much" in said[0]


@pytest.mark.parametrize("effect", ["LaminarLeak", "GeneralDryFriction", "ValveDelay"])
def test_an_effect_on_its_bench(effect: str) -> None:
    composition, outcomes = on_bench(effect), []
    for brief in (True, False):
        own = composition.parameters[effect]
        path = build_source(
            composition.name, composition.text, sensitivities=own, lean=True, brief=brief
        )
        assert (path / TABLES).exists() == brief
        with Simulator(path) as simulator:
            inputs = Inputs([0.0, 1.0, 2.0], {"u_in": [0.35, 0.3, 0.0], "u_out": [0.0, 0.0, 0.3]})
            outcomes.append(simulator.run(TIMES, inputs=inputs).values)
    assert all(np.array_equal(outcomes[0][name], outcomes[1][name]) for name in outcomes[1])
