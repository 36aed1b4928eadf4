"""Which recordings, or rows of tables, are held out; directions of tables; interpolation and noise of the signals."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.benches import Bench
from pam_cosim.drafting.columns import names_in
from pam_cosim.drafting.entries import SENSES, MappedRun
from pam_cosim.drafting.headings import Headings, split_words
from pam_cosim.drafting.recordings import Source, places_of
from pam_cosim.drafting.shapes import (
    is_constant,
    is_held,
    is_repeated,
    is_switch,
    noise_at_rest,
    span,
)
from pam_cosim.drafting.values import text_of
from pam_cosim.errors import InputError
from pam_cosim.measurement import ROLES
from pam_cosim.measurement.curves import ROWS_PER_CURVE, ROWS_PER_LEVEL, curves, directions, levels
from pam_cosim.measurement.markers import marker_of
from pam_cosim.measurement.points import CONTRACTS, VALUE_TOLERANCE
from pam_cosim.measurement.run_names import patterns_first
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.references import BRANCH
from pam_cosim.units import format_quantity, readable_unit
from pam_cosim.wording import shown

_SAME_TRAIT = 0.02  # of the largest value: smaller differences do not distinguish runs
_HELD_OUT_SHARE = 0.25  # share of the runs, or of the values of a table, that are held out
_RUNS_TO_HOLD_OUT = 3  # at least; fewer runs are all needed for the fit
_LEVELS_TO_HOLD_OUT = 4  # values of an imposed quantity, at least, of which some are held out
_POINTS_TO_HOLD_OUT = 8  # the same along a single curve, which needs most of its points


@dataclass(frozen=True)
class Role:
    """``fit`` or ``holdout``, and why."""

    role: str
    why: str = ""


@dataclass(frozen=True)
class Sigma:
    """Standard deviation [SI], None where it is unknown; and from where."""

    value: float | None
    why: str


@dataclass(frozen=True)
class PointsDraft:
    """Keys of ``experiment.toml`` for tables of points at rest.

    Attributes:
        branch: direction by recording, "" where a column has it or it is unknown.
        hold_out: by recording, values that are held out, by input.
    """

    branch: tuple[str, ...]
    hold_out: tuple[dict[str, list[str]], ...]


def roles(
    runs: Sequence[MappedRun], interface: Interface, run_values: Sequence[Mapping[str, float]] = ()
) -> list[Role]:
    """One for each recording.

    A quarter is held out, each the one that differs most from its nearest neighbour among those that are fitted while
    its traits (level and pace of each signal, what is known of it) lie between theirs; else the one least outside.
    """
    result = [Role("fit") for _ in runs]
    if len(runs) < _RUNS_TO_HOLD_OUT:
        return result
    traits = {
        name: (unit, values)
        for name, (unit, values) in _traits(runs, interface, run_values).items()
        if np.isfinite(values).all() and span(values) > _SAME_TRAIT * float(np.max(np.abs(values)))
    }
    if not traits:
        result[-1] = Role("holdout", "the last: the recordings do not differ in any trait")
        return result
    scaled = np.array([(v - v.min()) / span(v) for _, v in traits.values()]).T
    fitted = list(range(len(runs)))
    for _ in range(max(1, round(_HELD_OUT_SHARE * len(runs)))):
        outside, apart = {}, {}
        for i in fitted:
            others = scaled[[k for k in fitted if k != i]]
            low, high = others.min(axis=0) - scaled[i], scaled[i] - others.max(axis=0)
            outside[i] = np.maximum(low, 0.0) + np.maximum(high, 0.0)
            apart[i] = min(np.abs(others - scaled[i]), key=lambda away: float(away @ away))
        chosen = min(
            fitted, key=lambda i: (outside[i].sum().round(9), -float(apart[i] @ apart[i]), i)
        )
        fitted.remove(chosen)
        within = not outside[chosen].any()
        name = list(traits)[int(np.argmax((apart if within else outside)[chosen]))]
        unit, values = traits[name]
        ends = values[chosen], values[fitted].min(), values[fitted].max()
        level, *span_of = (format_quantity(float(v), unit) for v in ends)
        how = "no recording lies within the range of the others, and this one exceeds it least"
        if within:
            how = "it lies within the range of the fitted runs and differs from each"
        result[chosen] = Role("holdout", f"{how}: {name} {level}, theirs {' to '.join(span_of)}")
    return result


def _traits(
    runs: Sequence[MappedRun], interface: Interface, run_values: Sequence[Mapping[str, float]]
) -> dict[str, tuple[str, Array]]:
    """Numbers of each recording with their units: mean and pace of each signal, what is known of it; NaN: none."""
    variables = {**interface.inputs, **interface.outputs, **interface.parameters}
    traits = {}
    for name in dict.fromkeys(name for run in runs for name in run.signals):
        unit = variables[name].unit
        read = [run.signals.get(name, np.full(1, np.nan)) for run in runs]
        means = np.array([np.nanmean(v) if np.isfinite(v).any() else np.nan for v in read])
        traits[f"mean of {name}"] = unit, means
        if not all(map(is_constant, read)):
            lasting = [float(np.ptp(run.time)) or np.inf for run in runs]
            paces = np.array([_travel(v) for v in read]) / lasting
            traits[f"pace of {name}"] = f"{unit}/s", np.where(np.isnan(means), np.nan, paces)
    for name in dict.fromkeys(name for values in run_values for name in values):
        constants = np.array([values.get(name, np.nan) for values in run_values])
        traits[name] = variables[name].unit, constants
    return traits


def _travel(values: Array) -> float:
    """Total variation of a signal, sampled in about two hundred steps."""
    return float(np.nansum(np.abs(np.diff(values[:: max(1, len(values) // 200)]))))


def stated_roles(
    guessed: Sequence[Role], sources: Sequence[Source], stated: Mapping[str, str]
) -> list[Role]:
    """The roles, those by name or pattern that the user states instead of guesses.

    Raises:
        InputError: there is no such recording or role, or none would be left to fit.
    """
    result = list(guessed)
    for name, role in patterns_first(stated):
        if role not in ROLES:
            raise InputError(
                f"{shown(role)} is no role of a recording; it is one of {', '.join(ROLES)}"
            )
        for i in places_of(name, sources):
            result[i] = Role(role)
    if not any(r.role == "fit" for r in result):
        raise InputError("no recording would remain to fit")
    return result


# ---- conventions of a logger: between samples, and noise -------------------------------------------------------------


def interpolation_of(bench: Bench) -> str:
    """``previous`` where what is imposed keeps its value between steps, in any file: a logger has one way for all."""
    read = bench.headings.with_trait("counted")
    formulas = [t for n, t in bench.evidence.formulas.items() if n in bench.interface.inputs]
    names = {name for text in formulas for name in names_in(text)}
    in_formulas = [c for c in bench.evidence.columns if c.name in names]
    for column in (*bench.choice.inputs.values(), *in_formulas):
        is_read = column.kind in read and "set" not in column.meaning.roles
        for values in column.values.values():
            keeps = is_held(values) and (is_repeated(values) or not is_read)
            if column.logged_on_change or keeps or is_switch(values):
                return "previous"
    return "linear"


def sigma_of(name: str, bench: Bench, runs: Sequence[MappedRun]) -> Sigma:
    """The median over the recordings, each of its longest rest."""
    unit, estimated = bench.signals[name].unit, "the software estimates it from"
    if name in bench.evidence.formulas:
        return Sigma(None, f"it is of a formula of yours: {estimated} the samples")
    if bench.evidence.points:
        return Sigma(None, f"the rows are points at rest: {estimated} neighbouring ones")
    estimates = []
    for run, file in zip(runs, bench.evidence.files, strict=True):
        rest = max(run.rests, key=lambda r: r.count, default=None)
        if rest is not None and name in run.outputs:
            sigma, step = noise_at_rest(run.time, run.outputs[name], rest)
            if sigma > 0.0:
                estimates.append((sigma, step, rest, run, file))
    if not estimates:
        return Sigma(None, f"{_why_none(name, runs)}: {estimated} the samples")
    value = float(np.median([sigma for sigma, *_ in estimates]))
    _, step, longest, run, file = max(estimates, key=lambda e: e[2].count)
    first, last = (round(float(run.time[i]), 3) for i in (longest.start, longest.stop - 1))
    where = f"from {first:.15g} s to {last:.15g} s of {file.name}, where nothing moves"
    steps = f"; recorded in steps of {format_quantity(step, unit)}" if step > value else ""
    more = f" (median of {len(estimates)} recordings)" if len(estimates) > 1 else ""
    return Sigma(value, f"the scatter of neighbouring samples {where}{more}{steps}")


def _why_none(name: str, runs: Sequence[MappedRun]) -> str:
    """Why the recordings show no noise."""
    if not any(run.rests for run in runs):
        return "nothing is at rest long enough"
    values = [run.outputs[name] for run in runs if name in run.outputs]
    if values and marker_of(np.concatenate(values)) is not None:
        return "one number is far from all others, as where a sample is missing"
    return "it shows no noise at rest"


# ---- points at rest: which way the muscle went, and rows that are held out -------------------------------------------


def check_imposed(bench: Bench) -> None:
    """Checks that every imposed input of points at rest has a value in each row.

    Raises:
        InputError: an imposed input has no value; the message names the option that states it.
    """
    evidence = bench.evidence
    for name in (n for n in bench.choice.unfed if n not in evidence.stated):
        if all(name in values for values in evidence.run_parameters):
            continue
        variable = bench.interface.inputs[name]
        unit = {"Pa": "kPa", "m": "mm"}.get(variable.unit, readable_unit(variable.unit))
        what = variable.description[:1].lower() + variable.description[1:]
        raise InputError(
            f"neither a column nor a file's name states the {what} ({name}); state it: --parameter '{name}=0 {unit}' "
            f"for all rows, or --parameter '{name}@FILE=0 {unit}' for each file"
        )


def points_draft(runs: Sequence[MappedRun], bench: Bench, by_run: bool) -> PointsDraft:
    """Directions by the names of the files or the order of the rows where no column has them, and rows to hold out.

    Args:
        runs: tables.
        bench: of the runs.
        by_run: whole recordings are held out.
    """
    inputs = bench.interface.inputs
    rows = [_imposed(run) for run in runs]
    branch = [""] * len(runs)
    if not any(BRANCH in run.inputs for run in runs):
        in_names = _in_names(bench.evidence.files, bench.headings)
        branch = in_names or _by_order([_ways(values, inputs) for values in rows])
    hold_out: list[dict[str, list[str]]] = [
        {} if by_run else _held_out(values, run.outputs, inputs)
        for values, run in zip(rows, runs, strict=True)
    ]
    return PointsDraft(tuple(branch), tuple(hold_out))


def _in_names(files: Sequence[Path], headings: Headings) -> list[str]:
    """up or down for each file, where every name states one of them and both occur; else none."""
    words = [[word for word in split_words(file.stem) if len(word) > 1] for file in files]
    ways = [set(map(headings.direction_word, file_words)) - {0} for file_words in words]
    is_clear = all(len(way) == 1 for way in ways) and len(set[int]().union(*ways)) == 2
    return [SENSES[sense] for way in ways for sense in way] if is_clear else []


def _ways(inputs: Mapping[str, Array], variables: Mapping[str, Variable]) -> Array:
    """(n,) 1 or -1 by the order of the rows, 0 where the order has no direction."""
    first = [name for unit in CONTRACTS for name in inputs if variables[name].unit == unit]
    return directions(inputs, first)[0] if first else np.zeros(1)


def _by_order(senses: Sequence[Array]) -> list[str]:
    """ "order" where rows go up and come back, in a file or from one to another; "" for all where they do not."""
    whole = {float(s[0]) for s in senses if len(s) and np.ptp(s) == 0.0}
    returns = any(min(np.sum(s > 0), np.sum(s < 0)) >= ROWS_PER_CURVE for s in senses)
    if not (whole >= {1.0, -1.0} or returns):
        return [""] * len(senses)
    return ["order" if s.any() else "none" for s in senses]


def _imposed(run: MappedRun) -> dict[str, Array]:
    """The imposed inputs, in the rows that have a value of each."""
    inputs = {name: values for name, values in run.inputs.items() if name != BRANCH}
    complete = np.all([np.isfinite(values) for values in inputs.values()], axis=0)
    return {name: values[complete] for name, values in inputs.items()}


def _held_out(
    inputs: Mapping[str, Array], outputs: Mapping[str, Array], variables: Mapping[str, Variable]
) -> dict[str, list[str]]:
    """Values of the input with the most levels, within the span of the others; none where there are few levels."""
    count = len(next(iter(inputs.values())))
    branches = curves(inputs, {n: v for n, v in outputs.items() if len(v) == count})
    least = dict.fromkeys([*branches[0].at, branches[0].along], _LEVELS_TO_HOLD_OUT)
    if len(branches) == 1:
        least[branches[0].along] = _POINTS_TO_HOLD_OUT
    levels_by_input = {name: _levels(inputs[name]) for name in least}
    able = [name for name, values in levels_by_input.items() if len(values) >= least[name]]
    if not able:
        return {}
    name = max(able, key=lambda name: len(levels_by_input[name]))
    values, unit = levels_by_input[name], variables[name].unit
    held_out = max(1, round(_HELD_OUT_SHARE * len(values)))
    places = np.round(np.linspace(0, len(values) - 1, held_out + 2)[1:-1]).astype(int)
    return {name: [text_of(values[i], unit) for i in places]}


def _levels(values: Array) -> list[float]:
    """The levels that readings repeat, each as it was read; none where the readings do not cluster."""
    exact = np.unique(values)
    tolerance = VALUE_TOLERANCE * span(values)
    is_apart = float(np.diff(exact).min(initial=np.inf)) > tolerance
    if is_apart and ROWS_PER_LEVEL * len(exact) <= len(values):
        return [float(value) for value in exact]
    number = levels(values)
    if number is None:
        return []
    groups = [values[number == k] for k in np.unique(number)]
    middle = [float(np.median(group)) for group in groups]
    wide = max(float(np.max(np.abs(g - m))) for g, m in zip(groups, middle, strict=True))
    return middle if wide <= tolerance else []
