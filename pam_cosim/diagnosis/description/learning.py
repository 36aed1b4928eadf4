"""A missing term that no effect of the catalogue explains, as a short formula of the model's own variables.

The formula is a description of one measurement, not a cause: another formula of the same size may describe it as well,
and beyond the range that was measured it means nothing.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from pam_cosim.arrays import Array
from pam_cosim.catalogue import compose, effect_classes
from pam_cosim.compiler import ClassTree, read_library
from pam_cosim.diagnosis.description.learning_library import Form, forms, quantities
from pam_cosim.diagnosis.description.learning_text import MISSING, formula_text, modelica_text
from pam_cosim.diagnosis.judgement.candidate import Attempt, Candidate
from pam_cosim.diagnosis.search.trial import Trial, run_trial
from pam_cosim.errors import InputError
from pam_cosim.files import write_text
from pam_cosim.ledger import BalanceEntry, Ledger
from pam_cosim.measurement import DataSet
from pam_cosim.measurement.free_parameter import INTERVAL

_MOST_FORMS = 4  # addends; more describe the measurement and no term
LEAST_GAIN = 0.03  # of the remaining error of left-out runs, that an addend must take away
_LEAST_GAIN_OF_TERM = 0.005  # the same, of the whole term
_DESCRIBED_ERROR = 0.3  # variances of the term: mean square that is its own uncertainty
BLOCKS = 4  # parts of a single run, which replace runs in the cross-validation
_MOST_WEIGHT = 3.0  # of a sample, times that of the median, so that few samples do not dominate
_SHAPE_SPAN = 3.0  # factor up and down, within which the shape number of a form is sought

_INTERVAL = 2 * INTERVAL  # standard deviations in the interval of an estimate


@dataclass(frozen=True)
class FittedAddend:
    """One addend: coefficient [unit of the term] with its standard deviation, times a form.

    Attributes:
        reach: size of the coefficient by which its bounds are set; 0: its own.
    """

    coefficient: float
    deviation: float
    form: Form
    reach: float = 0.0


@dataclass(frozen=True)
class LearnedTerm:
    """A missing term as a formula.

    Attributes:
        name: of the Modelica class.
        balance: in which it acts.
        formula: for a person, with numbers and units.
        modelica_source: an effect class that composes and refits like any other; family "learned".
        unit: of the term.
        terms: the addends.
        score: part of the missing term's mean square that the formula explains in runs that were not asked for it.
        fit_score: the same in the runs that were.
        parameters: by how much the free parameters of the model are off, as far as the term shows it [SI].
    """

    json_keys = "name balance formula unit score fit_score parameters modelica=modelica_source"

    name: str
    balance: str
    formula: str
    modelica_source: str
    unit: str
    terms: tuple[FittedAddend, ...]
    score: float
    fit_score: float
    parameters: dict[str, float]

    def __str__(self) -> str:
        return f"{self.formula}  (explains {100 * self.score:.0f} % in runs that were not asked)"


def learn(ledger: Ledger, tree: ClassTree | None = None) -> LearnedTerm:
    """Describes the missing term of the balance that fails most by a sparse formula.

    Forms are added one at a time, each time the one that lowers the error most in runs left out; the free
    parameters of the model may move along by what the term shows of them.

    Raises:
        InputError: the ledger has no such term: nothing fails, or an instrument does.
    """
    failing = map(ledger.entry, ledger.failing)
    entry = next((e for e in failing if e and e.courses), None)
    if entry is None:
        raise InputError("there is no missing term to learn")
    samples = _samples(entry)
    known = quantities(samples.variables, entry.units)
    picked = select_forms(samples, forms(known))
    fitted = coefficients_of(samples, picked)
    return described(entry, fitted.terms, samples, fitted, tree or read_library())


def described(
    entry: BalanceEntry,
    terms: tuple[FittedAddend, ...],
    samples: TermSamples,
    fitted: FittedForms,
    library: ClassTree,
    *origin: str,
) -> LearnedTerm:
    """The term with its formula and its class, named after its balance; ``origin`` as in ``modelica_text``."""
    name = f"Learned{entry.balance.capitalize()}"
    return LearnedTerm(
        name=name,
        balance=entry.balance,
        formula=formula_text(entry, terms),
        modelica_source=modelica_text(library, name, entry, terms, fitted.score, *origin),
        unit=entry.unit,
        terms=terms,
        score=fitted.score,
        fit_score=fitted.fit_score,
        parameters=dict(zip(samples.free, fitted.free.tolist(), strict=True)),
    )


def try_learned(
    term: LearnedTerm,
    data: DataSet,
    folder: Path,
    model: str | None = None,
    *,
    effects: Sequence[str] = (),
    start: Mapping[str, float] | None = None,
    files: Sequence[Path] = (),
) -> Attempt:
    """Writes the class into ``folder``, composes the model with it and refits: a candidate like any other.

    Args:
        term: what was learned.
        data: the measurement, with noise levels.
        folder: where the class goes, as ``<name>.mo``.
        model: default the bench of the data set.
        effects: names of effects that the model has already.
        start: values to start from [SI].
        files: the user's Modelica files.

    Raises:
        InputError: the term finds no place in the model (NoPlace).
    """
    file = folder / f"{term.name}.mo"
    write_text(file, term.modelica_source)
    sources = [*files, file]
    tree = read_library(files=sources)
    base = data.model_for(model)
    composition = compose(tree, base, [*effects, term.name], files=sources)
    effect = next(e for e in effect_classes(tree) if e.file == file)
    names = (*effects, term.name)
    return run_trial(Trial(effect, names, composition, data, dict(start or {}), tuple(sources)))


def refitted(
    term: LearnedTerm,
    entry: BalanceEntry,
    model: Candidate,
    tree: ClassTree,
    explained: str = MISSING,
) -> LearnedTerm:
    """The term with the values that ``try_learned`` fitted.

    Args:
        term: what was learned.
        entry: of the ledger, that it was learned from.
        model: the model with it.
        tree: the Modelica library.
        explained: what its score is a part of.
    """
    values = {name.rpartition(".")[2]: e for name, e in model.parameters.items()}
    terms = []
    for i, t in enumerate(term.terms, 1):
        shape = t.form.shape
        if shape is not None and (scale := values.get(f"s_{i}")) is not None:
            shape = replace(shape, value=scale.value)
        own = values[f"c_{i}"]
        deviation = (own.high - own.low) / _INTERVAL if own.determined else t.deviation
        terms.append(FittedAddend(own.value, deviation, replace(t.form, shape=shape), t.reach))
    return replace(
        term,
        terms=tuple(terms),
        formula=formula_text(entry, terms),
        modelica_source=modelica_text(tree, term.name, entry, terms, term.score, explained),
    )


# ---- samples ----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class TermSamples:
    """The missing term (n,) in standard deviations, and what it may depend on.

    Attributes:
        value: the term over its deviation; ``weight`` one over the deviation.
        variables: (n,) each [SI].
        group: (n,) number of the run (or part of it) that a sample belongs to.
        learning_groups: numbers of the groups to learn from.
        imitated: (n, Q) what the free parameters do, times the weight.
    """

    value: Array
    weight: Array
    variables: dict[str, Array]
    group: NDArray[np.intp]
    learning_groups: tuple[int, ...]
    imitated: Array
    free: tuple[str, ...]

    def column(self, form: Form, shape: float | None = None) -> Array:
        """What an addend of this form, with the coefficient 1, explains of the values."""
        return form.values(self.variables, shape) * self.weight


def _samples(entry: BalanceEntry) -> TermSamples:
    courses = entry.courses
    group, roles, count = [], [], 0
    single = sum(c.role == "fit" for c in courses) == 1
    for c in courses:
        parts = BLOCKS if single and c.role == "fit" else 1
        group.append(count + np.arange(len(c.time)) * parts // len(c.time))
        roles += [c.role] * parts
        count += parts
    deviation = np.concatenate([c.deviation for c in courses])
    free = tuple(courses[0].imitated)
    imitated = np.concatenate(
        [np.column_stack([np.zeros((len(c.time), 0)), *c.imitated.values()]) for c in courses]
    )
    used = np.any(imitated != 0, axis=0)
    weight = 1 / np.maximum(deviation, np.median(deviation) / _MOST_WEIGHT)
    return TermSamples(
        value=np.concatenate([c.value for c in courses]) * weight,
        weight=weight,
        variables={n: np.concatenate([c.against[n] for c in courses]) for n in courses[0].against},
        group=np.concatenate(group),
        learning_groups=tuple(i for i, r in enumerate(roles) if r == "fit") or tuple(range(count)),
        imitated=imitated[:, used] * weight[:, None],
        free=tuple(n for n, u in zip(free, used.tolist(), strict=True) if u),
    )


# ---- selection --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class FittedForms:
    """Forms with coefficients, standard deviations of these, and what the free parameters do beside them.

    Attributes:
        score: part of the mean square that the forms explain, in groups that they were not learned from, of what the
            free parameters alone leave; ``fit_score``: in those that they were.
        left: the mean square that the forms leave in groups that they were not learned from.
    """

    forms: tuple[Form, ...]
    coefficients: Array
    deviations: Array
    free: Array
    score: float
    fit_score: float
    left: float

    @property
    def terms(self) -> tuple[FittedAddend, ...]:
        """The addends."""
        return tuple(
            FittedAddend(float(c), float(d), f)
            for c, d, f in zip(self.coefficients, self.deviations, self.forms, strict=True)
        )


def select_forms(samples: TermSamples, library: Sequence[Form]) -> list[Form]:
    """At most ``_MOST_FORMS``, in order of selection."""
    picked: list[Form] = []
    left = first = _cross_validation_error(samples, [])
    while len(picked) < _MOST_FORMS and left > _DESCRIBED_ERROR:
        best, error = _best_next_form(samples, picked, library)
        if not _is_worthwhile(left, error, first):
            break
        picked += best
        left = error
    return [f for i, f in enumerate(picked) if _is_needed(samples, picked, i, left)]


def select_forms_jointly(samples: TermSamples, library: Sequence[Form], most: int) -> list[Form]:
    """As ``select_forms``, for forms that mean little alone: where no further one helps, two are added at once."""
    picked: list[Form] = []
    left = first = _cross_validation_error(samples, [])
    columns = {f.text: samples.column(f) for f in library}
    while len(picked) < most and left > _DESCRIBED_ERROR:
        own = [columns[f.text] for f in picked]
        others = [f for f in library if f not in picked]
        steps: list[tuple[Form, ...]] = [(f,) for f in others]
        for further in (steps, list(combinations(others, 2))):
            errors = [
                _cross_validation_error(samples, [*own, *(columns[f.text] for f in one)])
                for one in further
            ]
            error = min(errors, default=np.inf)
            if _is_worthwhile(left, error, first):
                picked += further[int(np.argmin(errors))]
                left = error
                break
        else:
            break
    return [f for i, f in enumerate(picked) if _is_needed(samples, picked, i, left)]


def _is_worthwhile(left: float, error: float, first: float) -> bool:
    return error < (1 - LEAST_GAIN) * left and left - error > _LEAST_GAIN_OF_TERM * first


def _best_next_form(
    samples: TermSamples, picked: Sequence[Form], library: Sequence[Form]
) -> tuple[list[Form], float]:
    """The form that helps most beside others, with its best shape, and what is left; none where all are picked."""
    columns = [samples.column(f) for f in picked]
    left = [f for f in library if f not in picked]
    if not left:
        return [], math.inf
    errors = [_cross_validation_error(samples, [*columns, samples.column(f)]) for f in left]
    best = _with_best_shape(samples, picked, left[int(np.argmin(errors))])
    return [best], _cross_validation_error(samples, [*columns, samples.column(best)])


def _is_needed(samples: TermSamples, picked: Sequence[Form], i: int, left: float) -> bool:
    others = [samples.column(f) for k, f in enumerate(picked) if k != i]
    return len(picked) == 1 or _cross_validation_error(samples, others) > (1 + LEAST_GAIN) * left


def _with_best_shape(samples: TermSamples, picked: Sequence[Form], form: Form) -> Form:
    """The form with the best value of its shape."""
    shape = form.shape
    if shape is None:
        return form
    own = [samples.column(f) for f in picked]

    def error(z: float) -> float:
        return _cross_validation_error(samples, [*own, samples.column(form, float(np.exp(z)))])

    bounds = (
        np.log(max(shape.low, shape.value / _SHAPE_SPAN)),
        np.log(min(shape.high, shape.value * _SHAPE_SPAN)),
    )
    optimum = minimize_scalar(
        error, bounds=bounds, method="bounded", options={"xatol": 0.01, "maxiter": 25}
    )
    return replace(form, shape=replace(shape, value=float(np.exp(optimum.x))))


def _cross_validation_error(samples: TermSamples, columns: Sequence[Array]) -> float:
    """Mean square of the term over its deviation in each asked group, predicted from the others."""
    rows = np.column_stack([samples.imitated, *columns])
    total, count = 0.0, 0
    moments = {}
    for g in samples.learning_groups:
        at = samples.group == g
        moments[g] = (
            rows[at].T @ rows[at],
            rows[at].T @ samples.value[at],
            float(samples.value[at] @ samples.value[at]),
        )
        count += int(at.sum())
    everything = sum(m[0] for m in moments.values())
    target = sum(m[1] for m in moments.values())
    for g in samples.learning_groups:
        own, right, square = moments[g]
        solution = _regularised_solution(everything - own, target - right)
        total += square - 2 * float(right @ solution) + float(solution @ own @ solution)
    return total / count


def _regularised_solution(matrix: Array, right: Array) -> Array:
    if not len(right):
        return right
    size = np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    scaled = matrix / np.outer(size, size) + 1e-9 * np.eye(len(right))
    solution: Array = np.linalg.solve(scaled, right / size) / size
    return solution


def coefficients_of(samples: TermSamples, picked: Sequence[Form]) -> FittedForms:
    """The forms with least squares of the learning groups, and what they explain beyond the free parameters alone."""
    columns = [samples.column(f) for f in picked]
    rows = np.column_stack([np.zeros((len(samples.value), 0)), samples.imitated, *columns])
    q = samples.imitated.shape[1]
    fitted = np.isin(samples.group, samples.learning_groups)

    def solve(kept: NDArray[np.bool_], of: Array = rows) -> Array:
        return _regularised_solution(of[kept].T @ of[kept], of[kept].T @ samples.value[kept])

    solution, without_forms = solve(fitted), solve(fitted, samples.imitated)
    # left-out groups show how far the coefficients can be trusted (jackknife: Efron and Tibshirani 1993)
    each = np.array([solve(fitted & (samples.group != g)) for g in samples.learning_groups])
    n = len(samples.learning_groups)
    deviation = np.sqrt((n - 1) / n * ((each - each.mean(axis=0)) ** 2).sum(axis=0))

    def mean_squares(kept: NDArray[np.bool_]) -> tuple[float, float]:
        """With the forms, and with the free parameters alone."""
        errors = samples.value - rows @ solution, samples.value - samples.imitated @ without_forms
        return float(np.mean(errors[0][kept] ** 2)), float(np.mean(errors[1][kept] ** 2))

    others = ~fitted
    if others.any():
        left, before = mean_squares(others)
    else:
        left, before = (_cross_validation_error(samples, of) for of in (columns, []))
    left_fitted, before_fitted = mean_squares(fitted)
    return FittedForms(
        tuple(picked),
        solution[q:],
        deviation[q:],
        solution[:q],
        1 - left / before,
        1 - left_fitted / before_fitted,
        left,
    )


__all__ = ["FittedAddend", "LearnedTerm", "learn", "refitted", "try_learned"]
