"""Least squares weighted by the noise, bounded, from several starts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import cast

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import (
    Comparison,
    ResidualStatistics,
    compare,
    noise_log_likelihood,
    residual_statistics,
    series_of,
)
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import InputError
from pam_cosim.exports import Columns, Tabular
from pam_cosim.fitting.combinations import Combination, combinations
from pam_cosim.fitting.estimate import Estimate, describe, estimates
from pam_cosim.fitting.free import Free, base_parameters
from pam_cosim.fitting.holdout_uncertainty import HoldoutUncertainty, estimate_holdout_uncertainty
from pam_cosim.fitting.linear import Linear, judged_by, linearised
from pam_cosim.fitting.methods import METHODS, GlobalSearch
from pam_cosim.fitting.objective import Objective
from pam_cosim.fitting.options import FitOptions
from pam_cosim.fitting.profile import Profiles, correlations, profiles
from pam_cosim.fitting.resume import LoggedSimulator
from pam_cosim.fitting.solve import FitProblem
from pam_cosim.fitting.start_estimates import estimated_starts, start_estimates
from pam_cosim.fitting.tracker import Convergence, Progress, Tracker
from pam_cosim.measurement import ROLES, DataSet
from pam_cosim.simulation import AnySimulator
from pam_cosim.wording import Printed

STRONG_CORRELATION = 0.95  # absolute correlation of two estimates that is named


@dataclass(frozen=True)
class Fit(Printed, Tabular):
    """A model with its free parameters fitted to the fit runs of a data set.

    Attributes:
        model: name of the model.
        parameters: estimates by name.
        comparison: the fitted model against all runs.
        residuals: what the residuals are like, per role ("fit", "holdout").
        evaluations: simulations of the set of fit runs that it took.
        failures: breakdowns of the simulation on the way, in the words of the solver.
        combinations: pairs of parameters of which only the product or the ratio is determined.
        method: how it was fitted.
        search: over all of the bounds, before the descents, where the method makes one.
        convergence: how the chi-square came down.
        correlation: (k, k) matrix of the estimates, in the order of ``parameters``; empty: not known.
        linear: the model about the optimum, where the options ask for it.
        holdout_uncertainty: of the held-out runs, where the options ask for it.
        starts: start values that were estimated, as "state@run".
    """

    json_keys = (
        "model parameters chi2_priors evaluations failures combinations method search correlation "
        "convergence starts? chi2_reduced=residuals.fit.chi2_reduced comparison"
    )

    model: str
    parameters: dict[str, Estimate]
    comparison: Comparison
    residuals: dict[str, ResidualStatistics]
    evaluations: int
    failures: tuple[str, ...] = ()
    combinations: tuple[Combination, ...] = ()
    method: str = "least-squares"
    search: GlobalSearch | None = None
    convergence: Convergence = field(default_factory=Convergence)
    correlation: Array = field(default_factory=lambda: np.zeros((0, 0)))
    linear: Linear | None = None
    holdout_uncertainty: HoldoutUncertainty = field(default_factory=HoldoutUncertainty)
    starts: dict[str, Estimate] = field(default_factory=dict)

    @cached_property
    def residuals_beyond_uncertainty(self) -> dict[str, ResidualStatistics]:
        """``residuals``, those of held-out runs but for what the parameters' uncertainty explains of them."""
        if not self.holdout_uncertainty.shifts:
            return self.residuals
        held = statistics_of(self.comparison, "holdout", self.holdout_uncertainty.shifts)
        held = replace(held, chi2=held.chi2 + self.holdout_uncertainty.cost)
        return {**self.residuals, "holdout": held}

    def without_linear(self) -> Fit:
        """The same fit without the linear model; statistics of the residuals that were computed are kept."""
        bare = replace(self, linear=None)
        for name in ("residuals_beyond_uncertainty", "_noise_deviances"):
            if name in vars(self):
                vars(bare)[name] = vars(self)[name]
        return bare

    @property
    def values(self) -> dict[str, float]:
        """Fitted parameters [SI] by name."""
        return {name: e.value for name, e in self.parameters.items()}

    @property
    def start_values(self) -> dict[str, float]:
        """Start values that were estimated [SI], by "state@run"."""
        return {name: e.value for name, e in self.starts.items()}

    @property
    def values_and_starts(self) -> dict[str, float]:
        """``values`` and ``start_values`` [SI]."""
        return {**self.values, **self.start_values}

    def coloured_deviance(self, largest: float) -> float:
        """Minus twice the log-likelihood of what is left as noise of any colour, and what the priors add.

        Of held-out runs beyond the uncertainty of the parameters.

        Args:
            largest: mean square that noise may have at most, in noise variances.
        """
        if largest not in self._noise_deviances:
            comparison, held = self.comparison, self.holdout_uncertainty
            series = series_of(comparison.runs, comparison.data.signals, held.shifts)
            self._noise_deviances[largest] = held.cost - 2 * noise_log_likelihood(series, largest)
        return self.chi2_priors + self._noise_deviances[largest]

    @cached_property
    def _noise_deviances(self) -> dict[float, float]:
        """By what noise may be at most."""
        return {}

    @cached_property
    def freedom(self) -> int:
        """Number of parameters that the data determine, start values of the fitted runs among them."""
        fitted = {run.run.name for run in self.comparison.runs if run.run.role == "fit"}
        starts = sum(e.determined for e in self.starts.values() if e.run in fitted)
        return starts + sum(e.determined for e in self.parameters.values())

    @cached_property
    def chi2_priors(self) -> float:
        """What the priors add to the chi-square that was made small."""
        return sum(e.surprise**2 for e in self.parameters.values() if e.prior is not None)

    @property
    def chi2_minimised(self) -> float:
        """The chi-square that was made small: of the fitted samples and of the priors."""
        return self.residuals["fit"].chi2 + self.chi2_priors

    def against(self, data: DataSet) -> Fit:
        """The same parameters judged by other samples: ``data`` has the same runs, some of their samples set aside."""
        comparison = self.comparison.against(data)
        linear = self.linear and judged_by(self.linear, comparison.runs, data, CRITERIA.search.rows)
        return replace(
            self, comparison=comparison, residuals=statistics_by_role(comparison), linear=linear
        )

    def frame_columns(self) -> Columns:
        """A row for each parameter: its value and 95 % interval in the SI unit of the column "unit"."""
        estimates = self.parameters.values()
        return {
            "parameter": (list(self.parameters), None),
            "unit": ([estimate.unit for estimate in estimates], None),
            "value": ([estimate.value for estimate in estimates], None),
            "low": ([estimate.low for estimate in estimates], None),
            "high": ([estimate.high for estimate in estimates], None),
            "determined": ([estimate.determined for estimate in estimates], None),
        }

    def confused(self) -> tuple[str, ...]:
        """A sentence for each pair of parameters that these data hardly separate."""
        names = list(self.parameters)
        stated = {frozenset(c.names) for c in self.combinations}
        sentences = []
        for i, j in zip(*np.triu_indices(len(self.correlation), 1), strict=True):
            r = self.correlation[i, j]
            if abs(r) > STRONG_CORRELATION and frozenset((names[i], names[j])) not in stated:
                way = "raised together" if r > 0 else "one raised and the other lowered"
                sentences.append(
                    f"{names[i]} and {names[j]} can hardly be separated: "
                    f"{way}, they fit equally well (correlation {r:+.3f})"
                )
        return tuple(sentences)

    def _headline(self) -> str:
        chi2 = [
            f"{role} {statistics.chi2_reduced:.4g}" for role, statistics in self.residuals.items()
        ]
        return f" of {self.model} to '{self.comparison.data.title}': reduced chi-square {', '.join(chi2)}"

    def __str__(self) -> str:
        lines = [str(self.comparison)]
        if self.search:
            reached = self.residuals["fit"].chi2_reduced
            lines += [
                str(self.search),
                f"  the descent from the best start reaches chi2 {reached:.4g}:",
            ]
        sentences_of_pairs = [f"  {c}" for c in (*self.combinations, *self.confused())]
        return "\n".join([*lines, describe(self.parameters), *sentences_of_pairs])


def fit(
    simulator: AnySimulator,
    data: DataSet,
    free: Sequence[Free] | None = None,
    *,
    fixed: Mapping[str, float] | None = None,
    starts: Sequence[Mapping[str, float]] = (),
    options: FitOptions | None = None,
    progress: Progress | None = None,
    resume: Path | None = None,
) -> Fit:
    """Fits ``free`` (default: what the data set declares under [fit]) to the fit runs.

    Args:
        simulator: the model.
        data: the measurement; every signal needs a noise level.
        free: parameters to move.
        fixed: further parameter values [SI].
        starts: further points to start from, by name [SI].
        options: how the fit goes.
        progress: called after each simulation with the ``FitProgress``: ``print`` will do.
        resume: a file that keeps every simulation, so that the same fit continues where it was interrupted; made where
            it is not there.

    Raises:
        SimulationFailure: the model breaks down at every start.
        InputError: a parameter that the model does not have; an unknown method; a file to resume of another model.
    """
    options = options or FitOptions()
    if options.method not in METHODS:
        raise InputError(
            f"there is no method '{options.method}' to fit with; choose one of {', '.join(METHODS)}"
        )
    chosen = tuple(base_parameters(data, simulator.interface) if free is None else free)
    if resume is not None:
        with closing(LoggedSimulator(simulator, resume)) as logged:
            cached = cast(AnySimulator, logged)
            return fit(
                cached, data, chosen, fixed=fixed, starts=starts, options=options, progress=progress
            )
    tracker = Tracker({n: signal.unit for n, signal in data.signals.items()}, progress)
    is_over = options.limit()
    objective = Objective(
        simulator, data, data.fit_runs, chosen, fixed, options.tolerance, tracker, is_over=is_over
    )
    points = [{f.name: f.start for f in chosen}, *starts]
    solution = METHODS[options.method](FitProblem(objective, points, options))
    end = solution.end
    linear = linearised(objective, end.z, options.rows) if options.rows else None
    if any(run.start.mode == "estimated" for run in data.fit_runs):
        objective.residuals(
            end.z
        )  # a descent may have ended with a look elsewhere, or answers come from a file
    values = objective.values(end.z)
    # samples of held-out runs say nothing of any other parameter
    starts_estimated = start_estimates(objective) | estimated_starts(
        simulator,
        data,
        data.holdout_runs,
        values,
        objective.tolerance,
        options.second_look and not is_over(),
        objective.starts.state_ranges,
    )
    values |= {name: e.value for name, e in starts_estimated.items()}
    comparison = compare(simulator, data, values, options.tolerance, rules=options.rules)
    by_role = statistics_by_role(comparison)
    spread = spread_of(by_role["fit"])
    parameters = estimates(chosen, end.z, end.jacobian, objective.bounds, spread)
    return Fit(
        simulator.interface.model,
        parameters,
        comparison,
        by_role,
        objective.evaluations,
        tuple(dict.fromkeys(objective.failures)),
        combinations(objective, end.z, end.jacobian, parameters, spread),
        options.method,
        solution.search,
        tracker.convergence,
        correlations(end.jacobian),
        linear,
        starts=starts_estimated,
        holdout_uncertainty=_holdout_uncertainty(objective, values, options, end.z, by_role["fit"]),
    )


def _holdout_uncertainty(
    fitted: Objective,
    values: Mapping[str, float],
    options: FitOptions,
    z: Array,
    residuals_of_fit: ResidualStatistics,
) -> HoldoutUncertainty:
    runs = fitted.data.holdout_runs
    if not options.holdout_uncertainty or not runs:
        return HoldoutUncertainty()
    # No allowance is made for a model with structured residuals in the fitted runs.
    if residuals_of_fit.exceeds(CRITERIA.residuals.drift) and _is_correlated(residuals_of_fit):
        return HoldoutUncertainty()
    free_without_priors = [
        replace(parameter, prior=None) for parameter in fitted.free
    ]  # the fitted runs have the priors
    holdout = Objective(
        fitted.simulator, fitted.data, runs, free_without_priors, values, options.tolerance
    )
    holdout.starts.state_ranges = fitted.starts.state_ranges
    return estimate_holdout_uncertainty(fitted, holdout, z, spread_of(residuals_of_fit), options)


def profile(
    simulator: AnySimulator,
    data: DataSet,
    fit: Fit,
    free: Sequence[Free] | None = None,
    *,
    fixed: Mapping[str, float] | None = None,
    progress: Progress | None = None,
) -> Profiles:
    """Profile likelihood of every parameter of a fit.

    Args:
        simulator: the model that was fitted.
        data: what it was fitted to.
        fit: the optimum.
        free: the parameters that were fitted, as for ``fit``.
        fixed: further parameter values [SI], as for ``fit``.
        progress: called after each simulation.
    """
    chosen = tuple(base_parameters(data, simulator.interface) if free is None else free)
    tracker = Tracker({n: signal.unit for n, signal in data.signals.items()}, progress)
    objective = Objective(simulator, data, data.fit_runs, chosen, fixed, None, tracker)
    return profiles(objective, fit.values, spread_of(fit.residuals["fit"]), fit.model)


def statistics_by_role(comparison: Comparison) -> dict[str, ResidualStatistics]:
    """What the residuals of a comparison are like, per role ("fit", "holdout")."""
    return {role: statistics_of(comparison, role) for role in ROLES}


def statistics_of(
    comparison: Comparison, role: str, shifts: Mapping[tuple[str, str], Array] | None = None
) -> ResidualStatistics:
    """What the residuals of the runs with one role are like.

    Args:
        comparison: of a model.
        role: of the runs.
        shifts: (n,) what is added to the weighted residuals, by run and signal.
    """
    runs = [r for r in comparison.runs if r.run.role == role]
    return residual_statistics(series_of(runs, comparison.data.signals, shifts))


def spread_of(s: ResidualStatistics) -> float:
    """Factor on standard deviations of estimates, for residuals beyond the declared noise or correlated ones."""
    time = s.correlation_time if _is_correlated(s) else 1.0
    return float(np.sqrt(max(1.0, s.chi2_reduced) * time))


def _is_correlated(s: ResidualStatistics) -> bool:
    return s.whiteness_score > CRITERIA.residuals.correlated
