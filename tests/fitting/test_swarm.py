"""The particle swarm of Dzahir and Yamamoto (2019), Table 1, by itself and as a method of fitting."""

from __future__ import annotations

import json

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.files import plain
from pam_cosim.fitting.free import base_parameters
from pam_cosim.fitting.methods.particle_swarm import (
    swarm,
)
from pam_cosim.fitting.objective import Objective
from pam_cosim.simulation import Simulator
from tests.fitting.models import TRUE_C_D, TRUE_N, vessel_data

LOW, HIGH = np.array([-2.0, -1.0, 0.0]), np.array([2.0, 3.0, 5.0])


def rosenbrock(z: np.ndarray) -> float:
    return float(((1 - z[:-1]) ** 2 + 100 * (z[1:] - z[:-1] ** 2) ** 2).sum())


def one_by_one(cost, particles: int, generations: int, seed: int):  # type: ignore[no-untyped-def]
    """The same rule, one particle after the other, with the same random numbers."""
    random = np.random.default_rng(seed)
    shape = (particles, len(LOW))
    at = [LOW + u * (HIGH - LOW) for u in random.random(shape)]
    speed = [(u - 0.5) * (HIGH - LOW) for u in random.random(shape)]
    own = [(cost(z), z) for z in at]
    lowest = [min(c for c, _ in own)]
    for _ in range(generations):
        best = min(own, key=lambda pair: pair[0])[1]
        towards_own, towards_best = random.random(shape), random.random(shape)
        for i in range(particles):
            speed[i] = 0.73 * speed[i] + 1.5 * towards_own[i] * (own[i][1] - at[i])
            speed[i] = speed[i] + 1.5 * towards_best[i] * (best - at[i])
            at[i] = np.minimum(np.maximum(at[i] + speed[i], LOW), HIGH)
            if (here := cost(at[i])) < own[i][0]:
                own[i] = (here, at[i])
        lowest.append(min(c for c, _ in own))
    return min(own, key=lambda pair: pair[0])[1], lowest


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_swarm_agrees_with_a_second_implementation(seed: int) -> None:
    seen = swarm(rosenbrock, LOW, HIGH, seed=seed)
    best, lowest = one_by_one(rosenbrock, 50, 10, seed)
    assert seen.best == pytest.approx(best)
    assert seen.costs == pytest.approx(lowest)


def test_fit_tells_what_the_swarm_did_and_what_the_descent_made_of_it() -> None:
    data = vessel_data()
    result = study.fit(data, method="particle-swarm")
    assert result.search is not None
    own = result.search
    assert own.generations == 10 and own.evaluations == 550 and len(own.chi2_reduced) == 11
    with Simulator(study.build("VesselOrifice")) as simulator:
        free = base_parameters(data, simulator.interface)
        objective = Objective(simulator, data, data.fit_runs, free, tolerance=1e-6)
        there = (
            objective.cost(np.array([f.to_z(own.parameters[f.name]) for f in free]))
            / objective.size
        )
    assert there == pytest.approx(own.chi2_reduced[-1], rel=1e-4)
    assert result.residuals["fit"].chi2_reduced <= own.chi2_reduced[-1]
    assert result.values != own.parameters
    assert result.values == pytest.approx({"orifice.C_d": TRUE_C_D, "tank.n": TRUE_N}, rel=0.02)
    plain = json.loads(json.dumps(result.as_dict()))
    assert plain["search"]["chi2_by_generation"] == list(own.chi2_reduced)
    assert plain["search"]["best_point"]["orifice.C_d"] == {
        "value": own.parameters["orifice.C_d"],
        "unit": "1",
    }
    assert plain["chi2_reduced"] <= plain["search"]["chi2_reduced"]
    text = str(result)
    for part in (
        "swarm of 50 particles: chi2",
        "in 10 generations",
        "its own best point",
        "the descent from the best start",
    ):
        assert part in text
    assert study.fit(data).search is None


PRODUCT = """model Product "Decay at the product of two rates, which no measurement of it can tell apart"
  input Real w(start=1);
  output Real y(unit="1");
  parameter Real a(unit="s", min=0.01, max=10) = 0.5 "First";
  parameter Real b(unit="s", min=0.01, max=10) = 0.5 "Second";
  parameter Real c(unit="1/s", min=0.01, max=10) = 1 "Known by itself";
  Real s(unit="1", start=1, fixed=true);
equation
  der(s) = -{law}*s + c*(w - s);
  y = s;
end Product;"""


def confounded(law: str, tmp_path, seed: int = 0):  # type: ignore[no-untyped-def]
    """Fit of a, b and c to y(t) of c = 0.7/s and a loss of 0.3/s, by the exact solution, with noise."""
    (tmp_path / "Product.mo").write_text(PRODUCT.format(law=law))
    t = np.linspace(0, 6, 121)
    y = (0.7 + 0.3 * np.exp(-t)) + 2e-3 * np.random.default_rng(seed).standard_normal(len(t))
    rows = [f"{time:.3f},1,{value:.6f}" for time, value in zip(t, y, strict=True)]
    (tmp_path / "one.csv").write_text("\n".join(["time [s],w,y", *rows, ""]))
    (tmp_path / "experiment.toml").write_text(
        'title = "a product"\nmodel = "Product"\n[signals.y]\nsigma = "0.002"\n[fit]\n'
        'a = { min = "0.01 s", max = "10 s", start = "0.9 s" }\nb = { min = "0.01 s", max = "10 s" }\n'
        'c = { min = "0.01 1/s", max = "10 1/s" }\n[[runs]]\nfile = "one.csv"\nrole = "fit"\n'
    )
    model = str(tmp_path / "Product.mo")
    return study.fit(study.read(tmp_path, model=model), model)


@pytest.mark.parametrize(("law", "kind"), [("a*b", "product"), ("a/b", "ratio")])
def test_only_the_product_or_ratio_is_claimed_where_only_that_is_known(
    law: str, kind: str, tmp_path
) -> None:  # type: ignore[no-untyped-def]
    result = confounded(law, tmp_path)
    assert not result.parameters["a"].determined and not result.parameters["b"].determined
    assert result.parameters["c"].determined
    (pair,) = result.combinations
    assert (pair.names, pair.kind) == (("a", "b"), kind)
    assert pair.low < 0.3 < pair.high and pair.high - pair.low < 0.03
    assert pair.unit == ("s2" if kind == "product" else "1")
    assert f"only the {kind} is determined" in str(result)
    assert result.as_dict()["combinations"] == [plain(pair)]
