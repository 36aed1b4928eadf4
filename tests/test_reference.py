"""The reference simulator against printed values, quadrature and closed forms."""

from __future__ import annotations

import csv
import math
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.signal import lsim

from rig.catalogue.dead_volume import DeadVolume
from rig.catalogue.dry_friction import Coulomb
from rig.catalogue.elasticity import LinearSpring, MooneyRivlin
from rig.catalogue.gas_energy import GasEnergy
from rig.catalogue.leak import LaminarLeak
from rig.catalogue.thermocouple_lag import ThermocoupleLag
from rig.flow import (
    FLOW_CONSTANT,
    P_ATM,
    R_CRITICAL,
    R_LAMINAR,
    T_ATM,
    G,
    R,
    flow_function,
    mass_flow,
)
from rig.muscle import MuscleParameters, simulate_muscle
from rig.quadrature import Approach
from rig.schedule import Phase, Schedule
from rig.tank import Vessel, orifice_port, simulate_vessel, valve_ports

TIMES = np.arange(1001) / 100
STEP = Schedule.of([Phase(5.0, u_in=0.35), Phase(5.0, u_out=0.35)])
FILL = Schedule.of([Phase(10.0, u_in=0.35)])


def sampled_step(pieces: int = 40) -> Schedule:
    """STEP as 100 Hz samples that are joined by lines: a ramp from 4.99 s to 5 s."""
    shares = [(k + 0.5) / pieces for k in range(pieces)]
    ramp = [Phase(0.01 / pieces, 0.35 * (1 - share), 0.35 * share) for share in shares]
    return Schedule.of([Phase(4.99, u_in=0.35), *ramp, Phase(5.0, u_out=0.35)])


# --- values printed in the description of the equations ---------------------------------------------------


@pytest.fixture(scope="module")
def printed_test():  # noqa: ANN201
    return simulate_muscle(MuscleParameters(), 207e3, sampled_step(), TIMES)


@pytest.mark.parametrize(
    ("signal", "t", "printed", "half_digit"),
    [
        ("p", 1.0, 77.4e3, 50.0),
        ("x", 1.0, 56.4e-3, 0.05e-3),
        ("p", 3.0, 206.8e3, 50.0),
        ("x", 3.0, 67.88e-3, 0.005e-3),
        ("p", 6.0, 82.1e3, 50.0),
        ("x", 7.0, 39.5e-3, 0.05e-3),
    ],
)
def test_muscle_reproduces_the_printed_values(printed_test, signal, t, printed, half_digit):
    assert getattr(printed_test, signal)[round(100 * t)] == pytest.approx(printed, abs=half_digit)


@pytest.mark.parametrize(
    ("volume", "n", "p_supply", "share", "printed", "half_digit"),
    [
        (2.1e-3, 1.0, 207e3, 0.5, 13.84, 0.005),
        (2.1e-3, 1.2, 207e3, 0.5, 10.80, 0.005),
        (2.1e-3, 1.4, 207e3, 0.5, 8.85, 0.005),
        (0.35e-3, 1.2, 138e3, 0.9, 3.200, 0.0005),
    ],
)
def test_tank_reproduces_the_printed_times(volume, n, p_supply, share, printed, half_digit):
    filling = Approach(Vessel(volume, n), valve_ports(p_supply, 0.699), 0.0, p_supply, (0.35, 0.0))
    assert filling.time_to(share * p_supply) == pytest.approx(printed, abs=half_digit)


# --- gas ---------------------------------------------------------------------------------------------------


def test_flow_constant_is_the_textbook_value_of_air():
    assert abs(FLOW_CONSTANT - 0.04042) < 1e-5  # s sqrt(K)/m
    assert abs(R_CRITICAL - 0.5283) < 5e-5


@pytest.mark.parametrize("edge", [R_CRITICAL, R_LAMINAR])
def test_flow_function_is_smooth_at_its_edges(edge):
    h = 1e-7
    assert flow_function(edge + h) == pytest.approx(flow_function(edge - h), abs=1e-4)
    left, right = (
        flow_function(edge) - flow_function(edge - h),
        flow_function(edge + h) - flow_function(edge),
    )
    assert right / h == pytest.approx(left / h, abs=1e-2)


def test_flow_reverses_with_the_pressures():
    assert mass_flow(1e-7, 3e5, 300.0, 2e5, 280.0) == -mass_flow(1e-7, 2e5, 280.0, 3e5, 300.0) > 0
    assert mass_flow(1e-7, 2e5, 300.0, 2e5, 280.0) == 0


@pytest.mark.parametrize("p_supply", [207e3, 138e3])
@pytest.mark.parametrize("litres", [2.1, 1.85, 1.6, 1.35, 1.1, 0.85, 0.6, 0.35])
def test_ode_of_the_tank_agrees_with_quadrature(litres, p_supply):
    times = np.linspace(0.0, 60.0, 25)
    vessel, ports = Vessel(litres * 1e-3), valve_ports(p_supply, 0.699)
    for start, end, currents in ((0.0, p_supply, (0.35, 0.0)), (p_supply, 0.0, (0.0, 0.35))):
        exact = Approach(vessel, ports, start, end, currents).pressures(times)
        ode = simulate_vessel(vessel, ports, times, start, Schedule.of([Phase(60.0, *currents)]))
        assert np.abs(ode.p - exact).max() < 2.0


def test_choked_isothermal_vessel_empties_exponentially():
    vessel = Vessel(1e-3, n=1.0, p_ref=790e3 + P_ATM, t_ref=300.0)
    times = np.linspace(0.0, 4.0, 41)
    result = simulate_vessel(vessel, orifice_port(2e-3, 0.84, 0.0), times, 790e3)
    tau = vessel.volume / (FLOW_CONSTANT * 0.84 * math.pi / 4 * 4e-6 * R * math.sqrt(300.0))
    exact = vessel.p_ref * np.exp(-times / tau) - P_ATM
    choked = (exact + P_ATM) * R_CRITICAL > P_ATM
    assert 10 < choked.sum() < 41
    assert result.p[choked] == pytest.approx(exact[choked], rel=1e-6)
    assert result.temperature == pytest.approx(300.0)


def test_vessel_with_orifice_agrees_with_quadrature():
    vessel = Vessel(16.2e-3, n=1.25, p_ref=790e3 + P_ATM, t_ref=296.0)
    ports = orifice_port(2e-3, 0.84, 0.0)
    times = np.linspace(0.0, 60.0, 31)
    result = simulate_vessel(vessel, ports, times, 790e3)
    assert result.p == pytest.approx(Approach(vessel, ports, 790e3, 0.0).pressures(times), abs=2.0)
    assert result.temperature == pytest.approx(296.0 * ((result.p + P_ATM) / vessel.p_ref) ** 0.2)


def test_adiabatic_filling_with_energy_balance_has_the_textbook_temperature():
    times = np.linspace(0.0, 20.0, 11)
    schedule = Schedule.of([Phase(20.0, u_in=0.35)])
    full = simulate_vessel(
        Vessel(), valve_ports(207e3, 0.699), times, 0.0, schedule, [GasEnergy(h=0.0)]
    )
    p = full.p + P_ATM
    exact = p / (
        P_ATM / T_ATM + (p - P_ATM) / (1.4 * T_ATM)
    )  # m c_v T - m_0 c_v T_0 = (m - m_0) c_p T_0
    assert full.temperature[-1] > T_ATM + 30
    assert full.temperature == pytest.approx(exact, rel=1e-6)


# --- muscle ------------------------------------------------------------------------------------------------


@pytest.mark.full
def test_result_does_not_depend_on_the_integrator():
    lsoda = simulate_muscle(MuscleParameters(), 207e3, STEP, TIMES)
    radau = simulate_muscle(MuscleParameters(), 207e3, STEP, TIMES, method="Radau", rtol=1e-9)
    assert np.abs(lsoda.p - radau.p).max() < 0.5
    assert np.abs(lsoda.x - radau.x).max() < 1e-7


def test_force_is_the_slope_of_the_volume():
    muscle, x, h = MuscleParameters(), 0.03, 1e-6
    slope = (muscle.volume(x + h) - muscle.volume(x - h)) / (2 * h)
    assert muscle.volume_slope(x) == pytest.approx(slope, rel=1e-8)
    assert muscle.volume(0.0) == pytest.approx(math.pi / 4 * 0.02**2 * 0.24)


def test_closed_muscle_stays_at_rest():
    still = simulate_muscle(MuscleParameters(), 207e3, Schedule.of([Phase(10.0)]), TIMES)
    assert np.ptp(still.x) < 1e-9
    assert np.abs(still.p).max() < 1e-3


def test_steady_state_balances_the_forces():
    spring = LinearSpring(k=400.0)
    muscle = MuscleParameters()
    end = simulate_muscle(muscle, 207e3, FILL, TIMES, [spring])
    p, x = end.p[-1], end.x[-1]
    pull = p * (muscle.volume_slope(x) - muscle.mu_fb * muscle.fibre_area)
    assert pull == pytest.approx(muscle.load * G + spring.k * x, abs=0.02)


# --- effects -----------------------------------------------------------------------------------------------


def test_mooney_rivlin_is_the_slope_of_its_energy():
    tube = MooneyRivlin()

    def energy(x: float) -> float:
        axial = 1 - x / tube.length
        squared = tube.length**2 + (tube.turns * math.pi * tube.diameter) ** 2
        hoop = math.sqrt(squared - (tube.length - x) ** 2) / (tube.turns * math.pi * tube.diameter)
        stretches = np.array([axial, hoop, 1 / (axial * hoop)])
        wall = math.pi * tube.diameter * tube.thickness * tube.length
        invariants = (stretches**2).sum() - 3, (stretches**-2.0).sum() - 3
        return wall * (tube.c10 * invariants[0] + tube.c01 * invariants[1])

    slope = (energy(0.05 + 1e-6) - energy(0.05 - 1e-6)) / 2e-6
    assert tube.force((), 0.05, 0.0, 0.0) == pytest.approx(slope, rel=1e-6)


def test_coulomb_friction_holds_a_band_of_rest_positions():
    gentle = Schedule.of([Phase(0.5, u_in=0.35), Phase(2.5), Phase(0.02, u_out=0.35), Phase(6.98)])
    moves = [
        abs(x[600] - x[300])
        for effects in ((), [Coulomb(f_c=8.0)])
        for x in [simulate_muscle(MuscleParameters(), 207e3, gentle, TIMES, effects).x]
    ]
    assert moves[0] > 0.5e-3
    assert moves[1] < 0.05e-3


def test_leak_lets_a_closed_muscle_down():
    hold = Schedule.of([Phase(2.0, u_in=0.35), Phase(8.0)])
    muscle = replace(MuscleParameters(), h_film=1e-6)  # no heat through the wall
    tight = simulate_muscle(muscle, 207e3, hold, TIMES)
    leaky = simulate_muscle(muscle, 207e3, hold, TIMES, [LaminarLeak(conductance=2e-11)])
    assert tight.p[300] - tight.p[-1] < 1.0
    gauge, slope = leaky.p[600], (leaky.p[610] - leaky.p[590]) / 0.2
    volume, temperature = muscle.volume(leaky.x[600]), leaky.temperature[600]
    v_rate = muscle.volume_slope(leaky.x[600]) * leaky.v[600]
    expected = -1.4 * (R * temperature * 2e-11 * gauge + (gauge + P_ATM) * v_rate) / volume
    assert slope == pytest.approx(expected, rel=1e-4)


def test_thermocouple_lag_is_a_linear_filter_of_the_gas_temperature():
    fine = np.arange(10001) / 1000
    gas = simulate_muscle(MuscleParameters(), 207e3, STEP, fine)
    slow = simulate_muscle(MuscleParameters(), 207e3, STEP, fine, [ThermocoupleLag(tau=0.3)])
    _, expected, _ = lsim(([1.0], [0.3, 1.0]), gas.temperature - T_ATM, fine)
    assert slow.temperature - T_ATM == pytest.approx(expected, abs=0.02)
    assert slow.x == pytest.approx(gas.x, abs=1e-8)


def test_gas_energy_keeps_the_mass_of_gas_in_a_closed_muscle():
    hold = Schedule.of([Phase(2.0, u_in=0.35), Phase(8.0)])
    end = simulate_muscle(MuscleParameters(), 207e3, hold, TIMES, [GasEnergy()])
    volumes = np.array([MuscleParameters().volume(x) for x in end.x[200:]])
    mass = (end.p[200:] + P_ATM) * volumes / (R * end.temperature[200:])
    assert np.ptp(mass) / mass[0] < 1e-7


@pytest.mark.parametrize("dead", [0.0, 2e-5])
def test_choked_filling_keeps_the_energy_of_gas_and_dead_volume(dead):
    tight = MuscleParameters(h_film=1e-6)
    times = np.linspace(0.0, 0.2, 2001)
    run = simulate_muscle(
        tight, 207e3, Schedule.of([Phase(0.2, u_in=0.35)]), times, [DeadVolume(dead)]
    )
    p, volume = run.p + P_ATM, np.array([tight.volume(x) for x in run.x])
    assert p.max() < R_CRITICAL * (207e3 + P_ATM)
    area = 0.699 * (1.80e-6 * 0.35 - 2.61e-7)
    enthalpy = (
        1.4 / 0.4 * R * T_ATM * mass_flow(area, 207e3 + P_ATM, T_ATM, p[0], T_ATM) * times[-1]
    )
    stored = (p[-1] * (volume[-1] + dead) - p[0] * (volume[0] + dead)) / 0.4
    assert stored + np.trapezoid(p, volume) == pytest.approx(enthalpy, rel=1e-5)


# --- data sets ---------------------------------------------------------------------------------------------


def read(folder: Path) -> tuple[dict, list[list[dict[str, str]]]]:
    experiment = tomllib.loads((folder / "experiment.toml").read_text())
    tables = []
    for run in experiment["runs"]:
        with (folder / run["file"]).open() as file:
            tables.append(list(csv.DictReader(file)))
    return experiment, tables
