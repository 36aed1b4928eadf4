"""A session's state as the events that a page shows."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import PureWindowsPath

from pam_cosim.comparison import Comparison, SignalScore, chi2_reduced, score, warnings_of
from pam_cosim.comparison import Rule as FoundRule
from pam_cosim.compiler.names import last
from pam_cosim.fitting import METHODS, Estimate, Free
from pam_cosim.measurement import ROLES, DataSet, Run
from pam_cosim.model.references import is_file
from pam_cosim.reporting.account import estimate_texts, percent, quantity_text, remark, unit_text
from pam_cosim.units import readable_factor
from pam_cosim.workbench.opened_model import Opened
from pam_cosim.workbench.protocol import (
    ErrorRegion,
    ErrorRegionsEvent,
    LadderStep,
    Level,
    ScoresEvent,
    ShownEffect,
    ShownParameter,
    ShownRun,
    ShownSignal,
    StepsEvent,
    StudyEvent,
)
from pam_cosim.workbench.state import State, label_of, standing_label, with_rung


def study_event(
    state: State, opened: Opened, effects: Sequence[ShownEffect], benches: Sequence[str]
) -> StudyEvent:
    """All that moves seldom."""
    data = state.data
    return StudyEvent(
        title=data.title,
        folder=str(data.folder.resolve().name),
        state="open",
        model=state.model,
        short=short_name(state.model),
        with_effects=label_of(state.effects),
        runs=tuple(_run(run) for run in data.runs),
        signals=tuple(_signals(data, opened)),
        parameters=tuple(_parameter(free, state, opened) for free in opened.parameters.values()),
        effects=tuple(effects),
        families=tuple(dict.fromkeys(e.family for e in effects)),
        notes=data.notes(),
        benches=tuple(benches),
        methods=tuple(METHODS),
        file=state.file,
    )


def short_name(model: str) -> str:
    """A model as it is called for short: a class by its last name, a file without its folder and kind."""
    return PureWindowsPath(model).stem if is_file(model) else last(model)


def steps_event(state: State, saved: bool) -> StepsEvent:
    """What was done."""
    return StepsEvent(tuple({"text": str(step)} for step in state.steps), saved)


def _run(run: Run) -> ShownRun:
    return ShownRun(
        name=run.name,
        role=run.role,
        duration=float(run.time[-1] - run.time[0]) if not run.is_static else float(len(run.time)),
        static=run.is_static,
        along=f"{run.along.name} [{unit_text(run.along.unit) or '1'}]" if run.along else "",
        samples=len(run.time),
        describe=run.describe(),
        parameters=tuple(f"{name} = {value:.4g}" for name, value in run.parameters.items()),
        begins=float(run.time[0]),
        ends=float(run.time[-1]),
    )


def _signals(data: DataSet, opened: Opened) -> list[ShownSignal]:
    outputs = opened.simulator.interface.outputs
    return [
        ShownSignal(
            name=name,
            unit=unit_text(s.unit),
            quantity=outputs[name].description or name,
            noise=s.sigma * readable_factor(s.unit),
            noise_text=quantity_text(s.sigma, s.unit),
            use="fitted" if s.fitted else "compared",
        )
        for name, s in data.signals.items()
    ]


def value_of(free: Free, state: State) -> float:
    """What a parameter stands at [SI]."""
    return state.values.get(free.name, free.start)


def _parameter(free: Free, state: State, opened: Opened) -> ShownParameter:
    factor = readable_factor(free.unit)
    variable = opened.simulator.interface.parameters.get(free.parameter)
    value = value_of(free, state)
    estimate = state.fit.parameters.get(free.name) if state.fit else None
    if estimate is not None and estimate.value != value:
        estimate = None
    text, interval = estimate_texts(estimate) if estimate else ("", "")
    low95, high95 = _interval(estimate, factor)
    return ShownParameter(
        name=free.name,
        unit=unit_text(free.unit),
        value=value * factor,
        start=free.start * factor,
        low=free.low * factor,
        high=free.high * factor,
        description=variable.description if variable else "",
        effect=opened.origin.get(free.name),
        logarithmic=free.logarithmic,
        low95=low95,
        high95=high95,
        text=f"{text} ({interval})" if interval else text,
        remark=remark(estimate) if estimate else "",
    )


def _interval(estimate: Estimate | None, factor: float) -> tuple[float | None, float | None]:
    """The interval of an estimate in the shown unit; nothing where the data do not determine it."""
    if estimate is None or not estimate.determined:
        return None, None
    if not math.isfinite(estimate.high - estimate.low):
        return None, None
    return estimate.low * factor, estimate.high * factor


def rung_of(label: str, comparison: Comparison) -> LadderStep:
    """A comparison as a step of the error ladder."""
    by_role = {role: _levels(comparison.scores[role], comparison.data) for role in ROLES}
    return LadderStep(
        label,
        by_role["fit"],
        by_role["holdout"],
        _finite(comparison.chi2_reduced("fit")),
        _finite(comparison.chi2_reduced("holdout")),
    )


def _levels(scores: dict[str, SignalScore], data: DataSet) -> dict[str, Level]:
    levels = {}
    for name, s in scores.items():
        unit = data.signals[name].unit
        factor = readable_factor(unit)
        levels[name] = Level(
            _finite(s.rmse * factor),
            _finite(s.noise_rmse * factor),
            _finite(s.chi2_reduced),
            quantity_text(s.rmse, unit),
            quantity_text(s.noise_rmse, unit),
        )
    return levels


def _shown_errors(scores: Mapping[str, SignalScore], data: DataSet) -> dict[str, float]:
    """Root mean square errors in the shown units."""
    factors = {name: readable_factor(data.signals[name].unit) for name in scores}
    return {name: one.rmse * factors[name] for name, one in scores.items()}


def _size(scores: Mapping[str, SignalScore], data: DataSet) -> float | None:
    """Of the error of the fitted signals, in noise standard deviations."""
    fitted = {name: one for name, one in scores.items() if data.signals[name].fitted}
    return _root(chi2_reduced(fitted))


def scores_event(state: State, opened: Opened, comparison: Comparison, version: int) -> ScoresEvent:
    """How far the standing model is from the measurement."""
    data = comparison.data
    now = rung_of(standing_label(state), comparison)
    by_run = {r.run.name: score([r], data.signals) for r in comparison.runs}
    return ScoresEvent(
        version=version,
        scores={"fit": now.fit, "holdout": now.holdout},
        runs={run: _shown_errors(scores, data) for run, scores in by_run.items()},
        sizes={run: _size(scores, data) for run, scores in by_run.items()},
        ladder=with_rung(state.rungs, now),
        values={
            f.name: value_of(f, state) * readable_factor(f.unit) for f in opened.parameters.values()
        },
        warnings=warnings_of(comparison.runs),
    )


def where_event(
    rules: Sequence[FoundRule], ranges: Sequence[dict[str, list[tuple[float, float]]]], version: int
) -> ErrorRegionsEvent:
    """Where the error sits."""
    shown = (
        ErrorRegion(
            number,
            r.signal,
            r.rule,
            r.error_share,
            r.time_share,
            f"{percent(r.error_share)} of the error of {r.signal} in {percent(r.time_share)} of the samples: {r.rule}",
            times,
        )
        for number, (r, times) in enumerate(zip(rules, ranges, strict=True))
    )
    return ErrorRegionsEvent(version, tuple(shown))


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _root(value: float) -> float | None:
    return math.sqrt(value) if math.isfinite(value) and value >= 0 else None
