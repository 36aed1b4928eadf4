"""Forms that the table marks as the catalogue's are the catalogue's: the same physics gives the same curve."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim.simulation import Simulator
from rig import catalogue
from rig.measurement import TRUTH
from rig.muscle import simulate_muscle
from tests.library.shelf import NOISE, built, effects, on_bench, values
from tests.library.test_effects_against_rig import BENCH, RUN, TIMES, _drive

pytestmark = pytest.mark.full  # many simulations of the rig, in Python

WALL = TRUTH.t_wall / TRUTH.k_wall
SHAPE = (TRUTH.length, TRUTH.fibre_squared, TRUTH.turns, TRUTH.fibre_area)
SAME = {
    "YoungBladder": (catalogue.elasticity.YoungTube(6e5), {"E": 6e5}),
    "MaxwellSlipFriction": (catalogue.dry_friction.MaxwellSlip(8.0, 2e-3), {"F_c": 8, "d": 2e-3}),
    "LoadRateFriction": (catalogue.rate_friction.LoadRate(0.5, *SHAPE[:3]), {"ab": 0.5}),
    "PronyCreep": (catalogue.creep.Prony(300.0, 0.5, 0.8), {"k_1": 300, "k_2": 150, "tau": 0.8}),
    "KerscherEnds": (catalogue.end_shape.KerscherEnds(0.1, 0.1), {"c_3": 0.1, "eps_0": 0.1}),
    "BalancedMass": (catalogue.moving_mass.BalancedMass(3.0), {"m": 3}),
    "CurrentOffsetArea": (catalogue.valve_area.CurrentOffset(0.01), {"u_0": 0.01}),
    "UnequalAreas": (catalogue.valve_area.UnequalAreas(0.85), {"r": 0.85}),
    "LongLine": (catalogue.supply_line.LongTube(5e-6, 4e-7), {"A": 4e-7, "V": 5e-6}),
    "OrificeLine": (catalogue.supply_line.OrificeTube(2e-7, 4e-7), {"A": 4e-7}),
    "LaminarLine": (catalogue.supply_line.LaminarTube(2e-7, 4e-9), {"G": 4e-9}),
    "ConvectiveGas": (catalogue.gas_energy.StirredGas(8.0, WALL, 30.0), {"h_0": 8, "h_1": 30}),
    "StorageWall": (
        catalogue.wall_heat.StorageWall(0.4, 2.0, TRUTH.h_film, WALL / 2, *SHAPE),
        {"C": 0.4, "r": 2},
    ),
    "FibreFrictionHeat": (catalogue.friction_heat.FibreHeat(1.0), {"share": 1}),
    "ThermocoupleSheath": (catalogue.thermocouple_lag.Sheath(0.15, 0.3), {"tau": 0.15, "r": 0.3}),
}


@pytest.mark.parametrize("name", SAME)
def test_same_physics_same_curve(name: str) -> None:
    hidden, own = SAME[name]
    effect = next(e for e in effects() if e.name == name)
    assert effect.family == hidden.family
    parameters = values(effect, on_bench(name, BENCH), own)
    parameters |= {"valve.C_A": TRUTH.calibration, "muscle.mu_fb": TRUTH.mu_fb, "load.m": RUN.load}
    expected = simulate_muscle(
        replace(TRUTH, load=RUN.load), RUN.p_supply, RUN.schedule, TIMES, [hidden], method="LSODA"
    )
    with Simulator(built(BENCH, name)) as simulator:
        simulated = simulator.run(
            TIMES, parameters=parameters, inputs=_drive(), tolerance=1e-7
        ).values
    for signal, course, unit in (
        ("p", expected.p, "Pa"),
        ("x", expected.x, "m"),
        ("T", expected.temperature, "K"),
    ):
        assert np.abs(simulated[signal] - course).max() < 0.3 * NOISE[unit], signal
