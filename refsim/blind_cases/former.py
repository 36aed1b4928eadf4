"""Lines of the table for the forms of the score on seven benches, which is published: looked at, and still its own.

The forms are in `rig.seen`. They stay in the set `score`, so that the cases of its score can be made again.
"""

from __future__ import annotations

from blind_cases.form import (
    At,
    Form,
    Make,
    Random,
    braided,
    fraction,
    gas_form,
    plain,
    spread,
    tube,
)
from rig import seen
from rig.effect import Effect
from rig.muscle import MuscleParameters

S = ("score",)


def _rubber(kind: type[Effect], name: str, bounds: tuple[float, float] | None = None) -> Make:
    """A tube of the bladder's size; its modulus is for the paper's wall, thicker ones are softer."""

    def make(rng: Random, muscle: MuscleParameters) -> At:
        tube_of = (muscle.length, muscle.diameter, muscle.t_wall, muscle.turns)
        drawn = {name: spread(rng, *bounds)} if bounds else {}
        unit = 2.4e5 * 0.254e-3 / muscle.t_wall
        return lambda s: kind(*tube_of, unit * s, **drawn)

    return make


def _rubbed(kind: type[Effect], /, **shapes: tuple[float, float]) -> Make:
    """The share of the heat of friction, whose forces are the muscle's."""

    def make(rng: Random, muscle: MuscleParameters) -> At:
        drawn = {name: spread(rng, *bounds) for name, bounds in shapes.items()}
        crossing = muscle.crossing_area * muscle.mu_d * muscle.k_f
        return lambda s: kind(
            share=s, crossing=crossing, covered=muscle.mu_fb * muscle.fibre_area, **drawn
        )

    return make


def _two_patches(rng: Random, muscle: MuscleParameters) -> At:
    drawn = {
        "ratio": spread(rng, 3.0, 10.0),
        "share": spread(rng, 0.3, 0.7),
        "g_out": spread(rng, 0.005, 0.04),
    }
    base = {
        "coefficient": muscle.heat_coefficient, "length": muscle.length, "fibre_squared": muscle.fibre_squared,
        "turns": muscle.turns, "fibre_area": muscle.fibre_area,
    }  # fmt: skip
    return lambda s: seen.wall_heat.TwoPatches(0.2 / s, **drawn, **base)


def _smaller(kind: type[Effect], parameter: str, unit: float) -> Make:
    """A restriction is the smaller the stronger; the root keeps the strength's own scale near linear."""
    return lambda rng, muscle: lambda s: kind(**{parameter: unit / s**0.5})


def _crank(rng: Random, muscle: MuscleParameters) -> At:
    radius, a = muscle.length * spread(rng, 0.3, 0.6), muscle.length * spread(rng, 0.05, 0.12)
    return lambda s: seen.moving_mass.Crank(1.5 * s, radius, a)


def _detent(rng: Random, muscle: MuscleParameters) -> At:
    x_1, width = muscle.length * rng.uniform(0.04, 0.12), spread(rng, 8e-4, 3e-3)
    return lambda s: seen.none_of_these.Detent(10.0 * s, x_1, width)


def _slow_reel(rng: Random, muscle: MuscleParameters) -> At:
    return lambda s: seen.none_of_these.SlowReel(0.03 / s)


FORMS: tuple[Form, ...] = (
    # family, form, sets, in the catalogue, ...
    Form("elasticity", "eight_chain", S, False, _rubber(seen.elasticity.EightChain, "links", (1.6, 6.0))),
    Form("elasticity", "prestretched", S, False, _rubber(seen.elasticity.PrestretchedTube, "prestretch", (1.05, 1.3))),
    Form("elasticity", "valanis_landel", S, False, _rubber(seen.elasticity.LogarithmicTube, "")),
    Form("dry_friction", "crossing_contact", S, False,
         braided(seen.dry_friction.CrossingContact, "c", 6e-5, width=(2e-4, 1e-3))),
    Form("dry_friction", "carried_pressure", S, False,
         braided(seen.dry_friction.CarriedPressure, "c", 8e-5, p_b=(5e4, 2e5), travel=(3e-4, 3e-3))),
    Form("dry_friction", "bliman_sorine", S, False,
         plain(seen.dry_friction.BreakawayByWay, "f_c", 7.0, a=(0.3, 0.8), travel=(1e-3, 5e-3))),
    Form("rate_friction", "carreau", S, False,
         plain(seen.rate_friction.ThinningOil, "c", 400.0, v_0=(0.01, 0.04), n=(0.3, 0.7))),
    Form("rate_friction", "warm_grease", S, False,
         plain(seen.rate_friction.WarmGrease, "c", 300.0, theta_0=(6.0, 20.0), tau=(0.2, 1.5))),
    Form("rate_friction", "turning_crossings", S, False, braided(seen.rate_friction.TurningCrossings, "c", 4e-3)),
    Form("creep", "hoop_relaxation", S, False, braided(seen.creep.HoopRelaxation, "k", 2.0, tau=(0.5, 4.0))),
    Form("creep", "stretched_exponential", S, False,
         plain(seen.creep.StretchedExponential, "k", 400.0, tau=(0.5, 3.0))),
    Form("end_shape", "round_caps", S, False, braided(seen.end_shape.RoundCaps, "c", 0.4, True), high=5.0),
    Form("end_shape", "uneven_braid", S, False,
         braided(seen.end_shape.UnevenBraid, "more", 0.05, share=(0.1, 0.3)), high=5.0),
    Form("end_shape", "bridging_bladder", S, False,
         braided(seen.end_shape.BridgingBladder, "c", 0.4, p_0=(5e4, 2e5)), high=4.0),
    Form("moving_mass", "own_wall", S, False, braided(seen.moving_mass.OwnWall, "m", 0.4, True)),
    Form("moving_mass", "crank", S, False, _crank),
    Form("moving_mass", "freewheel", S, False,
         plain(seen.moving_mass.Freewheel, "m", 4.0, tau=(0.01, 0.04), coast=(0.3, 2.0))),
    Form("valve_dynamics", "pressed_plunger", S, False,
         plain(seen.valve_dynamics.PressedPlunger, "tau", 0.04, p_0=(5e4, 2e5))),
    Form("valve_dynamics", "seat_adhesion", S, False,
         plain(seen.valve_dynamics.SeatAdhesion, "tau", 0.006, c=(2.0, 6.0), h_0=(0.1, 0.5)), 0.02),
    Form("valve_dynamics", "averaged_command", S, False,
         plain(seen.valve_dynamics.AveragedCommand, "window", 0.1), 0.05, 6.0),
    Form("valve_area", "jet_force", S, False, plain(seen.valve_area.JetForce, "beta", 0.08), high=8.0),
    Form("valve_area", "pushed_exhaust", S, False,
         plain(seen.valve_area.PushedExhaust, "beta", 0.08), high=6.0, signed=True),
    Form("valve_area", "short_stroke", S, False, _smaller(seen.valve_area.ShortStroke, "most", 3e-7)),
    Form("supply_line", "cooled_line", S, False,
         tube(seen.supply_line.CooledLine, "area", 5e-7, (2e-6, 1.5e-5), wall=(5e-3, 0.1)), 0.1, 20.0),
    Form("supply_line", "soft_hose", S, False,
         tube(seen.supply_line.SoftHose, "area", 5e-7, (2e-6, 1.2e-5), expansion=(1e-6, 6e-6)), 0.1, 20.0),
    Form("supply_line", "valved_coupling", S, False,
         tube(seen.supply_line.ValvedCoupling, "conductance", 6e-9, (1e-6, 8e-6), p_c=(3e3, 3e4)), 0.05, 12.0),
    Form("dead_volume", "trapped_pocket", S, False,
         plain(seen.dead_volume.TrappedPocket, "volume", 1.5e-5, conductance=(3e-9, 1e-8), share=(0.03, 0.3))),
    Form("dead_volume", "resonator", S, False,
         plain(seen.dead_volume.Resonator, "volume", 1.5e-5, inertance=(5e4, 3e5), conductance=(1e-8, 5e-8)), 0.05),
    Form("leak", "moving_seal", S, False,
         plain(seen.leak.MovingSeal, "conductance", 1.2e-11, v_0=(2e-3, 2e-2)), 1e-4, 40.0),
    Form("leak", "creeping_seal", S, False,
         plain(seen.leak.CreepingSeal, "conductance", 5e-11, p_0=(2e4, 8e4), tau=(0.4, 3.0)), 1e-4, 40.0),
    Form("leak", "cold_seal", S, False,
         plain(seen.leak.ColdSeal, "conductance", 3e-11, theta_0=(8.0, 25.0)), 1e-4, 40.0),
    gas_form("inlet_jet", S, False, seen.gas_energy.InletJet, h=(4.0, 12.0), h_1=(10.0, 80.0), tau=(0.05, 0.4)),
    gas_form("end_plates", S, False, seen.gas_energy.EndPlates, h=(5.0, 25.0), plates=(0.01, 0.08)),
    gas_form("fogging", S, False, seen.gas_energy.FoggingGas, h=(8.0, 40.0), water=(1e-3, 5e-3)),
    Form("wall_heat", "exhaust_draught", S, False,
         fraction(seen.wall_heat.ExhaustDraught, 0.4, g_out=(0.005, 0.04), c=(2.0, 12.0)), 0.01, 20.0),
    Form("wall_heat", "closing_gap", S, False,
         fraction(seen.wall_heat.ClosingGap, 0.4, g_out=(0.005, 0.03), x_0=(4e-3, 2e-2)), 0.01, 20.0),
    Form("wall_heat", "two_patches", S, False, _two_patches, 0.01, 20.0),
    Form("friction_heat", "pressed_contact", S, False,
         _rubbed(seen.friction_heat.PressedContact, p_0=(1e4, 1e5)), high=1.0),
    Form("friction_heat", "two_paths", S, False, _rubbed(seen.friction_heat.TwoPaths, tau=(0.2, 1.0)), high=1.0),
    Form("thermocouple_lag", "compensated", S, False,
         plain(seen.thermocouple_lag.Compensated, "tau", 0.3, r=(0.2, 0.7))),
    Form("thermocouple_lag", "recess", S, False,
         plain(seen.thermocouple_lag.Recess, "tau", 0.3, m_0=(1e-5, 2e-4))),
    Form("thermocouple_lag", "bessel", S, False, plain(seen.thermocouple_lag.BesselFilter, "tau", 0.08), 0.05),
    Form("pressure_offset", "resting_pointer", S, False,
         plain(seen.pressure_offset.RestingPointer, "offset", 3e3, p_0=(1e4, 4e4)), high=10.0, signed=True),
    Form("pressure_offset", "wrong_knot", S, False,
         plain(seen.pressure_offset.WrongKnot, "c", 0.06, p_k=(4e4, 1.2e5)), high=8.0, signed=True),
    Form("pressure_offset", "eccentric_pointer", S, False,
         plain(seen.pressure_offset.EccentricPointer, "size", 2e3, phi_0=(0.3, 6.0), p_fs=(2.5e5, 4e5)),
         high=8.0, signed=True),
)  # fmt: skip
"""Forms of the sixteen families."""

STRANGE: tuple[Form, ...] = (
    Form("none_of_these", "compliant_frame", S, False,
         braided(seen.none_of_these.CompliantFrame, "compliance", 2e-5, True)),
    Form("none_of_these", "venturi_tap", S, False, plain(seen.none_of_these.VenturiTap, "size", 300.0), high=6.0),
    Form("none_of_these", "detent", S, False, _detent, high=5.0),
    Form("none_of_these", "hot_supply", S, False, plain(seen.none_of_these.HotSupply, "hotter", 15.0), high=5.0),
    Form("none_of_these", "slow_reel", S, False, _slow_reel, 0.05, 12.0),
    Form("none_of_these", "dripping_load", S, False, plain(seen.none_of_these.DrippingLoad, "rate", 0.03), high=4.0),
    Form("none_of_these", "residual_charge", S, False,
         plain(seen.none_of_these.ResidualCharge, "per_metre", 30.0), signed=True),
    Form("none_of_these", "ground_loop", S, False,
         plain(seen.none_of_these.GroundLoop, "size", 2.0), signed=True),
    Form("none_of_these", "frozen_display", S, False,
         plain(seen.none_of_these.FrozenDisplay, "off", 0.1, period=(0.9, 2.0), first=(0.2, 0.8)), 0.1, 6.0),
    Form("none_of_these", "settling_rope", S, False,
         plain(seen.none_of_these.SettlingRope, "size", 1e-3, tau=(0.15, 1.0)), high=8.0),
    Form("none_of_these", "lost_counts", S, False,
         plain(seen.none_of_these.LostCounts, "share", 0.05, fast=(0.015, 0.06)), high=8.0),
)  # fmt: skip
"""Effects in no family."""
