"""Forms that the catalogue lacks, where a simpler law or a conserved quantity says what they must give."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from rig import seen
from rig.catalogue.dry_friction import Dahl
from rig.catalogue.elasticity import MooneyRivlin
from rig.effect import Now, Rest
from rig.flow import GAMMA, P_ATM, T_ATM, R
from rig.muscle import MuscleParameters, simulate_muscle
from rig.schedule import Phase, SampledSchedule, Schedule

pytestmark = pytest.mark.full  # many simulations of the rig, in Python

REST = Rest(0.0, 1e-4, T_ATM, (0.0, 0.0))


def _now(x: float = 0.0, v: float = 0.0, p_gauge: float = 0.0, heat: float = 0.0) -> Now:
    return Now(x, v, p_gauge, T_ATM, (0.0, 0.0), 0.0, heat)


@pytest.mark.parametrize("x", [0.005, 0.03, 0.07])
def test_long_chains_of_gent_are_neo_hookean(x):
    force = seen.elasticity.GentTube(mu=2e5, limit=1e6).force((), x, 0.0, 0.0)
    assert force == pytest.approx(MooneyRivlin(c10=1e5, c01=0.0).force((), x, 0.0, 0.0), rel=1e-5)
    assert seen.elasticity.GentTube(mu=2e5, limit=3.0).force((), x, 0.0, 0.0) > force


def test_bouc_wen_of_first_order_is_dahl():
    own, known = seen.dry_friction.BoucWen(8.0, 1e-3, 1.0, 1.0), Dahl(8.0, 8e3)

    def rates(t: float, y: np.ndarray) -> list[float]:
        now = _now(v=0.02 * np.cos(2 * pi * t))
        return [*own.rates(y[:1], now), *known.rates(y[1:], now)]

    y = solve_ivp(rates, (0.0, 1.5), [0.0, 0.0], rtol=1e-9, atol=1e-12).y
    for a, b in zip(y[0], y[1], strict=True):
        assert own.force([a], 0.0, 0.0, 0.0) == pytest.approx(
            known.force([b], 0.0, 0.0, 0.0), abs=1e-4
        )


def test_bouc_wen_dissipates_in_a_closed_cycle_and_stays_bounded():
    own = seen.dry_friction.BoucWen(n=2.0, g=0.5)

    def rates(t: float, y: np.ndarray) -> list[float]:
        v = 0.02 * np.cos(2 * pi * t)
        return [*own.rates(y[:1], _now(v=v)), own.force(y[:1], 0.0, v, 0.0) * v]

    y = solve_ivp(rates, (0.0, 3.0), [0.0, 0.0], rtol=1e-8, atol=1e-10, max_step=0.01).y
    assert np.abs(y[0]).max() < 1 + 1e-6
    assert y[1, -1] > 0.0


def test_rocker_keeps_its_energy():
    own = seen.moving_mass.Rocker(m=3.0, radius=0.15)

    def rates(t: float, y: np.ndarray) -> list[float]:
        return [y[1], -own.force((), y[0], y[1], 0.0) / own.balanced_mass(y[0])]

    y = solve_ivp(rates, (0.0, 1.0), [0.0, 0.1], rtol=1e-10, atol=1e-12).y
    energy = [own.balanced_mass(x) * v * v for x, v in y.T]
    assert y[0, -1] > 0.09
    assert energy == pytest.approx([energy[0]] * len(energy), rel=1e-7)


def test_flywheel_is_a_mass_for_slow_movements():
    own = seen.moving_mass.SlippingFlywheel(m=3.0, tau=0.01)
    y = solve_ivp(
        lambda t, y: own.rates(y, _now(v=0.2 * t)), (0.0, 1.0), [0.0], rtol=1e-9, atol=1e-12
    ).y
    assert own.force(y[:, -1], 0.0, 0.2, 0.0) == pytest.approx(3.0 * 0.2, rel=1e-4)


def test_hose_balances_enthalpy_with_energy_and_work():
    own = seen.dead_volume.Hose(1e-5, 5e-6)
    q = np.array(own.initial(REST))
    assert own._gas(q) == pytest.approx((P_ATM, T_ATM))
    fill = solve_ivp(
        lambda t, y: own.rates(y, _now(p_gauge=1e5)), (0.0, 1.0), q, rtol=1e-9, atol=(1e-13, 1e-9)
    )
    p, temperature = own._gas(fill.y[:, -1])
    assert p == pytest.approx(P_ATM + 1e5, rel=1e-4)
    volume = own.volume * (1 + own.expansion * (p - P_ATM))
    before, after = P_ATM * own.volume / (R * T_ATM), p * volume / (R * temperature)
    # enthalpy of what came in = gain of internal energy + work on the hose, whose pressure is linear in its volume
    work = (P_ATM + p) / 2 * (volume - own.volume)
    gained = (p * volume - P_ATM * own.volume) / (GAMMA - 1)
    assert GAMMA * R / (GAMMA - 1) * T_ATM * (after - before) == pytest.approx(
        gained + work, rel=1e-6
    )


def test_critical_ratio_of_the_nozzle_changes_little_and_a_lower_one_throttles():
    for p_down in (1.1e5, 1.5e5, 2.2e5, 2.9e5):
        assert seen.valve_area.CriticalRatio(0.0).valve_factor(3e5, p_down) == pytest.approx(
            1.0, abs=0.03
        )
    assert seen.valve_area.CriticalRatio(0.3).valve_factor(3e5, 1.5e5) < 0.97
    assert seen.valve_area.CriticalRatio(0.3).valve_factor(3e5, 0.3e5) == pytest.approx(1.0)


def test_blasius_drop_goes_with_flow_to_seven_quarters():
    tube = seen.supply_line.BlasiusTube(c=2e-10)
    flows = [tube.flow(p, T_ATM, 2e5, T_ATM) for p in (2.5e5, 3e5)]
    drops = [p * p - 4e10 for p in (2.5e5, 3e5)]
    assert np.log(drops[1] / drops[0]) / np.log(flows[1] / flows[0]) == pytest.approx(
        7 / 4, rel=1e-3
    )


def test_thick_wall_keeps_its_heat():
    own = seen.wall_heat.ThickWall(capacity=1.0, tau=8.0, g_out=0.0)
    y = solve_ivp(
        lambda t, y: own.rates(y, _now(heat=-0.5)),
        (0.0, 4.0),
        own.initial(REST),
        rtol=1e-9,
        atol=1e-9,
    ).y
    assert np.mean(y[:, -1]) - T_ATM == pytest.approx(0.5 * 4.0 / 1.0, rel=1e-6)
    assert list(y[:, -1]) == sorted(y[:, -1], reverse=True)


def test_diaphragm_solves_its_cubic():
    own = seen.pressure_offset.StiffeningDiaphragm(0.2, 1.5e5)
    for p in (-1e4, 0.0, 5e4, 2.5e5):
        shown = own.pressure_shown((), p)
        assert shown + 0.2 * shown**3 / 1.5e5**2 == pytest.approx(p, rel=1e-9, abs=1e-6)


@pytest.mark.parametrize(
    "schedule",
    [
        Schedule.of([Phase(1.0, u_in=0.3), Phase(9.0)]),
        SampledSchedule.joined([(0.0, 0.0), (0.3, 0.0), (0.3, 0.1), (0.0, 0.1)], 0.5),
    ],
)
def test_what_faults_do_to_the_command(schedule):
    skewed = seen.none_of_these.ClockSkew(0.02).drive(schedule)
    pushed = seen.none_of_these.Nudge(start=0.7, duration=0.6).drive(schedule)
    for t in (0.2, 0.8, 1.2, 1.4):
        assert skewed.at(1.02 * t) == pytest.approx(schedule.at(t))
        assert pushed.at(t) == schedule.at(t)
    assert {0.7, 1.3} <= {round(t, 9) for t in pushed.starts}


def test_a_short_push_is_not_stepped_over():
    times = np.arange(601) / 100
    schedule = Schedule.of([Phase(1.0, u_in=0.3), Phase(9.0)])
    base, pushed = (
        simulate_muscle(MuscleParameters(), 2e5, schedule, times, effects, 1e-6, "LSODA").x
        for effects in ((), (seen.none_of_these.Nudge(20.0, 4.0, 0.3),))
    )
    away = np.abs(pushed - base)
    assert away[(times > 4.05) & (times < 4.3)].max() > 1e-4
    assert away[times < 4.0].max() < 1e-5
