"""Which balance fails: the missing term of each as a signal with its uncertainty."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.files import Plain
from pam_cosim.model.domain import Domain
from pam_cosim.wording import Printed


@dataclass(frozen=True)
class TermSeries:
    """A missing term in one run, at n instants.

    Attributes:
        run: name of the run, ``role`` its role.
        time: (n,) [s].
        value: (n,) [unit of the term], and ``deviation`` (n,) its standard deviation.
        against: (n,) each [SI]: what it can be looked at against, smoothed.
        imitated: (n,) each [unit of the term per unit of the parameter]: what a free parameter of the model can do of
            the same kind. The term is known only but for a multiple of these, the same in all runs.
    """

    json_keys = "run role time value standard_deviation=deviation against imitated"

    run: str
    role: str
    time: Array
    value: Array
    deviation: Array
    against: dict[str, Array]
    imitated: dict[str, Array] = field(default_factory=dict)


@dataclass(frozen=True)
class BalanceEntry:
    """A balance.

    Attributes:
        balance: as the library calls it.
        gain: twice the logarithm by which this entry alone makes the samples more probable; negative: it does not pay.
        explains: part of the error beyond the noise that this entry alone takes away, 0 to 1.
        share: what is lost without it in the best explanation, over the sum of the same for all balances.
        unit: of the term; ``meaning``: what is positive.
        courses: the missing term in every run; none where the model has no place for it.
        units: of what the term can be looked at against.
        same_as: balances whose missing term would do the same in this model: they may be meant as well.
    """

    json_keys = "balance gain explains share unit meaning size outside same_as courses"

    balance: str
    gain: float
    explains: float
    share: float
    unit: str = ""
    meaning: str = ""
    courses: tuple[TermSeries, ...] = ()
    units: dict[str, str] = field(default_factory=dict)
    same_as: tuple[str, ...] = ()

    @property
    def size(self) -> float:
        """Root mean square of the term over all runs; NaN where there is none."""
        if not self.courses:
            return float("nan")
        return float(np.sqrt(np.mean(np.concatenate([c.value for c in self.courses]) ** 2)))

    @property
    def outside(self) -> float:
        """Part of the time in which the term is further from zero than two standard deviations."""
        if not self.courses:
            return float("nan")
        return float(
            np.mean(np.concatenate([np.abs(c.value) > 2 * c.deviation for c in self.courses]))
        )


@dataclass(frozen=True)
class Ledger(Printed, Plain):
    """The balances of a model on a data set.

    Attributes:
        model: name of the model.
        entries: one a balance, the largest share first.
        failing: the balances that the samples say fail, the largest share first; none if the model is good.
        closed: with them the model meets the samples to the noise; if not, something is missing elsewhere too.
        before: mean square of sample minus model in noise variances; ``after``: with the failing entries.
        parameters: values of the free parameters with the failing entries [SI].
        notes: what cannot be distinguished.
        domain: how the balances are described and drawn.
    """

    json_keys = "model entries failing closed before after parameters notes"

    model: str
    entries: tuple[BalanceEntry, ...]
    failing: tuple[str, ...]
    closed: bool
    before: float
    after: float
    parameters: dict[str, float]
    notes: tuple[str, ...] = ()
    domain: Domain = Domain()

    def entry(self, balance: str) -> BalanceEntry | None:
        """The entry of a balance; None where the ledger has none."""
        return next((e for e in self.entries if e.balance == balance), None)

    @property
    def shares(self) -> dict[str, float]:
        """Share of each balance in the error, 0 to 1."""
        return {e.balance: e.share for e in self.entries}

    def as_dict(self, courses: bool = True) -> dict[str, Any]:
        """Plain data for JSON, SI units; short without the time series."""
        content = super().as_dict()
        if not courses:
            for entry in content["entries"]:
                del entry["courses"]
        return content

    def __str__(self) -> str:
        lines = [
            f"{self.model}: "
            + (f"fails in {' and '.join(self.failing)}" if self.failing else "no balance fails")
        ]
        lines[0] += f"; mean square error {self.before:.4g} -> {self.after:.4g} noise variances"
        for e in self.entries:
            size_text = f", {e.size:.3g} {e.unit} rms" if e.courses else ""
            lines.append(
                f"  {e.balance:7} share {100 * e.share:5.1f} %, alone {100 * e.explains:5.1f} %{size_text}"
            )
        lines += [f"  note: {n}" for n in self.notes]
        return "\n".join(lines)


@dataclass(frozen=True)
class BinnedTerm:
    """A missing term in one part of what it is looked at against.

    Attributes:
        low, high: bounds of the part [SI].
        mean: weighted mean of the term, ``deviation`` its standard deviation, from the scatter between the runs.
        scatter: standard deviation of the term about the mean.
        samples: how many instants lie in it.
    """

    low: float
    high: float
    mean: float
    deviation: float
    scatter: float
    samples: int


def binned(entry: BalanceEntry, against: str, bands: int = 12) -> tuple[BinnedTerm, ...]:
    """A missing term against one of its variables, or "time", in bands that hold equally many instants.

    Raises:
        KeyError: the term has no such variable.
    """
    z = np.concatenate([c.time if against == "time" else c.against[against] for c in entry.courses])
    value = np.concatenate([c.value for c in entry.courses])
    weight = 1 / np.concatenate([c.deviation for c in entry.courses]) ** 2
    run = np.concatenate([np.full(len(c.time), i) for i, c in enumerate(entry.courses)])
    edges = np.unique(np.quantile(z, np.linspace(0, 1, bands + 1)))
    in_bands = []
    for i, (low, high) in enumerate(zip(edges[:-1], edges[1:], strict=True)):
        inside = (z >= low) & ((z <= high) if i == len(edges) - 2 else (z < high))
        if not inside.any():
            continue
        mean = float(np.average(value[inside], weights=weight[inside]))
        means = [
            float(np.average(value[inside & (run == r)], weights=weight[inside & (run == r)]))
            for r in np.unique(run[inside])
        ]
        sd = float(1 / np.sqrt(weight[inside].max()))
        between = float(np.std(means, ddof=1) / np.sqrt(len(means))) if len(means) > 1 else 0.0
        scatter = float(np.std(value[inside]))
        in_bands.append(
            BinnedTerm(float(low), float(high), mean, max(sd, between), scatter, int(inside.sum()))
        )
    return tuple(in_bands)


@dataclass(frozen=True)
class Map:
    """A missing term over the plane of two of its variables; cells (rows along y, columns along x).

    Attributes:
        x, y: names of the variables.
        x_edges, y_edges: bounds of the cells [SI].
        value: mean of the term; NaN where there is no sample.
        significance: that mean over its typical standard deviation.
    """

    x: str
    y: str
    x_edges: Array
    y_edges: Array
    value: Array
    significance: Array


def mapped(entry: BalanceEntry, x: str, y: str, cells: int = 16) -> Map:
    """A missing term over a plane.

    Raises:
        KeyError: the term has no such variable.
    """
    xs = np.concatenate([c.against[x] for c in entry.courses])
    ys = np.concatenate([c.against[y] for c in entry.courses])
    value = np.concatenate([c.value for c in entry.courses])
    deviation = np.concatenate([c.deviation for c in entry.courses])
    bins = [np.histogram_bin_edges(v, cells) for v in (ys, xs)]
    count, y_edges, x_edges = np.histogram2d(ys, xs, bins=bins)
    total, _, _ = np.histogram2d(ys, xs, bins=bins, weights=value)
    spread, _, _ = np.histogram2d(ys, xs, bins=bins, weights=deviation)
    with np.errstate(invalid="ignore", divide="ignore"):
        mean = np.where(count > 0, total / count, np.nan)
        significance = np.where(count > 0, total / spread, np.nan)
    return Map(x, y, x_edges, y_edges, mean, significance)
