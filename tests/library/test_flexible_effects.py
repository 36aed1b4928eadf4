"""The flexible member of each family: what it spans, and that no values within its bounds break a run."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from functools import cache

import numpy as np
import pytest
from scipy.signal import lsim

from pam_cosim.catalogue import EffectClass
from pam_cosim.model.interface import Interface
from tests.library.shelf import (
    BENCH,
    base,
    built,
    effects,
    homes,
    law_bench,
    noise,
    on_bench,
    run,
    without_numbers,
)
from tests.library.spans import DRIVE, HARNESS, Law, course_misses
from tests.tiers import quick

BESIDE = ("RealGas", "SideVolume", "ThermocoupleStem", "UnevenFriction")
FLEXIBLE = [e for e in effects() if e.name.startswith("Flexible") or e.name in BESIDE or e.general]
MOST_CORNERS = 16
P_ATM, T_ATM = 101325.0, 293.15
Array = np.ndarray
Form = Callable[[Array], Array]


every_flexible = pytest.mark.parametrize("effect", FLEXIBLE, ids=lambda e: e.name)


@every_flexible
def test_runs_at_the_corners_of_its_bounds(effect: EffectClass) -> None:
    assert without_numbers(effect.name, law_bench(effect.name), _corners) == []


@pytest.mark.full
@every_flexible
def test_runs_at_the_corners_of_its_bounds_on_every_bench(effect: EffectClass) -> None:
    for bench in homes(effect.name):
        assert without_numbers(effect.name, bench, _corners) == [], bench


def _corners(interface: Interface, names: Sequence[str]) -> Iterator[dict[str, float]]:
    """All corners, or some that are drawn where they are many.

    Where an effect has several places, the second takes the same corner as the first, and the opposite one.
    """
    places = [
        list(own) for _, own in itertools.groupby(names, lambda name: name.rpartition(".")[0])
    ]
    corners: Sequence[tuple[int, ...]] = list(itertools.product((0, 1), repeat=len(places[0])))
    if len(corners) > MOST_CORNERS:
        drawn = np.random.default_rng(1).choice(len(corners), MOST_CORNERS // 2, replace=False)
        corners = [corners[i] for i in sorted(drawn)]
    for corner in corners:
        for opposite in (0, 1)[: len(places)]:
            ends = [corner, *([side ^ opposite for side in corner] for _ in places[1:])]
            yield {
                name: (v.min, v.max)[side]
                for own, sides in zip(places, ends, strict=True)
                for name, side in zip(own, sides, strict=True)
                if (v := interface.parameters[name]).min is not None and v.max is not None
            }


# Spans: the share of a law's rms that the flexible member leaves, least squares over its working range.

X = np.linspace(0, 0.07, 141)  # m, up to 29 % of the length


@cache
def bladder() -> Law:
    return Law("FlexibleBladder", "bladder.f", {"load.s": X})


def mooney_rivlin(x: Array) -> Array:
    return Law("MooneyRivlinBladder", "bladder.f", {"load.s": x})(C_10=1.2e5, C_01=2e4)


SPRINGS: dict[str, tuple[float, Form]] = {
    "power 4": (0.03, lambda x: x**4),
    "exponential, 15 mm": (0.01, lambda x: np.expm1(x / 0.015)),
    "logarithmic, 5 mm": (0.02, lambda x: np.log1p(x / 0.005)),
    "Mooney-Rivlin": (0.01, mooney_rivlin),
    "locking at 80 mm": (0.05, lambda x: x / (1 - (x / 0.08) ** 2)),
    "slack of 30 mm": (0.13, lambda x: np.maximum(x - 0.03, 0)),
}


@pytest.mark.parametrize("name", SPRINGS)
def test_bladder_spans(name: str) -> None:
    bound, form = SPRINGS[name]
    f = form(X)
    assert bladder().misses(f * 5 / np.sqrt(np.mean(f**2))) < bound


V = np.geomspace(2e-4, 0.3, 200)  # m/s
EVEN = np.sqrt(np.gradient(V) / V.mean())  # every speed counts alike
FRICTIONS: dict[str, tuple[float, Form]] = {
    "power 0.3": (0.01, lambda v: v**0.3),
    "Coulomb and viscous": (0.02, lambda v: 3 * np.tanh(v / 0.002) + 60 * v),
    "Eyring, 2 mm/s": (0.01, lambda v: np.arcsinh(v / 0.002)),
    "saturating at 20 mm/s": (0.04, lambda v: np.tanh(v / 0.02)),
    "Stribeck": (
        0.07,
        lambda v: np.tanh(v / 0.002) * (3 + 3 * np.exp(-((v / 0.02) ** 2))) + 30 * v,
    ),
}


@pytest.mark.parametrize("name", FRICTIONS)
def test_rate_friction_spans(name: str) -> None:
    bound, form = FRICTIONS[name]
    law = weighted_friction()
    f = form(V) * EVEN
    assert law.misses(f * 5 / np.sqrt(np.mean(f**2))) < bound


@cache
def weighted_friction() -> Law:
    return Law("FlexibleRateFriction", "damper.f", {"load.v": V, "muscle.gas.p": P_ATM + 1e5}, EVEN)


PG = np.linspace(500, 2.5e5, 200)  # Pa gauge


@cache
def leak() -> Law:
    return Law("FlexibleLeak", "leak.port.m_flow", {"muscle.gas.p": P_ATM + PG})


def orifice(p: Array) -> Array:
    r = np.maximum(P_ATM / (p + P_ATM), 0.5283)
    return (p + P_ATM) * np.sqrt(np.maximum(r ** (2 / 1.4) - r ** (2.4 / 1.4), 0))


LEAKS: dict[str, tuple[float, Form]] = {
    "orifice": (0.02, orifice),
    "cubic": (0.01, lambda p: p**3),
    "Forchheimer": (0.01, lambda p: np.sqrt(1 + p / 5e3) - 1),
    "saturating": (0.02, lambda p: np.tanh(p / 5e4)),
    "a lip that pressure shuts": (1e-3, lambda p: p * np.exp(-p / 3.35e4)),
    "from 100 kPa on": (0.10, lambda p: np.maximum(p - 1e5, 0)),
}


@pytest.mark.parametrize("name", LEAKS)
def test_leak_spans(name: str) -> None:
    bound, form = LEAKS[name]
    m = form(PG)
    assert leak().misses(m * 2e-6 / np.sqrt(np.mean(m**2))) < bound


# Sleeves: pulls above 8 N. A(e): pull by pressure, by that at full length.
E, P = (a.ravel() for a in np.meshgrid(np.linspace(0, 0.29, 25), np.linspace(2e4, 2.1e5, 25)))
FIBRE = 0.24**2 + (2 * np.pi * 0.02) ** 2
AREA = (3 * 0.24**2 - FIBRE) / (16 * np.pi)


def cylinder(e: Array) -> Array:
    return (3 * 0.24**2 * (1 - e) ** 2 - FIBRE) / (16 * np.pi) / AREA


E, P = E[cylinder(E) * P * AREA > 8], P[cylinder(E) * P * AREA > 8]
SLEEVES: dict[str, tuple[float, Array]] = {
    "Tondu": (1e-3, cylinder(1.1 * E)),
    "Kerscher, 10 %": (0.11, cylinder(E) * (1 + 0.1 * np.exp(-E / 0.1))),
    "ends that close with pressure": (0.01, cylinder((1 + 0.15 * (1 - P / 3e5)) * E)),
    "factor by inverse pressure": (0.065, cylinder(E) * (1 - 3e3 / (P + 3e4))),
}


@cache
def sleeve() -> Law:
    return Law("FlexibleEnds", "muscle.braid.F", {"load.s": 0.24 * E, "muscle.gas.p": P_ATM + P})


@pytest.mark.parametrize("name", quick(SLEEVES, "ends that close with pressure"))
def test_ends_span(name: str) -> None:
    bound, factor = SLEEVES[name]
    assert sleeve().misses(P * AREA * factor, of=P * AREA * (factor - cylinder(E))) < bound


# Valves: inlet, three supplies, four currents.
PM, PS, U = (
    a.ravel()
    for a in np.meshgrid(np.linspace(0.05, 0.99, 20), [1e5, 1.5e5, 2e5], np.linspace(0.2, 0.35, 4))
)
PM = PM * PS
R = (PM + P_ATM) / (PS + P_ATM)
NOMINAL = 0.699 * (1.8e-6 * U - 2.61e-7)
AREAS: dict[str, tuple[float, Array]] = {
    "Perry": (0.05, 1 - 0.3 * R**1.5),
    "square of the ratio": (0.09, 1 - 0.2 * R**2),
    "exponential of the ratio": (0.01, np.exp(-0.3 * R)),
    "square law of current": (0.11, 1 + 0.5 * (U / 0.35 - 1) + 0.5 * (U / 0.35 - 1) ** 2),
}


@cache
def area() -> Law:
    at = {"muscle.gas.p": P_ATM + PM, "p_supply": PS, "u_in": U}
    return Law("FlexibleArea", "valve.area.A[1]", at)


@pytest.mark.parametrize("name", AREAS)
def test_area_spans(name: str) -> None:
    bound, factor = AREAS[name]
    assert area().misses(NOMINAL * factor, of=NOMINAL * (factor - 1)) < bound


# Lines: from the valve at p_a to the muscle at p_b.
PA, PB = (
    a.ravel() for a in np.meshgrid(np.linspace(1.2e5, 3.1e5, 25), np.linspace(1.05e5, 3.0e5, 25))
)
PA, PB = PA[PA > PB + 500], PB[PA > PB + 500]


@cache
def line() -> Law:
    gas = {"line.gas.p": PA, "line.gas.m": PA * 2e-6 / (287.05 * T_ATM), "muscle.gas.p": PB}
    return Law("FlexibleLine", "line.resistance.m_flow", gas)


def isentropic(p_a: Array, p_b: Array) -> Array:
    r = np.maximum(p_b / p_a, 0.5283)
    return p_a * np.sqrt(r ** (2 / 1.4) - r ** (2.4 / 1.4))


LINES: dict[str, tuple[float, Array]] = {
    "laminar": (0.01, PA**2 - PB**2),
    "isentropic": (0.09, isentropic(PA, PB)),
}


@pytest.mark.parametrize("name", LINES)
def test_line_spans(name: str) -> None:
    bound, m = LINES[name]
    assert line().misses(m * 1e-4 / np.sqrt(np.mean(m**2))) < bound


# General members: laws that the flexible member of the family does not say.

GAUGE, STRETCH = (
    a.ravel() for a in np.meshgrid(np.linspace(500, 2.5e5, 25), np.linspace(0, 0.07, 15))
)


def choked_below(b: float) -> Array:
    """Flow by the inlet's pressure where it chokes below the ratio ``b``, ISO 6358, by that of a nozzle."""
    nozzle = isentropic(PS + P_ATM, PM + P_ATM) / (PS + P_ATM)
    return np.sqrt(1 - (np.maximum(R - b, 0) / (1 - b)) ** 2) / nozzle


@cache
def general(family: str) -> Law:
    pressures = {"line.gas.p": PA, "line.gas.m": PA * 2e-6 / (287.05 * T_ATM), "muscle.gas.p": PB}
    both = {"line.gas.p": EACH, "line.gas.m": EACH * 2e-6 / (287.05 * T_ATM), "muscle.gas.p": OTHER}
    return {
        "bladder": lambda: Law("GeneralBladder", "bladder.f", {"load.s": X}),
        "leak": lambda: Law(
            "GeneralLeak", "leak.port.m_flow", {"muscle.gas.p": P_ATM + GAUGE, "load.s": STRETCH}
        ),
        "ends": lambda: Law(
            "GeneralEnds", "muscle.braid.F", {"load.s": 0.24 * E, "muscle.gas.p": P_ATM + P}
        ),
        "area": lambda: Law(
            "GeneralArea",
            "valve.area.A[1]",
            {"muscle.gas.p": P_ATM + PM, "p_supply": PS, "u_in": U},
        ),
        "line": lambda: Law("GeneralLine", "line.resistance.m_flow", pressures),
        "line both ways": lambda: Law("GeneralLine", "line.resistance.m_flow", both),
        "friction": lambda: Law(
            "GeneralRateFriction", "damper.f", {"load.v": V2, "muscle.gas.p": P_ATM + P2}
        ),
    }[family]()


EACH, OTHER = np.concatenate([PA, PB]), np.concatenate([PB, PA])
V2, P2 = (a.ravel() for a in np.meshgrid(np.linspace(2e-3, 0.2, 15), np.linspace(0.0, 2e5, 15)))
ONE_WAY = (EACH**2 - OTHER**2) * np.where(EACH > OTHER, 1.0, 0.4)
GENERAL: dict[str, tuple[str, float, Array, Array | None]] = {
    "slack of 30 mm": ("bladder", 0.04, 200 * np.maximum(X - 0.03, 0), None),
    "leak that stretching opens": ("leak", 0.01, 1e-11 * GAUGE * np.exp(STRETCH / 0.03), None),
    "short fillets": (
        "ends", 0.03, P * AREA * cylinder(E) * (1 + 0.1 * np.exp(-E / 0.1)),
        P * AREA * cylinder(E) * 0.1 * np.exp(-E / 0.1),
    ),
    "critical ratio 0.3": ("area", 0.01, NOMINAL * 0.5 * choked_below(0.3), NOMINAL * (1 - 0.5 * choked_below(0.3))),
    "square law of current": (
        "area", 0.01, NOMINAL * (1 + 0.5 * (U / 0.35 - 1) + 0.5 * (U / 0.35 - 1) ** 2), NOMINAL * 0.5 * (U / 0.35 - 1),
    ),
    "isentropic": ("line", 0.04, isentropic(PA, PB) * 1e-9, None),
    "one way": ("line both ways", 0.01, ONE_WAY * 1e-14, None),
    "film": ("friction", 0.01, 0.1 * np.sqrt(P2 * V2), None),
}  # fmt: skip


@pytest.mark.parametrize("name", quick(GENERAL, "short fillets", "isentropic"))
def test_general_member_spans_more(name: str) -> None:
    family, bound, target, of = GENERAL[name]
    assert general(family).misses(target, of=of) < bound


# With these values it is a flexible member, or the law beside it; to a tenth of the noise, as some can only be small.
CONTAINED: dict[tuple[str, str], tuple[dict[str, float], dict[str, float]]] = {
    ("GeneralWall", "FlexibleWall"): ({"C": 0.5, "G": 0.05, "r": 2.0, "K": 0.2, "n": 0.25}, {"s": 1.0}),
    ("GeneralFrictionHeat", "FlexibleFrictionHeat"): (
        {"share_f": 0.8, "share_b": 0.6, "back_f": 0.5, "back_b": -0.5}, {"tau": 1e-3, "r": 0.01},
    ),
    ("GeneralCreep", "FlexibleCreep"): ({"k_1": 400.0, "k_2": 200.0, "k_3": 100.0, "tau": 0.2}, {}),
    ("GeneralThermocouple", "FlexibleThermocouple"): (
        {"tau": 0.5, "n": 0.3, "b": 2.0, "loss": 0.05}, {"stem": 0.0, "r": 1e-3},
    ),
    ("GeneralThermocouple", "ThermocoupleSheath"): (
        {"tau": 0.5, "r": 0.4}, {"n": 0.0, "b": 0.0, "loss": 0.0, "stem": 0.0},
    ),
}  # fmt: skip


@pytest.mark.parametrize("pair", CONTAINED, ids=lambda pair: " in ".join(reversed(pair)))
def test_general_member_contains_the_others(pair: tuple[str, str]) -> None:
    own, rest = CONTAINED[pair]
    both = []
    for name in pair:
        composition = on_bench(name, BENCH)
        chosen = own | rest
        named = {
            n: chosen[k]
            for n in composition.parameters[name]
            if (k := n.rpartition(".")[2]) in chosen
        }
        both.append(run(built(BENCH, name), named))
    (one, interface), (other, _) = both
    without, _ = base(BENCH)
    for name in one:
        assert one[name] == pytest.approx(other[name], abs=0.1 * noise(interface.outputs[name])), (
            name
        )
    assert any(np.max(np.abs(one[n] - without[n])) > noise(interface.outputs[n]) for n in one)


# Creep: the force after a step of 10 mm.
AFTER = np.concatenate([[0.0, 0.001], np.linspace(0.02, 10, 200)])
RELAXATIONS: dict[str, tuple[float, Form]] = {
    "Maxwell": (0.01, lambda t: np.exp(-t / 2)),
    "Kohlrausch 0.3": (0.025, lambda t: np.exp(-(t**0.3))),
    "logarithm": (0.025, lambda t: 1 - 0.1 * np.log1p(t / 0.1)),
}


@pytest.mark.parametrize("name", RELAXATIONS)
def test_creep_spans(name: str) -> None:
    bound, form = RELAXATIONS[name]
    inputs = {"x_wanted": np.where(AFTER > 0, 0.01, 0.0), "p_wanted": np.full(len(AFTER), 1e5)}
    seen = np.where(AFTER >= 0.02, 1.0, 0.0)
    assert (
        course_misses(HARNESS, "FlexibleCreep", "effect", AFTER, inputs, 4 * form(AFTER), seen)
        < bound
    )


# Dry friction: large and small loops of contraction while the pressure rises from 50 to 150 kPa.
CLOCK = np.linspace(0, 2, 401)
PATH = 0.010 * (1 - np.cos(2 * np.pi * CLOCK)) + 0.0015 * np.sin(10 * np.pi * CLOCK) ** 3
RISING = 5e4 + 5e4 * CLOCK


def slips(travels: Array, path: Array) -> Array:
    """Mean of hard Jenkin elements, each slipping at its own travel [m], by its own force."""
    forces, r = [], np.zeros(len(travels))
    for step in np.diff(path, prepend=path[0]):
        r = np.clip(r + step / travels, -1, 1)
        forces.append(r.mean())
    return np.array(forces)


LOOPS: dict[str, tuple[float, Array, Array]] = {
    "Coulomb": (0.03, np.array([2e-5]), np.full(len(CLOCK), 8.0)),
    "one element of 1 mm": (0.11, np.array([1e-3]), np.full(len(CLOCK), 8.0)),
    "ten elements, by pressure": (0.05, np.linspace(3e-4, 4e-3, 10), 4 + 4e-5 * RISING),
}


@pytest.mark.parametrize("name", quick(LOOPS, "Coulomb"))
def test_dry_friction_spans(name: str) -> None:
    bound, travels, level = LOOPS[name]
    inputs = {"x_wanted": PATH, "p_wanted": RISING}
    target = level * slips(travels, PATH)

    assert course_misses(HARNESS, "FlexibleDryFriction", "effect", CLOCK, inputs, target) < bound


# Drives: opened at 0.1 s and shut at 1.1 s.
TICK = np.linspace(0, 2, 801)
COMMAND = np.where((TICK >= 0.1) & (TICK < 1.1), 0.35, 0.0)


def chain(zeta: float, omega: float) -> Array:
    """A second-order lag after ``COMMAND``."""
    _, y, _ = lsim(([omega**2], [1, 2 * zeta * omega, omega**2]), COMMAND, TICK)
    return np.asarray(y)


def chased(up: float, down: float, rate: float = np.inf) -> Array:
    """A first-order lag [s] that differs up and down, or a limited rate [A/s]."""
    y, currents = 0.0, []
    dt = (TICK[1] - TICK[0]) / 20
    for u in COMMAND:
        currents.append(y)
        for _ in range(20):
            y += dt * float(np.clip((u - y) / (up if u > y else down), -rate, rate))
    return np.array(currents)


COURSES: dict[str, tuple[float, Array]] = {
    "second order, 0.7": (0.05, chain(0.7, 30)),
    "slew rate and lag": (0.02, chased(0.05, 0.05, 2.0)),
}


@pytest.mark.parametrize("name", COURSES)
def test_drive_spans(name: str) -> None:
    bound, target = COURSES[name]
    assert course_misses(DRIVE, "FlexibleDrive", "drive", TICK, {"u": COMMAND}, target) < bound


# Laws of the independent rig: what is left of them in the readings, in standard deviations of the noise.

"""Where a fit begins, if not at the start values: a diagnosis tries ten times more and less of each."""
