"""From a measurement and a model to the effect that is missing."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from pam_cosim.catalogue import EffectClass
from pam_cosim.comparison import Convention, RunComparison, likely_convention, simulate_runs
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.description.explanation import (
    LearnedModel,
    described,
    disagreement,
    ledger_of,
    remaining_chi2,
)
from pam_cosim.diagnosis.judgement.candidate import Candidate, FailedTrial, role_summary
from pam_cosim.diagnosis.judgement.events import (
    Judged,
    LedgerKept,
    Listener,
    Remark,
    listened,
)
from pam_cosim.diagnosis.judgement.evidence import leaves_structure, rank
from pam_cosim.diagnosis.judgement.fitted_models import FittedModels
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.judgement.missing_term import MissingTerm, missing_term
from pam_cosim.diagnosis.judgement.model_space import effects_named
from pam_cosim.diagnosis.judgement.next_experiment import (
    NextExperiment,
    RivalPlan,
    distinguishable_rivals,
)
from pam_cosim.diagnosis.judgement.verdict import Verdict, explained, judge
from pam_cosim.diagnosis.judgement.verdict_sentences import verdict_lines
from pam_cosim.diagnosis.search.effort import Effort
from pam_cosim.diagnosis.search.folds import folds_of
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.search_result import SearchResult
from pam_cosim.diagnosis.search.searches import fit_base_model, with_effects
from pam_cosim.diagnosis.search.selection import select_effects
from pam_cosim.diagnosis.search.subject import subject_of
from pam_cosim.errors import InputError
from pam_cosim.exports import Columns, Tabular
from pam_cosim.files import plain_fields
from pam_cosim.fitting import Fit, FitOptions, base_parameters, fit
from pam_cosim.ledger import Ledger
from pam_cosim.measurement import ROLES, DataSet, error_in
from pam_cosim.problems import corrections_of
from pam_cosim.processes.workers import on_one_thread
from pam_cosim.simulation import AnySimulator
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, listed, look_first


@dataclass(frozen=True)
class Diagnosis(Printed, Tabular):
    """Everything a diagnosis found.

    Attributes:
        data: the measurement, with the noise levels that were used.
        model: the base model.
        base: the base model, refitted.
        candidates: every model that was tried, best first, judged against the base model.
        path: the effects that were added, in order, as candidates.
        balance: share of the explainable error by balance.
        verdict: the answer.
        failed: the effects that could not be fitted.
        outliers: how many single samples were set aside, by signal.
        next_experiment: for an ambiguous verdict, the run that would decide.
        missing_term: for a verdict that leaves structure, a description of it.
        ledger: which balances of the base model fail, with the missing terms as signals; None where nothing does.
        learned: likewise, a formula for what is missing and the model with it: a description, no cause.
        untried: effects of the models that promised to be better when a limit ended the search.
        simulations: runs that were simulated until the verdict stood, with sensitivities or without.
        not_tried: families that were not looked for, with the reason.
        means: where very many rows became means, which are in ``data``: a sentence on it.
        rivals: effects of each model that is left, best first: of an ambiguous verdict those that it names, of an
            unknown one those that come nearest; see ``rival_models``.
        convention: which other convention of the logger fits much better, in words, and what to write: everything here
            is judged by the data as it has them; "": those that the data are read with.
    """

    json_keys = (
        "title=data.title convention? base=_base where=base.comparison.where balance candidates=_candidates "
        "verdict final=_final folds=verdict.folds doubts=final.comparison.doubts outliers rivals "
        "next_experiment missing_term=_missing untried simulations not_tried ledger=_ledger disagreement"
    )

    data: DataSet
    model: str
    base: Fit
    candidates: tuple[Candidate, ...]
    path: tuple[Candidate, ...]
    balance: dict[str, float]
    verdict: Verdict
    failed: tuple[FailedTrial, ...] = ()
    outliers: dict[str, int] = field(default_factory=dict)
    next_experiment: NextExperiment | None = None
    missing_term: MissingTerm | None = None
    ledger: Ledger | None = None
    learned: LearnedModel | None = None
    untried: tuple[tuple[str, ...], ...] = ()
    simulations: int = 0
    not_tried: dict[str, str] = field(default_factory=dict)
    means: str = ""
    rivals: tuple[tuple[str, ...], ...] = ()
    convention: str = ""

    @property
    def rival_models(self) -> tuple[Candidate, ...]:
        """The models that are left, best first; none where the verdict leaves no choice."""
        candidates_by_effects = {c.effects: c for c in (*reversed(self.candidates), *self.path)}
        return tuple(
            candidates_by_effects[effects]
            for effects in self.rivals
            if effects in candidates_by_effects
        )

    @property
    def final(self) -> Fit:
        """The base model with all effects that were added, fitted."""
        return self.path[-1].fit if self.path else self.base

    @property
    def disagreement(self) -> str:
        """A sentence where the ledger fails elsewhere than the verdict's effects act; "" where they agree."""
        return disagreement(self.path, self.ledger)

    @property
    def not_tried_by_reason(self) -> dict[str, list[str]]:
        """The families that were not looked for, by reason, in their order."""
        families: dict[str, list[str]] = {}
        for family, why in self.not_tried.items():
            families.setdefault(why, []).append(family)
        return families

    @property
    def changes_of_data(self) -> tuple[str, ...]:
        """What was changed in the samples before models were judged by them, in sentences."""
        outliers = (
            f"{n} single {'samples' if n > 1 else 'sample'} of {name} {'are' if n > 1 else 'is'} set aside"
            for name, n in self.outliers.items()
            if n
        )
        return tuple(filter(None, [self.convention, *outliers, self.means]))

    def frame_columns(self) -> Columns:
        """A row for each candidate, best first; ``final.to_frame()`` has the parameters."""
        candidates = self.candidates
        return {
            "effects": ([" + ".join(c.effects) for c in candidates], None),
            "family": ([c.family for c in candidates], None),
            "balance": ([c.balance for c in candidates], None),
            **{
                f"chi2_{role}": ([c.fit.comparison.chi2_reduced(role) for c in candidates], "")
                for role in ROLES
            },
            "delta_bic": ([c.delta_bic for c in candidates], ""),
            "probability": ([c.probability for c in candidates], ""),
        }

    @property
    def _base(self) -> dict[str, object]:
        return (role_summary(self.base, "fit") or {}) | {
            "holdout": role_summary(self.base, "holdout"),
            "model": self.model,
            "parameters": self.base.parameters,
        }

    @property
    def _candidates(self) -> list[Candidate | FailedTrial]:
        return [*self.candidates, *self.failed]

    @property
    def _ledger(self) -> dict[str, Any] | None:
        return self.ledger.as_dict(courses=False) if self.ledger else None

    @property
    def _final(self) -> dict[str, object]:
        """The model that the verdict is about: what it is made of, its values and its scores."""
        corrections = [str(c) for c in corrections_of(self.data, self.final.values_and_starts)]
        return {
            "model": self.model,
            "effects": [c.effect for c in self.path],
            "parameters": self.final.parameters,
            "constants": self.data.constants,
            **({"corrections": corrections} if corrections else {}),
            **{role: role_summary(self.final, role) for role in ROLES},
        }

    @property
    def _missing(self) -> dict[str, object] | None:
        if self.missing_term is None:
            return None
        learned = {"learned": self.learned} if self.learned else {}
        return plain_fields(self.missing_term) | learned

    def _headline(self) -> str:
        return f": {verdict_lines(self.verdict)[0]}"

    def __str__(self) -> str:
        summary, *sentences = verdict_lines(self.verdict)
        lines = [f"Verdict: {summary}"]
        doubts = [doubt.text for doubt in self.final.comparison.doubts]
        lines += look_first(filter(None, [self.convention, *doubts]))
        lines += [f"  {sentence}" for sentence in (*sentences, self.disagreement) if sentence]
        lines += self._errors()
        lines += [f"  {n} = {e}" for n, e in self.final.parameters.items()]
        if self.untried:
            first = [" + ".join(names) for names in self.untried[: CRITERIA.search.first_tried]]
            more = len(self.untried) - len(first)
            lines.append(
                f"  The search ended after {self.simulations} simulations, at a limit or since nothing fitted visibly "
                f"better for long (--simulation-limit states how many); next would have been: {', '.join(first)}"
                f"{f' and {more} more' * bool(more)}"
            )
        lines += [f"  {change}" for change in self.changes_of_data if change != self.convention]
        lines += [
            f"  not looked for: {listed(names)}: {why}"
            for why, names in self.not_tried_by_reason.items()
        ]
        if self.learned is not None:
            beside = "".join(f" and {effect}" for effect in self.learned.model.effects[:-1])
            lines.append(f"  What is missing, described (not explained): {self.learned.term}")
            lines.append(
                f"  with it{beside} the chi-square is {remaining_chi2(self.learned.model.fit):.3g}"
            )
        return "\n".join(lines)

    def _errors(self) -> list[str]:
        """A line for each signal and role: its error before and after."""
        lines = []
        for role in ROLES:
            for name, before in self.base.comparison.scores[role].items():
                signal, after = self.data.signals[name], self.final.comparison.scores[role][name]
                errors = [format_quantity(score.rmse, signal.unit) for score in (before, after)]
                noise = f"{signal.scatter} {format_quantity(before.noise_rmse, signal.unit)}"
                fitted = "" if signal.fitted else " (not fitted)"
                lines.append(
                    f"  {role:8} {name:4} rms error {errors[0]} -> {errors[1]} ({noise}){fitted}"
                )
        return lines


@on_one_thread
def diagnose(
    data: DataSet,
    model: str | None = None,
    *,
    files: Sequence[Path] = (),
    say: Callable[[Message], None] = lambda message: None,
    progress: Listener | None = None,
    workers: int | None = None,
    explain: bool = True,
    time_limit: float | None = None,
    simulation_limit: int | None = None,
    exclude: Sequence[str] = (),
    expect: Sequence[str] = (),
) -> Diagnosis:
    """Refits the base model, tries every effect that fits it, adds what pays, and judges.

    Args:
        data: the measurement.
        model: the base model; default the bench of the data set.
        files: further Modelica files, whose effects are tried too.
        say: told what happens, line by line: texts that know whether they are a headline or a result (``Message``).
        progress: told the same as data, and more that no line is printed of: an ``Event`` each.
        workers: number of processes; 0: this one alone.
        explain: whether to keep a ledger and to describe what no effect explains; the verdict is the same. Points at
            rest have no ledger.
        time_limit: [s] after which the search ends with the best verdict so far; nothing is learned of what that leaves
            then, and what is begun is finished: a fit of the answer, the ledger.
        simulation_limit: likewise, by the runs that are simulated: the same verdict however quick the machine is;
            default: ``CRITERIA.search.patience`` ends it, where no time limit is stated.
        exclude: families or effects that are known not to be missing, with those of the data set.
        expect: likewise, that are likely: the evidence for one of them need not be as strong.

    Raises:
        InputError: the model cannot be compiled, or lacks a parameter that is to be fitted; an unknown family, or one
            that is both excluded and expected.
        SimulationFailure: the base model cannot be simulated at all.
    """
    say, tell = listened(say, progress), progress or (lambda event: None)
    deadline = math.inf if time_limit is None else time.monotonic() + time_limit
    effort = Effort.of(deadline, simulation_limit)
    subject = subject_of(data, model, files, workers, say)
    library = subject.library
    with effort.counting(), subject.simulator() as simulator:
        available = subject.effects(simulator.interface)
        excluded, expected = _excluded_and_expected(available, subject.data, exclude, expect)
        data, base = fit_base_model(simulator, subject.data, say)
        convention = _convention(simulator, subject.data, base)
        if convention is not None:
            say(Remark(f"LOOK FIRST: {convention.text}; going on with that").message)
            data, base = fit_base_model(simulator, convention.data, say)
    search = Search(
        library,
        subject.name,
        [e for e in available if e.name not in excluded],
        data,
        subject.sources,
        say,
        workers,
        expected=expected,
        effort=effort,
        recorded=convention.data if convention else subject.data,
    )
    result = select_effects(search, base)
    verdict, plans = _verdict(result, subject.sources)
    if verdict.leaves_structure and result.path and not effort.spent:
        folds = folds_of(subject, result.search, result.path[-1].effects, result.last)
        if folds is not None:
            result = with_effects(result, folds.named)
            verdict, plans = _verdict(result, subject.sources)
            verdict = replace(verdict, folds=folds)
    search, base, simulations = result.search, result.base, effort.simulations
    candidates = tuple(rank(base, result.tried))
    tell(Judged(verdict, base, candidates, result.path))
    ledger = _ledger_of_base(search, base, verdict, tell) if explain else None
    learned = None
    if explain and verdict.leaves_structure and not effort.spent:
        effects = [c.effect for c in result.path]
        learned = described(search, ledger, base, effects, result.last)
    balance = _balance(base, [c for c in result.tried if len(c.effects) == 1])
    return Diagnosis(
        data=search.data,
        model=subject.name,
        base=base,
        candidates=candidates,
        path=result.path,
        balance=balance,
        verdict=verdict,
        failed=tuple(search.failed),
        outliers=result.search.outliers,
        next_experiment=plans[0][1] if plans else None,
        missing_term=missing_term(result.last, balance) if verdict.leaves_structure else None,
        ledger=ledger,
        learned=learned,
        untried=result.untried,
        simulations=simulations,
        not_tried=_not_tried(available, excluded, result),
        means=subject.means,
        rivals=_models_left(verdict, result, [c for c, _ in plans]),
        convention=convention.text if convention else "",
    )


def _convention(simulator: AnySimulator, data: DataSet, base: Fit) -> Convention | None:
    """The convention of the logger with which the base model fits much better; None where it leaves nothing anyway."""
    if not leaves_structure(base):
        return None
    free = [
        replace(f, start=base.values[f.name]) for f in base_parameters(data, simulator.interface)
    ]

    def fitted(other: DataSet) -> Sequence[RunComparison]:
        runs = {"", *(run.name for run in other.runs)}
        free_of_runs = [f for f in free if f.run in runs]
        return fit(simulator, other, free_of_runs, options=FitOptions(rules=False)).comparison.runs

    simulated = partial(simulate_runs, simulator, values=base.values_and_starts)
    return likely_convention(
        data, base.comparison.units, simulated, base.comparison.runs, fitted if free else None
    )


def _models_left(
    verdict: Verdict, models: FittedModels, rivals: Sequence[Candidate]
) -> tuple[tuple[str, ...], ...]:
    """Effects of the models that a verdict leaves, best first."""
    if verdict.kind == "ambiguous":
        return (models.path[-1].effects, *(c.effects for c in rivals))
    return tuple(c.effects for c in models.nearest) if verdict.kind == "unknown" else ()


def _verdict(result: SearchResult, sources: Sequence[Path]) -> tuple[Verdict, list[RivalPlan]]:
    """The verdict, and the rivals with the run that would decide where either may be right."""
    plans: list[RivalPlan] = []
    if result.path and leaves_structure(result.last):
        plans = [(c, None) for c in result.rivals]
    elif result.path:
        plans = distinguishable_rivals(result.search.data, result.path[-1], result.rivals, sources)
    return judge(result, [c for c, _ in plans]), plans


def _excluded_and_expected(
    available: Sequence[EffectClass],
    data: DataSet,
    exclude: Sequence[str],
    expect: Sequence[str],
) -> tuple[frozenset[str], frozenset[str]]:
    """The effects that cannot be missing and those that are likely, by the data set and by the caller.

    Raises:
        InputError: an unknown name, or one that is both excluded and expected.
    """
    stated = {"exclude": data.excluded, "expect": data.expected}
    names = {"exclude": [*data.excluded, *exclude], "expect": [*data.expected, *expect]}

    def error(key: str, name: str, message: str) -> InputError:
        if name in stated[key]:
            return error_in(data.folder, message, "effects", key)
        return InputError(message)

    def effects(key: str) -> frozenset[str]:
        named_effects = frozenset[str]()
        for name in names[key]:
            try:
                named_effects |= effects_named(available, name)
            except ValueError as problem:
                raise error(key, name, f"{key}: {problem}") from None
        return named_effects

    excluded, expected = effects("exclude"), effects("expect")
    for name in names["expect"]:
        members = effects_named(available, name)
        if name in names["exclude"] or (members and members <= excluded):
            text = f"{name} is both excluded, as not missing, and expected, as likely; keep one of them"
            raise error("expect" if name in data.expected else "exclude", name, text)
    return excluded, expected


def _ledger_of_base(search: Search, base: Fit, verdict: Verdict, tell: Listener) -> Ledger | None:
    """The ledger of the base model; None where nothing is missing, or at rest: balances are kept over time."""
    if (
        verdict.kind == "none_missing"
        or verdict.doubt
        or any(run.is_static for run in search.data.runs)
    ):
        return None
    ledger = ledger_of(search, base)
    if ledger is not None:
        tell(LedgerKept(ledger))
    return ledger


def _not_tried(
    available: Sequence[EffectClass], excluded: Collection[str], result: SearchResult
) -> dict[str, str]:
    """Families that were not looked for, with the reason; none where nothing had to be looked for."""
    search = result.search
    probed = {search.family[p.effect] for p in result.probes}
    if not probed:
        return {}
    failed = {f.family for f in search.failed}
    families_considered = {search.family[p.effect] for p in result.probes if not p.silent}
    families_considered |= {
        search.family[name] for c in result.tried for name in c.effects if name in search.family
    }
    late = {search.family[name] for names in result.untried for name in names}
    at_rest = " at rest" if search.data.is_static else ""
    reasons = {}
    for family in dict.fromkeys(e.family for e in available):
        if {e.name for e in available if e.family == family} <= {*excluded}:
            reasons[family] = "excluded"
        elif family not in probed | failed:
            reasons[family] = (
                "a limit ended the search" if family in late else "the model has no place for them"
            )
        elif family in probed - families_considered:
            reasons[family] = f"no fitted signal{at_rest} shows them"
    return reasons


def _balance(base: Fit, candidates: Sequence[Candidate]) -> dict[str, float]:
    """Share of each balance in what its best effect explains of the error beyond the noise."""
    gains: dict[str, float] = {}
    for c in candidates:
        gains[c.balance] = max(gains.get(c.balance, 0.0), explained(base, c.fit), 0.0)
    total = sum(gains.values())
    return {b: gains[b] / total if total > 0 else 0.0 for b in sorted(gains)}
