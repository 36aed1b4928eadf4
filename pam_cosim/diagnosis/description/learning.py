"""A missing term that no effect of the catalogue explains, as a formula of the model's own variables.

The term is a sum of forms of the states, ramps that join to a spline among them, each with a coefficient that starts at
zero. One simulation tells what each coefficient would change in every sample, to first order; the forms are chosen that
explain most of the residuals of runs left out, beside what the free parameters can do. Points at rest have such
residuals too. The formula is a description of one measurement, not a cause: another formula of the same size may
describe it as well, and beyond the range that was measured it means nothing.
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
from pam_cosim.diagnosis.description.forms import Form, quantities, ramps
from pam_cosim.diagnosis.description.learning_text import (
    Addend,
    TermPlace,
    formula_text,
    modelica_text,
)
from pam_cosim.diagnosis.description.selection import (
    LEAST_GAIN,
    FeltForms,
    coefficients_of,
    cross_validation_error,
    select_forms,
)
from pam_cosim.diagnosis.judgement.candidate import Attempt, Candidate
from pam_cosim.diagnosis.search.effort import Effort
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.trial import Trial, every_parameter, run_trial
from pam_cosim.errors import InputError, ModelError, SimulationFailure
from pam_cosim.files import write_text
from pam_cosim.fitting import Fit, FitOptions, linearised
from pam_cosim.fitting.linear import rows_of_series
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_source
from pam_cosim.ledger.augmented import TERM
from pam_cosim.model.interface import Variable
from pam_cosim.simulation import Simulator

_REST_SPAN = 1e-15  # [SI unit]: a variable that spans less is at rest
_BLOCKS = 4  # parts of a single run, which replace runs in the cross-validation
_WATCHED = "Watched"
_SCRATCH = "LearnedScratch"


@dataclass(frozen=True)
class LearnedTerm:
    """A missing term as a formula.

    Attributes:
        name: of the Modelica class.
        balance: in which it acts.
        formula: for a person, with numbers and units.
        modelica_source: an effect class that composes and refits like any other; family "learned".
        unit: of the term.
        score: part of the model's mean square error that the formula explains in runs that were not asked for it.
        fit_score: the same in the runs that were.
    """

    json_keys = "name balance formula unit score fit_score modelica=modelica_source"

    name: str
    balance: str
    formula: str
    modelica_source: str
    unit: str
    score: float
    fit_score: float

    def __str__(self) -> str:
        return f"{self.formula}  (explains {100 * self.score:.0f} % in runs that were not asked)"


@dataclass(frozen=True)
class Description:
    """A term as it was learned: its place, its addends, and what these explain by the linearised model.

    Attributes:
        score, fit_score: as of ``LearnedTerm``.
        remaining_square: mean square of the residuals of runs left out, in noise variances.
    """

    place: TermPlace
    addends: tuple[Addend, ...]
    score: float
    fit_score: float
    remaining_square: float

    def with_part(self, part: float) -> Description:
        """The same with a part of its coefficients, where a fit may start from; their bounds stay."""
        return replace(
            self,
            addends=tuple(replace(a, coefficient=part * a.coefficient) for a in self.addends),
        )

    def with_values_of(self, model: Candidate) -> Description:
        """The same with the coefficients that were fitted."""
        values = {name.rpartition(".")[2]: e.value for name, e in model.parameters.items()}
        fitted = (replace(a, coefficient=values[f"c_{i}"]) for i, a in enumerate(self.addends, 1))
        return replace(self, addends=tuple(fitted))

    def term(self, tree: ClassTree) -> LearnedTerm:
        """The formula and the class, named after the balance."""
        place, name = self.place, f"Learned{self.place.balance.capitalize()}"
        return LearnedTerm(
            name,
            place.balance,
            formula_text(place, self.addends),
            modelica_text(tree, name, place, self.addends, self.score),
            place.unit,
            self.score,
            self.fit_score,
        )


def learn(
    search: Search, balances: Sequence[str], effects: Sequence[str], present: Fit, effort: Effort
) -> Description | None:
    """A term in the balance whose forms explain most of what a fitted model leaves; None where none explains any.

    Args:
        search: model, data and library.
        balances: in which a term is looked for; none: in all.
        effects: names of effects that the model has.
        present: the fit of the model with them.
        effort: once it is spent, no further balance is opened; this grows.
    """
    descriptions: list[Description] = []
    for term in unknown_terms(search.tree, origins(search.structure.parts)):
        if effort.spent or (balances and term.balance not in balances):
            continue
        try:
            with effort.counting():
                description = _in_balance(search, effects, present, term)
        except (SimulationFailure, InputError, ArithmeticError, ValueError):
            continue  # this balance cannot be opened in this model; others may
        if description is not None:
            descriptions.append(description)
    return min(descriptions, key=lambda d: d.remaining_square, default=None)


def try_learned(
    term: LearnedTerm, search: Search, effects: Sequence[str], present: Fit, options: FitOptions
) -> Attempt:
    """The model with effects and a learned term, fitted from the present values: a candidate like any other.

    Raises:
        InputError: the term finds no place in the model.
    """
    with tempfile.TemporaryDirectory(prefix="pam-cosim-") as folder:
        file = Path(folder) / f"{term.name}.mo"
        write_text(file, term.modelica_source)
        sources, names = (*search.files, file), (*effects, term.name)
        tree = read_library(files=sources)
        composition = compose_on(tree, search.structure, names)
        if composition is None:
            raise InputError(f"{search.model} has no place for {term.name}", file)
        effect = next(e for e in effect_classes(tree) if e.file == file)
        trial = Trial(effect, names, composition, search.data, present.values, sources, options)
        return run_trial(trial)


def _in_balance(
    search: Search, effects: Sequence[str], present: Fit, term: EffectClass
) -> Description | None:
    values = present.values_and_starts
    base = next(c.owner for c in search.tree.components(term.qualified_name) if c.name == TERM)
    component_names = [c.name for c in search.tree.classes[base].components]
    watched = _variables_beside(search, effects, term, values, component_names)
    if watched is None:
        return None
    variables, units, term_parameter = watched
    place = TermPlace(term.balance, base, term_parameter.unit, term_parameter.description)
    arguments = quantities(variables, units)
    signed = tuple(q.name for q in arguments if q.signed)
    try:
        library = ramps(arguments, variables)
        rows = _felt_forms(search, effects, values, place, library)
    except ModelError:  # a rate that follows the term at once can be in it only as a factor
        library = ramps(arguments, variables, signed)
        rows = _felt_forms(search, effects, values, place, library)
    # what a term of the size that it is declared for does not move by a standard deviation, it cannot be learned from
    largest = min(abs(term_parameter.min or np.inf), abs(term_parameter.max or np.inf))
    library = [f for f in library if largest * float(np.max(np.abs(rows.felt[f.text]))) > 1]
    picked = select_forms(rows, library) if library else []
    if not picked:
        return None
    error_with_forms, error_without = (
        cross_validation_error(rows, forms) for forms in (picked, [])
    )
    if not error_with_forms < (1 - LEAST_GAIN) * error_without:
        return None
    coefficients, left_fitted = coefficients_of(rows, picked)
    _, before_fitted = coefficients_of(rows, [])
    addends = (
        Addend(c, form, abs(c)) for c, form in zip(coefficients.tolist(), picked, strict=True)
    )
    return Description(
        place,
        tuple(addends),
        1 - error_with_forms / error_without,
        1 - left_fitted / before_fitted,
        error_with_forms,
    )


# ---- what a term could be a function of -----------------------------------------------------------------------------


def _variables_beside(
    search: Search,
    effects: Sequence[str],
    term: EffectClass,
    values: Mapping[str, float],
    component_names: Sequence[str],
) -> tuple[dict[str, Array], dict[str, str], Variable] | None:
    """The variables at the place of a term over all fitted samples, their units, and the parameter of the term.

    Those that its class means a law to be of come first: of two that say the same the first is taken.
    """
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
    inside.sort(key=lambda n: n[len(prefix) :] not in component_names)
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


def _felt_forms(
    search: Search,
    effects: Sequence[str],
    values: Mapping[str, float],
    place: TermPlace,
    library: Sequence[Form],
) -> FeltForms:
    """The fitted runs linearised about the values by the free parameters and by a coefficient of every form."""
    with tempfile.TemporaryDirectory(prefix="pam-cosim-") as folder:
        file = Path(folder, f"{_SCRATCH}.mo")
        addends = [Addend(0.0, form, 1.0) for form in library]
        write_text(file, modelica_text(search.tree, _SCRATCH, place, addends, 0.0))
        sources = (*search.files, file)
        tree = read_library(files=sources)
        composition = compose_on(tree, search.structure, [*effects, _SCRATCH])
        if composition is None:
            raise InputError(f"the model has no place for a term of {place.balance}")
        coefficient_names = [name for names in composition.parameters.values() for name in names]
        free = tuple(dict.fromkeys([*search.data.differentiated, *coefficient_names]))
        fmu = build_source(
            composition.name, composition.text, sources, sensitivities=free, lean=True
        )
    with Simulator(fmu) as simulator:
        simulator.most_steps = CRITERIA.search.longest_run
        free_parameters = every_parameter(search.data, composition, simulator.interface)
        free_parameters = [f.starting_at(values.get(f.name, f.start)) for f in free_parameters]
        objective = Objective(simulator, search.data, search.data.fit_runs, free_parameters, values)
        z = np.array([f.to_z(f.start) for f in free_parameters])
        linear = linearised(objective, z, CRITERIA.search.rows)
        if linear is None:
            raise SimulationFailure(objective.first_failure)
        group = _groups(search, objective, rows_of_series(objective, CRITERIA.search.rows))
    slopes = dict(zip(linear.names, linear.slopes.T, strict=True))
    coefficients = composition.parameters[_SCRATCH]
    at_bound = CRITERIA.fit.at_bound * (linear.high - linear.low)
    inside = (linear.values > linear.low + at_bound) & (linear.values < linear.high - at_bound)
    slopes_of_others = [
        slopes[name]
        for name, is_free in zip(linear.names, inside, strict=True)
        if is_free and name not in coefficients and np.any(slopes[name])
    ]
    felt = {form.text: slopes[name] for form, name in zip(library, coefficients, strict=True)}
    imitated = np.column_stack([np.zeros((len(linear.residual), 0)), *slopes_of_others])
    return FeltForms(linear.residual, felt, imitated, group)


def _groups(search: Search, objective: Objective, series: NDArray[np.int_]) -> NDArray[np.intp]:
    """(m,) number of the run that each row is of; parts of it where there is a single one."""
    names = [run.name for run in search.data.fit_runs]
    run = np.array([names.index(r.name) for r, _ in objective.series])[series]
    if len(names) > 1:
        return run
    place = np.concatenate([np.arange(n) / n for n in np.bincount(series)])
    return np.asarray(place * _BLOCKS, dtype=np.intp)


__all__ = ["Description", "LearnedTerm", "learn", "try_learned"]
