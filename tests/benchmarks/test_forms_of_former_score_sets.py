"""Forms that were the score set's own once, where a simpler law or a conserved quantity says what they must give."""

from __future__ import annotations

from math import exp, log, pi, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from rig import seen
from rig.catalogue.creep import Creep
from rig.catalogue.elasticity import MooneyRivlin
from rig.flow import GAMMA, P_ATM, T_ATM, R
from rig.muscle import MuscleParameters
from rig.schedule import Phase, Schedule
from rig.states import REST, held, now_at

pytestmark = pytest.mark.full  # many simulations of the rig, in Python


def test_little_stretched_ogden_rubber_is_neo_hookean_and_strays_further_on():
    ogden, neo = seen.elasticity.OgdenTube(modulus=2e5), MooneyRivlin(c10=1e5, c01=0.0)
    assert ogden.force((), 2e-6, 0.0, 0.0) == pytest.approx(neo.force((), 2e-6, 0.0, 0.0), rel=1e-3)
    assert ogden.force((), 0.0, 0.0, 0.0) == pytest.approx(0.0, abs=1e-9)
    assert abs(ogden.force((), 0.06, 0.0, 0.0) / neo.force((), 0.06, 0.0, 0.0) - 1) > 0.05


def test_slack_cord_pulls_only_when_taut():
    own = seen.elasticity.SlackCord(400.0, 0.02)
    assert own.force((), 0.0, 0.0, 0.0) < 0.01
    assert own.force((), 0.05, 0.0, 0.0) == pytest.approx(400.0 * 0.03, rel=1e-3)


def test_flowing_rubber_of_first_power_and_even_recovery_are_maxwell():
    known = Creep(400.0, 1.5)
    q, stretched = [0.02], now_at(x=0.05)
    for own in (
        seen.creep.FlowingRubber(400.0, 1.5, m=1.0),
        seen.creep.SlowRecovery(400.0, 1.5, r=1.0),
    ):
        assert own.rates(q, stretched) == pytest.approx(known.rates(q, stretched))
        assert own.force(q, 0.05, 0.0, 0.0) == known.force(q, 0.05, 0.0, 0.0)


def test_flowing_rubber_has_a_power_of_time_as_its_tail():
    own = seen.creep.FlowingRubber(tau=0.01, x_0=0.01, m=3.0)
    # e' = -e^3/(tau x_0^2) from a large stretch: e^2 = tau x_0^2/(2 t)
    left = 0.1 - held(own, now_at(x=0.1), 0.02)[0]
    assert left == pytest.approx(0.01 * sqrt(0.01 / (2 * 0.02)), rel=0.05)


def test_slow_recovery_takes_r_times_as_long():
    own = seen.creep.SlowRecovery(tau=1.0, r=4.0)
    assert held(own, now_at(x=0.05), 1.0)[0] == pytest.approx(0.05 * (1 - exp(-1)), rel=1e-6)
    assert held(own, now_at(x=0.0), 4.0, [0.05])[0] == pytest.approx(0.05 * exp(-1), rel=1e-6)


def test_capstan_tensions_differ_by_eulers_factor():
    muscle = MuscleParameters()
    own = seen.dry_friction.Capstan(0.3, muscle.length, muscle.fibre_squared, muscle.turns)
    x, p = 0.03, 1.5e5
    pull = p * muscle.volume_slope(x)
    assert pull / (pull - own.force((), x, 0.1, p)) == pytest.approx(exp(0.3))
    assert (pull - own.force((), x, -0.1, p)) / pull == pytest.approx(exp(0.3))


def test_contact_is_as_old_as_its_sliding_takes():
    own = seen.dry_friction.AgeingContact(8.0, 0.1, 1e-3)
    age = held(own, now_at(v=0.02), 2.0)
    assert age[0] == pytest.approx(1e-3 / 0.02, rel=1e-6)
    assert held(own, now_at(), 3.0)[0] == pytest.approx(8.0)
    assert own.force([8.0], 0.0, 0.02, 0.0) > own.force(age, 0.0, 0.02, 0.0) > 8.0


def test_eddy_brake_brakes_most_at_its_critical_speed():
    own = seen.rate_friction.EddyBrake(300.0, 0.08)
    speeds = np.linspace(0.001, 0.4, 400)
    forces = [own.force((), 0.0, v, 0.0) for v in speeds]
    assert speeds[int(np.argmax(forces))] == pytest.approx(0.08, abs=1e-3)
    assert own.force((), 0.0, -0.05, 0.0) == -own.force((), 0.0, 0.05, 0.0)


def test_power_in_the_matrix_is_that_of_turning_fibres():
    muscle, x, v, step = MuscleParameters(), 0.03, 0.05, 1e-7
    own = seen.rate_friction.ShearedMatrix(60.0, muscle.length, muscle.fibre_squared)
    b = sqrt(muscle.fibre_squared)
    turned = (
        (np.arccos((muscle.length - x - step) / b) - np.arccos((muscle.length - x + step) / b))
        / (2 * step)
        * v
    )
    assert own.force((), x, v, 0.0) * v == pytest.approx(60.0 * b * b * turned**2, rel=1e-5)


def test_ends_leave_the_cylinder_at_rest_and_under_pressure():
    muscle = MuscleParameters()
    cones = seen.end_shape.ConicalEnds(0.1, muscle.length, muscle.fibre_squared)
    assert cones.pull_factor(0.0, 1e5) == pytest.approx(1.0)
    thick = sqrt(4 * muscle.volume(0.05) / (pi * (muscle.length - 0.05)))
    assert cones.pull_factor(0.05, 1e5) == pytest.approx(1 - 0.1 * (thick / muscle.diameter - 1))
    bent = seen.end_shape.BentFibres(0.2, 3e4)
    assert bent.shape_factor(0.02, 9e4) == pytest.approx(1.1)
    assert bent.shape_factor(0.02, 1e9) == pytest.approx(1.0, abs=2e-3)


def test_belted_flywheel_is_a_mass_for_slow_movements():
    own = seen.moving_mass.BeltedFlywheel(3.0, 12.0, 0.3)

    def rates(t: float, q: np.ndarray) -> tuple[float, ...]:
        return own.rates(q, now_at(x=0.1 * t * t, v=0.2 * t))

    q = solve_ivp(rates, (0.0, 1.0), [0.0, 0.0], rtol=1e-9, atol=1e-12).y[:, -1]
    assert own.force(q, 0.1, 0.2, 0.0) == pytest.approx(3.0 * 0.2, rel=1e-3)


def test_winding_drum_keeps_its_energy():
    own = seen.moving_mass.WindingDrum(3.0, 0.1)

    def rates(t: float, y: np.ndarray) -> list[float]:
        return [y[1], -own.force((), y[0], y[1], 0.0) / own.balanced_mass(y[0])]

    y = solve_ivp(rates, (0.0, 1.0), [0.0, 0.1], rtol=1e-10, atol=1e-12).y
    energy = [own.balanced_mass(x) * v * v for x, v in y.T]
    assert y[1, -1] > 0.2
    assert energy == pytest.approx([energy[0]] * len(energy), rel=1e-7)


def test_a_coil_that_does_not_saturate_is_a_lag_and_one_that_does_is_quicker():
    def reached(u_s: float) -> float:
        own = seen.valve_dynamics.SaturatingCoil(0.1, u_s)
        return own.current(held(own, now_at(u=0.35), 0.1), (0.35, 0.0))[0]

    assert reached(1e6) == pytest.approx(0.35 * (1 - exp(-1)), rel=1e-6)
    assert reached(0.1) > 0.3


def test_pilot_stage_arrives_after_twice_its_time():
    own = seen.valve_dynamics.PilotStage(0.05, 0.35)
    assert held(own, now_at(u=0.35), 0.05)[0] == pytest.approx(0.35 * 3 / 4, rel=1e-2)
    assert held(own, now_at(u=0.35), 0.11)[0] == pytest.approx(0.35, rel=2e-3)


def test_sharp_edge_goes_from_perrys_first_to_his_last_coefficient():
    own = seen.valve_area.SharpEdge(1.0)
    assert own.valve_factor(3e5, 1.0) == pytest.approx(1.0, abs=1e-3)
    assert own.valve_factor(3e5, 3e5) == pytest.approx(0.6001 / 0.8414, rel=1e-3)
    factors = [own.valve_factor(1.0, r) for r in np.linspace(0.15, 1.0, 30)]
    assert factors == sorted(factors, reverse=True)


def test_silencer_bounds_the_exhaust_alone():
    own = seen.valve_area.CloggedSilencer(1e-7)
    assert own.areas((3e-7, 1e-9), (0.3, 0.3)) == pytest.approx((3e-7, 1e-9), rel=1e-3)
    assert own.areas((3e-7, 1e-5), (0.3, 0.3))[1] == pytest.approx(1e-7, rel=1e-3)


def test_choked_tube_is_iso_6358_both_ways():
    tube = seen.supply_line.ChokedTube(conductance=1e-9, b=0.2)
    choked = [tube.flow(5e5, T_ATM, p, T_ATM) for p in (0.2e5, 1e5)]
    assert choked == pytest.approx([1e-9 * P_ATM / (R * T_ATM) * 5e5] * 2, rel=1e-4)
    assert tube.flow(5e5, T_ATM, 3e5, T_ATM) == pytest.approx(
        choked[0] * sqrt(1 - (0.4 / 0.8) ** 2), rel=1e-4
    )
    assert tube.flow(2e5, T_ATM, 3e5, 330.0) == -tube.flow(3e5, 330.0, 2e5, T_ATM)
    assert tube.flow(3e5, T_ATM, 3e5, T_ATM) == 0.0


def test_kink_opens_with_pressure():
    hose = seen.supply_line.KinkedHose(conductance=4e-9, p_0=1e5)
    assert hose.flow(P_ATM + 5.0, T_ATM, P_ATM - 5.0, T_ATM) == pytest.approx(4e-8, rel=1e-6)
    assert hose.flow(P_ATM + 1e5 + 5.0, T_ATM, P_ATM + 1e5 - 5.0, T_ATM) == pytest.approx(
        2 * 4e-8 * (P_ATM + 1e5) / P_ATM, rel=1e-6
    )


@pytest.mark.parametrize(("tau", "warmer"), [(1e6, GAMMA), (1e-3, 1.0)])
def test_dead_end_takes_gas_by_enthalpy_without_walls_and_at_their_temperature_with(tau, warmer):
    own = seen.dead_volume.DeadEnd(1e-5, tau)
    mass, energy = held(own, now_at(p_gauge=1e5), 3.0)
    p = (GAMMA - 1) * energy / own.volume
    assert p == pytest.approx(P_ATM + 1e5, rel=1e-4)
    # without walls what came in brought its enthalpy, gamma times its energy
    before = P_ATM * own.volume / (R * T_ATM)
    assert mass - before == pytest.approx(1e5 * own.volume / (R * T_ATM) / warmer, rel=2e-3)


def test_leaks_grow_by_their_powers():
    gap = seen.leak.WideningGap(1e-12, 2e5)
    assert gap.leak(P_ATM + 2e5, T_ATM) == pytest.approx(1e-12 * 2e5 * 8)
    assert gap.leak(P_ATM, T_ATM) == 0.0
    muscle = MuscleParameters()
    crimp = seen.leak.PulledCrimp(1e-11, muscle.length, muscle.fibre_squared, muscle.turns)
    flow, enthalpy = crimp.exchange([0.03], P_ATM + 1e5, 300.0)
    assert flow == pytest.approx(1e-11 * 1e5 * 1e5 * muscle.volume_slope(0.03) / 100.0)
    assert enthalpy == pytest.approx(flow * GAMMA * R / (GAMMA - 1) * 300.0)
    assert crimp.exchange([0.99 * muscle.length], P_ATM + 1e5, 300.0)[0] == 0.0


def test_film_is_that_of_still_gas_at_rest_and_goes_with_the_root_of_renewal():
    own = seen.gas_energy.RenewedFilm(h=10.0, wall=0.0, tau=1.0, m_0=3e-5)
    still = own.film(own.initial(REST), 0.0, P_ATM, T_ATM)
    assert still == pytest.approx(5.0)
    flowing = own.film(held(own, now_at(flow=9e-5), 8.0), 0.0, P_ATM, T_ATM)
    assert flowing == pytest.approx(still * sqrt(1 + 3.0), rel=1e-3)


def test_enclosed_gas_turns_over_with_density_squared():
    own = seen.gas_energy.EnclosedConvection(h=10.0, wall=0.0, difference=20.0)
    assert own.film((), 0.0, P_ATM, T_ATM + 20.0) == pytest.approx(10.0, rel=1e-4)
    assert own.film((), 0.0, 4 * P_ATM, T_ATM - 20.0) == pytest.approx(15.0, rel=1e-4)


def test_pressed_layers_keep_their_heat_and_touch_better_under_pressure():
    own = seen.wall_heat.PressedLayers(0.3, 2.0, 0.1, 0.0)
    apart = []
    for p in (0.0, 1e5):
        bladder, braid = held(own, now_at(p_gauge=p, heat=-0.5), 4.0) - T_ATM
        assert 0.3 * bladder + 0.6 * braid == pytest.approx(0.5 * 4.0)
        apart.append(bladder - braid)
    assert apart[0] > 2 * apart[1]


def test_all_rubbed_heat_arrives_in_either_direction():
    own = seen.friction_heat.SoakedHeat(0.5, 0.2, 2e-3, 2e-4)
    for v in (0.05, -0.05):
        heat = own.heat(held(own, now_at(v=v, p_gauge=1e5), 4.0))
        assert heat == pytest.approx(0.5 * 1e5 * (2e-3 * 0.05**2 + 2e-4 * 0.05), rel=1e-6)


def test_potted_bead_comes_a_sixth_of_its_diffusion_time_late():
    own = seen.thermocouple_lag.PottedBead(1.2)
    q = solve_ivp(
        lambda t, q: own.rates(q, now_at(temperature=T_ATM + 10 * t)),
        (0.0, 3.0),
        own.initial(REST),
        rtol=1e-9,
    ).y[:, -1]
    assert own.reading(q, T_ATM) == pytest.approx(T_ATM + 10 * (3.0 - 1.2 / 6), abs=0.1)


def test_bead_without_buoyancy_is_a_lag():
    q, now = [T_ATM], now_at(temperature=T_ATM + 10.0)
    assert seen.thermocouple_lag.BuoyantBead(0.3, 0.0).rates(q, now)[0] == pytest.approx(10.0 / 0.3)
    assert seen.thermocouple_lag.BuoyantBead(0.3, 0.5).rates(q, now)[0] == pytest.approx(
        1.5 * 10.0 / 0.3, rel=1e-5
    )


def test_bowed_manometer_is_right_at_both_ends():
    own = seen.pressure_offset.BowedManometer(3e3, 3e5)
    assert [own.pressure_shown((), p) - p for p in (0.0, 1.5e5, 3e5)] == pytest.approx(
        [0.0, 3e3, 0.0]
    )


def test_loose_contact_cuts_the_current_off_and_its_edges_are_switches():
    own = seen.none_of_these.LooseContact(0.1, 1.0, 0.4)
    schedule = own.drive(Schedule.of([Phase(1.0, u_in=0.3), Phase(9.0)]))
    assert {0.4, 0.5, 1.4, 1.5, 11.4} <= {round(t, 9) for t in schedule.starts}
    assert schedule.at(0.45) == (0.3, 0.0)
    felt = [own.current([t], (0.3, 0.0))[0] for t in (0.39, 0.41, 0.49, 0.51, 1.45, 1.55)]
    assert felt == [0.3, 0.0, 0.0, 0.3, 0.0, 0.3]


def test_readings_and_forces_from_outside():
    slipped = seen.none_of_these.SlippedRuler(1e-3, 3.0)
    assert [slipped.position_shown([t], 0.02) for t in (2.8, 3.2)] == pytest.approx([0.02, 0.021])
    aslant = seen.none_of_these.ObliqueString(0.3, 0.4)
    assert aslant.position_shown((), 0.0) == 0.0
    assert aslant.position_shown((), 1e-6) == pytest.approx(
        0.8e-6, rel=1e-4
    )  # the cosine of its angle
    coils = seen.none_of_these.WarmCoils(2.0, 1.0)
    assert coils.reading(held(coils, now_at(u=0.35), 20.0), T_ATM) == pytest.approx(T_ATM - 2.0)
    ringing = seen.none_of_these.RestlessStart(8.0, 3.0, 1.0, 0.0)
    assert log(
        ringing.force([0.0], 0.0, 0.0, 0.0) / ringing.force([3.0], 0.0, 0.0, 0.0)
    ) == pytest.approx(1.0)
    assert seen.none_of_these.EmptyBottle(0.2).supply([5.0], 3e5) == pytest.approx(2.7e5)
