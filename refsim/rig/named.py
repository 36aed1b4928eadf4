"""Hidden effects by name: `family:form`, optionally `family:form:parameter=value,...`."""

from __future__ import annotations

from dataclasses import fields, replace

from rig.catalogue.creep import Creep
from rig.catalogue.dead_volume import DeadVolume
from rig.catalogue.dry_friction import Coulomb, Dahl
from rig.catalogue.elasticity import CubicSpring, LinearSpring, MooneyRivlin
from rig.catalogue.end_shape import KangEnds, TonduEnds
from rig.catalogue.friction_heat import FrictionHeat
from rig.catalogue.gas_energy import GasEnergy
from rig.catalogue.leak import LaminarLeak, OrificeLeak
from rig.catalogue.moving_mass import HangingMass
from rig.catalogue.pressure_offset import PressureGain, PressureOffset
from rig.catalogue.rate_friction import PowerViscous, PressureViscous, Viscous
from rig.catalogue.thermocouple_lag import ThermocoupleLag
from rig.catalogue.valve_area import BackPressure
from rig.catalogue.valve_dynamics import ValveDeadTime, ValveLag, ValveSecondOrder
from rig.catalogue.wall_heat import WarmWall
from rig.effect import Effect
from rig.seen.elasticity import ExponentialSpring
from rig.seen.gas_energy import InletJet
from rig.seen.leak import PressedLip
from rig.seen.none_of_these import Coupled, Ripple

__all__ = ["EFFECTS", "UNLISTED", "Effect", "effect_name", "effect_of", "effect_parameters"]

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

"""Effects with an ordinary size, by which a command line can ask for them."""

UNLISTED: dict[str, Effect] = {
    "ripple": Ripple(),
    "coupled": Coupled(),
    "pressed_lip": PressedLip(),
    "inlet_jet": InletJet(),
}
"""Effects that the catalogue does not hold, to see what a diagnosis makes of them."""


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
