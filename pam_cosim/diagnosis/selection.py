"""Selection of the effects that a model needs: added one after another, the superfluous ones removed (stepwise)."""

from __future__ import annotations

import math
from collections.abc import Sequence

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.evidence import (
    as_good,
    clears,
    coherent,
    convincing,
    dominant_effect,
    foretold,
    leading,
    promising,
    rank,
    structured,
)
from pam_cosim.diagnosis.message import Message
from pam_cosim.diagnosis.search import Search, at_noise, describe_fit
from pam_cosim.fitting import Fit


def select_effects(search: Search, base: Fit) -> tuple[list[Candidate], list[Candidate]]:
    """The effects that are needed, in the order in which they were found, and all that were tried."""
    missing = any(coherent(s) for s in base.residuals.values())
    tried = search.round((), base, below=math.inf if missing else 0.0)
    first = _steps(base, tried) if missing else []
    if missing and (not first or (_unsolved(first[0]) and _nearly(base, first[0]))):
        first = _generalized(search, base, first, tried)
    elif first and not _unsolved(first[0]) and not at_noise(first[0].fit):
        first = _outdone(search, base, first, tried)
    selected = [first[0]] if first else []
    if first and _unsolved(first[0]):
        selected = _second(search, base, first, tried)
        if len(selected) == 1 and not _nearly(base, first[0]):
            selected = _generalized(search, base, first, tried)[:1]
        selected = _dominant(search, base, selected, tried)
    while 1 < len(selected) < CRITERIA.search.most_effects and _unsolved(selected[-1]):
        selected = _enriched(search, base, selected, tried)
        last = selected[-1]
        if not _unsolved(last):
            break
        candidates = search.round(last.effects, last.fit, tried)
        tried += candidates
        steps = _steps(last.fit, candidates)
        if not steps:
            break
        selected.append(steps[0])
        search.say(Message(f"added {_told(steps[0])}"))
    selected = _merged(search, base, _needed(search, base, selected, tried), tried)
    return (selected, tried) if selected and convincing(base, rank(base, [selected[-1]])[0]) else ([], tried)


def _nearly(base: Fit, c: Candidate) -> bool:
    """Whether an effect takes away so much that a better form of it may do the rest, rather than a second effect."""
    before, after = base.residuals["fit"], c.fit.residuals["fit"]
    return after.excess < CRITERIA.search.better_form * before.excess


def _generalized(search: Search, base: Fit, first: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The first effects, or general members of families where one of them leaves nothing.

    Those of the leading families are fitted; where no effect helps at all, those of all others too.
    """
    candidates = rank(base, search.general(base, tried))
    if not first and not any(not _unsolved(c) for c in candidates):
        candidates = rank(base, [*candidates, *search.last_resort(base, [*tried, *candidates])])
    tried += candidates
    solved = [c for c in _steps(base, candidates) if not _unsolved(c)]
    if not solved:
        return list(first)
    search.say(Message(f"in general form: {_told(solved[0])}"))
    return solved


def _outdone(search: Search, base: Fit, first: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The first effects, led by the general member of a family where that is better beyond chance.

    For a remainder above the noise that does not come again in other runs: a drift as a rule, but not always.
    """
    present = first[0].fit
    candidates = rank(base, search.general(base, tried))
    tried += candidates
    better = {c.effects for c in rank(present, candidates) if convincing(present, c)}
    return [*(c for c in candidates if c.effects in better), *first]


def _second(search: Search, base: Fit, first: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The best first effect with the best second one: of two that are missing, neither need be the best alone.

    One that is beyond doubt by itself is the only first one, and need not leave much undone then.
    """
    singles = list(tried)
    dominant = dominant_effect(base, singles)
    starts = [_plain(dominant, singles)] if dominant else first[: CRITERIA.search.first_effects]
    pairs: list[Candidate] = []
    for start in starts:
        search.say(Message(f"with {_told(start)}"))
        below = CRITERIA.search.second_leaves * start.fit.residuals["fit"].excess if dominant else math.inf
        candidates = search.round(start.effects, start.fit, singles, below=below)
        tried += candidates
        pairs += _steps(start.fit, candidates)[:1]
        if pairs and not _unsolved(pairs[-1]):
            break
    if not pairs:
        return [starts[0]]
    best = rank(base, pairs)[0]
    chosen = next(p for p in pairs if p.effects == best.effects)
    search.say(Message(f"added {_told(chosen)}"))
    return [next(c for c in starts if c.effects == chosen.effects[:1]), chosen]


def _plain(one: Candidate, singles: Sequence[Candidate]) -> Candidate:
    """The best law of the same family, where a general member does not take away most of what that leaves."""
    laws = [c for c in singles if c.family == one.family and not c.general]
    law = min(laws, key=lambda c: c.fit.residuals["fit"].excess, default=one)
    return law if one.general and not _nearly(law.fit, one) else one


def _dominant(search: Search, base: Fit, selected: list[Candidate], tried: Sequence[Candidate]) -> list[Candidate]:
    """The selection, or the one effect beyond doubt where a second one does not take away most of what that leaves."""
    last, dominant = selected[-1], dominant_effect(base, tried)
    if dominant is None or not _unsolved(last) or (len(selected) > 1 and _nearly(selected[0].fit, last)):
        return selected
    search.say(Message(f"no second effect explains what is left by {_told(dominant)}"))
    return [dominant]


def _steps(present: Fit, candidates: Sequence[Candidate]) -> list[Candidate]:
    """Effects worth adding, the leading one first, one of each family."""
    order = [leading(candidates), *candidates] if any(c.fit for c in candidates) else []
    best: dict[str, Candidate] = {}
    repeats = _structured(present)
    for c in order:
        if _step(present, c, repeats):
            best.setdefault(c.family, c)
    return list(best.values())


def _unsolved(c: Candidate) -> bool:
    return _structured(c.fit)


def _told(c: Candidate) -> str:
    return f"{' + '.join(c.effects)} ({c.family}): {describe_fit(c.fit)}"


def _step(present: Fit, best: Candidate, repeats: bool) -> bool:
    """Whether an effect is worth adding: what is left ``repeats`` in other runs, or it takes away all there is."""
    if convincing(present, best) and clears(present, best.fit):
        return True
    return repeats and promising(present, best)


def _structured(fit: Fit) -> bool:
    repeated = foretold(fit)
    return any(structured(s, repeated) for s in fit.residuals.values())


def _needed(search: Search, base: Fit, selected: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The selection without effects that those added later made superfluous."""
    selected = list(selected)
    for i in reversed(range(len(selected) - 1)):
        rest = [*selected[:i], *selected[i + 1 :]]
        without = _refitted(search, [c.effect for c in rest], selected[-1].fit, base, tried, again=True)
        if without and as_good(without[-1].fit, selected[-1]):
            search.say(Message(f"{selected[i].effect} is not needed any more"))
            selected = without
    return selected


def _enriched(search: Search, base: Fit, selected: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The selection with one of its effects in another form, where that is better beyond chance; general ones last."""
    selected = list(selected)
    for general in (False, True):
        last = selected[-1]
        if not _unsolved(last):
            break
        candidates = search.exchanged([c.effect for c in selected], last.fit.values, general)
        tried += candidates
        better = [c for c in rank(last.fit, candidates) if convincing(last.fit, c)]
        if better:
            search.say(Message(f"in another form: {_told(better[0])}"))
            selected = _refitted(search, better[0].effects, better[0].fit, base, tried) or selected
    return selected


def _merged(search: Search, base: Fit, selected: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The selection with fewer effects, where a richer member of one's family does what two of them did."""
    selected = list(selected)
    while len(selected) > 1:
        full = selected[-1]
        candidates = search.fewer(
            [c.effect for c in selected], full.fit.values, CRITERIA.search.better_form * base.residuals["fit"].excess
        )
        tried += candidates
        enough = [c for c in candidates if as_good(c.fit, full)]
        if not enough:
            break
        best = rank(base, enough)[0]
        search.say(Message(f"fewer effects do as well: {_told(best)}"))
        fewer = _refitted(search, best.effects, best.fit, base, tried)
        if not fewer:
            break
        selected = fewer
    return selected


def _refitted(
    search: Search, effects: Sequence[str], full: Fit, base: Fit, tried: list[Candidate], again: bool = False
) -> list[Candidate]:
    """The models that add these effects one after another, fitted from the values of a fuller model.

    Models that were fitted before are taken as they are; the last one is fitted ``again``, since it may have stopped
    short of its best. Nothing where one of them cannot be fitted.
    """
    models: list[Candidate] = []
    for k in range(1, len(effects) + 1):
        names = tuple(effects[:k])
        before = models[-1].fit if models else base
        known = next((c for c in tried if c.effects == names and not c.brief), None)
        if known is None or (again and k == len(effects)):
            fresh = search.with_effects(names, full.values)
            known = _lower(tried, known, rank(before, [fresh])[0]) if fresh else known
        if known is None:
            return []
        models.append(known)
    return models


def _lower(tried: list[Candidate], known: Candidate | None, fresh: Candidate) -> Candidate:
    """That of two fits of the same model which is nearer to the data; the other one leaves ``tried``."""
    if known is None:
        tried.append(fresh)
        return fresh
    if fresh.fit.residuals["fit"].chi2 >= known.fit.residuals["fit"].chi2:
        return known
    tried[tried.index(known)] = fresh
    return fresh
