"""From a measurement and a model to the effect that is missing."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from pam_cosim.compiler import ClassTree, EffectClass, compose, effect_classes, read_library
from pam_cosim.diagnosis.candidate import Candidate, role_summary
from pam_cosim.diagnosis.evidence import convincing, leading, leaves_structure, rank, structured
from pam_cosim.diagnosis.missing_term import missing_term
from pam_cosim.diagnosis.next_experiment import Plan, told_apart
from pam_cosim.diagnosis.trial import Trial, crashed, run_trial
from pam_cosim.diagnosis.verdict import Verdict, explained, judge, rivals
from pam_cosim.diagnosis.workers import run_tasks
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fitting import Fit, complete_noise, fit
from pam_cosim.fmu import build_model
from pam_cosim.measurement import DataSet
from pam_cosim.quantities import readable
from pam_cosim.simulation import Simulator

_MOST_EFFECTS = 3


@dataclass(frozen=True)
class Diagnosis:
    """Everything a diagnosis found.

    Attributes:
        data: the measurement, with the noise levels that were used.
        model: the base model.
        base: the base model, refitted.
        candidates: every model that was tried, best first, judged against the base model.
        path: the effects that were added, in order, as candidates.
        balance: share of the explainable error by balance (force, mass, energy, sensor).
        verdict: the answer.
        next_experiment: for an ambiguous verdict, the run that would decide.
        missing_term: for an unknown verdict, a description of what is left.
    """

    data: DataSet
    model: str
    base: Fit
    candidates: tuple[Candidate, ...]
    path: tuple[Candidate, ...]
    balance: dict[str, float]
    verdict: Verdict
    next_experiment: dict[str, object] | None = None
    missing_term: dict[str, object] | None = None

    @property
    def final(self) -> Fit:
        """The base model with all effects that were added, fitted."""
        last = self.path[-1].fit if self.path else None
        return last or self.base

    def as_dict(self) -> dict[str, object]:
        """Plain data for JSON, SI units."""
        base = role_summary(self.base, "fit") or {}
        base |= {"holdout": role_summary(self.base, "holdout"), "model": self.model}
        base["parameters"] = {n: e.as_dict() for n, e in self.base.parameters.items()}
        return {
            "title": self.data.title,
            "base": base,
            "where": [vars(r) for r in self.base.comparison.where],
            "balance": self.balance,
            "candidates": [c.as_dict() for c in self.candidates],
            "verdict": self.verdict.as_dict(),
            "next_experiment": self.next_experiment,
            "missing_term": self.missing_term,
        }

    def __str__(self) -> str:
        v = self.verdict
        what = f": {' and '.join(v.families)} ({', '.join(v.effects)})" if v.families else ""
        lines = [f"Verdict: {v.kind}{what}", f"  {v.reason}"]
        for role in ("fit", "holdout"):
            for name, before in self.base.comparison.scores[role].items():
                after = self.final.comparison.scores[role][name]
                unit = self.data.signals[name].unit
                noise = readable(before.noise_rmse, unit)
                lines.append(
                    f"  {role:8} {name:4} rms error {readable(before.rmse, unit)} -> {readable(after.rmse, unit)}"
                    f" (noise {noise})"
                )
        lines += [f"  {n} = {e}" for n, e in self.final.parameters.items()]
        return "\n".join(lines)


def describe_fit(found: Fit) -> str:
    """Root mean square errors of a fit in units a person reads."""
    scores = found.comparison.scores["fit"]
    signals = found.comparison.data.signals
    return ", ".join(f"{n} {readable(s.rmse, signals[n].unit)}" for n, s in scores.items())


def diagnose(
    data: DataSet,
    model: str | None = None,
    *,
    files: Sequence[Path] = (),
    say: Callable[[str], None] = lambda text: None,
    workers: int | None = None,
) -> Diagnosis:
    """Refits the base model, tries every effect that fits it, adds what pays, and judges.

    Args:
        data: the measurement.
        model: the base model; default the bench of the data set.
        files: further Modelica files, whose effects are tried too.
        say: told what happens, line by line.
        workers: number of processes.

    Raises:
        InputError: the model cannot be compiled, or lacks a parameter that is to be fitted.
        SimulationFailure: the base model cannot be simulated at all.
    """
    data = complete_noise(data)
    name = model or data.model
    if name.endswith(".fmu"):
        raise InputError("effects can be added to a Modelica model only; an FMU can be compared and fitted", name)
    tree = read_library(files=_sources(name, files))
    with Simulator(build_model(name, files, sensitivities=tuple(data.fit), where_smooth=True)) as simulator:
        base = fit(simulator, data)
    say(f"base model refitted: rms error {describe_fit(base)}, chi2 {base.comparison.chi2_reduced('fit'):.4g}")
    shelf = effect_classes(tree)
    path: list[Candidate] = []
    tried: list[Candidate] = []
    others: list[Plan] = []
    present = base
    while len(path) < _MOST_EFFECTS and (not path or any(leaves_structure(s) for s in present.structure.values())):
        trials = _trials(tree, name, shelf, path, data, present, files)
        found = run_tasks(run_trial, trials, crashed, lambda c: say(_line(c)), workers)
        if found and all(c.fit is None for c in found):
            raise SimulationFailure(f"no effect could be tried; {found[0].effect}: {found[0].failure}")
        ranked = rank(present, found)
        tried += ranked
        if not ranked or not any(structured(s) for s in present.structure.values()):
            break  # many samples make the smallest difference of two programs significant: noise needs no effect
        if not convincing(present, best := leading(ranked)):
            break
        assert best.fit is not None
        path.append(best)
        others = told_apart(data, best, rivals(best, ranked), _sources(name, files))
        present = best.fit
        say(f"added {best.effect} ({best.family}): rms error {describe_fit(present)}")
    verdict = judge(base, path, [c for c, _ in others])
    balance = _balance(base, tried[: len(trials)])
    return Diagnosis(
        data=data,
        model=name,
        base=base,
        candidates=tuple(rank(base, tried)),
        path=tuple(path),
        balance=balance,
        verdict=verdict,
        next_experiment=others[0][1] if others else None,
        missing_term=missing_term(present, balance) if verdict.kind == "unknown" else None,
    )


def _sources(model: str, files: Sequence[Path]) -> list[Path]:
    return [*files, Path(model)] if model.endswith(".mo") else list(files)


def _trials(
    tree: ClassTree,
    model: str,
    shelf: Sequence[EffectClass],
    path: Sequence[Candidate],
    data: DataSet,
    present: Fit,
    files: Sequence[Path],
) -> list[Trial]:
    taken = {c.family for c in path}
    added = [c.effect for c in path]
    sources = tuple(_sources(model, files))
    trials = []
    for effect in shelf:
        if effect.family in taken:
            continue
        names = (*added, effect.name)
        composition = compose(tree, model, names, files=sources)
        if composition is not None:
            trials.append(Trial(effect, names, composition, data, present.values, sources))
    return trials


def _line(c: Candidate) -> str:
    if c.fit is None:
        return f"  {c.effect} ({c.family}): could not be fitted: {c.failure}"
    return (
        f"  {c.effect} ({c.family}): rms error {describe_fit(c.fit)}, chi2 {c.fit.comparison.chi2_reduced('fit'):.4g}"
    )


def _balance(base: Fit, candidates: Sequence[Candidate]) -> dict[str, float]:
    """Share of each balance in what its best effect explains of the error beyond the noise."""
    gains: dict[str, float] = {}
    for c in candidates:
        if c.fit is not None:
            gains[c.balance] = max(gains.get(c.balance, 0.0), explained(base, c.fit), 0.0)
    total = sum(gains.values())
    return {b: g / total for b, g in sorted(gains.items())} if total > 0 else dict.fromkeys(sorted(gains), 0.0)
