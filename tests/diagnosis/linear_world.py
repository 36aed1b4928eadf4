"""A world in which models are linear, so that every fit is a matter of linear algebra and the truth is known."""

from __future__ import annotations

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import SimpleNamespace
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.catalogue import EffectClass, effect_classes
from pam_cosim.compiler import read_library
from pam_cosim.diagnosis import Candidate
from pam_cosim.diagnosis.search.full_model import FullModel
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.diagnosis.search.search import FitRequest, Search
from pam_cosim.fitting import Estimate, Fit, Linear
from tests.diagnosis.synthetic import WhiteFit, statistics

TREE = read_library()
CATALOGUE = tuple(effect_classes(TREE))
ROWS = 400
_NEEDED = 0.2  # strength, four standard deviations
KNOWN = {e.name: e for e in CATALOGUE}


def moves(name: str, role: str) -> Array:
    """(ROWS, 1) what an effect of unit strength does to the samples of the runs of a role, per noise deviation.

    Members of a family are alike, but not the same.
    """
    rng = np.random.default_rng(zlib.crc32(f"{KNOWN[name].family} {role}".encode()))
    own = np.random.default_rng(zlib.crc32(f"{name} {role}".encode()))
    return np.asarray(rng.standard_normal((ROWS, 1)) + 0.3 * own.standard_normal((ROWS, 1)))


def base_moves(role: str) -> Array:
    """(ROWS, 2) what two free parameters of the base model do."""
    return np.asarray(np.random.default_rng(zlib.crc32(role.encode())).standard_normal((ROWS, 2)))


@dataclass(frozen=True)
class LinearWorld(Search):
    """A search whose data hide some effects, of these strengths.

    Attributes:
        hidden: strengths by name.
        strange: of a course that no effect has.
        masked: a family that acts in another way beside the base model than beside a better one.
        alike: a family whose effects do next to the same as a hanging mass.
        slow: an effect of which a few steps come to nothing.
        coloured: reduced chi-square above which residuals are correlated.
        stuck: effects whose last comes to nothing beside the others, until a model with more has been fitted.
        tried: the models that were fitted to the end.
        looks: what effects were looked at beside, and how many.
    """

    hidden: Mapping[str, float] = field(default_factory=dict)
    strange: float = 0.0
    masked: str = ""
    alike: str = ""
    slow: str = ""
    coloured: float = 1.3
    stuck: frozenset[str] = frozenset()
    tried: list[tuple[str, ...]] = field(default_factory=list)
    asked: list[tuple[str, ...]] = field(default_factory=list)
    looks: list[tuple[tuple[str, ...], int]] = field(default_factory=list)

    def samples(self, role: str) -> Array:
        """(ROWS,) what is left of the samples by the base model at zero."""
        rng = np.random.default_rng(zlib.crc32(f"noise {role}".encode()))
        seen = rng.standard_normal(ROWS) + base_moves(role) @ [0.5, -0.5]
        seen += self.strange * rng.standard_normal(ROWS)
        return np.asarray(
            seen + sum((s * moves(n, role)[:, 0] for n, s in self.hidden.items()), np.zeros(ROWS))
        )

    def _moves(self, name: str, role: str) -> Array:
        if KNOWN[name].family != self.alike:
            return moves(name, role)
        return moves("HangingMass", role) + 0.1 * moves(name, role)

    def fitted(self, effects: Sequence[str]) -> Fit:
        """The model with these effects."""
        columns = {
            r: np.hstack([base_moves(r), *(self._moves(e, r) for e in effects)])
            for r in ("fit", "holdout")
        }
        values = np.linalg.lstsq(columns["fit"], self.samples("fit"), rcond=None)[0]
        left = {r: self.samples(r) - columns[r] @ values for r in columns}
        names = ("base.0", "base.1", *(f"{e}.strength" for e in effects))
        estimates = {
            n: Estimate(float(v), float(v) - 0.1, float(v) + 0.1)
            for n, v in zip(names, values, strict=True)
        }
        chi2 = {r: float(v @ v) / ROWS for r, v in left.items()}
        numbers = {
            r: statistics(c, 30.0 if c > self.coloured else 0.0, samples=ROWS)
            for r, c in chi2.items()
        }
        limits = np.full(len(names), 1e3)
        linear = Linear(names, values, -limits, limits, left["fit"], columns["fit"])
        return WhiteFit("Test", estimates, _comparison(chi2), numbers, 1, linear=linear)

    def untouched(self, effects: Sequence[str]) -> Fit:
        """The model with these effects where the last of them does nothing yet, nor says what it could."""
        without, whole = self.fitted(effects[:-1]), self.fitted(effects)
        assert without.linear is not None and whole.linear is not None
        slopes = np.hstack([without.linear.slopes, np.zeros((ROWS, 1))])
        linear = replace(whole.linear, residual=without.linear.residual, slopes=slopes)
        return replace(without, parameters=whole.parameters, linear=linear)

    def probe(self, fitted: Fit, has: Sequence[str], effects: Sequence[str]) -> list[EffectProbe]:
        assert fitted.linear is not None
        self.looks.append((tuple(has), len(effects)))
        probes = []
        for e in (KNOWN[name] for name in effects):
            masked = e.family == self.masked and not has
            moved = self._moves("HangingMass" if masked else e.name, "fit")
            names, limits = (f"{e.name}.strength",), np.full(1, 1e3)
            left = fitted.linear.residual - 0.5 * moved[:, 0]
            linear = Linear(names, np.full(1, 0.5), -limits, limits, left, moved)
            probes.append(EffectProbe(e.name, e.family, linear))
        return probes

    def full_models(self, base: Fit, promising: Sequence[str]) -> list[FullModel]:
        plain: dict[str, str] = {}
        for e in (KNOWN[name] for name in promising):
            if not e.general:
                plain.setdefault(e.family, e.name)
        fit = self.fitted([*plain.values()])
        kept = [n for n in plain.values() if abs(fit.values[f"{n}.strength"]) > _NEEDED]
        return [FullModel(tuple(kept), {})]

    def simpler_laws(self, c: Candidate) -> list[tuple[str, ...]]:
        return []

    def reduced(self, c: Candidate, most: int) -> FitRequest:
        strongest = self.by_need(c)[:most]
        needed = (e for e in strongest if abs(c.fit.values[f"{e}.strength"]) > _NEEDED)
        return FitRequest(tuple(needed), c.fit.values)

    def without_others(self, c: Candidate, kept: Sequence[str]) -> FitRequest:
        return FitRequest(tuple(kept), c.fit.values)

    def in_order(self, c: Candidate, effects: Sequence[str]) -> Candidate:
        return replace(self.candidate(tuple(effects)), fit=c.fit, brief=c.brief)

    def by_need(self, c: Candidate) -> tuple[str, ...]:
        return tuple(sorted(c.effects, key=lambda e: -abs(c.fit.values[f"{e}.strength"])))

    def without_outliers(self, fit: Fit) -> LinearWorld:
        return self

    def fit_briefly(self, models: Sequence[FitRequest]) -> list[Candidate]:
        self.asked.extend(m.effects for m in models)
        brief = [replace(self.candidate(m.effects), brief=True) for m in models]
        return [
            replace(c, fit=self.untouched(c.effects))
            if c.effect == self.slow or self._is_stuck(c.effects)
            else c
            for c in brief
        ]

    def fit_completely(self, candidates: Sequence[Candidate], base: Fit) -> list[Candidate]:
        self.tried.extend(c.effects for c in candidates)
        made = [self.candidate(c.effects) for c in candidates]
        return [
            replace(c, fit=self.untouched(c.effects)) if self._is_stuck(c.effects) else c
            for c in made
        ]

    def _is_stuck(self, effects: Sequence[str]) -> bool:
        return self.stuck == frozenset(effects) and not any(
            self.stuck < frozenset(names) for names in self.tried
        )

    def fit_final(self, effects: Sequence[str], start: Mapping[str, float]) -> Candidate | None:
        return self.candidate(tuple(effects))

    def candidate(self, names: tuple[str, ...]) -> Candidate:
        """The model with these effects, fitted."""
        last: EffectClass = KNOWN[names[-1]]
        own = (f"{last.name}.strength",)
        return Candidate(
            last.name,
            last.family,
            last.balance,
            names,
            own,
            self.fitted(names),
            general=last.general,
        )


def world(hidden: Mapping[str, float], **nature: Any) -> LinearWorld:
    """A world with these effects hidden; ``nature``: further attributes of it."""
    return LinearWorld(
        TREE, "Test", CATALOGUE, SimpleNamespace(is_static=False), hidden=hidden, **nature
    )  # type: ignore[arg-type]


def _comparison(chi2: Mapping[str, float]) -> Any:
    """The comparison of a fit that was written down, with a signal of which both roles have as many samples."""
    score = SimpleNamespace(chi2_reduced=sum(chi2.values()) / len(chi2))
    signals = {"x": SimpleNamespace(fitted=True)}
    data = SimpleNamespace(signals=signals, fitted_signals=signals)
    return SimpleNamespace(runs=(), scores={"all": {"x": score}}, data=data)
