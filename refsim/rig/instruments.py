"""Faults of instruments: what a recorder writes where the rig itself behaves as it should.

A clean signal passes in this order: the sensor (offset, gain, curve, lag, dead time), the clock of the recorder, the
noise, and what comes after the noise (the end of the recorder's range, its steps). Terms are those of IEC 61298-2 and
of data sheets. Nothing is smoothed: a reading ends at a limit with a corner, and steps jump.

    faults = [Offset("x", 1e-3), ClockOffset(0.03)]
    shown = readings(faults, fine, clean, samples, sigma, rng)
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, ClassVar

import numpy as np

from rig.integrate import Array

Signals = Mapping[str, Array]
"""By name (p [Pa gauge], x [m], F [N], T [K], ...), arrays of shape (times,), all on the same times."""

STATIC = {
    "p": "pressure_offset",
    "x": "position_sensor",
    "F": "force_sensor",
    "T": "temperature_sensor",
}
LATE = {
    "p": "pressure_sensor_lag",
    "x": "position_sensor",
    "F": "force_sensor",
    "T": "thermocouple_lag",
}
"""The family of a fault by the letter that its signal begins with."""


def family_of(signal: str, families: Mapping[str, str]) -> str:
    """The family of a fault in a signal such as p, p_1 or eps; a contraction ratio is read by a ruler."""
    letter = "x" if signal in ("eps", "L") else signal.partition("_")[0]
    if letter not in families:
        raise ValueError(f"no instrument reads '{signal}'; known are {', '.join(families)}")
    return families[letter]


@dataclass(frozen=True)
class Fault:
    """An instrument is right. Subclasses say what one makes of the signals.

    Attributes:
        family, form: as those of an effect. after_noise: whether it acts on a signal that has its noise.
    """

    form: ClassVar[str] = "none"
    after_noise: ClassVar[bool] = False

    @property
    def family(self) -> str:
        """The family that a diagnosis should name."""
        return "none"

    def disturb(self, time: Array, signals: Signals) -> dict[str, Array]:
        """The signals as shown, at the same times [s]."""
        return dict(signals)


@dataclass(frozen=True)
class SensorFault(Fault):
    """A fault of the instrument that reads one signal."""

    signal: str = "x"

    @property
    def family(self) -> str:
        return family_of(self.signal, STATIC)

    def disturb(self, time: Array, signals: Signals) -> dict[str, Array]:
        if self.signal not in signals:
            raise ValueError(
                f"there is no signal '{self.signal}' to disturb, only {', '.join(signals)}"
            )
        return {**signals, self.signal: self.shown(time, signals[self.signal])}

    def shown(self, time: Array, y: Array) -> Array:
        """The reading of y, same shape, same unit."""
        return y


@dataclass(frozen=True)
class Offset(SensorFault):
    """Zero error: y + offset."""

    form = "offset"
    offset: float = 1e-3  # in the unit of the signal

    def shown(self, time: Array, y: Array) -> Array:
        return y + self.offset


@dataclass(frozen=True)
class Gain(SensorFault):
    """Span error: zero + gain (y - zero), right at zero."""

    form = "gain"
    gain: float = 1.03
    zero: float = 0.0  # in the unit of the signal

    def shown(self, time: Array, y: Array) -> Array:
        return self.zero + self.gain * (y - self.zero)


@dataclass(frozen=True)
class OffsetAndGain(SensorFault):
    """Zero and span error: offset + zero + gain (y - zero)."""

    form = "offset_and_gain"
    offset: float = 1e-3  # in the unit of the signal
    gain: float = 1.03
    zero: float = 0.0

    def shown(self, time: Array, y: Array) -> Array:
        return self.offset + self.zero + self.gain * (y - self.zero)


@dataclass(frozen=True)
class Bow(SensorFault):
    """Linearity error of an instrument that is adjusted at both ends of its range: y + 4 bow s (1 - s), s = y/full."""

    form = "bow"
    bow: float = 1e-3  # in the unit of the signal
    full: float = 0.08  # in the unit of the signal

    def shown(self, time: Array, y: Array) -> Array:
        share = y / self.full
        return y + 4 * self.bow * share * (1 - share)


def lagged(time: Array, y: Array, tau: float) -> Array:
    """z with tau z_dot = y - z from z = y at the start, for y that is straight between the times; exact."""
    step = np.diff(time) / tau
    kept = np.exp(-step)
    # of a line from y_0 to y_1 over a step: z_1 = kept z_0 + (1 - kept) y_0 + (1 - (1 - kept)/step) (y_1 - y_0)
    ramp = 1 + np.expm1(-step) / step
    z = np.empty_like(y)
    z[0] = y[0]
    for k in range(len(step)):
        z[k + 1] = kept[k] * z[k] + (1 - kept[k]) * y[k] + ramp[k] * (y[k + 1] - y[k])
    return z


def shifted(time: Array, y: Array, late: float) -> Array:
    """y(t - late), straight between the times; the first and the last value beyond them."""
    return np.interp(time - late, time, y)


@dataclass(frozen=True)
class Lag(SensorFault):
    """The reading follows through a first-order lag: an amplifier's filter, a snubber, a bead."""

    form = "lag"
    tau: float = 0.05  # s

    @property
    def family(self) -> str:
        return family_of(self.signal, LATE)

    def shown(self, time: Array, y: Array) -> Array:
        return lagged(time, y, self.tau)


@dataclass(frozen=True)
class TwoLags(Lag):
    """The reading follows through two lags, tau and r tau: a long tube before a filter."""

    form = "two_lags"
    r: float = 0.4

    def shown(self, time: Array, y: Array) -> Array:
        return lagged(time, lagged(time, y, self.tau), self.r * self.tau)


@dataclass(frozen=True)
class DeadTime(SensorFault):
    """The reading comes late as it is: a bus, a digital filter of many taps."""

    form = "dead_time"
    dead_time: float = 0.03  # s

    @property
    def family(self) -> str:
        return family_of(self.signal, LATE)

    def shown(self, time: Array, y: Array) -> Array:
        return shifted(time, y, self.dead_time)


@dataclass(frozen=True)
class ClockOffset(Fault):
    """The recorder of the readings is not started with that of the commands: what is written at t was at t - shift.

    A positive shift shows readings late, a negative one early; a run must have been simulated that much longer.
    """

    form = "shift"
    shift: float = 0.03  # s

    @property
    def family(self) -> str:
        return "clock_offset"

    def disturb(self, time: Array, signals: Signals) -> dict[str, Array]:
        return {name: shifted(time, y, self.shift) for name, y in signals.items()}


@dataclass(frozen=True)
class Saturation(SensorFault):
    """The reading ends at limits, those of the recorder's range, where the noise ends too."""

    form = "limits"
    after_noise = True
    low: float = -np.inf  # in the unit of the signal
    high: float = np.inf  # in the unit of the signal

    @property
    def family(self) -> str:
        return "saturation"

    def shown(self, time: Array, y: Array) -> Array:
        return np.clip(y, self.low, self.high)


@dataclass(frozen=True)
class TransducerSaturation(Saturation):
    """As Saturation, but the transducer itself is at its stop: the noise of what follows goes on."""

    form = "stop"
    after_noise = False


@dataclass(frozen=True)
class Quantisation(SensorFault):
    """The reading comes in steps: those of the converter, or of the digits that were written."""

    form = "steps"
    after_noise = True
    step: float = 1e-3  # in the unit of the signal

    @property
    def family(self) -> str:
        return "quantisation"

    def shown(self, time: Array, y: Array) -> Array:
        return self.step * np.round(y / self.step)


def disturbed(faults: Sequence[Fault], time: Array, signals: Signals) -> dict[str, Array]:
    """The signals through all faults, one after another, at the same times [s], without noise."""
    shown = dict(signals)
    for fault in faults:
        shown = fault.disturb(time, shown)
    return shown


def readings(
    faults: Sequence[Fault],
    time: Array,
    clean: Signals,
    samples: Array,
    sigma: Mapping[str, float],
    rng: np.random.Generator,
) -> dict[str, Array]:
    """What is recorded of clean signals.

    time: of the clean signals [s], from the first sample to at least the last and finer than they are, since a fault
    takes them as straight between. samples: when is recorded [s]. sigma: standard deviations of the noise by
    signal [SI]; drawn in the order of the signals.
    """
    shown = disturbed([f for f in faults if not f.after_noise], time, clean)
    noisy = {name: np.interp(samples, time, y) for name, y in shown.items()}
    noisy = {
        name: y + sigma.get(name, 0.0) * rng.standard_normal(len(samples))
        for name, y in noisy.items()
    }
    return disturbed([f for f in faults if f.after_noise], samples, noisy)


FAULTS: tuple[type[Fault], ...] = (
    Offset, Gain, OffsetAndGain, Bow, Lag, TwoLags, DeadTime, ClockOffset, Saturation, TransducerSaturation,
    Quantisation,
)  # fmt: skip


def fault_of(text: str) -> Fault:
    """The fault that ``form[:name=value,...]`` names, such as ``offset:signal=x,offset=1e-3``.

    Raises ValueError for an unknown form or name.
    """
    form, _, settings = text.partition(":")
    known = {kind.form: kind for kind in FAULTS}
    if form not in known:
        raise ValueError(f"no fault '{form}'; known: {', '.join(known)}")
    values = dict(item.split("=", 1) for item in settings.split(",") if item)
    has = [field.name for field in fields(known[form])]
    unknown = set(values) - set(has)
    if unknown:
        raise ValueError(f"'{form}' has no {', '.join(sorted(unknown))}; it has {', '.join(has)}")
    chosen: dict[str, Any] = {
        name: v if name == "signal" else float(v) for name, v in values.items()
    }
    return known[form](**chosen)
