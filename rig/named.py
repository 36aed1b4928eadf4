"""Hidden effects by name: `family:form`, optionally `family:form:parameter=value,...`."""

from __future__ import annotations

from dataclasses import fields, replace

from rig.catalogue.force import (
    Coulomb,
    Creep,
    CubicSpring,
    Dahl,
    ExponentialSpring,
    HangingMass,
    KangEnds,
    LinearSpring,
    MooneyRivlin,
    PowerViscous,
    PressureViscous,
    TonduEnds,
    Viscous,
)
from rig.catalogue.gas import DeadVolume, LaminarLeak, OrificeLeak
from rig.catalogue.heat import FrictionHeat, GasEnergy, WarmWall
from rig.catalogue.sensor import PressureGain, PressureOffset, ThermocoupleLag
from rig.catalogue.valve import BackPressure, ValveDeadTime, ValveLag, ValveSecondOrder
from rig.effect import Effect

__all__ = ["EFFECTS", "Effect", "effect_name", "effect_of", "effect_parameters"]

EFFECTS: tuple[type[Effect], ...] = (
    Effect,
    LinearSpring, CubicSpring, ExponentialSpring, MooneyRivlin,
    Coulomb, Dahl,
    Viscous, PressureViscous, PowerViscous,
    OrificeLeak, LaminarLeak,
    ValveLag, ValveDeadTime, ValveSecondOrder,
    GasEnergy,
    ThermocoupleLag,
    Creep,
    TonduEnds, KangEnds,
    HangingMass,
    BackPressure,
    DeadVolume,
    WarmWall,
    FrictionHeat,
    PressureOffset, PressureGain,
)  # fmt: skip


def effect_name(effect: Effect | type[Effect]) -> str:
    """`family:form`."""
    return f"{effect.family}:{effect.form}"


def effect_parameters(effect: Effect) -> dict[str, float]:
    """Parameters in SI units."""
    return {field.name: getattr(effect, field.name) for field in fields(effect)}


def effect_of(text: str) -> Effect:
    """The effect that `family:form[:parameter=value,...]` names; `none` alone is allowed.

    Raises ValueError for an unknown name or parameter.
    """
    family, form, settings = ([*text.split(":", 2), "", ""])[:3]
    known = {effect_name(kind): kind for kind in EFFECTS}
    name = f"{family}:{form or 'none'}"
    if name not in known:
        raise ValueError(f"no effect '{text}'; known: {', '.join(known)}")
    values = dict(item.split("=", 1) for item in settings.split(",") if item)
    effect = known[name]()
    unknown = set(values) - set(effect_parameters(effect))
    if unknown:
        has = ", ".join(effect_parameters(effect))
        raise ValueError(f"'{name}' has no parameter {', '.join(sorted(unknown))}; it has {has}")
    return replace(effect, **{key: float(value) for key, value in values.items()})
