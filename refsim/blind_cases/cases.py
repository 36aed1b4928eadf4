"""Case number and set -> a data set and what is hidden in it.

    python -m blind_cases.cases FOLDER --set tuning3 --number 7

writes one data set and prints what is hidden in it.

The forms of sets `tuning2` and `score2` are those labelled `tuning` and `score` in `table.py`. Set `score3` has those
of the catalogue that `score2` has, of motion (`beginnings.py`); set `score4` hides the same forms in other cases. Set
`tuning3` begins like `score3`, with all forms of `tuning2` and `score2`, which may be looked at. Set `tuning4` has the
catalogue's forms as `tuning3` has them, and new forms that no other set has, those of `table_further.py`.

The composition repeats every 80 cases: 24 with one form of the catalogue, 14 with one form that it lacks, 10 pairs, 8
triples, 10 faults of instruments, 8 with nothing hidden, 6 effects in no family; mixed, so that the first cases already
are a fair sample.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from blind_cases import apart, table
from blind_cases.beginnings import IN_THE_MIDDLE, begun
from blind_cases.faults import FAULTS, ON_SOME_BENCH, FaultForm, Scene
from blind_cases.noise import USUAL, Sensors, disturb, draw_sensors
from blind_cases.setups import SHARES, Design, Setup, draw, draw_design
from blind_cases.sizes import Ruler, Signals, calibrated
from rig import tables
from rig.effect import Effect
from rig.instruments import LATE, ClockOffset, Fault, family_of
from rig.muscle import MuscleParameters
from rig.named import effect_parameters

Random = np.random.Generator
Hidden = table.Form | FaultForm
SEEDS = {
    "tuning2": 90217,
    "score2": 20261122,
    "score3": 31415926,
    "score4": 14142135,
    "tuning3": 27182818,
    "tuning4": 16180339,
}
FORMS_OF = {
    "tuning2": ("tuning",), "score2": ("score",), "score3": ("score",), "score4": ("score",),
    "tuning3": ("tuning", "score"), "tuning4": ("tuning", "score"),
}  # fmt: skip
"""By which labels of the table a set's forms are known."""
NEW_FORMS_OF = {"tuning4": ("tuning4",)}
"""The same for the new forms of a set, where they have a label of their own."""
APART = ("score3", "score4")
"""Sets whose forms lie apart."""
IN_MOTION = ("score3", "score4", "tuning3", "tuning4")
"""Sets half of whose recordings begin in the middle of motion."""
GROUPS = {
    "catalogue": 24, "new_form": 14, "pair": 10, "triple": 8, "instrument": 10, "null": 8, "none_of_these": 6,
}  # fmt: skip
PERIOD = sum(GROUPS.values())
CLASSES = ((0.3, 1.0), (1.0, 3.0), (3.0, 10.0), (10.0, 30.0), (30.0, 80.0))
"""Classes of projected size in standard deviations of the noise; within a class evenly by order of magnitude."""
_CLASSES = {
    "catalogue": CLASSES, "new_form": CLASSES, "instrument": CLASSES[1:4], "none_of_these": ((5.0, 40.0),),
    "pair": ((5.0, 30.0),), "triple": ((5.0, 30.0),),
}  # fmt: skip
_TURNS = {5: (2, 0, 3, 1, 4, 2, 3), 3: (1, 2, 0, 1, 2), 1: (0,)}
"""The order in which classes of size come, by how many there are."""
_RUNS_TO_TELL = 4
"""Runs of a plan, at least, for what shows only in how runs differ."""
_HIDDEN = {"null": 0, "pair": 2, "triple": 3}
DRAWS = 5
"""How often the rig of a case is drawn again, at most."""


@dataclass(frozen=True)
class Case:
    """What a case number stands for, before anything is simulated.

    Attributes:
        hidden: forms of the tables. targets: sizes wanted, in standard deviations.
        draw: how often its rig was drawn again, because what is hidden in it could not be simulated.
        start: how its recordings begin, one of `beginnings.STARTS`; None in the sets that all begin at rest.
    """

    which: str
    number: int
    group: str
    design: Design
    hidden: tuple[Hidden, ...]
    targets: tuple[float, ...]
    draw: int = 0
    start: str | None = None

    def rng(self, stream: int) -> Random:
        """A stream of random numbers of this case, and draw, alone."""
        again = [self.draw] if self.draw else []
        return np.random.default_rng([SEEDS[self.which], self.number, stream, *again])


@dataclass(frozen=True)
class Made:
    """A case that was simulated: what was recorded, its description, and what is hidden, at its strength."""

    case: Case
    setup: Setup
    sensors: Sensors
    recorded: list[Signals]
    description: dict[str, Any]
    hidden: tuple[Effect | Fault, ...] = ()


def spread(shares: Mapping[str, int]) -> tuple[str, ...]:
    """Names by their shares, each spread evenly over one period."""
    slots = [((k + 0.5) / count, name) for name, count in shares.items() for k in range(count)]
    return tuple(name for _, name in sorted(slots))


_GROUP_ORDER, _BENCH_ORDER = spread(GROUPS), spread(SHARES)


@cache
def _sample(form: table.Form) -> Effect:
    """A member of a form, to ask which hooks it has."""
    return form.make(np.random.default_rng(1), MuscleParameters())(min(1.0, form.high))


@cache
def _table(which: str) -> tuple[tuple[table.Form, ...], tuple[table.Form, ...]]:
    """Forms of the families, and those in none, that a set may have."""
    if which not in APART:
        return table.FORMS, table.STRANGE
    lines = apart.module("lines")
    return (*(form for form in table.FORMS if form.catalogue), *lines.FORMS), lines.STRANGE


def choices(which: str, group: str, design: Design) -> dict[str, list[Hidden]]:
    """What can be hidden on a design, by what takes turns: a family, or a form that only some bench has."""
    by_turn: dict[str, list[Hidden]] = {}
    if group == "instrument":
        for fault in FAULTS:
            if fault.where(design):
                by_turn.setdefault(fault.family, []).append(fault)
        return by_turn
    labels = NEW_FORMS_OF if group == "new_form" else FORMS_OF
    own = {*labels.get(which, FORMS_OF[which])}
    families, strange = _table(which)
    for form in strange if group == "none_of_these" else (*families, *ON_SOME_BENCH):
        wanted = group == "none_of_these" or form.catalogue is (group != "new_form")
        if (
            not own.isdisjoint(form.sets)
            and wanted
            and design.rig.takes(_sample(form), design.signals)
        ):
            alone = form in ON_SOME_BENCH or group == "none_of_these"
            if form in ON_SOME_BENCH and design.runs < _RUNS_TO_TELL:
                continue
            by_turn.setdefault(f"{form.family}:{form.name}" if alone else form.family, []).append(
                form
            )
    return by_turn


@cache
def _cases(which: str, periods: int) -> tuple[Case, ...]:
    """The first cases of a set; what was least hidden so far in its group comes next."""
    used: dict[str, Counter[str]] = {group: Counter() for group in GROUPS}
    turns: Counter[str] = Counter()
    begin: Counter[str] = Counter()
    cases = []
    for number in range(periods * PERIOD):
        group = _GROUP_ORDER[number % PERIOD]
        bench = _BENCH_ORDER[(7 * number + number // len(_BENCH_ORDER)) % len(_BENCH_ORDER)]
        case = Case(which, number, group, Design(bench, (), 0.0, 0), (), ())
        rng = case.rng(0)
        count = _HIDDEN.get(group, 1)
        design, possible = _design(rng, which, group, bench, count)
        picked = _picked(rng, used[group], possible, count)
        bounds = _CLASSES.get(group, ())
        targets = []
        for _ in picked:
            order = _TURNS[len(bounds)]
            targets.append(_within(rng, bounds[order[turns[group] % len(order)]]))
            turns[group] += 1
        case = replace(case, design=design, hidden=picked, targets=tuple(targets))
        if which in IN_MOTION:
            case = replace(case, start=_start(design, begin[group]))
            begin[group] += case.design.bench != "VesselOrifice"
        cases.append(case)
    return tuple(cases)


def _start(design: Design, before: int) -> str:
    """How a case begins that has so many before it in its group: every second one in the middle.

    A vessel that empties begins with the pressure that its run states, as a parameter, and is left at that.
    """
    if design.bench == "VesselOrifice" or before % 2 == 0:
        return "rest"
    return IN_THE_MIDDLE[before // 2 % len(IN_THE_MIDDLE)]


def _within(rng: Random, bounds: tuple[float, float]) -> float:
    return float(np.exp(rng.uniform(*np.log(bounds))))


def _design(
    rng: Random, which: str, group: str, bench: str, count: int
) -> tuple[Design, dict[str, list[Hidden]]]:
    """A design of a bench on which there is enough to hide; drawn again where there is not."""
    while True:
        design = draw_design(rng, bench)
        possible = choices(which, group, design) if count else {}
        if len({forms[0].family for forms in possible.values()}) >= count:
            return design, possible


def _picked(
    rng: Random, used: Counter[str], possible: Mapping[str, Sequence[Hidden]], count: int
) -> tuple[Hidden, ...]:
    """Forms of different families, those that were hidden least first; what has no strength comes first of all."""
    picked: list[Hidden] = []
    for turn in sorted(possible, key=lambda turn: (used[turn], rng.random())):
        if len(picked) == count:
            break
        if any(form.family == possible[turn][0].family for form in picked):
            continue
        fewest = min(used[f"{turn}/{form.name}"] for form in possible[turn])
        forms = [form for form in possible[turn] if used[f"{turn}/{form.name}"] == fewest]
        picked.append(forms[int(rng.integers(len(forms)))])
        used.update([turn, f"{turn}/{picked[-1].name}"])
    return tuple(sorted(picked, key=lambda form: form.high / form.low))


def case_of(which: str, number: int) -> Case:
    """The case with this number (from 0) of a set. Raises ValueError for an unknown set or a negative number."""
    if which not in SEEDS or number < 0:
        raise ValueError(f"there is no case {number} of a set '{which}'; sets: {', '.join(SEEDS)}")
    return _cases(which, number // PERIOD + 1)[number]


def outline(case: Case) -> dict[str, Any]:
    """What is known of a case before it is simulated: the description of one that could not be."""
    design = case.design
    return {
        "set": case.which,
        "number": case.number,
        "group": case.group,
        "bench": design.bench,
        "signals": list(design.signals),
        "rate": design.rate,
        "runs": design.runs,
        "families": [form.family for form in case.hidden if form.family != "none_of_these"],
        "same_as": same_as(case),
        **({"start": case.start} if case.start else {}),
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


def same_as(
    case: Case, hidden: Sequence[Effect | Fault] = (), imitated: Sequence[bool] = ()
) -> list[list[str]]:
    """Other families that give the very same data, so that no verdict could tell them apart; none: nothing is missing.

    Whatever delays all that is measured against all that is commanded: a late recorder, a dead time of the only
    instrument, a dead time of valves where currents are all that moves. A mass that hangs on the muscle and a load that
    is stated too small, where all runs have one load.

    Args:
        case: what is hidden on which bench.
        hidden: the same at its strength, where it was simulated: a recorder may be early too.
        imitated: of each, whether the base model gives the same data with other values of its free parameters.
    """
    also: list[list[str]] = []
    families = [form.family for form in case.hidden]
    if any(imitated):
        also.append([f for f, away in zip(families, imitated, strict=True) if not away])
    for k, form in enumerate(case.hidden):
        early = isinstance(at := hidden[k] if hidden else None, ClockOffset) and at.shift < 0
        for other in [] if early else _delays(case, form):
            if other not in families:
                also.append([*families[:k], other, *families[k + 1 :]])
    if [(form.family, form.name) for form in case.hidden] == [("moving_mass", "hanging")] and (
        case.design.sixth == "load.m" or case.design.runs == 1
    ):
        also.append(["wrong_parameter"])
    return also


def _delays(case: Case, form: Hidden) -> list[str]:
    """Families that delay all that is measured, if a form does just that; none, if it does something else."""
    design = case.design
    delays = {"clock_offset": "shift"}
    if len(design.signals) == 1:
        delays[family_of(design.signals[0], LATE)] = "dead_time"
    if design.rig.course is None and design.bench != "VesselOrifice":
        delays["valve_dynamics"] = "dead_time"
    return list(delays) if delays.get(form.family) == form.name else []


def make(case: Case, changed: Callable[[Setup], Setup] = lambda setup: setup) -> Made:
    """Simulates a case. Where that cannot be done, its rig, plan and sensors are drawn again; what is hidden stays.

    Raises RuntimeError when no draw can be simulated.

    Args:
        case: what is hidden on which bench.
        changed: makes another setup of the one that was drawn, such as one that is driven in another way.
    """
    for draw_again in range(case.draw, DRAWS):
        with suppress(RuntimeError):
            return _made(replace(case, draw=draw_again), changed)
    return _made(replace(case, draw=DRAWS), changed)


def _made(case: Case, changed: Callable[[Setup], Setup]) -> Made:
    setup = changed(draw(case.rng(1), case.design)).driven()
    if case.start in IN_THE_MIDDLE:
        setup = begun(setup, case.rng(4))
    sensors = draw_sensors(case.rng(2), case.design.signals)
    ruler = Ruler(setup) if case.hidden else None
    hidden: list[Effect | Fault] = []
    sizes: list[dict[str, Any]] = []
    for k, (form, target) in enumerate(zip(case.hidden, case.targets, strict=True)):
        assert ruler is not None
        at = _maker(form, case.rng(10 + k), setup, ruler)
        strength, size = calibrated(ruler, at, sensors.sigma, target, form.low, form.high)
        if k == 0:
            sensors, size = _fitting_noise(sensors, size, target)
        hidden.append(at(strength))
        sizes.append(
            {"strength": strength, "size": size, "parameters": effect_parameters(hidden[-1])}
        )
    if ruler is not None and setup.loops:
        setup, ruler, sizes = _driven_again(setup, sensors, hidden, sizes)
    clean = ruler.simulated(hidden) if ruler else setup.simulate()
    zero = dict.fromkeys(setup.signals, 0.0)
    plain, projected = ruler.sizes(clean, sensors.sigma) if ruler else (zero, zero)
    for one, what in zip(hidden, sizes, strict=True):
        assert ruler is not None
        if (imitated := ruler.size_if_imitated(one, sensors.sigma)) is not None:
            what["refitted"] = imitated
    noise = case.rng(3)
    recorded = setup.recorded(hidden, lambda read: disturb(noise, sensors, read))
    known = outline(case)
    description = known | {
        "hidden": [a | b for a, b in zip(known["hidden"], sizes, strict=True)],
        "size": {"plain": plain, "projected": projected},
        "same_as": same_as(case, hidden, ["refitted" in what for what in sizes]),
        "sensors": sensors.as_dict(),
        "rig": dict(setup.values),
        "free": {p.name: {"true": p.true, "min": p.low, "max": p.high} for p in setup.free},
        "plan": [
            {
                "style": t.style,
                "role": t.role,
                "seconds": (t.samples - 1) / t.rate,
                "values": dict(t.values),
                **({"begins": t.begin / t.rate} if t.begin else {}),
            }
            for t in setup.plan
        ],
        "noise": noise_of(setup, sensors, clean, recorded),
    }
    if case.draw:
        description["draw"] = case.draw
    return Made(case, setup, sensors, recorded, description, tuple(hidden))


def _maker(form: Hidden, rng: Random, setup: Setup, ruler: Ruler) -> Callable[[float], Any]:
    if isinstance(form, FaultForm):
        peaks = {name: max(float(run[name].max()) for run in ruler.base) for name in setup.signals}
        at: Callable[[float], Any] = form.make(rng, Scene(setup, peaks))
    else:
        at = form.make(rng, setup.muscle)
    return _negative(at) if form.signed and rng.random() < 0.5 else at


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


def _driven_again(
    setup: Setup,
    sensors: Sensors,
    hidden: Sequence[Effect | Fault],
    sizes: Sequence[dict[str, Any]],
) -> tuple[Setup, Ruler, list[dict[str, Any]]]:
    """With what is hidden in the loop its currents are others, and sizes with them."""
    setup = setup.driven(hidden)
    ruler = Ruler(setup)
    measured = [
        s | {"size": ruler.size(one, sensors.sigma)} for s, one in zip(sizes, hidden, strict=True)
    ]
    return setup, ruler, measured


def noise_of(
    setup: Setup, sensors: Sensors, clean: Sequence[Signals], recorded: Sequence[Signals]
) -> dict[str, Any]:
    """Mean square of recorded minus true and number of samples, by role and signal [SI]: what the truth leaves.

    Without outliers, which whoever compares sets aside.
    """
    by_role: dict[str, Any] = {}
    for role in dict.fromkeys(trial.role for trial in setup.plan):
        runs = [k for k, trial in enumerate(setup.plan) if trial.role == role]
        by_role[role] = {}
        for name in setup.signals:
            error = np.concatenate([recorded[k][name] - clean[k][name] for k in runs])
            error = sensors.without_outliers(name, error[np.isfinite(error)])
            by_role[role][name] = {"mean_square": float(np.mean(error**2)), "samples": len(error)}
    return by_role


def write(made: Made, folder: Path) -> None:
    """Writes experiment.toml and the runs; nothing in them says what is hidden."""
    setup = made.setup
    free = {p.name: (p.low, p.high) for p in setup.free}
    known = {name: value for name, value in setup.values.items() if name not in free}
    known |= {p.name: p.nominal for p in setup.free if p.nominal is not None}
    sigma = made.sensors.sigma if made.sensors.stated else None
    start = "estimated" if made.case.start == "stated" else None
    about = tables.About(f"case {made.case.number}", setup.signals, sigma, known, free, start)
    tables.write(folder, setup.design.rig, list(zip(setup.plan, made.recorded, strict=True)), about)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line: writes one case, prints what is hidden in it."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("--set", dest="which", choices=SEEDS, default="tuning3")
    parser.add_argument("--number", type=int, default=0)
    options = parser.parse_args(arguments)
    made = make(case_of(options.which, options.number))
    write(made, options.folder)
    print(json.dumps(made.description, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
