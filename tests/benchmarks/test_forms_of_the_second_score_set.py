"""Forms that the score set had the second time, where a simpler law or a conserved quantity says what they give."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import exp, log, pi, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from blind_cases import table
from blind_cases.cases import _draw_bench
from blind_cases.noise import draw_sensors
from blind_cases.sizes import Ruler
from rig import seen
from rig.catalogue.creep import Creep
from rig.catalogue.dry_friction import Coulomb
from rig.catalogue.elasticity import MooneyRivlin
from rig.catalogue.gas_energy import EnergyGas
from rig.catalogue.wall_heat import WarmWall
from rig.flow import GAMMA, P_ATM, T_ATM, R, mass_flow
from rig.muscle import MuscleParameters
from rig.schedule import Phase, SampledSchedule, Schedule
from rig.seen.wall_heat import TwoLayerWall
from rig.states import REST, held, now_at

pytestmark = pytest.mark.full  # many simulations of the rig, in Python


def test_heat_of_friction_is_as_large_as_the_catalogues():
    bench = _draw_bench(np.random.default_rng(77))
    ruler = Ruler(replace(bench, plan=(*bench.plan[:2], bench.plan[-1])))
    sigma = draw_sensors(np.random.default_rng(4)).sigma

    def full(name: str) -> float:
        form = next(
            form for form in table.FORMS if (form.family, form.name) == ("friction_heat", name)
        )
        return ruler.size(form.make(np.random.default_rng(5), ruler.bench.muscle)(1.0), sigma)

    assert full("moving_contact") > full("share")


@pytest.mark.parametrize("x", [0.005, 0.03, 0.07])
def test_yeohs_first_term_is_neo_hookean_and_the_others_soften_and_stiffen(x):
    neo = MooneyRivlin(c10=1e5, c01=0.0).force((), x, 0.0, 0.0)
    assert seen.elasticity.YeohTube(c1=1e5, r2=0.0, r3=0.0).force((), x, 0.0, 0.0) == pytest.approx(
        neo, rel=1e-9
    )
    assert 0 < seen.elasticity.YeohTube(c1=1e5, r2=0.05, r3=0.0).force((), x, 0.0, 0.0) < neo
    assert seen.elasticity.YeohTube(c1=1e5, r2=0.0, r3=0.05).force((), x, 0.0, 0.0) > neo


def test_work_on_the_side_spring_is_that_of_its_stretching():
    own, x = seen.elasticity.SideSpring(1000.0, 0.08, 0.9), np.linspace(0.0, 0.06, 2001)
    work = np.trapezoid([own.force((), float(place), 0.0, 0.0) for place in x], x)
    before, after = 0.08 - 0.072, sqrt(0.08**2 + 0.06**2) - 0.072
    assert work == pytest.approx(500.0 * (after**2 - before**2), rel=1e-6)


def test_creep_without_hardening_or_warmth_is_maxwell():
    known, q, stretched = Creep(400.0, 1.5), [0.02], now_at(x=0.05)
    for own in (seen.creep.HardeningCreep(400.0, 1.5, m=0.0), seen.creep.WarmCreep(400.0, 1.5)):
        assert own.rates(q, stretched) == pytest.approx(known.rates(q, stretched))
        assert own.force(q, 0.05, 0.0, 0.0) == known.force(q, 0.05, 0.0, 0.0)


def test_hardened_dashpot_flows_by_a_root_of_time_at_first():
    # q' = e x_0/(tau q) with e near 0.1: q^2 = 2 e x_0 t/tau
    own = seen.creep.HardeningCreep(tau=0.3, x_0=1e-6, m=1.0)
    assert held(own, now_at(x=0.1), 10.0)[0] == pytest.approx(
        sqrt(2 * 0.1 * 1e-6 * 10.0 / 0.3), rel=0.05
    )


def test_time_and_temperature_shift_as_williams_landel_and_ferry_say():
    own = seen.creep.WarmCreep(tau=1.0)
    # the universal constants about the glass transition, 90 K lower
    expected = 10 ** (17.44 * 110.0 / (51.6 + 110.0) - 17.44 * 90.0 / (51.6 + 90.0))
    rates = [
        own.rates([0.0], now_at(x=0.01, temperature=t))[0]
        for t in (T_ATM, T_ATM + 40.0, T_ATM - 40.0)
    ]
    assert rates[1] / rates[0] == pytest.approx(expected, rel=0.02)
    assert rates[2] < rates[0]


def test_contact_comes_back_below_its_breakaway_and_slides_beyond():
    own = seen.dry_friction.ElastoPlastic(8.0, 1e-3, 0.6)
    there = held(own, now_at(v=0.001), 0.5)
    assert there[0] == pytest.approx(0.5)
    assert held(own, now_at(v=-0.001), 0.5, there)[0] == pytest.approx(0.0, abs=1e-9)
    for v in (0.02, -0.02):
        assert own.force(held(own, now_at(v=v), 2.0), 0.0, v, 0.0) == pytest.approx(
            8.0 * np.sign(v), rel=1e-3
        )


def test_wiper_drags_by_its_mean_and_alike_without_a_lip():
    own, known = seen.dry_friction.Wiper(8.0, 0.4, 1e-3), Coulomb(8.0, 1e-3)
    out, back = (own.force((), 0.0, v, 0.0) for v in (0.05, -0.05))
    assert (out - back) / 2 == pytest.approx(8.0)
    assert out == pytest.approx(8.0 * 1.4)
    assert seen.dry_friction.Wiper(8.0, 0.0, 1e-3).force((), 0.0, 7e-4, 0.0) == pytest.approx(
        known.force((), 0.0, 7e-4, 0.0)
    )


def test_grease_breaks_down_with_shear_and_sets_again():
    own = seen.rate_friction.ThixotropicGrease(400.0, 0.3, 0.01, 2.0)
    sheared = held(own, now_at(v=0.05), 10.0)
    assert sheared[0] == pytest.approx(1 / (1 + 2.0 * 0.05 / 0.01), rel=1e-6)
    assert own.force([0.0], 0.0, 0.05, 0.0) == pytest.approx(0.3 * 400.0 * 0.05)
    assert own.force([1.0], 0.0, -0.05, 0.0) == pytest.approx(-400.0 * 0.05)
    assert held(own, now_at(), 2.0, [0.0])[0] == pytest.approx(1 - exp(-1), rel=1e-6)


def test_viscous_bladder_is_the_rate_of_its_stretches():
    muscle, x, v, step = MuscleParameters(), 0.03, 0.05, 1e-6
    own = seen.rate_friction.ViscousBladder(1e5, 3.8e-6, muscle.length, muscle.fibre_squared)
    lengths = [muscle.length - x + side * step for side in (1, -1)]
    girths = [sqrt(muscle.fibre_squared - length**2) for length in lengths]
    along, around = (log(pair[1] / pair[0]) / (2 * step) * v for pair in (lengths, girths))
    thinning = -(along + around)
    power = 2 * 1e5 * 3.8e-6 * (along**2 + around**2 + thinning**2)
    assert own.force((), x, v, 0.0) * v == pytest.approx(power, rel=1e-6)


def test_ends_fade_with_their_length_and_under_pressure():
    muscle = MuscleParameters()
    shape = (muscle.length, muscle.fibre_squared, muscle.turns)
    assert seen.end_shape.RoundedTips(1e-9, *shape).shape_factor(0.03, 1e5) == pytest.approx(1.0)
    thick = sqrt(4 * muscle.volume(0.05) / (pi * (muscle.length - 0.05)))
    active = muscle.length - 0.6 * thick
    assert seen.end_shape.RoundedTips(0.6, *shape).shape_factor(0.05, 1e5) == pytest.approx(
        muscle.length / active
    )
    folds = seen.end_shape.UnfoldingEnds(0.2, 5e4)
    assert folds.pull_factor(0.02, 5e4) == pytest.approx(0.9)
    assert folds.pull_factor(0.02, 4e5) == pytest.approx(1.0, abs=1e-9)


def test_side_sled_keeps_its_energy_and_is_a_mass_far_along():
    own = seen.moving_mass.SideSled(4.0, 0.03, 0.08)

    def rates(t: float, y: np.ndarray) -> list[float]:
        return [y[1], -own.force((), y[0], y[1], 0.0) / own.balanced_mass(y[0])]

    y = solve_ivp(rates, (0.0, 1.0), [0.0, 0.1], rtol=1e-10, atol=1e-12).y
    energy = [own.balanced_mass(x) * v * v for x, v in y.T]
    assert y[1, -1] < 0.08
    assert energy == pytest.approx([energy[0]] * len(energy), rel=1e-7)
    assert own.balanced_mass(10.0) == pytest.approx(4.0, rel=1e-3)


@pytest.mark.parametrize(
    "schedule",
    [
        Schedule.of([Phase(1.03, u_in=0.3), Phase(9.0)]),
        SampledSchedule.joined([(0.0, 0.0), (0.3, 0.0), (0.3, 0.1), (0.0, 0.1)], 0.5),
    ],
)
def test_command_is_held_for_a_cycle(schedule):
    held = seen.valve_dynamics.HeldCommand(0.1, 0.5).drive(schedule)
    for t in (0.1, 0.4, 1.05, 1.11, 1.2, 3.0):
        tick = 0.05 + 0.1 * np.floor((t - 0.05) / 0.1 + 1e-9)
        assert held.at(t) == pytest.approx(schedule.at(float(tick)))
    assert held.at(0.01) == (0.0, 0.0)


def test_three_lags_answer_as_a_gamma_distribution():
    own = seen.valve_dynamics.ThreeLags(0.05)
    q = held(own, now_at(u=0.3), 0.1)
    n = 0.1 / 0.05
    assert own.current(q, (0.3, 0.0)) == pytest.approx(
        (0.3 * (1 - exp(-n) * (1 + n + n * n / 2)), 0.0), rel=1e-6
    )


def test_openings_agree_with_the_linear_law_where_they_must():
    port = seen.valve_area.RoundPort(1.0, 9e-7)
    assert port.areas((0.0, 4.5e-7), (0.0, 0.3)) == pytest.approx((0.0, 4.5e-7))
    assert port.areas((9e-7, 1.2e-6), (0.6, 0.7)) == pytest.approx((9e-7, 9e-7))
    # a quarter of the stroke uncovers a segment of 120 degrees
    assert port.areas((2.25e-7, 0.0), (0.3, 0.0))[0] == pytest.approx(
        9e-7 * (pi / 3 - sqrt(3) / 4) / pi
    )
    slot = seen.valve_area.NarrowSlot(1e-8)
    assert slot.areas((1e-5, 1e-8), (0.3, 0.3)) == pytest.approx((1e-5, 5e-9), rel=2e-3)


def test_steady_line_is_laminar_and_starts_by_its_inertance():
    own = seen.supply_line.InertialLine(5e-6, 4e-9, 1.6e5)
    q = own.initial(REST)
    assert own.line_rates(q, (0.0, 0.0), P_ATM - 1e3, T_ATM)[2] == pytest.approx(1e3 / 1.6e5)
    p_b, energy = 2e5, 3e5 * 5e-6 / (GAMMA - 1)
    steady = 4e-9 * (9e10 - 4e10) / (2 * P_ATM)
    rates = own.line_rates((2e-5, energy, steady), (steady, 0.0), p_b, T_ATM)
    assert rates[0] == pytest.approx(0.0, abs=1e-15)
    assert rates[2] == pytest.approx(0.0, abs=1e-9)


def test_chamber_behind_a_hole_balances_enthalpy():
    own = seen.dead_volume.OrificeChamber(1e-5, 3e-7)
    mass, energy = held(own, now_at(p_gauge=1e5), 3.0)
    assert (GAMMA - 1) * energy / own.volume == pytest.approx(P_ATM + 1e5, rel=1e-4)
    before = P_ATM * own.volume / (R * T_ATM)
    assert mass - before == pytest.approx(1e5 * own.volume / (R * T_ATM) / GAMMA, rel=1e-4)
    assert own.exchange(own.initial(REST), P_ATM + 1e5, T_ATM)[0] == mass_flow(
        3e-7, P_ATM + 1e5, T_ATM, P_ATM, T_ATM
    )


def test_stub_fills_from_its_mouth_and_in_the_end_alike():
    own = seen.dead_volume.CapillaryStub(1e-5, 5e-10)
    early, late = (held(own, now_at(p_gauge=1e5), t) for t in (0.1, 60.0))
    assert list(early) == sorted(early, reverse=True)
    assert early[0] > 1.02 * early[2]
    assert late == pytest.approx([(P_ATM + 1e5) * own.volume / 3 / (R * T_ATM)] * 3, rel=1e-6)
    flow = own.exchange(early, P_ATM + 1e5, T_ATM)[0]
    assert sum(own.rates(early, now_at(p_gauge=1e5))) == pytest.approx(flow)


def test_cut_gapes_with_the_hoop_stress():
    muscle = MuscleParameters()
    cut = seen.leak.CutBladder(5e-9, muscle.length, muscle.fibre_squared)
    flows = [cut.exchange([0.0], P_ATM + p, 300.0)[0] for p in (0.0, 1e5, 2e5)]
    assert flows[0] == 0.0
    assert flows[1] == pytest.approx(mass_flow(5e-9, P_ATM + 1e5, 300.0, P_ATM, T_ATM))
    assert flows[2] > 2.5 * flows[1]
    # the stress p D/(2 t), and the wall's thickness goes as one over its area
    area = [
        sqrt(muscle.fibre_squared - (muscle.length - x) ** 2) * (muscle.length - x)
        for x in (0.0, 0.05)
    ]
    girth = [sqrt(muscle.fibre_squared - (muscle.length - x) ** 2) for x in (0.0, 0.05)]
    wider = cut.exchange([0.05], P_ATM + 1e5, 300.0)[0] / flows[1]
    assert wider == pytest.approx(girth[1] * area[1] / (girth[0] * area[0]))


def test_labyrinth_of_many_turns_goes_with_the_root_of_their_number():
    few, many = (seen.leak.Labyrinth(1e-8, n).leak(3e5, T_ATM) for n in (1e4, 4e4))
    assert few / many == pytest.approx(2.0, rel=1e-3)
    own = seen.leak.Labyrinth(1e-8, 5.0)
    assert own.leak(3e5, T_ATM) == pytest.approx(
        1e-8 * sqrt((9e10 - P_ATM**2) / (R * T_ATM * (5.0 + log(3e5 / P_ATM)))), rel=1e-4
    )
    assert own.leak(P_ATM, T_ATM) == 0.0


def test_turbulence_decays_as_length_over_time():
    own = seen.gas_energy.DecayingTurbulence(h=8.0, wall=0.0, h_1=15.0, eddy=0.02, b=2e6)
    assert own.film(own.initial(REST), 0.0, P_ATM, T_ATM) == pytest.approx(4.0, abs=0.01)
    stirred = held(own, now_at(flow=-1e-4), 2.0)
    assert stirred[1] == pytest.approx(sqrt(2e6 * 1e-4 * 0.02), rel=1e-6)
    assert held(own, now_at(), 1.0, list(stirred))[1] == pytest.approx(0.02 / 1.0, rel=0.02)
    assert own.film([1e-4, 1.0], 0.0, P_ATM, T_ATM) == pytest.approx(11.5, rel=1e-6)


def test_gas_spring_in_the_end_only_loses_what_goes_through_the_wall():
    own, plain = seen.gas_energy.GasSpring(20.0, 1.8e-3, 1.5, 0.3), EnergyGas(20.0, 1.8e-3)
    q = held(own, now_at(temperature=T_ATM + 20.0), 6.0)

    def heat(states: Sequence[float]) -> float:
        film = own.film(states, 0.0, P_ATM, T_ATM + 20.0)
        return film * (own.wall_temperature(states, T_ATM) - T_ATM - 20.0)

    through = plain._through(20.0)
    assert heat(q) == pytest.approx(-through * 20.0, rel=1e-6)
    assert heat(own.initial(REST)) == pytest.approx(-2.5 * through * 20.0, rel=1e-6)


def test_walls_keep_their_heat_and_are_known_ones_at_rest():
    ends = seen.wall_heat.MetalEnds(0.4, 8.0, 0.0, 0.04)
    bladder, metal = held(ends, now_at(heat=-0.5), 4.0) - T_ATM
    assert 0.4 * bladder + 3.2 * metal == pytest.approx(0.5 * 4.0)
    assert bladder > metal > 0
    layers, warm = TwoLayerWall(0.4, 8.0, 0.04, 0.0), [T_ATM + 5.0, T_ATM + 1.0]
    assert ends.rates(warm, now_at()) == pytest.approx(layers.rates(warm, now_at()))
    fanned, still = seen.wall_heat.FannedWall(0.4, 0.02, 0.02), WarmWall(0.4, 0.02)
    assert fanned.rates(warm[:1], now_at()) == pytest.approx(
        still.rates(warm[:1], now_at()), rel=0.03
    )
    assert fanned.rates(warm[:1], now_at(v=-0.02))[0] == pytest.approx(
        2 * still.rates(warm[:1], now_at())[0], rel=1e-3
    )


def test_contact_that_moves_slowly_gives_all_its_heat():
    def arrived(v: float) -> float:
        own = seen.friction_heat.MovingContact(0.5, 0.05, 2e-3, 2e-4)
        return own.heat(held(own, now_at(v=v, p_gauge=1e5), 2.0)) / (
            1e5 * (2e-3 * v**2 + 2e-4 * abs(v))
        )

    assert arrived(1e-6) == pytest.approx(0.5, rel=0.01)
    assert arrived(0.05) == pytest.approx(0.25, rel=1e-6)
    assert arrived(-0.05) == pytest.approx(0.25, rel=1e-6)


def test_thermometers_are_late_by_their_times():
    poles = seen.thermocouple_lag.ThreePoles(0.1)
    ramp = solve_ivp(
        lambda t, q: poles.rates(q, now_at(temperature=T_ATM + 10 * t)),
        (0.0, 4.0),
        poles.initial(REST),
        rtol=1e-9,
    ).y[:, -1]
    assert poles.reading(ramp, T_ATM) == pytest.approx(T_ATM + 10 * (4.0 - 0.3), abs=0.01)
    lag = seen.thermocouple_lag.LongWire(0.2, 0.0)
    assert lag.reading(held(lag, now_at(temperature=T_ATM + 10.0), 0.2), T_ATM) == pytest.approx(
        T_ATM + 10 * (1 - exp(-1)), rel=1e-6
    )


def test_long_wire_ends_as_a_fin():
    own = seen.thermocouple_lag.LongWire(0.1, 4.0)
    tip = own.reading(held(own, now_at(temperature=T_ATM + 10.0), 5.0), T_ATM) - T_ATM
    # four pieces of half a decay length each; the tip's middle is half a piece short of the end
    assert tip == pytest.approx(10 * (1 - np.cosh(0.25) / np.cosh(2.0)), rel=0.02)


def test_bridge_is_right_at_small_pressures_and_off_by_its_share_at_full_scale():
    own = seen.pressure_offset.UnbalancedBridge(0.05, 3e5)
    assert own.pressure_shown((), 10.0) == pytest.approx(10.0, rel=1e-5)
    assert own.pressure_shown((), 3e5) == pytest.approx(3e5 / 1.05)
    assert seen.pressure_offset.UnbalancedBridge(-0.05, 3e5).pressure_shown((), 3e5) > 3e5


def test_lamp_goes_on_and_off_at_switches():
    own = seen.none_of_these.HeatLamp(2.0, 0.4, 0.5, 0.5)
    assert {0.5, 1.3, 2.5, 3.3} <= {
        round(t, 9) for t in own.drive(Schedule.of([Phase(9.0)])).starts
    }
    assert [own.heat([t]) for t in (0.4, 0.6, 1.2, 1.4, 2.6)] == [0.0, 0.5, 0.5, 0.0, 0.5]


def test_tank_loses_what_is_taken_and_recovers():
    own = seen.none_of_these.BufferTank(300.0, 1e9)
    drawn = held(own, now_at(flow=1e-4), 2.0)
    assert own.supply(drawn, 3e5) == pytest.approx(3e5 * (1 - 300.0 * 2e-4))
    assert held(own, now_at(flow=-1e-4), 2.0, list(drawn)) == pytest.approx(drawn)
    assert held(seen.none_of_these.BufferTank(300.0, 3.0), now_at(), 3.0, [0.1])[
        0
    ] == pytest.approx(0.1 * exp(-1), rel=1e-6)


def test_what_the_other_mishaps_show_and_hold():
    sagging = seen.none_of_these.SaggingExcitation(0.03)
    assert sagging.pressure_shown(held(sagging, now_at(u=0.35), 0.2), 1e5) == pytest.approx(0.97e5)
    assert sagging.pressure_shown(sagging.initial(REST), 1e5) == 1e5
    magnet = seen.none_of_these.HoldingMagnet(8.0, 1e-3)
    assert [magnet.force((), x, 0.0, 0.0) for x in (-1e-4, 1e-3, 1.0)] == pytest.approx(
        [8.0, 2.0, 0.0], abs=1e-4
    )
    heated = seen.none_of_these.SelfHeating(2.0, 3e-5)
    assert heated.reading(heated.initial(REST), T_ATM) == pytest.approx(T_ATM + 2.0)
    assert heated.reading(held(heated, now_at(flow=-3e-5), 2.0), T_ATM) == pytest.approx(
        T_ATM + 1.0
    )


def test_a_clock_of_its_own_shows_where_the_load_was_or_will_be():
    own = seen.none_of_these.OwnClock(0.01)

    def place(t: float) -> float:
        return 0.02 * np.sin(2.0 * t)

    q = solve_ivp(
        lambda t, q: own.rates(q, now_at(x=place(t))),
        (0.0, 3.0),
        own.initial(REST),
        rtol=1e-9,
        atol=1e-12,
    ).y[:, -1]
    assert own.position_shown(q, place(3.0)) == pytest.approx(place(3.03), abs=5e-5)
    assert abs(place(3.03) - place(3.0)) > 1e-3
