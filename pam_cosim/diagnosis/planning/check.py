"""What a data set can and cannot tell about its model, before any fit."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.comparison import warnings_of
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import FailedTrial
from pam_cosim.diagnosis.judgement.events import Listener, Remark, listened
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.planning.hypothetical_measurements import Option, with_all_outputs
from pam_cosim.diagnosis.planning.identifiability import (
    DetectableEffect,
    Identifiability,
    ParameterPrecision,
    Rows,
)
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.subject import subject_of
from pam_cosim.errors import SimulationFailure
from pam_cosim.files import Plain
from pam_cosim.fitting import base_parameters, linearised, rows_of_series
from pam_cosim.fitting.objective import Objective
from pam_cosim.measurement import DataSet
from pam_cosim.processes.workers import on_one_thread
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, listed, look_first

_SHARPENING = 0.8  # factor on the sd of parameters; a measurement with a larger one helps little
_MOST_LISTED = 5  # measurements that help
LARGEST_STRENGTH = 1e3  # stated strengths, that a real effect has at most


@dataclass(frozen=True)
class Help:
    """What a further measurement would bring.

    Attributes:
        option: the measurement.
        shows: families that it shows and the data do not.
        tells_apart: pairs of families, likewise.
        determines: free parameters that it determines, likewise.
        sharper: factor on the expected deviation of the free parameters, geometric mean.
    """

    json_keys = "kind=option.kind what=option.text shows tells_apart determines sharper"

    option: Option
    shows: tuple[str, ...]
    tells_apart: tuple[tuple[str, str], ...]
    determines: tuple[str, ...]
    sharper: float

    @property
    def settles(self) -> int:
        """How many questions it settles."""
        return len(self.shows) + len(self.tells_apart) + len(self.determines)


@dataclass(frozen=True)
class Check(Printed, Plain):
    """What a data set can tell, and what would help.

    Attributes:
        data: the measurement, with the noise levels that were used.
        model: the base model.
        identifiability: what the fitted runs can tell.
        no_place: families whose effects find no place in the model.
        helps: further measurements, the most useful first; none that would bring nothing.
        failed: effects that could not be simulated.
        warnings: of the model at its start values.
    """

    json_keys = (
        "title=data.title model parameters=_parameters confused=identifiability.confused "
        "effects=identifiability.effects visible=identifiability.visible "
        "alike=identifiability.alike hidden=identifiability.hidden no_place helps failed warnings?"
    )

    data: DataSet
    model: str
    identifiability: Identifiability
    no_place: tuple[str, ...]
    helps: tuple[Help, ...]
    failed: tuple[FailedTrial, ...] = ()
    warnings: tuple[str, ...] = ()

    @property
    def _parameters(self) -> dict[str, ParameterPrecision]:
        return {p.name: p for p in self.identifiability.parameters}

    def __str__(self) -> str:
        lines = [
            f"{self.model} and {self.data.title}: what these data determine, by the model at its start values"
        ]
        lines += look_first(self.warnings)
        lines += (
            [*self.data.starts, *self._about_parameters()]
            + self._about_families()
            + self._about_help()
        )
        return "\n".join(lines)

    def _about_parameters(self) -> list[str]:
        lines = []
        for k in self.identifiability.parameters:
            value, deviation = (
                format_quantity(k.start, k.unit),
                format_quantity(k.deviation, k.unit, 2),
            )
            lines.append(
                f"  {k.name}: {value} will be known to about ± {deviation}"
                if k.determined
                else f"  {k.name}: these data determine it no better than its bounds; measure it, or do not fit it"
            )
        lines += [
            f"  {a} and {b} can hardly be separated (correlation {r:+.3f})"
            for a, b, r in self.identifiability.confused
        ]
        return ["free parameters:", *lines] if lines else ["no free parameter"]

    def _about_families(self) -> list[str]:
        best, visible, hidden = (
            self.identifiability.families,
            self.identifiability.visible,
            self.identifiability.hidden,
        )
        limit_lines = [_detection_limit_text(best[family]) for family in best if family in visible]
        faint = [
            _detection_limit_text(best[family])
            for family in best
            if family not in {*visible, *hidden}
        ]
        lines = [
            "detectable families of effects, and the smallest detectable values:",
            *(limit_lines or ["  none"]),
        ]
        if faint:
            lines += ["families that are detectable only if stronger than usual:", *faint]
        if hidden:
            lines.append(
                f"not detectable (no effect on the signals, or masked by the free parameters): {listed(hidden)}"
            )
        failed = dict.fromkeys(c.family for c in self.failed)
        broken = [family for family in failed if family not in best]
        if broken:
            lines.append(
                f"could not be simulated at their stated strength, and may be missing: {listed(broken)}"
            )
        if self.no_place:
            lines.append(f"the model has no place for: {listed(self.no_place)}")
        return lines + self._about_confused_families()

    def _about_confused_families(self) -> list[str]:
        if not self.identifiability.alike:
            return []
        lines = ["families that are detectable, but cannot be separated at their usual strength:"]
        for a in self.identifiability.alike:
            pair = f"{a.family} ({a.effect}) may be mistaken for {a.other_family} ({a.other})"
            lines.append(f"  {pair}, {_strength_range_text(a.least)}")
        return lines

    def _about_help(self) -> list[str]:
        if not self.helps:
            return [
                "no further signal of this bench, and no usual change of a run, would settle more"
            ]
        return [
            "what would help most:",
            *(f"  {h.option.text}: {_benefit_text(h)}" for h in self.helps[:_MOST_LISTED]),
        ]


def _detection_limit_text(effect: DetectableEffect) -> str:
    texts = {
        name: _distinct_digits(value, effect.absent[name], effect.units[name])
        for name, value in effect.values.items()
    }
    values = [f"{name} = {text}" for name, text in texts.items() if text]
    return f"  {effect.family:20} {effect.effect}" + (f": {', '.join(values)}" if values else "")


def _distinct_digits(value: float, absent: float, unit: str) -> str:
    """A value in so many digits that it differs from another."""
    texts = (format_quantity(value, unit, digits) for digits in range(3, 17))
    return next(
        (
            text
            for digits, text in enumerate(texts, 3)
            if text != format_quantity(absent, unit, digits)
        ),
        "",
    )


def _strength_range_text(least: float) -> str:
    if least > LARGEST_STRENGTH:
        return "whatever its strength"
    return f"up to {least:.2g} times that strength"


def _benefit_text(h: Help) -> str:
    parts = []
    if h.shows:
        parts.append(f"shows {listed(h.shows)}")
    if h.tells_apart:
        parts.append(f"separates {listed([f'{a} from {b}' for a, b in h.tells_apart])}")
    if h.determines:
        parts.append(f"determines {listed(h.determines)}")
    if h.sharper < _SHARPENING:
        parts.append(f"the free parameters are known to {100 * h.sharper:.0f} % of the deviation")
    return "; ".join(parts)


@on_one_thread
def check(
    data: DataSet,
    model: str | None = None,
    *,
    files: Sequence[Path] = (),
    say: Callable[[Message], None] = lambda message: None,
    progress: Listener | None = None,
    workers: int | None = None,
) -> Check:
    """What the fitted runs of a data set can tell about its model, and which measurement would help most.

    The measured values do not matter, only where and how exactly something was measured.

    Args:
        data: the measurement.
        model: the base model; default the bench of the data set.
        files: further Modelica files, whose effects are looked at too.
        say: told what happens, line by line; ``progress``: as events, also those that have no line.
        workers: number of processes; 0: this one alone.

    Raises:
        InputError: the model cannot be compiled, or lacks a parameter that is to be fitted.
        SimulationFailure: the model cannot be simulated at its start values.
    """
    say = listened(say, progress)
    subject = subject_of(data, model, files, workers, say)
    data, name = subject.data, subject.name
    with subject.simulator() as simulator:
        available_effects = subject.effects(simulator.interface)
        possible = with_all_outputs(simulator, data)
        free = base_parameters(possible.data, simulator.interface)
        tolerance = CRITERIA.search.screening_tolerance
        objective = Objective(
            simulator, possible.data, possible.data.fit_runs, free, None, tolerance
        )
        count = _row_count(objective, data)
        start = np.array([f.to_z(f.start) for f in free])
        objective.residuals(start)
        warnings = warnings_of(objective.latest_runs)
        base = linearised(objective, start, count)
    if base is None:
        raise SimulationFailure(objective.first_failure)
    say(
        Remark(
            f"looking at what each of {len(available_effects)} effects does at its stated strength"
        ).message
    )
    probes, failed = [], []
    if available_effects:
        search = Search(
            subject.library, name, available_effects, possible.data, subject.sources, say, workers
        )
        probes, failed = search.probe_stated(base, objective.starts.settings, count), search.failed
    belongs = [possible.option[run.name, signal] for run, signal in objective.series]
    samples: Counter[Option] = Counter()
    for option, (run, signal) in zip(belongs, objective.series, strict=True):
        samples[option] += run.sample_count(signal)
    option_of_rows = [belongs[i] for i in rows_of_series(objective, count)]
    rows = Rows(base, {f.name: f.unit for f in free}, probes, option_of_rows, samples)
    identifiability = rows.identifiability()
    probed_families = {p.family for p in probes} | {f.family for f in failed}
    return Check(
        data=data,
        model=name,
        identifiability=identifiability,
        no_place=tuple(
            f
            for f in dict.fromkeys(e.family for e in available_effects)
            if f not in probed_families
        ),
        helps=tuple(_helps(rows, identifiability)),
        failed=tuple(failed),
        warnings=warnings,
    )


def _row_count(objective: Objective, data: DataSet) -> int:
    """As many rows for what was measured as a search takes."""
    measured = sum(
        run.sample_count(name)
        for run in data.fit_runs
        for name, s in data.signals.items()
        if s.fitted
    )
    return math.ceil(CRITERIA.search.rows * objective.size / max(measured, 1))


def _helps(rows: Rows, as_measured: Identifiability) -> list[Help]:
    """What each further measurement brings, the most useful first; none that brings nothing."""
    helps = [_help(option, as_measured, rows.identifiability(option)) for option in rows.further]
    useful = [h for h in helps if h.settles or h.sharper < _SHARPENING]
    return sorted(useful, key=lambda h: (-h.settles, h.sharper, h.option.text))


def _help(option: Option, as_measured: Identifiability, with_option: Identifiability) -> Help:
    pairs = [
        tuple(sorted(pair))
        for pair in with_option.pairs - as_measured.pairs
        if pair <= as_measured.visible
    ]
    determined = {k.name for k in as_measured.parameters if k.determined}
    ratios = [
        b.deviation / a.deviation
        for a, b in zip(as_measured.parameters, with_option.parameters, strict=True)
    ]
    return Help(
        option,
        tuple(sorted(with_option.visible - as_measured.visible)),
        tuple((a, b) for a, b in sorted(pairs)),
        tuple(k.name for k in with_option.parameters if k.determined and k.name not in determined),
        float(np.exp(np.mean(np.log(ratios)))) if ratios else 1.0,
    )
