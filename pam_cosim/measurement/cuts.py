"""Runs that begin later, or end earlier, than what was recorded."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.measurement.data_set import Run
from pam_cosim.measurement.run_names import Value, check_names, stated_of
from pam_cosim.measurement.start import START_MODES, StartMode
from pam_cosim.model.interface import Variable
from pam_cosim.model.settings import value_of
from pam_cosim.wording import shown

_NEAR = 1e-9  # of a run, by which a time may miss a row that it is written like

Moment = float | str | None
"""A time [s] of a recording's own clock, or as a text with a unit; None: its first or last."""


@dataclass(frozen=True)
class Cut:
    """What is kept of a recording.

    Attributes:
        begin, end: times of the recording's own clock [s], both kept; None: its first, and its last.
    """

    begin: float | None = None
    end: float | None = None


def cuts_of(stated: Mapping[str, Sequence[Moment]]) -> dict[str, Cut]:
    """Cuts by run, from a first and a last time each.

    Raises:
        InputError: what is no such pair.
    """
    cuts_by_run = {}
    for run, pair in stated.items():
        if isinstance(pair, str) or len(pair) != 2:
            raise InputError(
                f"{shown(run)}: a run is cut to a first and a last time, not {shown(pair)}"
            )
        begin, end = pair
        cuts_by_run[run] = Cut(_seconds(run, "from", begin), _seconds(run, "to", end))
    return cuts_by_run


def _seconds(run: str, end: str, value: Moment) -> float | None:
    if value is None:
        return None
    try:
        return value_of(value, Variable(end, "s"))
    except InputError as problem:
        raise InputError(f"{shown(run)}: {problem.message}") from None


def cut_run(run: Run, cut: Cut) -> Run:
    """The rows of a run from ``cut.begin`` to ``cut.end``; the same run where these are all.

    Raises:
        InputError: nothing, or one row, would be left; points at rest.
    """
    tolerance = _NEAR * float(run.time[-1] - run.time[0])
    first_row = (
        0
        if cut.begin is None
        else int(np.searchsorted(run.time, cut.begin - tolerance, side="left"))
    )
    last = (
        len(run.time)
        if cut.end is None
        else int(np.searchsorted(run.time, cut.end + tolerance, side="right"))
    )
    if (first_row, last) == (0, len(run.time)) and not run.is_static:
        return run
    if run.is_static:
        raise InputError(
            f"{run.name} holds points at rest, which have no times to be cut at", run.file
        )
    shortened = replace(
        run.rows(slice(first_row, last)), recorded=(float(run.time[0]), float(run.time[-1]))
    )
    if last - first_row < 2 or shortened.time[0] == shortened.time[-1]:
        span = f"goes from {run.time[0]:g} to {run.time[-1]:g} s"
        raise InputError(f"{run.name} {span}: no samples lie between {_ends(run, cut)}", run.file)
    if not any(np.isfinite(values).any() for values in shortened.measurements.values()):
        raise InputError(f"{run.name} has no sample between {_ends(run, cut)}", run.file)
    return shortened


def _ends(run: Run, cut: Cut) -> str:
    begin = run.time[0] if cut.begin is None else cut.begin
    end = run.time[-1] if cut.end is None else cut.end
    return f"{begin:g} and {end:g} s"


@dataclass(frozen=True)
class Overrides:
    """Cuts and initial states that the caller states in place of the data set, by run name or pattern.

    Attributes:
        cuts: from when to when a run goes.
        starts: in which state it begins.
    """

    cuts: Mapping[str, Cut] = field(default_factory=dict)
    starts: Mapping[str, StartMode] = field(default_factory=dict)

    def cut(self, run: Run) -> Cut | None:
        """Of a run; points at rest are cut only by their name."""
        return self._stated(run, self.cuts)

    def start(self, run: Run) -> StartMode | None:
        """Of a run; points at rest have one only by their name, which is an error."""
        return self._stated(run, self.starts)

    def _stated(self, run: Run, values: Mapping[str, Value]) -> Value | None:
        return values.get(run.name) if run.is_static else stated_of(run.name, values)

    def check(self, title: str, runs: Sequence[str]) -> None:
        """Refuses statements about a run that does not exist.

        Raises:
            InputError: names the nearest one.
        """
        check_names(title, (*self.cuts, *self.starts), runs)


def overrides_of(
    cuts: Mapping[str, Sequence[Moment]] | None = None, starts: Mapping[str, str] | None = None
) -> Overrides:
    """What is stated of runs, checked except for their names.

    Raises:
        InputError: no such times; no way to begin.
    """
    modes: dict[str, StartMode] = {}
    for run, stated in (starts or {}).items():
        mode = next((mode_name for mode_name in START_MODES if mode_name == stated), None)
        if mode is None:
            raise InputError(
                f"{shown(run)} cannot begin as {shown(stated)}; it is one of {', '.join(START_MODES)}"
            )
        modes[run] = mode
    return Overrides(cuts_of(cuts or {}), modes)
