"""What each stage of a diagnosis is worth: switches stages off, and notes where they did anything.

A stage is a function of the software with another one that leaves it out. Where a stage did nothing, the diagnosis
without it is the same, and need not run: with `--note-stages` a result of `one` says which stages did something.
"""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable, Collection
from typing import Any, NamedTuple

from pam_cosim.simulation import Simulator

_PACKAGE = "pam_cosim"


class Stage(NamedTuple):
    """Where a stage is: `place` is a module of the package, `name` a function or a method of a class there."""

    place: str
    name: str
    left_out: Callable[..., Any]


def _nothing(*_: Any) -> None: ...


STAGES: dict[str, Stage] = {
    "single effects to the end first": Stage(
        "diagnosis.search.selection", "_Models.one_may_be_enough", lambda _: False
    ),
    "full models": Stage("diagnosis.search.selection", "_Models.try_full_models", _nothing),
    "further single effects": Stage(
        "diagnosis.search.selection", "_Models.try_further_single", _nothing
    ),
    "exchange of members": Stage(
        "diagnosis.search.selection", "_Models._exchange_members", lambda *_: []
    ),
    "simpler laws at a bound": Stage(
        "diagnosis.search.search", "Search.simpler_laws", lambda *_: []
    ),
    "leaving out": Stage("diagnosis.search.selection", "_Models._leave_out", _nothing),
    "adding one": Stage("diagnosis.search.selection", "_Models._add_one", _nothing),
    "probes beside a model": Stage(
        "diagnosis.search.selection", "_Models._probe_further", _nothing
    ),
    "outliers beside the best model": Stage(
        "diagnosis.search.search", "Search.without_outliers", lambda self, _: self
    ),
    "models of other families": Stage(
        "diagnosis.search.ranking",
        "Ranking.leading",
        lambda self, count: [
            c for c in [self.leader()] if c is not None and len(c.effects) == count
        ],
    ),
    "coloured noise": Stage("diagnosis.judgement.evidence", "_may_be_drift", lambda _: False),
    "signals that were not fitted": Stage(
        "diagnosis.search.ranking", "refuted_by_unfitted_signals", lambda *_: False
    ),
    "one effect beyond doubt": Stage("diagnosis.search.ranking", "dominant_effect", _nothing),
    "effects too small to matter": Stage(
        "diagnosis.search.ranking", "Ranking.matters", lambda *_: True
    ),
    "coefficients held at zero": Stage(
        "diagnosis.search.trial", "pruned", lambda _, __, ___, ____, full, _____: full
    ),
    "start values a decade away": Stage("diagnosis.search.trial", "_start_points", lambda _: []),
    "folds": Stage("diagnosis.diagnose", "folds_of", _nothing),
    "conventions of a logger": Stage("diagnosis.diagnose", "_convention", _nothing),
    "rivals that no run decides": Stage(
        "diagnosis.diagnose",
        "distinguishable_rivals",
        lambda _, __, rivals, ___: [(c, None) for c in rivals],
    ),
}
"""All stages that can be switched off."""

_ORIGINALS: dict[str, Callable[..., Any]] = {}


def _original(name: str) -> Callable[..., Any]:
    return _ORIGINALS[name]


def _owner(stage: Stage) -> tuple[Any, str]:
    *classes, name = stage.name.split(".")
    return functools.reduce(
        getattr, classes, importlib.import_module(f"{_PACKAGE}.{stage.place}")
    ), name


def _put(name: str, function: Callable[..., Any]) -> None:
    owner, attribute = _owner(STAGES[name])
    raw = vars(owner)[attribute]
    _ORIGINALS.setdefault(name, getattr(owner, attribute))
    setattr(owner, attribute, staticmethod(function) if isinstance(raw, staticmethod) else function)


def _differ(result: Any, other: Any) -> bool:
    if result is other:
        return False
    return result != other if isinstance(result, tuple | list | bool) else True


def leave_out(names: Collection[str]) -> None:
    """Switches stages off in this process."""
    for name in names:
        _put(name, STAGES[name].left_out)


def note() -> set[str]:
    """Notes, from now on, the stages that did something: they simulated, or gave another result than without them."""
    active = set[str]()

    def watched(name: str) -> Callable[..., Any]:
        def call(*given: Any, **named: Any) -> Any:
            before = Simulator.simulations
            result = _original(name)(*given, **named)
            if name not in active and (
                Simulator.simulations > before
                or _differ(result, STAGES[name].left_out(*given, **named))
            ):
                active.add(name)
            return result

        return call

    for name in STAGES:
        _put(name, watched(name))
    return active
