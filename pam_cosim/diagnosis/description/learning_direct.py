"""A missing term learned from what the samples themselves feel of it.

A ledger opens all balances at once and looks at the course of each missing term; that needs a model whose states may be
moved freely, and time. Here the term is a sum of forms of the states, ramps that join to a spline among them, each with
a coefficient that starts at zero. One simulation tells what each coefficient would change in every sample, to first
order; the forms are chosen that explain most of the residuals of runs left out, beside what the free parameters can do.
Points at rest have such residuals too. What comes out is a description, as everything that is learned.
"""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.catalogue import (
    Composition,
    EffectClass,
    compose_on,
    effect_classes,
    origins,
    unknown_terms,
)
from pam_cosim.comparison import simulate_run
from pam_cosim.compiler import ClassTree, compile_model, read_library
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.description.learning import (
    BLOCKS,
    LEAST_GAIN,
    FittedAddend,
    LearnedTerm,
    TermSamples,
    coefficients_of,
    described,
    select_forms_jointly,
)
from pam_cosim.diagnosis.description.learning_library import Form, quantities, ramps
from pam_cosim.diagnosis.description.learning_text import modelica_text
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.trial import every_parameter
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.files import write_text
from pam_cosim.fitting import Fit, Linear, linearised
from pam_cosim.fitting.linear import rows_of_series
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_source
from pam_cosim.ledger import BalanceEntry
from pam_cosim.ledger.augmented import TERM
from pam_cosim.model.interface import Variable
from pam_cosim.simulation import Simulator

_MOST_RAMPS = 8  # addends of a spline: two variables with a line and three bends each
_REST_SPAN = 1e-15  # [SI unit]: a variable that spans less is at rest

RESIDUALS = "the model's mean square error"
"""What the score of a term that was learned directly is a part of."""

_WATCHED = "Watched"
_SCRATCH = "LearnedScratch"


@dataclass(frozen=True)
class DirectTerm:
    """A term that was learned directly, the entry that it is written for, and what it leaves of the residuals.

    Attributes:
        left: mean square of the residuals of runs left out, in standard deviations, by the linearised model.
    """

    term: LearnedTerm
    entry: BalanceEntry
    left: float


def learn_directly(search: Search, effects: Sequence[str], present: Fit) -> DirectTerm | None:
    """A term in the balance whose forms explain most of what a fitted model leaves; None where none explains any.

    Args:
        search: model, data and library.
        effects: names of effects that the model has.
        present: the fit of the model with them.
    """
    found: list[DirectTerm] = []
    for term in unknown_terms(search.tree, origins(search.structure.parts)):
        try:
            direct = _in_balance(search, effects, present, term)
        except (SimulationFailure, InputError, ArithmeticError, ValueError):
            continue  # this balance cannot be opened in this model; others may
        if direct is not None:
            found.append(direct)
    return min(found, key=lambda d: d.left, default=None)


def with_coefficients(direct: DirectTerm, tree: ClassTree, factor: float) -> LearnedTerm:
    """The term with a part of its coefficients, where a fit may start from; their bounds stay."""
    terms = tuple(replace(t, coefficient=factor * t.coefficient) for t in direct.term.terms)
    source = modelica_text(
        tree, direct.term.name, direct.entry, terms, direct.term.score, RESIDUALS
    )
    return replace(direct.term, terms=terms, modelica_source=source)


def _in_balance(
    search: Search, effects: Sequence[str], present: Fit, term: EffectClass
) -> DirectTerm | None:
    values = present.values_and_starts
    base = next(c.owner for c in search.tree.components(term.qualified_name) if c.name == TERM)
    watched = _variables_beside(search, effects, term, values)
    if watched is None:
        return None
    variables, units, own = watched
    known = quantities(variables, units)
    library = ramps(known, variables)
    entry = BalanceEntry(
        term.balance, 0.0, 0.0, 0.0, own.unit, own.description, base=base, units=units
    )
    samples = _residual_samples(search, effects, values, entry, library)
    # what a term of the size that it is declared for does not move by a standard deviation, it cannot be learned from
    largest = min(abs(own.min or np.inf), abs(own.max or np.inf))
    library = [f for f in library if largest * float(np.max(np.abs(samples.column(f)))) > 1]
    picked = select_forms_jointly(samples, library, _MOST_RAMPS) if library else []
    if not picked:
        return None
    fitted = coefficients_of(samples, picked)
    if not fitted.score > LEAST_GAIN:
        return None
    terms = tuple(replace(t, reach=abs(t.coefficient)) for t in fitted.terms)
    learned = described(entry, terms, samples, fitted, search.tree, RESIDUALS)
    return DirectTerm(learned, entry, fitted.left)


# ---- what a term could be a function of -----------------------------------------------------------------------------


def _variables_beside(
    search: Search, effects: Sequence[str], term: EffectClass, values: Mapping[str, float]
) -> tuple[dict[str, Array], dict[str, str], Variable] | None:
    """The variables beside a term over all fitted samples, their units, and the parameter that is the term."""
    composition = compose_on(search.tree, search.structure, [*effects, term.name])
    if composition is None:
        return None
    parameter = composition.parameters[term.name][0]
    prefix = parameter.rpartition(".")[0] + "."
    with tempfile.TemporaryDirectory(prefix="pam-cosim-") as folder:
        file = Path(folder, "composition.mo")
        file.write_text(composition.text, encoding="utf-8")
        interface = compile_model(composition.name, files=[*search.files, file]).interface
    inside = [n for n in interface.locals if n.startswith(prefix) and "." not in n[len(prefix) :]]
    names = {n[len(prefix) :]: n for n in inside if n != prefix + TERM}
    if not names:
        return None
    variables = _simulated(search, composition, names, values)
    units = {short: interface.locals[full].unit for short, full in names.items()}
    moving = {short: v for short, v in variables.items() if _is_moving(v)}
    return moving, units, interface.parameters[parameter]


def _is_moving(values: Array) -> bool:
    return bool(np.all(np.isfinite(values)) and np.ptp(values) > _REST_SPAN)


def _simulated(
    search: Search, composition: Composition, names: Mapping[str, str], values: Mapping[str, float]
) -> dict[str, Array]:
    """Variables of a model over all fitted samples, by the names that these have in ``names``."""
    outputs = {short: f"watched_{i}" for i, short in enumerate(names, 1)}
    lines = [f"  output Real {outputs[short]} = {full};" for short, full in names.items()]
    text = "\n".join(
        [f"model {_WATCHED}", f"  extends {composition.name};", *lines, f"end {_WATCHED};"]
    )
    parts: dict[str, list[Array]] = {short: [] for short in names}
    with Simulator(
        build_source(_WATCHED, f"{composition.text}\n{text}\n", search.files)
    ) as simulator:
        for run in search.data.fit_runs:
            simulated = simulate_run(simulator, search.data, run, values).model
            for short, output in outputs.items():
                parts[short].append(simulated[output])
    return {short: np.concatenate(arrays) for short, arrays in parts.items()}


# ---- what the samples feel of it ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _ResidualSamples(TermSamples):
    """Residuals of the model, and what each form's coefficient would change in them."""

    felt: Mapping[str, Array]

    def column(self, form: Form, shape: float | None = None) -> Array:
        return self.felt[form.text]


def _residual_samples(
    search: Search,
    effects: Sequence[str],
    values: Mapping[str, float],
    entry: BalanceEntry,
    library: Sequence[Form],
) -> _ResidualSamples:
    """The fitted runs linearised by the free parameters and by a coefficient of every form."""
    linear, objective, series, mine = _linearised_with_terms(
        search, effects, values, entry, library
    )
    by_name = dict(zip(linear.names, linear.slopes.T, strict=True))
    at_bound = CRITERIA.fit.at_bound * (linear.high - linear.low)
    inside = (linear.values > linear.low + at_bound) & (linear.values < linear.high - at_bound)
    free = [
        name
        for name, is_free in zip(linear.names, inside, strict=True)
        if is_free and name not in mine
    ]
    others = [name for name in free if np.any(by_name[name])]
    rows = len(linear.residual)
    nuisance = np.column_stack([np.zeros((rows, 0)), *(by_name[name] for name in others)])
    group = _groups(search, objective, series)
    return _ResidualSamples(
        value=linear.residual,
        weight=np.ones(rows),
        variables={},
        group=group,
        learning_groups=tuple(range(int(group.max()) + 1)),
        imitated=nuisance,
        free=tuple(others),
        felt={form.text: by_name[name] for form, name in zip(library, mine, strict=True)},
    )


def _linearised_with_terms(
    search: Search,
    effects: Sequence[str],
    values: Mapping[str, float],
    entry: BalanceEntry,
    library: Sequence[Form],
) -> tuple[Linear, Objective, NDArray[np.int_], Sequence[str]]:
    """The model with a term of every form about the values; its objective, the series of each row, the coefficients."""
    terms = [FittedAddend(0.0, 0.0, form, reach=1.0) for form in library]
    with tempfile.TemporaryDirectory(prefix="pam-cosim-") as folder:
        file = Path(folder, f"{_SCRATCH}.mo")
        write_text(file, modelica_text(search.tree, _SCRATCH, entry, terms, 0.0))
        sources = (*search.files, file)
        tree = read_library(files=sources)
        composition = compose_on(tree, search.structure, [*effects, _SCRATCH])
        if composition is None or not any(e.name == _SCRATCH for e in effect_classes(tree)):
            raise InputError(f"the model has no place for a term of {entry.balance}")
        own = [name for names in composition.parameters.values() for name in names]
        free = tuple(dict.fromkeys([*search.data.differentiated, *own]))
        fmu = build_source(
            composition.name, composition.text, sources, sensitivities=free, lean=True
        )
    with Simulator(fmu) as simulator:
        simulator.limit = CRITERIA.search.longest_run
        moved = every_parameter(search.data, composition, simulator.interface)
        moved = [f.starting_at(values.get(f.name, f.start)) for f in moved]
        objective = Objective(simulator, search.data, search.data.fit_runs, moved, values)
        linear = linearised(
            objective, np.array([f.to_z(f.start) for f in moved]), CRITERIA.search.rows
        )
        if linear is None:
            raise SimulationFailure(objective.first_failure)
        series = rows_of_series(objective, CRITERIA.search.rows)
    return linear, objective, series, composition.parameters[_SCRATCH]


def _groups(search: Search, objective: Objective, series: NDArray[np.int_]) -> NDArray[np.intp]:
    """(m,) number of the run that each row is of; parts of it where there is a single one."""
    names = [run.name for run in search.data.fit_runs]
    run = np.array([names.index(r.name) for r, _ in objective.series])[series]
    if len(names) > 1:
        return run
    place = np.concatenate([np.arange(n) / n for n in np.bincount(series)])
    return np.asarray(place * BLOCKS, dtype=np.intp)


__all__ = ["RESIDUALS", "DirectTerm", "learn_directly", "with_coefficients"]
