"""Faults of instruments that the score hides, and effects that only some bench has.

`FAULTS` are a table of their own beside that of `table.py`: a fault belongs to a signal, and how large it may be
follows from what the signal goes through in the case. Static faults of a manometer are of the family pressure_offset,
a slow thermometer is of thermocouple_lag.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from blind_cases.noise import USUAL
from blind_cases.setups import Design, Setup
from blind_cases.table import BOTH, Form
from rig import instruments
from rig.catalogue.rate_friction import LoadFrequency
from rig.effect import Effect
from rig.instruments import Fault
from rig.stated import WrongParameter

Random = np.random.Generator


@dataclass(frozen=True)
class Scene:
    """What a fault is drawn for: the rig, and the largest reading of each signal in its runs [SI]."""

    setup: Setup
    peaks: Mapping[str, float]


Make = Callable[[Random, Scene], Callable[[float], Effect | Fault]]


@dataclass(frozen=True)
class FaultForm:
    """One line of the table; what it says means as in `table.Form`.

    where: whether a design has the instrument.
    """

    family: str
    name: str
    catalogue: bool
    where: Callable[[Design], bool]
    make: Make
    low: float = 1e-3
    high: float = 30.0
    signed: bool = False


def _reads(signal: str) -> Callable[[Design], bool]:
    return lambda design: signal in design.signals


def _manometers(design: Design) -> tuple[str, ...]:
    return tuple(s for s in design.signals if s.startswith("p"))


def _offset(signal: str, unit: float) -> Make:
    return lambda rng, scene: lambda s: instruments.Offset(signal, unit * s)


def _gain(signal: str, unit: float, zero: float = 0.0) -> Make:
    return lambda rng, scene: lambda s: instruments.Gain(signal, 1 + unit * s, zero)


def _bow(signal: str, unit: float) -> Make:
    def make(rng: Random, scene: Scene) -> Callable[[float], Effect | Fault]:
        full = scene.peaks[signal] * rng.uniform(1.0, 1.6)
        return lambda s: instruments.Bow(signal, unit * s, full)

    return make


def _lag(signal: str, tau: float) -> Make:
    return lambda rng, scene: lambda s: instruments.Lag(signal, tau * s)


def _two_lags(signal: str, tau: float) -> Make:
    def make(rng: Random, scene: Scene) -> Callable[[float], Effect | Fault]:
        r = rng.uniform(0.3, 1.0)
        return lambda s: instruments.TwoLags(signal, tau * s, r)

    return make


def _dead_time(signal: str, late: float) -> Make:
    return lambda rng, scene: lambda s: instruments.DeadTime(signal, late * s)


def _clock(rng: Random, scene: Scene) -> Callable[[float], Effect | Fault]:
    """Where currents are all that moves, readings that come late are valves that do; there they come early."""
    moving = scene.setup.design.rig.course is not None
    sign = 1.0 if moving and rng.random() < 0.5 else -1.0
    return lambda s: instruments.ClockOffset(min(max(sign * 0.02 * s, -0.4), 0.4))


def _one_of(design_signals: tuple[str, ...], rng: Random) -> str:
    return design_signals[int(rng.integers(len(design_signals)))]


def _saturated(kind: type[instruments.Saturation]) -> Make:
    def make(rng: Random, scene: Scene) -> Callable[[float], Effect | Fault]:
        signal = _one_of(tuple(s for s in scene.setup.signals if s != "T"), rng)
        return lambda s: kind(signal, high=scene.peaks[signal] * (1 - 0.08 * s))

    return make


def _steps(rng: Random, scene: Scene) -> Callable[[float], Effect | Fault]:
    signal = _one_of(scene.setup.signals, rng)
    return lambda s: instruments.Quantisation(signal, 3 * USUAL[signal] * s)


WRONG: Mapping[str, tuple[str, ...]] = {
    "Isotonic": ("load.m", "muscle.L0", "muscle.D0", "p_supply"), "Isometric": ("muscle.L0", "muscle.D0", "p_supply"),
    "SwitchedMuscle": ("muscle.L0", "p_supply"), "Antagonistic": ("p_supply",),
    "VerticalLoad": ("load.m", "muscle.L0"), "TankFilling": ("p_supply",),
}  # fmt: skip
"""What may be stated wrongly; not what only counts together with a parameter that is free, as a tank's volume."""


def _may_be_wrong(design: Design, name: str) -> bool:
    # one load for all runs, stated wrongly, is one that something else hangs beside
    one_load = name == "load.m" and (design.sixth == "load.m" or design.runs < 3)
    return name in WRONG.get(design.bench, ()) and design.sixth != name and not one_load


def _wrong(name: str, unit: float) -> FaultForm:
    def make(rng: Random, scene: Scene) -> Callable[[float], Effect | Fault]:
        return lambda s: WrongParameter(name, 1 + unit * s)

    return FaultForm(
        "wrong_parameter", name.rpartition(".")[2], True, lambda design: _may_be_wrong(design, name), make,
        high=0.25 / unit, signed=True,
    )  # fmt: skip


def _manometer(
    family: str, name: str, catalogue: bool, of: Callable[[str], Make], high: float, signed: bool
) -> FaultForm:
    """A fault of one of the manometers."""

    def make(rng: Random, scene: Scene) -> Callable[[float], Effect | Fault]:
        return of(_one_of(_manometers(scene.setup.design), rng))(rng, scene)

    return FaultForm(
        family, name, catalogue, lambda d: bool(_manometers(d)), make, high=high, signed=signed
    )


FAULTS: tuple[FaultForm, ...] = (
    _manometer("pressure_offset", "offset", True, lambda s: _offset(s, 3e3), 15.0, True),
    _manometer("pressure_offset", "gain", True, lambda s: _gain(s, 0.03), 10.0, True),
    _manometer("pressure_offset", "bow", False, lambda s: _bow(s, 2e3), 10.0, True),
    _manometer("pressure_sensor_lag", "first_order", True, lambda s: _lag(s, 0.03), 12.0, False),
    _manometer("pressure_sensor_lag", "two_lags", False, lambda s: _two_lags(s, 0.02), 12.0, False),
    _manometer("pressure_sensor_lag", "dead_time", False, lambda s: _dead_time(s, 0.03), 10.0, False),
    FaultForm("position_sensor", "offset", True, _reads("x"), _offset("x", 1e-3), signed=True),
    FaultForm("position_sensor", "gain", True, _reads("x"), _gain("x", 0.03), high=10.0, signed=True),
    FaultForm("position_sensor", "lag", True, _reads("x"), _lag("x", 0.03), high=12.0),
    FaultForm("position_sensor", "bow", False, _reads("x"), _bow("x", 1e-3), high=10.0, signed=True),
    FaultForm("position_sensor", "dead_time", False, _reads("x"), _dead_time("x", 0.03), high=10.0),
    FaultForm("force_sensor", "offset", True, _reads("F"), _offset("F", 4.0), signed=True),
    FaultForm("force_sensor", "gain", True, _reads("F"), _gain("F", 0.03), high=10.0, signed=True),
    FaultForm("force_sensor", "lag", True, _reads("F"), _lag("F", 0.03), high=12.0),
    FaultForm("force_sensor", "bow", False, _reads("F"), _bow("F", 4.0), high=10.0, signed=True),
    FaultForm("temperature_sensor", "offset", True, _reads("T"), _offset("T", 1.0), signed=True),
    FaultForm("temperature_sensor", "gain", True, _reads("T"), _gain("T", 0.06, 293.15), high=8.0, signed=True),
    FaultForm("thermocouple_lag", "lag", True, _reads("T"), _lag("T", 0.15), high=12.0),
    FaultForm("clock_offset", "shift", True, lambda design: design.bench != "VesselOrifice", _clock, high=20.0),
    _wrong("load.m", 0.03), _wrong("muscle.L0", 0.01), _wrong("muscle.D0", 0.01), _wrong("p_supply", 0.03),
    FaultForm("saturation", "limits", True, lambda d: True, _saturated(instruments.Saturation), high=7.0),
    FaultForm("saturation", "stop", False, lambda d: True, _saturated(instruments.TransducerSaturation), high=7.0),
    FaultForm("quantisation", "steps", True, lambda d: True, _steps, high=12.0),
)  # fmt: skip
"""Both sets hide the same faults: what an instrument can do wrong is known."""

ON_SOME_BENCH: tuple[Form, ...] = (
    Form("rate_friction", "load_frequency", BOTH, True,
         lambda rng, muscle: lambda s: LoadFrequency(0.1 * s, muscle.length), 1e-3, 20.0),
)  # fmt: skip
"""Forms of the catalogue that ask for more than every bench has; they take turns as families of their own do."""
