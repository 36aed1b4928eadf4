"""Which effects a model needs: added one after another, the superfluous ones removed."""

from __future__ import annotations

import math
from collections.abc import Sequence

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.evidence import (
    alone,
    as_good,
    clears,
    coherent,
    convincing,
    foretold,
    leading,
    promising,
    rank,
    structured,
)
from pam_cosim.diagnosis.search import Search, at_noise, describe_fit
from pam_cosim.fitting import Fit


def find_path(search: Search, base: Fit) -> tuple[list[Candidate], list[Candidate]]:
    """The effects that are needed, in the order in which they were found, and all that were tried."""
    missing = any(coherent(s) for s in base.residuals.values())
    tried = search.round((), base, below=math.inf if missing else 0.0)
    first = _steps(base, tried) if missing else []
    if missing and (not first or (_unsolved(first[0]) and _nearly(base, first[0]))):
        first = _generalized(search, base, first, tried)
    elif first and not _unsolved(first[0]) and not at_noise(first[0].fit):
        first = _outdone(search, base, first, tried)
    path = [first[0]] if first else []
    if first and _unsolved(first[0]):
        path = _second(search, base, first, tried)
        if len(path) == 1 and not _nearly(base, first[0]):
            path = _generalized(search, base, first, tried)[:1]
        path = _lone(search, base, path, tried)
    while 1 < len(path) < CRITERIA.search.most_effects and _unsolved(path[-1]):
        path = _enriched(search, base, path, tried)
        last = path[-1]
        if not _unsolved(last):
            break
        found = search.round(last.effects, last.fit, tried)
        tried += found
        steps = _steps(last.fit, found)
        if not steps:
            break
        path.append(steps[0])
        search.say(f"added {_told(steps[0])}")
    path = _merged(search, base, _needed(search, base, path, tried), tried)
    return (path, tried) if path and convincing(base, rank(base, [path[-1]])[0]) else ([], tried)


def _nearly(base: Fit, c: Candidate) -> bool:
    """Whether an effect takes away so much that a better form of it may do the rest, rather than a second effect."""
    before, after = base.residuals["fit"], c.fit.residuals["fit"]
    return after.excess < CRITERIA.search.better_form * before.excess


def _generalized(search: Search, base: Fit, first: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The first effects, or general members of families where one of them leaves nothing.

    Those of the leading families are fitted; where no effect helps at all, those of all others too.
    """
    found = rank(base, search.general(base, tried))
    if not first and not any(not _unsolved(c) for c in found):
        found = rank(base, [*found, *search.last_resort(base, [*tried, *found])])
    tried += found
    solved = [c for c in _steps(base, found) if not _unsolved(c)]
    if not solved:
        return list(first)
    search.say(f"in general form: {_told(solved[0])}")
    return solved


def _outdone(search: Search, base: Fit, first: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The first effects, led by the general member of a family where that is better beyond chance.

    For a remainder above the noise that does not come again in other runs: a drift as a rule, but not always.
    """
    present = first[0].fit
    found = rank(base, search.general(base, tried))
    tried += found
    better = {c.effects for c in rank(present, found) if convincing(present, c)}
    return [*(c for c in found if c.effects in better), *first]


def _second(search: Search, base: Fit, first: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The best first effect with the best second one: of two that are missing, neither need be the best alone.

    One that is beyond doubt by itself is the only first one, and need not leave much undone then.
    """
    singles = list(tried)
    one = alone(base, singles)
    starts = [_plain(one, singles)] if one else first[: CRITERIA.search.first_effects]
    pairs: list[Candidate] = []
    for start in starts:
        search.say(f"with {_told(start)}")
        below = CRITERIA.search.second_leaves * start.fit.residuals["fit"].excess if one else math.inf
        found = search.round(start.effects, start.fit, singles, below=below)
        tried += found
        pairs += _steps(start.fit, found)[:1]
        if pairs and not _unsolved(pairs[-1]):
            break
    if not pairs:
        return [starts[0]]
    best = rank(base, pairs)[0]
    chosen = next(p for p in pairs if p.effects == best.effects)
    search.say(f"added {_told(chosen)}")
    return [next(c for c in starts if c.effects == chosen.effects[:1]), chosen]


def _plain(one: Candidate, singles: Sequence[Candidate]) -> Candidate:
    """The best law of the same family, where a general member does not take away most of what that leaves."""
    laws = [c for c in singles if c.family == one.family and not c.general]
    law = min(laws, key=lambda c: c.fit.residuals["fit"].excess, default=one)
    return law if one.general and not _nearly(law.fit, one) else one


def _lone(search: Search, base: Fit, path: list[Candidate], tried: Sequence[Candidate]) -> list[Candidate]:
    """The path, or the one effect beyond doubt where a second one does not take away most of what that leaves."""
    last, one = path[-1], alone(base, tried)
    if one is None or not _unsolved(last) or (len(path) > 1 and _nearly(path[0].fit, last)):
        return path
    search.say(f"no second effect explains what is left by {_told(one)}")
    return [one]


def _steps(present: Fit, found: Sequence[Candidate]) -> list[Candidate]:
    """Effects worth adding, the leading one first, one of each family."""
    order = [leading(found), *found] if any(c.fit for c in found) else []
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


def _structured(found: Fit) -> bool:
    repeated = foretold(found)
    return any(structured(s, repeated) for s in found.residuals.values())


def _needed(search: Search, base: Fit, path: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The path without effects that those added later made superfluous."""
    path = list(path)
    for i in reversed(range(len(path) - 1)):
        rest = [*path[:i], *path[i + 1 :]]
        without = _refitted(search, [c.effect for c in rest], path[-1].fit, base, tried, again=True)
        if without and as_good(without[-1].fit, path[-1]):
            search.say(f"{path[i].effect} is not needed any more")
            path = without
    return path


def _enriched(search: Search, base: Fit, path: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The path with one of its effects in another form, where that is better beyond chance; general ones come last."""
    path = list(path)
    for general in (False, True):
        last = path[-1]
        if not _unsolved(last):
            break
        found = search.exchanged([c.effect for c in path], last.fit.values, general)
        tried += found
        better = [c for c in rank(last.fit, found) if convincing(last.fit, c)]
        if better:
            search.say(f"in another form: {_told(better[0])}")
            path = _refitted(search, better[0].effects, better[0].fit, base, tried) or path
    return path


def _merged(search: Search, base: Fit, path: Sequence[Candidate], tried: list[Candidate]) -> list[Candidate]:
    """The path with fewer effects, where a richer member of one's family does what two of them did."""
    path = list(path)
    while len(path) > 1:
        full = path[-1]
        found = search.fewer(
            [c.effect for c in path], full.fit.values, CRITERIA.search.better_form * base.residuals["fit"].excess
        )
        tried += found
        enough = [c for c in found if as_good(c.fit, full)]
        if not enough:
            break
        best = rank(base, enough)[0]
        search.say(f"fewer effects do as well: {_told(best)}")
        fewer = _refitted(search, best.effects, best.fit, base, tried)
        if not fewer:
            break
        path = fewer
    return path


def _refitted(
    search: Search, effects: Sequence[str], full: Fit, base: Fit, tried: list[Candidate], again: bool = False
) -> list[Candidate]:
    """The chain of models that adds these effects one after another, fitted from the values of a fuller model.

    Models that were fitted before are taken as they are; the last one is fitted ``again``, since it may have stopped
    short of its best. Nothing where one of them cannot be fitted.
    """
    chain: list[Candidate] = []
    for k in range(1, len(effects) + 1):
        names = tuple(effects[:k])
        before = chain[-1].fit if chain else base
        known = next((c for c in tried if c.effects == names and not c.brief), None)
        if known is None or (again and k == len(effects)):
            fresh = search.with_effects(names, full.values)
            known = _lower(tried, known, rank(before, [fresh])[0]) if fresh else known
        if known is None:
            return []
        chain.append(known)
    return chain


def _lower(tried: list[Candidate], known: Candidate | None, fresh: Candidate) -> Candidate:
    """That of two fits of the same model which is nearer to the data; the other one leaves ``tried``."""
    if known is None:
        tried.append(fresh)
        return fresh
    if fresh.fit.residuals["fit"].chi2 >= known.fit.residuals["fit"].chi2:
        return known
    tried[tried.index(known)] = fresh
    return fresh
