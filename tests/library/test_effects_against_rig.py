"""Effects of the library against the independent rig's own programs of the same physics."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim.simulation import Inputs, Simulator
from rig import catalogue
from rig.effect import Effect
from rig.measurement import TRUTH
from rig.muscle import simulate_muscle
from rig.named import effect_of
from rig.plan import default_plan
from tests.library.catalogue import BENCH, NOISE, built, effects, on_bench, values

TIMES = np.linspace(0, 10, 501)
RUN = default_plan()[2]  # fills, holds and vents in parts under a small load

WALL = TRUTH.t_wall / TRUTH.k_wall
SHAPE = (TRUTH.length, TRUTH.fibre_squared, TRUTH.turns, TRUTH.fibre_area)
SAME: dict[str | Effect, tuple[str, dict[str, float]]] = {
    "elasticity:linear": ("LinearBladder", {"k": 250}),
    "elasticity:cubic": ("PolynomialBladder", {"k1": 120, "k3": 5e4}),
    "elasticity:mooney_rivlin": ("MooneyRivlinBladder", {"C_10": 1.2e5, "C_01": 2e4}),
    "dry_friction:dahl": ("DahlFriction", {"F_c": 8, "d": 4e-4}),
    "rate_friction:viscous": ("ViscousFriction", {"c": 300}),
    "rate_friction:pressure": ("PressureViscousFriction", {"c_p": 3e-3}),
    "rate_friction:power": ("PowerLawFriction", {"c": 60 * 0.1**-0.5, "a": 0.5}),
    "creep:maxwell": ("MaxwellCreep", {"k": 400, "tau": 1.5}),
    "end_shape:tondu": ("TonduEnds", {"k": 1.06}),
    "end_shape:kang": ("KangEnds", {"c_1": 0.2, "p_0": 1e5}),
    "moving_mass:hanging": ("HangingMass", {"m": 0.8}),
    "leak:orifice": ("OrificeLeak", {"A": 0.7 * np.pi / 4 * 1e-8}),
    "leak:laminar": ("LaminarLeak", {"G": 2e-11}),
    "valve_dynamics:lag": ("ValveLag", {"tau": 0.08}),
    "valve_dynamics:second_order": ("ValveSecondOrder", {"omega": 25, "zeta": 0.7}),
    "valve_area:back_pressure": ("BackPressureArea", {"beta": 0.15}),
    "dead_volume:constant": ("DeadVolume", {"V_d": 1e-5}),
    "gas_energy:film": ("EnergyGas", {"h": 20}),
    "wall_heat:lumped": ("WarmWall", {"C": 0.4, "G": 0.02}),
    "friction_heat:share": ("FrictionHeat", {"eta": 1}),
    "thermocouple_lag:first_order": ("ThermocoupleLag", {"tau": 0.15}),
    "pressure_offset:constant": ("PressureOffset", {"offset": 5e3}),
    "pressure_offset:gain": ("PressureGain", {"gain": 1.05}),
    catalogue.elasticity.YoungTube(600000.0): ("YoungBladder", {"E": 600000.0}),
    catalogue.dry_friction.MaxwellSlip(8.0, 0.002): ("MaxwellSlipFriction", {"F_c": 8, "d": 0.002}),
    catalogue.rate_friction.LoadRate(0.5, *SHAPE[:3]): ("LoadRateFriction", {"ab": 0.5}),
    catalogue.creep.Prony(300.0, 0.5, 0.8): ("PronyCreep", {"k_1": 300, "k_2": 150, "tau": 0.8}),
    catalogue.end_shape.KerscherEnds(0.1, 0.1): ("KerscherEnds", {"c_3": 0.1, "eps_0": 0.1}),
    catalogue.moving_mass.BalancedMass(3.0): ("BalancedMass", {"m": 3}),
    catalogue.valve_area.CurrentOffset(0.01): ("CurrentOffsetArea", {"u_0": 0.01}),
    catalogue.valve_area.UnequalAreas(0.85): ("UnequalAreas", {"r": 0.85}),
    catalogue.supply_line.LongTube(5e-06, 4e-07): ("LongLine", {"A": 4e-07, "V": 5e-06}),
    catalogue.supply_line.OrificeTube(2e-07, 4e-07): ("OrificeLine", {"A": 4e-07}),
    catalogue.supply_line.LaminarTube(2e-07, 4e-09): ("LaminarLine", {"G": 4e-09}),
    catalogue.gas_energy.StirredGas(8.0, WALL, 30.0): ("ConvectiveGas", {"h_0": 8, "h_1": 30}),
    catalogue.wall_heat.StorageWall(0.4, 2.0, TRUTH.h_film, WALL / 2, *SHAPE): (
        "StorageWall",
        {"C": 0.4, "r": 2},
    ),
    catalogue.friction_heat.FibreHeat(1.0): ("FibreFrictionHeat", {"share": 1}),
    catalogue.thermocouple_lag.Sheath(0.15, 0.3): ("ThermocoupleSheath", {"tau": 0.15, "r": 0.3}),
}


@pytest.mark.parametrize("hidden", SAME, ids=lambda hidden: SAME[hidden][0])
def test_same_physics_same_curve(hidden: str | Effect) -> None:
    name, own = SAME[hidden]
    effect = next(e for e in effects() if e.name == name)
    hidden = effect_of(hidden) if isinstance(hidden, str) else hidden
    assert effect.family == hidden.family
    if name == "EnergyGas":  # the rig's film coefficient is that of the whole wall
        own = {"h": 2 / (1 / own["h"] - TRUTH.t_wall / TRUTH.k_wall)}
    parameters = values(effect, on_bench(name, BENCH), own)
    parameters |= {"valve.C_A": TRUTH.calibration, "muscle.mu_fb": TRUTH.mu_fb, "load.m": RUN.load}
    muscle = replace(TRUTH, load=RUN.load)
    expected = simulate_muscle(muscle, RUN.p_supply, RUN.schedule, TIMES, [hidden])
    with Simulator(built(BENCH, name)) as simulator:
        simulated = simulator.run(
            TIMES, parameters=parameters, inputs=_drive(), tolerance=1e-7
        ).values
    for signal, course, unit in (
        ("p", expected.p, "Pa"),
        ("x", expected.x, "m"),
        ("T", expected.temperature, "K"),
    ):
        # regularisation at equal pressures and the position at rest on the stop differ a little
        assert np.abs(simulated[signal] - course).max() < 0.3 * NOISE[unit], signal


def _drive() -> Inputs:
    times = [0.0]
    for phase in RUN.phases:
        times.append(times[-1] + phase.duration)
    starts = np.array(times[:-1])
    currents = [RUN.schedule.at(t + 1e-6) for t in starts]
    values = {
        "u_in": np.array([c[0] for c in currents]),
        "u_out": np.array([c[1] for c in currents]),
    }
    return Inputs(starts, values | {"p_supply": np.full(len(starts), RUN.p_supply)}, "previous")
