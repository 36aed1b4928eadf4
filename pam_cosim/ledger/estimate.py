"""Estimates the ledger of a model on a data set.

The free parameters of the data set are estimated again with every missing term: what one of their values explains
is not missing. What is compared are explanations of the same samples by their marginal likelihood, so that a term that
may be any function of time does not win by being able to:

- the model by itself;
- the augmented model: an unknown input in each balance at once, each a random walk whose noise intensity the samples
  choose;
- where neither reaches the noise, or a balance fails that may stand for one without an unknown input
  (``Domain.confused``): the same with a law replaced by one that has an unknown input, as the library offers it.

What cannot be distinguished is found, not assumed: two unknown inputs that push every state and every signal in the
same direction at all times are one, and the ledger reports it. Not separated, and not noticed: two missing terms of one
balance; a term and what a free parameter can imitate of it (``TermSeries.imitated``). A ledger has no instruments: what
a faulty one reads is entered in the balances that it looks like.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.catalogue import domain_of
from pam_cosim.compiler import ClassTree, read_library
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import InputError
from pam_cosim.ledger.augmented import UnknownInput, augmented_models
from pam_cosim.ledger.explainer import Explainer
from pam_cosim.ledger.ledger import BalanceEntry, Ledger
from pam_cosim.ledger.smoothed_models import SmoothedModel, SmoothedModels
from pam_cosim.ledger.term_series import term_series
from pam_cosim.ledger.unaugmented import Unaugmented, unaugmented
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import is_fmu, sources_of

_NOISE_LEVEL = 1.3  # noise variances: mean square of residuals that need no explanation


def keep_ledger(
    data: DataSet,
    values: Mapping[str, float] | None = None,
    model: str | None = None,
    *,
    effects: Sequence[str] = (),
    files: Sequence[Path] = (),
    tree: ClassTree | None = None,
    deadline: float = math.inf,
) -> Ledger:
    """The ledger of ``model`` (default: the bench of the data set) with ``effects`` on all runs.

    Args:
        data: the measurement.
        values: parameters [SI], as a fit of the model found them; those under [fit] are estimated along from there.
        model: full name of a class, a bench's name, or a ``.mo`` file.
        effects: names of effects that the model has.
        files: the user's Modelica files.
        tree: the library with these files, if it was read already.
        deadline: of ``time.monotonic`` [s], after which nothing more is smoothed.

    Raises:
        TimeoutError: the deadline came first.
        InputError: an FMU, which has no balances to open; an unknown effect; points at rest, while balances are kept
            over time.
        ModelError: the model cannot be compiled.
    """
    name = data.model_for(model)
    if any(run.is_static for run in data.runs):
        raise InputError("a ledger needs recordings over time, not points at rest", data.folder)
    if is_fmu(name):
        raise InputError("a ledger needs a Modelica model: an FMU has no accessible balances", name)
    sources = sources_of(files, name)
    tree = tree or read_library(files=sources)
    models = augmented_models(tree, name, effects, files=sources)
    explainer = Explainer(data, dict(values or {}), models, domain_of(tree, name), deadline)
    return _Estimation(explainer).ledger()


class _Estimation:
    """One ledger in the making."""

    def __init__(self, explainer: Explainer) -> None:
        self.explainer = explainer
        self.data, self.models, self.domain = explainer.data, explainer.models, explainer.domain
        self.signals, self.notes = explainer.signals, explainer.notes

    def ledger(self) -> Ledger:
        """All explanations, the best of them, and the entries that it leaves."""
        base_model = self.models[0]
        problem, states = self.explainer.problem(base_model, ())
        by_itself = unaugmented(problem, states)
        augmented = self.explainer.explain(base_model, states)
        samples = int(np.isfinite(problem.grid.measured).sum())
        smoothed = [augmented.smoothed.chi2] if augmented else []
        is_open = min([by_itself.chi2, *smoothed]) / samples > _NOISE_LEVEL
        doubtful = is_open or self._is_doubtful(by_itself, augmented)
        replaced = self._replaced() if doubtful else None
        return self._judged(SmoothedModels(by_itself, augmented, replaced, samples))

    def _is_doubtful(self, by_itself: Unaugmented, augmented: SmoothedModel | None) -> bool:
        """Whether unknown inputs explain the samples, and one of them may do so for what has none."""
        return (
            augmented is not None
            and augmented.smoothed.deviance < by_itself.deviance
            and self._swallows(augmented)
        )

    def _replaced(self) -> SmoothedModel | None:
        """The best one with a law replaced by an unknown input."""
        replacements = [
            winner for winner in map(self.explainer.explain, self.models[1:]) if winner is not None
        ]
        return min(replacements, key=lambda winner: winner.smoothed.deviance, default=None)

    def _swallows(self, explanation: SmoothedModel) -> bool:
        """Whether a term is at work next to a balance without an unknown input, so that it may stand for it."""
        covered = {u.balance for u in explanation.unknown_inputs}
        neighbours = [
            u for b in self.models[1:] for u in b.unknown_inputs if u.balance not in covered
        ]
        if not neighbours:
            return False
        hiding = {row[0] for row in self.domain.confused}
        working = [u for u in explanation.unknown_inputs if u.balance in hiding]
        return any(
            explanation.without(u)[0]
            > explanation.smoothed.deviance + CRITERIA.evidence.very_strong
            for u in working
        )

    # ---- judgement --------------------------------------------------------------------------------------------

    def _judged(self, rivals: SmoothedModels) -> Ledger:
        """The ledger that the best explanation leaves."""
        winner = rivals.winner
        if rivals.is_confused:
            assert rivals.replaced is not None
            self.notes.append(self._confusion(self._replaced_balance(rivals.replaced)))
        losses = self._losses(rivals)
        failing = [
            balance for balance, loss in losses.items() if loss > CRITERIA.evidence.very_strong
        ]
        entries = self._entries(rivals, losses)
        free = tuple(winner.smoothed.point.free if winner else self.explainer.start)
        after = rivals.chi2 / rivals.samples
        return Ledger(
            model=self.data.model or self.models[0].ode.interface.model,
            entries=tuple(sorted(entries, key=lambda e: (-e.share, -e.explains, e.balance))),
            failing=tuple(sorted(failing, key=lambda balance: -losses[balance])),
            closed=bool(after <= _NOISE_LEVEL),
            before=rivals.unaugmented.chi2 / rivals.samples,
            after=float(after),
            parameters=dict(zip(self.explainer.free, map(float, free), strict=True)),
            notes=tuple(self.notes),
            domain=self.domain,
        )

    def _confusion(self, balance: str) -> str:
        """The message where a law replaced by an unknown input in ``balance`` explains as much."""
        sentence = next(
            (words for _, hidden, words in self.domain.confused if hidden == balance), None
        )
        return (
            sentence
            or f"a law that leaves the balance of {balance} open explains the samples as well"
        )

    def _losses(self, rivals: SmoothedModels) -> dict[str, float]:
        """What the best explanation loses without each of its balances."""
        best, winner, deviances = rivals.best, rivals.winner, rivals.deviances
        second = min(deviance for name, deviance in deviances.items() if name != best)
        if winner is None:
            return {}
        losses = {
            u.balance: max(winner.without(u)[0] - winner.smoothed.deviance, 0.0)
            for u in winner.unknown_inputs
        }
        if winner.augmented.replaced:  # the law that was replaced counts too
            alone = len(winner.unknown_inputs) == 1
            winner_balance = (
                winner.unknown_inputs[-1].balance if alone else self._replaced_balance(winner)
            )
            losses[winner_balance] = max(losses.get(winner_balance, 0.0), second - deviances[best])
        return losses

    def _replaced_balance(self, winner: SmoothedModel) -> str:
        before = {u.parameter for u in self.models[0].unknown_inputs}
        return next(u.balance for u in winner.augmented.unknown_inputs if u.parameter not in before)

    def _entries(self, rivals: SmoothedModels, losses: Mapping[str, float]) -> list[BalanceEntry]:
        """An entry for each balance: what it explains, its part of the loss, and the term over time."""
        total = sum(losses.values())
        shares = {balance: loss / total for balance, loss in losses.items()} if total else {}
        entries = self._alone(rivals, shares)
        best_model = rivals.winner or rivals.augmented
        if best_model is not None:
            for unknown_input in best_model.unknown_inputs:
                old = entries.get(unknown_input.balance) or BalanceEntry(
                    unknown_input.balance, 0.0, 0.0, 0.0
                )
                entries[unknown_input.balance] = self._with_terms(old, best_model, unknown_input)
        return list(entries.values())

    @staticmethod
    def _alone(rivals: SmoothedModels, shares: Mapping[str, float]) -> dict[str, BalanceEntry]:
        """What an unknown input in each balance explains by itself; in the place of a law, where it explains more."""
        entries: dict[str, BalanceEntry] = {}
        for explanation in filter(None, (rivals.augmented, rivals.replaced)):
            for unknown_input in explanation.unknown_inputs:
                balance = unknown_input.balance
                if balance in entries and explanation is not rivals.replaced:
                    continue
                deviance, chi2 = explanation.with_only(unknown_input)
                entry = BalanceEntry(
                    balance,
                    float(rivals.unaugmented.deviance - deviance),
                    rivals.explained(chi2),
                    shares.get(balance, 0.0),
                    unknown_input.unit,
                    unknown_input.meaning,
                )
                if balance not in entries or entry.gain > entries[balance].gain:
                    entries[balance] = entry
        return entries

    def _with_terms(
        self, entry: BalanceEntry, model: SmoothedModel, unknown_input: UnknownInput
    ) -> BalanceEntry:
        series, units = term_series(model, unknown_input)
        return replace(
            entry,
            unit=unknown_input.unit,
            meaning=unknown_input.meaning,
            courses=series,
            units=units,
            same_as=()
            if model.augmented.replaced
            else self.explainer.same.get(unknown_input.balance, ()),
        )
