"""Case number and set -> a data set and what is hidden in it.

    python -m blind_cases.sets FOLDER --set tuning --number 7

The composition repeats every 60 cases: 30 with one form of the catalogue, 12 with one form that it lacks, 6 pairs, 7
with nothing hidden, 5 with an effect in no family; mixed, so that the first cases already are a fair sample.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from blind_cases import table
from blind_cases.noise import SIGNALS, USUAL, Sensors, disturb, draw_sensors
from blind_cases.plans import draw_muscle, draw_plan
from blind_cases.sizes import Bench, FreeParameter, Ruler, Signals, calibrated
from rig import data_set
from rig.data_set import Description, Recording
from rig.effect import Effect
from rig.muscle import MuscleParameters
from rig.named import effect_parameters

Random = np.random.Generator
SEEDS = {"tuning": 4711, "score": 830519}
GROUPS = {"catalogue": 30, "new_form": 12, "pair": 6, "null": 7, "none_of_these": 5}
PERIOD = sum(GROUPS.values())
CLASSES = ((0.3, 1.0), (1.0, 3.0), (3.0, 10.0), (10.0, 30.0), (30.0, 80.0))
"""Classes of projected size in standard deviations of the noise; within a class evenly by order of magnitude."""
_SHOWN = (2, 0, 3, 1, 4, 2, 3)  # the order in which classes come: 3 to 10 and 10 to 30 twice

_PARAMETER_UNITS = {"muscle.h_film": "W/(m2.K)", "muscle.D0": "m", "muscle.L0": "m", "load.m": "kg"}


@dataclass(frozen=True)
class Case:
    """What a case number stands for, before anything is simulated.

    Attributes:
        hidden: forms of the table. targets: sizes wanted, in standard deviations.
        index: how many cases of the same group come before it in the set.
    """

    which: str
    number: int
    group: str
    index: int
    hidden: tuple[table.Form, ...]
    targets: tuple[float, ...]

    def rng(self, stream: int) -> Random:
        """A stream of random numbers of this case alone."""
        return np.random.default_rng([SEEDS[self.which], self.number, stream])


@dataclass(frozen=True)
class Made:
    """A case that was simulated: what was recorded, and its description."""

    case: Case
    bench: Bench
    sensors: Sensors
    recorded: list[Signals]
    description: dict[str, object]


def spread(shares: Mapping[str, int]) -> tuple[str, ...]:
    """Names by their shares, each spread evenly over one period."""
    slots = [((k + 0.5) / count, name) for name, count in shares.items() for k in range(count)]
    return tuple(name for _, name in sorted(slots))


_ORDER = spread(GROUPS)
_MIXED = tuple(
    table.FAMILIES[7 * k % 16] for k in range(16)
)  # neighbours belong to different balances


def case_of(which: str, number: int) -> Case:
    """The case with this number (from 0) of a set.

    Raises ValueError for an unknown set or a negative number.
    """
    if which not in SEEDS or number < 0:
        raise ValueError(f"there is no case {number} of a set '{which}'; sets: {', '.join(SEEDS)}")
    place, group = number % PERIOD, _ORDER[number % PERIOD]
    index = number // PERIOD * GROUPS[group] + _ORDER[:place].count(group)
    case = Case(which, number, group, index, (), ())
    rng = case.rng(0)
    if group in ("catalogue", "new_form"):
        turn, k = divmod(index, 16)
        choice = table.forms(which, group == "catalogue")[_MIXED[k]]
        bounds = CLASSES[_SHOWN[(turn + 3 * k) % len(_SHOWN)]]
        return replace(case, hidden=(choice[turn % len(choice)],), targets=(_within(rng, bounds),))
    if group == "none_of_these":
        choice = table.strange_forms(which)
        return replace(
            case, hidden=(choice[index % len(choice)],), targets=(_within(rng, (5.0, 40.0)),)
        )
    if group == "pair":
        choice = table.forms(which, True)
        # every family comes about equally often, with another partner in every turn
        first = index % 16
        second = (first + 1 + (7 * index + index // 16 + SEEDS[which]) % 15) % 16
        picked = tuple(
            choice[f][int(rng.integers(len(choice[f])))] for f in (_MIXED[first], _MIXED[second])
        )
        # what has no strength of its own sets the noise, so it comes first
        picked = tuple(sorted(picked, key=lambda form: form.high / form.low))
        return replace(
            case, hidden=picked, targets=tuple(_within(rng, (5.0, 30.0)) for _ in picked)
        )
    return case


def _within(rng: Random, bounds: tuple[float, float]) -> float:
    return float(np.exp(rng.uniform(*np.log(bounds))))


def _draw_bench(rng: Random) -> Bench:
    """Geometry, plan and the six free parameters, whose truth is not where a fit starts."""
    nominal = draw_muscle(rng)
    sixth = ("muscle.D0", "muscle.L0", "load.m")[int(rng.integers(0, 3))]
    plan = draw_plan(rng, nominal, sixth == "load.m")
    usual = (
        ("valve.C_A", "calibration", 0.5, 0.9, rng.uniform(0.58, 0.84)),
        ("muscle.n_g", "n_g", 1.0, 1.4, rng.uniform(1.06, 1.34)),
        ("muscle.mu_fb", "mu_fb", 0.002, 0.06, rng.uniform(0.008, 0.03)),
        ("muscle.h_film", "h_film", 2.0, 100.0, _within(rng, (10.0, 45.0))),
        ("muscle.mu_d", "mu_d", 0.1, 2.0, rng.uniform(0.5, 1.1)),
    )
    free = [
        FreeParameter(name, field, low, high, float(f"{true:.5g}"))
        for name, field, low, high, true in usual
    ]
    field, about, off, room = {
        "muscle.D0": ("diameter", nominal.diameter, 0.02, 0.05),
        "muscle.L0": ("length", nominal.length, 0.01, 0.03),
        "load.m": ("load", plan[0].load, 0.04, 0.1),
    }[sixth]
    true = float(f"{about * (1 + rng.uniform(-off, off)):.5g}")
    free.append(FreeParameter(sixth, field, about * (1 - room), about * (1 + room), true, about))
    muscle = replace(nominal, **{p.field: p.true for p in free})
    if sixth == "load.m":
        plan = tuple(replace(run, load=true) for run in plan)
    return Bench(muscle, plan, tuple(free))


def outline(case: Case) -> dict[str, Any]:
    """What is known of a case before it is simulated: the description of one that could not be."""
    return {
        "set": case.which,
        "number": case.number,
        "group": case.group,
        "families": [form.family for form in case.hidden if form.family != "none_of_these"],
        "hidden": [
            {
                "family": form.family,
                "form": form.name,
                "in_catalogue": form.catalogue,
                "target": target,
            }
            for form, target in zip(case.hidden, case.targets, strict=True)
        ],
    }


def make(case: Case) -> Made:
    """Simulates a case. Raises RuntimeError when its hidden effect cannot be simulated at any strength."""
    bench = _draw_bench(case.rng(1))
    sensors = draw_sensors(case.rng(2))
    # without a hidden effect there is nothing to measure, and the sensitivities are not needed
    ruler = Ruler(bench) if case.hidden else None
    effects: list[Effect] = []
    sizes: list[dict[str, object]] = []
    for k, (form, target) in enumerate(zip(case.hidden, case.targets, strict=True)):
        assert ruler is not None
        rng = case.rng(10 + k)
        at = form.make(rng, bench.muscle)
        if form.signed and rng.random() < 0.5:
            at = _negative(at)
        strength, size = calibrated(ruler, at, sensors.sigma, target, form.low, form.high)
        if k == 0:
            sensors, size = _fitting_noise(sensors, size, target)
        effects.append(at(strength))
        sizes.append(
            {"strength": strength, "size": size, "parameters": effect_parameters(effects[-1])}
        )
    clean = ruler.simulated(effects) if ruler else bench.simulate()
    zero = dict.fromkeys(SIGNALS, 0.0)
    plain, projected = ruler.sizes(clean, sensors.sigma) if ruler else (zero, zero)
    noise = case.rng(3)
    recorded = [disturb(noise, sensors, run) for run in clean]
    known = outline(case)
    description: dict[str, object] = known | {
        "hidden": [a | b for a, b in zip(known["hidden"], sizes, strict=True)],
        "size": {"plain": plain, "projected": projected},
        "sensors": sensors.as_dict(),
        "rig": {
            "L0": bench.muscle.length, "D0": bench.muscle.diameter, "turns": bench.muscle.turns,
            "fibres": bench.muscle.fibres, "t_wall": bench.muscle.t_wall,
        },
        "free": {p.name: {"true": p.true, "min": p.low, "max": p.high} for p in bench.free},
        "plan": [
            {"style": r.style, "role": r.role, "load": r.load, "p_supply": r.p_supply, "seconds": r.samples / 100}
            for r in bench.plan
        ],
        "noise": _noise_found(bench, sensors, clean, recorded),
    }  # fmt: skip
    return Made(case, bench, sensors, recorded, description)


def _negative(at: Callable[[float], Effect]) -> Callable[[float], Effect]:
    return lambda s: at(-s)


def _fitting_noise(sensors: Sensors, size: float, target: float) -> tuple[Sensors, float]:
    """Where the strength is at its bound, the instruments are made quieter or louder, between 0.1 and 10 times usual.

    Sizes go as one over the noise.
    """
    if abs(np.log(size / target)) < 0.4:
        return sensors, size
    name = next(iter(sensors.sigma))
    loud = sensors.sigma[name] / USUAL[name]
    factor = min(max(size / target, 0.1 / loud), 10.0 / loud)
    sigma = {name: float(f"{value * factor:.3g}") for name, value in sensors.sigma.items()}
    return replace(sensors, sigma=sigma), size / factor


def _noise_found(
    bench: Bench, sensors: Sensors, clean: Sequence[Signals], recorded: Sequence[Signals]
) -> dict[str, object]:
    """Mean square of recorded minus true and number of samples, by role and signal [SI]: what the truth leaves.

    Without outliers, which whoever compares sets aside.
    """
    by_role: dict[str, object] = {}
    for role in ("fit", "holdout"):
        runs = [k for k, run in enumerate(bench.plan) if run.role == role]
        by_signal = {}
        for name in SIGNALS:
            error = np.concatenate([recorded[k][name] - clean[k][name] for k in runs])
            error = sensors.without_outliers(name, error[np.isfinite(error)])
            by_signal[name] = {"mean_square": float(np.mean(error**2)), "samples": len(error)}
        by_role[role] = by_signal
    return by_role


def write(made: Made, folder: Path) -> None:
    """Writes experiment.toml and the runs; nothing in them says what is hidden."""
    bench, sensors = made.bench, made.sensors
    own_load = all(p.name != "load.m" for p in bench.free)
    runs = [
        Recording(
            run.schedule,
            run.p_supply,
            run.role,
            run.times,
            signals,
            run.load if own_load else None,
            run.interpolation,
        )
        for run, signals in zip(bench.plan, made.recorded, strict=True)
    ]
    free = {p.name: (_with_unit(p.low, p), _with_unit(p.high, p)) for p in bench.free}
    title, sigma = f"case {made.case.number}", sensors.sigma if sensors.stated else None
    data_set.write(folder, runs, Description(title, sigma, SIGNALS, _known(bench), free))


def _known(bench: Bench) -> dict[str, str]:
    """What [parameters] says: the geometry as drawn, the nominal value of a free dimension."""
    muscle: MuscleParameters = bench.muscle
    known = {
        "muscle.L0": (muscle.length, "m"), "muscle.D0": (muscle.diameter, "m"), "muscle.t_wall": (muscle.t_wall, "m"),
    }  # fmt: skip
    values = {name: f'"{value:.9g} {unit}"' for name, (value, unit) in known.items()}
    values |= {p.name: _with_unit(p.nominal, p) for p in bench.free if p.nominal is not None}
    return values | {"muscle.turns": f"{muscle.turns:.9g}", "muscle.fibres": f"{muscle.fibres:.9g}"}


def _with_unit(value: float, of: FreeParameter) -> str:
    unit = _PARAMETER_UNITS.get(of.name)
    return f'"{value:.9g} {unit}"' if unit else f"{value:.9g}"
