"""A session's state as the events that a page shows."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import PureWindowsPath

from pam_cosim.comparison import Comparison, Rule, SignalScore, score, warnings_of
from pam_cosim.compiler.names import last
from pam_cosim.errors import SimulationFailure
from pam_cosim.files import plain
from pam_cosim.fitting import METHODS, Estimate, Free
from pam_cosim.measurement import ROLES, DataSet, Run
from pam_cosim.model.references import is_file
from pam_cosim.problems import ParameterValue
from pam_cosim.reporting.account import quantity_text, remark, unit_text
from pam_cosim.units import readable_factor
from pam_cosim.workbench.opened_model import Opened
from pam_cosim.workbench.protocol import Json, event, selected
from pam_cosim.workbench.state import State, label_of, standing_label, with_rung


def study_event(
    state: State, opened: Opened, effects: Sequence[Json], benches: Sequence[str]
) -> Json:
    """The event of what changes seldom."""
    data = state.data
    outputs = opened.simulator.interface.outputs
    return event(
        "study",
        state="open",
        folder=data.folder.resolve().name,
        **selected(data, "title notes"),
        **selected(state, "model file"),
        short=short_name(state.model),
        with_effects=label_of(state.effects),
        runs=[_run(run) for run in data.runs],
        signals=[
            {
                "name": name,
                "unit": unit_text(s.unit),
                "quantity": outputs[name].description or name,
                "noise": s.sigma * readable_factor(s.unit),
                "noise_text": quantity_text(s.sigma, s.unit),
                "use": "fitted" if s.fitted else "compared",
            }
            for name, s in data.signals.items()
        ],
        parameters=[_parameter(free, state, opened) for free in opened.parameters.values()],
        held=[_held(row, opened) for row in state.known if row.free is None],
        effects=effects,
        families=list(dict.fromkeys(e["family"] for e in effects)),
        benches=benches,
        methods=list(METHODS),
    )


def short_name(model: str) -> str:
    """A model as it is called for short: a class by its last name, a file without its folder and kind."""
    return PureWindowsPath(model).stem if is_file(model) else last(model)


def steps_event(state: State, saved: bool) -> Json:
    """The event of what was done."""
    return event("steps", steps=[{"text": str(step)} for step in state.steps], saved=saved)


def _run(run: Run) -> Json:
    return selected(
        run,
        "name role describe static=is_static",
        along=f"{run.along.name} [{unit_text(run.along.unit) or '1'}]" if run.along else "",
        begins=run.time[0],
        ends=run.time[-1],
    )


def value_of(free: Free, state: State) -> float:
    """The value of a parameter [SI]."""
    return state.values.get(free.name, free.start)


def _parameter(free: Free, state: State, opened: Opened) -> Json:
    variable = opened.simulator.interface.parameters.get(free.parameter)
    value = value_of(free, state)
    estimate = state.fit.parameters.get(free.name) if state.fit else None
    if estimate is not None and estimate.value != value:
        estimate = None
    return {
        **selected(free, "name logarithmic"),
        **selected(free, "low high", free.unit),
        **interval(estimate, free.unit),
        "unit": unit_text(free.unit),
        "value": value * readable_factor(free.unit),
        "description": variable.description if variable else "",
        "effect": opened.origin.get(free.name),
        "remark": remark(estimate) if estimate else "",
    }


def _held(row: ParameterValue, opened: Opened) -> Json:
    """A value that no fit moves."""
    variable = opened.simulator.interface.settable.get(row.name)
    return {
        **selected(row, "name"),
        **selected(row, "value", row.unit),
        "unit": unit_text(row.unit),
        "source": row.source.replace("by the caller", "here"),
        "description": variable.description if variable else "",
        "bounded": variable is not None and None not in (variable.min, variable.max),
    }


def interval(estimate: Estimate | None, unit: str) -> Json:
    """The 95 % interval of an estimate in the shown unit; None where the data do not determine it."""
    if estimate is None or not (
        estimate.determined and math.isfinite(estimate.high - estimate.low)
    ):
        return {"low95": None, "high95": None}
    return selected(estimate, "low95=low high95=high", unit)


def rung_of(label: str, comparison: Comparison) -> Json:
    """A comparison as a rung of the error ladder."""
    rung: Json = {"label": label}
    for role in ROLES:
        rung |= {
            role: _levels(comparison.scores[role], comparison.data),
            f"chi2_{role}": comparison.chi2_reduced(role),
        }
    return plain(rung)  # type: ignore[no-any-return]


def _levels(scores: Mapping[str, SignalScore], data: DataSet) -> Json:
    units = {name: data.signals[name].unit for name in scores}
    return {
        name: selected(s, "rms=rmse", units[name], text=quantity_text(s.rmse, units[name]))
        for name, s in scores.items()
    }


def scores_event(
    state: State,
    opened: Opened,
    comparison: Comparison,
    version: int,
    failures: Mapping[str, SimulationFailure],
) -> Json:
    """The event of how far the standing model is from the measurement."""
    signals = comparison.data.signals
    present_rung = rung_of(standing_label(state), comparison)
    return event(
        "scores",
        version=version,
        scores={role: present_rung[role] for role in ROLES},
        runs={
            r.run.name: {
                name: signal_score.rmse * readable_factor(signals[name].unit)
                for name, signal_score in score([r], signals).items()
            }
            for r in comparison.runs
        },
        ladder=with_rung(state.rungs, present_rung),
        values={
            f.name: value_of(f, state) * readable_factor(f.unit) for f in opened.parameters.values()
        },
        warnings=[
            *(f"{run} cannot be simulated: {failure}" for run, failure in failures.items()),
            *warnings_of(comparison.runs),
        ],
        failed=[{"run": run, "text": str(failure)} for run, failure in failures.items()],
    )


def where_event(
    rules: Sequence[Rule], ranges: Sequence[dict[str, list[tuple[float, float]]]], version: int
) -> Json:
    """The event of where the error is."""
    rule_entries = [
        selected(rule, "signal rule error_share time_share", ranges=times)
        for rule, times in zip(rules, ranges, strict=True)
    ]
    return event("where", version=version, rules=rule_entries)
