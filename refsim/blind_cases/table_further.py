"""Lines of the table for the forms of a second author, for the new forms of the set `tuning4` alone.

The forms are in `rig.seen.further`. What a line is made of stands in `form.py`.
"""

from __future__ import annotations

from blind_cases.form import At, Form, Random, braided, fraction, gas_form, plain, spread, tube
from rig.muscle import MuscleParameters
from rig.seen import further

N = ("tuning4",)


def _demiray(rng: Random, muscle: MuscleParameters) -> At:
    tube_of = (muscle.length, muscle.diameter, muscle.t_wall, muscle.turns)
    b, unit = spread(rng, 0.3, 1.5), 2e5 * 0.254e-3 / muscle.t_wall
    return lambda s: further.elasticity.DemirayTube(*tube_of, unit * s, b)


def _metering(rng: Random, muscle: MuscleParameters) -> At:
    x_e = muscle.length * rng.uniform(0.3, 0.45)
    return lambda s: further.rate_friction.MeteringOrifices(4e3 * s, x_e)


def _eccentric(rng: Random, muscle: MuscleParameters) -> At:
    shape = {
        "radius": spread(rng, 0.02, 0.05),
        "e": spread(rng, 0.15, 0.4),
        "phi": rng.uniform(0.0, 6.28),
    }
    return lambda s: further.moving_mass.EccentricWheel(3.0 * s, **shape)


def _rubbed(muscle: MuscleParameters) -> dict[str, float]:
    """The muscle's own forces of friction, by pressure."""
    return {
        "crossing": muscle.crossing_area * muscle.mu_d * muscle.k_f,
        "covered": muscle.mu_fb * muscle.fibre_area,
    }


def _thinning(rng: Random, muscle: MuscleParameters) -> At:
    tau = spread(rng, 0.1, 0.8)
    braid = {"length": muscle.length, "fibre_squared": muscle.fibre_squared}
    return lambda s: further.friction_heat.ThinningWall(
        share=s, tau=tau, **_rubbed(muscle), **braid
    )


def _deep(rng: Random, muscle: MuscleParameters) -> At:
    tau = spread(rng, 0.05, 0.5)
    return lambda s: further.friction_heat.DeepContact(share=s, tau=tau, **_rubbed(muscle))


def _stretched(rng: Random, muscle: MuscleParameters) -> At:
    """A heavy wall is the base model's; what its rubber warms by itself goes with it."""
    g_out, b = spread(rng, 0.005, 0.04), spread(rng, 5e-4, 3e-3)
    braid = {"length": muscle.length, "fibre_squared": muscle.fibre_squared}
    return lambda s: further.wall_heat.StretchedWall(
        capacity=0.4 / s, g_out=g_out, b=b * min(s, 1.0), **braid
    )


def _touching(rng: Random, muscle: MuscleParameters) -> At:
    """The longer the lag, the larger the bead, and the more of it touches the wall."""
    c, tau_w = spread(rng, 0.05, 0.25), spread(rng, 0.5, 5.0)
    return lambda s: further.thermocouple_lag.TouchingBead(0.15 * s, min(c * s, 0.6), tau_w)


FORMS: tuple[Form, ...] = (
    # family, form, sets, in the catalogue, ...
    Form("elasticity", "demiray", N, False, _demiray),
    Form("elasticity", "set_braid", N, False, braided(further.elasticity.SetBraid, "f", 25.0)),
    Form("dry_friction", "savkoor", N, False,
         plain(further.dry_friction.RubberSliding, "f_c", 8.0, a=(0.3, 0.8), v_m=(0.01, 0.08), h=(0.4, 1.0),
               width=(2e-4, 1e-3))),
    Form("dry_friction", "guard_tube", N, False,
         braided(further.dry_friction.GuardTube, "f", 50.0, gap=(0.01, 0.1), width=(2e-4, 1e-3))),
    Form("rate_friction", "thickening", N, False,
         plain(further.rate_friction.ThickeningFluid, "c", 100.0, v_0=(0.02, 0.08), r=(2.5, 6.0))),
    Form("rate_friction", "metering_orifices", N, False, _metering),
    Form("creep", "stiffening_maxwell", N, False,
         plain(further.creep.StiffeningMaxwell, "k", 300.0, tau=(0.5, 4.0), x_0=(0.008, 0.03))),
    Form("creep", "overstress", N, False,
         plain(further.creep.Overstress, "k", 400.0, tau=(0.4, 3.0), y=(8e-4, 4e-3))),
    Form("end_shape", "slanted", N, False, braided(further.end_shape.SlantedEnds, "c", 0.8, True), high=10.0),
    Form("end_shape", "through_rod", N, False, braided(further.end_shape.ThroughRod, "c", 0.08), high=6.0),
    Form("moving_mass", "clutched_flywheel", N, False,
         plain(further.moving_mass.ClutchedFlywheel, "m", 4.0, a=(1.0, 6.0))),
    Form("moving_mass", "eccentric_wheel", N, False, _eccentric),
    Form("valve_dynamics", "squared_flux", N, False, plain(further.valve_dynamics.SquaredFlux, "tau", 0.05)),
    Form("valve_dynamics", "plunger_travel", N, False,
         plain(further.valve_dynamics.PlungerTravel, "tau", 0.05, a_r=(1e-7, 6e-7))),
    Form("valve_area", "subsonic_index", N, False, plain(further.valve_area.SubsonicIndex, "more", 0.06), high=8.0),
    Form("valve_area", "servo_assisted", N, False, plain(further.valve_area.ServoAssisted, "p_m", 3e3)),
    Form("supply_line", "coiled", N, False,
         tube(further.supply_line.CoiledHose, "conductance", 6e-9, (1e-6, 8e-6), m_0=(5e-5, 4e-4)), 0.05, 15.0),
    Form("supply_line", "flow_limiter", N, False,
         tube(further.supply_line.FlowLimiter, "m_max", 4e-4, (1e-6, 8e-6), p_l=(3e4, 1e5)), 0.05, 15.0),
    Form("dead_volume", "spring_piston", N, False,
         plain(further.dead_volume.SpringPiston, "volume", 1e-5, e=(0.5, 2.5), p_1=(3e4, 1e5))),
    Form("dead_volume", "sorbent", N, False,
         plain(further.dead_volume.Sorbent, "volume", 8e-6, b=(0.5, 2.0), c=(0.1, 0.5), tau=(0.05, 0.8))),
    Form("leak", "dissolved", N, False,
         plain(further.leak.DissolvedGas, "conductance", 2e-11, tau=(0.5, 4.0)), 1e-4, 40.0),
    Form("leak", "popping", N, False,
         plain(further.leak.PoppingSeal, "conductance", 3e-11, p_0=(2.5e4, 7e4), b=(0.15, 0.4)), 1e-4, 40.0),
    gas_form("pipe_flow", N, False, further.gas_energy.PipeFlow, h=(5.0, 20.0), h_1=(15.0, 80.0)),
    gas_form("swirl", N, False, further.gas_energy.Swirl, h=(4.0, 12.0), c=(2.0, 10.0), tau=(0.2, 2.0)),
    Form("wall_heat", "stretched", N, False, _stretched, 0.01, 20.0),
    Form("wall_heat", "damp_sleeve", N, False,
         fraction(further.wall_heat.DampSleeve, 0.4, g_out=(0.005, 0.04)), 0.01, 20.0),
    Form("friction_heat", "thinning_wall", N, False, _thinning, high=1.0),
    Form("friction_heat", "deep_contact", N, False, _deep, high=1.0),
    Form("thermocouple_lag", "flushed_probe", N, False,
         plain(further.thermocouple_lag.FlushedProbe, "tau", 0.05, m_0=(2e-5, 1e-4))),
    Form("thermocouple_lag", "touching", N, False, _touching),
    Form("pressure_offset", "range_switch", N, False,
         plain(further.pressure_offset.RangeSwitch, "c", 0.04, p_r=(3e4, 9e4)), high=6.0, signed=True),
    Form("pressure_offset", "cubic_residue", N, False,
         plain(further.pressure_offset.CubicResidue, "size", 3e3, p_fs=(1.5e5, 3e5)), high=8.0, signed=True),
)  # fmt: skip
"""Forms of the sixteen families, two each."""
