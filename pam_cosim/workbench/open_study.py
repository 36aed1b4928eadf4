"""A study whose standing model is simulated, drawn and scored for its windows, in one thread."""

from __future__ import annotations

import shutil
import tempfile
import threading
from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from pam_cosim.comparison import Comparison, RunComparison, samples_in, scored, where
from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, Run
from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.checks import is_number, one_of
from pam_cosim.workbench.curves import measured_curves, model_curves
from pam_cosim.workbench.frames import frame
from pam_cosim.workbench.opened_model import Opened, made_for, open_model
from pam_cosim.workbench.protocol import Json, event, failure
from pam_cosim.workbench.saved import lean_fit
from pam_cosim.workbench.simulators import Simulated
from pam_cosim.workbench.source import MeasurementSource
from pam_cosim.workbench.starts import StartsShown, courses
from pam_cosim.workbench.state import State, standing_label, with_rung
from pam_cosim.workbench.state_events import (
    rung_of,
    scores_event,
    steps_event,
    study_event,
    where_event,
)
from pam_cosim.workbench.steps import Step
from pam_cosim.workbench.windows import Windows

QUIET = 0.3  # [s] without a new value after which the page is sent where the error is
MOST_BACK = 100  # steps that can be taken back


class OpenStudy:
    """A study with its windows.

    Args:
        folder: of the data set.
        model: default: the bench of the data set.
        files: further Modelica files.
        windows: that show it.
        complete: whether a study is refused of which a run cannot be simulated; else its page opens and names the run.

    Raises:
        InputError: the data set cannot be read.
        SimulationFailure: a run cannot be simulated, and the study is to be complete.
    """

    def __init__(
        self,
        folder: Path,
        model: str | None,
        files: Sequence[Path],
        windows: Windows,
        complete: bool,
    ) -> None:
        self.complete = complete
        self.folder, self.windows = Path(folder), windows
        self.catalogue = Catalogue([Path(f) for f in files])
        self.source = MeasurementSource(self.folder, self.catalogue.files)
        self.scratch = Path(tempfile.mkdtemp(prefix="pam-cosim-workbench-"))
        self.past: list[State] = []
        self.saved: tuple[Step, ...] | None = None
        self.saved_file: object = None  # as ``files.identity``, when it was read or written last
        self.version = 0  # of what was drawn last
        self._thread = ThreadPoolExecutor(1, thread_name_prefix="study")
        self._lock = threading.Lock()
        self._waiting: Json = {}  # values that are to be set
        self._looking = False
        self._open: Opened | None = None
        self._comparison: Comparison | None = None
        self._drawn: dict[str, Sequence[RunComparison]] = {}  # by the kind of their frame
        self.simulated = Simulated()
        self._starts = StartsShown()
        try:
            self._thread.submit(self._begin, model).result()
        except BaseException:
            self.close()
            raise

    def _begin(self, model: str | None) -> None:
        data, values = self.source.read(model)
        self.benches = self.catalogue.benches(data.model)
        self.first = self.state = State(data, data.model_for(model), known=values)
        self.back(self.state)

    def close(self) -> None:
        """Ends everything; nothing is saved by it."""
        self._thread.shutdown(wait=True, cancel_futures=True)
        if self._open is not None:
            self._open.close()
            self._open = None
        shutil.rmtree(self.scratch, ignore_errors=True)

    @property
    def bench(self) -> str:
        """The base model, as the data set is read for it."""
        return self.state.data.unmapped or self.state.data.model

    @property
    def opened(self) -> Opened:
        """The standing model, ready to run."""
        assert self._open is not None
        return self._open

    @property
    def comparison(self) -> Comparison:
        """The standing model against the measurement."""
        assert self._comparison is not None
        return self._comparison

    def submit(self, method: Callable[..., object], *arguments: Any) -> None:
        """Does something in the study's thread, if there still is one."""
        with suppress(RuntimeError):
            self._thread.submit(self._guarded, method, *arguments)

    def _guarded(self, method: Callable[..., object], *arguments: Any) -> None:
        try:
            method(*arguments)
        except Exception as problem:  # there is no command that it could be answered to
            self.tell_failure(problem)

    def tell_failure(self, problem: BaseException, during: str = "", *, line: bool = False) -> None:
        """Sends all windows what went wrong; ``line``: later ones too, as progress."""
        self.windows.tell(event("failed", **failure(problem, during)), line=line)

    def _later(self, method: Callable[..., None], *arguments: Any) -> None:
        timer = threading.Timer(QUIET, self.submit, (method, *arguments))
        timer.daemon = True
        timer.start()

    def enter(self, state: State, *, moved: bool = False) -> None:
        """Makes a state the present one, a step after the one before; see ``back``."""
        before = self.state
        if before.milestone:
            rung = rung_of(before.milestone, self.comparison)
            state = replace(state, rungs=with_rung(state.rungs, rung))
        self.back(state, moved=moved)
        if len(state.steps) > len(before.steps) or not self.past:
            self.remember(before)

    def remember(self, state: State) -> None:
        """Keeps a state to go back to, without the curves of its fit, which are many."""
        lean_state = state if state.fit is None else replace(state, fit=lean_fit(state.fit))
        self.past = [*self.past[-MOST_BACK:], lean_state]

    def back(self, state: State, *, moved: bool = False) -> None:
        """Makes a state the present one: all that depends on it is made again, or nothing.

        Args:
            state: a new one, one that stood before, or one that was loaded.
            moved: only values differ from the present one: the rest of the page stays as it is.

        Raises:
            InputError: there is no such model.
            SimulationFailure: a run cannot be simulated that could be before.
        """
        old = self._open
        about = (state.data, state.model, state.effects)
        same_model = old is not None and old.made_for == made_for(*about)
        opened = old if old and same_model else open_model(*about, self.catalogue, self.scratch)
        other_data = old is None or state.data is not self.state.data
        try:
            simulated = opened.simulators.run(state.data, state.values)
            for run, failure in simulated.failures.items():
                if self.complete or (old is not None and run not in self.simulated.failures):
                    raise failure
            if other_data:
                curves = measured_curves(self.source.whole(state.data))
                self.windows.send(frame("measured", self.version, curves), "measured")
            self._draw(state, simulated.runs)
            comparison = scored_runs(state, opened, simulated.runs)
        except BaseException:
            if not same_model:
                opened.close()
            raise
        if old is not None and not same_model:
            old.close()
        if not same_model or other_data:
            self._starts.forget()
        self.state, self._open, self._comparison = state, opened, comparison
        self.simulated = simulated
        self._tell_scores()
        if not moved:
            self.tell_study()

    def draw(self) -> None:
        """Draws the standing model."""
        self._draw(self.state, self.comparison.runs)
        self._tell_scores()

    def draw_passing(self, values: Mapping[str, float]) -> None:
        """Draws the standing model at other values, without making them those of the study."""
        passing = replace(self.state, values=values, milestone="")
        runs = self.opened.simulators.run(passing.data, values).runs
        self._draw(passing, runs)
        comparison = scored_runs(passing, self.opened, runs)
        self.windows.tell(scores_event(passing, self.opened, comparison, self.version, {}))

    def start_values_of(self, run: str) -> dict[str, float]:
        """Where a run begins, by "state@run" [SI].

        Raises:
            InputError: there is no such run, or what was before its first sample determines where it begins.
        """
        trajectories = courses(
            _recording(self.state.data, run),
            self.state,
            self.opened,
            self.simulated.starts,
            only_start=True,
        )
        if not trajectories:
            raise InputError(
                f"the start of {run} is stated by its time before the first sample; first choose another start"
            )
        return {f"{name}@{run}": float(values[0]) for name, values in trajectories.items()}

    def _draw(self, state: State, runs: Sequence[RunComparison]) -> None:
        self.version += 1
        curves = model_curves(runs, self.source.whole(state.data))
        self._drawn["model"] = runs
        self.windows.send(frame("model", self.version, curves, standing_label(state)), "model")

    def _tell_scores(self) -> None:
        failures = self.simulated.failures
        self.windows.tell(
            scores_event(self.state, self.opened, self.comparison, self.version, failures)
        )
        self.tell_steps()
        if not self._looking:
            self._looking = True
            self._later(self._tell_where, self.version)

    def tell_steps(self) -> None:
        """Sends what was done."""
        self.windows.tell(steps_event(self.state, self.saved == self.state.steps))

    def tell_study(self) -> None:
        """Sends what changes seldom."""
        self.windows.tell(self.shown_study())
        self.tell_starts()
        self.draw_beside("reference", self.state.before, "before")

    def draw_beside(self, kind: str, comparison: Comparison | None, label: str = "") -> None:
        """Draws another model together with the present one; None: removes it."""
        self._drawn.pop(kind, None)
        if comparison is not None:
            self._drawn[kind] = comparison.runs
            curves = model_curves(comparison.runs, self.source.whole(self.state.data))
            self.windows.send(frame(kind, self.version, curves, label), kind)
        elif self.windows.forget(kind):
            self.windows.send(frame(kind, self.version, []))

    def samples(self, run: str, begin: float, end: float) -> Json:
        """Curves of a part of a run between two times [s]: frames in base 64, with every sample where these are few.

        Raises:
            InputError: there is no such recording.
        """
        if not (is_number(begin) and is_number(end)):
            raise InputError("begin and end must be times in seconds")
        whole, part = self.source.whole(self.state.data), (begin, end)
        recording = replace(whole, runs=(_recording(whole, run),))
        curves = {"measured": measured_curves(recording, part)} | {
            kind: model_curves([r for r in runs if r.run.name == run], recording, part)
            for kind, runs in self._drawn.items()
        }
        frames = [frame(kind, self.version, some) for kind, some in curves.items()]
        return {"frames": [b64encode(one).decode() for one in frames]}

    def tell_starts(self) -> None:
        """Sends where runs begin."""
        self.windows.tell(
            self._starts.event(self.state, self.opened, self.simulated.starts, self.version)
        )

    def shown_study(self) -> Json:
        """The event of what changes seldom."""
        effects = self.catalogue.shown(self.state.model, self.state.effects)
        return study_event(self.state, self.opened, effects, self.benches)

    def _tell_where(self, version: int) -> None:
        """Sends where the error is, as soon as nothing newer has been drawn for a while."""
        if version != self.version or self._waiting:
            self._later(self._tell_where, self.version)
            return
        self._looking = False
        self.tell_starts()
        interface, data = self.opened.simulator.interface, self.state.data
        runs = self.comparison.runs
        about = (runs, data.signals, interface.outputs, data.domain, interface.inputs)
        rules = where(*about)
        self.windows.tell(where_event(rules, [samples_in(rule, *about) for rule in rules], version))


def _recording(data: DataSet, run: str) -> Run:
    """The recording of this name, which has times."""
    recordings = {one.name: one for one in data.runs if not one.is_static}
    return recordings[one_of(run, recordings, "recording")]


def scored_runs(state: State, opened: Opened, runs: Sequence[RunComparison]) -> Comparison:
    """The same as ``study.compare`` returns, but for where the error is."""
    return scored(opened.simulator.interface, state.data, state.values, runs, rules=False)
