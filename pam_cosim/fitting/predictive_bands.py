"""What a fitted model predicts of a run, with how far parameters, model error and noise leave it open."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from math import sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import simulate_run, warnings_of
from pam_cosim.errors import SimulationFailure
from pam_cosim.exports import Exported, Table, headed
from pam_cosim.fitting.discrepancy import TAIL, Discrepancy
from pam_cosim.fitting.parameter_posterior import ParameterPosterior
from pam_cosim.measurement import DataSet, Run
from pam_cosim.measurement.free_parameter import INTERVAL
from pam_cosim.simulation import AnySimulator
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, look_first

_LEAST_EFFECTIVE = 20.0  # samples of equal weight; the ends of a band are rough below


@dataclass(frozen=True)
class Band:
    """One signal.

    Attributes:
        unit: SI unit.
        value: (n,) with the fitted parameters [unit].
        low, high: (n,) between which the signal lies with 95 % [unit], as far as the parameters say.
        reading_low, reading_high: (n,) between which a reading of it lies with 95 % [unit]: what the model is off by
            and the noise are added to the parameters.
        measured: (n,) readings [unit], NaN where there is none; empty: not recorded.
        discrepancy: the model error; None: not requested, or no run to estimate it from.
        mean: over time, with the fitted parameters [unit].
        mean_low, mean_high: between which the mean of the readings lies with 95 % [unit].
    """

    json_keys = (
        "unit coverage value low high reading_low reading_high measured discrepancy mean mean_low "
        "mean_high"
    )

    unit: str
    value: Array
    low: Array
    high: Array
    reading_low: Array
    reading_high: Array
    measured: Array = field(default_factory=lambda: np.zeros(0))
    discrepancy: Discrepancy | None = None
    mean: float = float("nan")
    mean_low: float = float("nan")
    mean_high: float = float("nan")

    @property
    def coverage(self) -> float:
        """Share of the readings that lie within their band; NaN without readings."""
        at = np.isfinite(self.measured) if self.measured.size else np.zeros(0, dtype=bool)
        if not at.any():
            return float("nan")
        inside = (self.measured >= self.reading_low) & (self.measured <= self.reading_high)
        return float(np.mean(inside[at]))


@dataclass(frozen=True)
class PredictiveBands(Printed, Exported):
    """A run that was predicted.

    Attributes:
        model: the fitted model.
        run: name of the run.
        time: (n,) [s].
        inputs: (n,) each [SI].
        bands: by signal.
        posterior: the parameters that it was predicted with.
        failed: how many of them the model broke down with.
        warnings: of the model at the optimum.
    """

    json_keys = "model run time inputs signals=bands parameters=posterior failed warnings?"

    model: str
    run: str
    time: Array
    inputs: dict[str, Array]
    bands: dict[str, Band]
    posterior: ParameterPosterior
    failed: int = 0
    warnings: tuple[str, ...] = ()

    def table(self) -> Table:
        """Time, and of each signal its value and the ends of both bands; SI units."""
        heads, columns = [headed("time", "s")], [self.time]
        for name, band in self.bands.items():
            for end in ("value", "low", "high", "reading_low", "reading_high"):
                heads.append(headed(name if end == "value" else f"{name}.{end}", band.unit))
                columns.append(getattr(band, end))
        return heads, ([float(v) for v in row] for row in zip(*columns, strict=True))

    def __str__(self) -> str:
        count, effective = len(self.posterior.samples), self.posterior.effective
        lines = [
            f"{self.model}, {self.run}: predicted with {count} samples of {len(self.posterior.names)} parameters"
        ]
        lines += look_first(self.warnings)
        if effective < _LEAST_EFFECTIVE:
            lines.append(
                f"  the effective number of samples is {effective:.0f}, so the bands are rough; take more samples"
            )
        for name, band in self.bands.items():
            width = format_quantity(float(np.median(band.high - band.low)) / 2, band.unit, 2)
            widest = int(np.argmax(band.high - band.low))
            most = format_quantity(float(band.high[widest] - band.low[widest]) / 2, band.unit, 2)
            text = (
                f"  {name}: ± {width} in the median (95 %), ± {most} at {self.time[widest]:.4g} s"
            )
            if band.coverage == band.coverage:
                text += f"; {100 * band.coverage:.1f} % of the readings are within their band"
            lines += [text, *_about_discrepancy(band)]
        if self.failed:
            lines.append(f"  {self.failed} samples could not be simulated and are left out")
        return "\n".join(lines)


def predictive_bands(
    simulator: AnySimulator,
    data: DataSet,
    run: Run,
    posterior: ParameterPosterior,
    fitted: dict[str, float],
    tell: Callable[[int], None] = lambda count: None,
    off: Mapping[str, Discrepancy] | None = None,
) -> PredictiveBands:
    """Simulates a run with every sample of the parameters.

    Args:
        simulator: the model that was fitted.
        data: what it was fitted to.
        run: inputs, parameters and times, as one of the data set.
        posterior: of the parameters.
        fitted: the optimum [SI].
        tell: called with how many samples are done.
        off: what the model is off by, by signal.

    Raises:
        SimulationFailure: the model breaks down at the optimum, or with most of the samples.
    """
    names = [name for name in simulator.interface.outputs if name in data.signals]
    best = simulate_run(simulator, data, run, fitted, None, names)
    drawn: list[dict[str, Array]] = []
    weights: list[float] = []
    for count, (values, weight) in enumerate(
        zip(posterior.values, posterior.weights, strict=True), 1
    ):
        if weight:
            with suppress(SimulationFailure):
                drawn.append(simulate_run(simulator, data, run, values, None, names).model)
                weights.append(float(weight))
        tell(count)
    failed = int(np.count_nonzero(posterior.weights)) - len(drawn)
    if failed > len(drawn):
        raise SimulationFailure(
            f"the model breaks down with {failed} of {len(posterior.samples)} samples"
        )
    share = np.array(weights) / sum(weights)
    off = off or {}
    bands = {
        n: _band(
            data,
            run,
            n,
            best.model[n],
            np.array([sample[n] for sample in drawn]),
            share,
            off.get(n),
        )
        for n in names
    }
    return PredictiveBands(
        simulator.interface.model,
        run.name,
        run.time,
        dict(run.inputs),
        bands,
        posterior,
        failed,
        warnings_of([best]),
    )


def _band(
    data: DataSet,
    run: Run,
    name: str,
    best: Array,
    drawn: Array,
    weights: Array,
    off: Discrepancy | None,
) -> Band:
    """Quantiles over the weighted samples; to each of them a reading adds model error and noise."""
    signal = data.signals[name]
    low, high = _quantile(drawn, weights, TAIL), _quantile(drawn, weights, 1 - TAIL)
    centre = weights @ drawn
    spread = weights @ (drawn - centre) ** 2
    noise = np.broadcast_to(signal.sigma_at(best), best.shape) ** 2
    around = np.sqrt(INTERVAL**2 * (spread + noise) + (off.reach() if off else 0.0) ** 2)
    measured = run.measurements.get(name, np.zeros(0))
    readings = measured if np.isfinite(measured).any() else np.zeros(0)
    # the mean over time: noise goes out of it by the number of readings, the model error by its memory
    share = _shares(run.time)
    means = drawn @ share
    middle = float(weights @ means)
    squares = INTERVAL**2 * (float(weights @ (means - middle) ** 2) + float(share**2 @ noise))
    of_mean = sqrt(squares + (off.reach(float(np.ptp(run.time))) if off else 0.0) ** 2)
    return Band(
        signal.unit,
        best,
        low,
        high,
        centre - around,
        centre + around,
        readings,
        off,
        float(share @ best),
        middle - of_mean,
        middle + of_mean,
    )


def _shares(time: Array) -> Array:
    """(n,) of a mean over time by the trapezoidal rule."""
    if len(time) < 2 or np.ptp(time) == 0.0:
        return np.full(len(time), 1.0 / len(time))
    steps = np.diff(time)
    around = np.concatenate([steps[:1], steps[:-1] + steps[1:], steps[-1:]]) / 2.0
    return np.asarray(around / np.ptp(time))


def _about_discrepancy(band: Band) -> list[str]:
    """What the model is off by, and the mean over the run, in words."""
    off = band.discrepancy
    if off is None:
        return []
    unit = band.unit
    sd, memory = format_quantity(off.sd, unit, 2), format_quantity(off.memory, "s", 2)
    source = "held-out" if off.held_out else "fitted"
    count = len(off.runs)
    middle, width = (band.mean_low + band.mean_high) / 2, (band.mean_high - band.mean_low) / 2
    return [
        f"    model error {sd} (sd), memory {memory}, from {count} {source} run{'s' * (count != 1)}; mean over "
        f"the run {format_quantity(middle, unit, 4)} ± {format_quantity(width, unit, 2)}"
    ]


def _quantile(drawn: Array, weights: Array, level: float) -> Array:
    """(n,) the value of each column below which the samples have a share ``level`` of the weight."""
    order = np.argsort(drawn, axis=0)
    below = np.cumsum(weights[order], axis=0) - 0.5 * weights[order]
    columns = np.take_along_axis(drawn, order, axis=0)
    return np.array([np.interp(level, below[:, i], columns[:, i]) for i in range(drawn.shape[1])])
