"""The table: which form of which family, in which set, how it is drawn and how its strength is set.

`catalogue` says whether modelica/PneumaticMuscle/Effects has the same law. A family with several laws in the
catalogue shows some of them in the tuning set and the others in the score set; forms that the catalogue lacks never
occur in both sets. Only where the catalogue has one law (dead volume), both sets use it.

What a line is made of stands in `form.py`. `former.py` has the lines of a score that is published,
`table_further.py` those of a second author's forms.
"""

from __future__ import annotations

import numpy as np

from blind_cases import former, table_further
from blind_cases.form import (
    SETS,
    At,
    Form,
    Make,
    Random,
    excess,
    fraction,
    gas_form,
    plain,
    spread,
    swing,
    tube,
)
from rig import catalogue, seen
from rig.effect import Effect
from rig.muscle import MuscleParameters

__all__ = ["FAMILIES", "FORMS", "SETS", "STRANGE", "Form"]


def _mooney_rivlin(rng: Random, muscle: MuscleParameters) -> At:
    ratio = spread(rng, 0.02, 0.2)
    shape = {
        "length": muscle.length, "diameter": muscle.diameter, "thickness": muscle.t_wall, "turns": muscle.turns,
    }  # fmt: skip
    unit = 1.2e5 * 0.254e-3 / muscle.t_wall
    return lambda s: catalogue.elasticity.MooneyRivlin(c10=unit * s, c01=ratio * unit * s, **shape)


def _young(rng: Random, muscle: MuscleParameters) -> At:
    unit = 6e5 * 0.254e-3 / muscle.t_wall
    return lambda s: catalogue.elasticity.YoungTube(
        unit * s, muscle.length, muscle.diameter, muscle.t_wall, muscle.turns
    )


def _rubber_tube(muscle: MuscleParameters) -> tuple[float, float, float, float]:
    """What a ``seen.elasticity.BraidedTube`` is made of."""
    return (muscle.length, muscle.diameter, muscle.t_wall, muscle.turns)


def _gent(rng: Random, muscle: MuscleParameters) -> At:
    limit, unit = spread(rng, 2.5, 8.0), 2.4e5 * 0.254e-3 / muscle.t_wall
    return lambda s: seen.elasticity.GentTube(*_rubber_tube(muscle), unit * s, limit)


def _cubic(rng: Random, muscle: MuscleParameters) -> At:
    k1, k3 = rng.uniform(40.0, 150.0), spread(rng, 2e4, 1e5)
    return lambda s: catalogue.elasticity.CubicSpring(k1 * s, k3 * s)


def _exponential(rng: Random, muscle: MuscleParameters) -> At:
    x0 = muscle.length * rng.uniform(0.1, 0.2)
    return lambda s: seen.elasticity.ExponentialSpring(5.0 * s, x0)


def _locking(rng: Random, muscle: MuscleParameters) -> At:
    x_lock = muscle.length * rng.uniform(0.36, 0.46)
    return lambda s: seen.elasticity.LockingSpring(120.0 * s, x_lock)


def _load_rate(rng: Random, muscle: MuscleParameters) -> At:
    return lambda s: catalogue.rate_friction.LoadRate(
        0.5 * s, muscle.length, muscle.fibre_squared, muscle.turns
    )


def _kerscher(rng: Random, muscle: MuscleParameters) -> At:
    eps_0 = spread(rng, 0.05, 0.2)
    return lambda s: catalogue.end_shape.KerscherEnds(0.1 * s, eps_0, muscle.length)


def _bulging(rng: Random, muscle: MuscleParameters) -> At:
    return lambda s: seen.end_shape.BulgingEnds(0.4 * s, muscle.length)


def _rocker(rng: Random, muscle: MuscleParameters) -> At:
    radius = muscle.length * rng.uniform(0.42, 0.7)
    return lambda s: seen.moving_mass.Rocker(4.0 * s, radius)


def _storage(rng: Random, muscle: MuscleParameters) -> At:
    """The base wall is the one without capacity and with equal films."""
    r, half = spread(rng, 0.5, 4.0), muscle.t_wall / (2 * muscle.k_wall)
    shape = (muscle.length, muscle.fibre_squared, muscle.turns, muscle.fibre_area)
    return lambda s: catalogue.wall_heat.StorageWall(
        0.4 * s, r ** min(s, 1.0), muscle.h_film, half, *shape
    )


def _late_heat(rng: Random, muscle: MuscleParameters) -> At:
    tau = spread(rng, 0.1, 0.5)
    crossing = muscle.crossing_area * muscle.mu_d * muscle.k_f
    return lambda s: seen.friction_heat.LateHeat(s, tau, crossing)


def _curved_pressure(rng: Random, muscle: MuscleParameters) -> At:
    c = rng.uniform(0.5, 1.5)
    return lambda s: seen.pressure_offset.CurvedPressure(3e3 * s, c)


def _conductive(rng: Random, muscle: MuscleParameters) -> At:
    h, wall = spread(rng, 8.0, 60.0), muscle.t_wall / muscle.k_wall
    return lambda s: seen.gas_energy.ConductiveGas(h, wall, muscle.length, muscle.fibre_squared)


def _stem(rng: Random, muscle: MuscleParameters) -> At:
    """The longer the lag, the thicker the wire, and the more its stem conducts."""
    c = spread(rng, 0.03, 0.15)
    return lambda s: seen.thermocouple_lag.StemThermocouple(0.15 * s, min(c * s, 0.5))


def _ogden(rng: Random, muscle: MuscleParameters) -> At:
    unit = 2.4e5 * 0.254e-3 / muscle.t_wall
    return lambda s: seen.elasticity.OgdenTube(*_rubber_tube(muscle), unit * s)


def _slack_cord(rng: Random, muscle: MuscleParameters) -> At:
    x_0 = muscle.length * rng.uniform(0.04, 0.12)
    return lambda s: seen.elasticity.SlackCord(400.0 * s, x_0)


def _capstan(rng: Random, muscle: MuscleParameters) -> At:
    width = spread(rng, 2e-4, 1e-3)
    return lambda s: seen.dry_friction.Capstan(
        0.1 * s, muscle.length, muscle.fibre_squared, muscle.turns, width
    )


def _sheared_matrix(rng: Random, muscle: MuscleParameters) -> At:
    return lambda s: seen.rate_friction.ShearedMatrix(60.0 * s, muscle.length, muscle.fibre_squared)


def _conical(rng: Random, muscle: MuscleParameters) -> At:
    return lambda s: seen.end_shape.ConicalEnds(0.1 * s, muscle.length, muscle.fibre_squared)


def _silencer(rng: Random, muscle: MuscleParameters) -> At:
    """A silencer is the smaller the stronger; the exponent keeps the strength's own scale near linear."""
    return lambda s: seen.valve_area.CloggedSilencer(5e-7 / s**0.5)


def _pulled_crimp(rng: Random, muscle: MuscleParameters) -> At:
    return lambda s: seen.leak.PulledCrimp(
        2e-11 * s, muscle.length, muscle.fibre_squared, muscle.turns
    )


def _soaked(rng: Random, muscle: MuscleParameters) -> At:
    tau = spread(rng, 0.1, 0.6)
    crossing = muscle.crossing_area * muscle.mu_d * muscle.k_f
    return lambda s: seen.friction_heat.SoakedHeat(
        s, tau, crossing, muscle.mu_fb * muscle.fibre_area
    )


def _ripple(kind: type[Effect], unit: float) -> Make:
    def make(rng: Random, muscle: MuscleParameters) -> At:
        pitch = rng.uniform(4e-3, 1e-2)
        return lambda s: kind(size=unit * s, pitch=pitch)

    return make


def _swinging_load(rng: Random, muscle: MuscleParameters) -> At:
    shape = {"frequency": spread(rng, 1.2, 4.0), "damping": spread(rng, 0.01, 0.08)}
    return lambda s: seen.none_of_these.SpringLoad(part=0.3 * s, **shape)


def _second_consumer(rng: Random, muscle: MuscleParameters) -> At:
    period, on = spread(rng, 1.5, 4.0), rng.uniform(0.25, 0.6)
    first = rng.uniform(0.0, 1.0)
    return lambda s: seen.none_of_these.SecondConsumer(period, on, first, 0.06 * s)


def _second_weight(rng: Random, muscle: MuscleParameters) -> At:
    x_1 = muscle.length * rng.uniform(0.1, 0.2)
    return lambda s: seen.none_of_these.SecondWeight(0.5 * s, x_1)


def _restless(rng: Random, muscle: MuscleParameters) -> At:
    shape = {
        "tau": spread(rng, 1.5, 5.0),
        "frequency": spread(rng, 0.8, 2.5),
        "phase": rng.uniform(0.0, 6.28),
    }
    return lambda s: seen.none_of_these.RestlessStart(size=8.0 * s, **shape)


def _sticky(rng: Random, muscle: MuscleParameters) -> At:
    start = int(rng.integers(0, 1000))
    return lambda s: seen.none_of_these.StickyValves(0.15 * s, start)


def _yeoh(rng: Random, muscle: MuscleParameters) -> At:
    r2, r3, unit = (
        rng.uniform(0.03, 0.1),
        spread(rng, 0.003, 0.02),
        1.2e5 * 0.254e-3 / muscle.t_wall,
    )
    return lambda s: seen.elasticity.YeohTube(*_rubber_tube(muscle), unit * s, r2, r3)


def _viscous_bladder(rng: Random, muscle: MuscleParameters) -> At:
    wall = np.pi * muscle.diameter * muscle.t_wall * muscle.length
    unit = 1e5 * 0.254e-3 / muscle.t_wall
    return lambda s: seen.rate_friction.ViscousBladder(
        unit * s, wall, muscle.length, muscle.fibre_squared
    )


def _rounded_tips(rng: Random, muscle: MuscleParameters) -> At:
    return lambda s: seen.end_shape.RoundedTips(
        0.8 * s, muscle.length, muscle.fibre_squared, muscle.turns
    )


def _cut(rng: Random, muscle: MuscleParameters) -> At:
    return lambda s: seen.leak.CutBladder(3e-9 * s, muscle.length, muscle.fibre_squared)


def _moving_contact(rng: Random, muscle: MuscleParameters) -> At:
    v_0 = spread(rng, 0.02, 0.2)
    crossing = muscle.crossing_area * muscle.mu_d * muscle.k_f
    return lambda s: seen.friction_heat.MovingContact(
        s, v_0, crossing, muscle.mu_fb * muscle.fibre_area
    )


def _long_wire(rng: Random, muscle: MuscleParameters) -> At:
    """Both the lag and the square of the decay length go with the square of the wire's thickness."""
    k = spread(rng, 0.3, 1.5)
    return lambda s: seen.thermocouple_lag.LongWire(0.15 * s, min(k * s, 6.0))


def _heat_lamp(rng: Random, muscle: MuscleParameters) -> At:
    period, on, first = spread(rng, 2.0, 5.0), rng.uniform(0.25, 0.6), rng.uniform(0.2, 1.5)
    return lambda s: seen.none_of_these.HeatLamp(period, on, first, 0.8 * s)


T, S, BOTH = ("tuning",), ("score",), SETS

FORMS: tuple[Form, ...] = (
    # family, form, sets, in the catalogue, ...
    Form("elasticity", "linear", T, True, plain(catalogue.elasticity.LinearSpring, "k", 250.0)),
    Form("elasticity", "mooney_rivlin", T, True, _mooney_rivlin),
    Form("elasticity", "young", S, True, _young),
    Form("elasticity", "cubic", S, True, _cubic),
    Form("elasticity", "exponential", T, False, _exponential),
    Form("elasticity", "locking", T, False, _locking),
    Form("elasticity", "arctan", T, False, plain(seen.elasticity.ArctanSpring, "f0", 10.0, x0=(0.01, 0.04))),
    Form("elasticity", "logarithmic", T, False, plain(seen.elasticity.LogSpring, "f0", 8.0, x0=(0.005, 0.03))),
    Form("elasticity", "gent", T, False, _gent),
    Form("elasticity", "ogden", T, False, _ogden),
    Form("elasticity", "slack_cord", T, False, _slack_cord),
    Form("elasticity", "yeoh", T, False, _yeoh),
    Form("elasticity", "side_spring", T, False,
         plain(seen.elasticity.SideSpring, "k", 3000.0, d=(0.05, 0.12), unstretched=(0.8, 0.97))),
    Form("dry_friction", "coulomb", T, True, plain(catalogue.dry_friction.Coulomb, "f_c", 8.0, width=(1e-4, 2e-3))),
    Form("dry_friction", "dahl", S, True, lambda rng, m: _dahl(rng)),
    Form("dry_friction", "maxwell_slip", S, True,
         plain(catalogue.dry_friction.MaxwellSlip, "f_c", 8.0, travel=(5e-4, 4e-3))),
    Form("dry_friction", "stribeck", T, False,
         plain(seen.dry_friction.Stribeck, "f_c", 8.0, a=(0.2, 0.6), v_s=(0.005, 0.02), width=(2e-4, 1e-3))),
    Form("dry_friction", "lugre", T, False,
         plain(seen.dry_friction.LuGre, "f_c", 8.0, travel=(1e-4, 1e-3), a=(0.2, 0.5), v_s=(0.005, 0.02))),
    Form("dry_friction", "pressed", T, False,
         plain(seen.dry_friction.PressedFriction, "c", 4e-5, p_0=(3e4, 1e5), width=(2e-4, 1e-3))),
    Form("dry_friction", "bouc_wen", T, False,
         plain(seen.dry_friction.BoucWen, "f_c", 8.0, travel=(5e-4, 4e-3), n=(1.2, 3.0), g=(0.5, 0.9))),
    Form("dry_friction", "capstan", T, False, _capstan, high=8.0),
    Form("dry_friction", "ageing", T, False,
         plain(seen.dry_friction.AgeingContact, "f_c", 6.0, b=(0.05, 0.15), d=(5e-4, 2e-3), width=(2e-4, 1e-3))),
    Form("dry_friction", "elasto_plastic", T, False,
         plain(seen.dry_friction.ElastoPlastic, "f_c", 8.0, travel=(3e-4, 3e-3), breakaway=(0.3, 0.8))),
    Form("dry_friction", "wiper", T, False,
         plain(seen.dry_friction.Wiper, "f_c", 8.0, a=(0.15, 0.6), width=(2e-4, 1e-3))),
    Form("rate_friction", "viscous", T, True, plain(catalogue.rate_friction.Viscous, "c", 300.0)),
    Form("rate_friction", "power", T, True, plain(catalogue.rate_friction.PowerViscous, "c", 60.0, a=(0.45, 0.8))),
    Form("rate_friction", "pressure", S, True, plain(catalogue.rate_friction.PressureViscous, "c", 3e-3)),
    Form("rate_friction", "load_rate", S, True, _load_rate),
    Form("rate_friction", "growing", T, False, plain(seen.rate_friction.GrowingViscous, "c", 120.0, x_0=(0.01, 0.05))),
    Form("rate_friction", "eyring", T, False, plain(seen.rate_friction.Eyring, "c", 600.0, v_0=(0.005, 0.03))),
    Form("rate_friction", "one_sided", T, False,
         plain(seen.rate_friction.OneSidedViscous, "c", 300.0, share=(0.1, 0.5))),
    Form("rate_friction", "film", T, False, plain(seen.rate_friction.FilmFriction, "c", 0.25)),
    Form("rate_friction", "orifice_damper", T, False,
         plain(seen.rate_friction.OrificeDamper, "c", 100.0, v_0=(0.005, 0.04))),
    Form("rate_friction", "eddy_brake", T, False, plain(seen.rate_friction.EddyBrake, "c", 300.0, v_k=(0.04, 0.15))),
    Form("rate_friction", "sheared_matrix", T, False, _sheared_matrix),
    Form("rate_friction", "thixotropic", T, False,
         plain(seen.rate_friction.ThixotropicGrease, "c", 400.0, r=(0.2, 0.5), d=(5e-3, 3e-2), tau=(1.0, 6.0))),
    Form("rate_friction", "viscous_bladder", T, False, _viscous_bladder),
    Form("creep", "maxwell", T, True, plain(catalogue.creep.Creep, "k", 400.0, tau=(0.5, 4.0))),
    Form("creep", "prony", S, True, plain(catalogue.creep.Prony, "k", 250.0, ratio=(0.3, 2.0), tau=(0.3, 1.5))),
    Form("creep", "eyring", T, False, plain(seen.creep.EyringCreep, "k", 400.0, tau=(1.0, 5.0), x_0=(0.008, 0.03))),
    Form("creep", "fractional", T, False, plain(seen.creep.FractionalCreep, "k", 150.0, a=(0.1, 0.5))),
    Form("creep", "fung", T, False, plain(seen.creep.FungCreep, "k", 200.0, tau=(0.5, 4.0), x_0=(0.02, 0.06))),
    Form("creep", "power_flow", T, False,
         plain(seen.creep.FlowingRubber, "k", 400.0, tau=(0.5, 3.0), x_0=(0.008, 0.03), m=(2.0, 4.0))),
    Form("creep", "slow_recovery", T, False, plain(seen.creep.SlowRecovery, "k", 400.0, tau=(0.4, 2.0), r=(2.5, 8.0))),
    Form("creep", "strain_hardening", T, False,
         plain(seen.creep.HardeningCreep, "k", 400.0, tau=(0.1, 0.6), x_0=(3e-3, 1e-2), m=(1.0, 3.0))),
    Form("creep", "time_temperature", T, False, plain(seen.creep.WarmCreep, "k", 400.0, tau=(0.5, 4.0))),
    Form("end_shape", "tondu", T, True, excess(catalogue.end_shape.TonduEnds, "k", 0.06), high=8.0),
    Form("end_shape", "kang", S, True, plain(catalogue.end_shape.KangEnds, "c1", 0.2, p0=(5e4, 3e5)), high=15.0),
    Form("end_shape", "kerscher", S, True, _kerscher, high=6.0),
    Form("end_shape", "bulging", T, False, _bulging, high=4.0),
    Form("end_shape", "spread", T, False, plain(seen.end_shape.SpreadEnds, "c", 0.15, p_0=(2e5, 4e5)), high=8.0),
    Form("end_shape", "loose_bladder", T, False,
         plain(seen.end_shape.LooseBladder, "c", 0.08, p_0=(2e4, 1e5)), high=11.0),
    Form("end_shape", "conical", T, False, _conical, high=8.0),
    Form("end_shape", "bent_fibres", T, False,
         plain(seen.end_shape.BentFibres, "c", 0.15, p_0=(1e4, 6e4)), high=10.0),
    Form("end_shape", "rounded_tips", T, False, _rounded_tips, high=3.5),
    Form("end_shape", "unfolding", T, False,
         plain(seen.end_shape.UnfoldingEnds, "c", 0.15, p_0=(3e4, 1e5)), high=6.0),
    Form("moving_mass", "hanging", T, True, plain(catalogue.moving_mass.HangingMass, "m", 0.5)),
    Form("moving_mass", "balanced", S, True, plain(catalogue.moving_mass.BalancedMass, "m", 3.0)),
    Form("moving_mass", "counterweight", T, False, plain(seen.moving_mass.Counterweight, "m", 1.5, w=(0.15, 0.4))),
    Form("moving_mass", "lever", T, False, plain(seen.moving_mass.Lever, "m", 2.0, x_0=(0.03, 0.1))),
    Form("moving_mass", "rocker", T, False, _rocker),
    Form("moving_mass", "slipping_flywheel", T, False,
         plain(seen.moving_mass.SlippingFlywheel, "m", 4.0, tau=(0.01, 0.08))),
    Form("moving_mass", "belted_flywheel", T, False,
         plain(seen.moving_mass.BeltedFlywheel, "m", 3.0, frequency=(8.0, 20.0), damping=(0.1, 0.4))),
    Form("moving_mass", "winding_drum", T, False, plain(seen.moving_mass.WindingDrum, "m", 4.0, x_0=(0.05, 0.2))),
    Form("moving_mass", "side_sled", T, False,
         plain(seen.moving_mass.SideSled, "m", 6.0, a=(0.02, 0.08), d=(0.05, 0.15))),
    Form("valve_dynamics", "lag", T, True, plain(catalogue.valve_dynamics.ValveLag, "tau", 0.05)),
    Form("valve_dynamics", "dead_time", S, True,
         plain(catalogue.valve_dynamics.ValveDeadTime, "dead_time", 0.05), high=8.0),
    Form("valve_dynamics", "second_order", S, True, lambda rng, m: _second_order(rng)),
    Form("valve_dynamics", "two_speeds", T, False,
         plain(seen.valve_dynamics.TwoSpeedValve, "tau", 0.06, ratio=(0.3, 0.7))),
    Form("valve_dynamics", "rate_limit", T, False, plain(seen.valve_dynamics.SlowRateValve, "time_per_amp", 0.3)),
    Form("valve_dynamics", "delayed_lag", T, False,
         plain(seen.valve_dynamics.DelayedLagValve, "tau", 0.03), high=15.0),
    Form("valve_dynamics", "eddy_currents", T, False,
         plain(seen.valve_dynamics.EddyValve, "tau", 0.1, at_once=(0.3, 0.7)), high=8.0),
    Form("valve_dynamics", "saturating_coil", T, False,
         plain(seen.valve_dynamics.SaturatingCoil, "tau", 0.1, u_s=(0.1, 0.3))),
    Form("valve_dynamics", "pilot_stage", T, False, plain(seen.valve_dynamics.PilotStage, "time", 0.04)),
    Form("valve_dynamics", "held_command", T, False,
         plain(seen.valve_dynamics.HeldCommand, "cycle", 0.05, first=(0.2, 0.9)), 0.2, 6.0),
    Form("valve_dynamics", "three_lags", T, False, plain(seen.valve_dynamics.ThreeLags, "tau", 0.02)),
    Form("valve_area", "back_pressure", T, True, plain(catalogue.valve_area.BackPressure, "beta", 0.15), high=5.5),
    Form("valve_area", "current_offset", S, True,
         plain(catalogue.valve_area.CurrentOffset, "u_0", 0.01), high=5.0, signed=True),
    Form("valve_area", "unequal", S, True, excess(catalogue.valve_area.UnequalAreas, "r", 0.1), high=6.0, signed=True),
    Form("valve_area", "lifted_seat", T, False,
         plain(seen.valve_area.PumpedArea, "beta", 0.08), high=6.0, signed=True),
    Form("valve_area", "curved", T, False, plain(seen.valve_area.CurvedArea, "c", 0.2), high=6.0, signed=True),
    Form("valve_area", "pressed", T, False, plain(seen.valve_area.PressedArea, "beta", 0.08), high=10.0),
    Form("valve_area", "critical_ratio", T, False, plain(seen.valve_area.CriticalRatio, "less", 0.05), high=10.0),
    Form("valve_area", "sharp_edge", T, False, plain(seen.valve_area.SharpEdge, "s", 0.4), high=5.0),
    Form("valve_area", "silencer", T, False, _silencer),
    Form("valve_area", "round_port", T, False, plain(seen.valve_area.RoundPort, "share", 0.3), high=3.3),
    Form("valve_area", "narrow_slot", T, False, plain(seen.valve_area.NarrowSlot, "transition", 3e-8), high=20.0),
    Form("supply_line", "long", T, True,
         tube(catalogue.supply_line.LongTube, "area", 5e-7, (2e-6, 1.5e-5)), 0.1, 20.0),
    Form("supply_line", "orifice", S, True, tube(catalogue.supply_line.OrificeTube, "area", 5e-7, None), 0.1, 20.0),
    Form("supply_line", "laminar", S, True,
         tube(catalogue.supply_line.LaminarTube, "conductance", 4e-9, None), 0.02, 15.0),
    Form("supply_line", "turbulent", T, False,
         tube(seen.supply_line.TurbulentTube, "c", 1.2e-9, (1e-6, 8e-6)), 0.1, 10.0),
    Form("supply_line", "two_lumps", T, False,
         tube(seen.supply_line.TwoLumpTube, "conductance", 4e-9, (2e-6, 1.5e-5)), 0.05, 15.0),
    Form("supply_line", "forchheimer", T, False,
         tube(seen.supply_line.ForchheimerTube, "conductance", 6e-9, (1e-6, 8e-6)), 0.05, 15.0),
    Form("supply_line", "blasius", T, False, tube(seen.supply_line.BlasiusTube, "c", 2e-10, (1e-6, 8e-6)), 0.1, 10.0),
    Form("supply_line", "one_way", T, False,
         tube(seen.supply_line.OneWayTube, "conductance", 6e-9, (1e-6, 8e-6), share=(0.2, 0.6)), 0.05, 12.0),
    Form("supply_line", "choked", T, False,
         tube(seen.supply_line.ChokedTube, "conductance", 1e-9, (1e-6, 8e-6), b=(0.05, 0.35)), 0.1, 20.0),
    Form("supply_line", "kinked", T, False,
         tube(seen.supply_line.KinkedHose, "conductance", 4e-9, (1e-6, 8e-6), p_0=(5e4, 2e5)), 0.05, 15.0),
    Form("supply_line", "inertial", T, False,
         tube(seen.supply_line.InertialLine, "conductance", 4e-9, (2e-6, 1.5e-5), inertance=(5e4, 3e5)), 0.05, 15.0),
    Form("dead_volume", "constant", BOTH, True, plain(catalogue.dead_volume.DeadVolume, "volume", 1.5e-5)),
    Form("dead_volume", "isothermal", T, False, plain(seen.dead_volume.CoolChamber, "volume", 1.5e-5)),
    Form("dead_volume", "throttled", T, False,
         plain(seen.dead_volume.SideChamber, "volume", 1.5e-5, conductance=(2e-9, 1e-8))),
    Form("dead_volume", "hose", T, False, plain(seen.dead_volume.Hose, "volume", 1.5e-5, expansion=(2e-6, 8e-6))),
    Form("dead_volume", "dead_end", T, False, plain(seen.dead_volume.DeadEnd, "volume", 1.5e-5, tau=(0.1, 1.0))),
    Form("dead_volume", "orifice_chamber", T, False,
         plain(seen.dead_volume.OrificeChamber, "volume", 1.5e-5, area=(1e-7, 1e-6))),
    Form("dead_volume", "capillary_stub", T, False,
         plain(seen.dead_volume.CapillaryStub, "volume", 1.5e-5, conductance=(5e-10, 1e-8))),
    Form("leak", "orifice", T, True, plain(catalogue.leak.OrificeLeak, "diameter", 1e-4), 0.01, 6.0),
    Form("leak", "laminar", S, True, plain(catalogue.leak.LaminarLeak, "conductance", 2e-11), 1e-4, 40.0),
    Form("leak", "turbulent", T, False, plain(seen.leak.TurbulentLeak, "c", 6e-9)),
    Form("leak", "squared", T, False, plain(seen.leak.SquaredLeak, "c", 4e-17)),
    Form("leak", "lifting", T, False, plain(seen.leak.LiftingLeak, "conductance", 4e-11, p_0=(3e4, 9e4))),
    Form("leak", "lip_seal", T, False, plain(seen.leak.LipSeal, "conductance", 2e-10, p_0=(3e4, 1e5))),
    Form("leak", "stretched_pores", T, False,
         plain(seen.leak.StretchedPores, "conductance", 6e-12, x_0=(0.012, 0.05))),
    Form("leak", "widening_gap", T, False,
         plain(seen.leak.WideningGap, "conductance", 6e-12, p_0=(1e5, 4e5)), 1e-4, 40.0),
    Form("leak", "pulled_crimp", T, False, _pulled_crimp, 1e-4, 40.0),
    Form("leak", "cut", T, False, _cut, 1e-3, 40.0),
    Form("leak", "labyrinth", T, False, plain(seen.leak.Labyrinth, "area", 1e-8, n=(3.0, 12.0)), 1e-3, 40.0),
    gas_form("film", T, True, catalogue.gas_energy.GasEnergy, h=(8.0, 60.0)),
    gas_form("convective", S, True, catalogue.gas_energy.StirredGas, h=(4.0, 10.0), h_1=(10.0, 100.0)),
    gas_form("free_convection", T, False, seen.gas_energy.FreeConvectionGas, h=(8.0, 60.0)),
    gas_form("dense", T, False, seen.gas_energy.DenseGas, h=(6.0, 30.0), a=(0.4, 0.9)),
    Form("gas_energy", "conductive", T, False, _conductive, 1.0, 1.0),
    gas_form("woschni", T, False, seen.gas_energy.WoschniGas, h=(4.0, 20.0), w_0=(0.01, 0.1)),
    gas_form("renewed_film", T, False, seen.gas_energy.RenewedFilm, h=(5.0, 20.0), tau=(0.5, 3.0), m_0=(1e-5, 1e-4)),
    gas_form("enclosed_convection", T, False, seen.gas_energy.EnclosedConvection, h=(5.0, 25.0)),
    gas_form("turbulence", T, False, seen.gas_energy.DecayingTurbulence,
              h=(4.0, 12.0), h_1=(5.0, 30.0), eddy=(0.01, 0.04)),
    gas_form("gas_spring", T, False, seen.gas_energy.GasSpring, h=(6.0, 40.0), c=(0.4, 2.5), tau=(0.1, 1.0)),
    Form("wall_heat", "lumped", T, True, fraction(catalogue.wall_heat.WarmWall, 0.4, g_out=(0.005, 0.04)), 0.01, 20.0),
    Form("wall_heat", "storage", S, True, _storage, 0.01, 20.0),
    Form("wall_heat", "free_convection", T, False,
         fraction(seen.wall_heat.FreeConvectionWall, 0.4, g_out=(0.005, 0.04)), 0.01, 20.0),
    Form("wall_heat", "two_layers", T, False,
         fraction(seen.wall_heat.TwoLayerWall, 0.3, ratio=(1.0, 5.0), between=(0.03, 0.2), g_out=(0.005, 0.04)),
         0.01, 20.0),
    Form("wall_heat", "diffusion", T, False,
         fraction(seen.wall_heat.ThickWall, 0.8, tau=(3.0, 20.0), g_out=(0.005, 0.04)), 0.01, 20.0),
    Form("wall_heat", "pressed_layers", T, False,
         fraction(seen.wall_heat.PressedLayers, 0.3, ratio=(1.0, 4.0), between=(0.05, 0.3), g_out=(0.005, 0.04)),
         0.01, 20.0),
    Form("wall_heat", "fanned", T, False,
         fraction(seen.wall_heat.FannedWall, 0.4, g_out=(0.005, 0.04), v_0=(0.01, 0.06)), 0.01, 20.0),
    Form("wall_heat", "metal_ends", T, False,
         fraction(seen.wall_heat.MetalEnds, 0.4, ratio=(3.0, 20.0), g_out=(0.005, 0.04), g_end=(0.01, 0.1)),
         0.01, 20.0),
    Form("friction_heat", "fibre", T, True, plain(catalogue.friction_heat.FibreHeat, "share", 1.0), high=1.0),
    Form("friction_heat", "share", S, True, plain(catalogue.friction_heat.FrictionHeat, "share", 1.0), high=1.0),
    Form("friction_heat", "late", T, False, _late_heat, high=1.0),
    Form("friction_heat", "contraction", T, False, plain(seen.friction_heat.RisingHeat, "share", 1.0), high=1.0),
    Form("friction_heat", "bladder", T, False, plain(seen.friction_heat.BladderHeat, "share", 1.0), high=1.0),
    Form("friction_heat", "soaked", T, False, _soaked, high=1.0),
    Form("friction_heat", "moving_contact", T, False, _moving_contact, high=1.0),
    Form("thermocouple_lag", "first_order", T, True, plain(catalogue.thermocouple_lag.ThermocoupleLag, "tau", 0.15)),
    Form("thermocouple_lag", "sheath", S, True, plain(catalogue.thermocouple_lag.Sheath, "tau", 0.15, r=(0.1, 0.8))),
    Form("thermocouple_lag", "blown", T, False,
         plain(seen.thermocouple_lag.BlownThermocouple, "tau", 0.3, m_0=(1e-5, 1e-4))),
    Form("thermocouple_lag", "two_parts", T, False,
         plain(seen.thermocouple_lag.TwoPartThermocouple, "tau", 0.1, share=(0.3, 0.7))),
    Form("thermocouple_lag", "dense_air", T, False,
         plain(seen.thermocouple_lag.DenseAirThermocouple, "tau", 0.3, a=(0.3, 0.6))),
    Form("thermocouple_lag", "stem", T, False, _stem),
    Form("thermocouple_lag", "potted", T, False, plain(seen.thermocouple_lag.PottedBead, "tau", 1.0)),
    Form("thermocouple_lag", "buoyant", T, False, plain(seen.thermocouple_lag.BuoyantBead, "tau", 0.25, a=(0.2, 1.0))),
    Form("thermocouple_lag", "three_poles", T, False, plain(seen.thermocouple_lag.ThreePoles, "tau", 0.06)),
    Form("thermocouple_lag", "long_wire", T, False, _long_wire),
    Form("pressure_offset", "constant", T, True,
         plain(catalogue.pressure_offset.PressureOffset, "offset", 3e3), high=15.0, signed=True),
    Form("pressure_offset", "gain", S, True,
         excess(catalogue.pressure_offset.PressureGain, "gain", 0.03), high=10.0, signed=True),
    Form("pressure_offset", "offset_and_gain", T, False, lambda rng, m: _offset_and_gain(rng), high=10.0, signed=True),
    Form("pressure_offset", "fading", T, False,
         plain(seen.pressure_offset.SaturatingPressure, "offset", 5e3, p_0=(8e4, 3e5)), signed=True),
    Form("pressure_offset", "curved", T, False, _curved_pressure, high=10.0, signed=True),
    Form("pressure_offset", "stiffening", T, False, plain(seen.pressure_offset.StiffeningDiaphragm, "c", 0.05)),
    Form("pressure_offset", "bowed", T, False,
         plain(seen.pressure_offset.BowedManometer, "bow", 3e3, p_fs=(2.5e5, 5e5)), high=10.0, signed=True),
    Form("pressure_offset", "bridge", T, False,
         plain(seen.pressure_offset.UnbalancedBridge, "c", 0.04, p_fs=(2.5e5, 5e5)), high=8.0, signed=True),
    *former.FORMS,
    *table_further.FORMS,
)  # fmt: skip
"""Forms of the sixteen families."""

STRANGE: tuple[Form, ...] = (
    Form("none_of_these", "force_ripple", T, False, _ripple(seen.none_of_these.ForceRipple, 5.0), high=6.0),
    Form("none_of_these", "pumping_supply", T, False,
         swing(seen.none_of_these.PumpingSupply, "share", 0.05, (0.3, 1.5)), high=6.0),
    Form("none_of_these", "drifting_ruler", T, False,
         plain(seen.none_of_these.DriftingRuler, "size", 1e-3, period=(4.0, 12.0)), high=8.0),
    Form("none_of_these", "swinging_load", T, False, _swinging_load, high=2.5),
    Form("none_of_these", "snubbed_manometer", T, False,
         plain(seen.none_of_these.SnubbedManometer, "tau", 0.05), high=8.0),
    Form("none_of_these", "sensor_backlash", T, False,
         plain(seen.none_of_these.SensorBacklash, "gap", 1e-3), high=5.0),
    Form("none_of_these", "second_weight", T, False, _second_weight, high=4.0),
    Form("none_of_these", "vibration", T, False,
         swing(seen.none_of_these.Vibration, "size", 4.0, (0.6, 3.0)), high=6.0),
    Form("none_of_these", "sticky_valves", T, False, _sticky, high=5.0),
    Form("none_of_these", "filtered_ruler", T, False, plain(seen.none_of_these.FilteredRuler, "tau", 0.05), high=8.0),
    Form("none_of_these", "encoder_error", T, False, _ripple(seen.none_of_these.EncoderError, 5e-4)),
    Form("none_of_these", "nudge", T, False,
         plain(seen.none_of_these.Nudge, "size", 20.0, start=(1.5, 4.0), duration=(0.3, 1.0)), high=6.0),
    Form("none_of_these", "second_consumer", T, False, _second_consumer, high=6.0),
    Form("none_of_these", "warming_junction", T, False,
         plain(seen.none_of_these.WarmingJunction, "size", 2.0, tau=(1.5, 6.0)), signed=True),
    Form("none_of_these", "mains_hum", T, False,
         swing(seen.none_of_these.MainsHum, "size", 3e3, (0.15, 0.6)), high=8.0),
    Form("none_of_these", "cross_talk", T, False, plain(seen.none_of_these.CrossTalk, "size", 4e-3), signed=True),
    Form("none_of_these", "clock_skew", T, False,
         plain(seen.none_of_these.ClockSkew, "skew", 0.01), high=6.0, signed=True),
    Form("none_of_these", "loose_contact", T, False,
         plain(seen.none_of_these.LooseContact, "off", 0.08, period=(0.9, 2.0), first=(0.2, 0.8)), high=8.0),
    Form("none_of_these", "slipped_ruler", T, False,
         plain(seen.none_of_these.SlippedRuler, "size", 1e-3, at=(1.5, 4.0)), signed=True),
    Form("none_of_these", "oblique_string", T, False,
         plain(seen.none_of_these.ObliqueString, "d", 0.08, a=(0.15, 0.4)), high=5.0),
    Form("none_of_these", "warm_coils", T, False, plain(seen.none_of_these.WarmCoils, "size", 2.0, tau=(0.8, 4.0))),
    Form("none_of_these", "restless_start", T, False, _restless, high=6.0),
    Form("none_of_these", "empty_bottle", T, False, plain(seen.none_of_these.EmptyBottle, "share", 0.15), high=4.0),
    Form("none_of_these", "heat_lamp", T, False, _heat_lamp, high=8.0),
    Form("none_of_these", "buffer_tank", T, False,
         plain(seen.none_of_these.BufferTank, "per_kilogram", 200.0, tau=(1.0, 6.0))),
    Form("none_of_these", "sagging_excitation", T, False,
         plain(seen.none_of_these.SaggingExcitation, "share", 0.02), high=10.0, signed=True),
    Form("none_of_these", "holding_magnet", T, False,
         plain(seen.none_of_these.HoldingMagnet, "size", 12.0, d=(5e-4, 3e-3))),
    Form("none_of_these", "own_clock", T, False,
         plain(seen.none_of_these.OwnClock, "skew", 0.01), high=6.0, signed=True),
    Form("none_of_these", "self_heating", T, False,
         plain(seen.none_of_these.SelfHeating, "size", 2.0, m_0=(1e-5, 1e-4))),
    *former.STRANGE,
)  # fmt: skip
"""Effects in no family."""

FAMILIES: tuple[str, ...] = tuple(dict.fromkeys(form.family for form in FORMS))
"""The sixteen, in the order of the table."""


def _dahl(rng: Random) -> At:
    travel = spread(rng, 1e-4, 2e-3)
    return lambda s: catalogue.dry_friction.Dahl(8.0 * s, 8.0 * s / travel)


def _second_order(rng: Random) -> At:
    zeta = rng.uniform(0.4, 1.2)
    return lambda s: catalogue.valve_dynamics.ValveSecondOrder(30.0 / s, zeta)


def _offset_and_gain(rng: Random) -> At:
    p_0 = rng.uniform(3e4, 1.2e5)
    return lambda s: seen.pressure_offset.OffsetAndGain(1 + 0.04 * s, p_0)
