"""Diagnoses made by hand: analytic curves, known errors, no simulation."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.comparison import (
    Comparison,
    Rule,
    RunComparison,
    residual_statistics,
    score,
    series_of,
)
from pam_cosim.diagnosis import (
    Candidate,
    Diagnosis,
    FailedTrial,
    LeftInSignal,
    MissingTerm,
    NextExperiment,
    Verdict,
)
from pam_cosim.fitting import Estimate, Fit
from pam_cosim.measurement import DataSet, Run, Signal

SIGNALS = {
    "p": Signal("p", "Pa", 500.0),
    "x": Signal("x", "m", 0.2e-3),
    "T": Signal("T", "K", 0.3, estimated=True),
}
RULES = (
    Rule("x", "filling, 40 kPa < p < 120 kPa", 0.71, 0.22),
    Rule("p", "run run-1, early", 0.43, 0.11),
)
EQUATIONS = 'model M "a <b> & c"\n  extends PneumaticMuscle.Benches.Isotonic;\nend M;\n'


def truth(time, i):
    swing = np.sin(time / 2 + i) ** 2
    return {"p": 2e5 * swing, "x": 0.05 * swing, "T": 293 + 20 * swing}


def make_run(i, role, samples=200, leave_out=(), seed=0):
    rng = np.random.default_rng([seed, i])
    time = np.linspace(0, 10, samples)
    values = truth(time, i)
    measured = {
        n: v + SIGNALS[n].sigma * rng.standard_normal(samples)
        for n, v in values.items()
        if n not in leave_out
    }
    return Run(
        f"run-{i}", Path(f"run-{i}.csv"), role, "linear", {"load.m": 2.0}, time, {}, measured
    )


def make_data(roles=("fit", "fit", "holdout"), samples=200, title="a rig", **options):
    runs = tuple(make_run(i + 1, role, samples, **options) for i, role in enumerate(roles))
    names = [n for n in SIGNALS if any(n in r.measurements for r in runs)]
    return DataSet(Path("/somewhere/rig"), title, "PneumaticMuscle.Benches.Isotonic", {n: SIGNALS[n] for n in names},
                   {}, {}, runs)  # fmt: skip


def make_comparison(data, error, model="PneumaticMuscle.Benches.Isotonic"):
    """A model that is off by ``error`` noise standard deviations, in a slow wave."""
    runs = []
    for i, run in enumerate(data.runs):
        wave = error * np.cos(run.time)
        runs.append(
            RunComparison(
                run, {n: v + wave * SIGNALS[n].sigma for n, v in truth(run.time, i + 1).items()}
            )
        )
    scores = {
        role: score([r for r in runs if r.run.role == role], data.signals)
        for role in ("fit", "holdout")
    }
    scores["all"] = score(runs, data.signals)
    return Comparison(model, data, {"valve.C_A": 0.7}, tuple(runs), scores, RULES if error else ())


def make_fit(data, error, parameters=None):
    comparison = make_comparison(data, error)
    by_role = {
        role: residual_statistics(
            series_of([r for r in comparison.runs if r.run.role == role], data.signals)
        )
        for role in ("fit", "holdout")
    }
    estimates = (
        {"valve.C_A": Estimate(0.712, 0.701, 0.723, "1")} if parameters is None else parameters
    )
    return Fit("M", estimates, comparison, by_role, 12, ("step size too small at t = 3 s",))


def make_candidate(data, effect, family, balance, error, own=None, before=(), **fields):
    own = own or {}
    fit = make_fit(data, error, {"valve.C_A": Estimate(0.699, 0.695, 0.703, "1"), **own})
    return Candidate(
        effect, family, balance, (*before, effect), tuple(own), fit, equations=EQUATIONS, **fields
    )


def make_diagnosis(kind="identified", data=None, **changes):
    """One diagnosis of each kind, all with the same candidates."""
    data = data or make_data()
    stiff = {
        "bladder.k": Estimate(812.0, 804.0, 820.0, "N/m"),
        "bladder.L_free": Estimate(0.2, 0.1, 0.3, "m", at_bound=True, determined=False),
        "film.h": Estimate(7.6, 7.1, 8.1, "W/(m2.K)"),
        "film.d": Estimate(0.5, 0.5, 0.5, "m", at_bound=True),
    }
    best = make_candidate(
        data, "StiffWall", "elasticity", "force", 0.0, stiff, delta_bic=-5200.4, probability=0.98
    )
    rival = make_candidate(
        data, "RoundEnds", "end_shape", "force", 0.1, delta_bic=-5199.0, probability=0.02
    )
    poor = make_candidate(data, "SmallHole", "leak", "mass", 8.0, delta_bic=float("nan"))
    failed = FailedTrial(
        "HotWall", "wall_heat", "energy", ("HotWall",), "no start value <can> be simulated"
    )
    base = make_fit(data, 10.0)
    candidates = (best, rival, poor)
    balance = {"energy": 0.0, "force": 0.93, "mass": 0.07}
    by_kind = {
        "none_missing": Diagnosis(
            data, data.model, make_fit(data, 0.0), (poor,), (), dict.fromkeys(balance, 0.0),
            Verdict("none_missing"),
        ),
        "identified": Diagnosis(
            data, data.model, base, candidates, (best,), balance,
            Verdict("identified", ("elasticity",), ("StiffWall",)),
        ),
        "ambiguous": Diagnosis(
            data, data.model, base, candidates, (best,), balance,
            Verdict("ambiguous", ("elasticity", "end_shape"), ("StiffWall", "RoundEnds")),
            next_experiment=NextExperiment("run-2", "p_supply times 1.5", 12.34, 152.3, ("elasticity", "end_shape"), {},
                                           "linear", {"time": [0.0, 10.0]}, {}),
        ),
        "unknown": Diagnosis(
            data, data.model, base, (poor,), (), balance,
            Verdict("unknown"),
            missing_term=MissingTerm(
                "force", {n: LeftInSignal(10 * SIGNALS[n].sigma, 7.07, "p", -0.61) for n in data.signals}, RULES
            ),
        ),
    }  # fmt: skip
    return replace(by_kind[kind], **{"failed": (failed,)} | changes)
