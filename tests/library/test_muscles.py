"""Muscles by name and by law: what was published of them, and sleeves by any measures that determine them."""

from __future__ import annotations

from functools import cache
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.catalogue import compose_on
from pam_cosim.compiler import read_library, read_structure
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fmu import build_source
from pam_cosim.simulation import Inputs, Simulator
from tests.library.rigs import held, rig, run, written

TABLES = Path(__file__).parent / "isometric"
Table = tuple[np.ndarray, np.ndarray, np.ndarray]


@cache
def table(name: str) -> Table:
    """Pressures [Pa], lengths [m] and pulls [N] of a published table."""
    lengths = (TABLES / name).read_text().split("\n", 1)[0].split(",")[1:]
    rows = np.loadtxt(TABLES / name, delimiter=",", skiprows=1)
    return rows[:, 0], np.array([float(length.split()[0]) / 1e3 for length in lengths]), rows[:, 1:]


A1, A2 = "DMSP-20-300.csv", "DMSP-10-250.csv"


def rms(residual: np.ndarray) -> float:
    return float(np.sqrt(np.mean(residual**2)))


# ---- muscles by name -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "of", "left"), [("DMSP10", A2, 6.2), ("DMSP20", A1, 13.5)])
def test_a_fluidic_muscle_pulls_as_was_measured(name: str, of: str, left: float) -> None:
    """What its documentation says is left; a ramp of a second from one pressure to the next is slow enough."""
    pressures, lengths, pulls = table(of)
    times, courses = np.arange(len(pressures) + 1.0), np.array([pressures[0], *pressures])
    isometric = rig("imposed-pressure", "imposed-length", name, "F")
    for_all = []
    for length in lengths:
        s = lengths[0] - length
        inputs = Inputs(times, {"p": courses, "s": np.full_like(times, s)}, "linear")
        for_all.append(run(isometric, times, {"drive.s_start": s}, inputs).values["F"])
    made = np.transpose(for_all)[1:]
    assert made.min() > -0.01
    assert left - 0.3 < rms(made - pulls) < left


@pytest.mark.parametrize(
    ("name", "pull", "pressure", "within"),
    [("DMSP10", 630, 8e5, 0.05), ("DMSP20", 1500, 6e5, 0.06), ("DMSP40", 6000, 6e5, 0.06)],
)
def test_a_fluidic_muscle_pulls_what_its_maker_says(
    name: str, pull: float, pressure: float, within: float
) -> None:
    made = run(
        rig("imposed-pressure", "imposed-length", name, "F"),
        np.linspace(0, 1, 11),
        inputs=held(1.0, p=pressure, s=0.0),
    )
    assert made.values["F"][-1] == pytest.approx(pull, rel=within)


def test_the_air_muscle_pulls_what_the_slides_say_and_rubs_on_nothing() -> None:
    """AM, theoretical force equation 1 at full length: 476 N at 600 kPa, 134 N more than with 216 fibres that rub."""
    muscle, pressure, angle = rig("imposed-pressure", "imposed-length", "AirMuscle", "F"), 6e5, 23.0
    slope = np.tan(np.radians(angle))
    pull = np.pi / 4 * 0.01**2 * pressure * (3 / slope**2 - (1 + slope**-2))
    made = run(muscle, np.linspace(0, 1, 11), inputs=held(1.0, p=pressure, s=0.0))
    assert made.values["F"][-1] == pytest.approx(pull, abs=0.01)
    assert made.warnings == ()


# ---- any measures that determine a sleeve ----------------------------------------------------------------------------

ANGLE = 0.4
SLEEVE = {
    "L0": 0.2,
    "D0": 0.015,
    "turns": 0.2 * np.tan(ANGLE) / (np.pi * 0.015),
    "b": 0.2 / np.cos(ANGLE),
    "alpha_0": ANGLE,
}
FRICTIONLESS = {"muscle.mu_fb": 0.0, "muscle.mu_d": 0.0}
SETS = [s for n in (3, 4, 5) for s in combinations(SLEEVE, n) if "D0" in s or "turns" in s]


@cache
def any_geometry() -> Path:
    made = rig("imposed-pressure", "imposed-length", "any-geometry", "F")
    return build_source(made.name, made.text, brief=True)


def sleeve(**measures: float) -> dict[str, float]:
    """Length, diameter, turns and pull at 100 kPa of the sleeve with these measures."""
    unstated = dict.fromkeys([*SLEEVE, "fittings"], 0.0)
    shown = ["muscle.L0", "muscle.D0", "muscle.turns", "F"]
    with Simulator(any_geometry()) as simulator:
        made = simulator.run(
            np.linspace(0, 0.5, 6),
            parameters=FRICTIONLESS
            | {f"muscle.sleeve.{name}": value for name, value in (unstated | measures).items()},
            inputs=held(0.5, p=1e5, s=0.0),
            outputs=shown,
            max_seconds=30,
        )
    return {name.rpartition(".")[2]: float(made.values[name][-1]) for name in shown}


@pytest.mark.parametrize("stated", SETS, ids="+".join)
def test_a_sleeve_is_determined_by(stated: tuple[str, ...]) -> None:
    made = sleeve(**{name: SLEEVE[name] for name in stated})
    assert [made[n] for n in ("L0", "D0", "turns")] == pytest.approx(
        [SLEEVE[n] for n in ("L0", "D0", "turns")], rel=1e-9
    )
    pull = 1e5 * np.pi / 4 * 0.015**2 * (3 / np.tan(ANGLE) ** 2 - 1 / np.sin(ANGLE) ** 2)
    assert made["F"] == pytest.approx(pull, rel=1e-3)


@pytest.mark.parametrize(
    ("measures", "said"),
    [
        (SLEEVE | {"turns": 2.0}, "contradict each other.*turns = 2"),
        (SLEEVE | {"b": 0.25}, "contradict each other.*b = 0.25"),
        ({"L0": 0.2, "D0": 0.015, "b": 0.15}, "contradict each other"),
        ({"D0": 0.03, "turns": 3.0, "b": 0.2}, "contradict each other"),
        ({"L0": 0.2, "D0": 0.015}, "not determined: state three of L0, D0, turns, b and alpha_0"),
        ({"L0": 0.2, "b": 0.22, "alpha_0": np.arccos(0.2 / 0.22)}, "with D0 or turns among them"),
        ({"L0": 0.2, "D0": 0.015, "turns": 1.0, "fittings": 0.2}, "fittings shorter than that"),
    ],
)
def test_measures_that_contradict_each_other_or_do_not_suffice(
    measures: dict[str, float], said: str
) -> None:
    with pytest.raises((InputError, SimulationFailure), match=said):
        sleeve(**measures)


# ---- laws of fluidic muscles -----------------------------------------------------------------------------------------

LAWS = "PneumaticMuscle.Laws.Forces"


def pull(law: str, p: np.ndarray, eps: np.ndarray, L0: float, **geometry: float) -> np.ndarray:
    """Pull [N] of a muscle with a law, each point a sample of the static bench; ``geometry`` may state coefficients."""
    own = {"D0": geometry.pop("D0", 0.02), "alpha_0": geometry.pop("alpha_0", 0.5), "L0": L0}
    stated = ", ".join(f"{n}={v!r}" for n, v in own.items())
    coefficients = ", ".join(f"{n}={v!r}" for n, v in geometry.items())
    change = (
        f"redeclare model Braid = {law}({coefficients})"
        if coefficients
        else f"redeclare model Braid = {law}"
    )
    text = f"""model Bench "A law"
      extends PneumaticMuscle.Benches.StaticForce(muscle({stated}, {change}));
    end Bench;"""
    times = np.arange(float(p.size))
    with Simulator(build_source("Bench", text, brief=True)) as simulator:
        inputs = Inputs(times, {"p": p.ravel(), "eps": eps.ravel()}, "linear")
        made: np.ndarray = simulator.run(times, inputs=inputs, max_seconds=30).values["F"]
    return made.reshape(p.shape)


def grid(of: str) -> Table:
    """Pressures, contraction ratios and pulls of a table, each as a matrix."""
    pressures, lengths, pulls = table(of)
    p, eps = np.meshgrid(pressures, 1 - lengths / lengths[0], indexing="ij")
    return p, eps, pulls


def test_sarosi_in_the_units_that_he_takes() -> None:
    """p in bar, contraction in percent; the 400 mm muscle."""
    a = (-4.35573, 281.22370, -0.32866, -9.27035, 302.20107, -263.69185)
    p, eps, _ = grid(A1)
    bar, percent = p / 1e5, eps * 100
    printed = (
        (a[0] * bar + a[1]) * np.exp(a[2] * percent) + a[3] * bar * percent + a[4] * bar + a[5]
    )
    made = pull(f"{LAWS}.Sarosi", p, eps, 0.4)
    assert made == pytest.approx(np.maximum(printed, 0), abs=0.06) and (printed < -50).any()


@pytest.mark.parametrize(
    ("L0", "p", "expected"), [(0.112, 620e3, 335.3), (0.054, 620e3, 219.86), (0.054, 300e3, 106.38)]
)
def test_bolen_as_the_equations_have_it(L0: float, p: float, expected: float) -> None:
    """335.3 N is printed. For the shorter muscle the paper works out 230 and 112 N, which its equations do not give."""
    assert pull(f"{LAWS}.Bolen", np.array([p, p]), np.zeros(2), L0)[0] == pytest.approx(
        expected, abs=0.06
    )


@pytest.mark.parametrize(("law", "left"), [("Hildebrandt", 4.3), ("Wickramatunge", 26.6)])
def test_a_law_leaves_of_the_table_what_its_documentation_says(law: str, left: float) -> None:
    p, eps, pulls = grid(A1)
    assert left - 0.3 < rms(pull(f"{LAWS}.{law}", p, eps, 0.296) - pulls) < left


def test_the_wall_as_an_effect_holds_until_its_threshold_and_does_not_push() -> None:
    """On the muscle of DP: no pull up to p_0, then the cylinder's less p_0; nothing where the cylinder would push."""
    bench = rig("imposed-pressure", "imposed-length", None, "F")
    file = written(bench)
    with_wall = compose_on(
        read_library(files=[file]),
        read_structure(str(file)),
        ["PneumaticMuscle.Effects.Elasticity.StiffWall"],
    )
    assert with_wall is not None
    source = f"{bench.text}\n{with_wall.text}"
    values = FRICTIONLESS | {"membrane.p_0": 40e3, "membrane.p_w": 0.0}
    with Simulator(build_source(with_wall.name, source, brief=True)) as simulator:
        times = np.array([0.0, 1.0, 2.0, 3.0])
        inputs = Inputs(times, {"p": np.array([2e4, 2e4, 4e4, 2e5]), "s": np.zeros(4)}, "linear")
        made = simulator.run(times, parameters=values, inputs=inputs, max_seconds=30).values["F"]
        far = Inputs(times, {"p": np.full(4, 2e5), "s": np.full(4, 0.12)}, "linear")
        pushed = simulator.run(
            times, parameters=values | {"drive.s_start": 0.12}, inputs=far, max_seconds=30
        ).values["F"]
    area = (2 * 0.24**2 - (2 * np.pi * 0.02) ** 2) / (16 * np.pi)
    assert made[1:] == pytest.approx([0, 0, 1.6e5 * area], abs=0.1)
    assert np.abs(pushed).max() < 0.1
