"""Forms that the score set had the third time, by their limits and by what they conserve."""

from __future__ import annotations

from dataclasses import replace
from math import exp, log, pi, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from rig import seen
from rig.catalogue.creep import Creep
from rig.catalogue.dry_friction import Coulomb, Dahl
from rig.catalogue.elasticity import MooneyRivlin
from rig.catalogue.gas_energy import EnergyGas
from rig.catalogue.leak import LaminarLeak
from rig.catalogue.rate_friction import Viscous
from rig.catalogue.supply_line import LaminarTube, OrificeTube
from rig.catalogue.thermocouple_lag import ThermocoupleLag
from rig.catalogue.valve_dynamics import ValveLag
from rig.catalogue.wall_heat import WarmWall
from rig.effect import Effect
from rig.flow import CP, CV, GAMMA, P_ATM, R_CRITICAL, T_ATM, G, R
from rig.muscle import MuscleParameters
from rig.schedule import Phase, SampledSchedule, Schedule
from rig.states import REST, held, now_at

pytestmark = pytest.mark.full  # of the measuring, not of the product

MUSCLE = MuscleParameters()
BRAID = (MUSCLE.length, MUSCLE.fibre_squared)
STEP = Schedule.of([Phase(1.0), Phase(9.0, u_in=0.3)])


def _girth(x: float) -> float:
    """Diameter by that at rest."""
    return sqrt(
        (MUSCLE.fibre_squared - (MUSCLE.length - x) ** 2)
        / (MUSCLE.fibre_squared - MUSCLE.length**2)
    )


def _work(effect: Effect, x: float) -> float:
    places = np.linspace(0.0, x, 4001)
    return float(
        np.trapezoid([effect.force((), float(place), 0.0, 0.0) for place in places], places)
    )


# --- force ----------------------------------------------------------------------------------------------------


def test_eight_chains_of_many_links_are_neo_hookean_and_of_few_stiffer():
    neo = MooneyRivlin(c10=1e5, c01=0.0)
    for x in (0.01, 0.05):
        many, few = (
            seen.elasticity.EightChain(mu=2e5, links=n).force((), x, 0.0, 0.0) for n in (1e5, 2.0)
        )
        assert many == pytest.approx(neo.force((), x, 0.0, 0.0), rel=1e-4)
        assert few > 1.2 * many


def test_bladder_without_prestretch_is_neo_hookean():
    neo = MooneyRivlin(c10=1e5, c01=0.0)
    own = seen.elasticity.PrestretchedTube(mu=2e5, prestretch=1.0)
    assert own.force((), 0.04, 0.0, 0.0) == pytest.approx(neo.force((), 0.04, 0.0, 0.0), rel=1e-9)


def test_work_on_a_prestretched_bladder_is_its_energy():
    own, x, a_0 = seen.elasticity.PrestretchedTube(mu=2e5, prestretch=1.2), 0.05, 1.2

    def energy(x: float) -> float:
        a, c = a_0 * (1 - x / own.length), _girth(x)
        return 1e5 * own.wall / a_0 * (a * a + c * c + 1 / (a * c) ** 2 - 3)

    assert _work(own, x) == pytest.approx(energy(x) - energy(0.0), rel=1e-3)


def test_work_on_logarithmic_rubber_is_its_energy_and_small_strains_are_neo_hookean():
    own, x = seen.elasticity.LogarithmicTube(mu=2e5), 0.05
    stretches = (1 - x / own.length, _girth(x), 1 / ((1 - x / own.length) * _girth(x)))
    energy = own.wall * 2 * 2e5 * sum(s * (log(s) - 1) + 1 for s in stretches)
    assert _work(own, x) == pytest.approx(energy, rel=1e-3)
    neo = MooneyRivlin(c10=1e5, c01=0.0)
    assert own.force((), 1e-5, 0.0, 0.0) == pytest.approx(neo.force((), 1e-5, 0.0, 0.0), rel=1e-2)


def test_crossings_rub_by_pressure_and_less_as_their_rhombs_open():
    own = seen.dry_friction.CrossingContact(5e-5, *BRAID, 1e-3)
    assert own.force((), 0.0, 0.05, 1e5) == pytest.approx(5.0)
    assert own.force((), 0.0, -0.05, 2e5) == pytest.approx(-10.0)
    theta = [np.arccos((MUSCLE.length - x) / sqrt(MUSCLE.fibre_squared)) for x in (0.0, 0.05)]
    assert own.force((), 0.05, 0.05, 1e5) == pytest.approx(
        5.0 * np.sin(2 * theta[0]) / np.sin(2 * theta[1])
    )


def test_bristle_under_what_the_bladder_leaves_is_dahls():
    own, known = seen.dry_friction.CarriedPressure(5e-5, 1e5, 1e-3, *BRAID), Dahl(6.0, 6e3)
    pressed = 1.2e5 + 1e5 * (_girth(0.03) - 1)
    for v in (0.01, -0.02):
        now = now_at(v=v, p_gauge=pressed)
        force = own.force(held(own, now, 0.07), 0.03, v, pressed)
        assert force == pytest.approx(known.force(held(known, now, 0.07), 0.0, v, 0.0), rel=1e-3)
    assert own.force([1.0], 0.05, 0.01, 0.2e5) < 0.03


def test_breakaway_peaks_by_the_way_at_any_speed_and_slides_at_its_force():
    own = seen.dry_friction.BreakawayByWay(8.0, 0.6, 2e-3)

    def after(way: float, v: float) -> float:
        return own.force(held(own, now_at(v=v), way / abs(v)), 0.0, v, 0.0)

    assert after(1e-3, 0.001) == pytest.approx(after(1e-3, 0.1), rel=1e-5)
    assert after(1.2e-3, 0.01) > 8.5
    assert after(0.03, 0.01) == pytest.approx(8.0, rel=1e-4)
    assert after(0.03, -0.01) == pytest.approx(-Coulomb(8.0).force((), 0.0, 0.01, 0.0), rel=1e-4)


def test_thinning_oil_is_viscous_at_first_and_a_power_then():
    own = seen.rate_friction.ThinningOil(400.0, 0.02, 0.4)
    assert own.force((), 0.0, 1e-5, 0.0) == pytest.approx(
        Viscous(400.0).force((), 0.0, 1e-5, 0.0), rel=1e-4
    )
    assert own.force((), 0.0, 8.0, 0.0) / own.force((), 0.0, 4.0, 0.0) == pytest.approx(
        2**0.4, rel=1e-3
    )


def test_warm_grease_thins_by_its_temperature():
    own = seen.rate_friction.WarmGrease(300.0, 10.0, 0.5)
    assert own.force(own.initial(REST), 0.0, 0.1, 0.0) == pytest.approx(30.0)
    warm = held(own, now_at(temperature=T_ATM + 20.0), 10.0)
    assert own.force(warm, 0.0, 0.1, 0.0) == pytest.approx(30.0 * exp(-1), rel=1e-5)


def test_power_at_greased_crossings_goes_with_the_turning_of_fibres():
    own = seen.rate_friction.TurningCrossings(3e-3, *BRAID)

    def turning(x: float, v: float) -> float:
        step = 1e-6
        angles = [
            np.arccos((MUSCLE.length - x - side * step) / sqrt(MUSCLE.fibre_squared))
            for side in (1, -1)
        ]
        return (angles[0] - angles[1]) / (2 * step) * v

    powers = [own.force((), x, v, 1e5) * v for x, v in ((0.0, 0.02), (0.06, 0.05))]
    assert powers[1] / powers[0] == pytest.approx(
        (turning(0.06, 0.05) / turning(0.0, 0.02)) ** 2, rel=1e-6
    )
    assert powers[0] == pytest.approx(3e-3 * 1e5 * 0.02**2)


def test_hoops_store_work_at_once_and_none_in_the_end():
    own, x = seen.creep.HoopRelaxation(2.0, 1.0, *BRAID), 0.06
    places = np.linspace(0.0, x, 4001)
    quick = np.trapezoid([own.force([1.0], float(place), 0.0, 0.0) for place in places], places)
    assert quick == pytest.approx((_girth(x) - 1) ** 2, rel=1e-5)
    assert own.force(held(own, now_at(x=x), 30.0), x, 0.0, 0.0) == pytest.approx(0.0, abs=1e-6)


def test_relaxation_is_a_stretched_exponential():
    own = seen.creep.StretchedExponential(400.0, 1.0)
    for t in (0.1, 0.3, 1.0, 3.0):
        left = own.force(held(own, now_at(x=0.02), t), 0.02, 0.0, 0.0)
        assert left / 8.0 == pytest.approx(exp(-sqrt(t)), abs=0.05)
    assert own.force((0.0,) * 6, 0.02, 0.0, 0.0) == pytest.approx(
        Creep(400.0).force((0.0,), 0.02, 0.0, 0.0)
    )


def test_round_caps_pull_by_virtual_work():
    own, x, step = seen.end_shape.RoundCaps(1.0, *BRAID, MUSCLE.turns), 0.04, 1e-6

    def volume(x: float) -> float:
        return MUSCLE.volume(x) - pi / 12 * (MUSCLE.diameter * _girth(x)) ** 3

    slope = (volume(x + step) - volume(x - step)) / (2 * step)
    assert own.pull_factor(x, 1e5) * MUSCLE.volume_slope(x) == pytest.approx(slope, rel=1e-6)


def test_uneven_braid_is_even_without_an_angle_and_weaker_with_one():
    for x in (0.0, 0.03, 0.06):
        assert seen.end_shape.UnevenBraid(0.0, 0.2, *BRAID).pull_factor(x, 1e5) == pytest.approx(
            1.0, abs=1e-9
        )
        assert seen.end_shape.UnevenBraid(0.1, 0.0, *BRAID).pull_factor(x, 1e5) == pytest.approx(
            1.0, abs=1e-9
        )
        assert 0.3 < seen.end_shape.UnevenBraid(0.1, 0.2, *BRAID).pull_factor(x, 1e5) < 1.0


def test_both_parts_of_an_uneven_braid_pull_alike():
    more, share, x = 0.08, 0.25, 0.05
    own = seen.end_shape.UnevenBraid(more, share, *BRAID)
    area = pi / 4 * MUSCLE.diameter**2
    pull = own.pull_factor(x, 1e5) * MUSCLE.volume_slope(x)
    total = 0.0
    for _, (part, cos2, sin2) in enumerate(own._parts()):
        length_0 = part * MUSCLE.length
        # the length at which a muscle of this angle pulls so: (3 L^2 - b^2)/(4 pi n^2)
        b2, turns = length_0**2 / cos2, length_0 * sqrt(sin2 / cos2) / (pi * MUSCLE.diameter)
        total += sqrt((pull * 4 * pi * turns**2 + b2) / 3)
    assert total == pytest.approx(MUSCLE.length - x, rel=1e-4)
    assert 0 < pull < 6 * area
    assert own._parts()[1][1] == pytest.approx(
        np.cos(np.arccos(sqrt(own._parts()[0][1])) + more) ** 2, rel=1e-3
    )


def test_bladder_bridges_where_the_step_is_and_pressure_is_not():
    own = seen.end_shape.BridgingBladder(0.5, 1e5, *BRAID)
    assert own.shape_factor(0.0, 0.0) == pytest.approx(1.0)
    assert own.shape_factor(0.05, 0.0) == pytest.approx(1 + 0.5 * (_girth(0.05) - 1))
    assert own.shape_factor(0.05, 1e5) - 1 == pytest.approx((own.shape_factor(0.05, 0.0) - 1) / 2)


def _coasting(effect: Effect) -> tuple[float, float]:
    """Kinetic energy of the balanced mass before and after 0.4 s without any other force."""

    def mass(x: float) -> float:
        return effect.balanced_mass(x) + effect.hanging_mass() + 1.0

    def rates(t: float, y: np.ndarray) -> list[float]:
        return [y[1], -effect.force((), y[0], y[1], 0.0) / mass(y[0])]

    y = solve_ivp(rates, (0.0, 0.4), [0.0, 0.1], rtol=1e-10, atol=1e-12).y
    return mass(y[0, 0]) * y[1, 0] ** 2 / 2, mass(y[0, -1]) * y[1, -1] ** 2 / 2


def test_moving_masses_keep_their_energy():
    wall = seen.moving_mass.OwnWall(0.3, *BRAID, MUSCLE.turns)
    for own in (wall, seen.moving_mass.Crank(2.0, 0.1, 0.02)):
        before, after = _coasting(own)
        assert after == pytest.approx(before, rel=1e-7)
    radii = [MUSCLE.diameter / 2 * _girth(side * 1e-6) for side in (1, -1)]
    outward = (radii[0] - radii[1]) / 2e-6
    inertia = wall.balanced_mass(0.0) + wall.hanging_mass()
    assert inertia == pytest.approx(0.3 * (1 / 3 + outward**2), rel=1e-4)


def test_freewheel_takes_the_wheel_along_and_leaves_it():
    own = seen.moving_mass.Freewheel(3.0, 0.02, 1e9)
    assert held(own, now_at(v=0.1), 1.0)[0] == pytest.approx(0.1, rel=0.02)
    assert own.force([0.1], 0.0, 0.02, 0.0) == pytest.approx(0.0, abs=1e-9)
    assert own.force([0.0], 0.0, 0.1, 0.0) == pytest.approx(3.0 * 0.1 / 0.02, rel=1e-6)
    # what it was given is the work that it took: momentum m w
    w = held(own, now_at(v=0.1), 0.01)[0]
    pushed = np.mean(
        [own.force(held(own, now_at(v=0.1), t), 0.0, 0.1, 0.0) for t in np.linspace(1e-4, 0.01, 80)]
    )
    assert pushed * 0.01 == pytest.approx(3.0 * w, rel=0.02)


# --- mass -----------------------------------------------------------------------------------------------------


def test_plunger_without_pressure_is_a_lag():
    own, known = seen.valve_dynamics.PressedPlunger(0.05, 8e4), ValveLag(0.05)
    now = now_at(u=0.3)._replace(command=(0.3, 0.2))
    assert own.rates([0.1, 0.1], now) == pytest.approx(known.rates([0.1, 0.1], now))
    pressed = now._replace(p_gauge=8e4)
    assert own.rates([0.1, 0.1], pressed)[1] == pytest.approx(known.rates([0.1, 0.1], now)[1] / 2)
    shutting = pressed._replace(command=(0.3, 0.0))
    assert own.rates([0.1, 0.1], shutting)[1] == pytest.approx(2 * -0.1 / 0.05)


def test_plunger_comes_off_its_seat_late_and_is_a_plain_lag_without_adhesion_or_when_lifted():
    own, known = seen.valve_dynamics.SeatAdhesion(0.02, 4.0, 0.2), ValveLag(0.02)
    now = now_at(u=0.3)
    assert own.rates([0.1, 0.0], now)[0] == pytest.approx(known.rates([0.1, 0.0], now)[0] / 5)
    assert own.rates([2.0, 0.0], now)[0] == pytest.approx(known.rates([2.0, 0.0], now)[0], rel=0.01)
    free = replace(own, c=0.0)
    assert free.rates([0.2, 0.1], now) == pytest.approx(known.rates([0.2, 0.1], now))
    assert own.current(held(own, now, 3.0), (0.3, 0.0)) == pytest.approx((0.3, 0.0), abs=1e-6)


def test_mean_of_a_step_is_a_ramp_and_of_a_line_comes_half_a_window_late():
    own = seen.valve_dynamics.AveragedCommand(0.1)
    felt = own.drive(STEP)
    for t, share in ((0.9, 0.0), (1.025, 0.25), (1.05, 0.5), (1.09, 0.9), (1.2, 1.0), (5.0, 1.0)):
        assert felt.at(t) == pytest.approx((0.3 * share, 0.0), abs=2e-3)
    assert {1.0, 1.1} <= set(felt.starts)
    line = SampledSchedule.joined([(0.01 * k, 0.0) for k in range(40)], 0.1)
    assert own.drive(line).at(2.0)[0] == pytest.approx(line.at(1.95)[0], abs=1e-3)


def test_jet_pulls_least_where_nothing_flows():
    own = seen.valve_area.JetForce(0.1)
    assert own.valve_factor(P_ATM, P_ATM) == pytest.approx(1.0, abs=1e-3)
    assert own.valve_factor(P_ATM, 0.3 * P_ATM) == pytest.approx(1 / 1.1)
    assert own.valve_factor(3 * P_ATM, P_ATM) == pytest.approx(1 / 1.3)
    assert own.valve_factor(P_ATM, R_CRITICAL * P_ATM) < own.valve_factor(P_ATM, 0.8 * P_ATM) < 1


def test_pressure_lifts_the_exhaust_alone_and_stops_bound_the_areas():
    pushed = seen.valve_area.PushedExhaust(0.1)
    lifted = held(pushed, now_at(p_gauge=2e5), 0.1)
    assert pushed.opening(lifted, (4e-7, 4e-7)) == pytest.approx((4e-7, 4.8e-7))
    assert pushed.opening(pushed.initial(REST), (4e-7, 4e-7)) == (4e-7, 4e-7)
    stops = seen.valve_area.ShortStroke(3e-7)
    assert stops.areas((1e-8, 1e-3), (0.1, 9.0)) == pytest.approx((1e-8, 3e-7), rel=1e-4)


def test_line_without_cooling_is_a_tube_and_one_with_it_loses_heat():
    own, known = seen.supply_line.CooledLine(5e-6, 5e-7, 0.0), OrificeTube(5e-6, 5e-7)
    q, valves = [2e-5, 5.0], (2e-4, 60.0)
    assert own.line_rates(q, valves, 1.5e5, 300.0) == known.line_rates(q, valves, 1.5e5, 300.0)
    cooled = replace(own, wall=0.03)
    warmer = known.node(q)[1] - T_ATM
    lost = np.subtract(
        known.line_rates(q, valves, 1.5e5, 300.0), cooled.line_rates(q, valves, 1.5e5, 300.0)
    )
    assert warmer > 10
    assert lost == pytest.approx([0.0, 0.03 * warmer])


def test_soft_hose_that_does_not_widen_is_a_tube_and_one_that_does_takes_work():
    hard, known = seen.supply_line.SoftHose(5e-6, 5e-7, 0.0), OrificeTube(5e-6, 5e-7)
    q = [2e-5, 1.5]
    assert hard.node(q) == pytest.approx(known.node(q))
    soft = seen.supply_line.SoftHose(5e-6, 5e-7, 4e-6)
    assert soft.node(soft.initial(REST)) == pytest.approx((P_ATM, T_ATM))
    p, temperature = soft.node(q)
    volume = 5e-6 * (1 + 4e-6 * (p - P_ATM))
    assert p * volume / (GAMMA - 1) + 5e-6 * 4e-6 * p * p / 2 == pytest.approx(1.5)
    assert p * volume == pytest.approx(2e-5 * R * temperature)


def test_coupling_is_laminar_at_large_drops_and_nearly_shut_at_small_ones():
    own, known = seen.supply_line.ValvedCoupling(5e-6, 6e-9, 1e3), LaminarTube(5e-6, 6e-9)
    wide = [c.flow(6e5, T_ATM, P_ATM, T_ATM) for c in (own, known)]
    assert wide[0] == pytest.approx(wide[1], rel=3e-3)
    narrow = [c.flow(P_ATM + 300.0, T_ATM, P_ATM, T_ATM) for c in (own, known)]
    assert narrow[0] < 0.3 * narrow[1]
    assert own.flow(2e5, T_ATM, 1e5, T_ATM) == -own.flow(1e5, T_ATM, 2e5, T_ATM)


def test_pockets_fill_with_their_enthalpy_and_one_empties_slowly():
    trap = seen.dead_volume.TrappedPocket(1.5e-5, 6e-9, 0.1)
    ring = seen.dead_volume.Resonator(1.5e-5, 1e5, 2e-8)
    before = P_ATM * 1.5e-5 / (R * T_ATM)
    for own in (trap, ring):
        mass, energy = held(own, now_at(p_gauge=1e5), 5.0)[:2]
        assert own.inside([mass, energy]) == pytest.approx(P_ATM + 1e5, rel=1e-3)
        assert energy - P_ATM * 1.5e-5 / (GAMMA - 1) == pytest.approx(
            CP * T_ATM * (mass - before), rel=1e-3
        )
        assert energy / (CV * mass) > T_ATM
    full = trap.initial(REST)
    ratio = trap.exchange(full, P_ATM + 1e3, T_ATM)[0] / trap.exchange(full, P_ATM - 1e3, T_ATM)[0]
    assert ratio == pytest.approx(-10.0)


def test_gas_in_a_neck_swings_at_helmholtzs_frequency():
    own = seen.dead_volume.Resonator(1.5e-5, 1e5, 1e3)
    omega = sqrt(GAMMA * R * T_ATM / (1.5e-5 * 1e5))
    start = held(own, now_at(), 1e-9)
    quarter = held(own, now_at(p_gauge=100.0), pi / omega, start)
    assert own.inside(quarter) - P_ATM == pytest.approx(200.0, rel=0.01)
    assert quarter[2] == pytest.approx(0.0, abs=1e-7)


def test_leaks_are_laminar_ones_where_nothing_changes_them():
    laminar = LaminarLeak(2e-11).leak(P_ATM + 1e5, T_ATM)
    seal, creeping = seen.leak.MovingSeal(2e-11, 5e-3), seen.leak.CreepingSeal(2e-11, 4e4, 1.5)
    assert seal.exchange([0.0], P_ATM + 1e5, T_ATM)[0] == pytest.approx(laminar, rel=0.05)
    moving = held(seal, now_at(v=-5e-3), 0.2)
    assert seal.exchange(moving, P_ATM + 1e5, T_ATM) == pytest.approx(
        (2 * laminar, 2 * laminar * CP * T_ATM), rel=1e-3
    )
    assert creeping.exchange(creeping.initial(REST), P_ATM + 1e5, T_ATM)[0] == pytest.approx(
        laminar
    )
    crept = held(creeping, now_at(p_gauge=4e4), 30.0)
    assert creeping.exchange(crept, P_ATM + 1e5, T_ATM)[0] == pytest.approx(laminar / 2)
    cold = seen.leak.ColdSeal(2e-11, 12.0)
    assert cold.leak(P_ATM + 1e5, T_ATM) == pytest.approx(laminar)
    assert cold.leak(P_ATM + 1e5, T_ATM - 12.0) == pytest.approx(laminar * exp(1))
    assert cold.leak(P_ATM, T_ATM - 12.0) == 0.0


# --- energy ---------------------------------------------------------------------------------------------------


def test_gas_without_what_is_new_is_the_plain_balance():
    plain = EnergyGas(20.0, 1.8e-3)
    jet, plates = (
        seen.gas_energy.InletJet(20.0, 1.8e-3, 30.0, 0.1),
        seen.gas_energy.EndPlates(20.0, 1.8e-3, 0.03),
    )
    still = plain._through(20.0)
    assert jet.film([1e-4, 0.0], 0.0, 2e5, 310.0) == pytest.approx(still, rel=0.01)
    vented = held(jet, now_at(flow=-1e-4), 1.0)
    assert jet.film(list(vented), 0.0, 2e5, 310.0) == pytest.approx(still, rel=0.01)
    filled = held(jet, now_at(flow=1e-4), 2.0)
    assert jet.film(list(filled), 0.0, 2e5, 310.0) == pytest.approx(
        1 / (2 / 50.0 + 1.8e-3), rel=1e-3
    )
    assert plates.exchange([1e-4], 2e5, T_ATM + 10.0) == pytest.approx((0.0, 0.3))
    assert plates.film([1e-4], 0.0, 2e5, 310.0) == still


def test_fog_gives_and_takes_its_latent_heat():
    own, cold, warm = seen.gas_energy.FoggingGas(water=3e-3), T_ATM - 40.0, T_ATM + 40.0
    dry = seen.gas_energy.FoggingGas(water=1e-9)
    assert dry.exchange([1e-4, 0.0], P_ATM, T_ATM)[1] == pytest.approx(0.0, abs=1e-3)
    # cooled by 40 K nearly all condenses: at 253 K some 0.8 g/kg stay
    fog = held(own, now_at(temperature=cold), 2.0)[1]
    assert 1.9e-3 < fog < 2.6e-3
    assert own.exchange([1e-4, 0.0], P_ATM, cold)[1] == pytest.approx(
        -2.5e6 * 1e-4 * fog / 0.05, rel=1e-3
    )
    assert own.exchange([1e-4, fog], P_ATM, warm)[1] > 0
    given = sum(
        own.exchange([1e-4, held(own, now_at(temperature=cold), t)[1]], P_ATM, cold)[1] * 1e-3
        for t in np.arange(0.0, 0.6, 1e-3) + 5e-4
    )
    assert given == pytest.approx(-2.5e6 * 1e-4 * fog, rel=1e-2)


def test_walls_are_known_ones_at_rest():
    lump, warm = WarmWall(0.4, 0.02), [T_ATM + 5.0]
    draught, gap = (
        seen.wall_heat.ExhaustDraught(0.4, 0.02, 5.0),
        seen.wall_heat.ClosingGap(0.4, 0.02, 0.01),
    )
    for own in (draught, gap):
        assert own.rates(warm, now_at(heat=-0.3)) == pytest.approx(
            lump.rates(warm, now_at(heat=-0.3))
        )
    blown = now_at()._replace(command=(0.0, 0.35))
    assert draught.rates(warm, blown)[0] == pytest.approx(6 * lump.rates(warm, now_at())[0])
    assert gap.rates(warm, now_at(x=0.01))[0] == pytest.approx(2 * lump.rates(warm, now_at())[0])


def test_patches_take_what_the_gas_gives():
    own = seen.wall_heat.TwoPatches(
        0.2, 5.0, 0.4, 0.0, MUSCLE.heat_coefficient, *BRAID, MUSCLE.turns, MUSCLE.fibre_area
    )
    q, x, gas = [T_ATM + 4.0, T_ATM + 1.0], 0.02, T_ATM + 20.0
    given = MUSCLE.heat_coefficient * MUSCLE.bare_area(x) * (gas - own.wall_temperature(q, T_ATM))
    bare, thick = own.rates(q, now_at(x=x, temperature=gas))
    assert 0.2 * bare + 1.0 * thick == pytest.approx(given)
    even = held(own, now_at(x=x, temperature=gas), 4000.0)
    assert even == pytest.approx([gas, gas], abs=0.01)


def test_heat_of_friction_is_never_more_than_its_power():
    rubbed = 1e5 * (2e-3 * 0.05**2 + 2e-4 * 0.05)
    pressed = seen.friction_heat.PressedContact(1.0, 1e5, 2e-3, 2e-4)
    paths = seen.friction_heat.TwoPaths(1.0, 0.5, 2e-3, 2e-4)
    for v in (0.05, -0.05):
        assert pressed.heat(held(pressed, now_at(v=v, p_gauge=1e5), 1.0)) == pytest.approx(
            rubbed / 2, rel=1e-6
        )
        assert paths.heat(held(paths, now_at(v=v, p_gauge=1e5), 9.0)) == pytest.approx(
            rubbed, rel=1e-5
        )
    early = paths.heat(held(paths, now_at(v=0.05, p_gauge=1e5), 0.1))
    assert 1e5 * 2e-4 * 0.05 * 0.98 < early < rubbed


# --- instruments ----------------------------------------------------------------------------------------------


def test_thermometers_show_a_steady_temperature_and_come_late():
    hot = now_at(temperature=T_ATM + 10.0)
    compensated = seen.thermocouple_lag.Compensated(0.2, 0.5)
    recess, bessel = (
        seen.thermocouple_lag.Recess(0.4, 4e-5),
        seen.thermocouple_lag.BesselFilter(0.1),
    )
    for own in (compensated, recess, bessel):
        assert own.reading(held(own, hot, 9.0), T_ATM + 10.0) == pytest.approx(
            T_ATM + 10.0, abs=1e-3
        )
        assert own.reading(own.initial(REST), T_ATM) == T_ATM
    known, bare = ThermocoupleLag(0.2), replace(compensated, r=0.0)
    q = held(known, hot, 0.3)
    assert bare.reading(q, T_ATM + 10.0) == known.reading(q, T_ATM + 10.0)
    assert compensated.reading([T_ATM], T_ATM + 10.0) == pytest.approx(T_ATM + 5.0)
    assert recess.rates([T_ATM, T_ATM], hot._replace(net_mass_flow=-4e-5))[0] == pytest.approx(
        2 * 10.0 / 0.4
    )
    # a ramp comes sqrt(3) tau late
    ramp = solve_ivp(
        lambda t, q: bessel.rates(q, now_at(temperature=T_ATM + 10 * t)),
        (0.0, 4.0),
        bessel.initial(REST),
        rtol=1e-9,
    ).y[0, -1]
    assert ramp == pytest.approx(T_ATM + 10 * (4.0 - sqrt(3) * 0.1), abs=0.01)


def test_gauges_are_right_where_they_were_set():
    pointer = seen.pressure_offset.RestingPointer(4e3, 2e4)
    assert pointer.pressure_shown((), 0.0) == 0.0
    assert pointer.pressure_shown((), 4e5) == pytest.approx(4e5 - 4e3)
    knot = seen.pressure_offset.WrongKnot(0.1, 8e4)
    assert knot.pressure_shown((), 1e4) == pytest.approx(1e4, abs=10.0)
    assert knot.pressure_shown((), 2e5) == pytest.approx(2e5 + 0.1 * 1.2e5, rel=1e-4)
    dial = seen.pressure_offset.EccentricPointer(3e3, 1.0, 2e5)
    readings = [dial.pressure_shown((), p) - p for p in np.linspace(0.0, 4 / 3 * 2e5, 2001)]
    assert readings[0] == 0.0
    assert max(readings) - min(readings) == pytest.approx(6e3, rel=1e-3)
    assert readings[-1] == pytest.approx(0.0, abs=1e-6)


# --- in no family ---------------------------------------------------------------------------------------------


def test_frame_bends_by_the_pull_and_stands_up_again():
    own = seen.none_of_these.CompliantFrame(2e-5, *BRAID, MUSCLE.turns)
    bent = held(own, now_at(x=0.02, p_gauge=1e5), 0.2)
    assert own.position_shown(bent, 0.02) == pytest.approx(
        0.02 - 2e-5 * 1e5 * MUSCLE.volume_slope(0.02), rel=1e-6
    )
    assert held(own, now_at(), 0.2, list(bent))[0] == pytest.approx(0.0, abs=1e-9)


def test_hot_supply_brings_more_enthalpy_with_what_flows_in():
    hot = seen.none_of_these.HotSupply(15.0)
    assert hot.exchange(held(hot, now_at(flow=1e-4), 0.2), 2e5, 300.0) == pytest.approx(
        (0.0, -CP * 1e-4 * 15.0)
    )
    assert hot.exchange(held(hot, now_at(flow=-1e-4), 0.2), 2e5, 300.0)[1] == 0.0


def test_work_over_a_detent_is_nothing_and_up_to_its_middle_what_it_holds():
    own, x = seen.none_of_these.Detent(10.0, 0.025, 1.5e-3), np.linspace(0.0, 0.05, 5001)
    forces = [own.force((), float(place), 0.0, 0.0) for place in x]
    assert max(forces) == pytest.approx(10.0, rel=1e-3)
    assert np.trapezoid(forces, x) == pytest.approx(0.0, abs=1e-9)
    assert np.trapezoid(forces[:2501], x[:2501]) == pytest.approx(
        -10.0 * 1.5e-3 * sqrt(exp(1)), rel=1e-3
    )


def test_rulers_that_follow_badly():
    reel = seen.none_of_these.SlowReel(0.03)
    assert held(reel, now_at(x=0.05), 0.1)[0] == pytest.approx(0.05, rel=1e-6)
    assert 0.05 - held(reel, now_at(x=0.0), 1.0, [0.05])[0] == pytest.approx(0.03, rel=0.05)
    frozen = seen.none_of_these.FrozenDisplay(0.2, 1.0, 0.4)
    assert {0.4, 0.6, 1.4, 1.6} <= {round(t, 9) for t in frozen.drive(STEP).starts}
    assert frozen.rates([0.5, 0.0], now_at(x=0.01)) == (1.0, 0.0)
    assert frozen.rates([0.7, 0.0], now_at(x=0.01))[1] > 0
    rope = seen.none_of_these.SettlingRope(1.5e-3, 0.2)
    assert held(rope, now_at(x=-1e-3), 5.0)[0] == pytest.approx(0.0, abs=1e-7)
    settled = held(rope, now_at(x=0.02), 5.0)
    assert rope.position_shown(settled, 0.02) == pytest.approx(0.0185)
    assert held(rope, now_at(x=-1e-3), 5.0, list(settled)) == pytest.approx(settled)
    counter = seen.none_of_these.LostCounts(0.05, 0.04)
    assert held(counter, now_at(v=0.01), 1.0)[0] == pytest.approx(0.0, abs=1e-8)
    assert held(counter, now_at(v=-0.08), 0.5)[0] == pytest.approx(-0.05 * 0.04, rel=1e-4)


def test_what_else_goes_wrong():
    tap = seen.none_of_these.VenturiTap(300.0)
    for flow in (2e-4, -2e-4):
        assert tap.pressure_shown(held(tap, now_at(flow=flow), 0.2), 1e5) == pytest.approx(
            1e5 - 1200.0
        )
    charge = seen.none_of_these.ResidualCharge(30.0)
    assert charge.reading(held(charge, now_at(v=0.05), 1.0), T_ATM) == pytest.approx(T_ATM + 1.5)
    loop = seen.none_of_these.GroundLoop(2.0)
    assert loop.reading(held(loop, now_at(u=0.35), 0.2), T_ATM) == pytest.approx(T_ATM + 2.0)
    assert loop.reading(loop.initial(REST), T_ATM) == T_ATM
    dripping = seen.none_of_these.DrippingLoad(0.02)
    assert dripping.force(dripping.initial(REST), 0.0, 0.0, 0.0) == 0.0
    assert dripping.force([5.0], 0.03, 0.0, 1e5) == pytest.approx(-0.1 * G)
