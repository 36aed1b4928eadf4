"""A model against a whole data set."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from pam_cosim.comparison.condition_table import ConditionTable, condition_table
from pam_cosim.comparison.error_regions import Rule, where
from pam_cosim.comparison.plausibility import Doubt, doubts
from pam_cosim.comparison.residuals import RunComparison, simulate_run
from pam_cosim.comparison.scores import SignalScore, chi2_reduced, score
from pam_cosim.errors import InputError
from pam_cosim.exports import Columns, Tabular
from pam_cosim.measurement import ROLES, DataSet
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import AnySimulator
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, did_you_mean, listed, look_first


@dataclass(frozen=True)
class Comparison(Printed, Tabular):
    """Residuals and scores of a model on a data set.

    Attributes:
        model: name of the model.
        data: the measurement.
        parameters: values the model was run with beyond what the data set knows [SI].
        runs: every run, simulated.
        scores: per role ("fit", "holdout", "all") and signal.
        where: rules that hold most of the error, over all runs.
        units: SI units of the parameters and inputs of the runs, by name.
        convention: the convention that fits much better than that of the data, in words; "": none, or not checked.
    """

    json_keys = "model parameters signals=scores.all roles=_roles runs=_runs where doubts"

    model: str
    data: DataSet
    parameters: dict[str, float]
    runs: tuple[RunComparison, ...]
    scores: dict[str, dict[str, SignalScore]]
    where: tuple[Rule, ...]
    units: dict[str, str] = field(default_factory=dict)
    convention: str = ""

    @cached_property
    def doubts(self) -> tuple[Doubt, ...]:
        """What a person should check before an effect is searched for."""
        fitted = set(self.data.fit) <= set(self.parameters)
        ranges = self.data.domain.ranges
        return doubts(self.runs, self.data.signals, self.units, fitted, self.convention, ranges)

    def chi2_reduced(self, role: str = "all") -> float:
        """Mean square error in noise standard deviations over the fitted signals of the runs with ``role``."""
        return chi2_reduced(
            {n: s for n, s in self.scores[role].items() if self.data.signals[n].fitted}
        )

    def against(self, data: DataSet) -> Comparison:
        """The same simulations compared with other samples: ``data`` has the same runs with fewer samples."""
        other_comparison = self.with_data(data)
        return replace(other_comparison, scores=_scores(data, other_comparison.runs))

    def without_data(self) -> Comparison:
        """The same without the samples, which the caller has: ``with_data`` puts them back."""
        bare = (replace(r.run, time=r.run.time[:0], inputs={}, measurements={}) for r in self.runs)
        runs = tuple(replace(r, run=run) for r, run in zip(self.runs, bare, strict=True))
        return replace(self, data=replace(self.data, runs=()), runs=runs)

    def with_data(self, data: DataSet) -> Comparison:
        """The same with the runs of the data set itself, not copies of them."""
        runs = tuple(replace(r, run=run) for r, run in zip(self.runs, data.runs, strict=True))
        return replace(self, data=data, runs=runs)

    def table(self, rows: str, columns: str, signal: str | None = None) -> ConditionTable:
        """Correlation, rms error and chi-square by two parameters of the runs, such as load and frequency.

        Args:
            rows: name of a parameter that every run has.
            columns: of another one.
            signal: default: the first one that is fitted.

        Raises:
            InputError: a parameter that a run does not have, or an unmeasured signal.
        """
        measured = self.scores["all"]
        chosen = signal or next((n for n in measured if self.data.signals[n].fitted), "")
        if chosen not in measured:
            raise InputError(f"no run has samples of '{chosen}'; {did_you_mean(chosen, measured)}")
        return condition_table(
            self.model,
            self.runs,
            self.data.signals[chosen],
            rows,
            columns,
            self.units,
            self.parameters,
        )

    def _solvers(self) -> list[str]:
        """A sentence where runs were made by model exchange: the first message, and the number of runs."""
        solver_notes = [r.solver for r in self.runs if r.solver]
        count = (
            ""
            if len(solver_notes) == len(self.runs)
            else f" (in {len(solver_notes)} of {len(self.runs)} runs)"
        )
        return [f"{solver_notes[0]}{count}"] if solver_notes else []

    def frame_columns(self) -> Columns:
        """A row for each sample of each run and signal, its values in the SI unit of the column "unit"."""
        rows = [
            (r.run.name, time, name, self.data.signals[name].unit, value, model, value - model)
            for r in self.runs
            for name, values in r.run.measurements.items()
            for time, value, model in zip(r.run.time, values, r.model[name], strict=True)
            if math.isfinite(value)
        ]
        names = ("run", "time", "signal", "unit", "measured", "model", "residual")
        columns = zip(*rows, strict=True) if rows else ((),) * len(names)
        return {
            name: (column, "s" if name == "time" else None)
            for name, column in zip(names, columns, strict=True)
        }

    @property
    def _roles(self) -> dict[str, object]:
        return {role: {"signals": scores} for role, scores in self.scores.items() if scores}

    @property
    def _runs(self) -> list[dict[str, object]]:
        return [self._run_as_dict(run) for run in self.runs]

    def _run_as_dict(self, compared: RunComparison) -> dict[str, object]:
        solver = {"solver": compared.solver} if compared.solver else {}
        return {
            "name": compared.run.name,
            "role": compared.run.role,
            "parameters": compared.run.parameters,
            **_start_of(compared),
            **solver,
            "signals": score([compared], self.data.signals),
        }

    def _headline(self) -> str:
        errors = [
            f"{name} {format_quantity(score.rmse, self.data.signals[name].unit)}"
            for name, score in self.scores["all"].items()
        ]
        return f" of {self.model} with '{self.data.title}': {', '.join(errors)}"

    def __str__(self) -> str:
        lines = [f"{self.model} against {self.data.title}"]
        lines += look_first(doubt.text for doubt in self.doubts)
        lines += [f"  {sentence}" for sentence in self.data.starts]
        lines += [f"  {sentence}" for sentence in self._solvers()]
        for role in ROLES:
            for name, s in self.scores[role].items():
                signal = self.data.signals[name]
                unit, scatter = signal.unit, signal.scatter
                noise = (
                    ""
                    if math.isnan(s.noise_rmse)
                    else f", {scatter} {format_quantity(s.noise_rmse, unit)}"
                )
                moves = not math.isnan(s.nrmse)
                share = f"{100 * s.nrmse:.1f} % of range" if moves else "it does not move"
                lines.append(
                    f"  {role:8} {name:4} rms error {format_quantity(s.rmse, unit):>10} ({share}{noise})"
                )
        for rule in self.where[:5]:
            lines.append(
                f"  {100 * rule.error_share:.0f} % of the error of {rule.signal} in "
                f"{100 * rule.time_share:.0f} % of the samples: {rule.rule}"
            )
        return "\n".join(lines)


def _start_of(run: RunComparison) -> dict[str, object]:
    start = run.run.start
    mode = "periodic" if start.periodic else start.mode
    return {} if mode is None else {"start": mode}


def compare(
    simulator: AnySimulator,
    data: DataSet,
    parameters: Mapping[str, float] | None = None,
    tolerance: float | None = None,
    *,
    rules: bool = True,
) -> Comparison:
    """Simulates every run of ``data`` and scores the differences.

    Args:
        simulator: the model.
        data: the measurement.
        parameters: by name [SI].
        tolerance: relative, of the solver.
        rules: whether to say where the error sits.

    Raises:
        SimulationFailure: a run did not reach its end.
        InputError: a parameter that the model does not have; no run has a sample.
    """
    stated_values = dict(parameters or {})
    if not any(run.sample_count(name) for run in data.runs for name in data.signals):
        files = listed(dict.fromkeys(run.file.name for run in data.runs))
        outputs = listed(simulator.interface.outputs)
        message = f"no recording ({files}) has a sample of an output of {simulator.interface.model}: {outputs}"
        raise InputError(message, data.folder)
    runs = tuple(simulate_run(simulator, data, run, stated_values, tolerance) for run in data.runs)
    return scored(simulator.interface, data, stated_values, runs, rules=rules)


def scored(
    interface: Interface,
    data: DataSet,
    parameters: Mapping[str, float],
    runs: Sequence[RunComparison],
    *,
    rules: bool = True,
) -> Comparison:
    """Scores runs that were simulated with ``parameters`` [SI] of the model with ``interface``; see ``compare``."""
    stated_values = dict(parameters)
    sits = (
        where(runs, data.signals, interface.outputs, data.domain, interface.inputs) if rules else []
    )
    settable = interface.settable
    names_of_runs = (name for run in data.runs for name in (*run.parameters, *run.inputs))
    value_names = dict.fromkeys([*stated_values, *names_of_runs])
    units = {name: settable[name].unit for name in value_names if name in settable}
    return Comparison(
        interface.model, data, stated_values, tuple(runs), _scores(data, runs), tuple(sits), units
    )


def _scores(data: DataSet, runs: Sequence[RunComparison]) -> dict[str, dict[str, SignalScore]]:
    """Scores of the runs of each role, and of all."""
    by_role = {role: [r for r in runs if r.run.role == role] for role in ROLES} | {
        "all": list(runs)
    }
    return {role: score(chosen, data.signals) for role, chosen in by_role.items()}
