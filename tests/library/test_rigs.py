"""Rigs put together from parts: each compiles, runs, has a place for effects, and does what its parts say."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pam_cosim.catalogue import compose_on
from pam_cosim.compiler import compile_model, read_library, read_structure
from pam_cosim.errors import InputError
from pam_cosim.fmu import build_model
from pam_cosim.simulation import Inputs, Simulator
from tests.library.catalogue import effects
from tests.library.rigs import choices, held, rig, run, written

G = 9.80665
ALL = [
    (pneumatics, mechanics, muscle)
    for pneumatics, mechanics in product(choices("pneumatics"), choices("mechanics"))
    for muscle in ("physical", "empirical")
    if muscle == "physical" or pneumatics == "regulator" or mechanics == "spring"
]
NAMED = [
    ("regulator", "spring", muscle)
    for muscle in choices("muscle")
    if muscle not in ("physical", "empirical")
]
FEW = [c for c in ALL if c[2] == "physical" and (c[0] == "regulator" or c[1] == "spring")]
FEW += [("valves", "lever", "empirical"), ("imposed-pressure", "imposed-force", "empirical")]
OF_VALVES = {"valve_area", "valve_dynamics"}
OF_GAS = {"gas_energy", "leak", "dead_volume"}
OF_FORCES = {"elasticity", "dry_friction", "rate_friction", "creep", "end_shape", "moving_mass"}
SENSORS = {
    "p": "pressure_offset",
    "x": "position_sensor",
    "F": "force_sensor",
    "T": "thermocouple_lag",
}


def drive(end: float) -> Inputs:
    """Filled for a while, held, vented."""
    times = np.array([0, 0.4, 0.4, 0.6, 0.6, 1]) * end
    currents = {"u_in": [0.35, 0.35, 0, 0, 0, 0], "u_out": [0, 0, 0, 0, 0.35, 0.35]}
    return Inputs(times, {n: np.array(v, dtype=float) for n, v in currents.items()}, "linear")


@pytest.mark.parametrize("combination", FEW, ids="+".join)
def test_a_combination_compiles(combination: tuple[str, str, str]) -> None:
    made = rig(*combination)
    model = compile_model(str(written(made)))
    assert model is not None and made.inputs + made.outputs


@pytest.mark.full
@pytest.mark.parametrize("combination", [*ALL, *NAMED], ids="+".join)
def test_every_combination_runs_its_default_experiment(combination: tuple[str, str, str]) -> None:
    made = rig(*combination)
    courses = run(made, np.linspace(0, 10, 201))
    for name in made.outputs:
        assert np.isfinite(courses.values[name]).all() and courses.values[name].any(), name
        late = courses.values[name][-20:]
        assert np.ptp(late) <= 0.02 * np.ptp(courses.values[name]) + 1e-9, (
            f"{name} has not come to rest"
        )


# ---- what exists already ---------------------------------------------------------------------------------------------

SAME = [
    ("Isotonic", ("valves", "hanging-load", "physical", "p,x,T"), {}),
    ("Isometric", ("valves", "imposed-length", "physical", "p,F,T"), {}),
    (
        "SwitchedMuscle",
        ("switched-valves", "imposed-length", "physical", "p,T"),
        {"drive.tau": 1e-3},
    ),
]
STOP = 0.0026
"""[N] What the rounded stop of full extension carries at no contraction; Isometric has no stop."""


@pytest.mark.parametrize(
    ("bench", "of", "parameters"),
    [
        pytest.param(*same, id=same[0], marks=[pytest.mark.full] * (same[0] == "SwitchedMuscle"))
        for same in SAME
    ],
)
def test_the_rig_of_a_bench_has_its_trajectory(
    bench: str, of: tuple[str, ...], parameters: dict[str, float]
) -> None:
    times = np.linspace(0, 6, 301)
    inputs = drive(6.0) if bench != "SwitchedMuscle" else None
    made = run(rig(*of), times, parameters, inputs)
    with Simulator(build_model(f"PneumaticMuscle.Benches.{bench}", brief=True)) as simulator:
        there = simulator.run(times, inputs=inputs)
    for name in rig(*of).outputs:
        expected = there.values[name]
        assert made.values[name][1:] == pytest.approx(
            expected[1:], rel=1e-9, abs=1e-9 * np.ptp(expected)
        )
        assert made.values[name][0] == pytest.approx(expected[0], abs=STOP)


# ---- what the parts do -----------------------------------------------------------------------------------------------

TIMES = np.linspace(0, 10, 501)


def test_a_pressure_valve_holds_what_a_voltage_commands_and_no_more_than_its_supply() -> None:
    of = rig("proportional-pressure-valve", "imposed-length", None, "p")
    own = {"valve.k_u": 100e3, "valve.u_0": 0.5}
    held_at = run(of, TIMES, own, held(10.0, u=2.5, p_supply=6e5, s=0.02)).values["p"]
    assert held_at[-1] == pytest.approx(200e3, abs=50.0)
    limited = run(of, TIMES, own, held(10.0, u=5.0, p_supply=3e5, s=0.02)).values["p"]
    assert limited[-1] == pytest.approx(3e5, rel=2e-3)


def test_a_directional_valve_fills_a_muscle_of_constant_length_as_its_opening_says() -> None:
    """Choked, the mass flow does not depend on the pressure behind; within the overlap there is none."""
    of = rig("proportional-directional-valve", "imposed-length", None, "p")
    own = {"valve.A_open": 1e-7, "valve.overlap": 0.1, "drive.tau": 1e-3, "muscle.n_g": 1.0}
    made = run(
        of, TIMES, own, held(10.0, u=8.0, p_supply=6e5, s=0.0), outputs=["muscle.port.m_flow"]
    )
    choked = (TIMES > 0.1) & (made.values["p"] < 0.9 * (0.528 * 7.01e5 - 1.01e5))
    area = 1e-7 * (0.6 - 0.1) / 0.9
    expected = 0.0404184 * (6e5 + 101325.0) * area / np.sqrt(293.15)
    assert choked.sum() > 20
    assert made.values["muscle.port.m_flow"][choked] == pytest.approx(expected, rel=1e-3)
    shut = run(of, TIMES, own, held(10.0, u=5.3, p_supply=6e5, s=0.0)).values["p"]
    assert np.abs(shut).max() < 1e-3 * made.values["p"][-1]


def test_an_imposed_force_is_what_the_load_cell_reads() -> None:
    made = run(
        rig("imposed-pressure", "imposed-force", None, "F"),
        TIMES,
        inputs=held(10.0, p=200e3, F_load=45.0),
    )
    assert made.values["F"][-1] == pytest.approx(45, rel=1e-4)


@pytest.mark.full
def test_a_platform_is_level_under_equal_pressures_and_tilts_towards_the_stronger_muscle() -> None:
    of = rig("imposed-pressure", "platform", None, "x,F")
    level = run(of, TIMES, inputs=held(10.0, p_1=150e3, p_2=150e3, p_3=150e3))
    tilted = run(
        of,
        TIMES,
        inputs=held(10.0, p_1=200e3, p_2=150e3, p_3=150e3),
        outputs=["platform.a", "platform.b"],
    )
    end = {name: values[-1] for name, values in tilted.values.items()}
    assert np.ptp([level.values[f"x_{i}"][-1] for i in (1, 2, 3)]) < 1e-9
    assert sum(level.values[f"F_{i}"][-1] for i in (1, 2, 3)) == pytest.approx(6 * G, rel=1e-4)
    assert sum(end[f"F_{i}"] for i in (1, 2, 3)) == pytest.approx(6 * G, rel=1e-4)
    assert end["platform.a"] > 1e-3 and abs(end["platform.b"]) < 1e-9
    assert end["x_1"] - end["x_2"] == pytest.approx(0.15 * end["platform.a"], rel=1e-6)


FRICTIONLESS = {"muscle.mu_d": 0.0, "muscle.mu_fb": 0.0}


def pull(p: float, x: float, v: float) -> float:
    """The cylinder's force, DP (1), and the braid that carries at full extension."""
    fibre = 0.24**2 + (2 * np.pi * 0.02) ** 2
    stop = max(0.0, -2e5 * x - 500 * v) if x < 0 else 0.0
    return float(p * (3 * (0.24 - x) ** 2 - fibre) / (4 * np.pi * 2**2)) + stop


def swing(
    acceleration: Callable[[float, float], float], start: float, times: np.ndarray
) -> np.ndarray:
    """Position over time [times], solved for apart from the library."""
    solved = solve_ivp(
        lambda t, y: [y[1], acceleration(*y)],
        times[[0, -1]],
        [start, 0.0],
        "Radau",
        times,
        rtol=1e-8,
        atol=1e-10,
    )
    position: np.ndarray = solved.y[0]
    return position


def test_a_spring_swings_as_newton_has_it() -> None:
    times, p, x_0 = np.linspace(0, 1, 201), 150e3, -5.0 / 2e5
    made = run(
        rig("imposed-pressure", "spring", None, "x"), times, FRICTIONLESS, held(1.0, p=p)
    ).values["x"]
    expected = swing(lambda x, v: (pull(p, x, v) - 5 - 2000 * (x - x_0) - 5 * v) / 0.5, x_0, times)
    assert np.ptp(expected) > 0.04 and (np.diff(np.sign(np.diff(expected))) != 0).sum() > 4
    assert made == pytest.approx(expected, abs=2e-4)


def test_a_lever_swings_as_newton_has_it() -> None:
    times, p = np.linspace(0, 1, 201), 80e3
    made = run(
        rig("imposed-pressure", "lever", None, "x"),
        times,
        FRICTIONLESS | {"lever.m": 3.0},
        held(1.0, p=p),
    ).values["x"]

    def acceleration(angle: float, rate: float) -> float:
        force = pull(p, 0.15 * np.sin(angle), 0.15 * np.cos(angle) * rate)
        return float(
            ((0.15 * force - 0.3 * 3 * G) * np.cos(angle) - 0.1 * rate) / (1e-3 + 3 * 0.3**2)
        )

    expected = 0.15 * np.sin(swing(acceleration, np.arcsin(-6 * G / 2e5 / 0.15), times))
    assert np.ptp(expected) > 0.03
    assert made == pytest.approx(expected, abs=2e-4)


def test_a_regulator_lags_and_droops() -> None:
    """Behind a small droop p = p_set (1 - exp(-t/tau)); behind a large one the muscle fills through a resistance."""
    times = np.linspace(0, 1, 201)
    of = rig("regulator", "imposed-length", None, "p")
    inputs = held(1.0, p_set=100e3, s=0.0)
    quick = run(of, times, {"regulator.droop": 1e4, "regulator.tau": 0.1}, inputs).values["p"]
    assert quick == pytest.approx(100e3 * (1 - np.exp(-times / 0.1)), abs=100)
    slow = run(
        of,
        times,
        {"regulator.droop": 1e8, "regulator.tau": 0.1},
        inputs,
        ["regulator.p_still", "muscle.port.m_flow"],
    )
    lost = slow.values["regulator.p_still"] - slow.values["p"]
    assert (
        lost == pytest.approx(1e8 * slow.values["muscle.port.m_flow"], abs=1.0) and lost.max() > 5e3
    )


def test_a_tank_that_nothing_refills_droops_to_the_pressure_of_the_muscle() -> None:
    of = rig("tank", "imposed-length", None, "p")
    made = run(
        of,
        TIMES,
        {"valve.d": 1e-6},
        held(10.0, u_in=0.35, u_out=0.0, p_supply=207e3, s=0.0),
        ["valve.tank.gas.p"],
    )
    tank, p = made.values["valve.tank.gas.p"] - 101325, made.values["p"]
    assert tank[0] == pytest.approx(207e3) and (np.diff(tank) < 1e-3).all()
    assert 0.6 * 207e3 < p[-1] < 0.95 * 207e3 and p[-1] == pytest.approx(tank[-1], rel=0.01)


@pytest.mark.parametrize("p", [120e3, 250e3])
def test_imposed_pressure_arrives(p: float) -> None:
    made = run(
        rig("imposed-pressure", "hanging-load"),
        TIMES,
        inputs=held(10.0, p=p),
        outputs=["muscle.port.p"],
    )
    late = made.values["muscle.port.p"][5:]
    assert late == pytest.approx(p + 101325, abs=10)  # what a gram a second loses


# ---- effects ---------------------------------------------------------------------------------------------------------


def families(combination: tuple[str, str, str], measure: str) -> dict[str, int]:
    """How many effects of each family find a place."""
    file = written(rig(*combination, measure))
    with_rig, structure = read_library(files=[file]), read_structure(str(file))
    placed = [
        e.family
        for e in effects()
        if compose_on(with_rig, structure, [e.qualified_name]) is not None
    ]
    return {family: placed.count(family) for family in dict.fromkeys(placed)}


def check_places(combination: tuple[str, str, str]) -> None:
    measure = "x,F,T" if combination[0] == "imposed-pressure" else "p,x,F,T"
    there = families(combination, measure)
    assert there.keys() >= OF_FORCES | OF_GAS | {"clock_offset", "saturation"}
    assert (there.keys() >= OF_VALVES) == (combination[0] in ("valves", "switched-valves", "tank"))
    assert there.keys().isdisjoint(OF_VALVES) or there.keys() >= OF_VALVES
    assert ("supply_line" in there) == (combination[0] != "imposed-pressure")
    assert there.keys() >= {SENSORS[name] for name in measure.split(",")}
    assert sum(there.values()) >= 70


@pytest.mark.parametrize(
    "combination",
    [FEW[0], ("valves", "lever", "physical"), ("imposed-pressure", "spring", "empirical")],
    ids="+".join,
)
def test_effects_find_their_places(combination: tuple[str, str, str]) -> None:
    check_places(combination)


def test_a_fault_of_an_instrument_finds_no_place_where_it_is_not_read() -> None:
    there = families(("regulator", "spring", "physical"), "x")
    assert "position_sensor" in there
    assert there.keys().isdisjoint(
        {"pressure_offset", "force_sensor", "thermocouple_lag", "temperature_sensor"}
    )


def test_an_effect_is_connected_to_each_muscle_of_a_pair() -> None:
    file = written(rig("regulator", "antagonistic-pair"))
    composed = compose_on(read_library(files=[file]), read_structure(str(file)), ["LinearBladder"])
    assert (
        composed is not None
        and "muscle_1.flange_a" in composed.text
        and "muscle_2.flange_a" in composed.text
    )


# ---- what is asked for -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("regulater", "spring"), "no pneumatics 'regulater'; did you mean 'regulator'"),
        (("regulator", "springs"), "no mechanics 'springs'; did you mean 'spring'"),
        (("regulator", "spring", "phisical"), "no muscle 'phisical'; did you mean 'physical'"),
        (("regulator", "spring", None, "p,q"), "no signal 'q'"),
        (("regulator", "spring", None, "x_1"), "no signal 'x_1' to measure; Known: F, x, p, T"),
        (("imposed-pressure", "spring", None, "p"), "'p' is imposed with imposed-pressure"),
        (("imposed-pressure", "spring", None, " , "), "no signal is measured"),
    ],
)
def test_a_bad_choice_is_said(words: tuple[str, ...], said: str) -> None:
    with pytest.raises(InputError, match=said):
        rig(*words)
